//! The recording run.mcap: what happened, step by step, for a viewer and for going on after an interruption.
//!
//! JSON messages with JSON schemas; `log_time` is simulated time in ns. Every step is a chunk of its own, flushed when it is complete,
//! so that a killed run loses at most the step it was in and a fifth of a second before it (`tape.rs`). A run in time solves several levels of
//! discretisation one after another: the recording holds the level that runs, and what the finished ones left behind is attached to it.

mod messages;
mod replay;
mod scene_update;
mod state;
mod tape;
mod texts;

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};
use std::time::Instant;

use scene::{Fault, Place};
use schemars::JsonSchema;
use serde::Serialize;
use wearshape::FinishedLevel;

use crate::folder::INTERVAL;

pub(crate) use messages::{Iteration, Log, Points};
pub(crate) use replay::Replay;
pub(crate) use scene_update::SceneUpdate;
pub(crate) use state::State;
pub(crate) use tape::Tape;

/// Name of the recording in its folder.
pub(crate) const RUN_MCAP: &str = "run.mcap";
/// Layout of a viewer for the recording, and its name in the folder.
pub(crate) const LAYOUT: [&str; 2] = ["run.layout.json", include_str!("record/run.layout.json")];

const PROFILE: &str = "/contact/profile";
const STATE: &str = "/state";
const ITERATION: &str = "/iteration";
const LOG: &str = "/log";
const MESH: &str = "/mesh";
/// All channels in the order of their numbers.
const CHANNELS: [&str; 5] = [PROFILE, STATE, ITERATION, LOG, MESH];

/// Messages after which the chunk is closed and flushed: the opening of a run in time, and each finished step.
const ENDS_OF_CHUNKS: [&str; 2] = [MESH, STATE];

/// Level of Zstandard: recordings of runs in time are no larger by it than by the usual one, 3.
const QUICKEST: u32 = 1;

/// Name of the attached scene, of the attached levels before, and of the attached summary.
const SCENE_ATTACHED: &str = "scene.resolved.toml";
const LEVELS_ATTACHED: &str = "levels.json";
const SUMMARY_ATTACHED: &str = "summary.json";

/// Who wrote a recording.
const LIBRARY: &str = concat!("wearshape ", env!("CARGO_PKG_VERSION"));

/// A recording in the making.
pub(crate) struct Recorder {
    path: PathBuf,
    writer: mcap::Writer<BufWriter<File>>,
    /// The same file, to hand it to the disk, and when that was done last.
    disk: (File, Instant),
    channels: Vec<u16>,
    sequence: u32,
    time: u64,
}

impl Recorder {
    /// Begins a recording; the resolved scene and, in a run in time, the finished levels are attached to it.
    pub(crate) fn create(path: &Path, resolved: &str, levels: Option<&[FinishedLevel]>) -> Result<Recorder, Fault> {
        let file = File::create(path).map_err(|error| unwritable(path, &error))?;
        let disk = (file.try_clone().map_err(|error| unwritable(path, &error))?, Instant::now());
        let writer = mcap::WriteOptions::new()
            .compression(Some(mcap::Compression::Zstd))
            .compression_level(QUICKEST)
            .compression_threads(0)
            .profile("wearshape")
            .library(LIBRARY)
            .create(BufWriter::new(file))
            .map_err(|error| unwritable(path, &error))?;
        let mut recorder = Recorder { path: path.to_path_buf(), writer, disk, channels: Vec::new(), sequence: 0, time: 0 };
        recorder.attach(SCENE_ATTACHED, "application/toml", resolved)?;
        if let Some(levels) = levels {
            let text = serde_json::to_string(levels).map_err(|error| unwritable(path, &error))?;
            recorder.attach(LEVELS_ATTACHED, "application/json", &text)?;
        }
        recorder.channel::<Points>(PROFILE, "wearshape.ContactProfile")?;
        recorder.channel::<State>(STATE, "wearshape.State")?;
        recorder.channel::<Iteration>(ITERATION, "wearshape.Iteration")?;
        recorder.channel::<Log>(LOG, "foxglove.Log")?;
        recorder.channel::<SceneUpdate>(MESH, "foxglove.SceneUpdate")?;
        Ok(recorder)
    }

