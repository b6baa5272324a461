//! Strains without stress of their own: free, hindered, in layers, in a thick cylinder.

use crate::classics::{cartesian, quarter_ring, rectangle};
use crate::common::*;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use hpfem::*;

const YOUNG: f64 = 210e3;
const EXPANSION: f64 = 1.2e-5;

fn heat(rise: impl Fn([f64; 2]) -> f64 + Send + Sync + 'static) -> Eigenstrain {
    Eigenstrain::thermal(&[EXPANSION], move |place| rise(place.position))
}

#[test]
fn a_body_that_expands_freely_is_without_stress() {
    // Any linear temperature leaves a free plate without stress; a body of revolution, or one held out of its plane, only a uniform one.
    let shapes = [Shape::Straight, Shape::Polynomial(2)];
    let meshes = shapes.into_iter().flat_map(|shape| {
        let mixed = TURNS[4..].iter().map(move |t| mixed(*t, shape, 0.0));
        TURNS.iter().map(move |t| patch(*t, shape, 0.0)).chain(mixed)
    });
    for mesh in meshes {
        for (kinematics, slope) in [(PLANE_STRESS, 0.4), (PLANE_STRAIN, 0.0), (Kinematics::Axisymmetric, 0.0)] {
            let warm = heat(move |[x, z]| 50.0 * (1.0 + slope * (x - 2.0 * z)));
            let body = Body::new(problem(&mesh, 4, kinematics, &steel(), &[], &[], Some("left")).load("0", warm)).unwrap();
            let field = body.field(&solved(&body, &[1.0])).unwrap();
            let hindered = if kinematics == PLANE_STRAIN { -50.0 * YOUNG * EXPANSION } else { 0.0 };
            for (cell, (xi, eta)) in (0..mesh.cells.len()).flat_map(|c| sample_points().map(move |x| (c, x))) {
                let stress = field.at(cell, xi, eta).unwrap().stress;
                for (s, wanted) in stress.into_iter().zip([0.0, 0.0, 0.0, hindered]) {
                    assert_abs_diff_eq!(s, wanted, epsilon = 1e-9 * 50.0 * YOUNG * EXPANSION);
                }
            }
            assert!(hindered != 0.0 || field.strain_energy() < 1e-12);
        }
    }
}

#[test]
fn a_bar_between_walls_is_pressed_by_its_modulus_times_the_strain_it_cannot_have() {
    let mesh = rectangle([0.0, 3.0], [0.0, 1.0]);
    let supports = [support("left", Direction::First), support("right", Direction::First), support("bottom", Direction::Second)];
    for kept in [None, Some("top"), Some("right")] {
        for factor in [1.0, -0.5] {
            let body =
                Body::new(problem(&mesh, 3, PLANE_STRESS, &steel(), &supports, &[], kept).load("0", heat(|_| 80.0))).unwrap();
            let state = solved(&body, &[factor]);
            let pressure = -factor * 80.0 * YOUNG * EXPANSION;
            let field = body.field(&state).unwrap();
            assert!(stress_error(&field, &mesh, |_| [pressure, 0.0, 0.0, 0.0]) < 1e-11);
            assert_relative_eq!(body.interface.reaction(0, &state)[0], -pressure * 0.7, max_relative = 1e-11);
            assert_relative_eq!(field.strain_energy(), 0.5 * pressure * pressure / YOUNG * 3.0 * 0.7, max_relative = 1e-11);
        }
    }
}

/// Timoshenko 1925: the curvature of a strip of two metals,
/// `6 (a_2 - a_1) T (1 + m)^2 / (h (3 (1 + m)^2 + (1 + m n) (m^2 + 1/(m n))))`, `m = h_1/h_2`, `n = E_1/E_2`.
#[test]
fn a_bimetal_strip_bends_as_timoshenko_says() {
    let (h, young, expansion, rise) = ([0.4, 0.6], [210e3, 70e3], [1.1e-5, 2.3e-5], 60.0);
    let x = [0.0, 1.0, 3.0, 6.0, 9.0, 10.0];
    let vertices = [0.0, h[0], 1.0].iter().flat_map(|z| x.map(|x| [x, *z])).collect();
    let quad = |row: usize, i: usize| {
        let corner = 6 * row + i;
        Quad { corners: [corner, corner + 1, corner + 7, corner + 6], material: row, layer: 0 }
    };
    let quads: Vec<Quad> = (0..2).flat_map(|row| (0..5).map(move |i| quad(row, i))).collect();
    let mesh = Mesh::new(vertices, &quads, &[], &[([6, 0], "middle"), ([12, 6], "middle")]).unwrap();
    let materials = young.map(|e| Material::isotropic(e, 0.3).unwrap());
    let pins = vec![Pin { vertex: 0, direction: Direction::Second }];
    let problem = problem(&mesh, 10, PLANE_STRESS, &materials, &[support("middle", Direction::First)], &[], None);
    let warm = Eigenstrain::thermal(&expansion, move |_| rise);
    let body = Body::new(BodyProblem { pins, ..problem }.load("0", warm)).unwrap();
    let field = body.field(&solved(&body, &[1.0])).unwrap();
    let (m, n) = (h[0] / h[1], young[0] / young[1]);
    let square = (1.0 + m) * (1.0 + m);
    let wanted = 6.0 * (expansion[1] - expansion[0]) * rise * square / (3.0 * square + (1.0 + m * n) * (m * m + 1.0 / (m * n)));
    for xi in [-1.0, 0.2, 1.0] {
        let strain = |cell, eta| field.at(cell, xi, eta).unwrap().gradient[0][0];
        assert_relative_eq!(strain(5, 1.0) - strain(0, -1.0), wanted, max_relative = 1e-7);
        // Plane sections, and no force nor moment on a section.
        assert_relative_eq!(strain(5, 1.0) - strain(5, -1.0), wanted * h[1], max_relative = 1e-7);
    }
}

