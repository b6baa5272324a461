//! Meshes and geometry as pictures of the cross-section.

use hpfem::{Curve, Mesh};
use report::Section;
use scene::Fault;

use crate::reproduce::made::Made;
use crate::reproduce::run::prepared;

/// Fill of body 1 and body 2.
const FILLS: [&str; 2] = ["#cfe3f3", "#eeeeee"];

/// Draws the meshes of both bodies of a scene as `mesh.svg` and their vertices as `mesh.csv`. Returns the number of cells.
pub(super) fn meshes(made: &mut Made, scene: &str, settings: &[String], title: &str) -> Result<usize, Fault> {
    let (problem, resolved, command) = prepared(scene, settings)?;
    let meshes = problem.meshes()?;
    if made.resolved.is_empty() {
        made.resolved = resolved;
    }
    made.commands.push(command);
    let points = || meshes.iter().flat_map(|mesh| mesh.edges.iter()).flat_map(|edge| polyline(&edge.curve));
    let range = |k: usize| points().fold([f64::MAX, f64::MIN], |[lo, hi], p| [lo.min(p[k]), hi.max(p[k])]);
    let section = Section::new(range(0), range(1), 0.0);
    let mut body = String::new();
    let mut rows = Vec::new();
    for (number, mesh) in meshes.iter().enumerate() {
        body += &mesh_svg(mesh, &section, FILLS[number]);
        for (cell, corners) in mesh.cells.iter().map(|cell| cell.vertices()).enumerate() {
            for (corner, vertex) in corners.iter().enumerate() {
                let [x, z] = mesh.vertices[*vertex].map(scene::number_text);
                rows.push(vec![(number + 1).to_string(), cell.to_string(), corner.to_string(), x, z]);
            }
        }
    }
    let names = if problem.scene().kinematics == Some(scene::Kinematics::Axisymmetric) { ["r", "z"] } else { ["x", "z"] };
    made.file("mesh.svg", section.picture(title, names, &body));
    made.file("mesh.csv", report::table(&["body", "cell", "corner", "x_mm", "z_mm"], rows));
    Ok(meshes.iter().map(|mesh| mesh.cells.len()).sum())
}

/// The cells of a mesh: filled, with their curved edges.
fn mesh_svg(mesh: &Mesh, section: &Section, fill: &str) -> String {
    let mut fills = String::new();
    for cell in 0..mesh.cells.len() {
        // Once around: edges 0 and 1 forwards, 2 and 3 backwards.
        let around = mesh.cells[cell].sides().flat_map(|(local, _)| {
            let curve = mesh.local_curve(cell, local);
            polyline(&if local < 2 { curve } else { curve.reversed() })
        });
        fills += &path(around.collect(), section, true);
    }
    let lines: String = mesh.edges.iter().map(|edge| path(polyline(&edge.curve), section, false)).collect();
    format!(
        "<path d=\"{fills}\" fill=\"{fill}\"/>\n<path d=\"{lines}\" fill=\"none\" stroke=\"#2b4a63\" stroke-width=\"0.7\"/>\n"
    )
}

fn polyline(curve: &Curve) -> Vec<[f64; 2]> {
    let pieces = if curve.is_straight() { 1 } else { 12 };
    (0..=pieces).map(|i| curve.point(2.0 * f64::from(i) / f64::from(pieces) - 1.0)).collect()
}

fn path(points: Vec<[f64; 2]>, section: &Section, closed: bool) -> String {
    let mut out = String::new();
    for (number, point) in points.into_iter().enumerate() {
        let [px, py] = section.place(point);
        out += &format!("{}{px:.1} {py:.1}", if number == 0 { "M" } else { "L" });
    }
    if closed { out + "Z" } else { out }
}
