//! The limit s -> 1: the pressure concentrates in points or lines.
//!
//! s -> 1 from above: the linear programme min int g dm under int psi_k dm = F_k, m >= 0; from below the same with max. With one mode
//! the force sits where phi/g is largest (above) or smallest (below).

use nalgebra::Vector3;

use crate::pressure_law::PressureLaw;
use crate::simplex::{Column, minimise};
use crate::stage::Stage;
use crate::why::BEYOND_THE_EDGE;
use crate::{Modes, PointForce, Problem, SurfacePoint, WearError};

/// From which side s approaches 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitSide {
    /// s -> 1+: the limit of minimisers.
    Above,
    /// s -> 1-: the limit of maximisers.
    Below,
}

/// Concentrated forces: where, and how much normal force (N).
pub(crate) type Atoms = Vec<(SurfacePoint, f64)>;

/// A grid point with its parameters, so that it can be refined.
type Place = ([f64; 2], SurfacePoint);

/// Forces that the stationary pressures approach as s -> 1 from one side, for the cost g = v^speed_power of the functional
/// (a/b for wear volume, 1 for friction power, a/(b+1) for wear power).
///
/// # Errors
/// Those of [`optimal_pressure`](crate::optimal_pressure): [`WearError::Infeasible`] for a load that no forces carry,
/// [`WearError::MixedExponents`] for several kinematic modes with friction on a curved surface.
pub fn singular_limit(problem: &Problem, speed_power: f64, side: LimitSide) -> Result<Vec<PointForce>, WearError> {
    problem.check()?;
    let stage = Stage::new(problem, crate::density::Density::BangBang { speed_power })?;
    let atoms = limit(&stage, speed_power, side)?;
    Ok(atoms.iter().map(|(point, force)| PointForce { position: point.position, force: *force }).collect())
}

/// The limit of the stationary pressures as s -> 1.
pub(crate) fn limit(stage: &Stage<'_>, speed_power: f64, side: LimitSide) -> Result<Atoms, WearError> {
    let law = &stage.law;
    let sign = if side == LimitSide::Above { 1.0 } else { -1.0 };
    let cost = |point: &SurfacePoint| sign * cost(law, speed_power, point);
    let places = grid(stage, None, 1.0);
    if law.count == 1 { one_mode(stage, places, &cost) } else { several_modes(stage, places, &cost) }
}

fn infeasible(stage: &Stage<'_>) -> WearError {
    stage.infeasible(BEYOND_THE_EDGE)
}

/// The places of the smallest cost / phi, with ties shared equally.
fn one_mode(stage: &Stage<'_>, mut places: Vec<Place>, cost: &dyn Fn(&SurfacePoint) -> f64) -> Result<Atoms, WearError> {
    let law = &stage.law;
    let value = |place: &Place| {
        let phi = law.mode_values(&place.1).phi[0];
        if phi > 0.0 { cost(&place.1) / phi } else { f64::INFINITY }
    };
    let by_value = |a: &Place, b: &Place| value(a).total_cmp(&value(b));
    let mut reach = 1.0;
    for _ in 0..18 {
        let best = places.iter().map(value).fold(f64::INFINITY, f64::min);
        let tie = if reach == 1.0 { 1e-3 } else { 1e-12 } * best.abs();
        let mut near: Vec<Place> = places.iter().filter(|place| value(place) <= best + tie).copied().collect();
        if reach < 1e-9 {
            break;
        }
        reach *= 0.25;
        near.sort_by(by_value);
        near.dedup_by(|a, b| a.0 == b.0);
        let mut next: Vec<Place> = Vec::new();
        for place in near.iter().take(40) {
            next.extend(grid(stage, Some(place.0), reach));
            next.push(*place);
        }
        places = next;
    }
    let best = places.iter().map(value).fold(f64::INFINITY, f64::min);
    places.sort_by(by_value);
    let mut chosen: Vec<SurfacePoint> = Vec::new();
    let size = extent(stage);
    for place in places.iter().filter(|place| value(place) <= best + 1e-11 * best.abs()) {
        if chosen.iter().all(|other| (other.position - place.1.position).norm() > 1e-3 * size) {
            chosen.push(place.1);
        }
    }
    let carried: f64 = chosen.iter().map(|point| law.mode_values(point).psi[0]).sum();
    let force = law.resultant(0) / carried;
    if !(force > 0.0 && force.is_finite()) {
        return Err(infeasible(stage));
    }
    Ok(chosen.into_iter().map(|point| (point, force)).collect())
}

