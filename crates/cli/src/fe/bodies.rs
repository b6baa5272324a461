//! The bodies of a scene as finite element problems of one discretisation.

use hpfem::{
    Additions, Body, BodyProblem, Direction, EdgeTraction, Effort, InterfaceOperator, Kinematics, LoadCase, Material, Mesh,
    RigidEdge, Sizes, SpaceKind, Support,
};
use std::sync::LazyLock;
use std::time::Instant;

use crate::fault::Fault;
use crate::fe::template::{AXIS, CONTACT, LOAD};
use crate::geometry::Geometry;
use crate::given::given;
use crate::scene::{self, Component, LoadKind, Scene, Task};

/// Degree and layers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Level {
    /// Degree of the cells outside the layers; it falls with the layers, to 2 at least.
    pub(crate) degree: usize,
    /// Layers around each singular point.
    pub(crate) layers: usize,
}

impl Level {
    /// The layers that go with a degree: as many, so that both errors fall together, and the last layer, where the pressure of
    /// a round trip is off by order one, is too small to count. A ring segment bends: its gap is a hundred times that of a block, and in the
    /// smallest cells its last digits are pressure. It has three layers for four degrees, in which the degree falls half as fast.
    pub(crate) fn of(scene: &Scene, degree: usize) -> Level {
        Level { degree, layers: if bends(scene) { (3 * degree).div_ceil(4) } else { degree } }
    }

    /// Degree of a cell in a layer.
    fn degree_in(self, scene: &Scene, layer: usize) -> usize {
        let fall = if bends(scene) { layer / 2 } else { layer };
        self.degree.saturating_sub(fall).max(2.min(self.degree))
    }
}

/// Whether the shape of a thin body 1 is asked for: its gap comes from bending.
fn bends(scene: &Scene) -> bool {
    scene.tasks.iter().flatten().any(|task| *task == Task::Shape)
        && matches!(scene.body1.as_ref().map(|body| &body.geometry), Some(Geometry::RingSegment(_)))
}

/// Everything a body of one level is made of.
pub(crate) struct BodyParts {
    /// The mesh.
    pub(crate) mesh: Mesh,
    degrees: Vec<usize>,
    kinematics: Kinematics,
    materials: Vec<Material>,
    supports: Vec<Support>,
    /// Names of the supported edges, one a support.
    pub(crate) support_names: Vec<String>,
    rigid_edge: Option<RigidEdge>,
    load_cases: Vec<LoadCase<'static>>,
}

/// Load cases of body 1: a load of 1 N, then mean displacement functionals of the load edge along x, z, and in rotation.
pub(crate) const MEAN_COLUMNS: [usize; 3] = [1, 2, 3];

/// Kinematics of the in-plane (or axisymmetric) problem.
pub(crate) fn kinematics(scene: &Scene) -> Kinematics {
    let thickness = scene.thickness.map_or(1.0, |t| t.0);
    match scene.kinematics {
        Some(scene::Kinematics::PlaneStrain) => Kinematics::PlaneStrain { thickness },
        Some(scene::Kinematics::Axisymmetric) => Kinematics::Axisymmetric,
        _ => Kinematics::PlaneStress { thickness },
    }
}

impl BodyParts {
    /// Body 1 (`shaped`) or body 2 on its mesh.
    pub(crate) fn new(scene: &Scene, shaped: bool, mesh: Mesh, level: Level, kinematics: Kinematics) -> Result<BodyParts, Fault> {
        let (key, body) = if shaped { ("body1", &scene.body1) } else { ("body2", &scene.body2) };
        let Some(body) = body else {
            return Err(Fault::at(key, "missing-key", format!("the key `{key}` is missing"), "describe both bodies"));
        };
        let materials = hpfem_materials(body).map_err(|error| {
            Fault::at(format!("{key}.material"), "wrong-value", error.to_string(), "give young > 0 and poisson below 0.5")
        })?;
        let degrees = mesh.cells.iter().map(|c| level.degree_in(scene, c.layer)).collect();
        let rigid = scene.load.as_ref().filter(|load| shaped && load.kind == Some(LoadKind::Rigid));
        let mut supports = Vec::new();
        let mut support_names = Vec::new();
        for (edge, components) in &body.support {
            let on_rigid_edge = rigid.is_some_and(|load| load.edge.as_deref() == Some(edge));
            for component in components {
                let direction = match (component, kinematics) {
                    (Component::Phi, Kinematics::Torsion) => Direction::First,
                    (Component::X, Kinematics::Torsion) | (Component::Z, Kinematics::Torsion) => continue,
                    (Component::Phi, _) => continue,
                    (Component::X, _) => Direction::First,
                    (Component::Z, _) => Direction::Second,
                };
                if on_rigid_edge && kinematics != Kinematics::Torsion {
                    continue;
                }
                supports.push(Support { boundary: edge.clone(), direction, value: 0.0 });
                support_names.push(format!("{key}.{edge}"));
            }
        }
        if mesh.boundaries.iter().any(|name| name == AXIS) {
            supports.push(Support { boundary: AXIS.into(), direction: Direction::First, value: 0.0 });
            support_names.push(String::new());
        }
        let rigid_edge = match (rigid, kinematics) {
            (None, _) | (_, Kinematics::Torsion) => None,
            (Some(load), _) => {
                let held = load.edge.as_ref().and_then(|edge| body.support.get(edge));
                let holds = |component| held.is_some_and(|components| components.contains(&component));
                let about = load.about.map_or([0.0; 2], |about| about.map(|x| x.0));
                let height = mesh.boundary(LOAD).ok().and_then(|edges| edges.first().map(|e| mesh.edges[*e].curve.point(0.0)[1]));
                let revolved = kinematics.is_revolved();
                Some(RigidEdge {
                    boundary: LOAD.into(),
                    reference: [about[0], height.unwrap_or(about[1])],
                    // A rotation prescribed as zero is held; another one is a motion.
                    free: [
                        !holds(Component::X) && !revolved,
                        !holds(Component::Z),
                        !revolved && load.tilt.is_none_or(|tilt| tilt.0 != 0.0),
                    ],
                })
            }
        };
        let load_cases = match (shaped, kinematics) {
            (true, Kinematics::Torsion) | (false, _) => Vec::new(),
            (true, _) => load_cases(scene, &mesh, kinematics, rigid_edge.is_some()),
        };
        Ok(BodyParts { mesh, degrees, kinematics, materials, supports, support_names, rigid_edge, load_cases })
    }

