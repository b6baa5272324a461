//! The proof of the shape of a reversing motion: contact solves on it, forward and backward, must give both pressures back. A
//! sense that the motion never goes in proves nothing: its pressure is that on a shape worn by the other.

use contact::{ContactOperator, ContactSolution};
use meshing::Cut;

use crate::effort::Effort;
use crate::faults::unsolved;
use crate::ladder::Refusal;
use crate::level::Level;
use crate::solution::Status;
use crate::steps::answer::Told;
use crate::steps::reversing::level::{Senses, Solved};

/// What the proof may miss at most on the very operators of the shape, relative to the pressure. Where a sense opens, it touches nearly without a
/// pressure beside its end, so that the contact there follows round-off of the gap.
const SAME: f64 = 1e-6;
/// What it may miss at least on other meshes before it counts as failed, and how much larger than that of the gap the error of a pressure may be.
const INDEPENDENT: [f64; 2] = [3e-2, 2e3];

/// Relative area-weighted L2 difference of two pressures.
fn difference(weights: &[f64], found: &[f64], wanted: &[f64]) -> f64 {
    let sum = |f: &dyn Fn(usize) -> f64| (0..weights.len()).map(|i| weights[i] * f(i)).sum::<f64>();
    (sum(&|i| (found[i] - wanted[i]).powi(2)) / sum(&|i| wanted[i].powi(2))).sqrt()
}

impl Senses<'_> {
    /// The larger of two misses, of the senses that the motion goes in.
    fn largest(&self, [forward, backward]: [f64; 2]) -> f64 {
        match self.share {
            1.0 => forward,
            0.0 => backward,
            _ => forward.max(backward),
        }
    }
}

fn weights(operator: &ContactOperator<'_>) -> Vec<f64> {
    operator.points().iter().map(|p| p.weight).collect()
}

/// The larger miss of both senses on the operator of the shape, and the contact forward.
pub(super) fn same(
    senses: &Senses<'_>,
    solved: &Solved,
    operator: &ContactOperator<'_>,
) -> Result<(f64, ContactSolution), Refusal> {
    let [forward, backward] = senses.loads(operator.points());
    let there = operator.solve(&solved.gap, &forward, None).map_err(unsolved)?;
    let back = operator.solve(&solved.gap, &backward, Some(&there)).map_err(unsolved)?;
    let weights = weights(operator);
    let miss = |found: &ContactSolution, side: usize| difference(&weights, &found.pressure, &solved.found.pressure[side]);
    let misses = [miss(&there, 0), miss(&back, 1)];
    Ok((senses.largest(misses), there))
}

/// The larger miss of both senses on an independent discretisation: two degrees more, other break points, the gap as a function of the arc length. Also
/// writes the pressure found forward into the columns that are told.
pub(super) fn independent(
    senses: &Senses<'_>,
    solved: &Solved,
    own: &ContactOperator<'_>,
    told: &mut Told,
) -> Result<(f64, Effort), Refusal> {
    let stage = senses.stages[0];
    let finer = Level { degree: (solved.level.degree + 2).min(hpfem::MAX_DEGREE), ..solved.level };
    let (reduced, effort) = stage.reduced(finer, Cut::Shifted)?;
    let pair = reduced.pair()?;
    let operator = reduced.operator(&pair, senses.shear())?;
    let at = |values: &[f64], exact: bool| -> Vec<f64> {
        let value = |arc: f64| if exact { own.value_at(values, arc) } else { own.pressure_at(values, arc) };
        operator.points().iter().map(|p| value(p.arc)).collect()
    };
    let gap = at(&solved.gap, true);
    let weights = weights(&operator);
    let mut misses = [0.0; 2];
    for (side, load) in senses.loads(operator.points()).into_iter().enumerate() {
        let found = operator.solve(&gap, &load, None).map_err(unsolved)?.pressure;
        misses[side] = difference(&weights, &found, &at(&solved.found.pressure[side], false));
        if side == 0 {
            let (start, length) = (stage.start(&pair), pair.trace().length());
            for profile in [&mut told.profile, &mut told.curve] {
                profile.pressure_solved =
                    profile.s.iter().map(|s| operator.pressure_at(&found, (s - start).clamp(0.0, length))).collect();
            }
        }
    }
    Ok((senses.largest(misses), effort))
}

/// The end of a shape whose proof fails.
pub(super) fn disproved([same, independent]: [f64; 2], gap: Option<f64>) -> Option<(Status, String)> {
    let by_gap = INDEPENDENT[1] * gap.unwrap_or(0.0);
    // A miss that is no number is one too.
    let within = |miss: f64, limit: f64| miss <= limit;
    let (miss, on) = match (!within(same, SAME.max(by_gap)), !within(independent, INDEPENDENT[0].max(by_gap))) {
        (true, _) => (same, "on the very bodies it was found on"),
        (_, true) => (independent, "on independent meshes"),
        _ => return None,
    };
    let reason = format!(
        "the proof fails: contact solves forward and backward on this shape give the pressures back within {} {on}",
        scene::short(miss)
    );
    Some((Status::AccuracyMissed, reason))
}
