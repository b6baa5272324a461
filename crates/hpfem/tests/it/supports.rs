//! Supports, reactions, rigid motions and rigid edges.

use crate::classics::rectangle;
use crate::common::*;
use approx::{assert_abs_diff_eq, assert_relative_eq};
use hpfem::*;

#[test]
fn rigid_motions_are_found_for_every_set_of_supports() {
    use Direction::{First, Normal, Second};
    let mesh = rectangle([1.0, 3.0], [-0.5, 1.0]);
    let materials = steel();
    let motions = |kinematics, supports: &[(&str, Direction)]| {
        let supports: Vec<Support> = supports.iter().map(|(b, d)| support(b, *d)).collect();
        let body = Body::new(problem(&mesh, 3, kinematics, &materials, &supports, &[], Some("top"))).unwrap();
        // Every rigid column costs no energy.
        let i = &body.interface;
        let strain = &i.stiffness * &i.rigid_modes;
        assert!(strain.norm_max() < 1e-10 * i.stiffness.norm_max() * i.rigid_modes.norm_max().max(1.0));
        i.rigid_motions.clone()
    };
    assert_eq!(motions(PLANE_STRESS, &[]).len(), 3);
    assert_eq!(motions(PLANE_STRESS, &[("left", First)]), [[0.0, 1.0, 0.0]]);
    assert_eq!(motions(PLANE_STRESS, &[("left", First), ("right", First)]), [[0.0, 1.0, 0.0]]);
    assert_eq!(motions(PLANE_STRESS, &[("left", Normal)]), [[0.0, 1.0, 0.0]]);
    assert_eq!(motions(PLANE_STRESS, &[("bottom", Second)]), [[1.0, 0.0, 0.0]]);
    assert!(motions(PLANE_STRESS, &[("bottom", Second), ("left", First)]).is_empty());
    // All points of the bottom held along x still leave the vertical motion; the rotation moves no point of it along x
    // only if it turns about the bottom line.
    let about_bottom = motions(PLANE_STRESS, &[("bottom", First)]);
    assert_eq!(about_bottom.len(), 2);
    for m in about_bottom {
        // u_x = t_x - theta z = 0 on z = -0.5.
        assert_abs_diff_eq!(m[0] + 0.5 * m[2], 0.0, epsilon = 1e-14);
    }
    assert!(motions(PLANE_STRAIN, &[("bottom", First), ("bottom", Second)]).is_empty());
    assert_eq!(motions(Kinematics::Axisymmetric, &[]), [[0.0, 1.0, 0.0]]);
    assert_eq!(motions(Kinematics::Axisymmetric, &[("left", First)]), [[0.0, 1.0, 0.0]]);
    assert!(motions(Kinematics::Axisymmetric, &[("bottom", Second)]).is_empty());
    assert_eq!(motions(Kinematics::Torsion, &[]).len(), 1);
    assert!(motions(Kinematics::Torsion, &[("bottom", First)]).is_empty());
}

#[test]
fn rollers_on_two_slanted_edges_hold_a_body() {
    let vertices = vec![[0.0, 0.0], [2.0, 0.0], [1.5, 1.0], [0.5, 1.0]];
    let quad = Quad { corners: [0, 1, 2, 3], material: 0, layer: 0 };
    let mesh = Mesh::new(vertices, &[quad], &[], &[([1, 2], "right"), ([3, 0], "left"), ([2, 3], "top")]).unwrap();
    let supports = [support("left", Direction::Normal), support("right", Direction::Normal)];
    let materials = steel();
    let body = Body::new(problem(&mesh, 4, PLANE_STRESS, &materials, &supports, &[], Some("top"))).unwrap();
    // Each edge of two points is held along its normal everywhere, so a turn would move one end in and the other out.
    assert!(body.interface.rigid_motions.is_empty(), "{:?}", body.interface.rigid_motions);
}

