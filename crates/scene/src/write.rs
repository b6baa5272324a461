//! A scene written back.

use crate::scene::Scene;

/// A scene as TOML in base units: read again, it is the same scene. Every scene can be written.
pub fn scene_text(scene: &Scene) -> String {
    let text = toml::to_string(scene);
    assert!(text.is_ok(), "a scene that TOML cannot hold: {text:?}");
    text.unwrap_or_default()
}
