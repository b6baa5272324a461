//! Loads added to a body that is factorised already: the body factorised with them.

use crate::common::*;
use hpfem::*;

const KINEMATICS: [Kinematics; 3] = [PLANE_STRESS, PLANE_STRAIN, Kinematics::Axisymmetric];

/// A load case of each kind, and of all kinds together.
fn cases() -> Vec<LoadCase> {
    let part = EdgeTraction::new("right", |p| [p.position[1], 0.3]).within([0.2, 1.1]);
    let whole = EdgeTraction::pressure("bottom", |x| x[0] * x[0]);
    let weight = BodyForce::new(|x| [x[1] * x[0], -2.0]);
    let point = PointForce::new([2.3, 1.4], [3.0, -1.0]);
    let heat = Eigenstrain::thermal(&[1e-5], |place| place.position[0].exp());
    vec![
        LoadCase::new("part").with(part.clone()),
        LoadCase::new("pressure").with(whole),
        LoadCase::new("weight").with(weight.clone()),
        LoadCase::new("point").with(point),
        LoadCase::new("heat").with(heat.clone()),
        LoadCase::new("all").with(part).with(weight).with(point).with(heat),
    ]
}

/// The patch with a load case and a prescribed displacement of its own.
fn base(mesh: &Mesh, kinematics: Kinematics, kept: Option<&str>) -> BodyProblem {
    let supports = [Support::hold("left", Direction::First), Support::moved("left", Direction::Second, 1e-4)];
    problem(mesh, 5, kinematics, &steel(), &supports, &[], kept)
        .load("shear", traction("top", |p| [p.position[0], 0.0]))
        .load("shear", BodyForce::new(|x| [0.0, x[0]]))
}

fn same(a: &faer::Mat<f64>, b: &faer::Mat<f64>, what: &str) {
    let difference = (a - b).norm_max();
    assert!(difference <= 1e-11 * b.norm_max(), "{what}: {difference:.1e} of {:.1e}", b.norm_max());
}

/// Compares two bodies by their operators, and their states under all load cases.
fn assert_same(later: &Body, whole: &Body) {
    let (a, b) = (&later.interface, &whole.interface);
    assert_eq!(a.load_cases, b.load_cases);
    same(&a.columns, &b.columns, "columns");
    same(&a.work, &b.work, "work");
    let names = b.load_cases.iter().enumerate();
    let acting: Vec<(&str, f64)> = names.map(|(k, name)| (name.as_str(), 1.0 + 0.3 * k as f64)).collect();
    let (s, t) = (later.solve(&acting).unwrap(), whole.solve(&acting).unwrap());
    for support in 0..2 {
        let (r, wanted) = (a.reaction(support, &s), b.reaction(support, &t));
        let size = wanted.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        r.iter().zip(wanted).for_each(|(r, w)| assert!((r - w).abs() <= 1e-11 * size, "{r} {w}"));
    }
    let (f, g) = (later.field(&s).unwrap(), whole.field(&t).unwrap());
    let (mut error, mut size) = ([0.0_f64; 2], [0.0_f64; 2]);
    for (cell, (xi, eta)) in (0..f.cells()).flat_map(|c| sample_points().map(move |x| (c, x))) {
        let (x, y) = (f.at(cell, xi, eta).unwrap(), g.at(cell, xi, eta).unwrap());
        let both = [(&x.displacement[..], &y.displacement[..]), (&x.stress[..], &y.stress[..])];
        for (k, (x, y)) in both.into_iter().enumerate() {
            for (x, y) in x.iter().zip(y) {
                error[k] = error[k].max((x - y).abs());
                size[k] = size[k].max(y.abs());
            }
        }
    }
    assert!((0..2).all(|k| error[k] <= 1e-11 * size[k]), "{error:?} of {size:?}");
}

#[test]
fn a_load_added_later_gives_the_body_factorised_with_it() {
    for mesh in [patch(TURNS[6], Shape::Arcs, 0.0), mixed(TURNS[4], Shape::Polynomial(3), 0.0)] {
        for kinematics in KINEMATICS {
            for kept in [None, Some("right"), Some("bottom")] {
                let mut later = Body::new(base(&mesh, kinematics, kept)).unwrap();
                let mut problem = base(&mesh, kinematics, kept);
                for case in cases() {
                    later.add_load(case.clone()).unwrap();
                    problem.load_cases.push(case);
                    assert_same(&later, &Body::new(problem.clone()).unwrap());
                }
                assert_eq!(later.problem().load_cases.len(), problem.load_cases.len());
            }
        }
    }
}

