//! Meshes with nodes at ends of contact that only a run itself finds: one that ends on the way, where no steady pressure says where they go.

use crate::ladder::Refusal;
use crate::level::Level;
use crate::stage::Stage;
use crate::steps::wear::level::{self, Known, Mesh, Unfinished};
use crate::steps::wear::pieces::Pieces;
use crate::steps::wear::ran::Ran;
use crate::watch::{FinishedLevel, Watch};

/// One run on one level, where no ends are known with nodes where the first level, which has none, found them.
pub(super) fn run(
    stage: Stage<'_>,
    pieces: &Pieces,
    mesh: Mesh<'_>,
    known: Known<'_>,
    watch: &mut Watch<'_>,
) -> Result<Result<(FinishedLevel, Ran), Unfinished>, Refusal> {
    let finished = known.finished;
    let mesh = Mesh { level: everywhere(stage, mesh.level, finished), ..mesh };
    let found = if mesh.known.is_empty() { nodes(stage, finished) } else { &[] };
    if found.is_empty() {
        return level::run(stage, pieces, mesh, known, watch);
    }
    let mut done = level::run(stage, pieces, Mesh { ends: found, ..mesh }, known, watch)?;
    let failed = done.as_ref().ok().filter(|(_, ran)| ran.failure().is_some()).map(|(_, ran)| ran.effort.clone());
    // The end of contact may not come past its node, where the points lie close together.
    if let Some(mut effort) = failed {
        done = level::run(stage, pieces, mesh, Known { finished, states: Vec::new() }, watch)?;
        if let Ok((_, ran)) = &mut done {
            effort += std::mem::take(&mut ran.effort);
            ran.effort = effort;
        }
    }
    Ok(done)
}

/// A level of a run, with its degree in all cells where the first one had a part of the surface open on the way: ends of contact have passed over them,
/// and levels whose degrees are alike somewhere would agree on what all of them are off by. What is steady knows nothing of the way, and a contact that grows from a
/// point has its cells where it goes.
fn everywhere(stage: Stage<'_>, level: Level, finished: &[FinishedLevel]) -> Level {
    let on_the_way = stage.problem.wear.until.is_some() && !stage.ends_move();
    if on_the_way && finished.first().is_some_and(|first| first.partial) { level.evenly() } else { level }
}

/// The nodes of a level of such a run: where its first level, which has none, found the ends.
fn nodes<'a>(stage: Stage<'_>, finished: &'a [FinishedLevel]) -> &'a [f64] {
    let found = finished.first().map_or(&[][..], |first| &first.ends);
    if !found.is_empty() && stage.meshes(1, stage.cut(found)).is_ok() { found } else { &[] }
}
