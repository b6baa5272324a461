//! Rigid motions that supports leave free, and what they are in kept unknowns.

use crate::boundary::edge_modes;
use crate::box_tree::Bounds;
use crate::error::Error;
use crate::foundation::HeldPlace;
use crate::freedom::rigid_rows;
use crate::kept::Kept;
use crate::kinematics::Kinematics;
use crate::mesh::{Mesh, distance};
use crate::problem::BodyProblem;
use crate::space::Space;
use faer::Mat;

/// Rigid motions `[t_x, t_z, theta]` about the origin that neither a support nor a foundation hinders, as a reduced basis. Of a potential,
/// the constant, as `[1, 0, 0]`.
pub(crate) fn free_motions(problem: &BodyProblem, space: &Space) -> Result<Vec<[f64; 3]>, Error> {
    let body = Conditions::new(problem, space, &|_| true);
    Ok(body.free(body.rows(&|_| true, &problem.held()?)))
}

/// Refuses a body that can move without moving what is kept, and a body of several parts one of which can move at all.
pub(crate) fn check_held(problem: &BodyProblem, space: &Space, kept: &Kept) -> Result<(), Error> {
    let part = parts(&problem.mesh, space);
    let parts = part.iter().max().map_or(0, |last| last + 1);
    // Both ends of an edge that is kept tell every motion.
    if parts == 1 && !kept.walks.is_empty() {
        return Ok(());
    }
    let held = problem.held()?;
    let mut loose = Vec::new();
    for number in 0..parts {
        let within = |g: usize| part[g] == number;
        let body = Conditions::new(problem, space, &within);
        let here: Vec<HeldPlace> = held.iter().filter(|place| within(place.group)).copied().collect();
        let mut rows = body.rows(&within, &here);
        if parts == 1 {
            rows.extend(kept.groups.iter().flat_map(|g| body.whole_rows(*g)));
        }
        let free = body.free(rows);
        if !free.is_empty() {
            loose.push((number, motion_words(problem.kinematics, &free)));
        }
    }
    let Some((number, motion)) = loose.first() else { return Ok(()) };
    if parts == 1 {
        return Err(Error::NotHeld { motion: motion.clone() });
    }
    let mesh = &problem.mesh;
    let cell = mesh.cells.iter().position(|cell| part[cell.corners[0]] == *number).unwrap_or(0);
    let [x, z] = mesh.cells.get(cell).map_or([0.0; 2], |cell| mesh.vertices[cell.corners[0]]);
    let motion = format!(
        "{} of its {parts} unconnected parts can move, the first with cell {cell} at ({x:.4}, {z:.4}): {motion}",
        loose.len()
    );
    Err(Error::NotHeld { motion })
}

/// Free motions in words.
pub(crate) fn motion_words(kinematics: Kinematics, free: &[[f64; 3]]) -> String {
    if kinematics.is_conduction() {
        return "its potential is known up to a constant".to_string();
    }
    if kinematics == Kinematics::Torsion {
        return "it can turn about its axis".to_string();
    }
    let free = with_one_turn(free);
    let words = |motion: &[f64; 3]| match motion {
        [_, t, theta] if theta.abs() <= 1e-12 && motion[0].abs() <= 1e-12 * t.abs() => "slide along the second axis".to_string(),
        [t, _, theta] if theta.abs() <= 1e-12 && motion[1].abs() <= 1e-12 * t.abs() => "slide along the first axis".to_string(),
        [x, z, theta] if theta.abs() <= 1e-12 => format!("slide along the direction ({x:.4}, {z:.4})"),
        // A rotation is free about any point if both translations are.
        [..] if free.len() == 3 => "turn".to_string(),
        [x, z, theta] => format!("turn about ({:.4}, {:.4})", 0.0 - z / theta, x / theta),
    };
    format!("it can {}", free.iter().map(words).collect::<Vec<_>>().join(" and "))
}

