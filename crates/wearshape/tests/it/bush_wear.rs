//! A shaft in a bush with clearance that wears in time: the contact grows from the place where they touch to both sides.
//!
//! A rigid shaft of radius R, the clearance c and what is worn off the middle h: where the shaft stands over the circle of the bush, the bush is worn,
//!
//! ```text
//!        .-- - --.           w(phi) = (c + h) cos phi - c,      cos alpha = c / (c + h)
//!      /  \  |  /  \          p(phi) = p_0 cos phi,             F = p_0 R t (alpha + sin alpha cos alpha)
//!     |    \ alpha |         dh/ds = k p_0, so that            k F s / (R t c) = alpha / cos alpha - sin alpha
//!      \     '     /
//! ```
//! with t the length of the bush and s the distance slid, to the first order in c / R.

use approx::assert_relative_eq;
use wearshape::{Problem, Solution, Status};

use crate::common::{goes_on, scene, solved};

const RADIUS: f64 = 25.0;
const LENGTH: f64 = 30.0;
const CLEARANCE: f64 = 0.05;
const FORCE: f64 = 3000.0;
/// 1e-6 mm^3/(N m).
const FACTOR: f64 = 1e-9;

fn worn(settings: &[&str]) -> Problem {
    let all: Vec<&str> = ["tasks=[wear]"].iter().chain(settings).copied().collect();
    scene("bushing", &all)
}

fn depth(solution: &Solution) -> f64 {
    1e-3 * solution.wear.as_ref().unwrap().depth.unwrap()
}

fn ends(solution: &Solution) -> [f64; 2] {
    solution.wear.as_ref().unwrap().ends.unwrap()
}

fn estimate(solution: &Solution) -> f64 {
    solution.error.as_ref().unwrap().gap_relative.unwrap()
}

/// Half the angle of contact of rigid bodies after a distance.
fn half_angle(distance: f64) -> f64 {
    let worn = FACTOR * FORCE * distance / (RADIUS * LENGTH * CLEARANCE);
    let mut range = [0.0, 1.57];
    for _ in 0..200 {
        let middle: f64 = 0.5 * (range[0] + range[1]);
        range[usize::from(middle / middle.cos() - middle.sin() > worn)] = middle;
    }
    range[0]
}

#[test]
fn a_rigid_shaft_wears_the_bush_to_its_own_circle() {
    let stiff = ["contact.shear=false", "body1.material.young=1e8", "body2.material.young=2.1e8", "accuracy=1e-3"];
    for until in ["wear.until=600", "wear.until=1 h"] {
        let all: Vec<&str> = stiff.iter().copied().chain([until]).collect();
        let solution = solved(&worn(&all));
        assert_eq!(solution.status, Status::Ok, "{until}: {:?}", solution.reason);
        let wear = solution.wear.as_ref().unwrap();
        let alpha = half_angle(wear.distance.unwrap());
        let [from, to] = ends(&solution);
        let exact = CLEARANCE * (1.0 / alpha.cos() - 1.0);
        println!("{until}: half angle {} of {alpha}, depth {} of {exact}", to / RADIUS, depth(&solution));
        assert_relative_eq!(depth(&solution), exact, max_relative = 2e-3);
        assert_relative_eq!(to / RADIUS, alpha, max_relative = 2e-3);
        assert!((from + to).abs() < 1e-4 * to, "{from} {to}");
        let volume = 2.0 * RADIUS * LENGTH * ((CLEARANCE + exact) * alpha.sin() - CLEARANCE * alpha);
        assert_relative_eq!(wear.volumes.unwrap()[0], volume, max_relative = 5e-3);
        // The pressure is that of the rule: it goes with the cosine, and carries the force.
        let most = FORCE / (RADIUS * LENGTH * (alpha + alpha.sin() * alpha.cos()));
        let profile = solution.profile.as_ref().unwrap();
        let inner = profile.s.iter().zip(&profile.pressure).filter(|(s, _)| s.abs() < 0.8 * to);
        let off = inner.map(|(s, p)| (p / (most * (s / RADIUS).cos()) - 1.0).abs()).fold(0.0, f64::max);
        println!("{until}: pressure off by {off:.1e}");
        assert!(off < 3e-2, "{until}: {off:e}");
    }
}