    /// The wedge of the body at a vertex of its boundary.
    pub(crate) fn corner(&self, vertex: usize, kinematics: Kinematics) -> Option<hpfem::Corner> {
        hpfem::Corner::at(&self.mesh, vertex, kinematics, &self.materials, &self.supports).ok().flatten()
    }

    /// Assembles and reduces the body.
    pub(crate) fn reduce(&self, key: &str) -> Result<Body<'_>, Fault> {
        Body::timed(self.problem(), Additions::default(), seconds).map_err(|error| not_held(key, &error))
    }

    /// Reduces the body to its contact edge, keeping nothing of its inside.
    pub(crate) fn interface(&self, key: &str) -> Result<(InterfaceOperator, Effort), Fault> {
        Body::interface_timed(&self.problem(), seconds).map_err(|error| not_held(key, &error))
    }

    /// What the reduction takes.
    pub(crate) fn sizes(&self, key: &str) -> Result<Sizes, Fault> {
        Body::sizes(&self.problem()).map_err(|error| not_held(key, &error))
    }

    fn problem(&self) -> BodyProblem<'_> {
        BodyProblem {
            mesh: &self.mesh,
            degrees: self.degrees.clone(),
            space: SpaceKind::Tensor,
            kinematics: self.kinematics,
            materials: &self.materials,
            supports: &self.supports,
            rigid_edge: self.rigid_edge.clone(),
            load_cases: &self.load_cases,
            kept: Some(CONTACT),
        }
    }
}

/// Seconds since the first call: the clock that the bodies are timed with.
fn seconds() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed().as_secs_f64()
}

fn not_held(key: &str, error: &hpfem::Error) -> Fault {
    let remedy = "hold it by supports so that only the load's own motions stay free";
    Fault::at(format!("{key}.support"), "not-held", error.to_string(), remedy)
}

/// The materials of a body, by the index that its cells have.
pub(super) fn hpfem_materials(body: &scene::Body) -> Result<Vec<Material>, hpfem::Error> {
    // Faults of the cells were found before.
    let given = given("body", body).ok().flatten().map(|given| given.materials);
    let own = || body.material.into_iter().collect();
    given.unwrap_or_else(own).into_iter().map(|m| Material::new(m.young.0, m.poisson)).collect()
}

/// The load for a force of 1 N, and the mean displacement functionals of the load edge.
fn load_cases(scene: &Scene, mesh: &Mesh, kinematics: Kinematics, rigid: bool) -> Vec<LoadCase<'static>> {
    let Some(load) = scene.load.as_ref().filter(|_| !rigid) else { return Vec::new() };
    let vertical = load.kind == Some(LoadKind::Vertical);
    // Area, projected area, and middle of the loaded edges.
    let (mut area, mut projected, mut middle) = (0.0, 0.0, [0.0; 2]);
    for edge in mesh.boundary(LOAD).unwrap_or_default() {
        let curve = &mesh.edges[edge].curve;
        let rule = hpfem::gauss(12);
        for (t, w) in rule.points.iter().zip(&rule.weights) {
            let (x, d) = (curve.point(*t), curve.derivative(*t));
            let da = w * kinematics.measure(x[0]);
            area += da * d[0].hypot(d[1]);
            projected += da * d[0].abs();
            middle[0] += da * d[0].hypot(d[1]) * x[0];
            middle[1] += da * d[0].hypot(d[1]) * x[1];
        }
    }
    let middle = middle.map(|m| m / area);
    let intensity = 1.0 / projected;
    let traction = move |point: &hpfem::BoundaryPoint| {
        let [nx, nz] = point.outward;
        if vertical { [0.0, -intensity * nz.abs()] } else { [-intensity * nx, -intensity * nz] }
    };
    let on_load = |traction| vec![EdgeTraction { boundary: LOAD.into(), traction }];
    vec![
        on_load(Box::new(traction)),
        on_load(Box::new(move |_| [1.0 / area, 0.0])),
        on_load(Box::new(move |_| [0.0, 1.0 / area])),
        on_load(Box::new(move |p| [(middle[1] - p.position[1]) / area, (p.position[0] - middle[0]) / area])),
    ]
}
