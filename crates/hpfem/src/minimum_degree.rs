//! Minimum-degree order of elimination.

use crate::front::{FrontPlan, Plan};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

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
