//! How exactly a shape has to be made: what small errors of it do to the pressure, and how soon wear removes them.

use contact::maximum;
use scene::Fault;
use shapeopt::{SurfacePlace, WearProblem, tolerances};

use crate::bodies::Reduced;
use crate::results::ToleranceResult;
use crate::steps::heat::following::Following;
use crate::steps::shaper::Shaper;

/// Amplitude of the errors, mm.
const AMPLITUDE: f64 = 1e-3;
/// Part of the mean pressure that a change may reach.
const ALLOWED: f64 = 0.1;
/// Part of the surface at either end where no change counts.
const INNER: f64 = 0.025;
/// Change below which an error counts as one of the free rigid motions, relative to the largest of all.
const RIGID: f64 = 1e-6;

/// Effects of the errors on the shape of a level, those that free rigid motions take up left out. Empty if a part of the surface is open. Where there is
/// heat that follows the pressure, `reduced` are the bodies bent by it, and a change of the pressure changes it too.
pub(crate) fn of(shaper: &Shaper<'_>, reduced: &Reduced, heat: Option<&Following<'_>>) -> Result<Vec<ToleranceResult>, Fault> {
    let stage = shaper.stage;
    let pair = reduced.pair()?;
    let operator = reduced.operator(&pair, stage.friction() > 0.0)?;
    let points = operator.points();
    let pressure: Vec<f64> = points.iter().map(|p| shaper.pressure(&SurfacePlace::from(p), Some(&pair))).collect();
    if pressure.iter().any(|p| *p <= 0.0) {
        return Ok(Vec::new());
    }
    let load = match heat {
        Some(following) => following.all_closed(&stage.contact_load(points))?,
        None => stage.contact_load(points),
    };
    let Ok(system) = operator.system(&load) else { return Ok(Vec::new()) };
    let (laws, counterface) = stage.rules()?;
    let surface: Vec<wear::SurfacePoint> = points.iter().map(|p| stage.surface_point(p.position, p.normal, p.weight)).collect();
    let gap = vec![0.0; points.len()];
    let mut problem = WearProblem::new(surface, laws, counterface, gap, system);
    problem.track_area = stage.patch.surface.track_area();
    let length = pair.trace().length();
    let errors: Vec<(String, Vec<f64>)> = shapes()
        .into_iter()
        .map(|(name, shape)| (name, points.iter().map(|p| AMPLITUDE * shape(p.arc / length)).collect()))
        .collect();
    let gaps: Vec<Vec<f64>> = errors.iter().map(|(_, gap)| gap.clone()).collect();
    let Some(found) = tolerances(&problem, &pressure, &gaps) else { return Ok(Vec::new()) };
    let area: f64 = points.iter().map(|p| p.weight).sum();
    let mean = points.iter().zip(&pressure).map(|(p, v)| p.weight * v).sum::<f64>() / area;
    // The ends of contact are sharp: there the change of the pressure may be infinite.
    let [from, to] = [INNER, 1.0 - INNER].map(|t| t * length);
    let inside = points.iter().map(|p| p.arc).filter(|arc| *arc > from && *arc < to);
    let arcs: Vec<f64> = std::iter::once(from).chain(inside).chain([to]).collect();
    let results: Vec<ToleranceResult> = errors
        .iter()
        .zip(&found)
        .map(|((name, _), effect)| {
            let pairs = || points.iter().zip(&effect.change);
            let change = |arc: f64| operator.value_at(&effect.change, arc).abs();
            let most = maximum(&arcs, &arcs.iter().map(|arc| change(*arc)).collect::<Vec<_>>(), &change)[1] / mean;
            let square = pairs().map(|(p, c)| p.weight * c * c).sum::<f64>() / area;
            ToleranceResult {
                error: name.clone(),
                amplitude: 1e3 * AMPLITUDE,
                pressure_change_relative: most,
                pressure_change_rms: square.sqrt() / mean,
                within_10_percent: 1e3 * AMPLITUDE * ALLOWED / most,
                run_in_distance: effect.run_in_distance,
            }
        })
        .collect();
    let largest = results.iter().map(|r| r.pressure_change_relative).fold(0.0, f64::max);
    Ok(results.into_iter().filter(|r| r.pressure_change_relative > RIGID * largest).collect())
}

/// An error of amplitude 1 over the surface coordinate from 0 to 1.
type ShapeOfError = Box<dyn Fn(f64) -> f64>;

/// The errors by name; L is the length of the surface.
fn shapes() -> Vec<(String, ShapeOfError)> {
    let mut all: Vec<(String, ShapeOfError)> = vec![
        ("offset".into(), Box::new(|_| 1.0)),
        ("tilt".into(), Box::new(|t| 2.0 * t - 1.0)),
        ("crown".into(), Box::new(|t| 1.0 - (2.0 * t - 1.0).powi(2))),
    ];
    for part in [1, 2, 4, 8] {
        let name = if part == 1 { "cosine, wavelength L".to_string() } else { format!("cosine, wavelength L/{part}") };
        all.push((name, Box::new(move |t| (std::f64::consts::TAU * f64::from(part) * t).cos())));
    }
    all.push(("random, wavelengths L/12 to L/4".into(), Box::new(random)));
    all
}

/// Waves of the lengths L/4 to L/12 with fixed phases that look like chance; amplitude 1 at most.
fn random(t: f64) -> f64 {
    let waves = 4..=12;
    let count = 9.0;
    // Multiples of the golden section, modulo one turn.
    let phase = |k: i32| std::f64::consts::TAU * (f64::from(k * k) * 0.618_033_988_749_895).fract();
    waves.map(|k| (std::f64::consts::TAU * f64::from(k) * t + phase(k)).cos()).sum::<f64>() / count
}
