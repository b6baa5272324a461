//! Pressure scenes through the program, against closed forms and textbooks.

use approx::assert_relative_eq;

use crate::call::Bench;

fn pressure(args: &str) -> serde_json::Value {
    let bench = Bench::new();
    let call = bench.call(&format!("run {args} -q -o x"));
    assert_eq!(call.code, 0, "{args}: {}", call.err);
    let summary: serde_json::Value = serde_json::from_str(&bench.read("x/summary.json")).unwrap();
    summary["pressure"].clone()
}

fn number(value: &serde_json::Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("no {key} in {value}"))
}

#[test]
fn the_drum_is_worn_in_at_cos_squared() {
    let p = pressure("drum-brake-block --set tasks=[pressure]");
    // b = 1/2: p ~ cos^2, 5.45455 and 4.09091 MPa (benchmarks, true equilibrium, k = 2).
    assert_relative_eq!(number(&p, "p_max_MPa"), 5.454545454545454, max_relative = 1e-12);
    assert_relative_eq!(number(&p, "p_min_MPa"), 4.090909090909091, max_relative = 1e-12);
    assert_relative_eq!(number(&p, "force_N"), 1e4, max_relative = 1e-12);
    assert!(number(&p, "steadiness_residual") < 1e-13);
}

#[test]
fn the_paper_normalisation_misses_part_of_the_load() {
    let p = pressure("drum-brake-block --set tasks=[pressure] --set optimum.functional=wear-power --set optimum.balance=paper");
    // docs/theory-errata.md, the normalisation of (29)-(31): 9582 N instead of 10000 N.
    assert_relative_eq!(number(&p, "force_N"), 9582.0, max_relative = 1e-4);
    assert_relative_eq!(number(&p, "normal_force_N"), 1e4, max_relative = 1e-12);
}

#[test]
fn the_clutch_has_the_textbook_torque() {
    // Uniform wear: mu F (r_o + r_i)/2; uniform pressure: (2/3) mu F (r_o^3 - r_i^3)/(r_o^2 - r_i^2), r_eff 70 and 81.905 mm.
    let p = pressure("annular-punch --set tasks=[pressure]");
    assert_relative_eq!(number(&p, "effective_radius_mm"), 70.0, max_relative = 1e-12);
    let p = pressure("annular-punch --set tasks=[pressure] --set optimum.functional=uniform");
    let expected = 2.0 / 3.0 * (120f64.powi(3) - 20f64.powi(3)) / (120f64.powi(2) - 400.0);
    assert_relative_eq!(number(&p, "effective_radius_mm"), expected, max_relative = 1e-12);
}

#[test]
fn the_pinned_shoe_is_shigleys() {
    // Shigley, example 16-2: p_a = 1 MPa, right shoe T = 365.8 N m with F = 2.2791 kN.
    let p = pressure("pinned-shoe");
    assert_relative_eq!(number(&p, "p_max_MPa"), 1.0, max_relative = 1e-4);
    assert_relative_eq!(number(&p, "torque_Nmm"), 365.8e3, max_relative = 2e-4);
    // The other sense of turning is the trailing shoe: 161.9 N m.
    let p = pressure("pinned-shoe --set sliding.omega=-10");
    assert_relative_eq!(number(&p, "torque_Nmm").abs(), 161.9e3, max_relative = 5e-4);
}

#[test]
fn a_pin_on_the_lining_is_refused_and_a_shoe_that_locks_is_told_its_moment() {
    let bench = Bench::new();
    let call = bench.check_and_run("pinned-shoe --set surface.pinned-shoe.pin_distance=150");
    assert_eq!(call.code, 2, "{}", call.out);
    assert!(call.err.contains("the pin lies on the contact") && call.err.contains("it cannot lie on the lining"), "{}", call.err);
    let call = bench.call("run pinned-shoe --set contact.friction=2 -o locked");
    assert_eq!(call.code, 1, "{}", call.err);
    let said = call.out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(said.contains(" N mm: the friction carries the load"), "{said}");
}

#[test]
fn the_pivoted_shoe_is_a_cosine() {
    // F0 = p_max R t (a0 + sin a0 cos a0) with a0 = 45 deg, R = 200, t = 50.
    let p = pressure("pivoted-shoe");
    let a = std::f64::consts::FRAC_PI_4;
    assert_relative_eq!(number(&p, "p_max_MPa"), 1e4 / (1e4 * (a + 0.5)), max_relative = 1e-9);
    assert!(number(&p, "moment_Nmm").abs() < 1e-6);
}

#[test]
fn the_rectangle_under_two_moments_is_linear() {
    // p = F/A (1 + 3 (Mx/F)/c_x + 3 (My/F)/c_y) at the corners for b = 1.
    let p = pressure("rectangular-punch");
    let mean = 1e4 / 2400.0;
    assert_relative_eq!(number(&p, "p_max_MPa"), mean * (1.0 + 3.0 * 4.0 / 30.0 + 3.0 * 1.5 / 20.0), max_relative = 1e-2);
    assert_relative_eq!(number(&p, "p_mean_MPa"), mean, max_relative = 1e-12);
}

