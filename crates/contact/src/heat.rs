//! Heat of a contact: temperatures of both surfaces by heat at the contact points, and how the frictional heat is shared.
//!
//! The friction power `g` at a point goes into the bodies as `g_1 + g_2 = g`: by a given share, or through a conductance `h` between the halves of
//! the source, `g_1 = g / 2 + h W (T_2 - T_1)` and `g_2 = g / 2 - h W (T_2 - T_1)` with the area `W` of the point, at closed points alone. With the
//! temperatures `T_i = T_i0 + R_i g_i` the flow `d = h W (T_2 - T_1)` solves `(1 / (h W) + R_1 + R_2) d = (R_2 - R_1) g / 2 + T_20 - T_10`.

use crate::error::Error;
use crate::pair::Pair;
use crate::side::Side;
use faer::Mat;
use faer::linalg::solvers::Solve;
use hpfem::{InterfaceOperator, InterfaceState, TraceLoad};

/// Temperature of the contact surface of a body at the contact points.
#[derive(Clone, Debug)]
pub struct HeatedSurface {
    /// `R`: temperature (K) at each point (row) by a unit of heat (mW) into the body at each point (column).
    pub by_heat: Mat<f64>,
    /// `T_0`: temperature without heat from the contact (degC).
    pub still: Vec<f64>,
}

/// What decides how much of the heat goes into each body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HeatSplit {
    /// The share of body 1, from 0 to 1.
    Share(f64),
    /// Conductance of the contact (mW/(mm^2 K)), at least 0; infinite for equal temperatures.
    Conductance(f64),
}

/// Heat into each body: `into * g + still` by the frictional heat `g` at the points.
#[derive(Clone, Debug)]
pub struct SharedHeat {
    /// For each body, `points x points`.
    pub into: [Mat<f64>; 2],
    /// For each body (mW), what flows without friction.
    pub still: [Vec<f64>; 2],
}

impl HeatedSurface {
    /// A surface of one temperature: `still` (degC), and `slope` (K/mW) more by all the heat into it.
    pub fn even(points: usize, still: f64, slope: f64) -> HeatedSurface {
        HeatedSurface { by_heat: Mat::full(points, points, slope), still: vec![still; points] }
    }

    /// Temperatures under heat into the body at the points.
    pub fn temperatures(&self, heat: &[f64]) -> Vec<f64> {
        let by_heat = crate::products::times(&self.by_heat, heat);
        self.still.iter().zip(by_heat).map(|(still, more)| still + more).collect()
    }
}

impl Pair<'_> {
    /// Kept unknowns of a side reduced as a potential, by a unit of heat into it at each contact point: `unknowns x points`. The body must lose
    /// heat somewhere.
    ///
    /// # Errors
    /// [`Error::NotHeld`].
    pub fn unit_heats(&self, side: Side) -> Result<Mat<f64>, Error> {
        let Some(body) = self.side(side) else { return Err(Error::NotHeld { side }) };
        if !body.kinematics.is_conduction() || body.rigid_modes.ncols() > 0 {
            return Err(Error::NotHeld { side });
        }
        let rows = self.temperature_rows(side, body);
        Ok(body.solve(&rows.transpose().to_owned(), &body.rigid_modes))
    }

    /// The surface of a side reduced as a potential, from its [`Pair::unit_heats`] and its state without heat from the contact.
    pub fn heated_surface(&self, side: Side, unit: &Mat<f64>, still: &InterfaceState) -> HeatedSurface {
        let points = self.points();
        let Some(body) = self.side(side) else { return HeatedSurface::even(points.len(), 0.0, 0.0) };
        let by_heat = self.temperature_rows(side, body) * unit;
        // Exactly symmetric, as reciprocity asks.
        let by_heat = Mat::from_fn(points.len(), points.len(), |i, j| 0.5 * (by_heat[(i, j)] + by_heat[(j, i)]));
        HeatedSurface { by_heat, still: points.iter().map(|point| self.potential(side, still, point)).collect() }
    }

    /// Potential (temperature) of a side at a contact point in a state of that side's body.
    pub fn potential(&self, side: Side, state: &InterfaceState, point: &crate::ContactPoint) -> f64 {
        self.hoop_displacement(side, state, point)
    }

    /// The state of a side reduced as a potential under heat (mW) into it at the contact points and factors of its load cases.
    pub fn heated(&self, side: Side, heat: &[f64], cases: &[f64]) -> Option<InterfaceState> {
        let body = self.side(side)?;
        let mut load = TraceLoad { unknowns: vec![0.0; body.trace.unknowns], ..TraceLoad::default() };
        for (point, heat) in self.points().iter().zip(heat) {
            body.trace.add_force(&mut load, self.place(side, point), [*heat, 0.0]);
        }
        let factors = body.factors_in_order(cases);
        let unknowns = body.solve_one(&body.right_hand_side(&load, &factors));
        Some(InterfaceState { unknowns, factors, load })
    }

    /// Temperature at the points as rows on the kept unknowns.
    fn temperature_rows(&self, side: Side, body: &InterfaceOperator) -> Mat<f64> {
        let points = self.points();
        let mut rows = Mat::zeros(points.len(), body.stiffness.nrows());
        for (i, point) in points.iter().enumerate() {
            let (edge, t) = self.place(side, point);
            let ([row, _], _) = body.trace.displacement_row(edge, t);
            row.iter().for_each(|(u, c)| rows[(i, *u)] += c);
        }
        rows
    }
}

