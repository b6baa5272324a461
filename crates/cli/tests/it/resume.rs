//! Runs in time that break off: killed, interrupted, with a torn recording. Continued they end with the same bytes.

use std::path::Path;
use std::process::Child;
use std::time::{Duration, Instant};

use crate::call::{Bench, files};

/// The punch on a fixed mesh: levels of degree 8, 10, 12, each with many steps, so that each takes longer than steps wait to be written.
const SCENE: &str = "punch-wear --set mesh.degree=12 --set accuracy=1e-8 --set wear.until=1000_s --set contact.shear=false";

/// Waits until the recording of a run holds that many bytes more than before; `false` if the run ended first.
fn grown(child: &mut Child, recording: &Path, bytes: u64) -> bool {
    let length = || std::fs::metadata(recording).map_or(0, |data| data.len());
    let (begin, first) = (Instant::now(), length());
    while length() < first + bytes {
        if child.try_wait().unwrap().is_some() {
            return false;
        }
        assert!(begin.elapsed() < Duration::from_secs(120), "the recording does not grow");
        std::thread::sleep(Duration::from_micros(200));
    }
    true
}

fn assert_same(bench: &Bench, one: &str, other: &str, what: &str) {
    let names = files(&bench.path(one));
    assert_eq!(files(&bench.path(other)), names, "{what}");
    for name in ["summary.json", "contact.csv", "history.csv", "run.mcap"] {
        assert!(names.iter().any(|file| file == name), "{name} is not there");
    }
    for name in names.iter().filter(|name| *name != "timing.json") {
        assert!(bench.bytes(&format!("{one}/{name}")) == bench.bytes(&format!("{other}/{name}")), "{what}: {name} differs");
    }
}

#[test]
fn a_killed_run_is_continued_to_the_same_bytes() {
    let bench = Bench::new();
    assert_eq!(bench.call(&format!("run {SCENE} -q -o whole")).code, 0);
    // Killed twice: in its first levels, and some steps after it was continued.
    let recording = bench.path("x.partial/run.mcap");
    for (flag, bytes) in [("", 120_000), ("--resume", 30_000)] {
        let mut child = bench.start(&format!("run {SCENE} -q -o x {flag}"));
        assert!(grown(&mut child, &recording, bytes), "the run was over before it could be killed");
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(!bench.path("x").exists() && recording.exists());
    }
    let call = bench.call(&format!("run {SCENE} -o x --resume"));
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(call.err.contains("goes on after"), "{}", call.err);
    assert_same(&bench, "whole", "x", "killed");
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_with_130_and_a_run_that_can_be_continued() {
    let bench = Bench::new();
    assert_eq!(bench.call(&format!("run {SCENE} -q -o whole")).code, 0);
    let mut child = bench.start(&format!("run {SCENE} -o x"));
    assert!(grown(&mut child, &bench.path("x.partial/run.mcap"), 60_000), "the run was over before it could be interrupted");
    crate::call::press_ctrl_c(&child);
    let output = child.wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(130), "{said}");
    assert!(said.contains("wearshape run punch-wear -o x") && said.contains("--resume"), "{said}");
    assert!(!bench.path("x").exists());
    let call = bench.call(&format!("run {SCENE} -o x --resume"));
    assert_eq!(call.code, 0, "{}", call.err);
    assert_same(&bench, "whole", "x", "interrupted");
}

#[test]
fn a_torn_or_damaged_recording_is_continued_as_far_as_it_goes() {
    let bench = Bench::new();
    let scene = "punch-wear --set mesh={degree=4,layers=2} --set wear.until=100_s";
    assert_eq!(bench.call(&format!("run {scene} -q -o whole")).code, 0);
    let bytes = bench.bytes("whole/run.mcap");
    let part = |share: f64| bytes[..(share * bytes.len() as f64) as usize].to_vec();
    let mut flipped = bytes.clone();
    flipped[bytes.len() / 2] ^= 0xff;
    let torn = [
        ("empty", Vec::new(), "begins at its start"),
        ("magic", bytes[..8].to_vec(), "begins at its start"),
        ("rubbish", b"no recording at all".to_vec(), "begins at its start"),
        ("a tenth", part(0.1), ""),
        ("a third", part(0.33), "goes on after"),
        ("most", part(0.9), "goes on after"),
        ("all but a byte", bytes[..bytes.len() - 1].to_vec(), "goes on after"),
        ("all", bytes.clone(), "goes on after"),
        ("a wrong byte in the middle", flipped, "goes on after"),
    ];
    for (what, recording, said) in torn {
        std::fs::create_dir(bench.path("x.partial")).unwrap();
        std::fs::copy(bench.path("whole/scene.resolved.toml"), bench.path("x.partial/scene.resolved.toml")).unwrap();
        std::fs::write(bench.path("x.partial/run.mcap"), recording).unwrap();
        let call = bench.call(&format!("run {scene} -o x --resume"));
        assert_eq!(call.code, 0, "{what}: {}", call.err);
        assert!(call.err.contains(said), "{what}: {}", call.err);
        assert_same(&bench, "whole", "x", what);
    }
}

