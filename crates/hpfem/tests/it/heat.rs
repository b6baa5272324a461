//! Temperatures and what they do to bodies, in closed form; every temperature is computed by conduction on the mesh of the body it bends.

use crate::classics::{cartesian, rectangle};
use crate::common::*;
use approx::assert_relative_eq;
use hpfem::*;
use std::f64::consts::PI;

const YOUNG: f64 = 210e3;
const NU: f64 = 0.3;
const EXPANSION: f64 = 1.2e-5;
const CONDUCTIVITY: f64 = 50.0;
/// The temperature without strain.
const REFERENCE: f64 = 20.0;

/// The problem of the temperature in a body of these kinematics.
pub(crate) fn conduction(mesh: &Mesh, degree: usize, kinematics: Kinematics) -> BodyProblem {
    let scalar = match kinematics.thickness() {
        Some(thickness) => Kinematics::Potential { thickness },
        None => Kinematics::AxisymmetricPotential,
    };
    BodyProblem::new(mesh.clone(), degree, scalar)
}

/// The field of a temperature that holds these values.
fn between(mesh: &Mesh, degree: usize, kinematics: Kinematics, held: &[(&str, f64)]) -> Field {
    let problem = conduction(mesh, degree, kinematics).material(Material::conductor(CONDUCTIVITY).unwrap());
    let hold =
        |problem: BodyProblem, (edge, value): &(&str, f64)| problem.support(Support::moved(edge, Direction::First, *value));
    let body = Body::new(held.iter().fold(problem, hold)).unwrap();
    body.field(&body.solve(&[]).unwrap()).unwrap()
}

/// The body of steel under a temperature, load case "0".
fn warm(mesh: &Mesh, degree: usize, kinematics: Kinematics, temperature: Field) -> BodyProblem {
    let strain = Eigenstrain::of_temperature(&[EXPANSION], temperature, REFERENCE).unwrap();
    BodyProblem::new(mesh.clone(), degree, kinematics).material(Material::isotropic(YOUNG, NU).unwrap()).load("0", strain)
}

/// What a free body expands by in its section.
fn expansion_in_section(kinematics: Kinematics) -> f64 {
    if matches!(kinematics, Kinematics::PlaneStrain { .. }) { (1.0 + NU) * EXPANSION } else { EXPANSION }
}

/// Largest difference of the displacement from `exact(position)`, relative to the largest exact one.
pub(crate) fn displacement_error(field: &Field, mesh: &Mesh, exact: impl Fn([f64; 2]) -> [f64; 2]) -> f64 {
    let (mut error, mut size) = (0.0_f64, 0.0_f64);
    for (cell, (xi, eta)) in (0..mesh.cells.len()).flat_map(|c| sample_points().map(move |x| (c, x))) {
        let value = field.at(cell, xi, eta).unwrap().displacement;
        for (a, b) in value.into_iter().zip(exact(field.position(cell, xi, eta))) {
            error = error.max((a - b).abs());
            size = size.max(b.abs());
        }
    }
    error / size
}

