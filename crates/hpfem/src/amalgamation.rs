//! Joining small fronts to larger ones.
//!
//! A front that eliminates few unknowns and passes many on spends its time on clearing, adding and reading them, not on arithmetic
//! (relaxed supernodes, Ashcraft and Grimes 1989).

use crate::front::{FrontPlan, Order, Plan, partial_factor};
use crate::places::postorder;

/// Multiplications that take as long as clearing a number of a merged element, adding to it and reading it again.
const HANDLING: f64 = 8.0;

/// Puts groups in the order of their elimination.
pub(crate) fn sort_by_rank(groups: &mut [usize], rank: &[usize]) {
    groups.sort_unstable_by_key(|g| rank[*g]);
}

impl Order {
    /// The plan with ranks by the order of elimination, small fronts joined.
    pub(crate) fn plan(self, size: &[usize], kept: &[usize]) -> Plan {
        let Order { groups, mut fronts, roots, elements } = self;
        let mut rank = vec![usize::MAX; size.len()];
        groups.iter().chain(kept).enumerate().for_each(|(i, g)| rank[*g] = i);
        // A front that joins another was eliminated before it, so that groups stay sorted.
        fronts.iter_mut().for_each(|front| sort_by_rank(&mut front.groups, &rank));
        let (fronts, roots) = amalgamated(fronts, roots, elements, size);
        Plan { rank, fronts, roots }
    }
}

/// Joins a front to the one that takes its element wherever the additional arithmetic costs less than handing on the element, children
/// before parents; `elements` is the number of original elements. Returns the fronts and roots with elements numbered anew.
fn amalgamated(mut fronts: Vec<FrontPlan>, roots: Vec<usize>, elements: usize, size: &[usize]) -> (Vec<FrontPlan>, Vec<usize>) {
    let mut parent = vec![None; fronts.len()];
    for (p, front) in fronts.iter().enumerate() {
        front.children.iter().filter_map(|c| c.checked_sub(elements)).for_each(|child| parent[child] = Some(p));
    }
    let total = |groups: &[usize]| groups.iter().map(|g| size[*g]).sum::<usize>() as f64;
    let mut sizes: Vec<[f64; 2]> = fronts.iter().map(|f| [total(&f.groups[..f.eliminated]), total(&f.groups)]).collect();
    let mut alive = vec![true; fronts.len()];
    for f in 0..fronts.len() {
        let Some(p) = parent[f] else { continue };
        let ([gone, all], [next_gone, next_all]) = (sizes[f], sizes[p]);
        let joined = [gone + next_gone, gone + next_all];
        if front_cost(joined[0], joined[1]) < front_cost(gone, all) + front_cost(next_gone, next_all) {
            let front = std::mem::take(&mut fronts[f]);
            sizes[p] = joined;
            alive[f] = false;
            let next = &mut fronts[p];
            next.children.retain(|child| *child != elements + f);
            next.children.extend(front.children);
            next.groups.splice(0..0, front.groups[..front.eliminated].iter().copied());
            next.eliminated += front.eliminated;
        }
    }
    let mut number = vec![0; fronts.len()];
    (1..fronts.len()).for_each(|f| number[f] = number[f - 1] + usize::from(alive[f - 1]));
    let anew = |element: usize| element.checked_sub(elements).map_or(element, |f| elements + number[f]);
    let mut left: Vec<FrontPlan> = fronts.into_iter().zip(&alive).filter(|(_, alive)| **alive).map(|(front, _)| front).collect();
    left.iter_mut().flat_map(|front| &mut front.children).for_each(|child| *child = anew(*child));
    in_postorder(left, roots.into_iter().map(anew).collect(), elements)
}

/// The fronts in postorder, which elements with places on stacks ask for; each computes what it computes in any other order.
fn in_postorder(mut fronts: Vec<FrontPlan>, roots: Vec<usize>, elements: usize) -> (Vec<FrontPlan>, Vec<usize>) {
    let number = postorder(&fronts, &roots, elements);
    let anew = |element: usize| element.checked_sub(elements).map_or(element, |f| elements + number[f]);
    fronts.iter_mut().flat_map(|front| &mut front.children).for_each(|child| *child = anew(*child));
    let mut sorted: Vec<FrontPlan> = (0..fronts.len()).map(|_| FrontPlan::default()).collect();
    number.iter().zip(fronts).for_each(|(number, front)| sorted[*number] = front);
    (sorted, roots.into_iter().map(anew).collect())
}

/// Multiplications of a front that eliminates `gone` of `all` unknowns, the handling of what it leaves counted as such.
pub(crate) fn front_cost(gone: f64, all: f64) -> f64 {
    partial_factor(gone, all) + HANDLING * (all - gone).powi(2)
}
