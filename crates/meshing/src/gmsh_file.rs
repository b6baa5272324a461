//! `geometry.mesh`: a gmsh file beside the scene.

use hpfem::{Curve, Error, GmshError, GmshMesh, Mesh};
use scene::{Fault, Material, MeshFile, did_you_mean, sha256};

use crate::given::{Files, Given};
use crate::placing::Placing;

/// The cells of a mesh file in their place, and the physical group of each material index.
fn parse(bytes: &[u8], placing: Option<Placing>) -> Result<(Mesh, Vec<String>), GmshError> {
    let GmshMesh { mut mesh, materials } = GmshMesh::read(bytes)?;
    mesh.check_whole()?;
    if let Some(placing) = placing {
        placing.put(&mut mesh);
    }
    round(&mut mesh);
    Ok((mesh, materials))
}

/// Reads the file of `key`.geometry.mesh; from then on the scene names it as its copy in the output folder, `key`.msh. `own` is the material of
/// groups that have none.
pub(crate) fn read(key: &str, file: &mut MeshFile, files: Files<'_>, own: Option<Material>) -> Result<Given, Fault> {
    let at = format!("{key}.geometry.mesh.file");
    let name = file.file.clone();
    let bytes = files(&name).map_err(|error| {
        let message = format!("cannot read the mesh {name}: {error}");
        Fault::at(&at, "unreadable", message, "give the path of a gmsh file, relative to the scene")
    })?;
    let hash = sha256(&bytes);
    if let Some(wanted) = file.sha256.as_ref().filter(|wanted| **wanted != hash) {
        let message =
            format!("the mesh {name} is another one than the scene was written for: its SHA-256 is {hash}, not {wanted}");
        let remedy = "bring the old file back, or remove the key sha256";
        return Err(Fault::at(format!("{key}.geometry.mesh.sha256"), "changed-mesh", message, remedy));
    }
    let (mesh, groups) = parse(&bytes, Placing::of(file))
        .map_err(|error| Fault::at(&at, "wrong-mesh", format!("{name}: {}", sentence(&error)), remedy(&error)))?;
    if let Some(own) = mesh.boundaries.iter().find(|name| name.starts_with('@')) {
        let message = format!("{name}: the physical curve `{own}` begins with @");
        return Err(Fault::at(&at, "wrong-mesh", message, "give it a name without @"));
    }
    file.content = Some(bytes.into());
    file.file = format!("{key}.msh");
    file.sha256 = Some(hash);
    let materials = materials(&format!("{key}.geometry.mesh"), file, &groups, own)?;
    Ok(Given { mesh, materials })
}

/// What is wrong, with cells counted as the file has them.
fn sentence(error: &GmshError) -> String {
    match error {
        GmshError::Mesh(Error::TouchingApart { cell, other, x, z, .. }) => {
            let (cell, other) = (cell.min(other) + 1, cell.max(other) + 1);
            format!(
                "cells {cell} and {other} touch without sharing nodes at ({x}, {z}): the body would be solved as if cut there (cells counted from 1)"
            )
        }
        GmshError::Mesh(Error::Pieces { cell, x, z }) => {
            format!(
                "the body is in pieces: no shared edges join cell {} at ({x}, {z}) to cell 1 (cells counted from 1)",
                cell + 1
            )
        }
        GmshError::Mesh(Error::CellsOverlap { a, b, x, z }) => {
            format!("the middle of cell {} at ({x:.6}, {z:.6}) lies inside cell {} (cells counted from 1)", a + 1, b + 1)
        }
        GmshError::Mesh(Error::FoldedCell { cell, x, z, .. }) => {
            format!("cell {} is folded or has no area at ({x:.6}, {z:.6}) (cells counted from 1)", cell + 1)
        }
        other => other.to_string(),
    }
}

fn remedy(error: &GmshError) -> &'static str {
    match error {
        GmshError::ElementType { .. } => "save the plane mesh alone, of order 1 to 4: Mesh.SaveAll = 0",
        GmshError::NoCells => "put the surface into a physical group",
        GmshError::Version { .. } => "save as version 4.1: gmsh -format msh41",
        GmshError::NotPlane { .. } => "put the section into the x-y or the x-z plane",
        GmshError::LooseLine { .. } => "let physical curves follow sides of cells",
        GmshError::Mesh(Error::TouchingApart { .. }) => {
            "merge duplicate nodes (gmsh: Coherence Mesh), and let no node lie inside the side of another cell; a crack with closed faces cannot be told from that and is not known"
        }
        GmshError::Mesh(Error::Pieces { .. }) => "join the pieces along common nodes, or save the one body alone",
        GmshError::Overlapping { .. } | GmshError::Mesh(Error::CellsOverlap { .. }) => {
            "let each place lie in one cell: remove cells that are there twice, or the surface that lies on another one"
        }
        GmshError::Mesh(_) => "mend the mesh: gmsh's Tools, Statistics shows cells of low quality",
        _ => "write the file again with gmsh, as MSH 4.1 or 2.2",
    }
}

