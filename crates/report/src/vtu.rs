//! Displacement and stress inside the bodies for VTK and ParaView: fields/*.vtu and fields/fields.pvd.
//!
//! Points belong to one cell each, so that nothing is averaged over cells. `bodyN.vtu` cuts every cell into flat pieces between its points;
//! `bodyN.lagrange.vtu` keeps it whole as a Lagrange quadrilateral or triangle (VTK types 70 and 69), on which the displacement is exact,
//! and the geometry and the stresses are interpolated in the points.

use base64::Engine;
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
    let points: usize = body.cells.iter().map(|cell| cell.position.len()).sum();
    let mut connectivity: Vec<i64> = Vec::new();
    let mut offsets: Vec<i64> = Vec::new();
    let mut degrees: Vec<f64> = Vec::new();
    let mut types: Vec<u8> = Vec::new();
    let mut first = 0;
    for cell in &body.cells {
        for nodes in elements(cell.grid, cut) {
            types.push(vtk_type(cell.grid, cut));
            connectivity.extend(nodes.iter().map(|node| (first + node) as i64));
            offsets.push(connectivity.len() as i64);
            degrees.push(cell.grid.degree as f64);
        }
        first += cell.position.len();
    }
    let mut out = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
         <UnstructuredGrid>\n<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{}\">\n",
        offsets.len()
    );
    out += "<PointData Vectors=\"displacement_mm\" Scalars=\"von_mises_MPa\">\n";
    let all = |value: &dyn Fn(&CellField, usize) -> f64| -> Vec<f64> {
        body.cells.iter().flat_map(|cell| (0..cell.position.len()).map(|row| value(cell, row)).collect::<Vec<f64>>()).collect()
    };
    let displacement: Vec<f64> = body.cells.iter().flat_map(|cell| cell.displacement.iter().flatten().copied()).collect();
    out += &array("displacement_mm", 3, &displacement);
    let [x, y] = if body.revolved { ["r", "hoop"] } else { ["x", "y"] };
    out += &array(&format!("sigma_{x}_MPa"), 1, &all(&|cell, row| cell.stress[row].xx));
    out += &array("sigma_z_MPa", 1, &all(&|cell, row| cell.stress[row].zz));
    out += &array(&format!("sigma_{y}_MPa"), 1, &all(&|cell, row| cell.stress[row].yy));
    out += &array(&format!("tau_{x}z_MPa"), 1, &all(&|cell, row| cell.stress[row].xz));
    if body.twisted {
        out += &array("tau_rphi_MPa", 1, &all(&|cell, row| cell.stress[row].xy));
        out += &array("tau_phiz_MPa", 1, &all(&|cell, row| cell.stress[row].yz));
    }
    out += &array("von_mises_MPa", 1, &all(&|cell, row| cell.stress[row].von_mises()));
    for k in 0..3 {
        out += &array(&format!("principal_{}_MPa", k + 1), 1, &all(&|cell, row| cell.stress[row].principal()[k]));
    }
    out += "</PointData>\n<CellData>\n";
    out += &array("degree", 1, &degrees);
    out += "</CellData>\n<Points>\n";
    let positions: Vec<f64> = body.cells.iter().flat_map(|cell| cell.position.iter().flat_map(|[x, z]| [*x, 0.0, *z])).collect();
    out += &array("position_mm", 3, &positions);
    out += "</Points>\n<Cells>\n";
    let bytes = |values: &[i64]| values.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<u8>>();
    out += &binary("Int64", "connectivity", 1, &bytes(&connectivity));
    out += &binary("Int64", "offsets", 1, &bytes(&offsets));
    out += &binary("UInt8", "types", 1, &types);
    out + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"
}

/// Nodes of the elements of a cell, as numbers of its points, in VTK's order.
fn elements(grid: CellGrid, cut: Cut) -> Vec<Vec<usize>> {
    match cut {
        Cut::Pieces => grid.pieces(grid.degree, grid.degree),
        Cut::Whole => vec![grid.lagrange()],
    }
}

/// VTK's number of the kind of these elements.
fn vtk_type(grid: CellGrid, cut: Cut) -> u8 {
    match (cut, grid.triangle) {
        (Cut::Pieces, false) => 9,
        (Cut::Pieces, true) => 5,
        (Cut::Whole, false) => 70,
        (Cut::Whole, true) => 69,
    }
}

fn array(name: &str, components: usize, values: &[f64]) -> String {
    let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    binary("Float64", name, components, &bytes)
}

/// An array in VTK's inline binary form: the number of bytes, then the bytes, as one base64 text.
fn binary(kind: &str, name: &str, components: usize, bytes: &[u8]) -> String {
    let mut data = (bytes.len() as u64).to_le_bytes().to_vec();
    data.extend_from_slice(bytes);
    let text = base64::engine::general_purpose::STANDARD.encode(&data);
    format!(
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"binary\">{text}</DataArray>\n"
    )
}
