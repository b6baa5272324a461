//! The gap that produces a wanted pressure: Appendix A of Paczelt and Mroz (2007), corrected, in one linear pass.

use crate::edge::{EdgeLoad, held_edge, solve_edge, solve_held};
use crate::error::Error;
use crate::place::SurfacePlace;
use crate::rigid_part::{Curve, Lowest, lowest};
use contact::{ContactPoint, Pair, Side, contact_traction, normal};
use hpfem::{BoundaryPoint, InterfaceOperator, InterfaceState, TraceLoad};
use nalgebra::{DMatrix, DVector};

/// Tractions and loads under which the surfaces shall just touch everywhere.
pub struct ShapeProblem<'a> {
    /// The two bodies.
    pub pair: Pair<'a>,
    /// Wanted pressure `p >= 0` and shear along the tangent (normal turned clockwise) on body 1, at a place of the surface.
    pub traction: &'a (dyn Fn(&SurfacePlace) -> [f64; 2] + Sync),
    /// Factors of the load cases of body 1.
    pub cases_shaped: &'a [f64],
    /// Factors of the load cases of body 2.
    pub cases_counter: &'a [f64],
    /// What fixes the rigid coordinates of body 1 at zero.
    pub gauge: Gauge,
    /// How the rigid part of the gap is chosen.
    pub rigid: RigidPart,
    /// How the traction is integrated.
    pub integration: Integration,
}

/// Integration of the wanted traction over the contact edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integration {
    /// At the Gauss-Lobatto points, as nodal forces `p weight`: the very forces of the contact solve, so that it can give the pressure
    /// back to round-off.
    Lobatto,
    /// By Gauss rules with this many points beyond the degree plus two on every edge.
    Gauss(usize),
}

/// Zero of the rigid coordinates of body 1.
#[derive(Clone, Debug, PartialEq)]
pub enum Gauge {
    /// The rigid edge is held: its free motions are zero.
    HeldEdge,
    /// The rigid edge is held along the body's rigid modes alone; free motions that supports hold elastically follow what acts on the edge.
    LoadedEdge(EdgeLoad),
    /// Mean displacement of the load edge is zero: columns of the interface operator that hold the mean displacement functionals of
    /// the free motions, one a rigid mode.
    MeanOf(Vec<usize>),
    /// The displacement is left orthogonal to the rigid modes, in the kept unknowns.
    Orthogonal,
}

/// Choice of the rigid part of the gap.
#[derive(Clone, Debug, PartialEq)]
pub enum RigidPart {
    /// The smallest gap that is nowhere negative: `g >= 0` with the least `int g dS`.
    Smallest,
    /// Prescribed coordinates of body 1's rigid modes; none for zeros.
    Prescribed(Vec<f64>),
    /// The smallest gap that is nowhere negative among the coordinates `start + a direction`: some motions prescribed, one free.
    SmallestAlong {
        /// Coordinates that hold the prescribed motions.
        start: Vec<f64>,
        /// Coordinates of the free motion.
        direction: Vec<f64>,
    },
}

/// The shape that produces the wanted pressure.
#[derive(Clone, Debug)]
pub struct Shape {
    /// State of body 1 with its rigid coordinates at zero.
    pub shaped: InterfaceState,
    /// State of body 2.
    pub counter: Option<InterfaceState>,
    /// Rigid coordinates of body 1 that belong to the gap, one a rigid mode.
    pub rigid: Vec<f64>,
    /// Sum of the contact load on body 1, integrated by the edges' own quadrature: `[x, z]`.
    pub contact_force: [f64; 2],
    /// What round-off of the displacements where the gap touches leaves in the gap by its rigid part (mm): the spacing of numbers times the largest
    /// jump, times the largest change of the gap by changes of 1 there. 0 where the rigid part is prescribed.
    pub round_off: f64,
}

