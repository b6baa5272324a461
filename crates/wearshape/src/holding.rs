//! What holds each body, and what it is free to do, in words.

use meshing::{Body, Couple};
use scene::Component;
use serde::Serialize;

use crate::held::Held;
use crate::one_way;
use crate::problem::Problem;

/// What holds a body.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Holding {
    /// "body1" or "body2".
    pub body: &'static str,
    /// What takes rigid motions away, and which.
    pub held: Vec<HeldBy>,
    /// The rigid motions that stay: "sliding" along x, "closing" along z, "tilt"; of solids of revolution "closing" and "turning" about the axis; under a pin or a roller
    /// the one motion that it leaves.
    pub free: Vec<String>,
}

/// What takes rigid motions away.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HeldBy {
    /// Edges with a support, or a key of the load.
    pub by: Vec<String>,
    /// The motions.
    pub motions: Vec<String>,
}

impl std::fmt::Display for Holding {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: ", self.body.replace("body", "body "))?;
        let held = |one: &HeldBy| format!("held by {}: {}; ", one.by.join(" and "), one.motions.join(", "));
        write!(f, "{}", self.held.iter().map(held).collect::<String>())?;
        write!(f, "free: {}", if self.free.is_empty() { "nothing".to_string() } else { self.free.join(", ") })
    }
}

impl Problem {
    /// What holds body 1 and body 2; nothing of a surface alone.
    pub fn holding(&self) -> Vec<Holding> {
        let Some(couple) = &self.couple else { return Vec::new() };
        let load = &self.load;
        let keys = [("load.approach", load.approach.is_some(), "closing"), ("load.tilt", load.tilt.is_some(), "tilt")];
        let prescribed = keys.into_iter().filter(|(_, given, _)| *given && couple.has_rigid_edge());
        let prescribed: Vec<_> = prescribed.map(|(key, _, motion)| (key.to_string(), vec![motion.to_string()])).collect();
        let turns = (!load.turns.is_empty()).then(|| ("its turning".to_string(), vec!["turning".to_string()]));
        let first = prescribed.into_iter().chain(turns).collect();
        vec![holding(couple, 0, first), holding(couple, 1, Vec::new())]
    }
}

/// What holds a body by its supports and by what else is given.
fn holding(couple: &Couple, number: usize, given: Vec<(String, Vec<String>)>) -> Holding {
    let body = &couple.bodies[number];
    let revolved = couple.is_revolved();
    let all: &[&str] = if revolved { &["closing", "turning"] } else { &["closing", "sliding", "tilt"] };
    let taken = |edge: &String| match one_way::taken(body, edge) {
        Some(taken) => taken,
        None if revolved => on_axis(body, edge),
        None => in_plane(&Held::by(body, edge)),
    };
    let mut single: Vec<(String, Vec<String>)> =
        body.supports.keys().map(|edge| (edge.clone(), taken(edge))).chain(given).collect();
    let holds =
        |single: &[(String, Vec<String>)], motion: &str| single.iter().any(|(_, taken)| taken.iter().any(|t| t == motion));
    // No edge alone, but all of them.
    if !revolved && Held::of(body).holds_turning() && !holds(&single, "tilt") {
        let edges: Vec<String> = body.supports.keys().cloned().collect();
        single.push((format!("{} together", edges.join(" and ")), vec!["tilt".to_string()]));
    }
    let left = || all.iter().filter(|motion| !holds(&single, motion)).map(|motion| (*motion).to_string()).collect();
    let free = one_way::free(couple).filter(|_| number == 0).map_or_else(left, |one| vec![one]);
    let mut held: Vec<HeldBy> = Vec::new();
    for (by, motions) in single.into_iter().filter(|(_, motions)| !motions.is_empty()) {
        match held.iter_mut().find(|known| known.motions == motions) {
            Some(known) => known.by.push(by),
            None => held.push(HeldBy { by: vec![by], motions }),
        }
    }
    Holding { body: body.key, held, free }
}

/// What the supports of an edge take away of the motions in the plane.
fn in_plane(held: &Held) -> Vec<String> {
    let rules = [(!held.x.is_empty(), "sliding"), (!held.z.is_empty(), "closing"), (held.holds_turning(), "tilt")];
    rules.into_iter().filter(|(taken, _)| *taken).map(|(_, motion)| motion.to_string()).collect()
}

/// What the supports of an edge take away of the motions of a solid of revolution; along r the axis holds it by itself.
fn on_axis(body: &Body, edge: &str) -> Vec<String> {
    let motion = |component: &Component| match component {
        Component::X => None,
        Component::Z => Some("closing".to_string()),
        Component::Phi => Some("turning".to_string()),
    };
    body.supports.get(edge).into_iter().flat_map(scene::Support::components).filter_map(motion).collect()
}
