//! `/mesh`: the edges of both meshes as lines, in the words of foxglove.SceneUpdate.

use schemars::JsonSchema;
use serde::Serialize;

use crate::record::messages::Timestamp;

/// Metres a millimetre: three-dimensional viewers count in metres.
const METRE: f64 = 1e-3;
/// Frame of all positions: x along the scene's x, z along its z.
pub(crate) const FRAME: &str = "scene";

/// What is shown. Kinds of primitives that we do not use are left out.
#[derive(Debug, Clone, Default, PartialEq, Serialize, JsonSchema)]
pub(crate) struct SceneUpdate {
    /// Nothing is ever taken away.
    deletions: Vec<Deletion>,
    /// One entity a body.
    entities: Vec<Entity>,
}

#[derive(Debug, Clone, Default, PartialEq, Serialize, JsonSchema)]
struct Deletion {
    timestamp: Timestamp,
    r#type: u8,
    id: String,
}

#[derive(Debug, Clone, Default, PartialEq, Serialize, JsonSchema)]
struct Entity {
    timestamp: Timestamp,
    frame_id: String,
    id: String,
    /// Zero: for ever.
    lifetime: Timestamp,
    frame_locked: bool,
    lines: Vec<Lines>,
}

#[derive(Debug, Clone, Default, PartialEq, Serialize, JsonSchema)]
struct Lines {
    /// 2: every two points are a line.
    r#type: u8,
    pose: Pose,
    /// Pixels.
    thickness: f64,
    scale_invariant: bool,
    points: Vec<Place>,
    color: Color,
    colors: Vec<Color>,
    indices: Vec<u32>,
}

#[derive(Debug, Clone, Default, PartialEq, Serialize, JsonSchema)]
struct Pose {
    position: Place,
    orientation: Quaternion,
}

/// Metres.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, JsonSchema)]
struct Place {
    x: f64,
    y: f64,
    z: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
struct Quaternion {
    x: f64,
    y: f64,
    z: f64,
    w: f64,
}

impl Default for Quaternion {
    fn default() -> Quaternion {
        Quaternion { x: 0.0, y: 0.0, z: 0.0, w: 1.0 }
    }
}

#[derive(Debug, Clone, Default, PartialEq, Serialize, JsonSchema)]
struct Color {
    r: f64,
    g: f64,
    b: f64,
    a: f64,
}

impl SceneUpdate {
    /// Both bodies, each given by pairs of points (x, z) in mm that are joined by a line.
    pub(crate) fn new(lines: &[Vec<[f64; 2]>; 2]) -> SceneUpdate {
        let colors = [[0.16, 0.44, 0.72], [0.45, 0.45, 0.45]];
        let entity = |body: usize| Entity {
            frame_id: FRAME.into(),
            id: format!("body{}", body + 1),
            lines: vec![Lines {
                r#type: 2,
                thickness: 1.0,
                scale_invariant: true,
                points: lines[body].iter().map(|[x, z]| Place { x: METRE * x, y: 0.0, z: METRE * z }).collect(),
                color: Color { r: colors[body][0], g: colors[body][1], b: colors[body][2], a: 1.0 },
                ..Lines::default()
            }],
            ..Entity::default()
        };
        SceneUpdate { deletions: Vec::new(), entities: vec![entity(0), entity(1)] }
    }
}
