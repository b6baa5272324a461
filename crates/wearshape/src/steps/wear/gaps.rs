//! Gaps of worn bodies without what is rigid in them.

use contact::{ContactOperator, ContactPoint, Pair};
use nalgebra::DMatrix;
use shapeopt::{Measure, NodalCurve, WearState, closing, difference_of_gaps, lowest_nonnegative};

use crate::stage::Stage;
use crate::steps::shape::FLAT;

/// How far another gap is from one that is known.
pub(super) type ApartFrom<'g> = &'g dyn Fn(&[f64]) -> f64;

/// How far a gap is from that of a state, modulo the rigid part, over the largest gap; zero of gaps that are round-off.
pub(super) fn gaps_apart(
    (stage, pair, operator): (Stage<'_>, &Pair<'_>, &ContactOperator<'_>),
    state: &WearState,
    other: &[f64],
) -> f64 {
    let [gap, other] = [&state.gap, other].map(|gap| with_lowest_rigid_part(stage, pair, operator, gap));
    if gap.iter().fold(0.0_f64, |most, gap| most.max(gap.abs())) <= FLAT * state.depth {
        return 0.0;
    }
    let points = operator.points();
    let modes: Vec<f64> = points.iter().flat_map(|point| closing(pair, point)).collect();
    let modes = DMatrix::from_row_slice(points.len(), modes.len() / points.len().max(1), &modes);
    difference_of_gaps(&other, &gap, &modes, Measure::Largest)
}

/// A gap with its lowest rigid part that keeps it open, unless the rigid part is prescribed.
pub(super) fn with_lowest_rigid_part(stage: Stage<'_>, pair: &Pair<'_>, operator: &ContactOperator<'_>, gap: &[f64]) -> Vec<f64> {
    let curve = NodalCurve { pair, operator, gap };
    let rigid = if stage.rigid_prescribed() || stage.turned() != 0.0 { None } else { lowest_nonnegative(&curve) };
    let rigid = rigid.unwrap_or_else(|| vec![0.0; pair.shaped.rigid_modes.ncols()]);
    let lifted = |p: &ContactPoint| rigid.iter().zip(closing(pair, p)).map(|(a, phi)| a * phi).sum::<f64>();
    operator.points().iter().zip(gap).map(|(p, g)| g + lifted(p)).collect()
}
