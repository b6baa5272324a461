//! Tables of the one-dimensional shape functions that the element matrices are made of, and the local order of modes.

use crate::legendre::shape_functions;
use crate::quadrature::{Quadrature, gauss};
use faer::Mat;

/// Shape functions of one degree at the points of one Gauss rule, and all their pairwise products.
#[derive(Clone, Debug)]
pub(crate) struct Table {
    /// Number of shape functions, `degree + 1`.
    pub(crate) functions: usize,
    /// The rule.
    pub(crate) rule: Quadrature,
    /// `products[2 a + b][(i + functions * j, q)] = f^(a)_i(x_q) f^(b)_j(x_q)`, a and b being orders of derivative 0 or 1.
    pub(crate) products: [Mat<f64>; 4],
    /// Values, `functions x points`.
    pub(crate) values: Mat<f64>,
}

impl Table {
    pub(crate) fn new(degree: usize, points: usize) -> Table {
        let rule = gauss(points);
        let n = degree + 1;
        let at: Vec<[Vec<f64>; 2]> = rule
            .points
            .iter()
            .map(|x| shape_functions(degree, *x).into())
            .collect();
        let products = std::array::from_fn(|ab| {
            Mat::from_fn(n * n, points, |ij, q| {
                at[q][ab / 2][ij % n] * at[q][ab % 2][ij / n]
            })
        });
        let values = Mat::from_fn(n, points, |i, q| at[q][0][i]);
        Table {
            functions: n,
            rule,
            products,
            values,
        }
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

/// Local degrees of freedom of a cell: interior modes first, then corners 0..4, then the modes of edges 0..4; displacement
/// components run fastest.
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
    /// First scalar position of each edge's modes; `[4]` is the end.
    pub(crate) edge_start: [usize; 5],
}

impl LocalModes {
    /// Modes of a cell of degree `degree` whose edges have degrees `edges` and are walked `against` their own direction: odd
    /// modes of such an edge change sign, which is all that continuity needs.
    pub(crate) fn new(
        degree: usize,
        edges: [usize; 4],
        against: [bool; 4],
        trunk: bool,
    ) -> LocalModes {
        let n = degree + 1;
        let mut position = vec![usize::MAX; n * n];
        let mut sign = vec![1.0; n * n];
        let mut interior = 0;
        for j in 2..n {
            for i in 2..n {
                if !trunk || i + j <= degree {
                    position[i + n * j] = interior;
                    interior += 1;
                }
            }
        }
        let mut edge_start = [interior + 4; 5];
        for e in 0..4 {
            edge_start[e + 1] = edge_start[e] + edges[e] - 1;
        }
        for j in 0..n {
            for i in 0..n {
                match place(i, j) {
                    Place::Interior => {}
                    Place::Corner(c) => position[i + n * j] = interior + c,
                    Place::Edge(e, k) if k <= edges[e] => {
                        position[i + n * j] = edge_start[e] + k - 2;
                        if against[e] && k % 2 == 1 {
                            sign[i + n * j] = -1.0;
                        }
                    }
                    Place::Edge(..) => {}
                }
            }
        }
        LocalModes {
            position,
            sign,
            interior,
            modes: edge_start[4],
            edge_start,
        }
    }
}
