//! Loads that the scene's choices do not carry are refused: an answer without them would be that of another scene.

use meshing::{Couple, outline};
use scene::{Fault, Kinematics, Load, LoadKind, Scene, SurfaceShape, Task};

use crate::freedom::guides_hold_turning;
use crate::setup::twist::turns;
use crate::surface::Patch;

/// A number of the load: its key, its value unless it says nothing, whether it is carried, and else why not, with the remedy.
type Row = (&'static str, Option<f64>, bool, &'static str, &'static str);

/// Refuses a number of the load that is not zero and that neither the kind of load nor the tasks carry.
pub(super) fn check(scene: &Scene, tasks: &[Task], couple: Option<&Couple>, patch: Option<&Patch>) -> Result<(), Fault> {
    let Some(load) = &scene.load else { return Ok(()) };
    let rows = moments(scene, load, couple).into_iter().chain(forces(scene, load, tasks, patch));
    for (key, value, carried, why, remedy) in rows {
        if let Some(value) = value.filter(|_| !carried) {
            let message = format!("{key} = {value} would be left out: {why}");
            return Err(Fault::at(key, "not-carried", message, remedy));
        }
    }
    let elastic = tasks != [Task::Pressure];
    match couple.filter(|_| elastic && load.kind != Some(LoadKind::Vertical)) {
        Some(couple) => strip(load, couple),
        None => Ok(()),
    }
}

fn not_zero(value: &f64) -> bool {
    *value != 0.0
}

/// Moments and rotations.
fn moments(scene: &Scene, load: &Load, couple: Option<&Couple>) -> Vec<Row> {
    let axisymmetric = scene.kinematics == Some(Kinematics::Axisymmetric);
    let bare = scene.surface.is_some();
    let flat = matches!(scene.surface, Some(SurfaceShape::RectangularPunch(_) | SurfaceShape::EllipticPunch(_)));
    let pinned = couple.is_some_and(|couple| couple.bodies[0].pin().is_some());
    let turns_by_load = load.kind == Some(LoadKind::Rigid) && !axisymmetric && !bare;
    let why = match (bare, axisymmetric) {
        (true, _) => "this surface is pressed by a force alone",
        (false, true) => "a body of revolution does not tilt",
        (false, false) => "a moment and a rotation act through a rigid edge",
    };
    let remedy = match (bare, axisymmetric) {
        (false, false) => "write load.as = \"rigid\", or leave it out",
        _ => "leave it out",
    };
    let guided = couple.is_some_and(|couple| guides_hold_turning(&couple.bodies[0]));
    // A rotation held at zero says no more than guides that hold it.
    let tilt = load.tilt.map(|tilt| tilt.0).filter(|tilt| *tilt != 0.0 || !(guided || bare || axisymmetric));
    let [moment, moment_y] = [load.moment, load.moment_y].map(|moment| moment.map(|moment| moment.0).filter(not_zero));
    vec![
        ("load.moment", moment, turns_by_load || flat || pinned, why, remedy),
        ("load.moment_y", moment_y, flat, "it belongs to the surfaces of punches", "leave it out"),
        ("load.tilt", tilt, turns_by_load, why, remedy),
    ]
}

/// What shifts and turns body 1, and where it acts.
fn forces(scene: &Scene, load: &Load, tasks: &[Task], patch: Option<&Patch>) -> Vec<Row> {
    let rigid = load.kind == Some(LoadKind::Rigid) && scene.surface.is_none();
    let shaped = tasks.contains(&Task::Shape) || tasks == [Task::Pressure];
    let time_needs = "the worn approach is that of a shape, under a rigid edge";
    let shear_needs = "stick and slip is known under the level rigid edge of a half-disc on a flat top";
    let turned = !turns(scene).is_empty();
    let turn_needs = "body 1 is turned about the axis of revolution, in the task contact";
    let twist = load.twist.iter().flat_map(|steps| &steps.0).map(|angle| angle.0).find(not_zero);
    let torque = load.torque.iter().flat_map(|steps| &steps.0).map(|torque| torque.0).find(not_zero);
    let time = load.approach_time.map(|time| time.0).filter(not_zero);
    let shear = load.shear_force.map(|force| force.0).filter(not_zero);
    let centre = load.centre.map(|centre| centre.0).filter(not_zero);
    let of_strip = "it is the middle of a strip, and load.width gives none";
    let time_remedy = "write load.as = \"rigid\" and the task shape, or leave it out";
    let turn_remedy = "write kinematics = \"axisymmetric\" and tasks = [\"contact\"], or leave it out";
    vec![
        ("load.approach_time", time, rigid && shaped, time_needs, time_remedy),
        ("load.shear_force", shear, rigid && patch.is_none(), shear_needs, "leave it out"),
        ("load.centre", centre, load.width.is_some() || tasks == [Task::Pressure], of_strip, "give load.width, or leave it out"),
        ("load.twist", twist, turned, turn_needs, turn_remedy),
        ("load.torque", torque, turned, turn_needs, turn_remedy),
    ]
}

/// Refuses a strip of a load that acts on the whole edge.
fn strip(load: &Load, couple: &Couple) -> Result<(), Fault> {
    let points = outline(&couple.bodies[0]).points(&couple.load.edge);
    let [from, to] = points.iter().fold([f64::MAX, f64::MIN], |[from, to], x| [from.min(x[0]), to.max(x[0])]);
    let centre = load.centre.map_or(0.0, |centre| centre.0);
    let whole = |width: f64| [centre - 0.5 * width, centre + 0.5 * width] == [from, to];
    let Some(width) = load.width.map(|width| width.0).filter(|width| !whole(*width)) else { return Ok(()) };
    let message = format!("load.width = {width} would be left out: only a vertical load acts on a strip of its edge");
    let remedy = "write load.as = \"vertical\", or leave out load.width";
    Err(Fault::at("load.width", "not-carried", message, remedy))
}
