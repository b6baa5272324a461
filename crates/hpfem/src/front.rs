//! Which elements meet in which front, in which order, and the memory that takes.

/// Bodies whose elimination would hold more bytes than this are refused: three quarters of 16 GiB.
pub(crate) const MEMORY_LIMIT: u64 = 12 << 30;

/// What mesh, numbering, shapes and order take a cell, as measured on a million unknowns of degree 2.
const CELL_BYTES: u64 = 1500;

/// What buffers, tables and touched pages of the program take.
const BASE_BYTES: u64 = 10 << 20;

/// The order of elimination and which elements meet in which front; it depends on the mesh and the degrees alone.
pub(crate) struct Plan {
    /// Place of each group in the order; kept groups come last, in the order given.
    pub(crate) rank: Vec<usize>,
    pub(crate) fronts: Vec<FrontPlan>,
    /// Elements left at the end.
    pub(crate) roots: Vec<usize>,
}

/// An order of elimination as it is found: fronts not yet joined, their groups not yet sorted.
pub(crate) struct Order {
    /// Groups in the order in which they disappear.
    pub(crate) groups: Vec<usize>,
    pub(crate) fronts: Vec<FrontPlan>,
    /// Elements left at the end.
    pub(crate) roots: Vec<usize>,
    /// Number of original elements.
    pub(crate) elements: usize,
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
        let elements: Vec<u64> = element_groups.iter().enumerate().map(own).collect();
        let mut held: u64 = elements.iter().sum();
        let mut largest = held;
        // Merged elements share one buffer, whose pages stay.
        let (mut waiting, mut buffer) = (0, 0);
        for front in &self.fronts {
            let (gone, left) = front.groups.split_at(front.eliminated);
            held += 8 * unknowns(&front.groups) * unknowns(gone);
            waiting += square(left);
            buffer = waiting.max(buffer);
            largest = largest.max(held + buffer);
            for child in &front.children {
                match child.checked_sub(elements.len()) {
                    Some(merged) => waiting -= square(self.fronts[merged].left()),
                    None => held -= elements[*child],
                }
            }
        }
        // What is left is copied into the operator.
        largest = largest.max(held + buffer + square(kept)).max(held + 2 * square(kept));
        largest + CELL_BYTES * element_groups.len() as u64 + BASE_BYTES
    }
}

/// Multiplications to eliminate `gone` of `all` unknowns of a dense symmetric matrix.
pub(crate) fn partial_factor(gone: f64, all: f64) -> f64 {
    let left = all - gone;
    gone.powi(3) / 6.0 + 0.5 * gone * gone * left + 0.5 * gone * left * left
}
