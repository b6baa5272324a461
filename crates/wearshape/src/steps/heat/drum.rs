//! A ring that turns under body 1: its temperature is even along each circle, `T(r) = A + B ln r`, and follows from the heat per turn.

use hpfem::Eigenstrain;
use nalgebra::{Matrix2, Vector2};
use scene::Fault;

use crate::heat::{Carried, Drum, Heat};
use crate::stage::Stage;

/// The ring with its temperatures by the heat into it.
#[derive(Clone, Debug)]
pub(crate) struct WarmDrum {
    drum: Drum,
    /// Temperatures on the circle that touches and on the other one, without heat from the contact (degC).
    still: [f64; 2],
    /// What a unit of heat into it adds (K/mW).
    slope: [f64; 2],
    expansion: f64,
    /// Conductances (mW/K) and surroundings (degC) of both circles, touching first: none where the circle is held.
    films: [Option<(f64, f64)>; 2],
    /// Heat that a flux brings through the other circle (mW).
    flux: f64,
}

/// The names of a ring's edges.
const EDGES: [&str; 2] = ["inner", "outer"];

impl WarmDrum {
    /// The ring of a stage, of whose circumference the contact covers the length `arc` (mm).
    pub(crate) fn new(stage: Stage<'_>, heat: &Heat, drum: Drum, arc: f64) -> Result<WarmDrum, Fault> {
        let body = &stage.couple.bodies[1];
        let material = body.materials.first();
        let conductivity = material.and_then(|material| material.conductivity).map_or(0.0, |k| k.0);
        let expansion = material.and_then(|material| material.expansion).map_or(0.0, |alpha| alpha.0);
        let thickness = stage.couple.kinematics.thickness().unwrap_or(1.0);
        let around = |r: f64| std::f64::consts::TAU * r * thickness;
        let [touching, other] = [drum.touching(), 1 - drum.touching()];
        let covered = arc / (std::f64::consts::TAU * drum.radii[touching]);
        let carried = |circle: usize| heat.edges[1].get(EDGES[circle]).copied();
        let (mut films, mut flux, mut held) = ([Some((0.0, 0.0)); 2], 0.0, None);
        if let Some(Carried::Convection(film, ambient)) = carried(touching) {
            films[0] = Some((film * (1.0 - covered) * around(drum.radii[touching]), ambient));
        }
        match carried(other) {
            Some(Carried::Convection(film, ambient)) => films[1] = Some((film * around(drum.radii[other]), ambient)),
            Some(Carried::Flux(q)) => flux = q * around(drum.radii[other]),
            Some(Carried::Held(temperature)) => (films[1], held) = (None, Some(temperature)),
            None => {}
        }
        let through = conductivity * around(1.0) / (drum.radii[1] / drum.radii[0]).ln();
        let film = |circle: usize| films[circle].unwrap_or((0.0, 0.0));
        // Heat that arrives on each circle flows to the surroundings or through the ring.
        let mut matrix = Matrix2::new(film(0).0 + through, -through, -through, film(1).0 + through);
        let mut right = Vector2::new(film(0).0 * film(0).1, film(1).0 * film(1).1 + flux);
        if let Some(temperature) = held {
            (matrix[(1, 0)], matrix[(1, 1)], right[1]) = (0.0, through, through * temperature);
        }
        let none = || {
            let message = "nothing cools the ring that revolves outside of its contact";
            Fault::at("body2.heat", "no-temperature", message, "give convection or a temperature on its other edge")
        };
        let inverse = matrix.try_inverse().ok_or_else(none)?;
        let (still, slope) = (inverse * right, inverse * Vector2::new(1.0, 0.0));
        Ok(WarmDrum { drum, still: still.into(), slope: slope.into(), expansion, films, flux })
    }

    /// Temperature of the circle that touches: without heat from the contact (degC), and by a unit of it (K/mW).
    pub(crate) fn surface(&self) -> [f64; 2] {
        [self.still[0], self.slope[0]]
    }

    /// Temperatures of the circle that touches and of the other one under the heat into the ring (degC).
    fn temperatures(&self, heat: f64) -> [f64; 2] {
        [0, 1].map(|circle| self.still[circle] + heat * self.slope[circle])
    }

    /// Temperature at a point under the heat into the ring (degC).
    pub(crate) fn at(&self, heat: f64, x: [f64; 2]) -> f64 {
        self.between(self.temperatures(heat), x)
    }

    fn between(&self, [touching, other]: [f64; 2], x: [f64; 2]) -> f64 {
        let r = (x[0] - self.drum.centre[0]).hypot(x[1] - self.drum.centre[1]);
        let of = self.drum.touching();
        let [from, to] = [self.drum.radii[of], self.drum.radii[1 - of]];
        touching + (other - touching) * (r / from).ln() / (to / from).ln()
    }

    /// Thermal strain above a reference temperature under the heat into the ring.
    pub(crate) fn strain(&self, heat: f64, reference: f64) -> Eigenstrain {
        let (own, temperatures) = (self.clone(), self.temperatures(heat));
        Eigenstrain::thermal(&[self.expansion], move |place| own.between(temperatures, place.position) - reference)
    }

    /// Thermal strain by a unit of heat alone.
    pub(crate) fn unit_strain(&self) -> Eigenstrain {
        let own = self.clone();
        Eigenstrain::thermal(&[self.expansion], move |place| own.between(own.slope, place.position))
    }

    /// The highest temperature under the heat into the ring (degC), and a place of it.
    pub(crate) fn highest(&self, heat: f64) -> (f64, [f64; 2]) {
        let [touching, other] = self.temperatures(heat);
        let of = self.drum.touching();
        let (temperature, r) = if touching >= other { (touching, self.drum.radii[of]) } else { (other, self.drum.radii[1 - of]) };
        (temperature, [self.drum.centre[0], self.drum.centre[1] + r])
    }

    /// Heat that leaves through each circle under the heat into the ring (mW).
    pub(crate) fn out(&self, heat: f64) -> Vec<(String, f64)> {
        let temperatures = self.temperatures(heat);
        let of = self.drum.touching();
        let leaving = |circle: usize| self.films[circle].map(|(film, ambient)| film * (temperatures[circle] - ambient));
        let at_touching = leaving(0).unwrap_or(0.0);
        let at_other = leaving(1).map_or(heat - at_touching, |leaving| leaving - self.flux);
        let names = [EDGES[of], EDGES[1 - of]].map(|edge| format!("body2.{edge}"));
        names.into_iter().zip([at_touching, at_other]).filter(|(_, heat)| *heat != 0.0).collect()
    }
}

impl Drum {
    /// Which of the circles touches: 0 for the inner one.
    fn touching(&self) -> usize {
        usize::from(self.outside)
    }
}
