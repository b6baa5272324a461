//! What the schedule of a run in time makes of load and sliding, in words.

use scene::{Scene, Schedule};

use crate::brief::brief;

/// What follows a number that the schedule multiplies by factors: nothing where they are all 1.
pub(crate) fn by_schedule(scene: &Scene, factors: fn(&Schedule) -> Option<&Vec<f64>>) -> String {
    let Some([low, high]) = scene.schedule.as_ref().and_then(factors).and_then(|factors| range(factors)) else {
        return String::new();
    };
    match (low, high) {
        (1.0, 1.0) => String::new(),
        _ if low == high => format!(" times {} by the schedule", brief(low)),
        _ => format!(" times {} to {} by the schedule", brief(low), brief(high)),
    }
}

/// Whether the schedule changes how fast body 2 slides, whichever way it goes.
pub(crate) fn speed_changes(scene: &Scene) -> bool {
    let factors = scene.schedule.iter().filter_map(|schedule| schedule.speed.as_ref()).flatten();
    let speeds: Vec<f64> = factors.map(|factor| factor.abs()).collect();
    range(&speeds).is_some_and(|[low, high]| low < high)
}

/// Whether the schedule changes the way that body 2 slides.
pub(crate) fn turns_back(scene: &Scene) -> bool {
    let factors = scene.schedule.as_ref().and_then(|schedule| schedule.speed.as_ref());
    factors.and_then(|factors| range(factors)).is_some_and(|[low, high]| low < 0.0 && high > 0.0)
}

/// Least and greatest of some factors.
fn range(factors: &[f64]) -> Option<[f64; 2]> {
    let low = factors.iter().copied().reduce(f64::min)?;
    Some([low, factors.iter().copied().fold(low, f64::max)])
}

#[cfg(test)]
mod tests {
    use scene::{Document, Fault, Scene, builtin};

    use super::{by_schedule, speed_changes, turns_back};

    fn scene(schedule: &str) -> Result<Scene, Fault> {
        let settings = [format!("schedule={{{schedule}}}")];
        let text = builtin("punch-wear").map_or("", |scene| scene.text);
        Ok(Document::read("punch-wear.toml", text, &settings)?.scene)
    }

    #[test]
    fn what_changes_is_told_with_its_range() -> Result<(), Fault> {
        let changing = scene("force=[1,0.5,1],speed=[1,0.1,-3]")?;
        let speed = |text: &str| scene(text).map(|scene| by_schedule(&scene, |schedule| schedule.speed.as_ref()));
        assert_eq!(by_schedule(&changing, |schedule| schedule.force.as_ref()), " times 0.5 to 1 by the schedule");
        assert_eq!(by_schedule(&changing, |schedule| schedule.speed.as_ref()), " times -3 to 1 by the schedule");
        assert_eq!(by_schedule(&changing, |schedule| schedule.moment.as_ref()), "");
        assert_eq!(speed("speed=[2]")?, " times 2 by the schedule");
        assert_eq!(speed("speed=[1,1]")?, "");
        Ok(())
    }

    #[test]
    fn another_way_is_no_other_speed() -> Result<(), Fault> {
        let told = |schedule: &str| scene(schedule).map(|scene| (speed_changes(&scene), turns_back(&scene)));
        assert_eq!(told("speed=[1,0.1]")?, (true, false));
        assert_eq!(told("speed=[2,-2]")?, (false, true));
        assert_eq!(told("force=[1,2]")?, (false, false));
        Ok(())
    }
}
