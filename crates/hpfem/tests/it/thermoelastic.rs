//! Thermal displacements and stresses of computed temperatures: manufactured solutions without symmetry on turned, curved cells, and
//! temperatures that are singular at corners and at the ends of what is held.

use crate::common::*;
use crate::exact::{Exact, bessel};
use crate::heat::{conduction, displacement_error};
use hpfem::*;
use nalgebra::Complex;

type C = Complex<f64>;

const CONDUCTIVITY: f64 = 1.4;
const REFERENCE: f64 = 0.3;
/// Large, so that the thermal part of the solutions is as large as the other.
const EXPANSION: f64 = 0.8;

/// An elastic solution without body force, and a harmonic temperature with the displacement `grad phi`,
/// `lap phi = b (T - T_r)`, `b = (1 + nu)/(1 - nu) alpha`, in plane stress `(1 + nu) alpha` (Goodier 1937): `s_ij = 2 G (phi,ij - d_ij lap phi)`.
#[derive(Clone, Copy)]
struct Warm {
    elastic: Exact,
}

/// Temperature above the reference with its gradient, potential's gradient (displacement) and second derivatives `[11, 22, 12, hoop]`, for `b = 1`.
struct Heated {
    rise: f64,
    slope: [f64; 2],
    displacement: [f64; 2],
    second: [f64; 4],
}

impl Warm {
    fn new(kinematics: Kinematics) -> Warm {
        Warm { elastic: Exact { kinematics, material: Material::isotropic(1.7, 0.28).unwrap() } }
    }

    fn heated(&self, x: [f64; 2]) -> Heated {
        if self.elastic.kinematics.is_revolved() { revolved(x) } else { plane(x) }
    }

    fn factor(&self) -> f64 {
        let nu = 0.28;
        let hindered = if self.elastic.kinematics == PLANE_STRESS { 1.0 } else { 1.0 - nu };
        (1.0 + nu) / hindered * EXPANSION
    }

    fn temperature(&self, x: [f64; 2]) -> f64 {
        REFERENCE + self.heated(x).rise
    }

    fn displacement(&self, x: [f64; 2]) -> [f64; 2] {
        let (u, thermal) = (self.elastic.displacement(x), self.heated(x).displacement);
        [0, 1].map(|i| u[i] + self.factor() * thermal[i])
    }

    fn stress(&self, x: [f64; 2]) -> [f64; 4] {
        let (s, thermal) = (self.elastic.stress(x), self.heated(x));
        let scale = 1.7 / 1.28 * self.factor();
        let [a, b, c, hoop] = thermal.second;
        // Out of the plane phi has no second derivative, and in plane stress there is no stress.
        let out = if self.elastic.kinematics == PLANE_STRESS { 0.0 } else { hoop - thermal.rise };
        let own = [a - thermal.rise, b - thermal.rise, c, out];
        std::array::from_fn(|i| s[i] + scale * own[i])
    }

    /// The computed temperature of a body that is held at the exact one on `held` and has the exact flux elsewhere.
    fn computed(self, mesh: &Mesh, degree: usize, held: &str) -> Field {
        let flux = move |p: &BoundaryPoint| {
            let slope = self.heated(p.position).slope;
            [CONDUCTIVITY * (slope[0] * p.outward[0] + slope[1] * p.outward[1]), 0.0]
        };
        let problem = conduction(mesh, degree, self.elastic.kinematics).material(Material::conductor(CONDUCTIVITY).unwrap());
        let problem = others(held).fold(problem, |problem, name| problem.load("0", EdgeTraction::new(name, flux)));
        let body =
            Body::new(problem.support(Support::hold(held, Direction::First).varying(move |x| self.temperature(x)))).unwrap();
        body.field(&solved(&body, &[1.0])).unwrap()
    }

    /// Errors of temperature, displacement and stress, relative to the largest value, the degrees being those of the temperature and of the displacement.
    fn errors(self, mesh: &Mesh, [thermal, elastic]: [usize; 2], held: &str) -> [f64; 3] {
        let temperature = self.computed(mesh, thermal, held);
        let first = displacement_error(&temperature, mesh, |x| [self.temperature(x), 0.0]);
        let pull = move |p: &BoundaryPoint| {
            let ([x, z, t, _], n) = (self.stress(p.position), p.outward);
            [x * n[0] + t * n[1], t * n[0] + z * n[1]]
        };
        let problem = BodyProblem::new(mesh.clone(), elastic, self.elastic.kinematics).material(self.elastic.material);
        let problem = others(held).fold(problem, |problem, name| problem.load("0", EdgeTraction::new(name, pull)));
        let problem = [Direction::First, Direction::Second].into_iter().enumerate().fold(problem, |problem, (i, direction)| {
            problem.support(Support::hold(held, direction).varying(move |x| self.displacement(x)[i]))
        });
        let strain = Eigenstrain::of_temperature(&[EXPANSION], temperature, REFERENCE).unwrap();
        let body = Body::new(problem.load("0", strain).keep("right")).unwrap();
        let field = body.field(&solved(&body, &[1.0])).unwrap();
        let second = displacement_error(&field, mesh, |x| self.displacement(x));
        [first, second, stress_error(&field, mesh, |x| self.stress(x))]
    }
}

