//! Graphs and profiles laid on edges: geometry to their order, and a body that solves on them.

use crate::common::*;
use crate::exact::Exact;
use approx::assert_abs_diff_eq;
use hpfem::*;

fn places() -> impl Iterator<Item = f64> {
    (0..=40).map(|i| 0.05 * f64::from(i) - 1.0)
}

#[test]
fn a_graph_keeps_its_abscissa_and_its_pieces_gain_the_ninth_power_of_their_width() {
    let z = |x: f64| (2.0 * x).sin() + 0.3 * x * x;
    let error = |pieces: usize| {
        let cut = |i: usize| 0.2 + 1.6 * i as f64 / pieces as f64;
        let curves = (0..pieces).map(|i| Curve::graph(cut(i), cut(i + 1), z));
        curves.flat_map(|c| places().map(move |t| c.point(t))).map(|x| (x[1] - z(x[0])).abs()).fold(0.0, f64::max)
    };
    assert!((error(2) / error(4)).log2() > 8.5, "{:.1e} {:.1e}", error(2), error(4));
    // Polynomials up to the degree of the curve are met to round-off, walked either way.
    for (from, to) in [(-0.5, 2.0), (2.0, -0.5)] {
        let curve = Curve::graph(from, to, |x| x.powi(8) - 3.0 * x);
        for t in places() {
            let x = curve.point(t);
            assert_abs_diff_eq!(x[0], 0.5 * ((1.0 - t) * from + (1.0 + t) * to), epsilon = 1e-13);
            assert_abs_diff_eq!(x[1], x[0].powi(8) - 3.0 * x[0], epsilon = 1e-11);
        }
    }
}

#[test]
fn a_profile_lies_on_the_left_of_the_walk_at_its_distance() {
    let arc = Curve::Arc { centre: [1.0, -2.0], radius: 3.0, from: 0.4, to: 1.3 };
    // Anti-clockwise around the centre the left is towards the centre.
    let worn = arc.with_profile(|_| 0.25);
    let back = arc.reversed().with_profile(|_| 0.25);
    for t in places() {
        let radius = |x: [f64; 2]| (x[0] - 1.0).hypot(x[1] + 2.0);
        assert_abs_diff_eq!(radius(worn.point(t)), 2.75, epsilon = 1e-11);
        assert_abs_diff_eq!(radius(back.point(t)), 3.25, epsilon = 1e-11);
    }
    // On a line a profile is a graph; its error is at most 0.1 * 1.5^9 / 9! times the greatest value 0.0065
    // of the product of (t - t_i) over the nine Gauss-Lobatto points.
    let line = Curve::Line { start: [0.0, 1.0], end: [2.0, 1.0] }.with_profile(|x| 0.1 * (1.5 * x[0]).cos());
    for t in places() {
        let x = line.point(t);
        assert_abs_diff_eq!(x[1], 1.0 + 0.1 * (1.5 * x[0]).cos(), epsilon = 7e-8);
    }
}

#[test]
fn a_body_with_a_profile_laid_on_its_boundary_converges_exponentially() {
    let exact = Exact { kinematics: PLANE_STRAIN, material: Material::isotropic(1.7, 0.28).unwrap() };
    let materials = [exact.material];
    let top = Curve::Arc { centre: [2.0, -1.0], radius: 3.0, from: 1.9, to: 1.2 }.with_profile(|x| 0.05 * (3.0 * x[0]).sin());
    let bottom = Curve::graph(1.0, 3.0, |x| -0.2 * (x - 2.2).powi(3));
    let names = [Side::Bottom, Side::Right, Side::Top, Side::Left].map(|side| Named { side, range: None, name: "all" });
    let right = [Named { side: Side::Right, range: None, name: "right" }];
    let names = [&names[..], &right].concat();
    let (breaks, levels) = ([-1.0, 0.2, 1.0], [0.0, 1.0]);
    let mesh = Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &levels, closed: false, material: 0, names: &names });
    let mesh = mesh.unwrap();
    let load = [vec![traction("all", move |p| exact.traction(p))]];
    let errors = [3, 6, 9, 12, 15].map(|p| {
        let body = Body::new(problem(&mesh, p, PLANE_STRAIN, &materials, &[], &load, Some("right"))).unwrap();
        stress_error(&body.field(&solved(&body, &[1.0])).unwrap(), &mesh, |x| exact.stress(x))
    });
    assert!(errors[4] < 1e-7, "{errors:?}");
    assert!((errors[0] / errors[4]).ln() / 12.0 > 2.5_f64.ln(), "{errors:?}");
}

