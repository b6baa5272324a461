//! Contact surfaces: parametric ones, on which integrals are exact to round-off, and plain lists of points.

use std::f64::consts::TAU;

use nalgebra::Vector3;

use crate::{SlidingMotion, SurfacePoint, WearError};

/// Largest difference of the length of a unit vector of a listed point from 1: coordinates may be single precision.
const UNIT: f64 = 1e-6;
/// What a track is refused as.
pub(crate) const TRACK: &str = "track area of the counterface";
/// Round-off of a full turn.
const TURN: f64 = 1e-9;

/// Geometry of a contact surface. Lengths in mm, angles in rad.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Points with weights, for example the contact points of a finite element boundary.
    Points(Vec<SurfacePoint>),
    /// Circular arc in the x-z plane, extruded by `thickness` along y: drum and shoe, journal bearing.
    Arc {
        /// Radius R.
        radius: f64,
        /// Centre of the circle.
        centre: Vector3<f64>,
        /// First and last angle, from the z axis towards +x.
        angles: [f64; 2],
        /// Thickness along y.
        thickness: f64,
        /// False: body 2 is inside (drum, shaft), n = (sin, cos). True: body 2 is outside (internal shoe), n reversed.
        internal: bool,
    },
    /// Plane strip along x at height z with n = +e_z: plane punch.
    Strip {
        /// First and last x.
        x: [f64; 2],
        /// Height.
        z: f64,
        /// Thickness along y.
        thickness: f64,
    },
    /// Full ring about the z axis, integrated over the angle: only modes with axial symmetry.
    Annulus {
        /// Inner and outer radius.
        radii: [f64; 2],
    },
    /// Sector of a ring about the z axis with n = +e_z: pad of a disc brake. A full turn is allowed (ring with moments).
    Sector {
        /// Inner and outer radius.
        radii: [f64; 2],
        /// First and last angle from the x axis towards y.
        angles: [f64; 2],
    },
    /// Rectangle in the plane z = 0.
    Rectangle {
        /// First and last x.
        x: [f64; 2],
        /// First and last y.
        y: [f64; 2],
    },
    /// Ellipse in the plane z = 0 about the origin.
    Ellipse {
        /// Semi-axes along x and y.
        semi_axes: [f64; 2],
    },
}

/// A contact surface with its sliding motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    shape: Shape,
    motion: SlidingMotion,
    track_area: Option<f64>,
}

impl Surface {
    /// A list of points, taken as it is: its weights are the quadrature.
    ///
    /// # Errors
    /// [`WearError::EmptySurface`] without points or without area; [`WearError::OutOfRange`] for a weight or a speed below 0, a normal that is not of
    /// unit length, a drag that is neither that nor zero (both up to 1e-6), and numbers that are not finite.
    pub fn from_points(points: Vec<SurfacePoint>) -> Result<Self, WearError> {
        for point in &points {
            finite("place, normal or drag of a point", &[point.position, point.normal, point.drag])?;
            for (name, value) in [("weight of a point", point.weight), ("sliding speed of a point", point.sliding_speed)] {
                if !(value >= 0.0 && value.is_finite()) {
                    return Err(WearError::OutOfRange { name, value, wanted: ">= 0 and finite" });
                }
            }
            let unit = |vector: &Vector3<f64>| (vector.norm() - 1.0).abs() <= UNIT;
            if !unit(&point.normal) {
                let (name, value) = ("length of the normal of a point", point.normal.norm());
                return Err(WearError::OutOfRange { name, value, wanted: "1" });
            }
            if !(unit(&point.drag) || point.drag == Vector3::zeros()) {
                let (name, value) = ("length of the drag of a point", point.drag.norm());
                return Err(WearError::OutOfRange { name, value, wanted: "1, or 0 where nothing slides" });
            }
        }
        let area: f64 = points.iter().map(|point| point.weight).sum();
        if points.is_empty() || !(area > 0.0 && area.is_finite()) {
            return Err(WearError::EmptySurface { points: points.len(), area });
        }
        Ok(Self { shape: Shape::Points(points), motion: SlidingMotion::along_x(0.0), track_area: None })
    }