#[test]
fn reactions_balance_the_loads_in_force_and_moment() {
    let materials = steel();
    for turns in TURNS {
        let mesh = patch(turns, Shape::Arcs, 0.0);
        let supports = [support("left", Direction::First), support("left", Direction::Second)];
        let push = |p: &BoundaryPoint| [1.0 + p.position[1], p.position[0] - 0.3 * p.position[1]];
        let load = [vec![traction("top", push)]];
        for kept in [None, Some("right"), Some("bottom")] {
            let body = Body::new(problem(&mesh, 6, PLANE_STRAIN, &materials, &supports, &load, kept)).unwrap();
            let state = solved(&body, &[1.0]);
            let reactions = [0, 1].map(|s| body.interface.reaction(s, &state));
            let resultant = resultant(&mesh, "top", PLANE_STRAIN, push);
            for k in 0..3 {
                assert_abs_diff_eq!(reactions[0][k] + reactions[1][k] + resultant[k], 0.0, epsilon = 1e-9);
            }
        }
    }
}

/// Force and moment about the origin of a traction, by a quadrature of its own.
fn resultant(mesh: &Mesh, name: &str, kinematics: Kinematics, t: impl Fn(&BoundaryPoint) -> [f64; 2]) -> [f64; 3] {
    let rule = gauss(30);
    let mut sum = [0.0; 3];
    for e in mesh.boundary(name).unwrap() {
        let curve = &mesh.edges[e].curve;
        for (s, w) in rule.points.iter().zip(&rule.weights) {
            let (x, d) = (curve.point(*s), curve.derivative(*s));
            let p = BoundaryPoint { position: x, outward: [0.0; 2], tangent: [0.0; 2] };
            let f = t(&p).map(|f| f * w * d[0].hypot(d[1]) * kinematics.measure(x[0]));
            sum[0] += f[0];
            sum[1] += f[1];
            sum[2] += x[0] * f[1] - x[1] * f[0];
        }
    }
    sum
}

#[test]
fn a_load_on_the_kept_boundary_gives_the_same_field_as_a_load_case() {
    let materials = steel();
    let mesh = patch([2, 0, 3, 1], Shape::Arcs, 0.0);
    let supports = [support("left", Direction::First), support("bottom", Direction::Second)];
    let push = |p: &BoundaryPoint| [p.position[1] - 2.0, 1.0 + p.position[0]];
    let load = [vec![traction("top", push)]];
    let as_case = Body::new(problem(&mesh, 6, PLANE_STRESS, &materials, &supports, &load, None)).unwrap();
    let case_state = solved(&as_case, &[1.0]);
    let kept = Body::new(problem(&mesh, 6, PLANE_STRESS, &materials, &supports, &[], Some("top"))).unwrap();
    let i = &kept.interface;
    let load = i.trace.load(PLANE_STRESS, 4, push);
    let factors = i.factors(&[]).unwrap();
    let right = i.right_hand_side(&load, &factors);
    let x = i.solve(&faer_column(&right), &i.rigid_modes);
    let state = InterfaceState { unknowns: (0..right.len()).map(|k| x[(k, 0)]).collect(), factors, load };
    assert_relative_eq!(i.strain_energy(&state), as_case.interface.strain_energy(&case_state), max_relative = 1e-11);
    for s in 0..2 {
        for (a, b) in i.reaction(s, &state).iter().zip(as_case.interface.reaction(s, &case_state)) {
            assert_abs_diff_eq!(*a, b, epsilon = 1e-10);
        }
    }
    let (f, g) = (kept.field(&state).unwrap(), as_case.field(&case_state).unwrap());
    let size = g.at(3, 1.0, 1.0).unwrap().displacement[1].abs();
    for cell in 0..4 {
        for (xi, eta) in sample_points() {
            let (a, b) = (f.at(cell, xi, eta).unwrap().displacement, g.at(cell, xi, eta).unwrap().displacement);
            assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-11 * size);
        }
    }
    // The trace of the kept body is the boundary value of the field.
    let (edge, t) = i.trace.locate(0.4 * i.trace.length());
    let (rows, constant) = i.trace.displacement_row(edge, t);
    let x = i.trace.boundary_point(edge, t).0.position;
    let (cell, xi, eta) = f.locate(x).unwrap();
    let value = f.at(cell, xi, eta).unwrap().displacement;
    let whole = i.trace.displacement(edge, t, &state.unknowns);
    let relative = i.trace.relative_displacement(edge, t, &state.unknowns);
    for k in 0..2 {
        let u: f64 = rows[k].iter().map(|(n, c)| c * state.unknowns[*n]).sum::<f64>();
        assert_abs_diff_eq!(u + constant[k], value[k], epsilon = 1e-12 * size);
        assert_eq!([relative[k], whole[k]], [u, u + constant[k]]);
    }
}

