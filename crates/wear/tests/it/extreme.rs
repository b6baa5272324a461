//! Extreme parameters: s next to 1 on both sides, huge and negative q, no friction, no answer. Right, or refused by name.

use approx::assert_relative_eq;
use nalgebra::Vector3;
use wear::{
    Character, Counterface, Functional, Modes, Problem, Regime, RigidMode, Shape, SlidingMotion, Surface, WearError, WearLaw,
    WearPair, optimal_pressure,
};

use crate::surfaces::{annulus, drum, plane_at, problem, punch};

const F0: f64 = 4398229.715025711;

fn press(force: f64) -> Vec<RigidMode> {
    vec![RigidMode::press_down(force)]
}

fn press_and_tilt(force: f64, moment: f64) -> Vec<RigidMode> {
    vec![RigidMode::press_down(force), RigidMode::tilt(moment, Vector3::zeros())]
}

/// log p of the annulus p = C r^(-n), int p dS = F: closed form in u = log(r/r_peak), from the side of the peak.
fn annulus_log_pressure(n: f64, r: f64) -> f64 {
    let span = 6_f64.ln();
    // int r^(1-n) dr = r_peak^(2-n) (1 - exp(-|2-n| span)) / |2-n|
    let m = 2.0 - n;
    let peak: f64 = if m < 0.0 { 20.0 } else { 120.0 };
    let integral = -(-m.abs() * span).exp_m1() / m.abs();
    (F0 / (std::f64::consts::TAU * peak * peak * integral)).ln() - n * (r / peak).ln()
}

#[test]
fn annulus_next_to_the_singular_exponent_on_both_sides() {
    for distance in [1e-2, 1e-4, 1e-6, 1e-8, -1e-2, -1e-4, -1e-6, -1e-8] {
        let q = 1.0 + distance;
        // Friction power: s - 1 = q - 1 exactly in doubles, p ~ r^(-q/(q-1)).
        let optimum = optimal_pressure(&problem(annulus(), Functional::FrictionPower, q, 1.0, 1.0, press(F0))).unwrap();
        let n = q / (q - 1.0);
        for r in [20.0, 20.001, 40.0, 119.0, 120.0] {
            let got = optimum.log_pressure_at(&plane_at(&annulus(), r));
            let wanted = annulus_log_pressure(n, r);
            assert!((got - wanted).abs() <= 1e-9 * wanted.abs().max(1.0), "q - 1 = {distance}, r = {r}: {got} {wanted}");
        }
        assert_relative_eq!(optimum.resultants[0], F0, max_relative = 1e-9);
        let radius = if distance > 0.0 { 20.0 } else { 120.0 };
        assert!((optimum.effective_radius.unwrap() / radius - 1.0).abs() < 12.0 * distance.abs());
        assert_eq!(optimum.character, if distance > 0.0 { Character::Minimum } else { Character::Maximum });
        assert_eq!(optimum.regime, Regime::NearSingular);
    }
}

#[test]
fn wear_power_rounds_s_minus_1_once() {
    // b + 1 and (b + 1) q are both inexact: s - 1 against exact rational arithmetic in integers of 2^-104.
    for (b, q) in [(0.1_f64, 1.0 / 1.1), (0.3, 1.0 / 1.3), (1.7, 0.370_370_370_4), (0.05, 0.952_380_952_4)] {
        let exact = exact_product_minus_1(b, q);
        let got = Functional::WearPower.s_minus_1(b, q);
        assert_relative_eq!(got, exact, max_relative = 1e-15, epsilon = 0.0);
    }
}

/// (b + 1) q - 1 with integers: b = m 2^-60, q = n 2^-60 exactly for these sizes.
fn exact_product_minus_1(b: f64, q: f64) -> f64 {
    let unit = 2_f64.powi(60);
    let (m, n) = ((b * unit) as i128, (q * unit) as i128);
    assert!(m as f64 == b * unit && n as f64 == q * unit);
    // (m + 2^60) n - 2^120 fits in i128.
    let product = (m + (1_i128 << 60)) * n - (1_i128 << 120);
    product as f64 / 2_f64.powi(120)
}

