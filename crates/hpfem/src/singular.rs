//! Where the stress is unbounded, and how strongly: exponents of the corner solutions `u ~ r^lambda`.
//!
//! In every sector of a corner (one cell, one material, shear modulus mu, `kappa = 3 - 4 nu` or `(3 - nu)/(1 + nu)`) the functions of
//! Kolosov and Muskhelishvili `phi = A z^lambda`, `psi = B z^lambda` give (Williams 1952)
//!
//! ```text
//! 2 mu u_r / r^l         = (kappa - l)(a cos- + b sin-) + c cos+ + d sin+
//! 2 mu u_t / r^l         = (kappa + l)(a sin- - b cos-) - c sin+ + d cos+
//! s_tt / (l r^(l-1))     = (l + 1)(a cos- + b sin-) - c cos+ - d sin+
//! s_rt / (l r^(l-1))     = (l - 1)(a sin- - b cos-) - c sin+ + d cos+        cos- = cos((l - 1) t), cos+ = cos((l + 1) t)
//! ```
//!
//! Boundary conditions on the two faces and continuity between sectors make a homogeneous system; the exponents are the roots of its
//! determinant, complex in general, found here by Newton's method from many starts, with the multiple root 0 of every corner divided out. A body of
//! revolution behaves like plane strain next to a corner off the axis; torsion like antiplane shear.

use crate::error::Error;
use crate::freedom::Support;
use crate::kinematics::Kinematics;
use crate::material::Material;
use crate::mesh::Mesh;
use crate::sector::{C, Constants, Face, Sector, antiplane, condition, plane};
use crate::small_determinant::SmallMatrix;
use std::f64::consts::{PI, TAU};

/// A vertex where derivatives of the displacement are not smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SingularVertex {
    /// The vertex.
    pub vertex: usize,
    /// Real part of the smallest exponent `lambda` of `u ~ r^lambda`; 1 where only the load jumps (`u ~ r log r`).
    pub exponent: f64,
}

/// Distance from the axis of revolution, over the largest, that is none.
const ON_AXIS: f64 = 1e-12;

/// Exponent from which on a vertex counts as smooth: slopes of `r^.99` grow by 7 % over a factor of a thousand.
const WEAKEST: f64 = 0.99;

/// The singular vertices of a mesh: every boundary vertex and every vertex between materials whose exponent is below .99, and the
/// vertices where a boundary in `loaded` ends: name there what is loaded, and what stands on a foundation or film, for it ends in a weak singularity too.
///
/// Vertices on an axis of revolution are left out: of the tip of a cone the sectors of a plane corner do not know the exponent. Push a [`SingularVertex`] for it.
///
/// # Errors
/// [`Error::NoSuchBoundary`]; [`Error::Anisotropic`]; [`Error::OutOfRange`] for the angle of a support that is not finite; [`Error::Beyond`] for a cell whose material
/// is not among the `materials`.
pub fn singular_vertices(
    mesh: &Mesh,
    kinematics: Kinematics,
    materials: &[Material],
    supports: &[Support],
    loaded: &[&str],
) -> Result<Vec<SingularVertex>, Error> {
    check_materials(mesh, materials)?;
    let constants = Constants::of(materials, kinematics)?;
    let wedges = Wedges { mesh, sides: mesh.edge_cells(), constants, held: held(mesh, supports)?, kinematics };
    // Numbers of the loads on each edge; jumps are where they change along the boundary.
    let mut load: Vec<Vec<usize>> = vec![Vec::new(); mesh.edges.len()];
    for (number, name) in loaded.iter().enumerate() {
        mesh.boundary(name)?.into_iter().for_each(|e| load[e].push(number));
    }
    let mut around: Vec<Vec<(usize, usize)>> = vec![Vec::new(); mesh.vertices.len()];
    for (c, cell) in mesh.cells.iter().enumerate() {
        cell.vertices().iter().enumerate().for_each(|(k, v)| around[*v].push((c, k)));
    }
    let size = mesh.vertices.iter().fold(0.0_f64, |most, x| most.max(x[0].abs()));
    let (mut found, mut known) = (Vec::new(), Vec::new());
    for (vertex, cells) in around.iter().enumerate() {
        let on_axis = kinematics.is_revolved() && mesh.vertices[vertex][0].abs() <= ON_AXIS * size;
        if cells.is_empty() || on_axis {
            continue;
        }
        let Some((sectors, faces, edges)) = wedges.at(vertex, cells) else {
            continue;
        };
        let smooth = matches!(faces, Some(f) if f[0] == f[1]) && (sectors.iter().map(|s| s.angle).sum::<f64>() - PI).abs() < 1e-6
            || faces.is_none();
        let uniform = sectors.windows(2).all(|s| s[0].constants == s[1].constants);
        // A straight interface between two materials.
        let straight = faces.is_none() && sectors.len() == 2 && (sectors[0].angle - PI).abs() < 1e-6;
        let exponent = if (smooth && uniform) || straight { 1.0 } else { exponent_of(&mut known, sectors, faces, kinematics) };
        if exponent < WEAKEST {
            found.push(SingularVertex { vertex, exponent });
        } else if edges.is_some_and(|[a, b]| load[a] != load[b]) {
            found.push(SingularVertex { vertex, exponent: 1.0 });
        }
    }
    Ok(found)
}

