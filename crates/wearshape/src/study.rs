//! Error against run time: a scene solved on rising degrees, each one alone, and compared with a truth.

use nalgebra::{DMatrix, Vector3};
use scene::Fault;
use shapeopt::{Measure, difference_of_gaps};

use crate::bodies::Bodies;
use crate::effort::Effort;
use crate::ladder::errors;
use crate::options::{CURVE, Options, Sampling, trapezoid_weights};
use crate::problem::Problem;
use crate::profile::Profile;
use crate::solution::{Solution, Status};
use crate::solve::solve;
use crate::step::Step;
use crate::watch::Watch;

/// Degrees of a study.
pub const DEGREES: [usize; 7] = [4, 6, 8, 10, 12, 14, 16];

/// What is compared: the result of the last task.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Quantity {
    /// The gap of the shape, or of the worn bodies at the end, the best rigid part removed from differences.
    Gap(Measure),
    /// The contact: the larger of the relative errors of the energy and of the pressure (L2 over the inner 95 % of the contact).
    Contact,
}

impl Quantity {
    /// Of a scene; `None` if it computes no elastic bodies.
    pub fn of(problem: &Problem) -> Option<Quantity> {
        if problem.plan.runs(Step::Evolution) {
            Some(Quantity::Gap(Measure::Largest))
        } else if problem.plan.runs(Step::Shape) {
            Some(Quantity::Gap(problem.measure()))
        } else {
            problem.plan.runs(Step::Contact).then_some(Quantity::Contact)
        }
    }

    /// Its definition in a sentence.
    pub fn description(self) -> &'static str {
        match self {
            Quantity::Gap(Measure::Largest) => "max |dg| / max g, rigid part removed",
            Quantity::Gap(Measure::Crown) => "max |dg| / (max g - min g), rigid part removed",
            Quantity::Contact => "larger of the relative errors of the energy and of the pressure (L2 over the inner 95 %)",
        }
    }
}

/// What levels are compared with: places, values there, and the ends of contact.
#[derive(Debug, Clone)]
pub struct Truth {
    /// Places along the surface (mm).
    pub s: Vec<f64>,
    /// Positions there (mm).
    pub position: Vec<[f64; 3]>,
    /// Unit normals out of body 2.
    pub normal: Vec<[f64; 3]>,
    /// Pressure there (MPa).
    pub pressure: Vec<f64>,
    /// Gap there (um).
    pub gap: Vec<f64>,
    /// Outermost ends of contact (mm).
    pub ends: [f64; 2],
    /// Strain energy of both bodies (N mm).
    pub energy: Option<f64>,
}

impl Truth {
    fn of(profile: &Profile, solution: &Solution) -> Truth {
        let known = solution.contact.as_ref().map(|contact| contact.ends.as_slice()).unwrap_or_default();
        Truth {
            s: profile.s.clone(),
            position: profile.position.clone(),
            normal: profile.normal.clone(),
            pressure: profile.pressure.clone(),
            gap: profile.gap.clone(),
            ends: outermost(known, &profile.s),
            energy: energy(solution),
        }
    }
}

/// The outermost of the ends of contact; without any, those of the surface.
pub fn outermost(ends: &[f64], s: &[f64]) -> [f64; 2] {
    let all = if ends.is_empty() { s } else { ends };
    [all.iter().copied().fold(f64::INFINITY, f64::min), all.iter().copied().fold(f64::NEG_INFINITY, f64::max)]
}

fn energy(solution: &Solution) -> Option<f64> {
    let energy = solution.energy.as_ref()?;
    Some(energy.body1? + energy.body2.unwrap_or(0.0))
}

/// One level of a study.
pub struct Level {
    /// Degree of the cells.
    pub degree: usize,
    /// Layers around each singular point.
    pub layers: usize,
    /// What it took.
    pub effort: Effort,
    /// Estimated error from this level and the two before it.
    pub estimate: Option<f64>,
    /// Difference from the truth; none for a level that is the truth.
    pub error: Option<f64>,
}

/// Why a study has no levels.
#[derive(Debug, Clone, PartialEq)]
pub enum Unstudied {
    /// Something is to be mended.
    Wrong(Fault),
    /// The scene has no answer on a level, or none was found.
    Unanswered {
        /// Degree of the level.
        degree: usize,
        /// How its solve ended.
        status: Status,
        /// Why.
        reason: String,
    },
    /// The watch has ended it.
    Interrupted,
}

impl From<Fault> for Unstudied {
    fn from(fault: Fault) -> Unstudied {
        Unstudied::Wrong(fault)
    }
}

struct Solved {
    degree: usize,
    layers: usize,
    effort: Effort,
    truth: Truth,
}

