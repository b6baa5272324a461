//! Tractions by edge: on whole edges, or on a part of one between two arc lengths.

use crate::additions::SegmentTraction;
use crate::boundary::path;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::problem::{BoundaryTraction, LoadCase};

/// A traction on an edge, or on a part of it.
pub(crate) struct EdgeLoad<'a> {
    /// The cell that takes it.
    pub(crate) owner: usize,
    /// Column of the load case.
    pub(crate) case: usize,
    /// The traction, MPa.
    pub(crate) traction: &'a BoundaryTraction<'a>,
    /// Part of the edge in its own parameter.
    pub(crate) part: [f64; 2],
}

/// The loads of every edge.
pub(crate) fn edge_loads<'b>(
    mesh: &Mesh,
    cases: &'b [LoadCase<'_>],
    segments: &'b [SegmentTraction<'_>],
) -> Result<Vec<Vec<EdgeLoad<'b>>>, Error> {
    let neighbours = mesh.edge_cells();
    let mut loads: Vec<Vec<EdgeLoad<'b>>> = mesh.edges.iter().map(|_| Vec::new()).collect();
    for (case, tractions) in cases.iter().enumerate() {
        for load in tractions {
            for e in mesh.boundary(&load.boundary)? {
                loads[e].push(EdgeLoad { owner: neighbours[e][0].0, case, traction: &load.traction, part: [-1.0, 1.0] });
            }
        }
    }
    for segment in segments {
        let mut start = 0.0;
        for (e, against) in path(mesh, &segment.boundary)? {
            let own = mesh.edges[e].curve;
            let curve = if against { own.reversed() } else { own };
            let length = curve.length();
            let [a, b] = segment.range.map(|s| curve.parameter_at_length((s - start).clamp(0.0, length)));
            if b > a {
                let part = if against { [-b, -a] } else { [a, b] };
                loads[e].push(EdgeLoad { owner: neighbours[e][0].0, case: segment.case, traction: &segment.traction, part });
            }
            start += length;
        }
    }
    Ok(loads)
}
