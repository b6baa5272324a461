//! Sparse matrices and natural modes.

use crate::classics::rectangle;
use crate::common::*;
use faer::Mat;
use faer::Side;
use faer::linalg::solvers::Solve;
use hpfem::*;
use std::f64::consts::PI;

#[test]
fn a_membrane_has_its_double_modes_twice() {
    // A square of side 2 held around: lambda = pi^2 (m^2 + n^2) / 4 with k = rho = 1.
    let mut problem = BodyProblem::new(rectangle([0.0, 2.0], [0.0, 2.0]), 14, Kinematics::Potential { thickness: 0.3 });
    problem = problem.material(Material::conductor(1.0).unwrap());
    problem = ["left", "right", "top", "bottom"].iter().fold(problem, |p, name| p.clamp(name));
    let modes = SparseBody::new(problem).unwrap().modes(&[1.0], 8).unwrap();
    let wanted = [2.0, 5.0, 5.0, 8.0, 10.0, 10.0, 13.0, 13.0];
    for (mode, wanted) in modes.iter().zip(wanted) {
        let exact = wanted * PI * PI / 4.0;
        assert!((mode.eigenvalue / exact - 1.0).abs() < 1e-9, "{} {exact}", mode.eigenvalue);
        assert!((2.0 * mode.field.strain_energy() / exact - 1.0).abs() < 1e-8);
    }
}

#[test]
fn a_bar_rings_and_a_free_one_has_three_rigid_motions() {
    // nu = 0, rollers along its sides: omega = (2k - 1) pi c / (2 L), c^2 = E / rho.
    let (young, density, length) = (210e3, 7.85e-9, 2.0);
    let mesh = rectangle([0.0, length], [0.0, 0.1]);
    let problem = BodyProblem::new(mesh, 14, PLANE_STRESS).material(Material::isotropic(young, 0.0).unwrap());
    let held = problem.clone().roller("left").roller("top").roller("bottom");
    let modes = SparseBody::new(held).unwrap().modes(&[density], 3).unwrap();
    for (k, mode) in modes.iter().enumerate() {
        let omega = (2 * k + 1) as f64 * PI / (2.0 * length) * (young / density).sqrt();
        assert!((mode.eigenvalue.sqrt() / omega - 1.0).abs() < 1e-9, "{k}: {} {omega}", mode.eigenvalue.sqrt());
    }
    let free = SparseBody::new(problem).unwrap().modes(&[density], 5).unwrap();
    assert!(free[..3].iter().all(|mode| mode.eigenvalue.abs() < 1e-9 * free[3].eigenvalue));
    // The first bending mode of a slender free beam, (4.730041 / L)^2 sqrt(E I / (rho A)), lowered by shear and rotary inertia.
    let euler = (4.730041_f64 / length).powi(2) * (young * 0.01 / 12.0 / density).sqrt();
    let ratio = free[3].eigenvalue.sqrt() / euler;
    assert!((0.97..1.0).contains(&ratio), "{ratio}");
}

#[test]
fn the_sparse_matrices_give_the_field_of_the_body() {
    let g = |x: [f64; 2]| [0.3 * x[0] * x[1], -0.2 * x[0]];
    let mesh = mixed([0, 1, 2, 3], Shape::Arcs, 0.0);
    for kinematics in [PLANE_STRAIN, Kinematics::Axisymmetric] {
        let problem = BodyProblem::new(mesh.clone(), 7, kinematics)
            .material(Material::isotropic(3.0, 0.3).unwrap())
            .support(Support::moved("left", Direction::First, 0.1).varying(|x| 0.05 * x[1]))
            .hold("bottom", Direction::Second)
            .foundation(Foundation::new("right", 2.0, 0.7))
            .load("weight", BodyForce::new(g))
            .load("weight", PointForce::new([2.2, 1.4], [0.1, -0.3]))
            .load("pull", EdgeTraction::new("top", |p| p.outward))
            .load("swell", Eigenstrain::new(|p| [0.01 * p.position[0], 0.02, 0.01 * p.position[1], 0.005]));
        let body = Body::new(problem.clone()).unwrap();
        let factors = [0.7, 1.3, 2.0];
        let state = body.solve(&[("weight", 0.7), ("pull", 1.3), ("swell", 2.0)]).unwrap();
        let wanted = body.field(&state).unwrap();
        let sparse = SparseBody::new(problem).unwrap();
        let (k, f) = sparse.stiffness().unwrap();
        let right = Mat::from_fn(f.nrows(), 1, |i, _| f[(i, 3)] + (0..3).map(|c| factors[c] * f[(i, c)]).sum::<f64>());
        let u = k.sp_cholesky(Side::Lower).unwrap().solve(&right);
        let field = sparse.field(u.col_as_slice(0), &factors).unwrap();
        for cell in 0..mesh.cells.len() {
            for (xi, eta) in sample_points() {
                let (a, b) = (field.at(cell, xi, eta).unwrap(), wanted.at(cell, xi, eta).unwrap());
                let pairs = a.displacement.iter().zip(b.displacement).chain(a.stress.iter().zip(b.stress));
                pairs.for_each(|(a, b)| assert!((a - b).abs() < 1e-10, "{a} {b}"));
            }
        }
    }
}

