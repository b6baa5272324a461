//! Meshes of a half-disc on a rectangle, with element nodes on wanted places of the contact surface.
//!
//! ```text
//!   z = R  C-----M-----E     nested cells around the first point of contact O: break
//!          |     |    /      points at the wanted nodes, at the end of the candidate
//!          A-----D   /       surface, then growing
//!          |     |  /
//!          O-x0-x1-B         the rectangle below has the same break points
//! ```
//! Both are cut at x = 0, the plane of symmetry or the axis, and mirrored where the load has no symmetry.

use hpfem::{Curve, Edge, Error, Mesh, Quad};
use scene::{Component, Fault, Geometry, HalfDisc, Material, Rectangle};

use crate::couple::Couple;
use crate::names::{AXIS, CONTACT, LOAD};

/// Ratio of the sizes of successive layers around an end of contact.
const RATIO: f64 = 0.2;
/// Where the contact between the middle or an end of stick and the next end is cut: on one cell up to the first layer the root at the end converges more
/// slowly than anything else. Of .5, .55, .65 and .75 with ratios of .15 to .25 these two are the best for cylinder, ball and push at 1e-6.
const WITHIN: f64 = 0.55;
/// Length of the candidate surface over that of the trial contact.
pub const CANDIDATE: f64 = 1.5;

/// A half-disc on the flat top of a rectangle, both symmetric about the line through the centre.
#[derive(Clone, Debug)]
pub struct HalfDiscOnFlat {
    /// Radius of the disc (mm).
    pub radius: f64,
    /// Place x of the centre (mm).
    pub middle: f64,
    /// Height z of the flat side (mm).
    pub height: f64,
    /// From the middle to the side of the rectangle.
    width: f64,
    depth: f64,
    /// Both halves are meshed; otherwise the half x >= 0.
    pub whole: bool,
    rigid: bool,
}

impl HalfDiscOnFlat {
    /// The half-disc and the rectangle of a couple; none if its bodies are others.
    ///
    /// # Errors
    /// The fault of bodies that are not symmetric about the line through the centre, or held so that they cannot be pressed.
    pub fn of(couple: &Couple) -> Result<Option<HalfDiscOnFlat>, Fault> {
        let [body1, body2] = &couple.bodies;
        let (Geometry::HalfDisc(disc), Geometry::Rectangle(plate)) = (&body1.geometry, &body2.geometry) else {
            return Ok(None);
        };
        let HalfDisc { radius, centre } = disc;
        let Rectangle { x, z } = plate;
        let revolved = couple.is_revolved();
        let middle = centre[0].0;
        let (left, right) = (middle - x[0].0, x[1].0 - middle);
        let symmetric = if revolved { left == 0.0 } else { (left - right).abs() <= 1e-12 * (left + right) };
        if !symmetric {
            let message = format!("body 2 from x = {} to {} is not symmetric about the centre x = {middle}", x[0].0, x[1].0);
            let remedy = if revolved { "let it begin on the axis, x = [0, ...]" } else { "give it the same width on both sides" };
            return Err(Fault::at("body2.geometry.rectangle.x", "not-available", message, remedy));
        }
        let sides = ["left", "right"].map(|side| body2.supports.get(side));
        if !revolved && sides[0] != sides[1] {
            let message = "body 2 is not held alike on its left and right";
            return Err(Fault::at("body2.support", "not-available", message, "hold both sides alike, or the bottom"));
        }
        let bad = body1.supports.iter().find(|(edge, held)| *edge == "arc" || held.holds(Component::Z));
        if let Some((edge, _)) = bad {
            let message = format!("body 1 is held on its edge {edge}, so that the load cannot press it on body 2");
            return Err(Fault::at("body1.support", "held", message, "hold body 1 along x only, on its line centre or its top"));
        }
        if !revolved && let Some(body) = couple.bodies.iter().find(|body| body.materials.iter().any(is_askew)) {
            let message =
                "the axes of an orthotropic material that are turned are not symmetric about the line through the centre";
            let remedy = "turn them by a multiple of 90 deg, or give the disc by cells (geometry.blocks)";
            return Err(Fault::at(format!("{}.material.angle", body.key), "not-available", message, remedy));
        }
        if let Some(body) = couple.bodies.iter().find(|body| !body.loads.is_empty()) {
            let load = body.loads[0];
            let message = format!("the contact of a half-disc with a flat does not know {}", load.word());
            let remedy = "give the disc by cells (geometry.blocks), or leave it out";
            return Err(Fault::at(format!("{}.{}", body.key, load.key()), "not-available", message, remedy));
        }
        let rigid = couple.has_rigid_edge();
        Ok(Some(HalfDiscOnFlat {
            radius: radius.0,
            middle,
            height: z[1].0,
            width: right,
            depth: z[1].0 - z[0].0,
            whole: rigid && !revolved,
            rigid,
        }))
    }

