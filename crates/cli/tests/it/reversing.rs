//! Motion that reverses: one shape, two pressures.

use serde_json::Value;

use crate::call::Bench;

const SCENE: &str = "reciprocating-pad";

/// A column of contact.csv of the run.
fn column(bench: &Bench, run: &str, name: &str) -> Vec<f64> {
    let table = bench.read(&format!("out/{run}/contact.csv"));
    let at =
        table.lines().next().unwrap().split(',').position(|known| known == name).unwrap_or_else(|| panic!("no column {name}"));
    table.lines().skip(1).map(|row| row.split(',').nth(at).unwrap().parse().unwrap()).collect()
}

/// Runs the pad with settings, and returns its summary.
fn run(bench: &Bench, out: &str, settings: &str) -> Value {
    let call = bench.call(&format!("run {SCENE} -q -o out/{out} {settings}"));
    assert_eq!(call.code, 0, "{settings}: {}", call.err);
    bench.summary(out)
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Largest difference of two lists over the range of the second.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let range = b.iter().copied().fold(f64::MIN, f64::max) - b.iter().copied().fold(f64::MAX, f64::min);
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / range
}

#[test]
fn a_pad_that_goes_to_and_fro_has_one_symmetric_shape_and_two_mirrored_pressures() {
    let bench = Bench::new();
    let summary = run(&bench, "both", "--sample 41");
    assert_eq!(summary["status"], "ok");
    let error = number(&summary["error"]["gap_relative"]);
    assert!(error < 1e-4, "{error:e}");
    let [there, back, gap] = ["pressure_MPa", "pressure_back_MPa", "gap_um"].map(|name| column(&bench, "both", name));
    let mirrored = |values: &[f64]| values.iter().rev().copied().collect::<Vec<f64>>();
    assert!(apart(&mirrored(&gap), &gap) < 10.0 * error, "{:e}", apart(&mirrored(&gap), &gap));
    let inner = |values: &[f64]| values[2..39].to_vec();
    assert!(apart(&inner(&mirrored(&back)), &inner(&there)) < 1e-2);
    // b = 1: the mean pressure is F/A everywhere.
    for (there, back) in inner(&there).iter().zip(inner(&back)) {
        approx::assert_relative_eq!(0.5 * (there + back), 2000.0 / 800.0, max_relative = 2e-2);
    }
    let [forward, backward] = ["forward", "back"].map(|sense| number(&summary["reversing"][sense]["p_max_MPa"]));
    approx::assert_relative_eq!(forward, backward, max_relative = 1e-3);
    assert!(forward > 1.2 * number(&summary["pressure"]["p_mean_MPa"]));
    approx::assert_relative_eq!(number(&summary["pressure"]["p_max_MPa"]), 2.5, max_relative = 1e-6);
    assert!(number(&summary["shape"]["roundtrip_same"]) < 1e-8, "{}", summary["shape"]);
    assert!(number(&summary["shape"]["roundtrip_independent"]) < 3e-2, "{}", summary["shape"]);
}

#[test]
fn forward_alone_is_the_motion_of_one_sense_and_backward_alone_its_reverse() {
    let bench = Bench::new();
    let sampled = "--sample 41 --set accuracy=1e-6";
    run(&bench, "forward", &format!("{sampled} --set sliding.reversing.share=1"));
    let alone = "run reciprocating-pad -q -o out/alone --sample 41 --set accuracy=1e-6 --set sliding={speed=50}";
    assert_eq!(bench.call(alone).code, 0);
    let [forward, single] = ["forward", "alone"].map(|name| column(&bench, name, "gap_um"));
    assert!(apart(&forward, &single) < 1e-5, "{:e}", apart(&forward, &single));
    run(&bench, "backward", &format!("{sampled} --set sliding.reversing.share=0"));
    let backward: Vec<f64> = column(&bench, "backward", "gap_um").into_iter().rev().collect();
    assert!(apart(&backward, &single) < 1e-5, "{:e}", apart(&backward, &single));
    // The sense that never comes has another pressure, without limit at the edges, which proves nothing.
    let proof = |name: &str| number(&bench.summary(name)["shape"]["roundtrip_independent"]);
    for name in ["forward", "backward"] {
        assert!(proof(name) < 3.0 * proof("alone"), "{name}: {:e} {:e}", proof(name), proof("alone"));
    }
    // Without friction nothing turns with the sliding.
    run(&bench, "smooth", &format!("{sampled} --set contact.friction=0"));
    let [there, back] = ["pressure_MPa", "pressure_back_MPa"].map(|name| column(&bench, "smooth", name));
    for (there, back) in there.iter().zip(&back) {
        approx::assert_relative_eq!(there, back, max_relative = 1e-9);
    }
}

