//! A furnace wall of brick, insulation and steel between hot gas and air: conduction through layers with a film on either side.

use hpfem::*;

/// Thickness, mm, and conductivity, W/(mm K), of each layer.
const LAYERS: [[f64; 2]; 3] = [[200.0, 1.1e-3], [80.0, 0.05e-3], [6.0, 0.05]];
/// Film coefficient, W/(mm^2 K), and temperature, degrees Celsius, of the gas and of the air.
const GAS: [f64; 2] = [40e-6, 1100.0];
const AIR: [f64; 2] = [10e-6, 25.0];

/// Temperatures at the hot face, at the two joints and at the cold face, degrees Celsius.
pub fn temperatures(degree: usize) -> Result<[f64; 4], Error> {
    let joints = [0.0, LAYERS[0][0], LAYERS[0][0] + LAYERS[1][0], LAYERS.iter().map(|layer| layer[0]).sum()];
    let vertices = [0.0, 100.0].iter().flat_map(|z| joints.map(|x| [x, *z])).collect();
    let cells: Vec<Quad> = (0..3).map(|i| Quad { corners: [i, i + 1, i + 5, i + 4], material: i, layer: 0 }).collect();
    let mesh = Mesh::new(vertices, &cells, &[], &[([4, 0], "hot"), ([3, 7], "cold")])?;
    let problem = BodyProblem::new(mesh, degree, Kinematics::Potential { thickness: 1.0 });
    let problem = LAYERS.iter().try_fold(problem, |problem, layer| Ok(problem.material(Material::conductor(layer[1])?)))?;
    // Convection h (T_around - T): a film, and the flux h T_around into the body.
    let body = Body::new([("hot", GAS), ("cold", AIR)].into_iter().fold(problem, |problem, (face, [film, around])| {
        problem
            .foundation(Foundation::new(face, film, 0.0))
            .load("around", EdgeTraction::new(face, move |_| [film * around, 0.0]))
    }))?;
    let field = body.field(&body.solve(&[("around", 1.0)])?)?;
    let at = |cell: usize, xi: f64| Ok(field.at(cell, xi, 0.0)?.displacement[0]);
    Ok([at(0, -1.0)?, at(1, -1.0)?, at(2, -1.0)?, at(2, 1.0)?])
}

/// Resistances in series.
pub fn exact() -> [f64; 4] {
    let resistance = LAYERS.map(|[thickness, conductivity]| thickness / conductivity);
    let flux = (GAS[1] - AIR[1]) / (1.0 / GAS[0] + resistance.iter().sum::<f64>() + 1.0 / AIR[0]);
    let hot = GAS[1] - flux / GAS[0];
    let first = hot - flux * resistance[0];
    let second = first - flux * resistance[1];
    [hot, first, second, second - flux * resistance[2]]
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    println!("hot face, joints, cold face: {:.3?} degrees Celsius", temperatures(1)?);
    println!("resistances in series:       {:.3?}", exact());
    Ok(())
}
