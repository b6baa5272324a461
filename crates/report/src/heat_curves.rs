//! The curves of heat along the contact: temperatures, heat into both bodies, and the parts of the gap.

use wearshape::{Profile, Solution};

use crate::line_plot::Series;

/// What a plot shows: its file, its title, the label of its axis, its curves by name, dashed or not.
pub(crate) struct HeatCurves {
    pub(crate) file: &'static str,
    pub(crate) what: &'static str,
    pub(crate) label: &'static str,
    pub(crate) series: Vec<Series>,
}

/// The points that know their temperatures: evenly spaced ones if they do, or those of the contact; none without heat.
pub(crate) fn warm<'a>(solution: &'a Solution, points: &'a Profile) -> Option<&'a Profile> {
    solution.curve.iter().chain(std::iter::once(points)).find(|profile| !profile.temperature[0].is_empty())
}

/// The plots of heat on such points.
pub(crate) fn heat_curves(
    solution: &Solution,
    profile: &Profile,
    series: &dyn Fn(&str, &[f64], bool) -> Series,
) -> Vec<HeatCurves> {
    let both = |pair: &[Vec<f64>; 2], names: [&str; 2]| -> Vec<Series> {
        let known = pair.iter().zip(names).filter(|(values, _)| values.iter().any(|value| value.is_finite()));
        known.map(|(values, name)| series(name, values, false)).collect()
    };
    let temperatures = both(&profile.temperature, ["body 1", "body 2"]);
    let heat = both(&profile.heat, ["into body 1", "into body 2"]);
    let mut found = vec![
        HeatCurves { file: "temperature", what: "temperature", label: "temperature (\u{b0}C)", series: temperatures },
        HeatCurves { file: "heat", what: "heat of friction", label: "heat (mW/mm\u{b2})", series: heat },
    ];
    let jump = |[first, second]: &[Vec<f64>; 2]| -> Vec<f64> { first.iter().zip(second).map(|(u1, u2)| u2 - u1).collect() };
    let thermal = jump(&profile.thermal_displacement);
    if solution.shape.is_some() {
        let elastic: Vec<f64> = jump(&profile.normal_displacement).iter().zip(&thermal).map(|(both, hot)| both - hot).collect();
        let parts = [("both", &profile.gap, false), ("thermal", &thermal, false), ("elastic", &elastic, true)];
        let curves = parts.map(|(name, part, dashed)| series(name, &lowered(profile, part), dashed)).to_vec();
        let what = "parts of the shape, each with body 1 let down on body 2";
        found.push(HeatCurves { file: "heat-gap", what, label: "gap (\u{b5}m)", series: curves });
    } else if thermal.iter().any(|value| value.is_finite()) {
        let curves = vec![series("", &lowered(profile, &thermal), false)];
        let what = "thermal part of the gap, body 1 let down on body 2";
        found.push(HeatCurves { file: "heat-gap", what, label: "gap (\u{b5}m)", series: curves });
    }
    found.retain(|plot| !plot.series.is_empty());
    found
}

/// A gap with body 1 let down along z until it touches: `g + c n_z`, c the least that keeps it open.
fn lowered(profile: &Profile, gap: &[f64]) -> Vec<f64> {
    let vertical = || profile.normal.iter().map(|normal| normal[2]);
    let down = gap.iter().zip(vertical()).map(|(gap, n)| -gap / n).fold(f64::NEG_INFINITY, f64::max);
    gap.iter().zip(vertical()).map(|(gap, n)| gap + down * n).collect()
}