/// The same motions with one turn among them at most, the last: turns about two points are a slide and a turn.
fn with_one_turn(free: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let Some(last) = (0..free.len()).max_by(|a, b| free[*a][2].abs().total_cmp(&free[*b][2].abs())) else { return Vec::new() };
    let turn = free[last];
    let slide = |motion: &[f64; 3]| {
        if motion[2].abs() <= 1e-12 {
            return *motion;
        }
        let [x, z] = [0, 1].map(|k| motion[k] - motion[2] / turn[2] * turn[k]);
        let unit = if x.abs() > z.abs() { x } else { z };
        [x / unit, z / unit, 0.0]
    };
    let others = free.iter().enumerate().filter(|(k, _)| *k != last);
    others.map(|(_, motion)| slide(motion)).chain([turn]).collect()
}

/// Number of the connected part of every group, the rigid edge's included.
fn parts(mesh: &Mesh, space: &Space) -> Vec<usize> {
    let vertices = mesh.vertices.len();
    let mut parent: Vec<usize> = (0..vertices + mesh.edges.len() + 1).collect();
    fn root(parent: &mut [usize], mut g: usize) -> usize {
        while parent[g] != g {
            parent[g] = parent[parent[g]];
            g = parent[g];
        }
        g
    }
    let frame = vertices + mesh.edges.len();
    let join = |parent: &mut Vec<usize>, a: usize, b: usize| {
        let (a, b) = (root(parent, a), root(parent, b));
        parent[a.max(b)] = a.min(b);
    };
    let mut used = vec![false; vertices];
    for cell in &mesh.cells {
        let first = cell.corners[0];
        for v in cell.vertices() {
            used[*v] = true;
            join(&mut parent, first, *v);
        }
        cell.sides().for_each(|(_, e)| join(&mut parent, first, vertices + e));
    }
    (0..vertices).filter(|v| space.freedom[*v].slaved).for_each(|v| join(&mut parent, v, frame));
    // Vertices that no cell has, and a rigid edge that is none, belong to the first part.
    let anchor = mesh.cells.first().map_or(0, |cell| cell.corners[0]);
    (0..vertices).filter(|v| !used[*v]).for_each(|v| join(&mut parent, anchor, v));
    if space.frame.is_none() {
        join(&mut parent, anchor, frame);
    }
    let mut number = vec![usize::MAX; parent.len()];
    let mut next = 0;
    let roots: Vec<usize> = (0..parent.len()).map(|g| root(&mut parent, g)).collect();
    for r in &roots {
        if number[*r] == usize::MAX {
            number[*r] = next;
            next += 1;
        }
    }
    roots.into_iter().map(|r| number[r]).collect()
}

/// What a problem asks of rigid motions.
struct Conditions<'a> {
    problem: &'a BodyProblem,
    space: &'a Space,
    /// The point about which motions turn, mm: the origin, or the middle of a body that is far from it.
    middle: [f64; 2],
    /// A length of the size of the body, the unit of rotations, mm.
    size: f64,
    /// What is left of a row by the round-off of coordinates.
    round_off: f64,
}

/// Sizes of a body from the origin beyond which its levers about that are lost in it.
const FAR: f64 = 1e5;

