//! The JSON schema of the types that are read by hand: what editors complete and check.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};

use crate::gap::{Gap, Until};
use crate::gap_sum::{Columns, GapSum, Rows};
use crate::known::known_materials;
use crate::layer::Layer;
use crate::material::{Material, Numbers};
use crate::point_shape::{PointShape, PolarPoint};
use crate::support::{Component, Support};
use crate::units::dimension::{pattern, schema_of};
use crate::units::quantities::{HEAT_TRANSFER, LENGTH, TIME, VOLUME};
use crate::units::{Angle, Axes, Conductance, Length, Pair, Scale, Steps};

/// Asks for a degree where a mesh is given without an accuracy.
pub(crate) fn mesh_or_accuracy(scene: &mut Schema) {
    let no_degree = json_schema!({ "required": ["mesh"], "properties": { "mesh": { "not": { "required": ["degree"] } } } });
    scene.insert("if".into(), no_degree.to_value());
    scene.insert("then".into(), json_schema!({ "required": ["accuracy"] }).to_value());
}

impl JsonSchema for Conductance {
    fn schema_name() -> Cow<'static, str> {
        "Conductance".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": format!("\"inf\", or {}", HEAT_TRANSFER.expected()),
            "anyOf": [{ "const": "inf" }, { "type": "number" }, { "type": "string", "pattern": pattern(&HEAT_TRANSFER) }]
        })
    }
}

impl JsonSchema for Scale {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Scale".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let units: Vec<&str> = LENGTH.units.iter().map(|unit| unit.0).collect();
        json_schema!({ "anyOf": [{ "type": "number" }, { "enum": units }] })
    }
}

impl JsonSchema for Gap {
    fn schema_name() -> Cow<'static, str> {
        "Gap".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let sum = generator.subschema_for::<GapSum>();
        json_schema!({
            "anyOf": [
                { "type": "number" },
                { "type": "string" },
                sum,
                {
                    "type": "object",
                    "properties": {
                        "s_mm": { "type": "array", "items": { "type": "number" }, "minItems": 2 },
                        "gap_um": { "type": "array", "items": { "type": "number", "minimum": 0 }, "minItems": 2 }
                    },
                    "required": ["s_mm", "gap_um"],
                    "additionalProperties": false
                }
            ]
        })
    }
}

impl JsonSchema for Rows {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Rows".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let columns = generator.subschema_for::<Columns>();
        json_schema!({ "anyOf": [{ "type": "string" }, columns] })
    }
}

impl JsonSchema for Until {
    fn schema_name() -> Cow<'static, str> {
        "Until".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let table = json_schema!({
            "type": "object",
            "properties": {
                "time": schema_of(&TIME),
                "distance": schema_of(&LENGTH),
                "revolutions": { "type": "number", "exclusiveMinimum": 0 },
                "depth": schema_of(&LENGTH),
                "volume": schema_of(&VOLUME)
            },
            "minProperties": 1,
            "maxProperties": 1,
            "additionalProperties": false
        });
        let time = json_schema!({ "type": "string", "pattern": pattern(&TIME) });
        json_schema!({ "anyOf": [{ "const": "steady" }, { "type": "number" }, time, table] })
    }
}

impl JsonSchema for Layer {
    fn schema_name() -> Cow<'static, str> {
        "Layer".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "anyOf": [schema_of(&LENGTH), { "type": "string", "pattern": "^[A-Za-z]" }] })
    }
}

impl JsonSchema for Material {
    fn schema_name() -> Cow<'static, str> {
        "Material".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let names: Vec<String> = known_materials().into_iter().map(|material| material.name).collect();
        json_schema!({ "anyOf": [generator.subschema_for::<Numbers>(), { "enum": names }] })
    }
}

impl JsonSchema for Support {
    fn schema_name() -> Cow<'static, str> {
        "Support".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let components = generator.subschema_for::<Vec<Component>>();
        let (at, angle) = (generator.subschema_for::<[Length; 2]>(), generator.subschema_for::<Angle>());
        let table = |key: &str, value: Schema| json_schema!({ "type": "object", "properties": { key: value }, "required": [key], "additionalProperties": false });
        json_schema!({ "anyOf": [components, table("pin", at), table("roller", angle)] })
    }
}

impl JsonSchema for PointShape {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Point".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let (at, polar) = (generator.subschema_for::<[Length; 2]>(), generator.subschema_for::<PolarPoint>());
        json_schema!({ "anyOf": [at, polar] })
    }
}

impl<T: JsonSchema> JsonSchema for Pair<T> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        format!("PairOf{}", T::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let one = generator.subschema_for::<T>();
        json_schema!({ "anyOf": [one, { "type": "array", "items": one, "minItems": 2, "maxItems": 2 }] })
    }
}

impl<T: JsonSchema> JsonSchema for Axes<T> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        format!("AxesOf{}", T::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let one = generator.subschema_for::<T>();
        json_schema!({ "anyOf": [one, { "type": "array", "items": one, "minItems": 3, "maxItems": 3 }] })
    }
}

impl<T: JsonSchema> JsonSchema for Steps<T> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        format!("StepsOf{}", T::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let one = generator.subschema_for::<T>();
        json_schema!({ "anyOf": [one, { "type": "array", "items": one, "minItems": 1 }] })
    }
}
