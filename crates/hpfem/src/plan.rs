//! The choice of the order of elimination.

use crate::amalgamation::front_cost;
use crate::dissection::dissected;
use crate::front::{FrontPlan, Plan};
use crate::minimum_degree::minimum_degree;

/// More elements than this are ordered by nested dissection alone.
const MANY_ELEMENTS: usize = 1000;
/// Up to this many elements minimum degree has always been the better order.
const FEW_ELEMENTS: usize = 100;

impl Plan {
    /// The order for elements at the given places: minimum degree, which finds the chains of graded layers, for few elements, nested
    /// dissection for many, in between the one that costs less.
    pub(crate) fn new(element_groups: &[Vec<usize>], places: &[[f64; 2]], size: &[usize], kept: &[usize]) -> Plan {
        let elements = element_groups.len();
        if elements > MANY_ELEMENTS {
            return dissected(element_groups, places, size, kept);
        }
        let plan = minimum_degree(element_groups, size, kept);
        if elements <= FEW_ELEMENTS {
            return plan;
        }
        let other = dissected(element_groups, places, size, kept);
        if other.cost(size) < plan.cost(size) { other } else { plan }
    }

    /// Multiplications of the elimination, the handling of merged elements counted as such.
    fn cost(&self, size: &[usize]) -> f64 {
        let total = |groups: &[usize]| groups.iter().map(|g| size[*g]).sum::<usize>() as f64;
        let front = |f: &FrontPlan| front_cost(total(&f.groups[..f.eliminated]), total(&f.groups));
        self.fronts.iter().map(front).sum()
    }
}
