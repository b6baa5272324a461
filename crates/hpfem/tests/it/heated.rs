//! Temperatures as load cases of a body that is reduced already: the body made with each of them.

use crate::common::*;
use crate::heat::conduction;
use faer::Mat;
use hpfem::*;

const REFERENCE: f64 = 20.0;
const EXPANSION: [f64; 1] = [1.2e-5];

/// An elastic body with prescribed displacements and loads of its own, one of them inside and one that came later.
fn cold(mesh: &Mesh, kinematics: Kinematics) -> BodyProblem {
    let supports = [Support::hold("left", Direction::First), Support::moved("left", Direction::Second, 1e-4)];
    problem(mesh, 5, kinematics, &steel(), &supports, &[], Some("right"))
        .load("shear", traction("top", |p| [p.position[0], 0.0]))
        .load("shear", BodyForce::new(|x| [0.0, x[0]]))
}

fn later() -> LoadCase {
    LoadCase::new("weight").with(BodyForce::new(|x| [x[1] * x[0], -2.0]))
}

/// The body of temperature, held at 35 degC below and warmed above.
fn temperature(mesh: &Mesh, kinematics: Kinematics) -> Body {
    Body::new(warming(mesh, kinematics)).unwrap()
}

/// The same with half the functions inside its cells: their space need not be that of the displacement.
fn temperature_in_trunk(mesh: &Mesh, kinematics: Kinematics) -> Body {
    Body::new(BodyProblem { space: SpaceKind::Trunk, ..warming(mesh, kinematics) }).unwrap()
}

fn warming(mesh: &Mesh, kinematics: Kinematics) -> BodyProblem {
    let problem = conduction(mesh, 5, kinematics).material(Material::conductor(1.4).unwrap());
    let problem = problem.support(Support::moved("bottom", Direction::First, 35.0)).keep("right");
    problem.load("0", traction("top", |p| [p.position[0], 0.0]))
}

/// As many states under heat into the kept boundary; the first is that without any.
fn cases(body: &Body, many: usize) -> Vec<TemperatureCase> {
    let operator = &body.interface;
    let n = operator.stiffness.nrows();
    let state = |k: usize| {
        let value = |i: usize| if k == 0 { 0.0 } else { ((3 * i + 7 * k) as f64).sin() };
        let load = TraceLoad { unknowns: (0..n).map(value).collect(), ..TraceLoad::default() };
        let mut factors = operator.factors_in_order(&[if k == 0 { 1.0 } else { 0.0 }]);
        factors[operator.prescribed_column()] = if k == 0 { 1.0 } else { 0.0 };
        InterfaceState { unknowns: operator.solve_one(&operator.right_hand_side(&load, &factors)), factors, load }
    };
    let reference = |k: usize| if k == 0 { REFERENCE } else { 0.0 };
    (0..many).map(|k| TemperatureCase { name: format!("heat {k}"), state: state(k), reference: reference(k) }).collect()
}

fn same(a: &Mat<f64>, b: &Mat<f64>, what: &str) {
    let difference = (a - b).norm_max();
    assert!(difference <= 1e-10 * b.norm_max(), "{what}: {difference:.1e} of {:.1e}", b.norm_max());
}

