//! The output folder: complete or not there, ours or left alone, the same bytes for the same scene.

use crate::call::{Bench, files};

#[test]
fn a_run_writes_its_folder_and_leaves_no_partial_one() {
    let bench = Bench::new();
    let call = bench.call("run disc-pad");
    assert_eq!(call.code, 0, "{}", call.err);
    let found = files(&bench.path("out/disc-pad"));
    for name in ["contact.csv", "plots/pressure.svg", "report.html", "scene.resolved.toml", "summary.json", "timing.json"] {
        assert!(found.iter().any(|file| file == name), "{name} is not among {found:?}");
    }
    assert_eq!(std::fs::read_dir(bench.path("out")).unwrap().count(), 1);
}

#[test]
fn the_same_scene_gives_the_same_bytes_with_any_number_of_threads() {
    let bench = Bench::new();
    for (folder, threads) in [("out/a", 1), ("out/b", 2), ("out/c", 2)] {
        let call = bench.call(&format!("run pinned-shoe -q --threads {threads} -o {folder}"));
        assert_eq!(call.code, 0, "{}", call.err);
    }
    let names = files(&bench.path("out/a"));
    assert!(names.len() > 5);
    for other in ["out/b", "out/c"] {
        assert_eq!(files(&bench.path(other)), names);
        for name in names.iter().filter(|name| *name != "timing.json") {
            assert!(bench.bytes(&format!("out/a/{name}")) == bench.bytes(&format!("{other}/{name}")), "{name} differs");
        }
    }
}

#[test]
fn our_own_folder_is_replaced_without_force() {
    let bench = Bench::new();
    assert_eq!(bench.call("run disc-pad -q").code, 0);
    let before = bench.read("out/disc-pad/scene.resolved.toml");
    assert_eq!(bench.call("run disc-pad -q --set contact.friction=.1").code, 0);
    assert_ne!(bench.read("out/disc-pad/scene.resolved.toml"), before);
}

#[test]
fn a_folder_of_somebody_else_is_refused_even_with_force() {
    let bench = Bench::new();
    bench.file("photos/one.jpg", "precious");
    for args in ["run disc-pad -o photos", "run disc-pad -o photos --force"] {
        let call = bench.call(args);
        assert_eq!(call.code, 2, "{args}");
        assert!(call.err.contains("did not write") && call.err.contains("-o photos"), "{}", call.err);
    }
    assert_eq!(files(&bench.path("photos")), ["one.jpg"]);
    bench.file("photos/summary.json", "{\"schema_version\": \"mine\"}");
    assert_eq!(bench.call("run disc-pad -o photos").code, 2, "a foreign summary.json is not ours");
    bench.file("note", "precious");
    assert_eq!(bench.call("run disc-pad -o note").code, 2);
    assert_eq!(bench.read("note"), "precious");
}

#[test]
fn a_partial_folder_of_somebody_else_is_left_alone() {
    let bench = Bench::new();
    bench.file("x.partial/letter.txt", "precious");
    let call = bench.call("run disc-pad -o x");
    assert_eq!(call.code, 2, "{}", call.err);
    assert_eq!(bench.read("x.partial/letter.txt"), "precious");
}

#[test]
fn a_leftover_partial_folder_of_ours_is_begun_again() {
    let bench = Bench::new();
    bench.file("x.partial/scene.resolved.toml", "title = \"old\"");
    bench.file("x.partial/history.csv", "1");
    assert_eq!(bench.call("run disc-pad -o x -q").code, 0);
    assert!(!bench.path("x.partial").exists() && !bench.path("x/history.csv").exists());
}

#[test]
fn a_folder_that_the_user_has_put_aside_is_never_deleted() {
    let bench = Bench::new();
    assert_eq!(bench.call("run disc-pad -q -o shoe").code, 0);
    std::fs::rename(bench.path("shoe"), bench.path("shoe.old")).unwrap();
    for friction in [".1", ".2", ".3"] {
        assert_eq!(bench.call(&format!("run disc-pad -q -o shoe --set contact.friction={friction}")).code, 0);
    }
    for name in ["run.v1", "run.old", "run.v1"] {
        assert_eq!(bench.call(&format!("run disc-pad -q -o {name}")).code, 0);
    }
    assert!(bench.path("shoe.old/summary.json").exists() && bench.path("run.old/summary.json").exists());
    // Nothing is left of what was replaced.
    let names = std::fs::read_dir(bench.path("")).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<String> = names.collect();
    names.sort();
    assert_eq!(names, ["run.old", "run.v1", "shoe", "shoe.old"]);
}

