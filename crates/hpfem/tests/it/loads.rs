//! Loads on parts of boundaries, displacements that vary along supports, layers along boundaries, splines.

use crate::common::*;
use crate::exact::Exact;
use approx::assert_abs_diff_eq;
use hpfem::*;

fn clamp() -> [Support; 2] {
    [support("left", Direction::First), support("left", Direction::Second)]
}

/// Resultant and moment about the origin of a traction between two arc lengths of the boundary "right", by quadrature of its own.
fn resultant(body: &Body, range: [f64; 2], traction: impl Fn(&BoundaryPoint) -> [f64; 2]) -> [f64; 3] {
    let trace = &body.interface.trace;
    let rule = gauss(40);
    let mut sum = [0.0; 3];
    for (number, edge) in trace.edges.iter().enumerate() {
        let [a, b] = range.map(|s| edge.curve.parameter_at_length((s - edge.start).clamp(0.0, edge.curve.length())));
        for (s, w) in rule.points.iter().zip(&rule.weights) {
            let (p, length) = trace.boundary_point(number, 0.5 * ((1.0 - s) * a + (1.0 + s) * b));
            let f = traction(&p).map(|f| 0.5 * (b - a) * w * length * f * body.interface.kinematics.measure(p.position[0]));
            [f[0], f[1], p.position[0] * f[1] - p.position[1] * f[0]].iter().zip(&mut sum).for_each(|(f, s)| *s += f);
        }
    }
    sum
}

#[test]
fn a_traction_on_a_part_of_a_boundary_has_its_resultant_to_round_off_wherever_the_part_ends() {
    let materials = steel();
    let pull = |p: &BoundaryPoint| [3.0 - p.position[1], -7.0 * p.outward[0] + 0.4 * p.position[0]];
    for turns in TURNS {
        for mesh in [patch(turns, Shape::Arcs, 0.0), mixed(turns, Shape::Arcs, 0.0), patch(turns, Shape::Polynomial(3), 0.0)] {
            for kinematics in [PLANE_STRAIN, Kinematics::Axisymmetric] {
                // From the middle of the first edge of two into the second one; beyond the end the path is cut off.
                for range in [[0.31, 1.47], [-1.0, 0.2], [1.9, 50.0]] {
                    let cases = [vec![traction("right", pull).within(range)]];
                    let body = Body::new(problem(&mesh, 7, kinematics, &materials, &clamp(), &cases, Some("right"))).unwrap();
                    let state = solved(&body, &[1.0]);
                    let wanted = resultant(&body, range, pull);
                    for k in 0..if kinematics.is_revolved() { 0 } else { 3 } {
                        let reaction: f64 = (0..2).map(|s| body.interface.reaction(s, &state)[k]).sum();
                        assert!((reaction + wanted[k]).abs() < 1e-9, "{turns:?} {range:?}: {reaction} {wanted:?}");
                    }
                    let axial = body.interface.reaction(1, &state)[1];
                    assert!((axial + wanted[1]).abs() < 1e-8, "{turns:?} {range:?}: {axial} {wanted:?}");
                }
            }
        }
    }
}

#[test]
fn the_whole_boundary_as_a_part_is_the_load_on_the_boundary() {
    let materials = steel();
    let mesh = mixed(TURNS[6], Shape::Arcs, 0.0);
    let (supports, pull) = (clamp(), |p: &BoundaryPoint| [p.position[1].sin(), p.position[0]]);
    let whole = [vec![traction("top", pull)]];
    let one = Body::new(problem(&mesh, 6, PLANE_STRESS, &materials, &supports, &whole, Some("right"))).unwrap();
    let part = [vec![traction("top", pull).within([0.0, 9.0])]];
    let two = Body::new(problem(&mesh, 6, PLANE_STRESS, &materials, &supports, &part, Some("right"))).unwrap();
    let difference = (&one.interface.columns - &two.interface.columns).norm_max();
    assert!(difference < 1e-13 * one.interface.columns.norm_max(), "{difference:.1e}");
}

