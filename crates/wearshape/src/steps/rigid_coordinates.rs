//! Coordinates of body 1's rigid modes, and the closing and turning that they are.

use contact::Pair;
use nalgebra::{DMatrix, DVector};

/// Closing at `about` and turning (closing more at larger x) of body 1's rigid modes, `2 x modes`.
fn motions(pair: &Pair<'_>, about: f64) -> DMatrix<f64> {
    let modes = &pair.shaped.rigid_motions;
    DMatrix::from_fn(2, modes.len(), |row, k| {
        let [_, tz, theta] = modes[k];
        if row == 0 { -(tz + theta * about) } else { -theta }
    })
}

/// Closing at `about` (mm) and turning (rad) of rigid coordinates, one a rigid mode.
pub(crate) fn motion(pair: &Pair<'_>, coordinates: &[f64], about: f64) -> [f64; 2] {
    let sums = motions(pair, about) * DVector::from_row_slice(coordinates);
    [sums[0], sums[1]]
}

/// Rigid coordinates of a closing at `about` and a turning, as far as body 1 has these motions.
pub(crate) fn coordinates(pair: &Pair<'_>, [closing, turning]: [f64; 2], about: f64) -> Vec<f64> {
    let wanted = DVector::from_row_slice(&[closing, turning]);
    // Rows of unlike units: the modes are scaled by the distance from the middle that they are about.
    let size = pair.trace().length();
    let scale = DMatrix::from_diagonal(&DVector::from_row_slice(&[1.0, size]));
    let svd = (&scale * motions(pair, about)).svd(true, true);
    svd.solve(&(scale * wanted), 1e-12).map(|x| x.iter().copied().collect()).unwrap_or_default()
}
