//! Two spheres (here a sphere and a plane) pressed together and turned about the common normal: Lubkin, J. Appl. Mech. 18 (1951) 183;
//! full stick: Reissner and Sagoci, J. Appl. Phys. 15 (1944) 652; reversal: Deresiewicz, J. Appl. Mech. 21 (1954) 52.
//!
//! ```text
//!        | theta            q = mu p          c < r < a   slip
//!      __|__                slip = 0          r < c       stick
//!   __/_____\__             p = p0 sqrt(1 - r^2/a^2)
//!      a   c                1/G = 1/G1 + 1/G2
//! ```
//! A sum of rigid twists of circles of radius s, each `q = 4 G b r / (pi sqrt(s^2 - r^2))` with torque `16/3 G b s^3`, leaves r < c unturned
//! if none is smaller than c, and Abel's equation for `q = mu p` outside gives `theta = mu/2 H(c)/G`, with `H(s) = int_s^a p dr / sqrt(r^2 - s^2)
//! = p0 (K - E)(k)`, `k^2 = 1 - s^2/a^2`, and the torque `8 mu/3 (c^3 H(c) + 3 int_c^a s^2 H ds)`, at most `3 pi/16 mu P a`.

use crate::common::cylinder::{Sizes, block, round};
use crate::common::{material, touching};
use approx::{assert_abs_diff_eq, assert_relative_eq};
use contact::*;
use hpfem::{Body, Direction, Kinematics, Mesh, gauss};
use std::f64::consts::PI;

const SIZES: Sizes = Sizes { radius: 5.0, width: 10.0, depth: 10.0 };
/// Radius of contact, mm: small against the bodies.
const END: f64 = 1e-4;
const PEAK: f64 = 1000.0;
const FRICTION: f64 = 0.3;
const YOUNG: [f64; 2] = [2.1e5, 0.7e5];

/// `1/G1 + 1/G2`.
fn softness() -> f64 {
    YOUNG.iter().map(|e| 2.6 / e).sum()
}

fn bodies(nodes: &[f64], degree: usize, layers: usize) -> Rebuilt {
    let reduce = |mesh: Mesh, held: &str, young: f64| {
        let problem = touching(mesh, [degree, layers], Kinematics::Torsion, material(young, 0.3));
        Body::new(problem.hold("axis", Direction::First).hold(held, Direction::First)).unwrap().interface
    };
    Rebuilt {
        shaped: reduce(round(&SIZES, nodes, 1.6, layers), "top", YOUNG[0]),
        counter: reduce(block(&SIZES, nodes, 1.6, layers), "bottom", YOUNG[1]),
        facing: true,
    }
}

fn operator(nodes: &[f64], degree: usize, layers: usize) -> TorsionOperator {
    let bodies = bodies(nodes, degree, layers);
    TorsionOperator::new(&bodies.pair().unwrap()).unwrap()
}

/// Limits of the nodal forces under the pressure of Hertz.
fn limits(operator: &TorsionOperator) -> Vec<f64> {
    let pressure = |r: f64| PEAK * (1.0 - (r / END).powi(2)).max(0.0).sqrt();
    operator.points().iter().map(|p| FRICTION * pressure(p.position[0]) * p.weight).collect()
}

/// `K - E` by the complementary modulus, by the arithmetic-geometric mean.
fn elliptic_difference(other: f64) -> f64 {
    let (mut a, mut b, mut c, mut sum, mut power) = (1.0, other, ((1.0 - other) * (1.0 + other)).sqrt(), 0.0, 0.5);
    while c > 1e-14 * a {
        sum += power * c * c;
        (a, b, c) = (0.5 * (a + b), (a * b).sqrt(), 0.5 * (a - b));
        power *= 2.0;
    }
    0.5 * PI / a * sum
}

/// Angle and torque at a radius of stick.
fn lubkin(stick: f64) -> (f64, f64) {
    let h = |s: f64| PEAK * elliptic_difference((s / END).min(1.0));
    let rule = gauss(60);
    // s = a - (a - c) t^2.
    let inner: f64 = rule
        .points
        .iter()
        .zip(&rule.weights)
        .map(|(x, w)| {
            let t = 0.5 * (x + 1.0);
            let s = END - (END - stick) * t * t;
            0.5 * w * 2.0 * t * (END - stick) * s * s * h(s)
        })
        .sum();
    let angle = 0.5 * FRICTION * softness() * h(stick);
    (angle, 8.0 * FRICTION / 3.0 * (stick.powi(3) * h(stick) + 3.0 * inner))
}

