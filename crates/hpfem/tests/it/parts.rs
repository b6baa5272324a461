//! Interface operators as plain data, several kept boundaries, closed ones.

use crate::common::*;
use hpfem::*;

fn ring_patch() -> BodyProblem {
    BodyProblem::new(mixed([0, 1, 2, 3], Shape::Arcs, 0.0), 5, PLANE_STRAIN)
        .material(Material::isotropic(210e3, 0.3).unwrap())
        .hold("left", Direction::First)
        .load("pull", EdgeTraction::new("right", |p| p.outward))
}

#[cfg(feature = "serde")]
#[test]
fn an_operator_comes_back_from_text_with_the_same_bits() {
    let operator = Body::interface(&ring_patch().keep("top").keep("bottom")).unwrap().0;
    let text = serde_json::to_string(&operator).unwrap();
    let back: InterfaceOperator = serde_json::from_str(&text).unwrap();
    assert_eq!(back.stiffness, operator.stiffness);
    assert_eq!(back.columns, operator.columns);
    assert_eq!(back.trace.points, operator.trace.points);
    assert_eq!(back.more_traces.len(), 1);
    let broken = text.replacen("\"load_cases\":[\"pull\"]", "\"load_cases\":[]", 1);
    let error = serde_json::from_str::<InterfaceOperator>(&broken).unwrap_err().to_string();
    assert!(error.contains("right-hand sides"), "{error}");
    // Supports and degrees that there are not (memory beyond all bounds was asked for, and a sum overflowed).
    let changed = |change: &dyn Fn(&mut serde_json::Value)| {
        let mut value: serde_json::Value = serde_json::from_str(&text).unwrap();
        change(&mut value["traces"][0]["edges"][0]);
        serde_json::from_value::<InterfaceOperator>(value).map(|_| ()).map_err(|error| error.to_string())
    };
    assert_eq!(changed(&|_| ()), Ok(()));
    for fault in [
        changed(&|edge| edge["fixed"][0][1] = (1_u64 << 40).into()),
        changed(&|edge| edge["degree"] = u64::MAX.into()),
        changed(&|edge| edge["degree"] = 4.into()),
    ] {
        assert!(fault.is_err_and(|error| error.contains("a kept boundary names")));
    }
}

#[test]
fn parts_that_do_not_fit_are_refused() {
    let parts = || Body::interface(&ring_patch().keep("top")).unwrap().0.into_parts();
    assert!(InterfaceOperator::from_parts(parts()).is_ok());
    let mut skew = parts();
    skew.stiffness[(0, 1)] *= 1.5;
    assert!(matches!(InterfaceOperator::from_parts(skew), Err(Error::OutOfRange { .. })));
    let mut short = parts();
    short.load_cases.clear();
    assert!(matches!(InterfaceOperator::from_parts(short), Err(Error::Count { .. })));
    let mut none = parts();
    none.traces.clear();
    assert!(matches!(InterfaceOperator::from_parts(none), Err(Error::Count { .. })));
    let mut beyond = parts();
    beyond.frame[0] = Some(1000);
    assert!(matches!(InterfaceOperator::from_parts(beyond), Err(Error::Inconsistent { .. })));
}

#[test]
fn several_kept_boundaries_condense_to_each_alone() {
    let both = Body::new(ring_patch().keep("top").keep("bottom")).unwrap();
    assert_eq!(both.interface.more_traces.len(), 1);
    assert_eq!(both.interface.trace.unknowns, both.interface.more_traces[0].unknowns);
    // The field is the same whatever is kept.
    let alone = Body::new(ring_patch().keep("top")).unwrap();
    let fields = [&both, &alone].map(|body| {
        let problem = body.problem().clone().hold("bottom", Direction::Second);
        let body = Body::new(problem).unwrap();
        body.field(&body.solve(&[("pull", 1.0)]).unwrap()).unwrap()
    });
    for (xi, eta) in sample_points() {
        let (a, b) = (fields[0].at(0, xi, eta).unwrap(), fields[1].at(0, xi, eta).unwrap());
        a.stress.iter().zip(b.stress).for_each(|(a, b)| assert!((a - b).abs() < 1e-10, "{a} {b}"));
    }
    // A boundary kept twice, or two that share a corner, have each unknown once.
    let corner = Body::interface(&ring_patch().keep("top").keep("right")).unwrap().0;
    let twice = Body::interface(&ring_patch().keep("top").keep("right").keep("top")).unwrap().0;
    assert_eq!(corner.stiffness, twice.stiffness);
}

