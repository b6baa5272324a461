//! The recording run.mcap: what happened, step by step, for a viewer and for going on after an interruption.
//!
//! JSON messages with JSON schemas; `log_time` is simulated time in ns. Every step is flushed, so that a killed run loses at most
//! the step it was in.

mod messages;

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use mcap::read::Options;
use schemars::JsonSchema;
use serde::Serialize;

use crate::fault::Fault;
use crate::profile::Profile;

pub(crate) use messages::{Iteration, Log, Points, State};

/// A recording in the making.
pub(crate) struct Recorder {
    path: PathBuf,
    writer: mcap::Writer<BufWriter<File>>,
    /// Channel numbers: profile, state, iteration, log.
    channels: [u16; 4],
    sequence: u32,
    time: u64,
}

impl Recorder {
    /// Begins a recording; the resolved scene is attached to it.
    pub(crate) fn create(path: &Path, resolved: &str) -> Result<Recorder, Fault> {
        let file = File::create(path).map_err(|error| unwritable(path, &error))?;
        let writer = mcap::WriteOptions::new()
            .compression(Some(mcap::Compression::Zstd))
            .compression_threads(0)
            .profile("wearshape")
            .library(concat!("wearshape ", env!("CARGO_PKG_VERSION")))
            .create(BufWriter::new(file))
            .map_err(|error| unwritable(path, &error))?;
        let mut recorder = Recorder { path: path.to_path_buf(), writer, channels: [0; 4], sequence: 0, time: 0 };
        recorder.attach("scene.resolved.toml", "application/toml", resolved)?;
        recorder.channels = [
            recorder.channel::<Points>("/contact/profile", "wearshape.ContactProfile")?,
            recorder.channel::<State>("/state", "wearshape.State")?,
            recorder.channel::<Iteration>("/iteration", "wearshape.Iteration")?,
            recorder.channel::<Log>("/log", "foxglove.Log")?,
        ];
        Ok(recorder)
    }

    /// Records an accepted step: its profile and its state, from which a run can go on.
    pub(crate) fn step(&mut self, state: &State, profile: &Profile) -> Result<(), Fault> {
        self.time = (state.time_s * 1e9).max(0.0) as u64;
        self.put(0, &Points::new(state.step, state.time_s, profile))?;
        self.put(1, state)?;
        self.writer.flush().map_err(|error| unwritable(&self.path, &error))
    }

    /// Records one pass of an iteration, at the time of the step before.
    #[allow(dead_code, reason = "reading back is tested; going on from it is not built yet")]
    pub(crate) fn iteration(&mut self, iteration: &Iteration) -> Result<(), Fault> {
        self.put(2, iteration)
    }

    /// Records a sentence.
    pub(crate) fn log(&mut self, message: &str) -> Result<(), Fault> {
        let log = Log::new(self.time, message);
        self.put(3, &log)
    }

    /// Ends the recording; the summary is attached to it.
    pub(crate) fn finish(mut self, summary: &str) -> Result<(), Fault> {
        self.attach("summary.json", "application/json", summary)?;
        self.writer.finish().map(|_| ()).map_err(|error| unwritable(&self.path, &error))
    }

