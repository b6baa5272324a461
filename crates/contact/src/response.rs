//! What one body does under forces at the contact points: its interface operator, solved once for every column a contact solve needs.

use crate::error::Error;
use crate::products::{add, symmetric_times, times};
use crate::segment::Station;
use crate::side::Side;
use faer::linalg::solvers::{DenseSolveCore, Solve};
use faer::{Mat, Side as Triangle};
use hpfem::InterfaceOperator;

/// Kept displacements of one body as a linear function of nodal contact forces, load factors and rigid coordinates:
/// `u = U_f a + X_n lambda + X_t sigma + Y y`, with the balance `K y = Y^T (f + N^T lambda + T^T sigma) + resultant`.
///
/// With a rigid edge the coordinates `y` are its free motions and everything else is solved with the edge held; without one they are
/// the rigid motions that the supports leave free (then `K = 0`).
#[derive(Clone, Debug)]
pub(crate) struct Response {
    /// Normal displacement at the points, `points x unknowns`.
    pub(crate) normal: Mat<f64>,
    /// Tangential displacement at the points, `points x unknowns`; no columns if shear was not asked for.
    pub(crate) tangential: Option<Mat<f64>>,
    /// Prescribed parts of the normal and tangential displacement.
    pub(crate) constant: [Vec<f64>; 2],
    /// `X_n`, `unknowns x points`.
    pub(crate) to_normal: Mat<f64>,
    /// `X_t`.
    pub(crate) to_tangential: Option<Mat<f64>>,
    /// `U_f`, `unknowns x (load cases + 1)`.
    pub(crate) to_columns: Mat<f64>,
    /// `Y`, `unknowns x coordinates`.
    pub(crate) motions: Mat<f64>,
    /// Normal and tangential displacement at the points by the coordinates, `points x coordinates`; round-off is cleared.
    pub(crate) motion: [Mat<f64>; 2],
    /// `K`, `coordinates x coordinates`.
    pub(crate) stiffness: Mat<f64>,
    /// `Y^T F`, `coordinates x (load cases + 1)`.
    pub(crate) motion_columns: Mat<f64>,
    /// For each coordinate the motion of the rigid edge it is: 0, 1, 2 for `t_x`, `t_z`, `theta`; `None` for a rigid mode.
    pub(crate) edge_motion: Vec<Option<usize>>,
}

impl Response {
    pub(crate) fn new(
        body: &InterfaceOperator,
        side: Side,
        points: usize,
        stations: &[Station],
        shear: bool,
    ) -> Result<Response, Error> {
        let n = points;
        let rows = |tangential: bool| component_rows(body, side, n, stations, tangential);
        let (normal, normal_constant) = rows(false);
        let (tangential, tangential_constant) = rows(true);
        let unknowns = body.stiffness.nrows();
        let columns = body.load_cases.len() + 1;
        let frame: Vec<usize> = body.frame.iter().flatten().copied().collect();
        let mut forces = vec![&normal];
        forces.extend(shear.then_some(&tangential));
        let loads = body.columns.subcols(0, columns).to_owned();
        let Answers { by_forces, to_columns, motions, stiffness } = if frame.is_empty() {
            with_nothing_held(body, &forces, &loads)
        } else {
            with_edge_held(body, &forces, &loads, &frame).ok_or(Error::NotHeld { side })?
        };
        let motion_columns = motions.transpose() * loads;
        let edge_motion = if frame.is_empty() {
            vec![None; motions.ncols()]
        } else {
            (0..3).filter(|k| body.frame[*k].is_some()).map(Some).collect()
        };
        let mut motion = [&normal * &motions, &tangential * &motions];
        for j in 0..motions.ncols() {
            let largest = motion.iter().flat_map(|m| m.col(j).iter()).fold(0.0_f64, |m, v| m.max(v.abs()));
            for m in &mut motion {
                (0..n).filter(|i| m[(*i, j)].abs() <= 1e-12 * largest).collect::<Vec<_>>().iter().for_each(|i| m[(*i, j)] = 0.0);
            }
        }
        let mut by_forces = by_forces.into_iter();
        Ok(Response {
            to_normal: by_forces.next().unwrap_or_else(|| Mat::zeros(unknowns, n)),
            to_tangential: by_forces.next(),
            to_columns,
            normal,
            tangential: shear.then_some(tangential),
            constant: [normal_constant, tangential_constant],
            motions,
            motion,
            stiffness,
            motion_columns,
            edge_motion,
        })
    }

