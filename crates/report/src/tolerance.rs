//! The tolerance band of a shape on the page.

use serde_json::Value;

use crate::brief::brief;
use crate::escape::escaped;

/// A table of `summary.shape.tolerance` with a sentence under it; empty without entries.
pub(crate) fn tolerance(entries: &Value) -> String {
    let entries = entries.as_array().map(Vec::as_slice).unwrap_or_default();
    let number = |entry: &Value, key: &str| entry[key].as_f64();
    let Some(tightest) = entries.iter().filter_map(|e| number(e, "within_10_percent_um")).reduce(f64::min) else {
        return String::new();
    };
    let mut out = "<h2>Tolerance</h2>\n<div class=\"wide\"><table>\n<tr><th>error of the shape</th><th>keeps the pressure within 10 %, &micro;m</th>\
                   <th>1 &micro;m changes it by, %</th><th>rms, %</th><th>worn to 1/e after, mm</th></tr>\n"
        .to_string();
    for entry in entries {
        let cell = |key: &str, factor: f64| number(entry, key).map_or("-".into(), |value| brief(factor * value));
        out += &format!(
            "<tr><td>{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n",
            escaped(entry["error"].as_str().unwrap_or("")),
            cell("within_10_percent_um", 1.0),
            cell("pressure_change_relative", 100.0),
            cell("pressure_change_rms", 100.0),
            cell("run_in_distance_mm", 1.0),
        );
    }
    out + &format!(
        "</table></div>\n<p>An error of &plusmn;{} &micro;m keeps the pressure within 10 % of its mean, whichever of these it is. In proportion \
         to the error, over the inner 95 % of the surface; L is its length. Errors that the free motions of body 1 take up \
         are left out.</p>\n",
        brief(tightest)
    )
}