/// A corner as it was met before, and its exponent.
type Met = (Vec<Sector>, Option<[Face; 2]>, f64);

/// [`corner_exponent`], looked up where the same corner was met before: meshes have many alike, above all where materials meet on their outline.
fn exponent_of(known: &mut Vec<Met>, sectors: Vec<Sector>, faces: Option<[Face; 2]>, kinematics: Kinematics) -> f64 {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-12;
    let alike = |(other, at, _): &&Met| {
        let mut pairs = other.iter().zip(&sectors);
        let same_face = |(a, b): (&Face, &Face)| match (a, b) {
            (Face::Held(a), Face::Held(b)) => near(*a, *b),
            (a, b) => a == b,
        };
        let same_faces = match (at, &faces) {
            (Some(a), Some(b)) => a.iter().zip(b).all(same_face),
            (a, b) => a.is_none() && b.is_none(),
        };
        same_faces && other.len() == sectors.len() && pairs.all(|(a, b)| a.constants == b.constants && near(a.angle, b.angle))
    };
    if let Some((_, _, exponent)) = known.iter().find(alike) {
        return *exponent;
    }
    let exponent = corner_exponent(&sectors, faces, kinematics);
    known.push((sectors, faces, exponent));
    exponent
}

/// Refuses cells of a material that is not given.
fn check_materials(mesh: &Mesh, materials: &[Material]) -> Result<(), Error> {
    match mesh.cells.iter().position(|cell| cell.material >= materials.len()) {
        Some(cell) => {
            let (by, index) = (format!("cell {cell}"), mesh.cells[cell].material);
            Err(Error::Beyond { by, what: "material", index, count: materials.len() })
        }
        None => Ok(()),
    }
}

/// Directions held on every edge.
fn held(mesh: &Mesh, supports: &[Support]) -> Result<Vec<Vec<[f64; 2]>>, Error> {
    let mut held: Vec<Vec<[f64; 2]>> = vec![Vec::new(); mesh.edges.len()];
    for support in supports {
        support.direction.check(&format!("the support of \"{}\"", support.boundary))?;
        for e in mesh.boundary(&support.boundary)? {
            let d = support.direction.vector().unwrap_or_else(|| {
                let t = mesh.edges[e].curve.derivative(0.0);
                let n = t[0].hypot(t[1]);
                [t[1] / n, -t[0] / n]
            });
            if held[e].iter().all(|h: &[f64; 2]| (h[0] * d[1] - h[1] * d[0]).abs() > 1e-9) {
                held[e].push(d);
            }
        }
    }
    Ok(held)
}

/// The wedge of a body at a vertex of its boundary.
#[derive(Clone, Debug, PartialEq)]
pub struct Corner {
    /// Its sectors, from one face to the other.
    pub sectors: Vec<Sector>,
    /// What holds on the faces.
    pub faces: [Face; 2],
}

impl Corner {
    /// The wedge of a body with the given supports at a boundary vertex, its sectors anti-clockwise; none inside the body.
    ///
    /// # Errors
    /// [`Error::NoSuchBoundary`]; [`Error::Anisotropic`]; [`Error::Beyond`] for a cell whose material is not among the `materials`.
    pub fn at(
        mesh: &Mesh,
        vertex: usize,
        kinematics: Kinematics,
        materials: &[Material],
        supports: &[Support],
    ) -> Result<Option<Corner>, Error> {
        check_materials(mesh, materials)?;
        let constants = Constants::of(materials, kinematics)?;
        let wedges = Wedges { mesh, sides: mesh.edge_cells(), constants, held: held(mesh, supports)?, kinematics };
        let touching = |(c, cell): (usize, &crate::mesh::Cell)| cell.vertices().iter().position(|v| *v == vertex).map(|k| (c, k));
        let cells: Vec<(usize, usize)> = mesh.cells.iter().enumerate().filter_map(touching).collect();
        let found = wedges.at(vertex, &cells);
        Ok(found.and_then(|(sectors, faces, _)| faces.map(|faces| Corner { sectors, faces })))
    }

