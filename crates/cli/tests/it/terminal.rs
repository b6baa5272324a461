//! What a user at a terminal sees and gets: lists, help, completions, manual pages, and folders that a run without an answer leaves alone.

use crate::call::{Bench, files};

#[test]
fn explain_lists_every_note_in_one_line_each() {
    let bench = Bench::new();
    let list = bench.call("explain");
    assert_eq!(list.code, 0);
    let lines: Vec<&str> = list.out.lines().take_while(|line| !line.is_empty()).collect();
    assert!(lines.len() >= 13, "{}", list.out);
    for line in lines {
        let (code, what) = line.split_once(' ').unwrap();
        assert!(what.trim().len() > 10 && line.len() <= 100, "{line}");
        let page = bench.call(&format!("explain {code}"));
        assert!(page.code == 0 && page.out.starts_with(code), "{code}");
        assert!(page.out.lines().all(|line| line.chars().count() <= 80), "{}", page.out);
    }
}

#[test]
fn an_unknown_note_is_answered_by_the_nearest_or_by_those_that_speak_of_it() {
    let bench = Bench::new();
    for (word, answer) in
        [("s-on", "did you mean `s-one`?"), ("paper", "paper-balance"), ("friction", "jamming"), ("zzz", "lists all")]
    {
        let call = bench.call(&format!("explain {word}"));
        assert!(call.code == 2 && call.err.contains(answer), "{word}: {}", call.err);
    }
}

#[test]
fn help_is_a_command_and_force_is_accepted_but_not_offered() {
    let bench = Bench::new();
    let call = bench.call("help run");
    assert_eq!((call.code, call.err.as_str()), (0, ""));
    assert!(call.out.contains("Usage: wearshape run") && !call.out.contains("--force"), "{}", call.out);
    assert_eq!(bench.call("run pinned-shoe --force -q").code, 0);
}

#[test]
fn completions_know_the_scenes_and_the_notes() {
    let bench = Bench::new();
    for shell in ["bash", "zsh", "fish"] {
        let script = bench.call(&format!("completions {shell}")).out;
        for name in ["drum-brake-block", "journal-arc", "s-one", "young-implausible"] {
            assert!(script.contains(name), "{shell}: {name}");
        }
    }
    // Files stay offered where a scene is asked for.
    assert!(bench.call("completions zsh").out.contains("_files}"));
    let script = "$0 completions bash > c && bash -c 'source c; COMP_WORDS=(wearshape run dru); COMP_CWORD=2; _wearshape wearshape dru run; echo ${COMPREPLY[@]}'";
    let call = bench.shell(&format!("command -v bash > /dev/null || exit 9; {script}"));
    assert!(call.code == 9 || call.out.trim() == "drum-brake-block drum-brake-ring drum-brake-hot", "{}{}", call.out, call.err);
}

#[test]
fn manual_pages_say_how_a_call_ends_and_which_files_there_are() {
    let bench = Bench::new();
    assert_eq!(bench.call("man pages").code, 0);
    for page in files(&bench.path("pages")) {
        let text = bench.read(&format!("pages/{page}"));
        assert!(text.contains(".SH \"EXIT STATUS\"") && text.contains("130"), "{page}");
    }
    for page in ["wearshape.1", "wearshape-run.1", "wearshape-sweep.1"] {
        let text = bench.read(&format!("pages/{page}"));
        assert!(text.contains(".SH \"FILES\"") && text.contains("summary.json"), "{page}");
    }
    assert!(!bench.path("pages/wearshape-help.1").exists());
}

/// All bytes of a folder.
fn bytes(bench: &Bench, folder: &str) -> Vec<(String, Vec<u8>)> {
    files(&bench.path(folder)).into_iter().map(|name| (name.clone(), bench.bytes(&format!("{folder}/{name}")))).collect()
}

