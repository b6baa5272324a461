//! The columns of contact.csv.

use nalgebra::Vector3;
use scene::number_text;

/// Numbers at the contact points, in order along the surface; NaN where not available.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Profile {
    /// Arc length from the middle, or r (mm).
    pub s: Vec<f64>,
    /// Position (mm).
    pub position: Vec<[f64; 3]>,
    /// Unit normal out of body 2 into body 1.
    pub normal: Vec<[f64; 3]>,
    /// Area weight (mm^2).
    pub weight: Vec<f64>,
    /// Pressure of the last task: optimal, solved, wanted, current (MPa).
    pub pressure: Vec<f64>,
    /// Pressure of the round trip (MPa).
    pub pressure_solved: Vec<f64>,
    /// Shear on body 1 along tau (MPa).
    pub shear: Vec<f64>,
    /// Unloaded gap (um).
    pub gap: Vec<f64>,
    /// Gap under load (um).
    pub opening: Vec<f64>,
    /// Wear rate of both bodies (um/s).
    pub wear_rate: Vec<f64>,
    /// Normal displacement of body 1 and 2 (um).
    pub normal_displacement: [Vec<f64>; 2],
    /// Displacement along tau of body 1 and 2 (um).
    pub tangential_displacement: [Vec<f64>; 2],
    /// Displacement around the axis of body 1 and 2, positive anti-clockwise (um).
    pub hoop_displacement: [Vec<f64>; 2],
    /// contact, open, stick or slip.
    pub status: Vec<&'static str>,
}

impl Profile {
    /// A profile of points without results: every column of results is NaN.
    pub fn new(s: Vec<f64>, points: &[wear::SurfacePoint]) -> Profile {
        let nothing = vec![f64::NAN; points.len()];
        let pair = || [nothing.clone(), nothing.clone()];
        Profile {
            s,
            position: points.iter().map(|point| array(point.position)).collect(),
            normal: points.iter().map(|point| array(point.normal)).collect(),
            weight: points.iter().map(|point| point.weight).collect(),
            pressure: nothing.clone(),
            pressure_solved: nothing.clone(),
            shear: nothing.clone(),
            gap: nothing.clone(),
            opening: nothing.clone(),
            wear_rate: nothing.clone(),
            normal_displacement: pair(),
            tangential_displacement: pair(),
            hoop_displacement: pair(),
            status: vec!["contact"; points.len()],
        }
    }

    /// The table as CSV.
    pub fn csv(&self) -> String {
        let mut out = String::from(
            "s_mm,x_mm,y_mm,z_mm,nx,ny,nz,weight_mm2,pressure_MPa,pressure_solved_MPa,shear_MPa,gap_um,opening_um,\
             wear_rate_um_per_s,un1_um,un2_um,ut1_um,ut2_um,uphi1_um,uphi2_um,status\n",
        );
        for (row, s) in self.s.iter().enumerate() {
            let [x, y, z] = self.position[row];
            let [nx, ny, nz] = self.normal[row];
            let numbers = [
                *s,
                x,
                y,
                z,
                nx,
                ny,
                nz,
                self.weight[row],
                self.pressure[row],
                self.pressure_solved[row],
                self.shear[row],
                self.gap[row],
                self.opening[row],
                self.wear_rate[row],
                self.normal_displacement[0][row],
                self.normal_displacement[1][row],
                self.tangential_displacement[0][row],
                self.tangential_displacement[1][row],
                self.hoop_displacement[0][row],
                self.hoop_displacement[1][row],
            ];
            for number in numbers {
                out += &number_text(number);
                out.push(',');
            }
            out += self.status[row];
            out.push('\n');
        }
        out
    }
}

fn array(vector: Vector3<f64>) -> [f64; 3] {
    [vector.x, vector.y, vector.z]
}