fn faer_column(values: &[f64]) -> faer::Mat<f64> {
    faer::Mat::from_fn(values.len(), 1, |i, _| values[i])
}

#[test]
fn a_prescribed_displacement_stretches_a_bar_and_its_reaction_is_the_force() {
    // E = 210e3, 2 x 1.5 x 0.7 thick, stretched by 0.01 along x with free sides: uniaxial.
    let mesh = rectangle([1.0, 3.0], [-0.5, 1.0]);
    let materials = steel();
    let supports = [
        support("left", Direction::First),
        Support::moved("right", Direction::First, 0.01),
        support("bottom", Direction::Second),
    ];
    for kept in [None, Some("top"), Some("right")] {
        let body = Body::new(problem(&mesh, 3, PLANE_STRESS, &materials, &supports, &[], kept)).unwrap();
        let state = solved(&body, &[]);
        let force = 210e3 * 0.005 * 1.5 * 0.7;
        let r = [0, 1, 2].map(|s| body.interface.reaction(s, &state));
        assert_relative_eq!(r[0][0], -force, max_relative = 1e-12);
        assert_relative_eq!(r[1][0], force, max_relative = 1e-12);
        assert_relative_eq!(r[1][2], -force * 0.25, max_relative = 1e-11);
        assert_abs_diff_eq!(r[2][1], 0.0, epsilon = 1e-9);
        let field = body.field(&state).unwrap();
        assert!(stress_error(&field, &mesh, |_| [1050.0, 0.0, 0.0, 0.0]) < 1e-12);
    }
}

#[test]
fn an_inclined_roller_holds_like_a_straight_one_turned() {
    // A square turned by 35 degrees on rollers along the normals of two of its sides, pulled uniformly on the other two.
    let (s, c) = 35.0_f64.to_radians().sin_cos();
    let turn = |x: [f64; 2]| [c * x[0] - s * x[1] + 2.0, s * x[0] + c * x[1]];
    let vertices = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(turn).to_vec();
    let quad = Quad { corners: [0, 1, 2, 3], material: 0, layer: 0 };
    let names = [([0, 1], "bottom"), ([1, 2], "right"), ([2, 3], "top"), ([3, 0], "left")];
    let mesh = Mesh::new(vertices, &[quad], &[], &names).unwrap();
    let supports = [support("left", Direction::Normal), support("bottom", Direction::Normal)];
    let materials = steel();
    let load = [vec![traction("right", |p| p.outward.map(|n| 2.0 * n)), traction("top", |p| p.outward)]];
    for degree in [1, 3, 6] {
        for kept in [None, Some("left"), Some("top")] {
            let body = Body::new(problem(&mesh, degree, PLANE_STRESS, &materials, &supports, &load, kept)).unwrap();
            assert!(body.interface.rigid_motions.is_empty());
            let state = solved(&body, &[1.0]);
            let field = body.field(&state).unwrap();
            let exact = [2.0 * c * c + s * s, 2.0 * s * s + c * c, s * c, 0.0];
            assert!(stress_error(&field, &mesh, |_| exact) < 1e-11);
            let r = body.interface.reaction(0, &state);
            assert_relative_eq!(r[0], -2.0 * 0.7 * c, max_relative = 1e-11);
            assert_relative_eq!(r[1], -2.0 * 0.7 * s, max_relative = 1e-11);
        }
    }
}