#[test]
fn the_trunk_space_of_curved_mixed_cells_holds_fewer_unknowns_and_still_converges() {
    let exact = Exact { kinematics: PLANE_STRAIN, material: Material::isotropic(1.7, 0.28).unwrap() };
    let materials = [exact.material];
    let mesh = mixed(TURNS[6], Shape::Arcs, 0.0);
    let load = [vec![traction("all", move |p| exact.traction(p))]];
    let solve = |space, p: usize| {
        let problem = BodyProblem { space, ..problem(&mesh, p, PLANE_STRAIN, &materials, &[], &load, Some("right")) };
        let body = Body::new(problem).unwrap();
        let error = stress_error(&body.field(&solved(&body, &[1.0])).unwrap(), &mesh, |x| exact.stress(x));
        (error, body.effort.unknowns)
    };
    let errors = [4, 8, 12, 16].map(|p| solve(SpaceKind::Trunk, p).0);
    assert!(errors[3] < 1e-5 && errors.windows(2).all(|e| e[1] < 0.1 * e[0]), "{errors:?}");
    // Two quadrilaterals lose (p - 1)^2 - (p - 2)(p - 3) / 2 modes of two components each; triangles lose none.
    assert_eq!(solve(SpaceKind::Tensor, 8).1 - solve(SpaceKind::Trunk, 8).1, 2 * 2 * (49 - 15));
}

#[test]
fn a_curve_goes_through_two_points_at_least_and_nine_at_most() {
    let points: Vec<[f64; 2]> = (0..10).map(|i| [f64::from(i), f64::from(i * i)]).collect();
    for n in [0, 1, 10] {
        let error = Curve::through(&points[..n]).unwrap_err();
        assert!(matches!(error, Error::Count { given, .. } if given == n), "{error}");
    }
    // As splines, none goes through one place twice in a row.
    for again in [&[points[1]; 2][..], &[points[0], points[1], points[1]]] {
        let error = Curve::through(again).unwrap_err();
        assert!(matches!(error, Error::OutOfRange { value: 0.0, .. }) && error.to_string().contains("at (1, 1)"), "{error}");
    }
    assert_eq!(Curve::through(&points[..2]), Ok(Curve::Line { start: points[0], end: points[1] }));
    for n in 3..=9 {
        let end = Curve::through(&points[..n]).unwrap().point(1.0);
        assert_abs_diff_eq!(end[1], points[n - 1][1], epsilon = 1e-12);
    }
}

/// 24 Gauss points were off by 2.6e-5 on the graph of Runge's function, whose speed is not smooth.
#[test]
fn lengths_of_curves_are_exact_to_round_off_and_places_by_length_go_back_and_forth() {
    let runge = Curve::graph(-1.0, 1.0, |x| 1.0 / (1.0 + 4.0 * x * x));
    let cusp = Curve::interpolated(3, |t| [t * t, t * t * t]);
    for (curve, near) in [(runge, 1e-12), (cusp, 1e-8)] {
        let pieces = 4096;
        let place = |i: usize| 2.0 * i as f64 / pieces as f64 - 1.0;
        let rule = gauss(6);
        let speed = |t: f64| curve.derivative(t)[0].hypot(curve.derivative(t)[1]);
        let piece = |i: usize| {
            let (low, half) = (place(i), 1.0 / pieces as f64);
            half * rule.points.iter().zip(&rule.weights).map(|(s, w)| w * speed(low + half * (1.0 + s))).sum::<f64>()
        };
        let wanted: f64 = (0..pieces).map(piece).sum();
        assert!((curve.length() / wanted - 1.0).abs() < near, "{} {wanted}", curve.length());
        for share in [0.1, 0.45, 0.8] {
            let t = curve.parameter_at_length(share * wanted);
            assert!((curve.length_until(t) / wanted - share).abs() < near, "{share}");
        }
    }
}
