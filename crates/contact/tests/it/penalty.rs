//! Why the points are those of Lobatto and the pressure a multiplier: the same meshes of the cylinder with a penalty at Gauss points.

use crate::hertz::{bodies, gap, hertz, positioned};
use contact::*;
use faer::Mat;
use faer::linalg::solvers::Solve;
use hpfem::{InterfaceOperator, barycentric_weights, gauss, lagrange};

const FORCE: f64 = 350.0;

/// Gauss points of the contact edges, one more than the degree an edge: contact point and weight.
fn gauss_points(pair: &Pair<'_>) -> Vec<(ContactPoint, f64)> {
    let edges = pair.trace().edges.iter();
    edges
        .flat_map(|edge| {
            let (length, rule) = (edge.curve.length(), gauss(edge.degree + 1));
            let place = move |(t, w): (&f64, &f64)| (edge.start + 0.5 * (1.0 + t) * length, 0.5 * w * length);
            rule.points.iter().zip(&rule.weights).map(place).collect::<Vec<_>>()
        })
        .map(|(arc, weight)| (pair.at_arc(arc), weight))
        .collect()
}

/// Displacements along z at the points as rows on the kept unknowns.
fn rows(body: &InterfaceOperator, pair: &Pair<'_>, side: Side, points: &[(ContactPoint, f64)]) -> Mat<f64> {
    let mut rows = Mat::zeros(points.len(), body.stiffness.nrows());
    for (g, (point, _)) in points.iter().enumerate() {
        let (edge, t) = pair.place(side, point);
        body.trace.displacement_row(edge, t).0[1].iter().for_each(|(u, c)| rows[(g, *u)] += c);
    }
    rows
}

/// Pressures `max(0, -stiffness * opening)` at the Gauss points: the closed points are iterated until they stay.
fn penalty(pair: &Pair<'_>, stiffness: f64) -> (Vec<(ContactPoint, f64)>, Vec<f64>) {
    let points = gauss_points(pair);
    let n = points.len();
    let counter = pair.counter.unwrap();
    let (one, two) = (rows(pair.shaped, pair, Side::Shaped, &points), rows(counter, pair, Side::Counter, &points));
    let response = |body: &InterfaceOperator, n: &Mat<f64>| n * body.solve(&n.transpose().to_owned(), &body.rigid_modes);
    let compliance = response(pair.shaped, &one) + response(counter, &two);
    let load = pair.shaped.columns.submatrix(0, 0, pair.shaped.stiffness.nrows(), 1).to_owned();
    let pressed = &one * pair.shaped.solve(&load, &pair.shaped.rigid_modes);
    let modes = &one * &pair.shaped.rigid_modes;
    let force: f64 = (0..load.nrows()).map(|i| pair.shaped.rigid_modes[(i, 0)] * load[(i, 0)]).sum();
    let mut closed: Vec<bool> = points.iter().map(|(p, _)| p.position[0] < 1.1 * hertz(FORCE).0).collect();
    for _ in 0..60 {
        let on: Vec<usize> = (0..n).filter(|i| closed[*i]).collect();
        let a = on.len();
        let matrix = Mat::from_fn(a + 1, a + 1, |i, j| match (i < a, j < a) {
            (true, true) => compliance[(on[i], on[j])] * points[on[j]].1 + if i == j { 1.0 / stiffness } else { 0.0 },
            (true, false) => modes[(on[i], 0)],
            (false, true) => modes[(on[j], 0)] * points[on[j]].1,
            (false, false) => 0.0,
        });
        let right = Mat::from_fn(a + 1, 1, |i, _| if i < a { -(gap(&points[on[i]].0) + pressed[(on[i], 0)]) } else { -force });
        let x = matrix.partial_piv_lu().solve(&right);
        let mut pressure = vec![0.0; n];
        on.iter().enumerate().for_each(|(k, i)| pressure[*i] = x[(k, 0)]);
        let opening = |i: usize| {
            let elastic: f64 = (0..n).map(|j| compliance[(i, j)] * points[j].1 * pressure[j]).sum();
            gap(&points[i].0) + pressed[(i, 0)] + elastic + modes[(i, 0)] * x[(a, 0)]
        };
        let next: Vec<bool> = (0..n).map(|i| if closed[i] { pressure[i] > 0.0 } else { opening(i) < 0.0 }).collect();
        if next == closed {
            return (points, pressure);
        }
        closed = next;
    }
    panic!("the closed points do not settle");
}

