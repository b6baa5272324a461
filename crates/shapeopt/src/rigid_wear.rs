//! Rigid motions along which wear may go on for ever, and how far a wear rate is from them.

use contact::ContactSystem;
use faer::{Mat, Side};

/// Stiffness of a rigid mode relative to that of a contact point.
const IDLE: f64 = 1e-11;

/// Coordinates split into rigid modes (no stiffness) and held ones.
pub(crate) struct RigidWear {
    /// Openings by the rigid modes, `points x modes`.
    pub(crate) influence: Mat<f64>,
    /// Balance columns of the rigid modes.
    pub(crate) balance: Mat<f64>,
    /// Openings by the held coordinates.
    pub(crate) held_influence: Mat<f64>,
    /// Balance columns of the held coordinates over their stiffness.
    pub(crate) held_balance: Mat<f64>,
    /// Resultants along the rigid modes.
    pub(crate) load: Vec<f64>,
    /// Displacements of the held coordinates by their resultants.
    pub(crate) held_load: Vec<f64>,
    /// Whether the load pushes along some rigid mode. If not, wear relieves the contact.
    pub(crate) driven: bool,
}

impl RigidWear {
    pub(crate) fn new(system: &ContactSystem) -> RigidWear {
        let (n, m) = (system.opening.len(), system.load.len());
        let softest = (0..n).map(|i| system.compliance[(i, i)].abs()).fold(f64::MIN_POSITIVE, f64::max);
        let unit: Vec<f64> = (0..m)
            .map(|j| (0..n).map(|i| system.influence[(i, j)].abs()).fold(0.0, f64::max))
            .map(|size| if size > 0.0 { 1.0 / size } else { 1.0 })
            .collect();
        let scaled =
            Mat::from_fn(m, m, |i, j| 0.5 * (system.stiffness[(i, j)] + system.stiffness[(j, i)]) * unit[i] * unit[j] * softest);
        let (mut vectors, mut values) = (Mat::<f64>::identity(m, m), vec![0.0; m]);
        if m > 0
            && let Ok(eigen) = scaled.self_adjoint_eigen(Side::Lower)
        {
            vectors = eigen.U().to_owned();
            values = (0..m).map(|j| eigen.S()[j]).collect();
        }
        let along = |matrix: &Mat<f64>, rigid: bool, divide: bool| {
            let columns: Vec<usize> = (0..m).filter(|j| (values[*j] < IDLE) == rigid).collect();
            Mat::from_fn(n, columns.len(), |i, c| {
                let sum: f64 = (0..m).map(|j| matrix[(i, j)] * unit[j] * vectors[(j, columns[c])]).sum();
                if divide { sum * softest / values[columns[c]] } else { sum }
            })
        };
        let along_mode = |k: usize| (0..m).map(|j| system.load[j] * unit[j] * vectors[(j, k)]).sum::<f64>();
        let size: f64 = (0..m).map(|j| (system.load[j] * unit[j]).abs()).sum();
        let (rigid, held): (Vec<usize>, Vec<usize>) = (0..m).partition(|k| values[*k] < IDLE);
        let driven = (0..m).any(|k| values[k] < IDLE && along_mode(k).abs() > 1e-13 * size);
        RigidWear {
            driven,
            influence: along(&system.influence, true, false),
            balance: along(&system.balance, true, false),
            held_influence: along(&system.influence, false, false),
            held_balance: along(&system.balance, false, true),
            load: rigid.into_iter().map(along_mode).collect(),
            held_load: held.into_iter().map(|k| along_mode(k) * softest / values[k]).collect(),
        }
    }

    /// `||r - Proj r|| / ||r||` in the area norm over the points under pressure, with the closing of open points by the rigid part added
    /// to the numerator: a run whose open points still come closer is not steady. Without a load along a rigid mode the contact wears itself
    /// free, and this is the part of the wear still to come: the closing `elastic` of the bodies over itself and what the gap has opened, `left = [elastic, opened]`.
    pub(crate) fn residual(&self, weights: &[f64], rate: &[f64], pressure: &[f64], left: [f64; 2]) -> f64 {
        // Rates may be so small that their squares are no numbers.
        let unit = unit(rate);
        let rate: Vec<f64> = rate.iter().map(|r| r * unit).collect();
        let inside = inside(weights, pressure);
        let whole = product(&inside, &rate, &rate).sqrt();
        if whole == 0.0 {
            return 0.0;
        }
        if !self.driven {
            let [elastic, opened] = left;
            return elastic / (elastic + opened);
        }
        let rest = self.rest(&inside, &rate);
        let square: f64 = (0..rate.len())
            .map(|i| if pressure[i] > 0.0 { rest[i] } else { rest[i].min(0.0) })
            .zip(weights)
            .map(|(r, w)| w * r * r)
            .sum();
        square.sqrt() / whole
    }

    /// `r - Proj r`: rates less their rigid part, in the area norm with weights that are 0 outside the contact ([`inside`]).
    pub(crate) fn rest(&self, inside: &[f64], rate: &[f64]) -> Vec<f64> {
        let product = |a: &[f64], b: &[f64]| product(inside, a, b);
        let remove = |vector: &mut Vec<f64>, unit: &Vec<f64>| {
            let part = product(vector, unit);
            vector.iter_mut().zip(unit).for_each(|(v, u)| *v -= part * u);
        };
        let mut basis: Vec<Vec<f64>> = Vec::new();
        for k in 0..self.influence.ncols() {
            let mut column = self.influence.col_as_slice(k).to_vec();
            let size = product(&column, &column).sqrt();
            (0..2).for_each(|_| basis.iter().for_each(|b| remove(&mut column, b)));
            let left = product(&column, &column).sqrt();
            if left > 1e-10 * size {
                column.iter_mut().for_each(|c| *c /= left);
                basis.push(column);
            }
        }
        let mut rest = rate.to_vec();
        (0..2).for_each(|_| basis.iter().for_each(|b| remove(&mut rest, b)));
        rest
    }
}

/// Areas of the points in contact, 0 of the others.
pub(crate) fn inside(weights: &[f64], pressure: &[f64]) -> Vec<f64> {
    weights.iter().zip(pressure).map(|(w, p)| if *p > 0.0 { *w } else { 0.0 }).collect()
}

/// The product of two profiles in the area norm.
fn product(weights: &[f64], a: &[f64], b: &[f64]) -> f64 {
    weights.iter().zip(a).zip(b).map(|((w, a), b)| w * a * b).sum()
}

/// A power of two that brings the largest of the values near 1; 1 where they are near enough that squares are safe.
fn unit(values: &[f64]) -> f64 {
    let largest = values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    if largest == 0.0 || (1e-100..1e100).contains(&largest) {
        1.0
    } else {
        2f64.powi(-(largest.log2().floor() as i32).max(-1000))
    }
}
