//! Input beyond all measure is refused by name before it is read whole: files, nested settings, numbers of points; and what grows with a body grows
//! no faster than it.

use std::fmt::Write as _;
use std::fs::File;
use std::io::Write as _;
use std::process::{Command, Stdio};

use crate::call::Bench;

const SCENE: &str = r#"units = "N-mm"
kinematics = "plane-strain"
thickness = 10
tasks = ["pressure"]
accuracy = 1e-4
contact = { edges = ["bottom", "top"], friction = 0.1 }
sliding = { speed = 5 }
load = { edge = "top", as = "pressure", force = 600 }
wear = { beta = 1e-6 }
body1.material = { young = "210 GPa", poisson = 0.3 }
body1.support = { left = ["x"] }
body2.material = { young = "210 GPa", poisson = 0.3 }
body2.geometry.rectangle = { x = [-60, 60], z = [0, 100] }
body2.support = { bottom = ["x", "z"] }
"#;

/// A refusal with exit 2 that says some words, in few.
fn refused(bench: &Bench, args: &[&str], words: &str) {
    let call = bench.call_with(args);
    assert_eq!(call.code, 2, "{words}: {}", call.err);
    assert!(call.err.contains(words), "{words}: {}", call.err);
    assert!(call.err.len() < 2000, "{words}: {} bytes", call.err.len());
}

#[test]
fn a_scene_beyond_16_mb_is_refused_by_name() {
    let bench = Bench::new();
    bench.file("large.toml", SCENE);
    File::options().append(true).open(bench.path("large.toml")).unwrap().write_all(&vec![b'#'; 16_000_000]).unwrap();
    refused(&bench, &["check", "large.toml"], "cannot read the scene large.toml: it is larger than 16 MB");
    bench.file("line.toml", &"[".repeat(16_000_001));
    refused(&bench, &["check", "line.toml"], "larger than 16 MB");
}