impl Conditions<'_> {
    /// The conditions on what is `within` a part.
    fn new<'a>(problem: &'a BodyProblem, space: &'a Space, within: &dyn Fn(usize) -> bool) -> Conditions<'a> {
        let vertices = || problem.mesh.vertices.iter().enumerate().filter(|(v, _)| within(*v)).map(|(_, x)| *x);
        let reach = vertices().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
        let around = Bounds::around(vertices());
        let (middle, size) = match problem.kinematics == Kinematics::Torsion {
            // Turns about the axis, wherever along it.
            true => ([0.0; 2], vertices().fold(0.0_f64, |m, x| m.max(x[0].abs()))),
            false => (around.middle(), around.widths().into_iter().fold(0.0, f64::max)),
        };
        if reach > FAR * size {
            return Conditions { problem, space, middle, size, round_off: 1e-9 + 64.0 * f64::EPSILON * reach / size };
        }
        Conditions { problem, space, middle: [0.0; 2], size: reach.max(f64::MIN_POSITIVE), round_off: 1e-9 }
    }

    /// The motions without those that `rows` exclude.
    fn free(&self, rows: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
        let size = self.size;
        let candidates: &[usize] = match self.problem.kinematics {
            Kinematics::Axisymmetric => &[1],
            Kinematics::Torsion => &[2],
            Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => &[0],
            Kinematics::PlaneStress { .. } | Kinematics::PlaneStrain { .. } => &[0, 1, 2],
        };
        let (columns, pivots) = eliminated(rows, candidates, self.round_off);
        let motion = |free: &usize| {
            let mut motion = [0.0; 3];
            motion[*free] = 1.0;
            pivots.iter().for_each(|(c, r)| motion[*c] = -r[*free]);
            motion[2] /= size;
            let unit = motion.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            let motion = if *free == 2 { motion.map(|v| v * size) } else { motion.map(|v| v / unit) };
            self.about_origin(motion)
        };
        columns.iter().map(motion).collect()
    }

    /// A motion about the middle as one about the origin.
    fn about_origin(&self, [x, z, theta]: [f64; 3]) -> [f64; 3] {
        if self.middle == [0.0; 2] {
            return [x, z, theta];
        }
        [x + theta * self.middle[1], z - theta * self.middle[0], theta]
    }

    /// The condition on `(t_x, t_z, theta size)` that a direction is held at a place.
    fn row(&self, x: [f64; 2], d: [f64; 2]) -> [f64; 3] {
        let (x, d) = match self.problem.kinematics {
            // u_phi = r theta.
            Kinematics::Torsion => ([0.0, x[0]], [-1.0, 0.0]),
            Kinematics::Potential { .. } | Kinematics::AxisymmetricPotential => return [1.0, 0.0, 0.0],
            Kinematics::PlaneStress { .. } | Kinematics::PlaneStrain { .. } | Kinematics::Axisymmetric => (x, d),
        };
        let motions = rigid_rows(x, self.middle);
        [0, 1, 2].map(|k| (motions[k][0] * d[0] + motions[k][1] * d[1]) / if k == 2 { self.size } else { 1.0 })
    }

    /// The middle of a vertex or edge.
    fn place(&self, group: usize) -> [f64; 2] {
        let mesh = &self.problem.mesh;
        match group.checked_sub(mesh.vertices.len()) {
            None => mesh.vertices[group],
            Some(e) => mesh.edges[e].curve.point(0.0),
        }
    }

    /// Conditions of the held directions, of the supports and of the rigid edge, as far as they are `within` a part.
    fn rows(&self, within: &dyn Fn(usize) -> bool, held: &[HeldPlace]) -> Vec<[f64; 3]> {
        let mut rows: Vec<[f64; 3]> = held.iter().map(|place| self.row(place.position, place.direction)).collect();
        let groups = self.space.freedom.iter().enumerate();
        for (g, freedom) in groups.filter(|(g, freedom)| within(*g) && !freedom.slaved) {
            let fixed = (0..2).filter(|axis| freedom.fixed[*axis].is_some());
            rows.extend(fixed.map(|axis| self.row(self.place(g), freedom.axes[axis])));
        }
        if let Some((_, rigid)) = self.space.frame.as_ref().filter(|(group, _)| within(*group)) {
            let free = rigid.free;
            rows.extend(self.frame_rows(!free[2]).into_iter().zip(free).filter(|(_, free)| !free).map(|(row, _)| row));
        }
        rows
    }

    /// Conditions that a group does not move at all.
    fn whole_rows(&self, group: usize) -> Vec<[f64; 3]> {
        if self.space.frame.as_ref().is_some_and(|(frame, _)| *frame == group) {
            return self.frame_rows(true);
        }
        [[1.0, 0.0], [0.0, 1.0]].iter().map(|d| self.row(self.place(group), *d)).collect()
    }

    /// Conditions that the rigid edge does not slide along either axis nor turn. Without a turn it slides alike at all points, and the levers of one
    /// far from the body would hide that.
    fn frame_rows(&self, without_turn: bool) -> Vec<[f64; 3]> {
        let Some((_, rigid)) = &self.space.frame else { return Vec::new() };
        let is_far = distance(rigid.reference, self.middle) > FAR * self.size;
        let at = if without_turn && is_far { self.middle } else { rigid.reference };
        vec![self.row(at, [1.0, 0.0]), self.row(at, [0.0, 1.0]), [0.0, 0.0, 1.0]]
    }
}

