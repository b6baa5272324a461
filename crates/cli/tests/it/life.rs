//! The life of a thickness that may wear off, and runs in time that end by distance or turns: against closed forms.

use approx::assert_relative_eq;

use crate::call::Bench;

fn life(bench: &Bench, scene: &str) -> serde_json::Value {
    let call = bench.call(&format!("run {scene} -o x"));
    assert_eq!(call.code, 0, "{scene}: {}", call.err);
    assert!(call.out.contains("\nlife      "), "{}", call.out);
    let summary: serde_json::Value = serde_json::from_str(&bench.read("x/summary.json")).unwrap();
    summary["pressure"].clone()
}

/// A punch that slides under a uniform pressure p = F / A recedes by k p v: it lasts h / (k p v), h / (k p) of way, and rubs mu F h / (k p) of work.
#[test]
fn a_uniform_punch_lasts_its_thickness_over_k_p_v() {
    let bench = Bench::new();
    let scene = "translating-punch --set tasks=[pressure] --set wear.k=[1e-9,0] --set wear.a=1 --set wear.b=1 --set load.moment=0 \
                 --set load.force=1_kN --set contact.friction=.25 --set sliding.speed=5 --set wear.wearable=4_mm --set wear.spread=.5";
    let life = life(&bench, scene)["life"].clone();
    let (pressure, speed, k) = (1000.0 / 600.0, 5.0, 1e-9);
    let seconds = 4.0 / (k * pressure * speed);
    let number = |key: &str| life[key].as_f64().unwrap();
    assert_relative_eq!(number("time_h"), seconds / 3600.0, max_relative = 1e-9);
    assert_relative_eq!(number("distance_km"), 4e-6 / (k * pressure), max_relative = 1e-9);
    assert_relative_eq!(number("friction_work_MJ"), 1e-9 * 0.25 * 1000.0 * speed * seconds, max_relative = 1e-9);
    assert!(life["revolutions"].is_null(), "{life}");
    let between = |place: usize| life["time_between_h"][place].as_f64().unwrap();
    assert_relative_eq!(between(0), seconds / 3600.0 / 1.5, max_relative = 1e-9);
    assert_relative_eq!(between(1), seconds / 3600.0 / 0.5, max_relative = 1e-9);
}

/// A shoe that a drum drags sinks by the feed V, and recedes by V cos(angle) along its normal: most in its middle.
#[test]
fn a_shoe_lasts_until_its_middle_is_gone() {
    let bench = Bench::new();
    let pressure = life(&bench, "drum-brake-block --set tasks=[pressure] --set wear.wearable=4_mm");
    let seconds = 4.0 / pressure["feed"]["force"].as_f64().unwrap();
    let number = |key: &str| pressure["life"][key].as_f64().unwrap();
    assert_relative_eq!(number("time_h"), seconds / 3600.0, max_relative = 1e-9);
    assert_relative_eq!(number("distance_km"), 2.5 * 200.0 * 3600.0 * number("time_h") / 1e6, max_relative = 1e-9);
    assert_relative_eq!(number("revolutions"), 2.5 * 3600.0 * number("time_h") / std::f64::consts::TAU, max_relative = 1e-9);
    assert!(pressure["life"]["time_between_h"].is_null());
}

/// A pad on a disc wears evenly: what it loses is the feed everywhere, although p and v differ.
#[test]
fn a_pad_on_a_disc_lasts_its_thickness_over_the_feed() {
    let bench = Bench::new();
    let pressure = life(&bench, "disc-pad --set wear.wearable=10_mm --set wear.counterface=fresh");
    let hours = 10.0 / pressure["feed"]["force"].as_f64().unwrap() / 3600.0;
    assert_relative_eq!(pressure["life"]["time_h"].as_f64().unwrap(), hours, max_relative = 1e-9);
}

#[test]
fn a_scene_without_a_thickness_has_no_life() {
    let bench = Bench::new();
    let call = bench.call("run disc-pad -o x");
    assert!(!call.out.contains("life") && !bench.read("x/summary.json").contains("life"), "{}", call.out);
}

