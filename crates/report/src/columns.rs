//! Tables as CSV.

use scene::number_text;
use wearshape::Profile;

/// contact.csv: one row a contact point.
pub fn profile_csv(profile: &Profile) -> String {
    let mut out = String::from(
        "s_mm,x_mm,y_mm,z_mm,nx,ny,nz,weight_mm2,pressure_MPa,pressure_solved_MPa,shear_MPa,gap_um,opening_um,\
         wear_rate_um_per_s,un1_um,un2_um,ut1_um,ut2_um,uphi1_um,uphi2_um,status\n",
    );
    for (row, s) in profile.s.iter().enumerate() {
        let [x, y, z] = profile.position[row];
        let [nx, ny, nz] = profile.normal[row];
        let numbers = [
            *s,
            x,
            y,
            z,
            nx,
            ny,
            nz,
            profile.weight[row],
            profile.pressure[row],
            profile.pressure_solved[row],
            profile.shear[row],
            profile.gap[row],
            profile.opening[row],
            profile.wear_rate[row],
            profile.normal_displacement[0][row],
            profile.normal_displacement[1][row],
            profile.tangential_displacement[0][row],
            profile.tangential_displacement[1][row],
            profile.hoop_displacement[0][row],
            profile.hoop_displacement[1][row],
        ];
        for number in numbers {
            out += &number_text(number);
            out.push(',');
        }
        out += profile.status[row];
        out.push('\n');
    }
    out
}

/// Named columns.
pub fn columns_csv(columns: &[(String, Vec<f64>)]) -> String {
    let names: Vec<&str> = columns.iter().map(|(name, _)| name.as_str()).collect();
    let mut out = names.join(",") + "\n";
    for row in 0..columns.iter().map(|(_, values)| values.len()).min().unwrap_or(0) {
        let cells: Vec<String> = columns.iter().map(|(_, values)| number_text(values[row])).collect();
        out += &(cells.join(",") + "\n");
    }
    out
}
