//! Multipliers are dJ/dF_k, also where s is 1 and where two bodies wear by different rules below it: differences of J tell them.

use approx::assert_relative_eq;
use nalgebra::Vector3;
use wear::{
    Character, Functional, Optimum, Problem, RigidMode, Shape, SlidingMotion, Surface, WearLaw, WearPair, optimal_pressure,
};

fn annulus() -> Surface {
    Surface::new(Shape::Annulus { radii: [20.0, 120.0] }, SlidingMotion::about_z(2.5)).unwrap()
}

fn strip() -> Surface {
    Surface::new(Shape::Strip { x: [-25.0, 25.0], z: 0.0, thickness: 7.0 }, SlidingMotion::along_x(3.0)).unwrap()
}

fn law(factor: f64, a: f64, b: f64) -> WearLaw {
    WearLaw { factor, speed_exponent: a, pressure_exponent: b }
}

fn slope(at: impl Fn(f64) -> Optimum, force: f64) -> f64 {
    let of = |force: f64| at(force).objective.unwrap();
    (of(1.001 * force) - of(0.999 * force)) / (0.002 * force)
}

/// With friction power and a uniform speed every pressure of a force has the same J = mu v F, whatever its moment.
#[test]
fn where_every_pressure_does_the_multipliers_are_those_of_the_mode_that_is_the_cost() {
    for moment in [0.0, 2000.0, -3500.0] {
        let modes = vec![RigidMode::press_down(800.0), RigidMode::tilt(moment, Vector3::zeros())];
        let problem =
            Problem { functional: Functional::FrictionPower, friction: 0.3, ..Problem::new(strip(), law(3e-6, 1.0, 1.0), modes) };
        let found = optimal_pressure(&problem).unwrap();
        assert_eq!(found.character, Character::Indifferent);
        assert_relative_eq!(found.multipliers[0], 0.3 * 3.0, max_relative = 1e-12);
        assert_eq!(found.multipliers[1], 0.0);
    }
}

/// Under a cap, s = 1: the friction power and the wear volume, also as a square root of a square.
#[test]
fn under_a_cap_they_are_the_cost_where_the_pressure_ends() {
    for (functional, q, b) in
        [(Functional::FrictionPower, 1.0, 0.7), (Functional::WearVolume, 1.0, 1.0), (Functional::WearVolume, 2.0, 0.5)]
    {
        let at = |force: f64| {
            let problem = Problem::new(annulus(), law(3e-6, 1.3, b), vec![RigidMode::press_down(force)]);
            optimal_pressure(&Problem { functional: functional.clone(), q, friction: 0.25, p_max: Some(150.0), ..problem })
                .unwrap()
        };
        let found = at(3e6);
        assert_eq!(found.character, Character::Minimum);
        assert_relative_eq!(found.multipliers[0], slope(at, 3e6), max_relative = 1e-6);
    }
}

/// Different rules with both s below 1: the pressure falls where the modes grow, the multipliers are dJ/dF, and J has the sign of curvature that s says.
#[test]
fn two_rules_below_one_have_a_stationary_pressure() {
    for (functional, q, b) in [
        (Functional::WearVolume, 0.4, [0.5, 0.8]),
        (Functional::WearVolume, 0.9, [0.5, 0.55]),
        (Functional::WearVolume, -1.0, [0.5, 0.55]),
        (Functional::WearPower, -2.0, [1.0, 2.0]),
    ] {
        for (surface, modes) in [
            (annulus(), vec![RigidMode::press_down(4.4e6)]),
            (annulus(), vec![RigidMode::press_down(1.0)]),
            (strip(), vec![RigidMode::press_down(800.0), RigidMode::tilt(900.0, Vector3::zeros())]),
        ] {
            let of = |force: f64| {
                let mut modes = modes.clone();
                modes[0].resultant = force;
                let pair = WearPair::archard([2e-4, 1e-4], [1.0, 1.0], b);
                let problem = Problem {
                    functional: functional.clone(),
                    q,
                    friction: 0.25,
                    ..Problem::new(surface.clone(), law(1e-6, 1.0, 1.0), modes)
                };
                optimal_pressure(&Problem { wear: pair, ..problem }).unwrap()
            };
            let force = modes[0].resultant;
            let found = of(force);
            assert_relative_eq!(found.resultants[0], force, max_relative = 1e-10);
            assert_relative_eq!(found.multipliers[0], slope(of, force), max_relative = 1e-6);
        }
    }
}
