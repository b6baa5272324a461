//! The identities T1-T19 of the theory, over random parameters.

use approx::assert_relative_eq;
use nalgebra::Vector3;
use proptest::prelude::*;
use wear::{
    Character, Counterface, Functional, Modes, Optimum, Problem, RigidMode, Shape, SlidingMotion, Surface, WearLaw, WearPair,
    functional_value, optimal_pressure,
};

use crate::surfaces::{drum, drum_at};

fn functional() -> impl Strategy<Value = Functional> {
    prop_oneof![Just(Functional::WearVolume), Just(Functional::FrictionPower), Just(Functional::WearPower)]
}

/// q such that s = e q is the given one.
fn q_for(functional: &Functional, b: f64, s: f64) -> f64 {
    s / functional.pressure_power(b)
}

/// s on both sides of 1, away from it and from 0.
fn exponent() -> impl Strategy<Value = f64> {
    prop_oneof![1.05..6.0_f64, 0.1..0.9_f64, -3.0..-0.1_f64]
}

fn ring(inner: f64, ratio: f64) -> Surface {
    Surface::new(Shape::Annulus { radii: [inner, inner * ratio] }, SlidingMotion::about_z(2.5)).unwrap()
}

fn strip(half: f64) -> Surface {
    Surface::new(Shape::Strip { x: [-half, half], z: 0.0, thickness: 7.0 }, SlidingMotion::along_x(3.0)).unwrap()
}

fn law(a: f64, b: f64) -> WearLaw {
    WearLaw { factor: 3e-6, speed_exponent: a, pressure_exponent: b }
}

fn problem(surface: Surface, functional: Functional, q: f64, law: WearLaw, modes: Vec<RigidMode>) -> Problem {
    Problem { functional, q, friction: 0.3, ..Problem::new(surface, law, modes) }
}

fn press(force: f64) -> Vec<RigidMode> {
    vec![RigidMode::press_down(force)]
}

fn press_and_tilt(force: f64, moment: f64) -> Vec<RigidMode> {
    vec![RigidMode::press_down(force), RigidMode::tilt(moment, Vector3::zeros())]
}

fn plane(surface: &Surface, x: f64) -> wear::SurfacePoint {
    surface.point(Vector3::new(x, 0.0, 0.0), Vector3::z(), 0.0)
}

