//! Meshes of bodies given by their cells: cut where contact and load end, where the other body has its break points, and where cells
//! are slender.

use std::collections::BTreeSet;

use hpfem::{Direction, Mesh, Support, bisect};
use scene::{Component, Fault};

use crate::couple::{Couple, Strip};
use crate::cuts::{READ, SAME};
use crate::extent::Extent;
use crate::names::{AXIS, CONTACT, LOAD};
use crate::rows;

/// Share of an edge within which its end is moved onto an end of contact instead of cutting the edge there.
const NEAR: f64 = 0.25;

/// A body given by its cells, its surfaces named, and the points towards which it is to be graded.
#[derive(Clone, Debug)]
pub(crate) struct Cells {
    pub mesh: Mesh,
    pub singular: Vec<[f64; 2]>,
    /// Edge of the scene that touches the other body.
    contact: String,
    extent: Extent,
}

fn degenerate(key: &str, error: &hpfem::Error) -> Fault {
    Fault::at(format!("{key}.geometry"), "degenerate", error.to_string(), "make its cells less thin or less distorted")
}

impl Cells {
    /// The cells of a body, cut at the ends of its contact and of its load.
    pub(crate) fn new(couple: &Couple, number: usize, mesh: Mesh, extent: Extent) -> Result<Cells, Fault> {
        let (shaped, body) = (number == 0, &couple.bodies[number]);
        let key = body.key;
        let mut cells = Cells { mesh, singular: Vec::new(), contact: body.contact.clone(), extent };
        if let Extent::Round { x, touch, .. } = extent {
            cells.focus(touch, 1.4 * (x[1] - touch).max(touch - x[0])).map_err(|error| degenerate(key, &error))?;
            x.iter().for_each(|end| cells.draw(*end));
        }
        cells.cut(&extent.ends())?;
        let touching: Vec<usize> = cells.contact_edges().into_iter().map(|(e, _)| e).collect();
        tag(&mut cells.mesh, &touching, CONTACT);
        if shaped {
            let (edge, strip) = (&couple.load.edge, couple.load.strip.map(Strip::ends));
            for x in strip.into_iter().flatten() {
                cells.cut_edge_at_x(edge, x).map_err(|error| degenerate(key, &error))?;
            }
            let under = |e: &usize| {
                let x = cells.mesh.edges[*e].curve.point(0.0)[0];
                strip.is_none_or(|[from, to]| (from..=to).contains(&x))
            };
            let loaded: Vec<usize> = cells.mesh.boundary(edge).unwrap_or_default().into_iter().filter(under).collect();
            tag(&mut cells.mesh, &loaded, LOAD);
        }
        if couple.is_revolved() {
            let on_axis = |e: &usize| cells.mesh.edges[*e].vertices.iter().all(|v| cells.mesh.vertices[*v][0] == 0.0);
            let axis: Vec<usize> = (0..cells.mesh.edges.len()).filter(on_axis).collect();
            tag(&mut cells.mesh, &axis, AXIS);
        }
        cells.singular = singular(couple, number, &cells.mesh, extent).map_err(|error| degenerate(key, &error))?;
        cells.mesh = rows::cut_slender(cells.mesh).map_err(|error| degenerate(key, &error))?;
        Ok(cells)
    }

    /// Coordinates of the break points on the contact surface, ends included.
    pub(crate) fn breaks(&self) -> Vec<f64> {
        self.contact_edges().into_iter().flat_map(|(_, range)| range).collect()
    }

    /// Cuts the contact surface at the given coordinates; a vertex next to one is moved there.
    pub(crate) fn cut(&mut self, places: &[f64]) -> Result<(), Fault> {
        let [from, to] = self.extent.ends();
        for place in places {
            if self.moved_to(*place)? {
                continue;
            }
            let edges = self.mesh.boundary(&self.contact).unwrap_or_default();
            let near = SAME * (to - from);
            let hit = edges.into_iter().find_map(|e| {
                let [a, b] = self.extent.range(&self.mesh.edges[e].curve);
                let t = self.extent.parameter(&self.mesh.edges[e].curve, *place);
                ((place - a).abs().min((place - b).abs()) > near && t.abs() < 1.0).then_some((e, t))
            });
            if let Some((edge, t)) = hit {
                self.mesh = self.mesh.cut_through(edge, t).map_err(|error| {
                    Fault::at(
                        "contact.edges",
                        "not-available",
                        error.to_string(),
                        "give both bodies the same points on the contact",
                    )
                })?;
            }
        }
        Ok(())
    }

