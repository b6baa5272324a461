//! Frictional heat of a checked scene: how the bodies share it, what carries it away, and from which temperature they expand.

use std::collections::BTreeMap;

/// Frictional heat, with every default filled in.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Heat {
    /// What decides how much goes into each body.
    pub split: Split,
    /// Temperature of the cold shape (degC).
    pub reference: f64,
    /// How body 2 meets the heat of body 1.
    pub meets: Meets,
    /// What carries heat through the edges of each body, by name; all others are insulated.
    pub edges: [BTreeMap<String, Carried>; 2],
}

impl Heat {
    /// Whether bodies without friction have one temperature everywhere: nothing flows through them then that bends them.
    pub(crate) fn is_even_without_friction(&self) -> bool {
        let fresh = if let Meets::Fresh(temperature) = self.meets { Some(temperature) } else { None };
        let mut temperatures: Vec<f64> = fresh.into_iter().collect();
        for carried in self.edges.iter().flat_map(BTreeMap::values) {
            match *carried {
                Carried::Held(temperature) => temperatures.push(temperature),
                Carried::Convection(film, ambient) if film > 0.0 => temperatures.push(ambient),
                Carried::Convection(..) => {}
                Carried::Flux(flux) if flux != 0.0 => return false,
                Carried::Flux(_) => {}
            }
        }
        temperatures.windows(2).all(|pair| pair[0] == pair[1])
    }
}

/// What decides how much of the heat goes into each body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Split {
    /// The share of body 1, from 0 to 1.
    Share(f64),
    /// A conductance of the contact (mW/(mm^2 K)) between halves of the source; infinite for one temperature on both surfaces.
    Conductance(f64),
}

/// How body 2 meets the heat of body 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Meets {
    /// The same points meet.
    Congruent,
    /// Body 2 is a ring that turns under body 1: its temperature is even along each circle.
    Revolving(Drum),
    /// Body 2 arrives everywhere at one temperature (degC) and is not distorted.
    Fresh(f64),
}

/// A ring that turns under body 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Drum {
    /// Inner and outer radius (mm).
    pub radii: [f64; 2],
    /// Whether its outer circle is the one that touches.
    pub outside: bool,
    /// Its centre (mm).
    pub centre: [f64; 2],
}

/// What carries heat through an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Carried {
    /// Held at a temperature (degC).
    Held(f64),
    /// Convection: coefficient (mW/(mm^2 K)) and temperature of the surroundings (degC).
    Convection(f64, f64),
    /// Flux into the body (mW/mm^2).
    Flux(f64),
}

impl Carried {
    /// Whether it fixes a temperature.
    pub(crate) fn cools(self) -> bool {
        match self {
            Carried::Held(_) => true,
            Carried::Convection(film, _) => film > 0.0,
            Carried::Flux(_) => false,
        }
    }
}
