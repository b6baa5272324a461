//! Bodies that spin: discs and rings in the plane about a centre anywhere, in plane stress and plane strain, and as bodies of revolution.

use crate::classics::rectangle;
use hpfem::*;
use std::f64::consts::FRAC_PI_4;

const CENTRE: [f64; 2] = [3.0, -2.0];
const RADII: [f64; 2] = [1.0, 2.5];
const YOUNG: f64 = 210e3;
const POISSON: f64 = 0.3;
/// Density, t/mm^3, and angular speed, rad/s.
const DENSITY: f64 = 7.85e-9;
const SPEED: f64 = 3e4;

const KINEMATICS: [Kinematics; 2] = [Kinematics::PlaneStress { thickness: 0.7 }, Kinematics::PlaneStrain { thickness: 1.3 }];

/// `[u_r, s_r, s_t]` of a free ring, or of a disc without a bore (Timoshenko and Goodier 1970, sec. 32); plane strain by `E / (1 - nu^2)` and
/// `nu / (1 - nu)`.
fn exact(r: f64, bore: f64, kinematics: Kinematics) -> [f64; 3] {
    let (e, nu) = match kinematics {
        Kinematics::PlaneStress { .. } => (YOUNG, POISSON),
        _ => (YOUNG / (1.0 - POISSON * POISSON), POISSON / (1.0 - POISSON)),
    };
    let (a, b, r2) = (bore * bore, RADII[1] * RADII[1], r * r);
    let c = (3.0 + nu) / 8.0 * DENSITY * SPEED * SPEED;
    let hole = if bore > 0.0 { a * b / r2 } else { 0.0 };
    let (radial, hoop) = (c * (a + b - hole - r2), c * (a + b + hole - (1.0 + 3.0 * nu) / (3.0 + nu) * r2));
    [r / e * (hoop - nu * radial), radial, hoop]
}

/// A ring of eight sectors in two layers, of the materials 0 and 1.
fn ring() -> Mesh {
    let radii = [RADII[0], 1.6, RADII[1]];
    let at = |r: f64, k: usize| {
        let angle = FRAC_PI_4 * k as f64;
        [CENTRE[0] + r * angle.cos(), CENTRE[1] + r * angle.sin()]
    };
    let vertices = radii.iter().flat_map(|r| (0..8).map(move |k| at(*r, k))).collect();
    let (mut cells, mut curves) = (Vec::new(), Vec::new());
    for (layer, radius) in radii.into_iter().enumerate() {
        for k in 0..8 {
            let (a, b) = (8 * layer + k, 8 * layer + (k + 1) % 8);
            let from = FRAC_PI_4 * k as f64;
            curves.push(([a, b], Curve::Arc { centre: CENTRE, radius, from, to: from + FRAC_PI_4 }));
            if layer < 2 {
                let turned = [a, a + 8, b + 8, b];
                cells.push(Quad { corners: std::array::from_fn(|i| turned[(i + k) % 4]), material: layer, layer: 0 });
            }
        }
    }
    Mesh::new(vertices, &cells, &curves, &[]).unwrap()
}

/// The ring under a load, held at three vertices that the solution does not turn.
fn solved(load: BodyForce, kinematics: Kinematics, degree: usize) -> (Body, InterfaceState) {
    let pin = |vertex, direction| Pin { vertex, direction };
    let pins = vec![pin(0, Direction::Second), pin(4, Direction::Second), pin(2, Direction::First)];
    let material = Material::isotropic(YOUNG, POISSON).unwrap();
    let problem = BodyProblem::new(ring(), degree, kinematics).material(material).material(material).load("spin", load);
    let body = Body::new(BodyProblem { pins, ..problem }).unwrap();
    let state = body.solve(&[("spin", SPEED * SPEED)]).unwrap();
    (body, state)
}

/// The force on a unit of mass at 1 rad/s.
fn away() -> BodyForce {
    BodyForce::new(|x| [x[0] - CENTRE[0], x[1] - CENTRE[1]])
}