/// Solves for the shape: loads the separated bodies by the wanted tractions, takes the jump `m = (u2 - u1) . n` and adds the
/// rigid part, `g = m + sum_k a_k phi_k` with the closing velocities `phi_k = -n . u_k` of body 1's free modes.
///
/// The paper's step 6 takes `Delta = m(s*) / cos alpha*` at the minimum of `m`; that lets the gap become negative elsewhere. Here
/// the rigid part is the lowest admissible one over the whole continuous surface.
///
/// # Errors
/// [`Error::NoLowestGap`] if no rigid part makes the gap smallest (no closing mode reaches the surface); [`Error::ShapeInput`] for a gauge that leaves
/// body 1 a rigid motion, a rigid part of another number of modes, and a traction, factor or coordinate that is not finite.
pub fn solve_shape(problem: &ShapeProblem<'_>) -> Result<Shape, Error> {
    problem.check()?;
    let shaped = side_state(problem, Side::Shaped, problem.pair.shaped, problem.cases_shaped);
    let counter = problem.pair.counter.map(|c| side_state(problem, Side::Counter, c, problem.cases_counter));
    let [x, z, _] = shaped.load.resultant;
    if !(x.is_finite() && z.is_finite()) {
        return wrong("the wanted traction is not finite everywhere");
    }
    let mut shape = Shape { shaped, counter, rigid: Vec::new(), contact_force: [x, z], round_off: 0.0 };
    let modes = problem.pair.shaped.rigid_modes.ncols();
    let round_off = |found: &Lowest| f64::EPSILON * found.scale * found.amplification;
    (shape.rigid, shape.round_off) = match &problem.rigid {
        RigidPart::Prescribed(values) => (values.clone(), 0.0),
        RigidPart::Smallest if modes == 0 => (Vec::new(), 0.0),
        RigidPart::Smallest => {
            let curve = SurfaceCurve { pair: problem.pair, shape: &shape, along: None };
            let found = lowest(&curve).ok_or(Error::NoLowestGap { modes })?;
            (found.coordinates.clone(), round_off(&found))
        }
        RigidPart::SmallestAlong { start, direction } => {
            let curve = SurfaceCurve { pair: problem.pair, shape: &shape, along: Some([start, direction]) };
            let found = lowest(&curve).ok_or(Error::NoLowestGap { modes: 1 })?;
            (start.iter().zip(direction).map(|(s, d)| s + found.coordinates[0] * d).collect(), round_off(&found))
        }
    };
    Ok(shape)
}

impl ShapeProblem<'_> {
    /// Checks gauge and rigid part against the rigid modes of body 1.
    fn check(&self) -> Result<(), Error> {
        let body = self.pair.shaped;
        let modes = body.rigid_modes.ncols();
        if !self.gauge.holds(body) {
            return wrong(
                "the gauge does not hold the shaped body: it needs a rigid edge, or a mean displacement for each rigid mode",
            );
        }
        let fits = |values: &[f64]| values.len() == modes && values.iter().all(|v| v.is_finite());
        let rigid = match &self.rigid {
            RigidPart::Smallest => true,
            RigidPart::Prescribed(values) => values.is_empty() || fits(values),
            RigidPart::SmallestAlong { start, direction } => fits(start) && fits(direction),
        };
        if !rigid {
            return wrong("the rigid part of the gap needs a finite number for each rigid mode of the shaped body");
        }
        if self.cases_shaped.iter().chain(self.cases_counter).any(|factor| !factor.is_finite()) {
            return wrong("a factor of a load case is not finite");
        }
        Ok(())
    }
}

/// Refuses a problem.
fn wrong<T>(what: &'static str) -> Result<T, Error> {
    Err(Error::ShapeInput { what })
}

/// Part of the largest motion of a mode below which it moves an edge by round-off.
const HELD: f64 = 1e-12;

impl Gauge {
    /// Whether no rigid mode of the body is left.
    fn holds(&self, body: &InterfaceOperator) -> bool {
        let modes = body.rigid_modes.ncols();
        match self {
            Gauge::Orthogonal => true,
            Gauge::MeanOf(columns) => columns.len() >= modes && columns.iter().all(|c| *c < body.columns.ncols()),
            Gauge::HeldEdge | Gauge::LoadedEdge(_) => {
                let held: Vec<usize> = body.frame.iter().flatten().copied().collect();
                // Far from the origin a turn about it moves by much more than it turns.
                let largest = |m: usize| held.iter().fold(f64::MIN_POSITIVE, |most, i| body.rigid_modes[(*i, m)].abs().max(most));
                let moved = DMatrix::from_fn(held.len(), modes, |i, m| body.rigid_modes[(held[i], m)] / largest(m));
                modes == 0 || (held.len() >= modes && moved.rank(HELD) == modes)
            }
        }
    }
}

