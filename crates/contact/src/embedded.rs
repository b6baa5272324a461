//! An error estimate of the pressure from one solve: how much its highest polynomials on each edge carry.
//!
//! On the set of points in contact the pressure is sought once more among the polynomials of one degree less on each edge, `p = P q`
//! with the openings orthogonal to them, `P^T W w = 0`: one small dense problem on the compliance that is there. Where an edge is open in part the
//! pressure is no polynomial, and its end may lie anywhere between two points: the last closed point is opened instead.

use crate::error::Error;
use crate::lcp::Complementarity;
use crate::linear::Scaling;
use crate::load::{ContactLoad, Friction};
use crate::operator::ContactOperator;
use crate::solution::ContactSolution;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// Part of the surface at each of its ends that does not count: there the pressure may be singular.
const MARGIN: f64 = 0.025;

impl ContactOperator<'_> {
    /// Difference of the pressure from that of the embedded degree over the inner 95 % of the surface (all of a closed one), relative L2. `None` where no
    /// edge is in contact all over with a degree of 3 or more, and with stick and slip.
    ///
    /// It sees the polynomials of the pressure alone, not the mesh of the bodies. On meshes with layers towards all that is singular it is 1 to 1.4 times
    /// the error where contact ends at nodes, up to 4 times near round-off, and 4 to 14 times where it ends between points. What the cells of the bodies do
    /// not resolve it does not know: with no layers at corners outside the contact it was 7.6e-7 where the pressure was off by 2.4e-5. Compare two meshes
    /// to see both.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`].
    pub fn embedded_difference(&self, gap: &[f64], load: &ContactLoad, solution: &ContactSolution) -> Result<Option<f64>, Error> {
        let problem = self.stage(gap, load)?.plain.problem;
        let edges = &self.pair.trace().edges;
        let n = self.unit.points.len();
        let smooth = |edge: usize| edges[edge].degree > 2 && self.edge_points(edge).all(|i| solution.closed[i % n]);
        if !(0..edges.len()).any(smooth) || matches!(load.friction, Friction::Coulomb { .. }) {
            return Ok(None);
        }
        // Each end of contact inside an edge moves in by one point.
        let around = self.pair.turn().is_some();
        let open = |i: usize| solution.closed.get(if around { i % n } else { i }) == Some(&false);
        let before = |i: usize| (i > 0 || around) && open((i + n - 1) % n);
        let kept: Vec<bool> = (0..n).map(|i| solution.closed[i] && !open(i + 1) && !before(i)).collect();
        let lower = self.solve_in(&problem, &self.polynomials(&solution.closed, &kept));
        Ok(lower.map(|lower| self.inner_difference(&lower, &solution.pressure)))
    }

    /// Columns of the pressures of one degree less on the edges that are in contact all over (by `closed`), and of single points elsewhere, as far
    /// as they are `kept`.
    fn polynomials(&self, closed: &[bool], kept: &[bool]) -> Mat<f64> {
        let n = self.unit.points.len();
        let trace = self.pair.trace();
        let mut columns: Vec<Vec<(usize, f64)>> = Vec::new();
        // Hat of each break point and of each point of an edge that is open in part, then the bubbles.
        let mut hats: Vec<Vec<(usize, f64)>> = (0..n).map(|i| if kept[i] { vec![(i, 1.0)] } else { Vec::new() }).collect();
        for (edge, of) in trace.edges.iter().enumerate() {
            let range = self.edge_points(edge);
            if !range.clone().all(|i| closed[i % n]) {
                continue;
            }
            let (start, end) = (*range.start(), *range.end());
            let place = |i: usize| self.unit.points.get(i).map_or(trace.length(), |point| point.arc);
            let (low, high) = (place(start), place(end));
            let degree = of.degree.saturating_sub(1).max(1);
            for i in start + 1..end {
                hats[i].clear();
                let t = 2.0 * (self.unit.points[i].arc - low) / (high - low) - 1.0;
                hats[start].push((i, 0.5 * (1.0 - t)));
                hats[end % n].push((i, 0.5 * (1.0 + t)));
            }
            for k in 2..=degree {
                let bubble = |i: usize| {
                    let t = 2.0 * (self.unit.points[i].arc - low) / (high - low) - 1.0;
                    let values = hpfem::legendre(k, t);
                    values[k] - values[k - 2]
                };
                columns.push((start + 1..end).map(|i| (i, bubble(i))).collect());
            }
        }
        columns.extend(hats.into_iter().filter(|hat| !hat.is_empty()));
        let mut all = Mat::zeros(n, columns.len());
        columns.iter().enumerate().for_each(|(j, column)| column.iter().for_each(|(i, v)| all[(*i, j)] += v));
        all
    }

    /// Pressure `P q` whose openings are orthogonal to the columns of `P`, with the balance of the rigid motions.
    fn solve_in(&self, problem: &Complementarity<'_>, columns: &Mat<f64>) -> Option<Vec<f64>> {
        let (n, r, m) = (self.unit.points.len(), columns.ncols(), problem.load.len());
        let scaling = Scaling::new(problem);
        let forces = Mat::from_fn(n, r, |i, j| self.unit.points[i].weight * columns[(i, j)]);
        let compliance = forces.transpose() * &*problem.compliance * &forces;
        let (closing, balance) = (forces.transpose() * &problem.influence, forces.transpose() * &problem.balance);
        let size: Vec<f64> = (0..r).map(|j| 1.0 / compliance[(j, j)].sqrt()).collect();
        let matrix = Mat::from_fn(r + m, r + m, |i, j| match (i < r, j < r) {
            (true, true) => compliance[(i, j)] * size[i] * size[j],
            (true, false) => closing[(i, j - r)] * size[i] * scaling.unit[j - r],
            (false, true) => balance[(j, i - r)] * size[j] / scaling.resultant[i - r],
            (false, false) => -problem.stiffness[(i - r, j - r)] * scaling.unit[j - r] / scaling.resultant[i - r],
        });
        let opening = Mat::from_fn(n, 1, |i, _| problem.opening[i]);
        let known = forces.transpose() * opening;
        let right = Mat::from_fn(r + m, 1, |i, _| {
            if i < r { -known[(i, 0)] * size[i] } else { -problem.load[i - r] / scaling.resultant[i - r] }
        });
        let x = matrix.partial_piv_lu().solve(&right);
        let pressure: Vec<f64> = (0..n).map(|i| (0..r).map(|j| columns[(i, j)] * size[j] * x[(j, 0)]).sum()).collect();
        pressure.iter().all(|p| p.is_finite()).then_some(pressure)
    }

    /// `|a - b| / |b|` over the inner part of the surface.
    fn inner_difference(&self, a: &[f64], b: &[f64]) -> f64 {
        let length = self.pair.trace().length();
        let inner =
            |i: &usize| self.pair.turn().is_some() || (MARGIN..=1.0 - MARGIN).contains(&(self.unit.points[*i].arc / length));
        let sum = |f: &dyn Fn(usize) -> f64| -> f64 {
            (0..a.len()).filter(inner).map(|i| self.unit.points[i].weight * f(i).powi(2)).sum()
        };
        (sum(&|i| a[i] - b[i]) / sum(&|i| b[i])).sqrt()
    }
}
