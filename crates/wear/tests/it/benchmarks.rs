//! Numbers every engineer or tribologist checks first: rows "From the paper", "Wear" and "Machine design" of the benchmark list that
//! need no finite elements.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use nalgebra::Vector3;
use wear::{
    Character, Counterface, Functional, Problem, Regime, RigidMode, RigidMotion, Shape, SlidingMotion, Surface, WearLaw,
    WearPair, optimal_pressure,
};

use crate::surfaces::{annulus, drum, drum_at, plane_at, problem, punch};

const F0: f64 = 4398229.715025711;

fn press(force: f64) -> Vec<RigidMode> {
    vec![RigidMode::press_down(force)]
}

fn radius(functional: Functional, q: f64) -> f64 {
    optimal_pressure(&problem(annulus(), functional, q, 1.0, 1.0, press(F0))).unwrap().effective_radius.unwrap()
}

#[test]
fn wear_ratio_of_the_annulus_to_six_digits() {
    let table = [
        (1.05, 0.379085),
        (1.2, 0.620990),
        (1.4, 0.815790),
        (1.6, 0.895668),
        (1.7, 0.917323),
        (1.8, 0.932786),
        (1.9, 0.944219),
        (2.0, 0.952920),
    ];
    for (b, wanted) in table {
        let volume =
            |functional| optimal_pressure(&problem(annulus(), functional, 1.0, 1.0, b, press(F0))).unwrap().wear_volume_rate;
        let ratio = volume(Functional::WearVolume) / volume(Functional::WearPower);
        assert_abs_diff_eq!(ratio, wanted, epsilon = 6e-7);
    }
}

#[test]
fn edge_pressures_of_the_annulus_for_least_wear_power() {
    for (b, inner, outer) in [(1.05, 331.261, 60.128), (2.0, 191.649, 78.240)] {
        let case = problem(annulus(), Functional::WearPower, 1.0, 1.0, b, press(F0));
        let optimum = optimal_pressure(&case).unwrap();
        assert_abs_diff_eq!(optimum.p_max, inner, epsilon = 6e-4);
        assert_abs_diff_eq!(optimum.p_min, outer, epsilon = 6e-4);
    }
}

#[test]
fn effective_radii_of_the_annulus_over_q() {
    let power = [
        (0.3, 88.535),
        (0.4, 96.062),
        (0.45, 104.001),
        (0.55, 27.735),
        (0.6, 43.002),
        (0.75, 62.997),
        (1.0, 70.000),
        (2.0, 74.342),
        (5.0, 75.712),
        (10.0, 76.065),
        (f64::INFINITY, 76.381),
        (0.505, 20.421),
        (0.495, 117.714),
    ];
    for (q, wanted) in power {
        assert_abs_diff_eq!(radius(Functional::WearPower, q), wanted, epsilon = 6e-4);
    }
    for (q, wanted) in [(0.9, 110.0), (0.99, 118.824), (1.01, 20.204), (1.1, 22.5), (2.0, 55.811), (10.0, 68.485)] {
        assert_abs_diff_eq!(radius(Functional::FrictionPower, q), wanted, epsilon = 6e-4);
    }
    let peak = |q| optimal_pressure(&problem(annulus(), Functional::WearPower, q, 1.0, 1.0, press(F0))).unwrap();
    assert_relative_eq!(peak(0.505).p_max, 84_875.0, max_relative = 1e-5);
    assert_relative_eq!(peak(0.495).p_max, 2503.5, max_relative = 2e-5);
    assert_eq!(peak(0.505).regime, Regime::NearSingular);
    assert_eq!(peak(0.495).regime, Regime::NearSingular);
    assert_eq!(peak(1.0).regime, Regime::Regular);
}

#[test]
fn drum_exponents_under_true_equilibrium() {
    let rows = [
        (f64::INFINITY, 5.0, 5.0),
        (2.0, 5.22678, 4.52653),
        (1.5, 5.45455, 4.09091),
        (1.05, 9.37072, 0.52770),
        (0.95, 1.35900, 24.13277),
    ];
    for (s, centre, edge) in rows {
        let optimum = optimal_pressure(&problem(drum(), Functional::FrictionPower, s, 1.0, 1.0, press(1e4))).unwrap();
        let at = |degrees| optimum.pressure_at(&drum_at(&drum(), degrees));
        assert_abs_diff_eq!(at(0.0), centre, epsilon = 6e-6);
        assert_abs_diff_eq!(at(30.0), edge, epsilon = 6e-6);
        assert_relative_eq!(at(-30.0), at(30.0), max_relative = 1e-13);
        assert_relative_eq!(optimum.resultants[0], 1e4, max_relative = 1e-13);
    }
}

