//! Broken scenes: each ends with exit 2, names the place, and says what to write instead.

use crate::call::Bench;

const SOUND: &str = r#"title = "test"
units = "N-mm"
kinematics = "plane-stress"
thickness = 10
tasks = ["pressure", "shape"]
accuracy = 1e-6
body1.material = { young = "210 GPa", poisson = 0.3 }
body1.geometry.shoe-block = { radius = 200, half_angle = "30 deg", top = 300 }
body1.support = { left = ["x"], right = ["x"] }
body2.material = { young = "210 GPa", poisson = 0.3 }
body2.geometry.ring = { inner = 100, outer = 200, centre = [0, 0] }
body2.support = { inner = ["x", "z"] }
contact = { edges = ["inner", "outer"], friction = 0.25, gap = 0 }
sliding = { omega = "2.5 rad/s" }
load = { edge = "top", as = "pressure", force = "10 kN" }
wear = { beta = [2e-4, 0], a = 1, b = 0.5 }
optimum = { functional = "steady" }
"#;

/// Checks a scene with one replacement: exit 2, the line of the replacement, words of the message and of the remedy.
fn broken(from: &str, to: &str, message: &str, remedy: &str) {
    assert!(SOUND.contains(from), "{from} is not in the sound scene");
    let text = SOUND.replacen(from, to, 1);
    let line = SOUND[..SOUND.find(from).unwrap()].matches('\n').count() + 1;
    refused(&text, Some(line), message, remedy);
}

fn refused(text: &str, line: Option<usize>, message: &str, remedy: &str) {
    let bench = Bench::new();
    bench.file("scene.toml", text);
    bench.check_and_run("scene.toml");
    for command in ["check scene.toml", "run scene.toml"] {
        let call = bench.call(command);
        assert_eq!(call.code, 2, "{command}: {}{}", call.out, call.err);
        assert!(call.err.contains(message), "{command}: no `{message}` in\n{}", call.err);
        let said = call.err.split("remedy: ").nth(1).unwrap_or_default();
        assert!(said.contains(remedy), "{command}: no remedy `{remedy}` in\n{}", call.err);
        if let Some(line) = line {
            assert!(call.err.contains(&format!("scene.toml:{line}:")), "{command}: not line {line}:\n{}", call.err);
        }
        assert!(call.err.contains("--> "), "{command}: no place:\n{}", call.err);
        assert!(call.out.is_empty(), "{command}: errors belong on stderr: {}", call.out);
    }
    assert!(!bench.path("out").exists(), "a scene that is refused on reading leaves no folder");
}

#[test]
fn the_sound_scene_is_sound() {
    let bench = Bench::new();
    bench.file("scene.toml", SOUND);
    let call = bench.call("check scene.toml");
    assert_eq!(call.code, 0, "{}", call.err);
}

#[test]
fn an_unknown_key_is_named_with_the_one_meant() {
    broken("thickness = 10", "thicknes = 10", "unknown key `thicknes`", "did you mean `thickness`?");
}

#[test]
fn an_unknown_key_inside_a_table_is_named() {
    broken("friction = 0.25", "frction = 0.25", "unknown key `frction`", "`friction`");
}

#[test]
fn a_wrong_unit_is_named_with_the_known_ones() {
    broken("force = \"10 kN\"", "force = \"10 kg\"", "`kg` does not measure a force", "N, kN");
}

#[test]
fn a_negative_thickness_is_refused() {
    broken("thickness = 10", "thickness = -10", "negative thickness", "greater than 0");
}

#[test]
fn a_missing_load_is_refused() {
    let text = SOUND.lines().filter(|line| !line.starts_with("load")).collect::<Vec<_>>().join("\n");
    refused(&text, None, "`load` is missing", "add `load = ");
}

#[test]
fn a_load_without_force_is_refused() {
    broken(", force = \"10 kN\"", "", "`load.force` is missing", "load.force = ");
}

#[test]
fn a_modulus_of_zero_is_refused() {
    broken("young = \"210 GPa\"", "young = 0", "zero Young's modulus", "greater than 0");
}

#[test]
fn a_half_angle_of_90_degrees_is_refused() {
    broken("\"30 deg\"", "\"90 deg\"", "half angle 90", "less than 90 deg");
}

#[test]
fn negative_friction_is_refused() {
    broken("friction = 0.25", "friction = -0.25", "negative friction", "0 or more");
}

#[test]
fn a_shape_at_a_singular_q_is_refused_with_a_regular_one() {
    broken(
        "functional = \"steady\"",
        "functional = \"wear-power\", q = 0.6666666666666666",
        "singular",
        "0.7 (a minimum), cap the pressure with optimum.p_max",
    );
}

