//! Input that says nothing is refused by name, and a load that nothing holds has no balance.

use crate::common::material;
use crate::common::punch::rectangle;
use contact::faer::{Mat, mat};
use contact::*;
use hpfem::{Body, BodyProblem, Direction, InterfaceOperator, Kinematics, Material, RigidEdge};

const PLANE: Kinematics = Kinematics::PlaneStrain { thickness: 1.0 };

fn block(degree: usize, free: [bool; 3], kinematics: Kinematics) -> InterfaceOperator {
    let mesh = rectangle(&[0.0, 10.0, 20.0], &[0.0, 5.0, 20.0], hpfem::Side::Bottom, [0.0, 20.0]);
    let edge = RigidEdge { boundary: "top".into(), reference: [0.0, 20.0], free };
    let body = BodyProblem::new(mesh, degree, kinematics).material(material(210e3, 0.3)).keep("contact");
    Body::new(BodyProblem { rigid_edge: Some(edge), ..body }).unwrap().interface
}

fn pressed(along: f64, friction: Friction) -> ContactLoad {
    let motions = [Motion::Free { resultant: along }, Motion::Free { resultant: -100.0 }, Motion::FREE];
    ContactLoad { motions, friction, ..ContactLoad::factors(&[], &[]) }
}

#[test]
fn a_load_along_a_motion_that_nothing_resists_has_no_balance() {
    let body = block(4, [true, true, false], PLANE);
    let pair = Pair::new(&body, None).unwrap();
    let operator = ContactOperator::new(&pair, true).unwrap();
    let n = operator.points().len();
    let solve = |along: f64, friction: Friction| operator.solve(&vec![0.0; n], &pressed(along, friction), None).unwrap();
    let swallowed = solve(50.0, Friction::None);
    assert_eq!((swallowed.status, swallowed.balance), (Status::NoBalance, 1.0));
    let pivoted = operator.solve_by_pivoting(&vec![0.0; n], &pressed(50.0, Friction::None)).unwrap();
    assert_eq!(pivoted.status, Status::NoBalance);
    assert_eq!(solve(0.0, Friction::None).status, Status::ClosedEverywhere);
    assert_eq!(solve(1e-12, Friction::None).status, Status::ClosedEverywhere, "round-off");
    // A guide takes the drag alone, and a load may balance it.
    let drag = || Friction::Sliding { coefficient: 0.3, drag: vec![1.0; n] };
    assert!(solve(0.0, drag()).status.is_solved());
    assert_eq!(solve(50.0, drag()).status, Status::NoBalance);
    let sticks = Friction::Coulomb { coefficient: 0.3, slip_before: vec![0.0; n] };
    assert!(solve(20.0, sticks).status.is_solved());

    let idle = Motions::free(mat![[0.0], [0.0]], Mat::zeros(2, 1));
    let springs = MatrixContact::from_compliance(&Mat::identity(2, 2), &[1.0; 2], &idle).unwrap();
    assert_eq!(springs.solve(&[-1.0; 2], &[1.0], &Friction::None, None).unwrap().status, Status::NoBalance);
    assert!(springs.solve(&[-1.0; 2], &[0.0], &Friction::None, None).unwrap().status.is_solved());
    let both = Motions::free(mat![[-1.0, 0.0], [-1.0, 0.0]], mat![[0.0, 1.0], [0.0, 1.0]]);
    let slides = MatrixContact::from_compliance(&Mat::identity(4, 4), &[1.0; 2], &both).unwrap();
    let drag = Friction::Sliding { coefficient: 0.3, drag: vec![1.0; 2] };
    for (forces, balanced) in [([6.0, 1.0], false), ([6.0, -1.8], true), ([6.0, 0.0], true)] {
        assert_eq!(slides.solve(&[0.0; 2], &forces, &drag, None).unwrap().status.is_solved(), balanced, "{forces:?}");
    }
}

