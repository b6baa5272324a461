//! A point of `geometry.blocks`: [x, z], or radius and angle about a centre.

use std::fmt;

use serde::de::{self, Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use serde::{Serialize, Serializer};

use crate::units::{Angle, Length};

/// A point of the plane.
#[derive(Debug, Clone, PartialEq)]
pub enum PointShape {
    /// x and z.
    At([Length; 2]),
    /// On a circle.
    Polar(PolarPoint),
}

/// A point on a circle.
#[derive(Debug, Clone, PartialEq, serde::Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PolarPoint {
    /// Distance from the centre (mm).
    pub radius: Length,
    /// Angle from the z axis towards +x.
    pub angle: Angle,
    /// Centre [x, z]. Default the origin.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre: Option<[Length; 2]>,
}

impl PointShape {
    /// Position [x, z] in mm.
    pub fn position(&self) -> [f64; 2] {
        match self {
            PointShape::At(x) => x.map(|x| x.0),
            PointShape::Polar(PolarPoint { radius, angle, centre }) => {
                let centre = centre.map_or([0.0; 2], |c| c.map(|c| c.0));
                [centre[0] + radius.0 * angle.0.sin(), centre[1] + radius.0 * angle.0.cos()]
            }
        }
    }
}

impl<'de> Deserialize<'de> for PointShape {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct PointVisitor;
        impl<'de> Visitor<'de> for PointVisitor {
            type Value = PointShape;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a point: [x, z], or { radius = 200, angle = \"30 deg\" } from the z axis towards +x")
            }

            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<PointShape, A::Error> {
                <[Length; 2]>::deserialize(de::value::SeqAccessDeserializer::new(list)).map(PointShape::At)
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<PointShape, A::Error> {
                PolarPoint::deserialize(de::value::MapAccessDeserializer::new(map)).map(PointShape::Polar)
            }
        }
        deserializer.deserialize_any(PointVisitor)
    }
}

impl Serialize for PointShape {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            PointShape::At(x) => x.serialize(serializer),
            PointShape::Polar(point) => point.serialize(serializer),
        }
    }
}
