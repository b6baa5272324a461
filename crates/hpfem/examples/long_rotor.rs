//! Generalised plane strain: a long cylinder that spins, free to shorten. Plane strain with one more load case, a constant axial strain, whose factor
//! is what leaves the section without an axial force.

use hpfem::*;
use std::f64::consts::FRAC_PI_2;

const YOUNG: f64 = 210e3;
const POISSON: f64 = 0.3;
/// Density, t/mm^3, angular speed, rad/s, and radius, mm.
const DENSITY: f64 = 7.85e-9;
const SPEED: f64 = 1000.0;
const RADIUS: f64 = 200.0;

/// A quarter of the section: three cells around a point inside.
fn quarter() -> Result<Mesh, Error> {
    let (r, m) = (RADIUS, 0.45 * RADIUS);
    let d = 0.5_f64.sqrt() * r;
    let vertices = vec![[0.0, 0.0], [m, 0.0], [r, 0.0], [d, d], [0.0, r], [0.0, m], [m, m]];
    let cell = |corners| Quad { corners, material: 0, layer: 0 };
    let cells = [cell([0, 1, 6, 5]), cell([1, 2, 3, 6]), cell([5, 6, 3, 4])];
    let arc = |from: f64| Curve::Arc { centre: [0.0; 2], radius: r, from, to: from + 0.5 * FRAC_PI_2 };
    let curves = [([2, 3], arc(0.0)), ([3, 4], arc(0.5 * FRAC_PI_2))];
    let names = [([0, 1], "level"), ([1, 2], "level"), ([0, 5], "upright"), ([5, 4], "upright")];
    Mesh::new(vertices, &cells, &curves, &names)
}

/// The axial force of a quarter of the section for a thickness of 1 mm, N: `int s_yy dA` by Gauss quadrature.
fn axial_force(field: &Field, degree: usize) -> Result<f64, Error> {
    let rule = gauss(degree + 2);
    let mut force = 0.0;
    for cell in 0..field.cells() {
        for (xi, w) in rule.points.iter().zip(&rule.weights) {
            for (eta, v) in rule.points.iter().zip(&rule.weights) {
                let (_, [[a, b], [c, d]]) = field.mesh().map(cell, *xi, *eta);
                force += w * v * (a * d - b * c) * field.at(cell, *xi, *eta)?.stress[3];
            }
        }
    }
    Ok(force)
}

/// Axial strain, and the axial stress at the axis and at the rim, MPa, of the free rotor.
pub fn rotor(degree: usize) -> Result<[f64; 3], Error> {
    let problem = BodyProblem::new(quarter()?, degree, Kinematics::PlaneStrain { thickness: 1.0 })
        .material(Material::isotropic(YOUNG, POISSON)?)
        .support(Support::hold("level", Direction::Second))
        .support(Support::hold("upright", Direction::First))
        .load("spin", BodyForce::new(|x| x).by_material(&[DENSITY]))
        // A total strain along y is what plane strain lacks: the stress of an eigenstrain is C (eps - eps*).
        .load("axial strain", Eigenstrain::new(|_| [0.0, 0.0, 0.0, -1.0]));
    let body = Body::new(problem)?;
    let field = |spin: f64, strain: f64| body.field(&body.solve(&[("spin", spin), ("axial strain", strain)])?);
    let spun = axial_force(&field(SPEED * SPEED, 0.0)?, degree)?;
    let stretched = axial_force(&field(0.0, 1.0)?, degree)?;
    let strain = -spun / stretched;
    let free = field(SPEED * SPEED, strain)?;
    Ok([strain, free.at(0, -1.0, -1.0)?.stress[3], free.at(1, 1.0, -1.0)?.stress[3]])
}

/// `-nu rho w^2 b^2 / (2 E)`, and `s_yy = nu rho w^2 (b^2 - 2 r^2) / (4 (1 - nu))` (Timoshenko and Goodier 1970, sec. 119).
pub fn exact() -> [f64; 3] {
    let load = DENSITY * SPEED * SPEED * RADIUS * RADIUS;
    let axial = POISSON * load / (4.0 * (1.0 - POISSON));
    [-0.5 * POISSON * load / YOUNG, axial, -axial]
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    for degree in [2, 4, 8, 12] {
        println!("degree {degree:2}: axial strain and stress {:?}, exact {:?}", rotor(degree)?, exact());
    }
    Ok(())
}
