//! Meshes of the geometry templates: coarse cells cut at what the scene names, graded towards its singular points.

use hpfem::{Curve, Mesh, Named, Ruled, Side};
use scene::{Fault, Geometry, Rectangle, Ring, RingSegment, ShoeBlock, short};

use crate::coarse::{Coarse, degenerate};
use crate::couple::{Body, Couple};
use crate::cuts::{SAME, growing, halved, merged, parameters, subdivide, widest};
use crate::extent::{Cut, Extent};
use crate::names::{AXIS, CONTACT, LOAD};
use crate::outline::touches_all_around;

/// Share of the contact up to which what body 2 is longer is added to its graded mesh.
const LEDGE: f64 = 0.01;
/// The same over the height of body 2: cells beyond the contact of a thin one are cut as its height asks for.
const LEDGE_BY_HEIGHT: f64 = 2.0;
/// Share of the contact up to which both bodies end at one place.
const SAME_END: f64 = 1e-9;

fn not_meshed(key: &str, what: &str) -> Fault {
    let message = format!("{what} cannot be meshed for this contact yet");
    Fault::at(key, "not-available", message, "use the templates shoe-block, ring, ring-segment, rectangle")
}

/// Common break points of both bodies on the contact surface: at least two equal pieces, on arcs of at most 30 degrees, and those
/// that the bodies need for themselves: a template by its kind, one given by cells by its points (`breaks`).
pub(crate) fn contact_cuts(couple: &Couple, extent: Extent, cut: Cut<'_>, breaks: &[f64]) -> Vec<f64> {
    let [first, last] = extent.ends();
    let near = SAME * (last - first);
    let with = |points: &[f64]| {
        let mut others: Vec<f64> = breaks.iter().copied().filter(|b| points.iter().all(|p| (b - p).abs() > near)).collect();
        others.sort_unstable_by(f64::total_cmp);
        others.dedup_by(|b, a| (*b - *a).abs() <= near);
        merged(points.iter().copied().chain(others).collect())
    };
    let more = if cut == Cut::Shifted { 1.0 } else { 0.0 };
    let cuts = match (extent, &couple.bodies[0].geometry) {
        (Extent::Angles(ends) | Extent::Circles { angles: ends, .. }, Geometry::RingSegment(segment)) => {
            let half = 0.5 * (ends[1] - ends[0]);
            let own: Vec<f64> = segment_breaks(couple, segment, cut).breaks.iter().map(|t| ends[0] + half * (1.0 + t)).collect();
            if breaks.is_empty() { own } else { with(&own) }
        }
        (
            Extent::Angles([from, to]) | Extent::Circles { angles: [from, to], .. } | Extent::Convex { angles: [from, to], .. },
            _,
        ) => {
            let pieces = ((to - from) / std::f64::consts::FRAC_PI_6 * (1.0 - 1e-9)).ceil().max(2.0) + more;
            subdivide(&with(&with_ends([from, to], cut)), (to - from) / pieces)
        }
        (Extent::Round { .. }, _) => {
            let ends = cut.ends().iter().map(|t| first + 0.5 * (1.0 + t) * (last - first));
            subdivide(&with(&merged([first, last].into_iter().chain(ends).collect())), (last - first) / 3.0)
        }
        // Three pieces: the tilt of a gap is its tangent in the middle, which must lie inside a cell.
        (Extent::X([from, to]), _) => subdivide(&with(&with_ends([from, to], cut)), (to - from) / (3.0 + more)),
    };
    // Short waves are for templates, which have no cells of their own.
    let longest = couple.longest * (last - first);
    if couple.longest < 1.0 && !couple.bodies.iter().any(Body::is_given) { subdivide(&cuts, longest) } else { cuts }
}

/// The ends of the surface, the ends of contact, and the middles between them: no cell may lie between two points that both need layers.
fn with_ends([from, to]: [f64; 2], cut: Cut<'_>) -> Vec<f64> {
    if cut.ends().is_empty() {
        return vec![from, to];
    }
    let inner = cut.ends().iter().map(|t| from + 0.5 * (1.0 + t) * (to - from));
    halved(&merged([from, to].into_iter().chain(inner).collect()))
}