    /// The mirror image of the wedge, from the same face.
    pub fn mirrored(mut self) -> Corner {
        for face in &mut self.faces {
            if let Face::Held(angle) = face {
                *angle = (PI - *angle).rem_euclid(PI);
            }
        }
        self
    }

    /// The same wedge from its other face.
    pub fn reversed(mut self) -> Corner {
        self.sectors.reverse();
        self.faces.reverse();
        self
    }
}

/// Sectors anti-clockwise, two faces, their edges. Faces are none around an inner vertex.
type Wedge = (Vec<Sector>, Option<[Face; 2]>, Option<[usize; 2]>);

/// What tells the wedges of a body.
struct Wedges<'a> {
    mesh: &'a Mesh,
    /// Cells on each edge, as by [`Mesh::edge_cells`].
    sides: Vec<Vec<(usize, usize)>>,
    /// Constants of the materials.
    constants: Vec<Constants>,
    /// Directions held on each edge.
    held: Vec<Vec<[f64; 2]>>,
    kinematics: Kinematics,
}

impl Wedges<'_> {
    /// The wedge at a vertex; `cells` are those that touch it, each with its corner there.
    fn at(&self, vertex: usize, cells: &[(usize, usize)]) -> Option<Wedge> {
        let Wedges { mesh, sides, kinematics, .. } = self;
        // The edges that leave corner k: the one with the cell on its left, then the other.
        let leaving = |(c, k): (usize, usize)| {
            let [a, b] = mesh.cells[c].leaving(k).map(|e| mesh.cells[c].edges[e]);
            Some((a?, b?))
        };
        let start = cells.iter().copied().find(|cell| leaving(*cell).is_some_and(|(a, _)| sides[a].len() == 1));
        let inner = start.is_none();
        let mut cell = start.or(cells.first().copied())?;
        let first = leaving(cell)?.0;
        let mut sectors = Vec::new();
        let mut last = first;
        for _ in 0..cells.len() {
            let (a, b) = leaving(cell)?;
            let rays = [a, b].map(|e| ray(mesh, e, vertex));
            let mut angle = (rays[1][1].atan2(rays[1][0]) - rays[0][1].atan2(rays[0][0])).rem_euclid(TAU);
            if angle < 1e-9 {
                angle = TAU;
            }
            let constants = *self.constants.get(mesh.cells[cell.0].material)?;
            // Cells of one material next to each other are one sector.
            match sectors.last_mut() {
                Some(Sector { angle: sum, constants: same }) if *same == constants => *sum += angle,
                _ => sectors.push(Sector { angle, constants }),
            }
            last = b;
            match cells.iter().copied().find(|c| leaving(*c).is_some_and(|(a, _)| a == b)) {
                Some(next) => cell = next,
                None => break,
            }
        }
        if inner {
            if let [first, .., last] = &mut sectors[..]
                && first.constants == last.constants
            {
                first.angle += last.angle;
                sectors.pop();
            }
            return Some((sectors, None, None));
        }
        let face = |e: usize| match (self.held[e].len(), *kinematics) {
            (0, _) => Face::Free,
            (1, kinematics) if kinematics.components() == 1 => Face::Fixed,
            (2.., _) => Face::Fixed,
            (1, _) => {
                let (d, r) = (self.held[e][0], ray(mesh, e, vertex));
                Face::Held((r[0] * d[1] - r[1] * d[0]).atan2(r[0] * d[0] + r[1] * d[1]).rem_euclid(PI))
            }
        };
        Some((sectors, Some([face(first), face(last)]), Some([first, last])))
    }
}

/// Direction of an edge where it leaves a vertex.
fn ray(mesh: &Mesh, edge: usize, vertex: usize) -> [f64; 2] {
    let e = &mesh.edges[edge];
    if e.vertices[0] == vertex { e.curve.derivative(-1.0) } else { e.curve.derivative(1.0).map(|d| -d) }
}

/// Real part of the smallest exponent of a corner, `u ~ r^lambda`, at most 1: the sectors anti-clockwise from the first face; no
/// faces for sectors that close around a point. 1 without sectors, NaN where angles are not positive or make more than a full turn.
pub fn corner_exponent(sectors: &[Sector], faces: Option<[Face; 2]>, kinematics: Kinematics) -> f64 {
    let turn: f64 = sectors.iter().map(|sector| sector.angle).sum();
    let is_corner = sectors.iter().all(|sector| sector.angle > 0.0) && turn < TAU + 1e-6;
    match (sectors.is_empty(), is_corner) {
        (true, _) => 1.0,
        (false, false) => f64::NAN,
        (false, true) => smallest_root(sectors, faces, kinematics, STARTS),
    }
}

/// Starts along the real part, up to 1, and along the imaginary one.
const STARTS: [u32; 2] = [12, 3];

