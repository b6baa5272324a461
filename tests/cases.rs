//! One case, one name: data/scenes/X.toml, data/reference/X.json, fn x_...() here. Most are solved by the library; those about files and exit codes
//! go through the whole program.
#![allow(clippy::unwrap_used)]

mod known;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use cli::Exit;
use known::{at, difference_modulo, number, numbers, problem, profile, reaction, reference, run, solved};
use wearshape::{Profile, Solution, Status};

/// Annulus r = 20 to 120, 100 MPa, a = b = 1 (Paczelt and Mroz 2007, section 7): the steady pressure is p r = const,
/// 350 MPa inside and 350/6 MPa outside, the torque mu F (r_i + r_e)/2.
#[test]
fn annular_punch_pressure() {
    let run = run("annular-punch", "pressure", &["--set", "tasks=[pressure]"]);
    assert_eq!(run.exit, Exit::Done);
    let pressure = &run.summary()["pressure"];
    assert_relative_eq!(number(&pressure["p_max_MPa"]), 350.0, max_relative = 1e-12);
    assert_relative_eq!(number(&pressure["p_min_MPa"]), 350.0 / 6.0, max_relative = 1e-12);
    assert_relative_eq!(number(&pressure["effective_radius_mm"]), 70.0, max_relative = 1e-12);
    assert_relative_eq!(number(&pressure["torque_Nmm"]), 0.25 * 4398229.715025711 * 70.0, max_relative = 1e-12);
}

/// Drum, b = 1/2: the steady pressure is p ~ cos^2, 5.45455 MPa in the middle and 4.09091 MPa at +-30 deg.
#[test]
fn drum_brake_block_pressure() {
    let run = run("drum-brake-block", "pressure", &["--set", "tasks=[pressure]"]);
    assert_eq!(run.exit, Exit::Done);
    let pressure = &run.summary()["pressure"];
    assert_relative_eq!(number(&pressure["p_max_MPa"]), 60.0 / 11.0, max_relative = 1e-12);
    assert_relative_eq!(number(&pressure["p_min_MPa"]), 45.0 / 11.0, max_relative = 1e-12);
}

/// Punch L = 60, b = 2, M0/F0 = 5 mm (section 6): edge pressures 1.430662 and 0.351531 of the mean.
#[test]
fn translating_punch_pressure() {
    let run = run("translating-punch", "pressure", &["--set", "tasks=[pressure]", "--set", "load.moment=5 kN mm"]);
    assert_eq!(run.exit, Exit::Done);
    let pressure = &run.summary()["pressure"];
    let mean = 1000.0 / 600.0;
    assert_relative_eq!(number(&pressure["p_max_MPa"]), 1.430662 * mean, max_relative = 1e-6);
    assert_relative_eq!(number(&pressure["p_min_MPa"]), 0.351531 * mean, max_relative = 2e-6);
}

/// Pad to and fro with a linear wear rule: the mean of both pressures is F/A = 2.5 MPa, and the largest of each are the same by symmetry.
#[test]
fn reciprocating_pad_pressures() {
    let pad = solved("reciprocating-pad", &[], None);
    assert_eq!(pad.status, Status::Ok, "{:?}", pad.reason);
    let (mean, both) = (pad.pressure.as_ref().unwrap(), pad.reversing.as_ref().unwrap());
    assert_relative_eq!(mean.p_max.unwrap(), 2.5, max_relative = 1e-9);
    assert_relative_eq!(mean.p_min.unwrap(), 2.5, max_relative = 1e-9);
    assert_relative_eq!(both.forward.p_max, both.back.p_max, max_relative = 1e-6);
    // Where the other sense lifts off, one carries all: the largest pressure is the same over some length, forward at one end and backward at the other.
    assert!(both.forward.p_max_where * both.back.p_max_where < 0.0);
    assert!(estimated_gap_error(&pad) < 1e-4);
}

