//! The load: edge, kind, what is prescribed.

use meshing::{Body, LoadedEdge, Strip, outline, outside};
use scene::{Fault, Kinematics, Length, Load, LoadKind, Moment, Scene, SurfaceShape, Task, missing, positive};

use crate::load;
use crate::setup::bodies::{known_edge, off_axis};
use crate::setup::one_way;
use crate::setup::twist::turns;
use crate::surface::Patch;

/// Checks the load and fills in its defaults.
pub(super) fn resolve(scene: &mut Scene, tasks: &[Task], patch: Option<&Patch>, body: Option<&Body>) -> Result<(), Fault> {
    let Some(load) = &mut scene.load else {
        let example = if scene.surface.is_some() {
            "load = { force = \"10 kN\" }"
        } else {
            "load = { edge = \"top\", as = \"pressure\", force = \"10 kN\" }"
        };
        return Err(missing("load", "nothing presses body 1 on body 2", example));
    };
    alternatives(load)?;
    if let Some(surface) = &mut scene.surface {
        return on_surface(load, surface);
    }
    let Some(body) = body else {
        return Ok(());
    };
    if body.moves_one_way() && one_way::by_moment(load, body)? {
        return Ok(());
    }
    let Some(edge) = load.edge.clone() else {
        return Err(missing("load.edge", "the load needs an edge of body 1", "load.edge = \"top\""));
    };
    known_edge("load.edge", &edge, &outline(body).names(false))?;
    outside(body, &edge)?;
    one_way::direction(load, body)?;
    can_be_loaded(body, &edge, load.kind, scene.kinematics == Some(Kinematics::Axisymmetric))?;
    match load.kind {
        None => {
            let others = if body.moves_one_way() { "vertical, traction" } else { "vertical, rigid" };
            Err(missing("load.as", "how does the load act?", &format!("load.as = \"pressure\" (or {others})")))
        }
        Some(LoadKind::Rigid) => rigid(scene, tasks, patch),
        Some(kind) => {
            pressing(load)?;
            if kind == LoadKind::Vertical { strip(load, body, &edge, tasks) } else { Ok(()) }
        }
    }
}

/// Refuses an edge that touches body 2, and one on which no load presses downwards.
fn can_be_loaded(body: &Body, edge: &str, kind: Option<LoadKind>, axisymmetric: bool) -> Result<(), Fault> {
    if edge == body.contact {
        let message = format!("the edge `{edge}` touches body 2, and cannot be loaded too");
        return Err(Fault::at("load.edge", "wrong-value", message, "load another edge of body 1, as in load.edge = \"top\""));
    }
    let points = outline(body).points(edge);
    off_axis("load.edge", edge, &points, axisymmetric)?;
    let [from, to] = points.iter().fold([f64::MAX, f64::MIN], |[from, to], x| [from.min(x[0]), to.max(x[0])]);
    let any_way = kind == Some(LoadKind::Rigid) || (body.moves_one_way() && kind != Some(LoadKind::Vertical));
    if points.is_empty() || any_way || to - from > 1e-12 * from.abs().max(to.abs()) {
        return Ok(());
    }
    let message = format!("the edge `{edge}` is upright: a load on it does not press body 1 on body 2");
    Err(Fault::at("load.edge", "wrong-value", message, "load an edge that faces up or down, or write load.as = \"rigid\""))
}

/// What may not stand beside each other.
fn alternatives(load: &Load) -> Result<(), Fault> {
    if let Some(force) = load.force {
        positive("load.force", force.0, "force", " N")?;
    }
    if load.force.is_some() && load.approach.is_some() {
        let message = "both `load.force` and `load.approach` are given";
        return Err(Fault::at("load.approach", "two-alternatives", message, "keep the force or the prescribed approach"));
    }
    if load.moment.is_some() && load.tilt.is_some() {
        let message = "both `load.moment` and `load.tilt` are given";
        let remedy = "keep the moment (rotation free) or the prescribed tilt";
        return Err(Fault::at("load.tilt", "two-alternatives", message, remedy));
    }
    Ok(())
}

