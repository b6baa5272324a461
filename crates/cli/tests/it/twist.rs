//! Displacement around the axis in the tasks contact and wear: against a closed form, and against the shape under the same pressure.

use approx::assert_relative_eq;

use crate::call::Bench;

/// Two rings of the same radii, each held at its far end. By Betti's theorem with the state `u = r z / h`, whose only stress is
/// `tau_phiz = G r / h`, friction of any distribution turns each of them so that
///
/// ```text
///    ///////      z = 30      int r u_phi dA = (h / G) int r mu p dA
///    |  1  |
///    |_____|      z = 10      on the contact, with the opposite sign for body 2
///    |  2  |
///    ///////      z = 0
///    20    50     r
/// ```
const RINGS: &str = r#"
units = "N-mm"
kinematics = "axisymmetric"
tasks = ["contact"]
mesh = { degree = 6, layers = 2 }
body1.material = { young = "2 GPa", poisson = 0.25 }
body1.geometry.rectangle = { x = [20, 50], z = [10, 30] }
body1.support = { top = ["phi"] }
body2.material = { young = "4.5 GPa", poisson = 0.5e-1 }
body2.geometry.rectangle = { x = [20, 50], z = [0, 10] }
body2.support = { bottom = ["x", "z", "phi"] }
contact = { edges = ["bottom", "top"], friction = 0.3, gap = 0 }
sliding = { omega = 2 }
load = { edge = "top", as = "pressure", force = "20 kN" }
wear = { k = [3e-8, 1e-8], a = 1, b = 1.5, counterface = "congruent", until = "100 s" }
"#;
/// Height over shear modulus of each body, mm/MPa.
const COMPLIANCES: [f64; 2] = [20.0 / 800.0, 10.0 / (4500.0 / 2.1)];

/// Columns of contact.csv: r, weight, shear, uphi1, uphi2.
fn columns(bench: &Bench, folder: &str) -> [Vec<f64>; 5] {
    let text = bench.read(&format!("{folder}/contact.csv"));
    let head: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    ["x_mm", "weight_mm2", "shear_MPa", "uphi1_um", "uphi2_um"].map(|name| {
        let at = head.iter().position(|field| *field == name).unwrap();
        text.lines().skip(1).map(|line| line.split(',').nth(at).unwrap().parse().unwrap()).collect()
    })
}

/// Held against the closed form; `sense` is that of the sliding.
fn assert_twisted(bench: &Bench, sense: f64, what: &str) {
    let [r, weight, shear, one, two] = columns(bench, "x");
    let integral = |values: &[f64]| (0..r.len()).map(|i| weight[i] * r[i] * values[i]).sum::<f64>();
    for (u, wanted) in [(one, COMPLIANCES[0]), (two, -COMPLIANCES[1])] {
        assert_relative_eq!(1e-3 * integral(&u), sense * wanted * integral(&shear), max_relative = 1e-9);
        assert!(u.iter().all(|u| u * sense * wanted > 0.0), "{what}: {u:?}");
    }
}

#[test]
fn contact_and_wear_turn_the_rings_as_betti_says_in_the_sense_of_the_sliding() {
    let bench = Bench::new();
    bench.file("rings.toml", RINGS);
    bench.file("hollow.csv", "s_mm,gap_um\n20,0\n35,0\n50,100\n");
    let reversed = "--set tasks=[wear] --set schedule={time=[0,50],speed=[1,-1]}";
    for (options, sense) in [
        ("", 1.0),
        ("--set load.twist=1e-4", -1.0),
        ("--set load.twist=[1e-3,-1e-4]", 1.0),
        ("--set load.torque=-1e4", 1.0),
        ("--set sliding.omega=-2", -1.0),
        ("--set contact.gap=hollow.csv", 1.0),
        ("--set tasks=[wear]", 1.0),
        (reversed, -1.0),
    ] {
        let call = bench.call(&format!("run rings.toml -q -o x {options}"));
        assert_eq!(call.code, 0, "{options}: {}", call.err);
        assert_twisted(&bench, sense, options);
        let open = bench.read("x/contact.csv").contains(",open");
        assert!(open || options.contains("wear"), "{options}: the bodies lift where contact is partial");
    }
}

#[test]
fn sampled_rows_and_fields_hold_the_same_twist_each_in_the_sense_of_its_own_time() {
    let bench = Bench::new();
    bench.file("rings.toml", RINGS);
    let options = "--set tasks=[wear] --set schedule={time=[0,50],speed=[1,-1]} --set output.fields=true --sample 3";
    let call = bench.call(&format!("run rings.toml -q -o x {options}"));
    assert_eq!(call.code, 0, "{}", call.err);
    let [r, _, _, one, two] = columns(&bench, "x");
    // The turn of a corner of the contact, at the start and at the end of the run.
    let at = |file: &str, r: f64| {
        let text = bench.read(&format!("x/fields/{file}.vtu"));
        let (place, u) = (crate::fields::array(&text, "position_mm"), crate::fields::array(&text, "displacement_mm"));
        let row = place.chunks(3).position(|x| (x[0] - r).hypot(x[2] - 10.0) < 1e-9).unwrap();
        1e3 * u[3 * row + 1]
    };
    for (body, column) in [("body1", one), ("body2", two)] {
        for row in [0, 2] {
            assert_relative_eq!(at(body, r[row]), column[row], max_relative = 1e-9);
            assert!(at(&format!("{body}.start"), r[row]) * column[row] < 0.0, "{body}: the start slides the other way");
        }
    }
}