    /// The longest contact (mm), from the middle, that fits the bodies and these meshes.
    pub fn longest(&self) -> f64 {
        (0.6 * self.radius).min(0.8 * self.width).min(0.8 * self.depth) / CANDIDATE
    }

    /// Unloaded gap (mm) above the flat side: `R - sqrt(R^2 - (x - x_0)^2)`, written without cancellation.
    pub fn gap(&self, x: f64) -> f64 {
        let (r, x) = (self.radius, x - self.middle);
        x * x / (r + ((r - x) * (r + x)).max(0.0).sqrt())
    }

    /// Both bodies with element nodes at the given distances (mm) from the middle (ascending; the last one is the end of contact) and so
    /// many layers around each of them.
    ///
    /// # Errors
    /// The fault of bodies too thin for cells around that contact.
    pub fn meshes(&self, nodes: &[f64], layers: usize) -> Result<[Mesh; 2], Fault> {
        let candidate = CANDIDATE * nodes[nodes.len() - 1];
        self.cut(&Breaks { nodes, candidate, graded: nodes }, layers)
    }

    /// Both bodies of a contact whose end moves: with element nodes at the given distances (mm) from the middle (ascending), a candidate surface
    /// that reaches as far as `reach`, and so many layers around the last of the nodes.
    ///
    /// # Errors
    /// Those of [`HalfDiscOnFlat::meshes`].
    pub fn meshes_reaching(&self, nodes: &[f64], reach: f64, layers: usize) -> Result<[Mesh; 2], Fault> {
        let graded = &nodes[nodes.len().saturating_sub(1)..];
        self.cut(&Breaks { nodes, candidate: reach, graded }, layers)
    }

    fn cut(&self, breaks: &Breaks<'_>, layers: usize) -> Result<[Mesh; 2], Fault> {
        let meshes = || -> Result<[Mesh; 2], Error> {
            let halves = [self.disc(breaks, layers)?, self.block(breaks, layers)?];
            let [mut disc, mut block] = if self.whole { [mirrored(&halves[0])?, mirrored(&halves[1])?] } else { halves };
            shift(&mut disc, [self.middle, self.height]);
            shift(&mut block, [self.middle, self.height]);
            Ok([disc, block])
        };
        meshes().map_err(|error| {
            let remedy = "make the bodies less thin, and the contact shorter than half of them";
            Fault::at("body1.geometry.half-disc", "degenerate", error.to_string(), remedy)
        })
    }

