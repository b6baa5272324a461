//! Heat in the drawing of a scene: held, cooled and heated edges, and how the bodies share the heat of friction.

use scene::{Body, Counterface, EdgeHeat, Heat, Scene};
use wearshape::BodyOutline;

use crate::brief::brief;
use crate::edge_places::along;
use crate::sheet::{Mark, Sheet};

/// Colour of heat.
const HEATS: &str = "#b8860b";
/// Distance of the signs along an edge, and from the contact on an edge that has it (pixels).
const EVERY: f64 = 34.0;
const CLEAR: f64 = 10.0;

/// The edges that are held at a temperature, cooled or heated.
pub(crate) fn heated(sheet: &mut Sheet, scene: &Scene, bodies: &[BodyOutline; 2]) {
    let contact = scene.contact.as_ref().and_then(|contact| contact.edges.as_ref());
    let touching: Vec<[f64; 2]> = contact
        .map(|[first, _]| along(sheet, &bodies[0], bodies[0].edge(first), 2.0).into_iter().map(|(place, _)| place).collect())
        .unwrap_or_default();
    for (body, outline) in [&scene.body1, &scene.body2].into_iter().zip(bodies) {
        for (edge, heat) in body.iter().flat_map(|body| &body.heat) {
            let lines = outline.edge(edge).to_vec();
            if heat.temperature.is_some() {
                lines.iter().for_each(|line| sheet.line(line, HEATS, 3.2, "7 4"));
            }
            let apart = |a: [f64; 2], b: [f64; 2], least: f64| (a[0] - b[0]).hypot(a[1] - b[1]) > least;
            let mut signs: Vec<[f64; 2]> = Vec::new();
            for (place, out) in along(sheet, outline, &lines, EVERY) {
                // A curved edge is many short lines, each with a place.
                if touching.iter().all(|t| apart(place, *t, CLEAR)) && signs.iter().all(|sign| apart(place, *sign, 0.9 * EVERY)) {
                    carried(sheet, heat, place, out.unwrap_or([0.0, -1.0]));
                    signs.push(place);
                }
            }
        }
    }
}

/// A wave out of the body with an arrow head, or an arrow into it (out of it for a flux that cools).
fn carried(sheet: &mut Sheet, heat: &EdgeHeat, [x, y]: [f64; 2], out: [f64; 2]) {
    let along = [-out[1], out[0]];
    let at = |far: f64, off: f64| [x + far * out[0] + off * along[0], y + far * out[1] + off * along[1]];
    if heat.convection.is_some() {
        let points: Vec<String> = (0..=16)
            .map(|k| at(3.0 + f64::from(k), 3.0 * (f64::from(k) * std::f64::consts::FRAC_PI_4).sin()))
            .map(|[x, y]| format!("{x:.1} {y:.1}"))
            .collect();
        let path = points.join("L");
        sheet.sign(&format!("<path d=\"M{path}\" fill=\"none\" stroke=\"{HEATS}\" stroke-width=\"1.6\"/>\n"));
        sheet.take(at(3.0, 0.0), at(19.0, 0.0));
        sheet.arrow(at(19.0, 0.0), at(27.0, 0.0), HEATS);
    }
    match heat.flux.map(|flux| flux.0) {
        Some(flux) if flux > 0.0 => sheet.arrow(at(27.0, 0.0), at(3.0, 0.0), HEATS),
        Some(flux) if flux < 0.0 => sheet.arrow(at(3.0, 0.0), at(27.0, 0.0), HEATS),
        Some(_) | None => {}
    }
}

/// The lines of the legend on heat; none of a scene without it.
pub(crate) fn heat_legend(scene: &Scene) -> Vec<(Mark, String)> {
    let Some(heat) = &scene.heat else { return Vec::new() };
    let mut rows = vec![(Mark::None, shared(heat))];
    for (name, body) in [("body 1", &scene.body1), ("body 2", &scene.body2)] {
        rows.extend(body.iter().flat_map(edges).map(|(mark, text)| (mark, format!("{name}, {text}"))));
    }
    rows
}

/// How the bodies share the heat, and how body 2 meets it.
fn shared(heat: &Heat) -> String {
    let split = match (heat.share, heat.conductance) {
        (Some(share), _) => format!("heat of friction: {} % into body 1", brief(100.0 * share)),
        (None, Some(conductance)) if conductance.0.is_infinite() => "heat of friction: both surfaces have one temperature".into(),
        (None, Some(conductance)) => {
            format!("heat of friction crosses by {} W/(m\u{b2} K)", brief(1e3 * conductance.0))
        }
        (None, None) => "heat of friction".into(),
    };
    let meets = match heat.counterface {
        Some(Counterface::Revolving) => ", body 2 evenly warm around its axis",
        Some(Counterface::Fresh) => ", body 2 always arrives cold",
        Some(Counterface::Congruent) | None => "",
    };
    let reference = heat.reference.map(|reference| format!("; cold shape at {} \u{b0}C", brief(reference.0))).unwrap_or_default();
    format!("{split}{meets}{reference}")
}

/// What carries heat through the edges of a body.
fn edges(body: &Body) -> Vec<(Mark, String)> {
    let words = |(edge, heat): (&String, &EdgeHeat)| {
        let held = heat.temperature.map(|held| (Mark::Line(HEATS), format!("{edge}: held at {} \u{b0}C", brief(held.0))));
        let film = heat.convection.map(|film| {
            let to = heat.ambient.map(|to| format!(" to {} \u{b0}C", brief(to.0))).unwrap_or_default();
            (Mark::Arrow(HEATS), format!("{edge}: convection {} W/(m\u{b2} K){to}", brief(1e3 * film.0)))
        });
        let flux = heat.flux.map(|flux| (Mark::Arrow(HEATS), format!("{edge}: heated by {} mW/mm\u{b2}", brief(flux.0))));
        [held, film, flux].into_iter().flatten()
    };
    body.heat.iter().flat_map(words).collect()
}