/// Real part of the smallest root of the determinant that is reached from so many starts, at most 1.
fn smallest_root(sectors: &[Sector], faces: Option<[Face; 2]>, kinematics: Kinematics, [along, up]: [u32; 2]) -> f64 {
    let mut matrix = SmallMatrix::default();
    let mut f = |l: C| determinant(l, sectors, faces, kinematics, &mut matrix);
    let at_zero = roots_at_zero(sectors, faces, kinematics);
    let mut roots: Vec<C> = Vec::new();
    for i in 1..=along {
        for j in 0..up {
            let start = C::new(f64::from(i) / f64::from(along), f64::from(j) / f64::from(up));
            roots.extend(root_from(start, &mut f, (at_zero, &roots)));
        }
    }
    roots.iter().map(|root| root.re).fold(1.0, f64::min)
}

/// Distance from a known root within which no other one is expected.
const NEAR: f64 = 1e-4;

/// A root of the determinant from a start by Newton's method on `f / l^m`; none without one, or if it is a known one.
fn root_from(start: C, f: &mut impl FnMut(C) -> C, (at_zero, known): (f64, &[C])) -> Option<C> {
    let (mut l, mut step) = (start, C::new(1.0, 0.0));
    for _ in 0..40 {
        let (value, h) = (f(l), 1e-6);
        let slope = (f(l + h) - value) / h;
        step = value / (slope - value / l * at_zero);
        if !step.re.is_finite() || l.norm() > 4.0 || l.norm() < 1e-4 {
            return None;
        }
        l -= step;
        if step.norm() < 1e-11 {
            break;
        }
        if known.iter().any(|root| (l - root).norm().min((l.conj() - root).norm()) < NEAR) {
            return None;
        }
    }
    // Double roots (a crack) converge slowly but surely.
    Some(l).filter(|l| step.norm() < 1e-6 && l.re > 0.02 && l.norm() > 0.02)
}

/// Multiplicity of the root `l = 0` of the determinant, to which starts from near and far would go, slowly: one for each condition on a traction, which
/// has the factor `l`, one for each translation that nothing holds, and one for each component of a force at a point inside the body. Rollers
/// in line, and a roller beside a fixed face, leave one more, which is simple then and quickly reached.
fn roots_at_zero(sectors: &[Sector], faces: Option<[Face; 2]>, kinematics: Kinematics) -> f64 {
    let components = kinematics.components();
    let Some(faces) = faces else { return (components * (sectors.len() + 2)) as f64 };
    let held = |face: &Face| match face {
        Face::Free => 0,
        Face::Held(_) => 1,
        Face::Fixed => components,
    };
    let held = faces.each_ref().map(held);
    let around = sectors.iter().map(|sector| sector.angle).sum::<f64>();
    // Rollers that hold the same direction leave a translation.
    let alike = matches!(faces, [Face::Held(a), Face::Held(b)] if (around + b - a).sin().abs() < 1e-9);
    let holding = if alike { 1 } else { components.min(held[0] + held[1]) };
    (components * (sectors.len() + 1) - held[0] - held[1] + components - holding) as f64
}

/// Determinant of the conditions of a corner at the exponent `l`, made in `m`.
fn determinant(l: C, sectors: &[Sector], faces: Option<[Face; 2]>, kinematics: Kinematics, m: &mut SmallMatrix) -> C {
    let scalar = kinematics.components() == 1;
    let (unknowns, rows) = if scalar { (2, 1) } else { (4, 2) };
    let n = sectors.len();
    m.clear(unknowns * n);
    let mut row = 0;
    let state = |s: &Sector, t: f64| {
        if scalar { antiplane(l, s, t) } else { plane(l, s, t, kinematics) }
    };
    if let Some(faces) = faces {
        for (side, face) in faces.iter().enumerate() {
            let (number, t) = if side == 0 { (0, 0.0) } else { (n - 1, sectors[n - 1].angle) };
            let condition = condition(*face, &state(&sectors[number], t), rows);
            for values in &condition[..rows] {
                values[..unknowns].iter().enumerate().for_each(|(k, v)| *m.at(row, unknowns * number + k) = *v);
                row += 1;
            }
        }
    }
    let joints = if faces.is_some() { n - 1 } else { n };
    for i in 0..joints {
        let next = (i + 1) % n;
        let (a, b) = (state(&sectors[i], sectors[i].angle), state(&sectors[next], 0.0));
        for (x, y) in a.iter().zip(&b).take(2 * rows) {
            for k in 0..unknowns {
                *m.at(row, unknowns * i + k) += x[k];
                *m.at(row, unknowns * next + k) -= y[k];
            }
            row += 1;
        }
    }
    m.determinant()
}

#[cfg(test)]
mod tests;
