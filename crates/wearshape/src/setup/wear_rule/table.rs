//! A wear rule from a table of measured wear factors: its rows, and what it does not go with.

use scene::{Fault, Functional, Pair, Pressure, Scene, Task, Wear, WearFactor};
use wear::{OwnRule, TableError, TableLaw, WearPair};

use crate::functional::functional_row;
use crate::setup::threshold;

/// Wear by distance at the pressures of a table, `W = k p`.
fn law(rows: &[(Pressure, WearFactor)]) -> Result<TableLaw, TableError> {
    TableLaw::new(&rows.iter().map(|(pressure, k)| [pressure.0, k.value * pressure.0]).collect::<Vec<_>>())
}

/// Body 1 wears by the table of a resolved scene.
pub(super) fn pair(rows: &[(Pressure, WearFactor)]) -> Option<WearPair> {
    law(rows).ok().map(|law| WearPair::alone(OwnRule::from(law)))
}

/// Checks the rows of the table, and refuses what does not go with it.
pub(super) fn resolve(scene: &Scene, tasks: &[Task]) -> Result<(), Fault> {
    let Some((wear, rows)) = scene.wear.as_ref().and_then(|wear| Some((wear, wear.table.as_deref()?))) else { return Ok(()) };
    alone(wear)?;
    if let Err(TableError { row, why }) = law(rows) {
        let key = if rows.is_empty() { "wear.table".into() } else { format!("wear.table.{row}") };
        let remedy = "give pressures that increase with factors whose k p grows, as in table = [[\"0.5 MPa\", \"1e-7 mm^3/(N m)\"], [2, 3e-10]]";
        return Err(Fault::at(key, "wrong-value", format!("no wear rule goes through this row of the table: {why}"), remedy));
    }
    if tasks.iter().any(|task| matches!(task, Task::Pressure | Task::Shape)) {
        let functional = scene.optimum.as_ref().and_then(|optimum| optimum.functional).unwrap_or(Functional::Steady);
        let row = functional_row(functional);
        if functional != Functional::Steady && row.needs.wear {
            let message = format!("the {} is answered for powers of the pressure, and wear.table is none", row.word);
            return Err(Fault::at("optimum.functional", "not-available", message, "ask for optimum.functional = \"steady\""));
        }
    }
    threshold::motion(scene, tasks, "wear.table")
}

/// Refuses what says the same or another rule beside the table.
fn alone(wear: &Wear) -> Result<(), Fault> {
    let other = |given: Option<Pair<f64>>| given.is_some_and(|pair| pair != Pair::One(1.0) && pair != Pair::Two([1.0; 2]));
    let threshold = wear.threshold.is_some_and(|pair| pair != Pair::One(Pressure(0.0)) && pair != Pair::Two([Pressure(0.0); 2]));
    let given = [
        ("wear.beta", wear.beta.is_some(), "keep one of them"),
        ("wear.k", wear.k.is_some(), "keep one of them"),
        ("wear.a", other(wear.a), "leave it out: wear by a table is proportional to the speed"),
        ("wear.b", other(wear.b), "leave it out: the table says how wear grows with the pressure"),
        ("wear.threshold", threshold, "leave it out: a row with k = 0 says up to where nothing wears"),
    ];
    for (key, is_given, remedy) in given {
        if is_given {
            return Err(Fault::at(key, "two-alternatives", format!("both `wear.table` and `{key}` are given"), remedy));
        }
    }
    Ok(())
}
