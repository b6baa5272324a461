//! A uniform pressure under a force off the middle ends inside the surface in a jump.

use wearshape::Profile;

use crate::common::{read, solved};

/// A punch on a plate; lengths times `by`.
fn answer(by: f64) -> Profile {
    let number = |value: f64| format!("{:?}", by * value);
    let pair = |values: [f64; 2]| format!("{:?}", values.map(|v| by * v));
    let text = format!(
        r#"
units = "N-mm"
kinematics = "plane-strain"
thickness = {}
tasks = ["shape"]
check = false
mesh = {{ degree = 5, layers = 2 }}
contact = {{ edges = ["bottom", "top"], friction = 0.4, gap = 0 }}
sliding = {{ speed = 1.0 }}
load = {{ edge = "top", as = "rigid", force = {:?}, moment = {:?}, about = [0.0, 0.0] }}
wear = {{ k = [1e-6, 0.0], b = 1.0 }}
optimum = {{ functional = "uniform" }}
[body1]
material = {{ young = 1.6e4, poisson = 0.33 }}
support.top = ["x"]
geometry.rectangle = {{ x = {}, z = {} }}
[body2]
material = {{ young = 250.0, poisson = 0.1 }}
support.bottom = ["x", "z"]
geometry.rectangle = {{ x = {}, z = {} }}
"#,
        number(19.0),
        FORCE * by * by,
        MOMENT * by * by * by,
        pair([-5.0, 5.0]),
        pair([0.0, 4.0]),
        pair([-15.0, 8.0]),
        pair([-7.0, 0.0])
    );
    solved(&read(&text, &[])).profile.unwrap()
}

const FORCE: f64 = 16.0;
const MOMENT: f64 = -8.0;

/// The node on the jump carries what belongs to it: before, it carried all of its area or nothing, as round-off would have it.
#[test]
fn the_forces_of_a_pressure_that_jumps_are_those_of_the_load() {
    let found = answer(1.0);
    let sum = |value: &dyn Fn(usize) -> f64| {
        (0..found.pressure.len()).map(|i| found.weight[i] * found.pressure[i] * value(i)).sum::<f64>()
    };
    let (force, largest) = (sum(&|_| 1.0), found.pressure.iter().fold(0.0_f64, |most, p| most.max(*p)));
    assert!((force - FORCE).abs() < 1e-9 * FORCE, "{force} N of {FORCE}");
    // Turning about the y axis, from z to x; friction acts at z = 0.
    let moment = sum(&|i| -found.position[i][0]).abs();
    assert!((moment - MOMENT.abs()).abs() < 1e-9 * FORCE, "{moment} N mm of {MOMENT}");
    let between = found.pressure.iter().filter(|p| **p > 0.0 && **p < 0.999 * largest).count();
    assert_eq!(between, 1, "one node is on the jump");
}

#[test]
fn a_jump_is_at_the_same_place_at_every_scale() {
    let own = answer(1.0);
    for by in [0.83, 1.7, 3e-3, 130.0, 0.9, 1.1, 1.3] {
        let twin = answer(by);
        let most = own.gap.iter().fold(0.0_f64, |most, gap| most.max(gap.abs()));
        let pairs = || own.gap.iter().zip(&twin.gap).zip(own.pressure.iter().zip(&twin.pressure));
        assert_eq!(own.gap.len(), twin.gap.len());
        for ((gap, scaled), (p, q)) in pairs() {
            assert!((gap - scaled / by).abs() <= 1e-9 * most, "lengths times {by}: gaps {gap} and {}", scaled / by);
            assert!((p - q).abs() <= 1e-9 * (p + q), "lengths times {by}: pressures {p} and {q}");
        }
    }
}
