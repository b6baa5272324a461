//! The contact surface where geometry alone gives it: arcs, strips, rings, and the bare surfaces.

mod bare;
mod edges;
mod found;

use std::f64::consts::{PI, TAU};

use hpfem::Kinematics;
use meshing::{Body, Extent, contact_line};
use nalgebra::Vector3;
use scene::{Fault, Sliding, SurfaceShape, missing};
use wear::{Shape, SlidingMotion, Surface, SurfacePoint};

pub(crate) use self::found::PatchKind;
use crate::circles::Circles;
use crate::surface::edges::{EDGES, along, thickness};
use crate::surface::found::{Found, Other};

/// A contact surface known without a mesh.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Patch {
    /// The surface with its sliding motion.
    pub surface: Surface,
    /// What kind of motion closes a track, which decides how the counter-face wears.
    pub kind: PatchKind,
    /// Whether the surface's own angle falls towards +x: a shoe at the bottom inside its drum.
    pub backwards: bool,
    /// The circle of body 1, where it is another than that of the surface, which is body 2's.
    other: Option<Other>,
}

impl Patch {
    /// A surface without bodies.
    pub(crate) fn bare(surface: &SurfaceShape, sliding: Option<&Sliding>) -> Result<Patch, Fault> {
        Patch::new(bare::bare(surface)?, sliding, false)
    }

    /// The surface between two bodies; none when it takes a mesh to know it.
    pub(crate) fn between(kinematics: Kinematics, bodies: [&Body; 2], sliding: Option<&Sliding>) -> Result<Option<Patch>, Fault> {
        let [first, second] = bodies;
        let found = along(kinematics, [contact_line(first, true)?, contact_line(second, false)?])?;
        found
            .map(|found| {
                let backwards = matches!(found.shape, Shape::Arc { internal: true, .. });
                Patch::new(found, sliding, backwards)
            })
            .transpose()
    }

    fn new(found: Found, sliding: Option<&Sliding>, backwards: bool) -> Result<Patch, Fault> {
        let Found { shape, kind, centre, key, other } = found;
        let motion = motion(sliding, kind, &shape, centre)?;
        let surface = Surface::new(shape, motion)
            .map_err(|error| Fault::at(key, "degenerate", error.to_string(), "give a surface with area"))?;
        Ok(Patch { surface, kind, backwards, other })
    }

    /// Its extent in its own coordinate; none where bodies cannot be meshed for it.
    pub(crate) fn extent(&self) -> Option<Extent> {
        match self.surface.shape() {
            Shape::Arc { angles, centre, radius, .. } => Some(match self.other {
                Some(Other { circle, convex }) => {
                    let (angles, circles) = (*angles, [circle, ([centre.x, centre.z], *radius)]);
                    if convex { Extent::Convex { angles, circles } } else { Extent::Circles { angles, circles } }
                }
                None => Extent::Angles(*angles),
            }),
            Shape::Strip { x, .. } => Some(Extent::X(*x)),
            Shape::Annulus { radii } => Some(Extent::X(*radii)),
            Shape::Points(_) | Shape::Sector { .. } | Shape::Rectangle { .. } | Shape::Ellipse { .. } => None,
        }
    }

    /// First and last place along it, as `place` counts them (mm); none of surfaces of two dimensions.
    pub(crate) fn places(&self) -> Option<[f64; 2]> {
        let about_middle = |length: f64| [-0.5 * length, 0.5 * length];
        match self.surface.shape() {
            Shape::Arc { radius, angles, .. } => Some(about_middle(radius * (angles[1] - angles[0]))),
            Shape::Strip { x, .. } => Some(about_middle(x[1] - x[0])),
            Shape::Annulus { radii } => Some(*radii),
            Shape::Points(_) | Shape::Sector { .. } | Shape::Rectangle { .. } | Shape::Ellipse { .. } => None,
        }
    }

    /// Whether it is a full ring about the axis of revolution.
    pub(crate) fn is_ring(&self) -> bool {
        self.kind == PatchKind::Ring
    }

    /// Radius of an arc (mm), and whether body 1 lies inside it.
    pub(crate) fn circle(&self) -> Option<(f64, bool)> {
        match self.surface.shape() {
            Shape::Arc { radius, internal, .. } => Some((*radius, *internal)),
            _ => None,
        }
    }

    /// The circles of two arcs that are drawn with different radii.
    pub(crate) fn circles(&self) -> Option<Circles> {
        let Other { circle: (_, first), convex } = self.other?;
        let Shape::Arc { radius, angles, .. } = self.surface.shape() else { return None };
        if convex { Some(Circles::outside([first, *radius], 0.5 * (angles[0] + angles[1]))) } else { self.circles_of(first) }
    }

    /// Radii (mm) of both arcs, where they are drawn with different ones.
    pub(crate) fn radii(&self) -> Option<[f64; 2]> {
        let Other { circle: (_, first), .. } = self.other?;
        self.circle().map(|(radius, _)| [first, radius])
    }

    /// Whether two round bodies touch from outside.
    pub(crate) fn is_convex(&self) -> bool {
        self.other.is_some_and(|other| other.convex)
    }

    /// The circles of an arc and of a body 1 with a radius of its own.
    pub(crate) fn circles_of(&self, first: f64) -> Option<Circles> {
        let Shape::Arc { radius, angles, .. } = self.surface.shape() else { return None };
        Some(Circles::new([first, *radius], 0.5 * (angles[0] + angles[1]), self.backwards))
    }

