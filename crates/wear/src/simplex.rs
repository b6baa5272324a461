//! A small linear programme: minimise sum cost_j m_j under sum weight_kj m_j = target_k, m >= 0, with a handful of rows.

use nalgebra::{DMatrix, DVector};

use crate::mode::MAX_MODES;

/// A candidate place of a concentrated force.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Column {
    pub(crate) cost: f64,
    pub(crate) weight: [f64; MAX_MODES],
}

/// Two-phase revised simplex: column index and mass of the optimal basis; `None` when no m >= 0 meets the targets.
pub(crate) fn minimise(columns: &[Column], target: &[f64]) -> Option<Vec<(usize, f64)>> {
    let rows = target.len();
    let total = columns.len();
    // Artificial columns (indices from `total`) carry the sign of the target.
    let entry = |j: usize, k: usize| {
        if j < total {
            columns[j].weight[k]
        } else if j - total == k {
            if target[k] < 0.0 { -1.0 } else { 1.0 }
        } else {
            0.0
        }
    };
    let scale: f64 = target.iter().map(|t| t.abs()).sum();
    let mut basis: Vec<usize> = (total..total + rows).collect();
    let right = DVector::from_column_slice(target);
    for phase in [1, 2] {
        let cost = |j: usize| match (phase, j < total) {
            (1, artificial) => f64::from(u8::from(!artificial)),
            (_, true) => columns[j].cost,
            (_, false) => 0.0,
        };
        for _ in 0..500 {
            let matrix = DMatrix::from_fn(rows, rows, |k, i| entry(basis[i], k)).lu();
            let mass = matrix.solve(&right)?;
            let prices = DVector::from_fn(rows, |i, _| cost(basis[i]));
            let dual = DMatrix::from_fn(rows, rows, |i, k| entry(basis[i], k)).lu().solve(&prices)?;
            let reduced = |j: usize| cost(j) - (0..rows).map(|k| dual[k] * entry(j, k)).sum::<f64>();
            let entering = (0..total)
                .map(|j| (j, reduced(j)))
                .min_by(|a, b| a.1.total_cmp(&b.1))
                .filter(|(j, value)| *value < -1e-13 * cost(*j).abs().max(1.0) && !basis.contains(j));
            let Some((j, _)) = entering else {
                if phase == 2 {
                    return Some((0..rows).filter(|i| basis[*i] < total).map(|i| (basis[i], mass[i])).collect());
                }
                break;
            };
            let direction = matrix.solve(&DVector::from_fn(rows, |k, _| entry(j, k)))?;
            let leaving = (0..rows)
                .filter(|i| direction[*i] > 1e-12)
                .map(|i| (i, mass[i].max(0.0) / direction[i]))
                .min_by(|a, b| a.1.total_cmp(&b.1))?;
            basis[leaving.0] = j;
        }
        if phase == 1 {
            let matrix = DMatrix::from_fn(rows, rows, |k, i| entry(basis[i], k)).lu();
            let mass = matrix.solve(&right)?;
            let missed: f64 = (0..rows).filter(|i| basis[*i] >= total).map(|i| mass[i].abs()).sum();
            if missed > 1e-10 * scale {
                return None;
            }
        }
    }
    None
}
