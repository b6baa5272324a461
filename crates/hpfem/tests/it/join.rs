//! Two meshes made one: exact fields run through the joint, and everything that does not fit is refused by place.

use crate::classics::rectangle;
use crate::common::*;
use approx::assert_relative_eq;
use hpfem::*;
use std::f64::consts::PI;

/// The ring sector between two radii over the angles from 0 to a quarter turn, cut at the angles `breaks`.
fn sector([inner, outer]: [f64; 2], breaks: &[f64], material: usize) -> Mesh {
    let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: 0.5 * PI, to: 0.0 };
    let named = |side, name| Named { side, range: None, name };
    let names = [named(Side::Bottom, "inner"), named(Side::Top, "outer"), named(Side::Left, "x0"), named(Side::Right, "z0")];
    let (bottom, top) = (arc(inner), arc(outer));
    Mesh::ruled(&Ruled { bottom, top, breaks, levels: &[0.0, 1.0], closed: false, material, names: &names }).unwrap()
}

/// Radial displacement at the bore of a tube of two layers, 50 MPa inside, in plane strain.
fn bore(mesh: &Mesh, materials: &[Material]) -> f64 {
    let supports = [support("z0", Direction::Second), support("x0", Direction::First)];
    // The inner radius alone: the name is on the joint too.
    let load = [vec![traction("bore", |p| p.outward.map(|n| -50.0 * n))]];
    let body = Body::new(problem(mesh, 10, PLANE_STRAIN, materials, &supports, &load, None)).unwrap();
    let field = body.field(&solved(&body, &[1.0])).unwrap();
    let (cell, xi, eta) = field.locate([1.0, 0.0]).unwrap();
    field.at(cell, xi, eta).unwrap().displacement[0]
}

/// The sector with its inner side named anew.
fn with_bore(mut mesh: Mesh) -> Mesh {
    let inner = mesh.boundaries.iter_mut().find(|name| *name == "inner").unwrap();
    *inner = "bore".into();
    mesh
}

#[test]
fn a_tube_of_two_joined_sleeves_is_the_compound_cylinder() {
    let breaks = [-1.0, 0.1, 1.0];
    let sleeve = with_bore(sector([1.0, 1.5], &breaks, 0));
    let both = sleeve.join(&sector([1.5, 2.0], &breaks, 0), Joint::default()).unwrap();
    assert_eq!((both.cells.len(), both.vertices.len(), both.edges.len()), (4, 9, 12));
    assert_eq!(both.cells.iter().map(|c| c.material).collect::<Vec<_>>(), [0, 0, 1, 1]);
    // The vertices and cells of the first mesh keep their numbers, the shared edges both names.
    assert_eq!((&both.vertices[..6], &both.cells[..2]), (&sleeve.vertices[..], &sleeve.cells[..]));
    assert_eq!(both.boundaries, ["bore", "outer", "x0", "z0", "inner"]);
    let [inner, outer, x0] = ["inner", "outer", "x0"].map(|name| both.boundary(name).unwrap());
    assert!(inner.iter().all(|e| outer.contains(e)) && (inner.len(), outer.len(), x0.len()) == (2, 4, 2));

    // One material: Lame. u_r(a) = (1 + nu)/E (A (1 - 2 nu) a + B / a), A = 50/3, B = 200/3.
    let steel = Material::isotropic(210e3, 0.3).unwrap();
    assert_relative_eq!(bore(&both, &[steel, steel]), 1.3 / 210e3 * (50.0 / 3.0 * 0.4 + 200.0 / 3.0), max_relative = 1e-10);
    let one = sleeve.join(&sector([1.5, 2.0], &breaks, 0), Joint { material_offset: Some(0), ..Joint::default() }).unwrap();
    assert_relative_eq!(bore(&one, &[steel]), bore(&both, &[steel, steel]), max_relative = 1e-14);

    // Two materials: the pressure q between the sleeves from equal displacements at 1.5,
    // u = (1 + nu)/E ((1 - 2 nu) A r + B / r), A = (p a^2 - q b^2)/(b^2 - a^2), B = (p - q) a^2 b^2/(b^2 - a^2).
    let soft = Material::isotropic(70e3, 0.2).unwrap();
    let u = |m: Material, [p, q]: [f64; 2], [a, b]: [f64; 2], r: f64| {
        let d = b * b - a * a;
        let (big_a, big_b) = ((p * a * a - q * b * b) / d, (p - q) * a * a * b * b / d);
        let (young, poisson) = (m.young().unwrap(), m.poisson().unwrap());
        (1.0 + poisson) / young * ((1.0 - 2.0 * poisson) * big_a * r + big_b / r)
    };
    let gap = |q: f64| u(steel, [50.0, q], [1.0, 1.5], 1.5) - u(soft, [q, 0.0], [1.5, 2.0], 1.5);
    let q = gap(0.0) / (gap(0.0) - gap(1.0));
    assert_relative_eq!(bore(&both, &[steel, soft]), u(steel, [50.0, q], [1.0, 1.5], 1.0), max_relative = 1e-10);
}

