//! The drawing of a scene: bodies, materials, supports, load and sliding.

use std::f64::consts::PI;

use scene::{Component, Kinematics, Load, LoadKind, Scene, Support};
use wearshape::{BodyOutline, Problem};

use crate::bare_drawing::bare_drawing;
use crate::drawing_words::{FILLS, LOADED, SLIDES, TOUCHES, legend};
use crate::edge_places::along;
use crate::heat_drawing::heated;
use crate::labels::shown_title;
use crate::schedule_words::turns_back;
use crate::sheet::Sheet;
use crate::support_drawing::{is_near, pin, roller};
use crate::support_label::SupportLabel;

/// Least distance of two arrows side by side (pixels).
const ROOM: f64 = 14.0;

/// The scene as SVG: what is where, before anything is computed. The same problem gives the same bytes.
pub fn drawing(problem: &Problem) -> String {
    let scene = problem.scene();
    let Some(bodies) = problem.outlines() else { return bare_drawing(problem) };
    let points = || bodies.iter().flat_map(|body| body.borders.iter().flatten().copied());
    // The sign of a turn about the axis reaches to its other side.
    let revolved = scene.kinematics == Some(Kinematics::Axisymmetric);
    let beyond = revolved
        .then(|| points().fold(0.0, |far: f64, p| far.max(p[0])))
        .map(|far| [-0.08 * far, points().next().map_or(0.0, |p| p[1])]);
    let pins = scene.body1.iter().flat_map(|body| body.support.values()).filter_map(|support| match support {
        Support::Pin(at) => Some(at.map(|x| x.0)),
        Support::Components(_) | Support::Roller(_) => None,
    });
    let near = pins.filter(|pin| is_near(*pin, points())).collect::<Vec<_>>();
    let mut sheet = Sheet::new(points().chain(beyond).chain(near.iter().copied()));
    for (number, body) in bodies.iter().enumerate().rev() {
        for (index, area) in body.areas.iter().enumerate() {
            let fill = FILLS[number][index % 4];
            // Cells of a mesh side by side, or the lines around a body and its holes.
            match area.loops.len() {
                1 | 2 => sheet.area(&area.loops, fill),
                _ => area.loops.iter().for_each(|line| sheet.area(std::slice::from_ref(line), fill)),
            }
        }
        body.borders.iter().for_each(|line| sheet.line(line, "#555", 1.0, ""));
    }
    if revolved {
        axis(&mut sheet, &bodies);
    }
    let edges = scene.contact.as_ref().and_then(|contact| contact.edges.as_ref());
    if let Some([first, _]) = edges {
        bodies[0].edge(first).iter().for_each(|line| sheet.line(line, TOUCHES, 4.0, ""));
    }
    let mut labels = Vec::new();
    for (body, outline) in [&scene.body1, &scene.body2].into_iter().zip(&bodies) {
        let held = body.iter().flat_map(|body| &body.support);
        held.for_each(|(edge, held)| match held {
            Support::Components(components) => labels.push(support(&mut sheet, outline, edge, components)),
            Support::Pin(at) => pin(&mut sheet, outline, edge, at.map(|x| x.0), !near.is_empty()),
            Support::Roller(angle) => {
                let lines = outline.edge(edge).to_vec();
                let out = along(&sheet, outline, &lines, 11.0).first().and_then(|(_, out)| *out).unwrap_or([0.0, -1.0]);
                roller(&mut sheet, &lines, out, angle.0);
            }
        });
    }
    if let Some(load) = &scene.load {
        loaded(&mut sheet, &bodies[0], load);
    }
    sliding(&mut sheet, scene, &bodies[1]);
    heated(&mut sheet, scene, &bodies);
    // Last, beside all that is drawn.
    labels.iter().for_each(|label| label.put(&mut sheet));
    sheet.picture(&shown_title(problem), &legend(problem))
}

/// The axis of revolution.
fn axis(sheet: &mut Sheet, bodies: &[BodyOutline; 2]) {
    let heights = || bodies.iter().flat_map(|body| body.borders.iter().flatten()).map(|p| p[1]);
    let (low, high) = (heights().fold(f64::MAX, f64::min), heights().fold(f64::MIN, f64::max));
    let beyond = 0.06 * (high - low);
    sheet.line(&[[0.0, low - beyond], [0.0, high + beyond]], "#777", 1.2, "14 4 3 4");
}

/// A held edge: hatched; returns the held directions, which are written where there is room for them.
fn support(sheet: &mut Sheet, body: &BodyOutline, edge: &str, held: &[Component]) -> SupportLabel {
    let lines = body.edge(edge).to_vec();
    lines.iter().for_each(|line| sheet.line(line, "#333", 2.0, ""));
    let places = along(sheet, body, &lines, 11.0);
    for (place, out) in &places {
        sheet.hatch(&[*place], out.unwrap_or([1.0, 0.0]));
    }
    let word = |component: &Component| match component {
        Component::X => "x",
        Component::Z => "z",
        Component::Phi => "\u{3c6}",
    };
    SupportLabel { text: held.iter().map(word).collect::<Vec<_>>().join(", "), places }
}

