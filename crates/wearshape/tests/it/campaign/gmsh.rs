//! A rectangle of cells as a gmsh file, MSH 2.2.

use super::blocks::Names;
use super::draw::Random;

/// Names of the sides and of the surface; their numbers are those of the physical groups.
const GROUPS: [&str; 5] = ["bottom", "right", "top", "left", "all"];

/// The file. Seed 0 numbers nodes and elements in the order of the grid; any other one in an order of its own, with gaps, lists them in another, and walks
/// lines and cells from other nodes.
pub(super) fn file([x, z]: [&[f64]; 2], numbering: u64) -> String {
    let mut random = (numbering != 0).then(|| Random::new(numbering));
    let (columns, rows) = (x.len(), z.len());
    let count = columns * rows;
    let tags = Names::new(count, random.as_mut());
    let gap = if random.is_some() { 3 } else { 1 };
    let tag = |i: usize, j: usize| 1 + gap * tags.0[j * columns + i];
    let places = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j)));
    let nodes: Vec<String> = places.map(|(i, j)| format!("{} {:?} {:?} 0", tag(i, j), x[i], z[j])).collect();
    // Group and nodes.
    let mut elements: Vec<(usize, Vec<usize>)> = Vec::new();
    for i in 1..columns {
        elements.push((0, vec![tag(i - 1, 0), tag(i, 0)]));
        elements.push((2, vec![tag(i - 1, rows - 1), tag(i, rows - 1)]));
    }
    for j in 1..rows {
        elements.push((1, vec![tag(columns - 1, j - 1), tag(columns - 1, j)]));
        elements.push((3, vec![tag(0, j - 1), tag(0, j)]));
    }
    for (i, j) in (1..rows).flat_map(|j| (1..columns).map(move |i| (i, j))) {
        elements.push((4, vec![tag(i - 1, j - 1), tag(i, j - 1), tag(i, j), tag(i - 1, j)]));
    }
    if let Some(random) = &mut random {
        for (_, nodes) in &mut elements {
            let by = random.below(nodes.len());
            nodes.rotate_left(by);
        }
    }
    let order = Names::new(elements.len(), random.as_mut()).0;
    let line = |(number, (group, nodes)): (usize, &(usize, Vec<usize>))| {
        let kind = if *group == 4 { 3 } else { 1 };
        let nodes: Vec<String> = nodes.iter().map(ToString::to_string).collect();
        format!("{} {kind} 2 {} {} {}", gap * number + 1, group + 1, group + 1, nodes.join(" "))
    };
    let lines: Vec<String> = order.iter().map(|e| line((*e, &elements[*e]))).collect();
    let listed = |items: &[String], order: &[usize]| order.iter().map(|i| items[*i].clone()).collect::<Vec<_>>().join("\n");
    let names: Vec<String> =
        GROUPS.iter().enumerate().map(|(k, name)| format!("{} {} \"{name}\"", if k == 4 { 2 } else { 1 }, k + 1)).collect();
    let nodes_order = Names::new(count, random.as_mut()).0;
    format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n5\n{}\n$EndPhysicalNames\n$Nodes\n{count}\n{}\n$EndNodes\n$Elements\n{}\n{}\n$EndElements\n",
        names.join("\n"),
        listed(&nodes, &nodes_order),
        lines.len(),
        lines.join("\n")
    )
}
