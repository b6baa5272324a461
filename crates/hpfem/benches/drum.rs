//! The gap of a drum brake from meshes to displacements of the contact: error against seconds.
//!
//! A block shoe (`200 <= r`, half angle 30 degrees, flat top at 300) on a ring (100 to 200), plane stress, t = 10, uniform pressure of 5
//! MPa with friction 0.25 on the arc. Error: L2 of the gap over 1201 equally spaced angles relative to the gap, the best multiple of
//! cos(alpha) removed; reference: degree 16 with 14 layers. Run with RAYON_NUM_THREADS=1 for one thread;
//! `cargo bench -p wearshape-hpfem --bench drum -- DEGREE SHOE DRUM SLOPE RATIO` measures one mesh.

use hpfem::*;
use std::f64::consts::{FRAC_PI_2, PI};
use std::time::Instant;

const RADIUS: f64 = 200.0;
const HALF_ANGLE: f64 = PI / 6.0;
const FRICTION: f64 = 0.25;
const PRESSURE: f64 = 5.0;
const KINEMATICS: Kinematics = Kinematics::PlaneStress { thickness: 10.0 };

/// A discretisation: the degree falls by `slope` a layer.
#[derive(Clone, Copy)]
struct Level {
    degree: usize,
    layers_shoe: usize,
    layers_drum: usize,
    slope: f64,
    /// Size of a layer over that of the one before.
    ratio: f64,
}

fn main() {
    let reference = gap(Level { degree: 16, layers_shoe: 12, layers_drum: 14, slope: 0.0, ratio: 0.15 }).0;
    let arguments: Vec<f64> = std::env::args().filter_map(|a| a.parse().ok()).collect();
    if let [degree, shoe, drum, slope, ratio] = arguments[..] {
        let level = Level { degree: degree as usize, layers_shoe: shoe as usize, layers_drum: drum as usize, slope, ratio };
        return row(level, &reference);
    }
    println!("| p | layers shoe | layers drum | slope | ratio | unknowns | error | ms |");
    println!("|---|---|---|---|---|---|---|---|");
    let ladder = [
        (6, 1, 1, 1.5, 0.1),
        (6, 2, 3, 1.5, 0.15),
        (7, 3, 4, 1.5, 0.2),
        (8, 2, 4, 1.0, 0.25),
        (9, 4, 7, 1.5, 0.25),
        (10, 4, 7, 1.5, 0.25),
        (11, 5, 9, 1.5, 0.25),
        (12, 4, 8, 1.0, 0.25),
        (14, 6, 11, 1.5, 0.25),
    ];
    for (degree, layers_shoe, layers_drum, slope, ratio) in ladder {
        row(Level { degree, layers_shoe, layers_drum, slope, ratio }, &reference);
    }
}

/// Prints the error and the least time of a level.
fn row(level: Level, reference: &[f64]) {
    let mut seconds = f64::MAX;
    let (mut error, mut unknowns) = (0.0, 0);
    for _ in 0..25 {
        let (values, time, count) = gap(level);
        seconds = seconds.min(time);
        (error, unknowns) = (distance(&values, reference), count);
    }
    let Level { degree, layers_shoe, layers_drum, slope, ratio } = level;
    let milliseconds = 1e3 * seconds;
    println!("| {degree} | {layers_shoe} | {layers_drum} | {slope} | {ratio} | {unknowns} | {error:.1e} | {milliseconds:.2} |");
    println!("bench drum-gap-p{degree}-slope{slope} {seconds:.3e}");
}

fn angles() -> impl Iterator<Item = f64> {
    (0..1201).map(|k| (0.05 * k as f64 - 30.0).to_radians())
}

/// Gap without a rigid part at the 1201 angles, seconds from nothing to both traces, unknowns.
fn gap(level: Level) -> (Vec<f64>, f64, usize) {
    let start = Instant::now();
    let shoe = problem(shoe(level), level).hold("left", Direction::First).hold("right", Direction::First);
    let shoe = reduced(shoe.load("top", EdgeTraction::new("top", |_| [0.0, -PRESSURE])));
    let drum = reduced(problem(drum(level), level).clamp("hub"));
    let (u1, u2) = (press(&shoe.0, 1.0, &[1.0]), press(&drum.0, -1.0, &[]));
    let seconds = start.elapsed().as_secs_f64();
    let gap = angles().map(|a| normal(&drum.0, &u2, a) - normal(&shoe.0, &u1, a)).collect();
    (gap, seconds, shoe.1.unknowns + drum.1.unknowns)
}

