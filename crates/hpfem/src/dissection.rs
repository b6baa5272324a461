//! Nested dissection (George 1973) of elements by their places: the cells are halved across the longer side of their extent again and
//! again; what two halves share is eliminated after both.
//!
//! Fronts come in postorder, so that few unmerged elements are alive at a time. The work on a plane mesh of `N` unknowns grows like
//! `N^(3/2)`, the factor like `N log N`.

use crate::front::{FrontPlan, Order, Plan};

/// Elements whose sizes sum up to this are eliminated in one front: smaller fronts cost more in handling than they save in arithmetic.
const LEAF: usize = 400;

/// What is known of a part: elements not yet merged, and its groups with the number of original elements that hold them.
struct Part {
    elements: Vec<usize>,
    groups: Vec<(usize, usize)>,
}

struct Dissection<'a> {
    element_groups: &'a [Vec<usize>],
    places: &'a [[f64; 2]],
    weight: Vec<usize>,
    /// Number of elements that hold each group; never reached for kept groups.
    holders: Vec<usize>,
    /// Place of each group in the list under construction.
    slot: Vec<usize>,
    order: Vec<usize>,
    fronts: Vec<FrontPlan>,
}

/// The plan by nested dissection.
pub(crate) fn dissected(element_groups: &[Vec<usize>], places: &[[f64; 2]], size: &[usize], kept: &[usize]) -> Plan {
    let mut holders = vec![0; size.len()];
    element_groups.iter().flatten().for_each(|g| holders[*g] += 1);
    kept.iter().for_each(|g| holders[*g] = usize::MAX);
    let weight = element_groups.iter().map(|groups| groups.iter().map(|g| size[*g]).sum()).collect();
    let slot = vec![usize::MAX; size.len()];
    let mut dissection = Dissection { element_groups, places, weight, holders, slot, order: Vec::new(), fronts: Vec::new() };
    let mut all: Vec<usize> = (0..element_groups.len()).collect();
    let root = dissection.part(&mut all);
    let Dissection { order: groups, fronts, .. } = dissection;
    Order { groups, fronts, roots: root.elements, elements: element_groups.len() }.plan(size, kept)
}

impl Dissection<'_> {
    /// Eliminates all groups that no other part holds.
    fn part(&mut self, elements: &mut [usize]) -> Part {
        let total: usize = elements.iter().map(|e| self.weight[*e]).sum();
        let halves = if total <= LEAF || elements.len() == 1 {
            let leaf = |e: &usize| Part { elements: vec![*e], groups: self.element_groups[*e].iter().map(|g| (*g, 1)).collect() };
            elements.iter().map(leaf).collect()
        } else {
            let (a, b) = self.halve(elements);
            vec![self.part(a), self.part(b)]
        };
        let mut whole = Part { elements: Vec::new(), groups: Vec::new() };
        for half in halves {
            whole.elements.extend(half.elements);
            for (g, count) in half.groups {
                if self.slot[g] == usize::MAX {
                    self.slot[g] = whole.groups.len();
                    whole.groups.push((g, count));
                } else {
                    whole.groups[self.slot[g]].1 += count;
                }
            }
        }
        whole.groups.iter().for_each(|(g, _)| self.slot[*g] = usize::MAX);
        let (gone, left): (Vec<_>, Vec<_>) = whole.groups.iter().partition(|(g, count)| self.holders[*g] == *count);
        if gone.is_empty() {
            return whole;
        }
        self.order.extend(gone.iter().map(|(g, _)| *g));
        let groups = gone.iter().chain(&left).map(|(g, _)| *g).collect();
        self.fronts.push(FrontPlan { children: whole.elements, groups, eliminated: gone.len() });
        Part { elements: vec![self.element_groups.len() + self.fronts.len() - 1], groups: left }
    }

    /// Two halves with equally many elements, cut across the longer side of the extent.
    fn halve<'e>(&self, elements: &'e mut [usize]) -> (&'e mut [usize], &'e mut [usize]) {
        let extent = |axis: usize| {
            let values = elements.iter().map(|e| self.places[*e][axis]);
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
            high - low
        };
        let axis = usize::from(extent(1) > extent(0));
        let middle = elements.len() / 2;
        let key = |e: &usize| (self.places[*e][axis], *e);
        elements.select_nth_unstable_by(middle, |a, b| key(a).0.total_cmp(&key(b).0).then(a.cmp(b)));
        elements.split_at_mut(middle)
    }
}