    fn channel<M: JsonSchema>(&mut self, topic: &str, name: &str) -> Result<u16, Fault> {
        let settings = schemars::generate::SchemaSettings::draft07().with(|settings| settings.inline_subschemas = true);
        let schema = settings.into_generator().into_root_schema_for::<M>();
        let text = schema.as_value().to_string();
        let added = self
            .writer
            .add_schema(name, "jsonschema", text.as_bytes())
            .and_then(|schema| self.writer.add_channel(schema, topic, "json", &BTreeMap::new()));
        added.map_err(|error| unwritable(&self.path, &error))
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

    fn put(&mut self, channel: usize, message: &impl Serialize) -> Result<(), Fault> {
        let data = serde_json::to_vec(message).map_err(|error| unwritable(&self.path, &error))?;
        let header = mcap::records::MessageHeader {
            channel_id: self.channels[channel],
            sequence: self.sequence,
            log_time: self.time,
            publish_time: self.time,
        };
        self.sequence += 1;
        self.writer.write_to_known_channel(&header, &data).map_err(|error| unwritable(&self.path, &error))
    }
}

/// The finished steps of a recording, also of one that broke off.
#[allow(dead_code, reason = "reading back is tested; going on from it is not built yet")]
pub(crate) fn steps(path: &Path) -> Result<Vec<(State, Points)>, Fault> {
    let bytes = std::fs::read(path).map_err(|error| unreadable(path, &error))?;
    let messages = mcap::MessageStream::new_with_options(&bytes, Options::IgnoreEndMagic.into())
        .map_err(|error| unreadable(path, &error))?;
    let mut found = Vec::new();
    let mut profile: Option<Points> = None;
    // The first message that cannot be read is where the recording broke off.
    for message in messages.map_while(Result::ok) {
        match message.channel.topic.as_str() {
            "/contact/profile" => profile = serde_json::from_slice(&message.data).ok(),
            "/state" => {
                let state: Result<State, _> = serde_json::from_slice(&message.data);
                if let (Ok(state), Some(profile)) = (state, profile.take()) {
                    found.push((state, profile));
                }
            }
            _ => {}
        }
    }
    Ok(found)
}

fn unwritable(path: &Path, error: &impl std::fmt::Display) -> Fault {
    let message = format!("cannot write the recording {}: {error}", path.display());
    Fault::new("unwritable", message, "give a folder that can be written, with room on its disk: -o DIR")
}

#[allow(dead_code, reason = "reading back is tested; going on from it is not built yet")]
fn unreadable(path: &Path, error: &impl std::fmt::Display) -> Fault {
    let message = format!("cannot read the recording {}: {error}", path.display());
    Fault::new("unreadable", message, "run the scene again without --resume")
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn state(step: u64) -> State {
        State {
            step,
            time_s: 0.1 * step as f64,
            step_s: 0.1,
            gap_um: vec![0.1 + 0.2, 1.0 / 3.0 * step as f64],
            pressure_MPa: vec![5.0, f64::MIN_POSITIVE],
            ..State::default()
        }
    }

    fn profile() -> Profile {
        let point = wear::SurfacePoint {
            position: nalgebra::Vector3::new(1.0, 0.0, 2.0),
            normal: nalgebra::Vector3::z(),
            weight: 1.0,
            sliding_speed: 1.0,
            drag: nalgebra::Vector3::x(),
        };
        let mut profile = Profile::new(vec![0.5], &[point]);
        profile.pressure[0] = 0.1;
        profile
    }

    fn recorded(folder: &Path, count: u64) -> PathBuf {
        let path = folder.join("run.mcap");
        let mut recorder = Recorder::create(&path, "title = \"x\"\n").unwrap();
        for step in 0..count {
            recorder.iteration(&Iteration { step, pass: 1, residual: Some(1e-3) }).unwrap();
            recorder.log("a step").unwrap();
            recorder.step(&state(step), &profile()).unwrap();
        }
        recorder.finish("{}\n").unwrap();
        path
    }

    #[test]
    fn what_was_recorded_reads_back_to_the_bit() {
        let folder = temp_dir::TempDir::new().unwrap();
        let path = recorded(folder.path(), 20);
        let found = steps(&path).unwrap();
        assert_eq!(found.len(), 20);
        for (step, (read, points)) in found.iter().enumerate() {
            assert_eq!(*read, state(step as u64));
            assert_eq!(points.points[0].pressure_MPa, Some(0.1));
            assert_eq!(points.points[0].gap_um, None, "what is not available is absent");
        }
        let bytes = std::fs::read(&path).unwrap();
        let summary = mcap::Summary::read(&bytes).unwrap().unwrap();
        let names: Vec<String> = summary.attachment_indexes.iter().map(|index| index.name.clone()).collect();
        assert_eq!(names, ["scene.resolved.toml", "summary.json"]);
        let mut topics: Vec<String> = summary.channels.values().map(|channel| channel.topic.clone()).collect();
        topics.sort();
        assert_eq!(topics, ["/contact/profile", "/iteration", "/log", "/state"]);
    }

    #[test]
    fn a_torn_recording_gives_back_every_finished_step() {
        let folder = temp_dir::TempDir::new().unwrap();
        let path = recorded(folder.path(), 30);
        let bytes = std::fs::read(&path).unwrap();
        let mut last = 0;
        for share in [0.3, 0.5, 0.7, 0.9] {
            let torn = folder.path().join("torn.mcap");
            std::fs::write(&torn, &bytes[..(share * bytes.len() as f64) as usize]).unwrap();
            let found = steps(&torn).unwrap();
            assert!(found.len() >= last, "{} after {last}", found.len());
            assert!(found.iter().enumerate().all(|(step, (read, _))| *read == state(step as u64)));
            last = found.len();
        }
        assert!(last >= 15, "only {last} of 30 steps after a cut at 90 %");
    }

    #[test]
    fn the_same_run_gives_the_same_bytes() {
        let (one, two) = (temp_dir::TempDir::new().unwrap(), temp_dir::TempDir::new().unwrap());
        let bytes = |folder: &Path| std::fs::read(recorded(folder, 5)).unwrap();
        assert!(bytes(one.path()) == bytes(two.path()));
    }

    #[test]
    fn rubbish_is_no_recording_and_no_panic() {
        let folder = temp_dir::TempDir::new().unwrap();
        let path = folder.path().join("run.mcap");
        for rubbish in [&b""[..], b"hello", &[0x89, b'M', b'C', b'A', b'P', b'0', b'\r', b'\n', 1, 2, 3]] {
            std::fs::write(&path, rubbish).unwrap();
            assert!(steps(&path).map_or(true, |found| found.is_empty()));
        }
    }
}
