//! Structured meshes of the region between two curves.

use crate::curve::Curve;
use crate::error::Error;
use crate::mesh::{Mesh, Quad};
use std::cmp::Ordering;
use std::f64::consts::TAU;

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
    /// Ascending parameters in `[-1, 1]` where the curves are cut, both ends included; at least four of a closed region.
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
    /// [`Error::OutOfRange`] for breaks or levels that do not rise from end to end (-1 to 1, 0 to 1, up to 1e-12), for fewer than two of
    /// them (four breaks of a closed region, whose columns must differ in their vertices), and for a ruling or an end of a range that
    /// is none of them, for arcs beyond a full turn; those of [`Mesh::new`], [`Error::CellsOverlap`] for curves that go around more than once.
    pub fn ruled(region: &Ruled<'_>) -> Result<Mesh, Error> {
        let (breaks, levels) = (region.breaks, region.levels);
        check_rising("breaks", breaks, [-1.0, 1.0], if region.closed { 4 } else { 2 })?;
        check_rising("levels", levels, [0.0, 1.0], 2)?;
        check_turn(&[region.bottom, region.top])?;
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
                if let Some(curve) = level_curve(region, j) {
                    curves.push(([vertex(i, j), vertex(i + 1, j)], curve.part(breaks[i], breaks[i + 1])));
                }
                if j + 1 < levels.len() {
                    let corners = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
                    quads.push(Quad { corners, material: region.material, layer: 0 });
                }
            }
        }
        let mut names = Vec::new();
        for named in region.names {
            names.extend(named_edges(region, named, &vertex)?.into_iter().map(|edge| (edge, named.name)));
        }
        let mesh = Mesh::joined(vertices, &quads, &curves, &names)?;
        mesh.check_cells()?;
        // Columns between lines and arcs of a turn at most lie beside each other; others may go around more than once.
        if [region.bottom, region.top].iter().any(|curve| matches!(curve, Curve::Polynomial { .. })) {
            mesh.check_overlap()?;
        }
        Ok(mesh)
    }

    /// The vertex nearest to a point.
    pub fn nearest_vertex(&self, x: [f64; 2]) -> usize {
        let distance = |v: &[f64; 2]| (v[0] - x[0]).hypot(v[1] - x[1]);
        (0..self.vertices.len()).min_by(|a, b| distance(&self.vertices[*a]).total_cmp(&distance(&self.vertices[*b]))).unwrap_or(0)
    }
}

/// How far a parameter may be from the break it stands for.
const SAME: f64 = 1e-12;

/// Refuses numbers that do not rise from the first end to the last, or are too few.
fn check_rising(what: &str, values: &[f64], [first, last]: [f64; 2], fewest: usize) -> Result<(), Error> {
    if values.len() < fewest {
        let quantity = format!("the number of {what} of a ruled region");
        let range = if fewest > 2 { "at least 4 for a closed one" } else { "at least 2" };
        return Err(Error::OutOfRange { quantity, value: values.len() as f64, range });
    }
    let ends = [(0, first), (values.len() - 1, last)];
    if let Some((i, _)) = ends.into_iter().find(|(i, end)| values[*i].is_nan() || (values[*i] - end).abs() > SAME) {
        let quantity = format!("number {i} of the {what} of a ruled region");
        let range = match (i, what) {
            (0, "breaks") => "-1, the start of the curves",
            (0, _) => "0, the bottom",
            _ => "1, the end",
        };
        return Err(Error::OutOfRange { quantity, value: values[i], range });
    }
    match values.windows(2).position(|w| w[0].partial_cmp(&w[1]) != Some(Ordering::Less)) {
        Some(i) => {
            let quantity = format!("number {} of the {what} of a ruled region", i + 1);
            Err(Error::OutOfRange { quantity, value: values[i + 1], range: "larger than the one before it" })
        }
        None => Ok(()),
    }
}

/// Refuses arcs beyond a full turn, whose columns would lie on each other.
fn check_turn(curves: &[Curve]) -> Result<(), Error> {
    for curve in curves {
        if let Curve::Arc { from, to, .. } = curve
            && (to - from).abs() > TAU * (1.0 + SAME)
        {
            let quantity = "the angle of an arc of a ruled region".into();
            return Err(Error::OutOfRange { quantity, value: to - from, range: "at most a full turn" });
        }
    }
    Ok(())
}

/// The edges that a name stands for.
fn named_edges(region: &Ruled<'_>, named: &Named<'_>, vertex: &dyn Fn(usize, usize) -> usize) -> Result<Vec<[usize; 2]>, Error> {
    let (breaks, levels) = (region.breaks, region.levels);
    let find = |values: &[f64], t: f64, quantity: String, range: &'static str| {
        let found = values.iter().position(|b| (b - t).abs() < SAME);
        found.ok_or(Error::OutOfRange { quantity, value: t, range })
    };
    let along = |values: &[f64], range: &'static str| match named.range {
        None => Ok(0..values.len() - 1),
        Some(ends) => {
            let [from, to] = ends.map(|t| find(values, t, format!("an end of the range of \"{}\"", named.name), range));
            let (from, to) = (from?, to?);
            let quantity = || format!("the end of the range of \"{}\"", named.name);
            if from >= to {
                return Err(Error::OutOfRange { quantity: quantity(), value: ends[1], range: "larger than its start" });
            }
            Ok(from..to)
        }
    };
    let row = |j: usize| Ok(along(breaks, "one of the breaks")?.map(|i| [vertex(i, j), vertex(i + 1, j)]).collect());
    let column = |i: usize| Ok(along(levels, "one of the levels")?.map(|j| [vertex(i, j), vertex(i, j + 1)]).collect());
    match named.side {
        Side::Bottom => row(0),
        Side::Top => row(levels.len() - 1),
        Side::Left => column(0),
        Side::Right => column(breaks.len() - 1),
        Side::Ruling(t) => {
            column(find(breaks, t, format!("the parameter of the ruling \"{}\"", named.name), "one of the breaks")?)
        }
    }
}

/// The curve of a level, if it is not straight between its vertices.
fn level_curve(region: &Ruled<'_>, j: usize) -> Option<Curve> {
    match j {
        0 => Some(region.bottom),
        _ if j + 1 == region.levels.len() => Some(region.top),
        _ => between(&region.bottom, &region.top, region.levels[j]),
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
        (Curve::Line { .. } | Curve::Arc { .. } | Curve::Polynomial { .. }, _) => None,
    }
}
