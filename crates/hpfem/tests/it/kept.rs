//! Several kept boundaries.

use crate::common::*;
use hpfem::*;

#[test]
fn bodies_that_keep_several_boundaries_have_the_field_of_the_body_that_keeps_none() {
    let load = [vec![traction("top", |p| [p.position[1], 1.0 - p.position[0]])]];
    for mesh in [patch(TURNS[6], Shape::Arcs, 0.0), mixed(TURNS[4], Shape::Arcs, 0.0)] {
        let of = |names: &[&str]| {
            let problem = problem(&mesh, 6, PLANE_STRAIN, &steel(), &[], &load, None).clamp("left");
            Body::new(names.iter().fold(problem, |problem, name| problem.keep(name))).unwrap()
        };
        let alone = of(&[]);
        let wanted = alone.field(&solved(&alone, &[1.0])).unwrap();
        // Apart from each other, with a common corner, all three in a row, and loaded ones among them.
        for names in [&["right", "left"][..], &["bottom", "right"], &["top", "bottom", "right"]] {
            let body = of(names);
            let state = solved(&body, &[1.0]);
            let field = body.field(&state).unwrap();
            let size = wanted.at(0, 1.0, 1.0).unwrap().displacement[0].abs();
            for (cell, (xi, eta)) in (0..mesh.cells.len()).flat_map(|c| sample_points().map(move |x| (c, x))) {
                let (u, v) = (field.at(cell, xi, eta).unwrap().displacement, wanted.at(cell, xi, eta).unwrap().displacement);
                assert!((u[0] - v[0]).hypot(u[1] - v[1]) < 1e-10 * size, "{names:?}");
            }
            let interface = &body.interface;
            assert_eq!(interface.more_traces.len() + 1, names.len());
            for trace in std::iter::once(&interface.trace).chain(&interface.more_traces) {
                let (edge, t) = trace.locate(0.37 * trace.length());
                let (rows, constant) = trace.displacement_row(edge, t);
                let (cell, xi, eta) = field.locate(trace.boundary_point(edge, t).0.position).unwrap();
                let value = field.at(cell, xi, eta).unwrap().displacement;
                for k in 0..2 {
                    let u = rows[k].iter().map(|(n, c)| c * state.unknowns[*n]).sum::<f64>() + constant[k];
                    assert!((u - value[k]).abs() < 1e-10 * size, "{names:?}: {u} {}", value[k]);
                }
            }
        }
    }
}
