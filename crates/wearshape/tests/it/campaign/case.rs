//! A random scene as data, and what mirrors, scales and swaps it.

use super::warm::Warm;

/// Shape of a body.
#[derive(Debug, Clone)]
pub(super) enum Shape {
    /// A rectangle, by its template.
    Rectangle { x: [f64; 2], z: [f64; 2] },
    /// A rectangle cut into cells at these places; names and directions of points, curves and cells follow from the seed.
    Cells { x: Vec<f64>, z: Vec<f64>, naming: u64 },
    /// A block above a drum.
    Shoe { radius: f64, half_angle: f64, top: f64 },
    /// The same as a gmsh file, in which nodes and elements have the numbers and the order of the seed.
    Gmsh { x: Vec<f64>, z: Vec<f64>, numbering: u64 },
    /// A shoe on a pin beside it, around a drum: cells between two radii and angles from the z axis; the middle one parts what the pin holds from what is
    /// loaded.
    Pinned { radii: [f64; 2], angles: [f64; 3], pin: f64 },
    /// The lower half of a disc or ball that stands on z = 0.
    Disc { radius: f64, x: f64 },
    /// The drum.
    Ring { inner: f64, outer: f64 },
}

/// One body.
#[derive(Debug, Clone)]
pub(super) struct Body {
    pub shape: Shape,
    pub young: f64,
    pub poisson: f64,
    /// Edge and held components.
    pub support: Vec<(&'static str, &'static str)>,
}

/// The load on body 1.
#[derive(Debug, Clone)]
pub(super) struct Load {
    pub kind: &'static str,
    pub force: f64,
    /// Moment about a point.
    pub moment: Option<(f64, [f64; 2])>,
    /// Rotation of a rigid edge.
    pub tilt: Option<f64>,
}

