//! Two bodies on one arc, one with the angle and one with x as edge parameter: what happens to the pressure if points of equal parameter are
//! taken for the same place, or if points of one body press on the other one by one.
//!
//! A ring segment (body 1) on a full block of the same arc, radius 2, half angle 30 degrees, pressed by 1 MPa on the outside.

use crate::common::material;
use contact::{ContactLoad, ContactOperator, Pair, Side as Body12};
use faer::Mat;
use faer::linalg::solvers::Solve;
use hpfem::{Body, BodyProblem, BoundaryPoint, Curve, EdgeTraction, InterfaceOperator, Kinematics, Mesh, Named, Ruled, Side};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};

const RADIUS: f64 = 2.0;

fn arc(radius: f64) -> Curve {
    Curve::Arc { centre: [0.0; 2], radius, from: FRAC_PI_2 + FRAC_PI_6, to: FRAC_PI_2 - FRAC_PI_6 }
}

fn graph() -> Curve {
    Curve::graph(-1.0, 1.0, |x| (RADIUS * RADIUS - x * x).sqrt())
}

fn reduce(mesh: Mesh, degree: usize, complete: impl Fn(BodyProblem) -> BodyProblem) -> InterfaceOperator {
    let kinematics = Kinematics::PlaneStrain { thickness: 1.0 };
    let problem = BodyProblem::new(mesh, degree, kinematics).material(material(1000.0, 0.3)).keep("cut");
    Body::new(complete(problem).roller("left").roller("right")).unwrap().interface
}

/// Ring segment above, ring segment below with radial sides: under a uniform pressure outside all stays uniform along the arc.
fn bodies(lower_cut: Curve, lower_breaks: &[f64], degree: usize) -> [InterfaceOperator; 2] {
    let name = |side, name| Named { side, range: None, name };
    let ring = |bottom, top, breaks: &[f64], cut, far| {
        Mesh::ruled(&Ruled {
            bottom,
            top,
            breaks,
            levels: &[0.0, 1.0],
            closed: false,
            material: 0,
            names: &[name(cut, "cut"), name(far, "far"), name(Side::Left, "left"), name(Side::Right, "right")],
        })
        .unwrap()
    };
    let upper = ring(arc(RADIUS), arc(3.0), &[-1.0, -0.5, 0.0, 0.5, 1.0], Side::Bottom, Side::Top);
    let lower = ring(arc(1.0), lower_cut, lower_breaks, Side::Top, Side::Bottom);
    let press = EdgeTraction::new("far", |p: &BoundaryPoint| p.outward.map(|n| -n));
    [
        reduce(upper, degree, |problem| problem.load("pressure", press.clone())),
        reduce(lower, degree, |problem| problem.clamp("far")),
    ]
}

/// Pressure at the points of body 1 from one-pass collocation: every point presses on the given place of body 2, where the displacement is compared.
/// Also the resultant that is left over, per force.
fn collocated(bodies: &[InterfaceOperator; 2], places: &[(usize, f64)]) -> (Vec<f64>, f64) {
    let pair = Pair::new(&bodies[0], None).unwrap();
    let points = pair.points();
    let n = points.len();
    let rows = |body: &InterfaceOperator, place: &dyn Fn(usize) -> (usize, f64)| {
        let mut matrix = Mat::<f64>::zeros(n, body.stiffness.nrows());
        for (i, point) in points.iter().enumerate() {
            let (row, _) = body.trace.displacement_row(place(i).0, place(i).1);
            for (entries, d) in row.iter().zip(point.normal) {
                entries.iter().for_each(|(u, c)| matrix[(i, *u)] += d * c);
            }
        }
        matrix
    };
    let upper = rows(&bodies[0], &|i| points[i].place);
    let lower = rows(&bodies[1], &|i| places[i]);
    let solve = |body: &InterfaceOperator, right: &Mat<f64>| body.solve(right, &body.rigid_modes);
    let compliance =
        &upper * solve(&bodies[0], &upper.transpose().to_owned()) + &lower * solve(&bodies[1], &lower.transpose().to_owned());
    let loaded = bodies[0].columns.submatrix(0, 0, bodies[0].stiffness.nrows(), 1).to_owned();
    let modes = &bodies[0].rigid_modes;
    assert_eq!(modes.ncols(), 0);
    let opening = &upper * solve(&bodies[0], &loaded);
    let force = compliance.partial_piv_lu().solve(Mat::from_fn(n, 1, |i, _| -opening[(i, 0)]));
    // What body 1 and body 2 feel along z.
    let resultant = |body: usize| -> f64 {
        let mut load = hpfem::TraceLoad { unknowns: vec![0.0; bodies[body].stiffness.nrows()], ..Default::default() };
        let sign = [1.0, -1.0][body];
        for (i, point) in points.iter().enumerate() {
            let place = if body == 0 { point.place } else { places[i] };
            bodies[body].trace.add_force(&mut load, place, point.normal.map(|v| sign * v * force[(i, 0)]));
        }
        load.resultant[1]
    };
    let left = ((resultant(0) + resultant(1)) / resultant(0)).abs();
    ((0..n).map(|i| force[(i, 0)] / points[i].weight).collect(), left)
}