/// Ball of radius 3 mm on a disc, both wear by Archard's law: on 200 m under 5 N it loses k F s, and flat-worn the depth h with
/// pi h^2 (R - h/3) = k F s but for the elastic bulge (1 %); the disc loses its own k F s.
#[test]
fn pin_on_disc_wear() {
    let worn = solved("pin-on-disc", &["accuracy=1e-3"], None);
    assert_eq!(worn.status, Status::Ok);
    let wear = worn.wear.as_ref().unwrap();
    let groove = wear.groove.as_ref().unwrap();
    let volumes = wear.volumes.unwrap();
    assert_relative_eq!(volumes[0], 0.01, max_relative = 1e-10);
    assert_relative_eq!(volumes[1], 0.005, max_relative = 1e-10);
    assert_relative_eq!(wear.depth.unwrap(), 1e3 * (0.01 / (std::f64::consts::PI * 3.0)).sqrt(), max_relative = 1e-2);
    // Across the groove: a chord of what the disc would wear standing still, 4/3 a of its depth in the middle over the length of the track.
    let half = 0.5 * wear.scar.unwrap();
    let ratio = 0.5 * 4.0 / 3.0 * half / (std::f64::consts::TAU * 15.0);
    assert_relative_eq!(groove.depth_ratio, ratio, max_relative = 2e-2);
    let [(_, y), (_, depth)] = &worn.groove[..] else { panic!("groove.csv has two columns") };
    let area: f64 = (1..y.len()).map(|i| 0.5e-3 * (depth[i] + depth[i - 1]) * (y[i] - y[i - 1])).sum();
    assert_relative_eq!(area * std::f64::consts::TAU * 15.0, groove.volume, max_relative = 1e-3);
}

/// Largest error of the drum's gap at the five known angles, relative to the largest known gap, modulo the rigid part.
fn drum_gap_error(solution: &Solution, key: &str) -> f64 {
    let known = &reference("drum-brake-block")["uniform_gap"];
    let wanted = numbers(&known[key]["gap_um"]);
    let mode: Vec<f64> = numbers(&known["alpha_deg"]).iter().map(|a| a.to_radians().cos()).collect();
    let largest = wanted.iter().copied().fold(0.0, f64::max);
    difference_modulo(&profile(solution).gap, &wanted, &mode) / largest
}

/// Estimated relative error of the gap.
fn estimated_gap_error(solution: &Solution) -> f64 {
    solution.error.as_ref().unwrap().gap_relative.unwrap()
}

#[test]
fn drum_brake_block_gap_is_as_accurate_as_asked_and_its_energies_and_balance_hold() {
    for (mu, key) in [("0", "mu_0"), ("0.25", "mu_0.25")] {
        let friction = format!("contact.friction={mu}");
        let drum = solved("drum-brake-block", &["optimum.functional=uniform", "accuracy=1e-7", &friction], Some(5));
        assert_eq!(drum.status, Status::Ok);
        let (error, estimate) = (drum_gap_error(&drum, key), estimated_gap_error(&drum));
        assert!(error < 1e-7, "{key}: {error:.2e}");
        // The known gaps end at 1e-9 um, a few 1e-9 of the largest.
        assert!(error < 10.0 * estimate && estimate < 1e-7, "{key}: true {error:.2e}, estimated {estimate:.2e}");
        let energy = numbers(&reference("drum-brake-block")["uniform_gap"][key]["energy_Nmm"]);
        let found = drum.energy.as_ref().unwrap();
        assert_relative_eq!(found.body1.unwrap(), energy[0], max_relative = 1e-10);
        assert_relative_eq!(found.body2.unwrap(), energy[1], max_relative = 1e-10);
        let [left, right, hub] = ["body1.left", "body1.right", "body2.inner"].map(|edge| reaction(&drum, edge));
        let guides = left[0] + right[0];
        assert_abs_diff_eq!(guides, -hub[0], epsilon = 1e-8);
        assert_abs_diff_eq!(hub[1], 1e4, epsilon = 1e-6);
        // Uniform pressure 5 MPa: int mu p cos(alpha) over the arc is mu F0.
        assert_abs_diff_eq!(guides, mu.parse::<f64>().unwrap() * 1e4, epsilon = 1e-6);
    }
}

#[test]
fn drum_brake_block_error_falls_with_the_degree_and_its_estimate_follows() {
    let mut last = f64::INFINITY;
    for degree in [6, 8, 10, 12] {
        let set = format!("mesh.degree={degree}");
        let drum = solved("drum-brake-block", &["optimum.functional=uniform", &set, "check=false"], Some(5));
        let (error, estimate) = (drum_gap_error(&drum, "mu_0.25"), estimated_gap_error(&drum));
        println!("degree {degree}: true {error:.2e}, estimated {estimate:.2e}");
        assert!(error < 0.2 * last, "degree {degree}: {error:.2e} after {last:.2e}");
        assert!(error < 10.0 * estimate && estimate < 10.0 * error, "true {error:.2e}, estimated {estimate:.2e}");
        last = error;
    }
}

