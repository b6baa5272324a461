//! No circle between the modules of a crate.
//!
//! A module is a file; the root of the crate is none. Where two modules import each other, directly or by way of others, neither can be
//! read, tested or moved without the other.

use super::finding::Finding;
use super::graph::{components, shortest_circle};
use super::modules::{Edges, Modules, module_name};
use super::parsed::Parsed;

/// Modules of one crate that hang in circles.
pub(super) struct Circle {
    /// Their names, in order.
    pub(super) modules: Vec<String>,
    /// A shortest circle: name of the importing module, its file, line of the import.
    pub(super) shortest: Vec<(String, String, usize)>,
    /// All imports from one of them to another: from, to, file of the first, line.
    pub(super) imports: Vec<(String, String, String, usize)>,
}

/// Findings in all crates; `known` says how many modules of a crate hang in circles today.
pub(super) fn check(files: &[Parsed], known: &[(&str, usize)]) -> Vec<Finding> {
    let mut findings = Vec::new();
    let crates = crates(files);
    for krate in &crates {
        let allowed = known.iter().find(|(name, _)| name == krate).map_or(0, |(_, count)| *count);
        let circles = circles(files, krate);
        let count: usize = circles.iter().map(|circle| circle.modules.len()).sum();
        if count > allowed {
            findings.extend(circles.iter().map(|circle| finding(circle, krate, (count, allowed))));
        } else if count < allowed {
            findings.push(stale(krate, allowed, count));
        }
    }
    let gone = known.iter().filter(|(name, _)| !crates.contains(name));
    findings.extend(gone.map(|(name, count)| stale(name, *count, 0)));
    findings
}

/// Names of the crates that have sources.
pub(super) fn crates(files: &[Parsed]) -> Vec<&str> {
    let mut crates: Vec<&str> = files.iter().map(|file| file.krate.as_str()).collect();
    crates.sort_unstable();
    crates.dedup();
    crates
}

/// The circles of one crate, the largest first.
pub(super) fn circles(files: &[Parsed], krate: &str) -> Vec<Circle> {
    let own: Vec<&Parsed> = files.iter().filter(|file| file.krate == krate).collect();
    let Some(modules) = Modules::new(&own) else {
        return Vec::new();
    };
    let edges = modules.edges();
    let pairs: Vec<(usize, usize)> = edges.keys().copied().collect();
    let found = components(modules.files.len(), &pairs);
    found.iter().map(|component| circle(&modules, &edges, component, &shortest_circle(component, &pairs))).collect()
}

fn circle(modules: &Modules<'_>, edges: &Edges, component: &[usize], shortest: &[usize]) -> Circle {
    let name = |at: usize| module_name(modules.files[at]);
    let path = |at: usize| modules.files[at].path.clone();
    let step = |at: usize| {
        let (from, to) = (shortest[at], shortest[(at + 1) % shortest.len()]);
        (name(from), path(from), edges[&(from, to)])
    };
    let inside = edges.iter().filter(|((from, to), _)| component.contains(from) && component.contains(to));
    let mut names: Vec<String> = component.iter().map(|&at| name(at)).collect();
    names.sort_unstable();
    Circle {
        modules: names,
        shortest: (0..shortest.len()).map(step).collect(),
        imports: inside.map(|(&(from, to), &line)| (name(from), name(to), path(from), line)).collect(),
    }
}

impl Circle {
    /// A shortest circle in words: `a (a.rs:1) -> b (b.rs:2) -> a`, the line being that of the import of the next.
    pub(super) fn way(&self) -> String {
        let steps: Vec<String> = self.shortest.iter().map(|(name, file, line)| format!("{name} ({file}:{line})")).collect();
        let back = self.shortest.first().map_or("", |(name, ..)| name);
        format!("{} -> {back}", steps.join(" -> "))
    }
}

fn finding(circle: &Circle, krate: &str, (count, allowed): (usize, usize)) -> Finding {
    let (file, line) = circle.shortest.first().map_or((String::new(), 1), |(_, file, line)| (file.clone(), *line));
    let more = if allowed == 0 { String::new() } else { format!(" ({count} in all circles of the crate, {allowed} are known)") };
    Finding {
        file,
        line,
        problem: format!(
            "{} modules of `{krate}` import each other in a circle{more}: {}; a shortest circle: {}",
            circle.modules.len(),
            circle.modules.join(", "),
            circle.way()
        ),
        remedy: "move what both need into a module below them, or pass it as an argument; `cargo xtask tidy --list` names every import"
            .into(),
    }
}

fn stale(krate: &str, allowed: usize, count: usize) -> Finding {
    Finding {
        file: "xtask/src/tidy/today.rs".into(),
        line: 1,
        problem: format!("CIRCLES says that {allowed} modules of `{krate}` hang in circles, and there are {count}"),
        remedy: if count == 0 { format!("take `{krate}` off the list") } else { format!("lower the number to {count}") },
    }
}

#[cfg(test)]
mod tests {
    use super::super::finding::file;
    use super::super::parsed::parse;
    use super::*;

    fn crate_of(texts: &[(&str, &str)]) -> Vec<Parsed> {
        let files: Vec<_> = texts.iter().map(|(path, text)| file(&format!("crates/wear/src/{path}"), text)).collect();
        parse(&files).0
    }

    fn two_and_one() -> Vec<Parsed> {
        crate_of(&[
            ("lib.rs", "mod law;\nmod stage;\nmod surface;\n"),
            ("law.rs", "use crate::surface::Point;\npub struct Law;\n"),
            ("stage.rs", "use crate::law::Law;\n\nuse crate::surface::Point;\n"),
            ("surface.rs", "pub struct Point;\n\nfn wear(law: &super::law::Law) {}\n"),
        ])
    }

    #[test]
    fn a_circle_is_found_with_its_imports() {
        let findings = check(&two_and_one(), &[]);
        assert_eq!(findings.len(), 1);
        assert_eq!((findings[0].file.as_str(), findings[0].line), ("crates/wear/src/law.rs", 1));
        let way = "law (crates/wear/src/law.rs:1) -> surface (crates/wear/src/surface.rs:3) -> law";
        assert!(findings[0].problem.contains("2 modules of `wear`") && findings[0].problem.ends_with(way));
    }

    #[test]
    fn known_circles_may_only_shrink() {
        assert!(check(&two_and_one(), &[("wear", 2)]).is_empty());
        assert!(check(&two_and_one(), &[("wear", 1)])[0].problem.contains("2 in all circles of the crate, 1 are known"));
        assert_eq!(check(&two_and_one(), &[("wear", 3)])[0].remedy, "lower the number to 2");
        let straight = crate_of(&[("lib.rs", "mod law;\n"), ("law.rs", "")]);
        assert_eq!(check(&straight, &[("wear", 2)])[0].remedy, "take `wear` off the list");
        assert_eq!(check(&straight, &[("gone", 2)])[0].remedy, "take `gone` off the list");
    }

    #[test]
    fn imports_down_the_tree_are_no_circle() {
        let files = crate_of(&[
            ("lib.rs", "mod law;\nmod stage;\npub use stage::Stage;\n"),
            ("law.rs", "pub struct Law;\n"),
            ("stage.rs", "mod part;\nuse crate::law::Law;\npub use part::Stage;\n"),
            ("stage/part.rs", "use crate::law::Law;\npub struct Stage;\n"),
        ]);
        assert!(check(&files, &[]).is_empty());
    }
}