    /// Kept unknowns under factors, nodal forces on this body (normal and tangential) and coordinates.
    pub(crate) fn unknowns(&self, factors: &[f64], normal: &[f64], tangential: &[f64], coordinates: &[f64]) -> Vec<f64> {
        let mut u = times(&self.to_columns, factors);
        add(&mut u, &times(&self.to_normal, normal));
        if let Some(matrix) = &self.to_tangential {
            add(&mut u, &times(matrix, tangential));
        }
        add(&mut u, &times(&self.motions, coordinates));
        u
    }
}

/// What a body does under forces at the points and under its loads, and its coordinates with their stiffness.
struct Answers {
    /// `X_n`, and `X_t` if shear was asked for.
    by_forces: Vec<Mat<f64>>,
    to_columns: Mat<f64>,
    motions: Mat<f64>,
    stiffness: Mat<f64>,
}

/// Whether forces are so many that the inverse takes less than to solve for each: as rows of few entries they cost next to nothing then.
fn by_inverse(forces: &[&Mat<f64>]) -> bool {
    forces.iter().map(|rows| rows.nrows()).sum::<usize>() >= forces.iter().map(|rows| rows.ncols()).max().unwrap_or(0)
}

/// Solves with the motions of a body as they are.
fn with_nothing_held(body: &InterfaceOperator, forces: &[&Mat<f64>], loads: &Mat<f64>) -> Answers {
    let modes = &body.rigid_modes;
    let (by_forces, to_columns) = match by_inverse(forces).then(|| body.flexibility()).flatten() {
        Some(inverse) => (forces.iter().map(|rows| symmetric_times(&inverse, rows)).collect(), &inverse * loads),
        None => {
            let by_forces = forces.iter().map(|rows| rows.transpose().to_owned());
            let ends: Vec<usize> = forces
                .iter()
                .scan(0, |end, rows| {
                    *end += rows.nrows();
                    Some(*end)
                })
                .collect();
            let mut right = Mat::zeros(body.stiffness.nrows(), ends.last().unwrap_or(&0) + loads.ncols());
            for (rows, end) in by_forces.zip(&ends) {
                right.subcols_mut(end - rows.ncols(), rows.ncols()).copy_from(rows);
            }
            right.subcols_mut(right.ncols() - loads.ncols(), loads.ncols()).copy_from(loads);
            let solved = body.solve(&right, modes);
            let of = |(rows, end): (&&Mat<f64>, &usize)| solved.subcols(end - rows.nrows(), rows.nrows()).to_owned();
            (forces.iter().zip(&ends).map(of).collect(), solved.subcols(right.ncols() - loads.ncols(), loads.ncols()).to_owned())
        }
    };
    Answers { by_forces, to_columns, motions: modes.clone(), stiffness: Mat::zeros(modes.ncols(), modes.ncols()) }
}

/// Solves with the rigid edge held, whose motions are the coordinates.
fn with_edge_held(body: &InterfaceOperator, forces: &[&Mat<f64>], loads: &Mat<f64>, frame: &[usize]) -> Option<Answers> {
    let s = &body.stiffness;
    let unknowns = s.nrows();
    let kept = Kept::without(unknowns, frame);
    let factor = kept.columns(&kept.rows(s)).llt(Triangle::Lower).ok()?;
    let by_forces = if by_inverse(forces) {
        let inverse = factor.inverse();
        forces.iter().map(|rows| kept.spread(&symmetric_times(&inverse, &kept.columns(rows)))).collect()
    } else {
        forces.iter().map(|rows| kept.spread(&factor.solve(kept.columns(rows).transpose().to_owned()))).collect()
    };
    let to_columns = kept.spread(&factor.solve(kept.rows(loads)));
    let on_edge = Mat::from_fn(unknowns, frame.len(), |i, j| -s[(i, frame[j])]);
    let mut motions = kept.spread(&factor.solve(kept.rows(&on_edge)));
    frame.iter().enumerate().for_each(|(j, q)| motions[(*q, j)] = 1.0);
    let q = frame.len();
    let stiffness = Mat::from_fn(q, q, |i, j| (0..unknowns).map(|k| s[(frame[i], k)] * motions[(k, j)]).sum());
    // Rigid modes have no stiffness at all: P^T K P with P = I - Z (Z^T W Z)^-1 Z^T W.
    let z = Mat::from_fn(q, body.rigid_modes.ncols(), |i, j| body.rigid_modes[(frame[i], j)]);
    let answers = |stiffness: Mat<f64>| Some(Answers { by_forces, to_columns, motions, stiffness });
    if z.ncols() == 0 {
        return answers(stiffness);
    }
    if z.ncols() == q {
        return answers(Mat::zeros(q, q));
    }
    let weighted = Mat::from_fn(q, z.ncols(), |i, j| s[(frame[i], frame[i])] * z[(i, j)]);
    let projector = Mat::<f64>::identity(q, q) - &z * (z.transpose() * &weighted).partial_piv_lu().solve(weighted.transpose());
    answers(projector.transpose() * stiffness * &projector)
}

