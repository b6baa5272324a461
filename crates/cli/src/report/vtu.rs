//! Displacement and stress inside the bodies for VTK and ParaView: fields/*.vtu and fields/fields.pvd.
//!
//! Points belong to one cell each, so that nothing is averaged over cells. `bodyN.vtu` cuts every cell into flat quadrilaterals between
//! its points; `bodyN.lagrange.vtu` keeps it whole as a Lagrange quadrilateral (VTK type 70), on which the displacement is exact, and
//! the geometry and the stresses are interpolated in the points.

use base64::Engine;

use crate::body_field::{BodyField, CellField, FieldFrame};

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
            series.push((frame.time_s, number, format!("{name}.vtu")));
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
    let mut first = 0;
    for cell in &body.cells {
        for nodes in elements(cell.degree, cut) {
            connectivity.extend(nodes.iter().map(|node| (first + node) as i64));
            offsets.push(connectivity.len() as i64);
            degrees.push(cell.degree as f64);
        }
        first += cell.position.len();
    }
    let kind: u8 = if cut == Cut::Pieces { 9 } else { 70 };
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
    out += &binary("UInt8", "types", 1, &vec![kind; offsets.len()]);
    out + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"
}

/// Nodes of the elements of a cell, as rows of its grid, in VTK's order.
fn elements(degree: usize, cut: Cut) -> Vec<Vec<usize>> {
    let n = degree + 1;
    let at = |i: usize, j: usize| i + n * j;
    if cut == Cut::Pieces {
        let piece = |k: usize| {
            let (i, j) = (k % degree, k / degree);
            vec![at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
        };
        return (0..degree * degree).map(piece).collect();
    }
    // Corners, then the edges in the direction of growing coordinates, then the inside, the first coordinate fastest.
    let mut nodes = vec![at(0, 0), at(degree, 0), at(degree, degree), at(0, degree)];
    nodes.extend((1..degree).map(|i| at(i, 0)));
    nodes.extend((1..degree).map(|j| at(degree, j)));
    nodes.extend((1..degree).map(|i| at(i, degree)));
    nodes.extend((1..degree).map(|j| at(0, j)));
    nodes.extend((1..degree).flat_map(|j| (1..degree).map(move |i| at(i, j))));
    vec![nodes]
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

#[cfg(test)]
mod tests {
    use super::{Cut, elements};

    #[test]
    fn every_point_of_a_cell_is_a_node_of_its_lagrange_element_once() {
        for degree in 1..=16 {
            let mut nodes = elements(degree, Cut::Whole).concat();
            nodes.sort_unstable();
            assert_eq!(nodes, (0..(degree + 1) * (degree + 1)).collect::<Vec<_>>());
            assert_eq!(elements(degree, Cut::Pieces).len(), degree * degree);
        }
    }

    #[test]
    fn the_nodes_of_a_cubic_element_stand_in_vtk_order() {
        // 12 13 14 15
        //  8  9 10 11
        //  4  5  6  7
        //  0  1  2  3
        assert_eq!(elements(3, Cut::Whole), [[0, 3, 15, 12, 1, 2, 7, 11, 13, 14, 4, 8, 5, 6, 9, 10]]);
    }
}
