//! Seconds against unknowns: a square of `n x n` different cells with a kept edge, p = 2, 4, 8, and the exponent between rows.
//!
//! The second table is a square of equal cells, which share one condensed matrix.

use hpfem::*;
use std::time::Instant;

/// Largest number of unknowns; a first argument that is a number replaces it.
const LARGEST: usize = 200_000;

fn main() {
    let largest = std::env::args().skip(1).find_map(|a| a.parse().ok()).unwrap_or(LARGEST);
    for (title, stretch) in [("different cells", 0.17), ("equal cells", 0.0)] {
        println!("{title}\n| p | cells | unknowns | assemble, s | factor, s | total, s | exponent |");
        println!("|---|---|---|---|---|---|---|");
        for p in [2, 4, 8] {
            let mut last: Option<(f64, f64)> = None;
            for k in 0.. {
                let n = ((700.0 * 4.0_f64.powi(k)).sqrt() / p as f64).round().max(2.0) as usize;
                if 2 * n * n * p * p > largest {
                    break;
                }
                let mesh = square(n, stretch);
                let start = Instant::now();
                let effort = reduce(&mesh, p);
                let total = start.elapsed().as_secs_f64();
                let unknowns = effort.unknowns as f64;
                let exponent = last.map_or(f64::NAN, |(u, t)| (total / t).ln() / (unknowns / u).ln());
                last = Some((unknowns, total));
                let (assemble, factor) = (effort.assemble.as_secs_f64(), effort.factor.as_secs_f64());
                println!("| {p} | {} | {unknowns} | {assemble:.4} | {factor:.4} | {total:.4} | {exponent:.2} |", effort.cells);
            }
        }
    }
}

fn square(n: usize, stretch: f64) -> Mesh {
    // Unequal breaks make every cell a shape of its own.
    let cuts = |sign: f64| -> Vec<f64> {
        (0..=n).map(|i| i as f64 / n as f64).map(|t| t + sign * stretch * t * (1.0 - t) * (1.0 + 0.3 * t)).collect()
    };
    let breaks: Vec<f64> = cuts(1.0).iter().map(|t| 2.0 * t - 1.0).collect();
    let line = |z| Curve::Line { start: [-1.0, z], end: [1.0 + 0.2 * stretch * z, z] };
    let names = [Named { side: Side::Top, range: None, name: "top" }, Named { side: Side::Bottom, range: None, name: "bottom" }];
    let levels = cuts(-1.0);
    let (bottom, top) = (line(-1.0), line(1.0));
    Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &levels, closed: false, material: 0, names: &names })
        .expect("the region is not folded")
}

fn reduce(mesh: &Mesh, p: usize) -> Effort {
    let hold = |direction| Support { boundary: "bottom".into(), direction, value: 0.0 };
    let supports = [hold(Direction::First), hold(Direction::Second)];
    let materials = [Material::new(1.0, 0.3).expect("unit material")];
    let body = Body::new(BodyProblem {
        mesh,
        degrees: vec![p; mesh.cells.len()],
        space: SpaceKind::Tensor,
        kinematics: Kinematics::PlaneStrain { thickness: 1.0 },
        materials: &materials,
        supports: &supports,
        rigid_edge: None,
        load_cases: &[],
        kept: Some("top"),
    });
    body.expect("the bottom holds the body").effort
}