#[test]
fn a_punch_worn_to_its_steady_state_is_twisted_like_the_shape_of_that_pressure() {
    let bench = Bench::new();
    for task in ["shape", "wear"] {
        let call = bench.call(&format!(
            "run annular-punch -q -o {task} --set tasks=[{task}] --set check=false --set mesh={{degree=5,layers=2}}"
        ));
        assert_eq!(call.code, 0, "{}", call.err);
    }
    let ([_, _, _, one, two], [_, _, _, shape_one, shape_two]) = (columns(&bench, "wear"), columns(&bench, "shape"));
    for (worn, shaped) in one.iter().chain(&two).zip(shape_one.iter().chain(&shape_two)) {
        assert_relative_eq!(*worn, *shaped, max_relative = 1e-6);
    }
}

/// Lubkin 1951 (crates/contact/tests/it/twist.rs has the formulas): steel ball of 5 mm under 0.021 N, mu 0.3, turned by 1e-3 rad.
const LUBKIN: [f64; 3] = [0.001576322713, 3.253449607e-5, 3.267326833e-5];
const BALL: &str =
    "--set load.force=21e-3 --set contact.friction=0.3 --set body1.support.top=[phi] --set body2.support.bottom=[x,z,phi]";

#[test]
fn a_ball_turned_on_a_disc_sticks_and_slips_as_lubkin_says_and_its_loop_closes() {
    let bench = Bench::new();
    let call = bench.call(&format!("run hertz-sphere -q --set mesh.degree=6 --set load.twist=[1e-3,-1e-3,1e-3] {BALL}"));
    assert_eq!(call.code, 0, "{}", call.err);
    let summary = bench.summary("hertz-sphere");
    let twist = &summary["contact"]["twist"];
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    // The ball is no half-space: a/R = 1.8e-3.
    assert_relative_eq!(number(&summary["contact"]["stick_ends_mm"][1]), LUBKIN[0], max_relative = 1e-2);
    assert_relative_eq!(number(&twist["torque_Nmm"][0]), LUBKIN[1], max_relative = 5e-5);
    assert_relative_eq!(number(&twist["slip_torque_Nmm"]), LUBKIN[2], max_relative = 2e-4);
    assert_eq!(twist["status"], "slips-in-part");
    assert_relative_eq!(number(&twist["torque_Nmm"][1]), -number(&twist["torque_Nmm"][0]), max_relative = 1e-9);
    assert_relative_eq!(number(&twist["torque_Nmm"][2]), number(&twist["torque_Nmm"][0]), max_relative = 1e-9);
    // The estimate is what is off; the ball being no half-space makes 7.986e-6 (degrees 10 and 12).
    let off = number(&twist["torque_Nmm"][0]) / LUBKIN[1] - 1.0 - 7.986e-6;
    let estimate = number(&summary["error"]["twist_relative"]);
    assert!((0.5 * off.abs()..2.0 * off.abs()).contains(&estimate), "{off:e}: {estimate:e}");
    let table = bench.read("out/hertz-sphere/contact.csv");
    assert!(table.contains(",stick") && table.contains(",slip") && table.contains(",open"));
}

#[test]
fn a_torque_beyond_friction_turns_the_ball_through_and_is_refused_by_name() {
    let bench = Bench::new();
    let call = bench.call(&format!("run hertz-sphere -q --set mesh.degree=4 --set load.torque=4e-5 {BALL}"));
    assert_eq!(call.code, 1, "{}", call.err);
    let summary = bench.summary("hertz-sphere");
    assert_eq!(summary["status"], "refused");
    assert!(summary["verdict"].as_str().unwrap().contains("turns through"));
    assert_eq!(summary["contact"]["twist"]["status"], "turns-through");
}

#[test]
fn a_turning_that_cannot_be_says_what_is_missing() {
    let bench = Bench::new();
    for (options, code, words) in [
        ("hertz-sphere --set load.twist=1e-3", 2, "nothing resists"),
        ("hertz-sphere --set load.twist=1e-3 --set contact.friction=0.3", 2, "against turning"),
        ("annular-punch --set tasks=[contact,shape] --set load.twist=1e-3", 2, "steady sliding only"),
        ("annular-punch --set tasks=[contact] --set load.twist=[]", 2, "one value, or a list"),
        ("annular-punch --set tasks=[contact] --set load.twist=0.1_deg", 0, "sliding.omega"),
        ("annular-punch --set load.twist=1e-3", 2, "load.twist = 0.001 would be left out"),
        ("translating-punch --set tasks=[contact] --set load.torque=1", 2, "load.torque = 1 would be left out"),
    ] {
        let call = bench.call(&format!("check {options}"));
        let said = format!("{}{}", call.out, call.err);
        assert_eq!(call.code, code, "{options}: {said}");
        assert!(said.contains(words), "{options}: {said}");
    }
}
