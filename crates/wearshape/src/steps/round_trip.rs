//! The proof of a shape: a full Signorini-Coulomb solve on it must give the wanted pressure back.

use contact::{ContactLoad, ContactOperator, ContactSolution};
use meshing::Cut;
use scene::Fault;
use shapeopt::{GapCurve, Shape, SurfacePlace};

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::faults::unsolved;
use crate::heat::Heat;
use crate::level::Level;
use crate::results::InterfaceResult;
use crate::step::Step;
use crate::steps::answer::Told;
use crate::steps::diagnosis;
use crate::steps::heat::bodies::{Asked, HotBodies};
use crate::steps::heat::following::Following;
use crate::steps::heat::smooth::Smooth;
use crate::steps::heat::warmed::Surfaces;
use crate::steps::hot_shape::{contact_load, wanted_heat};
use crate::steps::shaper::Shaper;

/// Relative area-weighted L2 difference of two pressures.
fn difference(weights: &[f64], found: &[f64], wanted: &[f64]) -> f64 {
    let sum = |f: &dyn Fn(usize) -> f64| (0..weights.len()).map(|i| weights[i] * f(i)).sum::<f64>();
    (sum(&|i| (found[i] - wanted[i]).powi(2)) / sum(&|i| wanted[i].powi(2))).sqrt()
}

/// Wanted pressure at the points of an operator, and its points' weights.
fn wanted(shaper: &Shaper<'_>, operator: &ContactOperator<'_>) -> (Vec<f64>, Vec<f64>) {
    let points = operator.points();
    points.iter().map(|p| (p.weight, shaper.pressure(&SurfacePlace::from(p), Some(operator.pair())))).unzip()
}

/// Round trip on the very operators the shape was found on: a test of the contact solver. With it the condition of its system.
pub(crate) fn same(
    shaper: &Shaper<'_>,
    following: Option<&Following<'_>>,
    reduced: &Reduced,
    shape: &Shape,
) -> Result<Same, Fault> {
    let cold = reduced.pair()?;
    let reduced = following.map_or(reduced, |following| &*following.reduced);
    let pair = reduced.pair()?;
    let operator = reduced.operator(&pair, shaper.stage.friction() > 0.0)?;
    let gap: Vec<f64> = operator.points().iter().map(|p| shape.gap(&cold, p)).collect();
    let Found { found, load } = solve(shaper, &operator, &gap, following)?;
    let interface = diagnosis::interface(&operator, &gap, &load, &found)?;
    let (weights, wanted) = wanted(shaper, &operator);
    Ok(Same { miss: difference(&weights, &found.pressure, &wanted), interface })
}

/// What a round trip on the same operators tells.
pub(crate) struct Same {
    /// Relative difference of the pressure found from the wanted one.
    pub miss: f64,
    pub interface: Option<InterfaceResult>,
}

/// What a round trip on an independent discretisation tells.
pub(crate) struct Independent {
    /// Relative difference of the pressure found from the wanted one.
    pub miss: f64,
    pub effort: Effort,
}

/// Round trip on an independent discretisation: two degrees more, other break points, the gap as a function of the arc length.
/// Also writes the pressure found into the columns that are told, interpolated between the new points.
pub(crate) fn independent(shaper: &Shaper<'_>, level: Level, shape: &GapCurve, told: &mut Told) -> Result<Independent, Fault> {
    let finer = Level { degree: (level.degree + 2).min(hpfem::MAX_DEGREE), ..level };
    // The pressure is known before, but for what the proof is to find.
    let wanted_heat = |surfaces: &Surfaces, heat: &Heat| wanted_heat(shaper, surfaces, heat);
    let (following, reduced, effort) =
        match HotBodies::new(shaper.stage, finer, (Cut::Shifted, Asked::Near(&wanted_heat, Smooth::Little)))? {
            Some((bodies, mut effort)) => {
                let near = |_: &mut Effort| Following::as_asked(&bodies, Smooth::Little);
                (effort.timed(Step::Heat, shaper.stage.clock(), near)?, None, effort)
            }
            None => {
                let (reduced, effort) = shaper.stage.reduced(finer, Cut::Shifted)?;
                (None, Some(reduced), effort)
            }
        };
    let hot = following.as_ref().map(|following| &*following.reduced);
    let Some(reduced) = hot.or(reduced.as_deref()) else { unreachable!("bodies are hot or cold") };
    let pair = reduced.pair()?;
    let operator = reduced.operator(&pair, shaper.stage.friction() > 0.0)?;
    let gap: Vec<f64> = operator.points().iter().map(|p| shape.at(p.arc)).collect();
    let Found { found, .. } = solve(shaper, &operator, &gap, following.as_ref())?;
    let (weights, wanted) = wanted(shaper, &operator);
    let (start, length) = (shaper.stage.start(&pair), pair.trace().length());
    for profile in [&mut told.profile, &mut told.curve] {
        profile.pressure_solved =
            profile.s.iter().map(|s| operator.pressure_at(&found.pressure, (s - start).clamp(0.0, length))).collect();
    }
    Ok(Independent { miss: difference(&weights, &found.pressure, &wanted), effort })
}

/// A contact found on a shape.
struct Found {
    found: ContactSolution,
    load: ContactLoad,
}

fn solve(
    shaper: &Shaper<'_>,
    operator: &ContactOperator<'_>,
    gap: &[f64],
    following: Option<&Following<'_>>,
) -> Result<Found, Fault> {
    let load = contact_load(shaper, operator.points());
    let Some(following) = following else {
        let found = operator.solve(gap, &load, None).map_err(unsolved)?;
        return Ok(Found { found, load });
    };
    let hot = following.solve(operator, gap, &load)?;
    Ok(Found { found: hot.found, load: hot.load })
}
