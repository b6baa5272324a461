//! `--set`: types, alternatives, unused keys, and errors that name the flag.

use crate::call::Bench;

fn resolved(args: &str) -> toml::Table {
    let bench = Bench::new();
    let call = bench.call(&format!("run {args} -o out/x -q"));
    assert_eq!(call.code, 0, "{args}: {}", call.err);
    bench.read("out/x/scene.resolved.toml").parse().unwrap()
}

#[test]
fn numbers_may_begin_with_a_point_and_units_need_no_quotes() {
    let scene = resolved("drum-brake-block --set tasks=[pressure] --set contact.friction=.4 --set load.force=12_kN");
    assert_eq!(scene["contact"]["friction"].as_float(), Some(0.4));
    assert_eq!(scene["load"]["force"].as_float(), Some(12000.0));
    let scene = resolved("translating-punch --set tasks=[pressure] --set load.moment=-.5");
    assert_eq!(scene["load"]["moment"].as_float(), Some(-0.5));
}

#[test]
fn bare_words_in_lists_are_strings() {
    let scene = resolved("drum-brake-block --set tasks=[pressure,shape]");
    assert_eq!(scene["tasks"].as_array().map(Vec::len), Some(2));
    let twice = Bench::new().call("run drum-brake-block --set tasks=[shape,shape]");
    assert!(twice.code == 2 && twice.err.contains("twice"), "{}", twice.err);
    let scene = resolved("drum-brake-ring --set tasks=[pressure] --set body1.support={left=[x]}");
    let support = scene["body1"]["support"].as_table().unwrap();
    assert_eq!(support.keys().collect::<Vec<_>>(), ["left"]);
}

#[test]
fn text_that_is_not_toml_is_a_string() {
    let scene = resolved("drum-brake-block --set tasks=[pressure] --set title=My_own_shoe");
    assert_eq!(scene["title"].as_str(), Some("My own shoe"));
}

#[test]
fn alternatives_replace_each_other_and_the_later_wins() {
    let scene = resolved("drum-brake-block --set tasks=[pressure] --set wear.k=1e-7");
    assert!(scene["wear"].get("beta").is_none() && scene["wear"].get("k").is_some());
    let scene = resolved("drum-brake-block --set tasks=[pressure] --set wear.k=1e-7 --set wear.beta=3e-4");
    assert!(scene["wear"].get("k").is_none());
    assert_eq!(scene["wear"]["beta"][0].as_float(), Some(3e-4));
    let scene = resolved("drum-brake-block --set tasks=[pressure] --set mesh.degree=8");
    assert!(scene.get("accuracy").is_none());
    let scene = resolved("drum-brake-block --set tasks=[pressure] --set mesh.degree=8 --set accuracy=1e-4");
    assert!(scene.get("mesh").is_none());
    let scene = resolved("translating-punch --set tasks=[pressure] --set load.tilt=0");
    assert!(scene["load"].get("moment").is_none());
    let scene = resolved("translating-punch --set tasks=[pressure] --set load.tilt=0 --set load.moment=100");
    assert!(scene["load"].get("tilt").is_none());
}

#[test]
fn a_bare_surface_replaces_both_bodies() {
    let scene = resolved(
        "translating-punch --set tasks=[pressure] --set surface.rectangular-punch={x=[-30,30],y=[-5,5]} --set load.about=[0,0]",
    );
    assert!(scene.get("body1").is_none() && scene.get("body2").is_none());
    assert!(scene["surface"]["rectangular-punch"].get("x").is_some());
}

#[test]
fn another_geometry_replaces_the_one_before() {
    let bench = Bench::new();
    let call = bench.call(
        "check drum-brake-block --set body1.geometry.ring-segment={inner=200,outer=220,x=[-100,100]} --set load.edge=outer",
    );
    assert_eq!(call.code, 0, "{}", call.err);
    let call =
        bench.call("check drum-brake-block --set body1.geometry.rectangle.x=[-30,30] --set body1.geometry.rectangle.z=[200,300]");
    assert_eq!(call.code, 2);
    assert!(call.err.contains("cannot touch") || call.err.contains("no edge `inner`"), "{}", call.err);
}

