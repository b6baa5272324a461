//! Random scenes.

use super::case::{Body, Case, Load, Shape};
use super::twin::{Property, Rule};
use super::warm::Warm;

/// A generator of numbers (Steele, Lea and Flood 2014, splitmix).
pub(super) struct Random(u64);

impl Random {
    pub(super) fn new(seed: u64) -> Random {
        Random(seed.wrapping_mul(0xd134_2543_de82_ef95))
    }

    pub(super) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Evenly between two numbers, to four digits as people write them.
    pub(super) fn within(&mut self, from: f64, to: f64) -> f64 {
        let value = from + (to - from) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64;
        format!("{value:.3e}").parse().unwrap()
    }

    /// Evenly in the logarithm.
    pub(super) fn scale(&mut self, from: f64, to: f64) -> f64 {
        let value = self.within(from.ln(), to.ln()).exp();
        format!("{value:.3e}").parse().unwrap()
    }

    pub(super) fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }

    fn one<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())]
    }

    /// Ascending places with both ends.
    fn places(&mut self, [from, to]: [f64; 2], cells: usize) -> Vec<f64> {
        let mut places = vec![from];
        for cell in 1..cells {
            let share = (cell as f64 + self.within(-0.3, 0.3)) / cells as f64;
            places.push(from + share * (to - from));
        }
        places.push(to);
        places
    }
}

/// The next scene that a property can be tried on.
pub(super) fn case(random: &mut Random, property: Property) -> Case {
    let of_cells = matches!(property, Property::Naming | Property::Numbering | Property::Splitting);
    let mut case = match random.below(4) {
        _ if property == Property::Turning => pinned(random),
        _ if property == Property::Round => round(random),
        0 if !of_cells && property != Property::Swap => drum(random),
        1 if property != Property::Swap => annulus(random),
        _ => punch(random),
    };
    if of_cells || (!matches!(property, Property::Swap | Property::Turning | Property::Round) && random.below(5) == 0) {
        cut(&mut case, random);
    }
    if property == Property::Swap {
        (case.task, case.friction) = ("contact", 0.0);
        case.bodies[0].support = vec![("top", "[\"x\"]")];
        case.load = Load { kind: "rigid", force: case.load.force, moment: None, tilt: Some(0.0) };
        // A body 1 that is wider than body 2 is refused.
        if let [Shape::Rectangle { x, .. }, Shape::Rectangle { x: wide, .. }] = case.bodies.each_mut().map(|body| &mut body.shape)
        {
            *wide = *x;
        }
    }
    if matches!(property, Property::Naming | Property::Numbering) {
        // Ends of contact that are searched are not found to round-off.
        case.gap = None;
    }
    if of_cells {
        // What is estimated: the gap of a shape, the pressure of a contact.
        case.task = if case.task == "contact" { "contact" } else { "shape" };
    }
    if property.rule(&case) == Rule::Estimates {
        // An estimate takes finer discretisations.
        (case.degree, case.layers) = (5, 1 + random.below(2));
    }
    if matches!(property, Property::Mirror | Property::Scaling | Property::Units | Property::Threads) {
        // From numbers of its own: what is drawn after it is what it was.
        case.heat = Warm::drawn(&case, &mut Random(!random.0));
    }
    case
}

/// Rectangles become cells.
fn cut(case: &mut Case, random: &mut Random) {
    for body in &mut case.bodies {
        if let Shape::Rectangle { x, z } = body.shape {
            let cells = [1 + random.below(3), 1 + random.below(2)];
            body.shape = Shape::Cells { x: random.places(x, cells[0]), z: random.places(z, cells[1]), naming: 0 };
        }
    }
}

fn body(random: &mut Random, shape: Shape, support: Vec<(&'static str, &'static str)>) -> Body {
    Body { shape, young: random.scale(1e2, 3e5), poisson: random.within(0.0, 0.45), support }
}

/// A run in time in which the softer body's strain is worn off by some share.
fn until(case: &Case, area: f64, random: &mut Random) -> f64 {
    let pressure = case.load.force / area;
    let young = case.bodies[0].young.min(case.bodies[1].young);
    let [a, b] = case.exponents;
    let speed = if case.sliding.0 == "speed" { case.sliding.1 } else { 50.0 * case.sliding.1 };
    let rate = case.factors[0].max(case.factors[1]) * (case.friction * pressure).powf(b) * speed.abs().powf(a);
    random.scale(0.1, 2.0) * 50.0 * pressure / young / rate
}

