//! What must not change an answer, and the twin of a scene under it.

use super::case::Case;
use super::compare::{ACCURACY, Change, Outcome, deviations, outcome, over_estimates};
use super::draw::Random;
use super::numbers::Writing;

/// A change of the scene whose effect is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Property {
    Mirror,
    Scaling,
    Units,
    Threads,
    Naming,
    Swap,
    Splitting,
}

impl Property {
    /// One after the other; those that need estimates cost most and come once.
    pub(super) const TURNS: [Property; 10] = [
        Property::Mirror,
        Property::Scaling,
        Property::Units,
        Property::Threads,
        Property::Naming,
        Property::Mirror,
        Property::Scaling,
        Property::Swap,
        Property::Units,
        Property::Splitting,
    ];

    /// How twins of a scene are compared.
    pub(super) fn rule(self, case: &Case) -> Rule {
        match self {
            Property::Threads => Rule::Bits,
            // Both bodies are not cut alike, and cells of other names may be cut otherwise.
            Property::Splitting | Property::Swap | Property::Naming => Rule::Estimates,
            _ if case.has_free_ends() => Rule::Estimates,
            _ if case.task == "wear" => Rule::Steps,
            _ => Rule::RoundOff,
        }
    }
}

impl Property {
    /// The rule where both have as many cells: other names alone leave round-off.
    fn rule_of_equal_cells(self, rule: Rule) -> Rule {
        if self == Property::Naming { Rule::RoundOff } else { rule }
    }
}

/// What two answers may differ by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rule {
    /// Nothing.
    Bits,
    /// Round-off, which grows with the condition of the system.
    RoundOff,
    /// Twice the accuracy of a scene, to which the steps in time of each are chosen.
    Steps,
    /// Five times both estimated errors together: that an estimate is passed at most so far is what `cargo xtask estimates` holds.
    Estimates,
}

impl Rule {
    /// Largest deviation; of estimates their multiple.
    pub(super) fn limit(self) -> f64 {
        match self {
            Rule::Bits => 0.0,
            Rule::RoundOff => 1e-8,
            Rule::Steps => 2.0 * ACCURACY,
            Rule::Estimates => 5.0,
        }
    }
}

/// What came of a scene and its twin.
pub(super) enum Tried {
    /// Neither has an answer, for the same reason.
    Refused(Rule, String),
    /// The rule, the worst quantity and its deviation, and the texts.
    Compared { rule: Rule, worst: (&'static str, f64), texts: [String; 2] },
    /// One has an answer and the other none.
    Differ { rule: Rule, words: [String; 2], texts: [String; 2] },
}

/// Solves a scene and its twin.
pub(super) fn tried(case: &Case, property: Property, random: &mut Random) -> Tried {
    let mut change = Change::NONE;
    let base = case.text(Writing::Base);
    let twin = match property {
        Property::Mirror => {
            change.reversed = case.kinematics != "axisymmetric";
            case.mirrored().text(Writing::Base)
        }
        Property::Scaling => {
            (change.length, change.stress) = (random.scale(1e-4, 1e4), random.scale(1e-4, 1e4));
            case.scaled(change.length, change.stress).text(Writing::Base)
        }
        Property::Units => case.text(Writing::Other),
        Property::Threads => base.clone(),
        Property::Naming => case.renamed(random.next() | 1).text(Writing::Base),
        Property::Swap => case.swapped().text(Writing::Base),
        Property::Splitting => case.split().text(Writing::Base),
    };
    let rule = property.rule(case);
    let alone = rule != Rule::Estimates;
    let outcomes = if property == Property::Threads {
        [1, 2].map(|threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| outcome(&base, alone))
        })
    } else {
        [outcome(&base, alone), outcome(&twin, alone)]
    };
    if rule != Rule::Bits && alone && outcomes.iter().any(Outcome::opens) {
        let outcomes = [outcome(&base, false), outcome(&twin, false)];
        return compared([Rule::Estimates; 2], (outcomes, change), [base, twin]);
    }
    compared([rule, property.rule_of_equal_cells(rule)], (outcomes, change), [base, twin])
}

fn compared([rule, of_equal_cells]: [Rule; 2], (outcomes, change): ([Outcome; 2], Change), texts: [String; 2]) -> Tried {
    let words = outcomes.each_ref().map(Outcome::word);
    if words[0] != words[1] {
        return Tried::Differ { rule, words, texts };
    }
    let [Some(one), Some(twin)] = outcomes.each_ref().map(Outcome::answer) else {
        let [word, _] = words;
        return Tried::Refused(rule, word);
    };
    let rule = if one.effort.counters.cells == twin.effort.counters.cells { of_equal_cells } else { rule };
    let worst = match (rule, &one.wear) {
        (Rule::Estimates, Some(_)) => ("depth", over_estimates(one, twin, change).unwrap_or(f64::INFINITY)),
        (Rule::Estimates, None) => ("gap or energy", over_estimates(one, twin, change).unwrap_or(f64::INFINITY)),
        _ => deviations(one, twin, change).into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap(),
    };
    Tried::Compared { rule, worst, texts }
}
