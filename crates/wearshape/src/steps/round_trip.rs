//! The proof of a shape: a full Signorini-Coulomb solve on it must give the wanted pressure back.

use contact::{ContactLoad, ContactOperator, ContactSolution};
use meshing::Cut;
use scene::Fault;
use shapeopt::{GapCurve, Shape, SurfacePlace};

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::faults::unsolved;
use crate::level::Level;
use crate::results::InterfaceResult;
use crate::steps::answer::Told;
use crate::steps::diagnosis;
use crate::steps::shaper::Shaper;

/// Relative area-weighted L2 difference of two pressures.
fn difference(weights: &[f64], found: &[f64], wanted: &[f64]) -> f64 {
    let sum = |f: &dyn Fn(usize) -> f64| (0..weights.len()).map(|i| weights[i] * f(i)).sum::<f64>();
    (sum(&|i| (found[i] - wanted[i]).powi(2)) / sum(&|i| wanted[i].powi(2))).sqrt()
}

/// Wanted pressure at the points of an operator, and its points' weights.
fn wanted(shaper: &Shaper<'_>, operator: &ContactOperator<'_>) -> (Vec<f64>, Vec<f64>) {
    let points = operator.points();
    points.iter().map(|p| (p.weight, shaper.pressure(&SurfacePlace::from(p)))).unzip()
}

/// Round trip on the very operators the shape was found on: a test of the contact solver. With it the condition of its system.
pub(crate) fn same(shaper: &Shaper<'_>, reduced: &Reduced, shape: &Shape) -> Result<(f64, Option<InterfaceResult>), Fault> {
    let pair = reduced.pair()?;
    let operator = reduced.operator(&pair, shaper.stage.friction() > 0.0)?;
    let gap: Vec<f64> = operator.points().iter().map(|p| shape.gap(&pair, p)).collect();
    let found = solve(shaper, &operator, &gap)?;
    let interface = diagnosis::interface(&operator, &gap, &loaded(shaper, &operator), &found)?;
    let (weights, wanted) = wanted(shaper, &operator);
    Ok((difference(&weights, &found.pressure, &wanted), interface))
}

/// Round trip on an independent discretisation: two degrees more, other break points, the gap as a function of the arc length.
/// Also writes the pressure found into the columns that are told, interpolated between the new points.
pub(crate) fn independent(shaper: &Shaper<'_>, level: Level, shape: &GapCurve, told: &mut Told) -> Result<(f64, Effort), Fault> {
    let finer = Level { degree: (level.degree + 2).min(hpfem::MAX_DEGREE), ..level };
    let (reduced, effort) = shaper.stage.reduced(finer, Cut::Shifted)?;
    let pair = reduced.pair()?;
    let operator = reduced.operator(&pair, shaper.stage.friction() > 0.0)?;
    let gap: Vec<f64> = operator.points().iter().map(|p| shape.at(p.arc)).collect();
    let found = solve(shaper, &operator, &gap)?.pressure;
    let (weights, wanted) = wanted(shaper, &operator);
    let (start, length) = (shaper.stage.start(&pair), pair.trace().length());
    for profile in [&mut told.profile, &mut told.curve] {
        profile.pressure_solved =
            profile.s.iter().map(|s| operator.pressure_at(&found, (s - start).clamp(0.0, length))).collect();
    }
    Ok((difference(&weights, &found, &wanted), effort))
}

fn loaded(shaper: &Shaper<'_>, operator: &ContactOperator<'_>) -> ContactLoad {
    let mut load = shaper.stage.contact_load(operator.points());
    shaper.add_feed(&mut load);
    load
}

fn solve(shaper: &Shaper<'_>, operator: &ContactOperator<'_>, gap: &[f64]) -> Result<ContactSolution, Fault> {
    operator.solve(gap, &loaded(shaper, operator), None).map_err(unsolved)
}