#[test]
fn files_of_somebody_else_in_a_folder_of_ours_are_never_touched() {
    let bench = Bench::new();
    assert_eq!(bench.call("run disc-pad -q -o x").code, 0);
    let before = bench.bytes("x/summary.json");
    for name in ["notes.txt", "plots/notes.txt", "more/notes.txt"] {
        bench.file(&format!("x/{name}"), "precious");
        let call = bench.call("run disc-pad -q -o x --set contact.friction=.1");
        assert!(call.code == 2 && call.err.contains(name) && call.err.contains("did not write"), "{name}: {}", call.err);
        assert_eq!((bench.read(&format!("x/{name}")).as_str(), bench.bytes("x/summary.json") == before), ("precious", true));
        std::fs::remove_file(bench.path(&format!("x/{name}"))).unwrap();
    }
    assert_eq!(bench.call("run disc-pad -q -o x --set contact.friction=.1").code, 0);
    // The same in a partial folder, with and without going on.
    bench.file("y.partial/scene.resolved.toml", "");
    bench.file("y.partial/thesis.tex", "precious");
    for flag in ["", "--resume"] {
        let call = bench.call(&format!("run disc-pad -q -o y {flag}"));
        assert!(call.code == 2 && call.err.contains("thesis.tex"), "{}", call.err);
    }
    assert_eq!(files(&bench.path("y.partial")), ["scene.resolved.toml", "thesis.tex"]);
}

#[test]
fn the_summary_lists_the_files_of_its_folder() {
    let bench = Bench::new();
    for args in [
        "run drum-brake-block --set mesh.degree=4 --set output.fields=true",
        "run punch-wear --set mesh={degree=4,layers=2} --set wear.until=20_s",
        "sweep disc-pad --over contact.friction=.1,.2",
        "study drum-brake-block --set optimum.functional=uniform",
        "reproduce fig19",
    ] {
        let call = bench.call(&format!("{args} --json -o x"));
        assert!(call.code < 2, "{args}: {}{}", call.out, call.err);
        let said: serde_json::Value = serde_json::from_str(&call.out).unwrap();
        let written: serde_json::Value = serde_json::from_str(&bench.read("x/summary.json")).unwrap();
        assert_eq!(said, written, "{args}");
        assert_eq!(written["manifest"], serde_json::json!(files(&bench.path("x"))), "{args}");
    }
}

#[cfg(unix)]
#[test]
fn a_folder_has_a_name_and_links_lead_somewhere() {
    let bench = Bench::new();
    std::os::unix::fs::symlink("nowhere", bench.path("dangling")).unwrap();
    for folder in [".", "..", "/", "dangling"] {
        let call = bench.call(&format!("run disc-pad -q -o {folder}"));
        assert!(call.code == 2 && call.err.contains(&format!("-o {folder}")), "{folder}: {}", call.err);
    }
    std::fs::create_dir(bench.path("there")).unwrap();
    std::os::unix::fs::symlink("there", bench.path("link")).unwrap();
    for _ in 0..2 {
        assert_eq!(bench.call("run disc-pad -q -o link").code, 0);
    }
    assert!(bench.path("link").is_symlink() && bench.path("there/summary.json").exists());
}

#[test]
fn the_call_after_a_new_scene_can_be_pasted_into_a_shell() {
    let bench = Bench::new();
    let call = bench.call_with(&["new", "disc-pad", "my pad.toml"]);
    assert!(call.code == 0 && call.err.ends_with("next: wearshape run 'my pad.toml'\n"), "{}", call.err);
}

