//! The shapes of cells where the fields ask for them: at the ends of the contact surface, under a short contact, at the contact of a ring.

use hpfem::Mesh;
use meshing::{CONTACT, Couple, Cut, Extent, meshes};
use scene::LoadKind;

use crate::common::{DRUM, PLATE, PUNCH, SHOE, SHOE_CELLS, body, breaks, couple, extent, two_cells};

/// The couple of two geometries that touch at these edges.
fn pressed(first: (&str, &str), second: (&str, &str)) -> (Couple, Extent) {
    let first = body("body1", first.0, first.1, "left = ['x'], right = ['x']");
    let couple = couple(first, body("body2", second.0, second.1, ""), "top", LoadKind::Pressure);
    let extent = extent(&couple);
    (couple, extent)
}

/// Lengths of the edges at the vertex next to a place: the longest over the shortest.
fn slenderness(mesh: &Mesh, x: [f64; 2]) -> f64 {
    let vertex = mesh.nearest_vertex(x);
    let around = mesh.edges.iter().filter(|edge| edge.vertices.contains(&vertex)).map(|edge| edge.curve.length());
    let [least, most] = around.fold([f64::INFINITY, 0.0], |[least, most], length| [length.min(least), length.max(most)]);
    most / least
}

/// Ends of the contact surface.
fn ends(mesh: &Mesh) -> [[f64; 2]; 2] {
    let edges = mesh.boundary(CONTACT).unwrap();
    let places = || edges.iter().flat_map(|e| mesh.edges[*e].vertices).map(|v| mesh.vertices[v]);
    let by_x = |a: &[f64; 2], b: &[f64; 2]| a[0].total_cmp(&b[0]);
    [places().min_by(by_x).unwrap(), places().max_by(by_x).unwrap()]
}

/// A pad ten times as long as high, alone and as cells, a lining on its back, a plate thinner than its punch, and layers of a ten thousandth of their
/// length on thick bodies, which are not cut into slices for their sake.
#[test]
fn cells_at_the_ends_of_a_thin_body_are_cut_until_they_are_no_longer_slender_in_both_bodies_alike() {
    let [layer, film] = ["rectangle = { x = [-30, 30], z = [0, 0.006] }", "rectangle = { x = [-70, 80], z = [-0.006, 0] }"];
    let pad = "rectangle = { x = [-30, 30], z = [0, 6] }";
    let sheet = "rectangle = { x = [-70, 80], z = [-6, 0] }";
    let plate = "rectangle = { x = [-70, 80], z = [-30, 0] }";
    let cells = two_cells([-30.0, 4.0, 30.0], [0.0, 6.0]);
    let cases = [
        ((pad, "bottom"), (plate, "top")),
        ((cells.as_str(), "bottom"), (plate, "top")),
        ((PUNCH, "bottom"), (sheet, "top")),
        ((SHOE_CELLS, "inner"), (DRUM, "outer")),
        ((layer, "bottom"), (PLATE, "top")),
        ((PUNCH, "bottom"), (film, "top")),
    ];
    for (first, second) in cases {
        let (couple, extent) = pressed(first, second);
        for cut in [Cut::Plain, Cut::Shifted] {
            let [one, other] = meshes(&couple, extent, 0, cut).unwrap();
            for (mesh, end) in ends(&one).into_iter().flat_map(|end| [(&one, end), (&other, end)]) {
                let most = slenderness(mesh, end);
                assert!(most < 3.5, "{first:?} {second:?} {cut:?}: {most}");
            }
            let [own, faced] = [&one, &other].map(|mesh| breaks(&couple, extent, mesh));
            assert_eq!(own.len(), faced.len());
            assert!(own.iter().zip(&faced).all(|(a, b)| (a - b).abs() < 1e-9 * (own[own.len() - 1] - own[0])));
        }
    }
}

/// Where a lining ends on its back the fields are singular too, and cuts through the lining go on through the back.
#[test]
fn cells_of_the_back_are_no_longer_slender_where_a_thin_lining_ends_on_it() {
    for bond in [205.0, 201.0, 200.3, 200.03] {
        let shoe = SHOE_CELLS.replace("radius = 210", &format!("radius = {bond}"));
        for drum in [DRUM, "ring = { inner = 198, outer = 200 }"] {
            let (couple, extent) = pressed((&shoe, "inner"), (drum, "outer"));
            for cut in [Cut::Plain, Cut::Shifted] {
                let [one, other] = meshes(&couple, extent, 0, cut).unwrap();
                for degrees in [-30.0_f64, 30.0] {
                    let [sine, cosine] = [degrees.to_radians().sin(), degrees.to_radians().cos()];
                    let most = slenderness(&one, [bond * sine, bond * cosine]);
                    assert!(most < 4.5, "{bond} {drum} {cut:?}: {most}");
                }
                assert_eq!(breaks(&couple, extent, &one).len(), breaks(&couple, extent, &other).len());
            }
        }
    }
}