/// Shares the frictional heat between two surfaces; `weights` are the areas of the points (mm^2), `closed` says which are in contact.
///
/// # Errors
/// [`Error::Singular`] where both surfaces are held at a temperature at a closed point of infinite conductance; [`Error::HeatSplit`];
/// [`Error::Shape`] for lists and surfaces of other numbers of points.
pub fn share_heat(
    surfaces: [&HeatedSurface; 2],
    weights: &[f64],
    closed: &[bool],
    split: HeatSplit,
) -> Result<SharedHeat, Error> {
    let n = weights.len();
    fitting(surfaces, n, closed, split)?;
    let even = |share: f64| Mat::from_fn(n, n, |i, j| if i == j { share } else { 0.0 });
    let conductance = match split {
        HeatSplit::Share(share) => {
            return Ok(SharedHeat { into: [even(share), even(1.0 - share)], still: [vec![0.0; n], vec![0.0; n]] });
        }
        HeatSplit::Conductance(conductance) => conductance,
    };
    let (mut into, mut still) = ([even(0.5), even(0.5)], [vec![0.0; n], vec![0.0; n]]);
    let points = conducting(weights, closed, conductance);
    let m = points.len();
    let [first, second] = surfaces;
    // The flow by frictional heat at the closed points, and without any.
    let right = Mat::from_fn(m, m + 1, |i, j| match points.get(j) {
        Some(b) => 0.5 * (second.by_heat[(points[i], *b)] - first.by_heat[(points[i], *b)]),
        None => second.still[points[i]] - first.still[points[i]],
    });
    let flow = flows(surfaces, weights, (&points, conductance), &right)?;
    for (i, a) in points.iter().enumerate() {
        for (j, b) in points.iter().enumerate() {
            into[0][(*a, *b)] += flow[(i, j)];
            into[1][(*a, *b)] -= flow[(i, j)];
        }
        still[0][*a] = flow[(i, m)];
        still[1][*a] = -flow[(i, m)];
        // A surface held at a temperature that it meets without resistance leaves the other one none of the friction's heat.
        for into in &mut into {
            if points.iter().all(|b| into[(*a, *b)].abs() <= ROUND_OFF) {
                points.iter().for_each(|b| into[(*a, *b)] = 0.0);
            }
        }
    }
    Ok(SharedHeat { into, still })
}

/// Part of the heat that is round-off of two halves.
const ROUND_OFF: f64 = 1e-14;

/// Heat into each body (mW) at the points by a frictional heat (mW) that is known there, `into_1 = g / 2 + d`, `into_2 = g / 2 - d` with the flow `d` of the
/// module, or by the shares: `into * g + still` of [`share_heat`] from one right-hand side in place of one a point. `weights` are the areas of the points (mm^2),
/// `closed` says which are in contact; all have one value a point.
///
/// # Errors
/// As for [`share_heat`].
pub fn share_known_heat(
    surfaces: [&HeatedSurface; 2],
    weights: &[f64],
    closed: &[bool],
    (split, friction): (HeatSplit, &[f64]),
) -> Result<[Vec<f64>; 2], Error> {
    fitting(surfaces, weights.len(), closed, split)?;
    long("frictional heat", weights.len(), friction.len())?;
    let conductance = match split {
        HeatSplit::Share(share) => return Ok([share, 1.0 - share].map(|share| friction.iter().map(|g| share * g).collect())),
        HeatSplit::Conductance(conductance) => conductance,
    };
    let half: Vec<f64> = friction.iter().map(|g| 0.5 * g).collect();
    let points = conducting(weights, closed, conductance);
    // What flows at points that are open goes half into each body, and warms none of the closed ones.
    let at_closed: Vec<f64> = (0..half.len()).map(|i| if points.binary_search(&i).is_ok() { half[i] } else { 0.0 }).collect();
    let [first, second] = surfaces.map(|surface| surface.temperatures(&at_closed));
    let right = Mat::from_fn(points.len(), 1, |i, _| second[points[i]] - first[points[i]]);
    let flow = flows(surfaces, weights, (&points, conductance), &right)?;
    let mut into = [half.clone(), half];
    for (i, a) in points.iter().enumerate() {
        into[0][*a] += flow[(i, 0)];
        into[1][*a] -= flow[(i, 0)];
    }
    Ok(into)
}

