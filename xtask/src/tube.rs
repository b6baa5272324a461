//! hpfem by itself in a browser: a module of it alone, called from node, must compute the digits of the native example.

use std::path::Path;
use std::process::{Command, Stdio};

use super::packages::{cargo, printed};

/// The package of the module.
pub(crate) const PACKAGE: &str = "tube";
/// Degree at which the module and the native example are compared.
const DEGREE: &str = "10";

/// Compares the digits of a module with those of the native example, and says what the module says.
pub(crate) fn compared(root: &Path, module: &Path) -> Result<String, String> {
    let mut node = Command::new("node");
    let called = printed(node.arg(root.join("tests/wasm/tube.mjs")).arg(module).arg(DEGREE).stdin(Stdio::null()))?;
    let mut example = cargo(root);
    example.args(["run", "--quiet", "--release", "--package", "wearshape-hpfem", "--example", "thick_cylinder"]);
    let native = printed(&mut example)?;
    same_digits(&called, &native)?;
    Ok(format!("hpfem alone, in node: {}", called.trim()))
}

/// Whether the module printed the line of its degree as the native example did.
fn same_digits(module: &str, native: &str) -> Result<(), String> {
    let says = |text: &str| {
        let line = text.lines().find(|line| line.starts_with(&format!("degree {DEGREE}:")))?;
        line.split_whitespace().nth(4).map(|number| number.trim_end_matches(',').to_string())
    };
    match (says(module), says(native)) {
        (Some(a), Some(b)) if a == b => Ok(()),
        _ => Err(format!("the module says `{}`, the native example\n{native}", module.trim())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_of_the_module_are_those_of_the_native_example() {
        let native =
            "degree  8: u_r = 0.000453968255, relative error 1e-9\ndegree 10: u_r = 0.000453968254, relative error 1.3e-12\n";
        assert!(same_digits("degree 10: u_r = 0.000453968254 (0.00045396825396)", native).is_ok());
        assert!(same_digits("degree 10: u_r = 0.000453968255 (0.00045396825496)", native).is_err());
        assert!(same_digits("degree 10: u_r = NaN (NaN)", native).is_err());
        assert!(same_digits("", "").is_err());
    }
}
