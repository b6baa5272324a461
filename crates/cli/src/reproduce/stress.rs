//! Figures 16, 17 and 26: stresses in the punches.

use hpfem::Stress;
use report::{Isobands, Placed, Section, numbers_row, table};
use scene::Fault;
use wearshape::{BodyField, CellField};

use crate::reproduce::annulus;
use crate::reproduce::closed_form::{RADII, punch, ring_pressure};
use crate::reproduce::made::Made;
use crate::reproduce::row::Row;
use crate::reproduce::run::{Run, run, set};

const PUNCH: &str = "translating-punch";
/// The discretisation of the pictures; the rows say how exact it is.
const MESH: [&str; 3] = ["output.fields=true", "mesh.degree=10", "mesh.layers=4"];
/// Size of a piece that is cut at the colours, in pixels.
const PIECE: f64 = 4.0;
const CLIPPED: &str = "Colours span the stresses between their 2 and 98 per cent quantiles by area: at the corners of a held, loaded or sharp \
                       edge the stress of linear elasticity is infinite, and its largest number means nothing.";

fn with_fields(scene: &str, words: &[&str]) -> Result<Run, Fault> {
    let all: Vec<&str> = MESH.iter().chain(words).copied().collect();
    run(scene, &set(&all))
}

/// Body 1 at the reported moment.
fn upper(run: &Run) -> BodyField {
    run.solution.fields.iter().find(|frame| frame.moment.is_empty()).map(|frame| frame.bodies[0].clone()).unwrap_or_default()
}

/// Draws one stress of a body as `<name>.svg`, and keeps its points as `<name>.csv`.
fn draw(made: &mut Made, name: &str, title: &str, body: &BodyField, stress: fn(&Stress) -> f64) {
    let points = || body.cells.iter().flat_map(|cell| cell.position.iter());
    let range = |k: usize| points().fold([f64::MAX, f64::MIN], |[lo, hi], p| [lo.min(p[k]), hi.max(p[k])]);
    let section = Section::new(range(0), range(1), 96.0);
    let placed = |cell: &CellField| -> Placed {
        let sample = |k: usize| (section.place(cell.position[k]), stress(&cell.stress[k]));
        (cell.grid, (0..cell.position.len()).map(sample).collect())
    };
    let bands = Isobands::of(&body.cells.iter().map(placed).collect::<Vec<_>>(), PIECE);
    let [right, top, bottom] = section.edges();
    let svg = bands.svg() + &bands.bar([right + 16.0, top], (bottom - top).min(320.0));
    let names = if body.revolved { ["r", "z"] } else { ["x", "z"] };
    made.file(&format!("{name}.svg"), section.picture(title, names, &svg));
    let points = body.cells.iter().flat_map(|cell| cell.position.iter().zip(&cell.stress));
    let rows = points.map(|(place, value)| numbers_row(&[place[0], place[1], stress(value)]));
    made.file(&format!("{name}.csv"), table(&["x_mm", "z_mm", "stress_MPa"], rows));
}

/// Largest difference of a stress on a horizontal line from what it ought to be, for places between two ends.
fn off(body: &BodyField, z: f64, [from, to]: [f64; 2], wrong: impl Fn(f64, &Stress) -> f64) -> f64 {
    let points = body.cells.iter().flat_map(|cell| cell.position.iter().zip(&cell.stress));
    let near = points.filter(|(p, _)| (p[1] - z).abs() < 1e-9 && p[0] >= from && p[0] <= to);
    near.map(|(p, stress)| wrong(p[0], stress).abs()).fold(0.0, f64::max)
}

/// Figure 16.
pub(super) fn punch_before() -> Result<Made, Fault> {
    let mut made = Made::default();
    let words = ["tasks=[contact]", "contact.friction=0", "load.moment=5000"];
    let solved = with_fields(PUNCH, &words)?;
    made.ran(&solved);
    let body = upper(&solved);
    draw(&mut made, "sigma-z", "Punch before wear, M0 = 5 kN mm, \u{b5} = 0: \u{3c3}z (MPa)", &body, |s| s.zz);
    let exact = run(PUNCH, &set(&words))?;
    made.ran(&exact);
    let exponents = exact.solution.contact.clone().unwrap_or_default().edge_exponents;
    if let Some(exponent) = exponents.last() {
        made.rows.push(Row {
            quantity: "exponent of the pressure at x = 30 mm, z = 100 mm".into(),
            reference: Some(-0.225_987),
            ours: *exponent,
            note: "singular, as the paper says; reference: 90 deg corner on an equal half-plane without friction".into(),
            ..Row::default()
        });
    }
    made.rows.push(force_on_line(&body, 150.0));
    made.remarks.push(CLIPPED.into());
    Ok(made)
}

