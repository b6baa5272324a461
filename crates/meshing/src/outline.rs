//! What is known of a body without its mesh: its named edges, where they are, and what they can touch. A template says it here and nowhere else.

use std::f64::consts::{FRAC_PI_2, PI};

use hpfem::{Curve, Mesh};
use scene::{Fault, Geometry, HalfDisc, Rectangle, Ring, RingSegment, ShoeBlock};

use crate::couple::Body;
use crate::line::ContactLine;

/// The outline of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Outline {
    /// The named edges, and the named lines inside.
    pub edges: Vec<Edge>,
    /// Thickness at the middle of the contact edge (mm); of cells that the user gives that of the material there, along the normal: a lining without
    /// its back. No number where the edge is unknown.
    pub thickness: f64,
}

/// A named edge.
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    /// Its name.
    pub name: String,
    /// Points [x, z] (mm) that span it: its ends, and the top or bottom of an arc; of cells three for each curve.
    pub points: Vec<[f64; 2]>,
    /// Whether it is a line inside the body, which can be held, but neither touched nor loaded.
    pub inside: bool,
    /// What it can touch as an edge of body 1 and of body 2; of cells that is found by [`crate::contact_line()`].
    pub touches: [Option<ContactLine>; 2],
    /// Whether a vertical load can act on a part of it.
    pub strips: bool,
}

impl Outline {
    /// Names of the edges, with the lines inside or without.
    pub fn names(&self, inside: bool) -> Vec<String> {
        self.edges.iter().filter(|edge| inside || !edge.inside).map(|edge| edge.name.clone()).collect()
    }

    /// An edge by its name.
    pub fn edge(&self, name: &str) -> Option<&Edge> {
        self.edges.iter().find(|edge| edge.name == name)
    }

    /// The points that span an edge; none of an unknown one.
    pub fn points(&self, name: &str) -> Vec<[f64; 2]> {
        self.edge(name).map(|edge| edge.points.clone()).unwrap_or_default()
    }
}

/// The outline of a body; of one given by its cells every named edge is a curve of its mesh.
pub fn outline(body: &Body) -> Outline {
    match &body.geometry {
        Geometry::ShoeBlock(shoe) => shoe_block(shoe),
        Geometry::Ring(circles) => ring(circles),
        Geometry::Rectangle(block) => rectangle(block),
        Geometry::RingSegment(segment) => ring_segment(segment),
        Geometry::HalfDisc(disc) => half_disc(disc),
        Geometry::Blocks(_) | Geometry::Mesh(_) => of_cells(body),
    }
}

fn edge(name: &str, points: Vec<[f64; 2]>) -> Edge {
    Edge { name: name.into(), points, inside: false, touches: [None, None], strips: false }
}

fn shoe_block(shoe: &ShoeBlock) -> Outline {
    let angle = shoe.half_angle.0;
    let (sine, cosine) = angle.sin_cos();
    let (x, low, high) = (shoe.radius.0 * sine, shoe.radius.0 * cosine, shoe.top.0);
    let circle = ContactLine::Circle { centre: [0.0; 2], radius: shoe.radius.0, angles: [-angle, angle], internal: false };
    let inner = edge("inner", vec![[-x, low], [0.0, shoe.radius.0], [x, low]]);
    Outline {
        edges: vec![
            Edge { touches: [Some(circle), None], ..inner },
            edge("left", vec![[-x, low], [-x, high]]),
            edge("right", vec![[x, low], [x, high]]),
            edge("top", vec![[-x, high], [x, high]]),
        ],
        thickness: shoe.top.0 - shoe.radius.0,
    }
}

fn ring(ring: &Ring) -> Outline {
    let centre = ring.centre.map_or([0.0; 2], |centre| centre.map(|x| x.0));
    let circle = |name: &str, radius: f64, internal: bool| {
        let [x, z] = centre;
        let touch = |angles, internal| Some(ContactLine::Circle { centre, radius, angles, internal });
        let points = vec![[x - radius, z], [x, z + radius], [x + radius, z]];
        // As body 1 the ring lies on the other side of the circle.
        Edge { touches: [touch(reach_of_whole(!internal), !internal), touch([-PI, PI], internal)], ..edge(name, points) }
    };
    Outline {
        edges: vec![circle("inner", ring.inner.0, true), circle("outer", ring.outer.0, false)],
        thickness: ring.outer.0 - ring.inner.0,
    }
}

/// How far from the top or bottom of a whole circle two bodies can touch that are pressed on each other along z (rad): a quarter of a turn less a degree.
/// Where there is clearance, contact ends before that.
const REACH: f64 = 89.0 / 180.0 * PI;