#[test]
fn drum_next_to_the_singular_exponent_narrows_like_a_gaussian() {
    for distance in [1e-4, 1e-6, 1e-8] {
        let case = problem(drum(), Functional::FrictionPower, 1.0 + distance, 1.0, 1.0, press(1e4));
        let optimum = optimal_pressure(&case).unwrap();
        // int cos^m R t da over the arc -> R t sqrt(2 pi/m) (1 - 1/(4 m) + O(1/m^2)), m = k + 1; the cut tails are exp(-1e3).
        let m = 1.0 / (case.q - 1.0) + 1.0;
        let peak = 1e4 / (2000.0 * (std::f64::consts::TAU / m).sqrt() * (1.0 - 0.25 / m));
        assert_relative_eq!(optimum.p_max, peak, max_relative = 1e-9 + 1.0 / (m * m));
        assert_relative_eq!(optimum.resultants[0], 1e4, max_relative = 1e-9);
    }
    for distance in [1e-4, 1e-6, 1e-8] {
        let case = problem(drum(), Functional::FrictionPower, 1.0 - distance, 1.0, 1.0, press(1e4));
        let optimum = optimal_pressure(&case).unwrap();
        assert_relative_eq!(optimum.resultants[0], 1e4, max_relative = 1e-7);
        assert_eq!(optimum.character, Character::Stationary);
    }
}

#[test]
fn punch_next_to_the_singular_exponent_is_the_exponential() {
    let limit = optimal_pressure(&problem(punch(), Functional::WearVolume, 1.0, 1.0, 1.0, press_and_tilt(1e3, 8e3))).unwrap();
    for distance in [1e-5, 1e-8, 1e-12, -1e-5, -1e-8, -1e-12] {
        let case = problem(punch(), Functional::WearVolume, 1.0 + distance, 1.0, 1.0, press_and_tilt(1e3, 8e3));
        let optimum = optimal_pressure(&case).unwrap();
        for x in [-30.0, -7.0, 0.0, 30.0] {
            let point = plane_at(&punch(), x);
            let error: f64 = optimum.pressure_at(&point) / limit.pressure_at(&point) - 1.0;
            assert!(error.abs() < 2.0 * distance.abs() + 1e-11, "{distance} {x} {error:e}");
        }
        assert_eq!(optimum.regime, Regime::Regular);
    }
}

#[test]
fn singular_exponent_is_named_with_its_limit_measure() {
    let optimum = optimal_pressure(&problem(annulus(), Functional::WearVolume, 1.0, 1.0, 1.0, press(F0))).unwrap();
    assert_eq!(optimum.regime, Regime::Singular);
    assert_eq!(optimum.limit_measure.len(), 1);
    assert_relative_eq!(optimum.limit_measure[0].force, F0, max_relative = 1e-12);
    assert_relative_eq!(optimum.limit_measure[0].position.x, 20.0, max_relative = 1e-12);
    // b q = 1 in decimals but not in doubles.
    let optimum = optimal_pressure(&problem(annulus(), Functional::WearVolume, 10.0, 1.0, 0.1, press(F0))).unwrap();
    assert_eq!(optimum.regime, Regime::Singular);
    let centre = optimal_pressure(&problem(drum(), Functional::WearVolume, 2.0, 1.0, 0.5, press(1e4))).unwrap();
    assert!(centre.limit_measure[0].position.x.abs() < 1e-4);
    // Kinematic modes with friction: the force is F0/psi at a place known to the square root of round-off.
    assert_relative_eq!(centre.limit_measure[0].force, 1e4, max_relative = 1e-8);
    // A pad under force and moment: at most as many forces as modes, and they carry the load.
    let shape = Shape::Sector { radii: [60.0, 110.0], angles: [-0.5, 0.5] };
    let surface = Surface::new(shape, SlidingMotion::about_z(10.0)).unwrap();
    let modes = press_and_tilt(1000.0, 85_000.0);
    let pad = optimal_pressure(&problem(surface, Functional::FrictionPower, 1.0, 1.0, 1.0, modes)).unwrap();
    assert_eq!(pad.regime, Regime::Singular);
    assert!(pad.limit_measure.len() <= 2);
    assert_relative_eq!(pad.resultants[0], 1000.0, max_relative = 1e-9);
    assert_relative_eq!(pad.resultants[1], 85_000.0, max_relative = 1e-9);
}

