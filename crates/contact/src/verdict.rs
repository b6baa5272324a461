//! What an answer of the complementarity problem means.

use crate::coulomb::{ContactState, Coulomb, Outcome};
use crate::lcp::{Answer, BALANCED, Complementarity};
use crate::linear::Scaling;
use crate::products::{add, times, transposed_times};
use crate::status::Status;
use faer::Mat;
use std::borrow::Cow;

/// Status of an answer.
pub(crate) fn status(problem: &Complementarity<'_>, normal: &Mat<f64>, answer: &Answer) -> Status {
    if answer.settled && problem.is_balanced(&answer.point) {
        let closed = answer.active.iter().filter(|a| **a).count();
        return match closed {
            0 => Status::NoContact,
            _ if !answer.regular => Status::NotUnique,
            _ if closed == answer.active.len() => Status::ClosedEverywhere,
            _ => Status::Converged,
        };
    }
    let frictionless = Complementarity {
        compliance: Cow::Borrowed(normal),
        influence: problem.influence.clone(),
        balance: problem.influence.clone(),
        stiffness: problem.stiffness.clone(),
        opening: problem.opening.clone(),
        load: problem.load.clone(),
        symmetric: true,
    };
    if !can_balance(&frictionless, std::slice::from_ref(&frictionless.balance)) {
        return Status::NoBalance;
    }
    if !can_balance(problem, std::slice::from_ref(&problem.balance)) || friction_resists(problem, &frictionless) {
        return Status::Jammed;
    }
    Status::IterationLimit { history: answer.history.clone() }
}

/// Status of a load step with stick and slip.
pub(crate) fn sheared_status(problem: &Coulomb<'_>, outcome: &Outcome) -> Status {
    let balanced = outcome.at.as_ref().is_some_and(|at| problem.relative_imbalance(at) <= BALANCED);
    if outcome.settled && balanced {
        let closed = outcome.states.iter().filter(|s| **s != ContactState::Open).count();
        return match closed {
            0 => Status::NoContact,
            _ if closed == outcome.states.len() => Status::ClosedEverywhere,
            _ => Status::Converged,
        };
    }
    // Each point's force lies between the two edges of its friction cone.
    let normal = problem.normal;
    let edge = |sign: f64| {
        let n = normal.points();
        Mat::from_fn(n, normal.load.len(), |i, j| {
            normal.influence[(i, j)] + sign * problem.coefficient * problem.influence[(i, j)]
        })
    };
    if can_balance(normal, &[edge(1.0), edge(-1.0)]) {
        Status::IterationLimit { history: outcome.history.clone() }
    } else {
        Status::NoBalance
    }
}

/// Whether some nodal forces `lambda >= 0` and coordinates `y` give `f + B^T lambda = K y`: non-negative least squares (Lawson and Hanson
/// 1974) on scaled rows, with the range of `K` taken out.
fn can_balance(problem: &Complementarity<'_>, generators: &[Mat<f64>]) -> bool {
    let m = problem.load.len();
    let n = problem.points();
    let entries = |j: usize| generators.iter().flat_map(move |g| (0..n).map(move |i| g[(i, j)]));
    // Rows scaled to unit largest entry.
    let scale: Vec<f64> = (0..m)
        .map(|j| entries(j).fold(problem.load[j].abs(), |m, v| m.max(v.abs())))
        .map(|s| if s > 0.0 { s } else { 1.0 })
        .collect();
    let rows: Vec<usize> = (0..m).filter(|j| problem.stiffness[(*j, *j)] <= 0.0).collect();
    let size = rows.iter().map(|j| (problem.load[*j] / scale[*j]).abs()).fold(0.0, f64::max);
    if size == 0.0 {
        return true;
    }
    let target: Vec<f64> = rows.iter().map(|j| -problem.load[*j] / scale[*j] / size).collect();
    let column = |g: &Mat<f64>, i: usize| -> Vec<f64> { rows.iter().map(|j| g[(i, *j)] / scale[*j]).collect() };
    let columns: Vec<Vec<f64>> = generators.iter().flat_map(|g| (0..n).map(move |i| (g, i))).map(|(g, i)| column(g, i)).collect();
    distance_to_cone(&columns, &target) < 1e-7
}

