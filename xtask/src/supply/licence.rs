//! Licence expressions: names joined by `OR` (of old, `/`), `AND` and `WITH`, with brackets.

/// Whether an expression can be met by allowed licences alone; a name with its exception is one name.
///
/// # Errors
/// What is wrong with the expression.
pub(super) fn permits(expression: &str, allowed: &dyn Fn(&str) -> bool) -> Result<bool, String> {
    let spaced = expression.replace('(', " ( ").replace(')', " ) ").replace('/', " OR ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut rest = words.as_slice();
    let met = any(&mut rest, allowed)?;
    match rest.first() {
        None => Ok(met),
        Some(word) => Err(format!("`{word}` is one too many")),
    }
}

fn any(rest: &mut &[&str], allowed: &dyn Fn(&str) -> bool) -> Result<bool, String> {
    let mut met = all(rest, allowed)?;
    while take(rest, "OR") {
        met |= all(rest, allowed)?;
    }
    Ok(met)
}

fn all(rest: &mut &[&str], allowed: &dyn Fn(&str) -> bool) -> Result<bool, String> {
    let mut met = one(rest, allowed)?;
    while take(rest, "AND") {
        met &= one(rest, allowed)?;
    }
    Ok(met)
}

fn one(rest: &mut &[&str], allowed: &dyn Fn(&str) -> bool) -> Result<bool, String> {
    if take(rest, "(") {
        let met = any(rest, allowed)?;
        return if take(rest, ")") { Ok(met) } else { Err("a bracket is left open".into()) };
    }
    let name = word(rest)?;
    if take(rest, "WITH") {
        let exception = word(rest)?;
        return Ok(allowed(&format!("{name} WITH {exception}")));
    }
    Ok(allowed(name))
}

fn word<'a>(rest: &mut &[&'a str]) -> Result<&'a str, String> {
    let (first, others) = rest.split_first().ok_or("a name is missing at its end")?;
    if ["OR", "AND", "WITH", "(", ")"].contains(first) {
        return Err(format!("`{first}` stands where a name is due"));
    }
    *rest = others;
    Ok(first)
}

fn take(rest: &mut &[&str], word: &str) -> bool {
    match rest.split_first() {
        Some((first, others)) if *first == word => {
            *rest = others;
            true
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_expression_is_met_by_one_side_of_or_and_by_both_of_and() {
        let allowed = |name: &str| ["MIT", "Unicode-3.0", "Apache-2.0 WITH LLVM-exception"].contains(&name);
        for (expression, met) in [
            ("MIT", true),
            ("GPL-2.0", false),
            ("GPL-2.0/MIT", true),
            ("GPL-2.0 OR MIT AND GPL-3.0", false),
            ("(MIT OR Apache-2.0) AND Unicode-3.0", true),
            ("(GPL-2.0 OR Apache-2.0) AND Unicode-3.0", false),
            ("Apache-2.0 WITH LLVM-exception", true),
            ("Apache-2.0", false),
        ] {
            assert_eq!(permits(expression, &allowed), Ok(met), "{expression}");
        }
        for wrong in ["", "MIT OR", "(MIT", "MIT)", "MIT MIT", "AND"] {
            assert!(permits(wrong, &allowed).is_err(), "{wrong}");
        }
    }
}