/// The material of each physical group of cells, at the dotted `key`.
fn materials(key: &str, file: &MeshFile, groups: &[String], own: Option<Material>) -> Result<Vec<Material>, Fault> {
    if let Some(unknown) = file.materials.keys().find(|name| !groups.contains(name)) {
        let known: Vec<&str> = groups.iter().map(String::as_str).filter(|name| !name.is_empty()).collect();
        let message = format!("the mesh has no physical surface `{unknown}`");
        return Err(Fault::at(format!("{key}.materials.{unknown}"), "unknown-group", message, did_you_mean(unknown, &known)));
    }
    let material = |group: &String| {
        file.materials.get(group).copied().or(own).ok_or_else(|| {
            let (what, remedy) = match group.as_str() {
                "" => ("cells of no physical surface".to_string(), "give the body a material for the rest".to_string()),
                name => {
                    (format!("the physical surface `{name}`"), format!("add {key}.materials.{name}, or a material of the body"))
                }
            };
            Fault::at(format!("{key}.materials"), "missing-key", format!("there is no material for {what}"), remedy)
        })
    };
    groups.iter().map(material).collect()
}

/// Boundaries whose nodes lie on one circle become arcs of it: gmsh puts the nodes of curved edges on the true curve, and the polynomial
/// between them is only near it.
fn round(mesh: &mut Mesh) {
    // Edges meant to be straight, up to the digits of the file.
    for edge in &mut mesh.edges {
        let bent = match &edge.curve {
            Curve::Polynomial { modes, .. } => modes.iter().flatten().any(|m| m.abs() > 1e-9 * edge.curve.length()),
            _ => true,
        };
        if !bent {
            edge.curve = Curve::Line { start: edge.curve.point(-1.0), end: edge.curve.point(1.0) };
        }
    }
    for name in mesh.boundaries.clone() {
        let edges = mesh.boundary(&name).unwrap_or_default();
        let curves: Vec<Curve> = edges.iter().map(|e| mesh.edges[*e].curve).collect();
        if let Some(arcs) = arcs(&curves) {
            edges.into_iter().zip(arcs).for_each(|(e, arc)| mesh.edges[e].curve = arc);
        }
    }
}

/// The arcs of one circle that pass through the nodes of polynomial curves, if there is one.
fn arcs(curves: &[Curve]) -> Option<Vec<Curve>> {
    let nodes: Vec<Vec<[f64; 2]>> = curves.iter().map(nodes).collect::<Option<_>>()?;
    let all: Vec<[f64; 2]> = nodes.iter().flatten().copied().collect();
    let (centre, radius) = circle(&all)?;
    let from_centre = |x: &[f64; 2]| (x[0] - centre[0]).hypot(x[1] - centre[1]);
    let size = curves.iter().map(Curve::length).sum::<f64>();
    if radius > 1e3 * size || all.iter().any(|x| (from_centre(x) - radius).abs() > 1e-9 * size) {
        return None;
    }
    let angle = |x: [f64; 2]| (x[1] - centre[1]).atan2(x[0] - centre[0]);
    let arc = |places: &Vec<[f64; 2]>| {
        let from = angle(places[0]);
        let turn = (angle(places[places.len() - 1]) - from + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU)
            - std::f64::consts::PI;
        Curve::Arc { centre, radius, from, to: from + turn }
    };
    Some(nodes.iter().map(arc).collect())
}

/// The equally spaced nodes of a polynomial edge, as many as its degree asks for.
fn nodes(curve: &Curve) -> Option<Vec<[f64; 2]>> {
    let Curve::Polynomial { modes, .. } = curve else { return None };
    let scale = 1e-12 * curve.length();
    let degree = modes.iter().rposition(|m| m[0].abs().max(m[1].abs()) > scale)? + 2;
    Some((0..=degree).map(|i| curve.point(2.0 * i as f64 / degree as f64 - 1.0)).collect())
}

/// Centre and radius of the circle nearest to points, by linear least squares on `x^2 + z^2 = 2 a x + 2 b z + c`.
pub(crate) fn circle(points: &[[f64; 2]]) -> Option<([f64; 2], f64)> {
    let count = points.len() as f64;
    let mean: [f64; 2] = std::array::from_fn(|i| points.iter().map(|x| x[i]).sum::<f64>() / count);
    let (mut normal, mut right) = (nalgebra::DMatrix::zeros(3, 3), nalgebra::DVector::zeros(3));
    let size = points.iter().map(|x| (x[0] - mean[0]).hypot(x[1] - mean[1])).fold(0.0, f64::max);
    for x in points {
        let row = nalgebra::DVector::from_row_slice(&[(x[0] - mean[0]) / size, (x[1] - mean[1]) / size, 1.0]);
        normal += &row * row.transpose();
        let square = row[0] * row[0] + row[1] * row[1];
        right += row * square;
    }
    let best = normal.lu().solve(&right)?;
    let (a, b) = (0.5 * best[0], 0.5 * best[1]);
    let square = best[2] + a * a + b * b;
    (square.is_finite() && square > 0.0).then(|| ([mean[0] + size * a, mean[1] + size * b], size * square.sqrt()))
}