/// The coarse mesh of a template, cut at the given places of the contact surface.
pub(crate) fn coarse(couple: &Couple, number: usize, extent: Extent, cuts: &[f64], cut: Cut<'_>) -> Result<Coarse, Fault> {
    let (shaped, body) = (number == 0, &couple.bodies[number]);
    let key = if shaped { "body1.geometry" } else { "body2.geometry" };
    if let Geometry::Rectangle(rectangle) = &body.geometry {
        not_too_wide(key, rectangle, cuts)?;
    }
    let width = width_for_height(couple, extent, cuts, cut);
    let result = match &body.geometry {
        Geometry::ShoeBlock(shoe) if shaped => shoe_block(couple, shoe, (cuts, width), cut),
        Geometry::RingSegment(segment) if shaped => ring_segment(couple, segment, cuts, cut),
        Geometry::Ring(ring) => full_ring(couple, number, ring, &OnRing::new(couple, number, extent, cuts, cut)),
        Geometry::Rectangle(rectangle) => block(couple, rectangle, (cuts, width), shaped, cut),
        other @ (Geometry::ShoeBlock(_)
        | Geometry::RingSegment(_)
        | Geometry::HalfDisc(_)
        | Geometry::Blocks(_)
        | Geometry::Mesh(_)) => return Err(not_meshed(key, other.name())),
    };
    result.map_err(|error| degenerate(key, &error))
}

/// Refuses a rectangle beside whose width the contact has no length left.
fn not_too_wide(key: &str, rectangle: &Rectangle, cuts: &[f64]) -> Result<(), Fault> {
    const MOST: f64 = 1e8;
    let width = rectangle.x[1].0 - rectangle.x[0].0;
    let contact = cuts[cuts.len() - 1] - cuts[0];
    if width <= MOST * contact {
        return Ok(());
    }
    let [wide, long] = [width, contact].map(short);
    let message = format!("a body {wide} mm wide for a contact of {long} mm: cells between the two sizes have no digits left");
    Err(Fault::at(format!("{key}.rectangle.x"), "degenerate", message, "give a width of some lengths of the contact"))
}

fn named(side: Side, name: &str) -> Named<'_> {
    Named { side, range: None, name }
}

fn arc(centre: [f64; 2], radius: f64, [from, to]: [f64; 2]) -> Curve {
    let quarter = std::f64::consts::FRAC_PI_2;
    Curve::Arc { centre, radius, from: quarter - from, to: quarter - to }
}

/// Levels from bottom to top, at least `least` pieces, whose cells are about as high as wide at the contact and twice as high from one to the
/// next.
fn levels(height: f64, width: f64, least: usize, contact: Side) -> Vec<f64> {
    // No two lengths are further apart than 2^1000.
    let n = (height / width + 1.0).log2().round().min(1000.0).max(least as f64) as i32;
    let up_to = |level: i32| 2.0_f64.powi(level) - 1.0;
    let from_contact = (0..=n).map(|level| if level == n { 1.0 } else { up_to(level) / up_to(n) });
    if matches!(contact, Side::Top) { from_contact.rev().map(|level| 1.0 - level).collect() } else { from_contact.collect() }
}

/// Width of the cells that their height goes by, over that of the narrowest, where contact ends on their surface.
const BESIDE_ENDS: f64 = 1.5;
/// The same over that of the widest, at least: cells of the other body may leave splinters.
const LEAST_WIDTH: f64 = 0.25;

/// The width of cells on the contact surface that their height goes by. Beside ends of contact the fields change over the distance from these in depth too:
/// with cells that are high beside the narrowest the gap of a drum, cut at 0.53 of its half, is off by 80 times as much (degree 8).
fn width_for_height(couple: &Couple, extent: Extent, cuts: &[f64], cut: Cut<'_>) -> f64 {
    if cut.ends().is_empty() || !at_corners(couple, extent) {
        return widest(cuts);
    }
    let narrowest = cuts.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
    (BESIDE_ENDS * narrowest.max(LEAST_WIDTH * widest(cuts))).min(widest(cuts))
}

