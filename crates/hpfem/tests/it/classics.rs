//! Closed-form solutions of the textbooks.

use crate::common::*;
use hpfem::*;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Quarter ring of radii 1 and 2 in the first quadrant, one cell, boundaries inner, outer, start (angle 90) and end (angle 0).
pub(crate) fn quarter_ring(cells: usize) -> Mesh {
    let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: FRAC_PI_2, to: 0.0 };
    let breaks: Vec<f64> = (0..=cells).map(|i| 2.0 * i as f64 / cells as f64 - 1.0).collect();
    let named = |side, name| Named { side, range: None, name };
    let names = [named(Side::Bottom, "inner"), named(Side::Top, "outer"), named(Side::Left, "start"), named(Side::Right, "end")];
    let region = Ruled {
        bottom: arc(1.0),
        top: arc(2.0),
        breaks: &breaks,
        levels: &[0.0, 1.0],
        closed: false,
        material: 0,
        names: &names,
    };
    Mesh::ruled(&region).unwrap()
}

/// Rectangle `[x0, x1] x [z0, z1]` of one cell with boundaries bottom, right, top, left.
pub(crate) fn rectangle(x: [f64; 2], z: [f64; 2]) -> Mesh {
    let vertices = vec![[x[0], z[0]], [x[1], z[0]], [x[1], z[1]], [x[0], z[1]]];
    let quad = Quad { corners: [0, 1, 2, 3], material: 0, layer: 0 };
    Mesh::new(vertices, &[quad], &[], &[([0, 1], "bottom"), ([1, 2], "right"), ([2, 3], "top"), ([3, 0], "left")]).unwrap()
}

/// Cartesian `[xx, zz, xz]` from polar `[rr, tt, rt]` at the angle of `x`.
pub(crate) fn cartesian(x: [f64; 2], [rr, tt, rt]: [f64; 3]) -> [f64; 3] {
    let angle = x[1].atan2(x[0]);
    let (s, c) = angle.sin_cos();
    [
        c * c * rr + s * s * tt - 2.0 * s * c * rt,
        s * s * rr + c * c * tt + 2.0 * s * c * rt,
        s * c * (rr - tt) + (c * c - s * s) * rt,
    ]
}

/// Errors of the stress for degrees in a range; the load is the exact traction on all the named boundaries.
fn errors(
    mesh: &Mesh,
    kinematics: Kinematics,
    boundaries: &[&str],
    kept: &str,
    degrees: std::ops::RangeInclusive<usize>,
    exact: impl Fn([f64; 2]) -> [f64; 4] + Copy + Send + Sync + 'static,
) -> Vec<f64> {
    let materials = steel();
    degrees
        .map(|p| {
            let loads = boundaries
                .iter()
                .map(|b| {
                    traction(b, move |q| {
                        let ([x, z, t, _], n) = (exact(q.position), q.outward);
                        if kinematics == Kinematics::Torsion {
                            return [x * n[0] + z * n[1], 0.0];
                        }
                        [x * n[0] + t * n[1], t * n[0] + z * n[1]]
                    })
                })
                .collect();
            let cases = [loads];
            let body = Body::new(problem(mesh, p, kinematics, &materials, &[], &cases, Some(kept))).unwrap();
            stress_error(&body.field(&solved(&body, &[1.0])).unwrap(), mesh, exact)
        })
        .collect()
}

fn assert_exponential(errors: &[f64], rate: f64, last: f64) {
    let slope = (errors[0] / errors[errors.len() - 1]).ln() / (errors.len() - 1) as f64;
    assert!(slope > rate.ln(), "slope {slope:.2}: {errors:?}");
    assert!(errors[errors.len() - 1] < last, "{errors:?}");
}

/// Lame 1852 (Timoshenko and Goodier, art. 28): thick cylinder, inner radius a, outer b, inner pressure q:
/// `s_rr = A - B / r^2`, `s_tt = A + B / r^2`, `A = q a^2 / (b^2 - a^2)`, `B = A b^2`.
#[test]
fn thick_cylinder_in_plane_strain() {
    let exact = |x: [f64; 2]| {
        let (a, b) = (50.0 / 3.0, 200.0 / 3.0);
        let r2 = x[0] * x[0] + x[1] * x[1];
        let [xx, zz, xz] = cartesian(x, [a - b / r2, a + b / r2, 0.0]);
        [xx, zz, xz, 0.3 * 2.0 * a]
    };
    let all = ["inner", "outer", "start", "end"];
    assert_exponential(&errors(&quarter_ring(2), PLANE_STRAIN, &all, "end", 2..=16, exact), 3.0, 1e-9);
}

