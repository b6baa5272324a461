//! The plots of a run: pressure, shear and where it sticks, wear rate, gap, what a run in time does, error.

use serde_json::{Value, json};
use wearshape::{PointStatus, Problem, Profile, Rung, Shape, Solution};

use crate::brief::brief;
use crate::heat_curves::{HeatCurves, heat_curves, warm};
use crate::labels::shown_title;
use crate::line_plot::{Axis, LinePlot, Series, Zone, cut};
use crate::path_curves::path_plots;
use crate::schedule_words::speed_changes;

/// A plot with the name of its file and the named parts of its x axis.
pub(crate) struct Picture {
    pub(crate) file: String,
    pub(crate) plot: LinePlot,
    pub(crate) zones: Vec<Zone>,
}

/// The plots of a run.
pub(crate) fn line_plots(problem: &Problem, solution: &Solution) -> Vec<Picture> {
    let title = &shown_title(problem);
    let Some(points) = &solution.profile else {
        return Vec::new();
    };
    let plain = |(file, plot): (&'static str, LinePlot)| Picture { file: file.to_string(), plot, zones: Vec::new() };
    let mut plots = along_the_surface(problem, solution, points);
    plots.extend(warm(solution, points).into_iter().flat_map(|profile| heat_pictures(problem, solution, profile)));
    plots.extend(path_plots(title, &solution.paths).into_iter().map(|(file, plot)| Picture { file, plot, zones: Vec::new() }));
    plots.extend(histories(title, &solution.history, !speed_changes(problem.scene())).into_iter().map(plain));
    plots.extend(groove(title, &solution.groove).map(plain));
    plots.extend(error_plot(title, &solution.ladder).map(|plot| ("error", plot)).map(plain));
    plots
}

/// Pressure, wear rate and gap along the contact surface.
fn along_the_surface(problem: &Problem, solution: &Solution, points: &Profile) -> Vec<Picture> {
    // Evenly spaced points draw smoother than the contact points.
    let profile = solution.curve.as_ref().unwrap_or(points);
    let (places, x_label) = abscissa(problem, profile);
    let series = |name: &str, values: &[f64], dashed: bool| series_over(&places, name, values, dashed);
    let known = |values: &[f64]| values.iter().any(|value| value.is_finite());
    let plot = |what: &str, y_label: &str, series: Vec<Series>| LinePlot {
        title: format!("{}: {what}", shown_title(problem)),
        x_label: x_label.to_string(),
        y_label: y_label.to_string(),
        axes: [Axis::Linear, Axis::Linear],
        from_zero: true,
        series,
    };
    let mut plots = Vec::new();
    if known(&profile.pressure) {
        let mut curves = vec![series("", &profile.pressure, false)];
        let cut = solution.map.is_some();
        let mut what = (if cut { "contact pressure on the middle line" } else { "contact pressure" }, "pressure (MPa)");
        let touched = solution.contact.is_some() && solution.shape.is_none() && solution.wear.is_none();
        if let Some(share) = share_forward(solution).filter(|_| !profile.pressure_back.is_empty()) {
            curves = both_senses(profile, share, &series);
            what.0 = "contact pressure forward and backward";
        } else if known(&profile.pressure_solved) {
            curves[0].name = "wanted".into();
            curves.push(series("contact solve on the shape", &profile.pressure_solved, true));
        } else if touched && profile.shear.iter().any(|shear| shear.abs() > 0.0) {
            curves[0].name = "pressure".into();
            curves.push(series("shear on body 1", &profile.shear, false));
            what = ("contact pressure and shear", "pressure, shear (MPa)");
        }
        compared_with(solution, &mut curves, &series);
        // From point to point of the contact: their status changes exactly there.
        let zones = sticking(&abscissa(problem, points).0, points);
        plots.push(Picture { file: "pressure".to_string(), plot: plot(what.0, what.1, curves), zones });
    }
    let mut plain = |file: &'static str, plot: LinePlot| plots.push(Picture { file: file.to_string(), plot, zones: Vec::new() });
    if profile.wear_rate.iter().any(|rate| *rate > 0.0) {
        plain("wear-rate", plot("wear rate", "wear rate (\u{b5}m/s)", vec![series("", &profile.wear_rate, false)]));
    }
    if known(&profile.gap) && points.gap.iter().any(|gap| *gap != 0.0) {
        let what = match (&solution.wear, &solution.shape) {
            (Some(_), _) => "worn profile, without load",
            (None, Some(_)) => "taken off by machining",
            _ => "gap without load",
        };
        plain("gap", plot(what, "gap (\u{b5}m)", vec![series("", &profile.gap, false)]));
    }
    plots
}

/// Names pressures of the last task, and adds those of the surface as machined before wear in time and as it is now.
fn compared_with(solution: &Solution, curves: &mut Vec<Series>, series: &dyn Fn(&str, &[f64], bool) -> Series) {
    let machined = solution.as_machined.as_ref();
    if machined.is_none() && solution.unmachined.is_none() {
        return;
    }
    let last = if machined.is_some() { "worn" } else { "as machined" };
    let first = &mut curves[0].name;
    *first = if first.is_empty() { last.into() } else { format!("{last}: {first}") };
    curves.extend(machined.map(|machined| series("as machined", &machined.curve.pressure, true)));
    curves.extend(solution.unmachined.as_ref().map(|now| series("as it is now", &now.pressure, false)));
}

/// A curve without marks over these places.
fn series_over(places: &[f64], name: &str, values: &[f64], dashed: bool) -> Series {
    let points = places.iter().copied().zip(values.iter().copied()).collect();
    Series { name: name.to_string(), points, marks: false, dashed }
}

/// Temperature, heat and thermal gap along the contact surface.
fn heat_pictures(problem: &Problem, solution: &Solution, profile: &Profile) -> Vec<Picture> {
    let (places, x_label) = abscissa(problem, profile);
    let series = |name: &str, values: &[f64], dashed: bool| series_over(&places, name, values, dashed);
    let picture = |curves: HeatCurves| {
        let plot = LinePlot {
            title: format!("{}: {}", shown_title(problem), curves.what),
            x_label: x_label.to_string(),
            y_label: curves.label.to_string(),
            axes: [Axis::Linear, Axis::Linear],
            from_zero: curves.file != "temperature",
            series: curves.series,
        };
        Picture { file: curves.file.to_string(), plot, zones: Vec::new() }
    };
    heat_curves(solution, profile, &series).into_iter().map(picture).collect()
}

/// Share of the time that a reversing motion goes forward.
fn share_forward(solution: &Solution) -> Option<f64> {
    let by_turns = || solution.wear.as_ref()?.turns.as_ref()?.shares.first().copied();
    by_turns().or(solution.reversing.as_ref().map(|reversing| reversing.share))
}

/// The pressures of a reversing motion, what a contact solve forward gives back, and the mean over the time.
fn both_senses(profile: &Profile, share: f64, series: &dyn Fn(&str, &[f64], bool) -> Series) -> Vec<Series> {
    let both = profile.pressure.iter().zip(&profile.pressure_back);
    let mean: Vec<f64> = both.map(|(forward, backward)| share * forward + (1.0 - share) * backward).collect();
    let mut curves = vec![series("forward", &profile.pressure, false), series("backward", &profile.pressure_back, false)];
    curves.push(series("mean over the time", &mean, false));
    if profile.pressure_solved.iter().any(|value| value.is_finite()) {
        curves.push(series("contact solve on the shape, forward", &profile.pressure_solved, true));
    }
    curves
}

/// Where the contact sticks, of one that slips elsewhere.
fn sticking(places: &[f64], profile: &Profile) -> Vec<Zone> {
    let mut zones: Vec<Zone> = Vec::new();
    let mut open = false;
    for (place, status) in places.iter().zip(&profile.status) {
        let sticks = *status == PointStatus::Stick;
        match zones.last_mut().filter(|_| open && sticks) {
            Some(zone) => zone.range[1] = *place,
            None if sticks => zones.push(Zone { range: [*place; 2], name: "sticks" }),
            None => {}
        }
        open = sticks;
    }
    zones
}

/// A run in time: its pressures, the depth and the volume worn off; the speed is told where it is `one`.
fn histories(title: &str, history: &[(String, Vec<f64>)], one: bool) -> Vec<(&'static str, LinePlot)> {
    let column = |name: &str| history.iter().find(|(known, _)| known == name).map(|(_, values)| values.as_slice());
    let Some(time) = column("time_s").filter(|time| time.len() > 1) else { return Vec::new() };
    let series = |name: &str, column: &[f64]| Series {
        name: name.to_string(),
        points: time.iter().copied().zip(column.iter().copied()).collect(),
        marks: true,
        dashed: false,
    };
    let speed = column("distance_mm").and_then(|distance| Some(distance.last()? / time.last()?));
    let speed = speed.filter(|speed| one && speed.is_finite());
    let x_label = speed.map_or("time (s)".into(), |speed| format!("time (s); {} mm of sliding a second", brief(speed)));
    let plot = |what: &str, y_label: &str, axes: [Axis; 2], series: Vec<Series>| LinePlot {
        title: format!("{title}: {what}"),
        x_label: x_label.clone(),
        y_label: y_label.into(),
        axes,
        from_zero: axes[1] == Axis::Linear,
        series,
    };
    // Most steps of a run into the steady state lie in its very beginning.
    let early = time[time.len() / 2] < 0.02 * time[time.len() - 1];
    let x_axis = if early { Axis::Logarithmic } else { Axis::Linear };
    let mut plots = Vec::new();
    if let (Some(most), Some(least)) = (column("p_max_MPa"), column("p_min_MPa")) {
        let wide = most.iter().copied().fold(0.0, f64::max) > 20.0 * most.iter().copied().fold(f64::INFINITY, f64::min);
        let y_axis = if wide { Axis::Logarithmic } else { Axis::Linear };
        // Where points are open all the time the smallest is zero, which a logarithmic axis cannot show.
        let shown = y_axis == Axis::Linear || least.iter().any(|p| *p > 0.0);
        let curves = if shown { vec![series("largest", most), series("smallest", least)] } else { vec![series("", most)] };
        let what = if shown { "pressure over time" } else { "largest pressure over time" };
        plots.push(("history-pressure", plot(what, "pressure (MPa)", [x_axis, y_axis], curves)));
    }
    let linear = [Axis::Linear; 2];
    if let Some(depth) = column("depth_um") {
        plots.push(("history-depth", plot("depth worn off body 1", "depth (\u{b5}m)", linear, vec![series("", depth)])));
    }
    let hottest = |name: &str, key: &str| column(key).map(|values| series(name, values));
    let warm: Vec<Series> = [hottest("body 1", "T1_max_degC"), hottest("body 2", "T2_max_degC")].into_iter().flatten().collect();
    if !warm.is_empty() {
        let plot = plot("highest temperatures over time", "temperature (\u{b0}C)", [x_axis, Axis::Linear], warm);
        plots.push(("history-temperature", LinePlot { from_zero: false, ..plot }));
    }
    if let Some(scar) = column("scar_mm") {
        plots.push(("history-scar", plot("width of the scar", "width (mm)", linear, vec![series("", scar)])));
    }
    let worn = |name: &'static str, key: &str| column(key).filter(|v| v.iter().any(|v| *v > 0.0)).map(|v| series(name, v));
    let volumes: Vec<Series> = [worn("body 1", "volume1_mm3"), worn("body 2", "volume2_mm3")].into_iter().flatten().collect();
    if !volumes.is_empty() {
        plots.push(("history-volume", plot("volume worn off", "volume (mm\u{b3})", linear, volumes)));
    }
    plots
}

/// The profile of the groove in a revolving disc.
fn groove(title: &str, columns: &[(String, Vec<f64>)]) -> Option<(&'static str, LinePlot)> {
    let [(_, places), (_, depths)] = columns else { return None };
    let points = places.iter().copied().zip(depths.iter().map(|depth| -depth)).collect();
    let plot = LinePlot {
        title: format!("{title}: groove in body 2"),
        x_label: "across the track (mm)".into(),
        y_label: "height (\u{b5}m)".into(),
        axes: [Axis::Linear; 2],
        from_zero: true,
        series: vec![Series { name: String::new(), points, marks: false, dashed: false }],
    };
    Some(("groove", plot))
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
        series: series.into_iter().filter(|series| !series.points.is_empty()).collect(),
    })
    // Two points at the least, of one curve or of two.
    .filter(|plot| plot.series.iter().map(|series| series.points.len()).sum::<usize>() > 1)
}

