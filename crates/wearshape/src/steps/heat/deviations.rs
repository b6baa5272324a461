//! Whether deviations of a hot contact from its steady pressure wear off.

use contact::faer::Mat;
use contact::{ContactLoad, ContactOperator};
use scene::{Fault, Functional};
use wear::Counterface;

use crate::faults::unsolved;
use crate::stage::Stage;
use crate::steps::heat::following::Following;
use crate::steps::heat::smooth::{Smooth, smooth};

impl Following<'_> {
    /// The fastest growth (1/s) of what deviates from a steady pressure (MPa) at the points and is smooth along the surface; 0 where all of it wears
    /// off, none where the pressure is not one of wear. A body 2 that is fresh or revolves does not take the shape of what is worn off it.
    pub(crate) fn deviation_growth(
        &self,
        stage: Stage<'_>,
        operator: &ContactOperator<'_>,
        (base, pressure): (&ContactLoad, &[f64]),
    ) -> Result<Option<f64>, Fault> {
        let (laws, counterface) = stage.rules()?;
        if stage.problem.optimum.functional != Functional::Steady || !laws.active {
            return Ok(None);
        }
        let shaped = if counterface == Counterface::Congruent { &laws.rules[..] } else { &laws.rules[..1] };
        let points = operator.points();
        let closed: Vec<bool> = pressure.iter().map(|p| *p > 0.0).collect();
        let slope = |i: usize| -> f64 {
            let speed = stage.surface_point(points[i].position, points[i].normal, 0.0).sliding_speed;
            shaped.iter().map(|rule| rule.slope(pressure[i], speed)).sum()
        };
        let slopes: Vec<f64> = (0..points.len()).map(|i| if closed[i] { slope(i) } else { 0.0 }).collect();
        let pressed: Vec<usize> = (0..points.len()).filter(|i| closed[*i]).collect();
        let Some(start) = pressed.first().map(|i| points[*i].arc) else { return Ok(None) };
        let places: Vec<(f64, f64)> = pressed.iter().map(|i| (points[*i].arc - start, points[*i].weight)).collect();
        let there = smooth(&places, Smooth::Deviations);
        let mut functions = Mat::zeros(points.len(), there.ncols());
        for (row, i) in pressed.iter().enumerate() {
            (0..there.ncols()).for_each(|k| functions[(*i, k)] = there[(row, k)]);
        }
        let load = self.fitting(base, &self.surfaces.rates, &self.shared(&closed)?);
        operator.deviation_growth(&load, &closed, (&slopes, &functions)).map_err(unsolved)
    }
}