#[test]
fn thick_cylinder_as_an_axisymmetric_body() {
    let materials = steel();
    let mesh = rectangle([1.0, 2.0], [0.0, 0.5]);
    let supports = [support("bottom", Direction::Second), support("top", Direction::Second)];
    let load = [vec![traction("left", |p| p.outward.map(|n| -50.0 * n))]];
    let (a, b) = (50.0 / 3.0, 200.0 / 3.0);
    let mut last = f64::MAX;
    for p in [2, 4, 8, 12, 16] {
        let body = Body::new(problem(&mesh, p, Kinematics::Axisymmetric, &materials, &supports, &load, None)).unwrap();
        let state = solved(&body, &[1.0]);
        let field = body.field(&state).unwrap();
        let e = stress_error(&field, &mesh, |x| {
            let r2 = x[0] * x[0];
            [a - b / r2, 0.3 * 2.0 * a, 0.0, a + b / r2]
        });
        assert!(e < 0.3 * last || e < 1e-10, "p = {p}: {e:.1e} after {last:.1e}");
        last = e;
        // The axial force on the top is that of the plane-strain stress over the annulus.
        let force = body.interface.reaction(1, &state)[1];
        assert!((force - 0.6 * a * PI * 3.0).abs() < e * 1e3, "p = {p}: {force}");
    }
    assert!(last < 2e-10, "{last:.1e}");
}

/// Golovin 1881 (Timoshenko and Goodier, art. 29): pure bending of a curved beam, moment M at the ends, radii a < b.
#[test]
fn curved_beam_in_pure_bending() {
    let (a, b, m): (f64, f64, f64) = (1.0, 2.0, 1.0);
    let l = (b / a).ln();
    let n = (b * b - a * a).powi(2) - 4.0 * a * a * b * b * l * l;
    let exact = move |x: [f64; 2]| {
        let r = x[0].hypot(x[1]);
        let common = b * b * (r / b).ln() + a * a * (a / r).ln();
        let q = a * a * b * b / (r * r) * l;
        let [xx, zz, xz] = cartesian(x, [-4.0 * m / n * (q + common), -4.0 * m / n * (-q + common + b * b - a * a), 0.0]);
        [xx, zz, xz, 0.0]
    };
    assert_exponential(&errors(&quarter_ring(2), PLANE_STRESS, &["start", "end"], "start", 2..=16, exact), 3.0, 1e-9);
}

/// Kirsch 1898 (Timoshenko and Goodier, art. 35): circular hole of radius 1 in a plate pulled by S = 1 along x; here a quarter of a
/// square plate of half side 3 with the exact tractions on its outer edges.
#[test]
fn plate_with_a_hole() {
    let exact = |x: [f64; 2]| {
        let (r2, angle) = (x[0] * x[0] + x[1] * x[1], x[1].atan2(x[0]));
        let (a2, a4) = (1.0 / r2, 1.0 / (r2 * r2));
        let (s, c) = (2.0 * angle).sin_cos();
        let polar = [
            0.5 * (1.0 - a2) + 0.5 * (1.0 + 3.0 * a4 - 4.0 * a2) * c,
            0.5 * (1.0 + a2) - 0.5 * (1.0 + 3.0 * a4) * c,
            -0.5 * (1.0 - 3.0 * a4 + 2.0 * a2) * s,
        ];
        let [xx, zz, xz] = cartesian(x, polar);
        [xx, zz, xz, 0.0]
    };
    let h = 0.5_f64.sqrt();
    let vertices = vec![[1.0, 0.0], [3.0, 0.0], [3.0, 3.0], [h, h], [0.0, 3.0], [0.0, 1.0]];
    let quad = |corners| Quad { corners, material: 0, layer: 0 };
    let arc = |from, to| Curve::Arc { centre: [0.0; 2], radius: 1.0, from, to };
    let curves = [([0, 3], arc(0.0, FRAC_PI_4)), ([3, 5], arc(FRAC_PI_4, FRAC_PI_2))];
    let names = [([0, 1], "z0"), ([1, 2], "x1"), ([2, 4], "z1"), ([4, 5], "x0")];
    let mesh = Mesh::new(vertices, &[quad([0, 1, 2, 3]), quad([3, 2, 4, 5])], &curves, &names).unwrap();
    let materials = steel();
    let supports = [support("z0", Direction::Second), support("x0", Direction::First)];
    let errors: Vec<f64> = (2..=20)
        .map(|p| {
            let pull = |b| {
                traction(b, move |q: &BoundaryPoint| {
                    let ([x, z, t, _], n) = (exact(q.position), q.outward);
                    [x * n[0] + t * n[1], t * n[0] + z * n[1]]
                })
            };
            let load = [vec![pull("x1"), pull("z1")]];
            let body = Body::new(problem(&mesh, p, PLANE_STRESS, &materials, &supports, &load, None)).unwrap();
            stress_error(&body.field(&solved(&body, &[1.0])).unwrap(), &mesh, exact)
        })
        .collect();
    assert_exponential(&errors, 2.0, 1e-6);
    assert!(errors[18] < 1e-6);
}

