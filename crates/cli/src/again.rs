//! How an interrupted call goes on, as a command to copy.

use crate::args::{Common, Points};

/// Says what is `kept` and the call that goes on with it; without anything kept, the call that begins again. `words` are those of the call but for
/// its options.
pub(crate) fn again(words: &[&str], (common, points): (&Common, &Points), kept: Option<&str>) -> String {
    let mut call: Vec<String> = ["wearshape"].iter().chain(words).map(|word| quoted(word)).collect();
    if let Some(folder) = &common.output {
        call.extend(["-o".into(), quoted(&folder.display().to_string())]);
    }
    for set in &common.set {
        call.extend(["--set".into(), quoted(set)]);
    }
    for (flag, number) in [("--sample", points.sample), ("--threads", common.threads)] {
        call.extend(number.map(|number| format!("{flag} {number}")));
    }
    for (flag, given) in [("--json", common.json), ("--quiet", common.quiet)] {
        call.extend(given.then(|| flag.into()));
    }
    let call = call.join(" ");
    match kept {
        Some(kept) => format!("{kept} is kept; continue with: {call} --resume"),
        None => format!("begin it again with: {call}"),
    }
}

/// A word as a shell takes it.
pub(crate) fn quoted(word: &str) -> String {
    let plain = word.chars().all(|c| c.is_ascii_alphanumeric() || "=._-,/:+%@".contains(c));
    if plain { word.to_string() } else { format!("'{}'", word.replace('\'', "'\\''")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_call_that_goes_on_can_be_pasted_into_a_shell() {
        let common = Common {
            set: vec!["load.force=10 kN".into(), "title=it's".into()],
            output: Some("x".into()),
            json: true,
            ..Common::default()
        };
        let points = Points { sample: Some(11), ..Points::default() };
        let call = r"wearshape run a.toml -o x --set 'load.force=10 kN' --set 'title=it'\''s' --sample 11 --json";
        assert_eq!(again(&["run", "a.toml"], (&common, &points), None), format!("begin it again with: {call}"));
        let kept = again(&["run", "a.toml"], (&common, &points), Some("every finished step"));
        assert_eq!(kept, format!("every finished step is kept; continue with: {call} --resume"));
    }
}
