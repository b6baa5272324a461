//! Meshes with nodes at ends of contact that only a run itself finds: one that ends on the way, where no steady pressure says where they go, or one whose
//! contact grows, of which its own levels know more than rough runs.

use crate::ladder::Refusal;
use crate::stage::Stage;
use crate::steps::wear::integration_error::opens;
use crate::steps::wear::level::{self, Known, Mesh, Unfinished};
use crate::steps::wear::pieces::Pieces;
use crate::steps::wear::ran::Ran;
use crate::watch::{FinishedLevel, Watch};

/// One run on one level, where no ends are known with nodes where the first level, which has none, found them; where they grow, where the last one did.
pub(super) fn run(
    stage: Stage<'_>,
    pieces: &Pieces,
    mesh: Mesh<'_>,
    known: Known<'_>,
    watch: &mut Watch<'_>,
) -> Result<Result<(FinishedLevel, Ran), Unfinished>, Refusal> {
    let finished = known.finished;
    // Levels whose degrees are alike in cells that ends of contact pass over would agree on what all of them are off by.
    let mesh = if opens(stage, pieces.problems.len(), finished) { Mesh { level: mesh.level.evenly(), ..mesh } } else { mesh };
    let found = nodes(stage, mesh, finished);
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

/// The nodes of a level of such a run: where its first level, which has none, found the ends, and of a contact that grows where the last one did.
fn nodes<'a>(stage: Stage<'_>, mesh: Mesh<'_>, finished: &'a [FinishedLevel]) -> &'a [f64] {
    let found = match mesh.known {
        [] => finished.first().map_or(&[][..], |first| &first.ends),
        _ => finished.last().map_or(&[][..], |last| &last.passed),
    };
    if !found.is_empty() && stage.meshes(1, stage.cut(found)).is_ok() { found } else { &[] }
}