fn slip_torque() -> f64 {
    let force = 2.0 / 3.0 * PI * END * END * PEAK;
    3.0 * PI / 16.0 * FRICTION * force * END
}

#[test]
fn the_closed_form_has_its_known_limits() {
    // Everything slips; and little slips: the compliance of a rigid twist.
    assert_relative_eq!(lubkin(1e-9 * END).1, slip_torque(), max_relative = 1e-6);
    let (angle, torque) = lubkin((1.0 - 1e-5) * END);
    assert_relative_eq!(torque * softness() / (16.0 / 3.0 * END.powi(3)), angle, max_relative = 1e-4);
}

#[test]
fn a_contact_that_sticks_everywhere_has_the_stiffness_of_a_rigid_twist() {
    let operator = operator(&[END], 12, 8);
    let much: Vec<f64> = operator.points().iter().map(|p| if p.position[0] <= END { 1.0 } else { 0.0 }).collect();
    let n = much.len();
    let twist = operator.solve(&much, Turn::Angle(1e-3), &vec![0.0; n]).unwrap();
    let theory = 16.0 / 3.0 * END.powi(3) * 1e-3 / softness();
    println!("torque {:.8e}, theory {theory:.8e}, off by {:.1e}", twist.torque, twist.torque / theory - 1.0);
    assert_eq!(twist.status, TwistStatus::Sticks);
    assert_relative_eq!(twist.torque, theory, max_relative = 5e-6);
    // By torque the same angle.
    let back = operator.solve(&much, Turn::Torque(twist.torque), &vec![0.0; n]).unwrap();
    assert_relative_eq!(back.angle, 1e-3, max_relative = 1e-11);
}

#[test]
fn angle_torque_and_radius_of_stick_are_those_of_lubkin() {
    for ratio in [0.9, 0.6, 0.3] {
        let stick = ratio * END;
        let (angle, torque) = lubkin(stick);
        let operator = operator(&[stick, END], 12, 6);
        let limits = limits(&operator);
        let n = limits.len();
        for turn in [Turn::Angle(angle), Turn::Torque(torque)] {
            let twist = operator.solve(&limits, turn, &vec![0.0; n]).unwrap();
            let found = twist.stick.last().unwrap()[1];
            println!(
                "n {n} c/a {ratio}: angle {:.2e} torque {:.2e} stick {:.2e} off, {} systems, residual {:.1e}",
                twist.angle / angle - 1.0,
                twist.torque / torque - 1.0,
                found / stick - 1.0,
                twist.iterations,
                twist.residual
            );
            assert_eq!(twist.status, TwistStatus::SlipsInPart);
            // What is left is the curvature of the sphere, of the order a/R = 2e-5.
            assert_relative_eq!(twist.angle, angle, max_relative = 5e-6);
            assert_relative_eq!(twist.torque, torque, max_relative = 5e-6);
            assert_relative_eq!(found, stick, max_relative = 1e-5);
            assert!(twist.iterations <= 30);
            for (shear, limit) in twist.nodal_shear.iter().zip(&limits) {
                assert!(shear.abs() <= limit * (1.0 + 1e-8));
            }
        }
    }
}

#[test]
fn turning_back_and_forth_follows_masing_and_closes_the_loop() {
    let operator = operator(&[0.5 * END, END], 10, 4);
    let limits = limits(&operator);
    let n = limits.len();
    let step = |angle: f64, before: &[f64]| operator.solve(&limits, Turn::Angle(angle), before).unwrap();
    let (angle, _) = lubkin(0.4 * END);
    let loaded = step(angle, &vec![0.0; n]);
    // Halfway back, and to the other side: twice the first loading at half the change.
    let back = step(0.0, &loaded.slip);
    let half = step(0.5 * angle, &vec![0.0; n]);
    assert_relative_eq!(back.torque, loaded.torque - 2.0 * half.torque, max_relative = 1e-9);
    assert!(back.torque < 0.0 && back.states.contains(&ContactState::Forward));
    let other = step(-angle, &back.slip);
    assert_relative_eq!(other.torque, -loaded.torque, max_relative = 1e-9);
    let again = step(angle, &other.slip);
    println!("loop closes to {:.1e}", again.torque / loaded.torque - 1.0);
    let largest = limits.iter().copied().fold(0.0, f64::max);
    for (a, b) in again.nodal_shear.iter().zip(&loaded.nodal_shear) {
        assert_abs_diff_eq!(a / largest, b / largest, epsilon = 1e-9);
    }
    // Work of friction over the loop is positive: the torque on the way back lies below.
    assert!(back.torque < step(0.0, &vec![0.0; n]).torque);
}

