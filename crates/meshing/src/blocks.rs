//! `geometry.blocks`: from names to cells, and what can be wrong with them.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::f64::consts::{PI, TAU};

use hpfem::{Curve, Error, Mesh, Quad};
use scene::{ArcShape, Blocks, CellShape, CurveShape, Fault, Material, SplineShape, did_you_mean};

use crate::given::Given;

/// A curve between two numbered points.
struct Joined {
    ends: [usize; 2],
    curve: Curve,
}

/// The points in use, the curves by name, and the scene's key of the blocks.
struct Named<'a> {
    key: &'a str,
    points: Vec<[f64; 2]>,
    names: Vec<&'a str>,
    curves: BTreeMap<&'a str, Joined>,
}

/// Cells of the blocks at the dotted `key`; `own` is the material of cells that name none.
pub(crate) fn given(key: &str, blocks: &Blocks, own: Option<Material>) -> Result<Given, Fault> {
    let named = Named::new(key, blocks)?;
    let mut quads = Vec::new();
    let mut corners_of: HashMap<[usize; 4], &str> = HashMap::new();
    let known: Vec<&str> = blocks.materials.keys().map(String::as_str).collect();
    for (name, cell) in &blocks.cells {
        let corners = named.corners(name, cell)?;
        let mut set = corners;
        set.sort_unstable();
        if let Some(other) = corners_of.insert(set, name) {
            let message = format!("the cells `{other}` and `{name}` are the same");
            return Err(Fault::at(format!("{key}.cells.{name}"), "duplicate-cell", message, "remove one of them"));
        }
        let material = match &cell.material {
            Some(material) => known.binary_search(&material.as_str()).map_err(|_| {
                let message = format!("there is no material `{material}` in {key}.materials");
                let remedy = match known.is_empty() {
                    true => format!("describe it: {key}.materials.{material} = {{ young = \"1 GPa\", poisson = 0.3 }}"),
                    false => did_you_mean(material, &known),
                };
                Fault::at(format!("{key}.cells.{name}.material"), "unknown-material", message, remedy)
            })?,
            None => blocks.materials.len(),
        };
        quads.push(Quad { corners, material, layer: 0 });
    }
    if quads.is_empty() {
        let remedy = "write cells.one = { curves = [\"below\", \"right\", \"above\", \"left\"] }";
        return Err(Fault::at(format!("{key}.cells"), "no-cells", "the body has no cells", remedy));
    }
    let sides: HashSet<[usize; 2]> =
        quads.iter().flat_map(|q| (0..4).map(|i| sorted([q.corners[i], q.corners[(i + 1) % 4]]))).collect();
    let edges = named.edges(blocks, &sides)?;
    let mesh = named.mesh(blocks, &quads, &sides, &edges)?;
    named.connected(&mesh, blocks)?;
    Ok(Given { mesh, materials: blocks.materials.values().copied().chain(own).collect() })
}

/// Points, curves and materials that no cell uses, as keys below the blocks.
pub fn unused(blocks: &Blocks) -> Vec<String> {
    let sides: HashSet<&String> = blocks.cells.values().flat_map(|cell| &cell.curves).collect();
    let (used, idle): (Vec<_>, Vec<_>) = blocks.curves.iter().partition(|(name, _)| sides.contains(name));
    let ends: HashSet<&String> = used.iter().flat_map(|(_, shape)| ends(shape)).collect();
    let points = blocks.points.keys().filter(|name| !ends.contains(name)).map(|name| format!("points.{name}"));
    let curves = idle.into_iter().map(|(name, _)| format!("curves.{name}"));
    let named: HashSet<&String> = blocks.cells.values().filter_map(|cell| cell.material.as_ref()).collect();
    let materials = blocks.materials.keys().filter(|name| !named.contains(name)).map(|name| format!("materials.{name}"));
    points.chain(curves).chain(materials).collect()
}

/// First and last point of a curve.
fn ends(shape: &CurveShape) -> &[String; 2] {
    match shape {
        CurveShape::Line(ends) => ends,
        CurveShape::Arc(ArcShape { ends, .. }) => ends,
        CurveShape::Spline(SplineShape { ends, .. }) => ends,
    }
}

