//! Temperatures that are singular at a re-entrant corner and where a held part of a boundary ends, and the displacements they make in a
//! free body: a harmonic temperature `T - T_r = Re F(zeta)` leaves a free, simply connected plane body without stress, and
//! `u + i w = alpha int F d zeta` (Boley and Weiner 1960, sec. 10.5), in plane strain `(1 + nu) alpha`.
//!
//! ```text
//!   F = 100 K zeta^lambda:   -----+-----   lambda = 1/2, held on the left, insulated on the right
//!                                              +---      lambda = 2/3, insulated on both faces of the missing quarter
//! ```

use crate::common::*;
use crate::heat::conduction;
use approx::assert_relative_eq;
use hpfem::*;
use nalgebra::Complex;
use std::f64::consts::TAU;
use std::sync::Arc;

type C = Complex<f64>;

const EXPANSION: f64 = 1.2e-5;
const REFERENCE: f64 = 20.0;
const CONDUCTIVITY: f64 = 50.0;
const YOUNG: f64 = 210e3;
const NU: f64 = 0.3;
/// Where displacements are compared: on the far sides, and inside.
const PLACES: [[f64; 2]; 4] = [[-1.0, 0.0], [-1.0, 1.0], [0.0, 1.0], [0.4, 0.3]];

/// A body with a singular vertex, its temperature and the boundaries that hold it; "outer" is where the flux is given.
struct Singular {
    mesh: Mesh,
    vertex: usize,
    exponent: f64,
    /// Held at the reference, if a part of the boundary is.
    held: Option<&'static str>,
}

fn cells(corners: &[[usize; 4]]) -> Vec<Quad> {
    corners.iter().map(|corners| Quad { corners: *corners, material: 0, layer: 0 }).collect()
}

/// Two unit squares above a line whose left half is held.
fn half_held() -> Singular {
    let vertices = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [-1.0, 1.0], [-1.0, 0.0]];
    let mut names: Vec<([usize; 2], &str)> = [[1, 2], [2, 3], [3, 4], [4, 5]].map(|edge| (edge, "outer")).to_vec();
    names.push(([5, 0], "cold"));
    let mesh = Mesh::new(vertices, &cells(&[[0, 1, 2, 3], [0, 3, 4, 5]]), &[], &names).unwrap();
    Singular { mesh, vertex: 0, exponent: 0.5, held: Some("cold") }
}

/// Three unit squares; the one with x > 0, z < 0 is missing.
fn corner() -> Singular {
    let vertices = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [-1.0, 1.0], [-1.0, 0.0], [-1.0, -1.0], [0.0, -1.0]];
    let names = [[1, 2], [2, 3], [3, 4], [4, 5], [5, 6], [6, 7]].map(|edge| (edge, "outer"));
    let mesh = Mesh::new(vertices, &cells(&[[0, 1, 2, 3], [0, 3, 4, 5], [0, 5, 6, 7]]), &[], &names).unwrap();
    Singular { mesh, vertex: 0, exponent: 2.0 / 3.0, held: None }
}

impl Singular {
    /// `F`, amplitude 100 K.
    fn function(&self, x: [f64; 2]) -> C {
        let angle = x[1].atan2(x[0]).rem_euclid(TAU);
        C::from_polar(100.0 * x[0].hypot(x[1]).powf(self.exponent), self.exponent * angle)
    }

    /// `u + i w = a zeta F / (1 + lambda)`.
    fn displacement(&self, kinematics: Kinematics, x: [f64; 2]) -> [f64; 2] {
        let alpha = if kinematics == PLANE_STRAIN { (1.0 + NU) * EXPANSION } else { EXPANSION };
        let u = C::new(x[0], x[1]) * self.function(x) * (alpha / (1.0 + self.exponent));
        [u.re, u.im]
    }

    /// Dissipation `1/2 int k |grad T|^2 dA = 1/2 int k (T - T_r) T,n ds` over the outer boundary, straight edges of length 1.
    fn dissipation(&self) -> f64 {
        let rule = gauss(60);
        let mut sum = 0.0;
        for edge in self.mesh.boundary("outer").unwrap() {
            let [a, b] = self.mesh.edges[edge].vertices.map(|v| self.mesh.vertices[v]);
            for (t, w) in rule.points.iter().zip(&rule.weights) {
                let x = [0, 1].map(|i| 0.5 * (a[i] + b[i]) + 0.5 * t * (b[i] - a[i]));
                // Outward is away from the corner.
                let normal = if a[0] == b[0] { [x[0].signum(), 0.0] } else { [0.0, x[1].signum()] };
                sum += 0.25 * w * CONDUCTIVITY * self.function(x).re * self.slope(x, normal);
            }
        }
        sum
    }

    /// Derivative of the temperature along a direction.
    fn slope(&self, x: [f64; 2], d: [f64; 2]) -> f64 {
        let g = self.function(x) / C::new(x[0], x[1]) * self.exponent;
        g.re * d[0] - g.im * d[1]
    }