#[test]
fn loads_and_starts_that_do_not_fit_are_refused_by_name() {
    let (body, coarse) = (block(4, [true, true, false], PLANE), block(2, [true, true, false], PLANE));
    let [pair, other] = [&body, &coarse].map(|body| Pair::new(body, None).unwrap());
    let [operator, other] = [pair, other].map(|pair| ContactOperator::new(&pair, true).unwrap());
    let (n, few) = (operator.points().len(), other.points().len());
    let refused = |load: &ContactLoad| operator.solve(&vec![0.0; n], load, None).unwrap_err();
    let coulomb = |slip_before| Friction::Coulomb { coefficient: 0.3, slip_before };
    let mut slips = vec![0.0; n];
    slips[3] = f64::NAN;
    assert_eq!(refused(&pressed(0.0, coulomb(slips))), Error::NotFinite { name: "slip before", row: 3, column: 0 });
    for wrong in [f64::NAN, f64::INFINITY] {
        let error = refused(&pressed(wrong, Friction::None));
        assert_eq!(error, Error::NotFinite { name: "motion of the rigid edge", row: 0, column: 0 });
        let mut sprung = pressed(0.0, Friction::None);
        sprung.motions[1] = Motion::Sprung { stiffness: 1.0, rest: wrong };
        assert!(matches!(refused(&sprung), Error::NotFinite { row: 1, .. }));
        // The motion of an edge that is held counts for nothing.
        sprung.motions = [Motion::FREE, Motion::Prescribed { value: 0.0 }, Motion::Prescribed { value: wrong }];
        assert!(operator.solve(&vec![0.0; n], &sprung, None).is_ok());
    }
    let load = pressed(0.0, Friction::None);
    for given in [2, n + 3] {
        let error = operator.solve_on(&vec![0.0; n], &load, &vec![true; given]).unwrap_err();
        assert_eq!(error, Error::Gap { given, points: n });
    }
    let start = other.solve(&vec![0.0; few], &load, None).unwrap();
    let earlier = Error::Shape { name: "earlier solution", wanted: [n, 1], given: [few, 1] };
    assert_eq!(operator.solve(&vec![0.0; n], &load, Some(&start)).unwrap_err(), earlier);
    let mut held = operator.held_on(&vec![true; n]);
    assert_eq!(held.released(&vec![0.0; n], &load, &start).unwrap_err(), earlier);
    let mut own = operator.solve(&vec![0.0; n], &load, None).unwrap();
    own.states.clear();
    let error = operator.solve(&vec![0.0; n], &load, Some(&own)).unwrap_err();
    assert_eq!(error, Error::Shape { name: "earlier solution", wanted: [n, 1], given: [0, 1] });
    let sticks = pressed(0.0, coulomb(vec![0.0; n]));
    assert_eq!(operator.solve_by_pivoting(&vec![0.0; n], &sticks).unwrap_err(), Error::StickBySolve);
}