#[test]
fn steady_drum_is_a_power_of_the_cosine_and_not_uniform() {
    let case = Problem { friction: 0.25, ..Problem::new(drum(), WearLaw::from_beta(2e-4, 0.25, 1.0, 0.5), press(1e4)) };
    let optimum = optimal_pressure(&case).unwrap();
    assert_relative_eq!(optimum.pressure_at(&drum_at(&drum(), 0.0)), 5.454545, max_relative = 1e-6);
    assert_relative_eq!(optimum.pressure_at(&drum_at(&drum(), -30.0)), 4.090909, max_relative = 1e-6);
    assert!(optimum.steadiness_residual.unwrap() < 1e-14);
    assert_eq!(optimum.character, Character::Stationary);
    let uniform = Problem { functional: Functional::Uniform, ..case };
    let uniform = optimal_pressure(&uniform).unwrap();
    assert_relative_eq!(uniform.p_min, 5.0, max_relative = 1e-13);
    assert!(uniform.steadiness_residual.unwrap() > 0.01);
}

#[test]
fn equal_wear_of_a_revolving_drum_lowers_the_edge_pressure() {
    let law = WearLaw::from_beta(2e-4, 0.25, 1.0, 0.5);
    let case = Problem {
        wear: WearPair { rules: [law.into(), law.into()], active: true, friction_driven: true },
        counterface: Counterface::Revolving,
        ..Problem::new(drum(), law, press(1e4))
    };
    let optimum = optimal_pressure(&case).unwrap();
    let ratio = optimum.pressure_at(&drum_at(&drum(), 30.0)) / optimum.pressure_at(&drum_at(&drum(), 0.0));
    assert_abs_diff_eq!(ratio, 0.714, epsilon = 5e-4);
    assert!(optimum.steadiness_residual.unwrap() < 1e-13);
    // Body 1 wears by V cos - W2', with W2' the mean of body 2's wear over a turn.
    let turn = std::f64::consts::TAU * 200.0 * 10.0;
    let worn = |point: &wear::SurfacePoint| wear::wear_rate(&law, optimum.pressure_at(point), 500.0);
    let mean: f64 = optimum.points.iter().map(|point| point.weight * worn(point)).sum::<f64>() / turn;
    let feed = optimum.feed.as_ref().unwrap()[0];
    for point in &optimum.points {
        assert_relative_eq!(worn(point), feed * point.normal.z - mean, max_relative = 1e-12);
    }
}

#[test]
fn revolving_disc_under_a_pad_recedes_by_the_mean_along_each_track() {
    let shape = Shape::Sector { radii: [60.0, 110.0], angles: [-0.5, 0.5] };
    let surface = Surface::new(shape, SlidingMotion::about_z(10.0)).unwrap();
    let law = WearLaw { factor: 1e-7, speed_exponent: 1.0, pressure_exponent: 1.0 };
    let modes = vec![RigidMode::press_down(5000.0), RigidMode::tilt(0.0, Vector3::new(88.0, 0.0, 0.0))];
    let case = Problem {
        wear: WearPair { rules: [law.into(), law.into()], active: true, friction_driven: false },
        counterface: Counterface::Revolving,
        ..Problem::new(surface.clone(), law, modes)
    };
    let optimum = optimal_pressure(&case).unwrap();
    assert!(optimum.steadiness_residual.unwrap() < 1e-9, "{:?}", optimum.steadiness_residual);
    assert_relative_eq!(optimum.resultants[0], 5000.0, max_relative = 1e-10);
    assert!(optimum.resultants[1].abs() < 1e-6);
    // Along a track the pad's wear plus the disc's mean must be rigid: with b = 1 the mean over the pad is 1/pi of the turn.
    let feed = optimum.feed.unwrap();
    assert!(feed[0] > 0.0);
}

