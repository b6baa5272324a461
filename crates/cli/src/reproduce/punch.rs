//! Figures 12 to 15: the translating punch.

use report::LinePlot;
use scene::Fault;

use crate::reproduce::closed_form;
use crate::reproduce::drum::asymmetry;
use crate::reproduce::made::{Made, plot, series};
use crate::reproduce::row::Row;
use crate::reproduce::run::{Run, column, highest, run, set, value_at};
use crate::reproduce::section::meshes;

const SCENE: &str = "translating-punch";
const X: &str = "x (mm)";

/// Figure 12.
pub(super) fn mesh() -> Result<Made, Fault> {
    let mut made = Made::default();
    let cells =
        meshes(&mut made, SCENE, &set(&["mesh.degree=8", "mesh.layers=3"]), "Punch on its plate: mesh with three layers")?;
    made.rows.push(Row { quantity: "cells of both bodies".into(), ours: cells as f64, ..Row::default() });
    made.remarks.push("Our mesh, not the paper's. Thickness 10 mm and the plate's width of 120 mm are ours.".into());
    Ok(made)
}

/// The stationary wear power with q = 1 under a moment in N mm: its multipliers are lambda_F and lambda_M of (40).
fn stationary(moment: f64, words: &[&str]) -> Result<Run, Fault> {
    let mut settings = set(&["optimum.functional=wear-power"]);
    settings.push(format!("load.moment={moment}"));
    settings.extend(set(words));
    run(SCENE, &settings)
}

fn multipliers_of(run: &Run) -> [f64; 2] {
    let multipliers = run.pressure().multipliers;
    [multipliers.force.unwrap_or(f64::NAN), multipliers.moment.unwrap_or(0.0)]
}

/// Figure 13.
pub(super) fn multipliers() -> Result<Made, Fault> {
    let mut made = Made::default();
    let (mut force, mut moment) = (Vec::new(), Vec::new());
    for step in -20_i32..=20 {
        let m = 250.0 * f64::from(step);
        let solved = stationary(m, &["tasks=[pressure]"])?;
        let [lambda, rotation] = multipliers_of(&solved);
        force.push((1e-3 * m, 1e3 * lambda));
        moment.push((1e-3 * m, 1e3 * rotation * 30.0));
        if step % 10 != 0 {
            continue;
        }
        made.ran(&solved);
        let exact = closed_form::punch(m);
        let name = format!("M0 = {} kN mm", 1e-3 * m);
        let row = |what: &str, unit: &'static str, reference: f64, ours: f64, note: &str| Row {
            quantity: format!("{name}: {what}"),
            unit,
            reference: Some(reference),
            ours,
            note: note.into(),
            ..Row::default()
        };
        made.rows.push(row("lambda_F", "mm/s", exact.force, lambda, ""));
        made.rows.push(row("lambda_M L/2", "mm/s", 30.0 * exact.moment, 30.0 * rotation, ""));
        if step.abs() == 20 {
            let least = exact.ends[0].min(exact.ends[1]);
            let curve = solved.curve(column::pressure);
            let ours = curve.iter().map(|point| point.1).fold(f64::MAX, f64::min);
            made.rows.push(row(
                "smallest pressure",
                "MPa",
                least,
                ours,
                "positive everywhere, as the paper says; it would reach 0 at 6 kN mm",
            ));
        }
    }
    let curves = vec![series("\u{3bb}F", force), series("\u{3bb}M L/2", moment)];
    let mut picture =
        plot("Punch, F0 = 1 kN, a = 1, b = 2, q = 1: multipliers", "moment M0 (kN mm)", "multiplier (\u{b5}m/s)", curves);
    picture.from_zero = false;
    made.draw("curves", &picture);
    made.remarks.push(
        "The paper draws both multipliers and prints no numbers. They are (b + 1) = 3 times the rigid velocities of wear; lambda_M is drawn times L/2 = 30 mm."
            .into(),
    );
    Ok(made)
}

/// Lower edges of the punch after each displacement factor: the upper edge is moved down by `(lambda_F + lambda_M x) d_w`, which is the
/// feed, lambda over b + 1 = 3, during the time 3 d_w.
fn after_sliding(made: &mut Made, moment: f64, words: &[&str]) -> Result<Vec<Run>, Fault> {
    let mut runs = Vec::new();
    for factor in FACTORS {
        let time = format!("load.approach_time={}", 3.0 * factor);
        let all: Vec<&str> = words.iter().copied().chain(["check=false", time.as_str()]).collect();
        let solved = stationary(moment, &all)?;
        made.ran(&solved);
        runs.push(solved);
    }
    Ok(runs)
}

/// The picture of these edges.
fn edges(title: &str, runs: &[Run]) -> LinePlot {
    let curves = FACTORS.iter().zip(runs).map(|(factor, run)| series(format!("d_w = {factor} s"), run.curve(column::gap)));
    plot(title, X, "height of the lower edge (\u{b5}m)", curves.collect())
}

/// `max |g - (u2 - u1) . n - (lambda_F + lambda_M x) d_w| / max g` with the multipliers in closed form: the displacements with the upper
/// edge held, summed by hand.
fn off_by_hand(run: &Run, exact: &closed_form::Punch, factor: f64) -> f64 {
    let (first, second, gap) = (run.curve(column::normal1), run.curve(column::normal2), run.curve(column::gap));
    let by_hand = |i: usize| {
        let x = gap[i].0;
        second[i].1 - first[i].1 + 1e3 * (exact.force + exact.moment * x) * factor
    };
    let most = gap.iter().map(|point| point.1).fold(f64::MIN_POSITIVE, f64::max);
    (0..gap.len()).map(|i| (gap[i].1 - by_hand(i)).abs()).fold(0.0, f64::max) / most
}

