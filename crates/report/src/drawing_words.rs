//! The words below the drawing of a scene.

use scene::{Axes, Kinematics, Load, LoadKind, Material, Pressure, Scene, Support, SurfaceShape};
use wearshape::Problem;

use crate::brief::brief;
use crate::heat_drawing::heat_legend;
use crate::schedule_words::by_schedule;
use crate::sheet::Mark;

/// Fills of body 1 and of body 2, one material after the other.
pub(crate) const FILLS: [[&str; 4]; 2] =
    [["#cfe3f3", "#86b6dc", "#e3eef8", "#5b93c4"], ["#e4e4e4", "#c2c2c2", "#f2f2f2", "#a8a8a8"]];

/// Colour of the contact, of the load and of the sliding.
pub(crate) const TOUCHES: &str = "#d55e00";
pub(crate) const LOADED: &str = "#a3267c";
pub(crate) const SLIDES: &str = "#00795a";

/// The lines of the legend.
pub(crate) fn legend(problem: &Problem) -> Vec<(Mark, String)> {
    let scene = problem.scene();
    let mut rows = Vec::new();
    for (number, body) in problem.outlines().into_iter().flatten().enumerate() {
        for (index, area) in body.areas.iter().enumerate() {
            let text = format!(
                "body {}{}: {}",
                number + 1,
                if number == 0 { ", shaped" } else { ", counter-face" },
                elastic(&area.material)
            );
            rows.push((Mark::Fill(FILLS[number][index % 4]), text));
        }
    }
    let friction = scene.contact.as_ref().and_then(|contact| contact.friction).unwrap_or(0.0);
    let plan = matches!(
        scene.surface,
        Some(SurfaceShape::DiscPad(_) | SurfaceShape::RectangularPunch(_) | SurfaceShape::EllipticPunch(_))
    );
    let surface = if scene.surface.is_some() { "contact surface of body 1" } else { "contact" };
    let mark = if plan { Mark::Fill(FILLS[0][0]) } else { Mark::Line(TOUCHES) };
    rows.push((mark, format!("{surface}, friction {}", brief(friction))));
    let supports = || [&scene.body1, &scene.body2].into_iter().flatten().flat_map(|body| &body.support);
    let held = supports().any(|(_, support)| matches!(support, Support::Components(_)));
    if held {
        rows.push((Mark::Hatch, "held in the directions written beside it".into()));
    }
    rows.extend(supports().filter_map(guided_words).map(|text| (Mark::None, text)));
    let arrow = if plan { Mark::Into(LOADED) } else { Mark::Arrow(LOADED) };
    rows.extend(scene.load.as_ref().map(|load| (arrow, load_words(scene, load))));
    rows.extend(sliding_words(scene).map(|text| (Mark::Arrow(SLIDES), text)));
    rows.extend(heat_legend(scene));
    rows.extend(plane_words(scene).map(|text| (Mark::None, text)));
    rows
}

/// What a pin or a roller leaves an edge.
fn guided_words((edge, support): (&String, &Support)) -> Option<String> {
    match support {
        Support::Components(_) => None,
        Support::Pin(at) => {
            let [x, z] = at.map(|x| brief(x.0));
            Some(format!("{edge} turns about the pin at ({x}, {z})"))
        }
        Support::Roller(angle) => Some(format!("{edge} runs on a roller at {}\u{b0}", brief(angle.0.to_degrees()))),
    }
}

fn elastic(material: &Material) -> String {
    let list = |values: &[f64]| values.iter().map(|value| brief(*value)).collect::<Vec<_>>().join(", ");
    let along = |moduli: [Pressure; 3]| list(&moduli.map(|modulus| 1e-3 * modulus.0));
    match (material.young, material.poisson) {
        (Axes::One(young), Axes::One(poisson)) => format!("E = {} GPa, \u{3bd} = {poisson}", brief(1e-3 * young.0)),
        (young, poisson) => {
            let shear = material.shear.map_or(String::new(), |shear| match shear {
                Axes::One(shear) => format!(", G = {} GPa", brief(1e-3 * shear.0)),
                Axes::Three(shear) => format!(", G = {} GPa", along(shear)),
            });
            let angle = material.angle.map_or(0.0, |angle| angle.0.to_degrees());
            let turned = if angle == 0.0 { String::new() } else { format!(", axis 1 at {}\u{b0}", brief(angle)) };
            format!("E = {} GPa, \u{3bd} = {}{shear}{turned}", along(young.each()), list(&poisson.each()))
        }
    }
}

