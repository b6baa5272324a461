//! The bodies as a picture shows them: areas by material, borders and named edges, as polylines in mm.

use std::collections::BTreeMap;

use hpfem::{Curve, Mesh};
use meshing::{Body, outline};
use scene::{Geometry, Material};

/// Pieces of a curved line.
const PIECES: usize = 32;

/// A body as a picture shows it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BodyOutline {
    /// Areas by material; a picture fills them by the rule of even and odd.
    pub areas: Vec<Area>,
    /// Where the body ends, and where its material changes.
    pub borders: Vec<Vec<[f64; 2]>>,
    /// The named edges: name and lines of points (x, z).
    pub edges: Vec<(String, Vec<Vec<[f64; 2]>>)>,
}

/// Part of a body of one material.
#[derive(Debug, Clone, PartialEq)]
pub struct Area {
    /// The material.
    pub material: Material,
    /// Closed lines around it and around its holes (mm).
    pub loops: Vec<Vec<[f64; 2]>>,
}

impl BodyOutline {
    /// The lines of a named edge; none of an unknown one.
    pub fn edge(&self, name: &str) -> &[Vec<[f64; 2]>] {
        self.edges.iter().find(|(known, _)| known == name).map_or(&[], |(_, lines)| lines)
    }

    /// A body of the couple; of a body of revolution the half with r >= 0.
    pub(crate) fn of(body: &Body, revolved: bool) -> BodyOutline {
        let mut all = match &body.cells {
            Some(mesh) => of_cells(mesh, body),
            None => of_template(body),
        };
        if revolved {
            let loops = all.areas.iter_mut().flat_map(|area| &mut area.loops);
            loops.flatten().for_each(|point| point[0] = point[0].max(0.0));
            // Edges and borders end at the axis, along which nothing touches and nothing is held.
            for lines in all.edges.iter_mut().map(|(_, lines)| lines).chain([&mut all.borders]) {
                *lines = lines.iter().flat_map(|line| beyond_the_axis(line)).collect();
            }
        }
        all
    }
}

/// The parts of a line with r >= 0, cut where it crosses the axis.
fn beyond_the_axis(line: &[[f64; 2]]) -> Vec<Vec<[f64; 2]>> {
    let mut parts: Vec<Vec<[f64; 2]>> = Vec::new();
    let mut open = false;
    for pair in line.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        let cut = || [0.0, a[1] - a[0] * (b[1] - a[1]) / (b[0] - a[0])];
        let [from, to] = match (a[0] >= 0.0, b[0] >= 0.0) {
            (true, true) => [a, b],
            (true, false) if a[0] > 0.0 => [a, cut()],
            (false, true) if b[0] > 0.0 => [cut(), b],
            (true, false) | (false, true) | (false, false) => {
                open = false;
                continue;
            }
        };
        match parts.last_mut().filter(|_| open) {
            Some(part) => part.push(to),
            None => parts.push(vec![from, to]),
        }
        open = b[0] >= 0.0;
    }
    parts
}

fn of_template(body: &Body) -> BodyOutline {
    let known = outline(body);
    let full = matches!(body.geometry, Geometry::Ring(_));
    let edges: Vec<(String, Vec<Vec<[f64; 2]>>)> =
        known.edges.iter().map(|edge| (edge.name.clone(), vec![line(&edge.points, full)])).collect();
    let outer = || known.edges.iter().zip(&edges).filter(|(edge, _)| !edge.inside).map(|(_, (_, lines))| lines[0].clone());
    let loops = if full { outer().collect() } else { vec![chained(outer().collect())] };
    let areas = body.materials.first().map(|material| Area { material: *material, loops }).into_iter().collect();
    BodyOutline { areas, borders: outer().collect(), edges }
}

/// A straight line through two points, or the arc through three; of a full circle all of it.
fn line(points: &[[f64; 2]], full: bool) -> Vec<[f64; 2]> {
    let [a, b, c] = points else { return points.to_vec() };
    let Some((centre, radius)) = circle(*a, *b, *c) else { return points.to_vec() };
    let angle = |p: &[f64; 2]| (p[1] - centre[1]).atan2(p[0] - centre[0]);
    let from = angle(a);
    let turn = std::f64::consts::TAU;
    // From the first point to the last so that the middle one lies between.
    let [middle, last] = [b, c].map(|p| (angle(p) - from).rem_euclid(turn));
    let sweep = match (full, middle <= last) {
        (true, _) => turn,
        (false, true) => last,
        (false, false) => last - turn,
    };
    let at = |k: usize| {
        let t = from + sweep * k as f64 / (2 * PIECES) as f64;
        [centre[0] + radius * t.cos(), centre[1] + radius * t.sin()]
    };
    (0..=2 * PIECES).map(at).collect()
}

/// Centre and radius of the circle through three points; none through points of one line.
fn circle(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Option<([f64; 2], f64)> {
    let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1]]);
    let (uu, vv) = (u[0] * u[0] + u[1] * u[1], v[0] * v[0] + v[1] * v[1]);
    let twice = 2.0 * (u[0] * v[1] - u[1] * v[0]);
    if twice.abs() <= 1e-12 * uu.max(vv) {
        return None;
    }
    let off = [(v[1] * uu - u[1] * vv) / twice, (u[0] * vv - v[0] * uu) / twice];
    Some(([a[0] + off[0], a[1] + off[1]], off[0].hypot(off[1])))
}