#[test]
fn bodies_that_do_not_go_together_are_refused() {
    let free = [false, true, false];
    let body = block(3, free, PLANE);
    for other in [Kinematics::PlaneStrain { thickness: 2.0 }, Kinematics::Axisymmetric] {
        let counter = block(3, free, other);
        for found in [Pair::new, |a, b: Option<_>| Pair::facing(a, b.unwrap())] {
            let kinematics = [PLANE, other];
            assert_eq!(found(&body, Some(&counter)).err(), Some(Error::Unlike { kinematics }));
            assert!(Error::Unlike { kinematics }.to_string().contains("plane stress and plane strain go together"));
        }
    }
    let stressed = block(3, free, Kinematics::PlaneStress { thickness: 1.0 });
    assert!(Pair::new(&body, Some(&stressed)).is_ok());
    // It was told to hold the body against turning.
    let error = TorsionOperator::new(&Pair::new(&body, None).unwrap()).err();
    assert_eq!(error, Some(Error::NoTurn { side: Side::Shaped, kinematics: PLANE }));
    let mesh = || rectangle(&[0.0, 10.0, 20.0], &[0.0, 5.0, 20.0], hpfem::Side::Bottom, [0.0, 20.0]);
    let bare = BodyProblem::new(mesh(), 3, PLANE).material(material(210e3, 0.3)).clamp("top");
    let bare = Body::new(bare).unwrap().interface;
    let error = Pair::new(&body, Some(&bare)).err().unwrap();
    assert_eq!(error, Error::NothingKept { side: Side::Counter });
    assert_eq!(error.to_string(), "the counter-face keeps no boundary: name its contact surface by `BodyProblem::keep`");
    let kinematics = Kinematics::Potential { thickness: 1.0 };
    let warm = BodyProblem::new(mesh(), 3, kinematics).material(Material::conductor(1.0).unwrap());
    let warm = Body::new(warm.hold("top", Direction::First).keep("contact")).unwrap().interface;
    let pair = Pair::new(&warm, None).unwrap();
    assert_eq!(ContactOperator::new(&pair, false).err(), Some(Error::NoNormal { side: Side::Shaped, kinematics }));
}

#[test]
fn heat_is_shared_by_shares_and_conductances_alone() {
    let surface = HeatedSurface::even(3, 20.0, 0.1);
    let shared = |closed: &[bool], split| share_heat([&surface, &surface], &[1.0; 3], closed, split);
    for split in [HeatSplit::Share(7.0), HeatSplit::Share(f64::NAN), HeatSplit::Conductance(-5.0)] {
        assert!(matches!(shared(&[true; 3], split).unwrap_err(), Error::HeatSplit { .. }), "{split:?}");
        let known = share_known_heat([&surface, &surface], &[1.0; 3], &[true; 3], (split, &[1.0; 3]));
        assert!(matches!(known.unwrap_err(), Error::HeatSplit { .. }), "{split:?}");
    }
    assert!(shared(&[true; 3], HeatSplit::Conductance(5.0)).is_ok() && shared(&[true; 3], HeatSplit::Share(1.0)).is_ok());
    let error = shared(&[true; 2], HeatSplit::Conductance(5.0)).unwrap_err();
    assert_eq!(error, Error::Shape { name: "list of closed points", wanted: [3, 1], given: [2, 1] });
}

#[test]
fn lists_of_nothing_make_no_panic() {
    assert!(matches!(eigenvalues(&mat![[1.0, 2.0]]), Err(Error::Shape { .. })));
    assert!(piecewise_linear(&[], &[], 0.5).is_nan());
    assert_eq!(piecewise_linear(&[0.0, 1.0], &[3.0], 0.5), 3.0);
    let idle = Motions::free(mat![[-1.0], [-1.0]], Mat::zeros(2, 1));
    let stamp = MatrixContact::from_compliance(&Mat::identity(2, 2), &[1.0; 2], &idle).unwrap();
    let _ = stamp.system(&[1.0], &Friction::None).unwrap().is_regular(&[]);

    let torsion = |held: &str, side| {
        let mesh = rectangle(&[5.0, 10.0], &[0.0, 20.0], side, [5.0, 10.0]);
        let body = BodyProblem::new(mesh, 4, Kinematics::Torsion).material(material(210e3, 0.3));
        Body::new(body.hold(held, Direction::First).keep("contact")).unwrap().interface
    };
    let ring = torsion("top", hpfem::Side::Bottom);
    let operator = TorsionOperator::new(&Pair::new(&ring, None).unwrap()).unwrap();
    let none = vec![0.0; operator.points().len()];
    let still = operator.solve(&none, Turn::Torque(0.0), &none).unwrap();
    assert!(still.status.is_solved() && still.nodal_shear == none && still.angle == 0.0);
    assert_eq!(operator.solve(&none, Turn::Torque(1.0), &none).unwrap().status, TwistStatus::TurnsThrough);
}