#[test]
fn a_run_that_is_refused_leaves_the_good_folder_of_before_as_it_is() {
    let bench = Bench::new();
    assert_eq!(bench.call("run pinned-shoe -o x").code, 0);
    let before = bytes(&bench, "x");
    // Refused on reading, and by the solve: friction that locks the shoe.
    assert_eq!(bench.call("run pinned-shoe -o x --set accuracy=7").code, 2);
    assert_eq!(bytes(&bench, "x"), before);
    let call = bench.call("run translating-punch -o x --set tasks=[pressure] --set load.moment=50000");
    assert_eq!(call.code, 1, "{}{}", call.out, call.err);
    assert!(call.out.contains("x.failed") && call.err.contains("x keeps the run of before"), "{}{}", call.out, call.err);
    assert_eq!(bytes(&bench, "x"), before);
    let failed: serde_json::Value = serde_json::from_str(&bench.read("x.failed/summary.json")).unwrap();
    assert_eq!(failed["status"], "refused");
    assert!(!bench.path("x.partial").exists());
    // Where nothing stands, the folder is the one asked for, and a later run without an answer replaces it.
    for _ in 0..2 {
        assert_eq!(bench.call("run translating-punch -o y --set tasks=[pressure] --set load.moment=50000").code, 1);
        assert!(bench.path("y/summary.json").exists() && !bench.path("y.failed").exists());
    }
}

#[test]
fn a_missed_accuracy_says_what_was_found_and_what_would_reach_it() {
    let bench = Bench::new();
    let call = bench.call("run hertz-cylinder -o x --set accuracy=1e-13");
    assert_eq!(call.code, 1, "{}", call.err);
    assert!(call.out.contains("contact   force 35000 N, at most 35") && call.out.contains("help      "), "{}", call.out);
    let help = call.out.split("--set accuracy=").nth(1).unwrap().lines().next().unwrap();
    let again = bench.call(&format!("run hertz-cylinder -o x --set accuracy={help}"));
    assert_eq!(again.code, 0, "{}", again.out);
    let call = bench.call("run drum-brake-block -o y --set accuracy=1e-13");
    assert!(call.code == 1 && call.out.contains("take off most, 1.0") && call.out.contains("pressure  5.45"), "{}", call.out);
}

#[test]
fn no_note_and_no_unused_key_is_left_out_without_a_word() {
    let bench = Bench::new();
    let lines = |text: &str, name: &str| text.lines().filter(|line| line.starts_with(name)).count();
    let found = "--set tasks=[pressure,contact,shape] --set contact.roughness=1_um --set body1.wearable=4_mm";
    for (options, code) in [(format!("{found} --set sliding.omega=3.5"), 0), ("--set sliding.omega=20".into(), 1)] {
        let run = format!("run drum-brake-hot {options} --set optimum.q=2 -o x{code}");
        let call = bench.call(&run);
        assert_eq!(call.code, code, "{}{}", call.out, call.err);
        let summary: serde_json::Value = serde_json::from_str(&bench.read(&format!("x{code}/summary.json"))).unwrap();
        let notes = summary["lints"].as_array().unwrap().len();
        assert!(notes > 2 && lines(&call.out, "note  ") == 2, "{}", call.out);
        let more = format!("\nnotes     {} more in report.html\nunused    optimum.q\nfiles     x{code}\n", notes - 2);
        assert!(call.out.ends_with(&more), "{}", call.out);
        // Without the page they are in the summary, and all of them on the screen where that is asked for.
        let call = bench.call(&format!("{run} --set output.report=false"));
        assert!(call.out.contains(" more in summary.json\n"), "{}", call.out);
        let call = bench.call(&format!("{run} -v"));
        assert_eq!((lines(&call.out, "note  "), lines(&call.out, "notes ")), (notes, 0), "{}", call.out);
        assert!(call.out.contains("\nunused    optimum.q\nfiles     x"), "{}", call.out);
    }
}

#[test]
fn without_a_terminal_nothing_is_drawn() {
    let bench = Bench::new();
    for args in ["run punch-wear --set accuracy=1e-4", "check lining-on-back", "run drum-brake-block --dry-run"] {
        let call = bench.call(args);
        assert_eq!((call.code, call.err.as_str()), (0, ""), "{args}");
    }
}
