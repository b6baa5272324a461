//! A level of discretisation.

/// Degree and layers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Level {
    /// Degree of the cells outside the layers; it falls with the layers, to 2 at least.
    pub degree: usize,
    /// Layers around each singular point.
    pub layers: usize,
    /// Whether the degree falls by one in every second layer instead of in each, for the bending of thin bodies.
    pub slow: bool,
    /// Whether cells far from all that is not smooth have that degree too: where contact ends inside them they are not smooth.
    pub even: bool,
}

impl Level {
    /// The layers that go with a degree: as many, so that both errors fall together, and the last layer, where the pressure of
    /// a round trip is off by order one, is too small to count. A ring segment bends: its gap is a hundred times that of a block, and in the
    /// smallest cells its last digits are pressure. It has three layers for four degrees, in which the degree falls half as fast.
    pub(crate) fn of(degree: usize, bends: bool) -> Level {
        Level { degree, layers: if bends { (3 * degree).div_ceil(4) } else { degree }, slow: bends, even: false }
    }

    /// The level with its degree in all cells outside the layers.
    pub(crate) fn evenly(self) -> Level {
        Level { even: true, ..self }
    }

    /// Degree of a cell in a layer.
    pub(crate) fn degree_in(self, layer: usize) -> usize {
        let fall = if self.slow { layer / 2 } else { layer };
        self.degree.saturating_sub(fall).max(2.min(self.degree))
    }
}
