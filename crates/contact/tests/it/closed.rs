//! Contact all around: boundaries that close, whose last edge ends at their first point.
//!
//! A disc of radius 2 held at its hub of radius 1, pressed into a ring of radii 2 and 3 by an interference `d`, plane strain (Lame): with `E' = E / (1 - nu^2)` and
//! `nu' = nu / (1 - nu)` the ring gives way by `c2 p`, `c2 = 2 (13/5 + nu') / E'`, and the disc, whose displacement is `A r + B / r` with `A = -B`, by `c1 p`.

use crate::common::material;
use contact::{ContactLoad, ContactOperator, Pair};
use hpfem::{Body, BodyProblem, Curve, InterfaceOperator, Kinematics, Mesh, Named, Ruled, Side};
use std::f64::consts::{PI, TAU};

const YOUNG: f64 = 210e3;
const NU: f64 = 0.3;
const INTERFERENCE: f64 = 1e-3;

/// A full ring, held at its hub or not.
fn ring([inner, outer]: [f64; 2], columns: u32, kept: &str, held: bool) -> InterfaceOperator {
    let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: 0.0, to: TAU };
    let breaks: Vec<f64> = (0..=columns).map(|i| f64::from(2 * i) / f64::from(columns) - 1.0).collect();
    let names = [(Side::Bottom, "outer"), (Side::Top, "inner")].map(|(side, name)| Named { side, range: None, name });
    let (bottom, top) = (arc(outer), arc(inner));
    let region = Ruled { bottom, top, breaks: &breaks, levels: &[0.0, 0.5, 1.0], closed: true, material: 0, names: &names };
    let problem = BodyProblem::new(Mesh::ruled(&region).unwrap(), 8, Kinematics::PlaneStrain { thickness: 1.0 });
    let problem = problem.material(material(YOUNG, NU)).keep(kept);
    Body::new(if held { problem.clamp("inner") } else { problem }).unwrap().interface
}

/// Radial displacement by unit pressure of the disc and of the ring.
fn compliances() -> [f64; 2] {
    let lame = YOUNG / ((1.0 + NU) * (1.0 - 2.0 * NU));
    // Displacement -1 at radius 2: A = -1 / (2 - 1/2).
    let a = -1.0 / 1.5;
    let pressure = -lame * ((1.0 - NU) * (a + a / 4.0) + NU * (a - a / 4.0));
    let (young, nu) = (YOUNG / (1.0 - NU * NU), NU / (1.0 - NU));
    [1.0 / pressure, 2.0 * (13.0 / 5.0 + nu) / young]
}

#[test]
fn a_shrink_fit_of_full_rings_has_the_pressure_of_lame_wherever_it_is_asked() {
    let disc = ring([1.0, 2.0], 8, "outer", true);
    let [like, unlike] = [8, 10].map(|columns| ring([2.0, 3.0], columns, "inner", false));
    assert!(disc.trace.closed && like.trace.closed);
    let [own, other] = compliances();
    for (counter, compliance) in [(None, own), (Some(&like), own + other), (Some(&unlike), own + other)] {
        for [shaped, counter] in [[Some(&disc), counter], [counter, Some(&disc)]] {
            let Some(shaped) = shaped else { continue };
            let operator = ContactOperator::new(&Pair::new(shaped, counter).unwrap(), true).unwrap();
            let n = operator.points().len();
            let (gap, load) = (vec![-INTERFERENCE; n], ContactLoad::factors(&[], &[]));
            let found = operator.solve(&gap, &load, None).unwrap();
            let (wanted, length) = (INTERFERENCE / compliance, 4.0 * PI);
            let near = |pressure: f64| (pressure / wanted - 1.0).abs() < 1e-4;
            assert!(found.pressure.iter().all(|p| near(*p)), "{wanted} {:?}", found.pressure);
            for arc in (0..=40).map(|i| length * f64::from(i) / 40.0) {
                assert!(near(operator.value_at(&found.pressure, arc)) && near(operator.pressure_at(&found.pressure, arc)));
            }
            assert!(near(operator.maximum(&found.pressure)));
            assert!(operator.embedded_difference(&gap, &load, &found).unwrap().unwrap() < 1e-4);
            assert!(matches!(found.zones[..], [[from, to]] if from == 0.0 && (to - length).abs() < 1e-9), "{:?}", found.zones);
        }
    }
}

/// A gap that varies once around: contact on the part where the boundary begins and ends, largest at a place between its points.
#[test]
fn contact_across_the_first_point_of_a_closed_boundary_has_two_zones_and_one_maximum() {
    let disc = ring([1.0, 2.0], 16, "outer", true);
    let pair = Pair::new(&disc, None).unwrap();
    let operator = ContactOperator::new(&pair, false).unwrap();
    // The boundary begins at (-2, 0) and runs anti-clockwise: largest interference at an angle of `PI + 0.05`, and just before the seam.
    for turn in [0.05, -0.05] {
        let gap: Vec<f64> =
            operator.points().iter().map(|p| -1e-3 * (p.position[1].atan2(p.position[0]) - PI - turn).cos()).collect();
        let found = operator.solve(&gap, &ContactLoad::factors(&[], &[]), None).unwrap();
        let (length, n) = (4.0 * PI, gap.len());
        let [[from, _], [_, to]] = found.zones[..] else { panic!("{:?}", found.zones) };
        assert!(found.closed[0] && found.closed[n - 1] && from == 0.0 && (to - length).abs() < 1e-9, "{:?}", found.zones);
        // Seen from the place of the largest interference, both zones reach as far.
        let reach = [found.zones[0][1] - 2.0 * turn, length + 2.0 * turn - found.zones[1][0]];
        assert!((reach[0] - reach[1]).abs() < 0.05 * reach[0], "{reach:?}");
        let sampled = (0..4000).map(|i| operator.pressure_at(&found.pressure, length * f64::from(i) / 4000.0));
        let largest = sampled.fold(0.0, f64::max);
        assert!((operator.maximum(&found.pressure) / largest - 1.0).abs() < 1e-5, "{largest}");
    }
}
