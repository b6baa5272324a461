//! Entries of data/reference/optimality.json with two wearing bodies, the counter-face, and the Winkler rate.

use approx::assert_relative_eq;
use nalgebra::Vector3;
use serde_json::Value;
use wear::{
    Character, Counterface, Functional, Regime, RigidMode, Surface, SurfacePoint, WearPair, optimal_pressure,
    stationary_pressures, wear_rate,
};

use crate::reference::{force_and_moment, functional, group, list, number, same};
use crate::surfaces::{annulus, plane_at, problem, punch};

fn pair(inputs: &Value) -> WearPair {
    let two = |key| <[f64; 2]>::try_from(list(inputs, key)).unwrap();
    WearPair::archard(two("beta_tilde"), two("a"), two("b"))
}

#[test]
fn two_bodies_with_different_speed_exponents() {
    for entry in group("two_body_annulus") {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let rtol = number(&entry, "rtol");
        let force = vec![RigidMode::press_down(number(inputs, "F0"))];
        let mut case = problem(annulus(), functional(inputs), number(inputs, "q"), 1.0, 1.0, force);
        case.wear = pair(inputs);
        let optimum = optimal_pressure(&case).unwrap();
        for (r, p) in list(outputs, "r").iter().zip(list(outputs, "p")) {
            same(id, "p", optimum.pressure_at(&plane_at(&case.surface, *r)), p, rtol);
        }
        same(id, "J", optimum.objective.unwrap(), number(outputs, "J"), rtol);
        same(id, "lambda", optimum.multipliers[0], number(outputs, "lambda_F"), rtol);
    }
}

#[test]
fn two_bodies_with_different_pressure_exponents() {
    for entry in group("two_body_general") {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let rtol = number(&entry, "rtol");
        let force = vec![RigidMode::press_down(number(inputs, "F0"))];
        let mut case = problem(annulus(), functional(inputs), number(inputs, "q"), 1.0, 1.0, force);
        case.wear = pair(inputs);
        case.counterface = Counterface::Congruent;
        let steady = inputs["steady"] == true;
        if steady {
            case.functional = Functional::Steady;
        }
        let optimum = optimal_pressure(&case).unwrap();
        for (r, p) in list(outputs, "r").iter().zip(list(outputs, "p")) {
            same(id, "p", optimum.pressure_at(&plane_at(&case.surface, *r)), p, rtol);
        }
        same(id, "lambda", optimum.multipliers[0], number(outputs, "lambda_F"), rtol);
        if steady {
            assert!(optimum.steadiness_residual.unwrap() < 1e-13);
            let power: f64 = list(outputs, "J_terms").iter().sum();
            same(id, "D_w", optimum.wear_power, power, rtol);
        } else {
            same(id, "J", optimum.objective.unwrap(), number(outputs, "J"), rtol);
        }
        assert_eq!(optimum.character, Character::Minimum);
    }
}

#[test]
fn two_pads_have_three_stationary_pressures() {
    for entry in group("nonuniqueness") {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let rtol = number(&entry, "rtol");
        let points: Vec<SurfacePoint> = list(inputs, "v")
            .iter()
            .zip(list(inputs, "weights"))
            .map(|(v, weight)| SurfacePoint {
                position: Vector3::new(*v, 0.0, 0.0),
                normal: Vector3::z(),
                weight,
                sliding_speed: *v,
                drag: Vector3::y(),
            })
            .collect();
        let surface = Surface::from_points(points).unwrap();
        let mut case = problem(surface, Functional::WearVolume, number(inputs, "q"), 1.0, 1.0, vec![RigidMode::press_down(1.0)]);
        let b = number(inputs, "b");
        let ratio = number(inputs, "log_beta_ratio").exp();
        case.wear = WearPair::archard([1.0, ratio], list(inputs, "a").try_into().unwrap(), [b, b]);
        let mut found = stationary_pressures(&case).unwrap();
        let mut wanted = outputs["stationary"].as_array().unwrap().clone();
        assert_eq!(found.len(), wanted.len());
        found.sort_by(|a, b| a.pressure[0].total_cmp(&b.pressure[0]));
        wanted.sort_by(|a, b| list(a, "p")[0].total_cmp(&list(b, "p")[0]));
        for (optimum, wanted) in found.iter().zip(&wanted) {
            for (got, p) in optimum.pressure.iter().zip(list(wanted, "p")) {
                same(id, "p", *got, p, rtol);
            }
            same(id, "J", optimum.objective.unwrap(), number(wanted, "J"), rtol);
        }
        let best = optimal_pressure(&case).unwrap();
        assert_eq!(best.regime, Regime::Several);
        assert_relative_eq!(best.objective.unwrap(), 1.086146447836938, max_relative = rtol);
    }
}

#[test]
fn counterface_wears_by_equation_43a() {
    for entry in group("counterface") {
        let (id, inputs, outputs) = (&entry["id"], &entry["inputs"], &entry["outputs"]);
        let rtol = number(&entry, "rtol").max(1e-12);
        let mut case = problem(punch(), Functional::WearPower, 1.0, 1.0, 2.0, force_and_moment(inputs));
        let bt: [f64; 2] = list(inputs, "beta_tilde").try_into().unwrap();
        case.wear = WearPair::archard(bt, list(inputs, "a").try_into().unwrap(), [2.0, 2.0]);
        let optimum = optimal_pressure(&case).unwrap();
        same(id, "lambda", optimum.multipliers[0], number(outputs, "lambda_F"), rtol);
        // One pass of the punch (thickness 10) wears the plate by w2 = int w2'/v dx.
        let [law1, law2] = [0, 1].map(|i| *case.wear.rules[i].power().unwrap());
        let rate = |(point, p): (&SurfacePoint, &f64)| point.weight * wear_rate(&law2, *p, 5.0) / (5.0 * 10.0);
        let depth: f64 = optimum.points.iter().zip(&optimum.pressure).map(rate).sum();
        same(id, "w2 (41)", depth, number(outputs, "w2_quadrature_eq41"), rtol);
        let feed = optimum.feed.unwrap()[0];
        let rates = [law1, law2].map(|law| law.factor * 5.0_f64.powf(law.speed_exponent));
        let closed = rates[1] / (rates[0] + rates[1]) * 60.0 / 5.0 * feed;
        same(id, "w2 (43a)", closed, number(outputs, "w2_eq43a"), rtol);
    }
}

#[test]
fn winkler_rate_is_stiffness_times_the_slope_of_the_wear_rule() {
    // The transient itself and the half-plane eigenvalues (entry transient_halfplane_kappa) belong to the evolution, not to this crate.
    for entry in group("transient").iter().filter(|entry| entry["inputs"]["kf"].is_number()) {
        let inputs = &entry["inputs"];
        let law =
            wear::WearLaw { factor: number(inputs, "beta_tilde"), speed_exponent: 1.0, pressure_exponent: number(inputs, "b") };
        let slope = law.pressure_exponent * wear_rate(&law, 3.0, number(inputs, "v")) / 3.0;
        let rate = number(inputs, "kf") * slope;
        same(&entry["id"], "rate", rate, number(&entry["outputs"], "rate"), 1e-12);
    }
}
