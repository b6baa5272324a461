//! A rectangle of cells as `geometry.blocks`.

use super::draw::Random;
use super::numbers::Writing;

/// Names in an order of their own: whatever is sorted by name is sorted differently by each seed. Seed 0 keeps the order of the grid.
pub(super) struct Names(pub Vec<usize>);

impl Names {
    pub(super) fn new(count: usize, random: Option<&mut Random>) -> Names {
        let mut order: Vec<usize> = (0..count).collect();
        if let Some(random) = random {
            for last in (1..count).rev() {
                order.swap(last, random.below(last + 1));
            }
        }
        Names(order)
    }
}

/// The grid, its names and the directions in which things are walked.
struct Grid<'a> {
    x: &'a [f64],
    z: &'a [f64],
    points: Names,
    across: Names,
    cells: Names,
    random: Option<Random>,
}

impl Grid<'_> {
    fn point(&self, i: usize, j: usize) -> String {
        format!("p{:03}", self.points.0[j * self.x.len() + i])
    }

    /// The curve from point (i, j) towards +x or +z.
    fn curve(&self, i: usize, j: usize, up: bool) -> String {
        format!("c{:03}", self.across.0[2 * (j * self.x.len() + i) + usize::from(up)])
    }

    fn turned(&mut self) -> bool {
        self.random.as_mut().is_some_and(|random| random.below(2) == 1)
    }

    fn points_text(&self, writing: Writing) -> String {
        let place = |i: usize, j: usize| format!("{} = {}\n", self.point(i, j), writing.lengths([self.x[i], self.z[j]]));
        (0..self.z.len()).flat_map(|j| (0..self.x.len()).map(move |i| (i, j))).map(|(i, j)| place(i, j)).collect()
    }

    fn curves_text(&mut self) -> String {
        let (columns, rows) = (self.x.len(), self.z.len());
        let mut text = String::new();
        for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
            for (up, to) in [(false, (i + 1, j)), (true, (i, j + 1))] {
                if to.0 < columns && to.1 < rows {
                    let mut ends = [self.point(i, j), self.point(to.0, to.1)];
                    if self.turned() {
                        ends.reverse();
                    }
                    text += &format!("{}.line = {ends:?}\n", self.curve(i, j, up));
                }
            }
        }
        text
    }

    fn cells_text(&mut self) -> String {
        let (columns, rows) = (self.x.len() - 1, self.z.len() - 1);
        let mut text = String::new();
        for (i, j) in (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))) {
            let mut around =
                [self.curve(i, j, false), self.curve(i + 1, j, true), self.curve(i, j + 1, false), self.curve(i, j, true)];
            if let Some(random) = &mut self.random {
                around.rotate_left(random.below(4));
                if random.below(2) == 1 {
                    around.reverse();
                }
            }
            text += &format!("k{:03} = {{ curves = {around:?} }}\n", self.cells.0[j * columns + i]);
        }
        text
    }

    fn edges_text(&self) -> String {
        let (columns, rows) = (self.x.len() - 1, self.z.len() - 1);
        let along = |j: usize| (0..columns).map(|i| self.curve(i, j, false)).collect::<Vec<_>>();
        let up = |i: usize| (0..rows).map(|j| self.curve(i, j, true)).collect::<Vec<_>>();
        format!("bottom = {:?}\ntop = {:?}\nleft = {:?}\nright = {:?}\n", along(0), along(rows), up(0), up(columns))
    }
}

/// The tables of a body's blocks.
pub(super) fn tables(body: usize, [x, z]: [&[f64]; 2], naming: u64, writing: Writing) -> String {
    let mut random = (naming != 0).then(|| Random::new(naming));
    let count = x.len() * z.len();
    let points = Names::new(count, random.as_mut());
    let across = Names::new(2 * count, random.as_mut());
    let cells = Names::new(count, random.as_mut());
    let mut grid = Grid { x, z, points, across, cells, random };
    let at = format!("body{body}.geometry.blocks");
    format!(
        "[{at}.points]\n{}[{at}.curves]\n{}[{at}.cells]\n{}[{at}.edges]\n{}",
        grid.points_text(writing),
        grid.curves_text(),
        grid.cells_text(),
        grid.edges_text()
    )
}
