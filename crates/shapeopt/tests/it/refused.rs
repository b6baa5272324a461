//! Numbers that do not fit each other are refused.

use crate::closed_form::{FORCE, points, problem, winkler};
use contact::{MomentBalance, Motion, Pair};
use faer::Mat;
use hpfem::{Body, BodyProblem, Curve, Kinematics, Material, Mesh, Named, RigidEdge, Ruled, Side};
use shapeopt::*;
use wear::{Counterface, WearLaw, WearPair};

const LAW: WearLaw = WearLaw { factor: 1e-7, speed_exponent: 1.0, pressure_exponent: 1.0 };

fn run() -> WearProblem {
    let points = points(9);
    let system = winkler(&points, None, 500.0);
    problem(points, system, WearPair::alone(LAW), vec![0.0; 9])
}

fn refused(change: impl Fn(&mut WearProblem)) {
    let mut run = run();
    change(&mut run);
    assert!(matches!(Evolution::new(&run).err(), Some(Error::WearInput { .. })));
}

#[test]
fn runs_of_wrong_sizes_steps_and_ends_are_refused() {
    assert!(Evolution::new(&run()).is_ok());
    refused(|run| run.stages[0].system.influence = Mat::zeros(3, 1));
    refused(|run| run.stages[0].system.balance = Mat::zeros(3, 1));
    refused(|run| run.stages[0].system.stiffness = Mat::zeros(0, 0));
    for wrong in [f64::NAN, f64::INFINITY] {
        refused(|run| run.stages[0].system.compliance[(2, 3)] = wrong);
        refused(|run| run.stages[0].system.influence[(2, 0)] = wrong);
        refused(|run| run.stages[0].system.opening[4] = wrong);
        refused(|run| run.stages[0].system.load[0] = wrong);
    }
    for wrong in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        refused(|run| run.stepping = Stepping::Fixed(wrong));
        refused(|run| run.stepping = Stepping::Adaptive { accuracy: wrong });
        refused(|run| run.until = Until::Time(wrong));
        refused(|run| run.until = Until::Depth(wrong));
        refused(|run| run.until = Until::Volume(wrong));
        refused(|run| run.until = Until::Steady { residual: wrong, not_before: 0.0 });
    }
    refused(|run| run.until = Until::Steady { residual: 1e-9, not_before: f64::NAN });
    refused(|run| (run.wear, run.until) = (WearPair::alone(WearLaw::NONE), Until::Volume(1.0)));
    let second = WearPair::archard([0.0, 1e-7], [1.0; 2], [1.0; 2]);
    refused(|run| (run.wear, run.until) = (second.clone(), Until::Depth(1.0)));
}

/// They were told as a load of the wrong direction.
#[test]
fn numbers_that_are_not_finite_are_refused_with_their_place() {
    let said = |change: fn(&mut contact::ContactSystem)| {
        let mut run = run();
        change(&mut run.stages[0].system);
        Evolution::new(&run).err().unwrap().to_string()
    };
    assert!(
        said(|s| s.compliance[(2, 3)] = f64::NAN)
            .ends_with("load stage 0 has a number that is not finite: the compliance in row 2, column 3 is NaN")
    );
    assert!(said(|s| s.balance[(4, 0)] = f64::INFINITY).contains("the balance in row 4, column 0 is inf"));
    assert!(said(|s| s.load[0] = f64::NAN).contains("the load in row 0 is NaN"));
    assert!(said(|s| s.opening[8] = f64::NAN).contains("the opening in row 8 is NaN"));
    let reversing = |change: fn(&mut contact::ContactSystem)| {
        let points = points(9);
        let mut systems = [winkler(&points, None, 500.0), winkler(&points, None, 500.0)];
        change(&mut systems[1]);
        let (wear, counterface) = (WearPair::alone(LAW), Counterface::Fresh);
        let problem = ReversingProblem { points, wear, counterface, track_area: None, systems, share: 0.5 };
        steady_reversing(&problem).err().unwrap().to_string()
    };
    assert!(reversing(|s| s.load[0] = f64::NAN).contains("backward has a number that is not finite: the load in row 0 is NaN"));
    assert!(reversing(|s| s.compliance[(1, 7)] = f64::NAN).contains("the compliance in row 1, column 7 is NaN"));
}