#[test]
fn a_wrong_type_is_named() {
    broken("friction = 0.25", "friction = \"a lot\"", "wrong type", "write a number");
}

#[test]
fn a_boolean_for_a_length_is_named() {
    broken("thickness = 10", "thickness = true", "found boolean `true`", "a length as a number in mm");
}

#[test]
fn an_empty_file_is_refused() {
    refused("", Some(1), "the scene is empty", "wearshape new");
    refused("# only a remark\n\n", Some(1), "the scene is empty", "wearshape new");
}

#[test]
fn what_is_not_toml_is_shown_in_its_line() {
    broken("accuracy = 1e-6", "accuracy = = 1e-6", "not TOML", "key = value");
}

#[test]
fn a_key_written_twice_is_refused() {
    broken("sliding =", "thickness =", "duplicate key", "");
}

#[test]
fn missing_units_are_refused() {
    let text = SOUND.replace("units = \"N-mm\"\n", "");
    refused(&text, None, "`units` is missing", "units = \"N-mm\"");
}

#[test]
fn unknown_units_are_refused() {
    broken("units = \"N-mm\"", "units = \"kg-m\"", "unknown word `kg-m`", "N-mm");
}

#[test]
fn an_unknown_word_is_named_with_the_one_meant() {
    broken("\"plane-stress\"", "\"plane-stres\"", "unknown word `plane-stres`", "did you mean `plane-stress`?");
}

#[test]
fn an_unknown_edge_is_named_with_the_known_ones() {
    broken("edge = \"top\"", "edge = \"tpo\"", "no edge `tpo`", "did you mean `top`?");
    broken("[\"inner\", \"outer\"]", "[\"inside\", \"outer\"]", "no edge `inside`", "inner");
    broken("right = [\"x\"]", "rigth = [\"x\"]", "no edge `rigth`", "`right`");
}

#[test]
fn a_support_around_the_axis_of_a_plane_body_is_refused() {
    broken("left = [\"x\"]", "left = [\"phi\"]", "\"phi\"", "\"x\" or \"z\"");
}

#[test]
fn a_ratio_of_one_half_is_refused() {
    broken("poisson = 0.3", "poisson = 0.5", "0.5", "0.49999");
}

#[test]
fn a_ratio_next_to_one_half_is_refused_at_the_material_where_volume_counts() {
    let bench = Bench::new();
    let call = bench.call("run drum-brake-block -o x --set kinematics=plane-strain --set body1.material.poisson=0.4999999");
    assert_eq!(call.code, 2, "{}", call.err);
    assert!(call.err.contains("--set body1.material.poisson") && call.err.contains("at most 0.49999"), "{}", call.err);
    assert_eq!(bench.call("check drum-brake-block --set body1.material.poisson=0.4999999").code, 0);
}

#[test]
fn arcs_that_do_not_touch_are_refused() {
    let apart = SOUND.replacen("outer = 200", "outer = 201", 1);
    let contact = SOUND[..SOUND.find("contact = ").unwrap()].matches('\n').count() + 1;
    refused(&apart, Some(contact), "the shaft has the radius 201, its hole the radius 200", "larger radius");
}

#[test]
fn a_drum_needs_an_angular_speed() {
    broken("omega = \"2.5 rad/s\"", "speed = \"5 mm/s\"", "sliding.omega", "omega = ");
    broken("omega = \"2.5 rad/s\"", "omega = 0", "nothing slides", "omega = ");
}

#[test]
fn two_alternatives_in_one_file_are_refused() {
    broken("force = \"10 kN\"", "force = 1, approach = 2", "both", "keep");
    broken("a = 1", "a = 1, k = 1e-7", "both `wear.beta` and `wear.k`", "keep");
}

#[test]
fn a_body_held_along_z_cannot_be_pressed() {
    broken("left = [\"x\"]", "left = [\"x\", \"z\"]", "held along z", "along x only");
}

#[test]
fn exponents_and_factors_out_of_range_are_refused() {
    broken("b = 0.5", "b = 0", "exponent 0 is out of range", "greater than 0");
    broken("b = 0.5", "b = [0.5, -1]", "exponent -1", "greater than 0");
    broken("[2e-4, 0]", "[-2e-4, 0]", "negative wear factor", "0 or more");
    broken("[2e-4, 0]", "[0, 0]", "nothing wears", "greater than 0");
    broken("[2e-4, 0]", "\"1e-7 mm^3/(N m)\"", "a = b = 1", "bare number");
    broken("[2e-4, 0]", "[1, 2, 3]", "wrong number of entries", "[body 1, body 2]");
}

