//! Triangles beside quadrilaterals: geometry, refinement, grading towards a corner, points found by their position.

use crate::common::*;
use crate::exact::Exact;
use crate::lshape::{ENERGY, energy, l_shape};
use approx::assert_abs_diff_eq;
use hpfem::*;

/// Every quadrilateral cut into two triangles along the diagonal from its first corner.
fn cut(mesh: &Mesh) -> Mesh {
    let halves = |c: &Cell| {
        let [p, q, r, s] = c.corners;
        [[p, q, r, r], [p, r, s, s]].map(|corners| Quad { corners, material: c.material, layer: c.layer })
    };
    let cells: Vec<Quad> = mesh.cells.iter().flat_map(halves).collect();
    let curves: Vec<_> = mesh.edges.iter().map(|e| (e.vertices, e.curve)).collect();
    let names: Vec<_> =
        mesh.edges.iter().flat_map(|e| e.tags.iter().map(|t| (e.vertices, mesh.boundaries[*t].as_str()))).collect();
    Mesh::new(mesh.vertices.clone(), &cells, &curves, &names).unwrap()
}

/// Area by the divergence theorem over the boundary "all".
fn area(mesh: &Mesh) -> f64 {
    let rule = gauss(20);
    let sides = mesh.edge_cells();
    let edge = |e: usize| {
        let (cell, local) = sides[e][0];
        let curve = mesh.local_curve(cell, local);
        let turn = if local < 2 { 0.5 } else { -0.5 };
        let at = |t: f64| {
            let (x, d) = (curve.point(t), curve.derivative(t));
            turn * (x[0] * d[1] - x[1] * d[0])
        };
        rule.points.iter().zip(&rule.weights).map(|(t, w)| w * at(*t)).sum::<f64>()
    };
    mesh.boundary("all").unwrap().into_iter().map(edge).sum()
}

#[test]
fn refinement_of_mixed_meshes_keeps_shape_names_and_the_kinds_of_cells() {
    let mesh = mixed(TURNS[6], Shape::Arcs, 0.0);
    let triangles = |m: &Mesh| m.cells.iter().filter(|c| c.is_triangle()).count();
    assert_eq!((mesh.cells.len(), triangles(&mesh)), (6, 4));
    let fine = mesh.refined().unwrap().refined().unwrap();
    assert_eq!((fine.cells.len(), triangles(&fine), fine.boundary("top").unwrap().len()), (96, 64, 8));
    assert_abs_diff_eq!(area(&mesh), area(&fine), epsilon = 1e-12);
    // Vertex 1 belongs to one quadrilateral and two triangles: each cut of a triangle leaves a triangle and a quadrilateral.
    let graded = mesh.refined_towards(&[1], 0.2, 3).unwrap();
    assert_eq!((graded.cells.len(), triangles(&graded)), (6 + 3 * (2 + 1 + 1), 4));
    assert_eq!(graded.cells.iter().map(|c| c.layer).max(), Some(3));
    assert_abs_diff_eq!(area(&mesh), area(&graded), epsilon = 1e-12);
}

#[test]
fn points_of_curved_triangles_are_found_by_their_position_and_the_map_has_its_derivative() {
    let exact = Exact { kinematics: PLANE_STRAIN, material: Material::isotropic(1.7, 0.28).unwrap() };
    let materials = [exact.material];
    for shape in [Shape::Arcs, Shape::Polynomial(4)] {
        let mesh = mixed(TURNS[4], shape, 0.0);
        let load = [vec![traction("all", move |p| exact.traction(p))]];
        let body = Body::new(problem(&mesh, 4, PLANE_STRAIN, &materials, &[], &load, Some("top"))).unwrap();
        let field = body.field(&solved(&body, &[1.0])).unwrap();
        for cell in 0..mesh.cells.len() {
            for (xi, eta) in sample_points() {
                let x = field.position(cell, xi, eta);
                let (found, a, b) = field.locate(x).unwrap();
                let y = field.position(found, a, b);
                assert!((x[0] - y[0]).hypot(x[1] - y[1]) < 1e-9, "{x:?} {y:?}");
                // The displacement is continuous, whichever of the neighbours was found.
                let (u, v) = (field.at(cell, xi, eta).unwrap().displacement, field.at(found, a, b).unwrap().displacement);
                assert!((u[0] - v[0]).hypot(u[1] - v[1]) < 1e-8, "{x:?}");
                let h = 1e-6;
                let (s, t) = (xi.clamp(-1.0 + h, 1.0 - h), eta.clamp(-1.0 + h, 1.0 - h));
                let d = mesh.map(cell, s, t).1;
                for i in 0..2 {
                    let slope = |a: [f64; 2], b: [f64; 2]| (a[i] - b[i]) / (2.0 * h);
                    let at = |s, t| mesh.map(cell, s, t).0;
                    assert_abs_diff_eq!(d[i][0], slope(at(s + h, t), at(s - h, t)), epsilon = 1e-8);
                    assert_abs_diff_eq!(d[i][1], slope(at(s, t + h), at(s, t - h)), epsilon = 1e-8);
                }
            }
        }
        assert!(matches!(field.locate([10.0, 0.0]), Err(Error::OutsideMesh { .. })));
    }
}