/// ```text
///   z
///   |  top, T_1        u   = a ((T_0 - T_r) + g z) x            g = (T_1 - T_0) / h
///   +-----------+      u_z = a ((T_0 - T_r) z + g (z^2 - x^2)/2)
///   |           | h    curvature a g; a is the expansion, in plane strain (1 + nu) times as much
///   +-----------+--> x (or r)
///      bottom, T_0
/// ```
#[test]
fn a_slab_warmer_above_bends_by_expansion_times_gradient_and_without_stress() {
    let (height, [below, above]) = (0.8, [70.0, 150.0]);
    let slope = (above - below) / height;
    let mesh = rectangle([0.0, 3.0], [0.0, height]);
    for kinematics in [PLANE_STRESS, PLANE_STRAIN, Kinematics::Axisymmetric] {
        let a = expansion_in_section(kinematics);
        let temperature = between(&mesh, 2, kinematics, &[("bottom", below), ("top", above)]);
        let pins = vec![Pin { vertex: 0, direction: Direction::Second }];
        let problem = BodyProblem { pins, ..warm(&mesh, 3, kinematics, temperature) };
        let problem = if kinematics.is_revolved() { problem } else { problem.hold("left", Direction::First) };
        let body = Body::new(problem).unwrap();
        let field = body.field(&solved(&body, &[1.0])).unwrap();
        let error = displacement_error(&field, &mesh, |[x, z]| {
            let rise = below - REFERENCE;
            [a * (rise + slope * z) * x, a * (rise * z + 0.5 * slope * (z * z - x * x))]
        });
        assert!(error < 1e-12, "{kinematics:?}: {error:.1e}");
        // The strain along x grows by the curvature times the height.
        let strain = |eta| field.at(0, 0.3, eta).unwrap().gradient[0][0];
        assert_relative_eq!((strain(1.0) - strain(-1.0)) / height, a * slope, max_relative = 1e-11);
        let out_of_plane = |z: f64| match kinematics {
            Kinematics::PlaneStrain { .. } => -YOUNG * EXPANSION * (below - REFERENCE + slope * z),
            _ => 0.0,
        };
        for (xi, eta) in sample_points() {
            let z = field.position(0, xi, eta)[1];
            for (stress, wanted) in field.at(0, xi, eta).unwrap().stress.into_iter().zip([0.0, 0.0, 0.0, out_of_plane(z)]) {
                assert!((stress - wanted).abs() < 1e-10 * YOUNG * EXPANSION * above, "{kinematics:?}: {stress} {wanted}");
            }
        }
    }
}

/// A free ring of radii a, b at `T - T_r = rise_a + g ln(r/a)` (Timoshenko and Goodier, art. 150 and 151), plane stress:
///
/// ```text
/// u    = alpha ((1 + nu)/r I(r) + ((1 - nu) r + (1 + nu) a^2/r)/(b^2 - a^2) I(b)),   I(r) = int_a^r (T - T_r) s ds
/// s_rr = alpha E ((1 - a^2/r^2)/(b^2 - a^2) I(b) - I(r)/r^2)
/// s_tt = alpha E ((1 + a^2/r^2)/(b^2 - a^2) I(b) + I(r)/r^2 - (T - T_r))
/// ```
///
/// In plane strain with `E/(1 - nu^2)`, `nu/(1 - nu)`, `(1 + nu) alpha`, and `s_yy = nu (s_rr + s_tt) - E alpha (T - T_r)`.
struct Ring {
    radii: [f64; 2],
    /// Temperatures of bore and rim above the reference.
    rise: [f64; 2],
    strain: bool,
}

impl Ring {
    fn rise(&self, r: f64) -> f64 {
        let [a, b] = self.radii;
        self.rise[0] + (self.rise[1] - self.rise[0]) * (r / a).ln() / (b / a).ln()
    }

    fn moment(&self, r: f64) -> f64 {
        let [a, b] = self.radii;
        let slope = (self.rise[1] - self.rise[0]) / (b / a).ln();
        0.5 * self.rise[0] * (r * r - a * a) + slope * (0.5 * r * r * (r / a).ln() - 0.25 * (r * r - a * a))
    }

    /// `[E, nu, alpha]` of the plane.
    fn constants(&self) -> [f64; 3] {
        if self.strain { [YOUNG / (1.0 - NU * NU), NU / (1.0 - NU), (1.0 + NU) * EXPANSION] } else { [YOUNG, NU, EXPANSION] }
    }

    fn radial_displacement(&self, r: f64) -> f64 {
        let ([a, b], [_, nu, alpha]) = (self.radii, self.constants());
        let whole = self.moment(b) / (b * b - a * a);
        alpha * ((1.0 + nu) / r * self.moment(r) + ((1.0 - nu) * r + (1.0 + nu) * a * a / r) * whole)
    }