#[test]
fn vertices_within_the_tolerance_are_merged_and_the_edges_there_follow() {
    let breaks = [-1.0, 0.1, 1.0];
    let sleeve = with_bore(sector([1.0, 1.5], &breaks, 0));
    let outer = sector([1.5, 2.0], &breaks, 0);
    let moved = outer.mapped(|[x, z]| [x + 3e-6, z + 4e-6]).unwrap();
    let error = sleeve.join(&moved, Joint::default()).unwrap_err();
    assert!(matches!(error, Error::NotTouching { distance, .. } if (distance - 5e-6).abs() < 1e-11), "{error}");
    let joint = Joint { tolerance: Some(1e-5), material_offset: Some(0) };
    let both = sleeve.join(&moved, joint).unwrap();
    assert_eq!((both.cells.len(), both.vertices.len()), (4, 9));
    let exact = 1.3 / 210e3 * (50.0 / 3.0 * 0.4 + 200.0 / 3.0);
    assert_relative_eq!(bore(&both, &steel()), exact, max_relative = 1e-5);
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let joint = Joint { tolerance: Some(tolerance), material_offset: None };
        assert!(matches!(sleeve.join(&outer, joint), Err(Error::OutOfRange { .. })));
    }
}

#[test]
fn meshes_that_do_not_meet_edge_on_edge_are_refused_by_place() {
    let square = rectangle([0.0, 1.0], [0.0, 1.0]);
    let join = |x: [f64; 2], z: [f64; 2]| square.join(&rectangle(x, z), Joint::default());
    assert_eq!(join([1.0, 2.0], [0.0, 1.0]).unwrap().vertices.len(), 6);
    let error = join([1.5, 2.0], [0.0, 1.0]).unwrap_err();
    assert!(matches!(error, Error::NotTouching { distance: 0.5, .. }), "{error}");
    // One corner is no connection.
    let error = join([1.0, 2.0], [1.0, 2.0]).unwrap_err();
    assert!(matches!(error, Error::NotTouching { distance: 0.0, .. }), "{error}");
    // Half an edge, with and without a shared corner.
    for z in [[0.0, 0.5], [-1.0, 0.5], [-1.0, 1.0], [0.25, 0.75], [-1.0, 2.0]] {
        let error = join([1.0, 2.0], z).unwrap_err();
        assert!(matches!(error, Error::HangingVertex { x, .. } if (x - 1.0).abs() < 1e-12), "{z:?}: {error}");
    }
    // On each other: in part, whole, one inside the other.
    for (x, z) in [([0.5, 1.5], [0.0, 1.0]), ([0.0, 1.0], [0.0, 1.0]), ([0.25, 0.75], [0.25, 0.75]), ([0.0, 1.0], [0.0, 0.5])] {
        let error = join(x, z).unwrap_err();
        let refused = matches!(
            error,
            Error::MeshesOverlap { .. }
                | Error::CellsOverlap { .. }
                | Error::Overlapping { .. }
                | Error::HangingVertex { .. }
                | Error::NotTouching { .. }
        );
        assert!(refused, "{x:?} {z:?}: {error}");
    }
    // Overlapping although an edge is shared: two cells on one side, and a cell in the corner of a bent row of cells.
    let row = rectangle([1.0, 2.0], [0.0, 1.0]).join(&square, Joint::default()).unwrap();
    let error = row.join(&square, Joint::default()).unwrap_err();
    assert!(matches!(error, Error::MeshesOverlap { .. } | Error::CellsOverlap { .. } | Error::Overlapping { .. }), "{error}");
}

#[test]
fn edges_that_run_differently_are_refused() {
    let breaks = [-1.0, 1.0];
    let inner = sector([1.0, 1.5], &breaks, 0);
    let mut outer = sector([1.5, 2.0], &breaks, 0);
    let e = outer.boundary("inner").unwrap()[0];
    // The polynomial of an edge of order 2 through the middle of the arc.
    let curve = outer.edges[e].curve;
    outer.edges[e].curve = Curve::through(&[-1.0, 0.0, 1.0].map(|t| curve.point(t))).unwrap();
    let error = inner.join(&outer, Joint::default()).unwrap_err();
    assert!(matches!(error, Error::CurvesDisagree { distance, .. } if distance > 1e-3), "{error}");
    // Given its circle back, it fits.
    let round = outer.with_outline("inner", Outline::Circle { centre: [0.0; 2], radius: 1.5 }).unwrap();
    assert_eq!(inner.join(&round, Joint::default()).unwrap().cells.len(), 2);
}

#[test]
fn a_vertex_with_two_partners_is_refused() {
    // A slit between two cells: the vertices of its faces lie on one place.
    let vertices = vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
    let quad = |corners| Quad { corners, material: 0, layer: 0 };
    let slit = Mesh::new(vertices, &[quad([0, 1, 4, 5]), quad([7, 2, 3, 6])], &[], &[]).unwrap();
    let on_top = rectangle([0.0, 1.0], [1.0, 2.0]);
    let error = on_top.join(&slit, Joint::default()).unwrap_err();
    assert!(matches!(error, Error::AmbiguousVertex { x: 1.0, z: 1.0, .. }), "{error}");
}