/// Timoshenko and Goodier, art. 151: a long cylinder of radii a < b, `T = T_a ln(b/r) / ln(b/a)`, no axial strain: `[rr, tt, zz]`.
fn cylinder(r: f64, rise: f64) -> [f64; 3] {
    let (a, b, nu) = (1.0_f64, 2.0_f64, 0.3);
    let (l, far) = ((b / a).ln(), (b / r).ln());
    let c = YOUNG * EXPANSION * rise / (2.0 * (1.0 - nu) * l);
    let ratio = a * a / (b * b - a * a) * l;
    let rr = c * (-far - ratio * (1.0 - b * b / (r * r)));
    let tt = c * (1.0 - far - ratio * (1.0 + b * b / (r * r)));
    [rr, tt, nu * (rr + tt) - YOUNG * EXPANSION * rise * far / l]
}

#[test]
fn a_thick_cylinder_hot_inside_has_the_stress_of_its_closed_form() {
    let rise = 100.0;
    let temperature = move |r: f64| rise * (2.0 / r).ln() / 2.0_f64.ln();
    let mesh = rectangle([1.0, 2.0], [0.0, 0.5]);
    let supports = [support("bottom", Direction::Second), support("top", Direction::Second)];
    let revolved = problem(&mesh, 16, Kinematics::Axisymmetric, &steel(), &supports, &[], Some("left"));
    let body = Body::new(revolved.load("0", heat(move |x| temperature(x[0])))).unwrap();
    let error = stress_error(&body.field(&solved(&body, &[1.0])).unwrap(), &mesh, |x| {
        let [rr, tt, zz] = cylinder(x[0], rise);
        [rr, zz, 0.0, tt]
    });
    assert!(error < 1e-9, "{error:.1e}");
    let mesh = quarter_ring(2);
    let supports = [Support::roller("start"), Support::roller("end")];
    let plane = problem(&mesh, 16, PLANE_STRAIN, &steel(), &supports, &[], Some("inner"));
    let body = Body::new(plane.load("0", heat(move |x| temperature(x[0].hypot(x[1]))))).unwrap();
    let error = stress_error(&body.field(&solved(&body, &[1.0])).unwrap(), &mesh, |x| {
        let [rr, tt, zz] = cylinder(x[0].hypot(x[1]), rise);
        let [xx, yy, xy] = cartesian(x, [rr, tt, 0.0]);
        [xx, yy, xy, zz]
    });
    assert!(error < 1e-9, "{error:.1e}");
}

/// A temperature on another mesh, and a field that is none.
#[test]
fn a_temperature_belongs_to_its_mesh() {
    let conduction = |mesh: &Mesh| {
        let problem = BodyProblem::new(mesh.clone(), 2, Kinematics::Potential { thickness: 1.0 });
        let body = Body::new(problem.material(Material::conductor(1.0).unwrap()).clamp("left")).unwrap();
        body.field(&body.solve(&[]).unwrap()).unwrap()
    };
    let (one, other) = (rectangle([1.0, 2.0], [0.0, 0.5]), quarter_ring(2));
    let load = Eigenstrain::of_temperature(&[1e-5], conduction(&one), 20.0).unwrap();
    let held = |mesh: &Mesh, edge: &str| {
        BodyProblem::new(mesh.clone(), 2, PLANE_STRAIN).material(steel()[0]).clamp(edge).load("heat", load.clone())
    };
    let error = Body::new(held(&other, "start")).map(|_| ()).unwrap_err();
    assert_eq!(error, Error::OtherMesh);
    // As many cells in another place, and the law of conduction of another kinematics.
    let far = rectangle([50.0, 51.0], [0.0, 9.0]);
    assert_eq!(Body::new(held(&far, "left")).map(|_| ()).unwrap_err(), Error::OtherMesh);
    let turned = BodyProblem { kinematics: Kinematics::Axisymmetric, ..held(&one, "left") };
    assert!(matches!(Body::new(turned), Err(Error::NoMeaning { .. })));
    // Cold by 20 K and held: a stress, and a field of displacements is no temperature.
    let body = Body::new(held(&one, "left")).unwrap();
    let field = body.field(&body.solve(&[("heat", 1.0)]).unwrap()).unwrap();
    assert!(field.at(0, -1.0, 0.0).unwrap().stress[1] > 0.0);
    assert!(matches!(Eigenstrain::of_temperature(&[1e-5], field, 20.0), Err(Error::NoMeaning { .. })));
}
