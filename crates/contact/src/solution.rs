//! Result of a contact solve.

use crate::coulomb::ContactState;
use crate::status::Status;
use hpfem::InterfaceState;

/// Pressures, openings and the state of both bodies. Arrays hold one value a contact point, in the order of
/// [`ContactOperator::points`](crate::ContactOperator::points).
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct ContactSolution {
    /// How the solve ended.
    pub status: Status,
    /// Pressure, at least 0 in compression.
    pub pressure: Vec<f64>,
    /// Shear traction on body 1 along the point's tangent.
    pub shear: Vec<f64>,
    /// Nodal normal force on body 1, `pressure * weight`.
    pub nodal_force: Vec<f64>,
    /// Nodal tangential force on body 1, `shear * weight`.
    pub nodal_shear: Vec<f64>,
    /// Distance of the loaded surfaces along the normal.
    pub opening: Vec<f64>,
    /// Tangential displacement of body 1 less that of body 2 along the point's tangent; empty if the operator was made without shear.
    pub slip: Vec<f64>,
    /// State of each point; without friction, points in contact count as sticking.
    pub states: Vec<ContactState>,
    /// Whether the point is in contact.
    pub closed: Vec<bool>,
    /// State of the shaped body.
    pub shaped: InterfaceState,
    /// State of the counter-face, if it is elastic.
    pub counter: Option<InterfaceState>,
    /// Motions `t_x`, `t_z`, `theta` of the shaped body's rigid edge, or the coordinates of its rigid modes; then the same of the counter-face.
    pub coordinates: [Vec<f64>; 2],
    /// Contact force on body 1.
    pub force: [f64; 2],
    /// Moment of the contact traction on body 1 about the origin, positive from x to z.
    pub moment: f64,
    /// Largest relative violation of `p >= 0`, `opening >= 0`, `p opening = 0`.
    pub complementarity: f64,
    /// Largest relative residual of the force and moment balances of the free coordinates; the drag of sliding along a motion that nothing resists is
    /// left to a guide, and not counted.
    pub balance: f64,
    /// Linear systems solved.
    pub iterations: usize,
    /// Whether the exact active-set method had to take over from the augmented Lagrangian.
    pub took_over: bool,
    /// Whether the force at each point closes it further, by the heat that follows it, than it opens it as a pressure, `C_ii + H_ii < 0` (mm/N) once the free
    /// rigid motions that come nearest to the openings by that force are taken off: signs alone do not tell then that this is the contact which grows from the
    /// cold bodies.
    pub closes_itself: bool,
    /// Arc lengths at which each contact zone starts and ends.
    pub zones: Vec<[f64; 2]>,
}
