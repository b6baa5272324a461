//! The highest temperature of a body at many moments: heat comes in through its edges alone, so that it is hottest at one of them.

use hpfem::{CellGrid, Field, InterfaceState, Mesh};
use scene::Fault;

use crate::steps::heat::known::PointHeat;
use crate::steps::heat::warmed::{Warmed, no_field};

/// Fields that are there at once.
const AT_ONCE: usize = 32;

/// Highest temperature (degC) of body 1 (0) or body 2 (1) under each of the heats; empty for a body without a temperature field.
pub(crate) fn highest_of_each(warmed: &Warmed<'_>, number: usize, heats: &[PointHeat]) -> Result<Vec<f64>, Fault> {
    let Some(conduction) = warmed.conduction(number) else { return Ok(Vec::new()) };
    let pair = warmed.pair()?;
    let mut found = Vec::new();
    let mut places = Vec::new();
    for heats in heats.chunks(AT_ONCE) {
        let states: Vec<InterfaceState> =
            heats.iter().filter_map(|heat| warmed.states(&pair, &heat.into)[number].clone()).collect();
        for field in conduction.body.fields(&states).map_err(no_field)? {
            if places.is_empty() {
                places = on_edges(&field, &|_| true);
            }
            let mut highest = f64::NEG_INFINITY;
            for (cell, [xi, eta]) in &places {
                highest = highest.max(field.at(*cell, *xi, *eta).map_err(no_field)?.displacement[0]);
            }
            found.push(highest);
        }
    }
    Ok(found)
}

/// Points of the cells' grids on the edges of the part of a body that is made of the materials asked for, and on named lines inside it, which may be held
/// at a temperature: cell and reference coordinates.
pub(super) fn on_edges(field: &Field, of: &dyn Fn(usize) -> bool) -> Vec<(usize, [f64; 2])> {
    let mesh: &Mesh = field.mesh();
    let mut sides = vec![Vec::new(); mesh.cells.len()];
    for (edge, mut cells) in mesh.edges.iter().zip(mesh.edge_cells()) {
        cells.retain(|(cell, _)| of(mesh.cells[*cell].material));
        if let Some((cell, side)) = cells.first().filter(|_| cells.len() == 1 || !edge.tags.is_empty()) {
            sides[*cell].push(*side);
        }
    }
    let mut points = Vec::new();
    for (cell, sides) in sides.into_iter().enumerate().filter(|(_, sides)| !sides.is_empty()) {
        let triangle = mesh.cells[cell].is_triangle();
        let grid = CellGrid { degree: field.degree(cell), triangle };
        let p = grid.degree;
        let on = |(i, j): (usize, usize), side: usize| match side {
            0 => j == 0,
            1 if triangle => i + j == p,
            1 => i == p,
            2 if !triangle => j == p,
            _ => i == 0,
        };
        let own = grid.steps().zip(grid.reference()).filter(|(step, _)| sides.iter().any(|side| on(*step, *side)));
        points.extend(own.map(|(_, at)| (cell, at)));
    }
    points
}
