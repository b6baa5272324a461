//! Problems are plain data.

use wearshape::{Bodies, Document, Options, Problem, Resume, SCENES, Solution, WearState, builtin};

use crate::common::{computed_from, read, scene, solved};

const fn data<T: Clone + std::fmt::Debug + Send + Sync>() {}
const fn compared<T: PartialEq>() {}
const fn shared<T: Send + Sync>() {}

const _: () = {
    data::<Document>();
    data::<Problem>();
    data::<Solution>();
    data::<Resume>();
    data::<WearState>();
    data::<Options<'static>>();
    compared::<Document>();
    compared::<Problem>();
    compared::<Resume>();
    shared::<Bodies>();
};

#[test]
fn the_same_document_gives_equal_problems_and_another_one_another() {
    for builtin in &SCENES {
        let problem = read(builtin.text, &[]);
        assert_eq!(problem, read(builtin.text, &[]), "{}", builtin.name);
        assert_eq!(problem, problem.clone(), "{}", builtin.name);
        assert_ne!(problem, read(builtin.text, &["load.force=1234.5"]), "{}", builtin.name);
    }
    let [one, other] = ["wear.b=0.5", "wear.b=0.5000000000000001"].map(|b| scene("drum-brake-block", &[b]));
    assert_ne!(one, other, "the last bit counts");
}

/// A resolved scene is read by another name, and writes down what its first text left out: that alone may differ.
#[test]
fn the_resolved_scene_is_the_same_problem() {
    for builtin in &SCENES {
        let problem = read(builtin.text, &[]);
        let text = problem.resolved();
        let document = Document::read("other.toml", &text, &[]).unwrap();
        let again = Problem::new(&document, &|file| Err(format!("there is no {file}"))).unwrap();
        assert_eq!(again.name(), "other");
        assert_eq!(again.resolved(), text, "{}", builtin.name);
        let named = computed_from(&again).replace("name: \"other\"", &format!("name: {:?}", problem.name()));
        assert_eq!(named, computed_from(&problem), "{}", builtin.name);
    }
}

#[test]
fn a_built_in_scene_has_its_name_and_title() {
    let drum = builtin("drum-brake-block").unwrap();
    let document = Document::read(&drum.file(), drum.text, &[]).unwrap();
    let problem = Problem::new(&document, &|_| Err(String::new())).unwrap();
    assert_eq!((problem.name(), problem.title()), (drum.name, drum.title()));
    assert!(builtin("no-such-scene").is_none());
}

/// Found by the campaign: the points next to the end of the pressure came last, and backwards.
#[test]
fn points_of_a_pressure_that_ends_inside_the_surface_are_in_order() {
    for moment in ["load.moment=-8e3", "load.moment=8e3"] {
        let profile = solved(&scene("translating-punch", &["tasks=[\"pressure\"]", moment])).profile.unwrap();
        assert!(profile.s.windows(2).all(|pair| pair[0] < pair[1]), "{moment}: {:?}", profile.s);
    }
}
