//! What guides and moves a rigid edge: its force and moment balance those of the other supports and the weight.

use crate::common::{read, scene, solved};

/// Sum of the reactions [N, N, N mm], and the largest force.
fn sum(solution: &wearshape::Solution) -> ([f64; 3], f64) {
    let all: Vec<[f64; 3]> = solution.reactions.iter().map(|(_, r)| [r.x, r.z, r.moment].map(Option::unwrap)).collect();
    let sum = std::array::from_fn(|k| all.iter().map(|r| r[k]).sum());
    (sum, all.iter().flat_map(|r| [r[0].abs(), r[1].abs()]).fold(0.0, f64::max))
}

/// The edge of a punch takes its load and the friction at the foot, 100 mm below; of an edge free to tilt or held, whichever way the plate moves.
#[test]
fn the_guide_of_a_punch_takes_friction_and_its_moment() {
    for settings in [&[][..], &["load.moment=3000"], &["sliding.speed=-5"], &["tasks=[contact]", "contact.friction=0"]] {
        let solution = solved(&scene("translating-punch", &[&["accuracy=1e-3", "check=false"], settings].concat()));
        let (left, size) = sum(&solution);
        assert!(left[0].abs().max(left[1].abs()) < 1e-12 * size && left[2].abs() < 1e-10 * size, "{settings:?}: {left:?}");
        let (_, guide) = solution.reactions.iter().find(|(edge, _)| edge == "body1.top").unwrap();
        assert!((guide.z.unwrap() + 1000.0).abs() < 1e-9, "{settings:?}: {guide:?}");
        let drag = if settings.contains(&"contact.friction=0") { 0.0 } else { -250.0 };
        let drag = if settings.contains(&"sliding.speed=-5") { -drag } else { drag };
        assert!((guide.x.unwrap() - drag).abs() < 1e-9, "{settings:?}: {guide:?}");
    }
}

/// It carries the weight besides: 7850 kg/m^3 on 60 by 100 by 10 mm, in the middle of the body.
#[test]
fn it_carries_the_weight() {
    let gravity = ["accuracy=1e-3", "check=false", "body1.material.density=7850 kg/m^3", "body1.gravity=[2000,-9810]"];
    let (left, _) = sum(&solved(&scene("translating-punch", &gravity)));
    let mass = 7.85e-9 * 60.0 * 100.0 * 10.0;
    let [x, z] = [2000.0 * mass, -9810.0 * mass];
    for (left, wanted) in left.into_iter().zip([-x, -z, 150.0 * x]) {
        assert!((left - wanted).abs() < 1e-8, "{left} {wanted}");
    }
}

/// A shaft in its housing with friction: the surfaces have different radii, and the moment of friction is that of the surface of each.
#[test]
fn a_housing_takes_what_its_shaft_presses() {
    let solution = solved(&scene("journal", &["accuracy=1e-3"]));
    let (left, size) = sum(&solution);
    assert!(left[0].abs().max(left[1].abs()) < 1e-12 * size, "{left:?}");
    // Beside supports at its sides the guide of a block takes the rest.
    let beside = "body1.support.left=['x']";
    let solution = solved(&read(BLOCK, &[beside]));
    let (left, size) = sum(&solution);
    assert!(solution.reactions.iter().any(|(edge, _)| edge == "body1.left"));
    assert!(left[0].abs().max(left[1].abs()) < 1e-12 * size && left[2].abs() < 1e-10 * size, "{left:?}");
}

/// A block whose rigid edge moves, on a plate.
const BLOCK: &str = r#"
units = "N-mm"
kinematics = "plane-strain"
thickness = 5
tasks = ["contact"]
accuracy = 1e-2
body1.material = { young = 70000, poisson = 0.3 }
body1.geometry.rectangle = { x = [-10, 10], z = [0, 12] }
body2.material = { young = 200000, poisson = 0.3 }
body2.geometry.rectangle = { x = [-40, 40], z = [-20, 0] }
body2.support = { bottom = ["x", "z"] }
contact = { edges = ["bottom", "top"], friction = 0.2, gap = 0 }
sliding = { speed = "1 m/s" }
load = { edge = "top", as = "rigid", force = 500, tilt = 0, about = [0, 0] }
wear = { k = [1e-8, 0] }
"#;
