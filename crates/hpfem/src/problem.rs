//! The problem of one body: mesh, degrees, materials, supports and loads.

use crate::basis::SpaceKind;
use crate::freedom::{Direction, Foundation, Pin, RigidEdge, Support};
use crate::kinematics::Kinematics;
use crate::load_case::{Load, LoadCase};
use crate::material::Material;
use crate::mesh::Mesh;
use std::sync::Arc;

/// The problem of one body. It owns all it is made of, so that a [`Body`](crate::Body) can be stored, returned and sent to a thread; a
/// mesh shared by several problems is an `Arc`, and cloning a problem does not copy it.
///
/// ```
/// use hpfem::*;
/// let cells = [Quad { corners: [0, 1, 2, 3], material: 0, layer: 0 }];
/// let names = [([0, 1], "below"), ([3, 0], "left"), ([1, 2], "right")];
/// let mesh = Mesh::new(vec![[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]], &cells, &[], &names)?;
/// let problem = BodyProblem::new(mesh, 4, Kinematics::PlaneStress { thickness: 1.0 })
///     .material(Material::isotropic(210e3, 0.3)?)
///     .roller("left")
///     .roller("below")
///     .load("pull", EdgeTraction::new("right", |_| [100.0, 0.0]));
/// let body = Body::new(problem)?;
/// let field = body.field(&body.solve(&[("pull", 1.0)])?)?;
/// assert!((field.at(0, 1.0, 1.0)?.displacement[0] - 2.0 * 100.0 / 210e3).abs() < 1e-15);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct BodyProblem {
    /// The mesh.
    pub mesh: Arc<Mesh>,
    /// Degree of every cell, one a cell, `1..=`[`MAX_DEGREE`](crate::MAX_DEGREE).
    pub degrees: Vec<usize>,
    /// Tensor or trunk space.
    pub space: SpaceKind,
    /// Plane stress, plane strain, axisymmetric, torsion or a potential.
    pub kinematics: Kinematics,
    /// Materials, by the index of the cells.
    pub materials: Vec<Material>,
    /// Prescribed displacement components.
    pub supports: Vec<Support>,
    /// A boundary that moves as a rigid line.
    pub rigid_edge: Option<RigidEdge>,
    /// Whether the force of what holds and moves the rigid edge is a reaction too: the last one, after those of supports and pins.
    pub edge_reaction: bool,
    /// Pinned vertices; their reactions are numbered after those of the supports.
    pub pins: Vec<Pin>,
    /// Elastic foundations. The strain energy of a body includes its foundations.
    pub foundations: Vec<Foundation>,
    /// Load cases; their factors are given later, to [`Body::solve`](crate::Body::solve).
    pub load_cases: Vec<LoadCase>,
    /// Names of the boundaries whose unknowns are kept, each an open or closed path; none solves the body alone.
    pub kept: Vec<String>,
}

impl BodyProblem {
    /// A body of one degree, without materials, supports, loads and kept boundaries yet.
    pub fn new(mesh: impl Into<Arc<Mesh>>, degree: usize, kinematics: Kinematics) -> BodyProblem {
        let mesh = mesh.into();
        BodyProblem {
            degrees: vec![degree; mesh.cells.len()],
            mesh,
            space: SpaceKind::Tensor,
            kinematics,
            materials: Vec::new(),
            supports: Vec::new(),
            rigid_edge: None,
            edge_reaction: false,
            pins: Vec::new(),
            foundations: Vec::new(),
            load_cases: Vec::new(),
            kept: Vec::new(),
        }
    }

    /// With a degree for every cell.
    #[must_use]
    pub fn degrees(self, degrees: Vec<usize>) -> BodyProblem {
        BodyProblem { degrees, ..self }
    }

    /// With one more material, the next in the numbering of the cells.
    #[must_use]
    pub fn material(mut self, material: Material) -> BodyProblem {
        self.materials.push(material);
        self
    }

    /// With one more support.
    #[must_use]
    pub fn support(mut self, support: Support) -> BodyProblem {
        self.supports.push(support);
        self
    }

    /// With a boundary held in a direction.
    #[must_use]
    pub fn hold(self, boundary: &str, direction: Direction) -> BodyProblem {
        self.support(Support::hold(boundary, direction))
    }

    /// With a straight boundary that slides along itself.
    #[must_use]
    pub fn roller(self, boundary: &str) -> BodyProblem {
        self.support(Support::roller(boundary))
    }

    /// With a boundary held in all directions.
    #[must_use]
    pub fn clamp(self, boundary: &str) -> BodyProblem {
        let one = self.hold(boundary, Direction::First);
        if one.kinematics.components() == 1 { one } else { one.hold(boundary, Direction::Second) }
    }

    /// With one more elastic foundation.
    #[must_use]
    pub fn foundation(mut self, foundation: Foundation) -> BodyProblem {
        self.foundations.push(foundation);
        self
    }

    /// With a load in the load case of that name, which is made if there is none.
    #[must_use]
    pub fn load(mut self, case: &str, load: impl Into<Load>) -> BodyProblem {
        match self.load_cases.iter_mut().find(|known| known.name == case) {
            Some(known) => known.loads.push(load.into()),
            None => self.load_cases.push(LoadCase::new(case).with(load)),
        }
        self
    }

    /// With one more boundary whose unknowns are kept.
    #[must_use]
    pub fn keep(mut self, boundary: &str) -> BodyProblem {
        self.kept.push(boundary.to_string());
        self
    }

    /// Right-hand sides: load cases, one for prescribed displacements, three reactions a support, a pin and a rigid edge that wants its own.
    pub(crate) fn columns(&self) -> usize {
        let edge = usize::from(self.reacting_edge().is_some());
        self.load_cases.len() + 1 + 3 * (self.supports.len() + self.pins.len() + edge)
    }

    /// Number of the reaction of the rigid edge.
    pub(crate) fn reacting_edge(&self) -> Option<usize> {
        (self.edge_reaction && self.rigid_edge.is_some()).then_some(self.supports.len() + self.pins.len())
    }
}
