//! Displacement and stress inside the bodies for VTK and ParaView: fields/*.vtu and fields/fields.pvd.
//!
//! Points belong to one cell each, so that nothing is averaged over cells. `bodyN.vtu` cuts every cell into flat pieces between its points;
//! `bodyN.lagrange.vtu` keeps it whole as a Lagrange quadrilateral or triangle (VTK types 70 and 69), on which the displacement is exact,
//! and the geometry and the stresses are interpolated in the points.

use hpfem::{Vtu, VtuArray, VtuKind};
use wearshape::{BodyField, CellField, CellGrid, FieldFrame};

/// Flat pieces, or whole cells.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Cut {
    Pieces,
    Whole,
}

/// Names and texts of all files.
pub(crate) fn field_files(frames: &[FieldFrame]) -> Vec<(String, String)> {
    let mut files = Vec::new();
    let mut series = Vec::new();
    for frame in frames {
        for (number, body) in frame.bodies.iter().enumerate() {
            let moment = if frame.moment.is_empty() { String::new() } else { format!(".{}", frame.moment) };
            let name = format!("body{}{moment}", number + 1);
            series.push((frame.time, number, format!("{name}.vtu")));
            files.push((format!("fields/{name}.vtu"), vtu(body, Cut::Pieces)));
            files.push((format!("fields/{name}.lagrange.vtu"), vtu(body, Cut::Whole)));
        }
    }
    if !series.is_empty() {
        series.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        files.push(("fields/fields.pvd".into(), collection(&series)));
    }
    files
}

fn collection(series: &[(f64, usize, String)]) -> String {
    let mut out = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n",
    );
    for (time, body, file) in series {
        out += &format!("<DataSet timestep=\"{time}\" group=\"\" part=\"{body}\" name=\"body{}\" file=\"{file}\"/>\n", body + 1);
    }
    out + "</Collection>\n</VTKFile>\n"
}

fn vtu(body: &BodyField, cut: Cut) -> String {
    let mut cells = Vec::new();
    let mut degrees = Vec::new();
    let mut first = 0;
    for cell in &body.cells {
        for nodes in elements(cell.grid, cut) {
            cells.push((vtk_kind(cell.grid, cut), nodes.into_iter().map(|node| first + node).collect()));
            degrees.push(cell.grid.degree as f64);
        }
        first += cell.position.len();
    }
    let positions = body.cells.iter().flat_map(|cell| cell.position.iter().flat_map(|[x, z]| [*x, 0.0, *z])).collect();
    let file = Vtu {
        points: VtuArray::new("position_mm", 3, positions),
        cells,
        point_arrays: point_arrays(body),
        cell_arrays: vec![VtuArray::new("degree", 1, degrees)],
        vectors: "displacement_mm".into(),
        scalars: "von_mises_MPa".into(),
    };
    file.text().expect("every point of a cell has its values")
}

/// Displacement and stresses at all points.
fn point_arrays(body: &BodyField) -> Vec<VtuArray> {
    let all = |name: &str, value: &dyn Fn(&CellField, usize) -> f64| -> VtuArray {
        let of = |cell: &CellField| (0..cell.position.len()).map(|row| value(cell, row)).collect::<Vec<f64>>();
        VtuArray::new(name, 1, body.cells.iter().flat_map(of).collect())
    };
    let displacement = body.cells.iter().flat_map(|cell| cell.displacement.iter().flatten().copied()).collect();
    let [x, y] = if body.revolved { ["r", "hoop"] } else { ["x", "y"] };
    let mut arrays = vec![
        VtuArray::new("displacement_mm", 3, displacement),
        all(&format!("sigma_{x}_MPa"), &|cell, row| cell.stress[row].xx),
        all("sigma_z_MPa", &|cell, row| cell.stress[row].zz),
        all(&format!("sigma_{y}_MPa"), &|cell, row| cell.stress[row].yy),
        all(&format!("tau_{x}z_MPa"), &|cell, row| cell.stress[row].xz),
    ];
    if body.twisted {
        arrays.push(all("tau_rphi_MPa", &|cell, row| cell.stress[row].xy));
        arrays.push(all("tau_phiz_MPa", &|cell, row| cell.stress[row].yz));
    }
    arrays.push(all("von_mises_MPa", &|cell, row| cell.stress[row].von_mises()));
    arrays.extend((0..3).map(|k| all(&format!("principal_{}_MPa", k + 1), &|cell, row| cell.stress[row].principal()[k])));
    arrays
}

/// Nodes of the elements of a cell, as numbers of its points, in VTK's order.
fn elements(grid: CellGrid, cut: Cut) -> Vec<Vec<usize>> {
    match cut {
        Cut::Pieces => grid.pieces(grid.degree, grid.degree),
        Cut::Whole => vec![grid.lagrange()],
    }
}

/// Kind of these elements.
fn vtk_kind(grid: CellGrid, cut: Cut) -> VtuKind {
    match (cut, grid.triangle) {
        (Cut::Pieces, false) => VtuKind::Quadrilateral,
        (Cut::Pieces, true) => VtuKind::Triangle,
        (Cut::Whole, false) => VtuKind::LagrangeQuadrilateral,
        (Cut::Whole, true) => VtuKind::LagrangeTriangle,
    }
}