#[test]
fn a_rigid_edge_carries_force_and_moment_like_a_beam() {
    // nu = 0: a bar of length 2, depth 1.5, thickness 0.7 on a clamped left end; force along and moment on the rigid right end give
    // t_x = F L / (E A) and theta = M L / (E I) exactly.
    let mesh = rectangle([0.0, 2.0], [-0.75, 0.75]);
    let materials = [Material::isotropic(1000.0, 0.0).unwrap()];
    let supports = [support("left", Direction::First), support("left", Direction::Second)];
    let rigid = RigidEdge { boundary: "right".into(), reference: [2.0, 0.0], free: [true; 3] };
    for kept in [None, Some("top")] {
        let body = Body::new(BodyProblem {
            rigid_edge: Some(rigid.clone()),
            ..problem(&mesh, 4, PLANE_STRESS, &materials, &supports, &[], kept)
        })
        .unwrap();
        let i = &body.interface;
        let [Some(x), Some(z), Some(theta)] = i.frame else { panic!("all three motions are free") };
        let mut load = TraceLoad { unknowns: vec![0.0; i.stiffness.nrows()], ..TraceLoad::default() };
        (load.unknowns[x], load.unknowns[theta]) = (3.0, 0.5);
        let factors = i.factors(&[]).unwrap();
        let u = i.solve(&faer_column(&i.right_hand_side(&load, &factors)), &i.rigid_modes);
        let (area, inertia) = (1.5 * 0.7, 0.7 * 1.5_f64.powi(3) / 12.0);
        assert_relative_eq!(u[(x, 0)], 3.0 * 2.0 / (1000.0 * area), max_relative = 1e-11);
        assert_relative_eq!(u[(theta, 0)], 0.5 * 2.0 / (1000.0 * inertia), max_relative = 1e-11);
        // Euler and Bernoulli: w = M L^2 / (2 E I), no shear in pure bending.
        assert_relative_eq!(u[(z, 0)], 0.5 * 4.0 / (2.0 * 1000.0 * inertia), max_relative = 1e-11);
        let state = InterfaceState { unknowns: (0..u.nrows()).map(|k| u[(k, 0)]).collect(), factors, load };
        let r = [0, 1].map(|s| i.reaction(s, &state));
        assert_abs_diff_eq!(r[0][0] + r[1][0], -3.0, epsilon = 1e-10);
        assert_abs_diff_eq!(r[0][1] + r[1][1], 0.0, epsilon = 1e-10);
        assert_abs_diff_eq!(r[0][2] + r[1][2], -0.5, epsilon = 1e-10);
    }
}

#[test]
fn a_rigid_edge_that_only_shifts_carries_the_force_of_all_its_vertices() {
    let mesh = rectangle([0.0, 2.0], [-0.75, 0.75]);
    let materials = [Material::isotropic(1000.0, 0.0).unwrap()];
    let supports = [support("left", Direction::First), support("left", Direction::Second)];
    for free in [[true, false, false], [true, true, false]] {
        let rigid = RigidEdge { boundary: "right".into(), reference: [2.0, 0.0], free };
        let body = Body::new(BodyProblem {
            rigid_edge: Some(rigid),
            ..problem(&mesh, 4, PLANE_STRESS, &materials, &supports, &[], None)
        })
        .unwrap();
        let stiffness = &body.interface.stiffness;
        assert_relative_eq!(stiffness[(0, 0)], 1000.0 * 1.5 * 0.7 / 2.0, max_relative = 1e-11);
        // A cantilever without rotation of its end: between Euler and Bernoulli's 12 E I / L^3 and half of it, for shear.
        if free[1] {
            let bending = 12.0 * 1000.0 * 0.7 * 1.5_f64.powi(3) / 12.0 / 8.0;
            assert!((0.3 * bending..bending).contains(&stiffness[(1, 1)]), "{} {bending}", stiffness[(1, 1)]);
        }
    }
}

