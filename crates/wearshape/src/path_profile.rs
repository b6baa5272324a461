//! Displacement, stress and temperature along a line or arc through a body.

use hpfem::Stress;

use crate::body_field::FieldFrame;
use crate::results::EnergyResult;

/// Numbers at the points of a line, in order along it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PathProfile {
    /// Goes into the name of the file.
    pub name: String,
    /// Body 1 or 2.
    pub body: usize,
    /// Distance from the first end (mm).
    pub s: Vec<f64>,
    /// Position (x, z), mm, of the unloaded body.
    pub position: Vec<[f64; 2]>,
    /// Displacement (x, y, z), mm.
    pub displacement: Vec<[f64; 3]>,
    /// Stress (MPa); on the border of two cells that of the first of them.
    pub stress: Vec<Stress>,
    /// Temperature (degC); empty without heat.
    pub temperature: Vec<f64>,
    /// The body is revolved about the axis: x is r, and y the direction around the axis.
    pub revolved: bool,
    /// Friction twists the body: the displacement along y and the shears xy and yz are known.
    pub twisted: bool,
}

/// What is recovered inside the bodies.
#[derive(Default)]
pub(crate) struct Inside {
    /// On all cells, the reported moment first; empty unless asked for.
    pub frames: Vec<FieldFrame>,
    /// Along lines, at the reported moment.
    pub paths: Vec<PathProfile>,
    /// Strain energies of bodies with thermal strains at the reported moment: the work of their loads does not tell these.
    pub energy: Option<EnergyResult>,
}
