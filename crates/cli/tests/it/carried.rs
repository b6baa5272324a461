//! A load is carried or refused by its key: none is left out.

use crate::call::Bench;

#[test]
fn a_load_that_the_scene_cannot_carry_is_refused_by_its_key() {
    let bench = Bench::new();
    for (scene, key) in [
        ("drum-brake-block --set load.moment=1000", "load.moment"),
        ("drum-brake-block --set load.tilt=1e-4", "load.tilt"),
        ("drum-brake-block --set load.approach_time=10", "load.approach_time"),
        ("drum-brake-block --set load.shear_force=10", "load.shear_force"),
        ("drum-brake-block --set load.width=10", "load.width"),
        ("drum-brake-block --set load.centre=3", "load.centre"),
        ("drum-brake-block --set load.moment_y=3", "load.moment_y"),
        ("drum-brake-block --set load.torque=3", "load.torque"),
        ("translating-punch --set load.shear_force=10", "load.shear_force"),
        ("translating-punch --set load.width=10", "load.width"),
        ("translating-punch --set load.moment_y=10", "load.moment_y"),
        ("translating-punch --set tasks=[contact] --set load.approach_time=10", "load.approach_time"),
        ("translating-punch --set load.as=pressure --set load.moment=10", "load.moment"),
        ("translating-punch --set load.as=pressure --set load.tilt=0", "load.tilt"),
        ("annular-punch --set load.as=rigid --set load.moment=10", "load.moment"),
        ("annular-punch --set load.as=rigid --set load.tilt=1e-4", "load.tilt"),
        ("annular-punch --set load.twist=1e-3", "load.twist"),
        ("disc-pad --set load.moment=10", "load.moment"),
        ("journal-arc --set load.tilt=1e-3", "load.tilt"),
        ("pivoted-shoe --set load.moment_y=1", "load.moment_y"),
    ] {
        let call = bench.check_and_run(scene);
        assert_eq!(call.code, 2, "{scene}: {}", call.out);
        assert!(call.err.contains(&format!("{key} = ")) && call.err.contains("would be left out"), "{scene}: {}", call.err);
        assert!(call.err.contains("--> --set load.") && call.err.contains("remedy: "), "{scene}: {}", call.err);
    }
}

#[test]
fn a_load_of_zero_is_inert() {
    let bench = Bench::new();
    for settings in [
        "drum-brake-block --set load.moment=0 --set load.tilt=0 --set load.shear_force=0",
        "annular-punch --set load.twist=0 --set load.moment=0",
        "translating-punch --set load.as=pressure --set load.moment=0 --set contact.friction=0 --set wear.k=1e-7",
        "rectangular-punch --set load.moment=10 --set load.moment_y=10",
    ] {
        let call = bench.check_and_run(&format!("{settings} -q"));
        assert_eq!(call.code, 0, "{settings}: {}", call.err);
    }
}

#[test]
fn a_load_on_an_edge_that_presses_nothing_is_refused() {
    let bench = Bench::new();
    for (scene, words) in [
        ("translating-punch --set load.edge=left --set load.as=pressure", "upright"),
        ("translating-punch --set load.edge=left --set load.as=vertical", "upright"),
        ("translating-punch --set load.edge=bottom", "touches body 2"),
        ("drum-brake-block --set load.edge=inner", "touches body 2"),
    ] {
        let call = bench.check_and_run(scene);
        assert_eq!(call.code, 2, "{scene}: {}", call.out);
        assert!(call.err.contains(words), "{scene}: {}", call.err);
    }
}

/// contact.csv has the wear rate of a contact that slides.
#[test]
fn a_wear_factor_is_unused_only_where_nothing_is_computed_from_it() {
    let bench = Bench::new();
    let call = bench.call("run translating-punch --set tasks=[contact] --set mesh.degree=4 -q");
    assert_eq!(call.code, 0, "{}", call.err);
    let unused = bench.summary("translating-punch")["unused_keys"].to_string();
    assert!(!unused.contains("wear.beta") && !unused.contains("wear.b\"") && !unused.contains("sliding"), "{unused}");
    let table = bench.read("out/translating-punch/contact.csv");
    let mut rows = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let column = rows.next().unwrap().iter().position(|name| *name == "wear_rate_um_per_s").unwrap();
    assert!(rows.all(|row| row[column].parse::<f64>().unwrap() > 0.0));
    let call = bench.call("run cattaneo-mindlin --set wear.beta=1e-4 --set mesh.degree=4 -q");
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(bench.summary("cattaneo-mindlin")["unused_keys"].to_string().contains("wear.beta"));
}