#[test]
fn huge_zero_and_negative_q_are_answered() {
    for b in [0.05, 0.5, 1.0, 3.0, 20.0] {
        for q in [1e6, f64::INFINITY] {
            let optimum = optimal_pressure(&problem(annulus(), Functional::WearPower, q, 1.0, b, press(F0))).unwrap();
            let n = 1.0 / (b + 1.0);
            let at = |r| optimum.pressure_at(&plane_at(&annulus(), r));
            assert_relative_eq!(at(40.0) / at(80.0), 2_f64.powf(n), max_relative = 1e-5);
            assert_relative_eq!(optimum.resultants[0], F0, max_relative = 1e-12);
            assert!(optimum.objective.unwrap().is_finite());
        }
        let zero = optimal_pressure(&problem(annulus(), Functional::WearPower, 0.0, 1.0, b, press(F0))).unwrap();
        assert_relative_eq!(zero.p_max, zero.p_min, max_relative = 1e-13);
        assert_eq!(zero.objective, None);
        assert_eq!(zero.character, Character::Maximum);
        let negative = optimal_pressure(&problem(annulus(), Functional::WearPower, -2.0, 1.0, b, press(F0))).unwrap();
        assert_eq!(negative.character, Character::Maximum);
        let minus = optimal_pressure(&problem(annulus(), Functional::WearPower, -1e6, 1.0, b, press(F0))).unwrap();
        let plus = optimal_pressure(&problem(annulus(), Functional::WearPower, 1e6, 1.0, b, press(F0))).unwrap();
        assert_relative_eq!(minus.p_max, plus.p_max, max_relative = 1e-5);
    }
}

#[test]
fn without_friction_nothing_wears_but_the_pressure_is_the_usual_one() {
    let usual = Problem { friction: 0.25, ..Problem::new(annulus(), WearLaw::from_beta(2e-4, 0.25, 1.0, 1.4), press(F0)) };
    let smooth =
        Problem { friction: 0.0, wear: WearPair::from_beta([2e-4, 0.0], 0.0, [1.0; 2], [1.4; 2]).unwrap(), ..usual.clone() };
    let (usual, smooth) = (optimal_pressure(&usual).unwrap(), optimal_pressure(&smooth).unwrap());
    assert_relative_eq!(usual.p_max, smooth.p_max, max_relative = 1e-13);
    assert_eq!((smooth.wear_volume_rate, smooth.friction_power, smooth.wear_power), (0.0, 0.0, 0.0));
    assert_eq!(smooth.multipliers, vec![0.0]);
    assert_eq!(smooth.feed, Some(vec![0.0]));
    assert_eq!(smooth.steadiness_residual, None);
    for functional in [Functional::WearVolume, Functional::WearPower, Functional::FrictionPower] {
        let case = Problem {
            functional,
            q: 2.0,
            friction: 0.0,
            wear: WearPair::from_beta([2e-4, 2e-4], 0.0, [1.0; 2], [1.4; 2]).unwrap(),
            ..Problem::new(annulus(), WearLaw::NONE, press(F0))
        };
        let optimum = optimal_pressure(&case).unwrap();
        assert!(optimum.p_max.is_finite() && optimum.p_max > 0.0);
        assert_eq!(optimum.multipliers, vec![0.0]);
    }
    let refused = WearPair::from_beta([2e-4, 1e-4], 0.0, [1.0; 2], [1.0, 2.0]);
    assert!(matches!(refused, Err(WearError::NoWear { .. })));
}

#[test]
fn loads_that_no_pressure_carries_are_refused_by_name() {
    for moment in [30e3, 31e3, -45e3] {
        for (functional, q) in [
            (Functional::Steady, 1.0),
            (Functional::WearVolume, 1.0),
            (Functional::WearVolume, 0.3),
            (Functional::WearVolume, -2.0),
            (Functional::WearPower, f64::INFINITY),
        ] {
            let case = problem(punch(), functional.clone(), q, 1.0, 1.0, press_and_tilt(1e3, moment));
            assert!(infeasible(&case), "{functional:?} {q} {moment}: {:?}", optimal_pressure(&case).map(|o| o.regime));
        }
    }
    for force in [0.0, -5.0] {
        assert!(infeasible(&problem(punch(), Functional::Steady, 1.0, 1.0, 1.0, press(force))));
    }
    // Self-locking: an arc on the trailing side beyond atan(mu).
    let shape = Shape::Arc { radius: 200.0, centre: Vector3::zeros(), angles: [-1.2, -1.0], thickness: 10.0, internal: false };
    let surface = Surface::new(shape, SlidingMotion::in_plane(2.5, Vector3::zeros())).unwrap();
    let mut case = problem(surface, Functional::Steady, 1.0, 1.0, 1.0, press(1e3));
    case.friction = 0.9;
    assert!(infeasible(&case));
    case.friction = 0.2;
    assert!(optimal_pressure(&case).is_ok());
}

