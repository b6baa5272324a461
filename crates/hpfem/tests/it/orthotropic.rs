//! Orthotropic materials: patches at four angles, exact solutions without symmetry, Lekhnitskii's hole, the isotropic limit, turned bodies.

use crate::classics::rectangle;
use crate::common::*;
use hpfem::*;
use nalgebra::Complex;
use std::f64::consts::{FRAC_PI_8, PI};

type C = Complex<f64>;

/// A carbon laminate, MPa.
const LAMINATE: Orthotropic = Orthotropic { young: [140e3, 10e3, 9e3], poisson: [0.3, 0.28, 0.42], shear: [5e3, 4.6e3, 3.4e3] };

const ANGLES: [f64; 4] = [0.0, 0.3, 0.9, 2.2];

const KINEMATICS: [Kinematics; 2] = [PLANE_STRESS, PLANE_STRAIN];

/// Stresses `[xx, zz, xz, yy]` of a linear displacement with the gradient `g`.
fn stress(material: &Material, kinematics: Kinematics, g: [[f64; 2]; 2]) -> [f64; 4] {
    material.moduli(kinematics).stress([g[0][0], g[1][1], g[0][1] + g[1][0], 0.0], kinematics)
}

/// A body under the tractions of a stress field on all its boundary, pinned.
fn under(
    mesh: &Mesh,
    degree: usize,
    material: Material,
    kinematics: Kinematics,
    stress: impl Fn([f64; 2]) -> [f64; 4] + Send + Sync + 'static,
) -> Body {
    let load = traction("all", move |p| {
        let ([x, z, t, _], n) = (stress(p.position), p.outward);
        [x * n[0] + t * n[1], t * n[0] + z * n[1]]
    });
    let far = (0..mesh.vertices.len()).max_by(|a, b| mesh.vertices[*a][1].total_cmp(&mesh.vertices[*b][1])).unwrap();
    let pin = |vertex, direction| Pin { vertex, direction };
    let pins = vec![pin(0, Direction::First), pin(0, Direction::Second), pin(far, Direction::First)];
    Body::new(BodyProblem { pins, ..problem(mesh, degree, kinematics, &[material], &[], &[vec![load]], None) }).unwrap()
}