/// Total variation of the error over the inner 80 % of the contact, and its root mean square, over the highest pressure, at places close to each
/// other.
fn ripple(pressure: impl Fn(f64) -> f64, end: f64, highest: f64) -> [f64; 2] {
    let places = (0..800).map(|i| 0.8 * end * f64::from(i) / 800.0);
    let error: Vec<f64> = places.map(|x| pressure(x) / highest - (1.0 - (x / end).powi(2)).sqrt()).collect();
    let variation = error.windows(2).map(|w| (w[1] - w[0]).abs()).sum();
    [variation, (error.iter().map(|e| e * e).sum::<f64>() / error.len() as f64).sqrt()]
}

/// The polynomial through the Gauss points of the edge.
fn between(pair: &Pair<'_>, pressure: &[f64], arc: f64) -> f64 {
    let (edge, t) = pair.trace().locate(arc);
    let edges = &pair.trace().edges;
    let first: usize = edges[..edge].iter().map(|e| e.degree + 1).sum();
    let nodes = gauss(edges[edge].degree + 1).points;
    let shapes = lagrange(&nodes, &barycentric_weights(&nodes), t);
    shapes.iter().zip(&pressure[first..]).map(|(l, p)| l * p).sum()
}

#[test]
fn a_penalty_at_gauss_points_yields_or_ripples_and_a_multiplier_at_lobatto_points_does_neither() {
    let fine = positioned(14, 7, FORCE).0;
    let (end, highest) = (fine.ends[0], fine.solution.pressure[0]);
    let natural = 1.0 / (0.91 / 210e3 + 0.91 / 70e3) / end;
    for (node, layered) in [(1.0, true), (1.0, false), (0.8, false)] {
        for degree in [4, 8, 12] {
            let bodies = bodies(node * end, 1.6, degree, if layered { degree / 2 } else { 0 }, FORCE);
            let pair = bodies.pair().unwrap();
            let operator = ContactOperator::new(&pair, false).unwrap();
            let start: Vec<f64> = operator.points().iter().map(gap).collect();
            let solution = operator.solve(&start, &ContactLoad::factors(&[1.0], &[]), None).unwrap();
            let lobatto = ripple(|x| operator.value_at(&solution.pressure, x), end, highest);
            let penalties: Vec<[f64; 2]> = [1e1, 1e3, 1e5, 1e7, 1e9, 1e11]
                .iter()
                .map(|factor| {
                    let (_, pressure) = penalty(&pair, factor * natural);
                    ripple(|x| between(&pair, &pressure, x), end, highest)
                })
                .collect();
            let words = |[variation, rms]: &[f64; 2]| format!("{variation:.1e} ({rms:.1e})");
            println!("{node} {layered} {degree}: {} | {:?}", words(&lobatto), penalties.iter().map(words).collect::<Vec<_>>());
            let [soft, .., stiff] = penalties[..] else { unreachable!() };
            // Soft: the surfaces go through each other by a fortieth of the pressure at any degree.
            assert!(soft[1] > 0.02);
            if node < 1.0 {
                // Where contact ends inside a cell, and the stiffer it is: ripples that no degree takes away.
                assert!(penalties[2..].iter().all(|p| p[0] > 50.0 * lobatto[0] && p[0] > 0.7));
            } else if layered {
                assert!(stiff[0] > 20.0 * lobatto[0]);
            }
        }
    }
}
