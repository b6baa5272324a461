//! The balance where the pressure is not known up to a factor: pressure caps, b1 != b2, revolving counter-faces, and q = inf with
//! moments. Newton on (log scale, y) with a Jacobian by central differences: every integral is exact to round-off, so the
//! differences are too.

use nalgebra::{DMatrix, DVector};

use crate::WearError;
use crate::balance::Balanced;
use crate::bracket::Bracket;
use crate::cells::{BEYOND, is_beyond, whole};
use crate::density::Density;
use crate::pressure_law::Node;
use crate::stage::Stage;
use crate::why::{BELOW, BOUNDED, none};

const ITERATIONS: usize = 60;
const STEP: f64 = 1e-5;
const TOLERANCE: f64 = 2e-14;
/// Part of the load that is missing where a wear rule is at its bound, as a logarithm.
const SHORT: f64 = 1e-6;
/// Largest residual of an answer.
const LARGEST: f64 = 1e-10;

/// Solves the balance from the present y; on return the law is absolute and `nodes` hold log p.
pub(crate) fn balance_absolute(stage: &mut Stage<'_>, nodes: &mut Vec<Node>) -> Result<Balanced, WearError> {
    stage.law.absolute = true;
    find_scale(stage, nodes)?;
    let free: Vec<usize> = (0..stage.law.count).filter(|j| *j != stage.law.pivot).collect();
    let unknowns = free.len() + 1;
    let mut here = residual(stage, nodes, &free);
    let mut iterations = 0;
    while here.amax() > TOLERANCE && iterations < ITERATIONS {
        iterations += 1;
        let start = unknown(stage, &free);
        let mut jacobian = DMatrix::<f64>::zeros(unknowns, unknowns);
        for column in 0..unknowns {
            let step = STEP * if column == 0 { 1.0 } else { start[column].abs().max(0.1) };
            let mut at = |shift: f64, stage: &mut Stage<'_>| {
                let mut z = start.clone();
                z[column] += shift;
                set_unknown(stage, &free, &z);
                residual(stage, nodes, &free)
            };
            let difference = (at(step, stage) - at(-step, stage)) / (2.0 * step);
            jacobian.set_column(column, &difference);
        }
        let Some(full) = jacobian.lu().solve(&(-&here)) else {
            set_unknown(stage, &free, &start);
            break;
        };
        let mut length = 1.0_f64.min(3.0 / full[0].abs().max(f64::MIN_POSITIVE));
        let mut best = None;
        for _ in 0..40 {
            set_unknown(stage, &free, &(&start + &full * length));
            let there = residual(stage, nodes, &free);
            if there.norm() < (1.0 - 1e-4 * length) * here.norm() {
                best = Some(there);
                break;
            }
            length *= 0.5;
        }
        match best {
            Some(there) => here = there,
            None => {
                set_unknown(stage, &free, &start);
                break;
            }
        }
    }
    here = residual(stage, nodes, &free);
    whole(nodes)?;
    stage.affordable()?;
    let size = here.amax();
    if size.is_nan() || size > LARGEST.max(known_to(stage, nodes)) {
        return Err(WearError::NotConverged { iterations, residual: size });
    }
    Ok(Balanced { log_scale: stage.law.log_scale, iterations, residual: size })
}

/// How well the sums over a strip at the cap are known at s = 1: f = force over cost - 1 has the round-off of 1, and the strip ends where f vanishes.
fn known_to(stage: &Stage<'_>, nodes: &[Node]) -> f64 {
    let highest = nodes.iter().map(|node| node.f).fold(0.0, f64::max);
    if is_bang_bang(stage) && highest > 0.0 { 4.0 * f64::EPSILON / highest } else { 0.0 }
}

fn is_bang_bang(stage: &Stage<'_>) -> bool {
    matches!(stage.law.density, Density::BangBang { .. })
}

fn unknown(stage: &Stage<'_>, free: &[usize]) -> DVector<f64> {
    DVector::from_iterator(free.len() + 1, std::iter::once(stage.law.log_scale).chain(free.iter().map(|j| stage.law.y[*j])))
}