/// What a plate is longer than its punch by, from less than the cells at the ends to much more, in thick bodies and thin ones; away from the origin, where
/// coordinates have no digits for cells much smaller than they need to be.
#[test]
fn a_plate_that_stands_out_a_little_is_meshed_however_thin_the_bodies_are() {
    for [height, depth] in [[100.0, 100.0], [0.06, 100.0], [100.0, 0.06], [0.06, 0.06]] {
        for out in [0.003, 0.03, 0.1, 0.2, 0.5, 1.0, 10.0] {
            let punch = format!("rectangle = {{ x = [-30, 30], z = [100, {}] }}", 100.0 + height);
            let plate = format!("rectangle = {{ x = [-{}, 60], z = [{}, 100] }}", 30.0 + out, 100.0 - depth);
            let punch = body("body1", &punch, "bottom", "left = ['x'], right = ['x']");
            let couple = couple(punch, body("body2", &plate, "top", "bottom = ['x', 'z']"), "top", LoadKind::Pressure);
            let extent = extent(&couple);
            let [one, other] = meshes(&couple, extent, 16, Cut::Plain).unwrap();
            let [own, faced] = [&one, &other].map(|mesh| breaks(&couple, extent, mesh));
            assert_eq!(own.len(), faced.len(), "{height} {depth} {out}");
        }
    }
}

/// A pad whose lowest cells are 1/27 as high as long, which takes just two cuts (the second at 1/6, of which half is 1/3): round-off of its lengths takes
/// no third.
#[test]
fn cuts_beside_the_ends_do_not_hang_on_round_off() {
    for k in 1..40 {
        let [half, height, far, deep] = [27.0, 2.0, 80.0, 60.0].map(|length| length * 0.1 * f64::from(k));
        let pad = format!("rectangle = {{ x = [-{half}, {half}], z = [0, {height}] }}");
        let plate = format!("rectangle = {{ x = [-{far}, {far}], z = [-{deep}, 0] }}");
        let (couple, extent) = pressed((&pad, "bottom"), (&plate, "top"));
        let [one, _] = meshes(&couple, extent, 0, Cut::Plain).unwrap();
        assert_eq!(one.boundary(CONTACT).unwrap().len(), 3 + 2 * 2, "{k}");
    }
}

/// The cells of a thick shoe and of a punch are as they were.
#[test]
fn cells_at_the_ends_that_are_not_slender_stay() {
    let cases = [((SHOE, "inner"), (DRUM, "outer"), 2), ((PUNCH, "bottom"), (PLATE, "top"), 3)];
    for (first, second, pieces) in cases {
        let (couple, extent) = pressed(first, second);
        let [one, _] = meshes(&couple, extent, 0, Cut::Plain).unwrap();
        assert_eq!(one.boundary(CONTACT).unwrap().len(), pieces);
    }
}

/// Under a contact of a hundredth of the surface, on a plate that is high and on one that is not.
#[test]
fn cells_under_a_short_contact_are_as_long_as_high() {
    for plate in [PLATE, "rectangle = { x = [-70, 80], z = [-600, 0] }"] {
        let (couple, extent) = pressed((PUNCH, "bottom"), (plate, "top"));
        for mesh in meshes(&couple, extent, 0, Cut::Ends(&[-0.01, 0.01])).unwrap() {
            let most = slenderness(&mesh, [0.0, 0.0]);
            assert!(most < 2.0, "{plate}: {most}");
        }
    }
}

/// Cells grow from the contact inwards, on a shaft and on the bore of a hub.
#[test]
fn the_lowest_cells_of_a_ring_are_at_its_contact() {
    let shaft = "ring = { inner = 40, outer = 200 }";
    let (couple, extent) = pressed((SHOE_CELLS, "inner"), (shaft, "outer"));
    let [_, mesh] = meshes(&couple, extent, 0, Cut::Plain).unwrap();
    let mut radii: Vec<f64> = mesh.vertices.iter().map(|x| x[0].hypot(x[1])).collect();
    radii.sort_by(f64::total_cmp);
    radii.dedup_by(|b, a| (*b - *a).abs() < 1e-9);
    let heights: Vec<f64> = radii.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert!(heights.len() > 1 && heights.windows(2).all(|pair| pair[1] < pair[0]), "{radii:?}");
}