/// A force is needed.
fn pressing(load: &Load) -> Result<(), Fault> {
    let why = "nothing presses body 1 on body 2";
    if load.force.is_none() && load.approach.is_some() && load.edge.is_some() {
        let message = "an approach is prescribed to a rigid edge, and this load is a traction";
        return Err(Fault::at("load.approach", "wrong-value", message, "write load.as = \"rigid\", or give load.force instead"));
    }
    load.force.map(|_| ()).ok_or_else(|| missing("load.force", why, "load.force = \"10 kN\""))
}

/// A load on a surface without bodies.
fn on_surface(load: &mut Load, surface: &mut SurfaceShape) -> Result<(), Fault> {
    pressing(load)?;
    match surface {
        SurfaceShape::PivotedShoe(shoe) => {
            // Where the shoe reaches beyond 90 deg it does not press.
            let angle = shoe.half_angle.0.min(std::f64::consts::FRAC_PI_2);
            let neutral = 4.0 * shoe.radius.0 * angle.sin() / (2.0 * angle + (2.0 * angle).sin());
            shoe.pivot.get_or_insert(Length(neutral));
        }
        SurfaceShape::RectangularPunch(_) | SurfaceShape::EllipticPunch(_) => {
            load.moment.get_or_insert(Moment(0.0));
            load.moment_y.get_or_insert(Moment(0.0));
            load.about.get_or_insert([Length(0.0); 2]);
        }
        SurfaceShape::DiscPad(_) | SurfaceShape::PinnedShoe(_) | SurfaceShape::JournalArc(_) => {}
    }
    Ok(())
}

/// A vertical load on the edge or a strip of it.
fn strip(load: &mut Load, body: &Body, edge: &str, tasks: &[Task]) -> Result<(), Fault> {
    let points = outline(body).points(edge);
    let ends = points.iter().fold((f64::MAX, f64::MIN), |(lo, hi), p| (lo.min(p[0]), hi.max(p[0])));
    let Some(width) = load.width else { return Ok(()) };
    let centre = load.centre.get_or_insert(Length(0.0)).0;
    positive("load.width", width.0, "width", " mm")?;
    let (from, to) = (centre - 0.5 * width.0, centre + 0.5 * width.0);
    if !points.is_empty() && (from < ends.0 || to > ends.1) {
        let message = format!("the loaded strip x = {from} to {to} leaves the edge, x = {} to {}", ends.0, ends.1);
        return Err(Fault::at("load.width", "wrong-value", message, "give a narrower strip, or no width"));
    }
    let strips = outline(body).edge(edge).is_some_and(|edge| edge.strips);
    if !strips && [from, to] != [ends.0, ends.1] && tasks != [Task::Pressure] {
        let message = format!("this template carries loads on the whole of the edge `{edge}`, not on a strip of it");
        let remedy = "leave out `width`, or give body 1 by geometry.blocks (wearshape new lining-on-back)";
        return Err(Fault::at("load.width", "not-available", message, remedy));
    }
    Ok(())
}

/// A load through a rigid edge.
fn rigid(scene: &mut Scene, tasks: &[Task], patch: Option<&Patch>) -> Result<(), Fault> {
    let axisymmetric = scene.kinematics == Some(Kinematics::Axisymmetric);
    let Some(load) = &mut scene.load else { return Ok(()) };
    if load.force.is_none() && load.approach.is_none() {
        let why = "a rigid edge needs a force or a prescribed approach";
        return Err(missing("load.force", why, "load.force = \"10 kN\""));
    }
    let optimal = tasks.iter().any(|task| matches!(task, Task::Pressure | Task::Shape));
    if let (None, Some(approach), true) = (load.force, load.approach, optimal) {
        if !tasks.iter().any(|task| matches!(task, Task::Shape | Task::Contact | Task::Wear)) {
            let message = "the pressure alone does not say how much it carries: with a prescribed approach that follows from the elastic bodies";
            let remedy = "give load.force instead, or add \"shape\" to the tasks";
            return Err(Fault::at("load.approach", "not-available", message, remedy));
        }
        positive("load.approach", approach.0, "approach", " mm")?;
    }
    if load.tilt.is_none() && !axisymmetric {
        load.moment.get_or_insert(Moment(0.0));
    }
    if load.about.is_none() && !axisymmetric {
        let middle = patch.and_then(|patch| match patch.surface.shape() {
            wear::Shape::Strip { x, z, .. } => Some([Length(0.5 * (x[0] + x[1])), Length(*z)]),
            wear::Shape::Points(_)
            | wear::Shape::Arc { .. }
            | wear::Shape::Annulus { .. }
            | wear::Shape::Sector { .. }
            | wear::Shape::Rectangle { .. }
            | wear::Shape::Ellipse { .. } => None,
        });
        load.about = Some(middle.unwrap_or([Length(0.0); 2]));
    }
    match load.approach_time {
        Some(time) => worn_approach(scene, time.0),
        None => Ok(()),
    }
}

