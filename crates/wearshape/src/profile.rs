//! The columns of contact.csv.

use nalgebra::Vector3;

use crate::words::PointStatus;

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
    /// Pressure of a reversing motion as it goes backward (MPa); empty for other motions, and then no column.
    pub pressure_back: Vec<f64>,
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
    /// Temperature of body 1 and 2 (degC); empty without heat, and then no column. So are the next two.
    pub temperature: [Vec<f64>; 2],
    /// Frictional heat into body 1 and 2 (mW/mm^2).
    pub heat: [Vec<f64>; 2],
    /// Thermal part of the normal displacement of body 1 and 2 (um).
    pub thermal_displacement: [Vec<f64>; 2],
    /// contact, open, stick or slip.
    pub status: Vec<PointStatus>,
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
            pressure_back: Vec::new(),
            pressure_solved: nothing.clone(),
            shear: nothing.clone(),
            gap: nothing.clone(),
            opening: nothing.clone(),
            wear_rate: nothing.clone(),
            normal_displacement: pair(),
            tangential_displacement: pair(),
            hoop_displacement: pair(),
            temperature: Default::default(),
            heat: Default::default(),
            thermal_displacement: Default::default(),
            status: vec![PointStatus::Contact; points.len()],
        }
    }

    /// Takes away the results of a contact that was not found: all but the places and the gap.
    pub(crate) fn withdraw(&mut self) {
        let pairs = [&mut self.normal_displacement, &mut self.tangential_displacement, &mut self.hoop_displacement];
        let single = [&mut self.pressure, &mut self.shear, &mut self.opening, &mut self.wear_rate];
        single.into_iter().chain(pairs.into_iter().flatten()).for_each(|column| column.fill(f64::NAN));
        self.status.fill(PointStatus::Open);
    }
}

fn array(vector: Vector3<f64>) -> [f64; 3] {
    [vector.x, vector.y, vector.z]
}