#[test]
fn no_friction_with_beta_means_no_wear_and_the_same_pressure() {
    let with = pressure("translating-punch --set tasks=[pressure] --set load.moment=2_kN_mm");
    let without = pressure("translating-punch --set tasks=[pressure] --set load.moment=2_kN_mm --set contact.friction=0");
    assert_relative_eq!(number(&with, "p_max_MPa"), number(&without, "p_max_MPa"), max_relative = 1e-12);
    for key in ["wear_volume_rate_mm3_per_s", "friction_power_mW", "wear_power_mW"] {
        assert_eq!(number(&without, key), 0.0, "{key}");
    }
    assert_eq!(without["multipliers"]["force"], 0.0);
    assert_eq!(without["feed"]["force"], 0.0);
    assert!(without.get("steadiness_residual").is_none());
}

#[test]
fn a_singular_q_is_answered_for_the_pressure_alone() {
    let p = pressure("annular-punch --set tasks=[pressure] --set optimum.functional=friction-power");
    assert_eq!(p["regime"], "singular");
    // s = 1, D_F: the friction power is least when all the force stands on the inner rim.
    assert_relative_eq!(number(&p["limit_measure"][0], "x_mm"), 20.0, max_relative = 1e-9);
    assert_relative_eq!(number(&p["limit_measure"][0], "force_N"), 4398229.715025711, max_relative = 1e-9);
}

#[test]
fn below_s_of_one_the_answer_is_called_a_maximum() {
    let p = pressure("annular-punch --set tasks=[pressure] --set optimum.functional=friction-power --set optimum.q=.5");
    assert_eq!(p["character"], "maximum");
}

/// The pad carries at most 50 MPa times 6 545 mm^2 = 327 kN under its cap.
#[test]
fn a_load_beyond_what_the_cap_carries_at_s_1_is_refused_at_once() {
    let sets = "--set optimum.functional=wear-power --set optimum.q=.5 --set wear.a=.5 --set optimum.p_max=50";
    for (force, code) in [("3.2e5", 0), ("3.3e5", 1), ("1e8", 1)] {
        let args = format!("run disc-pad -q {sets} --set load.force={force}");
        let call = Bench::new().call_with(&args.split_whitespace().collect::<Vec<_>>());
        assert_eq!(call.code, code, "{force}: {}{}", call.out, call.err);
    }
}

/// The journal arc of another half angle, with what else is set.
fn shell(bench: &Bench, half_angle: &str, set: &[&str]) -> crate::call::Call {
    let half_angle = format!("surface.journal-arc.half_angle={half_angle}");
    let mut args = vec!["run", "journal-arc", "-q", "-o", "x", "--set", &half_angle];
    set.iter().for_each(|set| args.extend(["--set", set]));
    bench.call_with(&args)
}

fn of_shell(half_angle: &str, set: &[&str]) -> serde_json::Value {
    let bench = Bench::new();
    let call = shell(&bench, half_angle, set);
    assert_eq!(call.code, 0, "{half_angle} {set:?}: {}", call.err);
    let summary: serde_json::Value = serde_json::from_str(&bench.read("x/summary.json")).unwrap();
    summary["pressure"].clone()
}

#[test]
fn a_bearing_shell_beyond_90_degrees_has_a_pressure() {
    // p = p_max cos(a) over the half turn that closes: F = p_max R t pi/2.
    let top = 2e3 / (500.0 * std::f64::consts::PI);
    for half in ["100 deg", "180 deg"] {
        let p = of_shell(half, &["contact.friction=0"]);
        assert_relative_eq!(number(&p, "p_max_MPa"), top, max_relative = 1e-12);
        assert_eq!(p["regime"], "partial-contact");
    }
    // With friction it touches over the half turn about atan(mu): sqrt(1 + mu^2) p_max R t pi/2 = F.
    let p = of_shell("2.9", &["contact.friction=1"]);
    assert_relative_eq!(number(&p, "p_max_MPa"), top / 2f64.sqrt(), max_relative = 1e-9);
}

#[test]
fn a_bearing_shell_with_much_friction_and_b_3_has_a_pressure() {
    let p = of_shell("1.2", &["contact.friction=1", "wear.b=3"]);
    assert_relative_eq!(number(&p, "force_N"), 2e3, max_relative = 1e-9);
    assert!(number(&p, "steadiness_residual") < 1e-8);
}

#[test]
fn a_shell_of_more_than_a_turn_is_refused() {
    let call = shell(&Bench::new(), "181 deg", &[]);
    assert_eq!(call.code, 2, "{}", call.err);
    assert!(call.err.contains("at most 180 deg"), "{}", call.err);
}

#[test]
fn a_jammed_shell_is_named() {
    // The friction angle lies beyond the end of the shell: no pressure is balanced.
    let bench = Bench::new();
    let call = shell(&bench, "1", &["contact.friction=2"]);
    assert_eq!(call.code, 1, "{}", call.err);
    let summary: serde_json::Value = serde_json::from_str(&bench.read("x/summary.json")).unwrap();
    assert_eq!(summary["status"], "refused");
    assert_eq!(summary["pressure"]["regime"], "infeasible");
    assert!(summary["verdict"].as_str().unwrap().contains("self-locking"), "{}", summary["verdict"]);
}

