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

/// Which surface carries the contact points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Surface {
    /// One surface, common to both bodies; the points are those of the given side's trace.
    Common(Side),
    /// The counter-face; the shaped body's surface lies off it along the normal.
    Counter,
}

/// Two interface operators whose kept boundaries share break points, so that contact is nodal and exact.
#[derive(Clone, Copy)]
pub struct Pair<'a> {
    /// The shaped body.
    pub shaped: &'a InterfaceOperator,
    /// The counter-face; `None` if it is rigid.
    pub counter: Option<&'a InterfaceOperator>,
    surface: Surface,
}

impl<'a> Pair<'a> {
    /// Pairs two boundaries that lie on each other and share edges and their parameters.
    ///
    /// # Errors
    /// [`Error::Unmatched`] when the number of edges or the places of their ends or middles differ by more than round-off.
    pub fn new(shaped: &'a InterfaceOperator, counter: Option<&'a InterfaceOperator>) -> Result<Pair<'a>, Error> {
        if let Some(counter) = counter {
            let (a, b) = (&shaped.trace, &counter.trace);
            same_number_of_edges(shaped, counter)?;
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
        let lead = counter.map_or(Side::Shaped, |counter| lead(shaped, counter));
        Ok(Pair { shaped, counter, surface: Surface::Common(lead) })
    }

    /// Pairs two boundaries that face each other across a gap (a cylinder on a plane): points, normal, weights and gap belong to the
    /// counter-face, the points of the shaped body are those met along the normal. Break points must face each other.
    ///
    /// # Errors
    /// [`Error::Unmatched`] when the number of edges differs or break points do not face each other.
    pub fn facing(shaped: &'a InterfaceOperator, counter: &'a InterfaceOperator) -> Result<Pair<'a>, Error> {
        same_number_of_edges(shaped, counter)?;
        let pair = Pair { shaped, counter: Some(counter), surface: Surface::Counter };
        let trace = &counter.trace;
        for edge in 0..trace.edges.len() {
            for t in [-1.0, 1.0] {
                let point = pair.point((edge, t), 0.0, 0.0);
                let x = shaped.trace.boundary_point(edge, t).0.position;
                let distance = along(point.tangent, difference(x, point.position)).abs();
                if distance > 1e-9 * trace.length() {
                    return Err(Error::Unmatched { edge, distance });
                }
            }
        }
        Ok(pair)
    }

    /// The place of a contact point on a side: edge of the path and parameter.
    pub fn place(&self, side: Side, point: &ContactPoint) -> (usize, f64) {
        match (self.surface, side) {
            (Surface::Counter, Side::Shaped) => self.facing_place(point),
            _ => point.place,
        }
    }

    /// Distance of the undeformed surfaces along the normal at a contact point.
    pub fn distance(&self, point: &ContactPoint) -> f64 {
        let (edge, t) = self.place(Side::Shaped, point);
        along(point.normal, difference(self.shaped.trace.boundary_point(edge, t).0.position, point.position))
    }

    /// Newton's method for the parameter at which the shaped body's edge crosses the normal through the point.
    fn facing_place(&self, point: &ContactPoint) -> (usize, f64) {
        let (edge, mut t) = point.place;
        let curve = &self.shaped.trace.edges[edge].curve;
        for _ in 0..50 {
            let step =
                along(point.tangent, difference(curve.point(t), point.position)) / along(point.tangent, curve.derivative(t));
            t = (t - step).clamp(-1.0, 1.0);
            if step.abs() < 1e-15 {
                break;
            }
        }
        (edge, t)
    }

    /// The operator whose boundary carries the points.
    fn surface(&self) -> (Side, &'a InterfaceOperator) {
        match (self.surface, self.counter) {
            (Surface::Counter | Surface::Common(Side::Counter), Some(counter)) => (Side::Counter, counter),
            _ => (Side::Shaped, self.shaped),
        }
    }

    /// The operator of a side; `None` for a rigid counter-face.
    pub fn side(&self, side: Side) -> Option<&'a InterfaceOperator> {
        match side {
            Side::Shaped => Some(self.shaped),
            Side::Counter => self.counter,
        }
    }

    /// The Gauss-Lobatto points of the contact surface.
    pub fn points(&self) -> Vec<ContactPoint> {
        let (_, operator) = self.surface();
        operator.trace.points.iter().map(|p| self.point((p.edge, p.parameter), p.arc, p.weight)).collect()
    }

    /// The contact point at arc length `arc` from the start of the path, without a weight.
    pub fn at_arc(&self, arc: f64) -> ContactPoint {
        self.point(self.surface().1.trace.locate(arc), arc, 0.0)
    }

    fn point(&self, place: (usize, f64), arc: f64, weight: f64) -> ContactPoint {
        let (side, operator) = self.surface();
        let boundary = operator.trace.boundary_point(place.0, place.1).0;
        let normal = normal(side, &boundary);
        ContactPoint { place, arc, position: boundary.position, normal, tangent: [normal[1], -normal[0]], weight }
    }
}

/// The side whose trace carries the points: the softer one, since there every pressure the points can hold moves the surface; of two
/// similar ones that of the higher degree.
fn lead(shaped: &InterfaceOperator, counter: &InterfaceOperator) -> Side {
    let stiffness = |body: &InterfaceOperator| {
        let held: Vec<usize> = (0..body.stiffness.nrows()).filter(|i| !body.frame.contains(&Some(*i))).collect();
        held.iter().map(|i| body.stiffness[(*i, *i)]).sum::<f64>() / held.len().max(1) as f64
    };
    let ratio = stiffness(shaped) / stiffness(counter);
    let richer = counter.trace.points.len() > shaped.trace.points.len();
    if ratio > 4.0 || (ratio >= 0.25 && richer) { Side::Counter } else { Side::Shaped }
}

fn same_number_of_edges(shaped: &InterfaceOperator, counter: &InterfaceOperator) -> Result<(), Error> {
    let (a, b) = (shaped.trace.edges.len(), counter.trace.edges.len());
    if a == b { Ok(()) } else { Err(Error::EdgeCount { shaped: a, counter: b }) }
}

fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn along(direction: [f64; 2], v: [f64; 2]) -> f64 {
    direction[0] * v[0] + direction[1] * v[1]
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
