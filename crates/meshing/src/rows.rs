//! Rows of cells that are cut: where cells are slender, and where one touches two points to grade towards. Which rows these are hangs on the shape of the
//! cells alone: not on the order in which they are given, nor on the side from which they are walked, nor on round-off.

use hpfem::Mesh;

/// Longest side of a cell over its shortest before it is cut.
const SLENDER: f64 = 3.0;
/// Ratios that differ by this share are equal: round-off.
const EQUAL: f64 = 1e-9;
/// Most cuts of slender cells in one body.
const MOST_CUTS: usize = 24;

/// Cuts the most slender cells across, again and again, until none is slender; those that are as slender as each other at once.
pub(crate) fn cut_slender(mut mesh: Mesh) -> Result<Mesh, hpfem::Error> {
    let mut left = MOST_CUTS;
    loop {
        let (ratio, edges) = slenderest(&mesh);
        if ratio <= SLENDER * (1.0 + EQUAL) {
            return Ok(mesh);
        }
        let (cut, rows) = mesh.cut_rows(&edges)?;
        if rows > left {
            return Ok(mesh);
        }
        left -= rows;
        mesh = cut;
    }
}

/// Mean length of the longer two opposite sides of a quadrilateral over that of the others, and one of the longer; of a square one of either pair.
fn slenderness(mesh: &Mesh, cell: usize) -> Option<(f64, [Option<usize>; 2])> {
    let size = |local: usize| {
        let length = |local: usize| mesh.local_curve(cell, local).length();
        0.5 * (length(local) + length(local + 2))
    };
    let own = &mesh.cells[cell];
    let ratio = if own.is_triangle() { return None } else { size(0) / size(1) };
    let longer = |local: usize, ratio: f64| own.edges[local].filter(|_| ratio >= 1.0 - EQUAL);
    Some((ratio.max(1.0 / ratio), [longer(0, ratio), longer(1, 1.0 / ratio)]))
}

/// The largest ratio of the sides of a cell, and an edge of the longer ones of each cell that has it.
fn slenderest(mesh: &Mesh) -> (f64, Vec<usize>) {
    let cells: Vec<_> = (0..mesh.cells.len()).filter_map(|cell| slenderness(mesh, cell)).collect();
    let most = cells.iter().fold(0.0_f64, |most, (ratio, _)| most.max(*ratio));
    let equal = cells.iter().filter(|(ratio, _)| *ratio >= most * (1.0 - EQUAL));
    (most, equal.flat_map(|(_, edges)| edges.iter().flatten().copied()).collect())
}

/// Edges whose cuts part the points to grade towards that one cell touches: those that join two of them, and of cells that touch two across, one of the
/// longer sides; of cells as long as high one in each direction.
pub(crate) fn crowded_edges(mesh: &Mesh, singular: &[[f64; 2]]) -> Vec<usize> {
    let graded: Vec<usize> = singular.iter().map(|x| mesh.nearest_vertex(*x)).collect();
    let joining: Vec<usize> =
        (0..mesh.edges.len()).filter(|e| mesh.edges[*e].vertices.iter().all(|v| graded.contains(v))).collect();
    if !joining.is_empty() {
        return joining;
    }
    let touches = |cell: &usize| mesh.cells[*cell].vertices().iter().filter(|v| graded.contains(v)).count() > 1;
    let across = (0..mesh.cells.len()).filter(touches).filter_map(|cell| slenderness(mesh, cell));
    across.flat_map(|(_, edges)| edges.into_iter().flatten()).collect()
}

/// A cell that touches two of the points, and the two corners.
pub(crate) fn crowded(mesh: &Mesh, singular: &[[f64; 2]]) -> Option<(usize, [usize; 2])> {
    let graded: Vec<usize> = singular.iter().map(|x| mesh.nearest_vertex(*x)).collect();
    mesh.cells.iter().enumerate().find_map(|(c, cell)| {
        let mut touched = (0..cell.vertices().len()).filter(|k| graded.contains(&cell.corners[*k]));
        Some((c, [touched.next()?, touched.next()?]))
    })
}
