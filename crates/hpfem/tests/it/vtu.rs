//! Files for VTK: what is read back is the field.

use crate::common::*;
use base64::Engine;
use hpfem::*;

/// The bytes of an array behind their length.
fn bytes(text: &str, name: &str) -> Vec<u8> {
    let from = text.find(&format!("Name=\"{name}\"")).unwrap();
    let start = from + text[from..].find('>').unwrap() + 1;
    let end = start + text[start..].find('<').unwrap();
    let data = base64::engine::general_purpose::STANDARD.decode(&text[start..end]).unwrap();
    assert_eq!(u64::from_le_bytes(data[..8].try_into().unwrap()) as usize, data.len() - 8, "{name}");
    data[8..].to_vec()
}

fn numbers(text: &str, name: &str) -> Vec<f64> {
    bytes(text, name).chunks(8).map(|c| f64::from_le_bytes(c.try_into().unwrap())).collect()
}

fn integers(text: &str, name: &str) -> Vec<usize> {
    bytes(text, name).chunks(8).map(|c| i64::from_le_bytes(c.try_into().unwrap()) as usize).collect()
}

#[test]
fn a_field_is_written_as_one_lagrange_cell_a_cell_with_its_values_at_the_nodes() {
    let mesh = mixed([0, 1, 2, 3], Shape::Arcs, 0.0);
    let materials = steel();
    let supports = [support("left", Direction::First), support("left", Direction::Second)];
    for (kinematics, degree) in [(PLANE_STRAIN, 1), (PLANE_STRESS, 4), (Kinematics::Axisymmetric, 12), (Kinematics::Torsion, 3)] {
        let load = [vec![traction("right", |_| [3.0, 1.0])]];
        let held = if kinematics == Kinematics::Torsion { &supports[..1] } else { &supports[..] };
        let body = Body::new(problem(&mesh, degree, kinematics, &materials, held, &load, None)).unwrap();
        let field = body.field(&solved(&body, &[1.0])).unwrap();
        let text = field.vtu().unwrap().text().unwrap();
        assert_eq!(text, field.vtu().unwrap().text().unwrap());
        assert!(text.contains("<PointData Vectors=\"displacement\" Scalars=\"von_mises\">"), "{degree}");
        let (place, moved, stress) = (numbers(&text, "position"), numbers(&text, "displacement"), numbers(&text, "stress"));
        let (nodes, ends, types) = (integers(&text, "connectivity"), integers(&text, "offsets"), bytes(&text, "types"));
        let p = degree.min(10);
        assert_eq!(numbers(&text, "degree"), vec![degree as f64; mesh.cells.len()]);
        assert_eq!((place.len() / 3, moved.len() / 3, stress.len() / 6), (nodes.len(), nodes.len(), nodes.len()));
        let mut first = 0;
        for (c, cell) in mesh.cells.iter().enumerate() {
            let own = &nodes[first..ends[c]];
            let count = if cell.is_triangle() { (p + 1) * (p + 2) / 2 } else { (p + 1) * (p + 1) };
            assert_eq!((own.len(), types[c]), (count, if cell.is_triangle() { 69 } else { 70 }));
            // Corners come first, then the nodes of the edge between the first two.
            let at = |k: usize| [place[3 * own[k]], place[3 * own[k] + 2]];
            let near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-13;
            let corners = cell.vertices();
            assert!(corners.iter().enumerate().all(|(k, v)| near(at(k), mesh.vertices[*v])));
            for i in 1..p {
                let xi = 2.0 * i as f64 / p as f64 - 1.0;
                assert!(near(at(corners.len() + i - 1), mesh.map(c, xi, -1.0).0));
                let (node, state) = (own[corners.len() + i - 1], field.at(c, xi, -1.0).unwrap());
                let [u, w] = state.displacement;
                let torsion = kinematics == Kinematics::Torsion;
                let wanted = if torsion { [0.0, u, 0.0] } else { [u, 0.0, w] };
                assert!((0..3).all(|k| (moved[3 * node + k] - wanted[k]).abs() < 1e-18 + 1e-12 * u.abs().max(w.abs())));
                let s = state.stress;
                let wanted = if torsion { [0.0, 0.0, 0.0, s[0], s[1], 0.0] } else { [s[0], s[3], s[1], 0.0, 0.0, s[2]] };
                assert!((0..6).all(|k| (stress[6 * node + k] - wanted[k]).abs() < 1e-9));
            }
            first = ends[c];
        }
        assert_eq!(first, nodes.len());
    }
}

#[test]
fn arrays_and_cells_that_do_not_fit_are_refused_by_name() {
    let square = || Vtu {
        points: VtuArray::new("place", 3, vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0]),
        cells: vec![(VtuKind::Quadrilateral, vec![0, 1, 2, 3])],
        point_arrays: vec![VtuArray::new("p < \"q\" & r", 1, vec![1.0, 2.0, 3.0, 4.0])],
        cell_arrays: vec![VtuArray::new("tensor", 6, vec![0.0; 6])],
        ..Vtu::default()
    };
    let text = square().text().unwrap();
    assert!(
        text.contains("<PointData>\n<DataArray type=\"Float64\" Name=\"p &lt; &quot;q&quot; &amp; r\" NumberOfComponents=\"1\""),
        "{text}"
    );
    let changed = |change: &dyn Fn(&mut Vtu)| {
        let mut vtu = square();
        change(&mut vtu);
        vtu.text().unwrap_err()
    };
    let fault = |change: &dyn Fn(&mut Vtu)| match changed(change) {
        Error::Count { what, given, expected } => (what, given, expected),
        other => panic!("{other:?}"),
    };
    assert_eq!(fault(&|v| v.points.components = 2), ("components of positions".into(), 2, 3));
    assert_eq!(fault(&|v| v.points.values.push(0.0)), ("values of \"place\"".into(), 13, 12));
    assert_eq!(fault(&|v| v.point_arrays[0].values.push(0.0)), ("values of \"p < \"q\" & r\"".into(), 5, 4));
    assert_eq!(fault(&|v| v.cell_arrays[0].values.truncate(1)), ("values of \"tensor\"".into(), 1, 6));
    let beyond = Error::Beyond { by: "cell 0".into(), what: "point", index: 4, count: 4 };
    assert_eq!(changed(&|v| v.cells[0].1[2] = 4), beyond);
    assert_eq!(fault(&|v| v.cells[0].0 = VtuKind::Triangle), ("points of cell 0".into(), 4, 3));
    assert_eq!(fault(&|v| v.cells[0].0 = VtuKind::LagrangeTriangle), ("points of cell 0".into(), 4, 3));
    assert_eq!(fault(&|v| v.cells[0] = (VtuKind::LagrangeQuadrilateral, vec![0, 1, 2])), ("points of cell 0".into(), 3, 4));
}
