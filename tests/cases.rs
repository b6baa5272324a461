//! One case, one name: data/scenes/X.toml, data/reference/X.json, fn x_...() here, through the whole program.
#![allow(clippy::unwrap_used)]

mod known;

use approx::{assert_abs_diff_eq, assert_relative_eq};
use cli::Exit;
use known::{difference_modulo, number, numbers, reference, run};

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

/// Largest error of the drum's gap at the five known angles, relative to the largest known gap, modulo the rigid part.
fn drum_gap_error(run: &known::Run, key: &str) -> f64 {
    let known = &reference("drum-brake-block")["uniform_gap"];
    let wanted = numbers(&known[key]["gap_um"]);
    let mode: Vec<f64> = numbers(&known["alpha_deg"]).iter().map(|a| a.to_radians().cos()).collect();
    let largest = wanted.iter().copied().fold(0.0, f64::max);
    difference_modulo(&run.column("gap_um"), &wanted, &mode) / largest
}

#[test]
fn drum_brake_block_gap_is_as_accurate_as_asked_and_its_energies_and_balance_hold() {
    for (mu, key) in [("0", "mu_0"), ("0.25", "mu_0.25")] {
        let friction = format!("contact.friction={mu}");
        let sets = ["--set", "optimum.functional=uniform", "--set", "accuracy=1e-7", "--set", &friction, "--sample", "5"];
        let run = run("drum-brake-block", key, &sets);
        assert_eq!(run.exit, Exit::Done);
        let summary = run.summary();
        let (error, estimate) = (drum_gap_error(&run, key), number(&summary["error"]["gap_relative"]));
        assert!(error < 1e-7, "{key}: {error:.2e}");
        // The known gaps end at 1e-9 um, a few 1e-9 of the largest.
        assert!(error < 10.0 * estimate && estimate < 1e-7, "{key}: true {error:.2e}, estimated {estimate:.2e}");
        let energy = numbers(&reference("drum-brake-block")["uniform_gap"][key]["energy_Nmm"]);
        assert_relative_eq!(number(&summary["energy"]["body1_Nmm"]), energy[0], max_relative = 1e-10);
        assert_relative_eq!(number(&summary["energy"]["body2_Nmm"]), energy[1], max_relative = 1e-10);
        let reaction = |edge: &str, component: &str| number(&summary["reactions"][edge][component]);
        let guides = reaction("body1.left", "x_N") + reaction("body1.right", "x_N");
        assert_abs_diff_eq!(guides, -reaction("body2.inner", "x_N"), epsilon = 1e-8);
        assert_abs_diff_eq!(reaction("body2.inner", "z_N"), 1e4, epsilon = 1e-6);
        // Uniform pressure 5 MPa: int mu p cos(alpha) over the arc is mu F0.
        assert_abs_diff_eq!(guides, mu.parse::<f64>().unwrap() * 1e4, epsilon = 1e-6);
    }
}

#[test]
fn drum_brake_block_error_falls_with_the_degree_and_its_estimate_follows() {
    let mut last = f64::INFINITY;
    for degree in [6, 8, 10, 12] {
        let set = format!("mesh.degree={degree}");
        let sets = ["--set", "optimum.functional=uniform", "--set", &set, "--set", "check=false", "--sample", "5"];
        let run = run("drum-brake-block", &format!("degree-{degree}"), &sets);
        let (error, estimate) = (drum_gap_error(&run, "mu_0.25"), number(&run.summary()["error"]["gap_relative"]));
        println!("degree {degree}: true {error:.2e}, estimated {estimate:.2e}");
        assert!(error < 0.2 * last, "degree {degree}: {error:.2e} after {last:.2e}");
        assert!(error < 10.0 * estimate && estimate < 10.0 * error, "true {error:.2e}, estimated {estimate:.2e}");
        last = error;
    }
}

/// Round trips of a scene at an accuracy: on the same operators, and on an independent discretisation.
fn round_trips(scene: &str, accuracy: &str) -> [f64; 2] {
    let run = run(scene, &format!("round-trip-{accuracy}"), &["--set", &format!("accuracy={accuracy}")]);
    assert_eq!(run.exit, Exit::Done, "{scene} at {accuracy}");
    ["roundtrip_same", "roundtrip_independent"].map(|key| number(&run.summary()["shape"][key]))
}

