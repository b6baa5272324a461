//! The surface to machine, for machines: profile.csv, profile-spline.csv, profile.dxf.

use wearshape::{Machined, SurfacePoint};

use crate::dxf::{Drawing, dxf};
use crate::table::{numbers_row, table};

/// Names and texts of the files.
pub(crate) fn machined_files(machined: &Machined, title: &str) -> Vec<(&'static str, String)> {
    vec![("profile.csv", points(machined)), ("profile-spline.csv", spline(machined)), ("profile.dxf", drawing(machined, title))]
}

fn points(machined: &Machined) -> String {
    let row = |point: &SurfacePoint| {
        let ([x, z], [a, b], [nx, nz]) = (point.finished(), point.nominal, point.normal);
        numbers_row(&[point.s, x, z, 1e3 * point.gap, a, b, nx, nz])
    };
    let names = ["s_mm", "x_mm", "z_mm", "gap_um", "nominal_x_mm", "nominal_z_mm", "nx", "nz"];
    table(&names, machined.points.iter().map(row))
}

/// One row an interval: x, z and the gap are `c0 + c1 d + c2 d^2 + c3 d^3` with `d = s - from`.
fn spline(machined: &Machined) -> String {
    let spline = &machined.fit.spline;
    let names = ["from_s_mm", "to_s_mm", "x0", "x1", "x2", "x3", "z0", "z1", "z2", "z3", "gap0_mm", "gap1", "gap2", "gap3"];
    let pieces = spline.knots.windows(2).zip(&spline.pieces);
    table(&names, pieces.map(|(ends, piece)| numbers_row(&[ends, piece.concat().as_slice()].concat())))
}

fn drawing(machined: &Machined, title: &str) -> String {
    let spline = &machined.fit.spline;
    let place = |point: &SurfacePoint| {
        let [x, z] = point.finished();
        format!("x = {x:.6} mm, z = {z:.6} mm, gap = {:.4} um", (1e3 * point.gap).max(0.0))
    };
    let control: Vec<[f64; 2]> = spline.control_points().iter().map(|point| [point[0], point[1]]).collect();
    // Some readers take no knots below zero.
    let knots: Vec<f64> = spline.padded_knots().iter().map(|knot| knot - spline.knots[0]).collect();
    let notes = [
        title.to_string(),
        "finished surface of body 1 in the coordinates of the scene (x, z), mm".to_string(),
        format!("datum (least taken off): {}", place(&machined.datum)),
        format!("most taken off: {}", place(&machined.deepest)),
        format!("largest deviation from the computed surface: {:.1e} mm", machined.fit.deviation),
    ];
    dxf(&Drawing {
        notes: &notes,
        knots: &knots,
        control: &control,
        marks: &[("DATUM", machined.datum.finished()), ("MOST-TAKEN-OFF", machined.deepest.finished())],
    })
}