#[cfg(unix)]
#[test]
fn a_full_disk_loses_no_finished_step() {
    let bench = Bench::new();
    let scene = "run punch-wear -q --set mesh={degree=4,layers=2} --set wear.until=100_s";
    assert_eq!(bench.call(&format!("{scene} -o whole")).code, 0);
    // A file size limit stands for the full disk: writing fails in the same way.
    let call = bench
        .shell(&format!("trap '' XFSZ; ulimit -f 120; exec \"$0\" {} -o x", scene.replace("100_s", "100").replace('_', " ")));
    assert_eq!(call.code, 2, "{}", call.err);
    assert!(call.err.contains("cannot write the recording") && call.err.contains("--resume"), "{}", call.err);
    let call = bench.call(&format!("{scene} -o x --resume").replace(" -q", ""));
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(call.err.contains("goes on after") && call.err.contains("finished levels and step"), "{}", call.err);
    assert_same(&bench, "whole", "x", "full disk");
}

#[test]
fn another_scene_is_not_continued() {
    let bench = Bench::new();
    bench.file("x.partial/scene.resolved.toml", "title = \"something else\"\n");
    let call = bench.call("run punch-wear -o x --resume");
    assert_eq!(call.code, 2, "{}", call.err);
    assert!(call.err.contains("another scene") && call.err.contains("leave out --resume"), "{}", call.err);
    assert_eq!(bench.read("x.partial/scene.resolved.toml"), "title = \"something else\"\n");
    bench.file("y.partial/letter.txt", "precious");
    assert_eq!(bench.call("run punch-wear -o y --resume").code, 2, "a folder of somebody else");
}

#[test]
fn shape_and_wear_have_the_same_bytes_with_one_thread_and_two() {
    let bench = Bench::new();
    for scene in ["drum-brake-block --set accuracy=1e-3", "punch-wear --set mesh.degree=6"] {
        for threads in [1, 2] {
            let call = bench.call(&format!("run {scene} -q --threads {threads} -o t{threads}"));
            assert_eq!(call.code, 0, "{scene}: {}", call.err);
        }
        let names = files(&bench.path("t1"));
        assert_eq!(files(&bench.path("t2")), names);
        for name in names.iter().filter(|name| *name != "timing.json") {
            assert!(bench.bytes(&format!("t1/{name}")) == bench.bytes(&format!("t2/{name}")), "{scene}: {name} differs");
        }
    }
}

#[test]
fn a_recording_of_another_version_is_not_written_over() {
    let bench = Bench::new();
    let scene = "run punch-wear --set mesh={degree=4,layers=2} --set wear.until=20_s -q";
    assert_eq!(bench.call(&format!("{scene} -o whole")).code, 0);
    let mut bytes = bench.bytes("whole/run.mcap");
    let version = concat!("wearshape ", env!("CARGO_PKG_VERSION")).as_bytes();
    let at = bytes.windows(version.len()).position(|window| window == version).unwrap() + version.len() - 1;
    bytes[at] ^= 1;
    std::fs::create_dir(bench.path("x.partial")).unwrap();
    std::fs::copy(bench.path("whole/scene.resolved.toml"), bench.path("x.partial/scene.resolved.toml")).unwrap();
    std::fs::write(bench.path("x.partial/run.mcap"), &bytes).unwrap();
    let call = bench.call(&format!("{scene} -o x --resume"));
    assert!(call.code == 2 && call.err.contains("finished steps") && call.err.contains("was written by"), "{}", call.err);
    assert!(bench.bytes("x.partial/run.mcap") == bytes && !bench.path("x").exists());
}

