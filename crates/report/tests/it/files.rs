//! One folder: which files, the same bytes, a page without network.

use std::ops::ControlFlow;
use std::sync::LazyLock;

use wearshape::{Bodies, Document, Event, Options, Problem, Solution, builtin};

/// The drum brake with its shape, on coarse meshes.
static DRUM: LazyLock<(Problem, Solution)> = LazyLock::new(|| {
    let settings = ["mesh.degree=4", "check=false", "output.fields=true"].map(String::from);
    let document = Document::read("drum-brake-block.toml", builtin("drum-brake-block").unwrap().text, &settings).unwrap();
    let problem = Problem::new(&document, &|file| Err(format!("there is no file {file}"))).unwrap();
    let going_on = &mut |_: Event<'_>| ControlFlow::Continue(());
    let options = Options { machining: true, ..Options::default() };
    let solution = wearshape::solve(&problem, &options, &Bodies::default(), going_on).unwrap();
    (problem, solution)
});

fn files() -> Vec<(String, Vec<u8>)> {
    report::files(&DRUM.0, &DRUM.1)
}

fn file(name: &str) -> Option<Vec<u8>> {
    files().into_iter().find(|(known, _)| known == name).map(|(_, bytes)| bytes)
}

fn text(name: &str) -> String {
    String::from_utf8(file(name).unwrap()).unwrap()
}

#[test]
fn a_shape_has_its_tables_pictures_fields_drawing_and_page_each_once() {
    let mut names: Vec<String> = files().into_iter().map(|(name, _)| name).collect();
    let count = names.len();
    names.sort();
    names.dedup();
    assert_eq!(names.len(), count);
    for name in [
        "contact.csv",
        "fields/body1.vtu",
        "fields/fields.pvd",
        "plots/curves.json",
        "plots/field.svg",
        "plots/gap.svg",
        "plots/pressure.svg",
        "plots/scene.svg",
        "profile-spline.csv",
        "profile.csv",
        "profile.dxf",
        "report.html",
        "scene.resolved.toml",
        "summary.json",
    ] {
        assert!(names.iter().any(|known| known == name), "{name} is not in {names:?}");
    }
}

#[test]
fn the_page_links_to_every_file_that_it_does_not_show() {
    let page = text("report.html");
    // Pictures are shown, and cells of high order hold the fields that are linked once more.
    let is_linked = |name: &str| name != "report.html" && !name.ends_with(".svg") && !name.contains(".lagrange.");
    for (name, _) in files().iter().filter(|(name, _)| is_linked(name)) {
        assert!(page.contains(&format!("href=\"{name}\"")), "{name} is not linked: FILES of page.rs has its words");
    }
}

#[test]
fn the_same_solution_gives_the_same_bytes() {
    assert!(files() == files());
}

#[test]
fn the_page_asks_nothing_of_the_network() {
    let page = text("report.html");
    assert!(!page.contains("Left out"), "a picture of its own is left out");
    // The name of a language is no address that is asked.
    let addresses: Vec<&str> = page
        .match_indices("http")
        .filter(|(at, _)| !page[*at..].starts_with("http-equiv="))
        .map(|(at, _)| &page[at..(at + 18).min(page.len())])
        .collect();
    assert!(addresses.iter().all(|address| *address == "http://www.w3.org/"), "{addresses:?}");
    assert!(!page.contains("src=") && !page.contains("@import") && !page.contains("url("));
}

#[test]
fn the_page_is_built_again_from_the_other_files() {
    assert_eq!(report::page(&file, None).unwrap(), text("report.html"));
    let without = |name: &str| file(name).filter(|_| name != "summary.json");
    assert!(report::page(&without, None).unwrap_err().message.contains("summary.json is missing"));
    let damaged = |name: &str| if name == "plots/curves.json" { Some(b"[{".to_vec()) } else { file(name) };
    assert!(report::page(&damaged, None).unwrap_err().message.contains("plots/curves.json is damaged"));
}

/// Equal to the last bit; a zero has no sign in a file, and a number that is not there is not a number.
fn same(read: &[f64], computed: &[f64]) -> bool {
    let pair = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || (*a == 0.0 && *b == 0.0) || (a.is_nan() && b.is_nan());
    read.len() == computed.len() && read.iter().zip(computed).all(pair)
}

