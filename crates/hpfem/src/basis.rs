//! Tables of the one-dimensional shape functions that the element matrices are made of, and the local order of modes.

use crate::legendre::shape_functions;
use crate::quadrature::{Quadrature, gauss};
use faer::Mat;
use std::sync::OnceLock;

/// Highest degree of a cell.
pub const MAX_DEGREE: usize = 24;

/// Which tensor products of shape functions a quadrilateral has in its interior. Triangles have all polynomials of their degree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SpaceKind {
    /// All products up to the degree in each direction.
    #[default]
    Tensor,
    /// Products whose degrees sum up to the degree at most (serendipity).
    Trunk,
}

/// Number of Gauss points a direction for a cell of the given degree; curved maps need a little more than `degree + 1`.
pub(crate) fn points_for(degree: usize) -> usize {
    degree + 2
}

/// Shape functions of one degree at the points of one Gauss rule, and all their pairwise products.
///
/// In the tables the bubbles come first and the two hats last, so that interior modes of a cell stand in runs.
#[derive(Clone, Debug)]
pub(crate) struct Table {
    /// Number of shape functions, `degree + 1`.
    pub(crate) functions: usize,
    /// The rule.
    pub(crate) rule: Quadrature,
    /// Shape function at each place of the tables: `2, 3, .., degree, 0, 1`.
    pub(crate) order: Vec<usize>,
    /// `all[2 a + b][(i + functions * j, q)] = f^(a)_i(x_q) f^(b)_j(x_q)`, a and b being orders of derivative 0 or 1.
    pub(crate) all: [Mat<f64>; 4],
    /// The rows of `all` with `i >= j`, in the same order.
    pub(crate) lower: [Mat<f64>; 4],
    /// The shape functions in their own order, and their slopes, at the points of the rule.
    pub(crate) shapes: [Mat<f64>; 2],
}

/// Shape functions of a degree and their slopes at points, `points x functions`.
pub(crate) fn shapes_at(degree: usize, points: &[f64]) -> [Mat<f64>; 2] {
    let functions: Vec<_> = points.iter().map(|x| shape_functions(degree, *x)).collect();
    let values = Mat::from_fn(points.len(), degree + 1, |q, i| functions[q].0[i]);
    [values, Mat::from_fn(points.len(), degree + 1, |q, i| functions[q].1[i])]
}

/// Tables by degree, made when first asked for.
static TABLES: [OnceLock<Table>; MAX_DEGREE + 1] = [const { OnceLock::new() }; MAX_DEGREE + 1];

impl Table {
    /// The table of a degree, `1..=`[`MAX_DEGREE`], at the points that its cells take.
    pub(crate) fn of(degree: usize) -> &'static Table {
        TABLES[degree].get_or_init(|| Table::new(degree, points_for(degree)))
    }

    fn new(degree: usize, points: usize) -> Table {
        let rule = gauss(points);
        let n = degree + 1;
        let order: Vec<usize> = (2..n).chain([0, 1]).collect();
        let mut all = std::array::from_fn(|_| Mat::zeros(n * n, points));
        let mut lower = std::array::from_fn(|_| Mat::zeros(n * (n + 1) / 2, points));
        for (q, x) in rule.points.iter().enumerate() {
            let (values, slopes) = shape_functions(degree, *x);
            let sorted = [values, slopes].map(|f| order.iter().map(|i| f[*i]).collect::<Vec<f64>>());
            for ab in 0..4 {
                let (test, trial) = (&sorted[ab / 2], &sorted[ab % 2]);
                let column: &mut [f64] = all[ab].col_as_slice_mut(q);
                for (run, b) in column.chunks_exact_mut(n).zip(trial) {
                    run.iter_mut().zip(test).for_each(|(out, a)| *out = a * b);
                }
                let mut rest: &mut [f64] = lower[ab].col_as_slice_mut(q);
                for (j, b) in trial.iter().enumerate() {
                    let (run, next) = rest.split_at_mut(n - j);
                    run.iter_mut().zip(&test[j..]).for_each(|(out, a)| *out = a * b);
                    rest = next;
                }
            }
        }
        let shapes = shapes_at(degree, &rule.points);
        Table { functions: n, rule, order, all, lower, shapes }
    }
}

/// Where a tensor mode `(i, j)` of a cell lives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// Corner number.
    Corner(usize),
    /// Local edge and one-dimensional mode along it, `>= 2`.
    Edge(usize, usize),
    /// Interior mode.
    Interior,
}

