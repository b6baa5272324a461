//! A body 1 that a pin or a roller leaves one motion: which it is, how the load works on it, and which way it closes.

use meshing::{Body, Couple, UnitLoad, outline};
use nalgebra::{DMatrix, Vector3};
use scene::{Component, Fault, Support};
use wear::{RigidMode, RigidMotion};

use crate::load::Load;
use crate::surface::Patch;

/// Conditions on rigid motions below which, over the largest, one counts as met.
const FREE: f64 = 1e-9;
/// Work of a load on the motion below which, over force times size of the body, it does not move body 1.
const AT_REST: f64 = 1e-9;

/// The one motion of body 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum OneWay {
    /// A turn about a point (x, z).
    About([f64; 2]),
    /// A translation along a direction (x, z).
    Along([f64; 2]),
}

impl OneWay {
    /// The motion that a pin or a roller leaves body 1; none where it has neither.
    ///
    /// # Errors
    /// Supports that leave no motion, or several.
    pub(crate) fn of(couple: &Couple) -> Result<Option<OneWay>, Fault> {
        if !couple.moves_one_way() {
            return Ok(None);
        }
        let body = &couple.bodies[0];
        let rows = conditions(body);
        let size = size(body);
        let free = null_space(&rows, size);
        match free[..] {
            [[x, z, turn]] if (turn * size).abs() <= FREE * x.hypot(z) => {
                let length = x.hypot(z);
                Ok(Some(OneWay::Along([x / length, z / length])))
            }
            // The pin itself, without what elimination leaves of it.
            [[x, z, turn]] => Ok(Some(OneWay::About(body.pin().map_or([-z / turn, x / turn], |(_, at)| at)))),
            [] => {
                let edges = named(body);
                let message =
                    format!("body 1 cannot move: {edges} together hold all its motions, so that nothing presses it on body 2");
                let remedy = "keep the pin or the roller alone, and take away the other supports of body 1";
                Err(Fault::at("body1.support", "held", message, remedy))
            }
            _ => {
                let edges = named(body);
                let message = format!("{edges} leaves body 1 more than one motion");
                let remedy =
                    "let the roller run on an edge that is longer than a point along its direction, or hold another edge too";
                Err(Fault::at("body1.support", "not-held", message, remedy))
            }
        }
    }

    /// Work of a load of 1 N on the motion: its moment about the pole, anti-clockwise, or its force along the direction.
    fn work(self, load: &UnitLoad) -> f64 {
        match self {
            OneWay::About(pole) => load.moment_about(pole),
            OneWay::Along([x, z]) => x * load.force[0] + z * load.force[1],
        }
    }

    /// The motion in the sense of a work, with its size as the resultant.
    fn mode(self, work: f64) -> RigidMode {
        let sense = work.signum();
        let motion = match self {
            // The y axis points into the picture: about it a turn is clockwise.
            OneWay::About([x, z]) => RigidMotion::Rotation { axis: -sense * Vector3::y(), about: Vector3::new(x, 0.0, z) },
            OneWay::Along([x, z]) => RigidMotion::Translation { direction: sense * Vector3::new(x, 0.0, z) },
        };
        RigidMode { motion, resultant: work.abs() }
    }
}

/// Work of the whole load on the motion.
fn work(way: OneWay, couple: &Couple, load: &Load) -> f64 {
    let by_force = couple.unit_load().map_or(0.0, |unit| way.work(&unit));
    load.force.unwrap_or(0.0) * by_force + load.moment
}

/// The mode of body 1 under its load; none where it has no pin and no roller.
pub(crate) fn mode(couple: &Couple, load: &Load) -> Option<RigidMode> {
    let way = OneWay::of(couple).ok().flatten()?;
    Some(way.mode(work(way, couple, load)))
}