/// Refuses what is not of so many points, and a split out of its range.
fn fitting(surfaces: [&HeatedSurface; 2], points: usize, closed: &[bool], split: HeatSplit) -> Result<(), Error> {
    let (value, sound) = match split {
        HeatSplit::Share(share) => (share, (0.0..=1.0).contains(&share)),
        HeatSplit::Conductance(conductance) => (conductance, conductance >= 0.0),
    };
    if !sound {
        return Err(Error::HeatSplit { value });
    }
    long("list of closed points", points, closed.len())?;
    for HeatedSurface { by_heat, still } in surfaces {
        long("temperature", points, by_heat.nrows())?;
        long("temperature", points, by_heat.ncols())?;
        long("temperature", points, still.len())?;
    }
    Ok(())
}

fn long(name: &'static str, wanted: usize, given: usize) -> Result<(), Error> {
    if given == wanted { Ok(()) } else { Err(Error::Shape { name, wanted: [wanted, 1], given: [given, 1] }) }
}

/// Points at which heat passes from one body to the other.
fn conducting(weights: &[f64], closed: &[bool], conductance: f64) -> Vec<usize> {
    (0..weights.len()).filter(|i| closed[*i] && conductance * weights[*i] > 0.0).collect()
}

/// The flows `d` from body 2 to body 1 at points that conduct, by differences of temperature, a column each.
fn flows(
    [first, second]: [&HeatedSurface; 2],
    weights: &[f64],
    (points, conductance): (&[usize], f64),
    right: &Mat<f64>,
) -> Result<Mat<f64>, Error> {
    let m = points.len();
    if m == 0 {
        return Ok(right.clone());
    }
    let matrix = Mat::from_fn(m, m, |i, j| {
        let (a, b) = (points[i], points[j]);
        let own = if i == j { 1.0 / (conductance * weights[a]) } else { 0.0 };
        own + first.by_heat[(a, b)] + second.by_heat[(a, b)]
    });
    let flow = matrix.partial_piv_lu().solve(right);
    if flow.col_iter().any(|column| column.iter().any(|v| !v.is_finite())) {
        return Err(Error::Singular);
    }
    Ok(flow)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn known_heat_is_shared_as_any_is() {
        let n = 7;
        let surface = |size: f64, still: f64| HeatedSurface {
            by_heat: Mat::from_fn(n, n, |i, j| size / (1.0 + i.abs_diff(j) as f64)),
            still: (0..n).map(|i| still + (i as f64).sin()).collect(),
        };
        let surfaces = [&surface(2e-3, 20.0), &surface(5e-4, 35.0)];
        let weights: Vec<f64> = (0..n).map(|i| 0.5 + 0.1 * i as f64).collect();
        let friction: Vec<f64> = (0..n).map(|i| 1e3 * (i + 1) as f64).collect();
        for closed in [vec![true; n], (0..n).map(|i| i % 3 != 1).collect(), vec![false; n]] {
            for split in [HeatSplit::Share(0.3), HeatSplit::Conductance(8.0), HeatSplit::Conductance(f64::INFINITY)] {
                let shared = share_heat(surfaces, &weights, &closed, split).unwrap();
                let known = share_known_heat(surfaces, &weights, &closed, (split, &friction)).unwrap();
                for (body, known) in known.iter().enumerate() {
                    for (i, heat) in known.iter().enumerate() {
                        let by_friction: f64 = (0..n).map(|j| shared.into[body][(i, j)] * friction[j]).sum();
                        let wanted = shared.still[body][i] + by_friction;
                        assert!((heat - wanted).abs() < 1e-12 * 1e4, "{split:?} {closed:?}: {heat} for {wanted}");
                    }
                }
            }
        }
    }
}
