//! Given cells are cut by their shape alone: cells that are as slender as each other, and those that touch two points to grade towards, are not told apart
//! by the direction in which they are walked, nor by a rounding error.

use wearshape::Solution;

use crate::common::{read, solved};

/// A punch of one cell on a plate of two, whose numbers of lengths follow, and the bodies.
const HEAD: &str = r#"
units = "N-mm"
kinematics = "plane-stress"
check = false
mesh = { degree = 5, layers = 2 }
contact = { edges = ["bottom", "top"], friction = 0.2, gap = 0 }
sliding = { speed = 1.0 }
wear = { k = [1e-6, 0.0], b = 1.0 }
[body1]
material = { young = 2e3, poisson = 0.3 }
support.left = ["x"]
[body1.geometry.blocks]
curves = { bottom.line = ["a", "b"], right.line = ["b", "c"], top.line = ["d", "c"], left.line = ["a", "d"] }
cells.punch = { curves = ["bottom", "right", "top", "left"] }
edges = { bottom = ["bottom"], top = ["top"], left = ["left"] }
[body2]
material = { young = 2e5, poisson = 0.3 }
support.bottom = ["x", "z"]
[body2.geometry.blocks.curves]
ab.line = ["a", "b"]
bc.line = ["b", "c"]
de.line = ["d", "e"]
ef.line = ["e", "f"]
ad.line = ["a", "d"]
be.line = ["b", "e"]
cf.line = ["c", "f"]
[body2.geometry.blocks]
edges = { bottom = ["ab", "bc"], top = ["de", "ef"] }
"#;

const PUNCH: [[f64; 2]; 4] = [[-10.0, 0.0], [10.0, 0.0], [10.0, 36.0], [-10.0, 36.0]];
const PLATE: [[f64; 2]; 6] = [[-40.0, -33.0], [-9.3, -33.0], [22.0, -33.0], [-40.0, 0.0], [-9.3, 0.0], [22.0, 0.0]];

/// The curves around the cells of the plate.
const AS_GIVEN: [[&str; 4]; 2] = [["ab", "be", "de", "ad"], ["bc", "cf", "ef", "be"]];

/// Lengths times a factor at equal stresses, for a task, with cells of the plate that are walked in some way.
fn answer(by: f64, task: &str, cells: [[&str; 4]; 2]) -> Solution {
    let points = |at: &[[f64; 2]]| {
        let place = |([x, z], name): (&[f64; 2], char)| format!("{name} = [{:?}, {:?}]", by * x, by * z);
        at.iter().zip('a'..).map(place).collect::<Vec<_>>().join(", ")
    };
    let text = format!(
        "tasks = [\"{task}\"]\nthickness = {:?}\nload = {{ edge = \"top\", as = \"pressure\", force = {:?} }}\n{HEAD}\
         points = {{ {} }}\ncells = {{ a.curves = {:?}, b.curves = {:?} }}\n",
        6.0 * by,
        1000.0 * by * by,
        points(&PLATE),
        cells[0],
        cells[1]
    );
    solved(&read(
        &text.replace("[body1.geometry.blocks]\n", &format!("[body1.geometry.blocks]\npoints = {{ {} }}\n", points(&PUNCH))),
        &[],
    ))
}

/// Largest difference of two columns, each over its own largest value.
fn apart(first: &[f64], second: &[f64]) -> f64 {
    assert_eq!(first.len(), second.len());
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    let [a, b] = [largest(first), largest(second)];
    first.iter().zip(second).map(|(x, y)| (x / a - y / b).abs()).fold(0.0, f64::max)
}

/// Pressures, of the same bodies larger and smaller, were 9e-3 of the largest apart at the corner of the punch.
#[test]
fn bodies_of_every_size_are_cut_alike() {
    let pressure = |by: f64| answer(by, "contact", AS_GIVEN).profile.unwrap().pressure;
    let own = pressure(1.0);
    for by in [1.3, 0.7, 0.0115, 3.1, 0.011] {
        let off = apart(&own, &pressure(by));
        assert!(off < 1e-9, "lengths times {by}: {off:e} apart");
    }
}

/// Displacements of the plate were 3.5e-4 of the largest apart.
#[test]
fn cells_are_cut_alike_from_whatever_side_they_are_walked() {
    let moved = |cells: [[&str; 4]; 2]| answer(1.0, "shape", cells).profile.unwrap().normal_displacement;
    let own = moved(AS_GIVEN);
    for cells in [[["be", "de", "ad", "ab"], AS_GIVEN[1]], [["de", "be", "ab", "ad"], ["ef", "cf", "bc", "be"]]] {
        let turned = moved(cells);
        for (one, other) in own.iter().zip(&turned) {
            assert!(apart(one, other) < 1e-9, "{cells:?}: {:e} apart", apart(one, other));
        }
    }
}
