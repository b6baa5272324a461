//! Minimum-degree order with approximate external degrees (Amestoy, Davis and Duff 1996), weighted by group size.

use crate::front::{FrontPlan, Order, Plan};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The quotient graph: elements, merged ones after the original ones, and the groups they hold.
struct Graph<'s> {
    /// Number of unknowns of each group.
    size: &'s [usize],
    is_kept: Vec<bool>,
    /// Groups of each element; none once it is merged.
    members: Vec<Vec<usize>>,
    /// Number of unknowns of each element.
    weight: Vec<usize>,
    /// Elements not yet merged.
    alive: Vec<bool>,
    /// Elements that hold each group.
    holders: Vec<Vec<usize>>,
    /// External degree of each group.
    degree: Vec<usize>,
    /// Groups that are eliminated.
    done: Vec<bool>,
    /// Groups by degree; entries whose degree has changed are passed over.
    heap: BinaryHeap<Reverse<(usize, usize)>>,
    /// The element that each group was last seen in.
    stamp: Vec<usize>,
    /// Number of unknowns of each element outside the newest one, and the newest one at that time.
    outside: Vec<(usize, usize)>,
}

/// The plan by minimum degree.
pub(crate) fn minimum_degree(element_groups: &[Vec<usize>], size: &[usize], kept: &[usize]) -> Plan {
    let mut graph = Graph::new(element_groups, size, kept);
    let (mut order, mut fronts) = (Vec::with_capacity(size.len()), Vec::new());
    while let Some(Reverse((d, g))) = graph.heap.pop() {
        if graph.done[g] || d != graph.degree[g] {
            continue;
        }
        let children = std::mem::take(&mut graph.holders[g]);
        let groups = graph.merged(&children);
        let before = order.len();
        let remaining = graph.eliminated(&groups, &mut order);
        graph.push(remaining);
        fronts.push(FrontPlan { children, groups, eliminated: order.len() - before });
    }
    let roots = (0..graph.members.len()).filter(|e| graph.alive[*e]).collect();
    Order { groups: order, fronts, roots, elements: element_groups.len() }.plan(size, kept)
}

impl Graph<'_> {
    fn new<'s>(element_groups: &[Vec<usize>], size: &'s [usize], kept: &[usize]) -> Graph<'s> {
        let mut is_kept = vec![false; size.len()];
        kept.iter().for_each(|g| is_kept[*g] = true);
        let members: Vec<Vec<usize>> = element_groups.to_vec();
        let weight: Vec<usize> = members.iter().map(|m| m.iter().map(|g| size[*g]).sum()).collect();
        let mut many = vec![0; size.len()];
        members.iter().flatten().for_each(|g| many[*g] += 1);
        // An element that is pushed takes the place of at least one that is merged.
        let mut holders: Vec<Vec<usize>> = many.iter().map(|many| Vec::with_capacity(many + 1)).collect();
        for (e, groups) in members.iter().enumerate() {
            groups.iter().for_each(|g| holders[*g].push(e));
        }
        let degree: Vec<usize> = (0..size.len()).map(|g| holders[g].iter().map(|e| weight[*e] - size[g]).sum()).collect();
        let heap = (0..size.len()).filter(|g| !is_kept[*g] && !holders[*g].is_empty()).map(|g| Reverse((degree[g], g))).collect();
        let alive = vec![true; members.len()];
        let (done, stamp) = (vec![false; size.len()], vec![usize::MAX; size.len()]);
        let outside = vec![(0, usize::MAX); members.len()];
        Graph { size, is_kept, members, weight, alive, holders, degree, done, heap, stamp, outside }
    }

    /// All groups of the elements, which are merged.
    fn merged(&mut self, children: &[usize]) -> Vec<usize> {
        let id = self.members.len();
        let mut union = Vec::new();
        for child in children {
            self.alive[*child] = false;
            for h in std::mem::take(&mut self.members[*child]) {
                if self.stamp[h] != id {
                    self.stamp[h] = id;
                    union.push(h);
                }
            }
        }
        union
    }

    /// Puts the groups that no living element holds into the order and returns the others.
    fn eliminated(&mut self, groups: &[usize], order: &mut Vec<usize>) -> Vec<usize> {
        let mut remaining = Vec::new();
        for h in groups {
            self.holders[*h].retain(|e| self.alive[*e]);
            if !self.is_kept[*h] && self.holders[*h].is_empty() {
                self.done[*h] = true;
                order.push(*h);
            } else {
                remaining.push(*h);
            }
        }
        remaining
    }

    /// Adds the element of the remaining groups and brings their degrees up to date.
    fn push(&mut self, remaining: Vec<usize>) {
        let id = self.members.len();
        let total: usize = remaining.iter().map(|h| self.size[*h]).sum();
        // |L_e \ L_id| for every element e that shares a group with the new one.
        for h in &remaining {
            for e in &self.holders[*h] {
                let (outside, newest) = &mut self.outside[*e];
                if *newest != id {
                    (*outside, *newest) = (self.weight[*e], id);
                }
                *outside -= self.size[*h];
            }
        }
        for h in &remaining {
            let others = self.holders[*h].iter().map(|e| self.outside[*e].0).sum::<usize>();
            self.degree[*h] = total - self.size[*h] + others;
            self.holders[*h].push(id);
            if !self.is_kept[*h] {
                self.heap.push(Reverse((self.degree[*h], *h)));
            }
        }
        self.members.push(remaining);
        self.weight.push(total);
        self.alive.push(true);
        self.outside.push((0, usize::MAX));
    }
}
