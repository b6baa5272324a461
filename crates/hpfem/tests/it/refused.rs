//! Meshes and questions that cannot be, which once gave wrong answers or a panic.

use crate::classics::rectangle;
use crate::common::*;
use hpfem::*;

fn line(z: f64) -> Curve {
    Curve::Line { start: [0.0, z], end: [2.0, z] }
}

/// A rectangle of 2 x 1 cut by the breaks and levels.
fn ruled(breaks: &[f64], levels: &[f64], names: &[Named<'_>]) -> Result<Mesh, Error> {
    Mesh::ruled(&Ruled { bottom: line(0.0), top: line(1.0), breaks, levels, closed: false, material: 0, names })
}

fn quantity(result: Result<Mesh, Error>) -> (String, f64) {
    match result {
        Err(Error::OutOfRange { quantity, value, .. }) => (quantity, value),
        other => panic!("{other:?}"),
    }
}

#[test]
fn breaks_and_levels_that_do_not_run_from_end_to_end_are_refused() {
    let (breaks, levels) = ([-1.0, 0.2, 1.0], [0.0, 0.5, 1.0]);
    assert_eq!(ruled(&breaks, &levels, &[]).unwrap().cells.len(), 4);
    for few in [&[][..], &[-1.0], &[1.0]] {
        assert_eq!(quantity(ruled(few, &levels, &[])), ("the number of breaks of a ruled region".into(), few.len() as f64));
        assert_eq!(quantity(ruled(&breaks, few, &[])), ("the number of levels of a ruled region".into(), few.len() as f64));
    }
    for (wrong, at, value) in [
        (&[-1.0, 0.0][..], 1, 0.0),
        (&[0.0, 1.0], 0, 0.0),
        (&[-1.0, 2.0], 1, 2.0),
        (&[-1.0, 0.3, 0.3, 1.0], 2, 0.3),
        (&[-1.0, 0.3, 0.1, 1.0], 2, 0.1),
        (&[1.0, -1.0], 0, 1.0),
    ] {
        assert_eq!(quantity(ruled(wrong, &levels, &[])), (format!("number {at} of the breaks of a ruled region"), value));
    }
    assert_eq!(quantity(ruled(&breaks, &[0.0, 0.5], &[])), ("number 1 of the levels of a ruled region".into(), 0.5));
    for wrong in [[f64::NAN, 0.0, 1.0], [-1.0, f64::NAN, 1.0], [-1.0, 0.0, f64::NAN]] {
        assert!(matches!(ruled(&wrong, &levels, &[]), Err(Error::OutOfRange { .. })));
    }
    // Two columns of a closed region would share both vertices of their edges.
    let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: std::f64::consts::TAU, to: 0.0 };
    for breaks in [&[][..], &[-1.0], &[-1.0, 1.0], &[-1.0, 0.0, 1.0]] {
        let ring = Ruled { bottom: arc(1.0), top: arc(2.0), breaks, levels: &[0.0, 1.0], closed: true, material: 0, names: &[] };
        assert_eq!(quantity(Mesh::ruled(&ring)).1, breaks.len() as f64);
    }
}

