//! What a run is expected to take, with frictional heat and without.

use std::cell::Cell;

use wearshape::{Forecast, Options, Problem, builtin};

use crate::common::{read, scene};

/// A clock that goes on by a second whenever its thread looks at it.
fn ticking() -> f64 {
    thread_local! { static LOOKS: Cell<u32> = const { Cell::new(0) } }
    LOOKS.set(LOOKS.get() + 1);
    f64::from(LOOKS.get())
}

fn forecast(problem: &Problem) -> Vec<Forecast> {
    problem.forecast(&Options { clock: ticking, ..Options::default() }).unwrap()
}

/// A built-in scene without what it says of heat.
fn cold(name: &str, settings: &[&str]) -> Problem {
    let of_heat = |line: &&str| ["heat", "body1.heat", "body2.heat"].iter().any(|key| line.starts_with(key));
    let lines: Vec<&str> = builtin(name).unwrap().text.lines().filter(|line| !of_heat(line)).collect();
    read(&lines.join("\n"), settings)
}

#[test]
fn heat_takes_seconds_and_memory_on_the_same_unknowns() {
    for name in ["drum-brake-hot", "clutch-hot"] {
        for settings in [&[][..], &["check=false"], &["tasks=[contact]"], &["mesh.degree=6"]] {
            let (hot, cold) = (forecast(&scene(name, settings)), forecast(&cold(name, settings)));
            assert_eq!(hot.len(), cold.len(), "{name} {settings:?}");
            for (hot, cold) in hot.iter().zip(&cold) {
                let sizes = |level: &Forecast| {
                    [level.degree, level.layers, level.cells, level.dofs, level.trace_dofs, level.contact_points]
                };
                assert_eq!(sizes(hot), sizes(cold), "{name} {settings:?}");
                // The heat of each contact point displaces the whole contact surface.
                let responses = (8 * hot.contact_points * hot.trace_dofs) as u64;
                assert!(hot.memory_bytes > cold.memory_bytes + responses, "{name} {settings:?}: {hot:?} {cold:?}");
                assert!(hot.about_seconds > cold.about_seconds, "{name} {settings:?}: {hot:?} {cold:?}");
            }
        }
    }
}

#[test]
fn a_second_body_with_a_temperature_of_its_own_takes_memory() {
    let memory = |counterface: &str| -> Vec<u64> {
        let meets = format!("heat.counterface={counterface}");
        forecast(&scene("clutch-hot", &["heat.conductance=10", &meets])).iter().map(|level| level.memory_bytes).collect()
    };
    let (own, none) = (memory("congruent"), memory("fresh"));
    assert!(own.iter().zip(&none).all(|(own, none)| own > none), "{own:?} {none:?}");
}