/// The place of the tensor mode `N_i(xi) N_j(eta)`.
pub(crate) fn place(i: usize, j: usize) -> Place {
    match (i, j) {
        (0, 0) => Place::Corner(0),
        (1, 0) => Place::Corner(1),
        (1, 1) => Place::Corner(2),
        (0, 1) => Place::Corner(3),
        (i, 0) => Place::Edge(0, i),
        (1, j) => Place::Edge(1, j),
        (i, 1) => Place::Edge(2, i),
        (0, j) => Place::Edge(3, j),
        _ => Place::Interior,
    }
}

/// Local degrees of freedom of a cell: interior modes first (the mode in eta runs fastest), then the corners, then the modes of
/// edges 0..4; displacement components run fastest. The modes of a triangle are numbered as by
/// [`triangle_modes`](crate::triangle::triangle_modes) instead of `i + n * j`.
#[derive(Clone, Debug)]
pub(crate) struct LocalModes {
    /// Scalar position of the tensor mode `i + n * j` in the local order; `usize::MAX` if the space lacks it.
    pub(crate) position: Vec<usize>,
    /// Sign of the tensor mode in the local order.
    pub(crate) sign: Vec<f64>,
    /// Number of interior scalar modes.
    pub(crate) interior: usize,
    /// Number of scalar modes.
    pub(crate) modes: usize,
}

/// Boundary modes of a cell: the corners, then the modes of edges 0..4.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BoundaryModes {
    /// Number of corners.
    pub(crate) corners: usize,
    /// First mode of each edge; `[4]` is the number of all.
    start: [usize; 5],
}

impl BoundaryModes {
    /// Modes of a cell with so many corners and edges of the given degrees.
    pub(crate) fn new(corners: usize, edges: [usize; 4]) -> BoundaryModes {
        let mut start = [corners; 5];
        (0..4).for_each(|e| start[e + 1] = start[e] + edges[e] - 1);
        BoundaryModes { corners, start }
    }

    pub(crate) fn len(&self) -> usize {
        self.start[4]
    }

    /// Modes of an edge.
    pub(crate) fn edge(&self, edge: usize) -> std::ops::Range<usize> {
        self.start[edge]..self.start[edge + 1]
    }
}

impl LocalModes {
    /// Sign of every scalar mode in the local order.
    pub(crate) fn signs(&self) -> Vec<f64> {
        let mut signs = vec![1.0; self.modes];
        let present = self.position.iter().zip(&self.sign).filter(|(position, _)| **position != usize::MAX);
        present.for_each(|(position, sign)| signs[*position] = *sign);
        signs
    }

    /// Modes of a cell of degree `degree` whose edges have degrees `edges` and are walked `against` their own direction: odd
    /// modes of such an edge change sign, which is all that continuity needs.
    pub(crate) fn new(degree: usize, edges: [usize; 4], against: [bool; 4], trunk: bool) -> LocalModes {
        let n = degree + 1;
        let mut position = vec![usize::MAX; n * n];
        let mut sign = vec![1.0; n * n];
        let mut interior = 0;
        for i in 2..n {
            for j in 2..n {
                if !trunk || i + j <= degree {
                    position[i + n * j] = interior;
                    interior += 1;
                }
            }
        }
        let boundary = BoundaryModes::new(4, edges);
        for j in 0..n {
            for i in 0..n {
                match place(i, j) {
                    Place::Interior => {}
                    Place::Corner(c) => position[i + n * j] = interior + c,
                    Place::Edge(e, k) if k <= edges[e] => {
                        position[i + n * j] = interior + boundary.edge(e).start + k - 2;
                        if against[e] && k % 2 == 1 {
                            sign[i + n * j] = -1.0;
                        }
                    }
                    Place::Edge(..) => {}
                }
            }
        }
        LocalModes { position, sign, interior, modes: interior + boundary.len() }
    }

    /// Modes of a triangle, whose edge 2 does not exist.
    pub(crate) fn triangle(degree: usize, edges: [usize; 4], against: [bool; 4]) -> LocalModes {
        let interior = (degree - 1) * degree.saturating_sub(2) / 2;
        let mut position: Vec<usize> = (0..interior + 3).collect();
        let mut sign = vec![1.0; interior + 3];
        let boundary = BoundaryModes::new(3, edges);
        for e in 0..4 {
            for k in 2..=if e == 2 { 1 } else { degree } {
                position.push(if k <= edges[e] { interior + boundary.edge(e).start + k - 2 } else { usize::MAX });
                sign.push(if against[e] && k % 2 == 1 { -1.0 } else { 1.0 });
            }
        }
        LocalModes { position, sign, interior, modes: interior + boundary.len() }
    }
}