/// Body 2 wears by a far higher power of the pressure than the pad: guesses of the feed start where it would wear 1e40 mm/s.
#[test]
fn a_revolving_disc_that_wears_by_a_high_power_is_no_obstacle() {
    let bench = Bench::new();
    let ring = "surface.disc-pad = { inner = 0.2017, outer = 85.2, half_angle = 3.14159 }";
    bench.file(
        "ring.toml",
        &format!(
            "title = \"A wide ring\"\nunits = \"N-mm\"\ntasks = [\"pressure\"]\n{ring}\ncontact = {{ friction = 2 }}\n\
             sliding = {{ omega = 10 }}\nload = {{ force = 2.7282 }}\n\
             wear = {{ beta = [1e-8, 3.7e-10], a = [0, 0.245], b = [0.5, 3.248], counterface = \"revolving\" }}\n"
        ),
    );
    let call = bench.call("run ring.toml -q -o x");
    assert_eq!(call.code, 0, "{}", call.err);
    let summary: serde_json::Value = serde_json::from_str(&bench.read("x/summary.json")).unwrap();
    let p = &summary["pressure"];
    // Body 2's share is 1e-12 of the wear, and body 1 wears alike at every speed: the pressure is uniform.
    let uniform = 2.7282 / (std::f64::consts::PI * (85.2_f64.powi(2) - 0.2017_f64.powi(2)));
    assert_relative_eq!(number(p, "p_max_MPa"), uniform, max_relative = 1e-6);
    assert_relative_eq!(number(p, "p_min_MPa"), uniform, max_relative = 1e-6);
}

/// With `p ~ f^(1/b)` the pressure of a steep wear rule tends to a uniform one, up to the ends of contact.
#[cfg(unix)]
#[test]
fn a_huge_wear_exponent_takes_little_memory_and_levels_the_pressure() {
    let bench = Bench::new();
    for scene in ["disc-pad", "journal-arc", "pivoted-shoe", "annular-punch", "elliptic-punch"] {
        for b in ["1e4", "1e9"] {
            let run = format!("run {scene} -q --threads 1 --set wear.b={b} --set 'tasks=[\"pressure\"]' -o {scene}-{b}");
            let start = std::time::Instant::now();
            // 800 MB of addresses: what the program itself maps is in it.
            let call = bench.shell(&format!("ulimit -v 800000; exec \"$0\" {run}"));
            assert_eq!(call.code, 0, "{scene} {b}: {}", call.err);
            assert!(start.elapsed().as_secs() < 60, "{scene} {b}: {:?}", start.elapsed());
            let summary: serde_json::Value = serde_json::from_str(&bench.read(&format!("{scene}-{b}/summary.json"))).unwrap();
            let p = &summary["pressure"];
            if ["disc-pad", "annular-punch"].contains(&scene) {
                assert_relative_eq!(number(p, "p_max_MPa"), number(p, "p_mean_MPa"), max_relative = 1e-3);
            }
        }
    }
}

/// Body 1 and the mean of body 2 along each circle wear as fast at every radius: `w1(p, v) + w2(p, v) half_angle / pi` is one number.
#[test]
fn a_revolving_disc_of_a_wide_ring_recedes_evenly_with_the_pad() {
    let bench = Bench::new();
    let ring = "surface.disc-pad = { inner = 0.038, outer = 15.7, half_angle = 0.8 }";
    bench.file(
        "ring.toml",
        &format!(
            "title = \"A wide ring\"\nunits = \"N-mm\"\ntasks = [\"pressure\"]\n{ring}\ncontact = {{ friction = 0.3 }}\n\
             sliding = {{ omega = 10 }}\nload = {{ force = 30 }}\n\
             wear = {{ beta = [1e-8, 4.1e-8], a = [1, 0.02], b = [5, 5], counterface = \"revolving\" }}\n\
             optimum = {{ functional = \"steady\" }}\n"
        ),
    );
    let call = bench.call("run ring.toml -q -o x");
    assert_eq!(call.code, 0, "{}", call.err);
    let table = bench.read("x/contact.csv");
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let column = |name: &str| names.iter().position(|n| *n == name).unwrap();
    let [x, y, p] = ["x_mm", "y_mm", "pressure_MPa"].map(column);
    let rates = lines.map(|line| {
        let row: Vec<f64> = line.split(',').map(|field| field.parse().unwrap_or(f64::NAN)).collect();
        let (v, sheared) = (10.0 * row[x].hypot(row[y]), 0.3 * row[p]);
        1e-8 * sheared.powi(5) * v + 4.1e-8 * sheared.powi(5) * v.powf(0.02) * 0.8 / std::f64::consts::PI
    });
    let rates: Vec<f64> = rates.collect();
    assert!(rates.len() > 10 && rates[0] > 0.0);
    for rate in &rates {
        assert_relative_eq!(*rate, rates[0], max_relative = 1e-10);
    }
}