/// int sigma_z t dx on a horizontal line, from its points by the trapezoid rule, against the load.
fn force_on_line(body: &BodyField, z: f64) -> Row {
    let mut line: Vec<(f64, f64)> = Vec::new();
    for cell in &body.cells {
        // The sides of all pieces; one between two pieces counts for nothing when it comes again.
        let pieces = cell.grid.pieces(cell.grid.degree, cell.grid.degree);
        let sides = pieces.iter().flat_map(|piece| (0..piece.len()).map(|k| (piece[k], piece[(k + 1) % piece.len()])));
        for (from, to) in sides.map(|(a, b)| (a.min(b), a.max(b))) {
            let (a, b) = (cell.position[from], cell.position[to]);
            if (a[1] - z) * (b[1] - z) <= 0.0 && a[1] != b[1] {
                let t = (z - a[1]) / (b[1] - a[1]);
                let [low, high] = [from, to].map(|k| cell.stress[k].zz);
                line.push((a[0] + t * (b[0] - a[0]), low + t * (high - low)));
            }
        }
    }
    line.sort_by(|a, b| a.0.total_cmp(&b.0));
    let force: f64 = line.windows(2).map(|pair| 5.0 * (pair[1].0 - pair[0].0) * (pair[0].1 + pair[1].1)).sum();
    Row {
        quantity: format!("force through the section z = {z} mm"),
        unit: "N",
        reference: Some(1000.0),
        ours: -force,
        note: "sum over the points of the picture; the load is 1 kN".into(),
        ..Row::default()
    }
}

/// Figure 17.
pub(super) fn punch_after() -> Result<Made, Fault> {
    let mut made = Made::default();
    for (name, moment) in [("a", 5000.0), ("b", 0.0), ("c", -5000.0)] {
        let solved = with_fields(PUNCH, &["optimum.functional=wear-power", &format!("load.moment={moment}"), "check=false"])?;
        made.ran(&solved);
        let body = upper(&solved);
        let title = format!("Punch worn in, M0 = {} kN mm, \u{b5} = 0.25: \u{3c3}z (MPa)", 1e-3 * moment);
        draw(&mut made, name, &title, &body, |s| s.zz);
        let exact = punch(moment);
        // p^2 is linear between the ends.
        let wanted = |x: f64| {
            let t = (x + 30.0) / 60.0;
            ((1.0 - t) * exact.ends[0].powi(2) + t * exact.ends[1].powi(2)).sqrt()
        };
        made.rows.push(Row {
            quantity: format!("M0 = {} kN mm: largest |sigma_z + p| on the contact, |x| < 25 mm", 1e-3 * moment),
            unit: "MPa",
            reference: Some(0.0),
            ours: off(&body, 100.0, [-25.0, 25.0], |x, s| s.zz + wanted(x)),
            note: if moment == 0.0 { "uniform 1.66667 MPa, as the paper says".into() } else { "p of (40) in closed form".into() },
            ..Row::default()
        });
    }
    made.remarks.push(CLIPPED.into());
    Ok(made)
}

/// Figure 26.
pub(super) fn ring() -> Result<Made, Fault> {
    let mut made = Made::default();
    let solved = with_fields(annulus::SCENE, &["optimum.functional=wear-power", "optimum.q=1", "check=false"])?;
    made.ran(&solved);
    let body = upper(&solved);
    type Pick = fn(&Stress) -> f64;
    let pictures: [(&str, &str, Pick); 4] = [
        ("sigma-r", "\u{3c3}r", |s| s.xx),
        ("sigma-z", "\u{3c3}z", |s| s.zz),
        ("tau-phi-z", "\u{3c4}\u{3c6}z", |s| s.yz),
        ("von-mises", "equivalent \u{3c3}e (von Mises)", |s| s.von_mises()),
    ];
    for (name, word, pick) in pictures {
        draw(&mut made, name, &format!("Annular punch, q = 1, a = b = 1: {word} (MPa)"), &body, pick);
    }
    let inside = [RADII[0] + 10.0, RADII[1] - 10.0];
    let rows: [(&str, f64, f64); 3] = [
        ("largest |sigma_z + p| on the contact", 50.0, off(&body, 50.0, inside, |r, s| s.zz + ring_pressure(1.0, r))),
        (
            "largest ||tau_phi z| - mu p| on the contact",
            50.0,
            off(&body, 50.0, inside, |r, s| s.yz.abs() - 0.25 * ring_pressure(1.0, r)),
        ),
        ("largest |sigma_z + 100 MPa| on top", 100.0, off(&body, 100.0, inside, |_, s| s.zz + 100.0)),
    ];
    for (quantity, _, ours) in rows {
        made.rows.push(Row {
            quantity: format!("{quantity}, r = 30 to 110 mm"),
            unit: "MPa",
            reference: Some(0.0),
            ours,
            note: "the traction that is applied there; p = 7000 / r MPa".into(),
            ..Row::default()
        });
    }
    made.remarks.push(format!("{CLIPPED} The torsion by friction is part of the equivalent stress."));
    Ok(made)
}