#[test]
fn a_linear_displacement_is_met_at_every_angle_of_the_fibres_on_turned_cells() {
    let g = [[1.1e-3, -0.4e-3], [0.7e-3, 0.5e-3]];
    for (angle, turns) in ANGLES.into_iter().zip(TURNS) {
        let material = Material::orthotropic(LAMINATE, angle).unwrap();
        for kinematics in KINEMATICS {
            let exact = stress(&material, kinematics, g);
            for mesh in [patch(turns, Shape::Straight, 0.0), mixed(turns, Shape::Straight, 0.0)] {
                for degree in [1, 3] {
                    let body = under(&mesh, degree, material, kinematics, move |_| exact);
                    let error = stress_error(&body.field(&solved(&body, &[1.0])).unwrap(), &mesh, |_| exact);
                    assert!(error < 2e-12, "{angle} {kinematics:?} {degree}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn stiffness_turns_with_the_fibres() {
    // Pulled along the fibres, whatever their angle: E_1; across: E_2.
    for angle in ANGLES {
        let material = Material::orthotropic(LAMINATE, angle).unwrap();
        let (s, c) = angle.sin_cos();
        for (modulus, ratio, along) in [(140e3, 0.3, [c, s]), (10e3, 0.3 * 10.0 / 140.0, [-s, c])] {
            let across = [-along[1], along[0]];
            let g = |i: usize, j: usize| (along[i] * along[j] - ratio * across[i] * across[j]) / modulus;
            let [x, z, t, _] = stress(&material, PLANE_STRESS, [[g(0, 0), g(0, 1)], [g(1, 0), g(1, 1)]]);
            let wanted = [along[0] * along[0], along[1] * along[1], along[0] * along[1]];
            for (a, b) in [x, z, t].iter().zip(wanted) {
                assert!((a - b).abs() < 1e-12, "{angle} {a} {b}");
            }
        }
    }
}

/// Compliances `[a11, a12, a22, a16, a26, a66]` in the plane.
fn compliance(material: &Material, kinematics: Kinematics) -> [f64; 6] {
    let Moduli::General { stiffness: c } = material.moduli(kinematics) else { panic!("not orthotropic") };
    let places = [0, 1, 3];
    let a = nalgebra::Matrix3::from_fn(|i, j| c[places[i]][places[j]]).try_inverse().unwrap();
    [a[(0, 0)], a[(0, 1)], a[(1, 1)], a[(0, 2)], a[(1, 2)], a[(2, 2)]]
}

/// Roots above the real axis of the characteristic equation of a material.
fn roots([a11, a12, a22, a16, a26, a66]: [f64; 6]) -> [C; 2] {
    // a11 m^4 - 2 a16 m^3 + (2 a12 + a66) m^2 - 2 a26 m + a22 = 0, by Newton's method with deflation.
    let f = |m: C| (((m * a11 - 2.0 * a16) * m + 2.0 * a12 + a66) * m - 2.0 * a26) * m + a22;
    let slope = |m: C| ((m * 4.0 * a11 - 6.0 * a16) * m + 2.0 * (2.0 * a12 + a66)) * m - 2.0 * a26;
    let mut roots: Vec<C> = Vec::new();
    let mut start = 0.4;
    while roots.len() < 2 {
        let mut m = C::new(0.1 * start, start);
        for _ in 0..200 {
            let others: C = roots.iter().flat_map(|r| [*r, r.conj()]).map(|r| 1.0 / (m - r)).sum();
            m -= 1.0 / (slope(m) / f(m) - others);
            if f(m).norm() < 1e-18 * a22 {
                break;
            }
        }
        if m.im < 0.0 {
            m = m.conj();
        }
        if f(m).norm() < 1e-12 * a22 && roots.iter().all(|r| (r - m).norm() > 1e-6) {
            roots.push(m);
        }
        start += 0.37;
    }
    [roots[0], roots[1]]
}

/// Lekhnitskii's solution of an infinite plate with a hole of radius 1 pulled along x by 1 (Anisotropic plates, 1968).
#[derive(Clone, Copy)]
struct Hole {
    mu: [C; 2],
}

impl Hole {
    fn new(material: &Material) -> Hole {
        Hole { mu: roots(compliance(material, PLANE_STRESS)) }
    }

    fn stress(&self, x: [f64; 2]) -> [f64; 4] {
        let a = -C::i() / (2.0 * (self.mu[0] - self.mu[1]));
        let [p, q] = [(self.mu[0], a), (self.mu[1], -a)].map(|(mu, a)| {
            let z = x[0] + mu * x[1];
            let mut root = (z * z - 1.0 - mu * mu).sqrt();
            // The branch outside the hole.
            if (z - root).norm() > (z + root).norm() {
                root = -root;
            }
            let zeta = (z + root) / (1.0 - C::i() * mu);
            -a / (zeta * root)
        });
        let [m, n] = self.mu;
        [1.0 + 2.0 * (m * m * p + n * n * q).re, 2.0 * (p + q).re, -2.0 * (m * p + n * q).re, 0.0]
    }
}

/// Radii of a ring with thin layers at the hole: the solution is singular close to the hole, inside it.
const RADII: [f64; 5] = [1.0, 1.03, 1.12, 1.5, 3.0];

/// A ring of sixteen equal sectors between the radii 1 and 3; "all" is its boundary.
fn ring() -> Mesh {
    let at = |r: f64, k: usize| [r * (FRAC_PI_8 * k as f64).cos(), r * (FRAC_PI_8 * k as f64).sin()];
    let vertices: Vec<[f64; 2]> = RADII.iter().flat_map(|r| (0..16).map(move |k| at(*r, k))).collect();
    let (mut cells, mut curves, mut names) = (Vec::new(), Vec::new(), Vec::new());
    for (layer, r) in RADII.into_iter().enumerate() {
        for k in 0..16 {
            let (a, b) = (16 * layer + k, 16 * layer + (k + 1) % 16);
            let from = FRAC_PI_8 * k as f64;
            curves.push(([a, b], Curve::Arc { centre: [0.0; 2], radius: r, from, to: from + FRAC_PI_8 }));
            if layer < 4 {
                cells.push(Quad { corners: [a, a + 16, b + 16, b], material: 0, layer: 0 });
            }
            if layer % 4 == 0 {
                names.push(([a, b], "all"));
            }
        }
    }
    Mesh::new(vertices, &cells, &curves, &names).unwrap()
}

#[test]
fn lekhnitskiis_hole_is_met_at_every_angle_of_the_fibres() {
    for angle in [0.0, 0.9] {
        let material = Material::orthotropic(LAMINATE, angle).unwrap();
        let hole = Hole::new(&material);
        if angle == 0.0 {
            // The factor at the side of the hole in closed form.
            let factor = 1.0 + (2.0 * ((14.0_f64).sqrt() - 0.3) + 28.0).sqrt();
            assert!((hole.stress([0.0, 1.0])[0] / factor - 1.0).abs() < 1e-12);
        }
        let mesh = ring();
        let errors: Vec<f64> = [8, 14, 20]
            .iter()
            .map(|degree| {
                let body = under(&mesh, *degree, material, PLANE_STRESS, move |x| hole.stress(x));
                stress_error(&body.field(&solved(&body, &[1.0])).unwrap(), &mesh, |x| hole.stress(x))
            })
            .collect();
        assert!(errors[2] < 1e-6 && errors[2] < 1e-3 * errors[0], "{angle}: {errors:?}");
    }
}

/// A solution without body force and without any symmetry by Lekhnitskii's potentials: `s_xx = 2 Re sum mu_k^2 f_k`, `s_zz = 2 Re sum f_k`,
/// `s_xz = -2 Re sum mu_k f_k` with `f_k = a_k exp(b_k (x + mu_k z))`.
#[derive(Clone, Copy)]
struct Exponential {
    material: Material,
    kinematics: Kinematics,
    mu: [C; 2],
}

impl Exponential {
    fn new(material: Material, kinematics: Kinematics) -> Exponential {
        Exponential { material, kinematics, mu: roots(compliance(&material, kinematics)) }
    }

    fn stress(&self, x: [f64; 2]) -> [f64; 4] {
        let (factors, rates) = ([C::new(0.8, 0.5), C::new(-0.3, 0.7)], [C::new(0.3, -0.2), C::new(-0.2, 0.25)]);
        let [p, q] = std::array::from_fn(|k| factors[k] * (rates[k] * (x[0] - 2.0 + self.mu[k] * (x[1] - 0.7))).exp());
        let [m, n] = self.mu;
        let [xx, zz, xz] = [2.0 * (m * m * p + n * n * q).re, 2.0 * (p + q).re, -2.0 * (m * p + n * q).re];
        let [a11, a12, a22, a16, a26, a66] = compliance(&self.material, self.kinematics);
        let strains = [a11 * xx + a12 * zz + a16 * xz, a12 * xx + a22 * zz + a26 * xz, a16 * xx + a26 * zz + a66 * xz, 0.0];
        let yy = self.material.moduli(self.kinematics).stress(strains, self.kinematics)[3];
        [xx, zz, xz, yy]
    }
}

#[test]
fn a_solution_without_symmetry_converges_exponentially_on_turned_curved_cells() {
    for (angle, kinematics) in [(0.0, PLANE_STRESS), (0.9, PLANE_STRESS), (0.3, PLANE_STRAIN), (2.2, PLANE_STRAIN)] {
        let material = Material::orthotropic(LAMINATE, angle).unwrap();
        let exact = Exponential::new(material, kinematics);
        for (turns, shape) in [(TURNS[4], Shape::Arcs), (TURNS[6], Shape::Polynomial(3))] {
            for mesh in [patch(turns, shape, 0.0), mixed(turns, shape, 0.0)] {
                let errors: Vec<f64> = [3, 6, 9, 12]
                    .iter()
                    .map(|degree| {
                        let body = under(&mesh, *degree, material, kinematics, move |x| exact.stress(x));
                        stress_error(&body.field(&solved(&body, &[1.0])).unwrap(), &mesh, |x| exact.stress(x))
                    })
                    .collect();
                println!("{angle} {kinematics:?} {turns:?}: {errors:?}");
                // At least a factor of 2.5 a degree.
                assert!(errors[3] < 1e-6 && errors[3] < errors[0] * 2.5_f64.powi(-9), "{angle} {turns:?}: {errors:?}");
            }
        }
    }
}

/// A mesh of lines and arcs turned about the origin.
fn turned(mesh: &Mesh, angle: f64) -> Mesh {
    let (s, c) = angle.sin_cos();
    let point = |[x, z]: [f64; 2]| [c * x - s * z, s * x + c * z];
    let mut mesh = mesh.clone();
    mesh.vertices.iter_mut().for_each(|x| *x = point(*x));
    for edge in &mut mesh.edges {
        edge.curve = match &edge.curve {
            Curve::Line { start, end } => Curve::Line { start: point(*start), end: point(*end) },
            Curve::Arc { centre, radius, from, to } => {
                Curve::Arc { centre: point(*centre), radius: *radius, from: from + angle, to: to + angle }
            }
            other => panic!("{other:?}"),
        };
    }
    mesh
}

#[test]
fn a_body_turned_with_its_fibres_and_its_load_has_the_same_energy_and_the_turned_stress() {
    let (fibres, angle) = (0.4, 1.1);
    let (s, c) = f64::sin_cos(angle);
    let back = move |[x, z]: [f64; 2]| [c * x + s * z, c * z - s * x];
    let turned_stress = move |[x, z, t, y]: [f64; 4]| {
        [
            c * c * x + s * s * z - 2.0 * s * c * t,
            s * s * x + c * c * z + 2.0 * s * c * t,
            s * c * (x - z) + (c * c - s * s) * t,
            y,
        ]
    };
    for kinematics in KINEMATICS {
        let [still, moved] = [fibres, fibres + angle].map(|at| Material::orthotropic(LAMINATE, at).unwrap());
        let exact = Exponential::new(still, kinematics);
        let mesh = patch(TURNS[5], Shape::Arcs, 0.0);
        let other = turned(&mesh, angle);
        let field = |mesh: &Mesh, material, stress: Box<dyn Fn([f64; 2]) -> [f64; 4] + Send + Sync>| {
            let body = under(mesh, 12, material, kinematics, stress);
            let state = solved(&body, &[1.0]);
            let field = body.field(&state).unwrap();
            // Twice the energy is the work of the load, which the reduced body tells.
            let energy = field.strain_energy();
            let work = body.interface.strain_energy(&state);
            assert!((work / energy - 1.0).abs() < 1e-10, "{work} {energy}");
            (field, energy)
        };
        let (first, energy) = field(&mesh, still, Box::new(move |x| exact.stress(x)));
        let (second, same) = field(&other, moved, Box::new(move |x| turned_stress(exact.stress(back(x)))));
        assert!((same / energy - 1.0).abs() < 1e-11, "{same} {energy}");
        for cell in 0..4 {
            for (xi, eta) in sample_points() {
                let wanted = turned_stress(first.at(cell, xi, eta).unwrap().stress);
                let size = wanted.iter().fold(0.0_f64, |size, s| size.max(s.abs()));
                for (a, b) in second.at(cell, xi, eta).unwrap().stress.iter().zip(wanted) {
                    assert!((a - b).abs() < 1e-9 * size, "{a} {b}");
                }
            }
        }
    }
}

#[test]
fn constants_of_an_isotropic_material_make_one_to_the_bit() {
    let (young, poisson) = (210e3, 0.3);
    let isotropic = Material::isotropic(young, poisson).unwrap();
    let constants = Orthotropic { young: [young; 3], poisson: [poisson; 3], shear: [0.5 * young / (1.0 + poisson); 3] };
    assert_eq!(Material::orthotropic(constants, 0.7).unwrap(), isotropic);
    // Nearly isotropic constants go through the general law and give nearly the same body.
    let near = Orthotropic { young: [young * (1.0 + 1e-13), young, young], ..constants };
    let near = Material::orthotropic(near, 0.7).unwrap();
    assert!(matches!(near.moduli(PLANE_STRAIN), Moduli::General { .. }));
    for kinematics in [PLANE_STRESS, PLANE_STRAIN, Kinematics::Axisymmetric, Kinematics::Torsion] {
        for mesh in [patch(TURNS[6], Shape::Arcs, 0.0), mixed(TURNS[4], Shape::Arcs, 0.0)] {
            let stiffness = [isotropic, near].map(|material| {
                Body::new(problem(&mesh, 5, kinematics, &[material], &[], &[], Some("top"))).unwrap().interface.stiffness
            });
            let difference = (&stiffness[0] - &stiffness[1]).norm_max() / stiffness[0].norm_max();
            assert!(difference < 1e-11, "{kinematics:?} {difference:e}");
        }
    }
}

#[test]
fn a_solid_of_revolution_with_a_stiff_hoop_direction_has_its_closed_form() {
    // A disc spun or a tube pressed, u_z = 0: u = A r^k + B r^-k with k^2 = C_yy / C_rr of the stiffness.
    let constants = Orthotropic { young: [10e3, 12e3, 90e3], poisson: [0.25, 0.05, 0.06], shear: [4e3; 3] };
    let material = Material::orthotropic(constants, 0.0).unwrap();
    let Moduli::General { stiffness: c } = material.moduli(Kinematics::Axisymmetric) else { panic!("not orthotropic") };
    let k = (c[2][2] / c[0][0]).sqrt();
    let (inner, outer, pressure) = (1.0_f64, 2.0_f64, 50.0);
    // s_rr = A (c_rr k + c_ry) r^(k-1) + B (c_ry - c_rr k) r^(-k-1).
    let row = |r: f64| [(c[0][0] * k + c[0][2]) * r.powf(k - 1.0), (c[0][2] - c[0][0] * k) * r.powf(-k - 1.0)];
    let m = nalgebra::Matrix2::new(row(inner)[0], row(inner)[1], row(outer)[0], row(outer)[1]);
    let [a, b]: [f64; 2] = m.try_inverse().map(|m| m * nalgebra::Vector2::new(-pressure, 0.0)).unwrap().into();
    let mesh = crate::classics::rectangle([inner, outer], [0.0, 1.0]);
    let body = BodyProblem::new(mesh, 14, Kinematics::Axisymmetric)
        .material(material)
        .roller("bottom")
        .roller("top")
        .load("press", EdgeTraction::pressure("left", move |_| pressure));
    let body = Body::new(body).unwrap();
    let field = body.field(&body.solve(&[("press", 1.0)]).unwrap()).unwrap();
    for (xi, r) in [(-1.0, inner), (0.0, 1.5), (1.0, outer)] {
        let wanted = a * r.powf(k) + b * r.powf(-k);
        let u = field.at(0, xi, 0.2).unwrap().displacement[0];
        assert!((u / wanted - 1.0).abs() < 1e-9, "{r}: {u} {wanted}");
    }
}

#[test]
fn moduli_that_cannot_be_are_refused() {
    let refused = |constants| matches!(Material::orthotropic(constants, 0.0), Err(Error::Anisotropic { .. }));
    assert!(refused(Orthotropic { young: [1.0, -1.0, 1.0], ..LAMINATE }));
    assert!(refused(Orthotropic { shear: [0.0, 1.0, 1.0], ..LAMINATE }));
    assert!(refused(Orthotropic { poisson: [0.3, 0.28, 1.5], ..LAMINATE }));
    assert!(refused(Orthotropic { poisson: [f64::NAN, 0.28, 0.4], ..LAMINATE }));
    assert!(Material::orthotropic(LAMINATE, PI).is_ok());
    let mut skew = [[0.0; 4]; 4];
    (0..4).for_each(|i| skew[i][i] = 1.0);
    skew[0][1] = 0.5;
    assert!(matches!(Material::anisotropic(skew, [[1.0, 0.0], [0.0, 1.0]]), Err(Error::Anisotropic { .. })));
}

/// What changes its volume as little as an isotropic material beyond the limit is refused like it; stiff fibres, which hold one direction, are not.
#[test]
fn materials_that_hardly_change_their_volume_are_refused_where_that_counts() {
    let like = |nu: f64| {
        let g = 0.5 / (1.0 + nu) * (1.0 + 1e-7);
        Material::orthotropic(Orthotropic { young: [1.0; 3], poisson: [nu; 3], shear: [g; 3] }, 0.3).unwrap()
    };
    let fibres = Orthotropic { young: [1e6, 1.0, 1.0], poisson: [0.3, 0.3, 0.4], shear: [0.4; 3] };
    let fibres = Material::orthotropic(fibres, 0.3).unwrap();
    let mesh = rectangle([1.0, 2.0], [0.0, 1.0]);
    let made = |material: Material, kinematics| {
        Body::new(BodyProblem::new(mesh.clone(), 3, kinematics).material(material).clamp("left"))
    };
    for kinematics in [PLANE_STRAIN, Kinematics::Axisymmetric] {
        for nu in [0.499995, 0.499999999] {
            assert!(matches!(made(like(nu), kinematics), Err(Error::OutOfRange { .. })), "{nu}");
        }
        assert!(made(like(0.4999), kinematics).is_ok() && made(fibres, kinematics).is_ok());
    }
    assert!(made(like(0.499999999), PLANE_STRESS).is_ok());
}
