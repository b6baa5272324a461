//! Built-in scenes: each can be written, read, checked, and is listed.

use crate::call::Bench;

#[test]
fn every_template_is_listed_written_and_sound() {
    let bench = Bench::new();
    let list = bench.call("new --list").out;
    for name in scene::SCENES.iter().map(|scene| scene.name) {
        assert!(list.lines().any(|line| line.starts_with(name) && line.len() > 22), "{name} in {list}");
        let call = bench.call(&format!("new {name} {name}.toml"));
        assert_eq!(call.code, 0, "{}", call.err);
        let text = bench.read(&format!("{name}.toml"));
        assert!(text.starts_with("#:schema "), "{name}");
        assert_eq!(bench.call(&format!("new {name}")).out, text);
        let call = bench.call(&format!("check {name}.toml"));
        assert_eq!(call.code, 0, "{name}: {}", call.err);
        assert_eq!(without_seconds(&bench.call(&format!("check {name}")).out), without_seconds(&call.out));
        let plan: serde_json::Value = serde_json::from_str(&bench.call(&format!("check {name} --json")).out).unwrap();
        assert_eq!(plan["unused_keys"], serde_json::json!([]), "{name}");
    }
    assert_eq!(list.lines().count(), scene::SCENES.len());
}

/// What a check says but for the times it expects, which differ from call to call.
fn without_seconds(text: &str) -> String {
    text.lines().filter(|line| !line.contains("about")).collect::<Vec<_>>().join("\n")
}

#[test]
fn a_file_that_exists_is_not_overwritten() {
    let bench = Bench::new();
    bench.file("mine.toml", "precious");
    let call = bench.call("new disc-pad mine.toml");
    assert_eq!((call.code, bench.read("mine.toml").as_str()), (2, "precious"));
    assert!(call.err.contains("exists already"), "{}", call.err);
    assert_eq!(bench.call("new disc-pad no/such/folder.toml").code, 2);
    let call = bench.call("new disk-pad");
    assert_eq!(call.code, 2);
    assert!(call.err.contains("did you mean `disc-pad`?"), "{}", call.err);
}
