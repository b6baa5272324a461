//! Counts of a campaign.

use std::collections::BTreeMap;

use super::twin::{Property, Rule, Tried};

#[derive(Default)]
struct Row {
    tried: u64,
    refused: BTreeMap<String, u64>,
    failed: u64,
    worst: f64,
    of: String,
}

/// Counts by property, and what failed.
#[derive(Default)]
pub(super) struct Tally {
    rows: BTreeMap<(Property, Rule), Row>,
    /// Seed of the scene, what is wrong, both texts.
    pub failures: Vec<(u64, String)>,
}

impl Tally {
    pub(super) fn add(&mut self, property: Property, seed: u64, tried: Tried) {
        let rule = match tried {
            Tried::Refused(rule, _) | Tried::Compared { rule, .. } | Tried::Differ { rule, .. } => rule,
        };
        let row = self.rows.entry((property, rule)).or_default();
        row.tried += 1;
        let failure = match tried {
            Tried::Refused(_, why) => {
                *row.refused.entry(why).or_default() += 1;
                return;
            }
            Tried::Compared { worst: (name, deviation), texts, .. } => {
                if deviation > row.worst {
                    (row.worst, row.of) = (deviation, format!("{name} (seed {seed})"));
                }
                if deviation <= rule.limit() {
                    return;
                }
                (format!("{name} off by {deviation:e}"), texts)
            }
            Tried::Differ { words: [one, twin], texts, .. } => (format!("{one}, but its twin {twin}"), texts),
        };
        row.failed += 1;
        let (says, [one, twin]) = failure;
        self.failures.push((seed, format!("{property:?}, seed {seed}: {says}\n--- scene\n{one}--- twin\n{twin}")));
    }

    pub(super) fn refused(&self) -> u64 {
        self.rows.values().flat_map(|row| row.refused.values()).sum()
    }

    pub(super) fn table(&self) -> String {
        let mut text = String::from(
            "| changed | may differ by | tried | refused | failed | limit | worst | of |\n|---|---|---|---|---|---|---|---|\n",
        );
        for ((property, rule), row) in &self.rows {
            let refused: Vec<String> = row.refused.iter().map(|(why, count)| format!("{count} {why}")).collect();
            let refused = if refused.is_empty() { "0".into() } else { refused.join(", ") };
            let (tried, failed, worst, of) = (row.tried, row.failed, row.worst, &row.of);
            let (name, limit) = (format!("{property:?}").to_lowercase(), rule.limit());
            let by = words(*rule);
            text += &format!("| {name} | {by} | {tried} | {refused} | {failed} | {limit:.0e} | {worst:.1e} | {of} |\n");
        }
        text
    }
}

fn words(rule: Rule) -> &'static str {
    match rule {
        Rule::Bits => "no bit",
        Rule::RoundOff => "round-off",
        Rule::Steps => "steps in time",
        Rule::Estimates => "both estimates",
    }
}
