//! Hot contacts that end inside their surface, of which there may be several.

use wearshape::{SpeedFactor, Status};

use crate::common::{read, scene, solved};

const SLAB: &str = r#"
units = "N-mm"
kinematics = "plane-strain"
thickness = 10
tasks = ["contact"]
accuracy = 1e-6
body1.material = { young = "200 GPa", poisson = 0.3, conductivity = 20, expansion = 12e-6 }
body1.geometry.rectangle = { x = [-10, 10], z = [0, 20] }
body1.support = { left = ["x"], right = ["x"] }
body2.material = { young = "100 GPa", poisson = 0.25, conductivity = 50, expansion = 18e-6 }
body2.geometry.rectangle = { x = [-10, 10], z = [-30, 0] }
body2.support = { left = ["x"], right = ["x"], bottom = ["x", "z"] }
contact = { edges = ["bottom", "top"], friction = 0.25, gap = 0 }
sliding = { speed = "30 mm/s" }
load = { edge = "top", as = "rigid", force = "1 kN" }
heat = { conductance = 0.5, reference = 20, counterface = "congruent" }
body1.heat.top = { temperature = 20 }
body2.heat.bottom = { convection = 2, ambient = 30 }
"#;

/// At three to four times its speed the annulus touches inside its width, in one place or another: the heat that crosses the contact depends on where it ends.
/// The standing mesh leads to places further outside, to the border of a cell (72 mm) or beyond a branch (85.23 mm at 8.4 rad/s); what continues the contact of
/// slower sliding is found at every speed. Degree 12 with 12 layers has 97.685, 95.116, 91.081 and 89.462 mm.
#[test]
fn a_hot_contact_is_the_one_that_continues_that_of_slower_sliding() {
    for (speed, outer) in [(6.4, 97.685), (7.0, 95.116), (8.4, 91.081), (9.2, 89.462)] {
        let settings = ["tasks=[contact]", "mesh.degree=8", "mesh.layers=8", &format!("sliding.omega={speed}")];
        let solution = solved(&scene("clutch-hot", &settings));
        assert!(solution.status == Status::Ok && solution.remarks.is_empty(), "{speed}: {:?}", solution.remarks);
        let contact = solution.contact.unwrap();
        assert!((contact.ends[0] - 71.44).abs() < 0.05 && (contact.ends[1] - outer).abs() < 0.06, "{speed}: {:?}", contact.ends);
    }
}

/// Two blocks whose top tilts freely touch when they are hot on one side of their surface, or on the other: pressure, ends and the
/// speed at which they are no longer unique are those of one contact. Degree 12 has the end at -1.5845 mm and the factor 1.46963.
#[test]
fn ends_and_critical_speed_of_a_hot_contact_are_those_of_its_pressure() {
    for degree in [6, 8] {
        let mesh = [format!("mesh.degree={degree}"), format!("mesh.layers={degree}")];
        let solution = solved(&read(SLAB, &[&mesh[0], &mesh[1]]));
        assert_eq!(solution.status, Status::Ok, "{degree}: {:?}", solution.reason);
        let (contact, heat) = (solution.contact.unwrap(), solution.heat.unwrap());
        assert!((contact.ends[0] + 1.5845).abs() < 5e-3 && contact.ends[1] == 10.0, "{degree}: {:?}", contact.ends);
        let profile = solution.profile.unwrap();
        let pressed = |i: &usize| profile.pressure[*i] > 0.0;
        let first = (0..profile.pressure.len()).find(pressed).unwrap();
        assert!((profile.position[first][0] - contact.ends[0]).abs() < 0.1, "{degree}: {:?}", profile.position[first]);
        let Some(SpeedFactor::At(factor)) = heat.critical_speed_factor else { panic!("{degree}: no factor") };
        assert!((factor / 1.46963 - 1.0).abs() < 2e-3, "{degree}: {factor}");
    }
}
