//! The examples of the crate with their numbers pinned.
#![allow(unreachable_pub)]

#[path = "../../examples/cook.rs"]
mod cook;
#[path = "../../examples/l_shape.rs"]
mod l_shape;
#[path = "../../examples/plate_with_a_hole.rs"]
mod plate_with_a_hole;
#[path = "../../examples/thick_cylinder.rs"]
mod thick_cylinder;
#[path = "../../examples/torsion_groove.rs"]
mod torsion_groove;

use approx::assert_relative_eq;

#[test]
fn plate_with_a_hole_converges_to_its_number() {
    let k = [12, 16].map(|p| plate_with_a_hole::stress_concentration(p).unwrap());
    // A short, narrow plate: above the factor 3 of the infinite one.
    assert_relative_eq!(k[0], k[1], max_relative = 3e-8);
    assert_relative_eq!(k[1], 3.5832159709, max_relative = 1e-9);
}

#[test]
fn l_shape_reaches_the_accuracy_it_was_asked_for() {
    for accuracy in [1e-2, 1e-4, 1e-6] {
        let (energy, estimate) = l_shape::strain_energy(accuracy).unwrap();
        assert!(estimate <= accuracy);
        assert_relative_eq!(energy, 8.58403065, max_relative = accuracy);
    }
    assert_relative_eq!(l_shape::strain_energy(1e-8).unwrap().0, 8.584030643548, max_relative = 1e-10);
}

#[test]
fn cooks_membrane_deflects_by_its_number() {
    assert_relative_eq!(cook::deflection(12, 8).unwrap(), 23.967750607133, max_relative = 1e-9);
}

#[test]
fn the_bore_of_a_thick_cylinder_moves_as_lame_says() {
    let exact = 1.3 / 210e3 * (50.0 / 3.0 * 0.4 + 200.0 / 3.0);
    assert_relative_eq!(thick_cylinder::bore_displacement(10).unwrap(), exact, max_relative = 1e-11);
}

#[test]
fn the_groove_concentrates_the_stress_by_its_number() {
    let k = [10, 14].map(|p| torsion_groove::stress_concentration(p).unwrap());
    assert_relative_eq!(k[0], k[1], max_relative = 1e-11);
    assert_relative_eq!(k[1], 1.643949227873, max_relative = 1e-11);
}
