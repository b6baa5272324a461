//! Balls and cylinders that wear in time, from scene to folder.

use crate::call::Bench;

#[test]
fn a_pin_on_disc_writes_its_scar_and_groove() {
    let bench = Bench::new();
    let call = bench.call("run pin-on-disc -q --set accuracy=1e-2");
    assert_eq!(call.code, 0, "{}", call.err);
    let wear = &bench.summary("pin-on-disc")["wear"];
    assert_eq!(wear["status"], "time-reached");
    let number = |key: &str| wear.pointer(key).and_then(serde_json::Value::as_f64).unwrap();
    assert!((number("/scar_mm") - number("/groove/width_mm")).abs() < 1e-12 && number("/scar_mm") > 0.8);
    let groove = bench.read("out/pin-on-disc/groove.csv");
    assert!(groove.starts_with("y_mm,depth_um\n") && groove.lines().count() == 202, "{groove}");
    let header = bench.read("out/pin-on-disc/history.csv");
    assert!(header.lines().next().unwrap().ends_with(",scar_mm"), "{header}");
    assert!(bench.read("out/pin-on-disc/report.html").contains("width of the scar"));
    assert!(bench.summary("pin-on-disc")["lints"].to_string().contains("groove-mean"));
    // Without a track the disc is a long plate, and the ball alone is changed by its wear.
    let call = bench.call(
        "run hertz-sphere -q --set tasks=[wear] --set sliding.speed=10 --set wear.k=1e-7 --set wear.until=1 --set accuracy=1e-2",
    );
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(bench.read("out/hertz-sphere/scene.resolved.toml").contains("counterface = \"fresh\""));
    assert!(!bench.path("out/hertz-sphere/groove.csv").exists());
}

#[test]
fn what_is_no_round_contact_that_wears_is_refused_with_a_remedy() {
    let bench = Bench::new();
    for (change, says, remedy) in [
        ("wear.until=steady", "no pressure is steady", "give a time"),
        ("contact.shear=true", "no symmetry about its axis", "contact.shear = false"),
        ("sliding.track_radius=-1", "radius of the track", "sliding.track_radius"),
        ("sliding.track_radius=0", "radius of the track", "sliding.track_radius"),
        ("sliding={omega=3}", "at one speed", "track_radius"),
        ("sliding={speed=3,omega=3,track_radius=15}", "both `sliding.speed` and `sliding.omega`", "keep one"),
        ("sliding={speed=0,track_radius=15}", "nothing slides", "sliding.speed"),
        ("wear.counterface=fresh", "revolves under the ball", "revolving"),
        ("sliding={speed=100} --set wear.counterface=revolving", "no closed track", "track_radius"),
        ("wear.k=[0,1e-8]", "does not wear", "give both bodies"),
        ("wear={k=[1e-8,1e-8],b=[1,2],until=2}", "same power", "one b"),
        ("wear.until=1e9", "over the", "end the run earlier"),
        ("tasks=[contact,wear]", "the task wear alone", "tasks = [\"wear\"]"),
        ("schedule={time=[0,1],force=[1,2]}", "one load and speed", "schedule"),
    ] {
        let call = bench.check_and_run(&format!("pin-on-disc --set {change}"));
        assert_eq!(call.code, 2, "{change}: {}", call.out);
        assert!(call.err.contains(says) && call.err.contains(remedy), "{change}: {}", call.err);
    }
    for scene in [
        "hertz-cylinder --set tasks=[wear] --set sliding.speed=10 --set wear={k=1e-7,until=1}",
        "translating-punch",
        "punch-wear",
    ] {
        let call = bench.check_and_run(&format!("{scene} --set sliding.track_radius=15"));
        assert_eq!(call.code, 2, "{scene}: {}", call.out);
        assert!(call.err.contains("track_radius"), "{scene}: {}", call.err);
    }
}