/// On the same operators only round-off is left, which grows with the smallest cells; on others the error falls with the accuracy.
#[test]
fn shapes_of_all_scenes_of_the_paper_give_the_pressure_back() {
    for scene in ["drum-brake-block", "drum-brake-ring", "translating-punch", "annular-punch"] {
        let [[same, independent], [finer, closer]] = ["1e-4", "1e-8"].map(|accuracy| round_trips(scene, accuracy));
        println!("{scene}: same {same:.1e} {finer:.1e}, independent {independent:.1e} {closer:.1e}");
        assert!(same < 1e-9 && finer < 1e-9, "{scene}: {same:.2e} {finer:.2e}");
        assert!(closer < 1e-5 && closer < 0.1 * independent, "{scene}: {independent:.2e} {closer:.2e}");
    }
}

/// Normal displacement jump u2 - u1, mm.
fn jump(run: &known::Run) -> Vec<f64> {
    run.column("un2_um").iter().zip(run.column("un1_um")).map(|(b, a)| 1e-3 * (b - a)).collect()
}

#[test]
fn translating_punch_jump() {
    let known = &reference("translating-punch")["jump"];
    for (key, friction, moment) in [("mu_0_M_0", "0", "0"), ("mu_0_M_-5000", "0", "-5000"), ("mu_0.25_M_0", "0.25", "0")] {
        let (friction, moment) = (format!("contact.friction={friction}"), format!("load.moment={moment}"));
        let run =
            run("translating-punch", key, &["--set", &friction, "--set", &moment, "--set", "accuracy=1e-7", "--sample", "3"]);
        assert_eq!(run.exit, Exit::Done);
        for (found, wanted) in jump(&run).iter().zip(numbers(&known[key])) {
            assert_relative_eq!(1e3 * found, wanted, max_relative = 1e-6);
        }
    }
}

/// With body 1's rigid coordinates at zero, surfaces that touch everywhere jump by the rigid motion alone.
#[test]
fn in_full_contact_the_displacements_jump_by_the_rigid_motion() {
    let punch = run("translating-punch", "contact-jump", &["--set", "tasks=[contact]", "--set", "load.tilt=0"]);
    let approach = number(&punch.summary()["contact"]["approach_mm"]);
    for jump in jump(&punch) {
        assert_relative_eq!(jump, -approach, max_relative = 1e-9);
    }
    let drum = run("drum-brake-block", "contact-jump", &["--set", "tasks=[contact]", "--set", "mesh.degree=8"]);
    let along: Vec<f64> = jump(&drum).iter().zip(drum.column("nz")).map(|(jump, cosine)| jump / cosine).collect();
    let first = along[0];
    assert!(first < 0.0);
    for along in &along {
        assert_relative_eq!(*along, first, max_relative = 1e-9);
    }
}

#[test]
fn annular_punch_jump_and_twist() {
    let known = reference("annular-punch");
    let above_least = |run: &known::Run| {
        let jump = jump(run);
        let least = jump.iter().copied().fold(f64::INFINITY, f64::min);
        jump.iter().map(|m| m - least).collect::<Vec<f64>>()
    };
    let steady = run("annular-punch", "steady", &["--set", "accuracy=1e-7", "--sample", "3"]);
    for (found, wanted) in above_least(&steady).iter().zip(numbers(&known["jump"]["b_1_q_1"])) {
        assert_abs_diff_eq!(*found, wanted, epsilon = 1e-6 * 0.27);
    }
    let twist =
        steady.column("uphi1_um").iter().zip(steady.column("uphi2_um")).map(|(a, b)| 1e-3 * (a - b)).collect::<Vec<f64>>();
    for (found, wanted) in twist.iter().zip(numbers(&known["twist"]["value"])) {
        assert_relative_eq!(*found, wanted, max_relative = 1e-6);
    }
    let sets = ["--set", "optimum.functional=wear-power", "--set", "optimum.q=0.505", "--sample", "3"];
    let steep = run("annular-punch", "near-singular", &sets);
    for (found, wanted) in above_least(&steep).iter().zip(numbers(&known["jump"]["q_0.505"])) {
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
        let sets = ["--set", "optimum.functional=uniform", "--set", support, "--set", "check=false", "--sample", "5"];
        let run = run("drum-brake-ring", key, &sets);
        let wanted: Vec<f64> = numbers(&known[key]).iter().map(|g| 1e3 * g).collect();
        let largest = wanted.iter().copied().fold(0.0, f64::max);
        let error = difference_modulo(&run.column("gap_um"), &wanted, &mode) / largest;
        assert!(error < 1e-6, "{key}: {error:.2e}");
    }
}

