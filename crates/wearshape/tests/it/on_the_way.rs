//! Runs in time that end on the way, while part of the surface is open.

use std::ops::ControlFlow;

use wearshape::{Bodies, Options, Sampling, Solution, Status, solve};

use crate::common::{scene, solved};

/// A hot contact has several sets of points in contact on one gap: what is told of the bodies is told of the one that is reported.
#[test]
fn supports_of_a_hot_run_carry_the_pressure_that_it_tells() {
    for settings in [&["wear.until=2"][..], &["wear.until=1", "sliding.omega=2"]] {
        let all = [&["tasks=[wear]", "accuracy=1e-2"], settings].concat();
        let solution = solved(&scene("drum-brake-hot", &all));
        assert_eq!(solution.status, Status::Ok, "{:?}", solution.reason);
        let profile = solution.profile.as_ref().unwrap();
        let open = profile.pressure.iter().filter(|p| **p == 0.0).count();
        assert!(open > 0 && open < profile.s.len(), "{open}");
        // The supports of body 2 carry p n + mu p tau; the drum turns anti-clockwise, so that tau is n turned so.
        let mut force = [0.0; 2];
        for i in 0..profile.s.len() {
            let [nx, _, nz] = profile.normal[i];
            let [p, q] = [profile.pressure[i], profile.shear[i]].map(|value| profile.weight[i] * value);
            let drag = [-nz, nx];
            (force[0], force[1]) = (force[0] + p * nx + q * drag[0], force[1] + p * nz + q * drag[1]);
        }
        let (_, held) = solution.reactions.iter().find(|(edge, _)| edge == "body2.inner").unwrap();
        let size = force[0].hypot(force[1]);
        let misses = [held.x.unwrap() - force[0], held.z.unwrap() - force[1]];
        assert!(misses.iter().all(|miss| miss.abs() < 1e-8 * size), "{settings:?}: {misses:?} of {force:?}");
    }
}

/// A scene worn on, its gap told at evenly spaced places.
fn sampled(name: &str, settings: &[&str]) -> Solution {
    let all = [&["tasks=[wear]"], settings].concat();
    let options = Options { sample: Some(Sampling::Even(4001)), ..Options::default() };
    solve(&scene(name, &all), &options, &Bodies::default(), &mut |_| ControlFlow::Continue(())).unwrap()
}

/// How far the gap of a run is from that of a fine one, over the largest, without the rigid part: most of the surface is as it is.
fn apart(run: &Solution, fine: &Solution) -> f64 {
    let [gap, true_gap] = [run, fine].map(|solution| &solution.profile.as_ref().unwrap().gap);
    let size = true_gap.iter().fold(0.0_f64, |most, gap| most.max(*gap));
    let mut apart: Vec<f64> = gap.iter().zip(true_gap).map(|(a, b)| a - b).collect();
    apart.sort_by(f64::total_cmp);
    let middle = apart[apart.len() / 2];
    apart.iter().map(|miss| (miss - middle).abs()).fold(0.0, f64::max) / size
}

/// The end of contact of a lining under high friction moves over .4 mm next to the end of its surface and leaves a trace there, which is narrower than the
/// distance of evenly spaced places. Levels have it in no order, so that their differences tell its size alone: .77 to 2.8 of it in twelve such runs.
#[test]
fn the_error_of_a_run_that_ends_on_the_way_counts_the_trace_of_its_ends() {
    let worn = |how: &str| sampled("lining-on-back", &["wear.until=0.05", "contact.friction=0.6", how]);
    let fine = worn("mesh={ degree = 12, layers = 12 }");
    for accuracy in ["1e-3", "1e-5"] {
        let run = worn(&format!("accuracy={accuracy}"));
        let told = run.error.as_ref().unwrap().gap_relative.unwrap();
        let off = apart(&run, &fine);
        assert!(off > 1e-5 && off < 1.5 * told, "{accuracy}: {off:e} where {told:e} is told");
        assert_eq!(run.status == Status::AccuracyMissed, told > accuracy.parse::<f64>().unwrap());
    }
}