fn set_unknown(stage: &mut Stage<'_>, free: &[usize], z: &DVector<f64>) {
    stage.law.log_scale = z[0];
    for (row, j) in free.iter().enumerate() {
        stage.law.y[*j] = z[row + 1];
    }
}

/// log of the pivot resultant over its target, then the other resultants over the pivot's target.
fn residual(stage: &mut Stage<'_>, nodes: &mut Vec<Node>, free: &[usize]) -> DVector<f64> {
    if matches!(stage.law.density, Density::Receding { .. }) {
        stage.settle_recession(nodes);
    }
    if !stage.collect_within_reason(nodes) {
        return DVector::from_element(free.len() + 1, f64::NAN);
    }
    let target = stage.law.resultant(stage.law.pivot);
    let mut values = DVector::<f64>::zeros(free.len() + 1);
    for node in nodes.iter() {
        let share = node.log_h.exp() * node.point.weight / target;
        values[0] += node.modes.psi[stage.law.pivot] * share;
        for (row, j) in free.iter().enumerate() {
            values[row + 1] += stage.law.reduced(&node.modes.psi, *j) * share;
        }
    }
    if is_beyond(nodes) && matches!(stage.law.density, Density::Given(_)) {
        values[0] = BEYOND;
        return values;
    }
    values[0] = if values[0] > 0.0 { values[0].ln() } else { -700.0 };
    values
}

/// Common factor for which the pivot resultant is met, by bracketing: the resultant grows with the factor, or where the pressure falls with f it falls.
fn find_scale(stage: &mut Stage<'_>, nodes: &mut Vec<Node>) -> Result<(), WearError> {
    let at = |stage: &mut Stage<'_>, nodes: &mut Vec<Node>, scale: f64| {
        stage.law.log_scale = scale;
        residual(stage, nodes, &[])[0]
    };
    let mut a = stage.law.log_scale;
    let mut fa = at(stage, nodes, a);
    whole(nodes)?;
    let mut step = if stage.law.density.falls_with_force() { -0.5 } else { 0.5_f64 };
    let mut b = a;
    let mut fb = fa;
    // Under a cap at s = 1 every place is either full or empty: a hundred e-folds are all there is.
    let farthest = if is_bang_bang(stage) { 100.0 } else { 1e7 };
    while (fa > 0.0) == (fb > 0.0) {
        (a, fa) = (b, fb);
        b -= step * fb.signum();
        fb = at(stage, nodes, b);
        whole(nodes)?;
        step *= 2.0;
        if step.abs() > farthest {
            let below = matches!(stage.law.density, Density::Given(_)) && fb > 0.0;
            return Err(stage.infeasible(if below {
                BELOW
            } else if stage.problem.p_max.is_none() {
                none("friction carries it, or q is so large that its pressure is that of an infinite q")
            } else {
                none("the load is larger than the surface carries under p_max, or friction carries it")
            }));
        }
    }
    let mut root = Bracket { a, value_a: fa, b, value_b: fb };
    // A narrow strip of it has all its width within a few digits of the scale.
    let (enough, width) = if is_bang_bang(stage) { (TOLERANCE, 0.0) } else { (0.0, 1e-14) };
    for _ in 0..200 {
        if root.value_b.abs() <= enough || (root.b - root.a).abs() <= width * root.b.abs().max(1.0) {
            break;
        }
        let c = root.next();
        root.take(c, at(stage, nodes, c));
    }
    // A rule at its bound: below it less is carried, and beyond it there is no pressure.
    if at(stage, nodes, root.a.max(root.b)) >= BEYOND {
        let low = root.a.min(root.b);
        if at(stage, nodes, low) < -SHORT && stage.law.count == 1 {
            return Err(stage.infeasible(BOUNDED));
        }
        root.b = low;
    }
    stage.law.log_scale = root.b;
    Ok(())
}
