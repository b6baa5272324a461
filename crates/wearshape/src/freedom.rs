//! The rigid freedoms of body 1: what its supports and its load leave free, with the prescribed resultants.

use meshing::{Body, Couple, LoadedEdge, outline};
use nalgebra::Vector3;
use scene::{Fault, LoadKind, SurfaceShape};
use wear::{RigidMode, RigidMotion};

use crate::held::Held;
use crate::load::Load;
use crate::one_way;
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

/// What friction does to body 1 along the contact surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Grip {
    /// Nothing: there is none.
    None,
    /// It holds it, since nothing slides.
    Holds,
    /// It drags it along with body 2.
    Drags,
}

/// Refuses supports under which body 2 gives way, under which body 1 has a motion that neither contact nor friction stops, and under which the
/// load cannot press body 1 on body 2 or would turn it. The contact surface is none where it takes a mesh to know it: round bodies on flat ones.
pub(crate) fn check(couple: &Couple, load: &Load, patch: Option<&Patch>, grip: Grip) -> Result<(), Fault> {
    let body = &couple.bodies[0];
    let held = Held::of(body);
    holds_against(couple)?;
    if couple.moves_one_way() {
        return one_way::check(couple, load, patch);
    }
    let free = if couple.is_revolved() { None } else { unstopped(&held, load, patch) };
    let why = match grip {
        Grip::None => Some("without friction nothing holds it"),
        Grip::Holds => None,
        Grip::Drags => Some("friction drags it along"),
    };
    if let Some((motion, why)) = free.zip(why) {
        let remedy = format!("hold x on an edge{}", example(body, couple, patch.is_some()));
        return Err(Fault::at("body1.support", "not-held", format!("body 1 can {motion}, and {why}"), remedy));
    }
    if !held.z.is_empty() {
        let message = "body 1 is held along z, so that the load cannot press it on body 2";
        return Err(Fault::at("body1.support", "held", message, "hold body 1 along x only"));
    }
    let turns = !couple.is_revolved() && !couple.has_rigid_edge() && may_turn(&held, load);
    if turns && patch.is_some() { level(body, &couple.load) } else { Ok(()) }
}

/// The motion of body 1 along its contact surface that its supports and its load leave free: along a straight one it slides, along an arc it
/// turns about the centre. Pressure does not stop it.
fn unstopped(held: &Held, load: &Load, patch: Option<&Patch>) -> Option<&'static str> {
    let turns = may_turn(held, load);
    let arc = patch.and_then(|patch| match patch.surface.shape() {
        wear::Shape::Arc { radius, centre, .. } => Some((*radius, centre.z)),
        wear::Shape::Strip { .. }
        | wear::Shape::Points(_)
        | wear::Shape::Annulus { .. }
        | wear::Shape::Sector { .. }
        | wear::Shape::Rectangle { .. }
        | wear::Shape::Ellipse { .. } => None,
    });
    match (arc, held.pole_height()) {
        _ if held.x.is_empty() && turns => Some("slide along x and turn"),
        (None, _) if held.x.is_empty() => Some("slide along x"),
        (Some((radius, z)), Some(height)) if turns && (height - z).abs() <= 1e-9 * radius => {
            Some("turn about the centre of its arc, the height at which it is held along x")
        }
        _ => None,
    }
}

/// An edge of body 1 that may be held along x: neither touching nor the loaded one, where there is another.
fn example(body: &Body, couple: &Couple, known: bool) -> String {
    let edges = outline(body).names(!known);
    let other = |edge: &&String| **edge != body.contact && !couple.load.is(edge);
    let edge = edges.iter().find(|edge| other(edge) && *edge != "centre").or_else(|| edges.iter().find(other));
    edge.map_or(String::new(), |edge| format!(", as in body1.support = {{ {edge} = [\"x\"] }}"))
}

/// Whether supports and load leave body 1 free to turn.
fn may_turn(held: &Held, load: &Load) -> bool {
    load.tilt.is_none() && !held.holds_turning()
}

/// Whether the supports of body 1 alone hold it against turning.
pub(crate) fn guides_hold_turning(body: &Body) -> bool {
    Held::of(body).holds_turning()
}

/// Moment of the load about the middle of the contact surface (N mm, positive where it presses the +x side), where supports hold body 1 against
/// turning and so carry it; none where they do not, or where there is no such moment.
pub(crate) fn guided_moment(couple: &Couple, load: &Load, patch: &Patch) -> Option<f64> {
    let body = &couple.bodies[0];
    if couple.is_revolved() || couple.moves_one_way() || load.tilt.is_some() || !guides_hold_turning(body) {
        return None;
    }
    let [first, last] = [patch.surface.sample(2).first()?.position.x, patch.surface.sample(2).last()?.position.x];
    let middle = 0.5 * (first + last);
    let force = load.force.unwrap_or(0.0);
    let (moment, at) =
        if couple.has_rigid_edge() { (load.moment, load.about[0]) } else { (0.0, load_centre(body, &couple.load).0) };
    let moment = moment + force * (at - middle);
    (moment.abs() > 1e-9 * force * (last - first).abs()).then_some(moment)
}

/// The freedoms of body 1 on a known contact surface, the pressing first.
pub(crate) fn of_bodies(couple: &Couple, load: &Load, patch: &Patch) -> Vec<Freedom> {
    let body = &couple.bodies[0];
    if couple.moves_one_way() {
        let turns = |mode: &RigidMode| matches!(mode.motion, RigidMotion::Rotation { .. });
        let role = |mode: &RigidMode| if turns(mode) { Role::Moment } else { Role::Force };
        return one_way::mode(couple, load).map(|mode| Freedom { role: role(&mode), mode }).into_iter().collect();
    }
    let push = Freedom { role: Role::Force, mode: RigidMode::press_down(load.force.unwrap_or(0.0)) };
    if couple.is_revolved() {
        return vec![push];
    }
    let held = Held::of(body);
    let mut free = vec![push];
    if may_turn(&held, load) {
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
    let mut free = Vec::new();
    if couple.is_revolved() {
        free.extend(held.z.is_empty().then_some("slide along z"));
    } else {
        free.extend(held.x.is_empty().then_some("slide along x"));
        free.extend(held.z.is_empty().then_some("slide along z"));
        free.extend((!held.holds_turning()).then_some("turn"));
    }
    if free.is_empty() {
        return Ok(());
    }
    let message = format!("body 2 can {}, so that nothing carries the load", free.join(" and "));
    let components = if couple.is_revolved() { "[\"z\"]" } else { "[\"x\", \"z\"]" };
    let names = outline(body).names(false);
    let far = |edge: &&String| **edge != body.contact;
    let edge = names.iter().find(|edge| *edge == "bottom" && far(edge)).or_else(|| names.iter().find(far));
    let edge = edge.map_or(String::new(), |edge| format!(", as in {}.support = {{ {edge} = {components} }}", body.key));
    let remedy = format!("hold an edge of it that does not touch body 1{edge}");
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
