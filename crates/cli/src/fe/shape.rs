//! The shape stage: levels of rising degree until the gap is accurate enough.

use std::time::Instant;

use contact::{ContactPoint, Pair, Side};
use hpfem::Body;
use nalgebra::Vector3;
use shapeopt::{Gauge, RigidPart, Shape, ShapeProblem, SurfacePlace, closing, solve_shape};

use crate::fault::Fault;
use crate::fe::bodies::{BodyParts, Level, MEAN_COLUMNS, kinematics};
use crate::fe::template::{Extent, meshes};
use crate::profile::Profile;
use crate::scene::LoadKind;
use crate::setup::Problem;
use crate::solution::{EnergyResult, ErrorResult, Reaction, ShapeResult, Solution, Status};
use crate::solve::Options;
use crate::surface::Patch;

/// Samples of the gap for the comparison of levels.
const SAMPLES: usize = 201;
/// First and last degree of the ladder, and its step.
const DEGREES: [usize; 3] = [4, 16, 2];

/// What the shape stage needs besides the scene.
struct Stage<'a> {
    problem: &'a Problem,
    patch: &'a Patch,
    optimum: &'a wear::Optimum,
    extent: Extent,
}

/// One solved level.
struct Solved {
    gaps: Vec<f64>,
    solution: Solution,
}

/// Solves for the shape and fills in the solution.
pub(super) fn solve(problem: &Problem, options: Options, solution: &mut Solution) -> Result<(), Fault> {
    let Some(patch) = &problem.patch else { return Err(no_surface()) };
    let Some(extent) = Extent::of(patch.surface.shape()) else { return Err(no_surface()) };
    let wear = crate::solve::pressure::wear_problem(&problem.scene, patch, &problem.freedoms)
        .map_err(|error| Fault::at("wear", "wrong-value", error.to_string(), "mend the numbers in the message"))?;
    let optimum = match wear::optimal_pressure(&wear) {
        Ok(optimum) => optimum,
        Err(error) => {
            solution.status = Status::Refused;
            solution.reason = Some(error.to_string());
            return Ok(());
        }
    };
    let stage = Stage { problem, patch, optimum: &optimum, extent };
    let mesh = problem.scene.mesh.clone().unwrap_or_default();
    let fixed = mesh.degree.or(mesh.layers).map(|_| {
        let degree = mesh.degree.unwrap_or(8);
        Level { degree, layers: mesh.layers.unwrap_or(degree.saturating_sub(2).max(1)) }
    });
    let accuracy = problem.scene.accuracy.unwrap_or(1e-6);
    let mut solved: Vec<Solved> = Vec::new();
    for level in ladder(fixed) {
        solved.push(stage.level(level, options)?);
        let enough = fixed.is_none() && estimate(&solved).is_some_and(|error| error <= accuracy);
        if enough {
            break;
        }
    }
    finish(solved, fixed.is_some(), accuracy, solution);
    Ok(())
}

fn no_surface() -> Fault {
    let message = "this contact surface has no shape task yet";
    Fault::at("tasks", "not-available", message, "ask for the pressure alone: --set tasks=[pressure]")
}

/// The levels to solve: up to a fixed one, or until the caller has enough.
fn ladder(fixed: Option<Level>) -> Vec<Level> {
    let [first, last, step] = DEGREES;
    match fixed {
        None => (first..=last).step_by(step).map(|degree| Level { degree, layers: degree - 2 }).collect(),
        Some(level) => [4, 2, 0]
            .iter()
            .filter(|down| level.degree > **down)
            .map(|down| Level { degree: level.degree - down, layers: level.layers })
            .collect(),
    }
}

/// Estimated `max |dg| / max g` of the last level: the differences of three successive degrees fall like a geometric series,
/// whose rest is `d ratio / (1 - ratio)`.
fn estimate(solved: &[Solved]) -> Option<f64> {
    let difference = |a: &Solved, b: &Solved| {
        let largest = b.gaps.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        a.gaps.iter().zip(&b.gaps).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max) / largest
    };
    let [.., a, b, c] = solved else { return None };
    let (older, newer) = (difference(a, b), difference(b, c));
    let ratio = (newer / older).clamp(0.0, 0.9);
    Some((newer * ratio / (1.0 - ratio)).max(1e-13))
}