    /// A parametric surface with the motion of body 2 over it.
    ///
    /// # Errors
    /// [`WearError::OutOfRange`] for lengths, angles and radii that span nothing or are not finite, and for angles over more than a full turn;
    /// [`WearError::EmptySurface`] for points without area.
    pub fn new(shape: Shape, motion: SlidingMotion) -> Result<Self, WearError> {
        finite("sliding motion", &[motion.velocity, motion.angular_velocity, motion.about])?;
        let surface = Self { shape, motion, track_area: None };
        let positive = |name, value: f64| {
            if value > 0.0 && value.is_finite() {
                Ok(())
            } else {
                Err(WearError::OutOfRange { name, value, wanted: "> 0 and finite" })
            }
        };
        let angle = |name, angles: &[f64; 2]| {
            let value = angles[1] - angles[0];
            if value > TAU * (1.0 + TURN) && value.is_finite() {
                return Err(WearError::OutOfRange { name, value, wanted: "at most a full turn" });
            }
            positive(name, value)
        };
        match &surface.shape {
            Shape::Points(points) => return Self::from_points(points.clone()),
            Shape::Arc { radius, angles, thickness, centre, .. } => {
                finite("centre", &[*centre])?;
                positive("radius", *radius)?;
                positive("thickness", *thickness)?;
                angle("angle of the arc", angles)?;
            }
            Shape::Strip { x, thickness, z } => {
                finite("height of the strip", &[Vector3::new(0.0, 0.0, *z)])?;
                positive("length of the strip", x[1] - x[0])?;
                positive("thickness", *thickness)?;
            }
            Shape::Annulus { radii } | Shape::Sector { radii, .. } => {
                if radii[0] < 0.0 {
                    let (name, value) = ("inner radius", radii[0]);
                    return Err(WearError::OutOfRange { name, value, wanted: ">= 0" });
                }
                positive("width of the ring", radii[1] - radii[0])?;
                if let Shape::Sector { angles, .. } = &surface.shape {
                    angle("angle of the sector", angles)?;
                }
            }
            Shape::Rectangle { x, y } => {
                positive("width of the rectangle", x[1] - x[0])?;
                positive("height of the rectangle", y[1] - y[0])?;
            }
            Shape::Ellipse { semi_axes } => {
                positive("semi-axis along x", semi_axes[0])?;
                positive("semi-axis along y", semi_axes[1])?;
            }
        }
        Ok(surface)
    }

    /// The same surface with the area (mm^2) of body 2's closed track, greater than 0, needed by a revolving counter-face under a
    /// list of points. A [`Problem`](crate::Problem) is refused with another one.
    pub fn with_track_area(mut self, area: f64) -> Self {
        self.track_area = Some(area);
        self
    }

    /// Refuses a track without area, whether it is needed or not.
    pub(crate) fn check_track(&self) -> Result<(), WearError> {
        match self.track_area {
            Some(value) if value.is_nan() || value <= 0.0 => Err(WearError::OutOfRange { name: TRACK, value, wanted: "> 0" }),
            Some(_) | None => Ok(()),
        }
    }

    pub(crate) fn is_listed(&self) -> bool {
        matches!(self.shape, Shape::Points(_))
    }

    /// True for a disc without a hole that turns about its axis, where the sliding speed vanishes.
    pub(crate) fn reaches_axis(&self) -> bool {
        let radii = match &self.shape {
            Shape::Annulus { radii } | Shape::Sector { radii, .. } => radii,
            Shape::Points(_) | Shape::Arc { .. } | Shape::Strip { .. } | Shape::Rectangle { .. } | Shape::Ellipse { .. } => {
                return false;
            }
        };
        radii[0] == 0.0 && self.motion.velocity == Vector3::zeros()
    }

    /// The geometry.
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// Motion of body 2 relative to body 1.
    pub fn motion(&self) -> &SlidingMotion {
        &self.motion
    }

