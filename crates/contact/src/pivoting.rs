//! Block principal pivoting: an exact active-set method that needs no symmetry and no merit function.
//!
//! All points with a wrong sign change sides together as long as their number falls; after ten steps without progress only the last one
//! does (Murty 1974), which ends on every P-matrix (Kostreva 1978; Judice and Pires 1994).

use crate::lcp::{Answer, Complementarity, Point, Proximal};
use crate::linear::Scaling;

/// Steps without progress before single changes begin.
const PATIENCE: usize = 10;

/// Solves from full contact; the answer takes what is found.
pub(crate) fn solve(problem: &Complementarity<'_>, scaling: &Scaling, answer: &mut Answer) {
    answer.pivoted = true;
    let mut active = vec![true; problem.points()];
    let (mut best, mut patience) = (usize::MAX, PATIENCE);
    let origin = Point { force: vec![0.0; problem.points()], coordinates: vec![0.0; problem.load.len()] };
    // Without enough points in contact to hold the coordinates a weak spring does.
    let weak = Proximal { weight: f64::EPSILON.sqrt(), centre: &origin };
    for _ in 0..100 + 4 * problem.points() {
        answer.factorisations += 1;
        let wrong = match problem.finish(scaling, &active, answer) {
            Some(wrong) => wrong,
            None => {
                let Some((near, _)) = problem.on_active(scaling, &active, &weak) else { return };
                // From there the spring pulls no more on the coordinates that contact holds.
                let weak = Proximal { centre: &near, ..weak };
                let Some((point, _)) = problem.on_active(scaling, &active, &weak) else { return };
                let opening = problem.openings(&point);
                let wrong = problem.wrong(&point, &opening, &active);
                // So few points touch that a free coordinate is held by none, and no load moves it: a round body on one point of a coarse mesh.
                if wrong.is_empty() && problem.is_balanced(&point) {
                    answer.take(point, opening, &active);
                    return;
                }
                wrong
            }
        };
        let Some(last) = wrong.last() else { return };
        if wrong.len() < best {
            best = wrong.len();
            patience = PATIENCE;
        } else {
            patience = patience.saturating_sub(1);
        }
        if patience > 0 {
            wrong.iter().for_each(|i| active[*i] = !active[*i]);
        } else {
            active[*last] = !active[*last];
        }
    }
}