/// `approach_time` needs a multiplier that is a velocity.
fn worn_approach(scene: &Scene, time: f64) -> Result<(), Fault> {
    use scene::Functional;
    if time.is_nan() || time < 0.0 {
        let message = format!("negative time: load.approach_time = {time} s");
        return Err(Fault::at("load.approach_time", "wrong-value", message, "give a time of 0 or more"));
    }
    let optimum = scene.optimum.clone().unwrap_or_default();
    let b = scene.wear.as_ref().and_then(|wear| wear.b);
    let equal = !matches!(b, Some(scene::Pair::Two([b1, b2])) if b1 != b2);
    let velocity = match optimum.functional.unwrap_or(Functional::Steady) {
        Functional::Steady => true,
        Functional::WearPower => optimum.q.unwrap_or(1.0) == 1.0 && equal && !super::threshold::acts(scene),
        Functional::WearVolume | Functional::FrictionPower | Functional::Uniform => false,
    };
    if velocity {
        return Ok(());
    }
    let message = "load.approach_time needs the feed of the wear, and this optimum's multiplier is not a velocity";
    let remedy = "use optimum.functional = \"steady\", or wear-power with q = 1, b1 = b2 and no threshold";
    Err(Fault::at("load.approach_time", "wrong-value", message, remedy))
}

/// Where and how a resolved load acts; none without an edge. A moment about a pin acts on the edge that turns.
pub(super) fn edge(load: &Load, body: Option<&Body>) -> Option<LoadedEdge> {
    if let (None, Some((edge, pin))) = (load.kind, body.and_then(Body::pin)) {
        let (kind, edge) = (LoadKind::Rigid, edge.to_string());
        return Some(LoadedEdge { edge, kind, strip: None, about: pin, direction: 0.0, level: false });
    }
    let kind = load.kind?;
    let centre = load.centre.map_or(0.0, |centre| centre.0);
    Some(LoadedEdge {
        edge: load.edge.clone()?,
        kind,
        strip: load.width.filter(|_| kind == LoadKind::Vertical).map(|width| Strip { centre, width: width.0 }),
        about: about(load),
        direction: load.direction.map_or(0.0, |angle| angle.0),
        level: load.tilt.is_some_and(|tilt| tilt.0 == 0.0),
    })
}

fn about(load: &Load) -> [f64; 2] {
    load.about.map_or([0.0; 2], |about| about.map(|x| x.0))
}

/// The numbers of a resolved load.
pub(super) fn numbers(scene: &Scene) -> load::Load {
    let load = scene.load.clone().unwrap_or_default();
    let moment = |given: Option<Moment>| given.map_or(0.0, |moment| moment.0);
    load::Load {
        force: load.force.map(|force| force.0),
        approach: load.approach.map(|approach| approach.0),
        approach_time: load.approach_time.map(|time| time.0),
        tilt: load.tilt.map(|tilt| tilt.0),
        moment: moment(load.moment),
        moment_y: moment(load.moment_y),
        about: about(&load),
        shear_force: load.shear_force.map_or(0.0, |force| force.0),
        turns: turns(scene),
    }
}