/// The unknowns beside some, as ranges of successive ones.
struct Kept {
    unknowns: usize,
    ranges: Vec<std::ops::Range<usize>>,
}

impl Kept {
    /// All but those of the edge.
    fn without(unknowns: usize, frame: &[usize]) -> Kept {
        let mut ends: Vec<usize> = frame.to_vec();
        ends.sort_unstable();
        let starts = std::iter::once(0).chain(ends.iter().map(|end| end + 1));
        let ranges = starts.zip(ends.iter().copied().chain([unknowns])).map(|(start, end)| start..end).collect();
        Kept { unknowns, ranges }
    }

    fn len(&self) -> usize {
        self.ranges.iter().map(ExactSizeIterator::len).sum()
    }

    /// The rows of a matrix that are kept.
    fn rows(&self, matrix: &Mat<f64>) -> Mat<f64> {
        let mut kept = Mat::zeros(self.len(), matrix.ncols());
        for j in 0..matrix.ncols() {
            let (mut to, from) = (kept.col_as_slice_mut(j), matrix.col_as_slice(j));
            for range in &self.ranges {
                let (part, rest) = to.split_at_mut(range.len());
                part.copy_from_slice(&from[range.clone()]);
                to = rest;
            }
        }
        kept
    }

    /// The columns of a matrix that are kept.
    fn columns(&self, matrix: &Mat<f64>) -> Mat<f64> {
        let mut kept = Mat::zeros(matrix.nrows(), self.len());
        for (to, from) in self.ranges.iter().flat_map(Clone::clone).enumerate() {
            kept.col_as_slice_mut(to).copy_from_slice(matrix.col_as_slice(from));
        }
        kept
    }

    /// Rows that are kept among all others, which are zero.
    fn spread(&self, kept: &Mat<f64>) -> Mat<f64> {
        let mut full = Mat::zeros(self.unknowns, kept.ncols());
        for j in 0..kept.ncols() {
            let (to, mut from) = (full.col_as_slice_mut(j), kept.col_as_slice(j));
            for range in &self.ranges {
                let (part, rest) = from.split_at(range.len());
                to[range.clone()].copy_from_slice(part);
                from = rest;
            }
        }
        full
    }
}

/// Normal (or tangential) displacement at the points, the mean over their stations, as rows on the kept unknowns; and the prescribed part.
fn component_rows(
    body: &InterfaceOperator,
    side: Side,
    points: usize,
    stations: &[Station],
    tangential: bool,
) -> (Mat<f64>, Vec<f64>) {
    let mut matrix = Mat::zeros(points, body.stiffness.nrows());
    let mut constant = vec![0.0; points];
    for station in stations {
        let direction = if tangential { station.point.tangent } else { station.point.normal };
        let (edge, t) = station.places[side as usize];
        let (rows, fixed) = body.trace.displacement_row(edge, t);
        for (component, d) in direction.into_iter().enumerate() {
            for (i, share) in &station.shares {
                rows[component].iter().for_each(|(u, c)| matrix[(*i, *u)] += share * d * c);
                constant[*i] += share * d * fixed[component];
            }
        }
    }
    (matrix, constant)
}
