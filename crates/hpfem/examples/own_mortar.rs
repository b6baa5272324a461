//! Two bodies with meshes that do not match, tied along a line by a mortar of one's own on their interface operators.
//!
//! Legendre polynomials `P_0 .. P_m` on the line are the multipliers: `int P_k (u_1 - u_2) ds = 0` for both components, a saddle point
//! problem on the kept unknowns alone. A linear stress state goes through such a joint exactly.

use faer::Mat;
use faer::linalg::solvers::Solve;
use hpfem::*;

/// A block `[0, 2] x [bottom, bottom + 1]` of `n` columns of cells.
fn block(n: usize, bottom: f64) -> Result<Mesh, Error> {
    let at = |i: usize| 2.0 * i as f64 / n as f64;
    let vertices = (0..=n).map(|i| [at(i), bottom]).chain((0..=n).map(|i| [at(i), bottom + 1.0])).collect();
    let cells: Vec<Quad> = (0..n).map(|i| Quad { corners: [i, i + 1, i + n + 2, i + n + 1], material: 0, layer: 0 }).collect();
    let mut names: Vec<([usize; 2], &str)> =
        (0..n).flat_map(|i| [([i, i + 1], "below"), ([i + n + 1, i + n + 2], "above")]).collect();
    names.extend([([0, n + 1], "left"), ([n, 2 * n + 1], "right")]);
    Mesh::new(vertices, &cells, &[], &names)
}

/// Largest error of the stress anywhere, relative to the bending stress, in two blocks of 3 and 4 columns bent like one beam.
pub fn stress_error(degree: usize, multipliers: usize) -> Result<f64, Error> {
    // s_xx = z on the beam -1 < z < 1, everything else zero.
    let bend = |name: &str| EdgeTraction::new(name, |p| [p.position[1] * p.outward[0], 0.0]);
    let problem = |n, bottom, tied: &str| -> Result<BodyProblem, Error> {
        let problem = BodyProblem::new(block(n, bottom)?, degree, Kinematics::PlaneStress { thickness: 1.0 });
        Ok(problem.material(Material::isotropic(1.0, 0.3)?).load("bend", bend("right")).keep(tied))
    };
    let pins = vec![Pin { vertex: 0, direction: Direction::Second }];
    let lower = BodyProblem { pins, ..problem(3, -1.0, "above")?.roller("left") };
    let upper = problem(4, 0.0, "below")?.load("bend", bend("left"));
    let bodies = [Body::new(lower)?, Body::new(upper)?];

    let n = bodies.each_ref().map(|body| body.interface.stiffness.nrows());
    let size = n[0] + n[1] + 2 * multipliers;
    let mut matrix = Mat::<f64>::zeros(size, size);
    let mut right = Mat::<f64>::zeros(size, 1);
    for (number, body) in bodies.iter().enumerate() {
        let (interface, first) = (&body.interface, number * n[0]);
        let factors = interface.factors(&[("bend", 1.0)])?;
        let none = TraceLoad { unknowns: vec![0.0; n[number]], ..TraceLoad::default() };
        for (i, value) in interface.right_hand_side(&none, &factors).into_iter().enumerate() {
            right[(first + i, 0)] = value;
        }
        matrix.submatrix_mut(first, first, n[number], n[number]).copy_from(&interface.stiffness);
        let sign = if number == 0 { 1.0 } else { -1.0 };
        for k in 0..2 * multipliers {
            let load = interface.trace.load(interface.kinematics, multipliers, |p| {
                let value = legendre(multipliers, p.position[0] - 1.0)[k / 2];
                if k % 2 == 0 { [value, 0.0] } else { [0.0, value] }
            });
            for (i, value) in load.unknowns.iter().enumerate() {
                matrix[(first + i, n[0] + n[1] + k)] = sign * value;
                matrix[(n[0] + n[1] + k, first + i)] = sign * value;
            }
        }
    }
    let x = matrix.full_piv_lu().solve(&right);
    let mut error = 0.0_f64;
    for (number, body) in bodies.iter().enumerate() {
        let unknowns = (0..n[number]).map(|i| x[(number * n[0] + i, 0)]).collect();
        let factors = body.interface.factors(&[("bend", 1.0)])?;
        let field = body.field(&InterfaceState { unknowns, factors, load: TraceLoad::default() })?;
        for cell in 0..field.cells() {
            for (xi, eta) in [(-1.0, -1.0), (0.2, 0.7), (1.0, 1.0)] {
                let [xx, zz, xz, _] = field.at(cell, xi, eta)?.stress;
                let z = field.position(cell, xi, eta)[1];
                error = error.max((xx - z).abs()).max(zz.abs()).max(xz.abs());
            }
        }
    }
    Ok(error)
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    for degree in [1, 2, 3, 5] {
        println!("degree {degree}: error of the stress {:.1e}", stress_error(degree, degree.max(2))?);
    }
    Ok(())
}
