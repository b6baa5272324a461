//! Keys that were written but that the scene's choices do not use.

use meshing::{BODY_LOAD_KEYS, unused_in_blocks};
use scene::{Document, Geometry, Kinematics, LoadKind, Scene, Support, Task};

use crate::functional::functional_row;
use crate::setup::twist::turns;

/// The unused keys of a scene, sorted; `more` are further keys that it does not use, written or not.
pub(super) fn keys(document: &Document, scene: &Scene, tasks: &[Task], more: Vec<String>) -> Vec<String> {
    let idle = idle(scene, tasks).into_iter().map(String::from).chain(more);
    let mut unused: Vec<String> = idle.filter(|key| document.has(key)).collect();
    for (name, body) in [("body1", &scene.body1), ("body2", &scene.body2)] {
        if let Some(Geometry::Blocks(blocks)) = body.as_ref().map(|body| &body.geometry) {
            unused.extend(unused_in_blocks(blocks).iter().map(|key| format!("{name}.geometry.blocks.{key}")));
        }
    }
    unused.sort_unstable();
    unused.dedup();
    unused
}

/// Takes out the defaults that were filled in although nothing uses them: read again, they would be unused keys.
pub(super) fn leave_out(document: &Document, scene: &mut Scene, tasks: &[Task]) {
    let idle = idle(scene, tasks);
    let filled = |key: &str| idle.contains(&key) && !document.has(key);
    if let Some(contact) = &mut scene.contact
        && filled("contact.shear")
    {
        contact.shear = None;
    }
    if let Some(wear) = &mut scene.wear
        && filled("wear.counterface")
    {
        wear.counterface = None;
    }
}

/// Keys that the scene's choices do not use, written or not.
fn idle(scene: &Scene, tasks: &[Task]) -> Vec<&'static str> {
    let mut idle = Vec::new();
    let mut when = |condition: bool, keys: &[&'static str]| {
        if condition {
            idle.extend_from_slice(keys);
        }
    };
    let axisymmetric = scene.kinematics == Some(Kinematics::Axisymmetric);
    let bare = scene.surface.is_some();
    let pressure_only = tasks == [Task::Pressure];
    let optimal = tasks.contains(&Task::Pressure) || tasks.contains(&Task::Shape);
    let wears = tasks.contains(&Task::Wear);
    when(axisymmetric || bare, &["thickness"]);
    when(bare, &["kinematics", "contact.edges", "contact.gap", "contact.clearance", "load.edge", "load.as"]);
    when(!tasks.contains(&Task::Shape), &["check"]);
    when(pressure_only, &["mesh.degree", "mesh.layers"]);
    let flat = matches!(scene.contact.as_ref().and_then(|contact| contact.gap.as_ref()), None | Some(scene::Gap::Constant(_)));
    when(!tasks.contains(&Task::Contact) && !wears && !flat, &["contact.gap"]);
    when(!tasks.contains(&Task::Contact) && !wears, &["contact.clearance"]);
    when(pressure_only, &["output.fields", "output.paths", "load.approach_time"]);
    when(pressure_only, &BODY_LOAD_KEYS);
    let timed = scene.wear.as_ref().and_then(|wear| wear.until).is_some_and(|until| until != scene::Until::Steady);
    when(!wears && timed, &["wear.until"]);
    when(!wears, &["schedule"]);
    when(!super::duty::has_life(scene, tasks), &["wear.wearable", "body1.wearable", "wear.spread"]);
    let kind = scene.load.as_ref().and_then(|load| load.kind);
    let rigid = kind == Some(LoadKind::Rigid);
    when(!rigid, &["load.approach", "load.tilt", "load.approach_time", "load.shear_force"]);
    let punch = matches!(scene.surface, Some(scene::SurfaceShape::RectangularPunch(_) | scene::SurfaceShape::EllipticPunch(_)));
    let no_moment = if bare { !punch } else { !rigid || axisymmetric };
    let pinned = scene.body1.iter().flat_map(|body| body.support.values()).any(|held| matches!(held, Support::Pin(_)));
    when(no_moment && !pinned, &["load.moment"]);
    when(no_moment, &["load.about"]);
    when(kind != Some(LoadKind::Traction), &["load.direction"]);
    when(!punch, &["load.moment_y"]);
    when(rigid && axisymmetric, &["load.tilt"]);
    when(kind != Some(LoadKind::Vertical), &["load.width", "load.centre"]);
    when(scene.load.as_ref().is_some_and(|load| load.width.is_none()), &["load.centre"]);
    let functional = scene.optimum.as_ref().and_then(|optimum| optimum.functional);
    when(!optimal, &["optimum.functional", "optimum.q", "optimum.balance", "optimum.modes", "optimum.p_max"]);
    let needs = functional.map(|functional| functional_row(functional).needs);
    when(optimal && needs.is_some_and(|needs| !needs.q), &["optimum.q"]);
    when(optimal && needs.is_some_and(|needs| !needs.modes), &["optimum.modes"]);
    let contact_only = tasks == [Task::Contact];
    let turned = !turns(scene).is_empty();
    // The wear rate of a contact that slides is a column of contact.csv.
    let rates = scene.sliding.is_some() && !turned && scene.wear.as_ref().is_some_and(scene::Wear::has_rule);
    when(contact_only, &["wear.counterface"]);
    when(contact_only && !rates, &["wear.beta", "wear.k", "wear.a", "wear.b", "wear.threshold", "wear.table", "wear.law"]);
    let slides = scene.contact.as_ref().and_then(|contact| contact.friction).unwrap_or(0.0) > 0.0;
    when(contact_only && !slides && !rates, &["sliding.omega", "sliding.speed"]);
    when(contact_only && !slides, &["contact.shear"]);
    when(!optimal && !wears, &["sliding.reversing"]);
    let compared = tasks.contains(&Task::Contact) && tasks.contains(&Task::Shape);
    when(!compared, &["contact.roughness"]);
    when(!turned, &["load.twist", "load.torque"]);
    when(contact_only && turned, &["sliding.omega", "sliding.speed"]);
    idle
}
