//! What a load costs after factoring, against factoring anew with it: `cargo bench -p wearshape-hpfem --bench later_load`.
//!
//! A square of cells that all differ, clamped below, its top kept. Only fronts between the load and the kept boundary are visited.

use hpfem::*;
use std::time::Instant;

fn main() -> Result<(), Error> {
    println!(
        "| unknowns | factoring s | traction on the top s | point force s | weight s | solve s |\n|---|---|---|---|---|---|"
    );
    for (cells, degree) in [(20, 4), (60, 4), (150, 4), (60, 10)] {
        let problem = BodyProblem::new(square(cells)?, degree, Kinematics::PlaneStrain { thickness: 1.0 })
            .material(Material::isotropic(1.0, 0.3)?)
            .clamp("bottom")
            .keep("top");
        let start = Instant::now();
        let mut body = Body::new(problem)?;
        let factoring = start.elapsed().as_secs_f64();
        let cases = [
            LoadCase::new("traction").with(EdgeTraction::new("top", |p| p.outward)),
            LoadCase::new("point").with(PointForce::new([0.2, 0.1], [0.0, 1.0])),
            LoadCase::new("weight").with(BodyForce::weight(1.0, [0.0, -1.0])),
        ];
        let mut row = format!("| {} | {factoring:.2e} |", body.effort.unknowns);
        for case in cases {
            let start = Instant::now();
            body.add_load(case)?;
            row += &format!(" {:.1e} |", start.elapsed().as_secs_f64());
        }
        let start = Instant::now();
        body.solve(&[("traction", 1.0), ("point", 2.0), ("weight", 3.0)])?;
        println!("{row} {:.1e} |", start.elapsed().as_secs_f64());
    }
    Ok(())
}

/// A square of cells that all differ.
fn square(n: usize) -> Result<Mesh, Error> {
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