#[test]
fn a_list_with_more_entries_than_are_read_is_refused() {
    broken("[0, 0]", "[0, 0, 200]", "body2.geometry.ring.centre: wrong number of entries: found 3", "write a list of 2");
    broken(
        "[\"inner\", \"outer\"]",
        "[\"inner\", \"outer\", \"outer\"]",
        "contact.edges: wrong number of entries: found 3",
        "write a list of 2",
    );
    let bench = Bench::new();
    let call = bench.call("check translating-punch --set body2.geometry.rectangle.z=[0,50,100]");
    assert_eq!(call.code, 2, "{}", call.err);
    assert!(call.err.contains("body2.geometry.rectangle.z: wrong number of entries: found 3"), "{}", call.err);
}

#[test]
fn accuracy_out_of_range_is_refused() {
    broken("accuracy = 1e-6", "accuracy = 0", "accuracy = 0 is out of range", "1e-6");
    broken("accuracy = 1e-6", "accuracy = nan", "out of range", "1e-6");
    broken("accuracy = 1e-6", "mesh.degree = 99", "mesh.degree = 99", "1 to 24");
}

#[test]
fn numbers_too_large_are_refused() {
    broken("thickness = 10", "thickness = 1e999", "too large", "");
    broken("force = \"10 kN\"", "force = inf", "too large, and no force", "finite");
    broken("force = \"10 kN\"", "force = nan", "NaN is no number, and no force", "finite");
    broken("omega = \"2.5 rad/s\"", "omega = 1e-300", "1e-300 is too small, and no angular speed", "1e-100");
}

#[test]
fn an_unknown_task_is_refused() {
    broken("[\"pressure\", \"shape\"]", "[\"pressure\", \"shap\"]", "unknown word `shap`", "`shape`");
    broken("[\"pressure\", \"shape\"]", "[]", "empty", "tasks = [\"pressure\"]");
}

#[test]
fn a_gap_profile_that_is_missing_or_damaged_is_refused() {
    broken("gap = 0", "gap = \"nothing.csv\"", "cannot read the gap profile", "CSV");
    let bench = Bench::new();
    bench.file("scene.toml", &SOUND.replace("gap = 0", "gap = \"profile.csv\""));
    for (text, line, message) in [
        ("a,b\n1,2\n", 1, "s_mm and gap_um"),
        ("s_mm,gap_um\n0,1\n1,x\n", 3, "no two finite numbers"),
        ("s_mm,gap_um\n0,1\n0,2\n", 3, "does not increase"),
        ("s_mm,gap_um\n0,1\n1,-2\n", 3, "negative"),
        ("s_mm,gap_um\n0,1\n", 0, "1 place and 1 gap"),
        ("s_mm,gap_um\n-9,1,5\n9,0,0\n", 2, "3 fields, the first one 2 fields"),
        ("s_mm;gap_um\n-9;0\n9;1,5\n", 0, "18 mm of the contact surface of 209.44 mm"),
    ] {
        bench.file("profile.csv", text);
        let call = bench.call("check scene.toml");
        assert_eq!(call.code, 2, "{text}");
        assert!(call.err.contains(message), "{text}: {}", call.err);
        if line > 0 {
            assert!(call.err.contains(&format!("profile.csv:{line}:")), "{text}: {}", call.err);
        }
    }
}

#[test]
fn a_file_beside_a_scene_in_another_folder_is_named_as_it_is_found_from_here() {
    let bench = Bench::new();
    bench.file("shoes/scene.toml", &SOUND.replace("gap = 0", "gap = \"measured/profile.csv\""));
    let call = bench.call("check shoes/scene.toml");
    assert_eq!(call.code, 2);
    assert!(call.err.contains("shoes/measured/profile.csv") && call.err.contains("shoes/scene.toml:13:"), "{}", call.err);
    bench.file("shoes/measured/profile.csv", "s_mm,gap_um\n0,1\n1,x\n");
    let call = bench.call("check shoes/scene.toml");
    assert!(call.code == 2 && call.err.contains("--> shoes/measured/profile.csv:3:1\n"), "{}", call.err);
    let mesh = SOUND.replace("shoe-block = { radius = 200, half_angle = \"30 deg\", top = 300 }", "mesh.file = \"shoe.msh\"");
    bench.file("shoes/mesh.toml", &mesh);
    let call = bench.call("check shoes/mesh.toml");
    assert!(call.code == 2 && call.err.contains("shoes/shoe.msh") && call.err.contains("shoes/mesh.toml:8:"), "{}", call.err);
}

