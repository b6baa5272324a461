//! The schedule of a run in time: its lists fit each other and the scene, its times increase.

use scene::{Fault, Scene, Schedule, Time, missing};

use crate::problem::Piece;
use crate::setup::repeat;

/// Checks the schedule and fills in the lists that the scene's load and sliding have.
pub(super) fn resolve(scene: &mut Scene) -> Result<(), Fault> {
    let load = scene.load.clone().unwrap_or_default();
    repeat::resolve(scene)?;
    let reverses = scene.sliding.as_ref().is_some_and(|sliding| sliding.reversing.is_some());
    let Some(schedule) = scene.schedule.as_mut().filter(|_| !reverses) else { return Ok(()) };
    let pieces = times(schedule)?;
    if schedule.force.is_none() && schedule.moment.is_none() && schedule.speed.is_none() {
        let why = "nothing changes from piece to piece";
        return Err(missing("schedule.force", why, "force = [1, 0.5] (or moment, speed)"));
    }
    let fits = |name: &str, list: &Option<Vec<f64>>, wrong: fn(f64) -> bool, what: &str, remedy: &str| {
        let list = list.as_deref().unwrap_or_default();
        let key = format!("schedule.{name}");
        if !list.is_empty() && list.len() != pieces {
            let message = format!("{} numbers for {pieces} pieces: {key} and schedule.time differ in length", list.len());
            return Err(Fault::at(key, "wrong-length", message, format!("give {pieces} numbers, one for each time")));
        }
        match list.iter().position(|factor| !factor.is_finite() || wrong(*factor)) {
            Some(place) => {
                let message = format!("the factor {} of piece {} {what}", list[place], place + 1);
                Err(Fault::at(format!("{key}.{place}"), "wrong-value", message, remedy.to_string()))
            }
            None => Ok(()),
        }
    };
    let pressed = "give factors greater than 0, as in force = [1, 0.5]";
    fits("force", &schedule.force, |f| f <= 0.0, "does not press body 1 on body 2", pressed)?;
    fits("moment", &schedule.moment, |_| false, "is no number", "give finite numbers, as in moment = [0, 1]")?;
    let slides = "leave a standstill out (nothing wears in it); a negative factor slides the other way";
    fits("speed", &schedule.speed, |f| f == 0.0, "stops the sliding", slides)?;
    if schedule.force.is_some() && load.force.is_none() {
        let message = "schedule.force multiplies load.force, and there is none";
        return Err(Fault::at("schedule.force", "wrong-value", message, "give load.force, or leave the factors out"));
    }
    if schedule.moment.is_some() && load.moment.is_none_or(|moment| moment.0 == 0.0) {
        let message = "schedule.moment multiplies load.moment, and there is none but 0";
        return Err(Fault::at("schedule.moment", "wrong-value", message, "give load.moment, as in moment = \"5 kN mm\""));
    }
    if load.force.is_some() {
        schedule.force.get_or_insert_with(|| vec![1.0; pieces]);
    }
    schedule.speed.get_or_insert_with(|| vec![1.0; pieces]);
    Ok(())
}

/// Number of pieces.
fn times(schedule: &Schedule) -> Result<usize, Fault> {
    let key = "schedule.time";
    let Some(times) = schedule.time.as_ref().filter(|times| !times.is_empty()) else {
        return Err(missing(key, "a schedule needs the times at which its pieces begin", "time = [0, \"100 s\"]"));
    };
    if times[0].0 != 0.0 {
        let message = format!("the first piece begins at {} s", times[0].0);
        return Err(Fault::at(format!("{key}.0"), "wrong-value", message, "let it begin at 0"));
    }
    if let Some(place) = (1..times.len()).find(|place| times[*place].0 <= times[place - 1].0) {
        let message = format!("the times do not increase: {} s after {} s", times[place].0, times[place - 1].0);
        return Err(Fault::at(format!("{key}.{place}"), "wrong-value", message, "give the times in ascending order"));
    }
    Ok(times.len())
}

/// The pieces of a resolved schedule; none without one.
pub(super) fn pieces(scene: &Scene) -> Vec<Piece> {
    if let Some(pieces) = repeat::both_ways(scene) {
        return pieces;
    }
    let Some(schedule) = &scene.schedule else { return Vec::new() };
    let factor = |list: &Option<Vec<f64>>, piece: usize| list.as_ref().and_then(|list| list.get(piece)).copied().unwrap_or(1.0);
    let piece = |(number, time): (usize, &Time)| Piece {
        time: time.0,
        factors: [&schedule.force, &schedule.moment, &schedule.speed].map(|list| factor(list, number)),
    };
    schedule.time.iter().flatten().enumerate().map(piece).collect()
}
