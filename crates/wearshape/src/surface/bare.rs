//! Contact surfaces that the scene gives without bodies.

use nalgebra::Vector3;
use scene::{Fault, Length, SurfaceShape, positive};
use wear::Shape;

use crate::surface::found::{Found, PatchKind};

/// A surface without bodies.
pub(super) fn bare(surface: &SurfaceShape) -> Result<Found, Fault> {
    let range = |key: &str, range: [Length; 2]| {
        if range[1].0 > range[0].0 {
            return Ok([range[0].0, range[1].0]);
        }
        let message = format!("{key} = [{}, {}] does not increase", range[0].0, range[1].0);
        Err(Fault::at(key, "degenerate", message, "write [from, to] with from < to"))
    };
    let found = |shape: Shape, kind: PatchKind, key: &'static str| Ok(Found::bare(shape, kind, key));
    match surface {
        SurfaceShape::DiscPad(pad) => {
            let key = "surface.disc-pad";
            positive(&format!("{key}.inner"), pad.inner.0, "inner radius", " mm")?;
            let radii = range(&format!("{key}.outer"), [pad.inner, pad.outer])?;
            let half = pad.half_angle.0;
            if !(half > 0.0 && half <= std::f64::consts::PI) {
                let message = format!("half angle {} deg is out of range", half.to_degrees());
                return Err(Fault::at(format!("{key}.half_angle"), "degenerate", message, "give 0 to 180 deg"));
            }
            found(Shape::Sector { radii, angles: [-half, half] }, PatchKind::Turning, key)
        }
        SurfaceShape::PinnedShoe(shoe) => found(pinned(shoe)?, PatchKind::Turning, "surface.pinned-shoe"),
        SurfaceShape::PivotedShoe(shoe) => {
            let key = "surface.pivoted-shoe";
            found(symmetric_arc(key, shoe.radius, shoe.half_angle.0, shoe.width.0)?, PatchKind::Turning, key)
        }
        SurfaceShape::JournalArc(arc) => {
            let key = "surface.journal-arc";
            found(symmetric_arc(key, arc.radius, arc.half_angle.0, arc.width.0)?, PatchKind::Turning, key)
        }
        SurfaceShape::RectangularPunch(punch) => {
            let key = "surface.rectangular-punch";
            let shape = Shape::Rectangle { x: range(&format!("{key}.x"), punch.x)?, y: range(&format!("{key}.y"), punch.y)? };
            found(shape, PatchKind::Plane, key)
        }
        SurfaceShape::EllipticPunch(punch) => {
            let key = "surface.elliptic-punch";
            for axis in punch.half_axes {
                positive(&format!("{key}.half_axes"), axis.0, "half axis", " mm")?;
            }
            let semi_axes = [punch.half_axes[0].0, punch.half_axes[1].0];
            found(Shape::Ellipse { semi_axes }, PatchKind::Plane, key)
        }
    }
}

fn symmetric_arc(key: &str, radius: Length, half_angle: f64, width: f64) -> Result<Shape, Fault> {
    positive(&format!("{key}.radius"), radius.0, "radius", " mm")?;
    positive(&format!("{key}.width"), width, "width", " mm")?;
    half_turn_at_most(&format!("{key}.half_angle"), half_angle)?;
    let (centre, internal) = (Vector3::zeros(), false);
    Ok(Shape::Arc { radius: radius.0, centre, angles: [-half_angle, half_angle], thickness: width, internal })
}

fn half_turn_at_most(key: &str, angle: f64) -> Result<(), Fault> {
    if angle > 0.0 && angle <= std::f64::consts::PI {
        return Ok(());
    }
    let message = format!("half angle {} deg is out of range", angle.to_degrees());
    Err(Fault::at(key, "degenerate", message, "give a half angle greater than 0 and at most 180 deg"))
}

/// The arc of a shoe on a pin that is not on its lining.
fn pinned(shoe: &scene::PinnedShoe) -> Result<Shape, Fault> {
    let key = "surface.pinned-shoe";
    positive(&format!("{key}.radius"), shoe.radius.0, "radius", " mm")?;
    positive(&format!("{key}.width"), shoe.width.0, "width", " mm")?;
    positive(&format!("{key}.pin_distance"), shoe.pin_distance.0, "distance of the pin", " mm")?;
    positive(&format!("{key}.arm"), shoe.arm.0, "lever arm", " mm")?;
    let angles = [shoe.from.0, shoe.to.0];
    if !(angles[0] >= 0.0 && angles[1] > angles[0] && angles[1] < std::f64::consts::PI) {
        let (from, to) = (angles[0].to_degrees(), angles[1].to_degrees());
        let message = format!("the lining reaches from {from} to {to} deg, where it cannot close everywhere");
        return Err(Fault::at(format!("{key}.to"), "degenerate", message, "give 0 <= from < to < 180 deg"));
    }
    if angles[0] == 0.0 && (shoe.pin_distance.0 / shoe.radius.0 - 1.0).abs() < 1e-9 {
        let message = "the pin lies on the contact: the lining begins at its angle, and its distance is the drum's radius";
        let remedy = "give the distance of the pin from the middle of the drum; it cannot lie on the lining";
        return Err(Fault::at(format!("{key}.pin_distance"), "degenerate", message, remedy));
    }
    Ok(Shape::Arc { radius: shoe.radius.0, centre: Vector3::zeros(), angles, thickness: shoe.width.0, internal: true })
}
