//! A geometry that is no body, or that cannot be touched or meshed, is refused at the key that is to blame.

use meshing::{Cut, HalfDiscOnFlat, contact_line, meshes, outside, read_cells, sound};
use scene::{Document, Fault, LoadKind};

use crate::common::{DISC, DRUM, PLATE, PUNCH, SHOE, SHOE_CELLS, UNDER_DISC, body, couple, extent, two_cells};

/// Key and code of a fault.
fn blamed<T>(found: Result<T, Fault>) -> (String, &'static str) {
    let fault = found.err().unwrap();
    assert!(!fault.message.is_empty() && !fault.remedy.is_empty());
    (fault.key.unwrap(), fault.code)
}

/// What is wrong with a geometry of body 1, as it is written.
fn written(geometry: &str, axisymmetric: bool) -> Result<(), Fault> {
    let text = format!("units = 'N-mm'\n[body1]\n[body1.geometry]\n{geometry}\n");
    let mut body = Document::read("body.toml", &text, &[])?.scene.body1.unwrap();
    sound("body1", &mut body.geometry, axisymmetric)?;
    read_cells("body1", &mut body, &|_| Err("there is no such file".to_string())).map(|_| ())
}

#[test]
fn numbers_of_templates() {
    for (geometry, key, code) in [
        ("shoe-block = { radius = 0, half_angle = 0.5, top = 300 }", "shoe-block.radius", "wrong-value"),
        ("shoe-block = { radius = 200, half_angle = '90 deg', top = 300 }", "shoe-block.half_angle", "degenerate"),
        ("shoe-block = { radius = 200, half_angle = 0.5, top = 200 }", "shoe-block.top", "degenerate"),
        ("ring = { inner = -1, outer = 2 }", "ring.inner", "wrong-value"),
        ("ring = { inner = 2, outer = 2 }", "ring.outer", "degenerate"),
        ("ring-segment = { inner = 20, outer = 10, x = [-5, 5] }", "ring-segment.outer", "degenerate"),
        ("ring-segment = { inner = 20, outer = 30, x = [5, 5] }", "ring-segment.x", "degenerate"),
        ("ring-segment = { inner = 20, outer = 30, x = [-5, 20] }", "ring-segment.x", "degenerate"),
        ("rectangle = { x = [1, 0], z = [0, 1] }", "rectangle.x", "degenerate"),
        ("rectangle = { x = [0, 1], z = [1, 1] }", "rectangle.z", "degenerate"),
        ("half-disc = { radius = 0, centre = [0, 0] }", "half-disc.radius", "wrong-value"),
        (
            "mesh = { file = 'a.msh', materials.steel = { young = 0, poisson = 0.3 } }",
            "mesh.materials.steel.young",
            "wrong-value",
        ),
        (
            "mesh = { file = 'a.msh', materials.steel = { young = 1, poisson = 0.5 } }",
            "mesh.materials.steel.poisson",
            "wrong-value",
        ),
        ("mesh.file = 'a.msh'", "mesh.file", "unreadable"),
    ] {
        assert_eq!(blamed(written(geometry, false)), (format!("body1.geometry.{key}"), code), "{geometry}");
    }
    for good in [SHOE, DRUM, PUNCH, DISC] {
        assert_eq!(written(good, false), Ok(()), "{good}");
    }
}

#[test]
fn numbers_of_axisymmetric_templates() {
    for (geometry, key, code) in [
        (SHOE, "shoe-block", "wrong-value"),
        (DRUM, "ring", "wrong-value"),
        (PUNCH, "rectangle.x", "degenerate"),
        (DISC, "half-disc.centre", "degenerate"),
    ] {
        assert_eq!(blamed(written(geometry, true)), (format!("body1.geometry.{key}"), code), "{geometry}");
    }
}

