//! The plots of a run: pressure, wear rate, gap, error.

use serde_json::{Value, json};
use wearshape::{Problem, Profile, Rung, Shape, Solution};

use crate::line_plot::{Axis, LinePlot, Series};

/// The plots with the names of their files.
pub(crate) fn line_plots(problem: &Problem, solution: &Solution) -> Vec<(&'static str, LinePlot)> {
    let title = problem.title();
    let Some(points) = &solution.profile else {
        return Vec::new();
    };
    // Evenly spaced points draw smoother than the contact points.
    let profile = solution.curve.as_ref().unwrap_or(points);
    let (places, x_label) = abscissa(problem, profile);
    let series = |name: &str, values: &[f64], dashed: bool| Series {
        name: name.to_string(),
        points: places.iter().copied().zip(values.iter().copied()).collect(),
        marks: false,
        dashed,
    };
    let known = |values: &[f64]| values.iter().any(|value| value.is_finite());
    let plot = |what: &str, y_label: &str, from_zero: bool, series: Vec<Series>| LinePlot {
        title: format!("{title}: {what}"),
        x_label: x_label.to_string(),
        y_label: y_label.to_string(),
        axes: [Axis::Linear, Axis::Linear],
        from_zero,
        series,
    };
    let mut plots = Vec::new();
    if known(&profile.pressure) {
        let mut curves = vec![series("", &profile.pressure, false)];
        if known(&profile.pressure_solved) {
            curves[0].name = "wanted".into();
            curves.push(series("contact solve on the shape", &profile.pressure_solved, true));
        }
        plots.push(("pressure", plot("contact pressure", "pressure (MPa)", true, curves)));
    }
    if profile.wear_rate.iter().any(|rate| *rate > 0.0) {
        let curves = vec![series("", &profile.wear_rate, false)];
        plots.push(("wear-rate", plot("wear rate", "wear rate (\u{b5}m/s)", true, curves)));
    }
    if known(&profile.gap) && points.gap.iter().any(|gap| *gap != 0.0) {
        let what = match (&solution.wear, &solution.shape) {
            (Some(_), _) => "worn gap",
            (None, Some(_)) => "machined gap",
            _ => "gap without load",
        };
        plots.push(("gap", plot(what, "gap (\u{b5}m)", true, vec![series("", &profile.gap, false)])));
    }
    plots.extend(error_plot(title, &solution.ladder).map(|plot| ("error", plot)));
    plots
}

/// What the levels say about the error.
fn error_plot(title: &str, ladder: &[Rung]) -> Option<LinePlot> {
    let series = |name: &str, dashed: bool, value: fn(&Rung) -> Option<f64>| Series {
        name: name.to_string(),
        points: ladder.iter().filter_map(|rung| Some((rung.degree as f64, value(rung)?))).filter(|point| point.1 > 0.0).collect(),
        marks: true,
        dashed,
    };
    let series = [
        series("difference from the level before", false, |rung| rung.change),
        series("estimated error", true, |rung| rung.estimate),
    ];
    let quantity = ladder.first()?.quantity;
    Some(LinePlot {
        title: format!("{title}: error of the {quantity}"),
        x_label: "degree of the cells".into(),
        y_label: "relative error".into(),
        axes: [Axis::Linear, Axis::Logarithmic],
        from_zero: false,
        series: series.into_iter().filter(|series| series.points.len() > 1).collect(),
    })
    .filter(|plot| !plot.series.is_empty())
}

/// The plots as numbers, for the page and for other programs: plots/curves.json.
pub(crate) fn curves_json(plots: &[(&'static str, LinePlot)]) -> Value {
    let number = |value: f64| {
        if value.is_finite() { json!(value) } else { Value::Null }
    };
    let chart = |plot: &LinePlot| {
        let series = plot.series.iter().map(|series| {
            json!({
                "name": series.name,
                "dashed": series.dashed,
                "marks": series.marks,
                "x": series.points.iter().map(|point| number(point.0)).collect::<Vec<_>>(),
                "y": series.points.iter().map(|point| number(point.1)).collect::<Vec<_>>(),
            })
        });
        json!({
            "title": plot.title,
            "x_label": plot.x_label,
            "y_label": plot.y_label,
            "from_zero": plot.from_zero,
            "log_y": plot.axes[1] == Axis::Logarithmic,
            "series": series.collect::<Vec<_>>(),
        })
    };
    Value::Array(plots.iter().map(|(name, plot)| json!({ "file": name, "chart": chart(plot) })).collect())
}

/// The coordinate of a picture and its name: angle on an arc, radius on a ring, else arc length.
pub fn abscissa(problem: &Problem, profile: &Profile) -> (Vec<f64>, &'static str) {
    if let Some(angles) = profile.s.iter().map(|s| problem.angle(*s)).collect::<Option<Vec<_>>>() {
        return (angles.into_iter().map(f64::to_degrees).collect(), "angle (deg)");
    }
    match problem.contact_shape() {
        Some(Shape::Annulus { .. } | Shape::Sector { .. }) => (profile.s.clone(), "radius (mm)"),
        Some(_) => (profile.position.iter().map(|p| p[0]).collect(), "x (mm)"),
        None => (profile.s.clone(), "s (mm)"),
    }
}