#[test]
fn the_mass_of_a_translation_is_the_mass_of_the_body() {
    let mesh = mixed([3, 1, 0, 2], Shape::Arcs, 0.0);
    let area: f64 = {
        let one = BodyProblem::new(mesh.clone(), 8, Kinematics::Potential { thickness: 1.0 });
        let sparse = SparseBody::new(one.material(Material::conductor(1.0).unwrap())).unwrap();
        let (m, n) = (sparse.mass(&[2.0]).unwrap(), sparse.unknowns());
        // The constant is one at every vertex and has no other modes.
        let one = Mat::from_fn(n, 1, |i, _| f64::from(u8::from(i < mesh.vertices.len())));
        (one.transpose() * (&m * &one))[(0, 0)] / 2.0
    };
    // Gauss' theorem on the boundary.
    let mut green = 0.0;
    let rule = gauss(12);
    for e in mesh.boundary("all").unwrap() {
        let (cell, local) = mesh.edge_cells()[e][0];
        let forward = (local < 2) != mesh.cells[cell].against[local];
        let curve = if forward { mesh.edges[e].curve } else { mesh.edges[e].curve.reversed() };
        green +=
            rule.points.iter().zip(&rule.weights).map(|(t, w)| w * curve.point(*t)[0] * curve.derivative(*t)[1]).sum::<f64>();
    }
    assert!((area / green - 1.0).abs() < 1e-12, "{area} {green}");
}

#[test]
fn what_cannot_be_is_refused() {
    let problem = BodyProblem::new(rectangle([0.0, 1.0], [0.0, 1.0]), 2, PLANE_STRESS);
    let sparse = SparseBody::new(problem.material(Material::isotropic(1.0, 0.2).unwrap())).unwrap();
    assert!(matches!(sparse.mass(&[]), Err(Error::Count { .. })));
    assert!(matches!(sparse.mass(&[-1.0]), Err(Error::OutOfRange { .. })));
    assert!(matches!(sparse.modes(&[1.0], 0), Err(Error::OutOfRange { .. })));
    assert!(matches!(sparse.element(9), Err(Error::Beyond { index: 9, .. })));
}

#[test]
fn as_many_modes_come_as_are_asked_for() {
    let steel = Material::isotropic(210e3, 0.3).unwrap();
    // On a foundation ten orders softer than steel, three modes are nearly rigid.
    let soft = BodyProblem::new(rectangle([0.0, 100.0], [0.0, 50.0]).refined().unwrap(), 7, PLANE_STRESS).material(steel);
    let soft = SparseBody::new(soft.foundation(Foundation::new("bottom", 1e-3, 1e-3))).unwrap();
    assert!(soft.unknowns() > 200);
    let (few, many) = (soft.modes(&[7.85e-9], 6).unwrap(), soft.modes(&[7.85e-9], 20).unwrap());
    assert_eq!((few.len(), many.len()), (6, 20));
    for (a, b) in few.iter().zip(&many).skip(3) {
        assert!((a.eigenvalue / b.eigenvalue - 1.0).abs() < 1e-9, "{} {}", a.eigenvalue, b.eigenvalue);
    }
    // Nearly rigid: the three lowest are those of a block on springs. Up and down it moves alone, omega^2 = k L t / m.
    let heave = 1e-3 * 100.0 * 0.7 / (7.85e-9 * 100.0 * 50.0 * 0.7);
    let nearest = few[..3].iter().map(|mode| (mode.eigenvalue / heave - 1.0).abs()).fold(f64::INFINITY, f64::min);
    assert!(nearest < 1e-5, "{nearest:e}");
    assert!(few[2].eigenvalue < 1e-3 * few[3].eigenvalue);
    // All modes of a small body, held or free; in two parts; with a moved support, whose displacement is no part of a mode.
    let small = BodyProblem::new(rectangle([0.0, 2.0], [0.0, 1.0]), 3, PLANE_STRESS).material(steel);
    for problem in [small.clone(), small.clone().support(Support::moved("left", Direction::First, 0.5))] {
        let sparse = SparseBody::new(problem).unwrap();
        let modes = sparse.modes(&[7.85e-9], sparse.unknowns()).unwrap();
        assert_eq!(modes.len(), sparse.unknowns());
        assert!(modes.windows(2).all(|m| m[0].eigenvalue <= m[1].eigenvalue));
    }
    let moved = SparseBody::new(small.support(Support::moved("left", Direction::First, 0.5))).unwrap();
    let mode = &moved.modes(&[7.85e-9], 3).unwrap()[2];
    assert!(mode.field.at(0, -1.0, 0.3).unwrap().displacement[0].abs() < 1e-12);
}

#[test]
fn two_parts_ring_each_for_itself() {
    let square = |x: f64| vec![[x, 0.0], [x + 1.0, 0.0], [x + 1.0, 1.0], [x, 1.0]];
    let vertices: Vec<[f64; 2]> = [square(0.0), square(2.2)].concat();
    let cell = |k: usize| Quad { corners: [k, k + 1, k + 2, k + 3], material: 0, layer: 0 };
    let both = Mesh::new(vertices, &[cell(0), cell(4)], &[], &[]).unwrap();
    let one = Mesh::new(square(0.0), &[cell(0)], &[], &[]).unwrap();
    let modes = |mesh: Mesh, count| {
        let problem = BodyProblem::new(mesh, 8, PLANE_STRAIN).material(Material::isotropic(2.0, 0.3).unwrap());
        SparseBody::new(problem).unwrap().modes(&[1.5], count).unwrap()
    };
    let (single, double) = (modes(one, 8), modes(both, 16));
    for k in 3..8 {
        for mode in &double[2 * k..2 * k + 2] {
            assert!((mode.eigenvalue / single[k].eigenvalue - 1.0).abs() < 1e-8, "{k}");
        }
    }
}