#[test]
fn displacements_that_vary_along_a_support_converge_exponentially_to_an_exact_solution() {
    for kinematics in [PLANE_STRESS, PLANE_STRAIN, Kinematics::Axisymmetric, Kinematics::Torsion] {
        let exact = Exact { kinematics, material: Material::isotropic(1.7, 0.28).unwrap() };
        let materials = [exact.material];
        for mesh in [patch(TURNS[6], Shape::Arcs, 0.0), mixed(TURNS[4], Shape::Arcs, 0.0)] {
            // Prescribed left and top, so that a corner belongs to two; loaded elsewhere. The constant part of the support counts too.
            let errors = [2, 4, 6, 8, 10, 12].map(|p| {
                let moved = |boundary, (component, direction)| {
                    Support::moved(boundary, direction, 0.3).varying(move |x| exact.displacement(x)[component] - 0.3)
                };
                let directions = [(0, Direction::First), (1, Direction::Second)];
                let supports: Vec<Support> = ["left", "top"]
                    .iter()
                    .flat_map(|b| directions.map(|d| moved(b, d)))
                    .take(if kinematics == Kinematics::Torsion { 1 } else { 4 })
                    .collect();
                let pull = |b: &str| traction(b, move |p| exact.traction(p));
                let mut load = vec![pull("right"), pull("bottom")];
                if kinematics == Kinematics::Torsion {
                    load.push(pull("top"));
                }
                let cases = [load];
                let body = Body::new(problem(&mesh, p, kinematics, &materials, &supports, &cases, Some("right"))).unwrap();
                stress_error(&body.field(&solved(&body, &[1.0])).unwrap(), &mesh, |x| exact.stress(x))
            });
            assert!(errors[5] < 2e-7, "{kinematics:?}: {errors:?}");
            assert!((errors[0] / errors[5]).ln() / 10.0 > 2.5_f64.ln(), "{kinematics:?}: {errors:?}");
        }
    }
}

#[test]
fn a_rotation_prescribed_along_supports_turns_the_body_without_stress() {
    // A rotation about (0.4, -0.3) on three boundaries: the rotation everywhere, and no reaction.
    let mesh = patch(TURNS[5], Shape::Straight, 0.0);
    let materials = steel();
    let turn = |x: [f64; 2]| [-1e-3 * (x[1] + 0.3), 1e-3 * (x[0] - 0.4)];
    let moved = |boundary, direction, component: usize| Support::hold(boundary, direction).varying(move |x| turn(x)[component]);
    let mut supports = ["bottom", "right", "left"].map(|name| moved(name, Direction::First, 0)).to_vec();
    supports.push(moved("bottom", Direction::Second, 1));
    let cases = [vec![]];
    let body = Body::new(problem(&mesh, 3, PLANE_STRAIN, &materials, &supports, &cases, None)).unwrap();
    let field = body.field(&solved(&body, &[1.0])).unwrap();
    for (cell, (xi, eta)) in (0..4).flat_map(|c| sample_points().map(move |x| (c, x))) {
        let (u, wanted) = (field.at(cell, xi, eta).unwrap().displacement, turn(field.position(cell, xi, eta)));
        assert_abs_diff_eq!(u[0], wanted[0], epsilon = 1e-14);
        assert_abs_diff_eq!(u[1], wanted[1], epsilon = 1e-14);
    }
    assert!(body.interface.reaction(0, &solved(&body, &[1.0])).iter().all(|r| r.abs() < 1e-8));
}

