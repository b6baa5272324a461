//! A brake disc with a hot rim: conduction, and the stress of the temperature on the same mesh.

use hpfem::*;
use std::f64::consts::FRAC_PI_4;

/// Radii, mm, of bore and rim; temperatures there, K above the one without stress.
const RADII: [f64; 2] = [60.0, 140.0];
const RISE: [f64; 2] = [20.0, 180.0];
/// Young's modulus, MPa, and expansion, 1/K, of grey iron.
const YOUNG: f64 = 110e3;
const EXPANSION: f64 = 11e-6;

/// Hoop stress at bore and rim, MPa, of a disc in plane stress, by a quarter of it in two cells.
pub fn hoop_stress(degree: usize) -> Result<[f64; 2], Error> {
    let on = |r: f64, angle: f64| [r * angle.cos(), r * angle.sin()];
    let vertices = (0..3).flat_map(|i| RADII.map(|r| on(r, FRAC_PI_4 * f64::from(i)))).collect();
    let cells = [[0, 1, 3, 2], [2, 3, 5, 4]].map(|corners| Quad { corners, material: 0, layer: 0 });
    let arc = |i: usize, radius: f64| Curve::Arc {
        centre: [0.0; 2],
        radius,
        from: FRAC_PI_4 * i as f64,
        to: FRAC_PI_4 * (i + 1) as f64,
    };
    let curves: Vec<([usize; 2], Curve)> =
        (0..2).flat_map(|i| [([2 * i, 2 * i + 2], arc(i, RADII[0])), ([2 * i + 1, 2 * i + 3], arc(i, RADII[1]))]).collect();
    let names =
        [([0, 2], "bore"), ([2, 4], "bore"), ([1, 3], "rim"), ([3, 5], "rim"), ([0, 1], "first cut"), ([4, 5], "second cut")];
    let mesh = Mesh::new(vertices, &cells, &curves, &names)?;
    let steel = Material::isotropic(YOUNG, 0.26)?.conducting([[0.05, 0.0], [0.0, 0.05]])?;

    let conduction = BodyProblem::new(mesh.clone(), degree, Kinematics::Potential { thickness: 10.0 })
        .material(steel)
        .support(Support::moved("bore", Direction::First, RISE[0]))
        .support(Support::moved("rim", Direction::First, RISE[1]));
    let conduction = Body::new(conduction)?;
    let temperature = conduction.field(&conduction.solve(&[])?)?;

    let disc = BodyProblem::new(mesh, degree, Kinematics::PlaneStress { thickness: 10.0 })
        .material(steel)
        .roller("first cut")
        .roller("second cut")
        .load("heat", Eigenstrain::of_temperature(&[EXPANSION], temperature, 0.0)?);
    let disc = Body::new(disc)?;
    let field = disc.field(&disc.solve(&[("heat", 1.0)])?)?;
    // On the first cut the hoop stress is that along z.
    Ok([field.at(0, -1.0, -1.0)?.stress[1], field.at(0, 1.0, -1.0)?.stress[1]])
}

/// Timoshenko and Goodier, art. 150: `s_t = E a (1/r^2 (r^2 + a^2)/(b^2 - a^2) int_a^b T r dr + 1/r^2 int_a^r T r dr - T)` with the logarithm of
/// steady conduction.
pub fn exact() -> [f64; 2] {
    let [a, b] = RADII;
    let slope = (RISE[1] - RISE[0]) / (b / a).ln();
    // int_a^b T r dr of T = T_a + slope ln(r / a).
    let moment = 0.5 * RISE[0] * (b * b - a * a) + slope * (0.5 * b * b * (b / a).ln() - 0.25 * (b * b - a * a));
    let at_bore = 2.0 * moment / (b * b - a * a) - RISE[0];
    let at_rim = 2.0 * moment / (b * b - a * a) - RISE[1];
    [at_bore, at_rim].map(|strain| YOUNG * EXPANSION * strain)
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    println!("closed form: {:.9?} MPa", exact());
    for degree in [2, 4, 8, 12] {
        println!("degree {degree:2}: hoop stress at bore and rim {:.9?} MPa", hoop_stress(degree)?);
    }
    Ok(())
}
