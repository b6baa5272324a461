//! Reading a recording back, also one that broke off: the finished levels, and the messages of every finished step.

use mcap::parse_record;
use mcap::records::Record;
use mcap::sans_io::{LinearReadEvent, LinearReader, LinearReaderOptions};
use scene::Fault;
use wearshape::{FinishedLevel, RunningIn, RunningInStep};

use crate::record::messages::{Point, Points};
use crate::record::state::State;
use crate::record::texts::texts_fit;
use crate::record::{CHANNELS, LEVELS_ATTACHED, LIBRARY, PROFILE, Recorder, SCENE_ATTACHED, STATE};

/// No step of ours is nearly as large (bytes): a longer record or chunk is damage.
const LARGEST: usize = 1 << 26;
/// What is unpacked of a recording at most: this many bytes, and so many for each byte of the file. Digits of ours are packed to no less than a
/// twentieth: beyond that a recording is damaged too.
const UNPACKED: [usize; 2] = [LARGEST, 50];

/// What a record takes beside its bytes.
const RECORD: usize = 64;

/// What a recording still holds.
#[derive(Debug, Default)]
pub(crate) struct Replay {
    /// Who wrote it.
    library: String,
    /// The attached scene.
    scene: String,
    /// The levels that were finished before the recorded one, if they can be read.
    levels: Option<Vec<FinishedLevel>>,
    /// Messages up to the last finished step.
    messages: Vec<Message>,
    /// States of the finished steps.
    pub(crate) states: Vec<State>,
}

#[derive(Debug)]
struct Message {
    topic: &'static str,
    time: u64,
    data: Vec<u8>,
}

impl Replay {
    /// Reads what can be read: the first record that is damaged or cut off is where the recording ends.
    pub(crate) fn read(bytes: &[u8]) -> Replay {
        let mut replay = Replay::default();
        let mut topics: Vec<(u16, &'static str)> = Vec::new();
        let mut finished = 0;
        let mut records = Records::new(bytes);
        while let Some(record) = records.next() {
            match record {
                Record::Header(header) => replay.library = header.library,
                Record::Attachment { header, data, .. } => match header.name.as_str() {
                    SCENE_ATTACHED => replay.scene = String::from_utf8_lossy(&data).into_owned(),
                    LEVELS_ATTACHED => replay.levels = serde_json::from_slice(&data).ok(),
                    _ => {}
                },
                Record::Channel(channel) => {
                    topics.extend(CHANNELS.iter().filter(|known| **known == channel.topic).map(|known| (channel.id, *known)));
                }
                Record::Message { header, data } => {
                    let Some((_, topic)) = topics.iter().find(|(id, _)| *id == header.channel_id) else { break };
                    if *topic == STATE {
                        let Ok(state) = serde_json::from_slice::<State>(&data) else { break };
                        // A chunk whose first byte is damaged is passed over.
                        if state.step != replay.states.len() as u64 {
                            break;
                        }
                        replay.states.push(state);
                        finished = replay.messages.len() + 1;
                    }
                    replay.messages.push(Message { topic, time: header.log_time, data: data.into_owned() });
                }
                // What follows is the summary.
                Record::DataEnd(_) => break,
                _ => {}
            }
        }
        replay.messages.truncate(finished);
        replay
    }

    /// Pressure and gap at each finished step.
    pub(crate) fn running_in(&self) -> RunningIn {
        let profiles = self.messages.iter().filter(|message| message.topic == PROFILE);
        let profiles: Vec<Points> = profiles.filter_map(|message| serde_json::from_slice(&message.data).ok()).collect();
        let s = profiles.last().map(|last| last.points.iter().map(|point| point.s).collect()).unwrap_or_default();
        let column = |points: &Points, pick: fn(&Point) -> Option<f64>| -> Vec<f64> {
            points.points.iter().map(|point| pick(point).unwrap_or(f64::NAN)).collect()
        };
        let step = |points: &Points| RunningInStep {
            step: points.step as usize,
            time: points.time,
            pressure: column(points, |point| point.pressure),
            gap: column(points, |point| point.gap),
        };
        RunningIn { s, steps: profiles.iter().map(step).collect() }
    }

    /// The levels that were finished before the recorded one.
    pub(crate) fn levels(&self) -> &[FinishedLevel] {
        self.levels.as_deref().unwrap_or_default()
    }

    /// Why a run of a scene cannot go on from here, if it cannot.
    pub(crate) fn unfit(&self, resolved: &str) -> Option<String> {
        if self.library.is_empty() {
            return Some("it is empty or damaged".into());
        }
        if self.library != LIBRARY {
            return Some(format!("it was written by {}, and this is {LIBRARY}", self.library));
        }
        let whole = self.scene == resolved && self.levels.is_some();
        (!whole).then(|| "it is cut off at its beginning, or of another scene".into())
    }

    /// Records everything again, as it was recorded.
    pub(crate) fn copy_to(&self, recorder: &mut Recorder) -> Result<(), Fault> {
        for message in &self.messages {
            recorder.put_bytes(message.topic, message.time, &message.data)?;
        }
        Ok(())
    }
}

/// The records of a file one after another, those inside of chunks too, until the first that is damaged or cut off.
struct Records<'a> {
    rest: &'a [u8],
    reader: LinearReader,
    /// Bytes that may still be unpacked.
    room: usize,
}

impl<'a> Records<'a> {
    fn new(bytes: &'a [u8]) -> Records<'a> {
        let options = LinearReaderOptions::default()
            .with_skip_end_magic(true)
            .with_prevalidate_chunk_crcs(true)
            .with_record_length_limit(LARGEST);
        let room = UNPACKED[0].saturating_add(UNPACKED[1].saturating_mul(bytes.len()));
        Records { rest: bytes, reader: LinearReader::new_with_options(options), room }
    }

    fn next(&mut self) -> Option<Record<'static>> {
        loop {
            match self.reader.next_event()? {
                Ok(LinearReadEvent::ReadRequest(need)) => {
                    let (now, rest) = self.rest.split_at(need.min(self.rest.len()));
                    self.reader.insert(now.len()).copy_from_slice(now);
                    self.reader.notify_read(now.len());
                    self.rest = rest;
                }
                Ok(LinearReadEvent::Record { data, opcode }) => {
                    self.room = self.room.checked_sub(data.len() + RECORD)?;
                    match texts_fit(opcode, data) {
                        Some(true) => return parse_record(opcode, data).ok().map(Record::into_owned),
                        Some(false) => return None,
                        None => {}
                    }
                }
                Err(_) => return None,
            }
        }
    }
}