/// Displacement factors, s: with less than 40 s the shape for M0 = -5 kN mm would need material where the punch was flat.
const FACTORS: [f64; 4] = [40.0, 80.0, 120.0, 160.0];

/// Largest difference of two curves after the best straight line is taken out, over a size.
fn apart_from_line(a: &[(f64, f64)], b: &[(f64, f64)], size: f64) -> f64 {
    let rest: Vec<(f64, f64)> = a.iter().map(|(x, y)| (*x, y - value_at(b, *x))).collect();
    let count = rest.len() as f64;
    let mean = |f: &dyn Fn(&(f64, f64)) -> f64| rest.iter().map(f).sum::<f64>() / count;
    let (x0, y0) = (mean(&|p| p.0), mean(&|p| p.1));
    let slope = mean(&|p| (p.0 - x0) * (p.1 - y0)) / mean(&|p| (p.0 - x0).powi(2));
    rest.iter().map(|(x, y)| (y - y0 - slope * (x - x0)).abs()).fold(0.0, f64::max) / size
}

/// Figure 14.
pub(super) fn shapes_with_moment() -> Result<Made, Fault> {
    let mut made = Made::default();
    for (name, moment) in [("a", -5000.0), ("b", 5000.0)] {
        let runs = after_sliding(&mut made, moment, &[])?;
        let title = format!("Punch, M0 = {} kN mm, \u{b5} = 0.25: shape after sliding", 1e-3 * moment);
        made.draw(name, &edges(&title, &runs));
        made.rows.push(Row {
            quantity: format!("M0 = {} kN mm, d_w = 40 s: edge against displacements and approach summed by hand", 1e-3 * moment),
            reference: Some(0.0),
            ours: off_by_hand(&runs[0], &closed_form::punch(moment), FACTORS[0]),
            note: "max |dg| / max g; the approach with the multipliers in closed form".into(),
            ..Row::default()
        });
        let worn = run(SCENE, &set(&["tasks=[wear]", &format!("load.moment={moment}")]))?;
        made.ran(&worn);
        // Of the lowest shape, without the approach that all of them have.
        let largest = highest(&worn.curve(column::gap)).1;
        made.rows.push(Row {
            quantity: format!("M0 = {} kN mm: shape against wear in time from a flat start, max |dg| / max g", 1e-3 * moment),
            reference: Some(0.0),
            ours: apart_from_line(&worn.curve(column::gap), &runs[0].curve(column::gap), largest),
            note: "the best straight line taken out".into(),
            ..Row::default()
        });
    }
    made.remarks.push(
        "The paper's displacement factors are not in the text; ours are 40 to 160 s. The shapes of (a) and (b) are no mirror images: friction drags the punch towards +x in both."
            .into(),
    );
    Ok(made)
}

/// Figure 15.
pub(super) fn shapes_without_moment() -> Result<Made, Fault> {
    let mut made = Made::default();
    let runs = after_sliding(&mut made, 0.0, &["contact.shear=false"])?;
    made.draw("a", &edges("Punch, M0 = 0, no shear on the bodies: shape after sliding", &runs));
    made.rows.push(Row {
        quantity: "frictionless: asymmetry of the shape, max |g(x) - g(-x)| / max g".into(),
        reference: Some(0.0),
        ours: asymmetry(&runs[0].curve(column::gap)),
        note: "the wear keeps mu = 0.25 (contact.shear = false): with mu = 0 the rule (4) wears nothing".into(),
        ..Row::default()
    });
    let mut curves = Vec::new();
    let mut odd = Vec::new();
    for friction in ["0", "0.1", "0.2", "0.25", "0.3"] {
        let solved = run(SCENE, &set(&[&format!("contact.friction={friction}"), "load.tilt=0", "check=false"]))?;
        made.ran(&solved);
        let curve = solved.curve(column::gap);
        odd.push(value_at(&curve, 25.0) - value_at(&curve, -25.0));
        if friction == "0.25" {
            made.rows.push(Row {
                quantity: "mu = 0.25: asymmetry of the shape".into(),
                ours: asymmetry(&curve),
                note: "the paper: asymmetric with friction".into(),
                ..Row::default()
            });
        }
        curves.push(series(format!("\u{b5} = {friction}"), curve));
    }
    made.draw("b", &plot("Punch, M0 = 0, rotation held: lowest shape by friction", X, "gap (\u{b5}m)", curves));
    made.rows.push(Row {
        quantity: "odd part of the shape at 25 mm, mu = 0.2 over mu = 0.1".into(),
        reference: Some(2.0),
        ours: odd[2] / odd[1],
        note: "linear elasticity under mu p with the same uniform p".into(),
        ..Row::default()
    });
    let held = run(SCENE, &set(&["load.tilt=0", "tasks=[pressure]"]))?;
    let free = run(SCENE, &set(&["load.moment=0", "tasks=[pressure]"]))?;
    made.rows.push(Row {
        quantity: "pressure with the rotation held, at 25 mm".into(),
        unit: "MPa",
        reference: Some(free.at(column::pressure, 25.0)),
        ours: held.at(column::pressure, 25.0),
        note: "the same as with M0 = 0, as the paper says".into(),
        ..Row::default()
    });
    Ok(made)
}
