//! What the surfaces of a pair do in given states of its bodies.

use crate::pair::Pair;
use crate::point::{ContactPoint, along};
use crate::side::Side;
use hpfem::{InterfaceOperator, InterfaceState, TraceLoad};

impl Pair<'_> {
    /// Displacement (mm) of a side at a contact point along its normal and tangent, `[u . n, u . t]`, in a state of that side's body; zero for
    /// a rigid counter-face.
    pub fn displacement(&self, side: Side, state: &InterfaceState, point: &ContactPoint) -> [f64; 2] {
        let Some(body) = self.side(side) else { return [0.0; 2] };
        let u = displacement(body, state, self.place(side, point));
        [along(point.normal, u), along(point.tangent, u)]
    }

    /// Displacement (mm) around the axis, anti-clockwise positive, of a side of a pair reduced in
    /// [`Kinematics::Torsion`](hpfem::Kinematics::Torsion); zero for a rigid counter-face.
    pub fn hoop_displacement(&self, side: Side, state: &InterfaceState, point: &ContactPoint) -> f64 {
        self.side(side).map_or(0.0, |body| displacement(body, state, self.place(side, point))[0])
    }

    /// The state of a body under shear around the axis, one value (MPa) a contact point: `shear * weight` on body 1, anti-clockwise positive, the
    /// opposite on body 2, at the very points where the contact of this pair acts. `body` is the given side reduced in
    /// [`Kinematics::Torsion`](hpfem::Kinematics::Torsion) on the same mesh, with no other load.
    pub fn twisted(&self, side: Side, body: &InterfaceOperator, shear: &[f64]) -> InterfaceState {
        let sign = if side == Side::Shaped { 1.0 } else { -1.0 };
        let mut load = TraceLoad { unknowns: vec![0.0; body.trace.unknowns], ..TraceLoad::default() };
        for (point, shear) in self.points().iter().zip(shear) {
            body.trace.add_force(&mut load, self.place(side, point), [sign * shear * point.weight, 0.0]);
        }
        let factors = body.factors_in_order(&[]);
        let unknowns = body.solve_one(&body.right_hand_side(&load, &factors));
        InterfaceState { unknowns, factors, load }
    }
}

/// Displacement of a body at a place of its kept boundary, edge of the path and parameter.
fn displacement(body: &InterfaceOperator, state: &InterfaceState, (edge, t): (usize, f64)) -> [f64; 2] {
    body.trace.displacement(edge, t, &state.unknowns)
}