/// Gaussian elimination with pivoting among `candidates`: the free columns, and the pivot rows by their columns. Pivots below `round_off` are none.
fn eliminated(mut rows: Vec<[f64; 3]>, candidates: &[usize], round_off: f64) -> (Vec<usize>, Vec<(usize, [f64; 3])>) {
    let mut pivots: Vec<(usize, [f64; 3])> = Vec::new();
    let mut columns: Vec<usize> = candidates.to_vec();
    for _ in 0..candidates.len() {
        let best = rows
            .iter()
            .flat_map(|r| columns.iter().map(move |c| (r, *c)))
            .max_by(|(r, c), (s, d)| r[*c].abs().total_cmp(&s[*d].abs()));
        let Some((row, column)) = best.map(|(r, c)| (*r, c)) else {
            break;
        };
        if row[column].abs() < round_off {
            break;
        }
        let pivot = row.map(|v| v / row[column]);
        let eliminate = |r: &mut [f64; 3]| {
            let f = r[column];
            (0..3).for_each(|k| r[k] -= f * pivot[k]);
        };
        rows.iter_mut().for_each(eliminate);
        pivots.iter_mut().for_each(|(_, r)| eliminate(r));
        pivots.push((column, pivot));
        columns.retain(|c| *c != column);
    }
    (columns, pivots)
}

/// The motions as kept unknowns.
pub(crate) fn rigid_columns(mesh: &Mesh, space: &Space, kinematics: Kinematics, kept: &Kept, motions: &[[f64; 3]]) -> Mat<f64> {
    let mut columns = Mat::zeros(kept.unknowns, motions.len());
    let field = |m: &[f64; 3], x: [f64; 2]| -> [f64; 2] {
        if kinematics == Kinematics::Torsion {
            return [m[2] * x[0], 0.0];
        }
        if kinematics.is_conduction() {
            return [m[0], 0.0];
        }
        let rows = rigid_rows(x, [0.0, 0.0]);
        std::array::from_fn(|i| (0..3).map(|k| m[k] * rows[k][i]).sum())
    };
    let mut at = 0;
    for g in &kept.groups {
        for (c, motion) in motions.iter().enumerate() {
            if let Some((group, rigid)) = &space.frame
                && group == g
            {
                let t = field(motion, rigid.reference);
                let values = [t[0], t[1], motion[2]];
                let free = (0..3).filter(|k| rigid.free[*k]);
                free.enumerate().for_each(|(i, k)| columns[(at + i, c)] = values[k]);
                continue;
            }
            let modes = match g.checked_sub(mesh.vertices.len()) {
                None => vec![field(motion, mesh.vertices[*g])],
                Some(e) => edge_modes(&mesh.edges[e].curve, space.edge_degree[e], |x| field(motion, x)),
            };
            let freedom = &space.freedom[*g];
            let free: Vec<usize> = (0..space.components).filter(|a| freedom.fixed[*a].is_none()).collect();
            for (m, value) in modes.iter().enumerate() {
                for (i, axis) in free.iter().enumerate() {
                    let d = freedom.axes[*axis];
                    columns[(at + m * free.len() + i, c)] = d[0] * value[0] + d[1] * value[1];
                }
            }
        }
        at += space.size[*g];
    }
    columns
}