#[test]
fn an_end_by_distance_or_turns_is_the_end_by_their_time() {
    let bench = Bench::new();
    let coarse = "--set mesh.degree=3 --set mesh.layers=1 -q";
    let punch = format!("run punch-wear {coarse} --set wear.until=");
    let drum = format!("run drum-brake-block {coarse} --set tasks=[wear] --set wear.until=");
    let turns = 0.5e-3 * std::f64::consts::TAU / 2.5;
    let cases = [
        (format!("{punch}{{distance=\"0.1_m\"}}"), format!("{punch}20")),
        (format!("{punch}{{time=\"20_s\"}}"), format!("{punch}20")),
        (format!("{drum}{{revolutions=0.5e-3}}"), format!("{drum}{turns:e}")),
    ];
    for (one, other) in cases {
        for (call, folder) in [(&one, "a"), (&other, "b")] {
            let call = bench.call(&format!("{call} -o {folder}"));
            assert!(call.code < 2, "{one}: {}", call.err);
        }
        for name in ["history.csv", "contact.csv", "scene.resolved.toml"] {
            assert!(bench.read(&format!("a/{name}")) == bench.read(&format!("b/{name}")), "{one}: {name}");
        }
    }
}

/// The speed of a drum's surface is omega R.
#[test]
fn a_distance_on_a_drum_is_a_time_by_its_radius() {
    let bench = Bench::new();
    let sets = "--set mesh.degree=3 --set mesh.layers=1 --set tasks=[wear]";
    let call = bench.call(&format!("run drum-brake-block -q {sets} --set wear.until={{distance=\"1e-6_km\"}} -o x"));
    assert!(call.code < 2, "{}", call.err);
    let scene: toml::Table = bench.read("x/scene.resolved.toml").parse().unwrap();
    assert_relative_eq!(scene["wear"]["until"].as_float().unwrap(), 1.0 / (2.5 * 200.0), max_relative = 1e-12);
}

#[test]
fn what_has_no_meaning_is_refused_with_what_to_do() {
    let bench = Bench::new();
    for (scene, words) in [
        ("punch-wear --set wear.until={revolutions=10}", "body 2 does not turn"),
        ("punch-wear --set wear.until={distance=-1}", "wear.until"),
        ("punch-wear --set wear.until={revolutions=0}", "wear.until"),
        ("punch-wear --set wear.until={distance=1,time=1}", "one end"),
        ("punch-wear --set wear.until={}", "empty table"),
        ("punch-wear --set wear.until={way=1}", "unknown key"),
        ("punch-wear --set wear.until=2_km", "km"),
        ("punch-wear --set wear.until={distance=9} --set schedule={time=[0,1],speed=[1,2]}", "schedule.speed"),
        ("annular-punch --set tasks=[wear] --set wear.until={distance=9}", "no single sliding speed"),
        ("disc-pad --set wear.wearable=0", "wear.wearable"),
        ("disc-pad --set wear.wearable=nan", "wear.wearable"),
        ("disc-pad --set wear.wearable=4 --set wear.spread=1", "out of range"),
        ("disc-pad --set wear.wearable=4 --set wear.spread=-.1", "out of range"),
        ("disc-pad --set wear.spread=.5", "add wear.wearable"),
        ("disc-pad --set wear.wearable=4 --set contact.friction=0", "contact.friction = 0 with wear.beta means no wear"),
        ("disc-pad --set wear.wearable=4 --set wear.beta=[0,1e-8]", "its wear factor is 0"),
        ("translating-punch --set wear.wearable=4 --set load.approach=1e-3", "does not follow the wear"),
        ("translating-punch --set body1.wearable=4 --set load.approach=1e-3", "leave body1.wearable out"),
        ("translating-punch --set body1.wearable=4 --set wear.wearable=4", "given twice"),
        ("translating-punch --set body2.wearable=4", "a life is that of body 1"),
        ("translating-punch --set body1.wearable=-1", "body1.wearable"),
        ("hertz-cylinder --set body1.wearable=1", "no wear rule"),
        ("drum-brake-block --set body1.wearable=lining", "neither a thickness nor a material"),
        ("lining-on-back --set body1.wearable=felt", "a material at the contact: lining, steel"),
        ("lining-on-back --set body1.wearable=steel", "not a layer of `steel` on another material"),
        ("lining-on-back --set body2.wearable=lining", "a life is that of body 1"),
        ("lining-on-back --set body1.wearable=4_foo", "wrong unit"),
    ] {
        let call = bench.check_and_run(scene);
        assert_eq!(call.code, 2, "{scene}: {}", call.out);
        assert!(call.err.contains(words), "{scene}: {}", call.err);
    }
    // Without the steady wear nothing uses it, and that is said.
    for sets in ["--set optimum.functional=uniform", "--set optimum.functional=wear-power --set optimum.q=2"] {
        let call = bench.call(&format!("check disc-pad --set wear.wearable=4 {sets}"));
        assert!(call.code == 0 && call.out.contains("wear.wearable"), "{sets}: {}{}", call.out, call.err);
    }
}

