//! path-NAME.csv: displacement, stress and temperature along a line through a body.

use wearshape::{PathProfile, Solution};

use crate::table::columns_csv;

/// The files of all lines, by name and text.
pub(crate) fn path_files(solution: &Solution) -> Vec<(String, String)> {
    solution.paths.iter().map(|path| (format!("path-{}.csv", path.name), columns_csv(&columns(path)))).collect()
}

/// The columns with their units in their names; stresses are called as in the fields.
fn columns(path: &PathProfile) -> Vec<(String, Vec<f64>)> {
    let rows = || 0..path.s.len();
    let column = |name: String, value: &dyn Fn(usize) -> f64| (name, rows().map(value).collect::<Vec<f64>>());
    let [x, y] = if path.revolved { ["r", "hoop"] } else { ["x", "y"] };
    let mut columns = vec![
        column("s_mm".into(), &|k| path.s[k]),
        column(format!("{x}_mm"), &|k| path.position[k][0]),
        column("z_mm".into(), &|k| path.position[k][1]),
        column(format!("u{x}_um"), &|k| 1e3 * path.displacement[k][0]),
        column("uz_um".into(), &|k| 1e3 * path.displacement[k][2]),
        column(format!("sigma_{x}_MPa"), &|k| path.stress[k].xx),
        column("sigma_z_MPa".into(), &|k| path.stress[k].zz),
        column(format!("sigma_{y}_MPa"), &|k| path.stress[k].yy),
        column(format!("tau_{x}z_MPa"), &|k| path.stress[k].xz),
    ];
    if path.twisted {
        columns.push(column("uphi_um".into(), &|k| 1e3 * path.displacement[k][1]));
        columns.push(column("tau_rphi_MPa".into(), &|k| path.stress[k].xy));
        columns.push(column("tau_phiz_MPa".into(), &|k| path.stress[k].yz));
    }
    columns.push(column("von_mises_MPa".into(), &|k| path.stress[k].von_mises()));
    if !path.temperature.is_empty() {
        columns.push(column("temperature_degC".into(), &|k| path.temperature[k]));
    }
    columns
}