#[test]
fn parts_and_displacements_that_cannot_be_are_refused() {
    let mesh = patch([0; 4], Shape::Straight, 0.0);
    let held = || problem(&mesh, 2, PLANE_STRAIN, &steel(), &clamp(), &[], None);
    let refused = |problem| Body::new(problem).err().unwrap().to_string();
    let part = |boundary, range| held().load("0", traction(boundary, |_| [0.0; 2]).within(range));
    assert!(refused(part("lid", [0.0, 1.0])).contains("\"lid\""));
    assert!(refused(part("top", [1.0, 0.5])).contains("\"top\""));
    for beyond in [[50.0, 70.0], [-2.0, -1.0]] {
        assert!(refused(part("top", beyond)).contains("the start of a loaded part of \"top\""));
    }
    let moved = |boundary, value| held().support(Support::hold(boundary, Direction::First).varying(move |_| value));
    assert!(refused(moved("lid", 0.0)).contains("\"lid\""));
    assert!(refused(moved("left", f64::NAN)).contains("\"left\""));
    // Next to the clamp, another value along the same direction.
    assert!(matches!(Body::new(moved("left", 0.1)), Err(Error::HeldTwice { .. })));
}

#[test]
fn layers_along_a_boundary_are_geometric_keep_arcs_exact_and_leave_constant_stress_exact() {
    let materials = steel();
    // All around, corners included; a part of the boundary, so that layers end; beside triangles.
    let (quads, mixed) = (patch(TURNS[6], Shape::Straight, 0.0), mixed(TURNS[5], Shape::Straight, 0.0));
    for (mesh, names) in [(quads.refined().unwrap(), ["all", "right"]), (mixed.clone(), ["right", "left"])] {
        for name in names {
            let graded = mesh.refined_towards_edges(name, 0.2, 3).unwrap();
            assert!(graded.cells.len() > mesh.cells.len());
            let load = [vec![traction("all", |p| [p.outward[0], 0.5 * p.outward[1]])]];
            let body = Body::new(problem(&graded, 2, PLANE_STRESS, &materials, &[], &load, Some("top"))).unwrap();
            let error = stress_error(&body.field(&solved(&body, &[1.0])).unwrap(), &graded, |_| [1.0, 0.5, 0.0, 0.0]);
            assert!(error < 1e-9, "{name}: {error:.1e}");
        }
    }
    let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: 0.0, to: 1.2 };
    let names = [Named { side: Side::Top, range: None, name: "bore" }, Named { side: Side::Bottom, range: None, name: "rim" }];
    let (breaks, levels) = ([-1.0, 0.1, 1.0], [0.0, 1.0]);
    let (bottom, top) = (arc(2.0), arc(1.0));
    let ring = Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &levels, closed: false, material: 0, names: &names });
    let graded = ring.unwrap().refined_towards_edges("bore", 0.1, 4).unwrap();
    assert_eq!(graded.cells.len(), 2 * 5);
    let radii: Vec<f64> = graded.vertices.iter().map(|x| x[0].hypot(x[1]) - 1.0).filter(|r| *r > 1e-12).collect();
    assert_abs_diff_eq!(radii.iter().fold(1.0, |m: f64, r| m.min(*r)), 1e-4, epsilon = 1e-14);
    assert!(graded.edges.iter().all(|e| !matches!(e.curve, Curve::Polynomial { .. })));
    // Corners on curved boundaries are cut without folding; a triangle between two such edges cannot be.
    let curved = patch(TURNS[4], Shape::Arcs, 0.0).refined().unwrap();
    assert_eq!(curved.refined_towards_edges("all", 0.3, 1).unwrap().cells.len(), 16 + 8 + 4 * 2);
    assert!(matches!(mixed.refined_towards_edges("all", 0.3, 1), Err(Error::BetweenGradedEdges { .. })));
    let narrow = patch([0; 4], Shape::Straight, 0.0).refined_towards_edges("left", 1.2, 1).unwrap_err();
    assert!(matches!(narrow, Error::OutOfRange { .. }), "{narrow}");
    let single = crate::classics::rectangle([0.0, 1.0], [0.0, 1.0]);
    let all: Vec<_> = single.edges.iter().map(|e| (e.vertices, "all")).collect();
    let quads: Vec<Quad> = single.cells.iter().map(|c| Quad { corners: c.corners, material: 0, layer: 0 }).collect();
    let single = Mesh::new(single.vertices.clone(), &quads, &[], &all).unwrap();
    let between = single.refined_towards_edges("all", 0.2, 1).unwrap_err();
    assert!(matches!(between, Error::BetweenGradedEdges { cell: 0, .. }), "{between}");
}

