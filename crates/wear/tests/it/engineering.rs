//! The examples.

use approx::assert_relative_eq;
use wear::WearError;

#[path = "../../examples/clutch_torque.rs"]
#[allow(dead_code)]
mod clutch_torque;
#[path = "../../examples/own_wear_law.rs"]
#[allow(dead_code)]
mod own_wear_law;
#[path = "../../examples/pinned_shoe.rs"]
#[allow(dead_code)]
mod pinned_shoe;
#[path = "../../examples/punch_beyond_kern.rs"]
#[allow(dead_code)]
mod punch_beyond_kern;

#[test]
fn example_own_wear_law() {
    own_wear_law::main().unwrap();
    // Beyond the kern part of the face lifts under this law too.
    let lifted = own_wear_law::punch([1e3, 1.5e4]).unwrap();
    assert_eq!(lifted.regime, wear::Regime::PartialContact);
}

#[path = "../../examples/table_wear_law.rs"]
#[allow(dead_code)]
mod table_wear_law;

#[path = "../../examples/largest_wear_rate.rs"]
#[allow(dead_code)]
mod largest_wear_rate;

#[test]
fn example_table_wear_law() {
    use table_wear_law::{clutch, measured};
    table_wear_law::main().unwrap();
    // Of a straight line the cubics are the line, within the table and beyond: Archard's hyperbola p = F/(2 pi (re - ri) r).
    let optimum = clutch(measured(&[[0.3, 0.06], [1.0, 0.2], [2.0, 0.4]]).unwrap()).unwrap();
    for (point, p) in optimum.points.iter().zip(&optimum.pressure) {
        let wanted = 5e4 / (std::f64::consts::TAU * 100.0 * point.position.x);
        assert!((p / wanted - 1.0).abs() < 1e-9, "{p} {wanted}");
    }
    // Of p^2 they come near with the third power of the distance, and their slope is that of differences.
    let error = |n: u32| {
        let pairs: Vec<[f64; 2]> = (1..=n).map(|i| 4.0 * f64::from(i) / f64::from(n)).map(|p| [p, p * p]).collect();
        let table = wear::TableLaw::new(&pairs).unwrap();
        let places = (1..400).map(|i| 0.01 * f64::from(i));
        places
            .map(|p| {
                let slope = (table.at(p + 1e-6)[0] - table.at(p - 1e-6)[0]) / 2e-6;
                assert!((table.at(p)[1] - slope).abs() < 1e-4 && table.at(p)[1] >= 0.0);
                (table.at(p)[0] - p * p).abs()
            })
            .fold(0.0, f64::max)
    };
    assert!(error(40) < 0.3 * error(20) && error(20) < 0.01, "{} {}", error(20), error(40));
    // A threshold is pairs without wear; what does not grow is refused.
    assert_eq!(wear::TableLaw::new(&[[0.4, 0.0], [1.0, 0.3]]).unwrap().at(0.3), [0.0; 2]);
    for pairs in [
        &[][..],
        &[[0.0, 1.0], [1.0, 2.0]],
        &[[1.0, 0.0]],
        &[[1.0, 0.2], [2.0, 0.2]],
        &[[2.0, 0.2], [1.0, 0.4]],
        &[[1.0, f64::NAN]],
    ] {
        assert!(wear::TableLaw::new(pairs).is_err(), "{pairs:?}");
    }
}

#[test]
fn example_largest_wear_rate() {
    use largest_wear_rate::{best, largest, spread};
    use wear::Functional;
    largest_wear_rate::main().unwrap();
    // Everywhere the same rate: k (p v^(a/b))^b with p = F v^(-a/b)/int v^(-a/b) dS, and no other optimum wears less at its worst place.
    let limit = best(Functional::WearVolume, f64::INFINITY).unwrap();
    assert!((spread(&limit) - 1.0).abs() < 1e-12);
    let e: f64 = 1.2 / 0.8;
    let integral = std::f64::consts::TAU * (120f64.powf(2.0 - e) - 20f64.powf(2.0 - e)) / (2.0 - e);
    let rate = 1e-8 * (5e3 / integral * 10f64.powf(e)).powf(0.8);
    assert!((largest(&limit) / rate - 1.0).abs() < 1e-10, "{} {rate}", largest(&limit));
    for (functional, q) in [
        (Functional::WearPower, 2.0),
        (Functional::WearVolume, 4.0),
        (Functional::Uniform, 1.0),
        (Functional::FrictionPower, 2.0),
    ] {
        assert!(largest(&best(functional, q).unwrap()) > rate);
    }
}

#[test]
fn example_clutch_torque() {
    clutch_torque::main().unwrap();
    let [new, worn] = clutch_torque::effective_radii(1.0, 1.0).unwrap();
    assert_relative_eq!(new, 81.904761904761, max_relative = 1e-12);
    assert_relative_eq!(worn, 70.0, max_relative = 1e-12);
}

#[test]
fn example_pinned_shoe() {
    pinned_shoe::main().unwrap();
    let torque = |omega| pinned_shoe::shoe(omega, 1.0, 2279.1 * 212.0).unwrap().torque.unwrap();
    assert_relative_eq!(torque(10.0) + torque(-10.0), 527.8e3, max_relative = 2e-4);
}

#[test]
fn example_punch_beyond_the_kern() {
    punch_beyond_kern::main().unwrap();
    let area = |e| punch_beyond_kern::punch(1.0, e).unwrap().points.iter().map(|p| p.weight).sum::<f64>();
    assert_relative_eq!(area(20.0), 10.0 * 3.0 * 10.0, max_relative = 1e-9);
    assert!(matches!(punch_beyond_kern::punch(1.0, 30.0), Err(WearError::Infeasible { .. })));
}