/// Takes over the last level with the error estimate and the effort of all.
fn finish(mut solved: Vec<Solved>, fixed: bool, accuracy: f64, solution: &mut Solution) {
    let error = estimate(&solved);
    let levels = solved.len();
    let effort: Vec<Vec<(String, f64)>> = solved.iter().map(|s| s.solution.times.clone()).collect();
    let factorisations: usize = solved.iter().map(|s| s.solution.counters.factorisations).sum();
    let Some(last) = solved.pop() else { return };
    let last = last.solution;
    for stage in ["mesh", "assemble", "factor", "interface", "shape"] {
        let total = effort.iter().flatten().filter(|(name, _)| name == stage).map(|(_, seconds)| seconds).sum();
        solution.times.push((stage.to_string(), total));
    }
    solution.shape = last.shape;
    solution.energy = last.energy;
    solution.reactions = last.reactions;
    solution.profile = last.profile;
    solution.curve = last.curve;
    solution.counters = last.counters;
    solution.counters.factorisations = factorisations;
    let mut result = solution.error.clone().unwrap_or_default();
    result.gap_relative = error;
    result.how = format!("gap: {levels} degrees compared, the rest of the geometric series; {}", result.how);
    solution.error = Some(ErrorResult { ..result });
    if let (false, Some(error)) = (fixed, error)
        && error > accuracy
    {
        solution.status = Status::AccuracyMissed;
        solution.reason = Some(format!("the gap is accurate to {error:.1e}, not to the {accuracy:.0e} asked for"));
    }
}