#[test]
fn scenes_that_keep_their_sense_have_no_second_pressure() {
    let bench = Bench::new();
    let call = bench.call("run reciprocating-pad -q -o out/one --set sliding={speed=50}");
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(!bench.read("out/one/contact.csv").contains("back"));
    assert!(!bench.read("out/one/report.html").contains("of the mean of both directions"));
    assert!(bench.summary("one")["reversing"].is_null());
}

#[test]
fn a_reversing_motion_that_cannot_be_is_refused_with_a_remedy_by_check_and_run_alike() {
    let bench = Bench::new();
    for (settings, words) in [
        ("sliding.reversing.share=1.5", "not between 0 and 1"),
        ("sliding.reversing.share=-0.1", "not between 0 and 1"),
        ("sliding={reversing={share=0.5}}", "`sliding.speed` is missing"),
        ("load={edge=top,as=rigid,approach=1e-3}", "under a prescribed approach"),
        ("load.shear_force=100", "a shear force with stick and slip"),
        ("optimum.functional=uniform", "and no others"),
        ("optimum.functional=wear-power", "and no others"),
        ("optimum.balance=paper", "in equilibrium"),
        ("optimum.modes=associated", "is a rigid motion"),
        ("optimum.p_max=3", "no cap"),
        ("wear.k=[0,1e-7]", "body 1 does not wear"),
    ] {
        for command in ["run", "check"] {
            let call = bench.call_with(&[command, SCENE, "--set", settings]);
            assert_eq!(call.code, 2, "{command} {settings}: {}", call.err);
            assert!(call.err.contains(words) && call.err.contains("remedy:"), "{command} {settings}: {}", call.err);
        }
    }
}

#[test]
fn both_pressures_stand_on_the_first_screen_and_the_page() {
    let bench = Bench::new();
    let call = bench.call(&format!("run {SCENE}"));
    assert_eq!(call.code, 0, "{}", call.err);
    let said = call.out.split_whitespace().collect::<Vec<_>>().join(" ");
    for words in ["forward at most", "backward at most", "return both pressures within"] {
        assert!(said.contains(words), "{words} in {said}");
    }
    let page = bench.read(&format!("out/{SCENE}/report.html"));
    let row = "<tr><td title=\"pressure.p_max_MPa\">largest pressure, of the mean of both directions</td>";
    for words in [row, "mean over the time", "backward: largest pressure", "contact pressure forward and backward"] {
        assert!(page.contains(words), "{words}");
    }
}

#[test]
fn the_curves_of_a_sweep_hold_both_pressures_of_reversing_contacts_alone() {
    let bench = Bench::new();
    let sweep = |scene: &str, over: &str, out: &str| {
        let call = bench.call(&format!("sweep {scene} --over {over} --sample 11 --set accuracy=1e-2 -o {out}"));
        assert_eq!(call.code, 0, "{}", call.err);
        assert_eq!(call.out.contains("p max of mean MPa"), out == "both", "{}", call.out);
        assert_eq!(call.out.contains("p max MPa"), out == "one", "{}", call.out);
        bench.read(&format!("{out}/curves.csv"))
    };
    let table = sweep(SCENE, "contact.friction=0.1,0.2", "both");
    assert!(table.lines().next().unwrap().ends_with(",contact.friction,pressure_back_MPa"), "{table}");
    let cells = |row: &str| row.split(',').map(|cell| cell.parse::<f64>().unwrap()).collect::<Vec<f64>>();
    let rows: Vec<Vec<f64>> = table.lines().skip(1).map(cells).collect();
    assert_eq!(rows.len(), 22);
    // Forward is backward in the mirror.
    for (row, mirrored) in rows[1..10].iter().zip(rows[1..10].iter().rev()) {
        approx::assert_relative_eq!(row[5], mirrored[row.len() - 1], max_relative = 5e-2);
    }
    assert!(bench.read("both/report.html").contains("contact pressure backward"));
    let plain = sweep("reciprocating-pad --set sliding={speed=50}", "contact.friction=0.1,0.2", "one");
    assert!(!plain.contains("back"), "{plain}");
}
