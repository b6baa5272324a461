//! Mixed complementarity problem of contact as data: nodal forces `lambda >= 0`, openings `w >= 0`, `lambda . w = 0`, with
//! `w = d + A lambda + Psi y` and the balance `K y - B^T lambda = f` of the free coordinates `y`.

use crate::products::{add, times, transposed_times};
use faer::Mat;
use std::borrow::Cow;

/// Largest relative imbalance of a solution.
pub(crate) const BALANCED: f64 = 1e-8;

/// Penalty times the compliance of a point.
pub(crate) const PENALTY: f64 = 16384.0;

/// The problem: `A` is `points x points`, `Psi` and `B` are `points x coordinates`, `K` is `coordinates x coordinates`.
pub(crate) struct Complementarity<'m> {
    pub(crate) compliance: Cow<'m, Mat<f64>>,
    pub(crate) influence: Mat<f64>,
    pub(crate) balance: Mat<f64>,
    pub(crate) stiffness: Mat<f64>,
    pub(crate) opening: Vec<f64>,
    pub(crate) load: Vec<f64>,
    pub(crate) symmetric: bool,
}

/// Forces and coordinates.
#[derive(Clone, Debug, Default)]
pub(crate) struct Point {
    pub(crate) force: Vec<f64>,
    pub(crate) coordinates: Vec<f64>,
}

/// What a solve found.
pub(crate) struct Answer {
    pub(crate) point: Point,
    pub(crate) opening: Vec<f64>,
    pub(crate) active: Vec<bool>,
    pub(crate) factorisations: usize,
    /// Number of points with a wrong sign at each step.
    pub(crate) history: Vec<usize>,
    pub(crate) settled: bool,
    /// Whether the pivoting method had to take over.
    pub(crate) pivoted: bool,
    /// Whether the determinant has the sign of the frictionless problem.
    pub(crate) regular: bool,
}

/// Multipliers and weights of the proximal terms; `weight` is zero for the plain problem.
pub(crate) struct Proximal<'a> {
    pub(crate) weight: f64,
    pub(crate) centre: &'a Point,
}

impl Complementarity<'_> {
    pub(crate) fn points(&self) -> usize {
        self.opening.len()
    }

    /// `w = d + A lambda + Psi y`.
    pub(crate) fn openings(&self, at: &Point) -> Vec<f64> {
        let mut w = self.opening.clone();
        add(&mut w, &times(&self.compliance, &at.force));
        add(&mut w, &times(&self.influence, &at.coordinates));
        w
    }

    /// `f + B^T lambda - K y`.
    pub(crate) fn imbalance(&self, at: &Point) -> Vec<f64> {
        let mut r = self.load.clone();
        add(&mut r, &transposed_times(&self.balance, &at.force));
        times(&self.stiffness, &at.coordinates).iter().zip(&mut r).for_each(|(k, r)| *r -= k);
        r
    }

    /// Tolerances for the signs of forces and openings at a solution: round-off of what was added up.
    pub(crate) fn tolerances(&self, at: &Point) -> (f64, Vec<f64>) {
        let largest = at.force.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let elastic = times(&self.compliance, &at.force);
        let scale = elastic.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        let rigid = times(&self.influence, &at.coordinates);
        let openings =
            (0..self.points()).map(|i| 1e-11 * scale + 16.0 * f64::EPSILON * (self.opening[i].abs() + rigid[i].abs())).collect();
        (1e-11 * largest, openings)
    }

    /// Points whose sign is wrong.
    pub(crate) fn wrong(&self, at: &Point, opening: &[f64], active: &[bool]) -> Vec<usize> {
        let (force, tolerance) = self.tolerances(at);
        let wrong = |i: &usize| if active[*i] { at.force[*i] < -force } else { opening[*i] < -tolerance[*i] };
        (0..self.points()).filter(wrong).collect()
    }

    /// Largest relative residual of the balances, each against the sum of the magnitudes in it.
    pub(crate) fn relative_imbalance(&self, at: &Point) -> f64 {
        let spring = times(&self.stiffness, &at.coordinates);
        self.imbalance(at)
            .iter()
            .enumerate()
            .map(|(j, r)| {
                let contact: f64 = (0..self.points()).map(|i| (self.balance[(i, j)] * at.force[i]).abs()).sum();
                let size = contact + self.load[j].abs() + spring[j].abs();
                if size > 0.0 { r.abs() / size } else { 0.0 }
            })
            .fold(0.0, f64::max)
    }

    /// Whether the balances hold but for [`BALANCED`] of what all forces would do where they do the most: one that goes through the point that carries it
    /// has a moment of round-off alone.
    pub(crate) fn is_balanced(&self, at: &Point) -> bool {
        let spring = times(&self.stiffness, &at.coordinates);
        let force: f64 = at.force.iter().map(|f| f.abs()).sum();
        self.imbalance(at).iter().enumerate().all(|(j, r)| {
            let most = (0..self.points()).map(|i| self.balance[(i, j)].abs()).fold(0.0, f64::max);
            r.abs() <= BALANCED * (most * force + self.load[j].abs() + spring[j].abs())
        })
    }

    /// Largest relative violation of the signs and of `lambda w = 0`.
    pub(crate) fn complementarity(&self, at: &Point, opening: &[f64]) -> f64 {
        worst_sign(&at.force, opening, &times(&self.compliance, &at.force))
    }
}

/// Largest relative violation of the signs and of `lambda w = 0`, openings against the largest elastic one.
pub(crate) fn worst_sign(force: &[f64], opening: &[f64], elastic: &[f64]) -> f64 {
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let (most, elastic) = (largest(force), largest(elastic));
    if most == 0.0 || elastic == 0.0 {
        return 0.0;
    }
    let violation = |(f, w): (&f64, &f64)| {
        let (f, w) = (f / most, w / elastic);
        (-f).max(-w).max((f * w).abs())
    };
    force.iter().zip(opening).map(violation).fold(0.0, f64::max)
}

impl Answer {
    /// Takes a point of which every sign is right.
    pub(crate) fn take(&mut self, point: Point, opening: Vec<f64>, active: &[bool]) {
        self.point = point;
        self.point.force.iter_mut().for_each(|f| *f = f.max(0.0));
        (self.opening, self.active, self.settled) = (opening, active.to_vec(), true);
    }

    /// Nothing in contact.
    pub(crate) fn open(problem: &Complementarity<'_>) -> Answer {
        let n = problem.points();
        Answer {
            point: Point { force: vec![0.0; n], coordinates: vec![0.0; problem.load.len()] },
            opening: problem.opening.clone(),
            active: vec![false; n],
            factorisations: 0,
            history: Vec::new(),
            settled: false,
            pivoted: false,
            regular: true,
        }
    }
}