#[cfg(unix)]
#[test]
fn of_two_calls_into_one_folder_one_wins_and_the_other_says_so() {
    let bench = Bench::new();
    let slow =
        "run punch-wear --set mesh.degree=12 --set accuracy=1e-8 --set wear.until=1000_s --set contact.shear=false -q -o c";
    let mut first = bench.start(slow);
    while !bench.path("c.partial/scene.resolved.toml").exists() {
        assert_eq!(first.try_wait().unwrap(), None, "it was over before another could begin");
        std::thread::sleep(std::time::Duration::from_micros(200));
    }
    for other in [
        format!("{slow} --set contact.friction=.1"),
        format!("{slow} --resume"),
        "sweep disc-pad --over contact.friction=.1,.2 -o c".into(),
        "study drum-brake-block -o ./c".into(),
    ] {
        let call = bench.call(&other);
        assert!(call.code == 2 && call.err.contains("is being written by another wearshape"), "{other}: {}", call.err);
    }
    assert_eq!(first.wait().unwrap().code(), Some(0));
    let summary: serde_json::Value = serde_json::from_str(&bench.read("c/summary.json")).unwrap();
    assert_eq!(summary["scene_sha256"], crate::call::sha256(&bench.read("c/scene.resolved.toml")));
    assert!(bench.read("c/scene.resolved.toml").contains("friction = 0.25"));
}

#[test]
fn a_partial_folder_whose_scene_is_changed_meanwhile_is_not_finished() {
    let bench = Bench::new();
    let mut child = bench.start("sweep drum-brake-block --set mesh.degree=4 --over contact.friction=0:.4:500 -q -o x");
    while !bench.path("x.partial/sweep.jsonl").exists() {
        assert_eq!(child.try_wait().unwrap(), None);
        std::thread::sleep(std::time::Duration::from_micros(200));
    }
    bench.file("x.partial/scene.resolved.toml", "title = \"another\"\n");
    let output = child.wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.code() == Some(2) && said.contains("its scene is another one"), "{said}");
    assert!(!bench.path("x").exists());
}

#[test]
fn a_folder_that_cannot_be_written_is_said_with_a_remedy() {
    let bench = Bench::new();
    bench.file("file", "");
    let call = bench.call("run disc-pad -o file/inside");
    assert_eq!(call.code, 2, "{}", call.err);
    assert!(call.err.contains("cannot write") && call.err.contains("remedy: "), "{}", call.err);
}

#[test]
fn a_dry_run_writes_nothing() {
    let bench = Bench::new();
    let call = bench.call("run drum-brake-block --dry-run");
    assert_eq!(call.code, 0);
    assert!(call.out.contains("would write") && !bench.path("out").exists(), "{}", call.out);
}

#[test]
fn contact_csv_has_the_columns_of_the_contract_and_reads_back() {
    let bench = Bench::new();
    assert_eq!(bench.call("run annular-punch --set tasks=[pressure] --sample 101 -q").code, 0);
    let table = bench.read("out/annular-punch/contact.csv");
    let mut rows = table.lines();
    assert_eq!(
        rows.next().unwrap(),
        "s_mm,x_mm,y_mm,z_mm,nx,ny,nz,weight_mm2,pressure_MPa,pressure_solved_MPa,shear_MPa,gap_um,opening_um,\
         wear_rate_um_per_s,un1_um,un2_um,ut1_um,ut2_um,uphi1_um,uphi2_um,status"
    );
    let rows: Vec<Vec<&str>> = rows.map(|row| row.split(',').collect()).collect();
    assert_eq!(rows.len(), 101);
    assert!(rows.iter().all(|row| row.len() == 21));
    let number = |row: usize, column: usize| rows[row][column].parse::<f64>().unwrap();
    assert_eq!((number(0, 0), number(100, 0)), (20.0, 120.0));
    // Steady with a = b = 1: p r is constant; trapezoid weights are those of the area.
    approx::assert_relative_eq!(number(50, 8), 100.0, max_relative = 1e-12);
    let area: f64 = (0..101).map(|row| number(row, 7)).sum();
    approx::assert_relative_eq!(area, std::f64::consts::PI * (120.0f64.powi(2) - 400.0), max_relative = 1e-12);
    assert_eq!(rows[0][11], "nan");
    assert_eq!(rows[0][20], "contact");
}