    /// `[rr, tt, yy]`.
    fn stress(&self, r: f64) -> [f64; 3] {
        let ([a, b], [young, _, alpha]) = (self.radii, self.constants());
        let (whole, part) = (self.moment(b) / (b * b - a * a), self.moment(r) / (r * r));
        let rr = alpha * young * ((1.0 - a * a / (r * r)) * whole - part);
        let tt = alpha * young * ((1.0 + a * a / (r * r)) * whole + part - self.rise(r));
        [rr, tt, if self.strain { NU * (rr + tt) - YOUNG * EXPANSION * self.rise(r) } else { 0.0 }]
    }

    /// Energy `1/2 int sigma : C^-1 sigma` per thickness of the whole ring.
    fn energy(&self) -> f64 {
        let ([a, b], rule) = (self.radii, gauss(40));
        let density = |r: f64| {
            let [s, t, y] = self.stress(r);
            0.5 / YOUNG * (s * s + t * t + y * y - 2.0 * NU * (s * t + t * y + y * s))
        };
        let at = |x: f64| 0.5 * (a + b) + 0.5 * (b - a) * x;
        rule.points.iter().zip(&rule.weights).map(|(x, w)| w * 0.5 * (b - a) * 2.0 * PI * at(*x) * density(at(*x))).sum()
    }
}

/// The whole ring in eight columns of cells, boundaries bore and rim; it begins at the vertex (-a, 0).
fn whole_ring([a, b]: [f64; 2]) -> Mesh {
    let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: PI, to: 3.0 * PI };
    let names = [Named { side: Side::Top, range: None, name: "bore" }, Named { side: Side::Bottom, range: None, name: "rim" }];
    let breaks: Vec<f64> = (0..=8).map(|i| f64::from(i) / 4.0 - 1.0).collect();
    let region =
        Ruled { bottom: arc(b), top: arc(a), breaks: &breaks, levels: &[0.0, 1.0], closed: true, material: 0, names: &names };
    Mesh::ruled(&region).unwrap()
}

/// Vertex of a mesh at a place.
fn vertex(mesh: &Mesh, [x, z]: [f64; 2]) -> usize {
    mesh.vertices.iter().position(|v| (v[0] - x).hypot(v[1] - z) < 1e-9).unwrap()
}

#[test]
fn a_free_ring_warm_inside_grows_and_is_stressed_as_its_closed_form_says() {
    let radii = [1.0, 1.6];
    let mesh = whole_ring(radii);
    for kinematics in [PLANE_STRESS, PLANE_STRAIN] {
        let ring = Ring { radii, rise: [180.0, 30.0], strain: kinematics == PLANE_STRAIN };
        let held = [("bore", ring.rise[0] + REFERENCE), ("rim", ring.rise[1] + REFERENCE)];
        let temperature = between(&mesh, 14, kinematics, &held);
        let pin = |place, direction| Pin { vertex: vertex(&mesh, place), direction };
        let pins = [([1.0, 0.0], Direction::Second), ([-1.0, 0.0], Direction::Second), ([0.0, 1.0], Direction::First)];
        let pins = pins.map(|(place, direction)| pin(place, direction)).to_vec();
        let body = Body::new(BodyProblem { pins, ..warm(&mesh, 14, kinematics, temperature) }).unwrap();
        let field = body.field(&solved(&body, &[1.0])).unwrap();
        let error = displacement_error(&field, &mesh, |x| {
            let r = x[0].hypot(x[1]);
            x.map(|v| v / r * ring.radial_displacement(r))
        });
        assert!(error < 1e-10, "{kinematics:?}: {error:.1e}");
        let error = stress_error(&field, &mesh, |x| {
            let [rr, tt, yy] = ring.stress(x[0].hypot(x[1]));
            let [xx, zz, xz] = cartesian(x, [rr, tt, 0.0]);
            [xx, zz, xz, yy]
        });
        assert!(error < 1e-9, "{kinematics:?}: {error:.1e}");
        assert_relative_eq!(field.strain_energy(), kinematics.thickness().unwrap() * ring.energy(), max_relative = 1e-10);
    }
}

