//! `wearshape materials`: what a scene may name in place of the numbers of a material.

use scene::{Fault, KnownMaterial, known_materials};

use crate::exit::Exit;
use crate::print::print_out;

const HEAD: &str = "                      young  poisson  density  conductivity  expansion  heat capacity
name                    GPa             kg/m3       W/(m K)     1e-6/K       J/(kg K)  source\n";

/// Prints the table.
pub(crate) fn run() -> Result<Exit, Fault> {
    print_out(HEAD);
    for material in known_materials() {
        print_out(&line(&material));
    }
    print_out(
        "\nA contact is computed from young and poisson. Wear factors depend on the pair and its running: docs/wear-factors.md\n",
    );
    Ok(Exit::Done)
}

fn line(material: &KnownMaterial) -> String {
    let KnownMaterial { name, young, poisson, source, .. } = material;
    let or_dash = |number: Option<f64>| number.map_or_else(|| "-".to_string(), |number| number.to_string());
    let [density, conductivity, expansion, heat] =
        [material.density, material.conductivity, material.expansion, material.heat_capacity].map(or_dash);
    let about = material.about.as_ref().map_or_else(String::new, |about| format!(" ({about})"));
    format!(
        "{name:<20} {young:>6}  {poisson:>7}  {density:>7}  {conductivity:>12}  {expansion:>9}  {heat:>13}  {source}{about}\n"
    )
}
