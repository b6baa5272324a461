//! What one body does under forces at the contact points: its interface operator, factorised, and solved for the columns that every contact solve
//! needs.

use crate::error::Error;
use crate::products::{add, times};
use crate::rows::Rows;
use crate::segment::Station;
use crate::side::Side;
use faer::Mat;
use faer::linalg::solvers::Solve;
use hpfem::{HalfSolved, InterfaceFactor, InterfaceOperator};
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// Kept displacements of one body as a linear function of nodal contact forces, load factors and rigid coordinates:
/// `u = U_f a + X_n lambda + X_t sigma + Y y`, with the balance `K y = Y^T (f + N^T lambda + T^T sigma) + resultant`.
///
/// With a rigid edge the coordinates `y` are its free motions and everything else is solved with the edge held; without one they are
/// the rigid motions that the supports leave free (then `K = 0`).
#[derive(Clone, Debug)]
pub(crate) struct Response {
    /// Normal displacement at the points, `points x unknowns`.
    pub(crate) normal: Rows,
    /// Tangential displacement at the points, `points x unknowns`; no columns if shear was not asked for.
    pub(crate) tangential: Option<Rows>,
    /// Prescribed parts of the normal and tangential displacement.
    pub(crate) constant: [Vec<f64>; 2],
    /// What gives `X_n` and `X_t`; the unknowns that move the points expected in contact are its last ones.
    factor: InterfaceFactor,
    /// Where these begin in the order of the factor, and which points these are.
    first: usize,
    near: Vec<bool>,
    /// `U_f`, `unknowns x (load cases + 1)`.
    pub(crate) to_columns: Mat<f64>,
    /// Normal displacement at the points by those columns, made when it is asked for.
    opened: OnceLock<Mat<f64>>,
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
    /// Of a body at contact points, of which those `near` are expected in contact.
    pub(crate) fn new(
        body: &InterfaceOperator,
        side: Side,
        near: &[bool],
        stations: &[Station],
        shear: bool,
    ) -> Result<Response, Error> {
        let n = near.len();
        let rows = |tangential: bool| component_rows(body, side, n, stations, tangential);
        let (normal, normal_constant) = rows(false);
        let (tangential, tangential_constant) = rows(true);
        let unknowns = body.stiffness.nrows();
        let frame: Vec<usize> = body.frame.iter().flatten().copied().collect();
        // The unknown that moves the first of the points stands first: unit forces at later ones then begin later.
        let mut moved = normal.reach(near);
        if shear {
            let first = |(a, b): (&mut Option<usize>, Option<usize>)| *a = [*a, b].into_iter().flatten().min();
            moved.iter_mut().zip(tangential.reach(near)).for_each(first);
        }
        let (mut last, mut order): (Vec<usize>, Vec<usize>) =
            (0..unknowns).filter(|k| !frame.contains(k)).partition(|k| moved[*k].is_some());
        last.sort_by_key(|k| moved[*k]);
        let first = order.len();
        order.extend(last);
        let columns = body.columns.submatrix(0, 0, unknowns, body.load_cases.len() + 1).to_owned();
        let (factor, motions, stiffness) = if frame.is_empty() {
            let modes = body.rigid_modes.ncols();
            (body.factor(&body.rigid_modes, order), body.rigid_modes.clone(), Mat::zeros(modes, modes))
        } else {
            with_edge_held(body, order, &frame).ok_or(Error::NotHeld { side })?
        };
        let motion_columns = motions.transpose() * &columns;
        let edge_motion = if frame.is_empty() {
            vec![None; motions.ncols()]
        } else {
            (0..3).filter(|k| body.frame[*k].is_some()).map(Some).collect()
        };
        let mut motion = [normal.product(&motions), tangential.product(&motions)];
        for j in 0..motions.ncols() {
            let largest = motion.iter().flat_map(|m| m.col(j).iter()).fold(0.0_f64, |m, v| m.max(v.abs()));
            for m in &mut motion {
                (0..n).filter(|i| m[(*i, j)].abs() <= 1e-12 * largest).collect::<Vec<_>>().iter().for_each(|i| m[(*i, j)] = 0.0);
            }
        }
        Ok(Response {
            to_columns: factor.solve(&columns),
            opened: OnceLock::new(),
            factor,
            first,
            near: near.to_vec(),
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

    /// Normal displacement at the points by a unit of each load case, then by what is prescribed, `points x (load cases + 1)`.
    pub(crate) fn normal_by_columns(&self) -> &Mat<f64> {
        self.opened.get_or_init(|| self.normal.product(&self.to_columns))
    }

    /// Unit forces at some of the points, half solved: normal ones, and tangential ones if these were asked for.
    pub(crate) fn half_solved(&self, at: &[usize]) -> (HalfSolved, Option<HalfSolved>) {
        let half = |rows: &Rows| self.factor.half_solved(&rows.entries(at));
        (half(&self.normal), self.tangential.as_ref().map(half))
    }

    /// Columns of `X_n` (or `X_t`) by rows of the normal (or tangential) displacement of some points, `unknowns x rows`, as far as they move these points.
    pub(crate) fn under(&self, rows: &Rows, at: &[usize]) -> Mat<f64> {
        let first = if at.iter().all(|i| self.near[*i]) { self.first } else { 0 };
        self.factor.solve_from(&rows.transposed(), first)
    }

    /// Kept unknowns under factors, nodal forces on this body (normal and tangential) and coordinates.
    pub(crate) fn unknowns(&self, factors: &[f64], normal: &[f64], tangential: &[f64], coordinates: &[f64]) -> Vec<f64> {
        let mut forces = self.normal.transposed_times(normal);
        if let Some(matrix) = &self.tangential {
            add(&mut forces, &matrix.transposed_times(tangential));
        }
        let mut u = self.factor.solve(&Mat::from_fn(forces.len(), 1, |i, _| forces[i])).col_as_slice(0).to_vec();
        add(&mut u, &times(&self.to_columns, factors));
        add(&mut u, &times(&self.motions, coordinates));
        u
    }
}

/// Factorises with the rigid edge held, and gives the motions of the edge as columns with their stiffness.
fn with_edge_held(body: &InterfaceOperator, order: Vec<usize>, frame: &[usize]) -> Option<(InterfaceFactor, Mat<f64>, Mat<f64>)> {
    let s = &body.stiffness;
    let unknowns = s.nrows();
    let factor = Some(body.factor(&Mat::zeros(unknowns, 0), order)).filter(InterfaceFactor::is_definite)?;
    let mut motions = factor.solve(&Mat::from_fn(unknowns, frame.len(), |i, j| -s[(i, frame[j])]));
    frame.iter().enumerate().for_each(|(j, q)| motions[(*q, j)] = 1.0);
    let q = frame.len();
    let stiffness = Mat::from_fn(q, q, |i, j| (0..unknowns).map(|k| s[(frame[i], k)] * motions[(k, j)]).sum());
    // Rigid modes have no stiffness at all: P^T K P with P = I - Z (Z^T W Z)^-1 Z^T W.
    let z = Mat::from_fn(q, body.rigid_modes.ncols(), |i, j| body.rigid_modes[(frame[i], j)]);
    if z.ncols() == 0 {
        return Some((factor, motions, stiffness));
    }
    if z.ncols() == q {
        return Some((factor, motions, Mat::zeros(q, q)));
    }
    let weighted = Mat::from_fn(q, z.ncols(), |i, j| s[(frame[i], frame[i])] * z[(i, j)]);
    let projector = Mat::<f64>::identity(q, q) - &z * (z.transpose() * &weighted).partial_piv_lu().solve(weighted.transpose());
    Some((factor, motions, projector.transpose() * stiffness * &projector))
}

/// Normal (or tangential) displacement at the points, the mean over their stations, as rows on the kept unknowns; and the prescribed part.
fn component_rows(
    body: &InterfaceOperator,
    side: Side,
    points: usize,
    stations: &[Station],
    tangential: bool,
) -> (Rows, Vec<f64>) {
    let mut matrix = vec![BTreeMap::new(); points];
    let mut constant = vec![0.0; points];
    for station in stations {
        let direction = if tangential { station.point.tangent } else { station.point.normal };
        let (edge, t) = station.places[side as usize];
        let (rows, fixed) = body.trace.displacement_row(edge, t);
        for (component, d) in direction.into_iter().enumerate() {
            for (i, share) in &station.shares {
                rows[component].iter().for_each(|(u, c)| *matrix[*i].entry(*u).or_insert(0.0) += share * d * c);
                constant[*i] += share * d * fixed[component];
            }
        }
    }
    (Rows::new(matrix, body.stiffness.nrows()), constant)
}
