//! Seconds to make and condense one curved cell, p = 2..20, against the plain `B^T D B` loop over quadrature points.
//!
//! The cells are all different (no two are similar), so nothing is shared. Best of several runs.

use hpfem::*;
use std::hint::black_box;
use std::sync::{Arc, LazyLock};
use std::time::Instant;

fn main() {
    println!("| p | hpfem with condensation, us | plain loop without, us | ratio |");
    println!("|---|---|---|---|");
    let mesh = Arc::new(bent_mesh());
    let steel = Material::isotropic(210e3, 0.3).expect("steel");
    for p in (2..=20).step_by(2) {
        let runs = if p <= 8 { 20 } else { 3 };
        let whole = best(runs, || assemble(&mesh, steel, p)) / mesh.cells.len() as f64;
        let plain = best(if p <= 6 { 3 } else { 1 }, || {
            let start = Instant::now();
            black_box(plain_stiffness(&mesh, p));
            start.elapsed().as_secs_f64()
        });
        println!("| {p} | {:.1} | {:.1} | {:.0} |", 1e6 * whole, 1e6 * plain, plain / whole);
        println!("bench cell-plain-p{p} {plain:.3e}");
        println!("bench cell-p{p} {whole:.3e} cell-plain-p{p}");
    }
}

fn best(runs: usize, mut seconds: impl FnMut() -> f64) -> f64 {
    (0..runs).map(|_| seconds()).fold(f64::MAX, f64::min)
}

/// Four by four cells between two bent curves; their shapes all differ.
fn bent_mesh() -> Mesh {
    let curve = |height: f64, bend: f64| Curve::interpolated(4, |t| [t + 0.05 * t * t, height + bend * (t + 0.3) * (t + 0.3)]);
    let breaks = [-1.0, -0.45, 0.05, 0.6, 1.0];
    let levels = [0.0, 0.3, 0.55, 0.75, 1.0];
    let (bottom, top) = (curve(0.0, 0.1), curve(2.0, -0.15));
    let names = [Named { side: Side::Bottom, range: None, name: "bottom" }];
    Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &levels, closed: false, material: 0, names: &names })
        .expect("the region is not folded")
}

fn assemble(mesh: &Arc<Mesh>, steel: Material, p: usize) -> f64 {
    let kinematics = Kinematics::PlaneStrain { thickness: 1.0 };
    let problem = BodyProblem::new(Arc::clone(mesh), p, kinematics).material(steel).keep("bottom");
    Body::timed(problem, seconds).expect("the body is held by its kept edge").effort.assemble
}

/// Seconds since the first call.
fn seconds() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed().as_secs_f64()
}

/// Lower triangle of the stiffness of cell 0 as written in textbooks: for every point, every pair of modes.
fn plain_stiffness(mesh: &Mesh, p: usize) -> Vec<f64> {
    let n = p + 1;
    let size = 2 * n * n;
    let mut k = vec![0.0; size * size];
    let d = [[1.35, 0.58, 0.0], [0.58, 1.35, 0.0], [0.0, 0.0, 0.38]];
    let rule = gauss(p + 2);
    for (eta, we) in rule.points.iter().zip(&rule.weights) {
        for (xi, wx) in rule.points.iter().zip(&rule.weights) {
            let (_, [[a, b], [c, e]]) = mesh.map(0, *xi, *eta);
            let jacobian = a * e - b * c;
            let ((fx, gx), (fy, gy)) = (shape_functions(p, *xi), shape_functions(p, *eta));
            let slopes: Vec<[f64; 2]> = (0..n * n)
                .map(|m| {
                    let (dx, dy) = (gx[m % n] * fy[m / n], fx[m % n] * gy[m / n]);
                    [(e * dx - c * dy) / jacobian, (a * dy - b * dx) / jacobian]
                })
                .collect();
            let strain = |m: usize, k: usize| {
                let [x, z] = slopes[m];
                if k == 0 { [x, 0.0, z] } else { [0.0, z, x] }
            };
            for j in 0..size {
                let trial = strain(j / 2, j % 2);
                let stress = d.map(|row| row[0] * trial[0] + row[1] * trial[1] + row[2] * trial[2]);
                for i in j..size {
                    let test = strain(i / 2, i % 2);
                    let work = test[0] * stress[0] + test[1] * stress[1] + test[2] * stress[2];
                    k[j * size + i] += wx * we * jacobian * work;
                }
            }
        }
    }
    k
}