/// The part of a whole circle of body 1 that can touch: about its bottom if body 1 lies inside, else about its top.
pub(crate) fn reach_of_whole(internal: bool) -> [f64; 2] {
    let about = if internal { PI } else { 0.0 };
    [about - REACH, about + REACH]
}

/// Whether the contact edge of a body is a whole circle.
pub fn touches_all_around(body: &Body) -> bool {
    match (&body.geometry, &body.cells) {
        (Geometry::Ring(_), _) => true,
        (_, Some(mesh)) => {
            let curves = edge_curves(mesh, &body.contact);
            let arc = |curve: &Curve| if let Curve::Arc { from, to, .. } = curve { (to - from).abs() } else { 0.0 };
            curves.iter().map(arc).sum::<f64>() > 2.0 * PI * (1.0 - 1e-9)
        }
        (_, None) => false,
    }
}

fn rectangle(rectangle: &Rectangle) -> Outline {
    let (x, z) = (rectangle.x.map(|x| x.0), rectangle.z.map(|z| z.0));
    let line = |z: f64| Some(ContactLine::Line { z, x });
    Outline {
        edges: vec![
            edge("left", vec![[x[0], z[0]], [x[0], z[1]]]),
            edge("right", vec![[x[1], z[0]], [x[1], z[1]]]),
            Edge { touches: [line(z[0]), None], ..edge("bottom", vec![[x[0], z[0]], [x[1], z[0]]]) },
            Edge { touches: [None, line(z[1])], ..edge("top", vec![[x[0], z[1]], [x[1], z[1]]]) },
        ],
        thickness: z[1] - z[0],
    }
}

fn ring_segment(segment: &RingSegment) -> Outline {
    let (inner, outer, x) = (segment.inner.0, segment.outer.0, segment.x.map(|x| x.0));
    let height = |radius: f64, x: f64| (radius * radius - x * x).sqrt();
    let cut = |x: f64| vec![[x, height(inner, x)], [x, height(outer, x)]];
    let arc = |radius: f64| {
        let middle = if x[0] < 0.0 && x[1] > 0.0 { 0.0 } else { 0.5 * (x[0] + x[1]) };
        [x[0], middle, x[1]].map(|x| [x, height(radius, x)]).to_vec()
    };
    let angles = x.map(|x| (x / inner).asin());
    let circle = ContactLine::Circle { centre: [0.0; 2], radius: inner, angles, internal: false };
    Outline {
        edges: vec![
            Edge { touches: [Some(circle), None], ..edge("inner", arc(inner)) },
            Edge { strips: true, ..edge("outer", arc(outer)) },
            edge("left", cut(x[0])),
            edge("right", cut(x[1])),
            Edge { inside: true, ..edge("centre", cut(0.0)) },
        ],
        thickness: outer - inner,
    }
}

fn half_disc(disc: &HalfDisc) -> Outline {
    let ([x, z], radius) = (disc.centre.map(|c| c.0), disc.radius.0);
    let angles = [FRAC_PI_2, PI + FRAC_PI_2];
    let circle = ContactLine::Circle { centre: [x, z], radius, angles, internal: true };
    let arc = edge("arc", vec![[x - radius, z], [x, z - radius], [x + radius, z]]);
    Outline {
        edges: vec![
            Edge { touches: [Some(circle), None], ..arc },
            edge("top", vec![[x - radius, z], [x + radius, z]]),
            Edge { inside: true, ..edge("centre", vec![[x, z - radius], [x, z]]) },
        ],
        thickness: radius,
    }
}

/// Of a body given by its cells; which edges lie inside is said by [`crate::outside`], with the place.
fn of_cells(body: &Body) -> Outline {
    let Some(mesh) = &body.cells else { return Outline { edges: Vec::new(), thickness: 0.0 } };
    let points = |name: &str| -> Vec<[f64; 2]> {
        edge_curves(mesh, name).iter().flat_map(|curve| [-1.0, 0.0, 1.0].map(|t| curve.point(t))).collect()
    };
    let edges = mesh.boundaries.iter().map(|name| Edge { strips: true, ..edge(name, points(name)) }).collect();
    Outline { edges, thickness: thickness_of_cells(mesh, &body.contact) }
}