fn shoe_block(couple: &Couple, shoe: &ShoeBlock, (cuts, width): (&[f64], f64), cut: Cut<'_>) -> Result<Coarse, hpfem::Error> {
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
        if couple.load.is(edge) {
            names.push(named(side, LOAD));
        }
    }
    // A top that turns about a pin or runs on a roller is graded towards its ends.
    let guided = couple.moves_one_way() && couple.bodies[0].supports.contains_key("top");
    let breaks = parameters(cuts, [-angle, angle]);
    let width = radius * width;
    let bottom = arc([0.0; 2], radius, [-angle, angle]);
    let free = cut.ends().iter().map(|t| bottom.point(*t)).collect();
    let mesh = Mesh::ruled(&Ruled {
        bottom,
        top: Curve::Line { start: [-x, top], end: [x, top] },
        breaks: &breaks,
        levels: &levels(top - radius, width, if guided { 2 } else { 1 }, Side::Bottom),
        closed: false,
        material: 0,
        names: &names,
    })?;
    let mut singular = vec![[-x, z], [x, z]];
    if guided {
        singular.extend([[-x, top], [x, top]]);
    }
    Ok(Coarse { mesh, singular, ledges: [0.0; 2], free })
}

/// Where a ring segment is cut, in the common parameter of its arcs.
struct SegmentBreaks {
    breaks: Vec<f64>,
    /// The loaded part of the outer arc, if it is not the whole.
    load: Option<[f64; 2]>,
    /// The line x = 0, if it is a straight ruling.
    middle: Option<f64>,
}

fn segment_angles(segment: &RingSegment) -> [[f64; 2]; 2] {
    let x = segment.x.map(|x| x.0);
    [segment.inner.0, segment.outer.0].map(|radius| x.map(|x| (x / radius).asin()))
}

fn segment_breaks(couple: &Couple, segment: &RingSegment, cut: Cut<'_>) -> SegmentBreaks {
    let [inner, outer] = segment_angles(segment);
    let mut points = vec![-1.0, 1.0];
    let strip = couple.load.strip.filter(|_| couple.load.is("outer"));
    let load = strip.map(|strip| {
        let range = parameters(&strip.ends().map(|x| (x / segment.outer.0).asin()), outer);
        [range[0], range[1]]
    });
    points.extend(load.into_iter().flatten());
    let middle = Some(0.0).filter(|_| (inner[0] + inner[1]).abs() < 1e-12);
    points.extend(middle);
    points.extend(cut.ends());
    let thickness = segment.outer.0 - segment.inner.0;
    let finer = if cut == Cut::Shifted { 0.8 } else { 1.0 };
    let step = (1.5 * finer * thickness / (segment.inner.0 * (inner[1] - inner[0]))).min(1.0);
    let points = merged(points);
    // No cell may lie between two points that both need layers: at least two pieces everywhere.
    SegmentBreaks { breaks: subdivide(&halved(&points), step), load, middle }
}

fn ring_segment(couple: &Couple, segment: &RingSegment, cuts: &[f64], cut: Cut<'_>) -> Result<Coarse, hpfem::Error> {
    let SegmentBreaks { mut breaks, load, middle } = segment_breaks(couple, segment, cut);
    let [inner, outer] = segment_angles(segment);
    // Further cuts that a counter-face given by its cells asks for.
    if cuts.len() > breaks.len() {
        breaks = merged(breaks.into_iter().chain(parameters(cuts, inner)).collect());
    }
    let centre = middle.filter(|_| couple.bodies[0].supports.contains_key("centre"));
    let mut names = vec![
        named(Side::Bottom, "inner"),
        named(Side::Bottom, CONTACT),
        named(Side::Top, "outer"),
        named(Side::Left, "left"),
        named(Side::Right, "right"),
    ];
    if couple.load.is("outer") {
        names.push(Named { side: Side::Top, range: load, name: LOAD });
    }
    names.extend(centre.map(|t| named(Side::Ruling(t), "centre")));
    let bottom = arc([0.0; 2], segment.inner.0, inner);
    let top = arc([0.0; 2], segment.outer.0, outer);
    let mut singular = vec![bottom.point(-1.0), bottom.point(1.0), top.point(-1.0), top.point(1.0)];
    singular.extend(load.into_iter().flatten().map(|t| top.point(t)));
    let free = cut.ends().iter().map(|t| bottom.point(*t)).collect();
    singular.extend(centre.into_iter().flat_map(|t| [bottom.point(t), top.point(t)]));
    let levels = [0.0, 0.5, 1.0];
    let mesh = Mesh::ruled(&Ruled { bottom, top, breaks: &breaks, levels: &levels, closed: false, material: 0, names: &names })?;
    Ok(Coarse { mesh, singular, ledges: [0.0; 2], free })
}