#[test]
fn beyond_the_torque_of_friction_the_body_turns_through() {
    let operator = operator(&[END], 10, 4);
    let limits = limits(&operator);
    let n = limits.len();
    assert_relative_eq!(operator.slip_torque(&limits), slip_torque(), max_relative = 1e-4);
    let slip = operator.slip_torque(&limits);
    let turned = |turn| operator.solve(&limits, turn, &vec![0.0; n]).unwrap();
    assert_eq!(turned(Turn::Torque(1.001 * slip)).status, TwistStatus::TurnsThrough);
    assert!(!TwistStatus::TurnsThrough.is_solved());
    let near = turned(Turn::Torque(-0.999 * slip));
    assert_eq!(near.status, TwistStatus::SlipsInPart);
    assert_relative_eq!(near.torque, -0.999 * slip, max_relative = 1e-10);
    let far = turned(Turn::Angle(1.0));
    assert!(matches!(far.status, TwistStatus::Slips | TwistStatus::SlipsInPart));
    assert_relative_eq!(far.torque, slip, max_relative = 1e-9);
}

#[test]
fn limits_that_jump_from_point_to_point_leave_every_condition_fulfilled() {
    let operator = operator(&[END], 8, 3);
    let rough: Vec<f64> =
        limits(&operator).iter().enumerate().map(|(i, l)| l * if i % 3 == 0 { 1e-3 } else { 1.0 + (i % 2) as f64 }).collect();
    let n = rough.len();
    let before: Vec<f64> = (0..n).map(|i| 1e-8 * ((7 * i % 5) as f64 - 2.0)).collect();
    let largest = rough.iter().copied().fold(0.0, f64::max);
    for share in [-0.9, -0.3, 0.3, 0.6, 0.9] {
        let twist = operator.solve(&rough, Turn::Torque(share * operator.slip_torque(&rough)), &before).unwrap();
        assert!(twist.status.is_solved() && twist.iterations <= 60, "{} {}", twist.status, twist.iterations);
        for i in 0..n {
            let (force, moved) = (twist.nodal_shear[i], twist.slip[i] - before[i]);
            match twist.states[i] {
                ContactState::Open => assert_eq!(force, 0.0),
                ContactState::Stick => assert!(force.abs() <= rough[i] + 1e-9 * largest && moved.abs() < 1e-17),
                _ => assert!(force.abs() == rough[i] && force * moved <= 0.0),
            }
        }
    }
}

#[test]
fn bodies_that_can_turn_are_refused() {
    let mesh = round(&SIZES, &[END], 1.6, 2);
    let problem = touching(mesh, [4, 2], Kinematics::Torsion, material(2.1e5, 0.3)).hold("axis", Direction::First);
    let free = Body::new(problem).unwrap().interface;
    let held = bodies(&[END], 4, 2).counter;
    let pair = Pair::facing(&free, &held).unwrap();
    assert_eq!(TorsionOperator::new(&pair).err(), Some(Error::FreeToTurn { side: Side::Shaped }));
}

#[test]
fn bodies_twisted_by_the_shear_move_past_each_other_by_the_slip() {
    let bodies = bodies(&[END], 8, 3);
    let pair = bodies.pair().unwrap();
    let operator = TorsionOperator::new(&pair).unwrap();
    let limits = limits(&operator);
    let twist = operator.solve(&limits, Turn::Torque(0.6 * operator.slip_torque(&limits)), &vec![0.0; limits.len()]).unwrap();
    let [first, second] = [(Side::Shaped, &bodies.shaped), (Side::Counter, &bodies.counter)]
        .map(|(side, body)| (side, pair.twisted(side, body, &twist.shear)));
    let size = twist.slip.iter().fold(0.0_f64, |most, slip| most.max(slip.abs()));
    for (point, slip) in operator.points().iter().zip(&twist.slip) {
        let [u, v] = [&first, &second].map(|(side, state)| pair.hoop_displacement(*side, state, point));
        assert_abs_diff_eq!(u - v + point.position[0] * twist.angle, *slip, epsilon = 1e-9 * size);
    }
}