#[test]
fn a_ruling_or_range_that_is_no_break_is_refused_by_its_name() {
    let (breaks, levels) = ([-1.0, 0.2, 1.0], [0.0, 0.5, 1.0]);
    let named = |side, range| ruled(&breaks, &levels, &[Named { side, range, name: "middle" }]);
    let edges = |side, range| named(side, range).unwrap().boundary("middle").unwrap().len();
    assert_eq!(edges(Side::Ruling(0.2), None), 2);
    assert_eq!(edges(Side::Ruling(0.2), Some([0.0, 0.5])), 1);
    assert_eq!(edges(Side::Top, Some([-1.0, 0.2])), 1);
    assert_eq!(edges(Side::Left, Some([0.5, 1.0])), 1);
    for (side, range, value, what) in [
        (Side::Ruling(0.3), None, 0.3, "the parameter of the ruling \"middle\""),
        (Side::Ruling(f64::NAN), None, f64::NAN, "the parameter of the ruling \"middle\""),
        (Side::Ruling(0.2), Some([0.0, 0.7]), 0.7, "an end of the range of \"middle\""),
        (Side::Bottom, Some([-0.9, 0.2]), -0.9, "an end of the range of \"middle\""),
        (Side::Right, Some([0.2, 1.0]), 0.2, "an end of the range of \"middle\""),
        (Side::Top, Some([0.2, -1.0]), -1.0, "the end of the range of \"middle\""),
        (Side::Top, Some([0.2, 0.2]), 0.2, "the end of the range of \"middle\""),
    ] {
        let (quantity, number) = quantity(named(side, range));
        assert!(quantity == what && (number == value || value.is_nan()), "{side:?}: {quantity} {number}");
    }
}

/// A ring between two curves through points of arcs, over less and over more than a turn.
#[test]
fn a_ruled_region_that_lies_on_itself_is_refused() {
    let ring = |turns: f64| {
        let arc = |radius: f64| {
            Curve::interpolated(8, move |t| {
                let angle = turns * std::f64::consts::PI * (1.0 + t);
                [radius * angle.cos(), radius * angle.sin()]
            })
        };
        let breaks: Vec<f64> = (0..=12).map(|i| f64::from(i) / 6.0 - 1.0).collect();
        let (bottom, top) = (arc(2.0), arc(1.0));
        Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &[0.0, 1.0], closed: false, material: 0, names: &[] })
    };
    assert!(ring(0.9).is_ok());
    assert!(matches!(ring(1.15), Err(Error::CellsOverlap { .. })));
}

#[test]
fn a_mesh_without_cells_and_cells_on_one_place_are_refused() {
    assert_eq!(Mesh::new(vec![[0.0; 2]], &[], &[], &[]), Err(Error::NoCells));
    let quad = |corners| Quad { corners, material: 0, layer: 0 };
    let two = |shift: [f64; 2]| {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let vertices = square.into_iter().chain(square.map(|x| [x[0] + shift[0], x[1] + shift[1]])).collect();
        Mesh::new(vertices, &[quad([0, 1, 2, 3]), quad([4, 5, 6, 7])], &[], &[])
    };
    for shift in [[0.0, 0.0], [0.3, 0.2], [-0.45, 0.45], [0.0, 0.4]] {
        let error = two(shift).unwrap_err();
        assert!(matches!(error, Error::CellsOverlap { a: 0, b: 1, .. }), "{shift:?}: {error}");
    }
    // Side by side with vertices of their own: the faces of a slit.
    for shift in [[1.0, 0.0], [0.0, -1.0], [1.5, 0.0], [1.0, 1.0]] {
        assert_eq!(two(shift).unwrap().cells.len(), 2);
    }
    // A small triangle inside a cell; cells whose boxes overlap, but not they themselves.
    let vertices = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.7, 0.7], [0.8, 0.7], [0.7, 0.8]];
    let error = Mesh::new(vertices, &[quad([0, 1, 2, 3]), quad([4, 5, 6, 6])], &[], &[]).unwrap_err();
    assert!(matches!(error, Error::CellsOverlap { a: 1, b: 0, .. }), "{error}");
    let vertices = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 0.2], [1.0, 1.0], [0.2, 1.0]];
    assert!(Mesh::new(vertices, &[quad([0, 1, 2, 2]), quad([3, 4, 5, 5])], &[], &[]).is_ok());
    // A cell in the hollow of a curved one.
    let vertices = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0], [0.9, 0.05], [1.1, 0.05], [1.1, 0.25], [0.9, 0.25]];
    let cells = [quad([0, 1, 2, 3]), quad([4, 5, 6, 7])];
    let hollow = Curve::interpolated(4, |t| [1.0 + t, 0.5 * (1.0 - t * t)]);
    assert!(Mesh::new(vertices.clone(), &cells, &[([0, 1], hollow)], &[]).is_ok());
    assert!(matches!(Mesh::new(vertices, &cells, &[], &[]), Err(Error::CellsOverlap { .. })));
}

