//! Structured meshes of the region between two curves.

use crate::curve::Curve;
use crate::error::Error;
use crate::mesh::{Mesh, Quad};

/// A side of a ruled region.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Side {
    /// The bottom curve.
    Bottom,
    /// The line between the ends of the curves.
    Right,
    /// The top curve.
    Top,
    /// The line between the starts of the curves.
    Left,
    /// The ruling inside at the given parameter, which must be one of the breaks.
    Ruling(f64),
}

/// A name for a side or for the part of a side between two parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Named<'a> {
    /// The side.
    pub side: Side,
    /// Part of the side, in the parameter of `breaks` (bottom, top) or `levels` (left, right); its ends must be breaks.
    pub range: Option<[f64; 2]>,
    /// The name.
    pub name: &'a str,
}

/// The region swept by straight rulings from `bottom(t)` to `top(t)`; the top lies on the left of the walk along the bottom.
#[derive(Clone, Debug, PartialEq)]
pub struct Ruled<'a> {
    /// Curve of level 0.
    pub bottom: Curve,
    /// Curve of level 1.
    pub top: Curve,
    /// Ascending parameters in `[-1, 1]` where the curves are cut, both ends included.
    pub breaks: &'a [f64],
    /// Ascending levels from 0 to 1.
    pub levels: &'a [f64],
    /// Whether the end of each curve is its start (a full ring).
    pub closed: bool,
    /// Material index of the cells.
    pub material: usize,
    /// Names of boundary parts.
    pub names: &'a [Named<'a>],
}

impl Mesh {
    /// The structured mesh of a ruled region. Levels between two concentric arcs of the same angles are arcs, others lines.
    ///
    /// # Errors
    /// [`Error::FoldedCell`].
    pub fn ruled(region: &Ruled<'_>) -> Result<Mesh, Error> {
        let (breaks, levels) = (region.breaks, region.levels);
        let columns = if region.closed { breaks.len() - 1 } else { breaks.len() };
        let vertex = |i: usize, j: usize| j * columns + i % columns;
        let mut vertices = Vec::new();
        for level in levels {
            for t in &breaks[..columns] {
                let (a, b) = (region.bottom.point(*t), region.top.point(*t));
                vertices.push([(1.0 - level) * a[0] + level * b[0], (1.0 - level) * a[1] + level * b[1]]);
            }
        }
        let mut quads = Vec::new();
        let mut curves = Vec::new();
        for j in 0..levels.len() {
            for i in 0..breaks.len() - 1 {
                if let Some(curve) = level_curve(region, levels[j]) {
                    curves.push(([vertex(i, j), vertex(i + 1, j)], curve.part(breaks[i], breaks[i + 1])));
                }
                if j + 1 < levels.len() {
                    let corners = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
                    quads.push(Quad { corners, material: region.material, layer: 0 });
                }
            }
        }
        let mut names = Vec::new();
        let last = (breaks.len() - 1, levels.len() - 1);
        for named in region.names {
            let along = |values: &[f64], edge: &dyn Fn(usize) -> [usize; 2]| {
                let [from, to] = named.range.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
                (0..values.len() - 1)
                    .filter(|i| (from..to).contains(&(0.5 * (values[*i] + values[*i + 1]))))
                    .map(|i| (edge(i), named.name))
                    .collect::<Vec<_>>()
            };
            names.extend(match named.side {
                Side::Bottom => along(breaks, &|i| [vertex(i, 0), vertex(i + 1, 0)]),
                Side::Top => along(breaks, &|i| [vertex(i, last.1), vertex(i + 1, last.1)]),
                Side::Left => along(levels, &|j| [vertex(0, j), vertex(0, j + 1)]),
                Side::Right => along(levels, &|j| [vertex(last.0, j), vertex(last.0, j + 1)]),
                Side::Ruling(t) => match breaks.iter().position(|b| (b - t).abs() < 1e-12) {
                    Some(i) => along(levels, &|j| [vertex(i, j), vertex(i, j + 1)]),
                    None => Vec::new(),
                },
            });
        }
        Mesh::new(vertices, &quads, &curves, &names)
    }

    /// The vertex nearest to a point.
    pub fn nearest_vertex(&self, x: [f64; 2]) -> usize {
        let distance = |v: &[f64; 2]| (v[0] - x[0]).hypot(v[1] - x[1]);
        (0..self.vertices.len()).min_by(|a, b| distance(&self.vertices[*a]).total_cmp(&distance(&self.vertices[*b]))).unwrap_or(0)
    }
}

/// The curve of a level, if it is not straight between its vertices.
fn level_curve(region: &Ruled<'_>, level: f64) -> Option<Curve> {
    match level {
        0.0 => Some(region.bottom),
        1.0 => Some(region.top),
        _ => between(&region.bottom, &region.top, level),
    }
}

/// The arc at a level between two concentric arcs of the same angles.
pub(crate) fn between(bottom: &Curve, top: &Curve, level: f64) -> Option<Curve> {
    match (*bottom, *top) {
        (Curve::Arc { centre, radius, from, to }, Curve::Arc { centre: c, radius: r, from: f, to: t })
            if centre == c && from == f && to == t =>
        {
            Some(Curve::Arc { centre, radius: (1.0 - level) * radius + level * r, from, to })
        }
        _ => None,
    }
}
