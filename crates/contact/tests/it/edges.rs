//! Sharp edges of contact: stiffness of a rigid annular punch, and exponents of the pressure `p ~ d^l` at the distance `d` from an edge.

use crate::common::punch::{Punch, rectangle};
use crate::common::{at_arc, material, touching};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact::{ContactLoad, ContactOperator, ContactSolution, Motion, Pair};
use hpfem::{
    Body, BodyProblem, Constants, Corner, Direction, Face, InterfaceOperator, Kinematics, Mesh, RigidEdge, Sector, Side,
    SlidingEdge, sliding_edge,
};

const YOUNG: f64 = 1000.0;
const POISSON: f64 = 0.3;

/// A block above a rigid flat, in contact with it between two places; its top is a rigid edge that only moves up and down.
fn block(problem: BodyProblem) -> InterfaceOperator {
    let top = RigidEdge { boundary: "top".into(), reference: [0.0; 2], free: [false, true, false] };
    Body::new(BodyProblem { rigid_edge: Some(top), ..problem }).unwrap().interface
}

fn refined(mesh: &Mesh, x: &[f64], layers: usize) -> Mesh {
    let at: Vec<usize> = x.iter().map(|x| mesh.nearest_vertex([*x, 0.0])).collect();
    mesh.refined_towards(&at, 0.15, layers).unwrap()
}

fn pressed(body: &InterfaceOperator, approach: f64, friction: f64) -> (Vec<f64>, ContactSolution) {
    let pair = Pair::new(body, None).unwrap();
    let operator = ContactOperator::new(&pair, friction > 0.0).unwrap();
    let n = operator.points().len();
    let mut load = ContactLoad::factors(&[], &[]).sliding(friction, vec![1.0; n]);
    load.motions[1] = Motion::Prescribed { value: -approach };
    let solution = operator.solve(&vec![0.0; n], &load, None).unwrap();
    assert!(solution.status.is_solved());
    let last = operator.points()[n - 1].arc;
    // Pressure at distances from the start, then from the end.
    let distances = (0..41).map(|i| 1e-5 * 1e3_f64.powf(f64::from(i) / 40.0));
    let arcs: Vec<f64> = distances.clone().chain(distances.map(|d| last - d)).collect();
    (arcs.iter().map(|arc| at_arc(&operator, &solution.pressure, *arc)).collect(), solution)
}

/// Slope of `ln p` over `ln d` between 1e-5 and 1e-2 times the unit length.
fn slope(pressure: &[f64]) -> f64 {
    let mid = 0.5 * (pressure.len() - 1) as f64;
    let step = 1e3_f64.ln() / (pressure.len() - 1) as f64;
    let sums = pressure.iter().enumerate().fold([0.0; 2], |[top, bottom], (i, p)| {
        let x = (i as f64 - mid) * step;
        [top + x * p.ln(), bottom + x * x]
    });
    sums[0] / sums[1]
}

/// `P / (2 E* b delta)` of a rigid annulus `inner <= r <= 1` on a cylinder of radius and height `size`.
///
/// ```text
///      clamped            half-space values, from an independent solution of the integral equation:
///   +-----------+         inner / b   1/6        1/4        1/2        3/4
///   |           | size               .99936737  .99783289  .98101790  .92126984
///   +--aaa------+
/// ```
fn annulus_stiffness(inner: f64, size: f64, degree: usize, layers: usize) -> f64 {
    let mut r = vec![0.0, inner, 0.5 * (1.0 + inner), 1.0];
    let mut z = vec![0.0, 0.5 * (1.0 - inner)];
    for (list, first) in [(&mut r, 1.5), (&mut z, 1.0)] {
        let count = (size / first).log(2.2).ceil();
        list.extend((0..=count as usize).map(|i| first * (size / first).powf(i as f64 / count)));
    }
    let mesh = refined(&rectangle(&r, &z, Side::Bottom, [inner, 1.0]), &[inner, 1.0], layers);
    let body = block(
        touching(mesh, [degree, layers], Kinematics::Axisymmetric, material(YOUNG, POISSON)).hold("left", Direction::First),
    );
    let approach = 1e-3;
    let (_, solution) = pressed(&body, approach, 0.0);
    solution.force[1] / (2.0 * YOUNG / (1.0 - POISSON * POISSON) * approach)
}

#[test]
fn rigid_annular_punch_has_the_half_space_stiffness() {
    for (inner, reference) in [(1.0 / 6.0, 0.99936737), (0.25, 0.99783289), (0.5, 0.98101790), (0.75, 0.92126984)] {
        // The error of a finite body is c / L and smaller by powers of 1 / L^2.
        let [near, far] = [1e3, 2e3].map(|size| annulus_stiffness(inner, size, 10, 10));
        let half_space = 2.0 * far - near;
        println!("{inner:.4}: {near:.8} {far:.8} -> {half_space:.8}, {:.1e}", half_space / reference - 1.0);
        assert_relative_eq!(half_space, reference, max_relative = 1e-5);
    }
}