#[test]
fn a_cell_beyond_the_mesh_is_an_error_of_the_field() {
    let mesh = rectangle([0.0, 1.0], [0.0, 1.0]);
    let (materials, supports) = (steel(), [support("left", Direction::First), support("bottom", Direction::Second)]);
    let load = [vec![traction("right", |_| [1.0, 0.0])]];
    let body = Body::new(problem(&mesh, 3, PLANE_STRESS, &materials, &supports, &load, None)).unwrap();
    let field = body.field(&solved(&body, &[1.0])).unwrap();
    assert!(field.at(0, 0.0, 0.0).is_ok());
    assert!(matches!(field.at(7, 0.0, 0.0), Err(Error::Beyond { index: 7, count: 1, .. })));
}

#[test]
fn singular_vertices_of_cells_without_material_are_refused() {
    let mesh = rectangle([0.0, 1.0], [0.0, 1.0]);
    let error = singular_vertices(&mesh, PLANE_STRAIN, &[], &[], &[]).unwrap_err();
    assert!(matches!(error, Error::Beyond { index: 0, count: 0, .. }), "{error}");
    assert!(matches!(Corner::at(&mesh, 0, PLANE_STRAIN, &[], &[]), Err(Error::Beyond { .. })));
}

#[test]
fn sequences_of_different_lengths_have_no_estimate() {
    assert_eq!(sequence_estimate(&[vec![3.0], vec![4.0]]), Ok(0.25));
    for wrong in [&[][..], &[vec![1.0]]] {
        assert!(matches!(sequence_estimate(wrong), Err(Error::Count { expected: 2, .. })));
    }
    let error = sequence_estimate(&[vec![1.0, 2.0], vec![1.0], vec![1.0, 2.0]]).unwrap_err();
    assert!(matches!(error, Error::Count { given: 1, expected: 2, .. }), "{error}");
    let mesh = rectangle([0.0, 1.0], [0.0, 1.0]);
    let ever_more = |_: &Mesh, degrees: &[usize]| Ok(vec![1.0; degrees[0]]);
    assert!(matches!(adapt(&mesh, &[], 1e-3, 8, ever_more), Err(Error::Count { .. })));
}

#[test]
fn quantities_that_are_none_or_not_finite_have_no_estimate() {
    let mesh = rectangle([0.0, 1.0], [0.0, 1.0]);
    let of = |values: Vec<f64>| adapt(&mesh, &[], 1e-3, 8, |_, _| Ok(values.clone())).unwrap_err();
    assert!(matches!(of(vec![]), Error::Count { given: 0, expected: 1, .. }), "{}", of(vec![]));
    for value in [f64::NAN, f64::INFINITY] {
        let error = of(vec![1.0, value]);
        assert!(error.to_string().starts_with("quantity 1 of the level of degree 2 is"), "{error}");
    }
    assert!(matches!(sequence_estimate(&[vec![], vec![]]), Err(Error::Count { given: 0, .. })));
    let error = sequence_estimate(&[vec![1.0], vec![f64::NAN]]).unwrap_err();
    assert!(error.to_string().starts_with("quantity 0 of approximation 1 is NaN"), "{error}");
    let corner = [SingularVertex { vertex: 0, exponent: 0.5 }];
    for p in [0, 25] {
        assert!(matches!(graded_level(&mesh, &corner, p), Err(Error::OutOfRange { .. })));
    }
}

