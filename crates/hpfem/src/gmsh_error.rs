//! What can be wrong with a gmsh file.

use crate::error::Error;

/// What can be wrong with a gmsh file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GmshError {
    /// The file cannot be read.
    #[error("gmsh file, byte {byte}: {reason}")]
    Syntax {
        /// What is wrong.
        reason: String,
        /// Place in the file, bytes from its start.
        byte: usize,
    },
    /// A file version that is not read.
    #[error("gmsh file version {version} is not supported; save as MSH 4.1 or 2.2")]
    Version {
        /// The version of the file.
        version: String,
    },
    /// An element type that is not read.
    #[error(
        "gmsh element type {kind} is not supported: only quadrilaterals and triangles of order 1 to 4 and their edges; save the plane mesh alone (Mesh.SaveAll = 0)"
    )]
    ElementType {
        /// Gmsh's number of the type.
        kind: i32,
    },
    /// An element refers to a node that the file does not have.
    #[error("element {element} refers to node {node}, which the file does not have")]
    NoSuchNode {
        /// Tag of the element.
        element: u64,
        /// Tag of the node.
        node: u64,
    },
    /// The nodes do not lie in a coordinate plane.
    #[error("the mesh is not plane: its nodes span {y:.3e} in y and {z:.3e} in z, and one of them must be constant")]
    NotPlane {
        /// Extent in y.
        y: f64,
        /// Extent in z.
        z: f64,
    },
    /// There are no cells.
    #[error("the file has no quadrilaterals or triangles; put the surfaces to be meshed into a physical group")]
    NoCells,
    /// A line of a physical curve is not an edge of a cell.
    #[error("line {element} of the physical curve \"{name}\" is not an edge of any cell")]
    LooseLine {
        /// Tag of the line.
        element: u64,
        /// Name of the group.
        name: String,
    },
    /// More than two cells share an edge, or two lie on the same side of it.
    #[error("the edge between the nodes {} and {} is shared by more than two cells, or two lie on one side of it", nodes[0], nodes[1])]
    Overlapping {
        /// Tags of the nodes.
        nodes: [u64; 2],
    },
    /// The mesh is not valid.
    #[error(transparent)]
    Mesh(#[from] Error),
}
