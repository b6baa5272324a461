//! Reversals in time: averaged or one by one, by stroke and frequency, to a depth or volume, and broken off.

use std::time::{Duration, Instant};

use approx::assert_relative_eq;
use serde_json::Value;

use crate::call::{Bench, files};

/// The pad with a rule whose factor has no unit.
const PAD: &str = "reciprocating-pad -q --sample 41 --set wear.k=[1e-9,0]";

fn column(bench: &Bench, run: &str, name: &str) -> Vec<f64> {
    let table = bench.read(&format!("{run}/contact.csv"));
    let at = table.lines().next().unwrap().split(',').position(|known| known == name).unwrap();
    table.lines().skip(1).map(|row| row.split(',').nth(at).unwrap().parse().unwrap()).collect()
}

fn summary(bench: &Bench, run: &str) -> Value {
    serde_json::from_str(&bench.read(&format!("{run}/summary.json"))).unwrap()
}

fn run(bench: &Bench, out: &str, settings: &str) -> Value {
    let call = bench.call(&format!("run {PAD} -o {out} {settings}"));
    assert_eq!(call.code, 0, "{settings}: {}", call.err);
    summary(bench, out)
}

/// Largest difference of two lists over the range of the second.
fn apart(a: &[f64], b: &[f64]) -> f64 {
    let range = b.iter().copied().fold(f64::MIN, f64::max) - b.iter().copied().fold(f64::MAX, f64::min);
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / range
}

/// Two ways to one shape: the run in time that averages, and the shape solved for directly.
#[test]
fn a_run_that_averages_ends_on_the_shape_solved_for() {
    let bench = Bench::new();
    for (share, b) in [(0.5, 1.0), (0.3, 2.0)] {
        let settings = format!("--set sliding.reversing.share={share} --set wear.b={b}");
        run(&bench, "direct", &settings);
        let wear = run(&bench, "run", &format!("{settings} --set tasks=[wear] --set accuracy=1e-3"))["wear"].clone();
        assert_eq!((&wear["status"], &wear["turns"]["averaged"]), (&"steady".into(), &true.into()));
        for name in ["gap_um", "pressure_MPa", "pressure_back_MPa", "wear_rate_um_per_s"] {
            // Pressures at the corners of the pad follow their meshes.
            let inner = |folder: &str| column(&bench, folder, name)[2..39].to_vec();
            let off = if name.starts_with("wear") {
                inner("run").iter().zip(inner("direct")).map(|(a, b)| (a / b - 1.0).abs()).fold(0.0, f64::max)
            } else {
                apart(&inner("run"), &inner("direct"))
            };
            println!("share {share} b {b} {name}: {off:.1e}");
            assert!(off < 1e-3, "share {share} b {b} {name}: {off:e}");
        }
    }
}

/// Cycles that are long against wear are resolved, short ones averaged; the one draws near to the other with the length of a cycle.
#[test]
fn cycles_are_averaged_where_they_are_short_against_wear() {
    let bench = Bench::new();
    let wears = "--set tasks=[wear] --set accuracy=1e-3";
    let time = 8e4;
    let mean = run(&bench, "mean", &format!("{wears} --set wear.until={time}"));
    let gap = column(&bench, "mean", "gap_um");
    let mut last = f64::INFINITY;
    for (count, resolved) in [(8.0, true), (32.0, true), (40_000.0, false)] {
        let period = time / count;
        let found = run(&bench, "cycles", &format!("{wears} --set schedule={{repeat={count},period={period}}}"));
        let turns = &found["wear"]["turns"];
        assert_eq!(turns["averaged"].as_bool(), Some(!resolved), "{turns}");
        let ripple = turns["ripple"].as_f64().unwrap();
        let off = apart(&column(&bench, "cycles", "gap_um"), &gap);
        println!("{count} cycles: {off:.1e} from the mean, ripple {ripple:.1e}");
        assert!(off < 0.5 * last && off < 2.0 * ripple + 1e-6, "{count}: {off:e}, {ripple:e}");
        last = off;
        assert_relative_eq!(found["wear"]["time_s"].as_f64().unwrap(), time, max_relative = 1e-12);
        assert_relative_eq!(
            found["wear"]["volume_mm3"].as_f64().unwrap(),
            mean["wear"]["volume_mm3"].as_f64().unwrap(),
            max_relative = 1e-6
        );
        // The resolved scene is the scene.
        let written = bench.read("cycles/scene.resolved.toml");
        assert!(written.contains("repeat") && written.contains("period") && !written.contains("until"), "{written}");
        assert_eq!(bench.call("run cycles/scene.resolved.toml -q --sample 41 -o again").code, 0);
        assert_eq!(bench.read("again/contact.csv"), bench.read("cycles/contact.csv"));
    }
    // The same reversals as pieces.
    run(
        &bench,
        "pieces",
        &format!("{wears} --set sliding={{speed=50}} --set schedule={{time=[0,5000],speed=[1,-1],repeat=8,period=1e4}}"),
    );
    run(&bench, "cycles", &format!("{wears} --set schedule={{repeat=8,period=1e4}}"));
    assert_eq!(column(&bench, "pieces", "gap_um"), column(&bench, "cycles", "gap_um"));
}

