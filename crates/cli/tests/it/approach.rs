//! Shapes for a prescribed approach: the force follows from the bodies, and a contact solve under the approach gives the pressure back.

use crate::call::Bench;

fn summary(bench: &Bench, folder: &str) -> serde_json::Value {
    serde_json::from_str(&bench.read(&format!("{folder}/summary.json"))).unwrap()
}

#[test]
fn a_contact_solve_under_the_approach_gives_the_pressure_back() {
    let bench = Bench::new();
    let cases = [
        ("held", "--set load.tilt=0 --set accuracy=1e-6", 3, 1e-4),
        ("tilted", "--set load.tilt=2e-6 --set mesh.degree=8", 8, 1e-2),
        ("moment", "--set load.moment=2000 --set mesh.degree=8", 12, 1e-2),
        ("fed", "--set load.tilt=0 --set load.approach_time=10 --set mesh.degree=8", 3, 1e-2),
    ];
    for (name, sets, passes, independent) in cases {
        let args = format!("run translating-punch --set load.approach=1.3e-3 {sets} -q -o {name}");
        let call = bench.call_with(&args.split_whitespace().collect::<Vec<_>>());
        assert_eq!(call.code, 0, "{name}: {}", call.err);
        let summary = summary(&bench, name);
        let shape = &summary["shape"];
        assert!(shape["iterations"].as_u64().unwrap() <= passes, "{name}: {}", shape["iterations"]);
        assert!(shape["roundtrip_same"].as_f64().unwrap() < 1e-8, "{name}: {shape}");
        assert!(shape["roundtrip_independent"].as_f64().unwrap() < independent, "{name}: {shape}");
    }
    // The force, given as a force, needs this approach: its smallest gap has the rigid part of the approach.
    let force = summary(&bench, "held")["pressure"]["force_N"].as_f64().unwrap();
    let args = format!("run translating-punch --set load.force={force} --set load.tilt=0 --set accuracy=1e-6 -q -o given");
    assert_eq!(bench.call(&args).code, 0);
    let rigid = summary(&bench, "given")["shape"]["rigid_mm"].as_f64().unwrap();
    approx::assert_relative_eq!(rigid, -1.3e-3, max_relative = 1e-6);
}

#[test]
fn an_approach_that_no_force_matches_and_a_pressure_without_bodies_are_refused_by_name() {
    let bench = Bench::new();
    // The tilt alone presses one edge deeper than the approach allows on average: no smallest gap needs so little.
    let call = bench.call("run translating-punch --set load.approach=1e-3 --set load.tilt=1e-3 --set mesh.degree=4 -o x");
    assert_eq!(call.code, 1, "{}{}", call.out, call.err);
    assert!(call.out.contains("no force goes with the prescribed approach"), "{}", call.out);
    let call = bench.call("run translating-punch --set load.approach=1e-3 --set tasks=[pressure]");
    assert_eq!(call.code, 2);
    assert!(call.err.contains("elastic bodies") && call.err.contains("remedy: "), "{}", call.err);
}

#[test]
fn a_prescribed_tilt_turns_the_punch() {
    let bench = Bench::new();
    let args = "run translating-punch --set tasks=[contact] --set contact.friction=0 --set mesh.degree=4 -q";
    for (folder, tilt) in [("level", "0"), ("turned", "1e-5")] {
        assert_eq!(bench.call(&format!("{args} --set load.tilt={tilt} -o {folder}")).code, 0);
    }
    let moment = |folder: &str| summary(&bench, folder)["contact"]["moment_Nmm"].as_f64().unwrap();
    assert!(moment("level").abs() < 1e-6);
    // The side that comes closer carries more.
    assert!(moment("turned") > 1000.0);
}

/// The tilt of a punch whose rotation is free is no error; held, it is the first thing to look at.
#[test]
fn errors_of_the_shape_that_free_motions_take_up_are_left_out_of_the_tolerance() {
    let bench = Bench::new();
    let args = "run translating-punch --set mesh.degree=8 --set check=false -q";
    for (folder, sets, wanted) in [("free", "", vec![]), ("held", "--set load.tilt=0", vec!["tilt"])] {
        assert_eq!(bench.call(&format!("{args} {sets} -o {folder}")).code, 0);
        let summary = summary(&bench, folder);
        let entries = summary["shape"]["tolerance"].as_array().unwrap().clone();
        let name = |e: &serde_json::Value| e["error"].as_str().unwrap().to_string();
        let found: Vec<String> = entries.iter().map(name).filter(|n| n == "offset" || n == "tilt").collect();
        assert_eq!(found, wanted, "{folder}");
        let change = |k: usize| entries[k]["pressure_change_relative"].as_f64().unwrap();
        let distance = |k: usize| entries[k]["run_in_distance_mm"].as_f64().unwrap();
        // Cosines L, L/2, L/4, L/8 stand before the random error: the shorter, the more pressure, and the sooner worn away.
        let last = entries.len() - 1;
        for k in last - 4..last - 1 {
            assert!(change(k) < change(k + 1) && distance(k) > distance(k + 1), "{folder}: {entries:?}");
        }
        assert!(bench.read(&format!("{folder}/report.html")).contains("keeps the pressure within 10 %"));
    }
}

/// The accuracy is that of the shape, not of the worn approach that is added to it: however long it wore, the same degrees prove it.
#[test]
fn a_long_approach_time_weakens_no_proof() {
    let bench = Bench::new();
    let run = |time: f64| {
        let args = format!("run translating-punch --set load.tilt=0 --set load.approach_time={time} -q -o t{time}");
        let call = bench.call_with(&args.split_whitespace().collect::<Vec<_>>());
        assert_eq!(call.code, 0, "{}", call.err);
        summary(&bench, &format!("t{time}"))
    };
    let (none, long) = (run(0.0), run(200.0));
    assert!(long["shape"]["gap_max_um"].as_f64().unwrap() > 30.0);
    assert_eq!(none["counters"]["dofs"], long["counters"]["dofs"]);
    for (key, part) in [("error", "gap_relative"), ("shape", "roundtrip_independent"), ("shape", "crown_um")] {
        let of = |summary: &serde_json::Value| summary[key][part].as_f64().unwrap();
        approx::assert_relative_eq!(of(&none), of(&long), max_relative = 1e-4);
    }
    assert!(long["shape"]["roundtrip_independent"].as_f64().unwrap() < 2e-4);
}
