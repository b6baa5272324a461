//! Tables as CSV: fields parted by commas, quoted only where they must be, lines ended by LF.

use scene::number_text;
use wearshape::Profile;

/// A table of texts; every row is as long as the names.
pub fn table(names: &[&str], rows: impl IntoIterator<Item: IntoIterator<Item: AsRef<[u8]>>>) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let written = writer.write_record(names).and_then(|()| rows.into_iter().try_for_each(|row| writer.write_record(row)));
    assert!(written.is_ok(), "a row of {names:?} is too short or too long");
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

/// A row of numbers, each in the shortest form that reads back to the same bits.
pub fn numbers_row(numbers: &[f64]) -> Vec<String> {
    numbers.iter().map(|number| number_text(*number)).collect()
}

/// Named columns of numbers, as many rows as the shortest has.
pub fn columns_csv(columns: &[(String, Vec<f64>)]) -> String {
    let names: Vec<&str> = columns.iter().map(|(name, _)| name.as_str()).collect();
    let rows = columns.iter().map(|(_, values)| values.len()).min().unwrap_or(0);
    table(&names, (0..rows).map(|row| columns.iter().map(move |(_, values)| number_text(values[row]))))
}

/// The numbers of a column of a table; none if it has no such column, or a row without a number there.
pub fn column(table: &str, name: &str) -> Option<Vec<f64>> {
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(table.as_bytes());
    let at = reader.headers().ok()?.iter().position(|known| known == name)?;
    reader.records().map(|row| row.ok()?.get(at)?.parse().ok()).collect()
}

/// A column of contact.csv: its name with its unit, and the value at the contact point of a number.
pub type ContactColumn = (&'static str, fn(&Profile, usize) -> f64);

/// The columns of contact.csv before its status, in their order; units stand in the names.
pub const CONTACT_COLUMNS: [ContactColumn; 20] = [
    ("s_mm", |p, k| p.s[k]),
    ("x_mm", |p, k| p.position[k][0]),
    ("y_mm", |p, k| p.position[k][1]),
    ("z_mm", |p, k| p.position[k][2]),
    ("nx", |p, k| p.normal[k][0]),
    ("ny", |p, k| p.normal[k][1]),
    ("nz", |p, k| p.normal[k][2]),
    ("weight_mm2", |p, k| p.weight[k]),
    ("pressure_MPa", |p, k| p.pressure[k]),
    ("pressure_solved_MPa", |p, k| p.pressure_solved[k]),
    ("shear_MPa", |p, k| p.shear[k]),
    ("gap_um", |p, k| p.gap[k]),
    ("opening_um", |p, k| p.opening[k]),
    ("wear_rate_um_per_s", |p, k| p.wear_rate[k]),
    ("un1_um", |p, k| p.normal_displacement[0][k]),
    ("un2_um", |p, k| p.normal_displacement[1][k]),
    ("ut1_um", |p, k| p.tangential_displacement[0][k]),
    ("ut2_um", |p, k| p.tangential_displacement[1][k]),
    ("uphi1_um", |p, k| p.hoop_displacement[0][k]),
    ("uphi2_um", |p, k| p.hoop_displacement[1][k]),
];

/// The pressure backward, of a reversing motion alone.
const PRESSURE_BACK: ContactColumn = ("pressure_back_MPa", |p, k| p.pressure_back[k]);

/// Temperature, heat and thermal displacement, of scenes with heat alone.
const HEAT: [ContactColumn; 6] = [
    ("temperature1_degC", |p, k| p.temperature[0][k]),
    ("temperature2_degC", |p, k| p.temperature[1][k]),
    ("heat1_mW_mm2", |p, k| p.heat[0][k]),
    ("heat2_mW_mm2", |p, k| p.heat[1][k]),
    ("unth1_um", |p, k| p.thermal_displacement[0][k]),
    ("unth2_um", |p, k| p.thermal_displacement[1][k]),
];

/// contact.csv: one row a contact point.
pub(crate) fn profile_csv(profile: &Profile) -> String {
    let back = (!profile.pressure_back.is_empty()).then_some(PRESSURE_BACK);
    let hot: &[ContactColumn] = if profile.temperature[0].is_empty() { &[] } else { &HEAT };
    let columns = || CONTACT_COLUMNS.iter().copied().chain(back).chain(hot.iter().copied());
    let names: Vec<&str> = columns().map(|(name, _)| name).chain(["status"]).collect();
    let numbers = |row| columns().map(move |(_, value)| number_text(value(profile, row)));
    let status = |row: usize| profile.status[row].word().to_string();
    table(&names, (0..profile.s.len()).map(|row| numbers(row).chain([status(row)])))
}