/// What presses, turns and shifts body 1.
fn load_words(scene: &Scene, load: &Load) -> String {
    let mut words = Vec::new();
    let by_schedule = |factors| by_schedule(scene, factors);
    words.extend(load.force.map(|force| format!("{} N{}", brief(force.0), by_schedule(|schedule| schedule.force.as_ref()))));
    words.extend(load.approach.map(|approach| format!("pressed in by {} mm", brief(approach.0))));
    let edge = load.edge.as_deref().unwrap_or("");
    words.extend(load.kind.map(|kind| match kind {
        LoadKind::Pressure => format!("as a pressure on {edge}"),
        LoadKind::Vertical => format!("vertically on {edge}"),
        LoadKind::Rigid => format!("on {edge}, which moves without bending"),
        LoadKind::Traction => {
            let direction = load.direction.map_or(0.0, |angle| angle.0.to_degrees());
            format!("as a traction at {}\u{b0} on {edge}", brief(direction))
        }
    }));
    words.extend(load.tilt.map(|tilt| match tilt.0 {
        0.0 => "kept from turning".into(),
        tilt => format!("turned by {} rad", brief(tilt)),
    }));
    let named = |name: &str, value: Option<f64>, unit: &str| {
        value.filter(|value| *value != 0.0).map(|value| format!("{name} {} {unit}", brief(value)))
    };
    let moment = named("moment", load.moment.map(|m| m.0), "N mm");
    words.extend(moment.map(|moment| moment + &by_schedule(|schedule| schedule.moment.as_ref())));
    words.extend(named("moment about x", load.moment_y.map(|m| m.0), "N mm"));
    words.extend(named("then sideways", load.shear_force.map(|f| f.0), "N"));
    if load.twist.is_some() || load.torque.is_some() {
        words.push("then turned about the axis".into());
    }
    format!("load: {}", words.join(", "))
}

fn sliding_words(scene: &Scene) -> Option<String> {
    let sliding = scene.sliding.as_ref()?;
    let by_speed = sliding.speed.map(|speed| format!("body 2 slides at {} mm/s", brief(speed.0.abs())));
    let sense = |omega: f64| if omega > 0.0 { "anti-clockwise" } else { "clockwise" };
    let turning = sliding.omega.map(|omega| format!("body 2 turns {} at {} rad/s", sense(omega.0), brief(omega.0.abs())));
    let cycle = sliding.cycle.as_ref().and_then(|cycle| Some((cycle.stroke?.0, cycle.frequency?.0)));
    let to_and_fro = cycle.map(|(stroke, frequency)| {
        let speed = 2.0 * stroke * frequency;
        format!("body 2 slides {} mm to and fro at {} Hz, {} mm/s in the mean", brief(stroke), brief(frequency), brief(speed))
    });
    let words = to_and_fro.or(by_speed).or(turning)? + &by_schedule(scene, |schedule| schedule.speed.as_ref());
    Some(match (&sliding.reversing, &sliding.cycle) {
        (Some(reversing), None) => format!("{words}, and back, {} of the time forward", brief(reversing.share.unwrap_or(0.5))),
        _ => words,
    })
}

fn plane_words(scene: &Scene) -> Option<String> {
    let thick = scene.thickness.map(|thickness| format!(", {} mm thick", brief(thickness.0))).unwrap_or_default();
    Some(match scene.kinematics? {
        Kinematics::PlaneStress => format!("plane stress{thick}: thin, free to widen"),
        Kinematics::PlaneStrain => format!("plane strain{thick}: long, kept from widening"),
        Kinematics::Axisymmetric => "a section through bodies of revolution".into(),
    })
}