/// The mean of too many cycles to be resolved counts what it leaves out.
#[test]
fn too_many_long_cycles_miss_the_accuracy_and_say_so() {
    let bench = Bench::new();
    let call =
        bench.call(&format!("run {PAD} -o x --set tasks=[wear] --set accuracy=1e-7 --set schedule={{repeat=20000,period=2e3}}"));
    let found = summary(&bench, "x");
    let turns = &found["wear"]["turns"];
    assert_eq!((call.code, &turns["averaged"]), (1, &true.into()), "{turns}");
    assert!(
        found["error"]["gap_relative"].as_f64() > turns["ripple"].as_f64() && turns["ripple"].as_f64() > Some(1e-7),
        "{found}"
    );
}

/// Once cycles are alike all but the last are taken at once: the end, and when a layer is worn off on the way, are those of the same reversals as pieces of a
/// schedule, which are stepped through.
#[test]
fn cycles_that_are_alike_are_taken_at_once() {
    let bench = Bench::new();
    let (count, half) = (30, 5e4);
    let wears = "--set tasks=[wear] --set accuracy=1e-5 --set body1.wearable=0.2mm";
    let leapt = run(&bench, "leapt", &format!("{wears} --set schedule={{repeat={count},period={}}}", 2.0 * half))["wear"].clone();
    let times: Vec<String> = (0..2 * count).map(|k| format!("{}", half * f64::from(k))).collect();
    let speeds = vec!["1,-1"; count as usize].join(",");
    let pieces = format!("--set sliding={{speed=50}} --set schedule={{time=[{}],speed=[{speeds}]}}", times.join(","));
    let stepped =
        run(&bench, "stepped", &format!("{wears} {pieces} --set wear.until={}", 2.0 * half * f64::from(count)))["wear"].clone();
    assert!(leapt["turns"]["resolved"].as_f64().unwrap() < 15.0, "{leapt}");
    assert!(leapt["steps"].as_u64().unwrap() < stepped["steps"].as_u64().unwrap() / 2, "{leapt}");
    for name in ["gap_um", "pressure_MPa"] {
        let off = apart(&column(&bench, "leapt", name), &column(&bench, "stepped", name));
        println!("{name}: {off:.1e}");
        assert!(off < 1e-5, "{name}: {off:e}");
    }
    for name in ["time_s", "distance_mm", "depth_um", "volume_mm3"] {
        assert_relative_eq!(leapt[name].as_f64().unwrap(), stepped[name].as_f64().unwrap(), max_relative = 1e-8);
    }
    for name in ["time_h", "distance_km"] {
        let life = [&leapt, &stepped].map(|wear| wear["life"][name].as_f64().unwrap());
        println!("{name}: {life:?}");
        assert_relative_eq!(life[0], life[1], max_relative = 1e-7);
    }
}

/// A thousand long cycles, some dozens of them stepped through; each of the others wears as much as the next.
#[test]
fn a_thousand_long_cycles_come_to_their_end() {
    let bench = Bench::new();
    let scene = "run drum-brake-block -q --sample 41 --set tasks=[wear] --set accuracy=1e-4";
    let depth = |count: f64| -> f64 {
        let call =
            bench.call(&format!("{scene} -o x{count} --set schedule={{repeat={count},period=0.02,time=[0,0.01],speed=[1,-1]}}"));
        assert_eq!(call.code, 0, "{}", call.err);
        let wear = summary(&bench, &format!("x{count}"))["wear"].clone();
        assert!(wear["turns"]["resolved"].as_f64().unwrap() < 50.0, "{wear}");
        assert_relative_eq!(wear["time_s"].as_f64().unwrap(), 0.02 * count, max_relative = 1e-12);
        wear["depth_um"].as_f64().unwrap()
    };
    let [some, more, many] = [60.0, 80.0, 1000.0].map(depth);
    assert_relative_eq!((many - more) / 920.0, (more - some) / 20.0, max_relative = 1e-6);
    assert!(apart(&column(&bench, "x1000", "gap_um"), &column(&bench, "x60", "gap_um")) < 1e-4);
}