    /// Moves the break point next to a place of the contact surface there; false if there is none.
    fn moved_to(&mut self, place: f64) -> Result<bool, Fault> {
        let [from, to] = self.extent.ends();
        let edges = self.mesh.boundary(&self.contact).unwrap_or_default();
        let found = edges.into_iter().find_map(|e| {
            let range = self.extent.range(&self.mesh.edges[e].curve);
            let end = (0..2).find(|k| (range[*k] - place).abs() <= SAME * (to - from))?;
            let curve = &self.mesh.edges[e].curve;
            // Half the step in the parameter is the share of the length.
            let share = 0.5 * (self.extent.parameter(curve, place) - [-1.0, 1.0][end]) * (range[1] - range[0]).signum();
            Some((self.mesh.edges[e].vertices[end], place - range[end], share * curve.length()))
        });
        let Some((vertex, off, shift)) = found else { return Ok(false) };
        if off.abs() <= 1e-13 * (to - from) {
            return Ok(true);
        }
        match self.mesh.with_vertex_moved(vertex, shift) {
            Ok(mesh) => self.mesh = mesh,
            Err(_) if off.abs() <= READ * (to - from) => {}
            Err(error) => {
                let message = format!(
                    "two points of the contact edges are only {:.1e} of the contact apart: {error}",
                    off.abs() / (to - from)
                );
                return Err(Fault::at("contact.edges", "not-available", message, "give both bodies the same points there"));
            }
        }
        Ok(true)
    }

    /// Puts a vertex on a place of the contact surface, and cells around it whose edges there are no longer than `length`.
    fn focus(&mut self, place: f64, length: f64) -> Result<(), hpfem::Error> {
        self.draw(place);
        let edges = self.mesh.boundary(&self.contact).unwrap_or_default();
        let hit = edges.into_iter().find_map(|e| {
            let t = self.extent.parameter(&self.mesh.edges[e].curve, place);
            (t.abs() < 1.0 - SAME).then_some((e, t))
        });
        if let Some((edge, t)) = hit {
            self.mesh = self.mesh.cut_through(edge, t)?;
        }
        let Some(vertex) = self.vertex_at(place) else { return Ok(()) };
        let own = |e: &usize| self.mesh.edges[*e].vertices.contains(&vertex);
        let edges = self.mesh.boundary(&self.contact).unwrap_or_default().into_iter().filter(own);
        let longest = edges.map(|e| self.mesh.edges[e].curve.length()).fold(0.0, f64::max);
        let layers = (longest / length).log2().ceil();
        if layers > 0.0 {
            let ratio = (length / longest).powf(1.0 / layers);
            self.mesh = self.mesh.refined_towards(&[vertex], ratio, layers as usize)?;
            // Nothing is singular there: these cells keep their degree.
            self.mesh.cells.iter_mut().for_each(|cell| cell.layer = 0);
        }
        Ok(())
    }

    /// Moves the next vertex of the contact surface onto a place, if it is near and nothing but the mesh depends on it: no border of materials,
    /// no end of the contact.
    pub(crate) fn draw(&mut self, place: f64) {
        let [from, to] = self.extent.ends();
        let ends_contact = |at: f64| [from, to].iter().any(|end| (at - end).abs() <= SAME * (to - from));
        let edges = self.mesh.boundary(&self.contact).unwrap_or_default();
        let near = edges.into_iter().find_map(|e| {
            let own = &self.mesh.edges[e];
            let t = self.extent.parameter(&own.curve, place);
            let end = usize::from(t > 0.0);
            let share = 0.5 * (t - [-1.0, 1.0][end]);
            let [a, b] = self.extent.range(&own.curve);
            (t.abs() <= 1.0 && share.abs() < NEAR && !ends_contact([a, b][end]))
                .then(|| (own.vertices[end], share * own.curve.length() * (b - a).signum()))
        });
        let Some((vertex, shift)) = near else { return };
        let cells = || self.mesh.cells.iter().filter(|cell| cell.vertices().contains(&vertex));
        let material = cells().next().map(|cell| cell.material);
        let sides = self.mesh.edge_cells();
        let mut inner =
            (0..self.mesh.edges.len()).filter(|e| sides[*e].len() > 1 && self.mesh.edges[*e].vertices.contains(&vertex));
        let free = cells().all(|cell| Some(cell.material) == material) && inner.all(|e| self.mesh.edges[e].tags.is_empty());
        if let Some(mesh) = Some(()).filter(|()| free).and_then(|()| self.mesh.with_vertex_moved(vertex, shift).ok()) {
            self.mesh = mesh;
        }
    }

    /// The vertex on a place of the contact surface.
    fn vertex_at(&self, place: f64) -> Option<usize> {
        let [from, to] = self.extent.ends();
        self.mesh.boundary(&self.contact).unwrap_or_default().into_iter().find_map(|e| {
            let range = self.extent.range(&self.mesh.edges[e].curve);
            let end = (0..2).find(|k| (range[*k] - place).abs() <= SAME * (to - from))?;
            Some(self.mesh.edges[e].vertices[end])
        })
    }

    /// Where the vertex on a place of the contact surface is.
    pub(crate) fn point_at(&self, place: f64) -> Option<[f64; 2]> {
        self.vertex_at(place).map(|v| self.mesh.vertices[v])
    }

    /// Cuts every piece of the contact surface in the middle.
    pub(crate) fn halve(&mut self) -> Result<(), Fault> {
        let middles: Vec<f64> = self.contact_edges().into_iter().map(|(_, [a, b])| 0.5 * (a + b)).collect();
        self.cut(&middles)
    }