/// Round trips of a scene at an accuracy: on the same operators, and on an independent discretisation.
fn round_trips(scene: &str, accuracy: &str) -> [f64; 2] {
    let solution = solved(scene, &[&format!("accuracy={accuracy}")], None);
    assert_eq!(solution.status, Status::Ok, "{scene} at {accuracy}");
    let shape = solution.shape.unwrap();
    [shape.roundtrip_same, shape.roundtrip_independent].map(Option::unwrap)
}

/// On the same operators only round-off is left, which grows with the smallest cells; on others the error falls with the accuracy.
#[test]
fn shapes_of_all_scenes_of_the_paper_give_the_pressure_back() {
    // The ring and the annulus are accurate to 1e-8 in few degrees.
    let scenes =
        [("drum-brake-block", "1e-8"), ("drum-brake-ring", "1e-9"), ("translating-punch", "1e-8"), ("annular-punch", "1e-9")];
    for (scene, fine) in scenes {
        let [[same, independent], [finer, closer]] = ["1e-4", fine].map(|accuracy| round_trips(scene, accuracy));
        println!("{scene}: same {same:.1e} {finer:.1e}, independent {independent:.1e} {closer:.1e}");
        assert!(same < 1e-9 && finer < 1e-9, "{scene}: {same:.2e} {finer:.2e}");
        assert!(closer < 1e-5 && closer < 0.1 * independent, "{scene}: {independent:.2e} {closer:.2e}");
    }
}

/// Normal displacement jump u2 - u1, mm, from both in um.
fn jump([first, second]: &[Vec<f64>; 2]) -> Vec<f64> {
    second.iter().zip(first).map(|(b, a)| 1e-3 * (b - a)).collect()
}

#[test]
fn translating_punch_jump() {
    let known = &reference("translating-punch")["jump"];
    for (key, friction, moment) in [("mu_0_M_0", "0", "0"), ("mu_0_M_-5000", "0", "-5000"), ("mu_0.25_M_0", "0.25", "0")] {
        let (friction, moment) = (format!("contact.friction={friction}"), format!("load.moment={moment}"));
        let run =
            run("translating-punch", key, &["--set", &friction, "--set", &moment, "--set", "accuracy=1e-7", "--sample", "3"]);
        assert_eq!(run.exit, Exit::Done);
        let jump = jump(&["un1_um", "un2_um"].map(|name| run.column(name)));
        for (found, wanted) in jump.iter().zip(numbers(&known[key])) {
            assert_relative_eq!(1e3 * found, wanted, max_relative = 1e-6);
        }
    }
}

/// With body 1's rigid coordinates at zero, surfaces that touch everywhere jump by the rigid motion alone.
#[test]
fn in_full_contact_the_displacements_jump_by_the_rigid_motion() {
    let punch = solved("translating-punch", &["tasks=[contact]", "load.tilt=0"], None);
    let approach = punch.contact.as_ref().unwrap().approach.unwrap();
    for jump in jump(&profile(&punch).normal_displacement) {
        assert_relative_eq!(jump, -approach, max_relative = 1e-9);
    }
    let drum = solved("drum-brake-block", &["tasks=[contact]", "mesh.degree=8"], None);
    let drum = profile(&drum);
    let along: Vec<f64> = jump(&drum.normal_displacement).iter().zip(&drum.normal).map(|(jump, n)| jump / n[2]).collect();
    let first = along[0];
    assert!(first < 0.0);
    for along in &along {
        assert_relative_eq!(*along, first, max_relative = 1e-9);
    }
}