/// A cone under torsion: `u_phi = r / R^3` with `R^2 = r^2 + z^2` leaves every cone through the origin free of stress (Foeppl 1905;
/// `u_phi / r` is the fundamental solution in five dimensions), `tau_rphi = -3 G r^2 / R^5`, `tau_zphi = -3 G r z / R^5`.
#[test]
fn conical_shaft_in_torsion() {
    let shear = 210e3 / 2.6;
    let exact = move |x: [f64; 2]| {
        let d = x[0].hypot(x[1]).powi(5);
        [-3.0 * shear * x[0] * x[0] / d, -3.0 * shear * x[0] * x[1] / d, 0.0, 0.0]
    };
    let slope = 0.5;
    let vertices = vec![[0.0, 1.0], [slope, 1.0], [2.0 * slope, 2.0], [0.0, 2.0]];
    let quad = Quad { corners: [0, 1, 2, 3], material: 0, layer: 0 };
    let names = [([0, 1], "small"), ([2, 3], "large")];
    let mesh = Mesh::new(vertices, &[quad], &[], &names).unwrap();
    let errors = errors(&mesh, Kinematics::Torsion, &["small", "large"], "large", 2..=16, exact);
    assert_exponential(&errors, 2.5, 1e-6);
}

/// Cook 1974: tapered panel clamped on the left, sheared by a unit force on the right. The clamped corner at the top left is
/// singular, and the shear does not fit the free edges on the right, so the mesh is graded towards all corners.
#[test]
fn cooks_membrane() {
    let tip = |p: usize, layers: usize| {
        let mesh = cook(layers);
        let materials = [Material::isotropic(1.0, 1.0 / 3.0).unwrap()];
        let supports = [support("left", Direction::First), support("left", Direction::Second)];
        let load = [vec![traction("right", |_| [0.0, 1.0 / 16.0])]];
        let kinematics = Kinematics::PlaneStress { thickness: 1.0 };
        let body = Body::new(problem(&mesh, p, kinematics, &materials, &supports, &load, None)).unwrap();
        let state = solved(&body, &[1.0]);
        let field = body.field(&state).unwrap();
        let (cell, xi, eta) = field.locate([48.0, 52.0]).unwrap();
        let reaction: [f64; 3] =
            std::array::from_fn(|k| body.interface.reaction(0, &state)[k] + body.interface.reaction(1, &state)[k]);
        // The load's moment about the origin is 48.
        for (a, b) in reaction.iter().zip([0.0, -1.0, -48.0]) {
            assert!((a - b).abs() < 1e-9, "{reaction:?}");
        }
        (field.at(cell, xi, eta).unwrap().displacement[1], body.interface.strain_energy(&state))
    };
    let ([coarse, fine], [low, high]) = {
        let (a, b) = (tip(12, 8), tip(16, 8));
        ([a.0, b.0], [a.1, b.1])
    };
    // The energy converges exponentially and from below; twice the energy is the mean deflection of the loaded edge.
    assert!(low < high && high - low < 2e-8 * high, "{low} {high}");
    assert!((coarse - fine).abs() < 1e-6 * fine, "{coarse} {fine}");
    // Reference value of converged fine meshes in the literature: 23.96 at mid-height.
    assert!((fine - 23.96).abs() < 0.02, "{fine}");
}

/// The mesh of Cook's membrane, 2 x 2 cells, graded towards its corners.
pub(crate) fn cook(layers: usize) -> Mesh {
    let line = |start, end| Curve::Line { start, end };
    let named = |side, name| Named { side, range: None, name };
    let region = Ruled {
        bottom: line([0.0, 0.0], [48.0, 44.0]),
        top: line([0.0, 44.0], [48.0, 60.0]),
        breaks: &[-1.0, 0.0, 1.0],
        levels: &[0.0, 0.5, 1.0],
        closed: false,
        material: 0,
        names: &[named(Side::Left, "left"), named(Side::Right, "right")],
    };
    let mesh = Mesh::ruled(&region).unwrap();
    let corners = [
        mesh.nearest_vertex([0.0, 0.0]),
        mesh.nearest_vertex([0.0, 44.0]),
        mesh.nearest_vertex([48.0, 44.0]),
        mesh.nearest_vertex([48.0, 60.0]),
    ];
    mesh.refined_towards(&corners, 0.15, layers).unwrap()
}
