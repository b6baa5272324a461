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

/// At three times its speed and more the annulus touches inside its width, in one place or another: the heat that crosses the contact depends on where it ends.
/// The standing mesh leads to places further outside, to the border of a cell (72 mm), beyond a branch (85.23 mm at 8.4 rad/s) or to contact all over; what
/// continues the contact of slower sliding is found at every speed and degree. Degree 12 with 12 layers has these ends.
#[test]
fn a_hot_contact_is_the_one_that_continues_that_of_slower_sliding() {
    let known = [
        (7.0, 8, [71.4196, 95.1158], [0.003, 0.04]),
        (9.2, 8, [71.4398, 89.4555], [0.003, 0.04]),
        (12.0, 6, [71.5081, 85.6377], [0.01, 0.1]),
    ];
    for (speed, degree, [inner, outer], near) in known {
        let mesh = [format!("mesh.degree={degree}"), format!("mesh.layers={degree}")];
        let settings = ["tasks=[contact]", &mesh[0], &mesh[1], &format!("sliding.omega={speed}")];
        let solution = solved(&scene("clutch-hot", &settings));
        assert!(solution.status == Status::Ok && solution.remarks.is_empty(), "{speed}: {:?}", solution.remarks);
        let ends = solution.contact.unwrap().ends;
        assert!((ends[0] - inner).abs() < near[0] && (ends[1] - outer).abs() < near[1], "{speed}: {ends:?}");
    }
}

/// The slab touches all over up to 27 mm/s. Further on it jumps to a contact on one side, which nothing slower leads to.
#[test]
fn a_hot_contact_that_slower_sliding_does_not_lead_to_is_told_to_be_one_of_several() {
    let codes = |speed: &str| -> Vec<&'static str> {
        let solution = solved(&read(SLAB, &["mesh.degree=6", "mesh.layers=6", &format!("sliding.speed={speed}")]));
        assert_eq!(solution.status, Status::Ok, "{speed}: {:?}", solution.reason);
        solution.remarks.iter().map(|remark| remark.code).collect()
    };
    assert!(codes("29 mm/s").contains(&"several-solutions") && !codes("27 mm/s").contains(&"several-solutions"));
}

/// Two blocks whose top tilts freely touch when they are hot on one side of their surface, or on the other: pressure, ends and the
/// speed at which they are no longer unique are those of one contact. Degree 12 has the end at -1.58447 mm and the factor 1.469634.
#[test]
fn ends_and_critical_speed_of_a_hot_contact_are_those_of_its_pressure() {
    for (degree, near, of_factor) in [(6, 4e-3, 6e-4), (8, 6e-4, 1e-4)] {
        let mesh = [format!("mesh.degree={degree}"), format!("mesh.layers={degree}")];
        let solution = solved(&read(SLAB, &[&mesh[0], &mesh[1]]));
        assert_eq!(solution.status, Status::Ok, "{degree}: {:?}", solution.reason);
        let (contact, heat) = (solution.contact.unwrap(), solution.heat.unwrap());
        assert!(
            (contact.ends[0] + 1.58447).abs() < near && (contact.ends[1] - 10.0).abs() < 1e-9,
            "{degree}: {:?}",
            contact.ends
        );
        let profile = solution.profile.unwrap();
        let pressed = |i: &usize| profile.pressure[*i] > 0.0;
        let first = (0..profile.pressure.len()).find(pressed).unwrap();
        assert!((profile.position[first][0] - contact.ends[0]).abs() < 0.1, "{degree}: {:?}", profile.position[first]);
        let Some(SpeedFactor::At(factor)) = heat.critical_speed_factor else { panic!("{degree}: no factor") };
        assert!((factor / 1.469634 - 1.0).abs() < of_factor, "{degree}: {factor}");
    }
}

/// Heat that moves a body as a whole does not keep nodes from the ends of its contact: they stand on them from the first level on. (They stood on them from degree
/// 12 on, where the growth of the slab was taken for one of its points.) Degree 14 has these ends.
#[test]
fn a_body_that_grows_as_a_whole_has_nodes_on_the_ends_of_its_contact() {
    let solution = solved(&read(SLAB, &["contact.gap={crown='20 um'}", "sliding.speed=20 mm/s", "accuracy=1e-4"]));
    assert_eq!(solution.status, Status::Ok, "{:?}", solution.reason);
    let (ends, last) = (solution.contact.unwrap().ends, solution.ladder.last().unwrap().degree);
    assert!((ends[0] + 1.87129).abs() < 4e-4 && (ends[1] - 1.97582).abs() < 4e-4 && last <= 8, "{ends:?} {last}");
    assert!(!solution.error.unwrap().how.contains("settle"));
}

/// All heat into the lining: its contact opens at the outer end, then at the inner one, which goes inwards fast. Nothing conducts, and the standing mesh loses it.
#[test]
fn a_contact_that_is_lost_on_a_mesh_without_nodes_is_followed_from_slower_sliding() {
    let heat = "heat={share=1,reference=20,counterface='congruent'}";
    let solution = solved(&scene("clutch-hot", &["tasks=[contact]", "accuracy=1e-2", heat]));
    assert_eq!(solution.status, Status::Ok, "{:?}", solution.reason);
    let ends = solution.contact.unwrap().ends;
    assert!((ends[0] - 98.3139).abs() < 1e-3 && (ends[1] - 107.9855).abs() < 1e-3, "{ends:?}");
}

/// Soft bodies of which much heat leaves no contact. (The search's last pressures were reported, up to 4e5 MPa, with reactions to them.)
#[test]
fn a_contact_that_is_not_found_has_no_pressure_and_no_reactions() {
    let settings = [
        "tasks=[contact]",
        "contact.friction=1",
        "sliding.omega=10",
        "load.force=1e4",
        "body1.material={young=1e4,poisson=0.3,conductivity=20,expansion=1e-5}",
        "body2.material={young=1e5,poisson=0.27,conductivity=50,expansion=1.1e-5}",
        "heat={conductance=5,counterface='fresh',reference=20}",
        "body1.heat={top={temperature=20}}",
        "body2.heat={inner={temperature=20}}",
        "kinematics=plane-strain",
        "accuracy=1e-3",
    ];
    let solution = solved(&scene("drum-brake-block", &settings));
    assert_eq!(solution.status, Status::Refused);
    let profile = solution.profile.unwrap();
    assert!(
        !profile.pressure.is_empty() && profile.pressure.iter().all(|p| p.is_nan()) && profile.gap.iter().all(|gap| *gap == 0.0)
    );
    assert!(solution.reactions.is_empty() && solution.heat.is_none());
}