    /// Area of body 2's closed track in mm^2, where it is known: given, or the full turn of an arc.
    pub fn track_area(&self) -> Option<f64> {
        match &self.shape {
            Shape::Arc { radius, thickness, .. } => Some(TAU * radius * thickness),
            Shape::Points(_)
            | Shape::Strip { .. }
            | Shape::Annulus { .. }
            | Shape::Sector { .. }
            | Shape::Rectangle { .. }
            | Shape::Ellipse { .. } => self.track_area,
        }
    }

    /// Range of the inner parameter (along the surface; on a sector along the track).
    pub(crate) fn inner_range(&self) -> [f64; 2] {
        match &self.shape {
            Shape::Points(_) => [0.0, 0.0],
            Shape::Arc { angles, .. } | Shape::Sector { angles, .. } => *angles,
            Shape::Strip { x, .. } => *x,
            Shape::Annulus { radii } => log_range(radii),
            Shape::Rectangle { y, .. } => *y,
            Shape::Ellipse { .. } => [-1.0, 1.0],
        }
    }

    /// Range of the outer parameter of a surface with two, `None` for one.
    pub(crate) fn outer_range(&self) -> Option<[f64; 2]> {
        match &self.shape {
            Shape::Sector { radii, .. } => Some(log_range(radii)),
            Shape::Rectangle { x, .. } => Some(*x),
            Shape::Ellipse { .. } => Some([-TAU / 4.0, TAU / 4.0]),
            Shape::Points(_) | Shape::Arc { .. } | Shape::Strip { .. } | Shape::Annulus { .. } => None,
        }
    }

    /// The point at the given parameters; its weight is the area per unit of the parameters.
    pub(crate) fn at(&self, inner: f64, outer: f64) -> SurfacePoint {
        let up = Vector3::z();
        let (position, normal, weight) = match &self.shape {
            Shape::Points(points) => return points[0],
            Shape::Arc { radius, centre, thickness, internal, .. } => {
                let (sine, cosine) = inner.sin_cos();
                let outward = Vector3::new(sine, 0.0, cosine);
                let normal = if *internal { -outward } else { outward };
                (centre + outward * *radius, normal, radius * thickness)
            }
            Shape::Strip { z, thickness, .. } => (Vector3::new(inner, 0.0, *z), up, *thickness),
            Shape::Annulus { radii } => {
                let r = log_radius(radii, inner);
                (Vector3::new(r, 0.0, 0.0), up, TAU * r * r)
            }
            Shape::Sector { radii, .. } => {
                let r = log_radius(radii, outer);
                let (sine, cosine) = inner.sin_cos();
                (Vector3::new(r * cosine, r * sine, 0.0), up, r * r)
            }
            Shape::Rectangle { .. } => (Vector3::new(outer, inner, 0.0), up, 1.0),
            Shape::Ellipse { semi_axes } => {
                let (sine, cosine) = outer.sin_cos();
                let position = Vector3::new(semi_axes[0] * sine, semi_axes[1] * cosine * inner, 0.0);
                (position, up, semi_axes[0] * semi_axes[1] * cosine * cosine)
            }
        };
        self.point(position, normal, weight)
    }

    /// The surface point at a position with the given normal and weight; speed and drag direction from the motion.
    pub fn point(&self, position: Vector3<f64>, normal: Vector3<f64>, weight: f64) -> SurfacePoint {
        let (sliding_speed, drag) = self.motion.sliding(&position, &normal);
        SurfacePoint { position, normal, weight, sliding_speed, drag }
    }

    /// `count` >= 2 points equally spaced in the surface's own coordinate (angle, x, r), both ends included, with trapezoid
    /// weights. On surfaces with two parameters: the middle line along x (rectangle, ellipse) or r (sector), with the weight of the
    /// whole cross line. A list of points is returned as it is.
    pub fn sample(&self, count: usize) -> Vec<SurfacePoint> {
        if let Shape::Points(points) = &self.shape {
            return points.clone();
        }
        let (lo, hi) = self.range();
        let count = count.max(2);
        let last = (count - 1) as f64;
        let place = |index: usize| {
            let t = index as f64 / last;
            // Symmetric to the last bit about the middle, with exact ends.
            let u = if index + 1 == count { hi } else { lo * (1.0 - t) + hi * t };
            let share = if index == 0 || index + 1 == count { 0.5 } else { 1.0 };
            let mut point = self.along(u);
            point.weight *= share * (hi - lo) / last;
            point
        };
        (0..count).map(place).collect()
    }

