//! What belongs to another body or to none is told by its number; factors beyond all numbers are refused.

use crate::classics::rectangle;
use crate::common::*;
use hpfem::*;

/// A square of one cell, held at its left side, and a body of it.
fn pulled() -> Body {
    let problem = BodyProblem::new(rectangle([0.0, 1.0], [0.0, 1.0]), 2, PLANE_STRESS).clamp("left").keep("right");
    let pull = EdgeTraction::new("top", |p| p.outward);
    Body::new(problem.material(Material::isotropic(100.0, 0.3).unwrap()).load("pull", pull)).unwrap()
}

#[test]
#[should_panic(expected = "kept unknowns for an interface operator that has")]
fn the_energy_of_a_state_with_an_unknown_too_few_is_none() {
    let body = pulled();
    let mut state = body.solve(&[("pull", 1.0)]).unwrap();
    state.unknowns.pop();
    body.interface.strain_energy(&state);
}

#[test]
#[should_panic(expected = "a state of 8 factors for an interface operator that has 9 columns")]
fn the_work_in_a_state_from_before_a_load_is_none() {
    let mut body = pulled();
    let state = body.solve(&[("pull", 1.0)]).unwrap();
    body.add_load(LoadCase::new("later").with(EdgeTraction::new("top", |p| p.outward))).unwrap();
    body.interface.column_work(0, &state);
}

#[test]
#[should_panic(expected = "support 9 of an interface operator that has 2, its pins included")]
fn the_reaction_of_a_support_that_there_is_not_is_told_by_its_number() {
    let body = pulled();
    body.interface.reaction(9, &body.solve(&[]).unwrap());
}

#[test]
#[should_panic(expected = "a right-hand side of 1 numbers for")]
fn a_right_hand_side_of_another_body_is_told_by_its_length() {
    pulled().interface.solve_one(&[1.0]);
}

#[test]
#[should_panic(expected = "cell 9 of a mesh that has 1, counted from 0")]
fn the_map_of_a_cell_that_there_is_not_is_told_by_its_number() {
    rectangle([0.0, 1.0], [0.0, 1.0]).map(9, 0.0, 0.0);
}

#[test]
#[should_panic(expected = "local edge 7 of a cell, which has 4")]
fn the_curve_of_a_local_edge_that_there_is_not_is_told_by_its_number() {
    rectangle([0.0, 1.0], [0.0, 1.0]).local_curve(0, 7);
}

#[test]
fn factors_under_which_work_is_beyond_all_numbers_are_refused() {
    let body = pulled();
    for factor in [1e160, -1e308] {
        let error = body.solve(&[("pull", factor)]).unwrap_err();
        assert!(matches!(error, Error::OutOfRange { range: "finite", .. }), "{error}");
        assert!(error.to_string().contains(&format!("factors of load cases up to {:e}", factor.abs())), "{error}");
    }
    assert!(body.interface.strain_energy(&body.solve(&[("pull", 1e140)]).unwrap()).is_finite());
}
