//! What a load costs after factoring, against factoring anew with it: `cargo bench -p wearshape-hpfem --bench later_load`.
//!
//! A square of cells that all differ, clamped below, its top kept. Only fronts between the load and the kept boundary are visited.

mod common;

use common::square;
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
