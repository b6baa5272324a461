//! Streams that are full, closed or no longer read; signals. Nothing of it is a panic, and nothing is lost silently.
#![cfg(unix)]

use std::process::Command;
use std::time::{Duration, Instant};

use crate::call::Bench;

/// A full device, where the system has one.
fn full() -> bool {
    std::path::Path::new("/dev/full").exists()
}

#[test]
fn a_full_stderr_is_exit_2_and_the_files_are_there() {
    if !full() {
        return;
    }
    let bench = Bench::new();
    for (args, kept) in [
        ("run nosuch", None),
        ("nosuch", None),
        ("check disc-pad -q -v -o pad.svg --set nosuch=1", None),
        ("new disc-pad s.toml", Some("s.toml")),
        ("run pinned-shoe -v -o x", Some("x/summary.json")),
        ("report x", Some("x/report.html")),
    ] {
        let call = bench.shell(&format!("$0 {args} 2>/dev/full"));
        assert_eq!(call.code, 2, "{args}: {}", call.out);
        assert!(kept.is_none_or(|name| bench.path(name).exists()), "{args}");
    }
}

#[test]
fn a_full_stdout_is_exit_2_by_name_and_the_folder_is_there() {
    if !full() {
        return;
    }
    let bench = Bench::new();
    for args in
        ["schema", "new --list", "--help", "man", "completions bash", "explain", "check disc-pad", "run disc-pad --json -o k"]
    {
        let call = bench.shell(&format!("$0 {args} >/dev/full"));
        assert_eq!(call.code, 2, "{args}: {}", call.err);
        assert!(call.err.starts_with("error: cannot write to stdout: "), "{args}: {}", call.err);
        assert!(call.err.contains("--> stdout"), "{args}: {}", call.err);
        assert_eq!(bench.shell(&format!("$0 {args} >/dev/full 2>&1")).code, 2, "{args}");
    }
    assert!(bench.path("k/summary.json").exists());
    assert_eq!(bench.shell("$0 run disc-pad -q -o k >/dev/full").code, 0, "nothing is printed");
}

#[test]
fn a_pipe_that_nobody_reads_is_quiet_and_the_exit_is_that_of_the_work() {
    let bench = Bench::new();
    // The reader is gone before the program begins.
    let after = |streams: &str, args: &str| {
        let call = bench.shell(&format!("(sleep 0.3; $0 {args} {streams}; echo $? > code) | true; sleep 0.1; while ! [ -s code ]; do sleep 0.1; done; cat code; rm code"));
        call.out.trim().to_string() + &call.err
    };
    assert_eq!(after("2>/dev/null", "schema"), "0");
    assert_eq!(after("2>/dev/null", "run disc-pad -o a"), "0");
    assert_eq!(after("2>&1 >/dev/null", "new disc-pad s.toml"), "0");
    assert_eq!(after("2>&1 >/dev/null", "run nosuch"), "2");
    assert_eq!(after("2>&1", "run translating-punch -o b --set tasks=[pressure] --set load.moment=50000"), "1");
}

#[test]
fn closed_streams_are_no_streams_to_write_to_and_nothing_else() {
    let bench = Bench::new();
    for (args, code) in [("run disc-pad -o a", 0), ("new disc-pad s.toml", 0), ("run nosuch", 2), ("schema", 0)] {
        for closed in ["2>&-", ">&-", ">&- 2>&-", "<&- >&- 2>&-"] {
            let call = bench.shell(&format!("rm -f s.toml; $0 {args} {closed}"));
            assert_eq!(call.code, code, "{args} {closed}: {}{}", call.out, call.err);
        }
    }
    // What is opened instead of a closed stream gets none of the words: the files are those of a call with all streams.
    assert_eq!(bench.call("run disc-pad -o b").code, 0);
    for name in crate::call::files(&bench.path("b")).iter().filter(|name| *name != "timing.json") {
        assert!(bench.bytes(&format!("a/{name}")) == bench.bytes(&format!("b/{name}")), "{name}");
    }
}

/// Sends a signal as soon as the first rows of a sweep are there; returns the exit code and what was said.
fn signalled(bench: &Bench, start: &str, signal: &str) -> (i32, String) {
    let args = "sweep drum-brake-block --set mesh.degree=4 --set check=false --over contact.friction=0:0.3:4000 -q -o x";
    let mut sweep = Command::new("sh");
    let script = format!("exec {start} \"$0\" {args}");
    sweep.args(["-c", &script, env!("CARGO_BIN_EXE_wearshape")]).current_dir(bench.path("."));
    let child = sweep.stdout(std::process::Stdio::null()).stderr(std::process::Stdio::piped()).spawn().unwrap();
    let begin = Instant::now();
    let rows = || std::fs::metadata(bench.path("x.partial/sweep.jsonl")).map_or(0, |data| data.len());
    while rows() == 0 {
        assert!(begin.elapsed() < Duration::from_secs(120), "nothing comes");
        std::thread::sleep(Duration::from_millis(1));
    }
    let send = |signal: &str| Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap();
    assert!(send(signal).success());
    if !start.is_empty() {
        // It goes on, until it is asked by another signal.
        let before = rows();
        while rows() == before {
            assert!(begin.elapsed() < Duration::from_secs(120), "it does not go on");
            std::thread::sleep(Duration::from_millis(1));
        }
        assert!(send("-TERM").success());
    }
    let output = child.wait_with_output().unwrap();
    (output.status.code().unwrap_or(-1), String::from_utf8(output.stderr).unwrap())
}

/// Whether SIGHUP is ignored here, as under `nohup`: the first bit of the mask that Linux tells.
fn outlives() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:")).map(str::trim);
    mask.and_then(|mask| u64::from_str_radix(mask, 16).ok()).is_some_and(|mask| mask & 1 == 1)
}

#[test]
fn the_ends_that_a_system_asks_for_are_those_of_ctrl_c() {
    // Where the tests themselves are to outlive their terminal, the program is too.
    let signals = if outlives() { &["-TERM", "-INT"][..] } else { &["-TERM", "-HUP", "-INT"] };
    for signal in signals {
        let (code, said) = signalled(&Bench::new(), "", signal);
        assert_eq!(code, 130, "{signal}: {said}");
        assert!(said.contains("every finished row is kept") && said.contains("--resume"), "{signal}: {said}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_call_that_is_to_outlive_its_terminal_does() {
    let (code, said) = signalled(&Bench::new(), "nohup", "-HUP");
    assert_eq!(code, 130, "{said}");
    assert!(said.contains("every finished row is kept"), "{said}");
}
