//! A gap iteration of one's own on two interface operators: solve the contact on a gap, open the gap where the pressure is too high, close it
//! where it is too low, until the contact presses as it should.
//!
//! ```text
//!        F                 g_i <- g_i + omega A_ii W_i (p_i - p*_i)
//!    ____|____
//!   |  punch  |            p* = p_mean (5 - 3 (x/c)^2)/4: highest in the middle, half as high at the ends
//!   |_________|
//!  |   plate     |         the gap it arrives at is that of `solve_shape`, which needs no contact solve at all
//! ```

use contact::{ContactLoad, ContactOperator, Motion, Pair};
use hpfem::{Body, BodyProblem, Curve, InterfaceOperator, Kinematics, Material, Mesh, Named, RigidEdge, Ruled, Side};
use shapeopt::{Gauge, Integration, RigidPart, ShapeProblem, solve_shape};

type Anything = Box<dyn std::error::Error>;

/// Force, N; half length of the punch, mm; mean pressure, MPa, on a thickness of 10 mm.
const FORCE: f64 = 1000.0;
const HALF: f64 = 30.0;
const MEAN: f64 = FORCE / (2.0 * HALF * 10.0);

/// Part of a point's own closing that a step takes; with more the shortest ripples overshoot.
const OMEGA: f64 = 0.2;

/// Wanted pressure at a distance from the middle.
fn wanted(x: f64) -> f64 {
    0.25 * MEAN * (5.0 - 3.0 * (x / HALF).powi(2))
}

/// Steel punch 60 x 100 mm pressed through its rigid top, on a clamped plate 120 x 100 mm; plane stress.
fn bodies(degree: usize) -> Result<[InterfaceOperator; 2], hpfem::Error> {
    let rectangle = |x: [f64; 2], z: [f64; 2], breaks: &[f64], side: Side, contact: [f64; 2]| {
        let line = |z: f64| Curve::Line { start: [x[0], z], end: [x[1], z] };
        let name = |side, range, name| Named { side, range, name };
        let names = [name(Side::Bottom, None, "bottom"), name(Side::Top, None, "top"), name(side, Some(contact), "contact")];
        let (bottom, top) = (line(z[0]), line(z[1]));
        Mesh::ruled(&Ruled { bottom, top, breaks, levels: &[0.0, 1.0], closed: false, material: 0, names: &names })
    };
    let punch = rectangle([-HALF, HALF], [100.0, 200.0], &[-1.0, 0.0, 1.0], Side::Bottom, [-1.0, 1.0])?;
    let plate = rectangle([-60.0, 60.0], [0.0, 100.0], &[-1.0, -0.5, 0.0, 0.5, 1.0], Side::Top, [-0.5, 0.5])?;
    let pressed = RigidEdge { boundary: "top".into(), reference: [0.0, 200.0], free: [false, true, false] };
    let steel = Material::isotropic(210e3, 0.3)?;
    let body = |mesh| BodyProblem::new(mesh, degree, Kinematics::PlaneStress { thickness: 10.0 }).material(steel).keep("contact");
    let punch = BodyProblem { rigid_edge: Some(pressed), ..body(punch) };
    Ok([Body::interface(&punch)?.0, Body::interface(&body(plate).clamp("bottom"))?.0])
}

/// What the iteration has come to.
pub(crate) struct Found {
    /// Contact solves.
    pub solves: usize,
    /// Largest deviation of the pressure over the mean pressure.
    pub deviation: f64,
    /// Height of the gap from the middle to its ends, mm.
    pub crown: f64,
    /// Largest difference from the gap of `solve_shape` up to the rigid motion, over the crown.
    pub from_shape: f64,
}

/// Iterates the gap until the pressure deviates by less than a part of its mean.
pub(crate) fn iterated(degree: usize, part: f64) -> Result<Found, Anything> {
    let [punch, plate] = bodies(degree)?;
    let pair = Pair::new(&punch, Some(&plate))?;
    let operator = ContactOperator::new(&pair, false)?;
    let mut load = ContactLoad::factors(&[], &[]);
    load.motions[1] = Motion::Free { resultant: -FORCE };
    let compliance = operator.system(&load)?.compliance;
    let points = operator.points();
    let mut gap = vec![0.0; points.len()];
    let (mut solves, mut deviation) = (0, f64::INFINITY);
    while deviation > part && solves < 1000 {
        let pressure = operator.solve(&gap, &load, None)?.pressure;
        solves += 1;
        let excess: Vec<f64> = points.iter().zip(&pressure).map(|(point, p)| p - wanted(point.position[0])).collect();
        deviation = excess.iter().fold(0.0_f64, |most, e| most.max(e.abs())) / MEAN;
        for (i, g) in gap.iter_mut().enumerate() {
            *g += OMEGA * compliance[(i, i)] * points[i].weight * excess[i];
        }
    }
    let shape = solve_shape(&ShapeProblem {
        pair,
        // The arc length runs from the left end.
        traction: &|place| [wanted(place.arc - HALF), 0.0],
        cases_shaped: &[],
        cases_counter: &[],
        gauge: Gauge::HeldEdge,
        rigid: RigidPart::Smallest,
        integration: Integration::Lobatto,
    })?;
    let direct: Vec<f64> = points.iter().map(|point| shape.gap(&pair, point)).collect();
    let middle = points.len() / 2;
    let crown = gap[0] - gap[middle];
    let apart = |i: usize| ((gap[i] - gap[middle]) - (direct[i] - direct[middle])).abs();
    let from_shape = (0..points.len()).map(apart).fold(0.0, f64::max) / crown;
    Ok(Found { solves, deviation, crown, from_shape })
}

pub(crate) fn main() -> Result<(), Anything> {
    let found = iterated(8, 1e-9)?;
    println!("after {} contact solves the pressure deviates by {:.1e} of its mean", found.solves, found.deviation);
    println!("crown {:.9} um, {:.1e} of it away from the direct shape", 1e3 * found.crown, found.from_shape);
    Ok(())
}
