//! The track of a ball on a revolving disc, where there is none.

use scene::{Fault, Geometry, Scene, Task};

/// Refuses the radius of a track on scenes that have no ball which wears.
pub(super) fn resolve(scene: &Scene, tasks: &[Task]) -> Result<(), Fault> {
    let Some(track) = scene.sliding.as_ref().and_then(|sliding| sliding.track_radius) else { return Ok(()) };
    let geometry = scene.body1.as_ref().map(|body| &body.geometry);
    if !matches!(geometry, Some(Geometry::HalfDisc(_))) || !tasks.contains(&Task::Wear) {
        let message = "sliding.track_radius is that of a ball (half-disc) on a revolving disc, in the task wear";
        return Err(Fault::at("sliding.track_radius", "wrong-key", message, "leave out sliding.track_radius"));
    }
    scene::positive("sliding.track_radius", track.0, "radius of the track", " mm")
}
