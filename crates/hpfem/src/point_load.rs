//! Where loads at points of a cell go: the rows of its modes.

use crate::basis::LocalModes;
use crate::cell_point::CellPoint;

/// What a load at a point contributes to the rows of each component: factors of the value of a mode and of its two derivatives.
pub(crate) type PointLoad = [[f64; 3]; 2];

/// Value and derivatives in the plane of a mode at a point, with its place in the local order.
pub(crate) type PlaneJet = (usize, [f64; 3]);

/// Rows of a load on the modes of a cell.
#[derive(Clone, Copy)]
pub(crate) struct Rows<'a> {
    pub(crate) components: usize,
    pub(crate) local: &'a LocalModes,
}

impl Rows<'_> {
    pub(crate) fn row(self, mode: usize, c: usize) -> usize {
        let (ni, nb) = (self.local.interior, self.local.modes - self.local.interior);
        if mode < ni { c * ni + mode } else { self.components * ni + c * nb + mode - ni }
    }

    /// Values and derivatives in the plane of every mode at a point, once for all load cases.
    pub(crate) fn jets(self, point: &CellPoint) -> Vec<PlaneJet> {
        let [[xx, xe], [zx, ze]] = point.derivative;
        let jacobian = point.jacobian();
        let modes = point.modes.iter().zip(&self.local.position).filter(|(_, m)| **m != usize::MAX);
        let plane = |jet: &[f64; 3]| {
            let dx = (jet[1] * ze - jet[2] * zx) / jacobian;
            let dz = (jet[2] * xx - jet[1] * xe) / jacobian;
            [jet[0], dx, dz]
        };
        modes.map(|(jet, mode)| (*mode, plane(jet))).collect()
    }

    /// Adds a load at a point to a column.
    pub(crate) fn add(self, column: &mut [f64], jets: &[PlaneJet], factors: &PointLoad) {
        for (mode, [value, dx, dz]) in jets {
            for (c, f) in factors.iter().enumerate().take(self.components) {
                column[self.row(*mode, c)] += f[0] * value + f[1] * dx + f[2] * dz;
            }
        }
    }
}