#[test]
fn angles_that_are_not_finite_are_refused() {
    let material = Material::isotropic(100.0, 0.3).unwrap();
    let problem = || BodyProblem::new(rectangle([0.0, 1.0], [0.0, 1.0]), 2, PLANE_STRESS).material(material);
    for angle in [f64::NAN, f64::INFINITY] {
        let text = material.turned(angle).unwrap_err().to_string();
        assert!(text.contains("the angle that a material is turned by"), "{text}");
        let text = Body::new(problem().clamp("left").hold("right", Direction::Inclined(angle))).err().unwrap().to_string();
        assert!(text.contains("the angle of the support of \"right\"") && text.contains("must be finite"), "{text}");
        let supports = [Support::sliding("left", angle)];
        assert!(matches!(Body::new(problem().support(supports[0].clone())), Err(Error::OutOfRange { .. })));
        let mesh = rectangle([0.0, 1.0], [0.0, 1.0]);
        assert!(matches!(singular_vertices(&mesh, PLANE_STRAIN, &[material], &supports, &[]), Err(Error::OutOfRange { .. })));
        let pins = vec![Pin { vertex: 2, direction: Direction::Inclined(angle) }];
        let text = Body::new(BodyProblem { pins, ..problem().clamp("left") }).err().unwrap().to_string();
        assert!(text.contains("the angle of the pin at vertex 2"), "{text}");
    }
    assert_eq!(material.turned(0.3), Ok(material));
}

#[test]
fn the_largest_index_there_is_is_beyond_the_last_one() {
    let last = usize::MAX;
    let square = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let of = |corners, material| Mesh::new(square.clone(), &[Quad { corners, material, layer: 0 }], &[], &[]);
    let is_beyond = |error: Error, number: usize| matches!(error, Error::Beyond { index, .. } if index == number);
    assert!(is_beyond(of([0, 1, 2, last], 0).unwrap_err(), last));
    let mesh = of([0, 1, 2, 3], 0).unwrap();
    assert!(is_beyond(mesh.cut_through(last, 0.0).unwrap_err(), last));
    assert!(is_beyond(mesh.cut_rows(&[last]).unwrap_err(), last));
    assert!(is_beyond(mesh.refined_towards(&[last], 0.15, 1).unwrap_err(), last));
    let steel = Material::isotropic(100.0, 0.3).unwrap();
    let problem = |mesh: &Mesh| BodyProblem::new(mesh.clone(), 2, PLANE_STRESS).material(steel);
    let pins = vec![Pin { vertex: last, direction: Direction::First }];
    assert!(is_beyond(Body::new(BodyProblem { pins, ..problem(&mesh) }).err().unwrap(), last));
    // A material beyond the list, in a mesh that is joined to another one too: it does not come round to the first.
    let beyond = of([0, 1, 2, 3], last).unwrap();
    assert!(is_beyond(Body::new(problem(&beyond)).err().unwrap(), last));
    assert!(is_beyond(singular_vertices(&beyond, PLANE_STRAIN, &[steel], &[], &[]).unwrap_err(), last));
    let beside = rectangle([1.0, 2.0], [0.0, 1.0]);
    for joined in [beyond.join(&beside, Joint::default()), beside.join(&beyond, Joint::default())] {
        let problem = problem(&joined.unwrap()).material(steel).material(steel);
        assert!(is_beyond(Body::new(problem).err().unwrap(), last));
    }
}

#[test]
#[should_panic(expected = "column 9 of an interface operator that has 1, counted from 0")]
fn the_work_of_a_column_that_there_is_not_is_told_by_its_number() {
    let problem = BodyProblem::new(rectangle([0.0, 1.0], [0.0, 1.0]), 2, PLANE_STRESS);
    let body = Body::new(problem.material(Material::isotropic(100.0, 0.3).unwrap()).keep("top")).unwrap();
    let state = body.solve(&[]).unwrap();
    body.interface.column_work(9, &state);
}