/// Solves a problem on every degree and compares each level with the truth: the one given, or the finest level. `at` is the problem on the
/// fixed discretisation of a degree, without the proof of its shape. Each degree is solved alone, at the places of the truth, whatever the options say
/// of that.
///
/// # Errors
/// Those of `at` and of [`solve`](crate::solve); a level without an answer, and one that was cut short.
pub fn study(
    at: &dyn Fn(usize) -> Result<Problem, Fault>,
    given: Option<Truth>,
    options: &Options<'_>,
    watch: &mut Watch<'_>,
) -> Result<Vec<Level>, Unstudied> {
    let finest = DEGREES[DEGREES.len() - 1];
    let of_level = |sampling| Options { sample: Some(sampling), alone: true, ..*options };
    let (truth, mut finest_level) = match given {
        Some(truth) => (truth, None),
        None => {
            let problem = at(finest)?;
            let level = solve_degree(&problem, finest, &of_level(CURVE), watch)?;
            (level.truth.clone(), Some((problem, level)))
        }
    };
    let own_truth = finest_level.is_some();
    let mut solved = Vec::new();
    let mut problem = None;
    for degree in DEGREES {
        let (of_degree, level) = match finest_level.take_if(|_| degree == finest) {
            Some(level) => level,
            None => {
                let problem = at(degree)?;
                let level = solve_degree(&problem, degree, &of_level(Sampling::At(&truth.s)), watch)?;
                (problem, level)
            }
        };
        problem = Some(of_degree);
        solved.push(level);
    }
    let Some(problem) = problem else { return Ok(Vec::new()) };
    let distance = |a: &Solved, b: &Solved| [difference(&problem, &a.truth, &b.truth)];
    let rows = solved.iter().enumerate().map(|(i, level)| Level {
        degree: level.degree,
        layers: level.layers,
        effort: level.effort.clone(),
        estimate: errors(&solved[..=i], &distance).map(|[error]| error),
        error: (!own_truth || level.degree < finest).then(|| difference(&problem, &level.truth, &truth)),
    });
    Ok(rows.collect())
}

fn solve_degree(problem: &Problem, degree: usize, options: &Options<'_>, watch: &mut Watch<'_>) -> Result<Solved, Unstudied> {
    let solution = solve(problem, options, &Bodies::default(), watch)?;
    let status = solution.status;
    if status == Status::Interrupted {
        return Err(Unstudied::Interrupted);
    }
    let Some(profile) = solution.profile.as_ref().filter(|_| status != Status::Refused) else {
        let reason = solution.reason.unwrap_or_else(|| "it has no curve".into());
        return Err(Unstudied::Unanswered { degree, status, reason });
    };
    let truth = Truth::of(profile, &solution);
    let layers = problem.wanted.fixed.map_or(degree, |level| level.layers);
    Ok(Solved { degree, layers, effort: solution.effort, truth })
}

/// Difference of a level from a truth at the same places.
fn difference(problem: &Problem, level: &Truth, truth: &Truth) -> f64 {
    match Quantity::of(problem) {
        Some(Quantity::Contact) => {
            let energy = level.energy.zip(truth.energy).map_or(0.0, |(x, y)| ((x - y) / y).abs());
            difference_of_pressures(level, truth).max(energy)
        }
        Some(Quantity::Gap(measure)) => difference_of_gaps(&level.gap, &truth.gap, &closing(problem, truth), measure),
        None => 0.0,
    }
}

/// Relative L2 difference of the pressures over the inner 95 % of the contact.
fn difference_of_pressures(level: &Truth, truth: &Truth) -> f64 {
    let [from, to] = truth.ends;
    let cut = 0.025 * (to - from);
    let inner = |s: f64| s >= from + cut && s <= to - cut;
    let weights = trapezoid_weights(&truth.s);
    let square = |f: &dyn Fn(usize) -> f64| {
        (0..truth.s.len()).filter(|i| inner(truth.s[*i])).map(|i| weights[i] * f(i).powi(2)).sum::<f64>()
    };
    (square(&|i| level.pressure[i] - truth.pressure[i]) / square(&|i| truth.pressure[i])).sqrt()
}

impl Problem {
    /// Closing velocities -n . u of the free rigid modes of body 1 at some positions (mm) with their normals out of body 2: one list a mode.
    pub fn closing(&self, position: &[[f64; 3]], normal: &[[f64; 3]]) -> Vec<Vec<f64>> {
        let point = |(position, normal): (&[f64; 3], &[f64; 3])| wear::SurfacePoint {
            position: Vector3::from(*position),
            normal: Vector3::from(*normal),
            weight: 0.0,
            sliding_speed: 0.0,
            drag: Vector3::zeros(),
        };
        let points: Vec<wear::SurfacePoint> = position.iter().zip(normal).map(point).collect();
        self.freedoms.iter().map(|freedom| points.iter().map(|point| freedom.mode.motion.closing(point)).collect()).collect()
    }
}

/// Closing velocities of the free rigid modes at the places of a truth, one column a mode.
fn closing(problem: &Problem, truth: &Truth) -> DMatrix<f64> {
    let modes = problem.closing(&truth.position, &truth.normal);
    DMatrix::from_fn(truth.s.len(), modes.len(), |row, k| modes[k][row])
}
