//! Loads that do not use the whole surface, loads that wear themselves away, and a pressure that does not carry the load.

use approx::assert_relative_eq;

use crate::call::Bench;

/// A moment of 12 N m under 1 kN opens one side: p ~ sqrt(x - x_c), and the worn surface has a kink at x_c that grows for ever.
#[test]
fn a_run_that_ends_in_partial_contact_is_as_accurate_as_asked() {
    let bench = Bench::new();
    let call = bench.call("run punch-wear --set load.moment=12000 --set accuracy=1e-4 -q");
    assert_eq!(call.code, 0, "{}", call.err);
    let summary = bench.summary("punch-wear");
    assert!(summary["wear"]["steady"] == true);
    assert!(summary["error"]["gap_relative"].as_f64().unwrap() < 1e-4, "{}", summary["error"]);
    // p = p_max sqrt((x - x_c) / l) with p_max = 3/2 F / (l t) and its centroid at 3/5 l: l = 45 mm.
    let table = bench.read("out/punch-wear/contact.csv");
    let names: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let at = |name: &str| names.iter().position(|other| *other == name).unwrap();
    let (x, pressure) = (at("x_mm"), at("pressure_MPa"));
    for row in table.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>()) {
        let (x, found): (f64, f64) = (row[x].parse().unwrap(), row[pressure].parse().unwrap());
        // The wear rate, p^2, is what has become a rigid motion.
        let wanted = (10.0_f64 / 3.0).powi(2) * ((x + 15.0) / 45.0).max(0.0);
        assert!((found * found - wanted).abs() < 1e-6 * (10.0_f64 / 3.0).powi(2), "x = {x}: {} against {wanted}", found * found);
    }
}

#[test]
fn a_shape_for_partial_contact_has_nodes_where_its_pressure_begins() {
    let bench = Bench::new();
    let call = bench.call("run translating-punch --set tasks=[shape] --set load.moment=20000 --set accuracy=1e-5 -q");
    assert_eq!(call.code, 0, "{}", call.err);
    let shape = &bench.summary("translating-punch")["shape"];
    assert!(shape["roundtrip_same"].as_f64().unwrap() < 1e-7, "{shape}");
}

/// Under a prescribed approach of 1 um nothing feeds the wear: it ends when 1 um is worn off and the pressure is gone.
#[test]
fn a_prescribed_approach_wears_itself_free() {
    let bench = Bench::new();
    let call = bench.call("run punch-wear --set load.approach=1e-3 --set mesh={degree=4,layers=2}");
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(call.out.contains("worn itself free"), "{}", call.out);
    let wear = &bench.summary("punch-wear")["wear"];
    assert!(wear["steady"] == true, "{wear}");
    assert_relative_eq!(wear["volume_mm3"].as_f64().unwrap(), 60.0 * 10.0 * 1e-3, max_relative = 1e-7);
}

/// The paper's normalisation leaves 490 N of the drum's 10 kN uncarried: the shape is that under the force that is carried.
#[test]
fn a_shape_for_the_papers_balance_is_found_under_the_force_it_carries() {
    let bench = Bench::new();
    let args = "--set optimum.balance=paper --set optimum.functional=wear-volume --set optimum.q=1.1 --set accuracy=1e-4 -q";
    let call = bench.call(&format!("run drum-brake-block {args}"));
    assert_eq!(call.code, 0, "{}", call.err);
    let summary = bench.summary("drum-brake-block");
    assert!(summary["pressure"]["force_N"].as_f64().unwrap() < 9600.0);
    assert!(summary["shape"]["roundtrip_same"].as_f64().unwrap() < 1e-7, "{}", summary["shape"]);
}

#[test]
fn keys_of_a_wear_rule_that_a_contact_does_not_use_need_no_factor() {
    let call = Bench::new().call("check hertz-cylinder --set wear.b=2");
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(call.out.contains("wear.b"), "{}", call.out);
}

/// A pad with a friction moment that its load does not carry: the trailing end of its surface carries nothing, and touches all the same.
#[test]
fn the_shape_of_a_pad_that_carries_on_a_part_of_its_surface_is_proved() {
    let bench = Bench::new();
    let pad = "kinematics=plane-strain body1.geometry.rectangle={x=[-20,20],z=[100,115]} body1.material.young=3000 \
               load={edge=top,as=pressure,force=1000} contact.friction=.3";
    let sets: String = pad.split(' ').filter(|set| !set.is_empty()).map(|set| format!(" --set {set}")).collect();
    let call = bench.call(&format!("run translating-punch --set accuracy=1e-4 -q{sets}"));
    assert_eq!(call.code, 0, "{}", call.err);
    let summary = bench.summary("translating-punch");
    assert_eq!(summary["pressure"]["regime"], "partial-contact");
    assert!(summary["shape"]["roundtrip_independent"].as_f64().unwrap() < 1e-2, "{}", summary["shape"]);
}

/// The ring segment leaves the drum in the midst of its surface: at its default accuracy the contact is done.
#[test]
fn a_ring_segment_that_leaves_its_drum_has_the_accuracy_asked_for() {
    let bench = Bench::new();
    let call = bench.call("run drum-brake-ring -q --set tasks=[contact]");
    assert_eq!(call.code, 0, "{}{}", call.out, call.err);
}
