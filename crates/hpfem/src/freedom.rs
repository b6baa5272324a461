//! What supports and rigid edges leave free: their directions, and the freedom of the unknowns of a vertex or an edge.

use crate::error::Error;
use std::fmt;
use std::sync::Arc;

/// A direction in which a boundary is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// Along the first coordinate, x or r; the only component, u_phi, in torsion.
    First,
    /// Along the second coordinate, z.
    Second,
    /// Along the normal out of the body of a straight edge (an inclined roller).
    Normal,
    /// Along the direction at this angle from the first coordinate towards the second, rad.
    Inclined(f64),
}

/// A displacement component prescribed on a named boundary.
#[derive(Clone)]
pub struct Support {
    /// Name of the boundary.
    pub boundary: String,
    /// Component that is prescribed.
    pub direction: Direction,
    /// Its value, mm; 0 holds it.
    pub value: f64,
    /// A part that varies along the support, added to the constant `value`: mm, as a function of the position; met at the vertices,
    /// interpolated at the Gauss-Lobatto points of every edge.
    pub varying: Option<Profile>,
}

/// A displacement, mm, as a function of the position, mm.
pub type Profile = Arc<dyn Fn([f64; 2]) -> f64 + Send + Sync>;

impl Direction {
    /// Refuses an angle that is not finite, of the support or pin that has the direction.
    pub(crate) fn check(self, place: &str) -> Result<(), Error> {
        match self {
            Direction::Inclined(value) if !value.is_finite() => {
                Err(Error::OutOfRange { quantity: format!("the angle of {place}"), value, range: "finite" })
            }
            Direction::First | Direction::Second | Direction::Normal | Direction::Inclined(_) => Ok(()),
        }
    }

    /// The unit vector; none of the normal of an edge.
    pub(crate) fn vector(self) -> Option<[f64; 2]> {
        match self {
            Direction::First => Some([1.0, 0.0]),
            Direction::Second => Some([0.0, 1.0]),
            Direction::Normal => None,
            Direction::Inclined(angle) => {
                // Exactly along an axis where the angle is a right one but for its own rounding.
                let [x, z] = [angle.cos(), angle.sin()].map(|c| if c.abs() < 1e-15 { 0.0 } else { c });
                Some([x, z])
            }
        }
    }
}

impl Support {
    /// Holds a component of a boundary.
    pub fn hold(boundary: &str, direction: Direction) -> Support {
        Support::moved(boundary, direction, 0.0)
    }

    /// Lets a straight boundary slide along itself: holds the component along its normal.
    pub fn roller(boundary: &str) -> Support {
        Support::hold(boundary, Direction::Normal)
    }

    /// Lets a boundary of any form slide in the direction at this angle from the first coordinate towards the second, rad.
    pub fn sliding(boundary: &str, angle: f64) -> Support {
        Support::hold(boundary, Direction::Inclined(angle + std::f64::consts::FRAC_PI_2))
    }

    /// Moves a component of a boundary by `value`, mm.
    pub fn moved(boundary: &str, direction: Direction, value: f64) -> Support {
        Support { boundary: boundary.to_string(), direction, value, varying: None }
    }

    /// The same with a displacement, mm, that varies with the position.
    #[must_use]
    pub fn varying(self, displacement: impl Fn([f64; 2]) -> f64 + Send + Sync + 'static) -> Support {
        Support { varying: Some(Arc::new(displacement)), ..self }
    }

    /// The prescribed displacement at a place, mm.
    pub(crate) fn displacement(&self, x: [f64; 2]) -> f64 {
        self.value + self.varying.as_ref().map_or(0.0, |d| d(x))
    }
}

impl fmt::Debug for Support {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let varies = self.varying.is_some();
        let mut text = f.debug_struct("Support");
        text.field("boundary", &self.boundary).field("direction", &self.direction).field("value", &self.value);
        text.field("varies", &varies).finish()
    }
}

/// An elastic foundation: the boundary is pulled back by `-normal (u . n) n - tangential (u . t) t` per area. In torsion the
/// tangential stiffness acts on `u_phi`; for a potential `normal` is the film coefficient h of `q = -h u` (the flux `h u_0` of an ambient
/// potential is a traction).
#[derive(Clone, Debug, PartialEq)]
pub struct Foundation {
    /// Name of the boundary.
    pub boundary: String,
    /// Stiffness along the normal, pressure per length, MPa/mm; zero or positive.
    pub normal: f64,
    /// Stiffness along the tangent, MPa/mm; zero or positive.
    pub tangential: f64,
}

impl Foundation {
    /// A foundation by its stiffness along the normal and along the tangent, MPa/mm.
    pub fn new(boundary: &str, normal: f64, tangential: f64) -> Foundation {
        Foundation { boundary: boundary.to_string(), normal, tangential }
    }
}