/// What all kinds of scenes have in common; the load is such that strains are small.
fn common(random: &mut Random, bodies: [Body; 2], area: f64) -> Case {
    let young = bodies[0].young.min(bodies[1].young);
    let force = area * young * random.scale(1e-5, 1e-3);
    let task = random.one(&["pressure", "contact", "contact", "shape", "shape", "wear"]);
    let functional = if random.below(4) == 0 { "uniform" } else { "steady" };
    Case {
        kinematics: "plane-stress",
        thickness: random.scale(0.5, 50.0),
        task,
        degree: 4 + random.below(3),
        layers: 1 + random.below(3),
        bodies,
        edges: ["bottom", "top"],
        friction: random.within(0.02, 0.5),
        gap: None,
        sliding: ("speed", random.scale(0.1, 1e3) * random.one(&[-1.0, 1.0])),
        load: Load { kind: "pressure", force, moment: None, tilt: None },
        factors: [random.scale(1e-8, 1e-3), 0.0],
        exponents: [random.within(0.5, 1.5), random.within(0.5, 2.0)],
        until: 0.0,
        functional,
        heat: None,
    }
}

/// A crown and a wedge of the size of what the load deforms.
fn start_gap(case: &mut Case, [width, area]: [f64; 2], random: &mut Random) {
    let young = case.bodies[0].young.min(case.bodies[1].young);
    if matches!(case.task, "contact" | "wear") && random.below(3) == 0 {
        let indentation = width * case.load.force / (area * young);
        let tilt = if case.kinematics == "axisymmetric" { 0.0 } else { random.within(-0.5, 0.5) * indentation / width };
        case.gap = Some([indentation * random.scale(0.1, 10.0), tilt]);
    }
}

fn punch(random: &mut Random) -> Case {
    let (from, width) = (random.within(-60.0, 20.0), random.scale(8.0, 80.0));
    let x = [from, from + width];
    let wide = [x[0] - width * random.within(0.2, 2.0), x[1] + width * random.within(0.2, 2.0)];
    let upper = Shape::Rectangle { x, z: [0.0, width * random.scale(0.3, 3.0)] };
    let lower = Shape::Rectangle { x: wide, z: [-width * random.scale(0.3, 3.0), 0.0] };
    let held = match random.below(3) {
        0 => vec![("left", "[\"x\"]"), ("right", "[\"x\"]")],
        1 => vec![("left", "[\"x\"]")],
        _ => vec![("top", "[\"x\"]")],
    };
    let guided = held[0].0 != "top";
    let bodies = [body(random, upper, held), body(random, lower, vec![("bottom", "[\"x\", \"z\"]")])];
    let mut case = common(random, bodies, width);
    case.kinematics = random.one(&["plane-stress", "plane-strain"]);
    case.load.force *= case.thickness;
    if !guided && random.below(2) == 0 {
        case.load.kind = "rigid";
        if random.below(3) == 0 {
            case.load.tilt = Some(0.0);
        } else {
            let about = [x[0] + width * random.within(0.3, 0.7), 0.0];
            // About the middle of the punch no more than a tenth of its width.
            let moment = case.load.force * (0.5 * (x[0] + x[1]) - about[0] + width * random.within(-0.1, 0.1));
            case.load.moment = Some((moment, about));
        }
    }
    let area = width * case.thickness;
    start_gap(&mut case, [width, area], random);
    case.until = until(&case, area, random);
    case
}

