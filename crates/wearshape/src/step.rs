//! The names of what a run does.

use serde::Serialize;

use crate::words::word;

/// A stage of a run, in the words of the summary and of timing.json.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub enum Step {
    /// The force of a prescribed approach.
    #[serde(rename = "force of the approach")]
    Force,
    /// The optimal or steady pressure.
    #[serde(rename = "optimal pressure")]
    Pressure,
    /// Meshes of both bodies.
    #[serde(rename = "mesh")]
    Mesh,
    /// Cell matrices.
    #[serde(rename = "assemble")]
    Assemble,
    /// Elimination down to the contact surface.
    #[serde(rename = "factor")]
    Factor,
    /// Responses of the contact points.
    #[serde(rename = "interface")]
    Interface,
    /// The contact of the bodies as given.
    #[serde(rename = "contact")]
    Contact,
    /// The shape that has the pressure.
    #[serde(rename = "shape")]
    Shape,
    /// Contact solves that prove the shape.
    #[serde(rename = "round trip")]
    RoundTrip,
    /// Wear in time.
    #[serde(rename = "evolution")]
    Evolution,
    /// The scalar problem of twisting.
    #[serde(rename = "torsion")]
    Torsion,
    /// Temperatures of the bodies, and what they do to the contact surface.
    #[serde(rename = "heat")]
    Heat,
    /// Columns of the friction shear.
    #[serde(rename = "tangential columns")]
    Tangential,
    /// Displacement and stress inside the bodies.
    #[serde(rename = "field recovery")]
    Fields,
    /// The table of the contact points.
    #[serde(rename = "contact.csv")]
    Table,
    /// The surface to machine.
    #[serde(rename = "machined profile")]
    Machined,
    /// Pictures.
    #[serde(rename = "plots")]
    Plots,
    /// The page.
    #[serde(rename = "report.html")]
    Page,
    /// The recording.
    #[serde(rename = "run.mcap")]
    Recording,
}

impl Step {
    /// Its name in files and on the screen.
    pub fn name(self) -> String {
        word(&self)
    }
}
