//! `cargo xtask tidy --list`: the figures that the lists of today stand for, to measure before and after.

use super::circles::{Circle, circles, crates};
use super::lengths::{Function, long, wide};
use super::parsed::{Parsed, production_lines};

/// The figures as text.
pub(super) fn figures(files: &[Parsed]) -> String {
    let (long, wide) = (long(files), wide(files));
    let mut text = table(files, &long, &wide);
    text += "\nfunctions over 60 lines\n";
    for function in &long {
        text += &format!("  {:>4}  {} (line {})\n", function.lines, function.place, function.line);
    }
    text += "\nsignatures over 5 arguments\n";
    for function in &wide {
        text += &format!("  {:>4}  {} (line {})\n", function.arguments, function.place, function.line);
    }
    for krate in crates(files) {
        for found in circles(files, krate) {
            text += &circle(krate, &found);
        }
    }
    text
}

fn table(files: &[Parsed], long: &[Function], wide: &[Function]) -> String {
    let mut text =
        String::from("crate        modules  in circles  functions over 60 lines  signatures over 5 arguments   lines\n");
    let mut sums = [0; 5];
    for krate in crates(files) {
        let own: Vec<&Parsed> = files.iter().filter(|file| file.krate == krate).collect();
        let of_crate = |functions: &[Function]| functions.iter().filter(|f| f.place.starts_with(&format!("{krate}/"))).count();
        let row = [
            own.iter().filter(|file| !matches!(file.inner.as_str(), "lib.rs" | "main.rs")).count(),
            circles(files, krate).iter().map(|circle| circle.modules.len()).sum(),
            of_crate(long),
            of_crate(wide),
            own.iter().map(|file| production_lines(file)).sum(),
        ];
        text += &line(krate, row);
        sums = std::array::from_fn(|at| sums[at] + row[at]);
    }
    text + &line("all", sums)
}

fn line(name: &str, [modules, in_circles, long, wide, lines]: [usize; 5]) -> String {
    format!("{name:<12} {modules:>7}  {in_circles:>10}  {long:>23}  {wide:>27}  {lines:>6}\n")
}

/// One circle: a shortest way around, and for each module what it imports of the others.
fn circle(krate: &str, circle: &Circle) -> String {
    let mut text = format!("\n{} modules of {krate} in one circle; shortest: {}\n", circle.modules.len(), circle.way());
    for module in &circle.modules {
        let own = circle.imports.iter().filter(|(from, ..)| from == module);
        let imports: Vec<String> = own.map(|(_, to, _, line)| format!("{to} ({line})")).collect();
        text += &format!("  {module}: {}\n", imports.join(", "));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::super::finding::file;
    use super::super::parsed::parse;
    use super::*;

    #[test]
    fn the_figures_of_a_crate_stand_in_one_line() {
        let (parsed, _) = parse(&[
            file("crates/wear/src/lib.rs", "mod law;\nmod stage;\n"),
            file("crates/wear/src/law.rs", "use crate::stage::Stage;\n"),
            file("crates/wear/src/stage.rs", "use crate::law::Law;\n\nfn f(a: u8, b: u8, c: u8, d: u8, e: u8, f: u8) {}\n"),
        ]);
        let text = figures(&parsed);
        let row: Vec<&str> = text.lines().nth(1).expect("a row").split_whitespace().collect();
        assert_eq!(row, ["wear", "2", "2", "0", "1", "6"]);
        assert!(text.contains("     6  wear/stage.rs: f (line 3)\n"));
        assert!(text.contains("  law: stage (1)\n  stage: law (1)\n"));
    }
}