/// One body under its loads and the wanted tractions.
fn side_state(problem: &ShapeProblem<'_>, side: Side, body: &InterfaceOperator, cases: &[f64]) -> InterfaceState {
    let load = contact_load(problem, problem.traction, side, body);
    let factors = body.factors_in_order(cases);
    let right = body.right_hand_side(&load, &factors);
    let unknowns = match (&problem.gauge, side) {
        (Gauge::HeldEdge, Side::Shaped) => solve_held(body, &held_edge(body), &right),
        (Gauge::LoadedEdge(edge), Side::Shaped) => {
            let pressure = |place: &SurfacePlace| [(problem.traction)(place)[0], 0.0];
            let by_pressure = contact_load(problem, &pressure, side, body);
            solve_edge(body, edge, &right, &body.right_hand_side(&by_pressure, &factors))
        }
        (Gauge::MeanOf(_) | Gauge::Orthogonal, _) | (_, Side::Counter) => body.solve_one(&right),
    };
    let mut state = InterfaceState { unknowns, factors, load };
    if side == Side::Shaped && problem.gauge != Gauge::HeldEdge {
        problem.gauge.zero(body, &mut state);
    }
    state
}

/// Pressure and shear at a place of the surface.
type Traction<'a> = dyn Fn(&SurfacePlace) -> [f64; 2] + Sync + 'a;

/// The load of tractions on the contact edges of a body.
fn contact_load(problem: &ShapeProblem<'_>, traction: &Traction<'_>, side: Side, body: &InterfaceOperator) -> TraceLoad {
    let at = |point: &BoundaryPoint| {
        let place = SurfacePlace::near(problem.pair.trace(), point.position, normal(side, point));
        let [pressure, shear] = traction(&place);
        contact_traction(side, point, pressure, shear)
    };
    match problem.integration {
        Integration::Gauss(extra) => body.trace.load(body.kinematics, extra, at),
        Integration::Lobatto => nodal_load(problem, traction, side, body),
    }
}

/// The nodal forces `weight (p n + q t)` at the contact points of the pair.
fn nodal_load(problem: &ShapeProblem<'_>, traction: &Traction<'_>, side: Side, body: &InterfaceOperator) -> TraceLoad {
    let mut load = TraceLoad { unknowns: vec![0.0; body.trace.unknowns], ..TraceLoad::default() };
    let sign = if side == Side::Shaped { 1.0 } else { -1.0 };
    for point in problem.pair.points() {
        let [p, q] = traction(&SurfacePlace::from(&point));
        let force = |k: usize| sign * point.weight * (p * point.normal[k] + q * point.tangent[k]);
        body.trace.add_force(&mut load, point.place, [force(0), force(1)]);
    }
    load
}

impl Gauge {
    /// Shifts a state of body 1 along its free rigid modes until its rigid coordinates are zero. Gives the coordinates that it had, one a mode of
    /// [`InterfaceOperator::rigid_motions`] (mm, or rad where the mode turns); none where nothing is shifted.
    pub fn zero(&self, body: &InterfaceOperator, state: &mut InterfaceState) -> Vec<f64> {
        let (n, modes) = (state.unknowns.len(), body.rigid_modes.ncols());
        // Values of the functionals that are to vanish, in the state and in each mode.
        let (values, of_modes): (Vec<f64>, Vec<Vec<f64>>) = match self {
            Gauge::Orthogonal => return Vec::new(),
            Gauge::HeldEdge | Gauge::LoadedEdge(_) => {
                let held = body.frame.iter().flatten();
                held.map(|h| (state.unknowns[*h], (0..modes).map(|m| body.rigid_modes[(*h, m)]).collect())).unzip()
            }
            Gauge::MeanOf(columns) => {
                let mean = |c: usize, m: usize| (0..n).map(|i| body.columns[(i, c)] * body.rigid_modes[(i, m)]).sum::<f64>();
                let known = columns.iter().filter(|c| **c < body.columns.ncols());
                known.map(|c| (body.column_work(*c, state), (0..modes).map(|m| mean(*c, m)).collect())).unzip()
            }
        };
        if values.is_empty() || modes == 0 {
            return Vec::new();
        }
        let matrix = DMatrix::from_fn(values.len(), modes, |row, m| of_modes[row][m]);
        // A rigid edge that supports hold in part has more motions than the body has modes: least squares.
        let Ok(shift) = matrix.svd(true, true).solve(&DVector::from_vec(values), 1e-12) else { return Vec::new() };
        for (i, u) in state.unknowns.iter_mut().enumerate() {
            *u -= (0..modes).map(|m| shift[m] * body.rigid_modes[(i, m)]).sum::<f64>();
        }
        shift.iter().copied().collect()
    }
}

