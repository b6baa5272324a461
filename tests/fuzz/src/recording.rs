//! Recordings: what is in them is changed, and then packed again with right checksums. Each is reported on, and gone on with.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};

use crate::random::Random;
use crate::targets::Outcome;

/// A run in time of few steps.
const SCENE: [&str; 10] =
    ["punch-wear", "--set", "mesh.degree=4", "--set", "mesh.layers=2", "--set", "accuracy=1e-2", "--set", "wear.until=20", "-q"];

/// The parts of a recording.
struct Parts {
    library: String,
    attachments: Vec<[String; 2]>,
    messages: Vec<Message>,
}

#[derive(Clone)]
struct Message {
    topic: String,
    time: u64,
    data: Vec<u8>,
}

/// A run that was recorded, to be broken in many ways.
pub(crate) struct Recordings {
    folder: PathBuf,
    whole: Vec<u8>,
    parts: Parts,
}

impl Recordings {
    /// Runs the scene once.
    pub(crate) fn new(folder: &Path) -> Result<Recordings, String> {
        let sound = folder.join("sound");
        if cli::run(call(&["run"], &["--no-progress", "-o", &sound.display().to_string()])) != cli::Exit::Done {
            return Err("the scene of the recordings cannot be run".into());
        }
        let path = sound.join("run.mcap");
        let whole = fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let parts = parts(&whole).map_err(|error| format!("{}: {error}", path.display()))?;
        Ok(Recordings { folder: folder.to_path_buf(), whole, parts })
    }

    /// The sound recording.
    pub(crate) fn whole(&self) -> &[u8] {
        &self.whole
    }

    /// A recording with changed parts and right checksums.
    pub(crate) fn rebuilt(&self, random: &mut Random, mutated: fn(&[Vec<u8>], &mut Random) -> Vec<u8>) -> Vec<u8> {
        let mut attachments = self.parts.attachments.clone();
        // Cut off somewhere, as by a kill.
        let kept = self.parts.messages.len() - random.below(self.parts.messages.len());
        let mut messages = self.parts.messages[..kept].to_vec();
        for _ in 0..=random.below(2) {
            match random.below(8) {
                0..=2 => {
                    let [_, text] = &mut attachments[random.below(2)];
                    *text = String::from_utf8_lossy(&mutated(&[text.clone().into_bytes()], random)).into_owned();
                }
                3 => {
                    let (from, to) = (random.below(messages.len()), random.below(messages.len()));
                    messages[to].data = messages[from].data.clone();
                }
                4 => drop(messages.remove(random.below(messages.len().saturating_sub(1)))),
                _ => {
                    let at = random.below(messages.len());
                    let other = random.one_of(&self.parts.messages).data.clone();
                    messages[at].data = mutated(&[messages[at].data.clone(), other], random);
                }
            }
            if messages.is_empty() {
                break;
            }
        }
        packed(&Parts { library: self.parts.library.clone(), attachments, messages }).unwrap_or_default()
    }

    /// Builds the page of a folder with the recording, and goes on with a run from it.
    pub(crate) fn give(&self, input: &[u8]) -> Result<Outcome, String> {
        let failed = |error: std::io::Error| error.to_string();
        let sound = self.folder.join("sound");
        fs::write(sound.join("run.mcap"), input).map_err(failed)?;
        cli::run(["fuzz", "report", &sound.display().to_string()]);
        let (whole, partial) = (self.folder.join("resumed"), self.folder.join("resumed.partial"));
        for folder in [&whole, &partial] {
            let _ = fs::remove_dir_all(folder);
        }
        fs::create_dir_all(&partial).map_err(failed)?;
        fs::write(partial.join("run.mcap"), input).map_err(failed)?;
        let mark = "scene.resolved.toml";
        fs::copy(sound.join(mark), partial.join(mark)).map_err(failed)?;
        let exit = cli::run(call(&["run"], &["--no-progress", "--resume", "-o", &whole.display().to_string()]));
        if exit == cli::Exit::Interrupted {
            return Err("a run that nobody interrupted says that it was".into());
        }
        Ok(if exit == cli::Exit::Wrong { Outcome::Refused } else { Outcome::Accepted })
    }
}

fn call(before: &[&str], after: &[&str]) -> Vec<String> {
    ["fuzz"].iter().chain(before).chain(&SCENE).chain(after).map(ToString::to_string).collect()
}

/// What is in a recording.
fn parts(bytes: &[u8]) -> Result<Parts, mcap::McapError> {
    let mut attachments = Vec::new();
    let mut library = String::new();
    for record in mcap::read::LinearReader::new(bytes)? {
        match record? {
            mcap::records::Record::Header(header) => library = header.library,
            mcap::records::Record::Attachment { header, data, .. } => {
                attachments.push([header.name, String::from_utf8_lossy(&data).into_owned()]);
            }
            _ => {}
        }
    }
    let mut messages = Vec::new();
    for message in mcap::MessageStream::new(bytes)? {
        let message = message?;
        messages.push(Message { topic: message.channel.topic.clone(), time: message.log_time, data: message.data.into_owned() });
    }
    Ok(Parts { library, attachments, messages })
}

/// A recording of some parts.
fn packed(parts: &Parts) -> Result<Vec<u8>, mcap::McapError> {
    let mut bytes = Cursor::new(Vec::new());
    let options = mcap::WriteOptions::new().profile("wearshape").library(parts.library.clone()).compression(None);
    let mut writer = options.create(&mut bytes)?;
    for [name, text] in &parts.attachments {
        let data = Cow::Borrowed(text.as_bytes());
        writer.attach(&mcap::Attachment {
            log_time: 0,
            create_time: 0,
            name: name.clone(),
            media_type: "text/plain".into(),
            data,
        })?;
    }
    let mut channels = BTreeMap::new();
    for Message { topic, time, data } in &parts.messages {
        let channel_id = match channels.get(topic) {
            Some(id) => *id,
            None => writer.add_channel(0, topic, "json", &BTreeMap::new())?,
        };
        channels.insert(topic, channel_id);
        let header = mcap::records::MessageHeader { channel_id, sequence: 0, log_time: *time, publish_time: *time };
        writer.write_to_known_channel(&header, data)?;
    }
    writer.finish()?;
    drop(writer);
    Ok(bytes.into_inner())
}