#[test]
fn arc_beyond_ninety_degrees_touches_where_it_closes() {
    let shape = Shape::Arc { radius: 200.0, centre: Vector3::zeros(), angles: [-2.0, 2.0], thickness: 10.0, internal: false };
    let surface = Surface::new(shape, SlidingMotion::in_plane(2.5, Vector3::zeros())).unwrap();
    let optimum = optimal_pressure(&problem(surface.clone(), Functional::Steady, 1.0, 1.0, 1.0, press(1e4))).unwrap();
    assert_eq!(optimum.regime, Regime::PartialContact);
    // p_max R t pi/2 = F0.
    assert_relative_eq!(optimum.p_max, 1e4 / (2000.0 * std::f64::consts::FRAC_PI_2), max_relative = 1e-12);
    let maximum = problem(surface, Functional::WearVolume, 0.5, 1.0, 1.0, press(1e4));
    assert!(matches!(optimal_pressure(&maximum), Err(WearError::Infeasible { .. })));
}

fn infeasible(case: &Problem) -> bool {
    matches!(optimal_pressure(case), Err(WearError::Infeasible { .. }))
}

#[test]
fn the_largest_pressure_of_a_tilted_ellipse_lies_on_its_border() {
    let surface = Surface::new(Shape::Ellipse { semi_axes: [45.0, 41.0] }, SlidingMotion::along_x(10.0)).unwrap();
    let (force, x, y) = (1e3, -0.56 * 45.0, -0.59 * 41.0);
    let modes = vec![
        RigidMode::press_down(force),
        RigidMode::tilt(force * x, Vector3::zeros()),
        RigidMode::tilt_y(force * y, Vector3::zeros()),
    ];
    for b in [0.5, 1.0, 2.0, 5.0] {
        let optimum = optimal_pressure(&problem(surface.clone(), Functional::Steady, 1.0, 1.0, b, modes.clone())).unwrap();
        // By symmetry in scaled coordinates the highest place is where the load points to.
        let (u, v) = (x / 45.0, y / 41.0);
        let size = f64::hypot(u, v);
        let place = Vector3::new(45.0 * u / size, 41.0 * v / size, 0.0);
        let p = optimum.pressure_at(&surface.point(place, Vector3::z(), 1.0));
        assert_relative_eq!(optimum.p_max, p, max_relative = 1e-7);
    }
    let beyond = vec![
        RigidMode::press_down(force),
        RigidMode::tilt(force * 1.4 * x, Vector3::zeros()),
        RigidMode::tilt_y(force * 1.4 * y, Vector3::zeros()),
    ];
    assert!(infeasible(&problem(surface, Functional::Steady, 1.0, 1.0, 5.0, beyond)));
}

#[test]
fn full_disc_down_to_its_centre() {
    let surface = Surface::new(Shape::Annulus { radii: [0.0, 100.0] }, SlidingMotion::about_z(3.0)).unwrap();
    let case = problem(surface, Functional::WearPower, 1.0, 1.0, 1.0, press(1e4));
    let optimum = optimal_pressure(&case).unwrap();
    // p = F/(2 pi R r), torque mu F R/2.
    assert_relative_eq!(optimum.effective_radius.unwrap(), 50.0, max_relative = 1e-12);
    let p = optimum.pressure_at(&plane_at(&case.surface, 40.0));
    assert_relative_eq!(p, 1e4 / (std::f64::consts::TAU * 100.0 * 40.0), max_relative = 1e-12);
}

