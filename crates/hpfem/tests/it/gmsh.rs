//! Gmsh files of every dialect, sound and broken.

use crate::common::*;
use hpfem::*;
use std::path::PathBuf;

fn file(name: &str) -> Vec<u8> {
    std::fs::read(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/meshes").join(name)).unwrap()
}

const DIALECTS: [&str; 4] = ["41", "41b", "22", "22b"];

#[test]
fn every_dialect_and_order_gives_the_same_ring_with_its_names() {
    for order in 1..=4 {
        let all = DIALECTS.map(|d| GmshMesh::read(&file(&format!("ring_{order}_{d}.msh"))).unwrap());
        for other in &all {
            assert_eq!(other.materials, ["steel"]);
            assert_eq!(other.mesh.cells.len(), 3);
            for (name, edges) in [("z0", 1), ("outer", 3), ("x0", 1), ("inner surface", 3)] {
                assert_eq!(other.mesh.boundary(name).unwrap().len(), edges);
            }
            // Text files have 16 digits.
            for (a, b) in other.mesh.vertices.iter().zip(&all[0].mesh.vertices) {
                assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-14);
            }
            for e in other.mesh.boundary("outer").unwrap() {
                let off = (0..=10).map(|i| {
                    let x = other.mesh.edges[e].curve.point(0.2 * f64::from(i) - 1.0);
                    (x[0].hypot(x[1]) - 2.0).abs()
                });
                // Interpolation error of an arc of 30 degrees.
                assert!(off.fold(0.0, f64::max) < [8e-2, 2e-3, 5e-4, 1e-5][order - 1], "order {order}");
            }
        }
        let error = all[0].mesh.boundary("hub").unwrap_err().to_string();
        assert!(error.contains("z0, outer, x0, inner surface"), "{error}");
    }
}

#[test]
fn the_thick_cylinder_on_a_gmsh_mesh_converges_to_lame_with_the_order_of_its_edges() {
    let materials = steel();
    let supports = [support("z0", Direction::Second), support("x0", Direction::First)];
    let load = [vec![traction("inner surface", |p| p.outward.map(|n| -50.0 * n))]];
    let mut last = f64::MAX;
    for order in 1..=4 {
        let file = GmshMesh::read(&file(&format!("ring_{order}_41.msh"))).unwrap();
        let body = Body::new(problem(&file.mesh, 8, PLANE_STRAIN, &materials, &supports, &load, None)).unwrap();
        let field = body.field(&solved(&body, &[1.0])).unwrap();
        let v = file.mesh.nearest_vertex([1.0, 0.0]);
        let (cell, xi, eta) = field.locate(file.mesh.vertices[v]).unwrap();
        // u_r(a) = (1 + nu)/E (A (1 - 2 nu) a + B / a), A = 50/3, B = 200/3.
        let exact = 1.3 / 210e3 * (50.0 / 3.0 * 0.4 + 200.0 / 3.0);
        let error = (field.at(cell, xi, eta).unwrap().displacement[0] / exact - 1.0).abs();
        assert!(error < 0.3 * last, "order {order}: {error:.1e} after {last:.1e}");
        last = error;
    }
    assert!(last < 1e-5, "{last:.1e}");
}

#[test]
fn the_thick_cylinder_on_gmsh_triangles_and_quadrilaterals_converges_with_the_order_of_its_edges() {
    let materials = steel();
    let supports = [support("z0", Direction::Second), support("x0", Direction::First)];
    let load = [vec![traction("outer", |p| p.outward.map(|n| -50.0 * n))]];
    for dialect in ["41", "22b"] {
        let mut last = f64::MAX;
        for order in 1..=4 {
            let file = GmshMesh::read(&file(&format!("mixed_{order}_{dialect}.msh"))).unwrap();
            let mesh = &file.mesh;
            let triangles = mesh.cells.iter().filter(|c| c.is_triangle()).count();
            assert_eq!((mesh.cells.len(), triangles, &file.materials[..]), (9, 6, &["steel".to_string()][..]));
            for (name, edges) in [("z0", 2), ("outer", 3), ("x0", 2), ("inner surface", 3)] {
                assert_eq!(mesh.boundary(name).unwrap().len(), edges);
            }
            let body = Body::new(problem(mesh, 8, PLANE_STRAIN, &materials, &supports, &load, None)).unwrap();
            let field = body.field(&solved(&body, &[1.0])).unwrap();
            let v = mesh.nearest_vertex([2.0, 0.0]);
            let (cell, xi, eta) = field.locate(mesh.vertices[v]).unwrap();
            // Pressure 50 on the outer radius 2: u_r = (1 + nu)/E (A (1 - 2 nu) r + B / r), A = -200/3, B = -200/3.
            let exact = -1.3 / 210e3 * (200.0 / 3.0) * (0.4 * 2.0 + 0.5);
            let error = (field.at(cell, xi, eta).unwrap().displacement[0] / exact - 1.0).abs();
            assert!(error < 0.3 * last, "order {order}: {error:.1e} after {last:.1e}");
            last = error;
        }
        assert!(last < 1e-5, "{last:.1e}");
    }
}

