//! `wearshape reproduce`: the paper's figures and tables.

use crate::call::Bench;

/// Rows of an item as (quantity, ours, what the paper or the reference says).
fn rows(bench: &Bench, item: &str) -> Vec<(String, f64, f64)> {
    let call = bench.call_with(&["reproduce", item, "--json"]);
    assert_eq!(call.code, 0, "{}", call.err);
    let document: serde_json::Value = serde_json::from_str(&call.out).unwrap();
    let number = |row: &serde_json::Value, key: &str| row[key].as_f64();
    let of = |row: &serde_json::Value| {
        let other = number(row, "paper").or(number(row, "reference")).unwrap_or(f64::NAN);
        (row["quantity"].as_str().unwrap().to_string(), number(row, "ours").unwrap(), other)
    };
    document["rows"].as_array().unwrap().iter().map(of).collect()
}

/// Paczelt and Mroz 2007, section 7.4; the first three numbers are cut off there, not rounded.
#[test]
fn the_table_of_wear_ratios_is_the_printed_one_to_its_last_digit() {
    let printed = [0.3790, 0.6209, 0.8157, 0.8957, 0.9173, 0.9328, 0.9442, 0.9529];
    let exact = [0.379085, 0.620990, 0.815790, 0.895668, 0.917323, 0.932786, 0.944219, 0.952920];
    let bench = Bench::new();
    let rows = rows(&bench, "table-wr");
    assert_eq!(rows.len(), 8);
    for ((quantity, ours, paper), (printed, exact)) in rows.iter().zip(printed.iter().zip(exact)) {
        assert_eq!(paper, printed, "{quantity}");
        assert!((ours - printed).abs() < 1e-4, "{quantity}: {ours}");
        assert!((ours - exact).abs() < 1e-6, "{quantity}: {ours}");
    }
    for file in ["rows.csv", "curves.csv", "curves.svg", "commands.txt", "summary.json"] {
        assert!(bench.path(&format!("out/reproduce/table-wr/{file}")).is_file(), "{file}");
    }
}

/// lambda_M (L/2) / lambda_F = 0.88612582 at M0 / F0 = 5 mm, from int sqrt(1 + kappa x); p(-L/2) and p(L/2) as the multipliers.
#[test]
fn multipliers_of_the_punch_follow_the_closed_form_and_mirror_with_the_moment() {
    let bench = Bench::new();
    let rows = rows(&bench, "fig13");
    let ours = |name: &str| rows.iter().find(|row| row.0 == name).unwrap().1;
    let (force, moment) = (ours("M0 = 5 kN mm: lambda_F"), ours("M0 = 5 kN mm: lambda_M L/2"));
    assert!((moment / force - 0.886_125_82).abs() < 1e-7, "{}", moment / force);
    assert!((ours("M0 = -5 kN mm: lambda_F") / force - 1.0).abs() < 1e-9);
    assert!((ours("M0 = -5 kN mm: lambda_M L/2") / moment + 1.0).abs() < 1e-9);
    // 3 beta mu^2 v p^2 of the uniform pressure.
    let uniform = 3.0 * 2e-4 * 0.0625 * 5.0 * (1000.0_f64 / 600.0).powi(2);
    assert!((ours("M0 = 0 kN mm: lambda_F") / uniform - 1.0).abs() < 1e-12);
    for (quantity, ours, reference) in &rows {
        assert!((ours - reference).abs() <= 1e-9 * reference.abs(), "{quantity}: {ours} instead of {reference}");
    }
    let table = bench.read("out/reproduce/fig13/curves.csv");
    assert_eq!(table.lines().count(), 42);
    assert!(table.starts_with("moment M0 (kN mm),"), "{}", table.lines().next().unwrap());
}

/// Closed forms of textbooks and of Persson, row by row; of the latter with a housing that ends and a clearance that is no point.
#[test]
fn textbook_brakes_and_the_conformal_contact_are_those_of_their_closed_forms() {
    let bench = Bench::new();
    for (item, count, limit) in [("brakes", 12, 2e-5), ("conformal", 14, 5e-4)] {
        let rows = rows(&bench, item);
        assert_eq!(rows.len(), count);
        for (quantity, ours, reference) in rows {
            assert!((ours / reference - 1.0).abs() < limit, "{quantity}: {ours} instead of {reference}");
        }
    }
}

#[test]
fn an_item_may_be_computed_twice_into_its_folder_and_its_commands_repeat_it() {
    let bench = Bench::new();
    for _ in 0..2 {
        assert_eq!(bench.call("reproduce fig7 -o out/seven -q").code, 0);
    }
    let commands = bench.read("out/seven/commands.txt");
    let first: Vec<String> = commands.lines().next().unwrap().split_whitespace().skip(1).map(str::to_string).collect();
    assert_eq!(bench.call_with(&[&first[..], &["-o".into(), "out/first".into()]].concat()).code, 0, "{first:?}");
    let alone = bench.summary("first")["pressure"]["q"].clone();
    assert_eq!(alone, 0.5);
}

#[test]
fn what_cannot_be_reproduced_is_refused_with_the_nearest_item() {
    let bench = Bench::new();
    let call = bench.call("reproduce figg8");
    assert_eq!(call.code, 2);
    assert!(call.err.contains("did you mean `fig8`"), "{}", call.err);
    let list = bench.call("reproduce");
    assert_eq!(list.code, 0);
    for item in ["fig4", "fig13", "table-wr", "brakes", "errata", "all"] {
        assert!(list.out.lines().any(|line| line.starts_with(item)), "{item}");
    }
    assert!(!bench.path("out").exists());
}

/// The drum's uniform pressure is no steady state: a run in time that starts from its shape leaves it for cos^2.
#[test]
fn wear_in_time_leaves_the_uniform_pressure_of_the_drum_and_the_printed_balance_misses_force() {
    let bench = Bench::new();
    let rows = rows(&bench, "errata");
    let ours = |part: &str| rows.iter().find(|row| row.0.contains(part)).unwrap().1;
    assert!((ours("before any wear") - 1.0).abs() < 1e-6);
    assert!((ours("start from the shape of uniform pressure") - 4.0 / 3.0).abs() < 1e-5);
    assert!((ours("flat start") - 4.0 / 3.0).abs() < 1e-5);
    assert!(ours("drum, steady: part") < 1e-12 && ours("drum, uniform: part") > 0.04);
    assert!((ours("q = 1, printed balance") - 9582.43).abs() < 0.01);
    assert!((ours("q = inf, printed balance") - 30_000.0 / std::f64::consts::PI).abs() < 1e-6);
    // min W of the paper wears most of the three.
    assert!(
        ours("stationary wear volume") > ours("uniform pressure: wear")
            && ours("uniform pressure: wear") > ours("steady state: wear")
    );
}

/// sigma_z = -p and |tau_phi z| = mu p on the contact, sigma_z = -100 MPa on top: 1e-5 of the largest pressure there.
#[test]
fn stresses_in_the_ring_are_the_tractions_that_act_on_it() {
    let bench = Bench::new();
    let rows = rows(&bench, "fig26");
    assert_eq!(rows.len(), 3);
    for (quantity, ours, _) in &rows {
        assert!(*ours < 3e-3, "{quantity}: {ours} MPa");
    }
    let picture = bench.read("out/reproduce/fig26/von-mises.svg");
    assert!(picture.contains("von Mises") && picture.contains("r (mm)"));
}
