//! Meshes of the geometry templates: coarse cells cut at what the scene names, graded towards its singular points.

use hpfem::{Curve, Mesh, Named, Ruled, Side};

use crate::fault::Fault;
use crate::geometry::{Geometry, Rectangle, Ring, RingSegment, ShoeBlock};
use crate::scene::Scene;

/// Name of the edges on the contact surface.
pub(crate) const CONTACT: &str = "@contact";
/// Name of the loaded edges.
pub(crate) const LOAD: &str = "@load";
/// Name of the edges on the axis of revolution.
pub(crate) const AXIS: &str = "@axis";

/// Ratio of the sizes of successive layers. Of 0.1, 0.15, 0.25 the last reached a given error of the drum gap with the least work
/// in degrees 6 to 14 (layers = degree - 2).
const RATIO: f64 = 0.25;

/// A coarse mesh and the points towards which it is to be graded.
struct Coarse {
    mesh: Mesh,
    singular: Vec<[f64; 2]>,
}

/// Extent of the contact surface, shared by both bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Extent {
    /// On an arc about the centre, angles from the z axis towards +x.
    Angles([f64; 2]),
    /// On a horizontal line.
    X([f64; 2]),
}

impl Extent {
    /// The extent of a scene's contact surface, from its surface shape.
    pub(crate) fn of(shape: &wear::Shape) -> Option<Extent> {
        match shape {
            wear::Shape::Arc { angles, .. } => Some(Extent::Angles(*angles)),
            wear::Shape::Strip { x, .. } => Some(Extent::X(*x)),
            wear::Shape::Annulus { radii } => Some(Extent::X(*radii)),
            _ => None,
        }
    }
}

/// The meshes of both bodies with the given number of layers around each singular point.
pub(crate) fn meshes(scene: &Scene, extent: Extent, layers: usize) -> Result<[Mesh; 2], Fault> {
    let (Some(body1), Some(body2)) = (&scene.body1, &scene.body2) else {
        return Err(not_meshed("body1.geometry", "bodies"));
    };
    let cuts = contact_cuts(extent);
    let first = coarse(scene, &body1.geometry, &cuts, true)?;
    let second = coarse(scene, &body2.geometry, &cuts, false)?;
    let graded = |coarse: Coarse, key: &str| {
        let vertices: Vec<usize> = coarse.singular.iter().map(|x| coarse.mesh.nearest_vertex(*x)).collect();
        coarse.mesh.refined_towards(&vertices, RATIO, layers).map_err(|error| geometry_fault(key, &error))
    };
    Ok([graded(first, "body1.geometry")?, graded(second, "body2.geometry")?])
}

fn not_meshed(key: &str, what: &str) -> Fault {
    let message = format!("{what} cannot be meshed for this contact yet");
    Fault::at(key, "not-available", message, "use the templates shoe-block, ring, ring-segment, rectangle")
}

fn geometry_fault(key: &str, error: &hpfem::Error) -> Fault {
    Fault::at(key, "degenerate", error.to_string(), "make the body less thin or less distorted")
}

/// Common break points of both bodies on the contact surface: at least two equal pieces, on arcs of at most 30 degrees.
fn contact_cuts(extent: Extent) -> Vec<f64> {
    match extent {
        Extent::Angles([from, to]) => subdivide(&[from, to], (0.5 * (to - from)).min(std::f64::consts::FRAC_PI_6)),
        Extent::X([from, to]) => subdivide(&[from, to], 0.5 * (to - from)),
    }
}

/// Cuts every interval between the given points into equal pieces no longer than `step`.
fn subdivide(points: &[f64], step: f64) -> Vec<f64> {
    let mut cuts = vec![points[0]];
    for pair in points.windows(2) {
        let pieces = ((pair[1] - pair[0]) / step * (1.0 - 1e-9)).ceil().max(1.0) as usize;
        for i in 1..=pieces {
            let t = i as f64 / pieces as f64;
            cuts.push(if i == pieces { pair[1] } else { (1.0 - t) * pair[0] + t * pair[1] });
        }
    }
    cuts
}

/// Ascending points with near duplicates removed.
fn merged(mut points: Vec<f64>) -> Vec<f64> {
    points.sort_by(f64::total_cmp);
    let scale = points.last().copied().unwrap_or(0.0) - points.first().copied().unwrap_or(0.0);
    points.dedup_by(|b, a| (*b - *a).abs() <= 1e-9 * scale);
    points
}