/// One closed line from lines that share their ends.
fn chained(mut lines: Vec<Vec<[f64; 2]>>) -> Vec<[f64; 2]> {
    let mut all = if lines.is_empty() { Vec::new() } else { lines.remove(0) };
    while let Some(end) = all.last().copied() {
        let far = |p: &[f64; 2]| (p[0] - end[0]).hypot(p[1] - end[1]);
        let near = |line: &Vec<[f64; 2]>| [line.first(), line.last()].map(|p| p.map_or(f64::INFINITY, far));
        let nearest = |line: &Vec<[f64; 2]>| near(line)[0].min(near(line)[1]);
        let found = (0..lines.len()).min_by(|a, b| nearest(&lines[*a]).total_cmp(&nearest(&lines[*b])));
        let Some(found) = found else { break };
        let mut next = lines.remove(found);
        if near(&next)[1] < near(&next)[0] {
            next.reverse();
        }
        all.extend(next);
    }
    all
}

fn of_cells(mesh: &Mesh, body: &Body) -> BodyOutline {
    let mut loops: BTreeMap<usize, Vec<Vec<[f64; 2]>>> = BTreeMap::new();
    for (number, cell) in mesh.cells.iter().enumerate() {
        // Once around: edges 0 and 1 forwards, 2 and 3 backwards.
        let around = cell.sides().flat_map(|(local, _)| {
            let curve = mesh.local_curve(number, local);
            drawn(&if local < 2 { curve } else { curve.reversed() })
        });
        loops.entry(cell.material).or_default().push(around.collect());
    }
    let material = |index: usize| body.materials.get(index).copied();
    let areas = loops.into_iter().filter_map(|(index, loops)| Some(Area { material: material(index)?, loops })).collect();
    let ends = |cells: &Vec<(usize, usize)>| match cells[..] {
        [(one, _), (other, _)] => mesh.cells[one].material != mesh.cells[other].material,
        _ => true,
    };
    let sides = mesh.edge_cells();
    let borders = mesh.edges.iter().zip(&sides).filter(|(_, cells)| ends(cells)).map(|(edge, _)| drawn(&edge.curve)).collect();
    let named = |name: &String| {
        let lines = mesh.boundary(name).unwrap_or_default().into_iter().map(|edge| drawn(&mesh.edges[edge].curve));
        (name.clone(), lines.collect())
    };
    BodyOutline { areas, borders, edges: mesh.boundaries.iter().map(named).collect() }
}

fn drawn(curve: &Curve) -> Vec<[f64; 2]> {
    let pieces = match curve {
        // As many for a turn as of a template's arc.
        Curve::Arc { from, to, .. } => ((to - from).abs() / std::f64::consts::TAU * (2 * PIECES) as f64).ceil().max(1.0) as usize,
        curve if curve.is_straight() => 1,
        _ => PIECES / 4,
    };
    (0..=pieces).map(|i| curve.point(2.0 * i as f64 / pieces as f64 - 1.0)).collect()
}

#[cfg(test)]
mod tests {
    use super::{beyond_the_axis, chained, circle, line};

    #[test]
    fn an_arc_passes_through_its_middle_point_and_a_ring_is_whole() {
        let top = line(&[[-1.0, 0.0], [0.0, 1.0], [1.0, 0.0]], false);
        assert!(top.iter().all(|p| p[1] > -1e-12 && (p[0].hypot(p[1]) - 1.0).abs() < 1e-12));
        let bottom = line(&[[-1.0, 0.0], [0.0, -1.0], [1.0, 0.0]], false);
        assert!(bottom.iter().all(|p| p[1] < 1e-12));
        let ring = line(&[[-1.0, 0.0], [0.0, 1.0], [1.0, 0.0]], true);
        assert!(ring.iter().any(|p| p[1] < -0.99) && ring.iter().any(|p| p[1] > 0.99));
        assert_eq!(circle([0.0, 0.0], [1.0, 1.0], [2.0, 2.0]), None);
    }

    #[test]
    fn lines_of_bodies_of_revolution_end_at_the_axis() {
        let ball = line(&[[-5.0, 5.0], [0.0, 0.0], [5.0, 5.0]], false);
        let parts = beyond_the_axis(&ball);
        let [arc] = parts.as_slice() else { panic!("{parts:?}") };
        assert!(arc.iter().all(|p| (p[0].hypot(p[1] - 5.0) - 5.0).abs() < 1e-12), "no part of it is the axis: {arc:?}");
        assert!(arc[0][0].abs() < 1e-12 && arc.last().is_some_and(|p| (p[0] - 5.0).abs() < 1e-12));
        assert_eq!(beyond_the_axis(&[[-1.0, 2.0], [3.0, 6.0], [-1.0, 10.0]]), [[[0.0, 3.0], [3.0, 6.0], [0.0, 9.0]]]);
        assert_eq!(beyond_the_axis(&[[0.0, 2.0], [0.0, 6.0]]), [[[0.0, 2.0], [0.0, 6.0]]]);
        assert!(beyond_the_axis(&[[-1.0, 2.0], [0.0, 6.0]]).is_empty());
    }

    #[test]
    fn lines_are_chained_whatever_their_order_and_direction() {
        let square = chained(vec![
            vec![[0.0, 0.0], [1.0, 0.0]],
            vec![[0.0, 0.0], [0.0, 1.0]],
            vec![[1.0, 1.0], [1.0, 0.0]],
            vec![[0.0, 1.0], [1.0, 1.0]],
        ]);
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [1.0, 1.0], [1.0, 1.0], [0.0, 1.0], [0.0, 1.0], [0.0, 0.0]];
        assert_eq!(square, corners);
    }
}
