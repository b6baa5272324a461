//! The counts of a campaign.

use super::compare::Quantity;
use super::random::Scene;

/// A scene with true error over estimate of each quantity that the finer solution is sure of.
pub(super) struct Row {
    pub number: usize,
    pub scene: Scene,
    pub effectivities: Vec<(Quantity, f64)>,
    pub says: String,
}

/// A scene in a line.
pub(super) fn line(row: &Row) -> String {
    let Row { number, scene, effectivities, says } = row;
    let ratios: Vec<String> = effectivities.iter().map(|(quantity, ratio)| format!("{quantity} {ratio:.2}")).collect();
    let name = format!("{} {}", scene.base, scene.set[0]);
    format!("{number:>4} {name:<42} degree {:>2}, {:>2} layers  {} {says}", scene.degree, scene.layers, ratios.join(", "))
}

/// Counts by quantity, and the worst scenes.
pub(super) fn text(rows: &[Row], seed: u64) -> String {
    let solved = rows.iter().filter(|row| !row.effectivities.is_empty()).count();
    let mut text = format!(
        "Seed {seed}: {} scenes, {solved} with a truth that is sure.\n\n\
         | true error over estimate of | count | below 0.1 | 0.1 to 2 | 2 to 5 | above 5 | largest |\n|---|---|---|---|---|---|---|\n",
        rows.len()
    );
    for quantity in ["gap_relative", "pressure_relative", "energy_relative"] {
        let ratios: Vec<f64> =
            rows.iter().flat_map(|row| &row.effectivities).filter(|(of, _)| *of == quantity).map(|(_, ratio)| *ratio).collect();
        let within = |from: f64, to: f64| ratios.iter().filter(|ratio| **ratio >= from && **ratio < to).count();
        text += &format!(
            "| {quantity} | {} | {} | {} | {} | {} | {:.2} |\n",
            ratios.len(),
            within(0.0, 0.1),
            within(0.1, 2.0),
            within(2.0, 5.0),
            within(5.0, f64::INFINITY),
            ratios.iter().copied().fold(0.0, f64::max)
        );
    }
    let worst = |row: &Row| row.effectivities.iter().map(|(_, ratio)| *ratio).fold(0.0, f64::max);
    let mut order: Vec<&Row> = rows.iter().filter(|row| worst(row) > 2.0).collect();
    order.sort_by(|a, b| worst(b).total_cmp(&worst(a)));
    if !order.is_empty() {
        text += "\nErrors of more than twice the estimate:\n\n";
    }
    for row in order {
        text += &format!("- {}: {}\n", line(row).split_whitespace().collect::<Vec<_>>().join(" "), row.scene.set[2..].join(" "));
    }
    text
}

/// docs/estimates.md.
pub(super) fn page(text: &str) -> String {
    format!(
        "# How honest the estimated errors are\n\nWritten by `cargo xtask estimates --docs`. Each scene is a built-in one with random bodies, \
         materials and friction, at a fixed degree from 5 to 11 and any number of layers up to two more; the truth is the same four degrees higher, \
         where its own estimate is at most a tenth of the error. Pressures are compared away from ends of contact inside the surface, by more than the \
         distance of two samples: there they go like a square root, and a sample stands for what it is not. Energies are those \
         of both bodies together. An estimate that is too large costs time, one that is too small is wrong: none may be passed by more than 5 times.\n\n{text}"
    )
}