#[test]
fn a_scene_that_is_no_file_is_refused() {
    let bench = Bench::new();
    let call = bench.call("check nothing.toml");
    assert_eq!((call.code, call.err.contains("cannot read the scene nothing.toml")), (2, true), "{}", call.err);
    let call = bench.call("check drum-brake-blok");
    assert_eq!(call.code, 2);
    assert!(call.err.contains("did you mean `drum-brake-block`?"), "{}", call.err);
    std::fs::write(bench.path("binary.toml"), [0xff, 0xfe, 0x00]).unwrap();
    let call = bench.call("check binary.toml");
    assert_eq!((call.code, call.err.contains("UTF-8")), (2, true), "{}", call.err);
}

#[test]
fn a_gap_profile_that_covers_a_part_of_the_surface_is_refused_with_both_lengths() {
    let bench = Bench::new();
    bench.file("scene.toml", &SOUND.replace("gap = 0", "gap = \"profile.csv\""));
    bench.file("profile.csv", "\u{feff}s_mm;gap_um\r\n-10,5;0\r\n10,5;1\r\n");
    let call = bench.call("check scene.toml");
    assert_eq!(call.code, 2, "{}", call.err);
    assert!(
        call.err.contains("21 mm of the contact surface of 209.44 mm") && call.err.contains("scene.toml:13:"),
        "{}",
        call.err
    );
    broken("gap = 0", "gap = { s_mm = [-10, 10], gap_um = [0, 1] }", "20 mm of the contact surface", "whole surface");
    broken("gap = 0", "gap = { s_mm = [-200, 200], gap_um = [0, -1] }", "gap_um = -1 is negative", "0 or more");
}

#[test]
fn the_table_of_a_run_is_a_profile_of_the_next() {
    let bench = Bench::new();
    for scene in ["punch-wear", "annular-punch"] {
        let made = bench.call(&format!("run {scene} -q -o made --set accuracy=1e-3"));
        assert_eq!(made.code, 0, "{}", made.err);
        let call = bench.call(&format!("check {scene} --set contact.gap=made/contact.csv --set tasks=[contact]"));
        assert_eq!(call.code, 0, "{scene}: {}", call.err);
    }
}

#[test]
fn tables_and_decimal_commas_are_asked_for_in_words_of_a_scene() {
    let table = "write a table, as in { young = ";
    broken("{ young = \"210 GPa\", poisson = 0.3 }", "3", "found integer `3`", table);
    broken("{ young = \"210 GPa\", poisson = 0.3 }", "[210e3, 0.3]", "found sequence", table);
    broken("friction = 0.25", "friction = 0,25", "a decimal comma in `0,25`", "decimal point, not a comma: 0.25");
    broken("accuracy = 1e-6", "accuracy = 0,5", "a decimal comma in `0,5`", "decimal point, not a comma: 0.5");
    broken("friction = 0.25", "friction = \"0,25\"", "wrong type", "decimal point, not a comma: 0.25");
    broken("force = \"10 kN\"", "force = \"1,5 kN\"", "decimal comma", "\"1.5 kN\"");
    broken("title = \"test\"", "title = 3", "found integer `3`", "text in double quotes");
}

#[test]
fn every_refusal_of_a_call_has_a_place_and_a_remedy() {
    let bench = Bench::new();
    bench.file("there.toml", "");
    bench.file("latin.toml", "");
    std::fs::write(bench.path("latin.toml"), b"title = \"\xe9\"").unwrap();
    bench.file("foreign/notes.txt", "");
    bench.file("file", "");
    assert_eq!(bench.call("run disc-pad -q -o pad").code, 0);
    for args in [
        "run nosuch",
        "run nosuch.toml",
        "run latin.toml",
        "run there.toml",
        "run disc-pad -o foreign",
        "run disc-pad -o file",
        "run disc-pad -o .",
        "run disc-pad -o file/below",
        "run disc-pad --set nosuch=1",
        "run disc-pad --set load.force=-1",
        "run disc-pad --set load.force",
        "run disc-pad --sample 1",
        "run disc-pad --threads 0",
        "check disc-pad -o file/below.svg",
        "new nosuch",
        "new disc-pad there.toml",
        "new disc-pad file/below.toml",
        "sweep disc-pad --over load.force",
        "sweep disc-pad --over load.force=1:2:0",
        "sweep disc-pad --over nosuch=1,2 --set nosuch.more=1",
        "study disc-pad",
        "study drum-brake-block --reference pad",
        "study drum-brake-block --reference nowhere",
        "diff pad nowhere",
        "diff pad pad --tolerance=-1",
        "report nowhere",
        "reproduce nosuch",
        "explain nosuch",
        "man file",
    ] {
        let call = bench.call(args);
        assert_eq!(call.code, 2, "{args}: {}{}", call.out, call.err);
        assert!(call.err.contains("--> ") && call.err.contains("remedy: "), "{args}: {}", call.err);
    }
}
