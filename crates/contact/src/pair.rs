//! Two boundaries facing each other: common places, normal, drag direction.

use crate::error::Error;
use hpfem::{BoundaryPoint, InterfaceOperator};

/// Which of the two bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Body 1, the shaped body (shoe, punch).
    Shaped,
    /// Body 2, the counter-face (drum, plate, disc).
    Counter,
}

/// A point of the contact surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPoint {
    /// Edge of both paths and parameter on it.
    pub place: (usize, f64),
    /// Arc length from the start of the path.
    pub arc: f64,
    /// Position.
    pub position: [f64; 2],
    /// Unit normal out of body 2 into body 1.
    pub normal: [f64; 2],
    /// Unit tangent: the normal turned clockwise, along growing x where the normal points up.
    pub tangent: [f64; 2],
    /// Area of the surface that belongs to the point.
    pub weight: f64,
}

/// Two interface operators whose kept boundaries share break points and edge parameters, so that contact is nodal and exact.
#[derive(Clone, Copy)]
pub struct Pair<'a> {
    /// The shaped body.
    pub shaped: &'a InterfaceOperator,
    /// The counter-face; `None` if it is rigid.
    pub counter: Option<&'a InterfaceOperator>,
}

impl<'a> Pair<'a> {
    /// Pairs two boundaries.
    ///
    /// # Errors
    /// [`Error::Unmatched`] when the number of edges or the places of their ends differ by more than round-off.
    pub fn new(shaped: &'a InterfaceOperator, counter: Option<&'a InterfaceOperator>) -> Result<Pair<'a>, Error> {
        if let Some(counter) = counter {
            let (a, b) = (&shaped.trace, &counter.trace);
            if a.edges.len() != b.edges.len() {
                return Err(Error::Unmatched { edge: a.edges.len().min(b.edges.len()), distance: f64::INFINITY });
            }
            for edge in 0..a.edges.len() {
                for t in [-1.0, 0.0, 1.0] {
                    let (p, q) = (a.boundary_point(edge, t).0.position, b.boundary_point(edge, t).0.position);
                    let distance = (p[0] - q[0]).hypot(p[1] - q[1]);
                    if distance > 1e-9 * a.length() {
                        return Err(Error::Unmatched { edge, distance });
                    }
                }
            }
        }
        Ok(Pair { shaped, counter })
    }

    /// The operator of a side; `None` for a rigid counter-face.
    pub fn side(&self, side: Side) -> Option<&'a InterfaceOperator> {
        match side {
            Side::Shaped => Some(self.shaped),
            Side::Counter => self.counter,
        }
    }

    /// The Gauss-Lobatto points of the shaped body's boundary.
    pub fn points(&self) -> Vec<ContactPoint> {
        self.shaped
            .trace
            .points
            .iter()
            .map(|p| self.point((p.edge, p.parameter), p.arc, p.weight))
            .collect()
    }

    /// The contact point at arc length `arc` from the start of the path, without a weight.
    pub fn at_arc(&self, arc: f64) -> ContactPoint {
        self.point(self.shaped.trace.locate(arc), arc, 0.0)
    }

    fn point(&self, place: (usize, f64), arc: f64, weight: f64) -> ContactPoint {
        let boundary = self.shaped.trace.boundary_point(place.0, place.1).0;
        let normal = normal(Side::Shaped, &boundary);
        ContactPoint { place, arc, position: boundary.position, normal, tangent: [normal[1], -normal[0]], weight }
    }
}

/// The contact normal, out of body 2 into body 1, from a body's own outward normal.
pub fn normal(side: Side, point: &BoundaryPoint) -> [f64; 2] {
    match side {
        Side::Shaped => point.outward.map(|v| -v),
        Side::Counter => point.outward,
    }
}

/// Traction of the contact on a side: `p n + q t` on body 1, the opposite on body 2, with the shear `q` along the tangent `t` (the
/// normal turned clockwise).
pub fn contact_traction(side: Side, point: &BoundaryPoint, pressure: f64, shear: f64) -> [f64; 2] {
    let n = normal(side, point);
    let sign = if side == Side::Shaped { 1.0 } else { -1.0 };
    [sign * (pressure * n[0] + shear * n[1]), sign * (pressure * n[1] - shear * n[0])]
}
