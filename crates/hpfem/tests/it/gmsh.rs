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
        let field = body.field(&body.solve(&[1.0])).unwrap();
        let v = file.mesh.nearest_vertex([1.0, 0.0]);
        let (cell, xi, eta) = field.locate(file.mesh.vertices[v]).unwrap();
        // u_r(a) = (1 + nu)/E (A (1 - 2 nu) a + B / a), A = 50/3, B = 200/3.
        let exact = 1.3 / 210e3 * (50.0 / 3.0 * 0.4 + 200.0 / 3.0);
        let error = (field.at(cell, xi, eta).displacement[0] / exact - 1.0).abs();
        assert!(error < 0.3 * last, "order {order}: {error:.1e} after {last:.1e}");
        last = error;
    }
    assert!(last < 1e-5, "{last:.1e}");
}

#[test]
fn triangles_and_other_files_are_refused_with_a_remedy() {
    let error = GmshMesh::read(&file("triangles.msh")).unwrap_err();
    assert!(matches!(error, GmshError::ElementType { kind: 2 }) && error.to_string().contains("Recombine"), "{error}");
    assert!(matches!(GmshMesh::read(b""), Err(GmshError::Syntax { .. })));
    assert!(matches!(GmshMesh::read(b"solid block\n"), Err(GmshError::Syntax { .. })));
    let version = GmshMesh::read(b"$MeshFormat\n4 0 8\n$EndMeshFormat\n").unwrap_err();
    assert!(matches!(version, GmshError::Version { .. }), "{version}");
    let none = GmshMesh::read(b"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n").unwrap_err();
    assert!(matches!(none, GmshError::NoCells), "{none}");
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
    for dialect in DIALECTS {
        let sound = file(&format!("ring_2_{dialect}.msh"));
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