impl<'a> Named<'a> {
    fn new(key: &'a str, blocks: &'a Blocks) -> Result<Named<'a>, Fault> {
        let names: Vec<&str> = blocks.points.keys().map(String::as_str).collect();
        let points: Vec<[f64; 2]> = blocks.points.values().map(|p| p.position()).collect();
        if let Some([j, i]) = same_place(&points) {
            let message = format!("the points `{}` and `{}` are at the same place", names[j], names[i]);
            return Err(Fault::at(format!("{key}.points.{}", names[i]), "duplicate-point", message, "use one of them"));
        }
        let mut joining: HashMap<[usize; 2], &str> = HashMap::new();
        let mut named = Named { key, points, names, curves: BTreeMap::new() };
        for (name, shape) in &blocks.curves {
            let joined = named.curve(name, shape)?;
            if let Some(twin) = joining.insert(sorted(joined.ends), name) {
                let message = format!("the curves `{twin}` and `{name}` join the same two points");
                let remedy = "use one curve in both cells, or put a point between";
                return Err(Fault::at(format!("{key}.curves.{name}"), "duplicate-curve", message, remedy));
            }
            named.curves.insert(name, joined);
        }
        Ok(named)
    }

    fn curve(&self, name: &str, shape: &CurveShape) -> Result<Joined, Fault> {
        let at = |part: &str| format!("{}.curves.{name}.{part}", self.key);
        let part = match shape {
            CurveShape::Line(_) => "line",
            CurveShape::Arc(_) => "arc.ends",
            CurveShape::Spline(_) => "spline.ends",
        };
        let ends = ends(shape);
        let mut numbers = [0; 2];
        for (number, end) in numbers.iter_mut().zip(ends) {
            *number = self.names.binary_search(&end.as_str()).map_err(|_| {
                let message = format!("the curve `{name}` ends at the point `{end}`, which does not exist");
                Fault::at(at(part), "unknown-point", message, did_you_mean(end, &self.names))
            })?;
        }
        let degenerate = |message: String, remedy: &str| Err(Fault::at(at(part), "degenerate", message, remedy));
        let [a, b] = numbers.map(|number| self.points[number]);
        if numbers[0] == numbers[1] {
            return degenerate(format!("the curve `{name}` ends where it begins"), "cut a closed curve at two points or more");
        }
        let curve = match shape {
            CurveShape::Line(_) => Curve::Line { start: a, end: b },
            CurveShape::Spline(SplineShape { through, .. }) if through.is_empty() || through.len() > 7 => {
                let message = format!("the curve `{name}` passes through {} places between its ends", through.len());
                return degenerate(message, "give 1 to 7 places; cut a longer curve at a point, or write a line");
            }
            CurveShape::Spline(SplineShape { through, .. }) => {
                let inner = through.iter().map(|x| x.map(|x| x.0));
                smooth(&[a].into_iter().chain(inner).chain([b]).collect::<Vec<_>>())
            }
            CurveShape::Arc(ArcShape { centre, .. }) => {
                let centre = centre.map_or([0.0; 2], |c| c.map(|c| c.0));
                let radii = [distance(a, centre), distance(b, centre)];
                if (radii[0] - radii[1]).abs() > 1e-9 * radii[0] {
                    let message = format!("the ends of the arc `{name}` are {} and {} from its centre", radii[0], radii[1]);
                    return degenerate(message, "write its points by radius and angle: { radius = 200, angle = \"30 deg\" }");
                }
                let [from, to] = [a, b].map(|x| (x[1] - centre[1]).atan2(x[0] - centre[0]));
                let turn = (to - from + PI).rem_euclid(TAU) - PI;
                if turn.abs() > PI - 1e-9 {
                    let message = format!("the arc `{name}` is half a circle, which could be either half");
                    return degenerate(message, "cut it into two arcs");
                }
                Curve::Arc { centre, radius: 0.5 * (radii[0] + radii[1]), from, to: from + turn }
            }
        };
        Ok(Joined { ends: numbers, curve })
    }

    /// The corners of a cell, anti-clockwise.
    fn corners(&self, name: &str, cell: &CellShape) -> Result<[usize; 4], Fault> {
        let at = format!("{}.cells.{name}.curves", self.key);
        let mut sides = Vec::new();
        for curve in &cell.curves {
            let joined = self.curves.get(curve.as_str()).ok_or_else(|| {
                let known: Vec<&str> = self.curves.keys().copied().collect();
                let message = format!("the cell `{name}` names the curve `{curve}`, which does not exist");
                Fault::at(&at, "unknown-curve", message, did_you_mean(curve, &known))
            })?;
            sides.push(joined);
        }
        let mut corners = [0; 4];
        for i in 0..4 {
            let (one, next) = (sides[i], sides[(i + 1) % 4]);
            let common = one.ends.iter().find(|end| next.ends.contains(end)).filter(|_| one.ends != next.ends);
            corners[i] = *common.ok_or_else(|| {
                let message = format!(
                    "the curves of the cell `{name}` do not close: `{}` and `{}` have no common end",
                    cell.curves[i],
                    cell.curves[(i + 1) % 4]
                );
                Fault::at(&at, "open-cell", message, "name the four curves in their order around the cell")
            })?;
        }
        if (0..4).any(|i| corners[i] == corners[(i + 1) % 4]) {
            let message = format!("the curves of the cell `{name}` do not go round it: they meet at fewer than four points");
            return Err(Fault::at(&at, "open-cell", message, "name the four curves in their order around the cell"));
        }
        // Corner i lies between the sides i and i + 1: side i + 1 runs from corner i to corner i + 1. Twice the area by its sign.
        let mut area = 0.0;
        for i in 0..4 {
            let side = sides[(i + 1) % 4];
            let curve = if side.ends[0] == corners[i] { side.curve } else { side.curve.reversed() };
            let places = (0..=16).map(|k| curve.point(f64::from(k) / 8.0 - 1.0)).collect::<Vec<_>>();
            area += places.windows(2).map(|p| p[0][0] * p[1][1] - p[1][0] * p[0][1]).sum::<f64>();
        }
        if area < 0.0 {
            corners.reverse();
        }
        Ok(corners)
    }

    /// Named edges as pairs of points.
    fn edges(&self, blocks: &'a Blocks, sides: &HashSet<[usize; 2]>) -> Result<Vec<([usize; 2], &'a str)>, Fault> {
        let mut edges = Vec::new();
        for (name, curves) in &blocks.edges {
            let at = format!("{}.edges.{name}", self.key);
            if name.starts_with('@') || curves.is_empty() {
                let message = format!("the edge `{name}` {}", if curves.is_empty() { "has no curves" } else { "begins with @" });
                return Err(Fault::at(at, "wrong-value", message, "write edges.top = [\"name of a curve\"]"));
            }
            for curve in curves {
                let Some(joined) = self.curves.get(curve.as_str()) else {
                    let known: Vec<&str> = self.curves.keys().copied().collect();
                    let message = format!("the edge `{name}` names the curve `{curve}`, which does not exist");
                    return Err(Fault::at(at, "unknown-curve", message, did_you_mean(curve, &known)));
                };
                if !sides.contains(&sorted(joined.ends)) {
                    let message = format!("the edge `{name}` names the curve `{curve}`, which is not a side of any cell");
                    return Err(Fault::at(at, "not-on-boundary", message, "name curves of the boundary"));
                }
                edges.push((joined.ends, name.as_str()));
            }
        }
        Ok(edges)
    }

    /// The mesh of the points that cells use.
    fn mesh(
        &self,
        blocks: &Blocks,
        quads: &[Quad],
        sides: &HashSet<[usize; 2]>,
        edges: &[([usize; 2], &str)],
    ) -> Result<Mesh, Fault> {
        let mut used: Vec<usize> = quads.iter().flat_map(|q| q.corners).collect();
        used.sort_unstable();
        used.dedup();
        let number = |point: usize| used.binary_search(&point).unwrap_or(0);
        let vertices = used.iter().map(|p| self.points[*p]).collect();
        let cells: Vec<Quad> = quads.iter().map(|q| Quad { corners: q.corners.map(number), ..*q }).collect();
        let curves: Vec<([usize; 2], Curve)> = self
            .curves
            .values()
            .filter(|joined| sides.contains(&sorted(joined.ends)))
            .map(|joined| (joined.ends.map(number), joined.curve))
            .collect();
        let names: Vec<([usize; 2], &str)> = edges.iter().map(|(ends, name)| (ends.map(number), *name)).collect();
        Mesh::new(vertices, &cells, &curves, &names).map_err(|error| {
            let cell = |i: usize| blocks.cells.keys().nth(i).map_or("", String::as_str);
            let point = |i: usize| self.names[used[i]];
            match error {
                Error::FoldedCell { cell: i, x, z, .. } => {
                    let message = format!("the cell `{}` is folded or degenerate at x = {x:.6}, z = {z:.6}", cell(i));
                    let remedy = "let every angle of a cell be below 180 degrees, and no side cross another";
                    Fault::at(format!("{}.cells.{}", self.key, cell(i)), "folded-cell", message, remedy)
                }
                Error::Overlapping { a, b } => {
                    let message =
                        format!("two cells lie on the same side of the curve between `{}` and `{}`", point(a), point(b));
                    Fault::at(
                        format!("{}.cells", self.key),
                        "overlapping-cells",
                        message,
                        "let cells touch along whole curves only",
                    )
                }
                other => Fault::at(self.key, "degenerate", other.to_string(), "mend the points and curves of this body"),
            }
        })
    }

    /// Refuses cells that touch nothing, and points that lie on a side without cutting it.
    fn connected(&self, mesh: &Mesh, blocks: &Blocks) -> Result<(), Fault> {
        let names: Vec<&str> = blocks.cells.keys().map(String::as_str).collect();
        let of_vertex = |v: usize| {
            let x = mesh.vertices[v];
            self.points.iter().position(|p| *p == x).map_or("", |i| self.names[i])
        };
        mesh.check_whole().map_err(|error| match error {
            Error::TouchingApart { vertex, cell, .. } => {
                let (point, cell) = (of_vertex(vertex), names[cell]);
                let message = format!("the point `{point}` lies on a side of the cell `{cell}` without being its corner");
                let remedy = "cut that cell there, so that cells touch along whole curves only";
                Fault::at(format!("{}.cells.{cell}", self.key), "hanging-point", message, remedy)
            }
            Error::Pieces { cell, .. } => {
                let message = format!("the cells `{}` and `{}` belong to two pieces that share no curve", names[0], names[cell]);
                let remedy = "join all cells of a body by common curves";
                Fault::at(format!("{}.cells.{}", self.key, names[cell]), "loose-cell", message, remedy)
            }
            other => Fault::at(self.key, "degenerate", other.to_string(), "mend the points and curves of this body"),
        })
    }
}

