//! Circles in a graph of nodes `0 .. count` and edges from, to.

use std::collections::VecDeque;

/// Strongly connected components of more than one node, the largest first, nodes in ascending order: within one, every node reaches
/// every other. Source: Tarjan, SIAM J. Comput. 1 (1972) 146-160.
pub(super) fn components(count: usize, edges: &[(usize, usize)]) -> Vec<Vec<usize>> {
    let mut search =
        Search { next: neighbours(count, edges), order: vec![None; count], low: vec![0; count], ..Search::default() };
    for node in 0..count {
        if search.order[node].is_none() {
            search.visit(node);
        }
    }
    search.found.sort_by_key(|component| (std::cmp::Reverse(component.len()), component.first().copied()));
    search.found
}

fn neighbours(count: usize, edges: &[(usize, usize)]) -> Vec<Vec<usize>> {
    let mut next = vec![Vec::new(); count];
    for &(from, to) in edges {
        next[from].push(to);
    }
    next
}

#[derive(Default)]
struct Search {
    next: Vec<Vec<usize>>,
    /// When a node was met.
    order: Vec<Option<usize>>,
    /// The earliest node on the stack that it reaches.
    low: Vec<usize>,
    stack: Vec<usize>,
    met: usize,
    found: Vec<Vec<usize>>,
}

impl Search {
    /// Meets a node and all it reaches; as deep as the longest chain of imports.
    fn visit(&mut self, node: usize) {
        let order = self.met;
        (self.order[node], self.low[node]) = (Some(order), order);
        self.met += 1;
        self.stack.push(node);
        for to in self.next[node].clone() {
            match self.order[to] {
                None => {
                    self.visit(to);
                    self.low[node] = self.low[node].min(self.low[to]);
                }
                Some(earlier) if self.stack.contains(&to) => self.low[node] = self.low[node].min(earlier),
                Some(_) => {}
            }
        }
        if self.low[node] == order
            && let Some(at) = self.stack.iter().position(|&other| other == node)
        {
            let mut component = self.stack.split_off(at);
            component.sort_unstable();
            if component.len() > 1 {
                self.found.push(component);
            }
        }
    }
}

/// A shortest circle through nodes of one component: each imports the next, the last the first.
pub(super) fn shortest_circle(component: &[usize], edges: &[(usize, usize)]) -> Vec<usize> {
    let inside: Vec<_> = edges.iter().copied().filter(|(from, to)| component.contains(from) && component.contains(to)).collect();
    let count = component.last().map_or(0, |last| last + 1);
    let next = neighbours(count, &inside);
    component.iter().filter_map(|&node| circle_through(node, &next)).min_by_key(Vec::len).unwrap_or_default()
}

/// Breadth-first from a node back to it.
fn circle_through(start: usize, next: &[Vec<usize>]) -> Option<Vec<usize>> {
    let mut before = vec![None; next.len()];
    let mut queue = VecDeque::from([start]);
    while let Some(node) = queue.pop_front() {
        for &to in &next[node] {
            if to == start {
                let mut way = vec![node];
                while let Some(earlier) = before[*way.last()?] {
                    way.push(earlier);
                }
                way.reverse();
                return Some(way);
            }
            if before[to].is_none() {
                before[to] = Some(node);
                queue.push_back(to);
            }
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_has_no_circle() {
        assert!(components(4, &[(0, 1), (1, 2), (0, 2), (2, 3)]).is_empty());
    }

    #[test]
    fn components_are_told_apart() {
        // 1 <-> 2 and 3 -> 4 -> 5 -> 3, with a way from the first to the second.
        let edges = [(0, 1), (1, 2), (2, 1), (2, 3), (3, 4), (4, 5), (5, 3), (5, 6)];
        assert_eq!(components(7, &edges), [vec![3, 4, 5], vec![1, 2]]);
    }

    #[test]
    fn the_shortest_circle_is_named_in_the_order_of_imports() {
        // 0 -> 1 -> 2 -> 3 -> 0 with a short cut 2 -> 1.
        let edges = [(0, 1), (1, 2), (2, 3), (3, 0), (2, 1)];
        assert_eq!(components(4, &edges), [vec![0, 1, 2, 3]]);
        assert_eq!(shortest_circle(&[0, 1, 2, 3], &edges), [1, 2]);
        assert_eq!(shortest_circle(&[0, 1, 2, 3], &edges[..4]), [0, 1, 2, 3]);
    }
}
