//! What benches share.

use hpfem::*;

/// A square of cells that all differ.
pub(crate) fn square(n: usize) -> Result<Mesh, Error> {
    let cuts = |sign: f64| -> Vec<f64> {
        (0..=n).map(|i| i as f64 / n as f64).map(|t| t + sign * 0.17 * t * (1.0 - t) * (1.0 + 0.3 * t)).collect()
    };
    let breaks: Vec<f64> = cuts(1.0).iter().map(|t| 2.0 * t - 1.0).collect();
    let line = |z| Curve::Line { start: [-1.0, z], end: [1.0 + 0.034 * z, z] };
    let names = [Named { side: Side::Top, range: None, name: "top" }, Named { side: Side::Bottom, range: None, name: "bottom" }];
    let levels = cuts(-1.0);
    let (bottom, top) = (line(-1.0), line(1.0));
    Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &levels, closed: false, material: 0, names: &names })
}