/// A sheet turned by 0.3 far from the origin, `n` cells a side.
fn turned_sheet(n: usize, far: f64) -> Mesh {
    let (s, c) = 0.3_f64.sin_cos();
    let at = |i: usize, j: usize| {
        let (u, v) = (2.0 * i as f64 / n as f64, j as f64 / n as f64);
        [far + c * u - s * v, 0.7 * far + s * u + c * v]
    };
    let k = |i: usize, j: usize| j * (n + 1) + i;
    let vertices = (0..=n).flat_map(|j| (0..=n).map(move |i| at(i, j))).collect();
    let cell =
        |(i, j): (usize, usize)| Quad { corners: [k(i, j), k(i + 1, j), k(i + 1, j + 1), k(i, j + 1)], material: 0, layer: 0 };
    let cells: Vec<Quad> = (0..n).flat_map(|j| (0..n).map(move |i| (i, j))).map(cell).collect();
    let names: Vec<([usize; 2], &str)> = (0..n)
        .flat_map(|i| [([k(i, 0), k(i + 1, 0)], "bottom"), ([k(0, i), k(0, i + 1)], "left"), ([k(n, i), k(n, i + 1)], "right")])
        .collect();
    Mesh::new(vertices, &cells, &[], &names).unwrap()
}

#[test]
fn rollers_in_one_line_slide_wherever_they_lie() {
    let (s, c) = 0.3_f64.sin_cos();
    for far in [0.0, 1e3, 1e4] {
        let problem = BodyProblem::new(turned_sheet(12, far), 2, PLANE_STRESS).material(Material::isotropic(100.0, 0.3).unwrap());
        let body = problem.roller("left").roller("bottom").load("pull", EdgeTraction::new("right", move |_| [c, s]));
        let body = Body::new(body).unwrap();
        let field = body.field(&body.solve(&[("pull", 1.0)]).unwrap()).unwrap();
        let u = field.at(11, 1.0, -1.0).unwrap().displacement;
        assert!(((u[0] * c + u[1] * s) / 0.02 - 1.0).abs() < 1e-7, "{far}: {u:?}");
    }
}

#[test]
fn a_displacement_along_the_normal_points_out_of_the_body() {
    let mesh = rectangle([0.0, 2.0], [0.0, 1.0]);
    let out = [("left", [-1.0, 0.0]), ("right", [1.0, 0.0]), ("bottom", [0.0, -1.0]), ("top", [0.0, 1.0])];
    for (name, n) in out {
        let moved = Support::moved(name, Direction::Normal, 1e-3);
        let problem = BodyProblem::new(mesh.clone(), 2, PLANE_STRESS).material(Material::isotropic(100.0, 0.3).unwrap());
        let opposite = match name {
            "left" => "right",
            "right" => "left",
            "top" => "bottom",
            _ => "top",
        };
        let body = Body::new(problem.clamp(opposite).support(moved)).unwrap();
        let field = body.field(&body.solve(&[]).unwrap()).unwrap();
        let u = field.at(0, n[0], n[1]).unwrap().displacement;
        assert!((u[0] * n[0] + u[1] * n[1] - 1e-3).abs() < 1e-15, "{name}: {u:?}");
    }
}

