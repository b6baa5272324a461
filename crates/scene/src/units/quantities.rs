//! What a scene measures: every quantity with its units, and the type that holds it in base units. One more is a dimension and a type here.

use serde::de::{Deserialize, Deserializer};
use serde::{Serialize, Serializer};

use super::QuantityVisitor;
use super::dimension::Dimension;
#[cfg(feature = "schema")]
use super::dimension::schema_of;

pub(crate) const LENGTH: Dimension = Dimension {
    word: "length",
    base: "mm",
    units: &[
        ("mm", 1.0, 1.0),
        ("m", 1e3, 1.0),
        ("cm", 10.0, 1.0),
        ("um", 1.0, 1e3),
        ("µm", 1.0, 1e3),
        ("nm", 1.0, 1e6),
        ("in", 25.4, 1.0),
        ("km", 1e6, 1.0),
    ],
};
pub(crate) const FORCE: Dimension =
    Dimension { word: "force", base: "N", units: &[("N", 1.0, 1.0), ("kN", 1e3, 1.0), ("MN", 1e6, 1.0), ("mN", 1.0, 1e3)] };
pub(crate) const PRESSURE: Dimension = Dimension {
    word: "pressure or modulus",
    base: "MPa",
    units: &[("MPa", 1.0, 1.0), ("GPa", 1e3, 1.0), ("kPa", 1.0, 1e3), ("Pa", 1.0, 1e6), ("bar", 1.0, 10.0), ("N/mm^2", 1.0, 1.0)],
};
pub(crate) const ANGLE: Dimension = Dimension {
    word: "angle",
    base: "rad",
    units: &[("rad", 1.0, 1.0), ("deg", std::f64::consts::PI, 180.0), ("mrad", 1.0, 1e3)],
};
pub(crate) const SPEED: Dimension = Dimension {
    word: "speed",
    base: "mm/s",
    units: &[("mm/s", 1.0, 1.0), ("m/s", 1e3, 1.0), ("um/s", 1.0, 1e3), ("m/min", 1e3, 60.0), ("km/h", 1e6, 3600.0)],
};
pub(crate) const ACCELERATION: Dimension = Dimension {
    word: "acceleration",
    base: "mm/s^2",
    units: &[("mm/s^2", 1.0, 1.0), ("mm/s2", 1.0, 1.0), ("m/s^2", 1e3, 1.0), ("m/s2", 1e3, 1.0), ("gn", 9806.65, 1.0)],
};
pub(crate) const ANGULAR_SPEED: Dimension = Dimension {
    word: "angular speed",
    base: "rad/s",
    units: &[
        ("rad/s", 1.0, 1.0),
        ("rpm", std::f64::consts::PI, 30.0),
        ("1/min", std::f64::consts::PI, 30.0),
        ("deg/s", std::f64::consts::PI, 180.0),
    ],
};
pub(crate) const TIME: Dimension =
    Dimension { word: "time", base: "s", units: &[("s", 1.0, 1.0), ("ms", 1.0, 1e3), ("min", 60.0, 1.0), ("h", 3600.0, 1.0)] };
pub(crate) const MOMENT: Dimension = Dimension {
    word: "moment",
    base: "N mm",
    units: &[("N mm", 1.0, 1.0), ("N m", 1e3, 1.0), ("kN mm", 1e3, 1.0), ("kN m", 1e6, 1.0), ("Nmm", 1.0, 1.0), ("Nm", 1e3, 1.0)],
};
pub(crate) const DENSITY: Dimension = Dimension {
    word: "density",
    base: "t/mm^3",
    units: &[
        ("kg/m^3", 1.0, 1e12),
        ("kg/m3", 1.0, 1e12),
        ("g/cm^3", 1.0, 1e9),
        ("g/cm3", 1.0, 1e9),
        ("t/m^3", 1.0, 1e9),
        ("t/m3", 1.0, 1e9),
        ("t/mm^3", 1.0, 1.0),
    ],
};
pub(crate) const VOLUME: Dimension =
    Dimension { word: "volume", base: "mm^3", units: &[("mm^3", 1.0, 1.0), ("cm^3", 1e3, 1.0), ("um^3", 1.0, 1e9)] };
pub(crate) const FREQUENCY: Dimension = Dimension {
    word: "frequency",
    base: "cycles a second",
    units: &[("Hz", 1.0, 1.0), ("kHz", 1e3, 1.0), ("1/s", 1.0, 1.0), ("1/min", 1.0, 60.0), ("1/h", 1.0, 3600.0)],
};
pub(crate) const TEMPERATURE: Dimension =
    Dimension { word: "temperature", base: "degC", units: &[("degC", 1.0, 1.0), ("°C", 1.0, 1.0)] };
