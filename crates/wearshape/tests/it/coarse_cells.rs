//! Bodies of one given cell each.

use crate::common::{read, solved};

/// A punch on a longer plate, each of one cell, under a force beside its middle: part of the surface carries nothing.
const PUNCH: &str = r#"
units = "N-mm"
kinematics = "plane-stress"
thickness = 1.0
tasks = ["shape"]
check = false
mesh = { degree = 5, layers = 2 }
contact = { edges = ["bottom", "top"], friction = 0.2, gap = 0 }
sliding = { speed = 1.0 }
load = { edge = "top", as = "rigid", force = 4.0, moment = 36.0, about = [0, 0] }
wear = { k = [1e-6, 0.0], b = 1.0 }
[body1]
material = { young = 1e5, poisson = 0.1 }
support.top = ["x"]
[body1.geometry.blocks]
points = { a = [-20.0, 0.0], b = [20.0, 0.0], c = [20.0, 70.0], d = [-20.0, 70.0] }
curves = { ab.line = ["a", "b"], bc.line = ["b", "c"], dc.line = ["d", "c"], ad.line = ["a", "d"] }
cells.punch = { curves = ["ab", "bc", "dc", "ad"] }
edges = { bottom = ["ab"], top = ["dc"] }
[body2]
material = { young = 1e3, poisson = 0.1 }
support.bottom = ["x", "z"]
[body2.geometry.blocks]
points = { a = [-90.0, -60.0], b = [60.0, -60.0], c = [60.0, 0.0], d = [-90.0, 0.0] }
curves = { ab.line = ["a", "b"], bc.line = ["b", "c"], dc.line = ["d", "c"], ad.line = ["a", "d"] }
cells.plate = { curves = ["ab", "bc", "dc", "ad"] }
edges = { bottom = ["ab"], top = ["dc"] }
"#;

/// The end of the pressure does not become the end of the surface: a vertex of the plate at the end of the punch stays there.
#[test]
fn a_surface_that_carries_in_part_is_shaped_as_a_whole() {
    for moment in ["load.moment=36", "load.moment=-36"] {
        let found = solved(&read(PUNCH, &[moment])).profile.unwrap();
        let ends = [found.position[0], found.position[found.position.len() - 1]].map(|place| place[0]);
        assert!((ends[0] + 20.0).abs() < 1e-9 && (ends[1] - 20.0).abs() < 1e-9, "{moment}: from {} to {} mm", ends[0], ends[1]);
        assert!(found.pressure.contains(&0.0), "{moment}: part of the surface carries nothing");
    }
}
