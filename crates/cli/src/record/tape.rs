//! The recording of a run in time while it goes: one file, begun anew for each level, continued after an interruption.
//!
//! Steps wait for a moment before they are written, so that rough levels, which are over in less, cost no file. Written or not, every step is a chunk of its
//! own: when it was written does not show in the bytes.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use scene::{Fault, Place};
use shapeopt::WearState;
use wearshape::{FinishedLevel, Resume, RunLevel};

use crate::bounded;
use crate::record::replay::Replay;
use crate::record::{Iteration, Points, Recorder, SceneUpdate, State, unwritable};

/// What a killed run may lose, the step it was in aside.
const WAIT: Duration = Duration::from_millis(200);

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
    replay: Option<Replay>,
    /// The opening of the level that runs, until it is written.
    opening: Option<Opening>,
    recorder: Option<Recorder>,
    /// Steps that are not written yet, and since when.
    waiting: Vec<(Iteration, Points, State)>,
    since: Instant,
    /// Whether a run could go on from what is recorded or waits.
    holds_steps: bool,
}

/// How the recording of a level begins.
struct Opening {
    finished: Vec<FinishedLevel>,
    first: First,
}

/// What comes first in it.
enum First {
    /// What was recorded before an interruption.
    Replay(Replay),
    /// The level in a sentence, and its meshes.
    Mesh(String, SceneUpdate),
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
        let holds_steps = replay.as_ref().is_some_and(|replay| !(replay.states.is_empty() && replay.levels().is_empty()));
        let tape = Tape {
            path,
            resolved: resolved.into(),
            replay,
            opening: None,
            recorder: None,
            waiting: Vec::new(),
            since: Instant::now(),
            holds_steps,
        };
        Ok((tape, word))
    }

    /// Where an interrupted run goes on.
    pub(crate) fn resume(&self) -> Option<Resume> {
        let replay = self.replay.as_ref()?;
        let states = replay.states.iter().cloned().map(WearState::from).collect();
        Some(Resume { finished: replay.levels().to_vec(), states })
    }

    /// Whether there are finished steps, or levels, to go on from.
    pub(crate) fn holds_steps(&self) -> bool {
        self.holds_steps
    }

    /// Begins a level, or goes on with one; `mesh` and its message open a new recording.
    pub(crate) fn begin_level(
        &mut self,
        level: &RunLevel<'_>,
        mesh: impl FnOnce() -> Result<SceneUpdate, Fault>,
    ) -> Result<(), Fault> {
        let first = match self.replay.take().filter(|_| level.known_steps > 0) {
            Some(replay) => First::Replay(replay),
            None => First::Mesh(level.message.clone(), mesh()?),
        };
        self.holds_steps = level.known_steps > 0 || !level.finished.is_empty();
        self.opening = Some(Opening { finished: level.finished.to_vec(), first });
        self.recorder = None;
        self.waiting.clear();
        self.since = Instant::now();
        Ok(())
    }

    /// Takes an accepted step: its work, its profile, and its state, from which a run can go on.
    pub(crate) fn step(&mut self, iteration: Iteration, profile: Points, state: State) -> Result<(), Fault> {
        self.waiting.push((iteration, profile, state));
        self.holds_steps = true;
        if self.since.elapsed() >= WAIT {
            self.recorder()?;
        }
        Ok(())
    }

    /// The recording of the level that runs, with all steps up to now, if any level was begun.
    pub(crate) fn recorder(&mut self) -> Result<Option<&mut Recorder>, Fault> {
        if let Some(opening) = self.opening.take() {
            self.recorder = Some(self.open(opening)?);
        }
        let Some(recorder) = &mut self.recorder else { return Ok(None) };
        for (iteration, profile, state) in self.waiting.drain(..) {
            recorder.step(&iteration, &profile, &state)?;
        }
        self.since = Instant::now();
        Ok(Some(recorder))
    }

    /// Begins the file of a level.
    fn open(&self, Opening { finished, first }: Opening) -> Result<Recorder, Fault> {
        // The file that is there stays until the new one holds as much.
        let new = self.path.with_extension("mcap.new");
        let mut recorder = Recorder::create(&new, &self.resolved, Some(&finished))?;
        match first {
            First::Replay(replay) => replay.copy_to(&mut recorder)?,
            First::Mesh(message, mesh) => {
                recorder.log(&message)?;
                recorder.mesh(&mesh)?;
            }
        }
        fs::rename(&new, &self.path).map_err(|error| unwritable(&self.path, &error))?;
        recorder.path.clone_from(&self.path);
        Ok(recorder)
    }

    /// Ends the recording with a sentence and the summary, if any level was begun.
    pub(crate) fn finish(mut self, verdict: &str, summary: &str) -> Result<(), Fault> {
        self.recorder()?;
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