#[test]
fn what_the_kinematics_has_no_meaning_for_is_refused() {
    let mesh = rectangle([1.0, 2.0], [0.0, 1.0]);
    let material = Material::isotropic(100.0, 0.3).unwrap().conducting([[1.0, 0.0], [0.0, 1.0]]).unwrap();
    let problem = |kinematics| BodyProblem::new(mesh.clone(), 2, kinematics).material(material);
    let meaningless = |problem: BodyProblem| matches!(Body::new(problem), Err(Error::NoMeaning { .. }));
    let rigid = |free| Some(RigidEdge { boundary: "top".into(), reference: [1.5, 1.0], free });
    for kinematics in [Kinematics::Torsion, Kinematics::Potential { thickness: 1.0 }, Kinematics::AxisymmetricPotential] {
        assert!(meaningless(problem(kinematics).clamp("left").hold("right", Direction::Second)));
        assert!(meaningless(problem(kinematics).clamp("left").roller("right")));
        assert!(meaningless(BodyProblem { rigid_edge: rigid([true, false, false]), ..problem(kinematics).clamp("bottom") }));
        assert!(meaningless(problem(kinematics).clamp("left").load("hot", Eigenstrain::thermal(&[1e-5], |_| 100.0))));
        assert!(meaningless(problem(kinematics).clamp("left").load("press", EdgeTraction::pressure("right", |_| 1.0))));
        assert!(meaningless(problem(kinematics).clamp("left").load("weight", BodyForce::weight(1.0, [0.0, -1.0]))));
        assert!(meaningless(problem(kinematics).clamp("left").load("spin", BodyForce::spin(1.0, 1.0))));
    }
    assert!(meaningless(problem(PLANE_STRESS).clamp("left").load("spin", BodyForce::spin(1.0, 1.0))));
    let across = BodyForce::weight(1.0, [-1.0, 0.0]);
    assert!(meaningless(problem(Kinematics::Axisymmetric).clamp("left").load("weight", across)));
    assert!(meaningless(BodyProblem {
        rigid_edge: rigid([false, true, true]),
        ..problem(Kinematics::Axisymmetric).roller("bottom")
    }));
}

#[test]
fn supports_against_a_free_motion_of_the_rigid_edge_are_refused() {
    let rigid = |free| Some(RigidEdge { boundary: "right".into(), reference: [2.0, 0.0], free });
    let problem = |free| {
        let problem = BodyProblem::new(rectangle([0.0, 2.0], [0.0, 1.0]), 2, PLANE_STRESS);
        BodyProblem { rigid_edge: rigid(free), ..problem.material(Material::isotropic(100.0, 0.3).unwrap()) }
    };
    let tied = |problem: BodyProblem| matches!(Body::new(problem), Err(Error::TiedAndHeld { .. }));
    assert!(tied(problem([true; 3]).clamp("bottom")));
    assert!(tied(problem([true, false, false]).clamp("bottom")));
    assert!(tied(problem([false; 3]).support(Support::moved("bottom", Direction::Second, 0.1)).hold("bottom", Direction::First)));
    assert!(tied(BodyProblem { pins: vec![Pin { vertex: 2, direction: Direction::First }], ..problem([true; 3]) }));
    assert!(Body::new(problem([true, false, false]).hold("bottom", Direction::Second).hold("left", Direction::First)).is_ok());
}

#[test]
fn numbers_that_are_not_finite_are_refused_wherever_they_come_in() {
    let problem = BodyProblem::new(rectangle([0.0, 2.0], [0.0, 1.0]), 2, PLANE_STRESS);
    let problem = problem
        .material(Material::isotropic(100.0, 0.3).unwrap())
        .clamp("left")
        .load("pull", EdgeTraction::new("right", |p| p.outward));
    let mut body = Body::new(problem.clone()).unwrap();
    let loads: [Load; 3] = [
        BodyForce::new(|_| [f64::NAN, 0.0]).into(),
        EdgeTraction::new("left", |_| [f64::INFINITY, 0.0]).into(),
        Eigenstrain::new(|_| [f64::NAN; 4]).into(),
    ];
    for load in loads {
        let case = LoadCase::new("bad").with(load.clone());
        assert!(matches!(body.add_load(case), Err(Error::OutOfRange { .. })));
        assert!(Body::new(problem.clone().load("bad", load)).is_err());
    }
    assert!(body.solve(&[("pull", 1.0)]).is_ok());
    assert!(matches!(body.solve(&[("pull", f64::NAN)]), Err(Error::OutOfRange { .. })));
    let other = Body::new(problem.keep("top")).unwrap();
    assert!(matches!(body.field(&other.solve(&[("pull", 1.0)]).unwrap()), Err(Error::Count { .. })));
}

