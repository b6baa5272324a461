//! The rigid freedoms of body 1: what its supports and its load leave free, with the prescribed resultants.

use meshing::{Body, Couple, LoadedEdge, outline};
use nalgebra::Vector3;
use scene::{Component, Fault, LoadKind, SurfaceShape};
use wear::{RigidMode, RigidMotion};

use crate::load::Load;
use crate::surface::Patch;

/// One free rigid mode.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Freedom {
    /// Which resultant it carries in the summary.
    pub role: Role,
    /// Motion and resultant.
    pub mode: RigidMode,
}

/// What a resultant is called.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Role {
    /// The pressing force.
    Force,
    /// The moment int x p dS, or that about a pin or pivot.
    Moment,
    /// The moment int y p dS.
    MomentY,
    /// The force along x.
    SideForce,
}

/// Refuses supports under which the load cannot press body 1 on body 2 or would turn it, under which friction drags it away (if it
/// `drags`), and under which body 2 gives way.
pub(crate) fn check(couple: &Couple, load: &Load, drags: bool) -> Result<(), Fault> {
    let body = &couple.bodies[0];
    let held = Held::of(body);
    holds_against(couple)?;
    if drags && !couple.is_revolved() && held.x.is_empty() && load.shear_force == 0.0 && held.may_turn(load) {
        let message = "body 1 can slide along x and turn, and friction drags it along";
        let remedy = "hold x on an edge, as in body1.support = { left = [\"x\"] }";
        return Err(Fault::at("body1.support", "not-held", message, remedy));
    }
    if !held.z.is_empty() {
        let message = "body 1 is held along z, so that the load cannot press it on body 2";
        return Err(Fault::at("body1.support", "held", message, "hold body 1 along x only"));
    }
    if !couple.is_revolved() && !couple.has_rigid_edge() && held.may_turn(load) { level(body, &couple.load) } else { Ok(()) }
}

/// The freedoms of body 1 on a known contact surface, the pressing first.
pub(crate) fn of_bodies(couple: &Couple, load: &Load, patch: &Patch) -> Vec<Freedom> {
    let body = &couple.bodies[0];
    let push = Freedom { role: Role::Force, mode: RigidMode::press_down(load.force.unwrap_or(0.0)) };
    if couple.is_revolved() {
        return vec![push];
    }
    let held = Held::of(body);
    let mut free = vec![push];
    if held.may_turn(load) {
        let mode = if couple.has_rigid_edge() {
            // The moment of the contact pressure alone is prescribed: about a point of the surface friction has none.
            RigidMode::tilt(load.moment, Vector3::new(load.about[0], 0.0, surface_height(patch)))
        } else {
            let (x, z) = load_centre(body, &couple.load);
            RigidMode::tilt(0.0, Vector3::new(x, 0.0, held.pole_height().unwrap_or(z)))
        };
        free.push(Freedom { role: Role::Moment, mode });
    }
    if held.x.is_empty() {
        let motion = RigidMotion::Translation { direction: Vector3::x() };
        free.push(Freedom { role: Role::SideForce, mode: RigidMode { motion, resultant: load.shear_force } });
    }
    free
}

/// Refuses supports under which body 2 can move.
fn holds_against(couple: &Couple) -> Result<(), Fault> {
    let body = &couple.bodies[1];
    let held = Held::of(body);
    let apart = |places: &[f64]| {
        let [least, most] = [places.iter().copied().fold(f64::MAX, f64::min), places.iter().copied().fold(f64::MIN, f64::max)];
        most - least > 1e-9 * least.abs().max(most.abs())
    };
    let mut free = Vec::new();
    if couple.is_revolved() {
        free.extend(held.z.is_empty().then_some("slide along z"));
    } else {
        free.extend(held.x.is_empty().then_some("slide along x"));
        free.extend(held.z.is_empty().then_some("slide along z"));
        // Two supports along different lines hold it: x at two heights, z at two places, or both together anywhere.
        let turns = !apart(&held.x) && !apart(&held.z);
        free.extend(turns.then_some("turn"));
    }
    if free.is_empty() {
        return Ok(());
    }
    let message = format!("body 2 can {}, so that nothing carries the load", free.join(" and "));
    let components = if couple.is_revolved() { "[\"z\"]" } else { "[\"x\", \"z\"]" };
    let remedy =
        format!("hold an edge of it that does not touch body 1, as in {}.support = {{ bottom = {components} }}", body.key);
    Err(Fault::at(format!("{}.support", body.key), "not-held", message, remedy))
}

fn surface_height(patch: &Patch) -> f64 {
    match patch.surface.shape() {
        wear::Shape::Strip { z, .. } => *z,
        wear::Shape::Points(_)
        | wear::Shape::Arc { .. }
        | wear::Shape::Annulus { .. }
        | wear::Shape::Sector { .. }
        | wear::Shape::Rectangle { .. }
        | wear::Shape::Ellipse { .. } => 0.0,
    }
}

