//! Lines along which displacement and stress are written.

use std::f64::consts::TAU;

use scene::{Fault, Scene, Task};

use crate::problem::Path;

/// Points of a line that gives no number, and the most.
const POINTS: usize = 101;
const MOST: usize = 100_000;

/// Checks the lines and fills in their numbers of points; none of a scene without elastic bodies.
pub(super) fn resolve(scene: &mut Scene, tasks: &[Task]) -> Result<Vec<Path>, Fault> {
    let elastic = scene.surface.is_none() && tasks != [Task::Pressure];
    let Some(output) = scene.output.as_mut() else { return Ok(Vec::new()) };
    let mut paths: Vec<Path> = Vec::new();
    for (number, path) in output.paths.iter_mut().enumerate() {
        let key = format!("output.paths.{number}");
        let refused =
            |of: &str, message: String, remedy: &str| Err(Fault::at(format!("{key}.{of}"), "wrong-value", message, remedy));
        let name = &path.name;
        if name.is_empty() || !name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'-') {
            return refused("name", format!("`{name}` cannot go into the name of a file"), "use letters, digits and hyphens");
        }
        if paths.iter().any(|other| other.name.eq_ignore_ascii_case(name)) {
            return refused("name", format!("two paths are called `{name}`"), "give each a name of its own");
        }
        if !(1..=2).contains(&path.body) {
            return refused("body", format!("there is no body {}", path.body), "write body = 1 or body = 2");
        }
        let points = *path.points.get_or_insert(POINTS);
        if !(2..=MOST).contains(&points) {
            return refused("points", format!("a path of {points} points"), "give from 2 to 100000 points");
        }
        let ends = [path.from, path.to].map(|end| end.map(|x| x.0));
        if ends[0] == ends[1] && path.centre.is_none() {
            return refused("to", format!("the path `{name}` ends where it begins"), "give another end");
        }
        let places = match path.centre.map(|centre| centre.map(|x| x.0)) {
            None => straight(ends, points),
            Some(centre) => match around(centre, ends, points) {
                Ok(places) => places,
                Err([first, second]) => {
                    let message = format!("the path `{name}` begins {first} mm from its centre and ends {second} mm from it");
                    return refused("centre", message, "give both ends one distance, greater than 0, from the centre");
                }
            },
        };
        paths.push(Path { key, name: name.clone(), body: path.body - 1, places });
    }
    Ok(if elastic { paths } else { Vec::new() })
}

/// So many points on the straight line between two ends, and their distances from the first.
fn straight([from, to]: [[f64; 2]; 2], points: usize) -> Vec<(f64, [f64; 2])> {
    let length = (to[0] - from[0]).hypot(to[1] - from[1]);
    let last = (points - 1) as f64;
    let place = |k: usize| {
        let t = k as f64 / last;
        (t * length, [0, 1].map(|i| if t == 1.0 { to[i] } else { from[i] + t * (to[i] - from[i]) }))
    };
    (0..points).map(place).collect()
}

/// The same on an arc, anti-clockwise, a whole circle where both ends are one point. Distances of the ends from the centre that are not one are an error.
fn around(centre: [f64; 2], ends: [[f64; 2]; 2], points: usize) -> Result<Vec<(f64, [f64; 2])>, [f64; 2]> {
    let [from, to] = ends.map(|[x, z]| [x - centre[0], z - centre[1]]);
    let [first, second] = [from, to].map(|[x, z]| x.hypot(z));
    if !(first > 0.0 && (first - second).abs() <= 1e-9 * first) {
        return Err([first, second]);
    }
    let turn = (to[1].atan2(to[0]) - from[1].atan2(from[0])).rem_euclid(TAU);
    let turn = if ends[0] == ends[1] || turn == 0.0 { TAU } else { turn };
    let last = points - 1;
    let place = |k: usize| {
        let angle = turn * k as f64 / last as f64;
        let (sine, cosine) = angle.sin_cos();
        let x = [from[0] * cosine - from[1] * sine, from[0] * sine + from[1] * cosine];
        // Both ends are as they were written.
        let at = if k == 0 {
            ends[0]
        } else if k == last {
            ends[1]
        } else {
            [centre[0] + x[0], centre[1] + x[1]]
        };
        (first * angle, at)
    };
    Ok((0..points).map(place).collect())
}