#[test]
fn temperatures_as_load_cases_give_what_a_body_made_with_them_gives() {
    for (kinematics, left) in [(PLANE_STRESS, 0.0), (PLANE_STRAIN, 0.0), (Kinematics::Axisymmetric, 0.0)] {
        for mesh in [patch([3, 2, 0, 1], Shape::Arcs, left), mixed([1, 3, 2, 0], Shape::Polynomial(3), left)] {
            // Fewer temperatures than a cell has unknowns on its boundary, and more.
            for (many, warm) in [
                (1, temperature as fn(&Mesh, Kinematics) -> Body),
                (3, temperature_in_trunk),
                (26, temperature),
                (26, temperature_in_trunk),
            ] {
                let warm = warm(&mesh, kinematics);
                let cases = cases(&warm, many);
                let mut body = Body::new(cold(&mesh, kinematics)).unwrap();
                body.add_load(later()).unwrap();
                let found = body.heated(&warm, &cases, &EXPANSION).unwrap();
                let mut problem = cold(&mesh, kinematics);
                problem.load_cases.push(later());
                for case in &cases {
                    let field = warm.field(&case.state).unwrap();
                    let strain = Eigenstrain::of_temperature(&EXPANSION, field, case.reference).unwrap();
                    problem.load_cases.push(LoadCase::new(case.name.clone()).with(strain));
                }
                let whole = Body::new(problem).unwrap().interface;
                assert_eq!(found.load_cases, whole.load_cases);
                let hot = |m: &Mat<f64>, rows: usize| m.submatrix(0, 2, rows, many).to_owned();
                let rows = whole.columns.nrows();
                same(&hot(&found.columns, rows), &hot(&whole.columns, rows), "columns");
                same(&hot(&found.work, 2), &hot(&whole.work, 2), "work");
                let (mut parts, wanted) = (found.into_parts(), whole.into_parts());
                same(&hot(&parts.reaction_constant, 6), &hot(&wanted.reaction_constant, 6), "reactions");
                // The work of reactions and prescribed displacements with heat is known, that of heat with heat is not.
                let between = parts.work.as_mut().submatrix_mut(2, 2, many, many);
                assert!(between.col_iter().flat_map(|column| column.iter()).all(|work| work.is_nan()));
                let [rest, expected] = [&parts.work, &wanted.work].map(|m| m.submatrix(2 + many, 2, 7, many).to_owned());
                same(&rest, &expected, "work of prescribed displacements and reactions");
            }
        }
    }
}

#[test]
fn a_body_made_for_temperatures_of_one_body_takes_those_of_another_one_in_the_same_states() {
    let (mesh, still): (_, Clock) = (patch([3, 2, 0, 1], Shape::Arcs, 0.5), || 0.0);
    let problem = warming(&mesh, PLANE_STRESS);
    let cooled = problem.clone().foundation(Foundation::new("left", 3.0, 0.0));
    let [own, other] = [problem, cooled].map(|problem| Body::of_temperature(problem, still).unwrap());
    let cases = cases(&own, 2);
    let body = Body::for_heat(cold(&mesh, PLANE_STRESS), &own, Some(&cases), &EXPANSION, still).unwrap();
    let hot = |body: &Body, by: &Body| body.heated(by, &cases, &EXPANSION).unwrap().columns;
    let plain = Body::new(cold(&mesh, PLANE_STRESS)).unwrap();
    same(&hot(&body, &own), &hot(&plain, &own), "its own");
    same(&hot(&body, &other), &hot(&plain, &other), "another body's");
    let none = Body::for_heat(cold(&mesh, PLANE_STRESS), &own, Some(&[]), &EXPANSION, still).unwrap();
    assert_eq!(none.heated(&own, &[], &EXPANSION).unwrap().columns, plain.interface.columns);
    let apart = (hot(&plain, &own) - hot(&plain, &other)).norm_max() / hot(&plain, &own).norm_max();
    assert!(apart > 1e-4, "{apart:.1e}");
}

#[test]
fn what_is_kept_of_the_cells_of_a_temperature_changes_nothing_it_is_asked_for() {
    let still: Clock = || 0.0;
    for kinematics in [PLANE_STRAIN, Kinematics::Axisymmetric] {
        for mesh in [patch([3, 2, 0, 1], Shape::Arcs, 0.5), mixed([1, 3, 2, 0], Shape::Polynomial(3), 0.5)] {
            let warm = temperature(&mesh, kinematics);
            let keeping = Body::of_temperature(warming(&mesh, kinematics), still).unwrap();
            same(&keeping.interface.stiffness, &warm.interface.stiffness, "stiffness");
            for many in [1, 26] {
                let cases = cases(&warm, many);
                let states: Vec<InterfaceState> = cases.iter().map(|case| case.state.clone()).collect();
                let [own, other] = [&keeping, &warm].map(|body| body.fields(&states).unwrap());
                for (a, b) in own.iter().zip(&other) {
                    for cell in 0..mesh.cells.len() {
                        let [a, b] = [a, b].map(|field| field.at(cell, 0.2, 0.1).unwrap().displacement[0]);
                        assert!((a - b).abs() <= 1e-11 * b.abs().max(1.0), "{a} {b}");
                    }
                }
                for known in [None, Some(&cases[..])] {
                    let hot = |body: &Body| {
                        let cold = Body::for_heat(cold(&mesh, kinematics), body, known, &EXPANSION, still).unwrap();
                        cold.heated(body, &cases, &EXPANSION).unwrap().columns
                    };
                    same(&hot(&keeping), &hot(&warm), "columns");
                }
            }
        }
    }
}