/// A vertex held at zero in one direction, to stop rigid motions. Its reaction is number `supports + index`; on a body whose loads
/// balance it vanishes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pin {
    /// The vertex, an index into [`Mesh::vertices`](crate::Mesh::vertices).
    pub vertex: usize,
    /// Any direction but [`Direction::Normal`].
    pub direction: Direction,
}

/// A boundary that moves as a rigid line: `u_x = t_x - theta (z - z0)`, `u_z = t_z + theta (x - x0)`.
///
/// Its free motions are kept as unknowns of the interface operator, so that force and moment or approach and tilt can be
/// chosen later without a new factorisation. What supports hold of the boundary is expressed by `free`: a support against a free motion
/// at one of its vertices, or with a displacement there, is refused, and so is any pin. In a body of revolution only `t_z` can be free; problems of one
/// component have no rigid edges.
#[derive(Clone, Debug, PartialEq)]
pub struct RigidEdge {
    /// Name of the boundary. Along a curved one the turn is interpolated at the Gauss-Lobatto points of every edge, as prescribed
    /// displacements are.
    pub boundary: String,
    /// Reference point `(x0, z0)` of the rotation, mm.
    pub reference: [f64; 2],
    /// Which of `t_x`, `t_z` (mm) and `theta` (rad) are free; the others are zero.
    pub free: [bool; 3],
}

/// Freedom of the unknowns of a vertex or an edge in its own axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Freedom {
    /// Orthonormal axes.
    pub(crate) axes: [[f64; 2]; 2],
    /// Support that prescribes the component along each axis, with the value.
    pub(crate) fixed: [Option<(usize, f64)>; 2],
    /// Moves with the rigid edge.
    pub(crate) slaved: bool,
}

/// Stands for the axis of revolution where a support's number is expected: radial displacement and turn vanish there by themselves, and
/// no reaction belongs to it.
pub(crate) const AXIS: usize = usize::MAX;

/// Free along both coordinate axes.
pub(crate) const FREE: Freedom = Freedom { axes: [[1.0, 0.0], [0.0, 1.0]], fixed: [None, None], slaved: false };

impl Freedom {
    /// Number of free components out of `components`.
    pub(crate) fn free(&self, components: usize) -> usize {
        if self.slaved { 0 } else { self.fixed[..components].iter().filter(|f| f.is_none()).count() }
    }

    /// Whether both components are unknowns along the coordinate axes.
    pub(crate) fn is_plain(&self) -> bool {
        !self.slaved && self.fixed.iter().all(Option::is_none) && self.axes == FREE.axes
    }

    /// Index of the free axis among the free ones.
    pub(crate) fn index(&self, axis: usize) -> usize {
        self.fixed[..axis].iter().filter(|f| f.is_none()).count()
    }

    /// Prescribes the component along the unit vector `d`. What is prescribed along it already must be the same value, to round-off of
    /// values of the size `scale`; if not, that value is returned.
    pub(crate) fn fix(&mut self, d: [f64; 2], support: usize, value: f64, scale: f64) -> Result<(), f64> {
        let along = |a: [f64; 2]| a[0] * d[0] + a[1] * d[1];
        match self.fixed {
            [None, None] if d[0].abs() == 1.0 => self.fixed[0] = Some((support, value * d[0])),
            [None, None] if d[1].abs() == 1.0 => self.fixed[1] = Some((support, value * d[1])),
            [None, None] => {
                self.axes = [d, [-d[1], d[0]]];
                self.fixed[0] = Some((support, value));
            }
            [Some((_, known)), None] if along(self.axes[1]).abs() > 1e-9 => {
                self.fixed[1] = Some((support, (value - known * along(self.axes[0])) / along(self.axes[1])));
            }
            [None, Some((_, known))] if along(self.axes[0]).abs() > 1e-9 => {
                self.fixed[0] = Some((support, (value - known * along(self.axes[1])) / along(self.axes[0])));
            }
            _ => {
                let part = |axis: usize| self.fixed[axis].map_or(0.0, |(_, known)| known * along(self.axes[axis]));
                let known = part(0) + part(1);
                if (known - value).abs() > 1e-9 * scale.max(known.abs()).max(value.abs()) {
                    return Err(known);
                }
            }
        }
        Ok(())
    }
}

/// Displacement at `x` of the motions `t_x`, `t_z`, `theta` about `reference`.
pub(crate) fn rigid_rows(x: [f64; 2], reference: [f64; 2]) -> [[f64; 2]; 3] {
    [[1.0, 0.0], [0.0, 1.0], [reference[1] - x[1], x[0] - reference[0]]]
}

/// Rigid rotation about the origin.
pub(crate) fn rotation_about_origin(x: [f64; 2]) -> [f64; 2] {
    rigid_rows(x, [0.0, 0.0])[2]
}
