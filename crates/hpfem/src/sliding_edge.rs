//! Exponents of the pressure at a sharp edge of a body that slides on another with friction.
//!
//! Both bodies are wedges with a common contact ray: free or held outer faces, equal normal displacement and traction on the ray, and there the
//! shear `mu` times the pressure. The functions of every sector are those of [`corner_exponent`](crate::corner_exponent); the determinant
//! of all conditions is `D0(lambda) + mu D1(lambda)`, and the pressure goes like `d^(lambda - 1)` with the smallest root between 0 and 1
//! (Dundurs and Lee 1972 for frictionless edges, Gdoutos and Theocaris 1975 and Comninou 1976 with friction).

use nalgebra::DMatrix;

use crate::bisect::bisect;
use crate::error::Error;
use crate::kinematics::Kinematics;
use crate::sector::{C, Sector, condition, plane};
use crate::singular::Corner;

/// What the pressure does at a sharp sliding edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SlidingEdge {
    /// It grows like `d^(lambda - 1)`, `0 < lambda < 1`.
    Singular {
        /// `lambda`, no unit.
        lambda: f64,
    },
    /// No exponent lies between 0 and 1: the pressure stays bounded, or the edge lifts.
    Bounded,
    /// So much friction that the smallest exponent has left 0 to 1 through zero: no pressure that carries a finite force fits, the edge digs in.
    DigsIn,
}

/// Exponents tried between 0 and 1.
const STEPS: usize = 400;

/// The pressure at the edge of the body `shaped` on the body `counter`, of which the contact ray is the first face. `friction` is the
/// coefficient, positive where the other body drags `shaped` from the edge into the contact, negative where it drags out of it.
///
/// # Errors
/// [`Error::OutOfRange`] for a friction that is not finite.
pub fn sliding_edge(shaped: &Corner, counter: &Corner, friction: f64, kinematics: Kinematics) -> Result<SlidingEdge, Error> {
    if !friction.is_finite() {
        let quantity = "the friction of a sliding edge".into();
        return Err(Error::OutOfRange { quantity, value: friction, range: "finite" });
    }
    let value = |lambda: f64, friction: f64| determinant(lambda, shaped, counter, friction, kinematics);
    let at = |i: usize| i as f64 / STEPS as f64;
    let smallest = at(1) * 1e-2;
    // lambda = 1 is a root of every edge: a rigid motion.
    let places = std::iter::once(smallest).chain((1..STEPS).map(at)).chain([1.0 - 1e-5]);
    let mut before: Option<(f64, f64)> = None;
    for lambda in places {
        let now = value(lambda, friction);
        if let Some((lower, sign)) = before.filter(|(_, sign)| sign.signum() != now.signum()) {
            let [low, high] = bisect([lower, lambda], 60, |middle| value(middle, friction).signum() == sign.signum());
            return Ok(SlidingEdge::Singular { lambda: 0.5 * (low + high) });
        }
        before = Some((lambda, now));
    }
    // A root that has passed through zero leaves the sign there other than without friction.
    let digs_in = value(smallest, friction).signum() != value(smallest, 0.0).signum();
    Ok(if digs_in { SlidingEdge::DigsIn } else { SlidingEdge::Bounded })
}

/// Determinant of the conditions at a real exponent.
fn determinant(lambda: f64, shaped: &Corner, counter: &Corner, friction: f64, kinematics: Kinematics) -> f64 {
    let n = shaped.sectors.len() + counter.sectors.len();
    let mut m = DMatrix::<f64>::zeros(4 * n, 4 * n);
    let mut row = 0;
    // Angles from the contact ray: anti-clockwise in the shaped body, clockwise in the other.
    let state = |sector: &Sector, t: f64| plane(C::new(lambda, 0.0), sector, t, kinematics);
    let mut contact = Vec::new();
    for (corner, sense, first) in [(shaped, 1.0, 0), (counter, -1.0, shaped.sectors.len())] {
        let sectors = &corner.sectors;
        let mut put = |row: usize, sector: usize, values: &[C], factor: f64| {
            values.iter().enumerate().for_each(|(k, v)| m[(row, 4 * (first + sector) + k)] += factor * v.re);
        };
        for (number, pair) in sectors.windows(2).enumerate() {
            let (a, b) = (state(&pair[0], sense * pair[0].angle), state(&pair[1], 0.0));
            for k in 0..4 {
                put(row, number, &a[k], 1.0);
                put(row, number + 1, &b[k], -1.0);
                row += 1;
            }
        }
        let Some((last, open)) = sectors.last().map(|last| (sectors.len() - 1, state(last, sense * last.angle))) else {
            continue;
        };
        for values in condition(corner.faces[1], &open, 2) {
            put(row, last, &values, 1.0);
            row += 1;
        }
        contact.push((first, state(&sectors[0], 0.0)));
    }
    let [(one, a), (other, b)] = &contact[..] else { return 0.0 };
    let mut put = |row: usize, first: usize, values: &[C], factor: f64| {
        values.iter().enumerate().for_each(|(k, v)| m[(row, 4 * first + k)] += factor * v.re);
    };
    // Normal displacement, normal traction, shear traction alike; the shear is friction times the normal traction.
    for k in 1..4 {
        put(row, *one, &a[k], 1.0);
        put(row, *other, &b[k], -1.0);
        row += 1;
    }
    put(row, *one, &a[3], 1.0);
    put(row, *one, &a[2], -friction);
    m.determinant()
}
