//! Ends of contact inside the surface, and what it costs to have element nodes on them.

use approx::assert_abs_diff_eq;

use crate::call::Bench;

/// Ends of contact, factorisations, and levels of a contact run.
fn contact(scene: &str, args: &str) -> (Vec<f64>, u64, u64) {
    let bench = Bench::new();
    let call = bench.call(&format!("run {scene} -q --set tasks=[contact] {args}"));
    assert_eq!(call.code, 0, "{scene} {args}: {}", call.err);
    let summary = bench.summary(scene);
    let ends: Vec<f64> = summary["contact"]["ends_mm"].as_array().unwrap().iter().map(|end| end.as_f64().unwrap()).collect();
    // Three up to the fixed degree, and a finer one beside them.
    let levels = 4;
    let factorisations = summary["counters"]["factorisations"].as_u64().unwrap();
    println!("{scene} {args}: {ends:?}, {factorisations} factorisations in {levels} levels");
    (ends, factorisations, levels)
}

#[test]
fn the_three_free_ends_of_the_ring_take_at_most_four_times_the_plain_ladder() {
    let (ends, factorisations, levels) = contact("drum-brake-ring", "--set mesh.degree=6");
    // Degrees up to 16 find -90.2963651, -22.1330315, 33.0514041 mm; the error at degree 6 is a few times 1e-4 of the half length.
    assert_eq!(ends.len(), 4);
    for (end, fine) in ends[1..].iter().zip([-90.296_365, -22.133_032, 33.051_404]) {
        assert_abs_diff_eq!(*end, fine, epsilon = 0.03);
    }
    assert!(factorisations > 2 * levels && factorisations <= 4 * 2 * levels);
}

#[test]
fn ends_of_contact_are_as_far_off_as_they_are_told_to_be() {
    let bench = Bench::new();
    let at = |scene: &str, accuracy: &str| {
        let call = bench.call(&format!("run {scene} -q --set accuracy={accuracy}"));
        assert_eq!(call.code, 0, "{scene} {accuracy}: {}", call.err);
        let summary = bench.summary(scene);
        [&summary["contact"]["ends_mm"], &summary["error"]["ends_mm"]].map(Clone::clone)
    };
    for scene in ["bushing", "hertz-sphere", "knee"] {
        let [[found, told], [fine, told_of_fine]] = ["1e-4", "1e-7"].map(|accuracy| at(scene, accuracy));
        let [told, told_of_fine] = [told, told_of_fine].map(|told| told.as_f64().unwrap());
        let far = |i: usize| (found[i].as_f64().unwrap() - fine[i].as_f64().unwrap()).abs();
        let off = far(0).max(far(1));
        println!("{scene}: off by {off:e} mm, told {told:e}");
        assert!(told_of_fine < 0.1 * told && off < told && off > 0.05 * told, "{scene} {off:e} {told:e} {told_of_fine:e}");
    }
}

#[test]
fn a_contact_that_fills_its_surface_is_not_positioned() {
    let (ends, factorisations, levels) = contact("drum-brake-block", "--set mesh.degree=6");
    assert_abs_diff_eq!(ends[1], 104.719_755_119_66, epsilon = 1e-9);
    assert_eq!((ends.len(), factorisations), (2, 2 * levels));
}

#[test]
fn a_punch_pressed_beyond_its_kern_opens_on_one_side_without_friction() {
    // Kern of 60 mm: a sixth to both sides, 10 mm; the force acts at 15 mm.
    let (ends, factorisations, levels) =
        contact("translating-punch", "--set mesh.degree=8 --set contact.friction=0 --set load.moment=15000");
    assert_abs_diff_eq!(ends[0], -16.570_08, epsilon = 0.005);
    assert_abs_diff_eq!(ends[1], 30.0, epsilon = 1e-9);
    assert!(factorisations <= 4 * 2 * levels);
    let mirrored = "--set mesh.degree=8 --set contact.friction=0 --set load.moment=-15000";
    let (other, _, _) = contact("translating-punch", mirrored);
    assert_abs_diff_eq!(other[1], -ends[0], epsilon = 1e-6);
}

#[test]
fn an_end_of_contact_next_to_a_sharp_edge_is_resolved_at_its_distance() {
    // Friction 1 lifts the trailing edge .39 mm before x = 30; the drag into the leading one makes d^-.6146 there.
    let bench = Bench::new();
    let call = bench.call("run translating-punch -q --set tasks=[contact] --set contact.friction=1 --set mesh.degree=12");
    assert_eq!(call.code, 0, "{}", call.err);
    let summary = bench.summary("translating-punch");
    let end = summary["contact"]["ends_mm"][1].as_f64().unwrap();
    println!("{end} {} {}", summary["error"], summary["contact"]["edge_exponents"]);
    // Degree 16 finds 29.60944.
    assert_abs_diff_eq!(end, 29.60944, epsilon = 2e-3);
    assert!(summary["error"]["pressure_relative"].as_f64().unwrap() < 1e-4);
    assert_abs_diff_eq!(summary["contact"]["edge_exponents"][0].as_f64().unwrap(), -0.6146, epsilon = 0.02);
    assert_eq!(summary["lints"].as_array().unwrap().len(), 0);
}

#[test]
fn an_edge_that_no_layers_resolve_is_told_with_its_exponent() {
    let bench = Bench::new();
    let call = bench.call("run translating-punch -q --set tasks=[contact] --set contact.friction=2 --set mesh.degree=6");
    assert_eq!(call.code, 0, "{}", call.err);
    let summary = bench.summary("translating-punch");
    assert_eq!(summary["lints"][0]["code"], "edge-unresolved");
    assert!(summary["lints"][0]["message"].as_str().unwrap().contains("d^(-0.982)"), "{}", summary["lints"]);
    // Its largest value at a point would say nothing.
    assert!(summary["contact"].get("p_max_MPa").is_none());
    assert!(summary["contact"]["iterations"].as_u64().unwrap() <= 30);
}
