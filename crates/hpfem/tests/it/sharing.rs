//! Similar cells share their condensed matrix.

use hpfem::*;
use std::f64::consts::{FRAC_PI_2, PI};

/// A ring graded towards two points of its outer arc, degrees falling into the layers: turned, mirrored and unequal edges.
fn ring(separate: bool) -> (Mesh, Vec<Material>) {
    let arc = |radius| Curve::Arc { centre: [3.0, -2.0], radius, from: FRAC_PI_2 + PI, to: FRAC_PI_2 - PI };
    let breaks = [-6.0, -4.0, -2.0, -1.0, 0.0, 1.0, 2.0, 4.0, 6.0].map(|t| t / 6.0);
    let names = [
        Named { side: Side::Bottom, range: None, name: "hub" },
        Named { side: Side::Top, range: Some([breaks[3], breaks[5]]), name: "contact" },
    ];
    let (bottom, top) = (arc(1.0), arc(2.0));
    let levels = &[0.0, 1.0];
    let coarse = Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels, closed: true, material: 0, names: &names }).unwrap();
    let ends = [-1.0, 1.0].map(|t| coarse.nearest_vertex(top.point(t / 6.0)));
    let mut mesh = coarse.refined_towards(&ends, 0.25, 3).unwrap();
    let steel = Material::new(1.7, 0.28).unwrap();
    if !separate {
        return (mesh, vec![steel]);
    }
    // A material of its own, with the same numbers, keeps a cell from sharing.
    mesh.cells.iter_mut().enumerate().for_each(|(i, c)| c.material = i);
    let materials = vec![steel; mesh.cells.len()];
    (mesh, materials)
}

fn operator(separate: bool, space: SpaceKind) -> (faer::Mat<f64>, f64) {
    let (mesh, materials) = ring(separate);
    let supports = [Support { boundary: "hub".into(), direction: Direction::First, value: 0.0 }];
    let load: Vec<LoadCase<'_>> =
        vec![vec![EdgeTraction { boundary: "contact".into(), traction: Box::new(|p| [p.position[1], 0.7]) }]];
    let body = Body::new(BodyProblem {
        mesh: &mesh,
        degrees: mesh.cells.iter().map(|c| 7 - c.layer).collect(),
        space,
        kinematics: Kinematics::PlaneStrain { thickness: 1.0 },
        materials: &materials,
        supports: &supports,
        rigid_edge: None,
        load_cases: &load,
        kept: Some("contact"),
    })
    .unwrap();
    let point = body.field(&body.solve(&[1.0])).unwrap().at(5, 0.3, -0.4);
    (body.interface.stiffness.clone(), point.displacement[1])
}

#[test]
fn sharing_matrices_between_similar_cells_leaves_the_operator_as_it_is() {
    for space in [SpaceKind::Tensor, SpaceKind::Trunk] {
        let ((shared, u), (separate, v)) = (operator(false, space), operator(true, space));
        let difference = (&shared - &separate).norm_max();
        assert!(difference < 1e-12 * separate.norm_max(), "{difference:.1e}");
        assert!((u - v).abs() < 1e-9 * v.abs(), "{u} {v}");
    }
}
