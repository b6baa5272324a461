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