#[test]
fn blocks_at_the_name_that_is_wrong() {
    let good = two_cells([-3.0, 1.0, 3.0], [0.0, 5.0]);
    for (from, to, key, code) in [
        ("curves.be.line = ['b', 'e']", "curves.be.line = ['b', 'g']", "curves.be.line", "unknown-point"),
        ("curves.be.line = ['b', 'e']", "curves.be.line = ['b', 'b']", "curves.be.line", "degenerate"),
        ("['bc', 'cd', 'ed', 'be']", "['bc', 'cd', 'de', 'be']", "cells.two.curves", "unknown-curve"),
        ("['bc', 'cd', 'ed', 'be']", "['bc', 'ed', 'cd', 'be']", "cells.two.curves", "open-cell"),
        ("['bc', 'cd', 'ed', 'be']", "['ab', 'be', 'fe', 'af']", "cells.two", "duplicate-cell"),
        ("left = ['af']", "left = []", "edges.left", "wrong-value"),
        ("left = ['af']", "'@contact' = ['af']", "edges.@contact", "wrong-value"),
        ("a = [-3, 0]", "a = [0, 4.5]", "cells.one", "folded-cell"),
        ("a = [-3, 0]", "a = [1, 5]", "points.e", "duplicate-point"),
    ] {
        let bad = good.replace(from, to);
        assert_ne!(bad, good, "{from}");
        assert_eq!(blamed(written(&bad, false)), (format!("body1.geometry.blocks.{key}"), code), "{to}");
    }
    assert_eq!(written(&good, false), Ok(()));
}

#[test]
fn edges_that_cannot_touch() {
    let line = |key, geometry: &str, edge: &str, shaped| blamed(contact_line(&body(key, geometry, edge, ""), shaped));
    // A ring may be either body.
    assert!(contact_line(&body("body1", DRUM, "outer", ""), true).is_ok());
    for (geometry, edge) in [(SHOE, "top"), (PUNCH, "top"), (DISC, "top")] {
        assert_eq!(line("body1", geometry, edge, true), ("contact.edges.0".to_string(), "not-available"), "{geometry}");
    }
    for (geometry, edge) in [(SHOE, "inner"), (PLATE, "bottom"), (DISC, "arc")] {
        assert_eq!(line("body2", geometry, edge, false), ("contact.edges.1".to_string(), "not-available"), "{geometry}");
    }
    let cells = two_cells([-3.0, 1.0, 3.0], [0.0, 5.0]);
    assert!(contact_line(&body("body1", &cells, "bottom", ""), true).is_ok());
    // Body 1 would lie below its contact edge, or beside it.
    for edge in ["top", "left"] {
        assert_eq!(line("body1", &cells, edge, true), ("contact.edges.0".to_string(), "not-available"), "{edge}");
    }
}

#[test]
fn edges_inside_a_body() {
    let shoe = body("body1", SHOE_CELLS, "inner", "");
    assert_eq!(blamed(outside(&shoe, "bond")), ("body1.geometry.blocks.edges.bond".to_string(), "not-on-boundary"));
    assert_eq!(outside(&shoe, "inner"), Ok(()));
}

#[test]
fn couples_that_cannot_be_meshed() {
    let drum = || body("body2", DRUM, "outer", "inner = ['x', 'z']");
    // The plane top cuts off the crown of the arc.
    let mut thin = couple(body("body1", SHOE, "inner", "left = ['x']"), drum(), "top", LoadKind::Pressure);
    let extent = extent(&thin);
    let scene::Geometry::ShoeBlock(shoe) = &mut thin.bodies[0].geometry else { unreachable!() };
    shoe.top = scene::Length(190.0);
    assert_eq!(blamed(meshes(&thin, extent, 1, Cut::Plain)), ("body1.geometry".to_string(), "degenerate"));
}

#[test]
fn half_discs_that_cannot_be_pressed() {
    let on = |disc: &str, plate: &str, held: [&str; 2]| {
        let bodies = [body("body1", disc, "arc", held[0]), body("body2", plate, "top", held[1])];
        let [first, second] = bodies;
        HalfDiscOnFlat::of(&couple(first, second, "top", LoadKind::Pressure)).map(|found| found.is_some())
    };
    let below = "bottom = ['x', 'z']";
    assert_eq!(on(DISC, UNDER_DISC, ["centre = ['x']", below]), Ok(true));
    assert_eq!(on(SHOE, UNDER_DISC, ["left = ['x']", below]), Ok(false));
    for (plate, held, key, code) in [
        (PLATE, ["centre = ['x']", below], "body2.geometry.rectangle.x", "not-available"),
        (UNDER_DISC, ["centre = ['x']", "left = ['x', 'z']"], "body2.support", "not-available"),
        (UNDER_DISC, ["top = ['z']", below], "body1.support", "held"),
    ] {
        assert_eq!(blamed(on(DISC, plate, held)), (key.to_string(), code), "{plate} {held:?}");
    }
}
