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
fn the_same_solution_gives_the_same_bytes() {
    assert!(files() == files());
}

#[test]
fn the_page_asks_nothing_of_the_network() {
    let page = text("report.html");
    // The name of a language is no address that is asked.
    let addresses: Vec<&str> = page.match_indices("http").map(|(at, _)| &page[at..(at + 18).min(page.len())]).collect();
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
