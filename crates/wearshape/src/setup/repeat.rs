//! Schedules that repeat: cycles of reversals, one after the other until the run ends.

use scene::{Fault, Scene, Schedule, Time, missing};

use crate::problem::{Cycles, Piece};

/// Most cycles: counts up to here are whole numbers and times of their own.
const MOST: f64 = 1e12;

/// Share of the time that goes forward where the motion reverses by itself.
fn share(scene: &Scene) -> Option<f64> {
    scene.sliding.as_ref()?.reversing.as_ref()?.share
}

/// Checks how often a schedule repeats and how long a cycle takes, and fills in the length of a cycle that the motion has.
pub(super) fn resolve(scene: &mut Scene) -> Result<(), Fault> {
    let share = share(scene);
    let own = scene.sliding.as_ref().and_then(|sliding| sliding.cycle.as_ref()).and_then(|cycle| cycle.frequency);
    let Some(schedule) = &mut scene.schedule else { return Ok(()) };
    let lists = schedule.time.is_some() || schedule.force.is_some() || schedule.moment.is_some() || schedule.speed.is_some();
    if share.is_some() && lists {
        let message = "the motion reverses by itself, and the schedule has pieces of its own";
        let remedy =
            "keep sliding.reversing with schedule = { repeat = 1000, period = \"2 s\" }, or the pieces without sliding.reversing";
        return Err(Fault::at("schedule", "two-alternatives", message, remedy));
    }
    let Some(repeat) = schedule.repeat else {
        return match schedule.period {
            Some(_) => Err(missing("schedule.repeat", "a cycle has a period, and no number of times", "repeat = 1000")),
            None if share.is_some() => {
                Err(missing("schedule.repeat", "the schedule of a reversing motion repeats", "repeat = 1000"))
            }
            None => Ok(()),
        };
    };
    if !(1.0..=MOST).contains(&repeat) || repeat.fract() != 0.0 {
        let message = format!("the number of cycles {repeat} is no whole number from 1 to {MOST:e}");
        return Err(Fault::at("schedule.repeat", "wrong-value", message, "give a whole number, as in repeat = 1000"));
    }
    match (schedule.period, own) {
        (Some(_), Some(_)) if share.is_some() => {
            let message = "both schedule.period and sliding.cycle.frequency say how long a cycle takes";
            return Err(Fault::at("schedule.period", "two-alternatives", message, "leave schedule.period out"));
        }
        (None, Some(frequency)) if share.is_some() => schedule.period = Some(Time(1.0 / frequency.0)),
        (None, _) => return Err(missing("schedule.period", "nothing says how long a cycle takes", "period = \"2 s\"")),
        (Some(_), _) => {}
    }
    period(schedule)?;
    if share.is_some_and(|share| share == 0.0 || share == 1.0) {
        let message = "a motion that goes one way all the time has no reversals to repeat";
        return Err(Fault::at("schedule.repeat", "wrong-value", message, "leave schedule.repeat out"));
    }
    if share.is_none() {
        reverses(schedule)?;
    }
    if scene.wear.as_ref().is_some_and(|wear| wear.until.is_some()) {
        let message = "schedule.repeat ends the run after its last cycle, and wear.until says another end";
        return Err(Fault::at("wear.until", "two-alternatives", message, "keep one of schedule.repeat and wear.until"));
    }
    Ok(())
}

/// Checks the length of a cycle.
fn period(schedule: &Schedule) -> Result<(), Fault> {
    let Some(period) = schedule.period else { return Ok(()) };
    scene::positive("schedule.period", period.0, "length of a cycle", " s")?;
    let last = schedule.time.iter().flatten().last().map_or(0.0, |time| time.0);
    if period.0 <= last {
        let message = format!("a cycle of {} s ends before its last piece begins, at {last} s", period.0);
        return Err(Fault::at("schedule.period", "wrong-value", message, "give the time at which the last piece ends"));
    }
    Ok(())
}

/// Refuses cycles whose pieces slide all alike: they are no reversals.
fn reverses(schedule: &Schedule) -> Result<(), Fault> {
    let speeds = schedule.speed.as_deref().unwrap_or_default();
    let changes = speeds.iter().any(|speed| *speed != speeds[0]);
    if changes {
        return Ok(());
    }
    let message = "the pieces that repeat slide at one speed: there is no reversal, nor another change of it";
    Err(Fault::at(
        "schedule.repeat",
        "wrong-value",
        message,
        "give the speeds of a cycle, as in speed = [1, -1], or leave `repeat` out",
    ))
}

/// The cycles of a resolved schedule that repeats.
pub(super) fn cycles(scene: &Scene) -> Option<Cycles> {
    let schedule = scene.schedule.as_ref()?;
    Some(Cycles { count: schedule.repeat?, period: schedule.period?.0 })
}

/// Pieces of a cycle of a motion that reverses by itself.
pub(super) fn both_ways(scene: &Scene) -> Option<Vec<Piece>> {
    let (share, cycles) = share(scene).zip(cycles(scene))?;
    let piece = |time: f64, speed: f64| Piece { time, factors: [1.0, 1.0, speed] };
    Some(vec![piece(0.0, 1.0), piece(share * cycles.period, -1.0)])
}