#[test]
fn contact_of_the_drum_block_the_punch_and_the_annulus_as_given() {
    let drum = reference("drum-brake-block");
    for (mu, key) in [("0", "mu_0"), ("0.25", "mu_0.25")] {
        let friction = format!("contact.friction={mu}");
        let sets = ["--set", "tasks=[contact]", "--set", &friction, "--set", "accuracy=1e-5", "--sample", "81"];
        let run = run("drum-brake-block", &format!("contact-{key}"), &sets);
        let known = &drum["contact"][key];
        for (angle, wanted) in numbers(&known["alpha_deg"]).iter().zip(numbers(&known["pressure_MPa"])) {
            assert_relative_eq!(run.at("pressure_MPa", 200.0 * angle.to_radians()), wanted, max_relative = 1e-5);
        }
        if key == "mu_0.25" {
            let summary = run.summary();
            let guides = ["body1.left", "body1.right"].map(|e| number(&summary["reactions"][e]["x_N"])).iter().sum::<f64>();
            assert_relative_eq!(-guides, number(&known["force_x_N"]), max_relative = 1e-5);
        }
    }
    let punch = reference("translating-punch");
    for (mu, key) in [("0", "mu_0"), ("0.25", "mu_0.25")] {
        let friction = format!("contact.friction={mu}");
        let sets =
            ["--set", "tasks=[contact]", "--set", &friction, "--set", "load.tilt=0", "--set", "accuracy=1e-5", "--sample", "41"];
        let run = run("translating-punch", &format!("contact-{key}"), &sets);
        let known = &punch["contact"][key];
        for (x, wanted) in numbers(&known["x_mm"]).iter().zip(numbers(&known["pressure_MPa"])) {
            assert_relative_eq!(run.at("pressure_MPa", *x), wanted, max_relative = 1e-5);
        }
    }
    let known = &reference("annular-punch")["contact"];
    // 2.5 mm from the singular edge: beyond the inner 95 % that the accuracy speaks of.
    let sets = ["--set", "tasks=[contact]", "--set", "accuracy=1e-7", "--sample", "41"];
    let annulus = run("annular-punch", "contact", &sets);
    for (r, wanted) in numbers(&known["r_mm"]).iter().zip(numbers(&known["pressure_MPa"])) {
        assert_relative_eq!(annulus.at("pressure_MPa", *r), wanted, max_relative = 1e-5);
    }
}

#[test]
fn wear_in_time_arrives_at_the_steady_pressure_and_at_the_direct_shape() {
    let arrives = |scene: &str, sets: &[&str], direct: &[&str], mode: &dyn Fn(f64) -> Vec<f64>| {
        let common = ["--set", "accuracy=1e-6", "--set", "check=false", "--sample", "41"];
        let worn = run(scene, "worn", &[sets, &common].concat());
        let shape = run(scene.replace("punch-wear", "translating-punch").as_str(), "direct", &[direct, &common].concat());
        assert_eq!(worn.exit, Exit::Done);
        let (wanted, found) = (shape.column("pressure_MPa"), worn.column("pressure_MPa"));
        for (a, b) in found.iter().zip(&wanted) {
            assert_relative_eq!(*a, *b, max_relative = 1e-8);
        }
        let s = shape.column("s_mm");
        // The best rigid part by a pass over the modes, each orthogonalised by the last.
        let (mut found, wanted) = (worn.column("gap_um"), shape.column("gap_um"));
        for k in 0..mode(0.0).len() {
            let column: Vec<f64> = s.iter().map(|s| mode(*s)[k]).collect();
            let difference: Vec<f64> = found.iter().zip(&wanted).map(|(a, b)| a - b).collect();
            let along =
                difference.iter().zip(&column).map(|(d, c)| d * c).sum::<f64>() / column.iter().map(|c| c * c).sum::<f64>();
            found.iter_mut().zip(&column).for_each(|(f, c)| *f -= along * c);
        }
        let largest = wanted.iter().copied().fold(0.0, f64::max);
        let error = found.iter().zip(&wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest;
        assert!(error < 1e-7, "{scene}: {error:.2e}");
    };
    arrives("punch-wear", &[], &[], &|x| vec![1.0, x / 30.0]);
    arrives("drum-brake-block", &["--set", "tasks=[wear]"], &["--set", "tasks=[shape]"], &|s| vec![(s / 200.0).cos()]);
}
