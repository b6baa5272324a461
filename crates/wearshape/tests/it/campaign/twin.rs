//! What must not change an answer, and the twin of a scene under it.

use super::case::Case;
use super::compare::{ACCURACY, Change, Outcome, Written, deviations, outcome, over_estimates};
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
    Numbering,
    Turning,
    Round,
    Swap,
    Splitting,
}

impl Property {
    /// One after the other; those that need estimates cost most and come once.
    pub(super) const TURNS: [Property; 13] = [
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
        Property::Numbering,
        Property::Turning,
        Property::Round,
    ];

    /// How twins of a scene are compared.
    pub(super) fn rule(self, case: &Case) -> Rule {
        match self {
            Property::Threads => Rule::Bits,
            // Both bodies are not cut alike.
            Property::Splitting | Property::Swap => Rule::Estimates,
            _ if case.has_free_ends() => Rule::Estimates,
            _ if case.task == "wear" => Rule::Steps,
            _ => Rule::RoundOff,
        }
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

/// A scene as written, its twin, and what the twin's numbers are to be divided by.
fn pair(case: &Case, property: Property, random: &mut Random) -> ([Written; 2], Change) {
    let mut change = Change::NONE;
    let mut base = case.clone();
    let mut writing = Writing::Base;
    let twin = match property {
        Property::Mirror => {
            change.reversed = case.kinematics != "axisymmetric";
            case.mirrored()
        }
        Property::Scaling => {
            (change.length, change.stress) = (random.scale(1e-4, 1e4), random.scale(1e-4, 1e4));
            case.scaled(change.length, change.stress)
        }
        Property::Round => {
            change.reversed = case.kinematics != "axisymmetric";
            (change.length, change.stress) = (random.scale(1e-4, 1e4), random.scale(1e-4, 1e4));
            case.mirrored().scaled(change.length, change.stress)
        }
        Property::Units => {
            writing = Writing::Other;
            case.clone()
        }
        Property::Threads => case.clone(),
        Property::Naming => case.renamed(random.next() | 1),
        Property::Numbering => {
            base = case.numbered(0);
            case.numbered(random.next() | 1)
        }
        Property::Turning => case.turned(random.within(-0.5, 0.5)),
        Property::Swap => case.swapped(),
        Property::Splitting => case.split(),
    };
    let written = |case: &Case, writing: Writing| Written { text: case.text(writing), files: case.files() };
    ([written(&base, Writing::Base), written(&twin, writing)], change)
}

/// Solves a scene and its twin.
pub(super) fn tried(case: &Case, property: Property, random: &mut Random) -> Tried {
    let ([base, twin], change) = pair(case, property, random);
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
        return compared(Rule::Estimates, (outcomes, change), [base.text, twin.text]);
    }
    compared(rule, (outcomes, change), [base.text, twin.text])
}

fn compared(rule: Rule, (outcomes, change): ([Outcome; 2], Change), texts: [String; 2]) -> Tried {
    let words = outcomes.each_ref().map(Outcome::word);
    if words[0] != words[1] {
        return Tried::Differ { rule, words, texts };
    }
    let [Some(one), Some(twin)] = outcomes.each_ref().map(Outcome::answer) else {
        let [word, _] = words;
        return Tried::Refused(rule, word);
    };
    let worst = match (rule, &one.wear) {
        (Rule::Estimates, Some(_)) => ("depth", over_estimates(one, twin, change).unwrap_or(f64::INFINITY)),
        (Rule::Estimates, None) => ("gap or energy", over_estimates(one, twin, change).unwrap_or(f64::INFINITY)),
        _ => deviations(one, twin, change).into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).unwrap(),
    };
    Tried::Compared { rule, worst, texts }
}
