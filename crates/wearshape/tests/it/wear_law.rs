//! Wear rules by a function of the pressure with a few numbers, from the scene: their steady states in closed form, and what they do not go with.

use crate::common::{digits, read, scene, solved};

const SEVERE: &str = "wear={law={severe={mild='1e-7 mm^3/(N m)',above='5 MPa',severe='6e-7 mm^3/(N m)'}}}";
const SATURATING: &str = "wear={law={saturating={k='1e-7 mm^3/(N m)',half=8}}}";

/// The guided shoe recedes rigidly: the rate along the normal is V cos(alpha) everywhere, and the pressure is what wears at that rate.
#[test]
fn the_steady_pressure_on_a_drum_is_what_wears_at_the_rate_of_the_shoe() {
    // Pressures by rates over the sliding speed, written anew from the formulas.
    let severe = |w: f64| if w < 5e-10 { w / 1e-10 } else { 5.0 + (w - 5e-10) / 6e-10 };
    let saturating = |w: f64| w / (1e-10 - w / 8.0);
    for (rule, inverse) in [(SEVERE, &severe as &dyn Fn(f64) -> f64), (SATURATING, &saturating)] {
        let solution = solved(&scene("drum-brake-block", &["tasks=[pressure]", rule]));
        assert!(solution.reason.is_none(), "{:?}", solution.reason);
        let curve = solution.curve.unwrap();
        let middle = curve.wear_rate[curve.s.iter().position(|s| s.abs() < 1e-9).unwrap()];
        for (k, s) in curve.s.iter().enumerate() {
            let rate = middle * (s / 200.0).cos();
            assert!((curve.wear_rate[k] / rate - 1.0).abs() < 1e-9, "{rule} {s}");
            // Rates are in um/s, and the drum of 200 mm turns at 2.5 rad/s.
            let wanted = inverse(1e-3 * rate / 500.0);
            assert!((curve.pressure[k] / wanted - 1.0).abs() < 1e-9, "{rule} {s}: {} {wanted}", curve.pressure[k]);
        }
        let largest = curve.pressure.iter().copied().fold(0.0, f64::max);
        assert!(curve.pressure.iter().any(|p| *p < 5.0) && largest > 5.0, "{rule}: both parts of the law are there, {largest}");
    }
}

#[test]
fn a_law_that_is_archards_wears_like_archard() {
    let settings = ["tasks=[pressure,shape]", "accuracy=1e-5", "wear={law={severe={mild=2e-10,above=1,severe=2e-10}}}"];
    let law = solved(&scene("drum-brake-block", &settings)).curve.unwrap();
    let archard =
        solved(&scene("drum-brake-block", &["tasks=[pressure,shape]", "accuracy=1e-5", "wear={k=[2e-10,0]}"])).curve.unwrap();
    for k in 0..law.s.len() {
        assert!((law.pressure[k] / archard.pressure[k] - 1.0).abs() < 1e-10 && (law.gap[k] - archard.gap[k]).abs() < 1e-8);
    }
}

#[test]
fn the_run_in_time_ends_at_the_uniform_pressure_of_a_punch() {
    for rule in ["severe={mild=1e-6,above=1,severe=4e-6}", "saturating={k=1e-6,half=2}"] {
        let wear = format!("wear={{law={{{rule}}},until=steady}}");
        let settings = ["contact={edges=[bottom,top],friction=0,gap=0}", "accuracy=1e-3", &wear];
        let solution = solved(&scene("punch-wear", &settings));
        assert!(solution.reason.is_none(), "{:?}", solution.reason);
        let mean = 1000.0 / 600.0;
        for p in &solution.profile.unwrap().pressure {
            assert!((p / mean - 1.0).abs() < 3e-3, "{rule}: {p}");
        }
    }
}

/// Where the pressure crosses a row of a table it is not smooth, and levels come nearer in no order.
#[test]
fn the_shape_worn_in_by_a_table_is_no_further_off_than_is_told() {
    let table = "wear={table=[[3,1e-6],[5,2e-6],[7,2.5e-6]],until=steady}";
    let run = |degree: &str| solved(&scene("drum-brake-block", &["tasks=[wear]", table, degree]));
    let [rough, fine] = ["mesh.degree=10", "mesh.degree=16"].map(run);
    let told = rough.error.as_ref().unwrap().gap_relative.unwrap();
    // As curves at the same places, without the height of the whole.
    let [rough, fine] = [rough, fine].map(|solution| solution.curve.unwrap().gap);
    let largest = fine.iter().fold(0.0_f64, |most, gap| most.max(*gap));
    let apart: Vec<f64> = rough.iter().zip(&fine).map(|(a, b)| a - b).collect();
    let [low, high] = [f64::min, f64::max].map(|of| apart.iter().copied().reduce(of).unwrap());
    let off = 0.5 * (high - low) / largest;
    println!("told {told:.1e}, off {off:.1e}");
    assert!(off > 1e-6 && off < 2.0 * told, "{off} {told}");
}

#[test]
fn what_does_not_go_with_a_law_is_refused_by_its_key() {
    let law = "saturating = { k = 1e-10, half = 8 }";
    for (rule, settings, key) in [
        ("law = { saturating = { k = 1e-10, half = 0 } }".to_string(), &[][..], "wear.law"),
        ("law = { severe = { mild = -1e-10, above = 1, severe = 1 } }".into(), &[], "wear.law"),
        (format!("law = {{ {law} }}, k = 1e-10"), &[], "wear.k"),
        (format!("law = {{ {law} }}, table = [[1, 1e-10]]"), &[], "wear.table"),
        (format!("law = {{ {law} }}, b = 2"), &[], "wear.b"),
        (format!("law = {{ {law} }}"), &["optimum.functional=wear-power"], "optimum.functional"),
        (format!("law = {{ {law} }}"), &["sliding.reversing={share=0.5}"], "sliding.reversing"),
    ] {
        let text = scene::builtin("drum-brake-block").unwrap().text;
        let line = text.lines().find(|line| line.starts_with("wear = ")).unwrap();
        let settings: Vec<String> = settings.iter().map(ToString::to_string).collect();
        let document = wearshape::Document::read("law", &text.replace(line, &format!("wear = {{ {rule} }}")), &settings);
        let fault = document.and_then(|document| wearshape::Problem::new(&document, &|_| Err("no file".into()))).unwrap_err();
        assert_eq!(fault.key.as_deref(), Some(key), "{rule}: {}", fault.message);
    }
}

#[test]
fn the_resolved_scene_is_the_same_problem() {
    let problem = scene("drum-brake-block", &[SEVERE, "tasks=[pressure]"]);
    let again = read(&problem.resolved(), &[]);
    assert_eq!(problem.resolved(), again.resolved());
    assert_eq!(digits(&solved(&problem)), digits(&solved(&again)));
    // Setting another law takes the first one's place.
    let other = scene("drum-brake-block", &[SEVERE, "wear.law.saturating={k=1e-10,half=8}"]);
    assert!(other.resolved().contains("saturating") && !other.resolved().contains("severe"), "{}", other.resolved());
}
