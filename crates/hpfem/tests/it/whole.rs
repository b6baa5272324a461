//! Meshes that are not one body: found with their place, on straight and curved edges; sound ones pass.

use hpfem::*;

fn quad(corners: [usize; 4]) -> Quad {
    Quad { corners, material: 0, layer: 0 }
}

/// `n` times `n` squares of side 1; the vertices of the column in the middle once for each side if it is to be torn.
fn squares(n: usize, torn: bool) -> Mesh {
    let mut vertices: Vec<[f64; 2]> = (0..=n).flat_map(|i| (0..=n).map(move |j| [i as f64, j as f64])).collect();
    let middle = n / 2;
    let right = |i: usize, j: usize| if torn && i == middle && j > 0 { (n + 1) * (n + 1) + j - 1 } else { i * (n + 1) + j };
    if torn {
        vertices.extend((1..=n).map(|j| [middle as f64, j as f64]));
    }
    let mut quads = Vec::new();
    for i in 0..n {
        for j in 0..n {
            // Cells right of the middle have its second vertices; the lowest one is shared.
            let at = |a: usize, b: usize| if i >= middle { right(a, b) } else { a * (n + 1) + b };
            quads.push(quad([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
        }
    }
    Mesh::new(vertices, &quads, &[], &[]).unwrap()
}

#[test]
fn a_hundred_thousand_cells_are_checked_and_a_torn_column_is_found() {
    assert_eq!(squares(320, false).check_whole(), Ok(()));
    let Err(Error::TouchingApart { x, z, .. }) = squares(320, true).check_whole() else { panic!("not found") };
    assert!(x == 160.0 && z > 0.0, "({x}, {z})");
}

#[test]
fn a_hanging_vertex_is_found_on_lines_arcs_and_polynomials() {
    // One cell below, its upper edge a curve from (-1, 0) to (1, 0); two above, which share its middle.
    let arc = Curve::Arc {
        centre: [0.0, -1.0],
        radius: 2f64.sqrt(),
        from: 0.75 * std::f64::consts::PI,
        to: 0.25 * std::f64::consts::PI,
    };
    let polynomial = Curve::through(&[[-1.0, 0.0], [0.1, 0.3], [1.0, 0.0]]).unwrap();
    for curve in [Curve::Line { start: [-1.0, 0.0], end: [1.0, 0.0] }, arc, polynomial] {
        let cut = 0.2;
        let vertices =
            vec![[-1.0, -1.5], [1.0, -1.5], [1.0, 0.0], [-1.0, 0.0], curve.point(cut), [-1.0, 2.0], [0.2, 2.0], [1.0, 2.0]];
        let quads = [[0, 1, 2, 3], [3, 4, 6, 5], [4, 2, 7, 6]].map(quad);
        let curves = [([3, 2], curve), ([3, 4], curve.part(-1.0, cut)), ([4, 2], curve.part(cut, 1.0))];
        let mesh = Mesh::new(vertices, &quads, &curves, &[]).unwrap();
        let Err(Error::TouchingApart { vertex, cell, other, .. }) = mesh.check_whole() else { panic!("not found on {curve:?}") };
        assert_eq!((vertex, cell), (4, 0));
        assert!(other == 1 || other == 2);
    }
}

#[test]
fn pieces_that_share_a_vertex_or_nothing_are_found_and_cells_around_a_hole_pass() {
    let two = |off: f64| {
        let vertices = vec![
            [0.0, 0.0],
            [1.0, 0.0],
            [1.0, 1.0],
            [0.0, 1.0],
            [1.0 + off, 1.0],
            [2.0 + off, 1.0],
            [2.0 + off, 2.0],
            [1.0 + off, 2.0],
        ];
        let first = if off == 0.0 { 2 } else { 4 };
        Mesh::new(vertices, &[quad([0, 1, 2, 3]), quad([first, 5, 6, 7])], &[], &[]).unwrap()
    };
    for off in [0.0, 0.5] {
        assert!(matches!(two(off).check_whole(), Err(Error::Pieces { cell: 1, .. })), "{off}");
    }
    let circle = |radius| Curve::Arc { centre: [0.0; 2], radius, from: 0.0, to: std::f64::consts::TAU };
    let breaks: Vec<f64> = (0..=8).map(|i| f64::from(i) / 4.0 - 1.0).collect();
    let (bottom, top) = (circle(2.0), circle(1.0));
    let levels = [0.0, 0.5, 1.0];
    let ring =
        Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &levels, closed: true, material: 0, names: &[] }).unwrap();
    assert_eq!(ring.check_whole(), Ok(()));
    assert_eq!(ring.refined_towards(&[ring.nearest_vertex([1.0, 0.0])], 0.15, 12).unwrap().check_whole(), Ok(()));
}

/// A cell 2 x 1, clamped below, and one 1 x 1 on it that shares its left upper corner alone; its right lower one hangs, or is lifted.
fn hinged(lifted: f64) -> Result<Body, Error> {
    let vertices = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0], [1.0, 1.0 + lifted], [1.0, 2.0], [0.0, 2.0]];
    let mesh = Mesh::new(vertices, &[quad([0, 1, 2, 3]), quad([3, 4, 5, 6])], &[], &[([0, 1], "below")])?;
    let problem = BodyProblem::new(mesh, 3, Kinematics::PlaneStress { thickness: 1.0 });
    Body::new(problem.material(Material::isotropic(100.0, 0.3)?).clamp("below"))
}

#[test]
fn a_body_that_moves_like_a_hinge_is_told_where_a_vertex_hangs() {
    let error = hinged(0.0).err().unwrap();
    assert!(matches!(error, Error::TouchingApart { vertex: 4, cell: 0, other: 1, .. }), "{error}");
    let text = error.to_string();
    assert!(
        text.contains("(1.000000, 1.000000)") && text.contains("hangs on an edge") && text.contains("cut that edge"),
        "{text}"
    );
    let error = hinged(0.5).err().unwrap();
    assert!(matches!(error, Error::Pieces { cell: 1, .. }), "{error}");
}
