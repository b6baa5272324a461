//! Loads and named load cases.

use crate::boundary::BoundaryPoint;
use crate::kinematics::Kinematics;
use crate::mesh::Mesh;
use std::fmt;
use std::sync::Arc;

/// Loads that act together under one name; the interface operator keeps one column a load case.
#[derive(Clone, Debug, Default)]
pub struct LoadCase {
    /// The name by which [`Body::solve`](crate::Body::solve) knows the case; no two cases of a body share one.
    pub name: String,
    /// What acts.
    pub loads: Vec<Load>,
}

impl LoadCase {
    /// A load case without loads yet.
    pub fn new(name: impl Into<String>) -> LoadCase {
        LoadCase { name: name.into(), loads: Vec::new() }
    }

    /// With one more load.
    #[must_use]
    pub fn with(mut self, load: impl Into<Load>) -> LoadCase {
        self.loads.push(load.into());
        self
    }
}

/// One load.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Load {
    /// A traction on a boundary or a part of it.
    Traction(EdgeTraction),
    /// A force per volume.
    BodyForce(BodyForce),
    /// A force at a point.
    PointForce(PointForce),
    /// A strain without stress of its own.
    Eigenstrain(Eigenstrain),
}

impl From<EdgeTraction> for Load {
    fn from(load: EdgeTraction) -> Load {
        Load::Traction(load)
    }
}

impl From<BodyForce> for Load {
    fn from(load: BodyForce) -> Load {
        Load::BodyForce(load)
    }
}

impl From<PointForce> for Load {
    fn from(load: PointForce) -> Load {
        Load::PointForce(load)
    }
}

impl From<Eigenstrain> for Load {
    fn from(load: Eigenstrain) -> Load {
        Load::Eigenstrain(load)
    }
}

/// A traction on a named boundary, force per area, MPa, as a function of the point: `[t_x, t_z]`, in torsion `[t_phi, _]`, for a potential
/// the flux into the body `[q, _]`. On edges inside the body the outward normal is that of the edge's first cell, the one with the lower index.
#[derive(Clone)]
pub struct EdgeTraction {
    /// Name of the boundary.
    pub boundary: String,
    /// The part between two arc lengths, mm, from the end of the path with the smaller coordinates (first coordinate first), if not
    /// the whole; beyond the path it is cut off, and refused where it is wholly there. The quadrature ends where the traction does, so that a jump inside an edge costs no
    /// accuracy of the load (the stress has a singular point there that the mesh must resolve). The boundary is one path then; a closed one begins as [`Mesh::path`](crate::Mesh::path) walks it.
    pub range: Option<[f64; 2]>,
    /// The traction, MPa; it must be smooth on each edge for the quadrature to be accurate.
    pub traction: BoundaryTraction,
    /// Made as a pressure: two components are meant.
    pub(crate) along_normal: bool,
}

/// A traction, MPa, as a function of the boundary point.
pub type BoundaryTraction = Arc<dyn Fn(&BoundaryPoint) -> [f64; 2] + Send + Sync>;

impl EdgeTraction {
    /// A traction on a whole boundary.
    pub fn new(boundary: &str, traction: impl Fn(&BoundaryPoint) -> [f64; 2] + Send + Sync + 'static) -> EdgeTraction {
        EdgeTraction { boundary: boundary.to_string(), range: None, traction: Arc::new(traction), along_normal: false }
    }

    /// A pressure, MPa, positive into the body, as a function of the position, mm; refused in problems of one component.
    pub fn pressure(boundary: &str, pressure: impl Fn([f64; 2]) -> f64 + Send + Sync + 'static) -> EdgeTraction {
        let along_normal = EdgeTraction::new(boundary, move |p| p.outward.map(|n| -pressure(p.position) * n));
        EdgeTraction { along_normal: true, ..along_normal }
    }

    /// The same on the part between two arc lengths, mm, see [`EdgeTraction::range`].
    #[must_use]
    pub fn within(self, range: [f64; 2]) -> EdgeTraction {
        EdgeTraction { range: Some(range), ..self }
    }
}

/// A force per volume, N/mm^3, as a function of the position, `[f_x, f_z]`, in torsion `[f_phi, _]`, for a potential the source.
#[derive(Clone)]
pub struct BodyForce {
    /// The force, N/mm^3, at a position, mm.
    pub force: Arc<dyn Fn([f64; 2]) -> [f64; 2] + Send + Sync>,
    /// Factor of each material, by its index; none where it is the same in all.
    pub(crate) of_materials: Option<Vec<f64>>,
    /// What it was made as.
    pub(crate) meant: Meant,
}

/// What a force per volume was made as; not every kinematics has all of them.
#[derive(Clone, Copy)]
pub(crate) enum Meant {
    /// A function.
    Anything,
    /// A weight under this acceleration.
    Weight([f64; 2]),
    /// The centrifugal force of a body of revolution.
    Spin,
}

impl BodyForce {
    /// A force per volume by a function of the position.
    pub fn new(force: impl Fn([f64; 2]) -> [f64; 2] + Send + Sync + 'static) -> BodyForce {
        BodyForce { force: Arc::new(force), of_materials: None, meant: Meant::Anything }
    }