#[test]
fn a_rigid_edge_without_free_motion_is_a_clamp() {
    let mesh = patch([0; 4], Shape::Straight, 0.0);
    let materials = steel();
    let load = [vec![traction("right", |p| [1.0, p.position[1]])]];
    let clamp = [support("left", Direction::First), support("left", Direction::Second)];
    let a = Body::new(problem(&mesh, 5, PLANE_STRESS, &materials, &clamp, &load, None)).unwrap();
    let rigid = RigidEdge { boundary: "left".into(), reference: [0.3, 0.1], free: [false; 3] };
    let b = Body::new(BodyProblem { rigid_edge: Some(rigid), ..problem(&mesh, 5, PLANE_STRESS, &materials, &[], &load, None) })
        .unwrap();
    let energy = [&a, &b].map(|b| b.interface.strain_energy(&solved(b, &[1.0])));
    assert_relative_eq!(energy[0], energy[1], max_relative = 1e-12);
}

#[test]
fn a_curved_rigid_edge_turns_as_a_line_about_a_point_off_it_and_its_reaction_balances() {
    // A patch with arcs, its top turning about a point, its left end loaded: what the top takes is what is pressed on.
    let materials = steel();
    let pin = [2.0, 3.5];
    let load = [vec![traction("right", |p| [1.0, 0.3 * p.position[1]])]];
    for turns in TURNS {
        let mesh = patch(turns, Shape::Arcs, 0.0);
        let rigid = RigidEdge { boundary: "top".into(), reference: pin, free: [false, false, true] };
        let problem = BodyProblem {
            rigid_edge: Some(rigid),
            edge_reaction: true,
            ..problem(&mesh, 9, PLANE_STRESS, &materials, &[], &load, Some("left"))
        };
        let body = Body::new(problem).unwrap();
        let i = &body.interface;
        // Free, it turns about the pin without strain, but for what degree 9 leaves of the sines.
        let [[x, z, theta]] = i.rigid_motions[..] else { panic!("{:?}", i.rigid_motions) };
        assert!((x - theta * pin[1]).abs() < 1e-12 * theta.abs() && (z + theta * pin[0]).abs() < 1e-12 * theta.abs());
        let strain = &i.stiffness * &i.rigid_modes;
        assert!(strain.norm_max() < 1e-8 * i.stiffness.norm_max() * i.rigid_modes.norm_max().max(1.0));
        // A force on the kept edge that balances the load about the pin leaves the body at rest, and the pin takes the rest of the force.
        let Some(unknown) = i.frame[2] else { panic!("the turn is free") };
        let loads = afloat(&body, &[1.0]);
        let moment = -(0..i.stiffness.nrows()).map(|k| i.rigid_modes[(k, 0)] * i.columns[(k, 0)]).sum::<f64>()
            / i.rigid_modes[(unknown, 0)];
        let mut load = loads.load.clone();
        load.unknowns[unknown] = moment;
        let right = i.right_hand_side(&load, &loads.factors);
        let state = InterfaceState { unknowns: i.solve_one(&right), factors: loads.factors, load };
        let force = integral(&mesh, "right", |p| [1.0, 0.3 * p[1]]);
        let r = i.reaction(0, &state);
        assert_relative_eq!(r[0], -force[0], max_relative = 1e-9);
        assert_relative_eq!(r[1], -force[1], max_relative = 1e-9);
        // About the origin: the reaction of the line takes what the moment on it does not balance, at the pin.
        assert_relative_eq!(r[2], -force[2], max_relative = 1e-9);
        let field = body.field(&state).unwrap();
        let theta = state.unknowns[unknown];
        for cell in [2, 3] {
            for (xi, eta) in sample_points() {
                let x = field.position(cell, xi, eta);
                let on_top = mesh.boundary("top").unwrap().into_iter().any(|e| {
                    (0..=400).any(|k| {
                        let y = mesh.edges[e].curve.point(f64::from(k) / 200.0 - 1.0);
                        (y[0] - x[0]).hypot(y[1] - x[1]) < 1e-9
                    })
                });
                if on_top {
                    let u = field.at(cell, xi, eta).unwrap().displacement;
                    let wanted = [-theta * (x[1] - pin[1]), theta * (x[0] - pin[0])];
                    let size = theta.abs() * 1e-9 + 1e-18;
                    assert!((u[0] - wanted[0]).abs() < size && (u[1] - wanted[1]).abs() < size, "{u:?} {wanted:?}");
                }
            }
        }
    }
}

