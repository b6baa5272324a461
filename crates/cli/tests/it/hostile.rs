//! Texts and folders from others: nothing in them acts on a terminal, in a picture or in a page.

use crate::call::Bench;

/// What an honest text has none of.
fn acts(text: &str) -> bool {
    text.chars().any(|c| c.is_control() && c != '\n' && c != '\t')
}

#[test]
fn control_characters_of_a_scene_reach_no_terminal_and_no_picture() {
    let bench = Bench::new();
    let esc = "\\u001b]0;owned\\u0007\\u009b2J";
    bench.file("bad.toml", &format!("units = \"{esc}\"\n"));
    let call = bench.call("check bad.toml");
    assert!(call.code == 2 && !acts(&call.err) && call.err.contains("owned"), "{}", call.err);
    let call = bench.call("check bad.toml --json");
    assert!(call.code == 2 && !acts(&call.out), "{}", call.out);
    let scene = bench.call("new disc-pad").out;
    let title = scene.lines().find(|line| line.starts_with("title")).unwrap().to_string();
    bench.file("titled.toml", &scene.replace(&title, &format!("title = \"{esc}T\"")));
    let call = bench.call("check titled.toml");
    assert!(call.code == 0 && !acts(&call.out) && call.out.contains("\\u{1b}]0;owned\\u{7}\\u{9b}2JT"), "{}", call.out);
    assert_eq!(bench.call("run titled.toml -q -o o").code, 0);
    for name in ["report.html", "plots/pressure.svg", "plots/scene.svg", "plots/map.svg"] {
        let text = bench.read(&format!("o/{name}"));
        assert!(!acts(&text) && text.contains("owned"), "{name}");
    }
}

#[test]
fn of_a_line_without_end_what_is_around_the_place_is_told() {
    let bench = Bench::new();
    bench.file("long.toml", &"[".repeat(1 << 20));
    bench.file("key.toml", &format!("{} = 1\n", "k".repeat(1 << 20)));
    for scene in ["long.toml", "key.toml"] {
        let call = bench.call(&format!("check {scene}"));
        assert!(call.code == 2 && call.err.len() < 8000, "{scene}: {} bytes", call.err.len());
        let json = bench.call(&format!("check {scene} --json"));
        assert!(json.code == 2 && json.out.len() < 8000, "{scene}: {} bytes", json.out.len());
    }
}

#[test]
fn a_page_asks_no_network_and_runs_no_script_but_its_own() {
    let bench = Bench::new();
    assert_eq!(bench.call("run disc-pad -q -o o").code, 0);
    let page = bench.read("o/report.html");
    assert!(page.contains("Content-Security-Policy\" content=\"default-src 'none'; script-src 'sha256-"), "no policy");
    assert!(!page.contains("Left out"));
}

#[test]
fn the_page_of_a_finished_sweep_is_built_again_to_the_same_bytes() {
    let bench = Bench::new();
    assert_eq!(bench.call("sweep disc-pad --over load.force=1000,2000 --sample 5 -q -o s").code, 0);
    let before = bench.read("s/report.html");
    std::fs::remove_file(bench.path("s/report.html")).unwrap();
    let call = bench.call("report s");
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(before.contains("Content-Security-Policy") && bench.read("s/report.html") == before);
}

#[cfg(unix)]
#[test]
fn the_page_of_a_folder_from_others_holds_nothing_that_acts_and_writes_through_no_link() {
    use std::os::unix::fs::symlink;
    let bench = Bench::new();
    assert_eq!(bench.call("run disc-pad -q -o o").code, 0);
    bench.file("o/plots/map.svg", "<svg onload=\"alert(1)\"></svg><script>alert(2)</script>");
    bench.file("outside.svg", "<svg><script>alert(3)</script></svg>");
    let curves = bench.read("o/plots/curves.json").replace("\"file\":\"pressure\"", "\"file\":\"../../outside\"");
    bench.file("o/plots/curves.json", &curves);
    let secret = bench.file("secret.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><title>secret</title></svg>");
    std::fs::remove_file(bench.path("o/plots/scene.svg")).unwrap();
    symlink(&secret, bench.path("o/plots/scene.svg")).unwrap();
    std::fs::remove_file(bench.path("o/report.html")).unwrap();
    bench.file("victim", "precious");
    symlink("../victim", bench.path("o/report.html")).unwrap();
    let call = bench.call("report o");
    assert_eq!(call.code, 0, "{}", call.err);
    let page = bench.read("o/report.html");
    assert!(!page.contains("alert(") && !page.contains("secret"), "acts");
    assert!(page.contains("plots/map.svg") && page.contains("plots/../../outside.svg") && page.contains("Left out"));
    assert_eq!(bench.read("victim"), "precious");
    assert!(!std::fs::symlink_metadata(bench.path("o/report.html")).unwrap().is_symlink());
}