/// Runs that wear nothing ended with "even a step of inf s has no solution", or never.
#[test]
fn a_depth_or_volume_that_is_never_reached_is_told_as_such() {
    let at_rest = |run: &mut WearProblem| run.stages[0].speeds = vec![0.0; 9];
    let ended = |change: &dyn Fn(&mut WearProblem)| {
        let mut run = run();
        change(&mut run);
        let mut evolution = Evolution::new(&run).unwrap();
        let state = evolution.by_ref().take(2000).last().unwrap();
        (evolution.status().clone(), state)
    };
    for until in [Until::Depth(1.0), Until::Volume(1.0)] {
        for stepping in [Stepping::Adaptive { accuracy: 1e-4 }, Stepping::Fixed(10.0)] {
            for scheme in [Scheme::Sdirk4, Scheme::Explicit] {
                let (status, state) = ended(&|run| {
                    at_rest(run);
                    (run.until, run.stepping, run.scheme) = (until, stepping, scheme);
                });
                assert_eq!(status, EvolutionStatus::Unreached { time: 0.0 });
                assert!(status.to_string().contains("nothing wears") && state.step == 0);
            }
        }
    }
    // What slides no more after 50 s.
    let (status, state) = ended(&|run| {
        run.stages.push(run.stages[0].clone());
        run.stages[1].speeds = vec![0.0; 9];
        run.schedule = vec![Interval { stage: 0, duration: 50.0 }, Interval { stage: 1, duration: f64::INFINITY }];
        run.until = Until::Volume(1.0);
    });
    assert_eq!(status, EvolutionStatus::Unreached { time: 50.0 });
    assert!(state.volume[0] > 0.0);
    // Bodies pressed together by .01 mm and by no force wear themselves free: 6 mm^3 at most.
    let (status, state) = ended(&|run| {
        let system = &mut run.stages[0].system;
        (system.influence, system.balance, system.stiffness) = (Mat::zeros(9, 0), Mat::zeros(9, 0), Mat::zeros(0, 0));
        (system.load, system.opening) = (Vec::new(), vec![-0.01; 9]);
        run.until = Until::Volume(10.0);
    });
    assert!(matches!(status, EvolutionStatus::Unreached { .. }), "{status}");
    assert!((state.volume[0] - 6.0).abs() < 1e-9, "{} mm^3", state.volume[0]);
    // A time is reached whatever wears.
    let (status, state) = ended(&|run| {
        at_rest(run);
        run.until = Until::Time(100.0);
    });
    assert_eq!((status, state.time, state.volume), (EvolutionStatus::TimeReached, 100.0, [0.0; 2]));
    // Body 2 alone wears, and passes away with its wear: 1e-7 of 1000 N by 5 mm/s.
    for scheme in [Scheme::Sdirk4, Scheme::Explicit] {
        let (status, state) = ended(&|run| {
            run.wear = WearPair::archard([0.0, 1e-7], [1.0; 2], [1.0; 2]);
            (run.until, run.scheme) = (Until::Volume(1.0), scheme);
        });
        assert_eq!(status, EvolutionStatus::WornOff);
        assert!((state.time / 2000.0 - 1.0).abs() < 1e-9 && (state.volume[1] - 1.0).abs() < 1e-9, "{} s", state.time);
    }
}

#[test]
fn reversals_and_tolerances_of_wrong_sizes_are_refused() {
    let points = points(9);
    let reversing = |change: fn(&mut contact::ContactSystem)| {
        let mut systems = [winkler(&points, None, 500.0), winkler(&points, None, 500.0)];
        change(&mut systems[0]);
        let (wear, points) = (WearPair::alone(LAW), points.clone());
        steady_reversing(&ReversingProblem {
            points,
            wear,
            counterface: Counterface::Fresh,
            track_area: None,
            systems,
            share: 0.5,
        })
    };
    assert!(reversing(|_| {}).is_ok());
    for change in [
        (|s| s.balance = Mat::zeros(1, 1)) as fn(&mut contact::ContactSystem),
        |s| s.stiffness = Mat::zeros(0, 0),
        |s| s.load = vec![FORCE; 2],
    ] {
        assert!(matches!(reversing(change), Err(Error::WearInput { .. })));
    }
    let known = |pressure: usize, error: usize| tolerances(&run(), &vec![1.0; pressure], &[vec![1e-4; error]]);
    assert!(known(9, 9).is_some() && known(12, 12).is_none() && known(9, 3).is_none());
}

