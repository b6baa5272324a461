//! The drawing of a scene that gives a contact surface alone.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use scene::SurfaceShape;
use wearshape::Problem;

use crate::drawing_words::{FILLS, LOADED, SLIDES, TOUCHES, legend};
use crate::labels::shown_title;
use crate::sheet::{Sheet, into_sheet};

/// Closed line around the origin; angles from the x axis.
fn ring(radius: f64, from: f64, to: f64) -> Vec<[f64; 2]> {
    (0..=96).map(|k| from + (to - from) * f64::from(k) / 96.0).map(|t| [radius * t.cos(), radius * t.sin()]).collect()
}

/// The contact surface, what it slides on, and how.
pub(crate) fn bare_drawing(problem: &Problem) -> String {
    let scene = problem.scene();
    let omega = scene.sliding.as_ref().and_then(|sliding| sliding.omega).map_or(0.0, |omega| omega.0.signum());
    let sheet = match &scene.surface {
        Some(SurfaceShape::DiscPad(pad)) => {
            let (inner, outer, half) = (pad.inner.0, pad.outer.0, pad.half_angle.0);
            let mut far = ring(inner, half, -half);
            let mut surface = ring(outer, -half, half);
            surface.append(&mut far);
            let mut sheet = on(&[ring(1.12 * outer, 0.0, TAU)], &surface);
            sheet.turning([0.0; 2], 0.6 * inner, 0.7 * PI * omega, SLIDES);
            pressed(&mut sheet, [0.5 * (inner + outer), 0.0]);
            sheet
        }
        Some(SurfaceShape::RectangularPunch(punch)) => {
            let ([a, b], [c, d]) = (punch.x.map(|x| x.0), punch.y.map(|y| y.0));
            flat(problem, [a, b, c, d], &[[a, c], [b, c], [b, d], [a, d]])
        }
        Some(SurfaceShape::EllipticPunch(punch)) => {
            let [a, b] = punch.half_axes.map(|x| x.0);
            let around: Vec<[f64; 2]> = ring(1.0, 0.0, TAU).into_iter().map(|[x, y]| [a * x, b * y]).collect();
            flat(problem, [-a, a, -b, b], &around)
        }
        // Angles of shoes and shells are measured from the z axis towards +x.
        Some(SurfaceShape::PinnedShoe(shoe)) => {
            let arc = ring(shoe.radius.0, FRAC_PI_2 - shoe.from.0, FRAC_PI_2 - shoe.to.0);
            let pin = [0.0, shoe.pin_distance.0];
            let mut sheet = round(Round { radius: shoe.radius.0, wall: WALL * shoe.radius.0, beyond: pin }, &arc, omega);
            dot(&mut sheet, pin, "pin");
            // The actuator pushes at its arm from the pin, on the side of the lining, towards the drum.
            let side = (0.5 * (shoe.from.0 + shoe.to.0)).sin().signum();
            let [x, y] = sheet.at([0.0, shoe.pin_distance.0 - shoe.arm.0]);
            sheet.arrow([x - 22.0 * side, y], [x + 22.0 * side, y], LOADED);
            sheet
        }
        Some(SurfaceShape::PivotedShoe(shoe)) => {
            let arc = ring(shoe.radius.0, FRAC_PI_2 + shoe.half_angle.0, FRAC_PI_2 - shoe.half_angle.0);
            let pivot = [0.0, shoe.pivot.map_or(0.0, |pivot| pivot.0)];
            let mut sheet = round(Round { radius: shoe.radius.0, wall: 0.0, beyond: pivot }, &arc, omega);
            dot(&mut sheet, pivot, "pivot");
            // The load acts on the pivot, towards the drum.
            let [x, y] = sheet.at(pivot);
            sheet.arrow([x, y - 44.0], [x, y - 9.0], LOADED);
            sheet
        }
        Some(SurfaceShape::JournalArc(shell)) => {
            let arc = ring(shell.radius.0, FRAC_PI_2 + shell.half_angle.0, FRAC_PI_2 - shell.half_angle.0);
            let mut sheet = round(Round { radius: shell.radius.0, wall: 0.0, beyond: [0.0; 2] }, &arc, omega);
            let [x, y] = sheet.at([0.0, shell.radius.0]);
            sheet.arrow([x, y - 44.0], [x, y - 6.0], LOADED);
            sheet
        }
        None => Sheet::new([[0.0; 2], [1.0; 2]].into_iter()),
    };
    sheet.picture(&shown_title(problem), &legend(problem))
}