#[cfg(unix)]
#[test]
fn an_endless_scene_is_refused_and_one_from_a_pipe_is_read() {
    let bench = Bench::new();
    refused(&bench, &["check", "/dev/zero"], "cannot read the scene /dev/zero: it is larger than 16 MB");
    let text = format!("{SCENE}body1.geometry.rectangle = {{ x = [-30, 30], z = [100, 200] }}\n");
    let mut check = Command::new(env!("CARGO_BIN_EXE_wearshape"));
    let mut check = check.args(["check", "/dev/stdin"]).stdin(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
    check.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    assert!(check.wait().unwrap().success());
}

#[cfg(unix)]
#[test]
fn meshes_and_profiles_are_files_of_at_most_100_mb() {
    let bench = Bench::new();
    assert_eq!(bench.shell("mkfifo pipe.msh && mkdir folder.msh").code, 0);
    File::create(bench.path("large.msh")).unwrap().set_len(100_000_001).unwrap();
    let cases = [
        ("pipe.msh", "it is a pipe or a device, not a file"),
        ("/dev/zero", "it is a pipe or a device, not a file"),
        ("folder.msh", "it is a folder"),
        ("large.msh", "it is larger than 100 MB, the largest that is read"),
    ];
    for (name, words) in cases {
        bench.file("mesh.toml", &format!("{SCENE}body1.geometry.mesh = {{ file = \"{name}\" }}\n"));
        refused(&bench, &["check", "mesh.toml"], &format!("cannot read the mesh {name}: {words}"));
        let scene = SCENE.replace("friction = 0.1", &format!("friction = 0.1, gap = \"{name}\""));
        bench.file("gap.toml", &format!("{scene}body1.geometry.rectangle = {{ x = [-30, 30], z = [100, 200] }}\n"));
        refused(&bench, &["check", "gap.toml"], words);
    }
}

#[test]
fn deeply_nested_and_long_settings_are_refused_in_few_words() {
    let bench = Bench::new();
    let nested = ["[".repeat(60_000), "{a=".repeat(30_000), "[{a=".repeat(100)];
    for value in nested {
        refused(&bench, &["check", "disc-pad", "--set", &format!("title={value}")], "deep, of at most 64");
    }
    let key = vec!["a"; 1000].join(".");
    refused(&bench, &["check", "disc-pad", "--set", &format!("{key}=1")], "is nested 1000 deep, of at most 64");
    refused(&bench, &["check", "disc-pad", "--set", &format!("title={}", "a".repeat(110_000))], "110006 bytes long");
    for text in ["a = ", "a.b = {c = "] {
        bench.file("deep.toml", &format!("{text}{}", "[".repeat(100_000)));
        refused(&bench, &["check", "deep.toml"], "this is not TOML");
    }
    // Brackets within text are none.
    let call = bench.call_with(&["check", "disc-pad", "--set", &format!("title=\"{}\"", "[".repeat(100))]);
    assert_eq!(call.code, 0, "{}", call.err);
}

#[test]
fn a_million_points_are_the_most_that_are_asked_for() {
    refused(&Bench::new(), &["run", "disc-pad", "--sample", "1000001"], "--sample 1000001 is out of range");
}

/// A body of n by n cells.
fn blocks(n: usize) -> String {
    let at = |i: usize| i as f64 / n as f64;
    let (mut points, mut curves, mut cells) = (String::new(), String::new(), String::new());
    for i in 0..=n {
        for j in 0..=n {
            writeln!(points, "p{i}x{j} = [{}, {}]", 60.0 * at(i) - 30.0, 100.0 + 60.0 * at(j)).unwrap();
            if i < n {
                writeln!(curves, "h{i}x{j}.line = [\"p{i}x{j}\", \"p{}x{j}\"]", i + 1).unwrap();
            }
            if j < n {
                writeln!(curves, "v{i}x{j}.line = [\"p{i}x{j}\", \"p{i}x{}\"]", j + 1).unwrap();
            }
            if i < n && j < n {
                let (right, above) = (i + 1, j + 1);
                writeln!(cells, "c{i}x{j} = {{ curves = [\"h{i}x{j}\", \"v{right}x{j}\", \"h{i}x{above}\", \"v{i}x{j}\"] }}")
                    .unwrap();
            }
        }
    }
    let list = |name: &dyn Fn(usize) -> String| format!("{:?}", (0..n).map(name).collect::<Vec<_>>());
    let [bottom, top, left] = [list(&|i| format!("h{i}x0")), list(&|i| format!("h{i}x{n}")), list(&|j| format!("v0x{j}"))];
    let key = "body1.geometry.blocks";
    format!(
        "{SCENE}[{key}.points]\n{points}[{key}.curves]\n{curves}[{key}.cells]\n{cells}[{key}.edges]\nbottom = {bottom}\ntop = {top}\nleft = {left}\n"
    )
}

#[cfg(target_os = "linux")]
#[test]
fn blocks_of_40_000_cells_take_seconds() {
    let bench = Bench::new();
    bench.file("blocks.toml", &blocks(200));
    // Ten seconds of processor time. With a search for each point, curve and side among all others it was a minute.
    let call = bench.shell("ulimit -t 10; \"$0\" check blocks.toml");
    assert_eq!(call.code, 0, "{}", call.err);
}

/// The folder `x` with the results of a small scene.
fn results() -> Bench {
    let bench = Bench::new();
    let call = bench.call("run translating-punch -q -o x --set tasks=[pressure,shape] --set mesh.degree=3 --set mesh.layers=1");
    assert!(call.code < 2, "{}", call.err);
    bench
}

#[cfg(unix)]
#[test]
fn results_are_files_of_at_most_1_gb() {
    let bench = results();
    let study = "study translating-punch --reference x -o y --set tasks=[pressure,shape]";
    for (name, commands) in [
        ("summary.json", &["report x", "diff x x", study][..]),
        ("contact.csv", &["report x", "diff x x", study]),
        ("scene.resolved.toml", &["diff x x", study]),
    ] {
        let (path, kept) = (bench.path(&format!("x/{name}")), bench.path("kept"));
        std::fs::rename(&path, &kept).unwrap();
        File::create(&path).unwrap().set_len(1_000_000_001).unwrap();
        for command in commands {
            let args: Vec<&str> = command.split(' ').collect();
            refused(&bench, &args, &format!("cannot read x/{name}: it is larger than 1000 MB, the largest that is read"));
        }
        std::fs::remove_file(&path).unwrap();
        assert_eq!(bench.shell(&format!("mkfifo x/{name}")).code, 0);
        for command in commands {
            let args: Vec<&str> = command.split(' ').collect();
            refused(&bench, &args, &format!("cannot read x/{name}: it is a pipe or a device, not a file"));
        }
        std::fs::remove_file(&path).unwrap();
        std::fs::rename(&kept, &path).unwrap();
    }
    assert_eq!(bench.call("diff x x").code, 0);
}

#[cfg(unix)]
#[test]
fn a_recording_is_a_file_of_at_most_1_gb() {
    let bench = results();
    let wear = "run punch-wear -q -o w --set mesh.degree=4 --set mesh.layers=2 --set accuracy=1e-2";
    assert_eq!(bench.call(wear).code, 0);
    assert_eq!(
        bench
            .shell(
                "mkdir w.partial && cp w/scene.resolved.toml w.partial && rm w/run.mcap && mkfifo x/run.mcap w.partial/run.mcap"
            )
            .code,
        0
    );
    let resume = format!("{wear} --resume");
    let resume: Vec<&str> = resume.split(' ').collect();
    refused(&bench, &["report", "x"], "cannot read x/run.mcap: it is a pipe or a device, not a file");
    refused(&bench, &resume, "run.mcap: it is a pipe or a device, not a file");
    assert_eq!(bench.shell("rm x/run.mcap w.partial/run.mcap").code, 0);
    for (name, args) in [("x/run.mcap", &["report", "x"][..]), ("w.partial/run.mcap", &resume)] {
        File::create(bench.path(name)).unwrap().set_len(1_000_000_001).unwrap();
        refused(&bench, args, "run.mcap: it is larger than 1000 MB, the largest that is read");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_pressure_too_steep_to_be_integrated_is_refused_in_half_a_gigabyte() {
    let bench = Bench::new();
    let call = bench.shell("ulimit -v 500000; $0 run elliptic-punch --set load.moment=1e16 --set wear.b=30 --threads 1 -o x");
    assert_eq!(call.code, 1, "{}", call.err);
    assert!(bench.read("x/summary.json").contains("the pressure is so steep that its integrals over the surface need more than"));
}

/// A drum on a hub of a ten thousandth of a millimetre turns about it so far that its gap is round-off, which is not a gap of nothing.
#[test]
fn a_gap_that_round_off_hides_is_told_as_one_whose_error_is_not_known() {
    let bench = Bench::new();
    let call = bench.call("run drum-brake-block --set body2.geometry.ring.inner=1e-4 -o x");
    assert_eq!(call.code, 1, "{}", call.err);
    assert!(call.out.contains("the proof fails") && !call.out.contains("nothing is to be taken off"), "{}", call.out);
    let summary: serde_json::Value = serde_json::from_str(&bench.read("x/summary.json")).unwrap();
    assert!(summary["error"]["gap_relative"].is_null(), "{}", summary["error"]);
}

/// A body a thousand million times as high as wide has cells of sizes without common digits: said, or computed, but no fault of the program.
#[test]
fn a_body_of_any_height_has_cells_or_is_refused() {
    let bench = Bench::new();
    // The estimate is missed, and the proof fails: nothing there is to be content with.
    let call = bench.call("run drum-brake-block --set body1.geometry.shoe-block.top=3e8 -o x");
    assert_eq!(call.code, 1);
    assert!(call.out.contains("the proof fails") && !call.out.contains("to be content"), "{}", call.out);
    for top in ["3e11", "3e30", "3e300"] {
        let call = bench.call(&format!("run drum-brake-block --set body1.geometry.shoe-block.top={top} -q -o x"));
        assert!([1, 2].contains(&call.code), "{top}: exit {}, {}", call.code, call.err);
    }
}