#[test]
fn a_ring_that_spins_has_its_closed_form_to_ten_digits() {
    for kinematics in KINEMATICS {
        let (body, state) = solved(away().by_material(&[DENSITY, DENSITY]), kinematics, 16);
        let field = body.field(&state).unwrap();
        let size = exact(RADII[0], RADII[0], kinematics);
        for cell in 0..16 {
            for (xi, eta) in crate::common::sample_points() {
                let x = field.position(cell, xi, eta);
                let (dx, dz) = (x[0] - CENTRE[0], x[1] - CENTRE[1]);
                let r = dx.hypot(dz);
                let (c, s) = (dx / r, dz / r);
                let found = field.at(cell, xi, eta).unwrap();
                let [xx, zz, xz, _] = found.stress;
                let u = found.displacement[0] * c + found.displacement[1] * s;
                let radial = c * c * xx + s * s * zz + 2.0 * s * c * xz;
                let hoop = s * s * xx + c * c * zz - 2.0 * s * c * xz;
                let [wanted_u, wanted_r, wanted_t] = exact(r, RADII[0], kinematics);
                assert!((u - wanted_u).abs() < 1e-10 * size[0], "{kinematics:?} {r}: {u} {wanted_u}");
                assert!((radial - wanted_r).abs() < 1e-10 * size[2], "{kinematics:?} {r}: {radial} {wanted_r}");
                assert!((hoop - wanted_t).abs() < 1e-10 * size[2], "{kinematics:?} {r}: {hoop} {wanted_t}");
            }
        }
        // Half the work of the force is the strain energy.
        let work = body.interface.strain_energy(&state);
        assert!((work / field.strain_energy() - 1.0).abs() < 1e-11);
    }
}

#[test]
fn a_density_for_each_material_is_a_density_by_the_place() {
    let (light, heavy) = (DENSITY, 3.0 * DENSITY);
    let by_place = BodyForce::new(move |x| {
        let (dx, dz) = (x[0] - CENTRE[0], x[1] - CENTRE[1]);
        let density = if dx.hypot(dz) < 1.6 { light } else { heavy };
        [density * dx, density * dz]
    });
    let energy = |load: BodyForce| {
        let (body, state) = solved(load, KINEMATICS[0], 6);
        body.interface.strain_energy(&state)
    };
    let by_material = energy(away().by_material(&[light, heavy]));
    assert!((by_material / energy(by_place) - 1.0).abs() < 1e-12);
    // A material without a factor has no force.
    assert!(energy(away().by_material(&[light])) < 0.5 * by_material);
}

#[test]
fn a_disc_and_a_ring_of_revolution_between_rollers_have_the_closed_form_of_plane_strain() {
    for bore in [0.0, RADII[0]] {
        let mesh = rectangle([bore, RADII[1]], [0.0, 0.8]);
        let problem = BodyProblem::new(mesh, 20, Kinematics::Axisymmetric)
            .material(Material::isotropic(YOUNG, POISSON).unwrap())
            .roller("bottom")
            .roller("top")
            .load("spin", BodyForce::new(|x| [x[0], 0.0]).by_material(&[DENSITY]));
        let problem = if bore == 0.0 { problem.support(Support::hold("left", Direction::First)) } else { problem };
        let body = Body::new(problem).unwrap();
        let field = body.field(&body.solve(&[("spin", SPEED * SPEED)]).unwrap()).unwrap();
        let size = exact(RADII[1], bore, KINEMATICS[1]);
        for xi in [-0.9, -0.2, 0.4, 1.0] {
            let r = field.position(0, xi, 0.3)[0];
            let found = field.at(0, xi, 0.3).unwrap();
            let [u, radial, hoop] = exact(r, bore, KINEMATICS[1]);
            let limit = if bore == 0.0 { 1e-12 } else { 1e-10 };
            assert!((found.displacement[0] - u).abs() < limit * size[0], "{r}");
            assert!(
                (found.stress[0] - radial).abs() < limit * size[2] && (found.stress[3] - hoop).abs() < limit * size[2],
                "{r}"
            );
        }
    }
}
