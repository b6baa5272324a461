//! Wrong input is an error that names the place, never a panic and never a wrong result.

use crate::classics::rectangle;
use crate::common::*;
use hpfem::*;
use std::f64::consts::TAU;

fn square() -> Vec<[f64; 2]> {
    vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 0.0], [2.0, 1.0]]
}

fn quad(corners: [usize; 4]) -> Quad {
    Quad { corners, material: 0, layer: 0 }
}

#[test]
fn bad_meshes_are_refused_with_the_cell_named() {
    let folded = Mesh::new(square(), &[quad([0, 3, 2, 1])], &[], &[]).unwrap_err();
    assert!(matches!(folded, Error::FoldedCell { cell: 0, .. }), "{folded}");
    let bow_tie = Mesh::new(square(), &[quad([0, 1, 3, 2])], &[], &[]).unwrap_err();
    assert!(matches!(bow_tie, Error::FoldedCell { cell: 0, .. }), "{bow_tie}");
    let flat = Mesh::new(vec![[0.0; 2], [1.0, 0.0], [2.0, 0.0], [0.5, 0.0]], &[quad([0, 1, 2, 3])], &[], &[]).unwrap_err();
    assert!(matches!(flat, Error::FoldedCell { .. }), "{flat}");
    let repeated = Mesh::new(square(), &[quad([0, 1, 1, 2])], &[], &[]).unwrap_err();
    assert!(matches!(repeated, Error::FoldedCell { .. } | Error::Overlapping { .. }), "{repeated}");
    // A triangle repeats its last corner; the wrong way round it is folded too.
    let turned = Mesh::new(square(), &[quad([0, 2, 1, 1])], &[], &[]).unwrap_err();
    assert!(matches!(turned, Error::FoldedCell { cell: 0, .. }), "{turned}");
    let missing = Mesh::new(square(), &[quad([0, 1, 2, 9])], &[], &[]).unwrap_err();
    assert_eq!(missing.to_string(), "cell 0 names vertex 9, but there are 6 in all, counted from 0");
    let mut vertices = square();
    vertices[2][1] = f64::NAN;
    assert!(matches!(Mesh::new(vertices, &[quad([0, 1, 2, 3])], &[], &[]), Err(Error::OutOfRange { .. })));
    let twice = Mesh::new(square(), &[quad([0, 1, 2, 3]), quad([0, 1, 2, 3])], &[], &[]).unwrap_err();
    assert!(matches!(twice, Error::Overlapping { .. }), "{twice}");
    let edge = Mesh::new(square(), &[quad([0, 1, 2, 3])], &[], &[([0, 2], "diagonal")]).unwrap_err();
    assert!(matches!(edge, Error::NoSuchEdge { a: 0, b: 2 }));
    let curve = Curve::Line { start: [0.0, 0.0], end: [1.0, 0.1] };
    let miss = Mesh::new(square(), &[quad([0, 1, 2, 3])], &[([0, 1], curve)], &[]).unwrap_err();
    assert!(matches!(miss, Error::CurveMissesVertex { .. }), "{miss}");
}

#[test]
fn a_cell_folded_away_from_its_corners_is_refused_when_assembled() {
    // The bottom edge bulges far beyond the top one.
    let bulge = Curve::interpolated(4, |t| [0.5 * (1.0 + t), 3.0 * (1.0 - t * t).powi(2)]);
    let names = [([3, 0], "left")];
    let mesh = Mesh::new(square(), &[quad([0, 1, 2, 3])], &[([0, 1], bulge)], &names);
    let folded = match mesh {
        Err(e) => e,
        Ok(mesh) => {
            let materials = steel();
            let clamp = [support("left", Direction::First), support("left", Direction::Second)];
            Body::new(problem(&mesh, 4, PLANE_STRESS, &materials, &clamp, &[], None)).err().unwrap()
        }
    };
    assert!(matches!(folded, Error::FoldedCell { cell: 0, .. }), "{folded}");
}