/// The first point, in their order, that lies where an earlier one does, after the first of these.
fn same_place(points: &[[f64; 2]]) -> Option<[usize; 2]> {
    let size = points.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
    let near = 1e-9 * size;
    // Squares twice as wide: what is near lies in the same one or next to it.
    let mut squares: HashMap<[i64; 2], Vec<usize>> = HashMap::new();
    for (i, p) in points.iter().enumerate() {
        let [x, z] = p.map(|x| (x / (2.0 * near)).floor() as i64);
        let around = (-1..=1).flat_map(|k| (-1..=1).map(move |l| [x.saturating_add(k), z.saturating_add(l)]));
        let others = around.filter_map(|square| squares.get(&square)).flatten();
        if let Some(j) = others.copied().filter(|j| distance(points[*j], *p) <= near).min() {
            return Some([j, i]);
        }
        squares.entry([x, z]).or_default().push(i);
    }
    None
}

/// The two ends of a curve, the lower number first.
fn sorted([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The polynomial through places whose parameters grow with the chords between them.
fn smooth(places: &[[f64; 2]]) -> Curve {
    let mut parameters = vec![0.0];
    for pair in places.windows(2) {
        parameters.push(parameters[parameters.len() - 1] + distance(pair[0], pair[1]));
    }
    let total = parameters[parameters.len() - 1];
    let parameters: Vec<f64> = parameters.iter().map(|t| 2.0 * t / total - 1.0).collect();
    let weights = hpfem::barycentric_weights(&parameters);
    Curve::interpolated(places.len() - 1, |t| {
        let shapes = hpfem::lagrange(&parameters, &weights, t);
        std::array::from_fn(|i| shapes.iter().zip(places).map(|(l, x)| l * x[i]).sum())
    })
}
