//! Sharp edges of a contact: exponents fitted to the pressure, and a note by their characteristic equation where no layers resolve it.

use contact::{ContactOperator, ContactSolution, Pair};
use hpfem::{Corner, SlidingEdge, sliding_edge};
use meshing::{CONTACT, Cut, RATIO};
use scene::Fault;

use crate::faults::wrong_friction;
use crate::level::Level;
use crate::parts::BodyParts;
use crate::remark::Remark;
use crate::stage::Stage;

/// Layers of the usual finest level.
const MOST: usize = 16;

/// A note on edges in contact that dig in, or whose innermost layer (of `layers`, or the usual most) still carries more than the accuracy asks
/// for: the energy there goes like its size to the power `2 lambda`.
pub(crate) fn note(stage: Stage<'_>, layers: usize, edges: &[Edge]) -> Option<Remark> {
    let friction = stage.friction();
    if friction == 0.0 {
        return None;
    }
    let mut said = Vec::new();
    for Edge { x, kind, .. } in edges.iter().filter(|edge| edge.drag != 0.0) {
        match kind {
            SlidingEdge::DigsIn => said.push(format!(
                "at x = {x:.6} mm friction {friction} is beyond what any pressure with a finite force allows: the sharp edge digs in"
            )),
            SlidingEdge::Singular { lambda } => {
                let rest = RATIO.powf(*lambda * layers.max(MOST) as f64);
                if rest * rest > stage.accuracy() {
                    said.push(format!(
                        "at x = {x:.6} mm the pressure grows like d^({:.3}): {:.1e} of what the edge carries is within the smallest element",
                        lambda - 1.0,
                        rest
                    ));
                }
            }
            SlidingEdge::Bounded => {}
        }
    }
    let message =
        format!("{}. Layers do not resolve that: round the edge off, or take less friction.", capital(&said.join("; ")));
    (!said.is_empty()).then_some(Remark { code: "edge-unresolved", message })
}

/// Exponents of a pressure below which it is taken for bounded: it is at most 2 % larger at a billionth of the distance.
const BOUNDED: f64 = 1e-3;

/// A note on edges in contact at which the pressure has no largest value although its layers show none of that: it grows too slowly.
pub(crate) fn unbounded(edges: &[Edge]) -> Option<Remark> {
    let slowly = |edge: &Edge| match edge.kind {
        SlidingEdge::Singular { lambda } if 1.0 - lambda > BOUNDED => {
            Some(format!("d^({:.3}) towards x = {:.6} mm", lambda - 1.0, edge.x))
        }
        SlidingEdge::Singular { .. } | SlidingEdge::Bounded | SlidingEdge::DigsIn => None,
    };
    let grows: Vec<String> = edges.iter().filter_map(slowly).collect();
    let message = format!(
        "The pressure has no largest value: it grows like {}, with the distance d. p_max_MPa is that of the last point, and larger on finer layers; a round \
         edge has one.",
        grows.join(" and like ")
    );
    (!grows.is_empty()).then_some(Remark { code: "edge-unbounded", message })
}

/// A sharp edge at an end of the surface.
pub(crate) struct Edge {
    /// Its place along x (mm).
    x: f64,
    /// Sense of the drag there along growing x.
    drag: f64,
    kind: SlidingEdge,
}