#[test]
fn annular_punch_jump_and_twist() {
    let known = reference("annular-punch");
    let above_least = |columns: &[Vec<f64>; 2]| {
        let jump = jump(columns);
        let least = jump.iter().copied().fold(f64::INFINITY, f64::min);
        jump.iter().map(|m| m - least).collect::<Vec<f64>>()
    };
    let steady = run("annular-punch", "steady", &["--set", "accuracy=1e-7", "--sample", "3"]);
    let normal = ["un1_um", "un2_um"].map(|name| steady.column(name));
    for (found, wanted) in above_least(&normal).iter().zip(numbers(&known["jump"]["b_1_q_1"])) {
        assert_abs_diff_eq!(*found, wanted, epsilon = 1e-6 * 0.27);
    }
    let twist =
        steady.column("uphi1_um").iter().zip(steady.column("uphi2_um")).map(|(a, b)| 1e-3 * (a - b)).collect::<Vec<f64>>();
    for (found, wanted) in twist.iter().zip(numbers(&known["twist"]["value"])) {
        assert_relative_eq!(*found, wanted, max_relative = 1e-6);
    }
    let steep = solved("annular-punch", &["optimum.functional=wear-power", "optimum.q=0.505"], Some(3));
    for (found, wanted) in above_least(&profile(&steep).normal_displacement).iter().zip(numbers(&known["jump"]["q_0.505"])) {
        assert_abs_diff_eq!(*found, wanted, epsilon = 1e-5 * 2.7);
    }
}

#[test]
fn drum_brake_ring_gap_with_supports_on_both_sides_and_in_the_middle() {
    let known = &reference("drum-brake-ring")["uniform_gap"];
    let mode: Vec<f64> = numbers(&known["alpha_deg"]).iter().map(|a| a.to_radians().cos()).collect();
    for (key, support) in
        [("both", "body1.support={ left = [\"x\"], right = [\"x\"] }"), ("centre", "body1.support={ centre = [\"x\"] }")]
    {
        let ring = solved("drum-brake-ring", &["optimum.functional=uniform", support, "check=false"], Some(5));
        let wanted: Vec<f64> = numbers(&known[key]).iter().map(|g| 1e3 * g).collect();
        let largest = wanted.iter().copied().fold(0.0, f64::max);
        let error = difference_modulo(&profile(&ring).gap, &wanted, &mode) / largest;
        assert!(error < 1e-6, "{key}: {error:.2e}");
    }
}

fn pressure_at(solution: &Solution, s: f64) -> f64 {
    let profile = profile(solution);
    at(profile, &profile.pressure, s)
}

#[test]
fn contact_of_the_drum_block_the_punch_and_the_annulus_as_given() {
    let drum = reference("drum-brake-block");
    for (mu, key) in [("0", "mu_0"), ("0.25", "mu_0.25")] {
        let friction = format!("contact.friction={mu}");
        let solution = solved("drum-brake-block", &["tasks=[contact]", &friction, "accuracy=1e-5"], Some(81));
        let known = &drum["contact"][key];
        for (angle, wanted) in numbers(&known["alpha_deg"]).iter().zip(numbers(&known["pressure_MPa"])) {
            assert_relative_eq!(pressure_at(&solution, 200.0 * angle.to_radians()), wanted, max_relative = 1e-5);
        }
        if key == "mu_0.25" {
            let guides = ["body1.left", "body1.right"].map(|edge| reaction(&solution, edge)[0]).iter().sum::<f64>();
            assert_relative_eq!(-guides, number(&known["force_x_N"]), max_relative = 1e-5);
        }
    }
    let punch = reference("translating-punch");
    for (mu, key) in [("0", "mu_0"), ("0.25", "mu_0.25")] {
        let friction = format!("contact.friction={mu}");
        let solution = solved("translating-punch", &["tasks=[contact]", &friction, "load.tilt=0", "accuracy=1e-5"], Some(41));
        let known = &punch["contact"][key];
        for (x, wanted) in numbers(&known["x_mm"]).iter().zip(numbers(&known["pressure_MPa"])) {
            assert_relative_eq!(pressure_at(&solution, *x), wanted, max_relative = 1e-5);
        }
    }
    let known = &reference("annular-punch")["contact"];
    // 2.5 mm from the singular edge: beyond the inner 95 % that the accuracy speaks of.
    let annulus = solved("annular-punch", &["tasks=[contact]", "accuracy=1e-7"], Some(41));
    for (r, wanted) in numbers(&known["r_mm"]).iter().zip(numbers(&known["pressure_MPa"])) {
        assert_relative_eq!(pressure_at(&annulus, *r), wanted, max_relative = 1e-5);
    }
}