#[test]
fn a_recording_is_written_when_asked_for_and_holds_the_scene() {
    let bench = Bench::new();
    assert_eq!(bench.call("run disc-pad -q --set output.recording=true").code, 0);
    let bytes = bench.bytes("out/disc-pad/run.mcap");
    let summary = mcap::Summary::read(&bytes).unwrap().unwrap();
    let scene = mcap::read::attachment(&bytes, &summary.attachment_indexes[0]).unwrap();
    assert_eq!(scene.data, bench.bytes("out/disc-pad/scene.resolved.toml"));
    let messages: Vec<_> = mcap::MessageStream::new(&bytes).unwrap().map(Result::unwrap).collect();
    let topics: Vec<&str> = messages.iter().map(|message| message.channel.topic.as_str()).collect();
    assert_eq!(topics, ["/log", "/contact/profile"]);
    let profile: serde_json::Value = serde_json::from_slice(&messages[1].data).unwrap();
    let rows = bench.read("out/disc-pad/contact.csv").lines().count() - 1;
    assert_eq!(profile["points"].as_array().map(Vec::len), Some(rows));
}

/// As the page of outputs says: the steps have the gap as it is worn, the end has its lowest rigid part.
#[test]
fn the_gap_of_the_last_step_is_that_of_the_end_but_for_a_rigid_motion() {
    let bench = Bench::new();
    assert_eq!(bench.call("run punch-wear -q --set mesh.degree=4 --set output.recording=true -o w").code, 0);
    let bytes = bench.bytes("w/run.mcap");
    let messages = mcap::MessageStream::new(&bytes).unwrap().map(Result::unwrap);
    let last = messages.filter(|message| message.channel.topic == "/contact/profile").last().unwrap();
    let last: serde_json::Value = serde_json::from_slice(&last.data).unwrap();
    let points = last["points"].as_array().unwrap();
    let table = bench.read("w/contact.csv");
    let mut rows = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = rows.next().unwrap();
    let column = |name: &str| names.iter().position(|known| *known == name).unwrap();
    let [x, gap] = ["x_mm", "gap_um"].map(column);
    let number = |text: &str| text.parse::<f64>().unwrap();
    let at_end: Vec<[f64; 2]> = rows.map(|row| [number(row[x]), number(row[gap])]).collect();
    assert_eq!(at_end.len(), points.len());
    let lifted: Vec<[f64; 2]> =
        points.iter().zip(&at_end).map(|(point, [x, gap])| [*x, point["gap_um"].as_f64().unwrap() - gap]).collect();
    let ([x0, d0], [x1, d1]) = (lifted[0], *lifted.last().unwrap());
    assert!(d0.abs().max(d1.abs()) > 1.0, "the punch is worn by more than a micrometre: {d0} {d1}");
    for [x, d] in &lifted {
        approx::assert_abs_diff_eq!(*d, d0 + (d1 - d0) * (x - x0) / (x1 - x0), epsilon = 1e-9 * d0.abs().max(d1.abs()));
    }
    let least = at_end.iter().map(|[_, gap]| *gap).fold(f64::INFINITY, f64::min);
    assert!(least.abs() < 1e-9, "the lowest rigid part closes the gap of the end: {least}");
}

#[test]
fn a_full_disk_ends_with_a_remedy_and_keeps_the_folder_that_was_there() {
    let bench = Bench::new();
    assert_eq!(bench.call("run disc-pad -q").code, 0);
    let before = bench.bytes("out/disc-pad/summary.json");
    // A file size limit stands for the full disk: writing fails in the same way.
    let script = "trap '' XFSZ; ulimit -f 8; exec \"$0\" run disc-pad -q --set contact.friction=.1";
    let call = bench.shell(script);
    assert_eq!(call.code, 2, "{}", call.err);
    assert!(call.err.contains("cannot write") && call.err.contains("room on its disk"), "{}", call.err);
    assert_eq!(bench.bytes("out/disc-pad/summary.json"), before);
    assert_eq!(bench.call("run disc-pad -q --set contact.friction=.1").code, 0, "the next run is not hindered");
}

#[test]
fn manual_pages_are_written_for_every_command() {
    let bench = Bench::new();
    let call = bench.call("man");
    assert!(call.code == 0 && call.out.contains(".TH wearshape 1"), "{}", call.err);
    assert_eq!(bench.call("man pages").code, 0);
    assert!(bench.read("pages/wearshape-run.1").contains("\\-\\-sample"));
    let call = bench.call("man /proc/pages");
    assert!(call.code == 2 && call.err.contains("/proc/pages"), "{}", call.err);
}