/// Distance of a point from the cone spanned by the columns.
fn distance_to_cone(columns: &[Vec<f64>], target: &[f64]) -> f64 {
    let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let mut chosen: Vec<usize> = Vec::new();
    let mut weights: Vec<f64> = Vec::new();
    let residual = |chosen: &[usize], weights: &[f64]| {
        let mut r = target.to_vec();
        chosen.iter().zip(weights).for_each(|(c, w)| r.iter_mut().zip(&columns[*c]).for_each(|(r, a)| *r -= w * a));
        r
    };
    for _ in 0..3 * columns.len() + 10 {
        let r = residual(&chosen, &weights);
        let length = dot(&r, &r).sqrt();
        let best = (0..columns.len())
            .filter(|i| !chosen.contains(i))
            .max_by(|i, j| dot(&columns[*i], &r).total_cmp(&dot(&columns[*j], &r)));
        let Some(enter) = best else { return length };
        if length < 1e-12 || dot(&columns[enter], &r) <= 1e-12 * length {
            return length;
        }
        chosen.push(enter);
        weights.push(0.0);
        loop {
            let least = least_squares(columns, &chosen, target);
            if least.iter().all(|v| *v > 0.0) {
                weights = least;
                break;
            }
            let step = weights
                .iter()
                .zip(&least)
                .filter(|(_, l)| **l <= 0.0)
                .map(|(w, l)| w / (w - l))
                .fold(1.0_f64, |m, v| if v.is_finite() { m.min(v) } else { 0.0 });
            weights.iter_mut().zip(&least).for_each(|(w, l)| *w += step * (l - *w));
            let keep: Vec<bool> = weights.iter().zip(&least).map(|(w, l)| *l > 0.0 || *w > 1e-14).collect();
            if keep.iter().all(|k| *k) {
                break;
            }
            let mut k = keep.iter();
            chosen.retain(|_| *k.next().unwrap_or(&true));
            let mut k = keep.iter();
            weights.retain(|_| *k.next().unwrap_or(&true));
            if chosen.is_empty() {
                break;
            }
        }
    }
    let r = residual(&chosen, &weights);
    dot(&r, &r).sqrt()
}

fn least_squares(columns: &[Vec<f64>], chosen: &[usize], target: &[f64]) -> Vec<f64> {
    let matrix = nalgebra::DMatrix::from_fn(target.len(), chosen.len(), |i, j| columns[chosen[j]][i]);
    let right = nalgebra::DVector::from_row_slice(target);
    matrix.svd(true, true).solve(&right, 1e-13).map_or_else(|_| vec![0.0; chosen.len()], |x| x.iter().copied().collect())
}

/// Pushes the body to where it would rest without friction and asks which way the contact then pushes back: jammed where
/// `int psi p <= 0`, the shear carrying the body along with the load.
fn friction_resists(problem: &Complementarity<'_>, frictionless: &Complementarity<'_>) -> bool {
    if problem.symmetric || problem.load.is_empty() {
        return false;
    }
    let rest = frictionless.solve(None);
    if !rest.settled {
        return false;
    }
    let mut opening = problem.opening.clone();
    add(&mut opening, &times(&problem.influence, &rest.point.coordinates));
    let n = problem.points();
    let pushed = Complementarity {
        compliance: Cow::Borrowed(&*problem.compliance),
        influence: Mat::zeros(n, 0),
        balance: Mat::zeros(n, 0),
        stiffness: Mat::zeros(0, 0),
        opening,
        load: Vec::new(),
        symmetric: false,
    }
    .solve(None);
    if !pushed.settled {
        return true;
    }
    // Work of contact and load along the motion of the frictionless body.
    let back = transposed_times(&problem.balance, &pushed.point.force);
    let without = transposed_times(&frictionless.balance, &rest.point.force);
    let along: f64 = back.iter().zip(&without).zip(&Scaling::new(problem).stiffness).map(|((b, w), k)| b * w / k).sum();
    along <= 0.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lcp::Point;

    /// Two points that overlap by 1, each pushed off by the other's force times `coupling` of its own.
    fn two_points(coupling: f64) -> Complementarity<'static> {
        Complementarity {
            compliance: Cow::Owned(Mat::from_fn(2, 2, |i, j| if i == j { 1.0 } else { coupling })),
            influence: Mat::zeros(2, 0),
            balance: Mat::zeros(2, 0),
            stiffness: Mat::zeros(0, 0),
            opening: vec![-1.0; 2],
            load: Vec::new(),
            symmetric: false,
        }
    }

    #[test]
    fn a_system_with_three_solutions_is_told_not_unique() {
        let problem = two_points(2.0);
        // By hand: forces (1, 0), (0, 1) and (1/3, 1/3), all with right signs.
        for (force, active) in [(vec![1.0, 0.0], [true, false]), (vec![0.0, 1.0], [false, true]), (vec![1.0 / 3.0; 2], [true; 2])]
        {
            let point = Point { force, coordinates: Vec::new() };
            assert!(problem.wrong(&point, &problem.openings(&point), &active).is_empty());
        }
        let answer = problem.solve(None);
        assert!((answer.point.force[0] - 1.0 / 3.0).abs() < 1e-12);
        assert_eq!(status(&problem, &problem.compliance, &answer), Status::NotUnique);
    }

    #[test]
    fn the_same_system_with_little_coupling_is_unique() {
        let problem = two_points(0.5);
        let answer = problem.solve(None);
        assert_eq!(status(&problem, &problem.compliance, &answer), Status::ClosedEverywhere);
    }
}