fn coarse(scene: &Scene, geometry: &Geometry, cuts: &[f64], shaped: bool) -> Result<Coarse, Fault> {
    let key = if shaped { "body1.geometry" } else { "body2.geometry" };
    let result = match geometry {
        Geometry::ShoeBlock(shoe) if shaped => shoe_block(scene, shoe, cuts),
        Geometry::RingSegment(segment) if shaped => ring_segment(scene, segment, cuts),
        Geometry::Ring(ring) if !shaped => full_ring(ring, cuts),
        Geometry::Rectangle(rectangle) => block(scene, rectangle, cuts, shaped),
        other => return Err(not_meshed(key, crate::setup::template(other))),
    };
    result.map_err(|error| geometry_fault(key, &error))
}

fn named(side: Side, name: &str) -> Named<'_> {
    Named { side, range: None, name }
}

fn arc(centre: [f64; 2], radius: f64, [from, to]: [f64; 2]) -> Curve {
    let quarter = std::f64::consts::FRAC_PI_2;
    Curve::Arc { centre, radius, from: quarter - from, to: quarter - to }
}

/// Levels from 0 to 1 whose cells are about as high as wide.
fn levels(height: f64, width: f64, least: usize) -> Vec<f64> {
    let n = ((height / width).round() as usize).max(least);
    (0..=n).map(|i| i as f64 / n as f64).collect()
}

/// Parameters in [-1, 1] of points between two ends.
fn parameters(points: &[f64], [from, to]: [f64; 2]) -> Vec<f64> {
    points.iter().map(|x| (2.0 * x - from - to) / (to - from)).collect()
}

/// Names of the load edge: the whole side.
fn load_side(scene: &Scene, edge: &str) -> bool {
    scene.load.as_ref().and_then(|load| load.edge.as_deref()) == Some(edge)
}

fn shoe_block(scene: &Scene, shoe: &ShoeBlock, cuts: &[f64]) -> Result<Coarse, hpfem::Error> {
    let (radius, angle, top) = (shoe.radius.0, shoe.half_angle.0, shoe.top.0);
    let (x, z) = (radius * angle.sin(), radius * angle.cos());
    let mut names = vec![
        named(Side::Bottom, "inner"),
        named(Side::Bottom, CONTACT),
        named(Side::Top, "top"),
        named(Side::Left, "left"),
        named(Side::Right, "right"),
    ];
    for (side, edge) in [(Side::Top, "top"), (Side::Left, "left"), (Side::Right, "right")] {
        if load_side(scene, edge) {
            names.push(named(side, LOAD));
        }
    }
    let breaks = parameters(cuts, [-angle, angle]);
    let width = radius * (cuts[1] - cuts[0]);
    let mesh = Mesh::ruled(&Ruled {
        bottom: arc([0.0; 2], radius, [-angle, angle]),
        top: Curve::Line { start: [-x, top], end: [x, top] },
        breaks: &breaks,
        levels: &levels(top - radius, width, 1),
        closed: false,
        material: 0,
        names: &names,
    })?;
    Ok(Coarse { mesh, singular: vec![[-x, z], [x, z]] })
}

fn ring_segment(scene: &Scene, segment: &RingSegment, cuts: &[f64]) -> Result<Coarse, hpfem::Error> {
    let (inner, outer, x) = (segment.inner.0, segment.outer.0, segment.x.map(|x| x.0));
    let inner_angles = x.map(|x| (x / inner).asin());
    let outer_angles = x.map(|x| (x / outer).asin());
    let mut points = parameters(cuts, inner_angles);
    let mut load_range = None;
    let load = scene.load.as_ref().filter(|load| load.edge.as_deref() == Some("outer"));
    if let Some((width, load)) = load.and_then(|load| load.width.map(|w| (w.0, load))) {
        let centre = load.centre.map_or(0.0, |c| c.0);
        let ends = [centre - 0.5 * width, centre + 0.5 * width];
        let range = parameters(&ends.map(|x| (x / outer).asin()), outer_angles);
        points.extend(&range);
        load_range = Some([range[0], range[1]]);
    }
    // The line x = 0 in the middle, ruled from arc to arc.
    let middle = -(outer_angles[0] + outer_angles[1]) / (outer_angles[1] - outer_angles[0]);
    let straight = (inner_angles[0] + inner_angles[1]).abs() < 1e-12;
    let centre_held = scene.body1.as_ref().is_some_and(|body| body.support.contains_key("centre"));
    if straight {
        points.push(middle);
    }
    let thickness = outer - inner;
    let step = 2.0 * (0.75 * thickness / (inner * (inner_angles[1] - inner_angles[0]))).min(0.5);
    let breaks = subdivide(&merged(points), step);
    let mut names = vec![
        named(Side::Bottom, "inner"),
        named(Side::Bottom, CONTACT),
        named(Side::Top, "outer"),
        named(Side::Left, "left"),
        named(Side::Right, "right"),
    ];
    if load.is_some() {
        names.push(Named { side: Side::Top, range: load_range, name: LOAD });
    }
    if centre_held && straight {
        names.push(named(Side::Ruling(middle), "centre"));
    }
    let bottom = arc([0.0; 2], inner, inner_angles);
    let top = arc([0.0; 2], outer, outer_angles);
    let mut singular = vec![bottom.point(-1.0), bottom.point(1.0), top.point(-1.0), top.point(1.0)];
    singular.extend(load_range.into_iter().flatten().map(|t| top.point(t)));
    if centre_held {
        singular.extend([bottom.point(middle), top.point(middle)]);
    }
    let mesh =
        Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &[0.0, 0.5, 1.0], closed: false, material: 0, names: &names })?;
    Ok(Coarse { mesh, singular })
}

