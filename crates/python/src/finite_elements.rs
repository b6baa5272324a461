//! Meshes of gmsh and bodies reduced to a boundary: the crate `hpfem`.

use std::sync::Arc;

use hpfem::{Body, BodyProblem, Direction, EdgeTraction, GmshMesh, InterfaceOperator, Kinematics, Material};
use pyo3::prelude::*;
use scene::Fault;

use crate::array::Array;
use crate::fault::{raised, refused};
use crate::pool::within;

/// A mesh from a file.
#[pyclass(frozen, module = "wearshape._core")]
pub(crate) struct Mesh {
    read: Arc<GmshMesh>,
}

/// A body in plain numbers and words.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Given {
    degree: usize,
    kinematics: String,
    thickness: f64,
    /// Young's modulus and Poisson's ratio of each material of the mesh.
    materials: Vec<[f64; 2]>,
    /// Boundary and the direction, `x` or `z`, in which it is held.
    supports: Vec<(String, String)>,
    /// Load case, boundary, traction along x and z.
    loads: Vec<(String, String, [f64; 2])>,
    /// The boundary that is kept.
    keep: String,
}

#[pymethods]
impl Mesh {
    /// Reads a file of gmsh.
    #[new]
    fn new(py: Python<'_>, bytes: &[u8]) -> PyResult<Mesh> {
        let read = GmshMesh::read(bytes);
        let read = read.map_err(|error| refused(py, "mesh-file", error, "save the mesh by gmsh as version 4.1 or 2.2"))?;
        Ok(Mesh { read: Arc::new(read) })
    }

    /// Positions of the vertices (mm), vertices x 2.
    #[getter]
    fn vertices(&self) -> Array {
        Array::rows(&self.read, |read| &read.mesh.vertices)
    }

    /// Corner vertices of the cells; a triangle repeats its last one.
    #[getter]
    fn cells(&self) -> Vec<[usize; 4]> {
        self.read.mesh.cells.iter().map(|cell| cell.corners).collect()
    }

    /// Index of the material of each cell.
    #[getter]
    fn cell_materials(&self) -> Vec<usize> {
        self.read.mesh.cells.iter().map(|cell| cell.material).collect()
    }

    /// Names of the materials.
    #[getter]
    fn materials(&self) -> Vec<String> {
        self.read.materials.clone()
    }

    /// Names of the boundaries.
    #[getter]
    fn boundaries(&self) -> Vec<String> {
        self.read.mesh.boundaries.clone()
    }

    /// The body reduced to one boundary.
    fn interface(&self, py: Python<'_>, given: Given) -> PyResult<Interface> {
        let wrong = |code, error: String, remedy: &str| Err(refused(py, code, error, remedy));
        let thickness = given.thickness;
        let kinematics = match given.kinematics.as_str() {
            "plane-stress" => Kinematics::PlaneStress { thickness },
            "plane-strain" => Kinematics::PlaneStrain { thickness },
            "axisymmetric" => Kinematics::Axisymmetric,
            other => {
                let remedy = "write plane-stress, plane-strain or axisymmetric";
                return wrong("kinematics", format!("no kinematics is called {other}"), remedy);
            }
        };
        let mut problem = BodyProblem::new(self.read.mesh.clone(), given.degree, kinematics).keep(&given.keep);
        for [young, poisson] in given.materials {
            let material = Material::isotropic(young, poisson);
            problem = problem.material(material.map_err(|error| refused(py, "material", error, "mend the moduli"))?);
        }
        for (boundary, direction) in &given.supports {
            let direction = match direction.as_str() {
                "x" => Direction::First,
                "z" => Direction::Second,
                other => return wrong("support", format!("no direction is called {other}"), "write x or z"),
            };
            problem = problem.hold(boundary, direction);
        }
        for (case, boundary, traction) in given.loads {
            problem = problem.load(&case, EdgeTraction::new(&boundary, move |_| traction));
        }
        let wrong = |error: hpfem::Error| Fault::new("body", error.to_string(), "mend mesh, supports or names");
        let reduced = py.detach(|| within(None, || Body::interface(&problem).map_err(wrong)));
        let (operator, _) = reduced.map_err(|fault| raised(py, fault))?;
        Ok(Interface { operator: Arc::new(operator) })
    }
}

/// A body reduced to its kept boundary.
#[pyclass(frozen, module = "wearshape._core")]
pub(crate) struct Interface {
    operator: Arc<InterfaceOperator>,
}

impl Interface {
    /// A vector at each point.
    fn at_points(&self, of: impl Fn(&hpfem::BoundaryPoint) -> [f64; 2]) -> Array {
        let vectors: Vec<[f64; 2]> = self.operator.trace.points.iter().map(|point| of(&point.boundary)).collect();
        Array::rows(&Arc::new(vectors), |vectors| vectors)
    }

    /// Rows that take the kept unknowns to a component at the points.
    fn component(&self, direction: impl Fn(&hpfem::BoundaryPoint) -> [f64; 2]) -> Array {
        let trace = &self.operator.trace;
        let places: Vec<(usize, f64)> = trace.points.iter().map(|point| (point.edge, point.parameter)).collect();
        Array::matrix(&Arc::new(trace.component_matrix(&places, direction)), |matrix| matrix.as_ref())
    }
}

#[pymethods]
impl Interface {
    /// `S`, unknowns x unknowns.
    #[getter]
    fn stiffness(&self) -> Array {
        Array::matrix(&self.operator, |operator| operator.stiffness.as_ref())
    }

    /// Condensed loads, unknowns x cases.
    #[getter]
    fn loads(&self) -> Array {
        Array::matrix(&self.operator, |operator| operator.columns.as_ref().subcols(0, operator.load_cases.len()))
    }

    /// Names of the load cases.
    #[getter]
    fn load_cases(&self) -> Vec<String> {
        self.operator.load_cases.clone()
    }

    /// Rigid motions that the supports leave free, unknowns x motions.
    #[getter]
    fn rigid_modes(&self) -> Array {
        Array::matrix(&self.operator, |operator| operator.rigid_modes.as_ref())
    }

    /// Arc length of the points (mm).
    #[getter]
    fn arc(&self) -> Array {
        let arc: Vec<f64> = self.operator.trace.points.iter().map(|point| point.arc).collect();
        Array::line(&Arc::new(arc), |arc| arc)
    }

    /// Area weights of the points (mm^2).
    #[getter]
    fn weight(&self) -> Array {
        let weight: Vec<f64> = self.operator.trace.points.iter().map(|point| point.weight).collect();
        Array::line(&Arc::new(weight), |weight| weight)
    }

    /// Positions of the points (mm), points x 2.
    #[getter]
    fn position(&self) -> Array {
        self.at_points(|point| point.position)
    }

    /// Unit normals out of the body, points x 2.
    #[getter]
    fn outward(&self) -> Array {
        self.at_points(|point| point.outward)
    }

    /// Takes the kept unknowns to the displacement along the outward normal at the points, points x unknowns.
    #[getter]
    fn normal_rows(&self) -> Array {
        self.component(|point| point.outward)
    }

    /// The same along x, or r.
    #[getter]
    fn first_rows(&self) -> Array {
        self.component(|_| [1.0, 0.0])
    }

    /// The same along z.
    #[getter]
    fn second_rows(&self) -> Array {
        self.component(|_| [0.0, 1.0])
    }
}