fn ruled(bottom: Curve, top: Curve, breaks: &[f64], names: &[Named<'_>], level: (f64, usize)) -> Mesh {
    let closed = names.iter().any(|n| n.name == "hub");
    let coarse = Mesh::ruled(&Ruled { bottom, top, breaks, levels: &[0.0, 1.0], closed, material: 0, names });
    let coarse = coarse.expect("the body is not folded");
    let (x, z) = (RADIUS * HALF_ANGLE.sin(), RADIUS * HALF_ANGLE.cos());
    let ends = [coarse.nearest_vertex([-x, z]), coarse.nearest_vertex([x, z])];
    coarse.refined_towards(&ends, level.0, level.1).expect("the layers are not folded")
}

fn shoe(level: Level) -> Mesh {
    let (from, to) = (FRAC_PI_2 + HALF_ANGLE, FRAC_PI_2 - HALF_ANGLE);
    let x = RADIUS * HALF_ANGLE.sin();
    let bottom = Curve::Arc { centre: [0.0; 2], radius: RADIUS, from, to };
    let top = Curve::Line { start: [-x, 300.0], end: [x, 300.0] };
    let n = |side, name| Named { side, range: None, name };
    let names = [n(Side::Bottom, "contact"), n(Side::Top, "top"), n(Side::Left, "left"), n(Side::Right, "right")];
    ruled(bottom, top, &[-1.0, 0.0, 1.0], &names, (level.ratio, level.layers_shoe))
}

fn drum(level: Level) -> Mesh {
    let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: FRAC_PI_2 + PI, to: FRAC_PI_2 - PI };
    let breaks = [-6.0, -4.0, -2.0, -1.0, 0.0, 1.0, 2.0, 4.0, 6.0].map(|t| t / 6.0);
    let names = [
        Named { side: Side::Bottom, range: None, name: "hub" },
        Named { side: Side::Top, range: Some([breaks[3], breaks[5]]), name: "contact" },
    ];
    ruled(arc(100.0), arc(RADIUS), &breaks, &names, (level.ratio, level.layers_drum))
}

fn problem(mesh: Mesh, level: Level) -> BodyProblem {
    let degree = |cell: &Cell| (level.degree as f64 - level.slope * cell.layer as f64).round().max(2.0) as usize;
    let degrees = mesh.cells.iter().map(degree).collect();
    let steel = Material::isotropic(210e3, 0.3).expect("steel");
    BodyProblem::new(mesh, level.degree, KINEMATICS).degrees(degrees).material(steel).keep("contact")
}

fn reduced(problem: BodyProblem) -> (InterfaceOperator, Effort) {
    Body::interface(&problem).expect("the body is held")
}

/// Kept unknowns under pressure and friction; `side` is 1 for the shoe, -1 for the drum.
fn press(operator: &InterfaceOperator, side: f64, cases: &[f64]) -> Vec<f64> {
    let load = operator.trace.load(KINEMATICS, 4, |point| {
        let n = point.outward.map(|v| -side * v);
        [side * PRESSURE * (n[0] - FRICTION * n[1]), side * PRESSURE * (n[1] + FRICTION * n[0])]
    });
    let right = operator.right_hand_side(&load, &operator.factors_in_order(cases));
    let x = operator.solve(&faer::Mat::from_fn(right.len(), 1, |i, _| right[i]), &operator.rigid_modes);
    (0..right.len()).map(|i| x[(i, 0)]).collect()
}

fn normal(operator: &InterfaceOperator, unknowns: &[f64], angle: f64) -> f64 {
    let trace = &operator.trace;
    let (edge, t) = trace.locate(RADIUS * (angle + HALF_ANGLE));
    let [x, z] = trace.displacement_row(edge, t).0.map(|row| row.iter().map(|(i, c)| c * unknowns[*i]).sum::<f64>());
    x * angle.sin() + z * angle.cos()
}

/// L2 distance of two gaps modulo cos(alpha), relative to the reference shifted so that it just touches.
fn distance(values: &[f64], reference: &[f64]) -> f64 {
    let cos: Vec<f64> = angles().map(f64::cos).collect();
    let mut difference: Vec<f64> = values.iter().zip(reference).map(|(a, b)| a - b).collect();
    let share = difference.iter().zip(&cos).map(|(d, c)| d * c).sum::<f64>() / cos.iter().map(|c| c * c).sum::<f64>();
    difference.iter_mut().zip(&cos).for_each(|(d, c)| *d -= share * c);
    let shift = reference.iter().zip(&cos).map(|(g, c)| g / c).fold(f64::MAX, f64::min);
    let norm = |v: &mut dyn Iterator<Item = f64>| v.map(|x| x * x).sum::<f64>().sqrt();
    norm(&mut difference.into_iter()) / norm(&mut reference.iter().zip(&cos).map(|(g, c)| g - shift * c))
}
