//! Frictional heat of a random scene.

use super::case::{Case, Shape};
use super::draw::Random;
use super::numbers::Writing;

/// How the friction warms both bodies, which are at 0 degC without it.
#[derive(Debug, Clone)]
pub(super) struct Warm {
    /// Key and value of what shares the heat: a share, or a conductance, mW/(mm2 K).
    split: (&'static str, f64),
    counterface: &'static str,
    /// Of each body, mW/(mm K).
    conductivity: [f64; 2],
    /// Of each body, 1/K.
    expansion: [f64; 2],
    /// Of the edge of each body away from the contact, mW/(mm2 K).
    convection: [f64; 2],
}

/// One scene of so many has heat where it may.
const ONE_OF: usize = 5;

impl Warm {
    /// Heat for some scenes. It distorts the surfaces by a part of what the load does, so that the speed is below the critical one, mostly.
    pub(super) fn drawn(case: &Case, random: &mut Random) -> Option<Warm> {
        let (counterface, width, radius, area) = match case.bodies[0].shape {
            Shape::Rectangle { x: [inner, outer], .. } if case.kinematics == "axisymmetric" => {
                ("congruent", outer - inner, outer, std::f64::consts::PI * (outer * outer - inner * inner))
            }
            Shape::Rectangle { x: [from, to], .. } => ("fresh", to - from, 0.0, (to - from) * case.thickness),
            Shape::Shoe { radius, half_angle, .. } => {
                let width = 2.0 * radius * half_angle.sin();
                ("revolving", width, radius, width * case.thickness)
            }
            _ => return None,
        };
        if case.task == "pressure" || random.below(ONE_OF) > 0 {
            return None;
        }
        let speed = case.sliding.1.abs() * if case.sliding.0 == "speed" { 1.0 } else { radius };
        let pressure = case.load.force / area;
        let (rise, part) = (random.within(1.0, 50.0), random.scale(1e-2, 0.3));
        let first = case.friction * pressure * speed * width / rise;
        let conductivity = [first, first * random.scale(0.1, 10.0)];
        let split = match random.below(2) {
            1 if counterface != "fresh" => ("conductance", first / width * random.scale(1e-2, 1e2)),
            _ => ("share", random.within(0.05, 0.95)),
        };
        Some(Warm {
            split,
            counterface,
            conductivity,
            expansion: case.bodies.each_ref().map(|body| part * pressure / (body.young * rise)),
            convection: conductivity.map(|k| k / width * random.scale(0.3, 10.0)),
        })
    }

    /// Lengths times `length`, stresses times `stress`, times and temperatures as they are.
    pub(super) fn scaled(&self, length: f64, stress: f64) -> Warm {
        let film = |h: f64| stress * length * h;
        let (key, value) = self.split;
        Warm {
            split: (key, if key == "share" { value } else { film(value) }),
            conductivity: self.conductivity.map(|k| stress * length.powi(2) * k),
            convection: self.convection.map(film),
            ..self.clone()
        }
    }

    /// The table of the scene.
    pub(super) fn text(&self, writing: Writing) -> String {
        let (key, value) = self.split;
        let value = if key == "share" { format!("{value:?}") } else { writing.film(value) };
        format!("heat = {{ {key} = {value}, counterface = \"{}\", reference = 0 }}\n", self.counterface)
    }

    /// The keys of a body's material.
    pub(super) fn material(&self, number: usize, writing: Writing) -> String {
        let conductivity = writing.conductivity(self.conductivity[number]);
        format!(", conductivity = {conductivity}, expansion = {:?}", self.expansion[number])
    }

    /// The key of a body.
    pub(super) fn body(&self, number: usize, shape: &Shape, writing: Writing) -> String {
        let edge = match (number, shape) {
            (0, _) => "top",
            (_, Shape::Ring { .. }) => "inner",
            _ => "bottom",
        };
        format!("heat = {{ {edge} = {{ convection = {}, ambient = 0 }} }}\n", writing.film(self.convection[number]))
    }
}