#[test]
fn a_body_without_loads_takes_them_all_later_and_a_copy_keeps_its_own() {
    let mesh = patch(TURNS[5], Shape::Arcs, 0.0);
    let bare = || BodyProblem { load_cases: Vec::new(), ..base(&mesh, PLANE_STRAIN, Some("top")) };
    let empty = Body::new(bare()).unwrap();
    let mut later = empty.clone();
    cases().into_iter().for_each(|case| later.add_load(case).unwrap());
    assert_same(&later, &Body::new(BodyProblem { load_cases: cases(), ..bare() }).unwrap());
    assert_same(&empty, &Body::new(bare()).unwrap());
}

#[test]
fn loads_added_at_once_are_those_added_one_after_the_other() {
    for mesh in [patch(TURNS[6], Shape::Arcs, 0.0), mixed(TURNS[4], Shape::Polynomial(3), 0.0)] {
        for kept in [None, Some("bottom")] {
            let mut problem = base(&mesh, PLANE_STRAIN, kept);
            let mut later = Body::new(problem.clone()).unwrap();
            let (first, others) = (cases().remove(0), cases().split_off(1));
            later.add_load(first).unwrap();
            later.add_loads(others.clone()).unwrap();
            problem.load_cases.extend(cases());
            let same = Body::new(problem).unwrap();
            assert_same(&later, &same);
            // All or none: one name is known, or comes twice.
            let name = others[0].name.clone();
            let new = || LoadCase::new("new").with(EdgeTraction::pressure("top", |_| 1.0));
            for refused in [vec![new(), others[0].clone()], vec![new(), others[0].clone(), others[0].clone()]] {
                assert_eq!(later.add_loads(refused), Err(Error::DuplicateLoadCase { name: name.clone() }));
            }
            assert_eq!(later.add_loads(vec![new(), new()]), Err(Error::DuplicateLoadCase { name: "new".into() }));
            let nowhere = LoadCase::new("roof").with(EdgeTraction::pressure("roof", |_| 1.0));
            assert!(matches!(later.add_loads(vec![new(), nowhere]), Err(Error::NoSuchBoundary { .. })));
            // Found where the loads are made.
            let outside = LoadCase::new("far").with(PointForce::new([9.0, 9.0], [1.0, 0.0]));
            assert!(matches!(later.add_loads(vec![new(), outside]), Err(Error::OutsideMesh { .. })));
            assert_same(&later, &same);
            assert_eq!(later.problem().load_cases.len(), same.problem().load_cases.len());
        }
    }
}

#[test]
fn a_case_of_the_same_name_is_replaced_and_cases_of_the_factorisation_are_not() {
    let mesh = mixed(TURNS[6], Shape::Arcs, 0.0);
    let mut later = Body::new(base(&mesh, PLANE_STRESS, Some("right"))).unwrap();
    let before = later.solve(&[("shear", 1.0)]).unwrap();
    for case in cases() {
        later.add_load(LoadCase { name: "wind".into(), ..case }).unwrap();
        later.add_load(LoadCase::new("point").with(PointForce::new([1.6, 0.4], [1.0, 0.0]))).unwrap();
    }
    let mut problem = base(&mesh, PLANE_STRESS, Some("right"));
    problem.load_cases.push(LoadCase { name: "wind".into(), ..cases().remove(5) });
    problem = problem.load("point", PointForce::new([1.6, 0.4], [1.0, 0.0]));
    assert_same(&later, &Body::new(problem).unwrap());
    // The state of before belongs to the body of before.
    assert!(matches!(later.field(&before), Err(Error::OtherLoads { given: 8, expected: 10 })));
    let known = later.interface.load_cases.clone();
    let twice = later.add_load(LoadCase::new("shear"));
    assert_eq!(twice, Err(Error::DuplicateLoadCase { name: "shear".into() }));
    let nowhere = later.add_load(LoadCase::new("roof").with(EdgeTraction::pressure("roof", |_| 1.0)));
    assert!(matches!(nowhere, Err(Error::NoSuchBoundary { .. })));
    let outside = later.add_load(LoadCase::new("far").with(PointForce::new([9.0, 9.0], [1.0, 0.0])));
    assert!(matches!(outside, Err(Error::OutsideMesh { .. })));
    assert_eq!(later.interface.load_cases, known);
    assert!(matches!(later.solve(&[("roof", 1.0)]), Err(Error::NoSuchLoadCase { .. })));
}
