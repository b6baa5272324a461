//! A wear law from a table: wear by distance measured at a few pressures. The worn-in pressure of a clutch under it.
//!
//! A law must grow with the pressure from where it begins, or a rate would not tell its pressure; a table that does not is refused.

use wear::{
    Optimum, OwnRule, Problem, RigidMode, Shape, SlidingMotion, Surface, TableError, TableLaw, WearError, optimal_pressure,
};

/// The law of pairs of a pressure (MPa) and wear by distance (um/m; 1 um/m is 1e-6 mm/mm).
pub(crate) fn measured(pairs: &[[f64; 2]]) -> Result<TableLaw, TableError> {
    TableLaw::new(&pairs.iter().map(|[pressure, wear]| [*pressure, 1e-6 * wear]).collect::<Vec<_>>())
}

/// Worn-in pressure of a clutch ring 20-120 mm under 50 kN.
pub(crate) fn clutch(table: TableLaw) -> Result<Optimum, WearError> {
    let ring = Surface::new(Shape::Annulus { radii: [20.0, 120.0] }, SlidingMotion::about_z(100.0))?;
    optimal_pressure(&Problem::new(ring, OwnRule::from(table), vec![RigidMode::press_down(5e4)]))
}

pub(crate) fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Mild up to 1 MPa, then ever more.
    let table = measured(&[[0.5, 0.1], [1.0, 0.22], [1.5, 0.6], [2.0, 1.5], [4.0, 8.0]])?;
    let optimum = clutch(table.clone())?;
    let feed = optimum.feed.as_ref().map_or(f64::NAN, |feed| feed[0]);
    println!("{:>6} {:>9} {:>14}", "r/mm", "p/MPa", "wear/(um/m)");
    for radius in [20.0, 40.0, 80.0, 120.0] {
        let point = wear::SurfacePoint {
            position: wear::nalgebra::Vector3::new(radius, 0.0, 0.0),
            sliding_speed: 100.0 * radius,
            ..optimum.points[0]
        };
        let p = optimum.pressure_at(&point);
        println!("{radius:>6} {p:>9.4} {:>14.5}", 1e6 * table.at(p)[0]);
        // In the steady state the whole ring recedes at one rate.
        let rate = table.at(p)[0] * point.sliding_speed;
        assert!((rate / feed - 1.0).abs() < 1e-9, "{rate} {feed}");
    }
    let refused = measured(&[[0.5, 0.1], [1.0, 0.3], [1.5, 0.2]]).err();
    println!("refused: {}", refused.map_or_else(String::new, |error| error.to_string()));
    Ok(())
}
