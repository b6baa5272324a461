//! A wear rule from a table of measured wear factors.

use scene::{Fault, Pressure, WearFactor};
use wear::{OwnRule, TableError, TableLaw};

/// Wear by distance at the pressures of a table, `W = k p`.
fn law(rows: &[(Pressure, WearFactor)]) -> Result<TableLaw, TableError> {
    TableLaw::new(&rows.iter().map(|(pressure, k)| [pressure.0, k.value * pressure.0]).collect::<Vec<_>>())
}

/// The rule of the table of a resolved scene.
pub(super) fn rule(rows: &[(Pressure, WearFactor)]) -> Option<OwnRule> {
    law(rows).ok().map(OwnRule::from)
}

/// Checks the rows of the table.
pub(super) fn sound(rows: &[(Pressure, WearFactor)]) -> Result<(), Fault> {
    law(rows).map(|_| ()).map_err(|TableError { row, why }| {
        let key = if rows.is_empty() { "wear.table".into() } else { format!("wear.table.{row}") };
        let remedy = "give pressures that increase with factors whose k p grows, as in table = [[\"0.5 MPa\", \"1e-7 mm^3/(N m)\"], [2, 3e-10]]";
        Fault::at(key, "wrong-value", format!("no wear rule goes through this row of the table: {why}"), remedy)
    })
}
