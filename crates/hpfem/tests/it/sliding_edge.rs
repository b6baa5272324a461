//! Exponents of sharp edges that slide with friction.

use approx::assert_abs_diff_eq;
use hpfem::*;
use std::f64::consts::PI;

use crate::common::*;

fn wedge(degrees: f64, young: f64, nu: f64) -> Corner {
    let sector = Sector { angle: degrees.to_radians(), constants: Constants { young, poisson: nu } };
    Corner { sectors: vec![sector], faces: [Face::Free; 2] }
}

fn lambda(found: SlidingEdge) -> f64 {
    match found {
        SlidingEdge::Singular { lambda } => lambda,
        other => panic!("{other:?}"),
    }
}

#[test]
fn an_edge_far_stiffer_than_its_plane_has_the_exponents_of_a_sliding_rigid_punch() {
    // -1/2 -+ g, tan(pi g) = mu (1 - 2 nu) / (2 (1 - nu)), at any unit of the modulus.
    for (nu, mu, unit) in [(0.3, 0.25_f64, 1.0), (0.1, 0.5, 1e-6), (0.45, 1.0, 1e6)] {
        let g = (mu * (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu))).atan() / PI;
        let (punch, plane) = (wedge(90.0, 1e10 * unit, 0.3), wedge(180.0, unit, nu));
        let found = |mu| lambda(sliding_edge(&punch, &plane, mu, PLANE_STRAIN).unwrap());
        assert_abs_diff_eq!(found(mu), 0.5 + g, epsilon = 1e-7);
        assert_abs_diff_eq!(found(-mu), 0.5 - g, epsilon = 1e-7);
        // The plane seen as the shaped body is dragged the other way.
        assert_abs_diff_eq!(lambda(sliding_edge(&plane, &punch, mu, PLANE_STRAIN).unwrap()), 0.5 - g, epsilon = 1e-7);
    }
}

#[test]
fn a_right_angled_edge_on_its_own_kind_gets_sharper_with_friction_until_it_digs_in() {
    // Roots of the same conditions written with the derivatives of an Airy function, by an independent program.
    let found = |mu| sliding_edge(&wedge(90.0, 210e3, 0.3), &wedge(180.0, 210e3, 0.3), mu, PLANE_STRESS).unwrap();
    for (mu, root) in
        [(0.0, 0.7740131), (0.25, 0.6586316), (-0.25, 0.9333781), (1.0, 0.3854037), (1.75, 0.1233842), (2.0, 0.018157)]
    {
        assert_abs_diff_eq!(lambda(found(mu)), root, epsilon = 1e-6);
    }
    assert_eq!(found(2.1), SlidingEdge::DigsIn);
    // The other edge: complex exponents above 1, the pressure vanishes and the edge lifts.
    assert_eq!(found(-0.5), SlidingEdge::Bounded);
    // A sharper wedge has no singular pressure.
    let sharp = |mu| sliding_edge(&wedge(60.0, 210e3, 0.3), &wedge(180.0, 210e3, 0.3), mu, PLANE_STRESS);
    assert_eq!(sharp(0.25), Ok(SlidingEdge::Bounded));
    // No friction at all was taken for an exponent.
    for mu in [f64::NAN, f64::INFINITY] {
        assert!(matches!(sharp(mu), Err(Error::OutOfRange { range: "finite", .. })), "{mu}");
    }
}

#[test]
fn the_wedges_of_a_mesh_are_found_with_their_supports() {
    let mesh = crate::classics::rectangle([0.0, 1.0], [0.0, 1.0]);
    let vertex = mesh.nearest_vertex([0.0, 0.0]);
    let supports = [support("left", Direction::First)];
    let corner = Corner::at(&mesh, vertex, PLANE_STRAIN, &steel(), &supports).unwrap().unwrap();
    assert_abs_diff_eq!(corner.sectors[0].angle, 0.5 * PI, epsilon = 1e-12);
    assert_eq!(corner.faces[0], Face::Free);
    assert!(matches!(corner.faces[1], Face::Held(_)));
    assert_eq!(corner.clone().reversed().faces[1], Face::Free);
    // With both outer faces on rollers the two quarters are half of a plane on a plane: no longer sharp.
    let guided = Corner { faces: [Face::Free, Face::Held(0.5 * PI)], ..corner };
    assert_eq!(
        sliding_edge(
            &guided,
            &Corner { faces: [Face::Free, Face::Held(0.5 * PI)], ..wedge(90.0, 210e3, 0.3) },
            0.0,
            PLANE_STRAIN
        ),
        Ok(SlidingEdge::Bounded)
    );
}
