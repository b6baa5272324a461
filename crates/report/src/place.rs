//! Places on a contact surface in words.

use wearshape::{Problem, Shape};

use crate::brief::brief;

/// A place in the words of the scene.
pub(crate) fn place(problem: &Problem, s: f64) -> String {
    if let Some(angle) = problem.angle(s) {
        return format!("{} deg", brief((angle.to_degrees() * 1e3).round() / 1e3));
    }
    match problem.contact_shape() {
        Some(Shape::Annulus { .. } | Shape::Sector { .. }) => format!("r = {} mm", brief(s)),
        Some(Shape::Strip { x, .. } | Shape::Rectangle { x, .. }) => {
            // The middle, found up to round-off, is the middle.
            let s = if s.abs() < 1e-9 * (x[1] - x[0]) { 0.0 } else { s };
            format!("x = {} mm", brief(s + 0.5 * (x[0] + x[1])))
        }
        Some(Shape::Ellipse { .. }) => format!("x = {} mm", brief(s)),
        Some(Shape::Arc { .. } | Shape::Points(_)) | None => format!("s = {} mm", brief(s)),
    }
}