#[test]
fn punch_multipliers_and_edge_pressures_at_the_kern() {
    let modes = |moment| vec![RigidMode::press_down(1000.0), RigidMode::tilt(moment, Vector3::zeros())];
    let row = |b: f64| {
        let case = problem(punch(), Functional::WearPower, 1.0, 1.0, b, modes(5000.0));
        let optimum = optimal_pressure(&case).unwrap();
        let at = |x| optimum.pressure_at(&plane_at(&punch(), x)) / optimum.p_mean;
        [optimum.multipliers[1] * 30.0 / optimum.multipliers[0], at(30.0), at(-30.0)]
    };
    for (got, wanted) in row(2.0).iter().zip([0.88612582, 1.430662, 0.351531]) {
        assert_abs_diff_eq!(*got, wanted, epsilon = 6e-7);
    }
    for (got, wanted) in row(1.0).iter().zip([0.5, 1.5, 0.5]) {
        assert_abs_diff_eq!(*got, wanted, epsilon = 1e-12);
    }
    // Full contact up to 6 mm of excentricity for b = 2; an edge pressure of exactly zero there is still full contact.
    let regime =
        |moment| optimal_pressure(&problem(punch(), Functional::WearPower, 1.0, 1.0, 2.0, modes(moment))).unwrap().regime;
    assert_eq!(regime(5999.9), Regime::Regular);
    assert_eq!(regime(6000.1), Regime::PartialContact);
    // b = 1 at e = 2 c/3: triangle of length 3 (c - e) = 30.
    let case = problem(punch(), Functional::Steady, 1.0, 1.0, 1.0, modes(20_000.0));
    let optimum = optimal_pressure(&case).unwrap();
    assert_relative_eq!(optimum.pressure_at(&plane_at(&punch(), 15.0)), 0.5 * optimum.p_max, max_relative = 1e-12);
    assert_relative_eq!(optimum.p_max, 2.0 * 1000.0 / (30.0 * 10.0), max_relative = 1e-12);
    assert_eq!(optimum.pressure_at(&plane_at(&punch(), -1e-6)), 0.0);
}

#[test]
fn clutch_torque_by_one_formula_from_uniform_wear_to_uniform_pressure() {
    assert_relative_eq!(radius(Functional::WearPower, 1.0), 70.0, max_relative = 1e-13);
    let uniform = 2.0 / 3.0 * (120_f64.powi(3) - 20_f64.powi(3)) / (120_f64.powi(2) - 20_f64.powi(2));
    assert_relative_eq!(uniform, 81.905, max_relative = 1e-5);
    assert_relative_eq!(radius(Functional::Uniform, 1.0), uniform, max_relative = 1e-13);
    for (a, b) in [(0.9, 0.5), (0.7, 1.3), (2.0, 0.4)] {
        let case = problem(annulus(), Functional::Steady, 1.0, a, b, press(F0));
        let power = |n: f64| (120_f64.powf(n) - 20_f64.powf(n)) / n;
        let wanted = power(3.0 - a / b) / power(2.0 - a / b);
        assert_relative_eq!(optimal_pressure(&case).unwrap().effective_radius.unwrap(), wanted, max_relative = 1e-12);
    }
}

/// Shigley, Mechanical Engineering Design, example 16-2: internal shoes on a drum of radius 150 mm, pin 122.654 mm from the centre,
/// lining from 0 to 126 degrees seen from the pin, width 32 mm, mu = .32, largest pressure 1 MPa.
pub(crate) fn pinned_shoe(omega: f64, b: f64, moment: f64) -> Problem {
    let shape = Shape::Arc {
        radius: 150.0,
        centre: Vector3::zeros(),
        angles: [0.0, 126_f64.to_radians()],
        thickness: 32.0,
        internal: true,
    };
    let surface = Surface::new(shape, SlidingMotion::in_plane(omega, Vector3::zeros())).unwrap();
    let pin = Vector3::new(0.0, 0.0, 122.654);
    let motion = RigidMotion::Rotation { axis: -Vector3::y(), about: pin };
    let law = WearLaw::from_beta(1e-6, 0.32, 1.0, b);
    Problem { friction: 0.32, ..Problem::new(surface, law, vec![RigidMode { motion, resultant: moment }]) }
}

