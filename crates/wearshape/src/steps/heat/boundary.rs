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
                places = on_edges(&field);
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

/// Points of the cells' grids on the edges of a body: cell and reference coordinates.
fn on_edges(field: &Field) -> Vec<(usize, [f64; 2])> {
    let mesh: &Mesh = field.mesh();
    let alone = mesh.edge_cells().into_iter().filter(|cells| cells.len() == 1);
    alone
        .flat_map(|cells| {
            let (cell, side) = cells[0];
            let triangle = mesh.cells[cell].is_triangle();
            let grid = CellGrid { degree: field.degree(cell), triangle };
            let p = grid.degree;
            let on = move |(i, j): (usize, usize)| match side {
                0 => j == 0,
                1 if triangle => i + j == p,
                1 => i == p,
                2 if !triangle => j == p,
                _ => i == 0,
            };
            grid.steps()
                .zip(grid.reference())
                .filter(move |(step, _)| on(*step))
                .map(move |(_, at)| (cell, at))
                .collect::<Vec<_>>()
        })
        .collect()
}