/// The optimal vertex of the linear programme, its places refined.
fn several_modes(stage: &Stage<'_>, mut places: Vec<Place>, cost: &dyn Fn(&SurfacePoint) -> f64) -> Result<Atoms, WearError> {
    let law = &stage.law;
    let friction_bends = places.iter().any(|place| {
        let values = law.mode_values(&place.1);
        (0..law.count).any(|k| (values.phi[k] - values.psi[k]).abs() > 1e-12)
    });
    if friction_bends && stage.problem.mode_kind == Modes::Kinematic {
        let why = "s = 1 with several kinematic modes and friction on a curved surface; use associated modes";
        return Err(WearError::MixedExponents { s1: 1.0, s2: 1.0, why });
    }
    let target: Vec<f64> = (0..law.count).map(|k| law.resultant(k)).collect();
    let vertex = |places: &[Place]| solve(law, places, &target, cost).ok_or_else(|| infeasible(stage));
    let mut reach = 1.0;
    let mut atoms = vertex(&places)?;
    for _ in 0..20 {
        reach *= 0.25;
        let mut next: Vec<Place> = Vec::new();
        for (index, _) in &atoms {
            next.push(places[*index]);
            next.extend(grid(stage, Some(places[*index].0), reach));
        }
        places = next;
        atoms = vertex(&places)?;
    }
    let largest = atoms.iter().map(|atom| atom.1).fold(0.0, f64::max);
    Ok(atoms.iter().filter(|atom| atom.1 > 1e-12 * largest).map(|(i, m)| (places[*i].1, *m)).collect())
}

/// True when some pressure p >= 0 carries the load: the load lies inside the cone of point forces, not on its border, which is tested
/// by taking away a billionth of a uniform pressure.
pub(crate) fn carries(stage: &Stage<'_>) -> bool {
    let law = &stage.law;
    let mut places = grid(stage, None, 1.0);
    places.extend(border(stage));
    let mean = |k: usize| places.iter().map(|place| law.mode_values(&place.1).psi[k]).sum::<f64>();
    let factor = 1e-9 * law.resultant(law.pivot) / mean(law.pivot);
    let target: Vec<f64> = (0..law.count).map(|k| law.resultant(k) - factor * mean(k)).collect();
    solve(law, &places, &target, &|_| 1.0).is_some()
}

fn solve(law: &PressureLaw, places: &[Place], target: &[f64], cost: &dyn Fn(&SurfacePoint) -> f64) -> Option<Vec<(usize, f64)>> {
    let columns: Vec<Column> =
        places.iter().map(|place| Column { cost: cost(&place.1), weight: law.mode_values(&place.1).psi }).collect();
    minimise(&columns, target)
}

fn cost(law: &PressureLaw, speed_power: f64, point: &SurfacePoint) -> f64 {
    if speed_power == 0.0 { 1.0 } else { (point.sliding_speed / law.reference_speed).powf(speed_power) }
}

fn extent(stage: &Stage<'_>) -> f64 {
    let (mut lo, mut hi) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
    stage.problem.surface.survey(&mut |point| {
        lo = lo.inf(&point.position);
        hi = hi.sup(&point.position);
    });
    (hi - lo).norm()
}

/// Points of the border of a surface with two parameters, dense so that a load just inside a curved border is told from one outside.
fn border(stage: &Stage<'_>) -> Vec<Place> {
    const COUNT: usize = 512;
    let surface = &stage.problem.surface;
    let (inner, Some(outer)) = (surface.inner_range(), surface.outer_range()) else { return Vec::new() };
    let place = |range: [f64; 2], i: usize| range[0] + (range[1] - range[0]) * i as f64 / COUNT as f64;
    let sides = |i: usize| {
        let (u, v) = (place(inner, i), place(outer, i));
        [[inner[0], v], [inner[1], v], [u, outer[0]], [u, outer[1]]]
    };
    (0..=COUNT).flat_map(sides).map(|at| (at, surface.at(at[0], at[1]))).collect()
}

/// Points of the surface around given parameters within `reach` of the whole range (the whole surface without a centre).
fn grid(stage: &Stage<'_>, centre: Option<[f64; 2]>, reach: f64) -> Vec<Place> {
    let surface = &stage.problem.surface;
    if let crate::Shape::Points(points) = surface.shape() {
        return points.iter().map(|point| ([0.0, 0.0], *point)).collect();
    }
    let inner = surface.inner_range();
    let outer = surface.outer_range();
    let count = match (centre, outer) {
        (None, None) => 256,
        (None, Some(_)) => 48,
        _ => 8,
    };
    let window = |range: [f64; 2], at: Option<f64>| match at {
        None => range,
        Some(at) => {
            let half = 0.125 * reach * (range[1] - range[0]);
            [(at - half).max(range[0]), (at + half).min(range[1])]
        }
    };
    let u = window(inner, centre.map(|c| c[0]));
    let v = outer.map(|range| window(range, centre.map(|c| c[1])));
    let mut places = Vec::new();
    let place = |range: [f64; 2], i: usize| {
        if i == count { range[1] } else { range[0] + (range[1] - range[0]) * i as f64 / count as f64 }
    };
    for j in 0..=(if v.is_some() { count } else { 0 }) {
        let outer = v.map_or(0.0, |range| place(range, j));
        for i in 0..=count {
            let inner = place(u, i);
            places.push(([inner, outer], surface.at(inner, outer)));
        }
    }
    places
}