/// A scene.
#[derive(Debug, Clone)]
pub(super) struct Case {
    pub kinematics: &'static str,
    pub thickness: f64,
    pub task: &'static str,
    pub degree: usize,
    pub layers: usize,
    pub bodies: [Body; 2],
    pub edges: [&'static str; 2],
    pub friction: f64,
    /// Crown (mm) and tilt (rad) of the start gap.
    pub gap: Option<[f64; 2]>,
    /// Key and value of the motion.
    pub sliding: (&'static str, f64),
    pub load: Load,
    pub factors: [f64; 2],
    /// Exponents of speed and pressure.
    pub exponents: [f64; 2],
    /// End of a run in time.
    pub until: f64,
    pub functional: &'static str,
    /// Frictional heat.
    pub heat: Option<Warm>,
}

fn mirrored_places(places: &[f64]) -> Vec<f64> {
    places.iter().rev().map(|x| -x).collect()
}

fn turned([from, to]: [f64; 2]) -> [f64; 2] {
    [-to, -from]
}

impl Shape {
    fn mirrored(&self) -> Shape {
        match self.clone() {
            Shape::Rectangle { x, z } => Shape::Rectangle { x: turned(x), z },
            Shape::Cells { x, z, naming } => Shape::Cells { x: mirrored_places(&x), z, naming },
            Shape::Disc { radius, x } => Shape::Disc { radius, x: -x },
            other => other,
        }
    }

    fn upside_down(&self) -> Shape {
        match self.clone() {
            Shape::Rectangle { x, z } => Shape::Rectangle { x, z: turned(z) },
            Shape::Cells { x, z, naming } => Shape::Cells { x, z: mirrored_places(&z), naming },
            other => other,
        }
    }

    fn scaled(&self, by: f64) -> Shape {
        let pair = |values: [f64; 2]| values.map(|v| by * v);
        let list = |values: &[f64]| values.iter().map(|v| by * v).collect();
        match self {
            Shape::Rectangle { x, z } => Shape::Rectangle { x: pair(*x), z: pair(*z) },
            Shape::Cells { x, z, naming } => Shape::Cells { x: list(x), z: list(z), naming: *naming },
            Shape::Gmsh { x, z, numbering } => Shape::Gmsh { x: list(x), z: list(z), numbering: *numbering },
            Shape::Pinned { radii, angles, pin } => Shape::Pinned { radii: pair(*radii), angles: *angles, pin: *pin },
            Shape::Disc { radius, x } => Shape::Disc { radius: by * radius, x: by * x },
            Shape::Shoe { radius, half_angle, top } => {
                Shape::Shoe { radius: by * radius, half_angle: *half_angle, top: by * top }
            }
            Shape::Ring { inner, outer } => Shape::Ring { inner: by * inner, outer: by * outer },
        }
    }
}

impl Case {
    /// Whether ends of contact inside the surface are searched: to the accuracy of the scene, and from a start that round-off may move to the next
    /// point. Their answers are compared by their estimated errors.
    pub(super) fn has_free_ends(&self) -> bool {
        self.gap.is_some() || matches!(self.bodies[0].shape, Shape::Disc { .. })
    }

    /// As seen in a mirror at x = 0; an axisymmetric scene turns the other way.
    pub(super) fn mirrored(&self) -> Case {
        let mut twin = self.clone();
        twin.sliding.1 *= -1.0;
        if self.kinematics == "axisymmetric" {
            return twin;
        }
        for body in &mut twin.bodies {
            body.shape = body.shape.mirrored();
            for (edge, _) in &mut body.support {
                *edge = match *edge {
                    "left" => "right",
                    "right" => "left",
                    other => other,
                };
            }
        }
        twin.gap = twin.gap.map(|[crown, tilt]| [crown, -tilt]);
        twin.load.moment = twin.load.moment.map(|(moment, [x, z])| (-moment, [-x, z]));
        twin.load.tilt = twin.load.tilt.map(|tilt| -tilt);
        twin
    }

    /// Lengths times `length`, stresses times `stress`, times as they are.
    pub(super) fn scaled(&self, length: f64, stress: f64) -> Case {
        let mut twin = self.clone();
        for body in &mut twin.bodies {
            body.shape = body.shape.scaled(length);
            body.young *= stress;
        }
        twin.thickness *= length;
        twin.gap = twin.gap.map(|[crown, tilt]| [length * crown, tilt]);
        twin.load.force *= stress * length.powi(2);
        twin.load.moment = twin.load.moment.map(|(moment, about)| (stress * length.powi(3) * moment, about.map(|x| length * x)));
        if self.sliding.0 == "speed" {
            twin.sliding.1 *= length;
        }
        // w' = beta (mu p)^b v^a is a length in a time.
        let [a, b] = self.exponents;
        let factor = length.powf(1.0 - a) * stress.powf(-b);
        twin.factors = self.factors.map(|beta| factor * beta);
        twin.heat = self.heat.as_ref().map(|heat| heat.scaled(length, stress));
        twin
    }

    /// z to -z with the bodies exchanged: a body held at its bottom becomes one under a rigid top.
    pub(super) fn swapped(&self) -> Case {
        let mut twin = self.clone();
        for (new, old) in twin.bodies.iter_mut().zip(self.bodies.iter().rev()) {
            new.shape = old.shape.upside_down();
            (new.young, new.poisson) = (old.young, old.poisson);
        }
        twin
    }

    /// Another naming of points, curves and cells, and other directions.
    pub(super) fn renamed(&self, seed: u64) -> Case {
        let mut twin = self.clone();
        for body in &mut twin.bodies {
            if let Shape::Cells { naming, .. } = &mut body.shape {
                *naming = seed;
            }
        }
        twin
    }

    /// Its cells as gmsh files, numbered by a seed.
    pub(super) fn numbered(&self, seed: u64) -> Case {
        let mut twin = self.clone();
        for body in &mut twin.bodies {
            if let Shape::Cells { x, z, .. } = body.shape.clone() {
                body.shape = Shape::Gmsh { x, z, numbering: seed };
            }
        }
        twin
    }

    /// Turned about the origin, clockwise.
    pub(super) fn turned(&self, by: f64) -> Case {
        let mut twin = self.clone();
        for body in &mut twin.bodies {
            if let Shape::Pinned { angles, pin, .. } = &mut body.shape {
                angles.iter_mut().for_each(|angle| *angle += by);
                *pin += by;
            }
        }
        twin
    }

    /// Every cell cut into four.
    pub(super) fn split(&self) -> Case {
        let halved = |places: &[f64]| {
            let mut new: Vec<f64> = places.windows(2).flat_map(|ends| [ends[0], 0.5 * (ends[0] + ends[1])]).collect();
            new.extend(places.last());
            new
        };
        let mut twin = self.clone();
        for body in &mut twin.bodies {
            if let Shape::Cells { x, z, .. } = &mut body.shape {
                (*x, *z) = (halved(x), halved(z));
            }
        }
        twin
    }
}
