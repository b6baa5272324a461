//! Wear rules of body 1 that are functions of the pressure, `wear.table` and `wear.law`: their numbers, and what they do not go with.

use scene::{Fault, Functional, Pair, Pressure, Scene, Task, Wear, WearFunction};
use wear::{FunctionLaw, OwnRule, WearPair};

use super::table;
use crate::functional::functional_row;
use crate::setup::threshold;

/// The law that a scene names.
fn law(named: WearFunction) -> FunctionLaw {
    match named {
        WearFunction::Severe { mild, above, severe } => {
            FunctionLaw::Severe { mild: mild.value, above: above.0, severe: severe.value }
        }
        WearFunction::Saturating { k, half } => FunctionLaw::Saturating { k: k.value, half: half.0 },
    }
}

/// Body 1 wears by the function of a resolved scene.
pub(super) fn pair(wear: &Wear) -> Option<WearPair> {
    match wear.law {
        Some(named) => Some(WearPair::alone(OwnRule::from(law(named)))),
        None => table::rule(wear.table.as_deref()?).map(WearPair::alone),
    }
}

/// Checks the numbers of the function, and refuses what does not go with it.
pub(super) fn resolve(scene: &Scene, tasks: &[Task]) -> Result<(), Fault> {
    let Some(wear) = scene.wear.as_ref() else { return Ok(()) };
    let key = match (wear.law, &wear.table) {
        (None, None) => return Ok(()),
        (Some(_), _) => "wear.law",
        (None, Some(_)) => "wear.table",
    };
    alone(wear, key)?;
    sound(wear)?;
    if tasks.iter().any(|task| matches!(task, Task::Pressure | Task::Shape)) {
        let functional = scene.optimum.as_ref().and_then(|optimum| optimum.functional).unwrap_or(Functional::Steady);
        let row = functional_row(functional);
        if functional != Functional::Steady && row.needs.wear {
            let message = format!("the {} is answered for powers of the pressure, and {key} is none", row.word);
            return Err(Fault::at("optimum.functional", "not-available", message, "ask for optimum.functional = \"steady\""));
        }
    }
    threshold::motion(scene, tasks, key)
}

/// Refuses numbers through which no rule goes.
fn sound(wear: &Wear) -> Result<(), Fault> {
    if let Some((name, value, wanted)) = wear.law.and_then(|named| law(named).wrong()) {
        let message = format!("{name} = {value} is no number of this wear rule");
        return Err(Fault::at("wear.law", "wrong-value", message, format!("give {name} a value {wanted}")));
    }
    wear.table.as_deref().map_or(Ok(()), table::sound)
}

/// Refuses what says the same or another rule beside the function.
fn alone(wear: &Wear, rule: &str) -> Result<(), Fault> {
    let other = |given: Option<Pair<f64>>| given.is_some_and(|pair| pair != Pair::One(1.0) && pair != Pair::Two([1.0; 2]));
    let threshold = wear.threshold.is_some_and(|pair| pair != Pair::One(Pressure(0.0)) && pair != Pair::Two([Pressure(0.0); 2]));
    let by_table = rule == "wear.table";
    let named = if by_table { "a table" } else { "a law" };
    let (b, p0) = match by_table {
        true => ("the table says how wear grows with the pressure", "a row with k = 0 says up to where nothing wears"),
        false => ("the law says how wear grows with the pressure", "the law says what wears at which pressure"),
    };
    let given = [
        ("wear.table", !by_table && wear.table.is_some(), "keep one of them".to_string()),
        ("wear.beta", wear.beta.is_some(), "keep one of them".to_string()),
        ("wear.k", wear.k.is_some(), "keep one of them".to_string()),
        ("wear.a", other(wear.a), format!("leave it out: wear by {named} is proportional to the speed")),
        ("wear.b", other(wear.b), format!("leave it out: {b}")),
        ("wear.threshold", threshold, format!("leave it out: {p0}")),
    ];
    for (key, is_given, remedy) in given {
        if is_given {
            return Err(Fault::at(key, "two-alternatives", format!("both `{rule}` and `{key}` are given"), remedy));
        }
    }
    Ok(())
}
