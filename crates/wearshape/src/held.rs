//! What the supports of a plane body take away of its rigid motions, by where they hold it.

use meshing::{Body, outline};
use scene::Component;

/// Heights z at which x is held, and places x at which z is held (mm).
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Held {
    /// Heights at which x is held.
    pub x: Vec<f64>,
    /// Places at which z is held.
    pub z: Vec<f64>,
}

impl Held {
    /// By all supports of a body.
    pub(crate) fn of(body: &Body) -> Held {
        let mut held = Held::default();
        for edge in body.supports.keys() {
            let Held { x, z } = Held::by(body, edge);
            held.x.extend(x);
            held.z.extend(z);
        }
        held
    }

    /// By the supports of one edge.
    pub(crate) fn by(body: &Body, edge: &str) -> Held {
        let holds = |component| body.supports.get(edge).is_some_and(|held| held.holds(component));
        let points = outline(body).points(edge);
        let along = |component, axis: usize| match holds(component) {
            true => points.iter().map(|point| point[axis]).collect(),
            false => Vec::new(),
        };
        Held { x: along(Component::X, 1), z: along(Component::Z, 0) }
    }

    /// Whether they hold the body against turning: x at two heights, z at two places, or both together anywhere.
    pub(crate) fn holds_turning(&self) -> bool {
        apart(&self.x) || apart(&self.z) || (!self.x.is_empty() && !self.z.is_empty())
    }

    /// Height of the line along x on which a body is held; none if it is held nowhere or at several heights.
    pub(crate) fn pole_height(&self) -> Option<f64> {
        self.x.first().copied().filter(|_| !apart(&self.x))
    }
}

/// Whether places are more than one.
fn apart(places: &[f64]) -> bool {
    let [least, most] = places.iter().fold([f64::MAX, f64::MIN], |[least, most], x| [least.min(*x), most.max(*x)]);
    most - least > 1e-9 * least.abs().max(most.abs())
}
