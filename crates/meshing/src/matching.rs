//! Common break points of two bodies of which at least one is given by its cells.

use hpfem::Mesh;
use scene::Fault;

use crate::cells::{Cells, add_singular, crowded};
use crate::coarse::Coarse;
use crate::couple::Couple;
use crate::extent::{Cut, Extent};
use crate::template::{coarse, contact_cuts};

/// Most rounds until the break points settle: a cut may come back to the contact elsewhere and ask for another.
const ROUNDS: usize = 20;

/// The coarse meshes of both bodies: cut at the break points of both on the contact surface, graded towards the same points there.
pub(crate) fn matched(couple: &Couple, given: [Option<Mesh>; 2], extent: Extent, cut: Cut<'_>) -> Result<[Coarse; 2], Fault> {
    let mut cells: Vec<Option<Cells>> = Vec::new();
    for (number, given) in given.into_iter().enumerate() {
        cells.push(given.map(|mesh| Cells::new(couple, number, mesh, extent)).transpose()?);
    }
    let [from, to] = extent.ends();
    let ends: Vec<f64> = cut.ends().iter().map(|t| from + 0.5 * (1.0 + t) * (to - from)).collect();
    cells.iter_mut().flatten().for_each(|cells| ends.iter().for_each(|end| cells.draw(*end)));
    if cut == Cut::Shifted {
        cells.iter_mut().flatten().try_for_each(Cells::halve)?;
    }
    // Cuts that keep two points to grade towards apart in a template.
    let mut apart: Vec<f64> = Vec::new();
    for _ in 0..ROUNDS {
        let breaks: Vec<f64> = cells.iter().flatten().flat_map(Cells::breaks).chain(apart.iter().copied()).collect();
        let cuts = contact_cuts(couple, extent, cut, &breaks);
        cells.iter_mut().flatten().try_for_each(|cells| cells.cut(&cuts))?;
        let near = 1e-10 * (cuts[cuts.len() - 1] - cuts[0]);
        let known = |place: &f64| cuts.iter().any(|c| (c - place).abs() <= near);
        if !cells.iter().flatten().all(|cells| cells.breaks().iter().all(known)) {
            continue;
        }
        let mut meshes: Vec<Coarse> = Vec::new();
        for (number, cells) in cells.iter().enumerate() {
            meshes.push(match cells {
                Some(cells) => {
                    let free = ends.iter().filter_map(|end| cells.point_at(*end)).collect();
                    Coarse { mesh: cells.mesh.clone(), singular: cells.singular.clone(), free }
                }
                None => coarse(couple, number, &cuts, cut)?,
            });
        }
        let both: Vec<[f64; 2]> = meshes.iter().flat_map(|coarse| coarse.singular.iter().copied()).collect();
        let touching = |x: &&[f64; 2]| cells.iter().flatten().any(|cells| cells.coordinate(**x).is_some());
        for (x, coarse) in both.iter().filter(touching).flat_map(|x| (0..2).map(move |number| (x, number))) {
            let Coarse { mesh, singular, .. } = &mut meshes[coarse];
            add_singular(mesh, singular, *x);
        }
        // A template that faces the cells lies on the same surface.
        if let Some(free) = meshes.iter().map(|coarse| coarse.free.clone()).find(|free| free.len() == ends.len()) {
            meshes.iter_mut().filter(|coarse| coarse.free.len() != ends.len()).for_each(|coarse| coarse.free.clone_from(&free));
        }
        let mut again = false;
        for (number, coarse) in meshes.iter().enumerate() {
            let graded: Vec<[f64; 2]> = coarse.singular.iter().chain(&coarse.free).copied().collect();
            let Some((cell, corners)) = crowded(&coarse.mesh, &graded) else { continue };
            again = true;
            if let Some(cells) = &mut cells[number] {
                coarse.singular.iter().for_each(|x| cells.grade_towards(*x));
                cells.part(cell, corners)?;
                continue;
            }
            let corner = |k: usize| coarse.mesh.vertices[coarse.mesh.cells[cell].corners[k]];
            let place = |k: usize| cells.iter().flatten().find_map(|cells| cells.coordinate(corner(k)));
            let [Some(a), Some(b)] = corners.map(place) else { return Err(unmatched()) };
            apart.push(0.5 * (a + b));
        }
        if !again {
            return <[Coarse; 2]>::try_from(meshes).map_err(|_| unmatched());
        }
    }
    Err(unmatched())
}

fn unmatched() -> Fault {
    let message = "the cells of the two bodies cannot be given common points on the contact surface";
    let remedy = "let rows of cells run straight through the bodies from their contact edges";
    Fault::at("contact.edges", "not-available", message, remedy)
}
