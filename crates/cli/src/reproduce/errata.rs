//! What of the paper does not hold, in numbers that anybody can compute again.

use scene::{Fault, Gap};

use crate::reproduce::closed_form::{DRUM_FORCE, HALF_ANGLE, drum};
use crate::reproduce::made::{Made, plot, series};
use crate::reproduce::row::Row;
use crate::reproduce::run::{Run, column, run, run_from, set, value_at};

const SCENE: &str = "drum-brake-block";

/// Three claims: maxima taken for minima, a steady state that is none, a force that is missed.
pub(super) fn errata() -> Result<Made, Fault> {
    let mut made = Made::default();
    maxima(&mut made)?;
    steady_state(&mut made)?;
    missed_force(&mut made)?;
    Ok(made)
}

fn pressure_only(made: &mut Made, scene: &str, words: &[&str]) -> Result<Run, Fault> {
    let all: Vec<&str> = words.iter().chain(&["tasks=[pressure]"]).copied().collect();
    let solved = run(scene, &set(&all))?;
    made.ran(&solved);
    Ok(solved)
}

/// The stationary wear volume with b q < 1 wears more than other pressures that carry the same load.
fn maxima(made: &mut Made) -> Result<(), Fault> {
    let cases: [(&str, &[&str]); 3] = [
        ("stationary wear volume, q = 1 (s = b = 0.5)", &["optimum.functional=wear-volume"]),
        ("uniform pressure", &["optimum.functional=uniform"]),
        ("steady state", &["optimum.functional=steady"]),
    ];
    for (name, words) in cases {
        let solved = pressure_only(made, SCENE, words)?;
        made.rows.push(Row {
            quantity: format!("drum, {name}: wear volume rate"),
            unit: "mm^3/s",
            ours: solved.pressure().wear_volume_rate.unwrap_or(f64::NAN),
            note: if name.starts_with("stationary") {
                "called min W in the paper; the two below carry the same load and wear less".into()
            } else {
                String::new()
            },
            ..Row::default()
        });
    }
    for q in ["0.9", "1.1"] {
        let solved = pressure_only(made, "annular-punch", &["optimum.functional=friction-power", &format!("optimum.q={q}")])?;
        made.rows.push(Row {
            quantity: format!("ring, stationary friction power of q = {q}: torque over mu F0"),
            unit: "mm",
            reference: Some(super::closed_form::effective_radius(q.parse::<f64>().map_or(f64::NAN, |q| q / (q - 1.0)))),
            ours: solved.pressure().effective_radius.unwrap_or(f64::NAN),
            note: format!("a {} (between 20 and 120 mm)", wearshape::word(&solved.pressure().character)),
            ..Row::default()
        });
    }
    Ok(())
}

/// Wear in time from the flat start and from the paper's shape leads to the same state, and that is not the uniform pressure.
fn steady_state(made: &mut Made) -> Result<(), Fault> {
    // One discretisation for all, so that the shape is known at the very points it is used at.
    let uniform = run(SCENE, &set(&["optimum.functional=uniform", "check=false", "mesh.degree=10"]))?;
    made.ran(&uniform);
    let profile = uniform.solution.profile.clone().unwrap_or_default();
    let file = "uniform-shape.csv";
    let columns = [("s_mm".to_string(), profile.s.clone()), ("gap_um".to_string(), profile.gap.clone())];
    made.file(file, report::columns_csv(&columns));
    let start = || Some((Gap::Profile { s: profile.s.clone(), gap: profile.gap.clone() }, file));
    let worn = set(&["tasks=[wear]", "mesh.degree=10"]);
    let flat = run(SCENE, &worn)?;
    let shaped = run_from(SCENE, &worn, start())?;
    let before = run_from(SCENE, &set(&["tasks=[contact]", "mesh.degree=10"]), start())?;
    for run in [&flat, &shaped, &before] {
        made.ran(run);
    }
    let steady = pressure_only(made, SCENE, &["optimum.functional=steady"])?;
    let ratio = |curve: &[(f64, f64)]| value_at(curve, 0.0) / value_at(curve, 30.0);
    for (name, worn) in [("flat start", &flat), ("start from the shape of uniform pressure", &shaped)] {
        made.rows.push(Row {
            quantity: format!("drum, worn in, {name}: p(0) over p(30 deg)"),
            paper: Some((1.0, "sections 5.3 and 8: uniform")),
            reference: Some(HALF_ANGLE.cos().powi(-2)),
            ours: ratio(&worn.curve(column::pressure)),
            note: "a rigid motion along z removes w' = V cos(a), so p ~ cos^(1/b) = cos^2".into(),
            ..Row::default()
        });
    }
    let first = before.curve(column::pressure);
    made.rows.push(Row {
        quantity: "the same, before any wear: p(0) over p(30 deg)".into(),
        reference: Some(1.0),
        ours: ratio(&first),
        note: "the run does start from the uniform pressure, and leaves it".into(),
        ..Row::default()
    });
    for (name, functional, q) in
        [("steady", "steady", "1"), ("uniform", "uniform", "1"), ("wear power, q = 1", "wear-power", "1")]
    {
        let solved = pressure_only(made, SCENE, &[&format!("optimum.functional={functional}"), &format!("optimum.q={q}")])?;
        made.rows.push(Row {
            quantity: format!("drum, {name}: part of the wear that no rigid motion removes"),
            ours: solved.pressure().steadiness_residual.unwrap_or(f64::NAN),
            note: if name == "uniform" { "the paper's steady state".into() } else { String::new() },
            ..Row::default()
        });
    }
    let mut end = series("worn in, from that shape", shaped.curve(column::pressure));
    end.dashed = true;
    let curves =
        vec![series("start: shape of uniform pressure", first), series("steady state", steady.curve(column::pressure)), end];
    made.draw(
        "drum",
        &plot("Drum, a = 1, b = 0.5: wear in time leaves the uniform pressure", "angle (deg)", "pressure (MPa)", curves),
    );
    Ok(())
}

/// The printed normalisation carries less than the load.
fn missed_force(made: &mut Made) -> Result<(), Fault> {
    for (name, functional, q, k) in [("wear power, q = 1", "wear-power", "1", 2.0), ("q = inf", "wear-power", "inf", 0.0)] {
        let words = [format!("optimum.functional={functional}"), format!("optimum.q={q}"), "optimum.balance=paper".into()];
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let solved = pressure_only(made, SCENE, &words)?;
        let exact = drum(k);
        made.rows.push(Row {
            quantity: format!("drum, {name}, printed balance: vertical force carried"),
            unit: "N",
            paper: Some((DRUM_FORCE, "section 5.3")),
            reference: Some(DRUM_FORCE * exact.printed / exact.balanced),
            ours: solved.pressure().force.unwrap_or(f64::NAN),
            note: "(29)-(34) balance int p dS, which is not the vertical force on an arc".into(),
            ..Row::default()
        });
    }
    Ok(())
}