#[test]
fn contact_csv_is_the_profile_to_the_last_bit() {
    let (table, profile) = (text("contact.csv"), DRUM.1.profile.as_ref().unwrap());
    let column = |name: &str| report::column(&table, name).unwrap();
    assert!(profile.s.len() > 10 && same(&column("s_mm"), &profile.s));
    assert!(same(&column("nz"), &profile.normal.iter().map(|n| n[2]).collect::<Vec<_>>()));
    assert!(same(&column("weight_mm2"), &profile.weight) && same(&column("pressure_MPa"), &profile.pressure));
    assert!(same(&column("gap_um"), &profile.gap) && same(&column("shear_MPa"), &profile.shear));
    assert!(same(&column("un2_um"), &profile.normal_displacement[1]));
    assert!(same(&column("ut1_um"), &profile.tangential_displacement[0]));
    assert_eq!(report::column(&table, "status"), None, "words are no numbers");
}

#[test]
fn profile_csv_is_the_surface_to_machine_to_the_last_bit() {
    let (table, machined) = (text("profile.csv"), DRUM.1.machined.as_ref().unwrap());
    let of = |value: fn(&wearshape::SurfacePoint) -> f64| machined.points.iter().map(value).collect::<Vec<f64>>();
    assert!(same(&report::column(&table, "s_mm").unwrap(), &of(|point| point.s)));
    assert!(same(&report::column(&table, "x_mm").unwrap(), &of(|point| point.finished()[0])));
    assert!(same(&report::column(&table, "z_mm").unwrap(), &of(|point| point.finished()[1])));
}

#[test]
fn the_page_begins_with_the_drawing_of_the_scene_and_links_the_files_beside_it() {
    let page = text("report.html");
    let drawing = text("plots/scene.svg");
    let (at, curves) = (page.find(&drawing).unwrap(), page.find("data-chart=").unwrap());
    assert!(at < curves);
    for link in ["summary.json", "contact.csv", "profile.dxf", "fields/body1.vtu", "plots/scene.svg"] {
        assert!(page.contains(&format!("href=\"{link}\"")) && file(link).is_some(), "{link}");
    }
    assert!(!page.contains("href=\"history.csv\"") && !page.contains("href=\"run.mcap\""), "what is not there is not linked");
    for words in [
        "body 1, shaped: E = 210 GPa",
        "load: 10000 N, as a pressure on top",
        "turns anti-clockwise at 2.5 rad/s",
        "friction 0.25",
    ] {
        assert!(drawing.contains(words), "{words}: {drawing}");
    }
}

#[test]
fn every_picture_has_a_role_and_a_title() {
    for (name, bytes) in files() {
        if name.ends_with(".svg") {
            let picture = String::from_utf8(bytes).unwrap();
            assert!(picture.contains("role=\"img\"") && picture.contains("<title>Drum brake"), "{name}");
        }
    }
}

#[test]
fn tables_of_the_page_say_words_and_units() {
    let page = text("report.html");
    assert!(page.contains(">largest pressure</td><td class=\"number\">5.45455 MPa<"), "{page}");
    assert!(!page.contains(">p_max_MPa<") && !page.contains(">crown_um<") && !page.contains(">nan<"), "{page}");
}

#[test]
fn a_shape_is_said_by_what_to_take_off() {
    let summary = report::summary(&DRUM.0, &DRUM.1);
    let verdict = summary["verdict"].as_str().unwrap();
    assert!(verdict.contains("take off most, 1.08") && verdict.contains(" um, at 30 deg; nothing at -12.6"), "{verdict}");
    let drawing = text("profile.dxf");
    assert!(drawing.contains("MOST-TAKEN-OFF") && drawing.contains("DATUM") && !drawing.contains("CROWN"));
}

#[test]
fn the_fields_say_the_material_of_each_cell_and_the_pressure_on_the_contact() {
    let field = text("fields/body1.vtu");
    for name in ["material", "young_MPa", "poisson", "contact_pressure_MPa"] {
        assert!(field.contains(&format!("Name=\"{name}\"")), "{name}");
    }
    let frame = &DRUM.1.fields[0];
    let touching: Vec<[f64; 2]> = frame.bodies[0]
        .cells
        .iter()
        .flat_map(|cell| cell.position.iter().zip(&cell.touching))
        .filter(|(_, on)| **on)
        .map(|(place, _)| *place)
        .collect();
    assert!(touching.len() > 20 && touching.iter().all(|[x, z]| (x.hypot(*z) - 200.0).abs() < 1e-9));
    assert_eq!(frame.bodies[0].materials.len(), 1);
}