/// A recording with its attached levels, or the data of its last state, written anew, with right checksums.
fn crafted(bench: &Bench, levels: &str, last_state: Option<&str>) -> Vec<u8> {
    let bytes = bench.bytes("whole/run.mcap");
    let library = concat!("wearshape ", env!("CARGO_PKG_VERSION"));
    let mut out = std::io::Cursor::new(Vec::new());
    let mut writer = mcap::WriteOptions::new().profile("wearshape").library(library).create(&mut out).unwrap();
    for (name, text) in [("scene.resolved.toml", bench.read("whole/scene.resolved.toml")), ("levels.json", levels.into())] {
        let data = std::borrow::Cow::Owned(text.into_bytes());
        let attachment =
            mcap::Attachment { log_time: 0, create_time: 0, name: name.into(), media_type: "application/json".into(), data };
        writer.attach(&attachment).unwrap();
    }
    let messages: Vec<mcap::Message<'_>> = mcap::MessageStream::new(&bytes).unwrap().map(Result::unwrap).collect();
    let last = messages.iter().rposition(|message| message.channel.topic == "/state").unwrap();
    for (number, mut message) in messages.into_iter().enumerate().take(last + 1) {
        if let Some(text) = last_state.filter(|_| number == last) {
            message.data = std::borrow::Cow::Owned(text.as_bytes().to_vec());
        }
        writer.write(&message).unwrap();
    }
    writer.finish().unwrap();
    drop(writer);
    out.into_inner()
}

/// The levels that are attached to the recording, and the data of its last state.
fn recorded(bench: &Bench) -> [String; 2] {
    let bytes = bench.bytes("whole/run.mcap");
    let summary = mcap::Summary::read(&bytes).unwrap().unwrap();
    let levels = summary.attachment_indexes.iter().find(|index| index.name == "levels.json").unwrap();
    let levels = mcap::read::attachment(&bytes, levels).unwrap().data.into_owned();
    let messages = mcap::MessageStream::new(&bytes).unwrap().map(Result::unwrap);
    let state = messages.filter(|message| message.channel.topic == "/state").last().unwrap().data.into_owned();
    [levels, state].map(|data| String::from_utf8(data).unwrap())
}

const SHORT: &str = "punch-wear --set mesh={degree=6,layers=2} --set wear.until=1_s";

fn resumed(bench: &Bench, recording: &[u8]) -> crate::call::Call {
    let _ = std::fs::remove_dir_all(bench.path("x.partial"));
    let _ = std::fs::remove_dir_all(bench.path("x"));
    std::fs::create_dir(bench.path("x.partial")).unwrap();
    std::fs::copy(bench.path("whole/scene.resolved.toml"), bench.path("x.partial/scene.resolved.toml")).unwrap();
    std::fs::write(bench.path("x.partial/run.mcap"), recording).unwrap();
    bench.call(&format!("run {SHORT} -o x --resume --threads 1"))
}

/// Of the list of numbers that follows a key, the place of its first comma.
fn first_comma(text: &str, key: &str) -> usize {
    let start = text.find(key).unwrap();
    start + text[start..].find(',').unwrap()
}

#[test]
fn a_recording_whose_lists_are_of_other_lengths_is_refused_by_name() {
    let bench = Bench::new();
    assert_eq!(bench.call(&format!("run {SHORT} -q -o whole")).code, 0);
    let [levels, state] = recorded(&bench);
    assert_eq!(resumed(&bench, &crafted(&bench, &levels, None)).code, 0, "what was recorded goes on");
    let longer = |text: &str, key: &str| {
        let place = first_comma(text, key);
        format!("{},0.5{}", &text[..place], &text[place..])
    };
    let mut wrong = vec![
        (levels.replace("\"degree\":4", "\"degree\":5"), None),
        (levels.replace("\"closing\":[", "\"closing\":[1e300,"), None),
        (longer(&levels, "\"gap_mm\":["), None),
        ("[{}]".into(), None),
    ];
    for key in ["gap_mm", "pressure_MPa", "opening_mm", "gap_rate_mm_per_s", "worn_mm"] {
        wrong.push((levels.clone(), Some(longer(&state, &format!("\"{key}\":[")))));
    }
    wrong.push((levels.clone(), Some(state.replace("\"coordinates\":[", "\"coordinates\":[0.5,"))));
    wrong.push((levels.clone(), Some(state.replace("\"piece\":0", "\"piece\":7"))));
    for (number, (levels, state)) in wrong.iter().enumerate() {
        let call = resumed(&bench, &crafted(&bench, levels, state.as_deref()));
        assert_eq!(call.code, 2, "number {number}: {}{}", call.out, call.err);
        assert!(
            call.err.contains("does not belong to this run") || call.err.contains("cannot be continued"),
            "number {number}: {}",
            call.err
        );
    }
}