#[test]
fn a_spline_meets_its_points_bends_smoothly_and_gains_a_factor_of_sixteen_by_halving_its_steps() {
    let at = |s: f64| [2.0 * s + 0.1 * (3.0 * s).sin(), (1.7 * s).cos() * (1.0 + s)];
    let error = |n: usize| {
        let points: Vec<[f64; 2]> = (0..=n).map(|i| at(i as f64 / n as f64)).collect();
        let pieces = Curve::spline(&points).unwrap();
        assert_eq!(pieces.len(), n);
        for (piece, ends) in pieces.iter().zip(points.windows(2)) {
            for (t, x) in [(-1.0, ends[0]), (1.0, ends[1])] {
                let y = piece.point(t);
                assert!((x[0] - y[0]).hypot(x[1] - y[1]) < 1e-14);
            }
        }
        let chords: Vec<f64> = points.windows(2).map(|w| (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1])).collect();
        let bend = |curve: &Curve, t: f64, h: f64, i: usize| {
            let (a, b) = (curve.derivative(t + 1e-4)[i], curve.derivative(t - 1e-4)[i]);
            (a - b) / 2e-4 * 4.0 / (h * h)
        };
        for i in 0..n - 1 {
            for c in 0..2 {
                let slopes = [(i, 1.0), (i + 1, -1.0)].map(|(k, t)| 2.0 * pieces[k].derivative(t)[c] / chords[k]);
                assert_abs_diff_eq!(slopes[0], slopes[1], epsilon = 1e-11);
                let bends = [(i, 1.0), (i + 1, -1.0)].map(|(k, t)| bend(&pieces[k], t, chords[k], c));
                assert_abs_diff_eq!(bends[0], bends[1], epsilon = 1e-6);
            }
        }
        // Distance from the curve, along its normal, near the ends too.
        let distance = |x: [f64; 2]| {
            let mut s = 0.5 * x[0];
            for _ in 0..50 {
                s -= 0.5 * (at(s)[0] - x[0]);
            }
            (at(s)[1] - x[1]).abs()
        };
        pieces.iter().flat_map(|p| (0..=20).map(|i| distance(p.point(0.1 * f64::from(i) - 1.0)))).fold(0.0, f64::max)
    };
    let (coarse, fine) = (error(16), error(32));
    assert!((coarse / fine).log2() > 3.7, "{coarse:.1e} {fine:.1e}");
    // A parabola through three points, a line through two; nothing through one, or through a point twice.
    let three = Curve::spline(&[[0.0, 0.0], [1.0, 1.0], [2.0, 0.0]]).unwrap();
    assert_abs_diff_eq!(three[0].point(0.0)[1], 0.75, epsilon = 1e-14);
    assert!(Curve::spline(&[[0.0, 0.0], [1.0, 1.0]]).unwrap()[0].is_straight());
    assert!(matches!(Curve::spline(&[[0.0, 0.0]]), Err(Error::Count { .. })));
    assert!(matches!(Curve::spline(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0]]), Err(Error::OutOfRange { .. })));
}

#[test]
fn factors_of_one_case_add_up_to_a_number_or_are_refused() {
    let problem =
        BodyProblem::new(crate::classics::rectangle([0.0, 2.0], [0.0, 1.0]), 3, Kinematics::PlaneStrain { thickness: 1.0 });
    let problem = problem.material(Material::isotropic(1.0, 0.3).unwrap()).clamp("left");
    let body = Body::new(problem.load("a", EdgeTraction::pressure("right", |_| 1.0))).unwrap();
    assert!(matches!(body.solve(&[("a", 1e308), ("a", 1e308)]), Err(Error::OutOfRange { .. })));
    assert!(body.solve(&[("a", 1.0), ("a", 2.0)]).is_ok());
}