/// A surface without bodies, solved.
fn bare(name: &str) -> (Problem, Solution) {
    let document = Document::read(&format!("{name}.toml"), builtin(name).unwrap().text, &[]).unwrap();
    let problem = Problem::new(&document, &|file| Err(format!("there is no file {file}"))).unwrap();
    let going_on = &mut |_: Event<'_>| ControlFlow::Continue(());
    let options = Options { machining: true, ..Options::default() };
    let solution = wearshape::solve(&problem, &options, &Bodies::default(), going_on).unwrap();
    (problem, solution)
}

#[test]
fn a_surface_of_two_dimensions_says_its_largest_pressure_and_has_a_map() {
    for (name, words) in [("rectangular-punch", "6.771 MPa at x = 30, y = -20 mm"), ("elliptic-punch", "8.551 MPa at x = 26.")] {
        let (problem, solution) = bare(name);
        let summary = report::summary(&problem, &solution);
        let (verdict, most) = (summary["verdict"].as_str().unwrap(), summary["pressure"]["p_max_MPa"].as_f64().unwrap());
        assert!(verdict.contains(words), "{verdict}");
        let map = solution.map.as_ref().unwrap();
        let drawn = map.pressure.iter().copied().fold(0.0, f64::max);
        assert!(drawn <= most * (1.0 + 1e-12) && drawn > 0.99 * most, "{drawn} of {most}");
        let files = report::files(&problem, &solution);
        assert!(files.iter().any(|(name, _)| name == "plots/map.svg") && files.iter().any(|(name, _)| name == "plots/scene.svg"));
    }
    // Where a cut says it all, it does.
    let (problem, solution) = bare("disc-pad");
    let verdict = report::summary(&problem, &solution)["verdict"].to_string();
    assert!(verdict.contains("1.91 MPa at r = 100 mm, 1.273 MPa at r = 150 mm"), "{verdict}");
}

#[test]
fn an_extreme_pressure_is_said_to_be_where_it_is() {
    let verdict = |name: &str| {
        let (problem, solution) = bare(name);
        report::summary(&problem, &solution)["verdict"].as_str().unwrap().to_string()
    };
    assert!(verdict("pinned-shoe").contains("1 MPa at 90 deg, 0 MPa at 0 deg"), "{}", verdict("pinned-shoe"));
    assert!(verdict("journal-arc").contains("1.405 MPa at 19.88 deg, "), "{}", verdict("journal-arc"));
    assert!(verdict("pivoted-shoe").contains("at 0 deg, 0.5501 MPa at +-45 deg"), "{}", verdict("pivoted-shoe"));
    // The smallest pressure of an ellipse lies between the points of its map, that of a rectangle in a corner.
    assert!(verdict("elliptic-punch").contains("y = -9.805 mm, at least 2.059 MPa."), "{}", verdict("elliptic-punch"));
    assert!(verdict("rectangular-punch").contains(", 1.562 MPa at x = -30, y = 20 mm"), "{}", verdict("rectangular-punch"));
}

