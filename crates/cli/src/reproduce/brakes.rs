//! Textbook formulas of clutches and long shoes as special cases of the steady state with a = b = 1.

use scene::Fault;

use crate::reproduce::closed_form::{RADII, integral};
use crate::reproduce::made::{Made, plot, series};
use crate::reproduce::row::Row;
use crate::reproduce::run::{column, run, set};

/// Clutch, pinned long shoe, pivoted long shoe.
pub(super) fn brakes() -> Result<Made, Fault> {
    let mut made = Made::default();
    clutch(&mut made)?;
    let pinned = pinned(&mut made)?;
    elastic(&mut made)?;
    let pivoted = pivoted(&mut made)?;
    made.draw("curves", &plot("Long shoes: steady pressure, a = b = 1", "angle (deg)", "pressure (MPa)", vec![pinned, pivoted]));
    Ok(made)
}

fn clutch(made: &mut Made) -> Result<(), Fault> {
    let [inner, outer] = RADII;
    let uniform_pressure = 2.0 / 3.0 * (outer.powi(3) - inner.powi(3)) / (outer.powi(2) - inner.powi(2));
    for (name, functional, radius) in
        [("uniform wear", "steady", 0.5 * (inner + outer)), ("uniform pressure", "uniform", uniform_pressure)]
    {
        let solved = run("annular-punch", &set(&[&format!("optimum.functional={functional}"), "tasks=[pressure]"]))?;
        made.ran(&solved);
        made.rows.push(Row {
            quantity: format!("clutch, {name}: torque over mu F"),
            unit: "mm",
            reference: Some(radius),
            ours: solved.pressure().effective_radius.unwrap_or(f64::NAN),
            note: if functional == "steady" { "(r_i + r_o) / 2".into() } else { "2/3 (r_o^3 - r_i^3) / (r_o^2 - r_i^2)".into() },
            ..Row::default()
        });
    }
    Ok(())
}

/// The internal expanding shoe of Shigley's example: r 150, width 32, mu 0.32, 1 MPa, pin distance 122.654, arm 212, 0 to 126 deg.
fn pinned(made: &mut Made) -> Result<report::Series, Fault> {
    let (r, width, mu, pin, arm, to) = (150.0, 32.0, 0.32, 122.654, 212.0, 126.0_f64.to_radians());
    // p = p_a sin(theta), largest at 90 degrees.
    let friction = mu * width * r * integral(|t: f64| t.sin() * (r - pin * t.cos()), 0.0, to);
    let normal = width * r * pin * integral(|t: f64| t.sin().powi(2), 0.0, to);
    let force = (normal - friction) / arm;
    let torque = mu * width * r * r * (1.0 - to.cos());
    let other = force * arm / (normal + friction);
    let from = "Shigley's example 16-2, its data as we know them";
    let mut curve = Vec::new();
    for (name, omega, share) in [("self-energised", "10", 1.0), ("trailing", "-10", other)] {
        let solved = run("pinned-shoe", &set(&[&format!("sliding.omega={omega}"), &format!("load.force={force}")]))?;
        made.ran(&solved);
        let ours = solved.pressure();
        if share == 1.0 {
            curve = solved.curve(column::pressure);
        }
        for (what, unit, reference, value) in [
            ("largest pressure", "MPa", share, ours.p_max),
            ("friction torque", "N m", 1e-3 * share * torque, ours.torque.map(|t| 1e-3 * t.abs())),
        ] {
            made.rows.push(Row {
                quantity: format!("pinned shoe, {name}: {what}"),
                unit,
                reference: Some(reference),
                ours: value.unwrap_or(f64::NAN),
                note: from.into(),
                ..Row::default()
            });
        }
    }
    made.remarks.push(format!(
        "Pinned shoe: M_f = {:.1} N m, M_n = {:.1} N m, F = {:.4} kN, both torques {:.1} N m by the textbook's integrals of p = p_a sin(theta). \
         The problem's data were not checked against the book.",
        1e-3 * friction,
        1e-3 * normal,
        1e-3 * force,
        1e-3 * torque * (1.0 + other)
    ));
    Ok(series("pinned, from the pin", curve))
}

/// Where the elastic shoe presses most: 90 deg from its pin.
const FULLEST: f64 = 160.0;

/// The elastic shoe on its pin: lining from 15 to 125 deg from the pin, tip opposite to it. Elastic bodies do not change its steady pressure, and a
/// contact solve on the shape gives that back.
fn elastic(made: &mut Made) -> Result<(), Fault> {
    let (r, width, mu, pin, force) = (110.0, 40.0, 0.38, 88.331_f64.hypot(32.150), 2500.0);
    // The tip lies at 110 deg, the pin at 250 deg; the force is across the tip.
    let arm = 2.0 * pin * 70.0_f64.to_radians().sin() * 70.0_f64.to_radians().sin();
    let [from, to] = [15.0_f64, 125.0].map(f64::to_radians);
    let friction = mu * width * r * integral(|t: f64| t.sin() * (r - pin * t.cos()), from, to);
    let normal = width * r * pin * integral(|t: f64| t.sin().powi(2), from, to);
    let torque = mu * width * r * r * (from.cos() - to.cos());
    for (name, omega, sense) in [("leading", "-80", -1.0), ("trailing", "80", 1.0)] {
        let solved = run("pinned-shoe-elastic", &set(&[&format!("sliding.omega={omega}")]))?;
        made.ran(&solved);
        let largest = force * arm / (normal + sense * friction);
        for (what, unit, reference, ours) in [
            (
                "pressure at 90 deg from the pin, from a contact solve on the shape",
                "MPa",
                largest,
                solved.at(column::solved, FULLEST),
            ),
            ("friction torque", "N m", 1e-3 * largest * torque, 1e-3 * solved.pressure().torque.map_or(f64::NAN, f64::abs)),
        ] {
            made.rows.push(Row {
                quantity: format!("elastic shoe on its pin, {name}: {what}"),
                unit,
                reference: Some(reference),
                ours,
                note: "the same integrals of p = p_a sin(theta)".into(),
                ..Row::default()
            });
        }
    }
    Ok(())
}

fn pivoted(made: &mut Made) -> Result<report::Series, Fault> {
    let solved = run("pivoted-shoe", &[])?;
    made.ran(&solved);
    let (radius, width, angle) = (200.0, 50.0, std::f64::consts::FRAC_PI_4);
    let share = angle + angle.sin() * angle.cos();
    made.rows.push(Row {
        quantity: "pivoted shoe: largest pressure".into(),
        unit: "MPa",
        reference: Some(10_000.0 / (radius * width * share)),
        ours: solved.pressure().p_max.unwrap_or(f64::NAN),
        note: "F = p_max R t (a0 + sin a0 cos a0), p = p_max cos(alpha)".into(),
        ..Row::default()
    });
    made.rows.push(Row {
        quantity: "pivoted shoe: pressure at 45 deg over the largest".into(),
        reference: Some(angle.cos()),
        ours: solved.at(column::pressure, 45.0) / solved.pressure().p_max.unwrap_or(f64::NAN),
        ..Row::default()
    });
    Ok(series("pivoted, from the pivot", solved.curve(column::pressure)))
}
