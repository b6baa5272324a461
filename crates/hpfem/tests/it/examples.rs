//! The examples of the crate with their numbers pinned.
#![allow(unreachable_pub)]

#[path = "../../examples/composite_wall.rs"]
mod composite_wall;
#[path = "../../examples/cook.rs"]
mod cook;
#[path = "../../examples/fin.rs"]
mod fin;
#[path = "../../examples/from_gmsh.rs"]
mod from_gmsh;
#[path = "../../examples/gravity_and_spin.rs"]
mod gravity_and_spin;
#[path = "../../examples/hot_rim.rs"]
mod hot_rim;
#[path = "../../examples/l_shape.rs"]
mod l_shape;
#[path = "../../examples/long_rotor.rs"]
mod long_rotor;
#[path = "../../examples/modes.rs"]
mod modes;
#[path = "../../examples/nearly_incompressible.rs"]
mod nearly_incompressible;
#[cfg(feature = "vtu")]
#[path = "../../examples/outputs.rs"]
mod outputs;
#[path = "../../examples/own_mortar.rs"]
mod own_mortar;
#[path = "../../examples/plate_with_a_hole.rs"]
mod plate_with_a_hole;
#[path = "../../examples/poisson.rs"]
mod poisson;
#[path = "../../examples/thick_cylinder.rs"]
mod thick_cylinder;
#[path = "../../examples/torsion_groove.rs"]
mod torsion_groove;
#[path = "../../examples/two_materials.rs"]
mod two_materials;

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
    // More than there are digits for: the last level is told as it is.
    let [before, last] = [1e-11, 1e-14].map(|accuracy| l_shape::strain_energy(accuracy).unwrap());
    assert!(before.1 <= 1e-11 && last.1 < 1e-11, "{before:?} {last:?}");
    assert_relative_eq!(last.0, before.0, max_relative = 1e-11);
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

#[test]
fn a_file_with_exact_circles_reaches_lame_where_its_own_edges_stall() {
    let [file, exact] = from_gmsh::errors(10).unwrap();
    assert!(file > 1e-5 && exact < 1e-12, "{file:e} {exact:e}");
}

#[test]
fn the_compound_tube_meets_lame_at_its_joint() {
    assert_relative_eq!(two_materials::joint_stress(14).unwrap(), two_materials::exact(), max_relative = 1e-11);
}

#[test]
fn the_mean_stress_converges_near_one_half_and_is_refused_beyond() {
    let [near, nearer] = [0.4999, 0.49999].map(|poisson| nearly_incompressible::mean_stress_error(poisson, 12).unwrap());
    assert!(near < 2e-7 && nearer < 2e-6, "{near:e} {nearer:e}");
    assert!(nearly_incompressible::mean_stress_error(0.499999, 12).is_err());
}

#[test]
fn the_flywheel_weighs_and_spins_by_its_closed_forms() {
    for (value, exact) in gravity_and_spin::flywheel(12).unwrap().into_iter().zip(gravity_and_spin::exact()) {
        assert_relative_eq!(value, exact, max_relative = 1e-8);
    }
}

#[test]
fn the_energy_of_poissons_equation_on_the_l_is_that_of_the_literature() {
    // Torsion of an L of unit squares: int u = 0.2140758036.
    assert_relative_eq!(2.0 * poisson::energy(12, 14).unwrap(), 0.2140758036, max_relative = 1e-7);
}

#[test]
fn the_ring_rings_a_little_lower_than_a_thin_one() {
    let [coarse, fine] = [8, 10].map(|degree| modes::frequencies(degree, 4).unwrap());
    for ((a, b), n) in coarse.iter().zip(&fine).zip([2.0, 2.0, 3.0, 3.0]) {
        assert_relative_eq!(a, b, max_relative = 1e-8);
        let ratio = b / modes::thin_ring(n);
        assert!((0.98..1.0).contains(&ratio), "{ratio}");
    }
}

#[test]
fn a_bent_beam_goes_through_the_mortar_exactly() {
    assert!(own_mortar::stress_error(2, 2).unwrap() < 1e-12);
}

#[cfg(feature = "vtu")]
#[test]
fn the_cantilever_balances_and_is_written() {
    let (deflection, reaction, file) = outputs::cantilever(8).unwrap();
    // Timoshenko: F L^3 / (3 E I) + 1.2 F L / (G A).
    let beam = 10.0 * 1e6 / (3.0 * 210e3 * 1000.0 / 12.0) + 1.2 * 10.0 * 100.0 / (210e3 / 2.6 * 10.0);
    assert_relative_eq!(deflection, -beam, max_relative = 2e-3);
    for (value, exact) in reaction.into_iter().zip([0.0, 10.0, 1000.0]) {
        approx::assert_abs_diff_eq!(value, exact, epsilon = 1e-8);
    }
    assert!(file.starts_with("<?xml") && file.contains("von_mises"));
}

#[test]
fn a_composite_wall_has_the_temperatures_of_resistances_in_series() {
    for (value, exact) in composite_wall::temperatures(1).unwrap().into_iter().zip(composite_wall::exact()) {
        assert_relative_eq!(value, exact, max_relative = 1e-12);
    }
}

#[test]
fn a_fin_takes_in_the_heat_of_its_series() {
    let [rough, fine] = [6, 12].map(|degree| fin::fin(degree).unwrap());
    for (place, exact) in fin::exact().into_iter().enumerate() {
        assert_relative_eq!(fine[place], exact, max_relative = 1e-9);
        assert!((fine[place] - exact).abs() < 1e-2 * (rough[place] - exact).abs());
    }
}

#[test]
fn a_disc_with_a_hot_rim_has_the_stress_of_its_closed_form() {
    for (value, exact) in hot_rim::hoop_stress(18).unwrap().into_iter().zip(hot_rim::exact()) {
        assert_relative_eq!(value, exact, max_relative = 1e-9);
    }
}

#[test]
fn a_long_rotor_that_is_free_to_shorten_has_its_closed_form() {
    let (found, exact) = (long_rotor::rotor(10).unwrap(), long_rotor::exact());
    for (found, exact) in found.iter().zip(exact) {
        assert_relative_eq!(*found, exact, max_relative = 1e-10);
    }
}
