//! Recordings are read back to the bit, whole or torn, and copied to the same bytes.
#![allow(clippy::unwrap_used)]

use std::path::{Path, PathBuf};

use shapeopt::{Entering, WearState};
use wearshape::{FinishedLevel, RunLevel};

use super::replay::Replay;
use super::*;

const RESOLVED: &str = "title = \"x\"\n";

/// A state with awkward numbers in every field.
fn state(step: usize) -> WearState {
    let odd = |k: usize| (step as f64 + 0.1) / (k as f64 + 3.0);
    WearState {
        step,
        time: 0.1 * step as f64,
        distance: odd(1),
        gap: vec![0.1 + 0.2, odd(2), -0.0],
        pressure: vec![5.0, f64::MIN_POSITIVE, f64::from_bits(1)],
        opening: vec![-f64::MIN_POSITIVE, odd(3), 1e-300],
        coordinates: vec![odd(4)],
        approach: vec![-odd(5)],
        gap_rate: vec![odd(6), f64::EPSILON, 1e23],
        worn: vec![odd(7); 3],
        conducting: vec![true, false, step.is_multiple_of(2)],
        depth: odd(8),
        recession: odd(9),
        volume: [odd(10), odd(11)],
        steady_residual: odd(12),
        lyapunov: odd(14),
        lyapunov_increase: odd(15),
        step_size: odd(16),
        next_step: f64::MAX,
        error: odd(17),
        rejected: step / 3,
        newton_iterations: 7 * step,
        jumps: step % 3,
        entering: Entering { entered: step.is_multiple_of(2), expected: odd(19), first_step: odd(20) },
        interval: step % 2,
        interval_start: odd(18),
    }
}

fn profile(step: usize) -> Points {
    let point = messages::Point { s: step as f64, pressure: Some(0.1), ..messages::Point::default() };
    Points { step: step as u64, time: 0.1 * step as f64, points: vec![point; 40] }
}

fn levels() -> Vec<FinishedLevel> {
    vec![FinishedLevel { degree: 4, layers: 4, gap: vec![0.1, 1.0 / 3.0], closing: vec![1.0, -1.0], ..Default::default() }]
}

/// Begins the level after the finished ones, of which a resumed run knows some steps already.
fn begin(tape: &mut Tape, mesh: SceneUpdate, known_steps: usize) {
    let finished = levels();
    let level = RunLevel {
        finished: &finished,
        known_steps,
        message: "a level".into(),
        lines: &|| Err(Fault::new("unused", "the mesh is given", "")),
    };
    tape.begin_level(&level, || Ok(mesh)).unwrap();
}

fn add(recorder: &mut Recorder, step: usize) {
    let iteration = Iteration { step: step as u64, tries: 1, ..Iteration::default() };
    recorder.step(&iteration, &profile(step), &State::from(&state(step))).unwrap();
}

/// A recording of some steps, ended or not.
fn recorded(folder: &Path, steps: usize) -> PathBuf {
    let (mut tape, word) = Tape::new(&folder.join(RUN_MCAP), RESOLVED, false).unwrap();
    assert_eq!(word, None);
    let mesh = SceneUpdate::new(&[vec![[0.0, 0.0], [1.0, 0.0]], vec![[0.0, 0.0], [0.0, -1.0]]]);
    assert_eq!(tape.resume(), None);
    begin(&mut tape, mesh, 0);
    (0..steps).for_each(|step| add(tape.recorder().unwrap().unwrap(), step));
    tape.finish("done", "{}\n").unwrap();
    folder.join(RUN_MCAP)
}

fn states(replay: &Replay) -> Vec<WearState> {
    replay.states.iter().cloned().map(WearState::from).collect()
}

#[test]
fn what_was_recorded_reads_back_to_the_bit() {
    let folder = temp_dir::TempDir::new().unwrap();
    let bytes = std::fs::read(recorded(folder.path(), 20)).unwrap();
    let replay = Replay::read(&bytes);
    assert_eq!(states(&replay), (0..20).map(state).collect::<Vec<_>>());
    assert_eq!(state(3).gap[2].to_bits(), states(&replay)[3].gap[2].to_bits(), "the sign of zero");
    assert_eq!(replay.levels(), levels());
    assert_eq!(replay.unfit(RESOLVED), None);
    assert!(replay.unfit("title = \"y\"\n").is_some());
    let summary = mcap::Summary::read(&bytes).unwrap().unwrap();
    let names: Vec<String> = summary.attachment_indexes.iter().map(|index| index.name.clone()).collect();
    assert_eq!(names, [SCENE_ATTACHED, LEVELS_ATTACHED, SUMMARY_ATTACHED]);
    let mut topics: Vec<String> = summary.channels.values().map(|channel| channel.topic.clone()).collect();
    topics.sort();
    assert_eq!(topics, [PROFILE, ITERATION, LOG, MESH, STATE]);
    let times: Vec<u64> = mcap::MessageStream::new(&bytes).unwrap().map(|message| message.unwrap().log_time).collect();
    assert!(times.is_sorted() && times.last() == Some(&1_900_000_000), "log_time is simulated time: {times:?}");
}

