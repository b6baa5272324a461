//! Similar cells share their condensed matrix.

use crate::common::*;
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
    let steel = Material::isotropic(1.7, 0.28).unwrap();
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
    let supports = [Support::hold("hub", Direction::First)];
    let degrees = mesh.cells.iter().map(|c| 7 - c.layer).collect();
    let load = [vec![traction("contact", |p| [p.position[1], 0.7])]];
    let plane = Kinematics::PlaneStrain { thickness: 1.0 };
    let problem = problem(&mesh, 1, plane, &materials, &supports, &load, Some("contact"));
    let body = Body::new(BodyProblem { degrees, space, ..problem }).unwrap();
    let point = body.field(&afloat(&body, &[1.0])).unwrap().at(5, 0.3, -0.4);
    (body.interface.stiffness.clone(), point.unwrap().displacement[1])
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

#[test]
fn loads_added_inside_similar_cells_are_those_of_each_cell_by_itself() {
    let skew = Eigenstrain::new(|place| {
        let [x, z] = place.position;
        [1e-3 * x, 2e-3 * z * z, -1e-3 * x * z, 3e-3]
    });
    let cases = [
        LoadCase::new("heat").with(Eigenstrain::thermal(&[1e-5], |place| (0.3 * place.position[0]).exp())),
        LoadCase::new("skew").with(skew),
        LoadCase::new("weight").with(BodyForce::new(|x| [x[1], -2.0 - x[0]])),
        LoadCase::new("both").with(BodyForce::new(|x| [1.0, x[0]])).with(PointForce::new([4.3, -1.4], [3.0, -1.0])),
    ];
    for (space, kinematics) in [
        (SpaceKind::Tensor, Kinematics::PlaneStrain { thickness: 1.0 }),
        (SpaceKind::Trunk, Kinematics::PlaneStress { thickness: 2.0 }),
    ] {
        let [shared, separate] = [false, true].map(|separate| {
            let (mesh, materials) = ring(separate);
            let cases = cases.clone().map(|case| match (case.name.as_str(), separate) {
                ("heat", true) => {
                    let expansion = vec![1e-5; materials.len()];
                    LoadCase::new("heat").with(Eigenstrain::thermal(&expansion, |place| (0.3 * place.position[0]).exp()))
                }
                _ => case,
            });
            let supports = [Support::hold("hub", Direction::First), Support::moved("hub", Direction::Second, 1e-3)];
            let degrees = mesh.cells.iter().map(|c| 7 - c.layer).collect();
            let problem = problem(&mesh, 1, kinematics, &materials, &supports, &[], Some("contact"));
            let mut body = Body::new(BodyProblem { degrees, space, ..problem }).unwrap();
            cases.into_iter().for_each(|case| body.add_load(case).unwrap());
            body.interface
        });
        let of = |body: &InterfaceOperator| [body.columns.clone(), body.work.clone()];
        for (shared, separate) in of(&shared).iter().zip(&of(&separate)) {
            for k in 0..separate.ncols() {
                let difference = (shared.col(k) - separate.col(k)).norm_max();
                assert!(difference <= 1e-11 * separate.col(k).norm_max(), "{kinematics:?} {k}: {difference:.1e}");
            }
        }
    }
}

/// Columns of a temperature as a load case, on a body reduced for any, on one reduced for it alone, and on one that was reduced for none.
fn heated((mesh, materials): (Mesh, Vec<Material>), kept: &str, conductivity: [[f64; 2]; 2]) -> [faer::Mat<f64>; 3] {
    let degrees: Vec<usize> = mesh.cells.iter().enumerate().map(|(i, c)| 7 - c.layer - i % 2).collect();
    let conductor = Material::conductor(1.0).unwrap().conducting(conductivity).unwrap();
    let load = [vec![traction(kept, |p| [p.position[1], 0.0])]];
    let (thickness, conductors) = (1.3, vec![conductor; materials.len()]);
    let conduction = problem(&mesh, 1, Kinematics::Potential { thickness }, &conductors, &[], &load, Some(kept));
    let warm = Body::new(conduction.degrees(degrees.clone()).foundation(Foundation::new(kept, 0.2, 0.0))).unwrap();
    let cold = problem(&mesh, 1, Kinematics::PlaneStress { thickness }, &materials, &[], &[], Some(kept)).degrees(degrees);
    let state = warm.solve(&[("0", 1.0)]).unwrap();
    let case = TemperatureCase { name: "heat".into(), state, reference: 0.4 };
    let expansion = vec![1.2e-5; materials.len()];
    let made = |known| Body::for_heat(cold.clone(), &warm, known, &expansion, || 0.0).unwrap();
    let bodies = [made(None), made(Some(std::slice::from_ref(&case))), Body::new(cold.clone()).unwrap()];
    bodies.map(|body| body.heated(&warm, std::slice::from_ref(&case), &expansion).unwrap().columns)
}

#[test]
fn similar_cells_share_what_temperatures_do_to_them_unless_they_conduct_otherwise() {
    for conductivity in [[[1.0, 0.0], [0.0, 1.0]], [[1.0, 0.4], [0.4, 2.0]]] {
        for (shared, alone, kept) in [(ring(false), ring(true), "contact"), (triangles(false), triangles(true), "top")] {
            let [[any, known, made], [other, alone, _]] = [shared, alone].map(|bodies| heated(bodies, kept, conductivity));
            assert_eq!((&known - &made).norm_max(), 0.0);
            for found in [&any, &known, &alone] {
                let difference = (found - &other).norm_max();
                assert!(difference < 1e-11 * other.norm_max(), "{kept} {conductivity:?}: {difference:.1e}");
            }
            // A cell by itself is loaded by the temperature at once.
            assert!((&alone - &other).norm_max() > 0.0);
        }
    }
}