    /// Records an accepted step: its work, its profile, and last its state, from which a run can go on.
    pub(crate) fn step(&mut self, iteration: &Iteration, profile: &Points, state: &State) -> Result<(), Fault> {
        self.time = nanoseconds(state.time);
        self.put(ITERATION, iteration)?;
        self.put(PROFILE, profile)?;
        self.put(STATE, state)
    }

    /// Records the contact points of a run that has no time.
    pub(crate) fn picture(&mut self, profile: &Points) -> Result<(), Fault> {
        self.put(PROFILE, profile)
    }

    /// Records the meshes.
    pub(crate) fn mesh(&mut self, mesh: &SceneUpdate) -> Result<(), Fault> {
        self.put(MESH, mesh)
    }

    /// Records a sentence.
    pub(crate) fn log(&mut self, message: &str) -> Result<(), Fault> {
        let log = Log::new(self.time, message);
        self.put(LOG, &log)
    }

    /// Ends the recording; the summary is attached to it.
    pub(crate) fn finish(mut self, summary: &str) -> Result<(), Fault> {
        self.attach(SUMMARY_ATTACHED, "application/json", summary)?;
        self.writer.finish().map(|_| ()).map_err(|error| unwritable(&self.path, &error))
    }

    /// Closes the chunk and hands everything to the system, and now and then to the disk.
    fn flush(&mut self) -> Result<(), Fault> {
        let mut flushed = self.writer.flush().map_err(|error| unwritable(&self.path, &error));
        if flushed.is_ok() && self.disk.1.elapsed() >= INTERVAL {
            flushed = self.disk.0.sync_data().map_err(|error| unwritable(&self.path, &error));
            self.disk.1 = Instant::now();
        }
        flushed
    }

    fn channel<M: JsonSchema>(&mut self, topic: &str, name: &str) -> Result<(), Fault> {
        let settings = schemars::generate::SchemaSettings::draft07().with(|settings| settings.inline_subschemas = true);
        let schema = settings.into_generator().into_root_schema_for::<M>();
        let text = schema.as_value().to_string();
        let added = self
            .writer
            .add_schema(name, "jsonschema", text.as_bytes())
            .and_then(|schema| self.writer.add_channel(schema, topic, "json", &BTreeMap::new()));
        self.channels.push(added.map_err(|error| unwritable(&self.path, &error))?);
        Ok(())
    }

    fn attach(&mut self, name: &str, media_type: &str, text: &str) -> Result<(), Fault> {
        let attachment = mcap::Attachment {
            log_time: self.time,
            create_time: 0,
            name: name.into(),
            media_type: media_type.into(),
            data: Cow::Borrowed(text.as_bytes()),
        };
        self.writer.attach(&attachment).map_err(|error| unwritable(&self.path, &error))
    }

    fn put(&mut self, topic: &str, message: &impl Serialize) -> Result<(), Fault> {
        let data = serde_json::to_vec(message).map_err(|error| unwritable(&self.path, &error))?;
        self.put_bytes(topic, self.time, &data)
    }

    fn put_bytes(&mut self, topic: &str, time: u64, data: &[u8]) -> Result<(), Fault> {
        let Some(channel_id) = CHANNELS.iter().position(|known| *known == topic).and_then(|place| self.channels.get(place))
        else {
            return Ok(());
        };
        let header =
            mcap::records::MessageHeader { channel_id: *channel_id, sequence: self.sequence, log_time: time, publish_time: time };
        self.sequence += 1;
        self.time = time;
        self.writer.write_to_known_channel(&header, data).map_err(|error| unwritable(&self.path, &error))?;
        if ENDS_OF_CHUNKS.contains(&topic) {
            self.flush()?;
        }
        Ok(())
    }
}

/// Simulated time as a time stamp.
fn nanoseconds(seconds: f64) -> u64 {
    (seconds * 1e9).max(0.0) as u64
}

fn unwritable(path: &Path, error: &impl std::fmt::Display) -> Fault {
    let message = format!("cannot write the recording {}: {error}", path.display());
    let remedy = "make room on the disk and continue with --resume, or give another folder: -o DIR";
    let folder = path.parent().unwrap_or(path).display().to_string();
    Fault { place: Some(Place::Flag(folder)), ..Fault::new("unwritable", message, remedy) }
}

#[cfg(test)]
mod tests;