#[test]
fn grading_towards_two_corners_of_one_cell_is_refused() {
    let mesh = rectangle([0.0, 1.0], [0.0, 1.0]);
    let error = mesh.refined_towards(&[0, 1], 0.15, 3).unwrap_err();
    assert!(matches!(error, Error::TwoGradedCorners { cell: 0, first: 0, second: 1 }), "{error}");
    assert!(mesh.refined_towards(&[0, 2], 0.15, 0).is_err());
    for ratio in [0.0, 1.0, -0.1, f64::NAN] {
        assert!(matches!(mesh.refined_towards(&[0], ratio, 1), Err(Error::OutOfRange { .. })));
    }
    assert!(matches!(mesh.refined_towards(&[17], 0.15, 1), Err(Error::Beyond { index: 17, .. })));
    assert!(matches!(mesh.refined_towards_by(&[0, 2], |_| 0.15), Err(Error::TwoGradedCorners { .. })));
    assert!(matches!(mesh.refined_towards_by(&[0], |_| 1.0), Err(Error::OutOfRange { .. })));
    assert!(matches!(mesh.refined_towards_by(&[17], |_| 0.15), Err(Error::Beyond { index: 17, .. })));
}

fn fault(change: impl FnOnce(&mut BodyProblem)) -> Error {
    let mesh = rectangle([0.5, 1.0], [0.0, 1.0]);
    let materials = steel();
    let supports = [support("bottom", Direction::First), support("bottom", Direction::Second)];
    let mut p = problem(&mesh, 2, PLANE_STRESS, &materials, &supports, &[], None);
    change(&mut p);
    Body::new(p).err().unwrap()
}

#[test]
fn bad_problems_are_refused_by_name() {
    assert!(matches!(fault(|p| p.degrees = vec![0]), Error::Degree { cell: 0, degree: 0 }));
    assert!(matches!(fault(|p| p.degrees = vec![25]), Error::Degree { degree: 25, .. }));
    assert!(matches!(fault(|p| p.degrees = vec![2, 2]), Error::Count { given: 2, expected: 1, .. }));
    let bare = fault(|p| p.materials.clear());
    assert_eq!(bare.to_string(), "cell 0 names material 0, but there are 0 in all, counted from 0");
    assert!(matches!(fault(|p| p.supports.clear()), Error::NotHeld { .. }));
    for thickness in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(fault(|p| p.kinematics = Kinematics::PlaneStress { thickness }), Error::OutOfRange { .. }));
        assert!(matches!(fault(|p| p.kinematics = Kinematics::PlaneStrain { thickness }), Error::OutOfRange { .. }));
    }
    let Error::NoSuchBoundary { name, known } = fault(|p| p.kept = vec!["contact".into()]) else { panic!("another error") };
    assert_eq!((name.as_str(), known.as_str()), ("contact", "bottom, right, top, left"));
}

#[test]
fn a_body_held_by_one_roller_only_is_refused_when_solved_alone() {
    let mesh = rectangle([0.5, 1.0], [0.0, 1.0]);
    let materials = steel();
    for name in ["bottom", "left"] {
        for direction in [Direction::First, Direction::Second, Direction::Normal] {
            let supports = [support(name, direction)];
            for degree in [1, 2, 5, 9] {
                let result = Body::new(problem(&mesh, degree, PLANE_STRESS, &materials, &supports, &[], None));
                assert!(matches!(result, Err(Error::NotHeld { .. })), "{name} {direction:?} p = {degree}");
            }
        }
    }
}

#[test]
fn a_support_value_or_load_that_is_no_number_is_refused() {
    let mesh = rectangle([0.5, 1.0], [0.0, 1.0]);
    let materials = steel();
    let mut supports = vec![support("bottom", Direction::First), support("bottom", Direction::Second)];
    let load = [vec![traction("top", |_| [f64::NAN, 0.0])]];
    let error = Body::new(problem(&mesh, 2, PLANE_STRESS, &materials, &supports, &load, None)).err().unwrap();
    assert!(matches!(error, Error::OutOfRange { .. }), "{error}");
    supports[0].value = f64::NAN;
    let error = Body::new(problem(&mesh, 2, PLANE_STRESS, &materials, &supports, &[], None)).err().unwrap();
    assert!(matches!(error, Error::OutOfRange { .. }), "{error}");
}