/// A block that keeps its bottom: held at its top, floating, or with a rigid edge there.
fn block(held: bool, edge: bool) -> Body {
    let line = |z| Curve::Line { start: [-20.0, z], end: [20.0, z] };
    let named = |side, name| Named { side, range: None, name };
    let mesh = Mesh::ruled(&Ruled {
        bottom: line(0.0),
        top: line(15.0),
        breaks: &[-1.0, 0.0, 1.0],
        levels: &[0.0, 1.0],
        closed: false,
        material: 0,
        names: &[named(Side::Bottom, "contact"), named(Side::Top, "top")],
    });
    let body = BodyProblem::new(mesh.unwrap(), 3, Kinematics::PlaneStrain { thickness: 2.0 });
    let body = body.material(Material::isotropic(210e3, 0.3).unwrap()).keep("contact");
    let body = if held { body.clamp("top") } else { body };
    let edge = edge.then(|| RigidEdge { boundary: "top".into(), reference: [0.0, 15.0], free: [false, true, true] });
    Body::new(BodyProblem { rigid_edge: edge, ..body }).unwrap()
}

fn shape(body: &Body, gauge: Gauge, rigid: RigidPart, pressure: f64) -> Result<Shape, Error> {
    let pair = Pair::new(&body.interface, None).unwrap();
    let traction = &move |_: &SurfacePlace| [pressure, 0.0];
    let integration = Integration::Lobatto;
    solve_shape(&ShapeProblem { pair, traction, cases_shaped: &[], cases_counter: &[], gauge, rigid, integration })
}

#[test]
fn gauges_and_rigid_parts_that_do_not_fit_the_body_are_refused() {
    let [held, floating, edged] = [block(true, false), block(false, false), block(false, true)];
    let loaded = || Gauge::LoadedEdge(EdgeLoad { motions: [Motion::FREE; 3], moment: MomentBalance::Traction });
    let wrong = |body: &Body, gauge: Gauge, rigid: RigidPart| {
        let found = shape(body, gauge.clone(), rigid, 10.0).err();
        assert!(matches!(found, Some(Error::ShapeInput { .. })), "{gauge:?}: {found:?}");
    };
    for gauge in [Gauge::HeldEdge, loaded(), Gauge::MeanOf(vec![]), Gauge::MeanOf(vec![99, 99, 99])] {
        wrong(&floating, gauge, RigidPart::Prescribed(vec![0.0; 3]));
    }
    wrong(&edged, Gauge::MeanOf(vec![99, 99]), RigidPart::Smallest);
    for gauge in [Gauge::HeldEdge, loaded(), Gauge::Orthogonal] {
        assert!(shape(&held, gauge.clone(), RigidPart::Smallest, 10.0).is_ok(), "{gauge:?}");
        assert!(shape(&edged, gauge.clone(), RigidPart::Smallest, 10.0).is_ok(), "{gauge:?}");
    }
    let along = |start, direction| RigidPart::SmallestAlong { start, direction };
    for rigid in [
        RigidPart::Prescribed(vec![0.0]),
        RigidPart::Prescribed(vec![0.0, f64::NAN]),
        along(vec![], vec![]),
        along(vec![0.0; 2], vec![f64::INFINITY, 0.0]),
    ] {
        wrong(&edged, Gauge::HeldEdge, rigid);
    }
    assert!(shape(&edged, Gauge::HeldEdge, RigidPart::Prescribed(Vec::new()), 10.0).is_ok());
    assert!(matches!(shape(&edged, Gauge::HeldEdge, RigidPart::Smallest, f64::NAN), Err(Error::ShapeInput { .. })));
}