/// Refuses a load that does not move body 1, and one that moves it away from body 2.
pub(crate) fn check(couple: &Couple, load: &Load, patch: Option<&Patch>) -> Result<(), Fault> {
    let Some(way) = OneWay::of(couple)? else { return Ok(()) };
    let Some(patch) = patch else {
        let message = "a pin or a roller of body 1 needs a contact surface that is known before it is meshed, and a round body on a flat one has none";
        let remedy = "let both contact edges be one line or parts of one circle, or hold body 1 by [\"x\"] and load it rigidly";
        return Err(Fault::at("body1.support", "not-available", message, remedy));
    };
    let (key, turned) = if load.moment != 0.0 { ("load.moment", 1.0) } else { ("load.edge", load.force.unwrap_or(0.0)) };
    let work = work(way, couple, load);
    let lever = if load.moment != 0.0 { 0.0 } else { turned * size(&couple.bodies[0]) };
    if work == 0.0 || work.abs() <= AT_REST * lever {
        let message = match way {
            OneWay::About([x, z]) => {
                format!("the load has no moment about the pin at ({x}, {z}), so that nothing presses body 1 on body 2")
            }
            OneWay::Along(_) => "the load has no force along the roller, so that nothing presses body 1 on body 2".to_string(),
        };
        let remedy = match way {
            OneWay::About(_) => "load another edge, or give load.moment about the pin",
            OneWay::Along(_) => "load another edge, or turn the roller",
        };
        return Err(Fault::at(key, "no-balance", message, remedy));
    }
    let mode = way.mode(work);
    let [opening, closing, fastest] = moved(mode.motion, patch);
    if closing > 1e-9 * fastest {
        return Ok(());
    }
    if opening <= 1e-9 * fastest {
        let (message, remedy) = match way {
            OneWay::About([x, z]) => (
                format!("a turn about ({x}, {z}) brings no point of body 1 nearer to body 2: it is the middle of the contact"),
                "place the pin off the middle of the contact",
            ),
            OneWay::Along(_) => {
                ("body 1 moves along the contact, no point of it nearer to body 2".to_string(), "turn the roller")
            }
        };
        return Err(Fault::at("body1.support", "wrong-value", message, remedy));
    }
    let sense = if work > 0.0 { "anti-clockwise" } else { "clockwise" };
    let (message, remedy) = match (way, load.moment != 0.0) {
        (OneWay::About([x, z]), true) => (
            format!("a moment of {} N mm turns body 1 {sense} about ({x}, {z}), away from body 2", load.moment),
            format!("load.moment is anti-clockwise positive: write load.moment = {}", -load.moment),
        ),
        (OneWay::About([x, z]), false) => (
            format!("the load turns body 1 {sense} about ({x}, {z}), away from body 2"),
            "load the edge on the other side of the pin, or give load.moment about the pin".to_string(),
        ),
        (OneWay::Along([x, z]), _) => (
            format!("the load moves body 1 along ({:.4}, {:.4}), away from body 2", x * work.signum(), z * work.signum()),
            "turn the roller, or load another edge".to_string(),
        ),
    };
    Err(Fault::at(key, "opens", message, remedy))
}

/// Whether the motion closes part of the contact surface and opens another, whichever way it goes.
pub(crate) fn opens_a_part(couple: &Couple, patch: &Patch) -> bool {
    let Ok(Some(way)) = OneWay::of(couple) else { return false };
    let [opening, closing, fastest] = moved(way.mode(1.0).motion, patch);
    closing.min(opening) > 1e-9 * fastest
}

/// Most that a motion opens and closes the contact surface, and the fastest that it moves a point of it.
fn moved(motion: RigidMotion, patch: &Patch) -> [f64; 3] {
    let points = patch.surface.sample(201);
    let most = |of: &dyn Fn(&wear::SurfacePoint) -> f64| points.iter().map(of).fold(0.0, f64::max);
    [
        most(&|point| -motion.closing(point)),
        most(&|point| motion.closing(point)),
        most(&|point| motion.displacement(&point.position).norm()),
    ]
}

