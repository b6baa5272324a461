//! Exact solutions of the equations of elasticity without body force, none of them with any symmetry.

use hpfem::{BodyProblem, BoundaryPoint, EdgeTraction, Kinematics, Material, Mesh};
use nalgebra::Complex;

type C = Complex<f64>;

/// An exact solution: displacement and stress `[xx, zz, xz, yy]` (or `[r phi, phi z, 0, 0]`) at a point.
#[derive(Clone, Copy)]
pub(crate) struct Exact {
    pub(crate) kinematics: Kinematics,
    pub(crate) material: Material,
}

impl Exact {
    pub(crate) fn displacement(&self, x: [f64; 2]) -> [f64; 2] {
        match self.kinematics {
            Kinematics::PlaneStress { .. } | Kinematics::PlaneStrain { .. } => self.plane(x).0,
            Kinematics::Axisymmetric => self.revolved(x).0,
            Kinematics::Torsion => torsion(x, self.material).0,
            Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => unreachable!("the solutions are elastic"),
        }
    }

    pub(crate) fn stress(&self, x: [f64; 2]) -> [f64; 4] {
        match self.kinematics {
            Kinematics::PlaneStress { .. } | Kinematics::PlaneStrain { .. } => self.plane(x).1,
            Kinematics::Axisymmetric => self.revolved(x).1,
            Kinematics::Torsion => torsion(x, self.material).1,
            Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => unreachable!("the solutions are elastic"),
        }
    }

    /// Traction on a boundary.
    pub(crate) fn traction(&self, p: &BoundaryPoint) -> [f64; 2] {
        let ([x, z, t, _], n) = (self.stress(p.position), p.outward);
        if self.kinematics == Kinematics::Torsion {
            return [x * n[0] + z * n[1], 0.0];
        }
        [x * n[0] + t * n[1], t * n[0] + z * n[1]]
    }

    /// The body under the tractions of the solution on its boundary "all", load case "0", not held.
    pub(crate) fn loaded(self, mesh: &Mesh, degree: usize) -> BodyProblem {
        let pull = EdgeTraction::new("all", move |p| self.traction(p));
        BodyProblem::new(mesh.clone(), degree, self.kinematics).material(self.material).load("0", pull)
    }

    fn shear(&self) -> f64 {
        0.5 * self.material.young().unwrap() / (1.0 + self.material.poisson().unwrap())
    }

    /// Kolosov and Muskhelishvili: `2 G (u + i w) = kappa phi - zeta conj(phi') - conj(psi)`, `s_xx + s_zz = 4 Re phi'`,
    /// `s_zz - s_xx + 2 i s_xz = 2 (conj(zeta) phi'' + psi')`, here with `phi = e^(a zeta)`, `psi = e^(b zeta)`.
    fn plane(&self, x: [f64; 2]) -> ([f64; 2], [f64; 4]) {
        let zeta = C::new(x[0] - 2.0, x[1] - 0.7);
        let (a, b) = (C::new(0.7, -0.4), C::new(-0.3, 0.9));
        let (phi, psi) = ((a * zeta).exp(), (b * zeta).exp() * C::new(0.8, 0.5));
        let nu = self.material.poisson().unwrap();
        let strain = matches!(self.kinematics, Kinematics::PlaneStrain { .. });
        let kappa = if strain { 3.0 - 4.0 * nu } else { (3.0 - nu) / (1.0 + nu) };
        let u = (phi * kappa - zeta * (a * phi).conj() - psi.conj()) / (2.0 * self.shear());
        let sum = 4.0 * (a * phi).re;
        let d = (zeta.conj() * a * a * phi + b * psi) * 2.0;
        let yy = if strain { nu * sum } else { 0.0 };
        ([u.re, u.im], [0.5 * (sum - d.re), 0.5 * (sum + d.re), 0.5 * d.im, yy])
    }

    /// Papkovich and Neuber in a body of revolution, `2 G u = grad f + (3 - 4 nu) h e_z - z grad h` with the harmonic functions
    /// `f = J_0(k r) e^(k z)` and `h = J_0(m r) e^(-m z)`.
    fn revolved(&self, x: [f64; 2]) -> ([f64; 2], [f64; 4]) {
        let [r, z] = x;
        let nu = self.material.poisson().unwrap();
        let (k, m): (f64, f64) = (0.9, 0.6);
        let (e, g) = ((k * z).exp(), (-m * z).exp());
        // J_1(s)/s is finite on the axis; J_0' = -J_1 and J_1' = J_0 - J_1/s.
        let (f0, f1) = (bessel(0, k * r), bessel_over(k * r));
        let (h0, h1) = (bessel(0, m * r), bessel_over(m * r));
        let f_r = -k * (k * r * f1) * e;
        let h = h0 * g;
        let (h_r, h_z) = (-m * (m * r * h1) * g, -m * h);
        let (h_rr, h_over, h_zz, h_rz) = (-m * m * (h0 - h1) * g, -m * m * h1 * g, m * m * h, m * m * (m * r * h1) * g);
        let u = [f_r - z * h_r, k * f0 * e + (3.0 - 4.0 * nu) * h - z * h_z];
        let rr = -k * k * (f0 - f1) * e - z * h_rr;
        let hoop = -k * k * f1 * e - z * h_over;
        let zz = k * k * f0 * e + (2.0 - 4.0 * nu) * h_z - z * h_zz;
        let rz = -k * k * (k * r * f1) * e + (1.0 - 2.0 * nu) * h_r - z * h_rz;
        let pressure = 2.0 * nu * h_z;
        (u.map(|v| v / (2.0 * self.shear())), [rr + pressure, zz + pressure, rz, hoop + pressure])
    }
}

/// `G u_phi = J_1(k r) e^(k z) + r z`.
fn torsion([r, z]: [f64; 2], material: Material) -> ([f64; 2], [f64; 4]) {
    let shear = 0.5 * material.young().unwrap() / (1.0 + material.poisson().unwrap());
    let k = 1.1;
    let (j0, j1) = (bessel(0, k * r), bessel_over(k * r));
    let e = (k * z).exp();
    let u = k * r * j1 * e + r * z;
    // u_r - u / r = k (J_0 - 2 J_1 / (k r)) e.
    ([u / shear, 0.0], [k * (j0 - 2.0 * j1) * e, k * (k * r * j1) * e + r, 0.0, 0.0])
}

/// Bessel function `J_n(s)` by its power series, for moderate `s`.
pub(crate) fn bessel(n: usize, s: f64) -> f64 {
    let mut term = (1..=n).fold(1.0, |t, i| t * 0.5 * s / i as f64);
    let mut sum = term;
    for i in 1..40 {
        term *= -0.25 * s * s / (i * (i + n)) as f64;
        sum += term;
    }
    sum
}

/// `J_1(s) / s`.
fn bessel_over(s: f64) -> f64 {
    let mut term = 0.5;
    let mut sum = term;
    for i in 1..40 {
        term *= -0.25 * s * s / (i * (i + 1)) as f64;
        sum += term;
    }
    sum
}
