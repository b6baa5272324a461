//! Two boundaries facing each other: common places, normal, drag direction.

use crate::error::Error;
use crate::facing::{coincide, crossing, nearest_break, unlike_length, unlike_normal};
use crate::point::{ContactPoint, along, difference};
use crate::side::Side;
use hpfem::{BoundaryPoint, InterfaceOperator, Trace};

/// Which surface carries the contact points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Surface {
    /// One surface, common to both bodies; the points are those of the given side's trace.
    Common(Side),
    /// The counter-face; the shaped body's surface lies off it along the normal.
    Counter,
}

/// Two interface operators whose kept boundaries meet. Where these share break points and edge parameters contact is nodal and exact;
/// otherwise the pressure of one is integrated over the segments between the break points of both (segment mortar).
#[derive(Clone, Copy)]
pub struct Pair<'a> {
    /// The shaped body.
    pub shaped: &'a InterfaceOperator,
    /// The counter-face; `None` if it is rigid.
    pub counter: Option<&'a InterfaceOperator>,
    surface: Surface,
    matched: bool,
}

/// Largest distance of two boundaries that are one surface, relative to its length: that of coarse straight edges on an arc.
const ON_EACH_OTHER: f64 = 1e-2;

impl<'a> Pair<'a> {
    /// Pairs two boundaries that lie on each other.
    ///
    /// # Errors
    /// [`Error::Unmatched`] when neither boundary is covered by the other, or they lie apart; [`Error::NothingKept`]; [`Error::Unlike`].
    pub fn new(shaped: &'a InterfaceOperator, counter: Option<&'a InterfaceOperator>) -> Result<Pair<'a>, Error> {
        alike(shaped, counter)?;
        let Some(other) = counter else {
            return Ok(Pair { shaped, counter, surface: Surface::Common(Side::Shaped), matched: true });
        };
        let side = lead(shaped, other);
        let pair = |side, matched| Pair { shaped, counter, surface: Surface::Common(side), matched };
        if coincide(&shaped.trace, &other.trace) {
            return Ok(pair(side, true));
        }
        let apart = pair(side, false).uncovered(ON_EACH_OTHER);
        let Some(apart) = apart else { return Ok(pair(side, false)) };
        match pair(side.other(), false).uncovered(ON_EACH_OTHER) {
            None => Ok(pair(side.other(), false)),
            Some(_) => Err(apart),
        }
    }

    /// Pairs two boundaries that face each other across a gap (a cylinder on a plane): points, normal, weights and gap belong to the
    /// counter-face, the points of the shaped body are those met along the normal.
    ///
    /// # Errors
    /// [`Error::Unmatched`] when the shaped body's boundary does not face all of the counter-face's; as [`Pair::new`].
    pub fn facing(shaped: &'a InterfaceOperator, counter: &'a InterfaceOperator) -> Result<Pair<'a>, Error> {
        alike(shaped, Some(counter))?;
        let pair = |matched| Pair { shaped, counter: Some(counter), surface: Surface::Counter, matched };
        if pair(true).break_points_face() {
            return Ok(pair(true));
        }
        pair(false).uncovered(f64::INFINITY).map_or(Ok(pair(false)), Err)
    }

    /// Pairs two arcs of different radii that face each other by the angle, each about its own centre, as a shaft and its housing: points, normals
    /// and weights are those of the counter-face, the gap between them is the caller's.
    ///
    /// # Errors
    /// [`Error::Unmatched`] when the edges of both do not end at the same angles; as [`Pair::new`].
    pub fn by_angle(shaped: &'a InterfaceOperator, counter: &'a InterfaceOperator) -> Result<Pair<'a>, Error> {
        alike(shaped, Some(counter))?;
        let pair = Pair { shaped, counter: Some(counter), surface: Surface::Common(Side::Counter), matched: true };
        match unlike_normal(&shaped.trace, &counter.trace) {
            None => Ok(pair),
            Some((edge, distance)) => Err(Error::Unmatched { edge, distance }),
        }
    }

    /// Pairs the arcs of two round bodies that touch from outside, as a cam and its roller: points face each other by the arc length from there, normals
    /// and weights are those of the counter-face, the gap between them is the caller's. Lengths that the contact takes up of the radii count by
    /// their square, as in Hertz's theory.
    ///
    /// # Errors
    /// [`Error::Unmatched`] when the edges of both are not of the same lengths; as [`Pair::new`].
    pub fn by_arc(shaped: &'a InterfaceOperator, counter: &'a InterfaceOperator) -> Result<Pair<'a>, Error> {
        alike(shaped, Some(counter))?;
        let pair = Pair { shaped, counter: Some(counter), surface: Surface::Common(Side::Counter), matched: true };
        match unlike_length(&shaped.trace, &counter.trace) {
            None => Ok(pair),
            Some((edge, distance)) => Err(Error::Unmatched { edge, distance }),
        }
    }

    /// Whether contact is nodal: the boundaries share break points and edge parameters.
    pub fn is_nodal(&self) -> bool {
        self.matched
    }

    /// Whether break points face each other along the normal, edge by edge.
    fn break_points_face(&self) -> bool {
        let (trace, shaped) = (self.trace(), &self.shaped.trace);
        let faces = |edge: usize, t: f64| {
            let point = self.point((edge, t), 0.0, 0.0);
            let x = shaped.edges[edge].curve.point(t);
            along(point.tangent, difference(x, point.position)).abs() <= 1e-9 * trace.length()
        };
        trace.edges.len() == shaped.edges.len() && (0..trace.edges.len()).all(|edge| faces(edge, -1.0) && faces(edge, 1.0))
    }

    /// Where the surface with the points is not covered by the other one, or farther from it than the limit (relative to the length).
    fn uncovered(&self, limit: f64) -> Option<Error> {
        let other = &self.side(self.surface().0.other())?.trace;
        let trace = self.trace();
        for edge in 0..trace.edges.len() {
            for t in [-1.0, 0.0, 1.0] {
                let point = self.point((edge, t), 0.0, 0.0);
                let distance = match crossing(other, &point) {
                    Some((_, distance)) if distance.abs() <= limit * trace.length() => continue,
                    Some((_, distance)) => distance.abs(),
                    None => nearest_break(other, point.position),
                };
                return Some(Error::Unmatched { edge, distance });
            }
        }
        None
    }

    /// The place of a contact point on a side: edge of the path and parameter.
    pub fn place(&self, side: Side, point: &ContactPoint) -> (usize, f64) {
        if side == self.surface().0 || (self.matched && self.surface != Surface::Counter) {
            return point.place;
        }
        self.side(side).and_then(|body| crossing(&body.trace, point)).map_or(point.place, |(place, _)| place)
    }

    /// Distance of the undeformed surfaces along the normal at a contact point.
    pub fn distance(&self, point: &ContactPoint) -> f64 {
        let (edge, t) = self.place(Side::Shaped, point);
        along(point.normal, difference(self.shaped.trace.boundary_point(edge, t).0.position, point.position))
    }

    /// The boundary that carries the contact points; their arc lengths are its own.
    pub fn trace(&self) -> &'a Trace {
        &self.surface().1.trace
    }

    /// The side whose boundary carries the points, and its operator.
    pub(crate) fn surface(&self) -> (Side, &'a InterfaceOperator) {
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
        let points: Vec<ContactPoint> =
            self.trace().points.iter().map(|p| self.point((p.edge, p.parameter), p.arc, p.weight)).collect();
        if self.matched { points } else { self.segments(points).0 }
    }

    /// The contact point at arc length `arc` from the start of the path, without a weight.
    pub fn at_arc(&self, arc: f64) -> ContactPoint {
        self.point(self.trace().locate(arc), arc, 0.0)
    }

    pub(crate) fn point(&self, place: (usize, f64), arc: f64, weight: f64) -> ContactPoint {
        let (side, operator) = self.surface();
        let boundary = operator.trace.boundary_point(place.0, place.1).0;
        let normal = normal(side, &boundary);
        ContactPoint { place, arc, position: boundary.position, normal, tangent: [normal[1], -normal[0]], weight }
    }
}

/// Refuses bodies without a boundary to touch, and two that do not mean the same by their coordinates.
fn alike(shaped: &InterfaceOperator, counter: Option<&InterfaceOperator>) -> Result<(), Error> {
    for (side, body) in [(Side::Shaped, Some(shaped)), (Side::Counter, counter)] {
        if body.is_some_and(|body| body.trace.edges.is_empty()) {
            return Err(Error::NothingKept { side });
        }
    }
    let kinematics = [shaped, counter.unwrap_or(shaped)].map(|body| body.kinematics);
    let [one, other] = kinematics;
    let like = one.components() == other.components() && one.is_conduction() == other.is_conduction();
    if like && one.thickness() == other.thickness() { Ok(()) } else { Err(Error::Unlike { kinematics }) }
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