#[test]
fn a_run_to_a_depth_or_a_volume_ends_there() {
    let bench = Bench::new();
    let wears = "--set tasks=[wear]";
    let depth = run(&bench, "depth", &format!("{wears} --set wear.until={{depth=\"5um\"}}"))["wear"].clone();
    assert_eq!(depth["status"], "worn-off");
    assert_relative_eq!(depth["depth_um"].as_f64().unwrap(), 5.0, max_relative = 1e-9);
    // The end at its time is the same.
    let time = depth["time_s"].as_f64().unwrap();
    let timed = run(&bench, "timed", &format!("{wears} --set wear.until={time}"))["wear"].clone();
    assert_relative_eq!(timed["depth_um"].as_f64().unwrap(), 5.0, max_relative = 1e-5);
    let volume = run(&bench, "volume", &format!("{wears} --set wear.until={{volume=\"5mm^3\"}}"))["wear"].clone();
    assert_relative_eq!(volume["volume_mm3"].as_f64().unwrap(), 5.0, max_relative = 1e-9);
    // b = 1: k F v t is worn off.
    assert_relative_eq!(volume["time_s"].as_f64().unwrap(), 5.0 / (1e-9 * 2000.0 * 50.0), max_relative = 1e-8);
    // A ball: pi h^2 R = k F s where it is stiff.
    let stiff = "--set body1.material.young=2.1e8 --set body2.material.young=2.1e8 --set accuracy=1e-3 --set wear.k=1e-7";
    let ball = "run hertz-sphere -q -o ball --set tasks=[wear] --set sliding.speed=10";
    let call = bench.call(&format!("{ball} {stiff} --set wear.until={{depth=\"3um\"}}"));
    assert_eq!(call.code, 0, "{}", call.err);
    let distance = summary(&bench, "ball")["wear"]["distance_mm"].as_f64().unwrap();
    let (h, r) = (3e-3, 5.0);
    assert_relative_eq!(distance, std::f64::consts::PI * h * h * (r - h / 3.0) / (1e-7 * 21.0), max_relative = 2e-3);
}

#[test]
fn a_stroke_and_a_frequency_are_a_speed_with_cycles_in_the_life() {
    let bench = Bench::new();
    let lasts = "--set wear.wearable=1 --set wear.spread=.5";
    let cycle = "--set sliding={cycle={stroke=\"25mm\",frequency=\"1Hz\"}}";
    let found = run(&bench, "cycle", &format!("{lasts} {cycle} --set tasks=[pressure,shape,wear]"));
    let plain = run(&bench, "plain", &format!("{lasts} --set tasks=[pressure,shape,wear]"));
    assert_eq!(bench.read("cycle/contact.csv"), bench.read("plain/contact.csv"));
    let life = |summary: &Value, key: &str| summary.pointer(key).and_then(Value::as_f64);
    // 1 mm over k p v, with p = F/A in the mean.
    let hours = 1.0 / (1e-9 * 2.5 * 50.0) / 3600.0;
    assert_relative_eq!(life(&found, "/pressure/life/time_h").unwrap(), hours, max_relative = 1e-7);
    assert_relative_eq!(life(&found, "/pressure/life/cycles").unwrap(), 3600.0 * hours, max_relative = 1e-7);
    assert_eq!(life(&plain, "/pressure/life/cycles"), None);
    // From the flat start the corners wear first: they end the layer a little earlier.
    let worn = life(&found, "/wear/life/time_h").unwrap();
    let deepest = 1e-3 * (life(&found, "/wear/depth_um").unwrap()) - 2.5e-9 * 50.0 * life(&found, "/wear/time_s").unwrap();
    assert_relative_eq!(worn, hours * (1.0 - deepest), max_relative = 1e-6);
    assert_relative_eq!(life(&found, "/wear/life/time_between_h/0").unwrap(), worn / 1.5, max_relative = 1e-12);
    assert_relative_eq!(life(&found, "/wear/life/distance_km").unwrap(), worn * 3600.0 * 50.0 * 1e-6, max_relative = 1e-9);
    // A layer that is gone before the run is steady.
    let soon = run(&bench, "soon", &format!("{cycle} --set wear.wearable=\"5um\" --set tasks=[wear]"))["wear"].clone();
    let depth = run(&bench, "depth", &format!("{cycle} --set wear.until={{depth=\"5um\"}} --set tasks=[wear]"))["wear"].clone();
    assert_relative_eq!(
        soon["life"]["time_h"].as_f64().unwrap() * 3600.0,
        depth["time_s"].as_f64().unwrap(),
        max_relative = 1e-4
    );
    // Without friction nothing turns with the sliding, and a surface without bodies has nothing that does.
    let call = bench.call(&format!("run {PAD} -o smooth {cycle} --set contact.friction=0"));
    assert_eq!(call.code, 0, "{}", call.err);
    assert!(!bench.read("smooth/scene.resolved.toml").contains("reversing"));
    assert_eq!(bench.call(&format!("run rectangular-punch -q -o punch {cycle}")).code, 0);
}