#[test]
fn pressure_cap_makes_the_singular_optimum_practical() {
    // Friction power, q = 1, annulus: p = p_max from r_i outward, the classical bang-bang.
    let mut case = problem(annulus(), Functional::FrictionPower, 1.0, 1.0, 1.0, press(F0));
    case.p_max = Some(300.0);
    let optimum = optimal_pressure(&case).unwrap();
    let outer = (20.0_f64.powi(2) + F0 / (300.0 * std::f64::consts::PI)).sqrt();
    assert_relative_eq!(optimum.pressure_at(&plane_at(&annulus(), outer - 1e-6)), 300.0, max_relative = 1e-12);
    assert_eq!(optimum.pressure_at(&plane_at(&annulus(), outer + 1e-6)), 0.0);
    assert_relative_eq!(optimum.resultants[0], F0, max_relative = 1e-11);
    assert_eq!(optimum.character, Character::Minimum);
    // A regular optimum is only clipped: C r^-n outside, p_max inside, same balance.
    let mut case = problem(annulus(), Functional::WearPower, 1.0, 1.0, 1.0, press(F0));
    case.p_max = Some(200.0);
    let optimum = optimal_pressure(&case).unwrap();
    let at = |r| optimum.pressure_at(&plane_at(&annulus(), r));
    assert_relative_eq!(at(20.0), 200.0, max_relative = 1e-12);
    assert_relative_eq!(at(60.0) / at(120.0), 2.0, max_relative = 1e-12);
    assert_relative_eq!(optimum.resultants[0], F0, max_relative = 1e-11);
    // The multiplier is still the derivative of the objective.
    let value = |force: f64| optimal_pressure(&Problem { modes: press(force), ..case.clone() }).unwrap().objective.unwrap();
    let h = 1e-4 * F0;
    let slope = (value(F0 + h) - value(F0 - h)) / (2.0 * h);
    assert_relative_eq!(optimum.multipliers[0], slope, max_relative = 1e-6);
    // With moments, and a cap that cannot carry the load.
    let mut case = problem(punch(), Functional::Steady, 1.0, 1.0, 1.0, press_and_tilt(1e3, 12e3));
    case.p_max = Some(3.5);
    let optimum = optimal_pressure(&case).unwrap();
    assert_relative_eq!(optimum.p_max, 3.5, max_relative = 1e-12);
    assert_relative_eq!(optimum.resultants[1], 12e3, max_relative = 1e-10);
    case.p_max = Some(1.0);
    assert!(matches!(optimal_pressure(&case), Err(WearError::Infeasible { .. })));
}

#[test]
fn kinematic_and_associated_modes_differ_as_recorded() {
    // mu = .25, wear power, q = 1, b = 1/2: p associated over kinematic -28 % at -30, -1.7 % at 0, +29 % at +30 degrees.
    let case = problem(drum(), Functional::WearPower, 1.0, 1.0, 0.5, press(1e4));
    let kinematic = optimal_pressure(&case).unwrap();
    let associated = optimal_pressure(&Problem { mode_kind: Modes::Associated, ..case }).unwrap();
    for (degrees, change) in [(-30.0, -0.28), (0.0, -0.017), (30.0, 0.29)] {
        let point = crate::surfaces::drum_at(&drum(), degrees);
        let ratio = associated.pressure_at(&point) / kinematic.pressure_at(&point) - 1.0;
        assert!((ratio - change).abs() < 6e-3, "{degrees}: {ratio}");
    }
}

#[test]
fn a_list_of_points_is_solved_on_its_own_quadrature() {
    let listed = Surface::from_points(annulus().sample(4001)).unwrap();
    let exact = optimal_pressure(&problem(annulus(), Functional::Steady, 1.0, 1.0, 1.4, press(F0))).unwrap();
    let optimum = optimal_pressure(&problem(listed, Functional::Steady, 1.0, 1.0, 1.4, press(F0))).unwrap();
    assert_relative_eq!(optimum.resultants[0], F0, max_relative = 1e-13);
    assert_relative_eq!(optimum.p_max, exact.p_max, max_relative = 1e-5);
    assert_eq!(optimum.points.len(), 4001);
    let point = plane_at(&annulus(), 77.7);
    assert_relative_eq!(optimum.pressure_at(&point), exact.pressure_at(&point), max_relative = 1e-5);
}

#[test]
fn counterface_alone_wearing_under_a_fresh_plate_is_refused() {
    let case =
        Problem { wear: WearPair::archard([0.0, 1e-6], [1.0; 2], [1.0; 2]), ..Problem::new(punch(), WearLaw::NONE, press(1e3)) };
    assert!(matches!(optimal_pressure(&case), Err(WearError::NoWear { .. })));
    let ring = Problem { surface: annulus(), counterface: Counterface::Congruent, ..case };
    assert!(optimal_pressure(&ring).unwrap().steadiness_residual.unwrap() < 1e-13);
}
