//! Figures 4 to 8: the block shoe on its drum.

use scene::Fault;
use wearshape::Profile;

use crate::reproduce::closed_form::{DRUM_FORCE, HALF_ANGLE, drum};
use crate::reproduce::made::{Made, plot, series};
use crate::reproduce::row::Row;
use crate::reproduce::run::{Run, column, highest, run, set, value_at};

const SCENE: &str = "drum-brake-block";
const ANGLE: &str = "angle (deg)";

/// Wear factor of the scene times speed to the power a, `beta v^a` with a = 1 and v = 2.5 x 200 mm/s; times (mu p)^b gives mm/s.
const RATE: f64 = 2e-4 * 500.0;
const MU: f64 = 0.25;
const B: f64 = 0.5;

fn solve(made: &mut Made, functional: &str, q: &str) -> Result<Run, Fault> {
    let solved = run(
        SCENE,
        &[format!("optimum.functional={functional}"), format!("optimum.q={q}"), "wear.b=.5".into(), "tasks=[pressure]".into()],
    )?;
    made.ran(&solved);
    Ok(solved)
}

/// What a figure draws over the angle.
#[derive(Clone, Copy, PartialEq)]
enum Shown {
    Pressure,
    WearRate,
}

impl Shown {
    fn label(self) -> &'static str {
        match self {
            Shown::Pressure => "pressure (MPa)",
            Shown::WearRate => "wear rate (\u{b5}m/s)",
        }
    }

    fn column(self) -> fn(&Profile) -> &Vec<f64> {
        match self {
            Shown::Pressure => column::pressure,
            Shown::WearRate => column::wear_rate,
        }
    }
}

/// A functional with its values of q.
struct Family<'a> {
    /// As in `optimum.functional`.
    functional: &'a str,
    /// Power of the pressure in it, for q = 1.
    power: f64,
    /// Values of q as they are written.
    qs: &'a [&'a str],
    /// Title of its figures.
    title: &'a str,
}

/// Stationary wear volume, figures 4 and 5.
const WEAR_VOLUME: Family<'static> = Family {
    functional: "wear-volume",
    power: B,
    qs: &["0", "1.5", "1.9", "2.1", "3", "10"],
    title: "Drum, stationary wear volume rate, a = 1, b = 0.5",
};
/// Stationary friction power, figure 6.
const FRICTION_POWER: Family<'static> = Family {
    functional: "friction-power",
    power: 1.0,
    qs: &["1.05", "1.1", "1.25", "1.5", "2", "10"],
    title: "Drum, stationary friction power, a = 1, b = 0.5",
};
/// Stationary wear power, figure 7.
const WEAR_POWER: Family<'static> = Family {
    functional: "wear-power",
    power: B + 1.0,
    qs: &["0.5", "0.62", "0.7", "0.8", "1", "2", "10"],
    title: "Drum, stationary wear power, a = 1, b = 0.5",
};

/// Curves of one functional over q, with rows that compare the middle and the edge with the closed form.
fn by_q(family: &Family<'_>, shown: Shown) -> Result<(Made, Vec<Run>), Fault> {
    let mut made = Made::default();
    let mut runs = Vec::new();
    let mut curves = Vec::new();
    for q in family.qs {
        let solved = solve(&mut made, family.functional, q)?;
        curves.push(series(format!("q = {q}"), solved.curve(shown.column())));
        let k = 1.0 / (family.power * q.parse::<f64>().unwrap_or(f64::INFINITY) - 1.0);
        let (exact, edge) = (drum(k), HALF_ANGLE.cos().powf(k));
        let wear = shown == Shown::WearRate;
        // um/s from MPa.
        let value = |p: f64| if wear { 1e3 * RATE * (MU * p).powf(B) } else { p };
        for (angle, share) in [(0.0, 1.0), (30.0, edge)] {
            made.rows.push(Row {
                quantity: format!("q = {q}: {} at {}", if wear { "wear rate" } else { "pressure" }, place(angle)),
                unit: if wear { "um/s" } else { "MPa" },
                printed: Some(value(exact.printed * share)),
                reference: Some(value(exact.balanced * share)),
                ours: solved.at(shown.column(), angle),
                note: if angle == 0.0 { character(&solved) } else { String::new() },
                ..Row::default()
            });
        }
        runs.push(solved);
    }
    made.draw("curves", &plot(family.title, ANGLE, shown.label(), curves));
    made.remarks.push(
        "The paper draws curves and prints no numbers for this figure; its values of q are not all named in the text. The independent \
         value is cos^k with the true balance of vertical forces; the formula as printed balances int p dS instead, which carries too \
         little (see `errata`)."
            .into(),
    );
    Ok((made, runs))
}