/// What is missing along the profile is the volume counted, and the wear of b = 1 is k times the integral of pressure and distance.
#[test]
fn what_is_worn_off_along_the_surface_is_the_volume() {
    let solution = solved(&worn(&["wear.until=1 h", "accuracy=1e-3"]));
    let running = solution.running_in.as_ref().unwrap();
    let (first, last) = (&running.steps[0], &running.steps[running.steps.len() - 1]);
    let worn: Vec<f64> = last.gap.iter().zip(&first.gap).map(|(b, a)| 1e-3 * (b - a)).collect();
    let strip = |i: usize| 0.5 * (running.s[i + 1] - running.s[i]) * (worn[i] + worn[i + 1]);
    let volume = LENGTH * (0..worn.len() - 1).map(strip).sum::<f64>();
    assert_relative_eq!(solution.wear.as_ref().unwrap().volumes.unwrap()[0], volume, max_relative = 3e-3);
}

/// Friction moves the contact to one side; the mirror image of the run turns the other way.
#[test]
fn the_other_sense_of_turning_is_the_mirror_image() {
    let of = |omega: &str| solved(&worn(&["wear.until=600", "accuracy=1e-3", omega]));
    let [there, back] = ["sliding.omega=300 rpm", "sliding.omega=-300 rpm"].map(of);
    let ([a, b], [c, d]) = (ends(&there), ends(&back));
    assert!((a + d).abs() < 2e-3 * (b - a) && (b + c).abs() < 2e-3 * (b - a), "{a} {b}, {c} {d}");
    assert!((a + b).abs() > 2e-2 * (b - a), "friction moves the contact: {a} {b}");
    assert_relative_eq!(depth(&there), depth(&back), max_relative = 1e-3);
}

#[test]
fn errors_are_within_their_estimates() {
    let of = |until: &str, accuracy: &str| solved(&worn(&["contact.shear=false", until, accuracy]));
    for until in ["wear.until=1", "wear.until=30", "wear.until=600", "wear.until=5 h"] {
        let fine = of(until, "accuracy=1e-4");
        let rough = of(until, "accuracy=1e-2");
        assert_eq!(rough.status, Status::Ok, "{until}: {:?}", rough.reason);
        let error = (depth(&rough) / depth(&fine) - 1.0).abs();
        println!("{until}: true {error:.1e}, estimated {:.1e}, finer {:.1e}", estimate(&rough), estimate(&fine));
        assert!(error < estimate(&rough) + estimate(&fine), "{until}: {error:.1e}");
    }
}

/// Of a knee insert whose contact grows to half as wide again: differences of levels were small by chance, 1.0e-6 told where 2.5e-6 was true.
#[test]
fn the_error_of_a_contact_that_grows_far_is_told() {
    let of = |set: &str| solved(&scene("knee", &["tasks=[wear]", "sliding={omega=1}", "wear={k=[1e-6,0],until=1000}", set]));
    let [rough, fine] = ["accuracy=1e-5", "mesh={degree=14,layers=12}"].map(of);
    let error = (depth(&rough) / depth(&fine) - 1.0).abs();
    assert!(error < estimate(&rough) && estimate(&rough) < 1e-5, "{error:.1e} {:.1e}", estimate(&rough));
}

/// Nodes are at the ends where the level before has them: rough runs, whose nodes all levels had, set degrees 12 and 14 apart by 3e-5 of them.
#[test]
fn ends_of_a_contact_that_grows_are_those_of_its_own_levels() {
    let of = |degree: &str| {
        let all = ["tasks=[wear]", "sliding={omega=1}", "wear={k=[1e-6,0],until=20}", degree, "mesh.layers=14"];
        ends(&solved(&scene("knee", &all)))
    };
    let [[_, coarse], [_, fine]] = ["mesh.degree=12", "mesh.degree=14"].map(of);
    assert!((coarse / fine - 1.0).abs() < 2e-6, "{coarse} {fine}");
}

/// The wear is small against the approach, and errors count by the wear: without that, the levels of the second were 2e-4 apart by their steps alone.
#[test]
fn a_short_run_is_as_accurate_as_asked_for() {
    for set in [
        ["wear.until=1", "contact.shear=true"],
        ["wear.until=30", "contact.shear=false"],
        ["wear.until=30", "contact.shear=true"],
    ] {
        let solution = solved(&worn(&set));
        assert_eq!(solution.status, Status::Ok, "{set:?}: {:?}", solution.reason);
        assert!(estimate(&solution) < 1e-4, "{set:?}: {:?}", solution.error);
    }
}

