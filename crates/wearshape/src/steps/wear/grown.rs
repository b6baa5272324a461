//! Where the surface of two circles that wear is cut: their contact grows from the place where they touch, to both sides.

use crate::effort::Effort;
use crate::ladder::Refusal;
use crate::stage::Stage;
use crate::steps::hertz_trial::short_contact;
use crate::steps::wear::pieces::Pieces;
use crate::steps::wear::rough::{self, FOUND, Rough, TRIALS};
use crate::steps::wear::round_mesh::{breaks, left};

/// Part of the way from the touch to the end of the surface beyond which the contact has come to it.
const FULL: f64 = 0.98;
/// The shortest contact at the start that the mesh knows of, over that at the end: what was worn in a shorter one is worn off by then.
const SHORTEST: f64 = 1.0 / 16.0;

/// Share of half the surface that the contact is shorter than at the start where its ends are guessed for the first rough run.
const SHORT: f64 = 0.5;
/// Length of the first contact over that of Hertz below which the cells of a rough run do not know it.
const LOST: f64 = 0.5;

/// Nodes from -1 to 1 along the surface that the ends of contact pass, to where they are at the end; none where no rough run tells them.
pub(super) fn nodes(stage: Stage<'_>, pieces: &Pieces) -> Result<(Vec<f64>, Effort), Refusal> {
    let mut effort = Effort::default();
    let hertz = short_contact(stage, SHORT).map(|(end, _)| end);
    let mut nodes = hertz.map_or_else(Vec::new, |end| cut(stage, &guess(end)));
    let mut before: Option<[f64; 2]> = None;
    for _ in 0..TRIALS {
        let found = match rough::run(stage, pieces, &nodes, &mut effort) {
            Ok(found) => with_start(found, hertz),
            // A contact that wears itself free has no end, and cells that cannot be cut there serve as they are.
            Err(_) => return Ok((Vec::new(), effort)),
        };
        nodes = cut(stage, &found);
        let [from, to] = found.end;
        let change = before.map_or(f64::INFINITY, |[a, b]| (from - a).abs().max((to - b).abs()) / (to - from));
        before = Some(found.end);
        if change <= FOUND * stage.accuracy() {
            break;
        }
    }
    if stage.meshes(1, stage.cut(&nodes)).is_err() {
        nodes.clear();
    }
    Ok((nodes, effort))
}

/// The same nodes as the ends of contact after each step tell them (mm along the surface); none of a surface on which nothing grows.
pub(super) fn passed(stage: Stage<'_>, ends: &[[f64; 2]]) -> Vec<f64> {
    let (Some((touch, _)), true) = (stage.problem.gap.touch(), stage.grows()) else { return Vec::new() };
    let mut from_touch = ends.iter().map(|ends| ends.map(|end| end - touch));
    let Some(start) = from_touch.next() else { return Vec::new() };
    let (mut end, mut widest) = (start, start);
    for [from, to] in from_touch {
        (end, widest) = ([from, to], [widest[0].min(from), widest[1].max(to)]);
    }
    let hertz = short_contact(stage, SHORT).map(|(end, _)| end);
    cut(stage, &with_start(Rough { start, end, widest }, hertz))
}

/// Where the ends of contact may move that begins as short as Hertz has it, too short for a mesh that knows nothing of it.
fn guess(hertz: f64) -> Rough {
    let end = [-hertz / SHORTEST, hertz / SHORTEST];
    Rough { start: [-hertz, hertz], end, widest: end }
}

/// What a rough run found, with the first contact of Hertz where its cells were too long for that.
fn with_start(found: Rough, hertz: Option<f64>) -> Rough {
    let [from, to] = found.start;
    let lost = |hertz: &f64| to - from < 2.0 * LOST * hertz;
    let start = hertz.filter(lost).map_or(found.start, |hertz| [-hertz, hertz]);
    Rough { start, ..found }
}

/// The nodes of ends that move as a rough run tells.
fn cut(stage: Stage<'_>, found: &Rough) -> Vec<f64> {
    let (Some([from, to]), Some((touch, _))) = (stage.patch.places(), stage.problem.gap.touch()) else { return Vec::new() };
    let wear = &stage.problem.wear;
    let linear = wear.exponents == [1.0] && !wear.own_rule;
    let mut places = Vec::new();
    for (side, sense, longest) in [(0, -1.0, touch - from), (1, 1.0, to - touch)] {
        let [start, end, widest] = [found.start, found.end, found.widest].map(|ends| sense * ends[side]);
        if end > 0.0 && longest > 0.0 {
            let end = end.min(longest);
            let passed = breaks(start.max(SHORTEST * end), end, linear);
            let within = passed.into_iter().chain(left(end, widest, linear)).filter(|x| *x < FULL * longest);
            places.extend(within.map(|x| touch + sense * x));
        }
    }
    places.sort_unstable_by(f64::total_cmp);
    places.iter().map(|place| (2.0 * place - from - to) / (to - from)).collect()
}