    /// Ends of the surface's own coordinate: an angle (rad) on an arc, x or r (mm) elsewhere; both 0 for single points.
    pub fn range(&self) -> (f64, f64) {
        match &self.shape {
            Shape::Arc { angles, .. } => (angles[0], angles[1]),
            Shape::Strip { x, .. } | Shape::Rectangle { x, .. } => (x[0], x[1]),
            Shape::Annulus { radii } | Shape::Sector { radii, .. } => (radii[0], radii[1]),
            Shape::Ellipse { semi_axes } => (-semi_axes[0], semi_axes[0]),
            Shape::Points(_) => (0.0, 0.0),
        }
    }

    /// The point at a value of the surface's own coordinate (see [`Surface::range`]), on the middle line of a wide surface. Its weight is the
    /// area per unit of the coordinate.
    pub fn along(&self, u: f64) -> SurfacePoint {
        let up = Vector3::z();
        match &self.shape {
            Shape::Arc { .. } | Shape::Strip { .. } | Shape::Points(_) => self.at(u, 0.0),
            Shape::Annulus { .. } => self.point(Vector3::new(u, 0.0, 0.0), up, TAU * u),
            Shape::Sector { angles, .. } => {
                let (sine, cosine) = (0.5 * (angles[0] + angles[1])).sin_cos();
                self.point(Vector3::new(u * cosine, u * sine, 0.0), up, u * (angles[1] - angles[0]))
            }
            Shape::Rectangle { y, .. } => self.point(Vector3::new(u, 0.5 * (y[0] + y[1]), 0.0), up, y[1] - y[0]),
            Shape::Ellipse { semi_axes } => {
                let ratio = u / semi_axes[0];
                self.point(Vector3::new(u, 0.0, 0.0), up, 2.0 * semi_axes[1] * (1.0 - ratio * ratio).max(0.0).sqrt())
            }
        }
    }

    /// Area in mm^2.
    pub fn area(&self) -> f64 {
        match &self.shape {
            Shape::Points(points) => points.iter().map(|point| point.weight).sum(),
            Shape::Arc { radius, angles, thickness, .. } => radius * (angles[1] - angles[0]) * thickness,
            Shape::Strip { x, thickness, .. } => (x[1] - x[0]) * thickness,
            Shape::Annulus { radii } => 0.5 * TAU * (radii[1] - radii[0]) * (radii[1] + radii[0]),
            Shape::Sector { radii, angles } => 0.5 * (angles[1] - angles[0]) * (radii[1] - radii[0]) * (radii[1] + radii[0]),
            Shape::Rectangle { x, y } => (x[1] - x[0]) * (y[1] - y[0]),
            Shape::Ellipse { semi_axes } => 0.5 * TAU * semi_axes[0] * semi_axes[1],
        }
    }
}

/// Refuses vectors that are not finite.
fn finite(name: &'static str, vectors: &[Vector3<f64>]) -> Result<(), WearError> {
    match vectors.iter().flat_map(|v| v.iter()).find(|value| !value.is_finite()) {
        Some(value) => Err(WearError::OutOfRange { name, value: *value, wanted: "finite" }),
        None => Ok(()),
    }
}

/// Radii are parametrised by u = log(r / r_i), so that powers of r are exponentials of u; with r_i = 0 by log(r / r_e) from -300.
fn log_range(radii: &[f64; 2]) -> [f64; 2] {
    if radii[0] > 0.0 { [0.0, (radii[1] / radii[0]).ln()] } else { [-300.0, 0.0] }
}

fn log_radius(radii: &[f64; 2], u: f64) -> f64 {
    if radii[0] > 0.0 { (radii[0] * u.exp()).min(radii[1]) } else { radii[1] * u.exp() }
}