/// Force and moment about the origin of a traction on a boundary of a body of the usual thickness.
fn integral(mesh: &Mesh, boundary: &str, traction: impl Fn([f64; 2]) -> [f64; 2]) -> [f64; 3] {
    let thickness = PLANE_STRESS.thickness().unwrap();
    let rule = gauss(20);
    let mut sum = [0.0; 3];
    for e in mesh.boundary(boundary).unwrap() {
        for (t, w) in rule.points.iter().zip(&rule.weights) {
            let (x, d) = (mesh.edges[e].curve.point(*t), mesh.edges[e].curve.derivative(*t));
            let q = traction(x).map(|q| q * w * thickness * d[0].hypot(d[1]));
            (sum[0], sum[1], sum[2]) = (sum[0] + q[0], sum[1] + q[1], sum[2] + x[0] * q[1] - x[1] * q[0]);
        }
    }
    sum
}

#[test]
fn an_edge_that_slides_at_an_angle_leaves_that_translation_alone() {
    let mesh = patch([0; 4], Shape::Arcs, 0.0);
    let angle = 0.6_f64;
    let problem =
        BodyProblem::new(mesh, 5, PLANE_STRESS).material(steel()[0]).support(Support::sliding("top", angle)).keep("left");
    let body = Body::new(problem).unwrap();
    let [[x, z, theta]] = body.interface.rigid_motions[..] else { panic!("{:?}", body.interface.rigid_motions) };
    assert_relative_eq!(z / x, angle.tan(), max_relative = 1e-12);
    assert_abs_diff_eq!(theta, 0.0, epsilon = 1e-12);
}

#[test]
fn the_energy_of_the_interface_leaves_out_the_work_of_prescribed_displacements() {
    let mesh = rectangle([0.0, 2.0], [0.0, 1.5]);
    let moved = 1e-3;
    let problem = BodyProblem::new(mesh, 2, PLANE_STRESS).material(steel()[0]).roller("left").roller("bottom");
    let problem = problem.support(Support::moved("right", Direction::First, moved));
    let problem = problem.load("press", EdgeTraction::new("top", |_| [0.0, -30.0]));
    for kept in [None, Some("top")] {
        let body = Body::new(kept.map_or(problem.clone(), |name| problem.clone().keep(name))).unwrap();
        let held = body.solve(&[]).unwrap();
        let whole = |state: &InterfaceState| body.field(state).unwrap().strain_energy();
        let volume = 2.0 * 1.5 * 0.7;
        assert_relative_eq!(whole(&held), 0.5 * 210e3 * (moved / 2.0_f64).powi(2) * volume, max_relative = 1e-11);
        assert!(body.interface.strain_energy(&held).abs() < 1e-12 * whole(&held));
        let state = body.solve(&[("press", 1.0)]).unwrap();
        let reactions = 0.5 * body.interface.reaction(2, &state)[0] * moved;
        assert_relative_eq!(body.interface.strain_energy(&state) + reactions, whole(&state), max_relative = 1e-11);
    }
}

#[test]
fn strain_energy_is_that_of_a_bar() {
    // U = s^2 V / (2 E).
    let mesh = rectangle([0.0, 2.0], [0.0, 1.5]);
    let materials = steel();
    let supports = [support("left", Direction::First), support("bottom", Direction::Second)];
    let load = [vec![traction("right", |_| [100.0, 0.0])]];
    for kept in [None, Some("right")] {
        let body = Body::new(problem(&mesh, 2, PLANE_STRESS, &materials, &supports, &load, kept)).unwrap();
        let u = body.interface.strain_energy(&solved(&body, &[1.0]));
        assert_relative_eq!(u, 1e4 * 2.0 * 1.5 * 0.7 / (2.0 * 210e3), max_relative = 1e-12);
    }
}