fn annulus(random: &mut Random) -> Case {
    let inner = random.scale(10.0, 60.0);
    let width = inner * random.scale(0.2, 2.0);
    let outer = inner + width;
    let upper = Shape::Rectangle { x: [inner, outer], z: [0.0, width * random.scale(0.3, 3.0)] };
    let beyond = [inner * random.within(0.2, 0.9), outer * random.within(1.1, 2.0)];
    let lower = Shape::Rectangle { x: beyond, z: [-width * random.scale(0.3, 3.0), 0.0] };
    let bodies =
        [body(random, upper, vec![("top", "[\"phi\"]")]), body(random, lower, vec![("bottom", "[\"x\", \"z\", \"phi\"]")])];
    let area = std::f64::consts::PI * (outer * outer - inner * inner);
    let mut case = common(random, bodies, area);
    case.kinematics = "axisymmetric";
    case.sliding = ("omega", random.scale(0.01, 100.0));
    case.factors[1] = random.one(&[0.0, 1e-6]);
    start_gap(&mut case, [width, area], random);
    case.until = until(&case, area, random);
    case
}

fn drum(random: &mut Random) -> Case {
    let radius = random.scale(20.0, 300.0);
    let half_angle = random.within(0.15, 0.9);
    let shoe = Shape::Shoe { radius, half_angle, top: radius * random.within(1.2, 1.8) };
    let ring = Shape::Ring { inner: radius * random.within(0.3, 0.8), outer: radius };
    let guides = vec![("left", "[\"x\"]"), ("right", "[\"x\"]")];
    let bodies = [body(random, shoe, guides), body(random, ring, vec![("inner", "[\"x\", \"z\"]")])];
    let width = 2.0 * radius * half_angle.sin();
    let mut case = common(random, bodies, width);
    case.kinematics = random.one(&["plane-stress", "plane-strain"]);
    case.edges = ["inner", "outer"];
    case.load.force *= case.thickness;
    case.load.kind = random.one(&["pressure", "vertical"]);
    case.sliding = ("omega", random.scale(0.01, 100.0) * random.one(&[-1.0, 1.0]));
    let area = width * case.thickness;
    start_gap(&mut case, [width, area], random);
    case.until = until(&case, area, random);
    case
}

/// A shoe around a drum, on a pin beside it.
fn pinned(random: &mut Random) -> Case {
    let radius = random.scale(20.0, 300.0);
    let start = random.within(-0.7, -0.1);
    let end = start + random.within(0.3, 0.8);
    let radii = [radius, radius * random.within(1.05, 1.4)];
    let middle = start + (end - start) * random.within(0.2, 0.5);
    let shoe = Shape::Pinned { radii, angles: [start, middle, end], pin: start - random.within(0.05, 0.3) };
    let ring = Shape::Ring { inner: radius * random.within(0.3, 0.8), outer: radius };
    let bodies = [body(random, shoe, Vec::new()), body(random, ring, vec![("inner", "[\"x\", \"z\"]")])];
    let width = radius * (end - start);
    let mut case = common(random, bodies, width);
    case.kinematics = random.one(&["plane-stress", "plane-strain"]);
    case.edges = ["inner", "outer"];
    case.load.force *= case.thickness;
    case.sliding = ("omega", random.scale(0.01, 100.0) * random.one(&[-1.0, 1.0]));
    case.functional = "steady";
    case.until = until(&case, width * case.thickness, random);
    case
}

/// A half disc or ball on a block; the contact is short and its ends are searched.
fn round(random: &mut Random) -> Case {
    let ball = random.below(3) == 0;
    let radius = random.scale(2.0, 100.0);
    let x = if ball { 0.0 } else { random.within(-50.0, 50.0) };
    // As far on both sides of the disc.
    let beyond = radius * random.within(1.2, 3.0);
    let from = if ball { 0.0 } else { x - beyond };
    let block = Shape::Rectangle { x: [from, x + beyond], z: [-radius * random.within(1.0, 4.0), 0.0] };
    let disc = Shape::Disc { radius, x };
    let held = if ball { Vec::new() } else { vec![("centre", "[\"x\"]")] };
    let bodies = [body(random, disc, held), body(random, block, vec![("bottom", "[\"x\", \"z\"]")])];
    // Forces of contacts whose width is some hundredths of the radius.
    let mut case = common(random, bodies, radius);
    case.task = "contact";
    case.edges = ["arc", "top"];
    case.friction = 0.0;
    case.load.force *= case.thickness;
    if ball {
        case.kinematics = "axisymmetric";
        case.load.force *= radius / case.thickness;
        case.sliding = ("omega", random.scale(0.01, 100.0));
    } else {
        case.kinematics = random.one(&["plane-stress", "plane-strain"]);
    }
    case
}
