//! The order of elimination.

use crate::amalgamation::{amalgamated, front_cost};
use crate::dissection::dissected;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Bodies whose elimination would hold more bytes than this are refused: three quarters of 16 GiB.
pub(crate) const MEMORY_LIMIT: u64 = 12 << 30;

/// What mesh, numbering, shapes and order take a cell, as measured on a million unknowns of degree 2.
const CELL_BYTES: u64 = 1500;

/// What buffers, tables and touched pages of the program take.
const BASE_BYTES: u64 = 10 << 20;

/// More elements than this are ordered by nested dissection alone.
const MANY_ELEMENTS: usize = 1000;
/// Up to this many elements minimum degree has always been the better order.
const FEW_ELEMENTS: usize = 100;

/// The order of elimination and which elements meet in which front; it depends on the mesh and the degrees alone.
pub(crate) struct Plan {
    /// Place of each group in the order; kept groups come last, in the order given.
    pub(crate) rank: Vec<usize>,
    pub(crate) fronts: Vec<FrontPlan>,
    /// Elements left at the end.
    pub(crate) roots: Vec<usize>,
}

/// Elements that merge and groups that disappear.
#[derive(Default)]
pub(crate) struct FrontPlan {
    pub(crate) children: Vec<usize>,
    /// Groups in order of rank; the first `eliminated` of them disappear.
    pub(crate) groups: Vec<usize>,
    pub(crate) eliminated: usize,
}

impl FrontPlan {
    /// The groups that stay.
    pub(crate) fn left(&self) -> &[usize] {
        &self.groups[self.eliminated..]
    }
}

impl Plan {
    /// The order for elements at the given places: minimum degree, which finds the chains of graded layers, for few elements, nested
    /// dissection for many, in between the one that costs less.
    pub(crate) fn new(element_groups: &[Vec<usize>], places: &[[f64; 2]], size: &[usize], kept: &[usize]) -> Plan {
        let elements = element_groups.len();
        if elements > MANY_ELEMENTS {
            return dissected(element_groups, places, size, kept);
        }
        let plan = Plan::minimum_degree(element_groups, size, kept);
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

    /// Minimum-degree order with approximate external degrees (Amestoy, Davis and Duff 1996), weighted by group size.
    pub(crate) fn minimum_degree(element_groups: &[Vec<usize>], size: &[usize], kept: &[usize]) -> Plan {
        let mut is_kept = vec![false; size.len()];
        kept.iter().for_each(|g| is_kept[*g] = true);
        let mut members: Vec<Vec<usize>> = element_groups.to_vec();
        let mut weight: Vec<usize> = members.iter().map(|m| m.iter().map(|g| size[*g]).sum()).collect();
        let mut holders: Vec<Vec<usize>> = vec![Vec::new(); size.len()];
        for (e, groups) in members.iter().enumerate() {
            groups.iter().for_each(|g| holders[*g].push(e));
        }
        let mut alive = vec![true; members.len()];
        let mut degree: Vec<usize> = (0..size.len()).map(|g| holders[g].iter().map(|e| weight[*e] - size[g]).sum()).collect();
        let mut heap: BinaryHeap<Reverse<(usize, usize)>> =
            (0..size.len()).filter(|g| !is_kept[*g] && !holders[*g].is_empty()).map(|g| Reverse((degree[g], g))).collect();
        let mut done = vec![false; size.len()];
        let mut stamp = vec![usize::MAX; size.len()];
        let mut outside: Vec<usize> = vec![0; members.len()];
        let mut outside_stamp: Vec<usize> = vec![usize::MAX; members.len()];
        let mut order = Vec::with_capacity(size.len());
        let mut fronts = Vec::new();
        while let Some(Reverse((d, g))) = heap.pop() {
            if done[g] || d != degree[g] {
                continue;
            }
            let id = members.len();
            let children = std::mem::take(&mut holders[g]);
            let mut union = Vec::new();
            for child in &children {
                alive[*child] = false;
                for h in std::mem::take(&mut members[*child]) {
                    if stamp[h] != id {
                        stamp[h] = id;
                        union.push(h);
                    }
                }
            }
            let mut remaining = Vec::new();
            let before = order.len();
            for h in &union {
                holders[*h].retain(|e| alive[*e]);
                if !is_kept[*h] && holders[*h].is_empty() {
                    done[*h] = true;
                    order.push(*h);
                } else {
                    remaining.push(*h);
                }
            }
            let total: usize = remaining.iter().map(|h| size[*h]).sum();
            // |L_e \ L_id| for every element e that shares a group with the new one.
            for h in &remaining {
                for e in &holders[*h] {
                    if outside_stamp[*e] != id {
                        outside_stamp[*e] = id;
                        outside[*e] = weight[*e];
                    }
                    outside[*e] -= size[*h];
                }
            }
            for h in &remaining {
                degree[*h] = total - size[*h] + holders[*h].iter().map(|e| outside[*e]).sum::<usize>();
                holders[*h].push(id);
                if !is_kept[*h] {
                    heap.push(Reverse((degree[*h], *h)));
                }
            }
            fronts.push(FrontPlan { children, groups: union, eliminated: order.len() - before });
            members.push(remaining);
            weight.push(total);
            alive.push(true);
            outside.push(0);
            outside_stamp.push(usize::MAX);
        }
        let roots = (0..members.len()).filter(|e| alive[*e]).collect();
        Plan::ordered(order, fronts, roots, element_groups.len(), size, kept)
    }

    /// The plan with ranks by the order of elimination, small fronts joined.
    pub(crate) fn ordered(
        order: Vec<usize>,
        mut fronts: Vec<FrontPlan>,
        roots: Vec<usize>,
        elements: usize,
        size: &[usize],
        kept: &[usize],
    ) -> Plan {
        let mut rank = vec![usize::MAX; size.len()];
        order.iter().chain(kept).enumerate().for_each(|(i, g)| rank[*g] = i);
        // A front that joins another was eliminated before it, so that groups stay sorted.
        fronts.iter_mut().for_each(|front| front.groups.sort_by_key(|g| rank[*g]));
        let (fronts, roots) = amalgamated(fronts, roots, elements, size);
        Plan { rank, fronts, roots }
    }

    /// Largest memory the elimination will hold at once, in bytes: panels of all fronts, elements not yet merged, and what is known of
    /// the cells; `owns` tells which elements have a matrix of their own, right-hand sides included.
    pub(crate) fn bytes(
        &self,
        element_groups: &[Vec<usize>],
        size: &[usize],
        kept: &[usize],
        owns: impl Fn(usize) -> bool,
    ) -> u64 {
        let unknowns = |groups: &[usize]| groups.iter().map(|g| size[*g] as u64).sum::<u64>();
        let square = |groups: &[usize]| 8 * unknowns(groups).pow(2);
        let own = |(e, groups): (usize, &Vec<usize>)| if owns(e) { square(groups) } else { 0 };
        let mut elements: Vec<u64> = element_groups.iter().enumerate().map(own).collect();
        let mut held: u64 = elements.iter().sum();
        let mut largest = held;
        for front in &self.fronts {
            let (gone, left) = front.groups.split_at(front.eliminated);
            elements.push(square(left));
            held += 8 * unknowns(&front.groups) * unknowns(gone) + square(left);
            largest = largest.max(held);
            held -= front.children.iter().map(|child| elements[*child]).sum::<u64>();
        }
        // What is left is copied into the operator and brought to its units.
        largest = largest.max(held + 3 * square(kept));
        largest + CELL_BYTES * element_groups.len() as u64 + BASE_BYTES
    }
}