#[test]
fn no_mutation_of_the_recorded_levels_makes_a_panic() {
    let bench = Bench::new();
    assert_eq!(bench.call(&format!("run {SHORT} -q -o whole")).code, 0);
    let [levels, state] = recorded(&bench);
    let mut seed: u64 = 7;
    let mut random = |below: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize % below
    };
    let mut codes = [0; 3];
    for number in 0..300 {
        let mut text = if number % 3 == 2 { state.clone() } else { levels.clone() };
        match random(5) {
            0 => text.truncate(random(text.len())),
            1 => {
                let place = random(text.len());
                text.replace_range(place..=place, ["9", "-", ",", "e", "[", "0"][random(6)]);
            }
            // A number more or less, or another one, in one of the lists.
            kind => {
                let commas: Vec<usize> = text.match_indices(',').map(|(place, _)| place).collect();
                let from = random(commas.len() - 1);
                let more = ["", ",0", ",1e300", ",-5e-324"][kind - 2 + random(2)];
                text.replace_range(commas[from]..commas[from + usize::from(kind < 4)], more);
            }
        }
        let recording = if number % 3 == 2 { crafted(&bench, &levels, Some(&text)) } else { crafted(&bench, &text, None) };
        let call = resumed(&bench, &recording);
        assert!((0..=2).contains(&call.code), "mutation {number}: exit {}: {}", call.code, call.err);
        codes[call.code as usize] += 1;
    }
    assert!(codes[0] > 0 && codes[2] > 100, "{codes:?}");
}

/// A punch whose load turns at 7 s: the level of degree 14 finds no pressure there.
const TURNED: &str = r#"
title = "A punch whose load turns"
units = "N-mm"
kinematics = "plane-strain"
thickness = 6
tasks = ["wear"]
body1.material = { young = 5000, poisson = 0.35 }
body1.geometry.rectangle = { x = [-20, 25], z = [50, 90] }
body1.support = { top = ["x"] }
body2.material = { young = 80000, poisson = 0.25 }
body2.geometry.rectangle = { x = [-60, 70], z = [0, 50] }
body2.support = { bottom = ["x", "z"] }
contact = { edges = ["bottom", "top"], friction = 0.5, gap = 0 }
sliding = { speed = 5 }
load = { edge = "top", as = "rigid", force = 900, moment = 700, about = [2.5, 50] }
wear = { k = [4e-7, 0], a = 1, b = 3, until = 60 }
schedule = { time = [0, 7, 30], force = [1, 0.4, 1.5], moment = [1, -2, 1], speed = [1, -2, 0.5] }
"#;

#[test]
fn a_finer_level_without_an_end_loses_neither_the_answer_nor_the_bytes_of_a_continued_run() {
    let bench = Bench::new();
    bench.file("turned.toml", TURNED);
    let call = bench.call("run turned.toml -o whole");
    assert_eq!(call.code, 1, "{}{}", call.out, call.err);
    let summary: serde_json::Value = serde_json::from_str(&bench.read("whole/summary.json")).unwrap();
    assert_eq!(summary["status"], "accuracy-missed", "{}", call.out);
    assert_eq!(summary["wear"]["time_s"], 60.0);
    let error = summary["error"]["gap_relative"].as_f64().unwrap();
    assert!((1e-6..3e-4).contains(&error), "{error:e}");
    // Asked for what is reached, it is the answer.
    let call = bench.call("run turned.toml -o less --set accuracy=5e-4");
    assert_eq!(call.code, 0, "{}{}", call.out, call.err);
    let less: serde_json::Value = serde_json::from_str(&bench.read("less/summary.json")).unwrap();
    let depth = |summary: &serde_json::Value| summary["wear"]["depth_um"].as_f64().unwrap();
    assert!((depth(&less) / depth(&summary) - 1.0).abs() < 2e-4, "{} {}", depth(&less), depth(&summary));
    // The recording is one of the level that is reported, and goes on from there.
    let bytes = bench.bytes("whole/run.mcap");
    for share in [0.5, 0.97] {
        let _ = std::fs::remove_dir_all(bench.path("x"));
        std::fs::create_dir(bench.path("x.partial")).unwrap();
        std::fs::copy(bench.path("whole/scene.resolved.toml"), bench.path("x.partial/scene.resolved.toml")).unwrap();
        std::fs::write(bench.path("x.partial/run.mcap"), &bytes[..(share * bytes.len() as f64) as usize]).unwrap();
        let call = bench.call("run turned.toml -o x --resume");
        assert_eq!(call.code, 1, "{}", call.err);
        assert!(call.err.contains("goes on after 4 finished levels and step"), "{}", call.err);
        assert_same(&bench, "whole", "x", "continued");
    }
}
