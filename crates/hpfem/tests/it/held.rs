//! Which bodies are held, wherever they lie, and what is said of those that are not.

use crate::common::*;
use hpfem::*;

/// The square between 0 and 2, moved, `cells` times beside each other with gaps of 1 between.
fn apart(cells: usize, moved: [f64; 2]) -> Mesh {
    let corner = |c: usize, [x, z]: [f64; 2]| [moved[0] + 3.0 * c as f64 + x, moved[1] + z];
    let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    let vertices = (0..cells).flat_map(|c| square.map(|x| corner(c, x))).collect();
    let quads: Vec<Quad> = (0..cells).map(|c| Quad { corners: [0, 1, 2, 3].map(|k| 4 * c + k), material: 0, layer: 0 }).collect();
    Mesh::new(vertices, &quads, &[], &[([0, 1], "bottom"), ([3, 0], "left"), ([1, 2], "right")]).unwrap()
}

#[test]
fn a_body_far_from_the_origin_is_held_as_it_is_near_it() {
    for far in [1e3, 1e7, 1e9, -1e10] {
        let problem = |kinematics, moved| BodyProblem::new(apart(1, moved), 2, kinematics).material(steel()[0]);
        let sheet = || problem(PLANE_STRESS, [far, 0.7 * far]);
        let pull = EdgeTraction::new("right", |_| [100.0, 0.0]);
        for held in [sheet().clamp("left"), sheet().roller("left").roller("bottom")] {
            let body = Body::new(held.load("pull", pull.clone())).unwrap();
            assert!(body.interface.rigid_motions.is_empty());
            let field = body.field(&body.solve(&[("pull", 1.0)]).unwrap()).unwrap();
            assert!((field.at(0, 1.0, 0.0).unwrap().displacement[0] / (2.0 * 100.0 / 210e3) - 1.0).abs() < 0.1);
        }
        let rigid_edge = Some(RigidEdge { boundary: "left".into(), reference: [0.0; 2], free: [false; 3] });
        assert!(Body::new(BodyProblem { rigid_edge, ..sheet() }).is_ok(), "{far}");
        // What is free is told: the height of a roller, the middle of a turn.
        let text = Body::new(sheet().roller("left")).err().unwrap().to_string();
        assert!(text.contains("it can slide along the second axis;"), "{far}: {text}");
        let pins = [Direction::First, Direction::Second].map(|direction| Pin { vertex: 0, direction }).to_vec();
        let pinned = Body::new(BodyProblem { pins, ..sheet() }).err().unwrap().to_string();
        assert!(pinned.contains(&format!("it can turn about ({far:.4}, {:.4})", 0.7 * far)), "{far}: {pinned}");
        let afloat = Body::interface(&sheet().keep("left")).unwrap().0;
        assert_eq!(afloat.rigid_motions.len(), 3);
        // A shaft far along its axis, held against its turn.
        assert!(Body::new(problem(Kinematics::Torsion, [0.0, far]).hold("bottom", Direction::First)).is_ok());
    }
}

#[test]
fn free_motions_are_told_once() {
    let problem = |cells| BodyProblem::new(apart(cells, [0.0; 2]), 2, PLANE_STRESS).material(steel()[0]);
    let text = |problem| Body::new(problem).err().unwrap().to_string();
    let all = "it can slide along the first axis and slide along the second axis and turn;";
    assert!(text(problem(1)).contains(&format!("not held: {all}")), "{}", text(problem(1)));
    let loose = "not held: 2 of its 3 unconnected parts can move, the first with cell 1 at (3.0000, 0.0000):";
    assert!(text(problem(3).clamp("left")).contains(&format!("{loose} {all}")), "{}", text(problem(3).clamp("left")));
    // One pinned direction leaves the turns about all points of a line: a slide across it and a turn.
    let pins = vec![Pin { vertex: 3, direction: Direction::Inclined(0.7) }];
    let pinned = text(BodyProblem { pins, ..problem(1) });
    assert!(pinned.contains("slide along the direction (") && pinned.matches("turn").count() == 1, "{pinned}");
}
