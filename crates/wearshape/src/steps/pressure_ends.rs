//! Ends of an optimal pressure that does not fill the contact surface, and of that part of it where the largest admissible pressure holds it down: the
//! pressure has kinks there, and the shape needs nodes. So it does where the pressure passes one at which a wear rule bends.

use wear::WearPair;

use crate::problem::Problem;
use crate::stage::Stage;

/// Pieces of the surface in which one end is looked for.
const PIECES: usize = 400;
/// Ends nearer to those of the surface count as these.
const APART: f64 = 1e-6;
/// Relative distance from the pressure at which a rule bends that is none, however a uniform one is rounded.
const AT: f64 = 1e-11;

/// Places from -1 to 1 where the pressure begins or ends inside the surface, or to be capped, in order.
pub(crate) fn pressure_ends(stage: Stage<'_>, optimum: &wear::Optimum) -> Vec<f64> {
    changes(stage, |point| (optimum.presses_at(point), optimum.is_capped_at(point)))
}

/// Places from -1 to 1 where the pressure passes one at which a wear rule bends, in order.
pub(crate) fn pressure_bends(stage: Stage<'_>, optimum: &wear::Optimum) -> Vec<f64> {
    let bends = bends(stage.problem);
    if bends.is_empty() {
        return Vec::new();
    }
    // How many are passed, and whether one is met: a pressure may also stay at it.
    changes(stage, |point| {
        let pressure = optimum.pressure_at(point);
        bends.iter().flat_map(|bend| [bend * (1.0 - AT), bend * (1.0 + AT)]).filter(|limit| pressure > *limit).count()
    })
}

/// The pressures (MPa) at which the wear rules of a problem bend.
pub(crate) fn bends(problem: &Problem) -> Vec<f64> {
    problem.wear.laws.iter().flat_map(WearPair::bends).collect()
}

/// Places from -1 to 1 inside the surface where something changes along it, in order.
fn changes<K: PartialEq>(stage: Stage<'_>, kind: impl Fn(&wear::SurfacePoint) -> K) -> Vec<f64> {
    let surface = &stage.patch.surface;
    let (lo, hi) = surface.range();
    let kind = |t: f64| kind(&surface.along(0.5 * (lo * (1.0 - t) + hi * (1.0 + t))));
    let place = |i: usize| 2.0 * i as f64 / PIECES as f64 - 1.0;
    let mut places = Vec::new();
    for i in 0..PIECES {
        let (mut low, mut high) = (place(i), place(i + 1));
        let before = kind(low);
        if before == kind(high) {
            continue;
        }
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if kind(middle) == before { low = middle } else { high = middle }
        }
        places.push(0.5 * (low + high));
    }
    places.retain(|t| t.abs() < 1.0 - APART);
    places
}