/// Whether the surface that may touch is known to end at corners of body 1, and not in the midst of round bodies, where nothing is singular. A ring segment
/// has its own breaks, by its thickness.
pub(crate) fn at_corners(couple: &Couple, extent: Extent) -> bool {
    let body = &couple.bodies[0];
    let is_segment = matches!(body.geometry, Geometry::RingSegment(_));
    matches!(extent, Extent::Angles(_) | Extent::X(_)) && !(is_segment || body.is_given() || touches_all_around(body))
}

/// What happens on a full ring, by angles of its own.
struct OnRing {
    /// Break points of the contact surface.
    cuts: Vec<f64>,
    /// Ends of contact.
    ends: Vec<f64>,
    /// Width of cells on the surface that their height goes by.
    width: f64,
    /// Whether the surface that may touch ends at corners of the other body.
    graded: bool,
}

impl OnRing {
    fn new(couple: &Couple, number: usize, extent: Extent, cuts: &[f64], cut: Cut<'_>) -> OnRing {
        let own = |places: &mut dyn Iterator<Item = f64>| {
            let mut angles: Vec<f64> = places.map(|place| extent.own(number, place)).collect();
            angles.sort_unstable_by(f64::total_cmp);
            angles
        };
        let [from, to] = extent.ends();
        let cuts = own(&mut cuts.iter().copied());
        let ends = own(&mut cut.ends().iter().map(|t| from + 0.5 * (1.0 + t) * (to - from)));
        let graded = !touches_all_around(&couple.bodies[0]) && !matches!(extent, Extent::Convex { .. });
        let width = width_for_height(couple, extent, &cuts, cut);
        OnRing { cuts, width, ends: if number == 0 { ends } else { Vec::new() }, graded }
    }
}

fn full_ring(couple: &Couple, number: usize, ring: &Ring, on: &OnRing) -> Result<Coarse, hpfem::Error> {
    let OnRing { cuts, ends, width, graded } = on;
    let (inner, outer) = (ring.inner.0, ring.outer.0);
    let centre = ring.centre.map_or([0.0; 2], |c| c.map(|c| c.0));
    let (from, to) = (cuts[0], cuts[cuts.len() - 1]);
    let turn = std::f64::consts::TAU;
    // Outside the contact: cells as wide as inside next to it, then wider.
    let contact_edge = couple.bodies[number].contact.as_str();
    let step = (cuts[1] - cuts[0]).min(0.25 * (turn - (to - from)));
    let rest = growing(to, from + turn, step, std::f64::consts::FRAC_PI_3);
    let angles: Vec<f64> = cuts.iter().copied().chain(rest[1..].iter().copied()).collect();
    let range = [from, from + turn];
    let breaks = parameters(&angles, range);
    let contact = parameters(&[from, to], range);
    let (bottom, top) = (arc(centre, inner, range), arc(centre, outer, range));
    // A drum around its shoe is touched on its bore.
    let (side, touched) = if contact_edge == "inner" { (Side::Bottom, bottom) } else { (Side::Top, top) };
    let mut names = vec![
        named(Side::Bottom, "inner"),
        named(Side::Top, "outer"),
        Named { side, range: Some([contact[0], contact[1]]), name: CONTACT },
    ];
    let loaded =
        [(Side::Bottom, "inner"), (Side::Top, "outer")].into_iter().filter(|(_, edge)| number == 0 && couple.load.is(edge));
    names.extend(loaded.map(|(side, _)| named(side, LOAD)));
    let singular = if *graded { vec![touched.point(contact[0]), touched.point(contact[1])] } else { Vec::new() };
    let free = parameters(ends, range).into_iter().map(|t| touched.point(t)).collect();
    let mesh = Mesh::ruled(&Ruled {
        bottom,
        top,
        breaks: &breaks,
        levels: &ring_levels(inner, outer, outer * width, side),
        closed: true,
        material: 0,
        names: &names,
    })?;
    Ok(Coarse { mesh, singular, ledges: [0.0; 2], free })
}