    /// The surface with all sliding speeds multiplied by a factor.
    pub(crate) fn faster(self, factor: f64) -> Patch {
        let SlidingMotion { velocity, angular_velocity, about } = *self.surface.motion();
        let motion = SlidingMotion { velocity: velocity * factor, angular_velocity: angular_velocity * factor, about };
        match Surface::new(self.surface.shape().clone(), motion) {
            Ok(surface) => Patch { surface, ..self },
            Err(_) => self,
        }
    }

    /// `count` points equally spaced in the surface's own coordinate, towards +x.
    pub(crate) fn sample(&self, count: usize) -> Vec<SurfacePoint> {
        self.towards_x(self.surface.sample(count))
    }

    /// Points of the surface in the order of its own coordinate, turned towards +x. Those of a pressure that ends inside a line come from both sides
    /// of the end.
    pub(crate) fn towards_x(&self, mut points: Vec<SurfacePoint>) -> Vec<SurfacePoint> {
        if self.backwards {
            points.reverse();
        }
        if let Shape::Arc { .. } | Shape::Strip { .. } | Shape::Annulus { .. } = self.surface.shape() {
            points.sort_by(|a, b| self.place(a).total_cmp(&self.place(b)));
        }
        points
    }

    /// The arc length from the middle of a point, positive towards +x; on rings and sectors its radius.
    pub(crate) fn place(&self, point: &SurfacePoint) -> f64 {
        let position = point.position;
        match self.surface.shape() {
            Shape::Arc { radius, centre, angles, .. } => {
                let (from, middle) = (position - centre, 0.5 * (angles[0] + angles[1]));
                let turned = from.x.atan2(from.z) - middle;
                let off = (turned + PI).rem_euclid(TAU) - PI;
                // The two ends of a full turn meet in one place.
                let off = if off == -PI && turned > 0.0 { PI } else { off };
                if self.backwards { -radius * off } else { radius * off }
            }
            Shape::Annulus { .. } | Shape::Sector { .. } => position.x.hypot(position.y),
            Shape::Strip { x, .. } | Shape::Rectangle { x, .. } => position.x - 0.5 * (x[0] + x[1]),
            Shape::Points(_) | Shape::Ellipse { .. } => position.x,
        }
    }

    /// The angle (rad, from the z axis towards +x) at an arc length from the middle; none off an arc.
    pub(crate) fn angle(&self, s: f64) -> Option<f64> {
        let Shape::Arc { radius, angles, .. } = self.surface.shape() else { return None };
        let middle = 0.5 * (angles[0] + angles[1]);
        Some(if self.backwards { middle - s / radius } else { middle + s / radius })
    }
}

impl Patch {
    /// A flat surface that slides as a whole along x.
    pub(crate) fn along_x(shape: Shape, speed: f64) -> Result<Patch, Fault> {
        let surface = Surface::new(shape, SlidingMotion::along_x(speed))
            .map_err(|error| Fault::at(EDGES, "degenerate", error.to_string(), "give a surface with area"))?;
        Ok(Patch { surface, kind: PatchKind::Plane, backwards: false, other: None })
    }

    /// A flat surface from and to the given x (or radius), where a round body meets a flat one.
    pub(crate) fn flat(kinematics: Kinematics, x: [f64; 2], z: f64, sliding: Option<&Sliding>) -> Result<Patch, Fault> {
        let (shape, kind) = match kinematics.is_revolved() {
            true => (Shape::Annulus { radii: x }, PatchKind::Ring),
            false => (Shape::Strip { x, z, thickness: thickness(kinematics) }, PatchKind::Plane),
        };
        Patch::new(Found { shape, kind, centre: [0.0, z], key: EDGES, other: None }, sliding, false)
    }
}

/// Motion of body 2; zero when the scene has none.
fn motion(sliding: Option<&Sliding>, kind: PatchKind, shape: &Shape, centre: [f64; 2]) -> Result<SlidingMotion, Fault> {
    let Some(sliding) = sliding else {
        return Ok(SlidingMotion::along_x(0.0));
    };
    let (wanted, found, other) = match kind {
        PatchKind::Plane => ("speed", sliding.speed.map(|speed| speed.0), sliding.omega.map(|_| "omega")),
        PatchKind::Ring | PatchKind::Turning => ("omega", sliding.omega.map(|omega| omega.0), sliding.speed.map(|_| "speed")),
    };
    let example = if wanted == "speed" { "sliding = { speed = \"5 mm/s\" }" } else { "sliding = { omega = \"2.5 rad/s\" }" };
    let Some(value) = found else {
        return Err(match other {
            Some(other) => Fault::at(
                format!("sliding.{other}"),
                "wrong-key",
                format!("`sliding.{other}` does not fit this contact surface, which needs `sliding.{wanted}`"),
                format!("write {example}"),
            ),
            None => missing(&format!("sliding.{wanted}"), "it says how body 2 moves", example),
        });
    };
    if value == 0.0 {
        let message = format!("sliding.{wanted} = 0: nothing slides");
        return Err(Fault::at(
            format!("sliding.{wanted}"),
            "wrong-value",
            message,
            format!("write {example}, or remove `sliding`"),
        ));
    }
    Ok(match (kind, shape) {
        (PatchKind::Plane, _) => SlidingMotion::along_x(value),
        (PatchKind::Ring, _) | (_, Shape::Sector { .. }) => SlidingMotion::about_z(value),
        _ => SlidingMotion::in_plane(value, Vector3::new(centre[0], 0.0, centre[1])),
    })
}
