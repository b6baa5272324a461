//! Bodies that problems share.

use wearshape::{Bodies, Problem};

use crate::common::{digits, scene, solved, solved_on};

/// The drum on two levels, without a proof: four bodies.
fn drum(more: &[&str]) -> Problem {
    scene("drum-brake-block", &[&["mesh.degree=4", "check=false"], more].concat())
}

const NUMBERS: [&[&str]; 4] = [
    &["load.force=2e4"],
    &["contact.friction=0.1"],
    &["wear.b=2", "wear.a=0.5"],
    &["sliding.omega=-1", "optimum.functional=uniform"],
];

#[test]
fn problems_that_differ_in_numbers_alone_share_and_have_the_digits_of_fresh_bodies() {
    let bodies = Bodies::default();
    solved_on(&drum(&[]), &bodies);
    assert_eq!((bodies.factorisations(), bodies.reused()), (4, 0));
    for more in NUMBERS {
        let problem = drum(more);
        let before = bodies.reused();
        let shared = solved_on(&problem, &bodies);
        assert!(digits(&shared) == digits(&solved(&problem)), "{more:?}");
        assert_eq!(bodies.factorisations(), 4, "{more:?}");
        assert!(bodies.reused() >= before + 4, "{more:?}");
        assert_eq!(shared.effort.counters.factorisations, 0, "{more:?}");
    }
}

#[test]
fn problems_whose_bodies_differ_do_not_share() {
    for more in [
        "body1.geometry.shoe-block.top=301",
        "body2.geometry.ring.inner=99",
        "body1.material.poisson=0.31",
        "body2.material.young=209e3",
        "body1.support={left=[\"x\"]}",
        "body2.support={inner=[\"x\",\"z\"],outer=[\"x\"]}",
        "load.as=vertical",
        "thickness=11",
        "kinematics=plane-strain",
        "mesh.layers=5",
    ] {
        let (bodies, problem) = (Bodies::default(), drum(&[more]));
        solved_on(&drum(&[]), &bodies);
        let shared = solved_on(&problem, &bodies);
        assert_eq!((bodies.factorisations(), bodies.reused()), (8, 0), "{more}");
        assert!(digits(&shared) == digits(&solved(&problem)), "{more}");
    }
}

/// More couples than are kept: the oldest are made again, with the same digits.
#[test]
fn bodies_that_were_forgotten_are_made_again() {
    let bodies = Bodies::default();
    let first = solved_on(&drum(&[]), &bodies);
    for thickness in 11..=15 {
        solved_on(&drum(&[&format!("thickness={thickness}")]), &bodies);
    }
    let again = solved_on(&drum(&[]), &bodies);
    assert_eq!((bodies.factorisations(), bodies.reused()), (28, 0));
    assert!(digits(&first) == digits(&again));
}

#[test]
fn four_threads_on_the_same_bodies_have_the_digits_of_one() {
    let bodies = Bodies::default();
    let problems = NUMBERS.map(drum);
    let shared = std::thread::scope(|scope| {
        let threads = problems.each_ref().map(|problem| scope.spawn(|| solved_on(problem, &bodies)));
        threads.map(|thread| thread.join().unwrap())
    });
    for (problem, shared) in problems.iter().zip(&shared) {
        assert!(digits(shared) == digits(&solved(problem)));
    }
    // Threads that miss the same bodies all make them; one pair of each level is kept.
    assert_eq!(bodies.factorisations(), 4);
}