/// Levels of a ring from its inner arc, small at the side of the contact; about a hole much smaller than the cells next to it their radii grow
/// fourfold at most, as the fields do.
fn ring_levels(inner: f64, outer: f64, width: f64, contact: Side) -> Vec<f64> {
    let mut levels = levels(outer - inner, width, 1, contact);
    let growth = 1.0 + levels[1] * (outer - inner) / inner;
    let pieces = (growth.ln() / 4.0_f64.ln() * (1.0 - 1e-9)).ceil().max(1.0) as usize;
    let between = (1..pieces).map(|i| inner * (growth.powf(i as f64 / pieces as f64) - 1.0) / (outer - inner));
    levels.splice(1..1, between.collect::<Vec<_>>());
    levels
}

/// How far body 2 reaches beyond the contact where that is little of its length and of its `height` (mm); its ends are drawn back to those of
/// the contact.
fn ledges(x: &mut [f64; 2], ends: [f64; 2], (height, revolved): (f64, bool)) -> [f64; 2] {
    let most = (LEDGE * (ends[1] - ends[0])).min(LEDGE_BY_HEIGHT * height);
    [0, 1].map(|side| {
        let beyond = if side == 0 { ends[0] - x[0] } else { x[1] - ends[1] };
        // A ledge up to the axis has no side there.
        if beyond > most || (revolved && x[side] == 0.0) {
            return 0.0;
        }
        x[side] = ends[side];
        if beyond > SAME_END * (ends[1] - ends[0]) { beyond } else { 0.0 }
    })
}

fn block(
    couple: &Couple,
    rectangle: &Rectangle,
    (cuts, width): (&[f64], f64),
    shaped: bool,
    cut: Cut<'_>,
) -> Result<Coarse, hpfem::Error> {
    let (mut x, z) = (rectangle.x.map(|x| x.0), rectangle.z.map(|z| z.0));
    let ends = [cuts[0], cuts[cuts.len() - 1]];
    let ledges = if shaped { [0.0; 2] } else { ledges(&mut x, ends, (z[1] - z[0], couple.is_revolved())) };
    let (contact_side, contact_z) = if shaped { (Side::Bottom, z[0]) } else { (Side::Top, z[1]) };
    let step = widest(cuts);
    let points = merged(cuts.iter().copied().chain(x).collect());
    let points = subdivide(&points, 2.0 * step.max(0.05 * (x[1] - x[0])));
    let contact = parameters(&ends, x);
    let mut names = vec![
        named(Side::Bottom, "bottom"),
        named(Side::Top, "top"),
        named(Side::Left, "left"),
        named(Side::Right, "right"),
        Named { side: contact_side, range: Some([contact[0], contact[1]]), name: CONTACT },
    ];
    let axisymmetric = couple.is_revolved();
    if axisymmetric && x[0] == 0.0 {
        names.push(named(Side::Left, AXIS));
    }
    for (side, edge) in [(Side::Top, "top"), (Side::Left, "left"), (Side::Right, "right")] {
        if shaped && couple.load.is(edge) {
            names.push(named(side, LOAD));
        }
    }
    // Ends of contact, and the corners of the far side, where supports or a rigid edge end.
    let far_z = if shaped { z[1] } else { z[0] };
    let far_edge = if shaped { "top" } else { "bottom" };
    let held = couple.bodies[usize::from(!shaped)].supports.contains_key(far_edge);
    let free = cut.ends().iter().map(|t| [ends[0] + 0.5 * (1.0 + t) * (ends[1] - ends[0]), contact_z]).collect();
    let mut singular: Vec<[f64; 2]> = ends.iter().map(|x| [*x, contact_z]).collect();
    if held || (shaped && couple.load.is(far_edge)) {
        singular.extend(x.map(|x| [x, far_z]));
    }
    singular.retain(|point| !(axisymmetric && point[0] == 0.0));
    let mesh = Mesh::ruled(&Ruled {
        bottom: Curve::Line { start: [x[0], z[0]], end: [x[1], z[0]] },
        top: Curve::Line { start: [x[0], z[1]], end: [x[1], z[1]] },
        breaks: &parameters(&points, x),
        levels: &levels(z[1] - z[0], width, 2, contact_side),
        closed: false,
        material: 0,
        names: &names,
    })?;
    Ok(Coarse { mesh, singular, ledges, free })
}