/// Largest deviation from the mean, relative.
fn ripple(pressure: &[f64]) -> f64 {
    let mean = pressure.iter().sum::<f64>() / pressure.len() as f64;
    pressure.iter().map(|p| (p / mean - 1.0).abs()).fold(0.0, f64::max)
}

fn solved(bodies: &[InterfaceOperator; 2]) -> (Vec<f64>, bool) {
    let pair = Pair::new(&bodies[0], Some(&bodies[1])).unwrap();
    let operator = ContactOperator::new(&pair, false).unwrap();
    let gap = vec![0.0; operator.points().len()];
    (operator.solve(&gap, &ContactLoad::factors(&[1.0], &[]), None).unwrap().pressure, pair.is_nodal())
}

#[test]
fn points_of_equal_parameter_on_two_parametrisations_ripple_the_pressure_and_segments_do_not() {
    let breaks = [-1.0, -0.5, 0.0, 0.5, 1.0];
    let common = bodies(arc(RADIUS), &breaks, 8);
    let (pressure, nodal) = solved(&common);
    assert!(nodal);
    println!("nodal {:.1e}", ripple(&pressure));
    assert!(ripple(&pressure) < 1e-9);
    // Break points at the same places, x instead of the angle in between.
    let x = breaks.map(|t| 2.0 * (FRAC_PI_6 * t).sin());
    let mixed = bodies(graph(), &x, 8);
    let trapped: Vec<(usize, f64)> = Pair::new(&mixed[0], None).unwrap().points().iter().map(|p| p.place).collect();
    let (pressure, left) = collocated(&mixed, &trapped);
    println!("equal parameters {:.1e}, force left over {left:.1e}", ripple(&pressure));
    assert!(ripple(&pressure) > 5e-3 && left < 1e-13);
    let (pressure, nodal) = solved(&mixed);
    println!("segments {:.1e}", ripple(&pressure));
    // The polynomial of degree 8 in x is not quite the arc.
    assert!(!nodal && ripple(&pressure) < 1e-5);
}

#[test]
fn one_pass_collocation_of_unmatched_points_fails_the_patch_test_that_segments_pass() {
    let apart = bodies(arc(RADIUS), &[-1.0, -0.7, 0.1, 0.4, 1.0], 8);
    let pair = Pair::new(&apart[0], Some(&apart[1])).unwrap();
    let places: Vec<(usize, f64)> =
        Pair::new(&apart[0], None).unwrap().points().iter().map(|p| pair.place(Body12::Counter, p)).collect();
    let (pressure, left) = collocated(&apart, &places);
    println!("collocation {:.1e}, force left over {left:.1e}", ripple(&pressure));
    assert!(ripple(&pressure) > 1e-2 && left < 1e-13);
    let (pressure, _) = solved(&apart);
    println!("segments {:.1e}", ripple(&pressure));
    assert!(ripple(&pressure) < 1e-8);
}