    /// Cuts rows of cells in the middle, those that hold one of the edges.
    pub(crate) fn part(&mut self, edges: &[usize]) -> Result<(), Fault> {
        (self.mesh, _) = self.mesh.cut_rows(edges).map_err(|error| {
            Fault::at(
                "contact.edges",
                "not-available",
                error.to_string(),
                "cut the cells at the ends of contact and load once more",
            )
        })?;
        Ok(())
    }

    /// Adds a point to grade towards, if it is a vertex.
    pub(crate) fn grade_towards(&mut self, x: [f64; 2]) {
        add_singular(&self.mesh, &mut self.singular, x);
    }

    /// The coordinate of a point that is a break point of the contact surface.
    pub(crate) fn coordinate(&self, x: [f64; 2]) -> Option<f64> {
        let vertex = self.mesh.nearest_vertex(x);
        self.contact_edges().into_iter().find_map(|(e, range)| {
            let end = (0..2).find(|k| self.mesh.edges[e].vertices[*k] == vertex)?;
            Some(range[end])
        })
    }

    /// The edges within the contact and their ranges of the coordinate.
    fn contact_edges(&self) -> Vec<(usize, [f64; 2])> {
        let [from, to] = self.extent.ends();
        let edges = self.mesh.boundary(&self.contact).unwrap_or_default();
        let ranges = edges.into_iter().map(|e| (e, self.extent.range(&self.mesh.edges[e].curve)));
        ranges.filter(|(_, [a, b])| (from..=to).contains(&(0.5 * (a + b)))).collect()
    }

    fn cut_edge_at_x(&mut self, edge: &str, x: f64) -> Result<(), hpfem::Error> {
        let hit = self.mesh.boundary(edge)?.into_iter().find_map(|e| {
            let curve = &self.mesh.edges[e].curve;
            let off = |t: f64| curve.point(t)[0] - x;
            let near = 1e-9 * curve.length();
            if off(-1.0).abs() <= near || off(1.0).abs() <= near || off(-1.0) * off(1.0) > 0.0 {
                return None;
            }
            let [low, high] = bisect([-1.0, 1.0], 60, |middle| off(middle) * off(-1.0) > 0.0);
            Some((e, 0.5 * (low + high)))
        });
        if let Some((edge, t)) = hit {
            self.mesh = self.mesh.cut_through(edge, t)?;
        }
        Ok(())
    }
}

/// Adds a point to grade towards, if it is a vertex and not yet among them.
pub(crate) fn add_singular(mesh: &Mesh, singular: &mut Vec<[f64; 2]>, x: [f64; 2]) {
    let scale = mesh.vertices.iter().flatten().fold(0.0_f64, |scale, v| scale.max(v.abs()));
    let near = |a: &[f64; 2]| (x[0] - a[0]).hypot(x[1] - a[1]) <= 1e-9 * scale;
    if near(&mesh.vertices[mesh.nearest_vertex(x)]) && !singular.iter().any(near) {
        singular.push(x);
    }
}

fn tag(mesh: &mut Mesh, edges: &[usize], name: &str) {
    if edges.is_empty() {
        return;
    }
    let tag = mesh.boundaries.len();
    mesh.boundaries.push(name.to_string());
    edges.iter().for_each(|e| mesh.edges[*e].tags.push(tag));
}

/// An edge as the stress at its ends sees it: one that turns about a pin is clamped to a rigid line.
fn held_along(edge: &str, support: &scene::Support) -> Vec<Support> {
    let hold = |direction| Support::hold(edge, direction);
    let direction = |component: &Component| match component {
        Component::X => Some(Direction::First),
        Component::Z => Some(Direction::Second),
        Component::Phi => None,
    };
    match support {
        scene::Support::Components(held) => held.iter().filter_map(direction).map(hold).collect(),
        scene::Support::Pin(_) => vec![hold(Direction::First), hold(Direction::Second)],
        scene::Support::Roller(angle) => vec![Support::sliding(edge, angle.0)],
    }
}

/// Points where the stress of a body is unbounded or its load jumps.
fn singular(couple: &Couple, number: usize, mesh: &Mesh, extent: Extent) -> Result<Vec<[f64; 2]>, hpfem::Error> {
    let body = &couple.bodies[number];
    let support = Support::hold;
    let mut supports: Vec<Support> = body.supports.iter().flat_map(|(edge, held)| held_along(edge, held)).collect();
    // A round body has left the other where the surface that may touch ends.
    let mut loaded = if matches!(extent, Extent::Round { .. } | Extent::Convex { .. }) { vec![] } else { vec![CONTACT] };
    if number == 0 && couple.has_rigid_edge() {
        supports.extend([support(LOAD, Direction::First), support(LOAD, Direction::Second)]);
    } else if number == 0 {
        loaded.push(LOAD);
    }
    let mut found = BTreeSet::new();
    for materials in body.stand_ins() {
        let materials = materials.collect::<Result<Vec<_>, _>>()?;
        let singular = hpfem::singular_vertices(mesh, couple.kinematics, &materials, &supports, &loaded)?;
        found.extend(singular.into_iter().map(|v| v.vertex));
    }
    Ok(found.into_iter().map(|vertex| mesh.vertices[vertex]).collect())
}