/// A built-in scene with some settings, stopped when so many levels have begun.
fn stopped(name: &str, settings: &[&str], levels: usize) -> (Problem, Solution) {
    let settings: Vec<String> = settings.iter().map(ToString::to_string).collect();
    let document = Document::read(&format!("{name}.toml"), builtin(name).unwrap().text, &settings).unwrap();
    let problem = Problem::new(&document, &|file| Err(format!("there is no file {file}"))).unwrap();
    let mut events = 0;
    let mut until = |_: Event<'_>| {
        events += 1;
        if events < levels { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let solution = wearshape::solve(&problem, &Options::default(), &Bodies::default(), &mut until).unwrap();
    assert_eq!(solution.status, wearshape::Status::Interrupted);
    (problem, solution)
}

#[test]
fn an_interrupted_run_promises_nothing() {
    let said = |name: &str, settings: &[&str], levels: usize| {
        let (problem, solution) = stopped(name, settings, levels);
        report::summary(&problem, &solution)["verdict"].as_str().unwrap().to_string()
    };
    for levels in 1..=3 {
        let verdict = said("drum-brake-block", &[], levels);
        assert!(verdict.starts_with("Interrupted ") && !verdict.contains("Machine"), "{verdict}");
        assert!(!verdict.contains("starts worn in"), "{verdict}");
    }
    let shape = said("drum-brake-block", &[], 2);
    assert!(shape.contains("which is not proved: ") && shape.contains("how far it is off is not known"), "{shape}");
    let contact = said("knee", &[], 2);
    assert!(contact.starts_with("Interrupted before the accuracy was reached. So far: The bodies touch"), "{contact}");
    let wear = said("punch-wear", &[], 90);
    assert!(wear.starts_with("Interrupted before the accuracy was reached. So far: Worn in"), "{wear}");
    assert!(wear.contains("how far it is off is not known"), "{wear}");
}

#[test]
fn a_run_whose_wear_stops_at_the_threshold_is_not_called_worn_in() {
    let said = |threshold: &str| {
        let settings = ["mesh.degree=4", "wear.b=1", "wear.until=steady", "contact.shear=false", threshold].map(String::from);
        let document = Document::read("punch-wear.toml", builtin("punch-wear").unwrap().text, &settings).unwrap();
        let problem = Problem::new(&document, &|file| Err(format!("there is no {file}"))).unwrap();
        let going_on = &mut |_: Event<'_>| ControlFlow::Continue(());
        let solution = wearshape::solve(&problem, &Options::default(), &Bodies::default(), going_on).unwrap();
        report::summary(&problem, &solution)["verdict"].to_string()
    };
    let (stops, goes_on) = (said("wear.threshold=1.8"), said("wear.threshold=1.2"));
    assert!(stops.contains("Wear has stopped after") && !stops.contains("steady"), "{stops}");
    assert!(goes_on.contains("Worn in to 1 %"), "{goes_on}");
}

#[test]
fn every_built_in_scene_can_be_drawn_before_it_is_computed() {
    for scene in wearshape::SCENES {
        let document = Document::read(&format!("{}.toml", scene.name), scene.text, &[]).unwrap();
        let Ok(problem) = Problem::new(&document, &|file| Err(format!("there is no file {file}"))) else { continue };
        let drawing = report::drawing(&problem);
        assert!(
            drawing.starts_with("<svg ") && !drawing.contains("NaN") && !drawing.contains("inf"),
            "{}: {drawing}",
            scene.name
        );
        assert!(drawing.contains("load: "), "{}", scene.name);
        // The arrow of the legend and at least one in the drawing.
        assert!(drawing.matches("stroke=\"#a3267c\"").count() > 1, "{}", scene.name);
    }
}

#[test]
fn a_ball_touches_with_its_surface_and_not_with_the_axis_of_revolution() {
    let document = Document::read("hertz-sphere.toml", builtin("hertz-sphere").unwrap().text, &[]).unwrap();
    let problem = Problem::new(&document, &|file| Err(format!("there is no file {file}"))).unwrap();
    let [ball, _] = problem.outlines().unwrap();
    let on_the_axis = ball.edge("arc").iter().flat_map(|line| line.iter()).filter(|point| point[0] <= 0.0).count();
    assert!(on_the_axis <= 1 && ball.edge("arc")[0].len() > 20, "{:?}", ball.edge("arc"));
}

#[test]
fn a_path_is_drawn_in_the_page() {
    let path = "output.paths=[{ name = 'rim', body = 2, from = [0, 100], to = [0, 200], points = 5 }]";
    let settings = ["mesh.degree=4", "check=false", path].map(String::from);
    let document = Document::read("drum-brake-block.toml", builtin("drum-brake-block").unwrap().text, &settings).unwrap();
    let problem = Problem::new(&document, &|file| Err(format!("there is no file {file}"))).unwrap();
    let going_on = &mut |_: Event<'_>| ControlFlow::Continue(());
    let solution = wearshape::solve(&problem, &Options::default(), &Bodies::default(), going_on).unwrap();
    let files = report::files(&problem, &solution);
    let text = |name: &str| {
        let (_, bytes) = files.iter().find(|(known, _)| known == name).unwrap();
        String::from_utf8(bytes.clone()).unwrap()
    };
    assert!(text("plots/path-rim.svg").contains("stress along rim, body 2"));
    assert!(text("report.html").contains("stress along rim, body 2"));
    // The numbers of the curve are those of the table.
    let curves: serde_json::Value = serde_json::from_str(&text("plots/curves.json")).unwrap();
    let drawn = curves.as_array().unwrap().iter().find(|entry| entry["file"] == "path-rim").unwrap();
    let pulls: Vec<f64> = drawn["chart"]["series"][1]["y"].as_array().unwrap().iter().map(|y| y.as_f64().unwrap()).collect();
    assert_eq!(pulls, solution.paths[0].stress.iter().map(|stress| stress.zz).collect::<Vec<_>>());
}