#[test]
fn a_long_ring_of_revolution_is_the_one_in_plane_strain() {
    let ring = Ring { radii: [1.0, 1.6], rise: [-40.0, 90.0], strain: true };
    let mesh = rectangle(ring.radii, [0.0, 0.5]);
    let held = [("left", ring.rise[0] + REFERENCE), ("right", ring.rise[1] + REFERENCE)];
    let temperature = between(&mesh, 16, Kinematics::Axisymmetric, &held);
    let body = Body::new(warm(&mesh, 16, Kinematics::Axisymmetric, temperature).roller("bottom").roller("top")).unwrap();
    let field = body.field(&solved(&body, &[1.0])).unwrap();
    let error = displacement_error(&field, &mesh, |[r, _]| [ring.radial_displacement(r), 0.0]);
    assert!(error < 1e-10, "{error:.1e}");
    let error = stress_error(&field, &mesh, |[r, _]| {
        let [rr, tt, yy] = ring.stress(r);
        [rr, yy, 0.0, tt]
    });
    assert!(error < 1e-9, "{error:.1e}");
    assert_relative_eq!(field.strain_energy(), 0.5 * ring.energy(), max_relative = 1e-10);
}

/// Held everywhere: `-E alpha dT/(1 - nu)` in plane stress, `-E alpha dT/(1 - 2 nu)` in all directions otherwise.
#[test]
fn a_body_that_cannot_expand_at_all_has_the_stress_of_its_kinematics() {
    let rise = 65.0;
    for kinematics in [PLANE_STRESS, PLANE_STRAIN, Kinematics::Axisymmetric] {
        for (mesh, turns) in TURNS.map(|turns| (patch(turns, Shape::Arcs, 0.0), turns)) {
            let temperature = between(&mesh, 5, kinematics, &[("all", REFERENCE + rise)]);
            let body = Body::new(warm(&mesh, 6, kinematics, temperature).clamp("all")).unwrap();
            let field = body.field(&solved(&body, &[1.0])).unwrap();
            let plane = kinematics == PLANE_STRESS;
            let stress = -YOUNG * EXPANSION * rise / if plane { 1.0 - NU } else { 1.0 - 2.0 * NU };
            let wanted = [stress, stress, 0.0, if plane { 0.0 } else { stress }];
            let error = stress_error(&field, &mesh, |_| wanted);
            assert!(error < 1e-11, "{kinematics:?} {turns:?}: {error:.1e}");
            // 1/2 sigma : (0 - alpha dT) on the volume, which a unit source measures.
            let directions = if plane { 2.0 } else { 3.0 };
            let density = 0.5 * directions * -stress * EXPANSION * rise;
            let measure = conduction(&mesh, 4, kinematics).material(Material::conductor(1.0).unwrap()).clamp("left");
            let measure = Body::new(measure.load("0", BodyForce::new(|_| [1.0, 0.0]))).unwrap();
            let volume = -measure.interface.reaction(0, &solved(&measure, &[1.0]))[0];
            assert_relative_eq!(field.strain_energy(), density * volume, max_relative = 1e-11);
        }
    }
}