#[test]
fn no_more_may_wear_off_than_there_is() {
    let bench = Bench::new();
    let call = bench.call("run lining-on-back --set wear.wearable=400");
    assert_eq!(call.code, 2, "{}", call.out);
    assert!(call.err.contains("10 mm thick at the contact") && call.err.contains("wear.wearable"), "{}", call.err);
    let call = bench.call("run lining-on-back --set tasks=[wear] --set wear.until={depth=11}");
    assert_eq!(call.code, 2, "{}", call.out);
    assert!(call.err.contains("10 mm thick at the contact") && call.err.contains("wear.until"), "{}", call.err);
}

/// A run that is over before its layer is gone says that it tells no life.
#[test]
fn a_life_that_a_run_is_too_short_for_is_said_to_be_missing() {
    let bench = Bench::new();
    let scene = "punch-wear --set mesh={degree=4,layers=2} --set wear.wearable=1_mm --set wear.until";
    for (until, told) in [("1", false), ("steady", true)] {
        assert_eq!(bench.call(&format!("run {scene}={until} -q -o {until}")).code, 0);
        let summary: serde_json::Value = serde_json::from_str(&bench.read(&format!("{until}/summary.json"))).unwrap();
        assert_eq!(summary["wear"]["life"].is_object(), told, "{until}: {}", summary["wear"]);
        assert_eq!(summary["lints"].to_string().contains("no-life"), !told, "{until}: {}", summary["lints"]);
    }
}

/// A pad says of itself what of it may wear off, in its block of the scene.
#[test]
fn the_thickness_of_a_body_is_that_of_the_wear_rule() {
    let bench = Bench::new();
    let [body, rule] = ["body1", "wear"].map(|place| {
        life(&bench, &format!("drum-brake-block --set tasks=[pressure] --set {place}.wearable=4_mm --set wear.spread=.5"))
    });
    assert_eq!(body, rule);
}

/// The lining of a shoe is 10 mm thick everywhere; it lasts as long as 10 mm do.
#[test]
fn a_layer_is_as_thick_as_its_cells() {
    let bench = Bench::new();
    let [layer, thickness] =
        ["lining", "10"].map(|what| life(&bench, &format!("lining-on-back --set tasks=[pressure] --set body1.wearable={what}")));
    for key in ["time_h", "distance_km", "revolutions", "friction_work_MJ"] {
        let [a, b] = [&layer, &thickness].map(|pressure| pressure["life"][key].as_f64().unwrap());
        assert_relative_eq!(a, b, max_relative = 1e-12);
    }
}

/// A pad whose lining is glued on askew lasts as far as that goes where it is thinnest: at its left end along the normal, not at the bond's nearest point.
#[test]
fn a_layer_glued_on_askew_lasts_as_its_thinnest_place() {
    let bench = Bench::new();
    let blocks = "
[body1.geometry.blocks.points]
a = [-30, 100]
b = [30, 100]
c = [40, 106]
d = [-30, 104]
e = [30, 150]
f = [-30, 150]
[body1.geometry.blocks.curves]
face.line = ['a', 'b']
bond.line = ['d', 'c']
right.line = ['b', 'c']
left.line = ['a', 'd']
behind-right.line = ['c', 'e']
behind-left.line = ['d', 'f']
top.line = ['f', 'e']
[body1.geometry.blocks.cells]
lining = { curves = ['face', 'right', 'bond', 'left'], material = 'lining' }
back = { curves = ['bond', 'behind-right', 'top', 'behind-left'], material = 'steel' }
[body1.geometry.blocks.edges]
bottom = ['face']
top = ['top']
[body1.geometry.blocks.materials]
lining = { young = '1 GPa', poisson = 0.25 }
steel = 'steel'
";
    let punch = bench.call("new translating-punch").out;
    let without: Vec<&str> =
        punch.lines().filter(|line| !line.starts_with("body1.material") && !line.starts_with("body1.geometry")).collect();
    bench.file("askew.toml", &format!("{}{}", without.join("\n"), blocks));
    let [layer, thickness] =
        ["lining", "4"].map(|what| life(&bench, &format!("askew.toml --set tasks=[pressure] --set body1.wearable={what}")));
    let [a, b] = [&layer, &thickness].map(|pressure| pressure["life"]["time_h"].as_f64().unwrap());
    assert_relative_eq!(a, b, max_relative = 1e-8);
}
