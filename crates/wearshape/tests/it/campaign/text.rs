//! The text of a scene.

use super::blocks;
use super::case::{Body, Case, Shape};
use super::gmsh;
use super::numbers::Writing;
use super::warm::Warm;

impl Case {
    /// Names and bytes of the files that the scene names.
    pub(super) fn files(&self) -> Vec<(String, Vec<u8>)> {
        let file = |(number, body): (usize, &Body)| match &body.shape {
            Shape::Gmsh { x, z, numbering } => Some((format!("body{number}.msh"), gmsh::file([x, z], *numbering).into_bytes())),
            _ => None,
        };
        (1..).zip(&self.bodies).filter_map(file).collect()
    }

    /// As a scene file.
    pub(super) fn text(&self, writing: Writing) -> String {
        let Case { kinematics, task, degree, layers, edges, friction, functional, .. } = self;
        let [a, b] = self.exponents;
        let (key, value) = self.sliding;
        let value = if key == "speed" { writing.speed(value) } else { format!("{value:?}") };
        let mut text = format!(
            "units = \"N-mm\"\nkinematics = \"{kinematics}\"\ntasks = [\"{task}\"]\nmesh = {{ degree = {degree}, layers = {layers} }}\ncheck = false\n"
        );
        if *kinematics != "axisymmetric" {
            text += &format!("thickness = {}\n", writing.length(self.thickness));
        }
        text += &format!("contact = {{ edges = {edges:?}, friction = {friction:?}, gap = {} }}\n", self.gap_text(writing));
        text += &self.load_text(writing);
        if !matches!(self.bodies[0].shape, Shape::Disc { .. }) {
            // Under a load alone it does not slide.
            text += &format!("sliding = {{ {key} = {value} }}\n");
        }
        let until = if *task == "wear" { format!(", until = {}", writing.time(self.until)) } else { String::new() };
        text += &format!("wear = {{ beta = {:?}, a = {a:?}, b = {b:?}{until} }}\n", self.factors);
        text += &format!("optimum = {{ functional = \"{functional}\" }}\n");
        text += &self.heat.as_ref().map(|heat| heat.text(writing)).unwrap_or_default();
        for (number, body) in self.bodies.iter().enumerate() {
            text += &body_text(number + 1, (body, self.heat.as_ref()), writing);
        }
        text
    }

    fn gap_text(&self, writing: Writing) -> String {
        let Some([crown, tilt]) = self.gap else { return "0".into() };
        format!("{{ crown = {}, tilt = {tilt:?} }}", writing.length(crown))
    }

    fn load_text(&self, writing: Writing) -> String {
        let load = &self.load;
        let mut text = format!("load = {{ edge = \"top\", as = \"{}\", force = {}", load.kind, writing.force(load.force));
        if let Some((moment, about)) = load.moment {
            text += &format!(", moment = {}, about = {}", writing.moment(moment), writing.lengths(about));
        }
        if let Some(tilt) = load.tilt {
            text += &format!(", tilt = {tilt:?}");
        }
        text + " }\n"
    }
}

fn body_text(number: usize, (body, heat): (&Body, Option<&Warm>), writing: Writing) -> String {
    let (young, thermal) = (writing.young(body.young), heat.map(|heat| heat.material(number - 1, writing)).unwrap_or_default());
    let mut text = format!("[body{number}]\nmaterial = {{ young = {young}, poisson = {:?}{thermal} }}\n", body.poisson);
    text += &heat.map(|heat| heat.body(number - 1, &body.shape, writing)).unwrap_or_default();
    for (edge, held) in &body.support {
        text += &format!("support.{edge} = {held}\n");
    }
    text + &match &body.shape {
        Shape::Rectangle { x, z } => {
            format!("geometry.rectangle = {{ x = {}, z = {} }}\n", writing.lengths(*x), writing.lengths(*z))
        }
        Shape::Cells { x, z, naming } => blocks::tables(number, [x, z], *naming, writing),
        Shape::Gmsh { .. } => format!("geometry.mesh.file = \"body{number}.msh\"\n"),
        Shape::Pinned { radii, angles, pin } => pinned([radii[0], radii[1]], *angles, *pin),
        Shape::Disc { radius, x } => format!(
            "geometry.half-disc = {{ radius = {}, centre = {} }}\n",
            writing.length(*radius),
            writing.lengths([*x, *radius])
        ),
        Shape::Shoe { radius, half_angle, top } => format!(
            "geometry.shoe-block = {{ radius = {}, half_angle = {half_angle:?}, top = {} }}\n",
            writing.length(*radius),
            writing.length(*top)
        ),
        Shape::Ring { inner, outer } => {
            format!("geometry.ring = {{ inner = {}, outer = {} }}\n", writing.length(*inner), writing.length(*outer))
        }
    }
}

/// The cells of a shoe on a pin, and the pin.
fn pinned([inner, outer]: [f64; 2], angles: [f64; 3], pin: f64) -> String {
    let at = |radius: f64, angle: f64| [radius * angle.sin(), radius * angle.cos()];
    let mut text = format!("support.seat = {{ pin = {:?} }}\n[body1.geometry.blocks.points]\n", at(1.1 * outer, pin));
    for (i, angle) in angles.into_iter().enumerate() {
        text += &format!("i{i} = {:?}\no{i} = {:?}\n", at(inner, angle), at(outer, angle));
    }
    text += "[body1.geometry.blocks.curves]\n";
    text += &(0..3).map(|i| format!("r{i}.line = [\"i{i}\", \"o{i}\"]\n")).collect::<String>();
    for (i, j) in [(0, 1), (1, 2)] {
        text += &format!("inner{i}.arc.ends = [\"i{i}\", \"i{j}\"]\nouter{i}.arc.ends = [\"o{i}\", \"o{j}\"]\n");
    }
    text += "[body1.geometry.blocks.cells]\n";
    text += "a.curves = [\"inner0\", \"r1\", \"outer0\", \"r0\"]\nb.curves = [\"inner1\", \"r2\", \"outer1\", \"r1\"]\n";
    text + "[body1.geometry.blocks.edges]\ninner = [\"inner0\", \"inner1\"]\nseat = [\"outer0\"]\ntop = [\"outer1\"]\n"
}