#[test]
fn the_singular_corner_of_a_mesh_of_triangles_is_found_and_its_layers_converge_exponentially() {
    let mesh = cut(&l_shape());
    let materials = [Material::isotropic(1.0, 0.3).unwrap()];
    let found = singular_vertices(&mesh, PLANE_STRAIN, &materials, &[], &[]).unwrap();
    assert_eq!(found.iter().map(|s| s.vertex).collect::<Vec<_>>(), [0]);
    assert_abs_diff_eq!(found[0].exponent, 0.544483736782464, epsilon = 1e-9);
    let mut errors = Vec::new();
    let mut roots = Vec::new();
    for p in 2..=10 {
        let graded = mesh.refined_towards(&[0], 0.15, p).unwrap();
        let degrees = graded.cells.iter().map(|c| (p + 1 - c.layer.min(p)).max(2)).collect();
        let (u, unknowns) = energy(&graded, degrees);
        errors.push((1.0 - u / ENERGY).abs().sqrt());
        roots.push((unknowns as f64).cbrt());
    }
    let rate = (errors[0] / errors[7]).ln() / (roots[7] - roots[0]);
    assert!(rate > 0.5, "rate {rate:.2}: {errors:?}");
    assert!(errors[8] < 1e-4, "{errors:?}");
    // The adaptive driver refines and grades triangles by itself.
    let (level, degrees) = graded_level(&mesh, &found, 5).unwrap();
    assert!(level.cells.iter().any(Cell::is_triangle) && degrees.len() == level.cells.len());
}

#[test]
fn the_interface_operator_of_a_kept_boundary_with_triangles_knows_the_rigid_motions_and_the_energy_of_quadrilaterals() {
    let materials = steel();
    let load = [vec![traction("left", |p| [40.0 * p.position[1], -15.0])]];
    let energy = |mesh: &Mesh| {
        let body = Body::new(problem(mesh, 14, PLANE_STRAIN, &materials, &[], &load, Some("right"))).unwrap();
        let interface = &body.interface;
        assert_eq!(interface.rigid_modes.ncols(), 3);
        let residual = &interface.stiffness * &interface.rigid_modes;
        assert!(residual.norm_max() < 1e-10 * interface.stiffness.norm_max() * interface.rigid_modes.norm_max());
        // The energy of one and the same displacement of the kept boundary, the rest following freely.
        let n = interface.stiffness.nrows();
        let places: Vec<_> = (0..interface.trace.edges.len()).flat_map(|e| [-1.0, -0.3, 0.4, 1.0].map(|t| (e, t))).collect();
        assert_eq!(interface.trace.component_matrix(&places, |_| [1.0, 0.0]).ncols(), n);
        let u = faer::Mat::from_fn(n, 1, |i, _| if i < 12 { 1e-4 / (1.0 + i as f64) } else { 0.0 });
        (u.transpose() * &interface.stiffness * &u)[(0, 0)]
    };
    let (quads, triangles) = (energy(&patch(TURNS[4], Shape::Arcs, 0.0)), energy(&mixed(TURNS[4], Shape::Arcs, 0.0)));
    assert!((triangles / quads - 1.0).abs() < 1e-4, "{quads} {triangles}");
}