/// The load on its edge of body 1.
fn loaded(sheet: &mut Sheet, body: &BodyOutline, load: &Load) {
    let Some(edge) = &load.edge else { return };
    let lines = body.edge(edge).to_vec();
    let places = along(sheet, body, &lines, 8.0);
    let width = load.width.map(|width| {
        let centre = load.centre.map_or(0.0, |centre| centre.0);
        [sheet.at([centre - 0.5 * width.0, 0.0])[0], sheet.at([centre + 0.5 * width.0, 0.0])[0]]
    });
    let pressed: Vec<_> =
        places.into_iter().filter(|(p, _)| width.is_none_or(|[a, b]| p[0] >= a - 4.0 && p[0] <= b + 4.0)).collect();
    let (Some(first), Some(last)) = (pressed.first(), pressed.last()) else { return };
    match load.kind {
        Some(LoadKind::Rigid) => {
            lines.iter().for_each(|line| sheet.line(line, LOADED, 4.0, ""));
            let middle = load.about.map_or(0.5 * (first.0[0] + last.0[0]), |about| sheet.at(about.map(|x| x.0))[0]);
            let top = pressed.iter().map(|(p, _)| p[1]).fold(f64::MAX, f64::min);
            sheet.arrow([middle, top - 44.0], [middle, top - 4.0], LOADED);
            if let Some(side) = load.shear_force.filter(|force| force.0 != 0.0) {
                let step = 44.0 * side.0.signum();
                sheet.arrow([middle + 0.2 * step, top - 22.0], [middle + 1.2 * step, top - 22.0], LOADED);
            }
        }
        kind => {
            for (place, out) in spread(&pressed) {
                let out = match (kind, load.direction) {
                    (Some(LoadKind::Vertical), _) => [0.0, -1.0],
                    // Against the traction, with z downwards.
                    (Some(LoadKind::Traction), Some(angle)) => [-angle.0.cos(), angle.0.sin()],
                    _ => out.unwrap_or([0.0, -1.0]),
                };
                let [from, to] = [38.0, 3.0].map(|far| [place[0] + far * out[0], place[1] + far * out[1]]);
                sheet.arrow(from, to, LOADED);
            }
        }
    }
}

/// About seven of some places in a row, fewer where their arrows would touch.
fn spread<T: Copy>(places: &[([f64; 2], T)]) -> Vec<([f64; 2], T)> {
    let every = (places.len() / 7).max(1);
    let mut kept: Vec<([f64; 2], T)> = Vec::new();
    for (place, of) in places.iter().skip(every / 2).step_by(every) {
        let apart = |(last, _): &([f64; 2], T)| (place[0] - last[0]).hypot(place[1] - last[1]);
        if kept.last().is_none_or(|last| apart(last) >= ROOM) {
            kept.push((*place, *of));
        }
    }
    kept
}

/// How body 2 moves.
fn sliding(sheet: &mut Sheet, scene: &Scene, body: &BodyOutline) {
    let Some(sliding) = &scene.sliding else { return };
    let points = || body.borders.iter().flatten();
    let (low, high) = points().fold(([f64::MAX; 2], [f64::MIN; 2]), |(low, high), p| {
        ([low[0].min(p[0]), low[1].min(p[1])], [high[0].max(p[0]), high[1].max(p[1])])
    });
    let centre = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
    let both_ways = sliding.reversing.is_some() || sliding.cycle.is_some() || turns_back(scene);
    if sliding.speed.is_some() || sliding.cycle.is_some() {
        let [x, y] = sheet.at(centre);
        let half = 42.0 * sliding.speed.map_or(1.0, |speed| speed.0.signum());
        sheet.arrow([x - half, y], [x + half, y], SLIDES);
        if both_ways {
            sheet.arrow([x + half, y], [x - half, y], SLIDES);
        }
    } else if let Some(omega) = sliding.omega {
        let sense = omega.0.signum();
        if scene.kinematics == Some(Kinematics::Axisymmetric) {
            // The axis is upright in the picture: an ellipse around it, its near side drawn.
            let [x, y] = sheet.at([0.0, low[1]]);
            let [from, to] = [-26.0 * sense, 26.0 * sense];
            sheet.sign(&format!(
                "<path d=\"M{:.1} {:.1}A26 8 0 0 {} {:.1} {:.1}\" fill=\"none\" stroke=\"{SLIDES}\" stroke-width=\"2.2\"/>\n",
                x + from,
                y + 14.0,
                if sense > 0.0 { 0 } else { 1 },
                x + to,
                y + 14.0
            ));
            sheet.arrow([x + 0.8 * to, y + 20.0], [x + to, y + 12.0], SLIDES);
            if both_ways {
                sheet.arrow([x + 0.8 * from, y + 20.0], [x + from, y + 12.0], SLIDES);
            }
            return;
        }
        let inner = points().map(|p| (p[0] - centre[0]).hypot(p[1] - centre[1])).fold(f64::MAX, f64::min);
        let outer = 0.5 * (high[0] - low[0]);
        let radius = if inner < 0.9 * outer { 0.5 * (inner + outer) } else { 0.5 * outer };
        let senses: &[f64] = if both_ways { &[sense, -sense] } else { &[sense] };
        senses.iter().for_each(|sense| sheet.turning(centre, radius, sense * 0.6 * PI, SLIDES));
    }
}

#[cfg(test)]
mod tests {
    use super::{ROOM, spread};

    #[test]
    fn arrows_on_a_narrow_edge_stand_apart() {
        let places = |step: f64| (0..40).map(|k| ([f64::from(k) * step, 0.0], ())).collect::<Vec<_>>();
        let narrow = spread(&places(0.5));
        assert!(narrow.len() == 2 && narrow[1].0[0] - narrow[0].0[0] >= ROOM, "{narrow:?}");
        assert_eq!(spread(&places(8.0)).len(), 8);
        assert!(spread::<()>(&[]).is_empty());
    }
}