#[test]
fn an_operator_with_temperatures_knows_energies_without_them_and_goes_to_files_and_back() {
    let mesh = patch([0; 4], Shape::Straight, 0.0);
    let body = Body::new(cold(&mesh, PLANE_STRESS)).unwrap();
    let warm = temperature(&mesh, PLANE_STRESS);
    let hot = body.heated(&warm, &cases(&warm, 1), &EXPANSION).unwrap();
    let pulled = |operator: &InterfaceOperator| {
        let factors = operator.factors(&[("shear", 1.0)]).unwrap();
        let load = TraceLoad { unknowns: vec![0.0; operator.stiffness.nrows()], ..TraceLoad::default() };
        let unknowns = operator.solve_one(&operator.right_hand_side(&load, &factors));
        operator.strain_energy(&InterfaceState { unknowns, factors, load })
    };
    assert_eq!(pulled(&hot), pulled(&body.interface));
    assert_eq!(pulled(&InterfaceOperator::from_parts(hot.clone().into_parts()).unwrap()), pulled(&hot));
    #[cfg(feature = "serde")]
    {
        let text = serde_json::to_string(&hot).unwrap();
        let back: InterfaceOperator = serde_json::from_str(&text).unwrap();
        assert_eq!(pulled(&back), pulled(&hot));
        assert!(back.work.col_iter().flat_map(|c| c.iter()).any(|v| v.is_nan()));
    }
    let twice = [cases(&warm, 1), cases(&warm, 1)].concat();
    assert_eq!(
        body.heated(&warm, &twice, &EXPANSION).map(|_| ()).unwrap_err(),
        Error::DuplicateLoadCase { name: "heat 0".into() }
    );
}

#[test]
fn temperatures_of_another_mesh_or_with_sources_are_refused() {
    let (mesh, other) = (patch([0; 4], Shape::Straight, 0.0), mixed([0; 4], Shape::Straight, 0.0));
    let body = Body::new(cold(&mesh, PLANE_STRESS)).unwrap();
    let warm = temperature(&other, PLANE_STRESS);
    assert_eq!(body.heated(&warm, &cases(&warm, 2), &EXPANSION).map(|_| ()).unwrap_err(), Error::OtherMesh);
    let moved = Mesh { vertices: mesh.vertices.iter().map(|x| [x[0] + 0.5, x[1]]).collect(), ..mesh.clone() };
    let warm = temperature(&moved, PLANE_STRESS);
    assert_eq!(body.heated(&warm, &cases(&warm, 2), &EXPANSION).map(|_| ()).unwrap_err(), Error::OtherMesh);
    let warm = temperature(&mesh, Kinematics::Axisymmetric);
    assert!(matches!(body.heated(&warm, &cases(&warm, 2), &EXPANSION), Err(Error::NoMeaning { .. })));
    let problem = conduction(&mesh, 5, PLANE_STRESS).material(Material::conductor(1.4).unwrap());
    let problem = problem.support(Support::moved("bottom", Direction::First, 35.0)).keep("right");
    let source = Body::new(problem.load("0", BodyForce::new(|x| [x[0], 0.0]))).unwrap();
    assert!(matches!(body.heated(&source, &cases(&source, 2), &EXPANSION), Err(Error::NoMeaning { .. })));
    assert!(matches!(body.heated(&body, &[], &EXPANSION), Err(Error::NoMeaning { .. })));
}
