//! `cargo xtask estimates`: how honest the estimated errors of fixed discretisations are, on random scenes.
//!
//! Each scene is a built-in one with other bodies, materials and friction, at a random degree and number of layers. It is solved again
//! four degrees higher with as many layers; what they differ by is taken for the true error. Whatever the number of scenes, the last one begins before
//! the minutes are over.

mod compare;
mod random;
mod table;

use crate::verify::programs;
use compare::{Solved, differences};
use random::{Random, Scene};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};
use table::Row;

/// Share of a true error up to which the finer solution may itself be off.
const SURE: f64 = 0.1;
/// True errors below which round-off decides.
const SMALLEST: f64 = 1e-11;
/// True error over estimate that no scene may pass.
const WORST: f64 = 5.0;

/// Draws the scenes, solves them and prints the table.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    match campaign(root, words) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(message) => {
            eprintln!("estimates: {message}");
            ExitCode::from(2)
        }
    }
}

fn campaign(root: &Path, words: &[String]) -> Result<bool, String> {
    let (mut seed, mut count, mut minutes, mut docs, mut program) = (1_u64, 500_usize, 15_u64, false, None);
    let mut rest = words.iter();
    while let Some(word) = rest.next() {
        let mut number = || rest.next().and_then(|text| text.parse::<u64>().ok()).ok_or(format!("{word} needs a whole number"));
        match word.as_str() {
            "--seed" => seed = number()?,
            "--count" => count = usize::try_from(number()?).map_err(|error| error.to_string())?,
            "--minutes" => minutes = number()?,
            "--docs" => docs = true,
            "--program" => program = Some(PathBuf::from(rest.next().ok_or("--program needs the path of a built wearshape")?)),
            other => return Err(format!("there is no option `{other}`")),
        }
    }
    let wearshape = program.map_or_else(|| programs::build(root), Ok)?;
    let mut random = Random::new(seed);
    let mut rows = Vec::new();
    let end = Instant::now() + Duration::from_secs(60 * minutes);
    for number in (0..count).take_while(|_| Instant::now() < end) {
        let scene = Scene::draw(&mut random);
        let row = one(root, &wearshape, number, scene)?;
        println!("{}", table::line(&row));
        rows.push(row);
    }
    let text = table::text(&rows, seed);
    print!("{text}");
    if docs {
        let page = root.join("docs/estimates.md");
        std::fs::write(&page, table::page(&text)).map_err(|error| format!("{}: {error}", page.display()))?;
    }
    Ok(rows.iter().all(|row| row.effectivities.iter().all(|(_, ratio)| *ratio <= WORST)))
}

/// Solves a scene and its finer twin.
fn one(root: &Path, wearshape: &Path, number: usize, scene: Scene) -> Result<Row, String> {
    let at = |degree: usize, layers: usize, name: &str| {
        let folder = root.join("target/estimates").join(name);
        solve(root, wearshape, &scene, [degree, layers], &folder)
    };
    let coarse = at(scene.degree, scene.layers, "scene")?;
    let fine = at(scene.degree + 4, scene.degree + 4, "finer")?;
    let (Some(coarse), Some(fine)) = (coarse, fine) else {
        return Ok(Row { number, scene, effectivities: Vec::new(), says: "not solved".into() });
    };
    let mut effectivities = Vec::new();
    for (quantity, truth) in differences(&coarse, &fine, scene.modes) {
        let (Some(estimate), Some(own)) = (coarse.estimate(quantity), fine.estimate(quantity)) else { continue };
        if truth > SMALLEST && own < SURE * truth.max(estimate) {
            effectivities.push((quantity, truth / estimate));
        }
    }
    let says = if effectivities.is_empty() { "truth not sure" } else { "" };
    Ok(Row { number, scene, effectivities, says: says.into() })
}

/// One run; `None` where it has no answer.
fn solve(root: &Path, wearshape: &Path, scene: &Scene, mesh: [usize; 2], folder: &Path) -> Result<Option<Solved>, String> {
    if folder.exists() {
        std::fs::remove_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    let mut command = Command::new(wearshape);
    command
        .current_dir(root)
        .args(["run", scene.base, "-q", "--no-progress", "--threads", "1", "--sample", "401", "-o"])
        .arg(folder);
    let fixed = [format!("mesh.degree={}", mesh[0]), format!("mesh.layers={}", mesh[1])];
    for change in scene.set.iter().chain(&fixed) {
        command.args(["--set", change]);
    }
    let output = command.stdin(Stdio::null()).output().map_err(|error| format!("wearshape: {error}"))?;
    if !output.status.success() {
        return Ok(None);
    }
    compare::read(folder).map(Some)
}