fn powers(optimum: &Optimum) -> [f64; 3] {
    [optimum.wear_volume_rate, optimum.friction_power, optimum.wear_power]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn t1_euler_and_t2_envelope(which in functional(), b in 0.3..3.0_f64, s in exponent(), share in -0.1..0.1_f64) {
        let q = q_for(&which, b, s);
        let at = |force: f64, moment: f64| {
            optimal_pressure(&problem(strip(25.0), which.clone(), q, law(1.0, b), press_and_tilt(force, moment))).unwrap()
        };
        let (force, moment) = (800.0, 800.0 * 25.0 * share);
        let optimum = at(force, moment);
        let e = which.pressure_power(b);
        let j = optimum.objective.unwrap();
        let work = optimum.multipliers[0] * force + optimum.multipliers[1] * moment;
        assert_relative_eq!(work, e * j, max_relative = 1e-11);
        let h = 1e-4 * force;
        let slope = (at(force + h, moment).objective.unwrap() - at(force - h, moment).objective.unwrap()) / (2.0 * h);
        assert_relative_eq!(optimum.multipliers[0], slope, max_relative = 1e-6);
        let h = 1e-3 * force;
        let slope = (at(force, moment + h).objective.unwrap() - at(force, moment - h).objective.unwrap()) / (2.0 * h);
        assert_relative_eq!(optimum.multipliers[1], slope, max_relative = 1e-5, epsilon = 1e-8 * e * j / (force * 25.0));
    }

    #[test]
    fn t3_scaling_and_independence_of_factors(which in functional(), b in 0.3..3.0_f64, s in exponent(), c in 0.01..100.0_f64) {
        let q = q_for(&which, b, s);
        let base = problem(ring(20.0, 4.0), which.clone(), q, law(1.2, b), press(1e4));
        let optimum = optimal_pressure(&base).unwrap();
        let scaled = optimal_pressure(&Problem { modes: press(c * 1e4), ..base.clone() }).unwrap();
        let e = which.pressure_power(b);
        assert_relative_eq!(scaled.multipliers[0], c.powf(e - 1.0) * optimum.multipliers[0], max_relative = 1e-11);
        let mut other = Problem { friction: 0.7, ..base.clone() };
        let law = *other.wear.rules[0].power().unwrap();
        other.wear.rules[0] = WearLaw { factor: 17.0 * law.factor, ..law }.into();
        let other = optimal_pressure(&other).unwrap();
        for r in [20.0, 33.0, 80.0] {
            let point = plane(&base.surface, r);
            let p = optimum.pressure_at(&point);
            assert_relative_eq!(scaled.pressure_at(&point), c * p, max_relative = 1e-12);
            assert_relative_eq!(other.pressure_at(&point), p, max_relative = 1e-13);
        }
    }

    #[test]
    fn t4_pressure_depends_on_s_alone_where_the_speed_is_constant(b in 0.3..3.0_f64, s in exponent(), share in -0.08..0.08_f64) {
        let modes = press_and_tilt(500.0, 500.0 * 25.0 * share);
        let of = |which: Functional| {
            optimal_pressure(&problem(strip(25.0), which.clone(), q_for(&which, b, s), law(1.3, b), modes.clone())).unwrap()
        };
        let (w, d) = (of(Functional::WearVolume), of(Functional::WearPower));
        for x in [-25.0, -3.0, 17.0] {
            let point = plane(&strip(25.0), x);
            assert_relative_eq!(w.pressure_at(&point), d.pressure_at(&point), max_relative = 1e-10);
        }
    }

    #[test]
    fn t5_infinite_q_of_the_wear_volume_is_the_least_wear_power_on_a_ring(a in 0.2..2.0_f64, b in 0.3..3.0_f64) {
        let of = |which, q| optimal_pressure(&problem(ring(30.0, 3.0), which, q, law(a, b), press(1e4))).unwrap();
        let (w, d) = (of(Functional::WearVolume, f64::INFINITY), of(Functional::WearPower, 1.0));
        for r in [30.0, 50.0, 90.0] {
            let point = plane(&ring(30.0, 3.0), r);
            assert_relative_eq!(w.pressure_at(&point), d.pressure_at(&point), max_relative = 1e-12);
        }
    }

    #[test]
    fn t6_hoelder_duality_certifies_the_optimum(b in 0.3..3.0_f64, s in exponent(), share in -0.08..0.08_f64) {
        // N_s(p) N_s'(f) = lambda . F with f in the gauge of the multipliers; g = 1 after a common factor.
        let q = q_for(&Functional::WearVolume, b, s);
        let modes = press_and_tilt(500.0, 500.0 * 25.0 * share);
        let optimum = optimal_pressure(&problem(strip(25.0), Functional::WearVolume, q, law(1.0, b), modes)).unwrap();
        let norm = |power: f64, value: &dyn Fn(usize) -> f64| {
            let sum: f64 = optimum.points.iter().enumerate().map(|(i, p)| p.weight * value(i).powf(power)).sum();
            sum.powf(1.0 / power)
        };
        let dual = s / (s - 1.0);
        let force = |point: &wear::SurfacePoint| optimum.multipliers[0] + optimum.multipliers[1] * point.position.x;
        let left = norm(s, &|i| optimum.pressure[i]) * norm(dual, &|i| force(&optimum.points[i]));
        let right = optimum.multipliers[0] * 500.0 + optimum.multipliers[1] * 500.0 * 25.0 * share;
        assert_relative_eq!(left, right, max_relative = 1e-10);
    }

    #[test]
    fn t7_mirrored_moments_give_mirrored_pressures(b in 0.3..3.0_f64, share in 0.0..0.9_f64) {
        let of = |moment| optimal_pressure(&problem(strip(25.0), Functional::Steady, 1.0, law(1.0, b), press_and_tilt(500.0, moment))).unwrap();
        let (plus, minus) = (of(500.0 * 25.0 * share), of(-500.0 * 25.0 * share));
        assert_relative_eq!(plus.multipliers[0], minus.multipliers[0], max_relative = 1e-9);
        assert_relative_eq!(plus.multipliers[1], -minus.multipliers[1], max_relative = 1e-9, epsilon = 1e-18);
        for x in [-20.0, 0.0, 11.0, 25.0] {
            let (p, m) = (plus.pressure_at(&plane(&strip(25.0), x)), minus.pressure_at(&plane(&strip(25.0), -x)));
            assert_relative_eq!(p, m, max_relative = 1e-7, epsilon = 1e-8 * plus.p_max);
        }
    }

    #[test]
    fn t9_wear_ratio_is_below_one_and_tends_to_one_with_the_speed_exponent(b in 1.05..3.0_f64, a in 0.2..1.5_f64) {
        let ratio = |a: f64| {
            let w = |which| optimal_pressure(&problem(ring(20.0, 6.0), which, 1.0, law(a, b), press(1e4))).unwrap().wear_volume_rate;
            w(Functional::WearVolume) / w(Functional::WearPower)
        };
        prop_assert!(ratio(a) < 1.0);
        prop_assert!(ratio(0.5 * a) > ratio(a));
        prop_assert!((ratio(1e-4) - 1.0).abs() < 1e-5);
    }

    #[test]
    fn t10_t11_torque_stays_between_the_radii_and_grows_with_q(q in 0.55..3.0_f64, ratio in 1.2..8.0_f64) {
        let radius = |q| {
            let case = problem(ring(20.0, ratio), Functional::WearPower, q, law(1.0, 1.0), press(1e4));
            optimal_pressure(&case).unwrap().effective_radius.unwrap()
        };
        let (here, more) = (radius(q), radius(q + 0.1));
        prop_assert!(here >= 20.0 && here <= 20.0 * ratio);
        prop_assert!(more > here);
        assert_relative_eq!(radius(1.0), 10.0 * (1.0 + ratio), max_relative = 1e-12);
        let mean = 2.0 / 3.0 * 20.0 * (ratio.powi(3) - 1.0) / (ratio * ratio - 1.0);
        assert_relative_eq!(radius(0.0), mean, max_relative = 1e-12);
    }

    #[test]
    fn t12_t14_drum_follows_the_cosine_and_ignores_friction_for_even_pressures(mu in 0.0..0.9_f64, b in 0.3..3.0_f64) {
        let with = |friction| {
            let case = Problem { friction, ..Problem::new(drum(), law(1.0, b), press(1e4)) };
            optimal_pressure(&case).unwrap()
        };
        let (rough, smooth) = (with(mu), with(0.0));
        for degrees in [-30.0, -11.0, 0.0, 24.0] {
            let point = drum_at(&drum(), degrees);
            assert_relative_eq!(rough.pressure_at(&point), smooth.pressure_at(&point), max_relative = 1e-12);
            let cosine = point.normal.z.powf(1.0 / b);
            assert_relative_eq!(smooth.pressure_at(&point), smooth.p_max * cosine, max_relative = 1e-12);
        }
    }

    #[test]
    fn t13_t15_strip_contact_beyond_the_kern_has_the_closed_length(b in 0.3..5.0_f64, share in 0.02..0.98_f64) {
        let k = 1.0 / b;
        // Excentricity between the edge of the kern c k/(k+2) and c.
        let kern = 25.0 * k / (k + 2.0);
        let e = kern + (25.0 - kern) * share;
        let case = problem(strip(25.0), Functional::Steady, 1.0, law(1.0, b), press_and_tilt(500.0, 500.0 * e));
        let optimum = optimal_pressure(&case).unwrap();
        let length = (k + 2.0) * (25.0 - e);
        let edge = 500.0 * (k + 1.0) / (7.0 * length);
        assert_relative_eq!(optimum.p_max, edge, max_relative = 1e-9);
        for t in [0.1, 0.5, 0.9] {
            let x = 25.0 - length * (1.0 - t);
            assert_relative_eq!(optimum.pressure_at(&plane(&case.surface, x)), edge * t.powf(k), max_relative = 1e-8);
        }
    }

    #[test]
    fn t16_total_wear_is_uniform_on_a_ring_for_different_speed_exponents(a1 in 0.2..2.0_f64, a2 in 0.2..2.0_f64, b in 0.3..3.0_f64, share in 0.1..10.0_f64) {
        let wear = WearPair::archard([1e-6, 1e-6 * share], [a1, a2], [b, b]);
        let case = Problem {
            wear: wear.clone(),
            counterface: Counterface::Congruent,
            ..problem(ring(20.0, 4.0), Functional::WearPower, 1.0, law(1.0, b), press(1e4))
        };
        let optimum = optimal_pressure(&case).unwrap();
        let feed = optimum.multipliers[0] / (b + 1.0);
        for r in [20.0, 31.0, 80.0] {
            let point = plane(&case.surface, r);
            let p = optimum.pressure_at(&point);
            let total: f64 = wear.rules.iter().map(|rule| rule.rate(p, point.sliding_speed)).sum();
            assert_relative_eq!(total, feed, max_relative = 1e-11);
        }
        prop_assert!(optimum.steadiness_residual.unwrap() < 1e-11);
    }

    #[test]
    fn t17_pressure_grows_with_f_for_two_bodies(b1 in 0.5..3.0_f64, b2 in 0.5..3.0_f64, a2 in 0.2..2.0_f64) {
        // s_i > 1 on both: more load, more pressure at every point.
        let wear = WearPair::archard([1e-6, 2e-7], [1.0, a2], [b1, b2]);
        let of = |force| {
            let case = Problem { wear: wear.clone(), counterface: Counterface::Congruent, ..problem(ring(20.0, 4.0), Functional::WearPower, 1.0, law(1.0, 1.0), press(force)) };
            optimal_pressure(&case).unwrap()
        };
        let (less, more) = (of(1e4), of(1.1e4));
        for r in [20.0, 45.0, 80.0] {
            let point = plane(&ring(20.0, 4.0), r);
            prop_assert!(more.pressure_at(&point) > less.pressure_at(&point));
        }
        assert_relative_eq!(less.resultants[0], 1e4, max_relative = 1e-12);
    }

    #[test]
    fn t18_t19_character_is_seen_by_perturbations_that_keep_the_balance(which in functional(), b in 0.3..3.0_f64, s in exponent(), share in -0.08..0.08_f64, seeds in prop::array::uniform4(-1.0..1.0_f64)) {
        let q = q_for(&which, b, s);
        let surface = strip(25.0);
        let case = problem(surface, which.clone(), q, law(1.0, b), press_and_tilt(500.0, 500.0 * 25.0 * share));
        let optimum = optimal_pressure(&case).unwrap();
        let (points, pressure) = (&optimum.points, &optimum.pressure);
        // A smooth perturbation z = dp/p with int p z = int p z x = 0.
        let raw = |x: f64| seeds.iter().enumerate().map(|(i, c)| c * ((i as f64 + 1.3) * x / 9.0 + 1.7 * c).sin()).sum::<f64>();
        let moment = |f: &dyn Fn(f64) -> f64| -> f64 { points.iter().zip(pressure).map(|(pt, p)| pt.weight * p * f(pt.position.x)).sum() };
        let gram = nalgebra::Matrix2::new(moment(&|_| 1.0), moment(&|x| x), moment(&|x| x), moment(&|x| x * x));
        let fit = gram.lu().solve(&nalgebra::Vector2::new(moment(&|x| raw(x)), moment(&|x| x * raw(x)))).unwrap();
        let change: Vec<f64> = points.iter().map(|pt| raw(pt.position.x) - fit[0] - fit[1] * pt.position.x).collect();
        let size = change.iter().fold(0.0_f64, |m, z| m.max(z.abs()));
        prop_assume!(size > 1e-3);
        let value = |eps: f64| {
            let p: Vec<f64> = pressure.iter().zip(&change).map(|(p, z)| p * (1.0 + eps * z / size)).collect();
            functional_value(&case, points, &p).unwrap()
        };
        let centre = value(0.0);
        let expected = if s > 1.0 { Character::Minimum } else { Character::Maximum };
        prop_assert_eq!(optimum.character, expected);
        for eps in [-0.3, -0.03, 0.03, 0.3] {
            let difference = (value(eps) - centre) * if s > 1.0 { 1.0 } else { -1.0 };
            prop_assert!(difference > -1e-13 * centre, "{} {} {}", eps, difference, centre);
        }
        // Stationary, and the second variation is J e [(s - 1) Var z + (e - 1) (E z)^2] under the probability p^s dS (the speed is constant).
        let h = 1e-3;
        let (first, second) = ((value(h) - value(-h)) / (2.0 * h), (value(h) - 2.0 * centre + value(-h)) / (h * h));
        prop_assert!(first.abs() < 1e-5 * centre, "{first} {centre}");
        let mean = |f: &dyn Fn(f64) -> f64| {
            let terms = || points.iter().zip(pressure).map(|(pt, p)| pt.weight * p.powf(s)).zip(&change);
            terms().map(|(w, z)| w * f(z / size)).sum::<f64>() / terms().map(|(w, _)| w).sum::<f64>()
        };
        let (e, z) = (which.pressure_power(b), mean(&|z| z));
        let variation = centre * e * ((s - 1.0) * mean(&|y| (y - z).powi(2)) + (e - 1.0) * z * z);
        assert_relative_eq!(variation, second, max_relative = 1e-4, epsilon = 1e-8 * centre);
    }

    #[test]
    fn lengths_of_any_unit_give_the_same_pressure_shape(b in 0.3..3.0_f64, s in exponent(), unit in prop_oneof![Just(1e-6), Just(1e6)]) {
        let q = q_for(&Functional::WearPower, b, s);
        let at = |scale: f64| {
            let shape = Shape::Annulus { radii: [20.0 * scale, 120.0 * scale] };
            let surface = Surface::new(shape, SlidingMotion::about_z(2.5)).unwrap();
            let case = problem(surface.clone(), Functional::WearPower, q, law(1.0, b), press(1e6 * scale * scale));
            let optimum = optimal_pressure(&case).unwrap();
            [20.0, 50.0, 120.0].map(|r| optimum.log_pressure_at(&plane(&surface, r * scale)))
        };
        for (one, other) in at(1.0).iter().zip(at(unit)) {
            prop_assert!((one - other).abs() < 1e-10 * one.abs().max(1.0), "{} {}", one, other);
        }
    }

    #[test]
    fn associated_drum_is_the_true_extremum_with_friction(mu in 0.05..0.5_f64, s in 1.2..5.0_f64) {
        let case = Problem { friction: mu, mode_kind: Modes::Associated, functional: Functional::FrictionPower, q: s, ..Problem::new(drum(), law(1.0, 1.0), press(1e4)) };
        let associated = optimal_pressure(&case).unwrap();
        prop_assert_eq!(associated.character, Character::Minimum);
        let kinematic = optimal_pressure(&Problem { mode_kind: Modes::Kinematic, ..case.clone() }).unwrap();
        prop_assert_eq!(kinematic.character, Character::Stationary);
        prop_assert!(associated.objective.unwrap() < kinematic.objective.unwrap());
        assert_relative_eq!(associated.resultants[0], 1e4, max_relative = 1e-12);
    }

    #[test]
    fn steady_state_with_different_rules_wears_rigidly_and_balances(b1 in 0.3..3.0_f64, b2 in 0.3..3.0_f64, a2 in 0.2..2.0_f64, share in -0.9..0.9_f64) {
        let case = Problem {
            wear: WearPair::archard([1e-6, 4e-6], [1.0, a2], [b1, b2]),
            counterface: Counterface::Congruent,
            ..problem(strip(25.0), Functional::Steady, 1.0, law(1.0, 1.0), press_and_tilt(500.0, 500.0 * 25.0 * share))
        };
        let optimum = optimal_pressure(&case).unwrap();
        prop_assert!(optimum.steadiness_residual.unwrap() < 1e-9, "{:?}", optimum.steadiness_residual);
        assert_relative_eq!(optimum.resultants[0], 500.0, max_relative = 1e-11);
        assert_relative_eq!(optimum.resultants[1], 500.0 * 25.0 * share, max_relative = 1e-9, epsilon = 1e-6);
        let _ = powers(&optimum);
    }
}
