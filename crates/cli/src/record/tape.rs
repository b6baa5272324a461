//! The recording of a run in time while it goes: one file, begun anew for each level, continued after an interruption.

use std::fs;
use std::path::{Path, PathBuf};

use scene::{Fault, Place};
use shapeopt::WearState;
use wearshape::{Resume, RunLevel};

use crate::bounded;
use crate::record::replay::Replay;
use crate::record::{Recorder, SceneUpdate, unwritable};

/// The bytes of a recording.
fn recorded(path: &Path) -> Result<Vec<u8>, Fault> {
    bounded::result(path).map_err(|why| {
        let message = format!("cannot read the recording {}: {why}", path.display());
        let remedy = "take it away, or leave out --resume to begin again";
        Fault { place: Some(Place::Flag("--resume".into())), ..Fault::new("unreadable", message, remedy) }
    })
}

/// A recording that follows a run from level to level.
pub(crate) struct Tape {
    path: PathBuf,
    resolved: String,
    recorder: Option<Recorder>,
    replay: Option<Replay>,
}

impl Tape {
    /// A recording; with `resume` it goes on with the one that is there. The sentence says from where.
    ///
    /// # Errors
    /// A recording with finished steps that cannot be continued: it is not written over.
    pub(crate) fn new(path: &Path, resolved: &str, resume: bool) -> Result<(Tape, Option<String>), Fault> {
        let path = path.to_path_buf();
        let (mut replay, mut word) = (None, None);
        if resume {
            let found = if path.exists() { Some(Replay::read(&recorded(&path)?)) } else { None };
            let said = match &found {
                None => "there is no recording to go on from; the run begins at its start".to_string(),
                Some(found) => match (found.unfit(resolved), found.states.last()) {
                    (Some(why), Some(_)) => return Err(lost(&path, &why, found.states.len())),
                    (Some(why), None) => format!("{} cannot be continued: {why}; the run begins at its start", path.display()),
                    (None, None) => format!("goes on after {} finished levels", found.levels().len()),
                    (None, Some(last)) => {
                        let levels = found.levels().len();
                        format!("goes on after {levels} finished levels and step {} at {} s", last.step, last.time)
                    }
                },
            };
            word = Some(said);
            replay = found.filter(|found| found.unfit(resolved).is_none());
        }
        Ok((Tape { path, resolved: resolved.into(), recorder: None, replay }, word))
    }

    /// Where an interrupted run goes on.
    pub(crate) fn resume(&self) -> Option<Resume> {
        let replay = self.replay.as_ref()?;
        let states = replay.states.iter().cloned().map(WearState::from).collect();
        Some(Resume { finished: replay.levels().to_vec(), states })
    }

    /// Begins a level, or goes on with one; `mesh` and its message open a new recording.
    pub(crate) fn begin_level(
        &mut self,
        level: &RunLevel<'_>,
        mesh: impl FnOnce() -> Result<SceneUpdate, Fault>,
    ) -> Result<(), Fault> {
        let replay = self.replay.take().filter(|_| level.known_steps > 0);
        // The file that is there stays until the new one holds as much.
        let new = self.path.with_extension("mcap.new");
        self.recorder = None;
        let mut recorder = Recorder::create(&new, &self.resolved, Some(level.finished))?;
        match &replay {
            Some(replay) => replay.copy_to(&mut recorder)?,
            None => {
                recorder.log(&level.message)?;
                recorder.mesh(&mesh()?)?;
            }
        }
        fs::rename(&new, &self.path).map_err(|error| unwritable(&self.path, &error))?;
        recorder.path.clone_from(&self.path);
        self.recorder = Some(recorder);
        Ok(())
    }

    /// The recording of the level that runs.
    pub(crate) fn recorder(&mut self) -> Option<&mut Recorder> {
        self.recorder.as_mut()
    }

    /// Ends the recording with a sentence and the summary, if any level was begun.
    pub(crate) fn finish(self, verdict: &str, summary: &str) -> Result<(), Fault> {
        let Some(mut recorder) = self.recorder else { return Ok(()) };
        recorder.log(verdict)?;
        recorder.finish(summary)
    }
}

/// Going on would write over finished steps.
fn lost(path: &Path, why: &str, steps: usize) -> Fault {
    let message = format!("{} holds {steps} finished steps and cannot be continued: {why}", path.display());
    let remedy = "go on with the program that wrote it, or leave out --resume to begin again without those steps";
    Fault { place: Some(Place::Flag("--resume".into())), ..Fault::new("another-recording", message, remedy) }
}
