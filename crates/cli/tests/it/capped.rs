//! A wanted pressure that `optimum.p_max` holds down has kinks, on which nodes stand.

use crate::call::Bench;

#[test]
fn a_capped_pressure_has_a_shape_that_gives_it_back() {
    let bench = Bench::new();
    for (scene, cap) in [("drum-brake-block", 5.3), ("clutch-hot", 0.2)] {
        let cap_is = format!("optimum.p_max={cap}");
        let call = bench.call_with(&["run", scene, "-q", "--set", &cap_is, "--set", "accuracy=1e-4"]);
        assert_eq!(call.code, 0, "{scene}: {}", call.err);
        let summary = bench.summary(scene);
        let number = |pointer: &str| summary.pointer(pointer).unwrap().as_f64().unwrap();
        approx::assert_relative_eq!(number("/pressure/p_max_MPa"), cap, max_relative = 1e-12);
        assert!(number("/shape/roundtrip_same") < 1e-8, "{scene}: {}", number("/shape/roundtrip_same"));
        assert!(number("/shape/roundtrip_independent") < 1e-3, "{scene}: {}", number("/shape/roundtrip_independent"));
        assert!(number("/error/gap_relative") < 1e-4, "{scene}");
        // Less pressure where it is largest, and the wear is no longer a rigid motion.
        assert!(number("/pressure/steadiness_residual") > 1e-3, "{scene}");
        assert!(summary.pointer("/pressure/feed").is_none(), "{scene}: {summary}");
        let verdict = summary["verdict"].as_str().unwrap();
        assert!(verdict.contains("it has the wanted pressure"), "{scene}: {verdict}");
    }
}

#[test]
fn a_cap_that_is_not_reached_changes_nothing() {
    let bench = Bench::new();
    for (folder, setting) in [("free", "title=free"), ("capped", "optimum.p_max=6")] {
        let fixed = ["-q", "--set", "mesh.degree=4", "--set", "check=false", "--set", setting, "-o", folder];
        let call = bench.call_with(&[&["run", "drum-brake-block"][..], &fixed].concat());
        assert_eq!(call.code, 0, "{folder}: {}", call.err);
    }
    assert_eq!(bench.read("free/contact.csv"), bench.read("capped/contact.csv"));
}

/// A moment lets a uniform pressure carry on a third of a punch, where it wears like a rigid motion: the rest, which does not wear, closes with it.
#[test]
fn a_pressure_is_not_steady_where_the_rest_of_the_surface_closes() {
    let bench = Bench::new();
    for (functional, rest) in [("uniform", 2.0_f64.sqrt()), ("steady", 0.0)] {
        let call = bench.call(&format!(
            "run translating-punch -q --force --set tasks=[pressure] --set load.moment=20000 --set optimum.functional={functional}"
        ));
        assert_eq!(call.code, 0, "{functional}: {}", call.err);
        let residual = bench.summary("translating-punch")["pressure"]["steadiness_residual"].as_f64().unwrap();
        assert!((residual - rest).abs() < 0.01, "{functional}: {residual}");
    }
}

/// On a drum with friction the kinematic modes have another balance than their own: their pressure is stationary and an extremum of nothing.
#[test]
fn nothing_is_called_a_minimum_or_maximum_that_is_none() {
    let bench = Bench::new();
    for (optimum, character, note) in [
        ("{functional=\"friction-power\",q=1}", "stationary", "no regular optimum"),
        ("{functional=\"friction-power\",q=1,modes=\"associated\"}", "minimum", "no regular optimum"),
        ("{functional=\"wear-volume\",q=1}", "stationary", "no minimum of the functional"),
        ("{functional=\"wear-volume\",q=1,modes=\"associated\"}", "maximum", "the worst one"),
    ] {
        let optimum = format!("optimum={optimum}");
        let call = bench.call(&format!("run drum-brake-block -q --force --set tasks=[pressure] --set {optimum}"));
        assert_eq!(call.code, 0, "{optimum}: {}", call.err);
        let summary = bench.summary("drum-brake-block");
        assert_eq!(summary["pressure"]["character"], character, "{optimum}");
        assert!(summary["lints"].to_string().contains(note), "{optimum}: {}", summary["lints"]);
    }
}

/// Where the pressure begins to be held down between the middle and the end of the surface, cells are as high there as they are near to its end.
#[test]
fn a_cap_near_the_end_of_the_surface_leaves_a_small_error() {
    let bench = Bench::new();
    for cap in [5.02, 5.1, 5.2] {
        let cap_is = format!("optimum.p_max={cap}");
        let mesh = ["--set", "mesh.degree=8", "--set", "mesh.layers=8"];
        let call = bench.call_with(&[&["run", "drum-brake-block", "-q", "--set", &cap_is][..], &mesh].concat());
        assert_eq!(call.code, 0, "{}", call.err);
        let told = bench.summary("drum-brake-block")["error"]["gap_relative"].as_f64().unwrap();
        assert!(told < 1e-5, "{cap}: {told}");
    }
}

/// The pressure has a kink where it passes one at which the rule bends; the shape has nodes there, and its proof gives the pressure back.
#[test]
fn a_shape_by_a_rule_that_bends_is_proved() {
    let bench = Bench::new();
    for rule in [
        "wear.law={severe={mild=1e-10,above=5,severe=6e-10}}",
        "wear.table=[[1,1e-10],[4,2e-10],[4.5,2.5e-10],[5,3e-10],[8,8e-10]]",
    ] {
        let call = bench.call_with(&["run", "drum-brake-block", "-q", "--set", "wear={a=1}", "--set", rule]);
        assert_eq!(call.code, 0, "{rule}: {}{}", call.out, call.err);
        let same = bench.summary("drum-brake-block")["shape"]["roundtrip_same"].as_f64().unwrap();
        assert!(same < 1e-8, "{rule}: {same}");
    }
}
