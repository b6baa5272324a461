//! Meshes of many cells: the order of elimination, the memory estimate, the same bits for any number of threads.

use crate::common::*;
use crate::exact::Exact;
use hpfem::*;

/// A square of `n x n` different cells, `[1, 2] x [0, 1]`, with the boundaries "left", "right" and "all".
fn square(n: usize) -> Mesh {
    let levels: Vec<f64> = (0..=n).map(|i| i as f64 / n as f64).map(|t| t + 0.17 * t * (1.0 - t) * (1.0 + 0.3 * t)).collect();
    let breaks: Vec<f64> = levels.iter().map(|t| 1.0 - 2.0 * t).rev().collect();
    let line = |z| Curve::Line { start: [1.0, z], end: [2.0, z] };
    let sides = [(Side::Left, "left"), (Side::Right, "right"), (Side::Bottom, "bottom"), (Side::Top, "top")];
    let mut names: Vec<Named<'_>> = sides.iter().map(|(side, name)| Named { side: *side, range: None, name }).collect();
    names.extend(sides.iter().map(|(side, _)| Named { side: *side, range: None, name: "all" }));
    let (bottom, top) = (line(0.0), line(1.0));
    Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &levels, closed: false, material: 0, names: &names }).unwrap()
}

#[test]
fn a_floating_body_of_many_cells_with_a_kept_boundary_is_as_exact_as_one_of_few() {
    let exact = Exact { kinematics: PLANE_STRAIN, material: Material::isotropic(1.7, 0.28).unwrap() };
    let materials = [exact.material];
    // More cells than are ordered by minimum degree.
    let mesh = square(36);
    let load = [vec![traction("all", move |p| exact.traction(p))]];
    let body = Body::new(problem(&mesh, 4, PLANE_STRAIN, &materials, &[], &load, Some("right"))).unwrap();
    let state = solved(&body, &[1.0]);
    let error = stress_error(&body.field(&state).unwrap(), &mesh, |x| exact.stress(x));
    assert!(error < 1e-6, "{error:.1e}");
    // The boundary is kept whole, and its operator knows the rigid motions.
    let interface = &body.interface;
    assert_eq!(interface.stiffness.nrows(), 2 * (36 * 4 + 1));
    let residual = (&interface.stiffness * &interface.rigid_modes).norm_max();
    assert!(residual < 1e-9 * interface.stiffness.norm_max(), "{residual:.1e}");
}

#[test]
fn supports_pins_and_foundations_of_a_body_of_many_cells_balance_its_loads() {
    let mesh = square(33);
    let materials = steel();
    let supports = [support("left", Direction::First)];
    let load = [vec![traction("right", |p| [3.0 + p.position[1], -2.0])]];
    let problem = problem(&mesh, 3, PLANE_STRESS, &materials, &supports, &load, None);
    let body = Body::new(problem.foundation(Foundation::new("bottom", 40.0, 3.0))).unwrap();
    let state = solved(&body, &[1.0]);
    let field = body.field(&state).unwrap();
    // The foundation's share of the force along x from the displacement it sees, 3 N/mm^3 on the thickness 0.7.
    let rule = gauss(8);
    let mut pulled = 0.0;
    for e in mesh.boundary("bottom").unwrap() {
        let (cell, local) = mesh.edge_cells()[e][0];
        for (t, w) in rule.points.iter().zip(&rule.weights) {
            assert_eq!(local, 0);
            let length = 0.5 * mesh.edges[e].curve.length();
            pulled += w * length * 0.7 * 3.0 * field.at(cell, *t, -1.0).unwrap().displacement[0];
        }
    }
    let reaction = body.interface.reaction(0, &state)[0];
    assert!((reaction + 0.7 * 3.5 - pulled).abs() < 1e-9, "{reaction} {pulled}");
}

#[test]
fn a_problem_beyond_the_memory_is_refused_by_its_estimate_before_any_work() {
    let mesh = square(250);
    let materials = steel();
    let supports = [support("left", Direction::First), support("left", Direction::Second)];
    let error = Body::new(problem(&mesh, 24, PLANE_STRAIN, &materials, &supports, &[], None)).err().unwrap();
    let Error::TooLarge { unknowns, bytes, limit } = error else { panic!("{error}") };
    assert!(unknowns > 5_000_000 && bytes > limit && limit == 12 << 30, "{unknowns} {bytes} {limit}");
    assert!(error.to_string().contains("bytes"));
}

