//! The built-in scenes: what each is, what comes out, its pictures, its text.

use std::fs;

use super::files::read;
use super::made::Made;
use super::play::Player;

/// A built-in scene.
pub(super) struct Scene {
    pub name: String,
    pub title: String,
    pub text: String,
}

/// All of them, in the order in which the program lists them.
pub(super) fn scenes(player: &Player<'_>) -> Result<Vec<Scene>, String> {
    let (code, list) = player.line(&player.runs.join("keys"), "wearshape new --list")?;
    if code != 0 {
        return Err(format!("wearshape new --list ended with {code}"));
    }
    let one = |line: &str| {
        let (name, title) = line.split_once(' ')?;
        let text = read(&player.root.join("data/scenes").join(format!("{name}.toml")));
        Some(text.map(|text| Scene { name: name.into(), title: title.trim().into(), text }))
    };
    list.lines().filter_map(one).collect()
}

/// The drawings of the scenes, each a link to its page.
pub(super) fn list(player: &Player<'_>) -> Result<String, String> {
    let one =
        |Scene { name, title, .. }: &Scene| format!("[![{title}](scenes/{name}/out/plots/scene.svg)](scenes/{name}.md)\n\n");
    Ok(format!("<div class=\"gallery\">\n\n{}</div>\n", scenes(player)?.iter().map(one).collect::<String>()))
}

/// A page for each scene, which is run for it.
pub(super) fn pages(player: &Player<'_>) -> Result<Vec<Made>, String> {
    scenes(player)?.iter().map(|scene| page(player, scene)).collect()
}

fn page(player: &Player<'_>, Scene { name, title, text }: &Scene) -> Result<Made, String> {
    let folder = player.runs.join("book/scenes").join(name);
    let command = format!("wearshape run {name} -o out");
    let (code, words) = player.line(&folder, &command)?;
    if code != 0 {
        return Err(format!("`{command}` ended with {code}:\n{words}"));
    }
    let entries = fs::read_dir(folder.join("out/plots")).map_err(|error| format!("plots of {name}: {error}"))?;
    let names = entries.filter_map(Result::ok).map(|entry| entry.file_name().to_string_lossy().into_owned());
    let mut plots: Vec<String> = names.filter(|plot| plot.ends_with(".svg")).collect();
    // The drawing first, then the curves by their names.
    plots.sort_by_key(|plot| (plot != "scene.svg", plot.clone()));
    let picture = |plot: &String| format!("![{}]({name}/out/plots/{plot})\n\n", alternative(title, plot));
    // A `console` block, not `sh`: it was run.
    let text = format!(
        "# {title}\n\n```console\n{command}\n```\n\n```text\n{}\n```\n\n<div class=\"gallery\">\n\n{}</div>\n\n## The scene\n\n```toml\n{}\n```\n",
        words.trim_end(),
        plots.iter().map(picture).collect::<String>(),
        text.trim_end()
    );
    Ok(Made { title: title.clone(), path: format!("book/scenes/{name}.md"), text })
}

/// What a picture shows, for who cannot see it.
fn alternative(title: &str, plot: &str) -> String {
    format!("{title}: {}", plot.trim_end_matches(".svg").replace('-', " ").replace("scene", "drawing of the scene"))
}