/// A punch beyond its kern, worn for many times its run-in: the pressure is the steady one, which ends inside the surface, `p = p_max (d / l)^(1/b)` with
/// `p_max = F (1 + 1/b) / (t l)`. Where its end stands on no node, levels of degree 6 and 8 have had its trace alike and 1e-2 off.
#[test]
fn a_long_run_of_a_punch_beyond_its_kern_is_as_accurate_as_it_tells() {
    for (b, moment, until) in [(3.0, 15000.0, 20000.0), (2.0, 20000.0, 5000.0)] {
        let settings = [
            &format!("wear={{ k = [1e-8, 0], a = 1, b = {b}, until = {until} }}"),
            &format!("load.moment={moment}"),
            "accuracy=1e-3",
        ];
        let run = solved(&scene("punch-wear", &settings));
        assert_eq!(run.status, Status::Ok, "{:?}", run.reason);
        // The middle of p over its length l = 30 - x0 stands at M / F.
        let k = 1.0 / b;
        let length = (30.0 - moment / 1000.0) * (k + 2.0);
        let most = 1000.0 * (k + 1.0) / (10.0 * length);
        let told = run.error.as_ref().unwrap().gap_relative.unwrap();
        let found = run.wear.as_ref().unwrap();
        assert!(found.depth.is_some() && told < 1e-3, "{told:e}");
        let profile = run.profile.as_ref().unwrap();
        for (s, p) in profile.s.iter().zip(&profile.pressure) {
            let d = s - 30.0 + length;
            let steady = if d > 0.0 { most * (d / length).powf(k) } else { 0.0 };
            let near = d.abs() < 0.02 * length;
            assert!(near || (p - steady).abs() < 2e-3 * most, "b {b} at {s}: {p} {steady}");
        }
    }
}

/// A lining that its friction holds has no steady pressure: nothing but a run itself tells where its contact ends. Without nodes there degrees 6 and 8 differed by
/// 1e-6 and 14 and 18 by 4e-3, since levels may have the end of contact at the end of one cell.
#[test]
fn a_run_to_no_known_place_has_nodes_where_it_found_the_end_of_its_contact() {
    let load = "load={ edge = 'top', as = 'rigid', force = 1e4, moment = 6e5, about = [0, 200] }";
    let worn = |how: &str| sampled("lining-on-back", &[load, "body1.support={ top = ['x'] }", "wear.until=3", how]);
    let run = worn("accuracy=1e-3");
    assert_eq!(run.status, Status::Ok, "{:?}", run.reason);
    let (told, off) =
        (run.error.as_ref().unwrap().gap_relative.unwrap(), apart(&run, &worn("mesh={ degree = 14, layers = 14 }")));
    assert!(off > 1e-5 && off < told, "{off:e} where {told:e} is told");
}

/// The steady pressure of a pinned shoe fills its surface: once the contact has done so, degrees fall fast again, whatever its ends passed over before.
#[test]
fn a_run_whose_contact_has_filled_the_surface_is_as_accurate_as_its_levels_say() {
    let run = |how: &str| sampled("pinned-shoe-elastic", &["wear.until='10h'", how]);
    let coarse = run("accuracy=1e-4");
    assert_eq!(coarse.status, Status::Ok, "{:?}", coarse.reason);
    assert!(coarse.history.iter().any(|(name, values)| name == "p_min_MPa" && values[0] == 0.0));
    let (told, off) =
        (coarse.error.as_ref().unwrap().gap_relative.unwrap(), apart(&coarse, &run("mesh={ degree = 12, layers = 12 }")));
    assert!(off < told && told < 1e-4, "{off:e} where {told:e} is told");
}

/// A punch under a moment touches in part until it has worn: where the steps were as fine as the accuracy alone had them, levels differed by those of each,
/// and a run to 1e-3 told 1.4e-2 after seven of them.
#[test]
fn a_contact_that_grows_over_its_surface_has_steps_as_fine_as_its_accuracy_asks_for() {
    let worn = |how: &str| {
        let wear = "wear={k=[1e-7,0],a=1,b=1,counterface='fresh',until='300 s'}";
        sampled("punch-wear", &["load.moment=12000", wear, how])
    };
    let (run, fine) = (worn("accuracy=1e-3"), worn("mesh={ degree = 12, layers = 8 }"));
    assert_eq!(run.status, Status::Ok, "{:?}", run.reason);
    let told = run.error.as_ref().unwrap().gap_relative.unwrap();
    let off = apart(&run, &fine);
    assert!(off < told && told < 1e-3, "{off:e} {told:e}");
}

/// By powers of the pressure a worn depth is not fixed by the force; its mean, which the gap leaves open, was told as closely as the gap: 2.4e-5 where 2e-4 was true.
#[test]
fn the_error_of_the_depth_of_a_run_on_the_way_counts_its_mean() {
    let wear = "wear={k=[1e-6,3e-6],b=[1.75,1.98],counterface=congruent,until=50}";
    let of = |set: &str| solved(&scene("punch-wear", &[wear, "contact.gap={crown=0.00409}", set])).wear.unwrap();
    let [rough, fine] = ["accuracy=1e-4", "mesh={degree=10,layers=10}"].map(of);
    let error = (rough.volume.unwrap() / fine.volume.unwrap() - 1.0).abs();
    assert!(error > 1e-4 && error < rough.run_in_error.unwrap(), "{error:.1e} {:?}", rough.run_in_error);
}