/// A bar of temperature `T_0 + g x` whose ends do not move but for the bow of their sections, `u = -a g z^2/2`: `s_xx = -E a mean(T - T_r)`.
#[test]
fn a_bar_between_walls_feels_the_mean_of_its_temperature() {
    let (length, [cold, hot]) = (4.0, [30.0, 190.0]);
    let slope = (hot - cold) / length;
    let mesh = rectangle([0.0, length], [-0.5, 0.5]);
    for kinematics in [PLANE_STRESS, PLANE_STRAIN] {
        let alpha = expansion_in_section(kinematics);
        let young = if kinematics == PLANE_STRAIN { YOUNG / (1.0 - NU * NU) } else { YOUNG };
        let temperature = between(&mesh, 1, kinematics, &[("left", cold), ("right", hot)]);
        let bow = move |x: [f64; 2]| -0.5 * alpha * slope * x[1] * x[1];
        let wall = |edge| Support::hold(edge, Direction::First).varying(bow);
        let pins = vec![Pin { vertex: 0, direction: Direction::Second }];
        let problem = BodyProblem { pins, ..warm(&mesh, 4, kinematics, temperature) };
        let body = Body::new(problem.support(wall("left")).support(wall("right"))).unwrap();
        let state = solved(&body, &[1.0]);
        let field = body.field(&state).unwrap();
        let stress = -young * alpha * (0.5 * (cold + hot) - REFERENCE);
        for (xi, eta) in sample_points() {
            let [xx, zz, xz, _] = field.at(0, xi, eta).unwrap().stress;
            assert_relative_eq!(xx, stress, max_relative = 1e-11);
            assert!(zz.abs().max(xz.abs()) < 1e-10 * stress.abs());
        }
        let push = body.interface.reaction(0, &state)[0];
        assert_relative_eq!(push, -stress * kinematics.thickness().unwrap(), max_relative = 1e-11);
    }
}

#[test]
fn a_body_warm_all_through_is_free_of_stress_whatever_it_is_made_of() {
    let constants = Orthotropic { young: [140e3, 10e3, 9e3], poisson: [0.3, 0.25, 0.4], shear: [5e3, 4e3, 3e3] };
    let materials = [Material::isotropic(YOUNG, NU).unwrap(), Material::orthotropic(constants, 0.6).unwrap()];
    for (turns, kinematics) in TURNS.into_iter().zip([PLANE_STRESS, Kinematics::Axisymmetric].into_iter().cycle()) {
        let whole = patch(turns, Shape::Polynomial(3), 0.0);
        let curves: Vec<([usize; 2], Curve)> = whole.edges.iter().map(|e| (e.vertices, e.curve)).collect();
        let cells: Vec<Quad> =
            whole.cells.iter().enumerate().map(|(i, c)| Quad { corners: c.corners, material: i % 2, layer: 0 }).collect();
        let mesh = Mesh::new(whole.vertices.clone(), &cells, &curves, &[([0, 1], "bottom")]).unwrap();
        let kelvin = materials.iter().map(|_| Material::conductor(CONDUCTIVITY).unwrap());
        let thermal = kelvin.fold(conduction(&mesh, 4, kinematics), BodyProblem::material);
        let thermal = Body::new(thermal.support(Support::moved("bottom", Direction::First, 95.0))).unwrap();
        let temperature = thermal.field(&thermal.solve(&[]).unwrap()).unwrap();
        let strain = Eigenstrain::of_temperature(&[EXPANSION; 2], temperature, REFERENCE).unwrap();
        let problem = BodyProblem::new(mesh.clone(), 5, kinematics).load("0", strain).keep("bottom");
        let body = Body::new(materials.into_iter().fold(problem, BodyProblem::material)).unwrap();
        let field = body.field(&afloat(&body, &[1.0])).unwrap();
        let size = 75.0 * EXPANSION * YOUNG;
        for (cell, (xi, eta)) in (0..mesh.cells.len()).flat_map(|c| sample_points().map(move |x| (c, x))) {
            let stress = field.at(cell, xi, eta).unwrap().stress;
            assert!(stress.iter().all(|s| s.abs() < 1e-9 * size), "{kinematics:?} {turns:?}: {stress:?}");
        }
        assert!(field.strain_energy() < 1e-18 * YOUNG);
    }
}