/// A round run that was killed goes on to the same bytes.
#[test]
fn a_killed_run_of_a_ball_is_continued_to_the_same_bytes() {
    let bench = Bench::new();
    let scene =
        "hertz-sphere -q --set tasks=[wear] --set sliding.speed=10 --set wear.k=1e-7 --set wear.until=5 --set accuracy=1e-3";
    assert_eq!(bench.call(&format!("run {scene} -o whole")).code, 0);
    let recording = bench.path("x.partial/run.mcap");
    let mut child = bench.start(&format!("run {scene} -o x"));
    let begin = std::time::Instant::now();
    while std::fs::metadata(&recording).map_or(0, |data| data.len()) < 300_000 {
        assert!(child.try_wait().unwrap().is_none(), "the run was over before it could be killed");
        assert!(begin.elapsed().as_secs() < 120, "the recording does not grow");
        std::thread::sleep(std::time::Duration::from_micros(200));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let call = bench.call(&format!("run {scene} -o x --resume"));
    assert_eq!(call.code, 0, "{}", call.err);
    for name in crate::call::files(&bench.path("whole")).iter().filter(|name| *name != "timing.json") {
        assert!(bench.bytes(&format!("whole/{name}")) == bench.bytes(&format!("x/{name}")), "{name}");
    }
}

/// What the model of a ball on a disc does not hold for is no answer: a track as short as the scar, a groove deeper than the wear of the ball.
#[test]
fn a_ball_on_a_disc_beyond_its_model_is_told() {
    let bench = Bench::new();
    let call = bench.call_with(&["run", "pin-on-disc", "--set", "sliding.track_radius=0.3", "--set", "accuracy=1e-2"]);
    assert_eq!(call.code, 2, "{}", call.out);
    assert!(call.err.contains("sliding.track_radius") && call.err.contains("the track is a circle of 0.3"), "{}", call.err);
    let call = bench.call("run pin-on-disc --set wear.k=[1e-8,1e-5] --set accuracy=1e-2 --set wear.until=10");
    assert_eq!(call.code, 1, "{} {}", call.out, call.err);
    assert!(call.out.contains("this answer is none"), "{}", call.out);
}

/// To and fro over a stroke each point of the plate is passed as often as on a disc whose track is as long.
#[test]
fn a_stroke_wears_the_groove_of_a_track_of_its_length() {
    let bench = Bench::new();
    let run = |sliding: &str, name: &str| {
        let sliding = format!("sliding={sliding}");
        let set = ["--set", &sliding, "--set", "wear.until=100", "--set", "accuracy=1e-2"];
        let call = bench.call_with(&[&["run", "pin-on-disc", "-q", "-o", name][..], &set].concat());
        assert_eq!(call.code, 0, "{sliding}: {}", call.err);
        let summary: serde_json::Value = serde_json::from_str(&bench.read(&format!("{name}/summary.json"))).unwrap();
        ["/depth_um", "/groove/depth_um", "/groove/volume_mm3"].map(|key| summary["wear"].pointer(key).unwrap().as_f64().unwrap())
    };
    let (stroke, frequency) = (12.0, 2.5);
    let found = run(&format!("{{cycle={{stroke={stroke},frequency={frequency}}}}}"), "stroke");
    let track = stroke / (2.0 * std::f64::consts::PI);
    let disc = run(&format!("{{speed={},track_radius={track:?}}}", 2.0 * stroke * frequency), "disc");
    for (found, disc) in found.iter().zip(disc) {
        assert!((found / disc - 1.0).abs() < 1e-9, "{found} {disc}");
    }
    // k F s of the plate.
    assert!((found[2] / (5e-9 * 5.0 * 2.0 * stroke * frequency * 100.0) - 1.0).abs() < 1e-9, "{}", found[2]);
    let call = bench.call("run pin-on-disc --set sliding={cycle={stroke=1,frequency=1}} --set accuracy=1e-2");
    assert!(call.code == 2 && call.err.contains("the stroke is 1 mm"), "{}", call.err);
    let call =
        bench.call("run pin-on-disc --set sliding={cycle={stroke=10,frequency=1}} --set wear.k=[0,1e-8] --set accuracy=1e-2");
    assert!(call.code == 2 && call.err.contains("body 1 does not wear"), "{}", call.err);
}

/// On a disc speed, turns and track tell one another.
#[test]
fn a_track_ties_speed_and_turns() {
    let bench = Bench::new();
    let run = |sliding: &str, until: &str, name: &str| {
        let (sliding, until) = (format!("sliding={sliding}"), format!("wear.until={until}"));
        let set = ["--set", &sliding, "--set", &until, "--set", "accuracy=1e-2"];
        let call = bench.call_with(&[&["run", "pin-on-disc", "-q", "-o", name][..], &set].concat());
        assert_eq!(call.code, 0, "{sliding} {until}: {}", call.err);
        let summary: serde_json::Value = serde_json::from_str(&bench.read(&format!("{name}/summary.json"))).unwrap();
        summary["wear"]["volume_mm3"].as_f64().unwrap()
    };
    let turns = 1e3 / (2.0 * std::f64::consts::PI * 20.0);
    let straight = run("{speed=100,track_radius=20}", "10", "a");
    for (number, sliding) in ["{speed=100,track_radius=20}", "{omega=5,track_radius=20}"].into_iter().enumerate() {
        for (way, until) in ["{distance=1000}".to_string(), format!("{{revolutions={turns:e}}}")].iter().enumerate() {
            let volume = run(sliding, until, &format!("b{number}{way}"));
            assert!((volume / straight - 1.0).abs() < 1e-6, "{sliding} {until}: {volume} {straight}");
        }
    }
}

/// Until a volume steps are about as short as until the time that it takes: one alone passes over all points that come into contact on the way.
#[test]
fn a_contact_worn_to_a_volume_takes_the_steps_of_one_worn_for_a_time() {
    let bench = Bench::new();
    let wear = |until: &str| {
        let scene = "run hertz-cylinder -q --set tasks=[wear] --set sliding.speed=100 --set wear.k=1e-7 --set accuracy=1e-3";
        let call = bench.call(&format!("{scene} --set wear.until={until}"));
        assert_eq!(call.code, 0, "{}", call.err);
        bench.summary("hertz-cylinder")["wear"].clone()
    };
    let by_volume = wear("{volume=0.01}");
    let by_time = wear(&by_volume["time_s"].to_string());
    let steps = [&by_volume, &by_time].map(|wear| wear["steps"].as_f64().unwrap());
    assert!(steps[0] > 0.5 * steps[1] && steps[1] > 5.0, "{steps:?}");
    let depths = [&by_volume, &by_time].map(|wear| wear["depth_um"].as_f64().unwrap());
    assert!((depths[0] - depths[1]).abs() < 1e-3 * depths[1], "{depths:?}");
}

/// A crown touches on a point of a coarse mesh, about which the punch would tilt: such levels are left out.
#[test]
fn a_crown_that_touches_on_a_point_of_a_coarse_mesh_is_worn() {
    let bench = Bench::new();
    let call = bench.call("run punch-wear -q --set contact.gap.crown=0.1 --set wear.until=1 --set accuracy=1e-2");
    assert_eq!(call.code, 0, "{}", call.err);
}
