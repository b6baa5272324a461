//! What an elastic step leaves to the twist and the fields.

use hpfem::InterfaceState;

use crate::level::Level;
use crate::steps::heat::known::PointHeat;

/// What a stage leaves behind for the fields: the discretisation it reports, and the states of its bodies there.
pub(crate) struct Reported {
    /// The discretisation.
    pub level: Level,
    /// Ends of contact that the meshes are cut at, from -1 to 1 on the surface.
    pub ends: Vec<f64>,
    /// Frictional heat at the contact points, of a scene with heat.
    pub heat: Option<PointHeat>,
    /// The moments, the reported one first.
    pub moments: Vec<Moment>,
}

/// Both bodies at a moment.
pub(crate) struct Moment {
    /// Time (s); 0 where nothing runs in time.
    pub time: f64,
    /// Its name in file names; empty for the reported one.
    pub name: &'static str,
    /// Displacements of body 1, with its rigid motion taken out, and of body 2.
    pub states: [InterfaceState; 2],
    /// Shear around the axis on body 1 at the contact points (MPa), for the twist.
    pub around: Vec<f64>,
}