/// How far a normal from the middle of the contact edge runs inside the material there.
fn thickness_of_cells(mesh: &Mesh, contact: &str) -> f64 {
    let touching = mesh.boundary(contact).unwrap_or_default();
    let middle = |e: &usize| mesh.edges[*e].curve.point(0.0);
    let ends = touching.iter().map(middle).fold([f64::MAX, f64::MIN], |[a, b], x| [a.min(x[0]), b.max(x[0])]);
    let off = |e: &usize| (middle(e)[0] - 0.5 * (ends[0] + ends[1])).abs();
    let Some(start) = touching.iter().min_by(|a, b| off(a).total_cmp(&off(b))) else { return f64::NAN };
    let cells = mesh.edge_cells();
    let Some(foot) = Foot::on(mesh, &cells, *start, 0.0) else { return f64::NAN };
    // Sides of the material: edges with one cell of it.
    let sides = cells.iter().enumerate().filter(|(e, around)| {
        around.iter().filter(|(cell, _)| mesh.cells[*cell].material == foot.material).count() == 1 && !touching.contains(e)
    });
    sides.filter_map(|(e, _)| foot.distance(&mesh.edges[e].curve)).fold(f64::INFINITY, f64::min)
}

/// Lines that a curve is taken for to find out where a ray crosses it, and tries to find the place on it.
const PIECES: u32 = 64;
const TRIES: usize = 60;

/// A place of the contact edge, from which a normal runs into the body.
pub(crate) struct Foot {
    at: [f64; 2],
    normal: [f64; 2],
    /// Of the cell there.
    pub(crate) material: usize,
}

impl Foot {
    /// A place on an edge of a mesh at its parameter in [-1, 1]; none where no cell has the edge.
    pub(crate) fn on(mesh: &Mesh, cells: &[Vec<(usize, usize)>], edge: usize, parameter: f64) -> Option<Foot> {
        let (owner, local) = cells[edge].first().copied()?;
        let curve = &mesh.edges[edge].curve;
        let along = curve.derivative(parameter);
        // The curve of the cell runs with that of the edge, or against it; local edges 0 and 1 have the cell on their left.
        let [ahead, own] = [curve.derivative(0.0), mesh.local_curve(owner, local).derivative(0.0)];
        let with = ahead[0] * own[0] + ahead[1] * own[1] > 0.0;
        let length = if (local < 2) == with { along[0].hypot(along[1]) } else { -along[0].hypot(along[1]) };
        Some(Foot {
            at: curve.point(parameter),
            normal: [-along[1] / length, along[0] / length],
            material: mesh.cells[owner].material,
        })
    }

    /// Distance along the normal to a curve; none where they do not cross.
    pub(crate) fn distance(&self, curve: &Curve) -> Option<f64> {
        // Along the normal and across it.
        let place = |t: f64| {
            let x = curve.point(t);
            let [dx, dz] = [x[0] - self.at[0], x[1] - self.at[1]];
            [dx * self.normal[0] + dz * self.normal[1], dx * self.normal[1] - dz * self.normal[0]]
        };
        let start = |i: u32| 2.0 * f64::from(i) / f64::from(PIECES) - 1.0;
        let crossed = (0..PIECES).filter_map(|i| {
            let [mut low, mut high] = [start(i), start(i + 1)];
            let [before, after] = [place(low)[1], place(high)[1]];
            if before * after > 0.0 || before == after {
                return None;
            }
            for _ in 0..TRIES {
                let mid = 0.5 * (low + high);
                if place(mid)[1] * before > 0.0 { low = mid } else { high = mid }
            }
            let ends = [place(low), place(high)];
            let share = ends[0][1] / (ends[0][1] - ends[1][1]);
            let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
            Some(ends[0][0] + share * (ends[1][0] - ends[0][0]))
        });
        crossed.filter(|distance| *distance > 0.0).reduce(f64::min)
    }
}

/// The curves of a named edge.
pub(crate) fn edge_curves(mesh: &Mesh, edge: &str) -> Vec<Curve> {
    mesh.boundary(edge).unwrap_or_default().into_iter().map(|e| mesh.edges[e].curve).collect()
}

/// Refuses an edge with a part inside the body, where nothing can touch or press it.
///
/// # Errors
/// The fault of the key that names the edge: of the blocks, or the mesh file.
pub fn outside(body: &Body, edge: &str) -> Result<(), Fault> {
    let Some(mesh) = &body.cells else { return Ok(()) };
    let key = body.key;
    let cells = mesh.edge_cells();
    let inside = mesh.boundary(edge).unwrap_or_default().into_iter().find(|e| cells[*e].len() > 1);
    let Some(e) = inside else { return Ok(()) };
    let [x, z] = mesh.edges[e].curve.point(0.0);
    let place = match body.geometry.blocks() {
        Some(_) => format!("{key}.geometry.blocks.edges.{edge}"),
        None => format!("{key}.geometry.mesh.file"),
    };
    let message = format!("the edge `{edge}` lies inside the body at x = {x}, z = {z}, where nothing can touch or load it");
    Err(Fault::at(place, "not-on-boundary", message, "name curves of one cell only; inner lines can be held by supports"))
}
