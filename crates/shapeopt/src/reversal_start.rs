//! A first guess for a reversing motion: the same pressure in both senses, as without shear on the bodies.

use crate::gap_rate::GapRate;
use crate::rigid_wear::RigidWear;
use nalgebra::{DMatrix, DVector};

/// Velocities of the rigid modes whose feed wears at the rates of a uniform pressure that carries the load, as nearly as they can.
pub(crate) fn first_feed(rigid: &RigidWear, rate: &GapRate, weights: &[f64]) -> Vec<f64> {
    let (n, modes) = (weights.len(), rigid.influence.ncols());
    // The pressure that carries the largest resultant, as uniform pressures make them.
    let carried = |k: usize| (0..n).map(|i| rigid.balance[(i, k)] * weights[i]).sum::<f64>();
    let (mut load, mut reach) = (0.0, 0.0);
    for k in 0..modes {
        load -= rigid.load[k] * carried(k);
        reach += carried(k) * carried(k);
    }
    let pressure = load / reach;
    let recession = rate.recession(&vec![pressure; n]);
    let modes_of = DMatrix::from_fn(n, modes, |i, k| -rigid.influence[(i, k)] * weights[i].sqrt());
    let rates = DVector::from_fn(n, |i, _| (rate.local(i, pressure) + recession) * weights[i].sqrt());
    let found = modes_of.svd(true, true).solve(&rates, 1e-12);
    found.map_or_else(|_| vec![0.0; modes], |found| found.iter().copied().collect())
}
