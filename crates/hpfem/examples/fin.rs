//! A cooling fin: conduction in the plane with convection on its faces, and the heat that its root takes in.

use hpfem::*;
use std::f64::consts::PI;

/// Length, half of the thickness, depth (mm), conductivity (W/(mm K)), film coefficient (W/(mm^2 K)), temperature of the root above the air (K).
const LENGTH: f64 = 40.0;
const HALF: f64 = 5.0;
const DEPTH: f64 = 1.0;
const CONDUCTIVITY: f64 = 0.05;
const FILM: f64 = 2e-3;
const ROOT: f64 = 80.0;

/// Heat of the upper half of the fin, W, and the temperature in the middle of its tip, K above the air.
pub fn fin(degree: usize) -> Result<[f64; 2], Error> {
    let vertices = [0.0, HALF].iter().flat_map(|z| [0.0, HALF, 3.0 * HALF, LENGTH].map(|x| [x, *z])).collect();
    let cells = [0, 1, 2].map(|i| Quad { corners: [i, i + 1, i + 5, i + 4], material: 0, layer: 0 });
    let names = [([4, 5], "face"), ([5, 6], "face"), ([6, 7], "face"), ([4, 0], "root")];
    // The flux along the root has a logarithm where the face begins.
    let mesh = Mesh::new(vertices, &cells, &[], &names)?.refined_towards(&[4], 0.15, degree)?;
    let problem = BodyProblem::new(mesh, degree, Kinematics::Potential { thickness: DEPTH })
        .material(Material::conductor(CONDUCTIVITY)?)
        .support(Support::moved("root", Direction::First, ROOT))
        .foundation(Foundation::new("face", FILM, 0.0));
    let body = Body::new(problem)?;
    let state = body.solve(&[])?;
    let field = body.field(&state)?;
    let (cell, xi, eta) = field.locate([LENGTH, 0.0])?;
    Ok([body.interface.reaction(0, &state)[0], field.at(cell, xi, eta)?.displacement[0]])
}

/// The series `T = sum_n c_n cos(l_n z) cosh(l_n (L - x)) / cosh(l_n L)`, `l_n H tan(l_n H) = h H / k`.
pub fn exact() -> [f64; 2] {
    let biot = FILM * HALF / CONDUCTIVITY;
    let (mut heat, mut tip) = (0.0, 0.0);
    // The heat falls like 1/n^3: the tail of the terms left out is of the order 1e-12 of it.
    for n in (0..20_000).rev() {
        // Between n pi, where tan = 0, and (n + 1/2) pi.
        let (mut low, mut high) = (n as f64 * PI, (n as f64 + 0.5) * PI);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if middle * middle.tan() < biot {
                low = middle;
            } else {
                high = middle;
            }
        }
        let a = 0.5 * (low + high);
        let c = ROOT * 4.0 * a.sin() / (2.0 * a + (2.0 * a).sin());
        let l = a / HALF;
        heat += CONDUCTIVITY * DEPTH * c * (l * LENGTH).tanh() * a.sin();
        tip += c / (l * LENGTH).cosh();
    }
    [heat, tip]
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    println!("series: {:?}", exact());
    for degree in [2, 4, 6, 8, 10, 12] {
        println!("degree and layers {degree:2}: heat W, tip K {:?}", fin(degree)?);
    }
    Ok(())
}