impl Stage<'_> {
    /// Solves one level.
    fn level(&self, level: Level, options: Options) -> Result<Solved, Fault> {
        let scene = &self.problem.scene;
        let mut solution = Solution::default();
        let start = Instant::now();
        let [mesh1, mesh2] = meshes(scene, self.extent, level.layers)?;
        let kinematics = kinematics(scene);
        let parts = [
            BodyParts::new(scene, true, mesh1, level, kinematics)?,
            BodyParts::new(scene, false, mesh2, level, kinematics)?,
        ];
        note(&mut solution, "mesh", start);
        let bodies = [parts[0].reduce("body1")?, parts[1].reduce("body2")?];
        effort(&mut solution, &bodies);
        let start = Instant::now();
        let pair = Pair::new(&bodies[0].interface, Some(&bodies[1].interface)).map_err(|error| {
            Fault::at("contact.edges", "no-contact", error.to_string(), "give both bodies the same contact surface")
        })?;
        note(&mut solution, "interface", start);
        let start = Instant::now();
        let shape = self.shape(&pair)?;
        note(&mut solution, "shape", start);
        let length = bodies[0].interface.trace.length();
        let arcs: Vec<f64> = (0..SAMPLES).map(|i| length * i as f64 / (SAMPLES - 1) as f64).collect();
        let gaps: Vec<f64> = arcs.iter().map(|arc| shape.gap(&pair, &pair.at_arc(*arc))).collect();
        solution.shape = Some(self.result(&pair, &shape, &arcs, &gaps));
        solution.energy = Some(EnergyResult {
            body1_Nmm: Some(pair.shaped.strain_energy(&shape.shaped)),
            body2_Nmm: pair.counter.zip(shape.counter.as_ref()).map(|(body, state)| body.strain_energy(state)),
        });
        solution.reactions = reactions(&parts, &bodies, &shape);
        let points = match options.sample {
            Some(count) => sample(&pair, kinematics, count),
            None => pair.points(),
        };
        solution.profile = Some(self.profile(&pair, &shape, &points));
        solution.curve = Some(self.profile(&pair, &shape, &sample(&pair, kinematics, 401)));
        Ok(Solved { gaps, solution })
    }

    /// Pressure and shear along the tangent at a place.
    fn traction(&self, place: &SurfacePlace) -> [f64; 2] {
        let point = self.surface_point(place.position, place.normal, 0.0);
        let pressure = self.optimum.pressure_at(&point);
        let tangent = Vector3::new(place.normal[1], 0.0, -place.normal[0]);
        [pressure, self.friction() * pressure * point.drag.dot(&tangent)]
    }

    fn friction(&self) -> f64 {
        let contact = self.problem.scene.contact.as_ref();
        let shear = contact.and_then(|c| c.shear).unwrap_or(true);
        if shear { contact.and_then(|c| c.friction).unwrap_or(0.0) } else { 0.0 }
    }

    fn surface_point(&self, x: [f64; 2], n: [f64; 2], weight: f64) -> wear::SurfacePoint {
        self.patch.surface.point(Vector3::new(x[0], 0.0, x[1]), Vector3::new(n[0], 0.0, n[1]), weight)
    }

    fn shape(&self, pair: &Pair<'_>) -> Result<Shape, Fault> {
        let load = self.problem.scene.load.as_ref();
        let rigid_edge = load.is_some_and(|load| load.kind == Some(LoadKind::Rigid));
        let cases = if rigid_edge { vec![] } else { vec![1.0, 0.0, 0.0, 0.0] };
        let gauge = if rigid_edge { Gauge::HeldEdge } else { Gauge::MeanOf(mean_columns(pair)) };
        let steep = self.optimum.k.map_or(0.0, f64::abs);
        solve_shape(&ShapeProblem {
            pair: *pair,
            traction: &|place| self.traction(place),
            cases_shaped: &cases,
            cases_counter: &[],
            gauge,
            rigid: RigidPart::Smallest,
            extra_points: 4 + (2.0 * steep).min(60.0) as usize,
        })
        .map_err(|error| Fault::at("load", "no-closing", error.to_string(), "press body 1 on body 2"))
    }

    fn result(&self, pair: &Pair<'_>, shape: &Shape, arcs: &[f64], gaps: &[f64]) -> ShapeResult {
        let most = (0..gaps.len()).max_by(|a, b| gaps[*a].total_cmp(&gaps[*b])).unwrap_or(0);
        let start = surface_start(pair, self.patch);
        ShapeResult {
            iterations: 1,
            gap_max_um: Some(1e3 * gaps[most]),
            gap_where_mm: Some(start + arcs[most]),
            crown_um: Some(1e3 * (gaps[most] - gaps.iter().copied().fold(f64::INFINITY, f64::min))),
            rigid_mm: shape.rigid.first().copied(),
            roundtrip_same: None,
            roundtrip_independent: None,
        }
    }

    fn profile(&self, pair: &Pair<'_>, shape: &Shape, points: &[ContactPoint]) -> Profile {
        let start = surface_start(pair, self.patch);
        let surface: Vec<wear::SurfacePoint> =
            points.iter().map(|p| self.surface_point(p.position, p.normal, p.weight)).collect();
        let mut profile = Profile::new(points.iter().map(|p| start + p.arc).collect(), &surface);
        let laws = crate::solve::pressure::wear_pair(&self.problem.scene, self.wear_friction());
        for (row, (point, on_surface)) in points.iter().zip(&surface).enumerate() {
            let pressure = self.optimum.pressure_at(on_surface);
            profile.pressure[row] = pressure;
            profile.shear[row] = self.friction() * pressure;
            profile.gap[row] = 1e3 * shape.gap(pair, point);
            profile.opening[row] = 0.0;
            if let Ok(pair) = &laws {
                let worn = (0..2).filter(|body| pair.wears(*body));
                let rate: f64 =
                    worn.map(|body| wear::wear_rate(&pair.laws[body], pressure, on_surface.sliding_speed)).sum();
                profile.wear_rate[row] = 1e3 * rate;
            }
            let tangent = Vector3::new(point.tangent[0], 0.0, point.tangent[1]);
            let along = on_surface.drag.dot(&tangent);
            // Without sliding in the plane tau is the tangent itself.
            let sense = if along == 0.0 { 1.0 } else { along.signum() };
            for (body, side) in [Side::Shaped, Side::Counter].into_iter().enumerate() {
                let [normal, tangential] = shape.displacement(pair, side, point);
                profile.normal_displacement[body][row] = 1e3 * normal;
                profile.tangential_displacement[body][row] = 1e3 * sense * tangential;
            }
            profile.status[row] = if pressure > 0.0 { "contact" } else { "open" };
        }
        profile
    }

    fn wear_friction(&self) -> f64 {
        self.problem.scene.contact.as_ref().and_then(|c| c.friction).unwrap_or(0.0)
    }
}