#[test]
fn wear_in_time_arrives_at_the_steady_pressure_and_at_the_direct_shape() {
    let arrives = |scene: &str, sets: &[&str], direct: &[&str], mode: &dyn Fn(f64) -> Vec<f64>| {
        let common = ["accuracy=1e-6", "check=false"];
        let worn = solved(scene, &[sets, &common].concat(), Some(41));
        let shape = solved(&scene.replace("punch-wear", "translating-punch"), &[direct, &common].concat(), Some(41));
        assert_eq!(worn.status, Status::Ok);
        let [worn, shape]: [&Profile; 2] = [&worn, &shape].map(profile);
        for (a, b) in worn.pressure.iter().zip(&shape.pressure) {
            assert_relative_eq!(*a, *b, max_relative = 1e-8);
        }
        // The best rigid part by a pass over the modes, each orthogonalised by the last.
        let (s, mut found, wanted) = (&shape.s, worn.gap.clone(), &shape.gap);
        for k in 0..mode(0.0).len() {
            let column: Vec<f64> = s.iter().map(|s| mode(*s)[k]).collect();
            let difference: Vec<f64> = found.iter().zip(wanted).map(|(a, b)| a - b).collect();
            let along =
                difference.iter().zip(&column).map(|(d, c)| d * c).sum::<f64>() / column.iter().map(|c| c * c).sum::<f64>();
            found.iter_mut().zip(&column).for_each(|(f, c)| *f -= along * c);
        }
        let largest = wanted.iter().copied().fold(0.0, f64::max);
        let error = found.iter().zip(wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest;
        assert!(error < 1e-7, "{scene}: {error:.2e}");
    };
    arrives("punch-wear", &[], &[], &|x| vec![1.0, x / 30.0]);
    arrives("drum-brake-block", &["tasks=[wear]"], &["tasks=[shape]"], &|s| vec![(s / 200.0).cos()]);
}

/// What the program writes of a run without time is what `report` has of the library's solution, byte for byte, and the times beside it.
#[test]
fn the_folder_of_the_program_holds_the_files_of_the_library() {
    for (scene, degree) in
        [("drum-brake-block", "mesh.degree=6"), ("annular-punch", "mesh.degree=4"), ("pinned-shoe", "check=false")]
    {
        let run = run(scene, "files", &["--set", degree]);
        assert_eq!(run.exit, Exit::Done);
        let problem = problem(scene, &[degree]);
        let options = wearshape::Options { machining: true, ..wearshape::Options::default() };
        let going_on = &mut |_: wearshape::Event<'_>| std::ops::ControlFlow::Continue(());
        let solution = wearshape::solve(&problem, &options, &wearshape::Bodies::default(), going_on).unwrap();
        let files = report::files(&problem, &solution);
        assert!(files.iter().any(|(name, _)| name == "contact.csv") && files.iter().any(|(name, _)| name == "report.html"));
        for (name, bytes) in files.iter().filter(|(name, _)| name != "summary.json") {
            assert!(run.file(name).as_ref() == Some(bytes), "{scene}: {name} differs");
        }
        // The folder lists its files in its summary.
        let (_, bytes) = files.iter().find(|(name, _)| name == "summary.json").unwrap();
        let mut written = run.summary();
        let manifest = written.as_object_mut().unwrap().remove("manifest").unwrap();
        assert_eq!(written, serde_json::from_slice::<serde_json::Value>(bytes).unwrap());
        assert!(files.iter().all(|(name, _)| manifest.as_array().unwrap().iter().any(|listed| listed == name)));
        assert!(run.file("timing.json").is_some());
    }
}

#[test]
fn the_exit_says_how_a_run_ended() {
    let beyond = run("translating-punch", "beyond", &["--set", "tasks=[pressure]", "--set", "load.moment=40 kN mm"]);
    assert_eq!((beyond.exit, &beyond.summary()["status"]), (Exit::GoalMissed, &"refused".into()));
    let coarse = run("drum-brake-block", "coarse", &["--set", "tasks=[contact]", "--set", "accuracy=1e-13"]);
    assert_eq!((coarse.exit, &coarse.summary()["status"]), (Exit::GoalMissed, &"accuracy-missed".into()));
    let wrong = run("drum-brake-block", "wrong", &["--set", "load.force=-1"]);
    assert_eq!((wrong.exit, wrong.file("summary.json")), (Exit::Wrong, None));
}