fn place(angle: f64) -> &'static str {
    if angle == 0.0 { "0 deg" } else { "+-30 deg" }
}

fn character(run: &Run) -> String {
    let s = run.pressure().s.unwrap_or(f64::NAN);
    if s < 1.0 {
        format!("s = {} < 1: this stationary pressure is the worst, not the best", (s * 1e4).round() / 1e4)
    } else {
        String::new()
    }
}

/// Rows on where the pressure gathers: at the edges for `q` below the singular one, in the middle above it, as the paper says at a `place`.
fn localisation(made: &mut Made, (family, runs): (&Family<'_>, &[Run]), [below, above]: [&str; 2], place: &'static str) {
    for (q, said) in [(below, 30.0), (above, 0.0)] {
        let Some(run) = family.qs.iter().position(|other| *other == q).map(|i| &runs[i]) else { continue };
        made.rows.push(Row {
            quantity: format!("q = {q}: angle of the largest pressure"),
            unit: "deg",
            paper: Some((said, place)),
            ours: highest(&run.curve(column::pressure)).0.abs(),
            note: if said == 30.0 { "both edges".into() } else { String::new() },
            ..Row::default()
        });
    }
}

/// The q at which s = 1, from a regular run.
fn singular_q(runs: &[Run]) -> f64 {
    let first = runs.first().map(Run::pressure).unwrap_or_default();
    let last = runs.last().map(Run::pressure).unwrap_or_default();
    [first, last].iter().find_map(|p| Some(p.q? / p.s.filter(|s| s.is_finite() && *s > 0.0)?)).unwrap_or(f64::NAN)
}

/// Figure 4.
pub(super) fn pressure_of_wear_volume() -> Result<Made, Fault> {
    let (mut made, runs) = by_q(&WEAR_VOLUME, Shown::Pressure)?;
    let singular = Row {
        quantity: "q of the singular pressure".into(),
        paper: Some((2.0, "section 5.3")),
        ours: singular_q(&runs[1..]),
        note: "b q = 1".into(),
        ..Row::default()
    };
    made.rows.push(singular);
    localisation(&mut made, (&WEAR_VOLUME, &runs), ["1.9", "2.1"], "section 5.2");
    uniform(&mut made)?;
    Ok(made)
}

/// The limit q -> inf.
fn uniform(made: &mut Made) -> Result<(), Fault> {
    let limit = solve(made, "wear-volume", "inf")?;
    made.rows.push(Row {
        quantity: "q = inf: pressure everywhere".into(),
        unit: "MPa",
        paper: Some((5.0, "section 5.3, Fig. 8")),
        printed: Some(drum(0.0).printed),
        reference: Some(DRUM_FORCE / (2.0 * 2000.0 * HALF_ANGLE.sin())),
        ours: limit.at(column::pressure, 10.0),
        note: "the paper's own 5 MPa needs the true balance, not (32)".into(),
    });
    Ok(())
}

/// Figure 5.
pub(super) fn wear_rate_of_wear_volume() -> Result<Made, Fault> {
    Ok(by_q(&WEAR_VOLUME, Shown::WearRate)?.0)
}

/// Figure 6.
pub(super) fn pressure_of_friction_power() -> Result<Made, Fault> {
    let (mut made, runs) = by_q(&FRICTION_POWER, Shown::Pressure)?;
    localisation(&mut made, (&FRICTION_POWER, &runs), ["", "1.05"], "section 5.3");
    let said = 0.25 * 500.0 * DRUM_FORCE;
    for (q, run) in FRICTION_POWER.qs.iter().zip(&runs).filter(|(q, _)| ["1.05", "10"].contains(q)) {
        let k = 1.0 / (q.parse::<f64>().unwrap_or(1.0) - 1.0);
        let normal = drum(k).balanced * 2000.0 * super::closed_form::integral(|a| a.cos().powf(k), -HALF_ANGLE, HALF_ANGLE);
        made.rows.push(Row {
            quantity: format!("q = {q}: friction power"),
            unit: "mW",
            paper: Some((said, "(38)")),
            reference: Some(0.25 * 500.0 * normal),
            ours: run.pressure().friction_power.unwrap_or(f64::NAN),
            note: "(38) takes int p dS for F0; on an arc the normal forces sum up to more".into(),
            ..Row::default()
        });
    }
    Ok(made)
}

/// Figure 7.
pub(super) fn wear_rate_of_wear_power() -> Result<Made, Fault> {
    let (mut made, runs) = by_q(&WEAR_POWER, Shown::WearRate)?;
    made.rows.push(Row {
        quantity: "q of the singular pressure".into(),
        paper: Some((2.0 / 3.0, "section 5.3")),
        ours: singular_q(&runs),
        note: "(b + 1) q = 1".into(),
        ..Row::default()
    });
    localisation(&mut made, (&WEAR_POWER, &runs), ["0.62", "0.7"], "section 5.2");
    if let Some(steady) = runs.get(4) {
        made.rows.push(Row {
            quantity: "q = 1: wear rate at +-30 deg over that at 0".into(),
            reference: Some(HALF_ANGLE.cos()),
            ours: steady.at(column::wear_rate, 30.0) / steady.at(column::wear_rate, 0.0),
            note: "w' ~ cos: the rate of a rigid motion along z, so this is the steady state (see `errata`)".into(),
            ..Row::default()
        });
    }
    Ok(made)
}

fn gap(made: &mut Made, friction: &str) -> Result<Vec<(f64, f64)>, Fault> {
    let solved = run(SCENE, &set(&["optimum.functional=uniform", &format!("contact.friction={friction}"), "check=false"]))?;
    made.ran(&solved);
    Ok(solved.curve(column::gap))
}

/// Largest difference of a curve from its mirror image, over its largest value.
pub(super) fn asymmetry(curve: &[(f64, f64)]) -> f64 {
    let pairs = curve.iter().zip(curve.iter().rev());
    pairs.map(|(a, b)| (a.1 - b.1).abs()).fold(0.0, f64::max) / highest(curve).1
}

/// Figure 8.
pub(super) fn gap_by_friction() -> Result<Made, Fault> {
    let mut made = Made::default();
    let large = ["0", "0.1", "0.2", "0.25", "0.3"];
    let small = ["0", "0.005", "0.01", "0.02"];
    let mut gaps = Vec::new();
    for (name, frictions) in [("a", &large[..]), ("b", &small[..])] {
        let mut curves = Vec::new();
        for friction in frictions {
            let curve = gap(&mut made, friction)?;
            curves.push(series(format!("\u{b5} = {friction}"), curve.clone()));
            gaps.push((*friction, curve));
        }
        made.draw(name, &plot("Drum, gap for uniform 5 MPa", ANGLE, "gap (\u{b5}m)", curves));
    }
    let of =
        |friction: &str| gaps.iter().find(|(name, _)| *name == friction).map(|(_, curve)| curve.as_slice()).unwrap_or_default();
    let odd = |curve: &[(f64, f64)], angle: f64| value_at(curve, angle) - value_at(curve, -angle);
    made.rows.push(Row {
        quantity: "mu = 0: asymmetry of the gap, max |g(a) - g(-a)| / max g".into(),
        paper: Some((0.0, "section 5.3")),
        ours: asymmetry(of("0")),
        note: "the text says \"frictional\" once where it means frictionless".into(),
        ..Row::default()
    });
    for angle in [15.0, 30.0] {
        made.rows.push(Row {
            quantity: format!("mu = 0.25: gap at +{angle} deg less gap at -{angle} deg"),
            unit: "um",
            ours: odd(of("0.25"), angle),
            note: if angle == 15.0 {
                "the drum turns anti-clockwise, so +30 deg is the leading edge, where the paper sees the higher values".into()
            } else {
                "at the very end ours is higher on the trailing side; hub radius and guides are ours, the paper names none".into()
            },
            ..Row::default()
        });
    }
    // The jump is affine in the friction as long as the pressure is uniform; the rigid part follows cos and drops out of the odd part.
    made.rows.push(Row {
        quantity: "odd part of the gap at 15 deg, mu = 0.2 over mu = 0.1".into(),
        reference: Some(2.0),
        ours: odd(of("0.2"), 15.0) / odd(of("0.1"), 15.0),
        note: "linear elasticity under mu p with the same p".into(),
        ..Row::default()
    });
    let (still, slight) = (of("0"), of("0.005"));
    let change = still.iter().zip(slight).map(|(a, b)| (a.1 - b.1).abs()).fold(0.0, f64::max) / highest(still).1;
    made.rows.push(Row {
        quantity: "mu = 0.005: largest change of the gap over the largest gap".into(),
        ours: change,
        note: "the paper calls the change significant without a number; by linearity it is 1/50 of that at mu = 0.25".into(),
        ..Row::default()
    });
    made.remarks.push("Hub radius 100 mm and guides on both sides of the shoe are ours; Young's modulus is 2.1e5 MPa (the text misses the power).".into());
    Ok(made)
}