fn full_ring(ring: &Ring, cuts: &[f64]) -> Result<Coarse, hpfem::Error> {
    let (inner, outer) = (ring.inner.0, ring.outer.0);
    let centre = ring.centre.map_or([0.0; 2], |c| c.map(|c| c.0));
    let (from, to) = (cuts[0], cuts[cuts.len() - 1]);
    let turn = std::f64::consts::TAU;
    // Outside the contact: one cell as wide as inside on each side, the rest in cells of at most 60 degrees.
    let step = (cuts[1] - cuts[0]).min(0.25 * (turn - (to - from)));
    let rest = subdivide(&[to, to + step, from + turn - step, from + turn], std::f64::consts::FRAC_PI_3);
    let angles: Vec<f64> = cuts.iter().copied().chain(rest[1..].iter().copied()).collect();
    let range = [from, from + turn];
    let breaks = parameters(&angles, range);
    let contact = parameters(&[from, to], range);
    let top = arc(centre, outer, range);
    let names = [
        named(Side::Bottom, "inner"),
        named(Side::Top, "outer"),
        Named { side: Side::Top, range: Some([contact[0], contact[1]]), name: CONTACT },
    ];
    let singular = vec![top.point(contact[0]), top.point(contact[1])];
    let mesh = Mesh::ruled(&Ruled {
        bottom: arc(centre, inner, range),
        top,
        breaks: &breaks,
        levels: &levels(outer - inner, outer * step, 1),
        closed: true,
        material: 0,
        names: &names,
    })?;
    Ok(Coarse { mesh, singular })
}

fn block(scene: &Scene, rectangle: &Rectangle, cuts: &[f64], shaped: bool) -> Result<Coarse, hpfem::Error> {
    let (x, z) = (rectangle.x.map(|x| x.0), rectangle.z.map(|z| z.0));
    let (contact_side, contact_z) = if shaped { (Side::Bottom, z[0]) } else { (Side::Top, z[1]) };
    let ends = [cuts[0], cuts[cuts.len() - 1]];
    let step = cuts[1] - cuts[0];
    let points = merged(cuts.iter().copied().chain(x).collect());
    let points = subdivide(&points, 2.0 * step.max(0.1 * (x[1] - x[0])));
    let contact = parameters(&ends, x);
    let mut names = vec![
        named(Side::Bottom, "bottom"),
        named(Side::Top, "top"),
        named(Side::Left, "left"),
        named(Side::Right, "right"),
        Named { side: contact_side, range: Some([contact[0], contact[1]]), name: CONTACT },
    ];
    let axisymmetric = scene.kinematics == Some(crate::scene::Kinematics::Axisymmetric);
    if axisymmetric && x[0] == 0.0 {
        names.push(named(Side::Left, AXIS));
    }
    for (side, edge) in [(Side::Top, "top"), (Side::Left, "left"), (Side::Right, "right")] {
        if shaped && load_side(scene, edge) {
            names.push(named(side, LOAD));
        }
    }
    // Ends of contact, and the corners of the far side, where supports or a rigid edge end.
    let far_z = if shaped { z[1] } else { z[0] };
    let far_edge = if shaped { "top" } else { "bottom" };
    let body = if shaped { &scene.body1 } else { &scene.body2 };
    let held = body.as_ref().is_some_and(|b| b.support.contains_key(far_edge));
    let mut singular: Vec<[f64; 2]> = ends.iter().map(|x| [*x, contact_z]).collect();
    if held || (shaped && load_side(scene, far_edge)) {
        singular.extend(x.map(|x| [x, far_z]));
    }
    singular.retain(|point| !(axisymmetric && point[0] == 0.0));
    let mesh = Mesh::ruled(&Ruled {
        bottom: Curve::Line { start: [x[0], z[0]], end: [x[1], z[0]] },
        top: Curve::Line { start: [x[0], z[1]], end: [x[1], z[1]] },
        breaks: &parameters(&points, x),
        levels: &levels(z[1] - z[0], 1.5 * step, 2),
        closed: false,
        material: 0,
        names: &names,
    })?;
    Ok(Coarse { mesh, singular })
}