/// The bits of the interface operator of a body on a pool of so many threads.
fn bits(mesh: &Mesh, degree: usize, kinematics: Kinematics, threads: usize) -> Vec<u64> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| {
        assert_eq!(rayon::current_num_threads(), threads);
        let materials = steel();
        let supports = [support("left", Direction::First)];
        let load = [vec![traction("top", |p| [p.position[0], 1.0])]];
        let problem = problem(mesh, degree, kinematics, &materials, &supports, &load, Some("right"));
        let body = Body::new(problem.load("0", BodyForce::new(|x| [x[1], -x[0]]))).unwrap();
        let state = afloat(&body, &[1.0]);
        let field = body.field(&state).unwrap();
        let interface = &body.interface;
        let matrices = [&interface.stiffness, &interface.columns, &interface.work];
        let numbers = matrices.into_iter().flat_map(|m| m.col_iter().flat_map(|c| c.iter().copied()).collect::<Vec<f64>>());
        let points = (0..mesh.cells.len()).flat_map(|c| field.at(c, 0.3, -0.4).unwrap().stress);
        numbers.chain(points).map(f64::to_bits).collect()
    })
}

#[test]
fn one_thread_and_two_and_three_give_the_same_bits() {
    for kinematics in [PLANE_STRAIN, Kinematics::Axisymmetric] {
        for (mesh, p) in [(mixed(TURNS[6], Shape::Arcs, 0.0).refined().unwrap(), 7), (square(34), 2)] {
            let one = bits(&mesh, p, kinematics, 1);
            assert!(one == bits(&mesh, p, kinematics, 2) && one == bits(&mesh, p, kinematics, 3), "{kinematics:?}");
        }
    }
}

#[test]
fn sizes_before_a_reduction_are_those_of_the_reduction() {
    let mesh = square(9);
    let materials = steel();
    let supports = [support("left", Direction::First), support("left", Direction::Second)];
    for degree in [1, 5] {
        let of = || problem(&mesh, degree, PLANE_STRESS, &materials, &supports, &[], Some("right"));
        let (sizes, body) = (Body::sizes(&of()).unwrap(), Body::new(of()).unwrap());
        assert_eq!((sizes.cells, sizes.unknowns, sizes.bytes), (body.effort.cells, body.effort.unknowns, body.effort.bytes));
        assert_eq!(sizes.kept_unknowns, body.interface.stiffness.nrows());
        assert_eq!(sizes.points, body.interface.trace.points.len());
    }
}

/// One cell: its matrix takes p^5, its dense elimination p^6 multiplications. Many cells of one degree, dissected: n^3 on the separators.
#[test]
fn the_multiplications_of_a_reduction_grow_as_theory_has_it() {
    let materials = steel();
    let supports = [support("left", Direction::First), support("left", Direction::Second)];
    let operations = |n: usize, degree: usize| {
        let mesh = square(n);
        Body::sizes(&problem(&mesh, degree, PLANE_STRESS, &materials, &supports, &[], None)).unwrap().operations
    };
    let by_degree = operations(1, 24) / operations(1, 12);
    assert!((32.0..64.0).contains(&by_degree), "{by_degree}");
    let by_cells = operations(80, 2) / operations(40, 2);
    assert!((4.0..9.0).contains(&by_cells), "{by_cells}");
}

/// Resident memory of this process, bytes: now (`VmRSS:`) or at most (`VmHWM:`).
#[cfg(target_os = "linux")]
fn resident(line: &str) -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let text = status.lines().find(|l| l.starts_with(line)).unwrap();
    1024.0 * text.split_whitespace().nth(1).unwrap().parse::<f64>().unwrap()
}

/// The process that the test below starts: one body and nothing else.
#[cfg(target_os = "linux")]
#[test]
#[ignore = "run by the test of the memory estimate in a process of its own"]
fn one_large_body() {
    let shape: Vec<usize> = std::env::var("LARGE_BODY").unwrap().split(',').map(|n| n.parse().unwrap()).collect();
    let before = resident("VmRSS:");
    let mesh = square(shape[0]);
    let materials = steel();
    let supports = [support("left", Direction::First), support("left", Direction::Second)];
    let load = [vec![traction("top", |p| [p.position[0], 1.0])]];
    let body = Body::new(problem(&mesh, shape[1], PLANE_STRAIN, &materials, &supports, &load, Some("right"))).unwrap();
    println!("estimate over peak: {}", body.effort.bytes as f64 / (resident("VmHWM:") - before));
}

#[cfg(target_os = "linux")]
#[test]
fn the_memory_estimate_is_what_a_large_body_takes() {
    for shape in ["110,2", "70,4", "36,8"] {
        let mut command = std::process::Command::new(std::env::current_exe().unwrap());
        command.args(["--exact", "large::one_large_body", "--ignored", "--nocapture"]);
        let output = command.env("LARGE_BODY", shape).env("RAYON_NUM_THREADS", "1").output().unwrap();
        let text = String::from_utf8(output.stdout).unwrap();
        let ratio = text.lines().find_map(|l| l.split("estimate over peak: ").nth(1)).unwrap_or_else(|| panic!("{text}"));
        let ratio: f64 = ratio.trim().parse().unwrap();
        assert!((0.9..1.3).contains(&ratio), "{shape}: {ratio}");
    }
}
