//! Places along the surface at which the worn gaps of levels are compared.

use contact::{ContactPoint, Pair};

use crate::options::Sampling;
use crate::stage::Stage;

/// Evenly spaced places; more of them where a run ends on the way: what a moving end of contact passes over leaves a trace as narrow as a cell.
const EVEN: usize = 201;
const CLOSER: usize = 801;

/// Places beside each end of the surface or of contact, as narrow as the layers there, and the ratio of their distances from it.
const BESIDE: i32 = 32;
const RATIO: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// The places, of all levels the same, of a run on meshes with nodes at `ends`, from -1 to 1 along the surface.
pub(super) fn samples(stage: Stage<'_>, pair: &Pair<'_>, ends: &[f64]) -> Vec<ContactPoint> {
    let on_the_way = stage.problem.wear.until.is_some() && !stage.ends_move();
    if !on_the_way {
        return stage.sample(pair, Sampling::Even(EVEN));
    }
    let (start, length) = (stage.start(pair), pair.trace().length());
    let even = Sampling::Even(CLOSER).places([start, start + length]);
    let beside = [-1.0, 1.0].iter().chain(ends).flat_map(|end| {
        let at = start + 0.5 * length * (end + 1.0);
        (1..=BESIDE).flat_map(move |k| [-1.0, 1.0].map(|side| at + side * 0.5 * length * RATIO.powi(k)))
    });
    let inside = |s: &f64| *s > start && *s < start + length;
    let mut places: Vec<f64> = even.into_iter().chain(beside.filter(inside)).collect();
    places.sort_unstable_by(f64::total_cmp);
    stage.sample(pair, Sampling::At(&places))
}