impl Shape {
    /// Displacement jump `m = (u2 - u1) . n` at a point, rigid coordinates of body 1 at zero.
    pub fn jump(&self, pair: &Pair<'_>, point: &ContactPoint) -> f64 {
        let [n1, _] = self.displacement(pair, Side::Shaped, point);
        let [n2, _] = self.displacement(pair, Side::Counter, point);
        n2 - n1
    }

    /// Gap at a point.
    pub fn gap(&self, pair: &Pair<'_>, point: &ContactPoint) -> f64 {
        let closing: f64 = self.rigid.iter().zip(closing(pair, point)).map(|(a, phi)| a * phi).sum();
        self.jump(pair, point) + closing
    }

    /// Displacement of a side at a point along its normal and tangent; zero for a rigid counter-face.
    pub fn displacement(&self, pair: &Pair<'_>, side: Side, point: &ContactPoint) -> [f64; 2] {
        let state = if side == Side::Shaped { Some(&self.shaped) } else { self.counter.as_ref() };
        state.map_or([0.0; 2], |state| pair.displacement(side, state, point))
    }
}

/// Closing velocities `phi_k = -n . u_k` of body 1's rigid modes at a point.
pub fn closing(pair: &Pair<'_>, point: &ContactPoint) -> Vec<f64> {
    let body = pair.shaped;
    let (edge, t) = pair.place(Side::Shaped, point);
    let modes = 0..body.rigid_modes.ncols();
    let moved = modes.map(|m| body.trace.relative_displacement(edge, t, body.rigid_modes.col_as_slice(m)));
    moved.map(|u| -(point.normal[0] * u[0] + point.normal[1] * u[1])).collect()
}

/// The jump over the whole surface, for the choice of the rigid part.
struct SurfaceCurve<'a> {
    pair: Pair<'a>,
    shape: &'a Shape,
    /// Start and direction of the rigid coordinates, if they are not all free.
    along: Option<[&'a [f64]; 2]>,
}

/// Sum of the products.
fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

impl Curve for SurfaceCurve<'_> {
    fn length(&self) -> f64 {
        self.pair.trace().length()
    }

    fn samples(&self) -> Vec<f64> {
        let trace = self.pair.trace();
        let mut samples = Vec::new();
        for edge in &trace.edges {
            let n = 4 * (edge.degree + 1);
            let length = edge.curve.length();
            samples.extend((0..n).map(|i| edge.start + length * i as f64 / n as f64));
        }
        samples.push(trace.length());
        samples
    }

    fn value(&self, arc: f64) -> (f64, Vec<f64>) {
        let point = self.pair.at_arc(arc);
        let (jump, modes) = (self.shape.jump(&self.pair, &point), closing(&self.pair, &point));
        match self.along {
            None => (jump, modes),
            Some([start, direction]) => (jump + product(start, &modes), vec![product(direction, &modes)]),
        }
    }

    fn mean_modes(&self) -> Vec<f64> {
        let mut sums = vec![0.0; self.pair.shaped.rigid_modes.ncols()];
        for point in self.pair.points() {
            for (sum, phi) in sums.iter_mut().zip(closing(&self.pair, &point)) {
                *sum += point.weight * phi;
            }
        }
        match self.along {
            None => sums,
            Some([_, direction]) => vec![product(direction, &sums)],
        }
    }
}