#[test]
fn pinned_long_shoe_of_the_textbook() {
    // Actuating force 2.2791 kN at 212 mm from the pin; both shoes carry the same force.
    let moment = 2279.1 * 212.0;
    let leading = optimal_pressure(&pinned_shoe(10.0, 1.0, moment)).unwrap();
    assert_relative_eq!(leading.p_max, 1.0, max_relative = 3e-4);
    assert_relative_eq!(leading.torque.unwrap(), 365.8e3, max_relative = 3e-4);
    let trailing = optimal_pressure(&pinned_shoe(-10.0, 1.0, moment)).unwrap();
    assert_relative_eq!(trailing.torque.unwrap(), 161.9e3, max_relative = 3e-4);
    // The two moments of the textbook, at the pressure of the leading shoe: M_n = 787.3, M_f = 304.2 N m.
    let scale = 1.0 / leading.p_max;
    let pressing: f64 = leading
        .points
        .iter()
        .zip(&leading.pressure)
        .map(|(point, p)| scale * point.weight * p * 122.654 * point.position.x / 150.0)
        .sum();
    assert_relative_eq!(pressing, 787.3e3, max_relative = 1e-4);
    assert_relative_eq!(pressing - scale * moment, 304.2e3, max_relative = 1e-3);
    // p ~ sin(theta)^(1/b): p ~ sin for b = 1.
    for b in [1.0, 0.5, 2.0, 3.0] {
        let case = pinned_shoe(10.0, b, moment);
        let optimum = optimal_pressure(&case).unwrap();
        let at = |angle: f64| {
            let outward = Vector3::new(angle.sin(), 0.0, angle.cos());
            optimum.pressure_at(&case.surface.point(outward * 150.0, -outward, 0.0))
        };
        for angle in [0.1, 0.8, 2.0] {
            let wanted = f64::sin(angle).powf(1.0 / b) * at(std::f64::consts::FRAC_PI_2);
            assert_relative_eq!(at(angle), wanted, max_relative = 1e-12);
        }
        assert_relative_eq!(optimum.resultants[0], moment, max_relative = 1e-12);
        assert_eq!(optimum.regime, Regime::Regular);
    }
}

#[test]
fn pivoted_long_shoe_of_the_textbook() {
    let a0 = 30_f64.to_radians();
    let case = Problem::new(drum(), WearLaw::from_beta(2e-4, 0.25, 1.0, 1.0), press(1e4));
    let optimum = optimal_pressure(&case).unwrap();
    let p_max = 1e4 / (200.0 * 10.0 * (a0 + a0.sin() * a0.cos()));
    assert_relative_eq!(optimum.p_max, p_max, max_relative = 1e-13);
    assert_eq!(optimum.character, Character::Minimum);
}

#[test]
fn rigid_sphere_pin_and_archard_depth_from_the_rule() {
    // Depth sqrt(k F s / (pi R)) of a sphere worn flat: F = p pi 2 R depth, d(depth)/ds = k p.
    let (k, force, r) = (1.33e-7, 21.0, 5.0);
    let law = WearLaw { factor: k, speed_exponent: 1.0, pressure_exponent: 1.0 };
    for (metres, wanted) in [(0.5, 9.429e-3), (1.0, 13.335e-3), (2.0, 18.858e-3), (4.5, 28.287e-3)] {
        let distance: f64 = metres * 1e3;
        let depth = (k * force * distance / (std::f64::consts::PI * r)).sqrt();
        assert_abs_diff_eq!(depth, wanted, epsilon = 6e-7);
        // The rule per unit of distance at that depth is the derivative of the closed form.
        let pressure = force / (2.0 * std::f64::consts::PI * r * depth);
        let slope = depth / (2.0 * distance);
        assert_relative_eq!(wear::wear_rate(&law, pressure, 1.0), slope, max_relative = 1e-12);
    }
}

#[test]
fn plane_surfaces_with_two_moments_follow_the_bending_formula_for_b_1() {
    let law = WearLaw { factor: 1e-7, speed_exponent: 1.0, pressure_exponent: 1.0 };
    let modes = vec![
        RigidMode::press_down(1000.0),
        RigidMode::tilt(1500.0, Vector3::zeros()),
        RigidMode::tilt_y(-900.0, Vector3::zeros()),
    ];
    let cases = [
        (Shape::Rectangle { x: [-20.0, 20.0], y: [-10.0, 10.0] }, 800.0, 800.0 * 1600.0 / 12.0, 800.0 * 400.0 / 12.0),
        (
            Shape::Ellipse { semi_axes: [20.0, 10.0] },
            std::f64::consts::PI * 200.0,
            std::f64::consts::PI * 200.0 * 100.0,
            std::f64::consts::PI * 200.0 * 25.0,
        ),
    ];
    for (shape, area, inertia_x, inertia_y) in cases {
        let surface = Surface::new(shape, SlidingMotion::along_x(5.0)).unwrap();
        let optimum = optimal_pressure(&Problem::new(surface.clone(), law, modes.clone())).unwrap();
        for (x, y) in [(0.0, 0.0), (10.0, 3.0), (-12.0, -5.0)] {
            let wanted = 1000.0 / area + 1500.0 * x / inertia_x - 900.0 * y / inertia_y;
            let got = optimum.pressure_at(&surface.point(Vector3::new(x, y, 0.0), Vector3::z(), 0.0));
            assert_relative_eq!(got, wanted, max_relative = 1e-11);
        }
        assert_relative_eq!(optimum.normal_force, 1000.0, max_relative = 1e-13);
    }
}

