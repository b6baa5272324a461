//! `cargo xtask campaign`: random scenes beside their twins, thousands of them; the test that tries some of them does the work.

use std::path::Path;
use std::process::{Command, ExitCode};

/// Most scenes at once: some hours.
const MOST: u64 = 100_000;

/// Scenes and seed that are asked for.
fn wanted(words: &[String]) -> Result<[u64; 2], String> {
    let [mut scenes, mut seed] = [2000, 1];
    let mut rest = words.iter();
    while let Some(word) = rest.next() {
        let mut number = || rest.next().and_then(|text| text.parse::<u64>().ok()).ok_or(format!("{word} needs a whole number"));
        match word.as_str() {
            "--scenes" => scenes = number()?,
            "--seed" => seed = number()?,
            other => return Err(format!("there is no option `{other}`: write --scenes N, --seed N")),
        }
    }
    if !(1..=MOST).contains(&scenes) {
        return Err(format!("--scenes is {scenes}: write a number from 1 to {MOST}"));
    }
    Ok([scenes, seed])
}

/// Tries the scenes and prints the counts, and the text of each scene that fails.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    let [scenes, seed] = match wanted(words) {
        Ok(wanted) => wanted,
        Err(message) => {
            eprintln!("campaign: {message}");
            return ExitCode::from(2);
        }
    };
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let status = Command::new(cargo)
        .args(["test", "--locked", "--release", "-p", "wearshape", "--test", "it"])
        .args(["campaign::random_scenes_have_the_answer_of_their_twins", "--", "--exact", "--nocapture"])
        .env("WEARSHAPE_CAMPAIGN_SCENES", scenes.to_string())
        .env("WEARSHAPE_CAMPAIGN_SEED", seed.to_string())
        .current_dir(root)
        .status();
    match status {
        Ok(status) if status.success() => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("campaign: cargo: {error}");
            ExitCode::from(2)
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::wanted;

    #[test]
    fn numbers_of_scenes_and_seeds_are_bounded() {
        let words = |text: &str| text.split_whitespace().map(ToString::to_string).collect::<Vec<_>>();
        assert_eq!(wanted(&words("")).unwrap(), [2000, 1]);
        assert_eq!(wanted(&words("--scenes 7 --seed 3")).unwrap(), [7, 3]);
        for wrong in ["--scenes 0", "--scenes 100001", "--seed", "--seed x", "all"] {
            assert!(wanted(&words(wrong)).is_err(), "{wrong}");
        }
    }
}
