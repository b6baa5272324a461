//! Ctrl-C in sweeps, studies and figures: the program ends with 130 and says how to go on; what is finished is kept.
#![cfg(unix)]

use std::process::Child;
use std::time::{Duration, Instant};

use crate::call::{Bench, press_ctrl_c};

/// Presses Ctrl-C as soon as something is there; returns the exit code and what was said.
fn interrupt_when(mut child: Child, ready: impl Fn() -> bool) -> (Option<i32>, String) {
    let begin = Instant::now();
    while !ready() {
        assert_eq!(child.try_wait().unwrap(), None, "it was over before it could be interrupted");
        assert!(begin.elapsed() < Duration::from_secs(120), "nothing comes");
        std::thread::sleep(Duration::from_micros(200));
    }
    press_ctrl_c(&child);
    let output = child.wait_with_output().unwrap();
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

#[test]
fn a_sweep_keeps_its_finished_rows_and_is_resumed_to_the_same_bytes() {
    let bench = Bench::new();
    let args = "sweep drum-brake-block --set mesh.degree=4 --set check=false --over contact.friction=0:0.3:400 -q";
    assert_eq!(bench.call(&format!("{args} -o whole")).code, 0);
    let rows = || std::fs::read_to_string(bench.path("x.partial/sweep.jsonl")).unwrap_or_default();
    let (code, said) = interrupt_when(bench.start(&format!("{args} -o x")), || !rows().is_empty());
    assert_eq!(code, Some(130), "{said}");
    assert!(said.contains("wearshape sweep drum-brake-block --over contact.friction=0:0.3:400 -o x"), "{said}");
    assert!(said.contains("--resume") && !bench.path("x").exists(), "{said}");
    let kept = rows();
    assert!(kept.ends_with('\n') && (1..400).contains(&kept.lines().count()), "{} rows", kept.lines().count());
    assert!(bench.read("whole/sweep.jsonl").starts_with(&kept), "the finished rows are those of the whole sweep");
    assert_eq!(bench.call(&format!("{args} -o x --resume")).code, 0);
    for name in ["sweep.csv", "sweep.jsonl", "scene.resolved.toml"] {
        assert!(bench.bytes(&format!("x/{name}")) == bench.bytes(&format!("whole/{name}")), "{name} differs");
    }
}

#[test]
fn a_study_ends_without_an_error_and_without_a_folder() {
    let bench = Bench::new();
    // Its first degree alone takes many meshes: the study does not wait for the end of it.
    let child = bench.start("study drum-brake-hot --set tasks=[contact] -o x");
    let (code, said) = interrupt_when(child, || bench.path("x.partial").exists());
    assert_eq!(code, Some(130), "{said}");
    assert!(said.contains("begin it again with: wearshape study drum-brake-hot -o x"), "{said}");
    assert!(!said.contains("error") && !bench.path("x").exists() && !bench.path("x.partial").exists(), "{said}");
}

#[test]
fn a_run_in_time_that_has_no_step_yet_says_to_begin_it_again() {
    let bench = Bench::new();
    let child = bench.start("run punch-wear --set mesh={degree=24,layers=16} -q -o x");
    let (code, said) = interrupt_when(child, || bench.path("x.partial").exists());
    assert_eq!(code, Some(130), "{said}");
    assert!(said.contains("begin it again with: wearshape run punch-wear -o x"), "{said}");
    assert!(!said.contains("is kept") && !said.contains("--resume"), "{said}");
}

#[test]
fn figures_that_are_finished_stay() {
    let bench = Bench::new();
    let child = bench.start("reproduce all -q --threads 2 -o x");
    let (code, said) = interrupt_when(child, || bench.path("x/fig4").exists());
    assert_eq!(code, Some(130), "{said}");
    assert!(said.contains("begin it again with: wearshape reproduce all -o x --threads 2 --quiet\n"), "{said}");
    assert!(!said.contains("error"), "{said}");
    assert!(bench.path("x/fig4/rows.csv").exists() && !bench.path("x/index").exists());
}