/// What an edge takes away of the rigid motions, in words: of a pin both translations, of a roller that across it, and the turn.
pub(crate) fn taken(body: &Body, edge: &str) -> Option<Vec<String>> {
    match body.supports.get(edge)? {
        Support::Pin(_) => Some(vec!["sliding".into(), "closing".into()]),
        Support::Roller(angle) => {
            let mut taken = vec![format!("motion across {} deg", scene::short(angle.0.to_degrees()))];
            let extent = along(body, edge, angle.0);
            taken.extend((extent > FREE * size(body)).then(|| "tilt".to_string()));
            Some(taken)
        }
        Support::Components(_) => None,
    }
}

/// What body 1 is free to do, in words; none where it has no pin and no roller.
pub(crate) fn free(couple: &Couple) -> Option<String> {
    Some(match OneWay::of(couple).ok()?? {
        OneWay::About([x, z]) => format!("turning about ({}, {})", scene::short(x), scene::short(z)),
        OneWay::Along([x, z]) => {
            let angle = z.atan2(x).to_degrees().rem_euclid(180.0);
            format!("moving along {} deg", scene::short(angle))
        }
    })
}

/// Extent of an edge along a direction (mm).
fn along(body: &Body, edge: &str, angle: f64) -> f64 {
    let (sine, cosine) = angle.sin_cos();
    let places = outline(body).points(edge).into_iter().map(|[x, z]| cosine * x + sine * z);
    let [least, most] = places.fold([f64::MAX, f64::MIN], |[least, most], x| [least.min(x), most.max(x)]);
    most - least
}

/// Largest coordinate of the outline, a length of the size of the body.
fn size(body: &Body) -> f64 {
    outline(body).edges.iter().flat_map(|edge| &edge.points).flatten().fold(0.0, |size, x| size.max(x.abs()))
}

/// Names of the held edges.
fn named(body: &Body) -> String {
    body.supports.keys().map(|edge| format!("`{edge}`")).collect::<Vec<_>>().join(" and ")
}

/// Rows (t_x, t_z, theta about the origin) that vanish for the motions that the supports leave.
fn conditions(body: &Body) -> Vec<[f64; 3]> {
    let across = |[x, z]: [f64; 2], [dx, dz]: [f64; 2]| [dx, dz, x * dz - z * dx];
    let outline = outline(body);
    let mut rows = Vec::new();
    for (edge, support) in &body.supports {
        let points = outline.points(edge);
        let directions: Vec<[f64; 2]> = match support {
            Support::Pin(at) => {
                let at = at.map(|x| x.0);
                rows.extend([across(at, [1.0, 0.0]), across(at, [0.0, 1.0])]);
                continue;
            }
            Support::Roller(angle) => vec![[-angle.0.sin(), angle.0.cos()]],
            Support::Components(held) => held
                .iter()
                .filter_map(|component| match component {
                    Component::X => Some([1.0, 0.0]),
                    Component::Z => Some([0.0, 1.0]),
                    Component::Phi => None,
                })
                .collect(),
        };
        rows.extend(directions.iter().flat_map(|d| points.iter().map(|x| across(*x, *d))));
    }
    rows
}

/// Motions that all conditions leave.
fn null_space(rows: &[[f64; 3]], size: f64) -> Vec<[f64; 3]> {
    // The turn in units of its motion at the size of the body; three rows at least, so that all directions have a singular value.
    let matrix = DMatrix::from_fn(rows.len().max(3), 3, |i, k| {
        let row = rows.get(i).copied().unwrap_or_default();
        let scale = row.iter().enumerate().fold(0.0_f64, |m, (k, v)| m.max(if k == 2 { v.abs() / size } else { v.abs() }));
        if scale == 0.0 { 0.0 } else { row[k] / if k == 2 { size * scale } else { scale } }
    });
    let svd = matrix.svd(false, true);
    let Some(directions) = svd.v_t else { return Vec::new() };
    let largest = svd.singular_values.max();
    let free = (0..3).filter(|k| svd.singular_values[*k] <= FREE * largest);
    free.map(|k| [directions[(k, 0)], directions[(k, 1)], directions[(k, 2)] / size]).collect()
}