#[test]
fn a_mesh_of_triangles_alone_is_read() {
    let mesh = GmshMesh::read(&file("triangles.msh")).unwrap().mesh;
    assert!(mesh.cells.iter().all(Cell::is_triangle) && !mesh.cells.is_empty());
    let area = |c: &Cell| {
        let [a, b, c, _] = c.corners.map(|v| mesh.vertices[v]);
        0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]))
    };
    let total: f64 = mesh.cells.iter().map(area).sum();
    assert!((total - 0.5).abs() < 1e-12, "{total}");
}

#[test]
fn other_elements_and_other_files_are_refused_with_a_remedy() {
    let tetrahedron = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n1\n1 4 0 1 2 3 4\n$EndElements\n";
    let error = GmshMesh::read(tetrahedron.as_bytes()).unwrap_err();
    assert!(matches!(error, GmshError::ElementType { kind: 4 }) && error.to_string().contains("SaveAll"), "{error}");
    assert!(matches!(GmshMesh::read(b""), Err(GmshError::Syntax { .. })));
    assert!(matches!(GmshMesh::read(b"solid block\n"), Err(GmshError::Syntax { .. })));
    let version = GmshMesh::read(b"$MeshFormat\n4 0 8\n$EndMeshFormat\n").unwrap_err();
    assert!(matches!(version, GmshError::Version { .. }), "{version}");
    let none = GmshMesh::read(b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n").unwrap_err();
    assert!(matches!(none, GmshError::NoCells), "{none}");
}

/// The files of the fuzz target's minimized corpus, each behind its length in four bytes; see fuzz/fuzz_targets/gmsh.rs.
fn corpus() -> Vec<Vec<u8>> {
    let packed = file("gmsh.corpus");
    let (mut files, mut rest) = (Vec::new(), &packed[..]);
    while let Some((length, tail)) = rest.split_first_chunk::<4>() {
        let (one, tail) = tail.split_at(u32::from_le_bytes(*length) as usize);
        files.push(one.to_vec());
        rest = tail;
    }
    files
}

#[test]
fn the_corpus_of_the_fuzz_target_never_panics_whole_or_cut_or_changed() {
    let files = corpus();
    assert!(files.len() > 200);
    for mut bytes in files {
        // Short inputs that reach far into the reader; none is a whole mesh.
        assert!(GmshMesh::read(&bytes).is_err());
        for at in 0..bytes.len() {
            let _ = GmshMesh::read(&bytes[..at]);
            let old = std::mem::replace(&mut bytes[at], b'9');
            let _ = GmshMesh::read(&bytes);
            bytes[at] = old;
        }
    }
}

#[test]
fn files_cut_anywhere_and_files_with_any_byte_changed_never_panic() {
    let mut state = 0x2545_f491_4f6c_dd1d_u64;
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    };
    for name in DIALECTS.map(|d| format!("ring_2_{d}.msh")).into_iter().chain(["mixed_3_22b.msh".to_string()]) {
        let sound = file(&name);
        for end in 0..sound.len() {
            let _ = GmshMesh::read(&sound[..end]);
        }
        for _ in 0..4_000 {
            let mut broken = sound.clone();
            for _ in 0..=random() % 3 {
                let at = random() as usize % broken.len();
                broken[at] = random() as u8;
            }
            let _ = GmshMesh::read(&broken);
        }
    }
}

/// A row of two squares, and a cell that lies on the second one, between nodes whose tags are no numbers of vertices.
#[test]
fn an_edge_of_too_many_cells_is_named_by_the_nodes_of_the_file() {
    let file = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n6\n11 0 0 0\n12 1 0 0\n13 2 0 0\n24 0 1 0\n25 1 1 0\n26 2 1 0\n$EndNodes\n\
                $Elements\n3\n7 3 2 1 1 11 12 25 24\n8 3 2 1 1 12 13 26 25\n9 3 2 1 1 12 13 26 25\n$EndElements\n";
    let error = GmshMesh::read(file.as_bytes()).unwrap_err();
    assert!(matches!(error, GmshError::Overlapping { nodes: [a, b] } if a >= 11 && b >= 11), "{error}");
}

/// A square whose entity is in so many physical groups.
fn square_in_groups(groups: usize) -> String {
    let tags = vec!["1"; groups].join(" ");
    format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 0\n1 0 0 0 1 1 0 {groups} {tags} 0\n$EndEntities\n\
         $Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n\
         $Elements\n1 1 1 1\n2 1 3 1\n1 1 2 3 4\n$EndElements\n"
    )
}

#[test]
fn an_entity_in_more_groups_than_any_body_has_is_refused() {
    assert_eq!(GmshMesh::read(square_in_groups(100).as_bytes()).unwrap().materials, ["1"]);
    let error = GmshMesh::read(square_in_groups(60_000).as_bytes()).unwrap_err().to_string();
    assert!(error.contains("an entity is in 60000 physical groups, of at most 100"), "{error}");
}
