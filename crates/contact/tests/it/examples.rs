//! The examples of the crate with their numbers pinned.
#![allow(unreachable_pub)]

#[path = "../../examples/hertz.rs"]
mod hertz;
#[path = "../../examples/own_compliance.rs"]
mod own_compliance;

use approx::assert_relative_eq;

#[test]
fn two_blocks_press_as_hertz_says() {
    let [[highest, hertz], [half, a]] = hertz::pressure_and_length().unwrap();
    assert_relative_eq!(highest, hertz, max_relative = 1e-4);
    assert_relative_eq!(highest, 606.01253, max_relative = 1e-7);
    // Open from the first point beyond the end of contact on.
    assert_relative_eq!(half, a, max_relative = 1e-2);
}

#[test]
fn boundary_elements_press_and_stick_as_hertz_and_mindlin_say() {
    let found = [60, 120, 240].map(|strips| own_compliance::errors(strips).unwrap());
    println!("{found:?}");
    // Pressure at second order; the ends to a strip.
    assert_relative_eq!(found[0][0] / found[2][0], 16.0, max_relative = 0.1);
    assert!(found[2][0].abs() < 2e-5 && found[2][1].abs() < 0.01 && found[2][2].abs() < 0.02);
}
