//! Files beside a scene.

use std::cell::RefCell;

use wearshape::{Document, Fault, Problem};

use crate::common::computed_from;

const LINING: &str = include_str!("../../../../data/meshes/lining.toml");
const LINING_MESH: &[u8] = include_bytes!("../../../../data/meshes/lining.msh");
const HERTZ: &str = include_str!("../../../../data/meshes/hertz.toml");
const CYLINDER: &[u8] = include_bytes!("../../../../data/meshes/cylinder.msh");
const BLOCK: &[u8] = include_bytes!("../../../../data/meshes/block.msh");
const PROFILE: &str = "s_mm,gap_um\n-200,0\n0,3.5\n200,0\n";

/// A scene with files in memory, and which of them were asked for.
fn with(text: &str, settings: &[&str], files: &[(&str, &[u8])]) -> (Result<Problem, Fault>, Vec<String>) {
    let asked = RefCell::new(Vec::new());
    let settings: Vec<String> = settings.iter().map(|setting| setting.to_string()).collect();
    let document = Document::read("scene.toml", text, &settings).unwrap();
    let problem = Problem::new(&document, &|path| {
        asked.borrow_mut().push(path.to_string());
        let found = files.iter().find(|(name, _)| *name == path);
        found.map(|(_, bytes)| bytes.to_vec()).ok_or_else(|| "the tape is torn".to_string())
    });
    (problem, asked.into_inner())
}

#[test]
fn every_file_is_asked_for_once() {
    let gap = ["contact.gap=worn/profile.csv", "tasks=[contact]"];
    let (problem, mut asked) = with(LINING, &gap, &[("lining.msh", LINING_MESH), ("worn/profile.csv", PROFILE.as_bytes())]);
    asked.sort();
    assert_eq!(asked, ["lining.msh", "worn/profile.csv"]);
    assert!(problem.unwrap().remarks().iter().all(|remark| remark.code != "unreadable"));
    let (problem, mut asked) = with(HERTZ, &[], &[("cylinder.msh", CYLINDER), ("block.msh", BLOCK)]);
    asked.sort();
    assert_eq!(asked, ["block.msh", "cylinder.msh"]);
    // The problem keeps what it was given, for whoever writes it down.
    let kept = problem.unwrap().files();
    assert_eq!(kept, [("body1.msh".to_string(), CYLINDER.to_vec()), ("body2.msh".to_string(), BLOCK.to_vec())]);
}

#[test]
fn a_resolved_scene_with_its_files_is_the_same_problem() {
    let gap = ["contact.gap=worn/profile.csv", "tasks=[contact]"];
    let (problem, _) = with(LINING, &gap, &[("lining.msh", LINING_MESH), ("worn/profile.csv", PROFILE.as_bytes())]);
    let problem = problem.unwrap();
    let kept = problem.files();
    let kept: Vec<(&str, &[u8])> = kept.iter().map(|(name, bytes)| (name.as_str(), bytes.as_slice())).collect();
    let (again, asked) = with(&problem.resolved(), &[], &kept);
    // The profile stands in the resolved scene itself.
    assert_eq!(asked, ["body1.msh"]);
    assert_eq!(computed_from(&again.unwrap()), computed_from(&problem));
}

#[test]
fn a_file_that_is_not_there_is_a_fault_with_its_reason_and_place() {
    let files: [(&str, &[u8]); 1] = [("lining.msh", LINING_MESH)];
    let missing_gap = with(LINING, &["contact.gap=profile.csv"], &files).0.unwrap_err();
    let missing_mesh = with(LINING, &[], &[]).0.unwrap_err();
    for (fault, key, name) in
        [(missing_gap, "contact.gap", "profile.csv"), (missing_mesh, "body1.geometry.mesh.file", "lining.msh")]
    {
        assert_eq!((fault.code, fault.key.as_deref()), ("unreadable", Some(key)));
        assert!(fault.message.contains(name) && fault.message.contains("the tape is torn"), "{}", fault.message);
        assert!(fault.place.is_some());
    }
}

#[test]
fn a_scene_without_files_asks_for_none() {
    for scene in &wearshape::SCENES {
        let (problem, asked) = with(scene.text, &[], &[]);
        assert!(problem.is_ok() && asked.is_empty(), "{}: {asked:?}", scene.name);
    }
}

/// A drum of 64 triangles with edges of the third degree, from gmsh: where its nodes are added to those of the lining they are off by 6e-10 of the contact, and a
/// curved edge inside ends there, so that none can be moved.
#[test]
fn points_of_a_curved_mesh_that_round_off_parts_from_those_of_the_other_body_are_one() {
    const RING: &[u8] = include_bytes!("../meshes/ring_3_22.msh");
    let text = wearshape::builtin("lining-on-back").unwrap().text;
    let text = text.replace("geometry.ring = { inner = 100, outer = 200 }", "geometry.mesh = { file = \"ring.msh\" }");
    let (problem, asked) = with(&text, &["tasks=[shape]"], &[("ring.msh", RING)]);
    assert_eq!(asked, ["ring.msh"]);
    problem.unwrap().available().unwrap();
}