/// Middle of the loaded edge, through which the resultant passes.
fn load_centre(body: &Body, load: &LoadedEdge) -> (f64, f64) {
    let points = outline(body).points(&load.edge);
    if points.len() > 3 && load.strip.is_none() {
        // Curves of a body given by cells, three points each: the middle of their projections.
        let pieces = points.chunks(3).map(|p| ((p[2][0] - p[0][0]).abs(), 0.5 * (p[0][0] + p[2][0])));
        let (width, moment) = pieces.fold((0.0, 0.0), |(w, m), (width, x)| (w + width, m + width * x));
        if width > 0.0 {
            return (moment / width, points.iter().map(|p| p[1]).fold(f64::MIN, f64::max));
        }
    }
    let x = points.iter().map(|p| p[0]).fold((f64::MAX, f64::MIN), |(lo, hi), x| (lo.min(x), hi.max(x)));
    let z = points.iter().map(|p| p[1]).fold(f64::MIN, f64::max);
    let x = load.strip.map_or(0.5 * (x.0 + x.1), |strip| strip.centre);
    (x, z)
}

/// A pressure on an edge that is not level has a resultant that is not vertical: refused where body 1 may turn under it.
fn level(body: &Body, load: &LoadedEdge) -> Result<(), Fault> {
    if body.cells.is_none() || load.kind != LoadKind::Pressure {
        return Ok(());
    }
    let edge = &load.edge;
    let heights: Vec<f64> = outline(body).points(edge).iter().map(|p| p[1]).collect();
    let size = heights.iter().fold(0.0_f64, |size, z| size.max(z.abs()));
    if heights.iter().all(|z| (z - heights[0]).abs() <= 1e-9 * size) {
        return Ok(());
    }
    let message = format!("the pressure on the edge `{edge}`, which is not level, would turn body 1");
    Err(Fault::at(
        "load.as",
        "not-available",
        message,
        "load it vertically (as = \"vertical\"), or hold body 1 along x at two heights",
    ))
}

/// Heights z at which x is held, and places x at which z is held.
struct Held {
    x: Vec<f64>,
    z: Vec<f64>,
}

impl Held {
    fn of(body: &Body) -> Held {
        let mut held = Held { x: Vec::new(), z: Vec::new() };
        let outline = outline(body);
        for (edge, components) in &body.supports {
            for point in outline.points(edge) {
                if components.contains(&Component::X) {
                    held.x.push(point[1]);
                }
                if components.contains(&Component::Z) {
                    held.z.push(point[0]);
                }
            }
        }
        held
    }

    /// Height of the line along x on which body 1 is held; none if it is held nowhere, NaN if at several heights.
    fn pole_height(&self) -> Option<f64> {
        let scale = self.x.iter().fold(0.0_f64, |scale, z| scale.max(z.abs()));
        self.x.iter().copied().reduce(|a, b| if (a - b).abs() <= 1e-9 * scale { a } else { f64::NAN })
    }

    /// Whether supports and load leave body 1 free to turn.
    fn may_turn(&self, load: &Load) -> bool {
        load.tilt.is_none() && self.pole_height().is_none_or(|height| !height.is_nan())
    }
}

/// The freedoms of a body of which the surface alone is given.
pub(crate) fn of_surface(surface: &SurfaceShape, load: &Load) -> Vec<Freedom> {
    let force = load.force.unwrap_or(0.0);
    let push = Freedom { role: Role::Force, mode: RigidMode::press_down(force) };
    match surface {
        SurfaceShape::DiscPad(_) => vec![push],
        SurfaceShape::PinnedShoe(shoe) => {
            // Anti-clockwise in the picture (x right, z up) turns the lining, which lies clockwise of the pin, outwards.
            let about = Vector3::new(0.0, 0.0, shoe.pin_distance.0);
            let motion = RigidMotion::Rotation { axis: -Vector3::y(), about };
            vec![Freedom { role: Role::Moment, mode: RigidMode { motion, resultant: force * shoe.arm.0 } }]
        }
        SurfaceShape::PivotedShoe(shoe) => {
            let pivot = Vector3::new(0.0, 0.0, shoe.pivot.map_or(0.0, |pivot| pivot.0));
            vec![push, Freedom { role: Role::Moment, mode: RigidMode::tilt(0.0, pivot) }]
        }
        SurfaceShape::JournalArc(_) => {
            let motion = RigidMotion::Translation { direction: Vector3::x() };
            vec![push, Freedom { role: Role::SideForce, mode: RigidMode { motion, resultant: 0.0 } }]
        }
        SurfaceShape::RectangularPunch(_) | SurfaceShape::EllipticPunch(_) => {
            let about = Vector3::new(load.about[0], load.about[1], 0.0);
            let [x, y] = [load.moment, load.moment_y];
            vec![
                push,
                Freedom { role: Role::Moment, mode: RigidMode::tilt(x, about) },
                Freedom { role: Role::MomentY, mode: RigidMode::tilt_y(y, about) },
            ]
        }
    }
}
