//! Runs in time that break off: killed, interrupted, with a torn recording. Continued they end with the same bytes.

use std::path::Path;
use std::process::{Child, Command};
use std::time::{Duration, Instant};

use crate::call::{Bench, files};

/// The punch on a fixed mesh: levels of degree 4, 6, 8, each with many steps.
const SCENE: &str = "punch-wear --set mesh.degree=8 --set wear.until=1000_s --set contact.shear=false";

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
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
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
    assert!(call.err.contains("goes on after 0 finished levels and step"), "{}", call.err);
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
