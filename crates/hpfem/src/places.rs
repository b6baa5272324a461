//! Places of merged elements in one buffer, known before the elimination runs.
//!
//! In postorder the elements that wait for a front are the last ones left, so that two stacks hold them, fronts at even and at odd depth
//! of the tree apart: a front reads its children from the top of one and leaves its element on the other. The stacks
//! grow towards each other from the two ends of one buffer, whose pages are touched once.

use crate::front::{FrontPlan, Plan};
use std::ops::Range;

/// Where each front leaves its merged element, a square of what it does not eliminate.
pub(crate) struct Places {
    /// The part of the buffer of each front's element.
    pub(crate) parts: Vec<Range<usize>>,
    /// Length of the buffer.
    pub(crate) length: usize,
}

impl Places {
    /// What lies before the element of a front, its own part, and what lies after it.
    pub(crate) fn split<'b>(&self, front: usize, buffer: &'b mut [f64]) -> [&'b mut [f64]; 3] {
        let Range { start, end } = self.parts[front];
        let (before, own) = buffer.split_at_mut(start);
        let (own, after) = own.split_at_mut(end - start);
        [before, own, after]
    }

    /// The element of a child in what lies before or after that of its parent.
    pub(crate) fn child<'b>(&self, child: usize, parent: usize, [before, after]: [&'b [f64]; 2]) -> &'b [f64] {
        let Range { start, end } = self.parts[child];
        match start.checked_sub(self.parts[parent].end) {
            Some(from) => &after[from..from + end - start],
            None => &before[start..end],
        }
    }
}

impl Plan {
    /// The places of all merged elements; `elements` is the number of original elements.
    pub(crate) fn places(&self, size: &[usize], elements: usize) -> Places {
        let odd = self.odd_depths(elements);
        let square = |front: &FrontPlan| front.left().iter().map(|g| size[*g]).sum::<usize>().pow(2);
        let mut height = [0; 2];
        let mut length = 0;
        let mut parts: Vec<Range<usize>> = Vec::with_capacity(self.fronts.len());
        for (front, odd) in self.fronts.iter().zip(&odd) {
            let (own, other) = (usize::from(*odd), usize::from(!odd));
            parts.push(height[own]..height[own] + square(front));
            height[own] = parts[parts.len() - 1].end;
            length = length.max(height[0] + height[1]);
            let children = front.children.iter().filter_map(|child| child.checked_sub(elements));
            height[other] -= children.map(|child| parts[child].len()).sum::<usize>();
        }
        let from_the_end = parts.iter_mut().zip(&odd).filter(|(_, odd)| **odd);
        from_the_end.for_each(|(part, _)| *part = length - part.end..length - part.start);
        Places { parts, length }
    }

    /// Whether the number of fronts between a front and the end is odd.
    fn odd_depths(&self, elements: usize) -> Vec<bool> {
        let mut odd = vec![false; self.fronts.len()];
        for (number, front) in self.fronts.iter().enumerate().rev() {
            let children = front.children.iter().filter_map(|child| child.checked_sub(elements));
            children.for_each(|child| odd[child] = !odd[number]);
        }
        odd
    }
}

/// Fronts in postorder: those on which a front rests come right before it, in the order of its children. Returns the number of each of the
/// old ones.
pub(crate) fn postorder(fronts: &[FrontPlan], roots: &[usize], elements: usize) -> Vec<usize> {
    let merged = |e: &usize| e.checked_sub(elements);
    // Walked from the end: the last child comes first.
    let mut open: Vec<usize> = roots.iter().filter_map(merged).collect();
    let mut number = vec![0; fronts.len()];
    let mut next = fronts.len();
    while let Some(front) = open.pop() {
        next -= 1;
        number[front] = next;
        open.extend(fronts[front].children.iter().filter_map(merged));
    }
    number
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two original elements a leaf; fronts 0 and 1 merge into 3, 2 and 3 into 4, in an order that is no postorder.
    fn tree() -> (Plan, Vec<usize>) {
        let front = |children: &[usize], groups: &[usize], eliminated| FrontPlan {
            children: children.to_vec(),
            groups: groups.to_vec(),
            eliminated,
        };
        let fronts = vec![
            front(&[0, 1], &[0, 3, 4], 1),
            front(&[2, 3], &[1, 4], 1),
            front(&[4, 5], &[2, 5], 1),
            front(&[6, 7], &[3, 4], 1),
            front(&[9, 8], &[4, 5], 1),
        ];
        (Plan { rank: (0..6).collect(), fronts, roots: vec![10] }, vec![2, 3, 4, 5, 6, 7])
    }

    #[test]
    fn fronts_come_right_after_those_they_rest_on() {
        let (plan, _) = tree();
        assert_eq!(postorder(&plan.fronts, &plan.roots, 6), [0, 1, 3, 2, 4]);
    }

    #[test]
    fn elements_that_wait_for_a_front_never_overlap_it_or_each_other() {
        let (mut plan, size) = tree();
        plan.fronts.swap(2, 3);
        plan.fronts[4].children = vec![8, 9];
        let places = plan.places(&size, 6);
        let mut waiting: Vec<usize> = Vec::new();
        for (f, front) in plan.fronts.iter().enumerate() {
            let own = &places.parts[f];
            assert!(own.end <= places.length);
            for other in &waiting {
                let other = &places.parts[*other];
                assert!(other.end <= own.start || own.end <= other.start, "{own:?} {other:?}");
            }
            waiting.retain(|w| !front.children.contains(&(w + 6)));
            waiting.push(f);
        }
        // The first two and what they merge into are the most that is held at once.
        assert_eq!(places.length, 11 * 11 + 6 * 6 + 6 * 6);
    }
}
