//! A scene written back.

use crate::fault::Fault;
use crate::scene::Scene;

/// A scene as TOML in base units: read again, it is the same scene.
pub fn scene_text(scene: &Scene) -> Result<String, Fault> {
    toml::to_string(scene).map_err(|error| {
        Fault::new("internal", format!("the resolved scene cannot be written: {error}"), "please report this scene")
    })
}