#[test]
fn edges_of_a_sliding_rigid_punch_have_the_exponents_of_theory() {
    // Elastic body over a rigid flat of width 2: -1/2 -+ g, tan(pi g) = mu (1 - 2 nu) / (2 (1 - nu)).
    let x = [-10.0, -4.0, -1.0, 0.0, 1.0, 4.0, 10.0];
    let mesh = refined(&rectangle(&x, &[0.0, 1.0, 4.0, 10.0], Side::Bottom, [-1.0, 1.0]), &[-1.0, 1.0], 12);
    let body = block(touching(mesh, [14, 12], Kinematics::PlaneStrain { thickness: 1.0 }, material(YOUNG, POISSON)));
    let friction = 0.25;
    let (pressure, _) = pressed(&body, 1e-3, friction);
    let g = (friction * (1.0 - 2.0 * POISSON) / (2.0 * (1.0 - POISSON))).atan() / std::f64::consts::PI;
    assert_abs_diff_eq!(g, 0.022698, epsilon = 1e-6);
    let (start, end) = (slope(&pressure[..41]), slope(&pressure[41..]));
    println!("{start:.6} {end:.6}, theory -0.5 -+ {g:.6}");
    assert_abs_diff_eq!(start + end, -1.0, epsilon = 1e-3);
    assert_abs_diff_eq!((start - end).abs(), 2.0 * g, epsilon = 1e-3);
}

#[test]
fn right_angled_edge_on_a_plane_of_its_own_kind_has_the_exponent_of_theory() {
    let punch = Punch::translating(14, 12, [false, true, false]);
    let (body, plate) = punch.bodies();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let operator = ContactOperator::new(&pair, false).unwrap();
    let n = operator.points().len();
    let mut load = ContactLoad::factors(&[], &[]);
    load.motions[1] = Motion::Free { resultant: -1000.0 };
    let solution = operator.solve(&vec![0.0; n], &load, None).unwrap();
    let distances = (0..41).map(|i| 1e-5 * 1e3_f64.powf(f64::from(i) / 40.0));
    let pressure: Vec<f64> = distances.map(|d| at_arc(&operator, &solution.pressure, d)).collect();
    println!("{:.6}", slope(&pressure));
    assert_relative_eq!(slope(&pressure), -0.225987, max_relative = 5e-3);
}

#[test]
fn sharp_edges_of_a_sliding_elastic_punch_have_the_exponents_of_the_characteristic_equation() {
    let punch = Punch::translating(14, 12, [false, true, false]);
    let (body, plate) = punch.bodies();
    let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let n = operator.points().len();
    let last = operator.points()[n - 1].arc;
    let constants = Constants::of(&punch.materials, punch.kinematics).unwrap()[0];
    let wedge = |angle: f64| Corner { sectors: vec![Sector { angle: angle.to_radians(), constants }], faces: [Face::Free; 2] };
    for friction in [0.1, 0.25, 0.5, 1.0] {
        let mut load = ContactLoad::factors(&[], &[]).sliding(friction, vec![1.0; n]);
        load.motions[1] = Motion::Free { resultant: -1000.0 };
        let solution = operator.solve(&vec![0.0; n], &load, None).unwrap();
        let distances = (0..41).map(|i| 1e-5 * 1e3_f64.powf(f64::from(i) / 40.0));
        // Body 2 drags the punch towards +x: into the contact at its start.
        for (mu, at_start) in [(friction, true), (-friction, false)] {
            let found = sliding_edge(&wedge(90.0), &wedge(180.0), mu, punch.kinematics).unwrap();
            let pressure: Vec<f64> =
                distances.clone().map(|d| at_arc(&operator, &solution.pressure, if at_start { d } else { last - d })).collect();
            match found {
                SlidingEdge::Singular { lambda } => {
                    println!("mu {mu}: {:.6}, theory {:.6}", slope(&pressure), lambda - 1.0);
                    // Next to lambda = 1 the regular part of the pressure is as large as the singular one, and a slope is no exponent.
                    assert_abs_diff_eq!(slope(&pressure), lambda - 1.0, epsilon = if lambda < 0.9 { 5e-4 } else { 1e-2 });
                }
                // The other edge lifts.
                other => assert!(other == SlidingEdge::Bounded && !solution.closed[n - 1]),
            }
        }
    }
}