    /// Dissipation per thickness and displacements at [`PLACES`], of the body free but for three pins; and the largest stress there in the plane, MPa.
    fn solved(self: &Arc<Self>, mesh: &Mesh, degrees: &[usize], kinematics: Kinematics) -> (Vec<f64>, f64) {
        let own = Arc::clone(self);
        let flux = move |p: &BoundaryPoint| [CONDUCTIVITY * own.slope(p.position, p.outward), 0.0];
        let problem = conduction(mesh, 1, kinematics).degrees(degrees.to_vec()).load("0", EdgeTraction::new("outer", flux));
        let problem = problem.material(Material::conductor(CONDUCTIVITY).unwrap());
        let problem = match self.held {
            Some(name) => problem.support(Support::moved(name, Direction::First, REFERENCE)),
            None => problem.keep("outer"),
        };
        let body = Body::new(problem).unwrap();
        let state = body.solve(&[("0", 1.0)]).unwrap();
        let field = body.field(&state).unwrap();
        // Where nothing holds it, the temperature is known but for a constant: the one at the corner is the reference.
        let (cell, xi, eta) = field.locate([0.0, 0.0]).unwrap();
        let reference = field.at(cell, xi, eta).unwrap().displacement[0];
        let dissipation = field.strain_energy() / kinematics.thickness().unwrap();
        let strain = Eigenstrain::of_temperature(&[EXPANSION], field, reference).unwrap();
        let material = Material::isotropic(YOUNG, NU).unwrap();
        let free = BodyProblem::new(mesh.clone(), 1, kinematics).degrees(degrees.to_vec()).material(material).load("0", strain);
        let pins = [(1, Direction::First), (1, Direction::Second), (2, Direction::First)];
        let pins = pins.map(|(vertex, direction)| Pin { vertex, direction }).to_vec();
        let free = Body::new(BodyProblem { pins, ..free }).unwrap();
        let field = free.field(&solved(&free, &[1.0])).unwrap();
        let (mut found, mut stress) = (vec![dissipation], 0.0_f64);
        for x in PLACES {
            let (cell, xi, eta) = field.locate(x).unwrap();
            let state = field.at(cell, xi, eta).unwrap();
            found.extend(state.displacement);
            stress = state.stress[..3].iter().fold(stress, |m, s| m.max(s.abs()));
        }
        (found, stress)
    }

    /// The same in closed form, moved so that the pins are at rest.
    fn exact(&self, kinematics: Kinematics) -> Vec<f64> {
        let u = |x| self.displacement(kinematics, x);
        let (first, second) = (u([1.0, 0.0]), u([1.0, 1.0]));
        // Vertex 2 is above vertex 1 by 1: a turn theta moves it by -theta along x.
        let turn = second[0] - first[0];
        let moved = |x: [f64; 2]| {
            let [a, b] = u(x);
            [a - first[0] - turn * x[1], b - first[1] + turn * (x[0] - 1.0)]
        };
        std::iter::once(self.dissipation()).chain(PLACES.into_iter().flat_map(moved)).collect()
    }
}

/// Largest difference, of the dissipation relative to itself, of the displacements to the largest of them.
fn error(found: &[f64], exact: &[f64]) -> [f64; 2] {
    let size = exact[1..].iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let worst = found[1..].iter().zip(&exact[1..]).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
    [(found[0] / exact[0] - 1.0).abs(), worst / size]
}

#[test]
fn singular_temperatures_and_what_they_bend_converge_exponentially_with_layers() {
    for kinematics in [PLANE_STRESS, PLANE_STRAIN] {
        for body in [half_held(), corner()].map(Arc::new) {
            let exact = body.exact(kinematics);
            let errors = [4, 8, 12, 18].map(|p| {
                let mesh = body.mesh.refined_towards(&[body.vertex], 0.15, p).unwrap();
                let (found, stress) = body.solved(&mesh, &vec![p; mesh.cells.len()], kinematics);
                let [heat, bent] = error(&found, &exact);
                [heat, bent, stress / (YOUNG * EXPANSION * 100.0)]
            });
            // The stress is a derivative at single points: two digits behind.
            for (k, last) in [1e-9, 1e-9, 1e-7].into_iter().enumerate() {
                assert!(errors[3][k] < last, "exponent {}: {errors:?}", body.exponent);
                assert!((errors[0][k] / errors[2][k]).ln() / 8.0 > 1.7_f64.ln(), "exponent {}: {errors:?}", body.exponent);
            }
        }
    }
}

#[test]
fn exponents_of_temperatures_are_found_and_estimates_hold_for_what_they_bend() {
    for body in [half_held(), corner()].map(Arc::new) {
        let conductor = [Material::conductor(CONDUCTIVITY).unwrap()];
        let supports: Vec<Support> = body.held.iter().map(|name| Support::hold(name, Direction::First)).collect();
        let scalar = Kinematics::Potential { thickness: 0.7 };
        let singular = singular_vertices(&body.mesh, scalar, &conductor, &supports, &[]).unwrap();
        assert!(matches!(singular[..], [SingularVertex { vertex, .. }] if vertex == body.vertex), "{singular:?}");
        assert_relative_eq!(singular[0].exponent, body.exponent, max_relative = 1e-9);
        let exact = body.exact(PLANE_STRESS);
        // The displacements in the size of the dissipation: a common measure of both.
        let scaled = |values: &[f64]| -> Vec<f64> {
            let unit = exact[1..].iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            values.iter().enumerate().map(|(i, v)| if i == 0 { v / exact[0] } else { v / unit }).collect()
        };
        let wanted = scaled(&exact);
        for accuracy in [1e-4, 1e-6] {
            let run = adapt(&body.mesh, &singular, accuracy, 20, |mesh, degrees| {
                Ok(scaled(&body.solved(mesh, degrees, PLANE_STRESS).0))
            })
            .unwrap();
            assert_eq!(run.status, AdaptStatus::Reached);
            let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
            let off: Vec<f64> = run.quantities.last().unwrap().iter().zip(&wanted).map(|(a, b)| a - b).collect();
            let truth = norm(&off) / norm(&wanted);
            let effectivity = run.estimate / truth;
            assert!(
                truth < accuracy && (0.5..10.0).contains(&effectivity),
                "{accuracy:.0e}: {truth:.1e}, effectivity {effectivity:.2}"
            );
        }
    }
}