/// The pressure is largest between two points of the contact: the largest depth at the points alone was 6e-4 short of it.
#[test]
fn the_depth_is_the_largest_of_the_profile_wherever_the_points_are() {
    let of = |until: &str, accuracy: &str| solved(&worn(&["contact.shear=true", until, accuracy]));
    let [rough, fine] = ["accuracy=1e-4", "accuracy=1e-5"].map(|accuracy| of("wear.until=36.24", accuracy));
    let error = (depth(&rough) / depth(&fine) - 1.0).abs();
    assert!(error < estimate(&rough) + estimate(&fine) && error < 1e-5, "{error:.1e}");
    // Until that depth it takes that time.
    let until = of(&format!("wear.until={{depth={:e}}}", depth(&rough)), "accuracy=1e-4");
    assert_eq!(until.status, Status::Ok, "{:?}", until.reason);
    let time = until.wear.as_ref().unwrap().time.unwrap();
    assert!((time / 36.24 - 1.0).abs() < 1e-4, "{time}");
}

/// When the bush touches along all of its arc, its pressure is on the way to the steady one of that arc: by the force misplaced.
#[test]
fn a_bush_worn_to_its_ends_comes_to_the_steady_pressure() {
    let set = ["tasks=[pressure, wear]", "contact.shear=false", "accuracy=1e-3"];
    let off = |until: &str| {
        let all: Vec<&str> = set.iter().copied().chain([until]).collect();
        let solution = solved(&scene("bushing", &all));
        let most = solution.pressure.as_ref().unwrap().p_max.unwrap();
        let profile = solution.profile.as_ref().unwrap();
        let force = |i: usize| profile.weight[i] * (profile.pressure[i] - most * (profile.s[i] / RADIUS).cos()).abs();
        (0..profile.s.len()).map(force).sum::<f64>() / FORCE
    };
    let [early, late] = ["wear.until=1 h", "wear.until=100 h"].map(off);
    println!("off by {early:.1e}, {late:.1e}");
    assert!(early > 0.1 && late < 1e-2, "{early:e} {late:e}");
}

#[test]
fn a_run_goes_on_from_where_it_was_stopped() {
    let problem = worn(&["wear.until=600", "mesh.degree=6"]);
    goes_on(&problem, &[1, 5]);
}

/// A condyle in its insert wears by a power of the pressure, and under a load that changes.
#[test]
fn a_knee_wears_by_other_rules_too() {
    for rule in [["wear.b=2", "wear.k=1e-9"], ["wear.b=0.5", "wear.k=1e-6"]] {
        let set = ["tasks=[wear]", "sliding.omega=1", "wear.until=20", "accuracy=1e-2", rule[0], rule[1]];
        let solution = solved(&scene("knee", &set));
        assert_eq!(solution.status, Status::Ok, "{rule:?}: {:?}", solution.reason);
        let [from, to] = ends(&solution);
        assert!(to > 1.0 && (from + to).abs() < 1e-6 * to, "{rule:?}: {from} {to}");
    }
}

/// What is counted is the level that is reported, not the search for where the contact ends.
#[test]
fn the_sizes_of_a_worn_bush_are_those_of_its_level() {
    let unknowns = |degree: &str| solved(&worn(&["wear.until=60", degree])).effort.counters.dofs;
    let [rough, fine] = ["mesh.degree=5", "mesh.degree=7"].map(unknowns);
    assert!(rough > 0 && 2 * fine > 3 * rough, "{rough} {fine}");
}

/// Beyond the ends of the contact the surface keeps what it was worn when it was widest, with a kink there: without a node at it this is 1.1e-3.
#[test]
fn a_contact_that_shrinks_leaves_the_edge_of_its_widest_scar() {
    let falling = ["wear.k=1e-9", "wear.until=1200", "schedule={time=[0,600],force=[1,0.3]}"];
    let run = |mesh: &str| solved(&worn(&[&falling[..], &[mesh]].concat())).curve.unwrap();
    let [rough, fine] = ["mesh={degree=8,layers=4}", "mesh={degree=12,layers=4}"].map(run);
    let largest = fine.gap.iter().fold(0.0_f64, |most, gap| most.max(*gap));
    let off = rough.gap.iter().zip(&fine.gap).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest;
    println!("off {off:.1e}");
    assert!(off < 6e-4, "{off:e}");
}
