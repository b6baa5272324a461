//! The templates of a round contact as a few cells, to meet a body that is given by its own.

use hpfem::{Curve, Mesh, Quad};
use scene::Geometry;

use crate::couple::{Body, Couple};

/// The cells of a half-disc or rectangle; none of other bodies.
///
/// ```text
///   E--T---C---T--E     z = R
///   |  |   |   |  |
///    \\ D---A---D //     the arc from E over B and O to E
///      B---O---B
/// ```
pub(crate) fn as_cells(couple: &Couple, body: &Body) -> Option<Mesh> {
    if let Geometry::HalfDisc(disc) = &body.geometry {
        return half_disc(disc.radius.0, disc.centre.map(|c| c.0), couple.is_revolved()).ok();
    }
    let Geometry::Rectangle(rectangle) = &body.geometry else { return None };
    let (x, z) = (rectangle.x.map(|x| x.0), rectangle.z.map(|z| z.0));
    let corners = vec![[x[0], z[0]], [x[1], z[0]], [x[1], z[1]], [x[0], z[1]]];
    let names = [([0, 1], "bottom"), ([1, 2], "right"), ([3, 2], "top"), ([0, 3], "left")];
    Mesh::new(corners, &[Quad { corners: [0, 1, 2, 3], material: 0, layer: 0 }], &[], &names).ok()
}

fn half_disc(radius: f64, centre: [f64; 2], right_half: bool) -> Result<Mesh, hpfem::Error> {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
    let place = |x: f64, z: f64| [centre[0] + radius * x, centre[1] + radius * z];
    let half = 0.5_f64.sqrt();
    // O, A, C in the middle, then B, E, D, T of each side.
    let mut vertices = vec![place(0.0, -1.0), place(0.0, -0.5), place(0.0, 0.0)];
    let (mut quads, mut curves, mut names) = (Vec::new(), Vec::new(), vec![([0, 1], "centre"), ([1, 2], "centre")]);
    for side in if right_half { vec![1.0] } else { vec![1.0, -1.0] } {
        let b = vertices.len();
        let (e, d, t) = (b + 1, b + 2, b + 3);
        vertices.extend([place(side * half, -half), place(side, 0.0), place(0.45 * side, -0.45), place(0.5 * side, 0.0)]);
        let angle = |k: f64| if side > 0.0 { -FRAC_PI_2 + k * FRAC_PI_4 } else { -FRAC_PI_2 - k * FRAC_PI_4 };
        let arc = |from: f64, to: f64| Curve::Arc { centre, radius, from: angle(from), to: angle(to) };
        curves.extend([([0, b], arc(0.0, 1.0)), ([b, e], arc(1.0, 2.0))]);
        names.extend([([0, b], "arc"), ([b, e], "arc"), ([e, t], "top"), ([t, 2], "top")]);
        for corners in [[0, b, d, 1], [b, e, t, d], [1, d, t, 2]] {
            let [p, q, r, s] = corners;
            let corners = if side > 0.0 { corners } else { [q, p, s, r] };
            quads.push(Quad { corners, material: 0, layer: 0 });
        }
    }
    Mesh::new(vertices, &quads, &curves, &names)
}
