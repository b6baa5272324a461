//! How far the work is from the machine's dense peak: GFLOP/s of making and condensing cells and of the fronts (their ordering included),
//! against faer's matrix product and Cholesky factorisation of a large matrix in the same run. Run with RAYON_NUM_THREADS=1.
//!
//! Cells all differ, so nothing is shared. Additions and multiplications are counted as the algorithms need them: the two products of
//! sum factorisation, the elimination of the interior, the elimination of the fronts.

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};
use hpfem::*;
use std::sync::{Arc, LazyLock};
use std::time::Instant;

/// Size of the large matrix.
const LARGE: usize = 512;
/// Cells along and across.
const CELLS: [usize; 2] = [12, 12];

fn main() {
    let a = Mat::from_fn(LARGE, LARGE, |i, j| if i == j { LARGE as f64 } else { 1.0 / (1 + i + j) as f64 });
    let mut c = Mat::zeros(LARGE, LARGE);
    let cube = (LARGE as f64).powi(3);
    let product = best(40, || {
        let start = Instant::now();
        matmul(c.as_mut(), Accum::Replace, a.as_ref(), a.as_ref(), 1.0, Par::Seq);
        start.elapsed().as_secs_f64()
    });
    let cholesky = best(40, || {
        let start = Instant::now();
        assert!(a.llt(faer::Side::Lower).is_ok(), "the matrix is positive definite");
        start.elapsed().as_secs_f64()
    });
    println!("matrix product of size {LARGE}: {:.1} GFLOP/s", 2e-9 * cube / product);
    println!("Cholesky factorisation of size {LARGE}: {:.1} GFLOP/s", 1e-9 * cube / 3.0 / cholesky);
    println!("bench peak-product-{LARGE} {product:.3e}\nbench peak-cholesky-{LARGE} {cholesky:.3e}");
    println!("| p | cells, GFLOP/s | of the product, % | fronts, GFLOP/s | of the product, % |\n|---|---|---|---|---|");
    let mesh = Arc::new(bent_mesh());
    let steel = Material::isotropic(210e3, 0.3).expect("steel");
    for p in [2, 4, 6, 8, 10, 12, 16] {
        let kinematics = Kinematics::PlaneStrain { thickness: 1.0 };
        let problem = BodyProblem::new(Arc::clone(&mesh), p, kinematics).material(steel).keep("bottom");
        let runs = if p <= 8 { 20 } else { 6 };
        let mut times = [f64::MAX; 2];
        for _ in 0..runs {
            let (_, effort) = Body::interface_timed(&problem, seconds).expect("the body is held by its kept edge");
            times = [times[0].min(effort.assemble), times[1].min(effort.factor)];
        }
        // `operations` counts three products of pairs of components; the symmetric ones take half of their columns.
        let (n, points, cells) = ((p + 1) as f64, (p + 2) as f64, mesh.cells.len() as f64);
        let (interior, all) = (2.0 * (n - 2.0).powi(2), 2.0 * n * n);
        let left = all - interior;
        let condensed = interior.powi(3) / 6.0 + 0.5 * interior * interior * left + 0.5 * interior * left * left;
        let fronts = Body::sizes(&problem).expect("a problem").operations - cells * (12.0 * n.powi(4) * points + condensed);
        let eta_side = 12.0 * n * n * points * points;
        let xi_side = 4.0 * points * (n.powi(4) + n * n * n * (n + 1.0));
        let rates = [cells * (eta_side + xi_side + condensed) / times[0], fronts / times[1]].map(|r| 2e-9 * r);
        let share = rates.map(|r| 100.0 * r / (2e-9 * cube / product));
        println!("| {p} | {:.1} | {:.0} | {:.1} | {:.0} |", rates[0], share[0], rates[1], share[1]);
    }
}

/// Seconds since the first call.
fn seconds() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed().as_secs_f64()
}

fn best(runs: usize, mut seconds: impl FnMut() -> f64) -> f64 {
    (0..runs).map(|_| seconds()).fold(f64::MAX, f64::min)
}

/// Cells between two bent curves; their shapes all differ.
fn bent_mesh() -> Mesh {
    let curve = |height: f64, bend: f64| Curve::interpolated(4, |t| [t + 0.05 * t * t, height + bend * (t + 0.3) * (t + 0.3)]);
    let graded = |n: usize, i: usize| (i as f64 / n as f64) * (1.0 + 0.1 * (1.0 - i as f64 / n as f64));
    let breaks: Vec<f64> = (0..=CELLS[0]).map(|i| 2.0 * graded(CELLS[0], i) - 1.0).collect();
    let levels: Vec<f64> = (0..=CELLS[1]).map(|i| graded(CELLS[1], i)).collect();
    let (bottom, top) = (curve(0.0, 0.1), curve(2.0, -0.15));
    let names = [Named { side: Side::Bottom, range: None, name: "bottom" }];
    Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &levels, closed: false, material: 0, names: &names })
        .expect("the region is not folded")
}
