//! Seconds of the point search: `cargo bench -p wearshape-hpfem --bench search`.
//!
//! 10 000 cells of a half ring, with arcs, polynomial edges and straight ones; 100 000 points spread over the ring.

use hpfem::*;
use std::f64::consts::PI;
use std::time::Instant;

/// Points to be found.
const POINTS: usize = 100_000;

fn main() -> Result<(), Error> {
    let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: PI, to: 0.0 };
    let breaks: Vec<f64> = (0..=200).map(|i| f64::from(i) / 100.0 - 1.0).collect();
    let levels: Vec<f64> = (0..=50).map(|i| f64::from(i) / 50.0).collect();
    let (bottom, top) = (arc(1.0), arc(2.0));
    let arcs = Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &levels, closed: false, material: 0, names: &[] })?;
    let polynomials = arcs.mapped(|[x, z]| [x, z + 0.01 * (3.0 * x).sin()])?;
    let quads: Vec<Quad> = arcs.cells.iter().map(|c| Quad { corners: c.corners, material: 0, layer: 0 }).collect();
    let straight = Mesh::new(arcs.vertices.clone(), &quads, &[], &[])?;
    println!("| edges | cells | building s | found | us a point |\n|---|---|---|---|---|");
    for (edges, mesh) in [("arcs", &arcs), ("polynomials", &polynomials), ("straight", &straight)] {
        let start = Instant::now();
        let search = PointSearch::new(mesh);
        let building = start.elapsed().as_secs_f64();
        // Points of the golden angle and its companion, evenly spread.
        let spread = |k: usize, share: f64| (k as f64 * share).fract();
        let at = |k: usize| (1.0 + spread(k, 0.618_033_988_7), PI * spread(k, 0.754_877_666_2));
        let start = Instant::now();
        let found = (0..POINTS).map(at).filter(|(r, a)| search.locate([r * a.cos(), r * a.sin()]).is_ok()).count();
        let each = 1e6 * start.elapsed().as_secs_f64() / POINTS as f64;
        println!("| {edges} | {} | {building:.1e} | {found} | {each:.2} |", mesh.cells.len());
    }
    Ok(())
}
