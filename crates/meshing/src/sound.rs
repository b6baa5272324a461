//! What can be wrong with the numbers of a geometry.

use std::collections::BTreeMap;

use scene::{Fault, Geometry, HalfDisc, Length, Material, Rectangle, RingSegment, ShoeBlock, positive};

use crate::sound_material::sound_material;

fn interval(key: &str, range: [Length; 2]) -> Result<(), Fault> {
    if range[0].0 < range[1].0 && range[0].0.is_finite() && range[1].0.is_finite() {
        return Ok(());
    }
    let message = format!("{key} = [{}, {}] does not increase", range[0].0, range[1].0);
    Err(Fault::at(key, "degenerate", message, "write [from, to] with from < to"))
}

fn radii(key: &str, inner: Length, outer: Length) -> Result<(), Fault> {
    positive(&format!("{key}.inner"), inner.0, "inner radius", " mm")?;
    if outer.0 > inner.0 && outer.0.is_finite() {
        return Ok(());
    }
    let message = format!("the outer radius {} is not greater than the inner radius {}", outer.0, inner.0);
    Err(Fault::at(format!("{key}.outer"), "degenerate", message, "give outer > inner"))
}

/// Checks the numbers of a geometry (`name` is "body1" or "body2") and fills in its defaults.
///
/// # Errors
/// The fault of the key that makes it degenerate or that does not fit the kinematics.
pub fn sound(name: &str, geometry: &mut Geometry, axisymmetric: bool) -> Result<(), Fault> {
    let key = format!("{name}.geometry.{}", geometry.name());
    let plane_only = matches!(geometry, Geometry::ShoeBlock(_) | Geometry::Ring(_) | Geometry::RingSegment(_));
    if axisymmetric && plane_only {
        let message = format!("{} is a plane template, the scene is axisymmetric", geometry.name());
        let remedy = "use rectangle, half-disc, blocks or mesh, or kinematics = \"plane-stress\"";
        return Err(Fault::at(key, "wrong-value", message, remedy));
    }
    match geometry {
        Geometry::ShoeBlock(shoe) => shoe_block(&key, shoe),
        Geometry::Ring(ring) => {
            ring.centre.get_or_insert([Length(0.0), Length(0.0)]);
            radii(&key, ring.inner, ring.outer)
        }
        Geometry::RingSegment(segment) => ring_segment(&key, segment),
        Geometry::Rectangle(sides) => rectangle(&key, sides, axisymmetric),
        Geometry::HalfDisc(disc) => half_disc(&key, disc, axisymmetric),
        Geometry::Blocks(blocks) => materials(&key, &blocks.materials),
        Geometry::Mesh(file) => {
            if let Some(scale) = file.scale {
                positive(&format!("{key}.scale"), scale.0, "scale", "")?;
            }
            materials(&key, &file.materials)
        }
    }
}

fn shoe_block(key: &str, shoe: &ShoeBlock) -> Result<(), Fault> {
    positive(&format!("{key}.radius"), shoe.radius.0, "radius", " mm")?;
    let angle = shoe.half_angle.0;
    if !(angle > 0.0 && angle < std::f64::consts::FRAC_PI_2) {
        let message = format!("half angle {} deg: the shoe must close somewhere along its arc and have sides", degrees(angle));
        let remedy = "give a half angle greater than 0 and less than 90 deg";
        return Err(Fault::at(format!("{key}.half_angle"), "degenerate", message, remedy));
    }
    if shoe.top.0 <= shoe.radius.0 || !shoe.top.0.is_finite() {
        let message = format!("the top at z = {} is not above the arc of radius {}", shoe.top.0, shoe.radius.0);
        return Err(Fault::at(format!("{key}.top"), "degenerate", message, "give top > radius"));
    }
    Ok(())
}

fn ring_segment(key: &str, segment: &RingSegment) -> Result<(), Fault> {
    radii(key, segment.inner, segment.outer)?;
    interval(&format!("{key}.x"), segment.x)?;
    if segment.x.iter().any(|x| x.0.abs() >= segment.inner.0) {
        let [from, to] = segment.x.map(|x| x.0);
        let message = format!("the cuts x = {from} and {to} do not both cross the inner radius {}", segment.inner.0);
        return Err(Fault::at(format!("{key}.x"), "degenerate", message, "give |x| < inner"));
    }
    Ok(())
}

fn rectangle(key: &str, rectangle: &Rectangle, axisymmetric: bool) -> Result<(), Fault> {
    interval(&format!("{key}.x"), rectangle.x)?;
    interval(&format!("{key}.z"), rectangle.z)?;
    if axisymmetric && rectangle.x[0].0 < 0.0 {
        let message = format!("an axisymmetric body reaches to r = {}", rectangle.x[0].0);
        return Err(Fault::at(format!("{key}.x"), "degenerate", message, "give x = [from, to] with from >= 0"));
    }
    Ok(())
}

fn half_disc(key: &str, disc: &HalfDisc, axisymmetric: bool) -> Result<(), Fault> {
    positive(&format!("{key}.radius"), disc.radius.0, "radius", " mm")?;
    if axisymmetric && disc.centre[0].0 != 0.0 {
        let message = format!("an axisymmetric half disc has its centre at r = {}", disc.centre[0].0);
        return Err(Fault::at(format!("{key}.centre"), "degenerate", message, "give centre = [0, z]"));
    }
    Ok(())
}

fn materials(key: &str, materials: &BTreeMap<String, Material>) -> Result<(), Fault> {
    materials.iter().try_for_each(|(name, values)| sound_material(&format!("{key}.materials.{name}"), *values))
}

fn degrees(angle: f64) -> f64 {
    angle * 180.0 / std::f64::consts::PI
}