#[test]
fn a_key_that_the_choices_do_not_use_is_listed() {
    let bench = Bench::new();
    let call = bench.call("run drum-brake-block --set tasks=[pressure] --set optimum.q=3 --set load.width=5");
    assert_eq!(call.code, 0, "{}", call.err);
    assert_eq!(bench.summary("drum-brake-block")["unused_keys"], serde_json::json!(["load.width", "optimum.q"]));
    let call = bench.call("run annular-punch --set tasks=[pressure] --set thickness=5");
    assert_eq!(call.code, 0, "{}", call.err);
    assert_eq!(bench.summary("annular-punch")["unused_keys"], serde_json::json!(["thickness"]));
}

#[test]
fn an_error_in_a_setting_names_the_flag() {
    let bench = Bench::new();
    for (setting, message) in [
        ("thickness=-3", "negative thickness"),
        ("thicknes=3", "unknown key `thicknes`"),
        ("body1.material.yong=3", "unknown key `yong`"),
        ("tasks=[presure]", "unknown word `presure`"),
        ("load.force=ten", "not a force"),
        ("thickness.x=3", "is a value, not a table"),
        ("wear.beta.2=1e-4", "`wear.beta` is a list with the places 0 to 1"),
        ("thickness", "has no `=`"),
        ("=3", "key is empty"),
        ("contact.friction=-1", "negative friction"),
        ("optimum.functional=steddy", "unknown word `steddy`"),
    ] {
        let call = bench.call(&format!("check drum-brake-block --set {setting}"));
        assert_eq!(call.code, 2, "{setting}");
        assert!(call.err.contains(message), "{setting}: {}", call.err);
        assert!(call.err.contains(&format!("--set {setting}")), "{setting}: {}", call.err);
        assert!(call.err.contains("remedy: "), "{setting}: {}", call.err);
    }
}

/// Where the short form of a key stands in the scene, a key below it makes a table of it.
#[test]
fn a_key_below_a_short_form_makes_a_table_of_it() {
    let bench = Bench::new();
    std::fs::write(bench.path("worn.csv"), "s_mm,gap_um\n-50,1\n0,0\n50,1\n").unwrap();
    let resolved = |settings: &[&str]| -> toml::Table {
        let settings = settings.iter().flat_map(|setting| ["--set", setting]);
        let call = bench.call_with(
            &[&["run", "punch-wear", "-o", "out", "--set", "accuracy=1e-2"], &settings.collect::<Vec<_>>()[..]].concat(),
        );
        assert!(call.code <= 1, "{}", call.err);
        bench.read("out/scene.resolved.toml").parse().unwrap()
    };
    let scene = resolved(&["contact.gap.crown=10 um", "wear.until=1 h", "wear.until.depth=1 um"]);
    assert_eq!(scene["contact"]["gap"].as_table().unwrap().keys().collect::<Vec<_>>(), ["crown"]);
    assert_eq!(scene["wear"]["until"].as_table().unwrap().keys().collect::<Vec<_>>(), ["depth"]);
    let scene = resolved(&["contact.gap=worn.csv", "contact.gap.crown=10 um", "wear.until.time=1 s", "wear.until.distance=1 m"]);
    assert_eq!(scene["contact"]["gap"].as_table().unwrap().keys().collect::<Vec<_>>(), ["crown", "profile"]);
    assert_eq!(scene["contact"]["gap"]["profile"]["gap_um"].as_array().unwrap().len(), 3);
    // 1 m at 5 mm/s.
    assert_eq!(scene["wear"]["until"].as_float(), Some(200.0));
}

#[test]
fn infinite_q_is_a_number() {
    let bench = Bench::new();
    let call = bench.call("run annular-punch --set tasks=[pressure] --set optimum.functional=wear-power --set optimum.q=inf");
    assert_eq!(call.code, 0, "{}", call.err);
    let summary = bench.summary("annular-punch");
    assert!(summary["pressure"].get("q").is_none(), "a number that is not finite is an absent key");
    let scene: toml::Table = bench.read("out/annular-punch/scene.resolved.toml").parse().unwrap();
    assert_eq!(scene["optimum"]["q"].as_float(), Some(f64::INFINITY));
}
