//! A rigid edge whose free motions the body's own supports hold elastically: a punch guided at its side, pressed on its back.

use contact::{MomentBalance, Motion};
use faer::Mat;
use faer::linalg::solvers::Solve;
use hpfem::InterfaceOperator;

/// What acts on the rigid edge of body 1.
#[derive(Clone, Debug, PartialEq)]
pub struct EdgeLoad {
    /// Motions `t_x`, `t_z` and `theta`, as in [`ContactLoad::motions`](contact::ContactLoad::motions).
    pub motions: [Motion; 3],
    /// Which moment the moment of the edge balances.
    pub moment: MomentBalance,
}

/// Whether supports hold some free motion of a rigid edge elastically: the edge has more motions than the body.
pub fn is_held_elastically(body: &InterfaceOperator) -> bool {
    body.frame.iter().flatten().count() > body.rigid_modes.ncols()
}

/// Kept unknowns of a body under the right-hand sides `right`, its edge held but for motions that supports hold elastically: these follow from
///
/// ```text
/// K q = r + Psi^T f        Psi: the body's answer to unit motions of the edge, K: their stiffness, r: the resultants on the edge,
/// ```
///
/// with the rigid part of `q` left at zero, prescribed or not. Where the moment balances the pressure alone, its row takes `by_pressure`, the
/// right-hand side without shear, instead of `right`.
pub(crate) fn solve_edge(body: &InterfaceOperator, edge: &EdgeLoad, right: &[f64], by_pressure: &[f64]) -> Vec<f64> {
    let frame: Vec<(usize, usize)> = (0..3).filter_map(|k| body.frame[k].map(|unknown| (k, unknown))).collect();
    let held = held_edge(body);
    let answers: Vec<Vec<f64>> = frame.iter().map(|(_, unknown)| unit_motion(body, &held, *unknown)).collect();
    let work = |a: &[f64], f: &[f64]| a.iter().zip(f).map(|(a, f)| a * f).sum::<f64>();
    let (q, modes) = (frame.len(), body.rigid_modes.ncols());
    // The bordered system [K Z; Z^T 0], rows of motions that are given being the values themselves.
    let mut matrix = Mat::<f64>::zeros(q + modes, q + modes);
    let mut loads = Mat::<f64>::zeros(q + modes, 1);
    let stiffness = |i: usize, j: usize| (0..right.len()).map(|m| body.stiffness[(frame[i].1, m)] * answers[j][m]).sum::<f64>();
    let rigid: Vec<bool> = frame.iter().map(|(_, u)| (0..modes).any(|m| body.rigid_modes[(*u, m)].abs() > 1e-9)).collect();
    // Where the rigid modes are motions of the edge themselves, these are zero and need no balance.
    let apart = rigid.iter().filter(|rigid| **rigid).count() == modes;
    for (i, (k, unknown)) in frame.iter().enumerate() {
        let own = stiffness(i, i).max(body.stiffness[(*unknown, *unknown)]);
        let given = match edge.motions[*k] {
            _ if rigid[i] && apart => Some(0.0),
            Motion::Prescribed { value } if !rigid[i] => Some(value),
            Motion::Prescribed { .. } | Motion::Free { .. } | Motion::Sprung { .. } => None,
        };
        if let Some(value) = given {
            (matrix[(i, i)], loads[(i, 0)]) = (own, own * value);
            continue;
        }
        let guided = *k == 2 && edge.moment == MomentBalance::Pressure;
        loads[(i, 0)] = work(&answers[i], if guided { by_pressure } else { right });
        match edge.motions[*k] {
            Motion::Prescribed { .. } => {}
            Motion::Free { resultant } => loads[(i, 0)] += resultant,
            Motion::Sprung { stiffness, rest } => {
                matrix[(i, i)] += stiffness;
                loads[(i, 0)] += stiffness * rest;
            }
        }
        (0..q).for_each(|j| matrix[(i, j)] += stiffness(i, j));
        (0..modes).for_each(|m| matrix[(i, q + m)] = own * body.rigid_modes[(*unknown, m)]);
    }
    for (j, (_, unknown)) in frame.iter().enumerate() {
        (0..modes).for_each(|m| matrix[(q + m, j)] = if apart { 0.0 } else { body.rigid_modes[(*unknown, m)] });
    }
    if apart {
        (0..modes).for_each(|m| matrix[(q + m, q + m)] = 1.0);
    }
    let motions = matrix.full_piv_lu().solve(&loads);
    let mut unknowns = solve_held(body, &held, right);
    for (j, answer) in answers.iter().enumerate() {
        unknowns.iter_mut().zip(answer).for_each(|(u, a)| *u += motions[(j, 0)] * a);
    }
    unknowns
}

/// The body with its rigid edge held.
pub(crate) fn held_edge(body: &InterfaceOperator) -> InterfaceOperator {
    let mut operator = body.clone();
    for h in body.frame.iter().flatten().copied() {
        for i in 0..operator.stiffness.nrows() {
            operator.stiffness[(h, i)] = 0.0;
            operator.stiffness[(i, h)] = 0.0;
        }
        operator.stiffness[(h, h)] = body.stiffness[(h, h)];
    }
    operator.rigid_modes = Mat::zeros(body.stiffness.nrows(), 0);
    operator
}

/// Solves with the rigid edge's motions at zero.
pub(crate) fn solve_held(body: &InterfaceOperator, held: &InterfaceOperator, right: &[f64]) -> Vec<f64> {
    let frame: Vec<usize> = body.frame.iter().flatten().copied().collect();
    let right: Vec<f64> = right.iter().enumerate().map(|(i, f)| if frame.contains(&i) { 0.0 } else { *f }).collect();
    held.solve_one(&right)
}

/// The body's answer to a unit motion of its edge, the others at zero.
fn unit_motion(body: &InterfaceOperator, held: &InterfaceOperator, unknown: usize) -> Vec<f64> {
    let right: Vec<f64> = (0..body.stiffness.nrows()).map(|i| -body.stiffness[(i, unknown)]).collect();
    let mut answer = solve_held(body, held, &right);
    answer[unknown] = 1.0;
    answer
}