#[test]
fn a_recording_cut_anywhere_gives_back_every_step_that_was_flushed() {
    let folder = temp_dir::TempDir::new().unwrap();
    let (mut tape, _) = Tape::new(&folder.path().join(RUN_MCAP), RESOLVED, false).unwrap();
    begin(&mut tape, SceneUpdate::default(), 0);
    let mut lengths = Vec::new();
    for step in 0..8 {
        add(tape.recorder().unwrap().unwrap(), step);
        // What another process sees if this one is killed now.
        lengths.push(std::fs::metadata(folder.path().join(RUN_MCAP)).unwrap().len() as usize);
    }
    tape.finish("done", "{}\n").unwrap();
    let bytes = std::fs::read(folder.path().join(RUN_MCAP)).unwrap();
    for cut in (0..bytes.len()).step_by(5).chain(lengths.iter().flat_map(|length| [length - 1, *length])) {
        let complete = lengths.iter().filter(|length| **length <= cut).count();
        let found = Replay::read(&bytes[..cut]).states.len();
        assert!(found >= complete && found <= complete + 1, "cut at {cut}: {found} of {complete} steps");
    }
}

#[test]
fn a_torn_recording_goes_on_to_the_same_bytes() {
    let (whole, torn) = (temp_dir::TempDir::new().unwrap(), temp_dir::TempDir::new().unwrap());
    let bytes = std::fs::read(recorded(whole.path(), 12)).unwrap();
    for cut in (0..bytes.len()).step_by(bytes.len() / 40) {
        std::fs::write(torn.path().join(RUN_MCAP), &bytes[..cut]).unwrap();
        let (mut tape, word) = Tape::new(&torn.path().join(RUN_MCAP), RESOLVED, true).unwrap();
        assert!(word.is_some());
        let mesh = SceneUpdate::new(&[vec![[0.0, 0.0], [1.0, 0.0]], vec![[0.0, 0.0], [0.0, -1.0]]]);
        let known = tape.resume().map_or(0, |resume| resume.states.len());
        begin(&mut tape, mesh, known);
        (known..12).for_each(|step| add(tape.recorder().unwrap().unwrap(), step));
        tape.finish("done", "{}\n").unwrap();
        assert!(std::fs::read(torn.path().join(RUN_MCAP)).unwrap() == bytes, "cut at {cut}, {} steps known", known);
    }
}

#[test]
fn a_run_without_a_finished_step_has_nothing_to_go_on_from() {
    let folder = temp_dir::TempDir::new().unwrap();
    let (mut tape, _) = Tape::new(&folder.path().join(RUN_MCAP), RESOLVED, false).unwrap();
    assert!(!tape.holds_steps());
    let lines = || Err(Fault::new("unused", "the mesh is given", ""));
    let level = RunLevel { finished: &[], known_steps: 0, message: "a level".into(), lines: &lines };
    tape.begin_level(&level, || Ok(SceneUpdate::default())).unwrap();
    assert!(!tape.holds_steps());
    tape.step(Iteration::default(), profile(0), State::from(&state(0))).unwrap();
    assert!(tape.holds_steps());
    // A level that begins after a finished one, and recordings with either.
    begin(&mut tape, SceneUpdate::default(), 0);
    assert!(tape.holds_steps());
    for steps in [0, 3] {
        let (tape, _) = Tape::new(&recorded(folder.path(), steps), RESOLVED, true).unwrap();
        assert!(tape.holds_steps(), "{steps}");
    }
}

#[test]
fn a_damaged_recording_is_read_up_to_the_damage() {
    let folder = temp_dir::TempDir::new().unwrap();
    let bytes = std::fs::read(recorded(folder.path(), 6)).unwrap();
    let right: Vec<WearState> = (0..6).map(state).collect();
    for place in (0..bytes.len()).step_by(7) {
        let mut damaged = bytes.clone();
        damaged[place] ^= 0x55;
        let found = Replay::read(&damaged);
        if found.unfit(RESOLVED).is_none() {
            let found = states(&found);
            assert_eq!(found, right[..found.len()], "damage at {place}");
        }
    }
    for rubbish in [&b""[..], b"hello", &[0x89, b'M', b'C', b'A', b'P', b'0', b'\r', b'\n', 1, 2, 3]] {
        assert!(Replay::read(rubbish).unfit(RESOLVED).is_some());
    }
}

#[test]
fn a_recording_that_unpacks_beyond_measure_is_read_in_part() {
    let folder = temp_dir::TempDir::new().unwrap();
    let (mut tape, _) = Tape::new(&folder.path().join(RUN_MCAP), RESOLVED, false).unwrap();
    begin(&mut tape, SceneUpdate::default(), 0);
    let blank = vec![b' '; 1 << 20];
    for step in 0..200 {
        tape.recorder().unwrap().unwrap().put_bytes(LOG, 0, &blank).unwrap();
        add(tape.recorder().unwrap().unwrap(), step);
    }
    tape.finish("done", "{}\n").unwrap();
    let bytes = std::fs::read(folder.path().join(RUN_MCAP)).unwrap();
    assert!(bytes.len() < 1 << 20);
    let read = Replay::read(&bytes).states.len();
    assert!((60..120).contains(&read), "{read} steps of 1 MB each");
}