    /// The same with a factor for each material of the mesh, as the density where the function is a force per mass. A place whose material has no
    /// factor has no force.
    #[must_use]
    pub fn by_material(self, factors: &[f64]) -> BodyForce {
        BodyForce { of_materials: Some(factors.to_vec()), ..self }
    }

    /// The force per volume at a position in a material.
    pub(crate) fn at(&self, position: [f64; 2], material: usize) -> [f64; 2] {
        let factor = self.of_materials.as_ref().map(|factors| factors.get(material).copied().unwrap_or(0.0));
        let force = (self.force)(position);
        factor.map_or(force, |factor| force.map(|f| factor * f))
    }

    /// The weight of a body of this density under the acceleration `[g_x, g_z]`; refused in problems of one component, and across the axis of a body of
    /// revolution.
    pub fn weight(density: f64, acceleration: [f64; 2]) -> BodyForce {
        BodyForce { meant: Meant::Weight(acceleration), ..BodyForce::new(move |_| acceleration.map(|g| density * g)) }
    }

    /// The centrifugal force of a body of revolution of this density that spins about its axis, `density omega^2 r`; refused in other kinematics. A disc in
    /// the plane that spins about `c` has the [force](BodyForce::new) `density omega^2 (x - c)`.
    pub fn spin(density: f64, angular_velocity: f64) -> BodyForce {
        let force = BodyForce::new(move |x| [density * angular_velocity * angular_velocity * x[0], 0.0]);
        BodyForce { meant: Meant::Spin, ..force }
    }
}

/// A force at a point of the body, N; in a body of revolution the total on the circle through the point. The displacement under a force
/// in the plane is unbounded: it grows with the degree like the logarithm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointForce {
    /// The point, mm.
    pub at: [f64; 2],
    /// The force `[F_x, F_z]`, N; in torsion `[F_phi, _]`.
    pub force: [f64; 2],
}

impl PointForce {
    /// A force at a point.
    pub fn new(at: [f64; 2], force: [f64; 2]) -> PointForce {
        PointForce { at, force }
    }
}

/// A strain that causes no stress where nothing hinders it: thermal, residual, of swelling. The stress is `C (eps - eps*)`.
#[derive(Clone)]
pub struct Eigenstrain {
    /// The strains at a place, in the order of the stresses: `[xx, zz, gamma_xz, yy]`, in torsion `[gamma_r phi, gamma_phi z, _, _]`, for a
    /// potential a gradient without flux.
    pub strain: StrainAt,
    /// Made of normal strains, as a thermal one is.
    pub(crate) of_normals: bool,
    /// Mesh and kinematics of the temperature that it is made of.
    pub(crate) temperature: Option<(Arc<Mesh>, Kinematics)>,
    /// The same strain by the modes of a cell, where it is a polynomial in them.
    pub(crate) in_modes: Option<StrainInModes>,
}

/// Strain alike in all directions in a cell of a material with so many modes: the coefficient of each mode in the numbering of
/// [`CellPoint::modes`](crate::cell_point::CellPoint::modes), and a constant; none where the modes are others.
pub(crate) type StrainInModes = Arc<dyn Fn(usize, usize, usize) -> Option<(Vec<f64>, f64)> + Send + Sync>;

/// Strains as a function of the place.
pub type StrainAt = Arc<dyn Fn(&BodyPoint) -> [f64; 4] + Send + Sync>;

/// A place in a body. Cell and material tell the two sides of a joint apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyPoint {
    /// Index of the cell.
    pub cell: usize,
    /// Reference coordinates `(xi, eta)` in the cell, see [`Field::at`](crate::Field::at).
    pub reference: [f64; 2],
    /// Position (x, z) or (r, z), mm.
    pub position: [f64; 2],
    /// Index of the cell's material.
    pub material: usize,
}

impl Eigenstrain {
    /// A strain by a function of the place. All four components are finite, those without a meaning too, or the load is refused.
    pub fn new(strain: impl Fn(&BodyPoint) -> [f64; 4] + Send + Sync + 'static) -> Eigenstrain {
        Eigenstrain { strain: Arc::new(strain), of_normals: false, temperature: None, in_modes: None }
    }

    /// Thermal strain `alpha (T - T_0)` alike in all directions: `expansion` has one coefficient a material, 1/K, and `rise` is the
    /// temperature above the one without strain, K.
    ///
    /// A place whose material has no coefficient does not expand. Refused in problems of one component.
    pub fn thermal(expansion: &[f64], rise: impl Fn(&BodyPoint) -> f64 + Send + Sync + 'static) -> Eigenstrain {
        let expansion = expansion.to_vec();
        let thermal = Eigenstrain::new(move |place| {
            let e = expansion.get(place.material).copied().unwrap_or(0.0) * rise(place);
            [e, e, 0.0, e]
        });
        Eigenstrain { of_normals: true, ..thermal }
    }
}

impl fmt::Debug for EdgeTraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("EdgeTraction").field("boundary", &self.boundary).field("range", &self.range).finish_non_exhaustive()
    }
}

impl fmt::Debug for BodyForce {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("BodyForce").finish_non_exhaustive()
    }
}

impl fmt::Debug for Eigenstrain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Eigenstrain").finish_non_exhaustive()
    }
}