#[test]
fn a_closed_boundary_is_kept_with_every_point_once() {
    // A ring, its bore kept: the stiffness against a uniform pressure is Lame's, and the three rigid motions cost no energy.
    let arc = |radius| Curve::Arc { centre: [0.3, -0.2], radius, from: std::f64::consts::TAU, to: 0.0 };
    let names = [Named { side: Side::Bottom, range: None, name: "bore" }];
    let breaks: Vec<f64> = (0..=6).map(|k| f64::from(k) / 3.0 - 1.0).collect();
    let (bottom, top) = (arc(1.0), arc(2.0));
    let region = Ruled { bottom, top, breaks: &breaks, levels: &[0.0, 0.4, 1.0], closed: true, material: 0, names: &names };
    let mesh = Mesh::ruled(&region).unwrap();
    let problem = BodyProblem::new(mesh, 8, PLANE_STRESS).material(Material::isotropic(2.0, 0.3).unwrap()).keep("bore");
    let operator = Body::new(problem).unwrap().interface;
    let trace = &operator.trace;
    assert!(trace.closed);
    assert_eq!(trace.points.len(), 6 * 8);
    let area: f64 = trace.points.iter().map(|p| p.weight).sum();
    assert!((area / (0.7 * std::f64::consts::TAU) - 1.0).abs() < 1e-12, "{area}");
    assert_eq!(operator.rigid_motions.len(), 3);
    let rigid = &operator.stiffness * &operator.rigid_modes;
    assert!(rigid.norm_max() < 1e-9 * operator.stiffness.norm_max());
    let load = trace.load(operator.kinematics, 2, |p| p.outward.map(|n| -n));
    let u = operator.solve_one(&load.unknowns);
    // u_r = p a / E ((b^2 + a^2) / (b^2 - a^2) + nu).
    let wanted = (5.0 / 3.0 + 0.3) / 2.0;
    let (rows, _) = trace.displacement_row(2, 0.37);
    let at = |k: usize| rows[k].iter().map(|(i, c)| c * u[*i]).sum::<f64>();
    assert!((at(0).hypot(at(1)) / wanted - 1.0).abs() < 1e-6, "{} {wanted}", at(0).hypot(at(1)));
}

#[test]
fn bodies_are_stored_returned_and_sent_to_threads() {
    fn is_sent<T: Clone + Send + Sync + 'static>() {}
    is_sent::<BodyProblem>();
    is_sent::<Body>();
    is_sent::<Field>();
    is_sent::<InterfaceOperator>();
    // A body made in one thread, loaded in another, read in a third.
    let made = std::thread::spawn(|| Body::new(ring_patch().hold("bottom", Direction::Second)).unwrap()).join().unwrap();
    let loaded = std::thread::spawn(move || {
        let mut body = made;
        body.add_load(LoadCase::new("push").with(EdgeTraction::pressure("top", |x| x[0]))).unwrap();
        body.field(&body.solve(&[("pull", 2.0), ("push", 1.0)]).unwrap()).unwrap()
    });
    let field = loaded.join().unwrap();
    let sum = std::thread::spawn(move || (0..field.cells()).map(|c| field.at(c, 0.0, 0.0).unwrap().stress[0]).sum::<f64>());
    let here = ring_patch().hold("bottom", Direction::Second).load("push", EdgeTraction::pressure("top", |x| x[0]));
    let here = Body::new(here).unwrap();
    let field = here.field(&here.solve(&[("push", 1.0), ("pull", 2.0)]).unwrap()).unwrap();
    let wanted: f64 = (0..field.cells()).map(|c| field.at(c, 0.0, 0.0).unwrap().stress[0]).sum();
    assert!((sum.join().unwrap() / wanted - 1.0).abs() < 1e-11);
}