    /// Names of an edge on the line x = 0.
    fn on_axis(&self) -> Vec<&'static str> {
        if self.whole { vec![] } else { vec![AXIS] }
    }

    /// The part x >= 0 of the half-disc about (0, R), cut at z = R.
    fn disc(&self, breaks: &Breaks<'_>, layers: usize) -> Result<Mesh, Error> {
        let (r, candidate) = (self.radius, breaks.candidate);
        let (mut plan, [b, d, a]) = Plan::nested(&breaks.levels(r * 0.5_f64.sqrt()), 0.7);
        let e = plan.vertices.len();
        plan.add(&[[r, r], [0.5 * r, r], [0.0, r]], &[[b, e, e + 1, d], [a, d, e + 1, e + 2]]);
        let straight = plan.refined(&towards(breaks.graded), layers)?;
        let sag = |x: f64| x * x / (r + (r * r - x * x).max(0.0).sqrt());
        let place = |v: [f64; 2]| if v[0] >= r { v } else { [v[0], v[1] + sag(v[0]) * (1.0 - v[1] / r)] };
        let angle = |v: [f64; 2]| if v[0] >= r { 0.0 } else { (v[0] / r).asin() - std::f64::consts::FRAC_PI_2 };
        let on_arc = |v: [f64; 2]| v[1] == 0.0 || at_end(v[0], r);
        let curve = |p: [f64; 2], q: [f64; 2]| {
            (on_arc(p) && on_arc(q)).then(|| Curve::Arc { centre: [0.0, r], radius: r, from: angle(p), to: angle(q) })
        };
        let mesh = moved(&straight, false, place, curve, |p, q| {
            let mut names = Vec::new();
            if on_arc(p) && on_arc(q) {
                names.push("arc");
            }
            if p[1] == 0.0 && q[1] == 0.0 && p[0].max(q[0]) <= candidate * (1.0 + 1e-12) {
                names.push(CONTACT);
            }
            if p[0] == 0.0 && q[0] == 0.0 {
                names.push("centre");
                names.extend(self.on_axis());
            }
            if at_end(p[1], r) && at_end(q[1], r) {
                names.extend(["top", LOAD]);
            }
            names
        })?;
        if !self.rigid {
            return Ok(mesh);
        }
        let corner = mesh.nearest_vertex([r, r]);
        mesh.refined_towards(&[corner], RATIO, layers)
    }

    /// The part x >= 0 of the rectangle below z = 0.
    fn block(&self, breaks: &Breaks<'_>, layers: usize) -> Result<Mesh, Error> {
        let (w, h, candidate) = (self.width, self.depth, breaks.candidate);
        let side = w.min(h);
        let (mut plan, [b, d, a]) = Plan::nested(&breaks.levels(side), 1.0);
        // Beyond the square: along the longer side. First the end of the last row at the middle line or the surface, then the other.
        let (mut near, mut far) = if h > w { (a, d) } else { (b, d) };
        for to in growing(side, w.max(h)).skip(1) {
            let n = plan.vertices.len();
            if h > w {
                plan.add(&[[0.0, to], [w, to]], &[[near, far, n + 1, n]]);
            } else if w > h {
                plan.add(&[[to, 0.0], [to, h]], &[[near, n, n + 1, far]]);
            }
            (near, far) = (n, n + 1);
        }
        let places: Vec<[f64; 2]> = towards(breaks.graded).into_iter().chain([[w, h]]).collect();
        let straight = plan.refined(&places, layers)?;
        let below = |v: [f64; 2]| [v[0], -v[1]];
        let names = |p: [f64; 2], q: [f64; 2]| {
            let mut names = Vec::new();
            if p[1] == 0.0 && q[1] == 0.0 {
                names.push("top");
                if p[0].max(q[0]) <= candidate * (1.0 + 1e-12) {
                    names.push(CONTACT);
                }
            }
            if p[0] == 0.0 && q[0] == 0.0 {
                names.extend(self.on_axis());
            }
            if at_end(p[0], w) && at_end(q[0], w) {
                names.push("right");
            }
            if at_end(p[1], h) && at_end(q[1], h) {
                names.push("bottom");
            }
            names
        };
        moved(&straight, true, below, |_, _| None, names)
    }
}

/// Whether a coordinate is that of an edge: its pieces end on it but for round-off.
fn at_end(x: f64, edge: f64) -> bool {
    (x - edge).abs() <= 1e-12 * edge
}

/// Where half of each body is cut on the contact surface (mm from the middle, ascending).
struct Breaks<'a> {
    nodes: &'a [f64],
    /// End of the candidate surface.
    candidate: f64,
    /// Nodes with layers around them.
    graded: &'a [f64],
}

impl Breaks<'_> {
    /// All nested squares: at the nodes and between those that are graded, at the end of the candidate surface, and growing to `last`.
    fn levels(&self, last: f64) -> Vec<f64> {
        // Nodes that the end of contact only passes are close together.
        let before = std::iter::once(&0.0).chain(self.nodes).zip(self.nodes);
        let within = before.filter(|_| self.graded.len() == self.nodes.len()).map(|(from, to)| from + WITHIN * (to - from));
        let mut inner: Vec<f64> = within.chain(self.nodes.iter().copied()).collect();
        inner.sort_unstable_by(f64::total_cmp);
        inner.into_iter().chain(growing(self.candidate, last)).collect()
    }
}

/// Points from `from` to `to` whose distances from zero grow by the same factor of at most 2.
fn growing(from: f64, to: f64) -> impl Iterator<Item = f64> {
    let count = ((to / from).log2() * (1.0 - 1e-9)).ceil().max(1.0) as usize;
    (0..=count).map(move |j| if j == count { to } else { from * (to / from).powf(j as f64 / count as f64) })
}

fn towards(nodes: &[f64]) -> Vec<[f64; 2]> {
    nodes.iter().map(|x| [*x, 0.0]).collect()
}

/// Straight cells in the quadrant x >= 0, z >= 0.
struct Plan {
    vertices: Vec<[f64; 2]>,
    quads: Vec<Quad>,
}

impl Plan {
    /// Nested cells around the origin, and the vertices B, D, A of the last level.
    fn nested(levels: &[f64], shrink: f64) -> (Plan, [usize; 3]) {
        let mut plan = Plan { vertices: vec![[0.0, 0.0]], quads: Vec::new() };
        for (j, x) in levels.iter().enumerate() {
            let n = plan.vertices.len();
            let corners = [[*x, 0.0], [shrink * x, shrink * x], [0.0, shrink * x]];
            if j == 0 {
                plan.add(&corners, &[[0, 1, 2, 3]]);
            } else {
                plan.add(&corners, &[[n - 3, n, n + 1, n - 2], [n - 1, n - 2, n + 1, n + 2]]);
            }
        }
        let n = plan.vertices.len();
        (plan, [n - 3, n - 2, n - 1])
    }

