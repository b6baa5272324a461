//! The wanted tractions of a stage, and the shape they ask for on a pair of bodies.

use contact::{ContactLoad, Motion, Pair};
use nalgebra::Vector3;
use scene::Fault;
use shapeopt::{Integration, RigidPart, Shape, ShapeProblem, SurfacePlace, solve_shape};

use crate::ladder::Refusal;
use crate::stage::Stage;
use crate::steps::heat::known::with_heat;
use crate::steps::jumps::Jumps;
use crate::steps::pressure::infinite_at;
use crate::steps::pressure_ends::{pressure_bends, pressure_ends};
use crate::steps::rigid_coordinates::{coordinates, motion};

/// A wanted pressure that is infinite somewhere has no shape.
pub(crate) fn unanswered(stage: Stage<'_>, optimum: &wear::Optimum) -> Result<(), Refusal> {
    let Some(point) = infinite_at(stage.patch, optimum) else { return Ok(()) };
    let [x, z] = [point.position.x, point.position.z];
    Err(Refusal::Reason(format!(
        "the wanted pressure is infinite at x = {x}, z = {z}, and no shape has it; leave a hole or a cap there (optimum.p_max)"
    )))
}

/// The wanted tractions and the shape they ask for.
pub(crate) struct Shaper<'a> {
    /// The problem on its surface.
    pub stage: Stage<'a>,
    /// The wanted pressure.
    pub optimum: &'a wear::Optimum,
    /// Ends of the wanted pressure, and of its part that is capped, inside the surface.
    pub ends: Vec<f64>,
    /// All places inside the surface where the wanted pressure is not smooth: its ends, and where it passes one at which a wear rule bends.
    pub nodes: Vec<f64>,
    /// Those of them at which it jumps.
    jumps: Jumps,
    /// Rigid velocities of wear (mm/s, rad/s), one a freedom; empty where there are none.
    feed: Vec<f64>,
}

impl<'a> Shaper<'a> {
    /// For the optimal pressure of a stage.
    pub(crate) fn new(stage: Stage<'a>, optimum: &'a wear::Optimum) -> Shaper<'a> {
        let ends = pressure_ends(stage, optimum);
        let jumps = Jumps::among(&ends, stage, optimum);
        let mut nodes = pressure_bends(stage, optimum);
        nodes.extend(&ends);
        nodes.sort_unstable_by(f64::total_cmp);
        Shaper { stage, optimum, ends, nodes, jumps, feed: optimum.feed.clone().unwrap_or_default() }
    }

    /// Wanted pressure at a place; where it jumps, what a node of the pair there carries.
    pub(crate) fn pressure(&self, place: &SurfacePlace, pair: Option<&Pair<'_>>) -> f64 {
        let jump = self.jumps.pressure(place.position, pair);
        jump.unwrap_or_else(|| self.optimum.pressure_at(&self.stage.surface_point(place.position, place.normal, 0.0)))
    }

    /// Pressure and shear along the tangent at a place.
    fn traction(&self, place: &SurfacePlace, pair: &Pair<'_>) -> [f64; 2] {
        let point = self.stage.surface_point(place.position, place.normal, 0.0);
        let pressure = self.pressure(place, Some(pair));
        let tangent = Vector3::new(place.normal[1], 0.0, -place.normal[0]);
        [pressure, self.stage.friction() * pressure * point.drag.dot(&tangent)]
    }

    /// The shape on a pair of bodies.
    pub(crate) fn shape(&self, pair: &Pair<'_>) -> Result<Shape, Fault> {
        let load = &self.stage.problem.load;
        if !self.stage.rigid_prescribed() {
            return self.smallest(pair);
        }
        let fed = self.fed()?;
        let about = self.stage.about();
        let turned = match (load.approach, load.tilt) {
            // A rotation that nothing prescribes is that of the smallest shape.
            (Some(_), None) => motion(pair, &self.smallest(pair)?.rigid, about)[1],
            (_, tilt) => tilt.unwrap_or(0.0),
        };
        let motion = [load.approach.unwrap_or(0.0) + fed[0], turned + fed[1]];
        self.with_rigid_part(pair, RigidPart::Prescribed(coordinates(pair, motion, about)))
    }

    /// Worn approach and turning after `approach_time`.
    fn fed(&self) -> Result<[f64; 2], Fault> {
        let time = self.stage.problem.load.approach_time.unwrap_or(0.0);
        if time != 0.0 && self.feed.is_empty() {
            let message = "approach_time needs the feed of wear, and the multipliers of this functional are no velocities";
            let remedy = "use optimum.functional = \"steady\", or \"wear-power\" with q = 1 and equal b, with wear";
            return Err(Fault::at("load.approach_time", "no-feed", message, remedy));
        }
        Ok([0, 1].map(|k| self.feed.get(k).copied().unwrap_or(0.0) * time))
    }

    /// Adds the worn motions to those that a contact load prescribes.
    pub(crate) fn add_feed(&self, load: &mut ContactLoad) {
        for (k, fed) in self.fed().unwrap_or_default().into_iter().enumerate() {
            if let Motion::Prescribed { value } = &mut load.motions[k + 1] {
                *value -= fed;
            }
        }
    }

    /// The shape with its smallest rigid part; a prescribed rotation is kept.
    pub(crate) fn smallest(&self, pair: &Pair<'_>) -> Result<Shape, Fault> {
        let about = self.stage.about();
        let rigid = match self.stage.turned() {
            0.0 => RigidPart::Smallest,
            tilt => RigidPart::SmallestAlong {
                start: coordinates(pair, [0.0, tilt], about),
                direction: coordinates(pair, [1.0, 0.0], about),
            },
        };
        self.with_rigid_part(pair, rigid)
    }

    fn with_rigid_part(&self, pair: &Pair<'_>, rigid: RigidPart) -> Result<Shape, Fault> {
        let [shaped, counter] = with_heat(pair, self.stage.cases());
        solve_shape(&ShapeProblem {
            pair: *pair,
            traction: &|place| self.traction(place, pair),
            cases_shaped: &shaped,
            cases_counter: &counter,
            gauge: self.stage.gauge(pair),
            rigid,
            integration: Integration::Lobatto,
        })
        .map_err(|error| {
            Fault::at("load", "no-closing", error.to_string(), "press body 1 on body 2, with a pin beside the contact")
        })
    }
}