/// A body that keeps no boundary has no unknown left that the number would stand in.
#[test]
fn the_load_case_of_a_number_that_is_not_finite_is_told_by_its_name() {
    let held = BodyProblem::new(rectangle([0.0, 2.0], [0.0, 1.0]), 6, PLANE_STRESS);
    let held = held.material(Material::isotropic(100.0, 0.3).unwrap()).clamp("left");
    // The last strain has no part in plane stress.
    let strains = [[f64::NAN; 4], [0.0, 0.0, 0.0, f64::NAN], [0.0, f64::INFINITY, 0.0, 0.0]];
    let strains = strains.map(|strain| Load::from(Eigenstrain::new(move |_| strain)));
    for load in [Load::from(BodyForce::new(|_| [f64::NAN, 0.0]))].into_iter().chain(strains) {
        let body = held.clone().load("good", BodyForce::new(|_| [1.0, 0.0])).load("bad", load);
        let error = Body::new(body).err().unwrap().to_string();
        assert!(error.contains("load case \"bad\""), "{error}");
    }
    let error = Body::new(held).unwrap().solve(&[("zz", 1.0)]).unwrap_err().to_string();
    assert_eq!(error, "the body has no load case \"zz\"; it has: none");
}

#[test]
fn supports_that_agree_but_for_round_off_are_taken() {
    let problem = BodyProblem::new(rectangle([0.0, 1.0], [0.0, 1.0]), 3, PLANE_STRESS);
    let problem = problem.material(Material::isotropic(100.0, 0.3).unwrap()).hold("right", Direction::First);
    let bent = Support::moved("bottom", Direction::First, 0.0).varying(|x| 1e-3 * (std::f64::consts::PI * x[0]).sin());
    assert!(Body::new(problem.support(bent).hold("bottom", Direction::Second)).is_ok());
    assert!(Material::conductor(1e-200).is_ok());
    // Round-off of a displacement at a pin and on the axis of revolution.
    let sine = |x: [f64; 2]| 1e-3 * (std::f64::consts::PI * (x[0] + 1.0)).sin();
    let bent = |mesh: Mesh, kinematics| {
        let problem = BodyProblem::new(mesh, 3, kinematics).material(Material::isotropic(100.0, 0.3).unwrap());
        problem.support(Support::moved("bottom", Direction::First, 0.0).varying(sine)).hold("bottom", Direction::Second)
    };
    let pins = vec![Pin { vertex: 1, direction: Direction::First }];
    let square = || rectangle([0.0, 1.0], [0.0, 1.0]);
    assert!(Body::new(BodyProblem { pins, ..bent(square(), PLANE_STRESS) }).is_ok());
    assert!(Body::new(bent(square(), Kinematics::Axisymmetric)).is_ok());
}

#[test]
fn numbers_that_are_none_are_refused_wherever_they_stand() {
    let square = ruled(&[-1.0, 1.0], &[0.0, 1.0], &[]).unwrap();
    let hole = |x: [f64; 2]| if x[0] > 0.4 && x[0] < 1.6 { [f64::NAN; 2] } else { x };
    assert!(matches!(square.mapped(hole), Err(Error::FoldedCell { .. })));
    let mesh = rectangle([0.0, 2.0], [0.0, 1.0]);
    let gap_between = |[_, z]: [f64; 2]| if z > 0.05 && z < 0.4 { f64::NAN } else { 0.0 };
    let problem =
        BodyProblem::new(mesh, 5, Kinematics::PlaneStrain { thickness: 1.0 }).material(Material::isotropic(1.0, 0.3).unwrap());
    let body = Body::new(problem.clamp("left").support(Support::hold("right", Direction::First).varying(gap_between)));
    assert!(matches!(body, Err(Error::OutOfRange { quantity, .. }) if quantity == "the displacement of support \"right\""));
}