#[test]
fn a_negative_radius_is_refused_in_a_body_of_revolution() {
    let mesh = rectangle([-0.5, 1.0], [0.0, 1.0]);
    let materials = steel();
    let supports = [support("bottom", Direction::Second)];
    let error = Body::new(problem(&mesh, 2, Kinematics::Axisymmetric, &materials, &supports, &[], None)).err().unwrap();
    assert!(matches!(error, Error::OutOfRange { .. }), "{error}");
}

#[test]
fn a_normal_roller_on_a_curved_edge_is_refused() {
    let mesh = patch([0; 4], Shape::Arcs, 0.0);
    let materials = steel();
    let supports = [support("top", Direction::Normal)];
    let error = Body::new(problem(&mesh, 3, PLANE_STRESS, &materials, &supports, &[], Some("left"))).err().unwrap();
    assert!(matches!(error, Error::NotStraight { .. }), "{error}");
}

#[test]
fn a_closed_path_is_kept_and_a_broken_one_is_refused() {
    let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: TAU, to: 0.0 };
    let names = [
        Named { side: Side::Top, range: None, name: "outer" },
        Named { side: Side::Bottom, range: None, name: "hub" },
        Named { side: Side::Top, range: Some([-1.0, -0.5]), name: "two" },
        Named { side: Side::Top, range: Some([0.0, 0.5]), name: "two" },
    ];
    let breaks = [-1.0, -0.5, 0.0, 0.5, 1.0];
    let region =
        Ruled { bottom: arc(1.0), top: arc(2.0), breaks: &breaks, levels: &[0.0, 1.0], closed: true, material: 0, names: &names };
    let mesh = Mesh::ruled(&region).unwrap();
    let materials = steel();
    let supports = [support("hub", Direction::First), support("hub", Direction::Second)];
    let body = |name| Body::new(problem(&mesh, 3, PLANE_STRESS, &materials, &supports, &[], Some(name)));
    assert!(body("outer").unwrap().interface.trace.closed);
    let error = body("two").err().unwrap();
    assert!(matches!(error, Error::NotAPath { .. }), "{error}");
}

#[test]
fn materials_outside_their_range_are_refused() {
    for (young, poisson) in [(0.0, 0.3), (-1.0, 0.3), (f64::NAN, 0.3), (1.0, 0.5), (1.0, -1.0), (1.0, f64::NAN)] {
        assert!(matches!(Material::isotropic(young, poisson), Err(Error::Material { .. })));
    }
    assert!(Material::isotropic(1.0, 0.49999).is_ok());
    // Nearer to one half only where volume changes do not count.
    let mesh = patch(TURNS[0], Shape::Straight, 0.5);
    for (kinematics, taken) in [(PLANE_STRESS, true), (PLANE_STRAIN, false), (Kinematics::Axisymmetric, false)] {
        let near = [Material::isotropic(1.0, 0.499999).unwrap()];
        let result = Body::new(problem(&mesh, 2, kinematics, &near, &[], &[], Some("top")));
        let refused = matches!(result, Err(Error::OutOfRange { value: 0.499999, .. }));
        assert!(if taken { result.is_ok() } else { refused });
    }
}

#[test]
fn ratios_whose_mean_stress_would_be_lost_are_refused_where_volume_changes_count() {
    let mesh = rectangle([0.5, 1.0], [0.0, 1.0]);
    let of = |kinematics, poisson| {
        let material = Material::isotropic(1.0, poisson).unwrap();
        Body::new(problem(&mesh, 2, kinematics, &[material], &[], &[], None).clamp("bottom"))
    };
    for kinematics in [PLANE_STRAIN, Kinematics::Axisymmetric] {
        assert!(of(kinematics, MAX_POISSON).is_ok());
        assert!(matches!(of(kinematics, 0.499991), Err(Error::OutOfRange { .. })));
    }
    for kinematics in [PLANE_STRESS, Kinematics::Torsion] {
        assert!(of(kinematics, 0.4999999).is_ok());
    }
}