/// Columns of the mean displacement functionals that fix the free rigid modes, one a mode, each in turn the one of z, x,
/// rotation that still moves.
fn mean_columns(pair: &Pair<'_>) -> Vec<usize> {
    let body = pair.shaped;
    let [x, z, rotation] = MEAN_COLUMNS;
    let modes = body.rigid_motions.len();
    match modes {
        0 => Vec::new(),
        1 => {
            let [tx, tz, _] = body.rigid_motions[0];
            vec![if tz != 0.0 { z } else if tx != 0.0 { x } else { rotation }]
        }
        2 if body.rigid_motions.iter().all(|m| m[2] == 0.0) => vec![x, z],
        2 if body.rigid_motions.iter().any(|m| m[1] != 0.0 && m[2] == 0.0) => vec![z, rotation],
        2 => vec![x, rotation],
        _ => vec![x, z, rotation],
    }
}

/// Surface coordinate at the start of the path: minus half the length, or the radius there.
pub(super) fn surface_start(pair: &Pair<'_>, patch: &Patch) -> f64 {
    let trace = &pair.shaped.trace;
    match patch.surface.shape() {
        wear::Shape::Annulus { .. } => trace.boundary_point(0, -1.0).0.position[0],
        _ => -0.5 * trace.length(),
    }
}

/// Evenly spaced points of the path with trapezoid weights.
pub(super) fn sample(pair: &Pair<'_>, kinematics: hpfem::Kinematics, count: usize) -> Vec<ContactPoint> {
    let length = pair.shaped.trace.length();
    let last = count.max(2) - 1;
    (0..=last)
        .map(|i| {
            let mut point = pair.at_arc(length * i as f64 / last as f64);
            let share = if i == 0 || i == last { 0.5 } else { 1.0 };
            point.weight = share * length / last as f64 * kinematics.measure(point.position[0]);
            point
        })
        .collect()
}

/// Closing velocities are what the rigid part multiplies; exposed for the summary's single free translation.
#[allow(dead_code)]
fn closing_of(pair: &Pair<'_>, point: &ContactPoint) -> Vec<f64> {
    closing(pair, point)
}

fn note(solution: &mut Solution, stage: &str, start: Instant) {
    solution.times.push((stage.to_string(), start.elapsed().as_secs_f64()));
}

/// Counters and times of the reduction.
fn effort(solution: &mut Solution, bodies: &[Body<'_>; 2]) {
    let total = |f: &dyn Fn(&Body<'_>) -> f64| bodies.iter().map(f).sum::<f64>();
    solution.times.push(("assemble".into(), total(&|b| b.effort.assemble.as_secs_f64())));
    solution.times.push(("factor".into(), total(&|b| b.effort.factor.as_secs_f64())));
    solution.counters.cells = bodies.iter().map(|b| b.effort.cells).sum();
    solution.counters.dofs = bodies.iter().map(|b| b.effort.unknowns).sum();
    solution.counters.trace_dofs = bodies.iter().map(|b| b.interface.stiffness.nrows()).sum();
    solution.counters.factorisations = bodies.len();
}

/// Forces of the supports on their bodies.
fn reactions(parts: &[BodyParts; 2], bodies: &[Body<'_>; 2], shape: &Shape) -> Vec<(String, Reaction)> {
    let mut reactions: Vec<(String, Reaction)> = Vec::new();
    let states = [Some(&shape.shaped), shape.counter.as_ref()];
    for ((part, body), state) in parts.iter().zip(bodies).zip(states) {
        let Some(state) = state else { continue };
        for (number, name) in part.support_names.iter().enumerate().filter(|(_, name)| !name.is_empty()) {
            let [x, z, moment] = body.interface.reaction(number, state);
            match reactions.iter_mut().find(|(known, _)| known == name) {
                Some((_, sum)) => {
                    sum.x_N = sum.x_N.map(|v| v + x);
                    sum.z_N = sum.z_N.map(|v| v + z);
                    sum.moment_Nmm = sum.moment_Nmm.map(|v| v + moment);
                }
                None => {
                    let new = Reaction { x_N: Some(x), z_N: Some(z), moment_Nmm: Some(moment) };
                    reactions.push((name.clone(), new));
                }
            }
        }
    }
    reactions
}