/// A rectangle of triangles: two shapes, each twice refined, so moved, turned and scaled copies; a mirrored copy on the other side of x = 0.
fn triangles(separate: bool) -> (Mesh, Vec<Material>) {
    let vertices = vec![[0.0, 0.0], [2.0, 0.3], [1.7, 1.4], [0.0, 1.1], [-2.0, 0.3], [-1.7, 1.4]];
    let triangle = |a, b, c| Quad { corners: [a, b, c, c], material: 0, layer: 0 };
    let cells = [triangle(0, 1, 2), triangle(2, 3, 0), triangle(4, 0, 5), triangle(0, 3, 5)];
    let names = [([0, 1], "bottom"), ([0, 4], "bottom"), ([2, 3], "top"), ([3, 5], "top")];
    let mut mesh = Mesh::new(vertices, &cells, &[], &names).unwrap().refined().unwrap().refined().unwrap();
    let steel = Material::isotropic(1.7, 0.28).unwrap();
    if separate {
        mesh.cells.iter_mut().enumerate().for_each(|(i, c)| c.material = i);
    }
    let materials = vec![steel; mesh.cells.len()];
    (mesh, materials)
}

fn of_triangles<T>(separate: bool, kinematics: Kinematics, take: impl Fn(BodyProblem) -> T) -> T {
    let (mesh, materials) = triangles(separate);
    // Unequal degrees, so that edges have fewer modes than their cells.
    let degrees = (0..mesh.cells.len()).map(|i| 4 + i % 3).collect();
    take(problem(&mesh, 1, kinematics, &materials, &[], &[], Some("top")).degrees(degrees).clamp("bottom"))
}

#[test]
fn straight_triangles_moved_turned_mirrored_and_scaled_share_their_matrix_and_the_operator_stays_as_it_is() {
    let plane = Kinematics::PlaneStrain { thickness: 1.0 };
    let stiffness = |separate| of_triangles(separate, plane, |p| Body::new(p).unwrap().interface.stiffness.clone());
    let (shared, alone) = (stiffness(false), stiffness(true));
    let difference = (&shared - &alone).norm_max();
    assert!(difference < 1e-12 * alone.norm_max(), "{difference:.1e}");
    let operations = |separate, kinematics| of_triangles(separate, kinematics, |p| Body::sizes(&p).unwrap().operations);
    // 64 cells of two shapes and three degrees: at most six matrices. What is left is the elimination, which is the same.
    let saved = operations(true, plane) - operations(false, plane);
    let of_one = |p: usize| {
        let (n, interior) = (((p + 1) * (p + 2) / 2) as f64, ((p - 1) * (p - 2)) as f64);
        let left = 2.0 * n - interior;
        12.0 * n * n * (p + 2) as f64 + interior.powi(3) / 6.0 + 0.5 * interior * interior * left + 0.5 * interior * left * left
    };
    assert!(saved > 55.0 * of_one(4) && saved < 62.0 * of_one(6), "{saved}");
}

#[test]
fn triangles_of_revolution_never_share() {
    let revolved = |separate| {
        let (mut mesh, materials) = triangles(separate);
        // Away from the axis; equal shapes at unequal radii.
        mesh.vertices.iter_mut().for_each(|x| x[0] += 5.0);
        mesh.edges.iter_mut().for_each(|e| {
            if let Curve::Line { start, end } = &mut e.curve {
                start[0] += 5.0;
                end[0] += 5.0;
            }
        });
        let supports = [Support::hold("bottom", Direction::Second)];
        let problem = problem(&mesh, 4, Kinematics::Axisymmetric, &materials, &supports, &[], Some("top"));
        Body::sizes(&problem).unwrap().operations
    };
    assert_eq!(revolved(false), revolved(true));
}

#[test]
fn cells_whose_curves_differ_between_equal_ends_and_middles_do_not_share() {
    let square = |corners, material| Quad { corners, material, layer: 0 };
    let stiffness = |other: usize| {
        let vertices = vec![[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [0.0, 1.0]];
        let cells = [square([0, 1, 4, 5], 0), square([1, 2, 3, 4], other)];
        // Odd about its middle: ends and middle are those of the straight side of the other cell.
        let wave = Curve::interpolated(3, |t| [0.5 * (1.0 + t), 1.0 + 0.2 * (t - t.powi(3))]);
        let names = [([5, 4], "top"), ([4, 3], "top"), ([0, 1], "bottom"), ([1, 2], "bottom")];
        let mesh = Mesh::new(vertices, &cells, &[([5, 4], wave)], &names).unwrap();
        let plane = Kinematics::PlaneStrain { thickness: 1.0 };
        let materials = [Material::isotropic(1.7, 0.28).unwrap(); 2];
        let supports = [Support::hold("bottom", Direction::Second)];
        Body::new(problem(&mesh, 4, plane, &materials, &supports, &[], Some("top"))).unwrap().interface.stiffness
    };
    let (free_to_share, separate) = (stiffness(0), stiffness(1));
    let difference = (&free_to_share - &separate).norm_max();
    assert!(difference < 1e-12 * separate.norm_max(), "{difference:.1e}");
}