    fn add(&mut self, vertices: &[[f64; 2]], quads: &[[usize; 4]]) {
        self.vertices.extend(vertices);
        self.quads.extend(quads.iter().map(|corners| Quad { corners: *corners, material: 0, layer: 0 }));
    }

    /// The mesh, refined towards one place after the other.
    fn refined(&self, places: &[[f64; 2]], layers: usize) -> Result<Mesh, Error> {
        let mut mesh = Mesh::new(self.vertices.clone(), &self.quads, &[], &[])?;
        for place in places {
            mesh = mesh.refined_towards(&[mesh.nearest_vertex(*place)], RATIO, layers)?;
        }
        Ok(mesh)
    }
}

fn quads(mesh: &Mesh) -> Vec<Quad> {
    mesh.cells.iter().map(|c| Quad { corners: c.corners, material: c.material, layer: c.layer }).collect()
}

/// The mirror image of a cell's corners, anti-clockwise again.
fn turn(quad: Quad) -> Quad {
    let [a, b, c, d] = quad.corners;
    Quad { corners: [b, a, d, c], ..quad }
}

/// The same topology with vertices and curves moved (`flipped` if that is a reflection), and edges named by the straight positions of
/// their ends.
fn moved(
    straight: &Mesh,
    flipped: bool,
    place: impl Fn([f64; 2]) -> [f64; 2],
    curve: impl Fn([f64; 2], [f64; 2]) -> Option<Curve>,
    names: impl Fn([f64; 2], [f64; 2]) -> Vec<&'static str>,
) -> Result<Mesh, Error> {
    let ends = |e: &Edge| e.vertices.map(|v| straight.vertices[v]);
    let (mut curves, mut named) = (Vec::new(), Vec::new());
    for edge in &straight.edges {
        let [p, q] = ends(edge);
        curves.extend(curve(p, q).map(|c| (edge.vertices, c)));
        named.extend(names(p, q).into_iter().map(|name| (edge.vertices, name)));
    }
    let quads: Vec<Quad> = quads(straight).into_iter().map(|q| if flipped { turn(q) } else { q }).collect();
    Mesh::new(straight.vertices.iter().map(|v| place(*v)).collect(), &quads, &curves, &named)
}

/// A mesh and its mirror image in x = 0, joined there; names are kept, but for the right side, whose image is the left.
fn mirrored(half: &Mesh) -> Result<Mesh, Error> {
    let mut vertices = half.vertices.clone();
    let mut image: Vec<usize> = (0..vertices.len()).collect();
    for (i, v) in half.vertices.iter().enumerate().filter(|(_, v)| v[0] != 0.0) {
        image[i] = vertices.len();
        vertices.push([-v[0], v[1]]);
    }
    let copies = quads(half).into_iter().map(|q| turn(Quad { corners: q.corners.map(|v| image[v]), ..q }));
    let all: Vec<Quad> = quads(half).into_iter().chain(copies).collect();
    let (mut curves, mut names) = (Vec::new(), Vec::new());
    for edge in &half.edges {
        let other = edge.vertices.map(|v| image[v]);
        curves.push((edge.vertices, edge.curve));
        if let Curve::Arc { centre, radius, from, to } = edge.curve {
            let back = |angle: f64| -std::f64::consts::PI - angle;
            curves.push((other, Curve::Arc { centre: [-centre[0], centre[1]], radius, from: back(from), to: back(to) }));
        }
        for tag in &edge.tags {
            let name = half.boundaries[*tag].as_str();
            names.extend([(edge.vertices, name), (other, if name == "right" { "left" } else { name })]);
        }
    }
    Mesh::new(vertices, &all, &curves, &names)
}

/// Whether a material has other moduli after a reflection left to right.
fn is_askew(material: &Material) -> bool {
    let quarters = material.angle.map_or(0.0, |angle| angle.0 / std::f64::consts::FRAC_PI_2);
    material.is_orthotropic() && (quarters - quarters.round()).abs() > 1e-12
}

/// Moves a mesh of lines and arcs as a whole.
fn shift(mesh: &mut Mesh, by: [f64; 2]) {
    let add = |x: &mut [f64; 2]| *x = [x[0] + by[0], x[1] + by[1]];
    mesh.vertices.iter_mut().for_each(add);
    for edge in &mut mesh.edges {
        match &mut edge.curve {
            Curve::Arc { centre, .. } => add(centre),
            Curve::Line { start, end } | Curve::Polynomial { start, end, .. } => {
                add(start);
                add(end);
            }
        }
    }
}
