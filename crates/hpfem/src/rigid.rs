//! Rigid motions that supports leave free, and what they are in kept unknowns.

use crate::boundary::edge_modes;
use crate::freedom::rigid_rows;
use crate::kept::Kept;
use crate::material::Kinematics;
use crate::mesh::Mesh;
use crate::space::Space;
use faer::Mat;

/// Rigid motions `[t_x, t_z, theta]` about the origin that neither a support nor one of the directions `(place, direction)` in
/// `held` hinders, as a reduced basis.
pub(crate) fn free_motions(mesh: &Mesh, space: &Space, kinematics: Kinematics, held: &[([f64; 2], [f64; 2])]) -> Vec<[f64; 3]> {
    let size = mesh.vertices.iter().fold(0.0_f64, |m, x| m.max(x[0].abs()).max(x[1].abs()));
    let candidates: &[usize] = match kinematics {
        Kinematics::Axisymmetric => &[1],
        Kinematics::Torsion => &[2],
        _ => &[0, 1, 2],
    };
    let (columns, pivots) = eliminated(conditions(mesh, space, (kinematics, size), held), candidates);
    columns
        .iter()
        .map(|free| {
            let mut motion = [0.0; 3];
            motion[*free] = 1.0;
            pivots.iter().for_each(|(c, r)| motion[*c] = -r[*free]);
            motion[2] /= size;
            let unit = motion.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
            if *free == 2 { motion.map(|v| v * size) } else { motion.map(|v| v / unit) }
        })
        .collect()
}

/// Rows of conditions on `(t_x, t_z, theta size)`: of the held directions, of the supports, of the rigid edge.
fn conditions(mesh: &Mesh, space: &Space, (kinematics, size): (Kinematics, f64), held: &[([f64; 2], [f64; 2])]) -> Vec<[f64; 3]> {
    let row = |x: [f64; 2], d: [f64; 2]| {
        let motions = rigid_rows(x, [0.0, 0.0]);
        [0, 1, 2].map(|k| (motions[k][0] * d[0] + motions[k][1] * d[1]) / if k == 2 { size } else { 1.0 })
    };
    let mut rows: Vec<[f64; 3]> = held.iter().map(|(x, d)| row(*x, *d)).collect();
    for (g, freedom) in space.freedom.iter().enumerate().filter(|(_, freedom)| !freedom.slaved) {
        let x = match g.checked_sub(mesh.vertices.len()) {
            None => mesh.vertices[g],
            Some(e) => mesh.edges[e].curve.point(0.0),
        };
        for axis in (0..2).filter(|axis| freedom.fixed[*axis].is_some()) {
            rows.push(match kinematics {
                // u_phi = r theta.
                Kinematics::Torsion => row([0.0, x[0]], [-1.0, 0.0]),
                _ => row(x, freedom.axes[axis]),
            });
        }
    }
    if let Some((_, rigid)) = &space.frame {
        let axes = [[1.0, 0.0], [0.0, 1.0]];
        rows.extend(axes.iter().enumerate().filter(|(k, _)| !rigid.free[*k]).map(|(_, d)| row(rigid.reference, *d)));
        if !rigid.free[2] {
            rows.push([0.0, 0.0, 1.0]);
        }
    }
    rows
}

/// Gaussian elimination with pivoting among `candidates`: the free columns, and the pivot rows by their columns.
fn eliminated(mut rows: Vec<[f64; 3]>, candidates: &[usize]) -> (Vec<usize>, Vec<(usize, [f64; 3])>) {
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
        if row[column].abs() < 1e-9 {
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