/// The plots of a run as numbers: what plots/curves.json holds, a list of `{ file, chart }`.
pub fn curves(problem: &Problem, solution: &Solution) -> Value {
    curves_json(&line_plots(problem, solution))
}

/// The plots as numbers, for the page and for other programs: plots/curves.json.
pub(crate) fn curves_json(plots: &[Picture]) -> Value {
    let number = |value: f64| {
        if value.is_finite() { json!(value) } else { Value::Null }
    };
    let chart = |picture: &Picture| {
        let plot = &picture.plot;
        let cut = cut(plot);
        let zones = picture.zones.iter().map(|zone| json!({ "from": zone.range[0], "to": zone.range[1], "name": zone.name }));
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
            "log_x": plot.axes[0] == Axis::Logarithmic,
            "log_y": plot.axes[1] == Axis::Logarithmic,
            "top": cut.map(|cut| cut.high),
            "note": cut.map(|cut| cut.note()),
            "zones": zones.collect::<Vec<_>>(),
            "series": series.collect::<Vec<_>>(),
        })
    };
    Value::Array(plots.iter().map(|picture| json!({ "file": picture.file, "chart": chart(picture) })).collect())
}

/// The coordinate of a picture and its name: angle on an arc, radius on a ring, else arc length.
pub fn abscissa(problem: &Problem, profile: &Profile) -> (Vec<f64>, &'static str) {
    if let Some(angles) = profile.s.iter().map(|s| problem.angle(*s)).collect::<Option<Vec<_>>>() {
        return (angles.into_iter().map(f64::to_degrees).collect(), "angle (\u{b0})");
    }
    match problem.contact_shape() {
        Some(Shape::Annulus { .. } | Shape::Sector { .. }) => (profile.s.clone(), "radius (mm)"),
        Some(_) => (profile.position.iter().map(|p| p[0]).collect(), "x (mm)"),
        None => (profile.s.clone(), "s (mm)"),
    }
}