/// The edges at those ends of the surface, the first and the last, that are in contact (`closed`); none on the axis of revolution, or of bodies that face each other.
pub(crate) fn edges(stage: Stage<'_>, closed: [bool; 2]) -> Result<Vec<Edge>, Fault> {
    if stage.facing() || closed == [false; 2] {
        return Ok(Vec::new());
    }
    let level = Level { layers: 0, ..stage.problem.level(2) };
    let (parts, _) = stage.parts(level, Cut::Plain)?;
    let mut found = Vec::new();
    for (number, _) in closed.iter().enumerate().filter(|(_, closed)| **closed) {
        let (x, drag) = end(stage, &parts.parts[1], number);
        // The contact ray is the first face of the left wedge of body 1 and of the right one of body 2.
        let Some(wedges) = wedges(stage, [&parts.parts[0], &parts.parts[1]], number) else { continue };
        let into = if number == 0 { drag } else { -drag };
        let on_axis = stage.couple.kinematics.is_revolved() && x == 0.0;
        let kind = sliding_edge(&wedges[0], &wedges[1], into * stage.friction(), stage.couple.kinematics);
        let kind = kind.map_err(wrong_friction)?;
        found.extend((!on_axis).then_some(Edge { x, drag, kind }));
    }
    Ok(found)
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// The first or last vertex of a body's contact surface, by x.
fn end_vertex(body: &BodyParts, number: usize) -> Option<usize> {
    let edges = body.mesh().boundary(CONTACT).ok()?;
    let vertices = edges.into_iter().flat_map(|e| body.mesh().edges[e].vertices);
    let x = |v: &usize| body.mesh().vertices[*v][0];
    if number == 0 { vertices.min_by(|a, b| x(a).total_cmp(&x(b))) } else { vertices.max_by(|a, b| x(a).total_cmp(&x(b))) }
}

/// Place x of an end of the surface, and the sense of the drag there along growing x.
fn end(stage: Stage<'_>, counter: &BodyParts, number: usize) -> (f64, f64) {
    let Some(vertex) = end_vertex(counter, number) else { return (0.0, 0.0) };
    let x = counter.mesh().vertices[vertex];
    let surface = stage.surface_point(x, [0.0, 1.0], 0.0);
    (x[0], if surface.drag.x == 0.0 { 0.0 } else { surface.drag.x.signum() })
}

/// The wedges of both bodies at an end of the surface, from the contact outwards; the right end as its mirror image.
fn wedges(stage: Stage<'_>, bodies: [&BodyParts; 2], number: usize) -> Option<[Corner; 2]> {
    let mut found = Vec::new();
    for (body, parts) in bodies.into_iter().enumerate() {
        let vertex = end_vertex(parts, number)?;
        let corner = parts.corner(vertex, stage.couple.kinematics)?;
        let contact_first = (body == 0) == (number == 0);
        found.push(if contact_first { corner } else { corner.reversed() });
    }
    let found = <[Corner; 2]>::try_from(found).ok()?;
    Some(if number == 0 { found } else { found.map(Corner::mirrored) })
}

/// Exponents `l` of `p ~ d^l` at those ends of the surface that are in contact, from the pressure in the layers near them: the
/// slope of log p over log d between 20 and 1000 times the smallest edge. Empty where the pressure is bounded there.
pub(crate) fn exponents(pair: &Pair<'_>, operator: &ContactOperator<'_>, found: &ContactSolution) -> Vec<f64> {
    let trace = pair.trace();
    let length = trace.length();
    let slope = |from_start: bool| {
        let closed = if from_start { found.closed.first() } else { found.closed.last() };
        if !*closed? {
            return None;
        }
        let smallest = if from_start { trace.edges.first() } else { trace.edges.last() }?.curve.length();
        let range = [20.0 * smallest, (1000.0 * smallest).min(0.02 * length)];
        if range[1] <= 2.0 * range[0] {
            return None;
        }
        let count = 41;
        let (mut x, mut y) = (Vec::new(), Vec::new());
        for i in 0..count {
            let d = range[0] * (range[1] / range[0]).powf(f64::from(i) / f64::from(count - 1));
            let arc = if from_start { d } else { length - d };
            x.push(d.ln());
            y.push(operator.pressure_at(&found.pressure, arc).ln());
        }
        let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
        let (mx, my) = (mean(&x), mean(&y));
        let top: f64 = x.iter().zip(&y).map(|(a, b)| (a - mx) * (b - my)).sum();
        let bottom: f64 = x.iter().map(|a| (a - mx).powi(2)).sum();
        Some(top / bottom)
    };
    let both: Vec<f64> = [slope(true), slope(false)].into_iter().flatten().filter(|l| l.is_finite()).collect();
    if both.iter().any(|l| *l < -0.02) { both } else { Vec::new() }
}