pub(crate) const CONDUCTIVITY: Dimension = Dimension {
    word: "conductivity",
    base: "mW/(mm K)",
    units: &[("W/(m K)", 1.0, 1.0), ("mW/(mm K)", 1.0, 1.0), ("W/(mm K)", 1e3, 1.0), ("W/m/K", 1.0, 1.0)],
};
pub(crate) const EXPANSION: Dimension = Dimension {
    word: "thermal expansion",
    base: "1/K",
    units: &[("1/K", 1.0, 1.0), ("/K", 1.0, 1.0), ("um/(m K)", 1.0, 1e6), ("ppm/K", 1.0, 1e6), ("1/degC", 1.0, 1.0)],
};
pub(crate) const HEAT_TRANSFER: Dimension = Dimension {
    word: "coefficient of heat transfer",
    base: "mW/(mm^2 K)",
    units: &[
        ("W/(m2 K)", 1.0, 1e3),
        ("W/(m^2 K)", 1.0, 1e3),
        ("kW/(m2 K)", 1.0, 1.0),
        ("kW/(m^2 K)", 1.0, 1.0),
        ("mW/(mm2 K)", 1.0, 1.0),
        ("mW/(mm^2 K)", 1.0, 1.0),
        ("W/(mm2 K)", 1e3, 1.0),
        ("W/(mm^2 K)", 1e3, 1.0),
    ],
};
pub(crate) const HEAT_FLUX: Dimension = Dimension {
    word: "heat flux",
    base: "mW/mm^2",
    units: &[
        ("W/m2", 1.0, 1e3),
        ("W/m^2", 1.0, 1e3),
        ("kW/m2", 1.0, 1.0),
        ("kW/m^2", 1.0, 1.0),
        ("mW/mm2", 1.0, 1.0),
        ("mW/mm^2", 1.0, 1.0),
        ("W/mm2", 1e3, 1.0),
        ("W/mm^2", 1e3, 1.0),
        ("W/cm2", 10.0, 1.0),
        ("W/cm^2", 10.0, 1.0),
    ],
};
pub(crate) const WEAR_FACTOR: Dimension = Dimension {
    word: "wear factor",
    base: "mm^2/N (for a = b = 1)",
    units: &[
        ("mm^3/(N mm)", 1.0, 1.0),
        ("mm^3/(N m)", 1.0, 1e3),
        ("mm^3/N/m", 1.0, 1e3),
        ("m^3/(N m)", 1e6, 1.0),
        ("mm^2/N", 1.0, 1.0),
        ("m^2/N", 1e6, 1.0),
        ("1/MPa", 1.0, 1.0),
        ("1/Pa", 1e6, 1.0),
    ],
};

macro_rules! quantity {
    ($(#[$doc:meta])* $name:ident, $dimension:ident) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
        pub struct $name(pub f64);

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(QuantityVisitor(&$dimension)).map(|(number, _)| $name(number))
            }
        }

        impl Serialize for $name {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_f64(self.0)
            }
        }

        #[cfg(feature = "schema")]
        impl schemars::JsonSchema for $name {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($name).into()
            }

            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                schema_of(&$dimension)
            }
        }
    };
}

quantity!(
    /// A length in mm.
    Length, LENGTH
);
quantity!(
    /// A force in N.
    Force, FORCE
);
quantity!(
    /// A pressure or modulus in MPa.
    Pressure, PRESSURE
);
quantity!(
    /// An angle in rad.
    Angle, ANGLE
);
quantity!(
    /// A speed in mm/s.
    Speed, SPEED
);
quantity!(
    /// An acceleration in mm/s^2.
    Acceleration, ACCELERATION
);
quantity!(
    /// An angular speed in rad/s.
    AngularSpeed, ANGULAR_SPEED
);
quantity!(
    /// A time in s.
    Time, TIME
);
quantity!(
    /// A moment in N mm.
    Moment, MOMENT
);
quantity!(
    /// A density in t/mm^3, that is N s^2/mm^4.
    Density, DENSITY
);
quantity!(
    /// A volume in mm^3.
    Volume, VOLUME
);
quantity!(
    /// A frequency in cycles a second.
    Frequency, FREQUENCY
);
quantity!(
    /// A temperature in degC.
    Temperature, TEMPERATURE
);
quantity!(
    /// A conductivity of heat in mW/(mm K), that is W/(m K).
    Conductivity, CONDUCTIVITY
);
quantity!(
    /// A linear thermal expansion in 1/K.
    Expansion, EXPANSION
);
quantity!(
    /// A coefficient of heat transfer in mW/(mm^2 K), that is 1000 W/(m^2 K).
    HeatTransfer, HEAT_TRANSFER
);
quantity!(
    /// A heat flux in mW/mm^2.
    HeatFlux, HEAT_FLUX
);

/// A wear factor. A bare number has the unit that the exponents a and b give it; a unit fixes a = b = 1.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WearFactor {
    /// The number in N, mm, s.
    pub value: f64,
    /// Whether it was written with a unit of specific wear rate.
    pub has_unit: bool,
}

impl<'de> Deserialize<'de> for WearFactor {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let (value, has_unit) = deserializer.deserialize_any(QuantityVisitor(&WEAR_FACTOR))?;
        Ok(WearFactor { value, has_unit })
    }
}

impl Serialize for WearFactor {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_f64(self.value)
    }
}

#[cfg(feature = "schema")]
impl schemars::JsonSchema for WearFactor {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "WearFactor".into()
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schema_of(&WEAR_FACTOR)
    }
}