/// A broken recording of an averaged run, and of one that resolves its cycles, are continued to the same bytes.
#[test]
fn reversals_that_break_off_are_continued_to_the_same_bytes() {
    let bench = Bench::new();
    for (schedule, bytes) in [
        ("", 100_000),
        (" --set schedule={repeat=20,period=4e3}", 200_000),
        // Some are taken at once.
        (" --set schedule={repeat=100,period=1e5}", 400_000),
    ] {
        let scene = format!("{PAD} --set tasks=[wear] --set accuracy=1e-5{schedule}");
        assert!(bench.call(&format!("run {scene} -o whole")).code < 2);
        let recording = bench.path("x.partial/run.mcap");
        let mut child = bench.start(&format!("run {scene} -o x"));
        let begin = Instant::now();
        while std::fs::metadata(&recording).map_or(0, |data| data.len()) < bytes {
            assert!(child.try_wait().unwrap().is_none(), "the run was over before it could be killed");
            assert!(begin.elapsed() < Duration::from_secs(120), "the recording does not grow");
            std::thread::sleep(Duration::from_micros(200));
        }
        child.kill().unwrap();
        child.wait().unwrap();
        let call = bench.call(&format!("run {scene} -o x --resume"));
        assert!(call.code < 2, "{}", call.err);
        for name in files(&bench.path("whole")).iter().filter(|name| *name != "timing.json") {
            assert!(bench.bytes(&format!("whole/{name}")) == bench.bytes(&format!("x/{name}")), "{schedule}: {name}");
        }
        std::fs::remove_dir_all(bench.path("x")).unwrap();
        std::fs::remove_dir_all(bench.path("whole")).unwrap();
    }
}

#[test]
fn what_has_no_meaning_is_refused_with_a_remedy() {
    let bench = Bench::new();
    let pad = "reciprocating-pad --set tasks=[wear]";
    let once = "schedule={time=[0,1],speed=[1,-1]";
    let cases = [
        (format!("{pad} --set schedule={{repeat=0,period=1}}"), "no whole number", "repeat = 1000"),
        (format!("{pad} --set schedule={{repeat=1.5,period=1}}"), "no whole number", "repeat = 1000"),
        (format!("{pad} --set schedule={{repeat=1e30,period=1}}"), "no whole number", "repeat = 1000"),
        (format!("{pad} --set schedule={{repeat=10}}"), "how long a cycle takes", "period"),
        (format!("{pad} --set schedule={{period=2}}"), "no number of times", "repeat"),
        (format!("{pad} --set schedule={{repeat=9,period=-1}}"), "schedule.period = -1", "greater than 0"),
        (format!("{pad} --set {once},repeat=9,period=2}}"), "pieces of its own", "sliding.reversing"),
        (format!("{pad} --set schedule={{repeat=9,period=2}} --set sliding.reversing.share=1"), "one way all the time", "leave"),
        (format!("punch-wear --set {once},repeat=9,period=2}} --set wear.until=9"), "another end", "keep one"),
        (format!("{pad} --set wear.until={{depth=-1}}"), "wear.until.depth", "greater than 0"),
        (format!("{pad} --set wear.until={{depth=1,volume=1}}"), "one end", "keep one of"),
        ("reciprocating-pad --set sliding={cycle={stroke=1}}".into(), "its number a second", "frequency"),
        ("reciprocating-pad --set sliding={cycle={stroke=0,frequency=1}}".into(), "stroke", "greater than 0"),
        ("reciprocating-pad --set sliding={speed=3,cycle={stroke=1,frequency=1}}".into(), "both sliding.cycle", "keep one"),
        ("drum-brake-block --set sliding={cycle={stroke=1,frequency=1}}".into(), "straight line", "sliding.omega"),
    ];
    for (scene, words, remedy) in &cases {
        let call = bench.check_and_run(scene);
        assert_eq!(call.code, 2, "{scene}: {}", call.out);
        assert!(call.err.contains(words) && call.err.contains(remedy), "{scene}: {}", call.err);
    }
    for (schedule, words) in [
        ("{time=[0,1],force=[1,2],repeat=9,period=2}", "at one speed"),
        ("{time=[0,1],speed=[1,1],repeat=9,period=2}", "at one speed"),
        ("{time=[0,1],speed=[1,-1],repeat=9,period=1}", "before its last piece"),
        ("{time=[0,1],speed=[1,-1],repeat=9}", "how long a cycle takes"),
    ] {
        let call = bench.check_and_run(&format!("punch-wear --set schedule={schedule}"));
        assert!(call.code == 2 && call.err.contains(words), "{schedule}: {}", call.err);
    }
}
