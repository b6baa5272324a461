//! Displacement, stress and temperature inside the bodies for VTK and ParaView: fields/*.vtu and fields/fields.pvd.
//!
//! Points belong to one cell each, so that nothing is averaged over cells. `bodyN.vtu` cuts every cell into flat pieces between its points;
//! `bodyN.lagrange.vtu` keeps it whole as a Lagrange quadrilateral or triangle (VTK types 70 and 69), on which the displacement is exact,
//! and the geometry and the stresses are interpolated in the points.

use hpfem::{Vtu, VtuArray, VtuKind};
use wearshape::{BodyField, CellField, CellGrid, FieldFrame, Solution};

use crate::contact_line::ContactLine;

/// Flat pieces, or whole cells.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Cut {
    Pieces,
    Whole,
}

/// Names and texts of all files.
pub(crate) fn field_files(solution: &Solution) -> Vec<(String, String)> {
    let mut files = Vec::new();
    let mut series = Vec::new();
    for frame in &solution.fields {
        let line = pressed(solution, frame);
        for (number, body) in frame.bodies.iter().enumerate() {
            let moment = if frame.moment.is_empty() { String::new() } else { format!(".{}", frame.moment) };
            let name = format!("body{}{moment}", number + 1);
            series.push((frame.time, number, format!("{name}.vtu")));
            files.push((format!("fields/{name}.vtu"), vtu(body, line.as_ref(), Cut::Pieces)));
            files.push((format!("fields/{name}.lagrange.vtu"), vtu(body, line.as_ref(), Cut::Whole)));
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

/// The pressure along the contact surface at a moment.
fn pressed<'a>(solution: &'a Solution, frame: &FieldFrame) -> Option<ContactLine<'a>> {
    let profile = solution.profile.as_ref()?;
    let start = solution.running_in.as_ref().and_then(|run| run.steps.first());
    let pressure = if frame.moment.is_empty() { &profile.pressure } else { &start?.pressure };
    ContactLine::new(&profile.position, pressure)
}

fn vtu(body: &BodyField, line: Option<&ContactLine<'_>>, cut: Cut) -> String {
    let mut cells = Vec::new();
    let mut materials = Vec::new();
    let mut degrees = Vec::new();
    let mut first = 0;
    for cell in &body.cells {
        for nodes in elements(cell.grid, cut) {
            cells.push((vtk_kind(cell.grid, cut), nodes.into_iter().map(|node| first + node).collect()));
            degrees.push(cell.grid.degree as f64);
            materials.push(cell.material);
        }
        first += cell.position.len();
    }
    let positions = body.cells.iter().flat_map(|cell| cell.position.iter().flat_map(|[x, z]| [*x, 0.0, *z])).collect();
    let of_material = |value: fn(&scene::Material) -> f64| -> Vec<f64> {
        materials.iter().map(|index| body.materials.get(*index).map_or(f64::NAN, value)).collect()
    };
    let cell_arrays = vec![
        VtuArray::new("degree", 1, degrees),
        VtuArray::new("material", 1, materials.iter().map(|index| *index as f64).collect()),
        VtuArray::new("young_MPa", 1, of_material(|material| material.in_plane()[0])),
        VtuArray::new("poisson", 1, of_material(|material| material.in_plane()[1])),
    ];
    let mut point_arrays = point_arrays(body);
    point_arrays.extend(line.map(|line| VtuArray::new("contact_pressure_MPa", 1, contact_pressure(body, line))));
    let file = Vtu {
        points: VtuArray::new("position_mm", 3, positions),
        cells,
        point_arrays,
        cell_arrays,
        vectors: "displacement_mm".into(),
        scalars: "von_mises_MPa".into(),
    };
    file.text().expect("every point of a cell has its values")
}

/// The pressure at the points of the contact surface, interpolated in contact.csv; at all others there is none.
fn contact_pressure(body: &BodyField, line: &ContactLine<'_>) -> Vec<f64> {
    let at = |cell: &CellField, row: usize| match cell.touching.get(row) {
        Some(true) => line.at(cell.position[row]),
        _ => f64::NAN,
    };
    body.cells.iter().flat_map(|cell| (0..cell.position.len()).map(move |row| at(cell, row))).collect()
}

/// Displacement, stresses and, with heat, the temperature at all points.
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
    if body.cells.iter().all(|cell| cell.temperature.len() == cell.position.len()) && !body.cells.is_empty() {
        arrays.push(all("temperature_degC", &|cell, row| cell.temperature[row]));
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
