//! The pages: those that the table of contents names, each at its path of the repository, and the files that they link to.

use std::path::{Component, Path, PathBuf};

use super::excerpt;
use super::files::{copied, read, write};
use super::gallery;
use super::keys;
use super::play::Player;

/// The table of contents.
const SUMMARY: &str = "book/SUMMARY.md";

/// What was made.
pub(super) struct Book {
    pub pages: usize,
    pub commands: usize,
}

/// Writes all pages below `stage`, with what their commands print.
pub(super) fn written(player: &Player<'_>, stage: &Path) -> Result<Book, String> {
    let mut summary = read(&player.root.join(SUMMARY))?;
    let keys = keys::pages(player)?;
    let scenes = gallery::pages(player)?;
    for (place, made) in [("<!-- keys -->", &keys), ("<!-- scenes -->", &scenes)] {
        let lines: Vec<String> = made.iter().map(|page| format!("  - [{}]({})", page.title, page.path)).collect();
        summary = summary.replace(place, &lines.join("\n"));
    }
    let mut book = Book { pages: 0, commands: 0 };
    for path in linked(&summary).iter().filter(|path| path.ends_with(".md")) {
        let made = keys.iter().chain(&scenes).find(|page| page.path == *path);
        let source = match made {
            Some(page) => page.text.clone(),
            None => read(&player.root.join(path))?,
        };
        let text = filled(player, &source).map_err(|error| format!("{path}: {error}"))?;
        let (text, commands) = player.played(path, &text).map_err(|error| format!("{path}: {error}"))?;
        for file in linked(&text) {
            bring(player, stage, path, &file).map_err(|error| format!("{path}: {error}"))?;
        }
        // mdBook shows a README as the index of its folder, and links to it must say so.
        write(&stage.join(path.replace("README.md", "index.md")), &renamed(&text))?;
        book.pages += 1;
        book.commands += commands;
    }
    write(&stage.join("SUMMARY.md"), &renamed(&summary))?;
    Ok(book)
}

fn renamed(text: &str) -> String {
    ["README.md)", "README.md#"].iter().fold(text.to_string(), |text, link| text.replace(link, &link.replace("README", "index")))
}

/// Replaces what stands for a part of another file: `<!-- code: FILE -->` and `<!-- code: FILE | START -->`, `<!-- keys: KEY -->`, `<!-- web -->`.
fn filled(player: &Player<'_>, text: &str) -> Result<String, String> {
    let mut lines = Vec::new();
    for line in text.lines() {
        let order = line.trim().strip_prefix("<!-- ").and_then(|line| line.strip_suffix(" -->"));
        let indent = &line[..line.len() - line.trim_start().len()];
        let part = match order.map(|order| order.split_once(": ").unwrap_or((order, ""))) {
            Some(("code", what)) => code(player.root, what)?,
            Some(("keys", "")) => keys::top(player)?,
            Some(("units", "")) => keys::units(player)?,
            Some(("scenes", "")) => gallery::list(player)?,
            Some(("web", "")) => web(player.root),
            _ => {
                lines.push(line.to_string());
                continue;
            }
        };
        lines.extend(part.lines().map(|line| format!("{indent}{line}")));
    }
    Ok(lines.join("\n") + "\n")
}

/// A file, or a piece of it, as a block of code under its name.
fn code(root: &Path, what: &str) -> Result<String, String> {
    let (file, start) = what.split_once(" | ").map_or((what, None), |(file, start)| (file, Some(start)));
    let text = read(&root.join(file))?;
    let piece = match start {
        Some(start) => excerpt::of(&text, start).ok_or_else(|| format!("{file} has no line with `{start}`"))?,
        None => text.trim_end().to_string(),
    };
    let language = match file.rsplit('.').next() {
        Some("rs") => "rust",
        Some(other) => other,
        None => "text",
    };
    Ok(format!("`{file}`:\n\n```{language}\n{piece}\n```"))
}

/// The page that computes, if it was built.
fn web(root: &Path) -> String {
    if root.join("target/web/index.html").exists() {
        "<p><a href=\"../web/index.html\">The page by itself</a>, without the book around it.</p>\n\n\
         <iframe class=\"web\" src=\"../web/index.html\" title=\"wearshape in the browser\"></iframe>"
            .into()
    } else {
        "This copy of the book was built without it: `cargo xtask web` builds the page, and `cargo xtask book` after that puts it here.".into()
    }
}

/// Paths that a text links to, in their order and once, without those outside and within itself; anchors are cut off.
fn linked(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut fenced = false;
    for line in text.lines() {
        fenced ^= line.trim_start().starts_with("```");
        for rest in line.split("](").skip(1).filter(|_| !fenced) {
            let target = rest.split(')').next().unwrap_or_default();
            let path = target.split('#').next().unwrap_or_default().to_string();
            if !path.is_empty() && !path.contains("://") && !found.contains(&path) {
                found.push(path);
            }
        }
    }
    found
}

/// Copies a file that a page links to, from the runs of the page or from the repository; other pages come by themselves.
fn bring(player: &Player<'_>, stage: &Path, page: &str, link: &str) -> Result<(), String> {
    if link.ends_with(".md") || link.ends_with(".html") {
        return Ok(());
    }
    let path = plain(&Path::new(page).parent().unwrap_or(Path::new("")).join(link));
    let places = [player.runs.join(&path), player.root.join(&path)];
    let Some(from) = places.iter().find(|place| place.is_file()) else {
        return Err(format!("there is no {}", path.display()));
    };
    copied(from, &stage.join(&path))
}

/// A path without `..`.
fn plain(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::new(), |mut plain, part| {
        match part {
            Component::ParentDir => {
                plain.pop();
            }
            other => plain.push(other),
        }
        plain
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_are_found_outside_of_code() {
        let text = "[a](x.md#y), ![b](p/q.svg) [c](https://a.org/b) [d](#here)\n```rust\nf[0](z.md)\n```\n[e](x.md)\n";
        assert_eq!(linked(text), ["x.md", "p/q.svg"]);
    }

    #[test]
    fn paths_are_made_plain() {
        assert_eq!(plain(Path::new("book/../docs/a.svg")), Path::new("docs/a.svg"));
    }
}