/// A surface in plan view on what lies under it.
fn on(under: &[Vec<[f64; 2]>], surface: &[[f64; 2]]) -> Sheet {
    let mut sheet = Sheet::new(under.iter().flatten().copied());
    sheet.area(under, FILLS[1][0]);
    sheet.area(&[surface.to_vec()], FILLS[0][0]);
    let closed: Vec<[f64; 2]> = surface.iter().chain(surface.first()).copied().collect();
    sheet.line(&closed, TOUCHES, 2.0, "");
    sheet
}

/// A flat punch in plan view with the direction of sliding.
fn flat(problem: &Problem, [a, b, c, d]: [f64; 4], surface: &[[f64; 2]]) -> Sheet {
    let (wide, high) = (0.3 * (b - a), 0.2 * (d - c));
    let plate = vec![[a - wide, c - high], [b + wide, c - high], [b + wide, d + high], [a - wide, d + high]];
    let mut sheet = on(&[plate], surface);
    let speed = problem.scene().sliding.as_ref().and_then(|sliding| sliding.speed).map_or(0.0, |speed| speed.0.signum());
    let [x, y] = sheet.at([0.5 * (a + b), c - 0.5 * high]);
    if speed != 0.0 {
        sheet.arrow([x - 42.0 * speed, y], [x + 42.0 * speed, y], SLIDES);
    }
    pressed(&mut sheet, [0.5 * (a + b), 0.5 * (c + d)]);
    for (place, name) in [([b + 0.8 * wide, 0.5 * (c + d)], "x"), ([0.5 * (a + b), d + 0.6 * high], "y")] {
        let [x, y] = sheet.at(place);
        sheet.sign(&format!(
            "<text class=\"on\" x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\" font-style=\"italic\">{name}</text>\n",
            y + 5.0
        ));
    }
    sheet
}

/// A load that presses into the sheet: the feathers of its arrow.
fn pressed(sheet: &mut Sheet, place: [f64; 2]) {
    let [x, y] = sheet.at(place);
    sheet.sign(&into_sheet([x, y], 9.0, LOADED));
}

/// Thickness of a drum that is drawn around its shoe, over its radius: it has none in the scene.
const WALL: f64 = 0.1;

/// A drum or a shaft.
struct Round {
    /// Radius of the surface that slides.
    radius: f64,
    /// Thickness of what lies around that surface; 0 where it is the outside of a disc.
    wall: f64,
    /// A place that the sheet shows as well.
    beyond: [f64; 2],
}

/// A drum or a shaft with an arc of contact on it.
fn round(Round { radius, wall, beyond }: Round, arc: &[[f64; 2]], sense: f64) -> Sheet {
    let mut lines = vec![ring(radius, 0.0, TAU)];
    if wall > 0.0 {
        lines.push(ring(radius + wall, 0.0, TAU));
    }
    let mut sheet = Sheet::new(lines.iter().flatten().copied().chain([beyond]));
    sheet.area(&lines, FILLS[1][0]);
    lines.iter().for_each(|line| sheet.line(line, "#555", 1.2, ""));
    sheet.line(arc, TOUCHES, 7.0, "");
    sheet.turning([0.0; 2], 0.55 * radius, 0.7 * PI * sense, SLIDES);
    sheet
}

/// A named point about which body 1 turns.
fn dot(sheet: &mut Sheet, place: [f64; 2], name: &str) {
    let [x, y] = sheet.at(place);
    sheet.sign(&format!(
        "<circle class=\"ink\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"5\" fill=\"#333\" stroke=\"#fff\"/>\n<text x=\"{:.1}\" y=\"{:.1}\">{name}</text>\n",
        x + 10.0,
        y + 5.0
    ));
}