/// The boundaries of the patch but one.
fn others(held: &str) -> impl Iterator<Item = &'static str> {
    ["bottom", "right", "top", "left"].into_iter().filter(move |name| *name != held)
}

/// `T - T_r = Re F`, `F = e^(a zeta)`; `phi = Re(conj(zeta) G)`, `4 G' = F`, `phi,x + i phi,z = G + zeta conj(G')`.
fn plane(x: [f64; 2]) -> Heated {
    let a = C::new(0.6, -0.5);
    let zeta = C::new(x[0] - 2.0, x[1] - 0.7);
    let f = (a * zeta).exp();
    let u = f / (4.0 * a) + zeta * (f / 4.0).conj();
    // phi,xx + phi,zz = Re F, phi,xx - phi,zz - 2 i phi,xz = 2 conj(zeta) G''.
    let d = zeta.conj() * a * f * 0.5;
    Heated {
        rise: f.re,
        slope: [(a * f).re, -(a * f).im],
        displacement: [u.re, u.im],
        second: [0.5 * (f.re + d.re), 0.5 * (f.re - d.re), -0.5 * d.im, 0.0],
    }
}

/// `T - T_r = J_0(k r) e^(k z)`, `phi = z (T - T_r) / (2 k)`.
fn revolved([r, z]: [f64; 2]) -> Heated {
    let k = 0.8_f64;
    let e = (k * z).exp();
    let rise = bessel(0, k * r) * e;
    let radial = -k * bessel(1, k * r) * e;
    let over = if r == 0.0 { -0.5 * k * k * e } else { radial / r };
    // T,rr = -k^2 J_0 - T,r / r.
    let second = [z * (-k * k * rise - over), 2.0 * k * rise + k * k * z * rise, (1.0 + k * z) * radial, z * over];
    Heated {
        rise,
        slope: [radial, k * rise],
        displacement: [z * radial, (1.0 + k * z) * rise].map(|v| v / (2.0 * k)),
        second: second.map(|v| v / (2.0 * k)),
    }
}

#[test]
fn thermal_displacements_and_stresses_converge_exponentially_on_turned_curved_cells() {
    for (kinematics, left) in
        [(PLANE_STRESS, 0.0), (PLANE_STRAIN, 0.0), (Kinematics::Axisymmetric, 0.0), (Kinematics::Axisymmetric, 1.0)]
    {
        let meshes = TURNS[4..].iter().flat_map(|t| [patch(*t, Shape::Arcs, left), mixed(*t, Shape::Polynomial(3), left)]);
        // The axis itself is not held.
        let held = if left > 0.0 { ["top", "bottom", "right"] } else { ["top", "left", "bottom"] };
        for (mesh, held) in meshes.zip(held.into_iter().cycle()) {
            let exact = Warm::new(kinematics);
            let errors = [3, 8, 12, 16].map(|p| exact.errors(&mesh, [p, p], held));
            assert!(errors[3].into_iter().all(|e| e < 1e-9), "{kinematics:?}, {held}: {errors:?}");
            for (first, last) in errors[0].into_iter().zip(errors[2]) {
                assert!((first / last).ln() / 9.0 > 2.2_f64.ln(), "{kinematics:?}, {held}: {errors:?}");
            }
        }
    }
}

#[test]
fn temperature_and_displacement_may_be_of_different_degrees() {
    for kinematics in [PLANE_STRESS, PLANE_STRAIN, Kinematics::Axisymmetric] {
        let (exact, mesh) = (Warm::new(kinematics), patch([3, 2, 0, 1], Shape::Arcs, 0.0));
        for degrees in [[16, 14], [14, 16]] {
            let errors = exact.errors(&mesh, degrees, "left");
            assert!(errors.into_iter().all(|e| e < 1e-8), "{kinematics:?}, {degrees:?}: {errors:?}");
        }
    }
}