#[test]
fn rectangle_pressed_beyond_its_kern_in_two_directions_carries_its_load() {
    let law = |b| WearLaw { factor: 1e-7, speed_exponent: 1.0, pressure_exponent: b };
    for shape in [Shape::Rectangle { x: [-20.0, 20.0], y: [-10.0, 10.0] }, Shape::Ellipse { semi_axes: [20.0, 10.0] }] {
        for b in [0.5, 1.0, 2.0] {
            let surface = Surface::new(shape.clone(), SlidingMotion::along_x(5.0)).unwrap();
            let modes = vec![
                RigidMode::press_down(1000.0),
                RigidMode::tilt(8000.0, Vector3::zeros()),
                RigidMode::tilt_y(3000.0, Vector3::zeros()),
            ];
            let optimum = optimal_pressure(&Problem::new(surface, law(b), modes)).unwrap();
            assert_eq!(optimum.regime, Regime::PartialContact);
            for (got, wanted) in optimum.resultants.iter().zip([1000.0, 8000.0, 3000.0]) {
                assert_relative_eq!(*got, wanted, max_relative = 1e-10);
            }
            assert!(optimum.steadiness_residual.unwrap() < 1e-9);
        }
    }
    // One moment alone: the strip's closed form, width 20 in place of the thickness.
    let surface = Surface::new(Shape::Rectangle { x: [-20.0, 20.0], y: [-10.0, 10.0] }, SlidingMotion::along_x(5.0)).unwrap();
    let modes = vec![RigidMode::press_down(1000.0), RigidMode::tilt(12_000.0, Vector3::zeros())];
    let optimum = optimal_pressure(&Problem::new(surface, law(2.0), modes)).unwrap();
    let length = (0.5 + 2.0) * (20.0 - 12.0);
    assert_relative_eq!(optimum.p_max, 1000.0 * 1.5 / (20.0 * length), max_relative = 1e-8);
}

/// At the place where a pressure ends, as near as numbers come to it, there is none: with p ~ sqrt(distance) round-off would be 1e-8 of the largest.
#[test]
fn a_pressure_is_zero_at_its_end() {
    let law = WearLaw { factor: 1e-7, speed_exponent: 1.0, pressure_exponent: 2.0 };
    for middle in [0.0, -50.0, 37.3] {
        let shape = Shape::Rectangle { x: [middle - 20.0, middle + 20.0], y: [-10.0, 10.0] };
        let surface = Surface::new(shape, SlidingMotion::along_x(5.0)).unwrap();
        let about = Vector3::new(middle, 0.0, 0.0);
        let modes = vec![RigidMode::press_down(1000.0), RigidMode::tilt(12_000.0, about)];
        let optimum = optimal_pressure(&Problem::new(surface.clone(), law, modes)).unwrap();
        let at = |x: f64| surface.point(Vector3::new(x, 0.0, 0.0), Vector3::z(), 5.0);
        let (mut open, mut pressed) = (middle - 20.0, middle + 20.0);
        for _ in 0..200 {
            let half = 0.5 * (open + pressed);
            if optimum.presses_at(&at(half)) { pressed = half } else { open = half }
        }
        assert_relative_eq!(pressed, middle, epsilon = 1e-9);
        for x in [open, pressed, pressed + 4e-14, pressed.next_up().next_up()] {
            assert_eq!(optimum.pressure_at(&at(x)), 0.0, "{middle}: {x}");
        }
        // p = p_max sqrt(distance / 20).
        for distance in [1e-9, 1e-6, 5.0] {
            let wanted = optimum.p_max * (distance / 20.0_f64).sqrt();
            assert_relative_eq!(optimum.pressure_at(&at(pressed + distance)), wanted, max_relative = 1e-4);
        }
    }
}
