//! What one percent more of a given number does, on the page.

use scene::short;
use serde_json::Value;

use crate::escape::breakable;

/// A table of the `sensitivity` of `summary.pressure`, one row a given number; empty without entries.
pub(crate) fn one_percent(pressure: &Value) -> String {
    let entries = pressure["sensitivity"].as_array().map(Vec::as_slice).unwrap_or_default();
    if entries.is_empty() {
        return String::new();
    }
    // The key is the same where nothing turns.
    let friction = if pressure["torque_Nmm"].is_null() { "friction force" } else { "torque" };
    let columns = [("wear rate", "wear_rate_percent"), (friction, "torque_percent"), ("largest pressure", "p_max_percent")];
    let headings: String = columns.iter().map(|(heading, _)| format!("<th>{heading}</th>")).collect();
    let mut out = format!("<h2>What 1 % more does</h2>\n<div class=\"wide\"><table>\n<tr><th>1 % more of</th>{headings}</tr>\n");
    for entry in entries {
        let cell = |key: &str| entry[key].as_f64().map_or("-".into(), percent);
        let cells = columns.iter().map(|(_, key)| format!("<td class=\"number\">{}</td>", cell(key)));
        let given = breakable(entry["given"].as_str().unwrap_or(""));
        out += &format!("<tr><td>{given}</td>{}</tr>\n", cells.collect::<String>());
    }
    out + "</table></div>\n<p>Each number alone, all others as they are.</p>\n"
}

/// A change to four decimals, with its sign.
fn percent(value: f64) -> String {
    let value = (value * 1e4).round() / 1e4;
    format!("{}{} %", if value > 0.0 { "+" } else { "" }, short(value))
}

#[cfg(test)]
mod tests {
    use super::one_percent;
    use serde_json::{Value, json};

    #[test]
    fn each_given_number_has_a_row_of_signed_percents() {
        let entries = json!([
            { "given": "load.force", "wear_rate_percent": 1.0000000001, "p_max_percent": -0.25 },
            { "given": "a < b", "wear_rate_percent": 1e-13, "torque_percent": 0.333333333 },
        ]);
        let table = one_percent(&json!({ "sensitivity": entries, "torque_Nmm": 1.0 }));
        assert!(table.contains("<th>torque</th>") && !table.contains("friction force"));
        let sliding = one_percent(&json!({ "sensitivity": entries }));
        assert_eq!(sliding.replace("<th>friction force</th>", "<th>torque</th>"), table);
        assert_eq!(table.matches("What 1 % more does").count(), 1);
        let row = |given: &str, cells: [&str; 3]| {
            let cells = cells.map(|cell| format!("<td class=\"number\">{cell}</td>")).concat();
            assert!(table.contains(&format!("<tr><td>{given}</td>{cells}</tr>")), "{table}");
        };
        row("load.<wbr>force", ["+1 %", "-", "-0.25 %"]);
        row("a &lt; b", ["0 %", "+0.3333 %", "-"]);
    }

    #[test]
    fn without_a_list_there_is_no_table() {
        assert_eq!([Value::Null, json!({ "sensitivity": [] })].map(|pressure| one_percent(&pressure)), ["", ""]);
    }
}
