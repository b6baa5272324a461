//! One implicit stage of wear: pressures `p >= 0` and openings `o >= 0`, `p o = 0`, with
//! `o = known + A W p + step w'(p) + Psi y` and the balance of the free coordinates.
//!
//! The unknown is the normal map `u = sigma p + step w'(p) - o` (Robinson 1992) with `sigma = A_ii W_i`: positive in contact, negative in
//! the open. Pressure is a function `p(u)` with a slope between 0 and `1 / sigma` whatever the exponent of the wear rule, so the problem
//! `known + (A W - sigma) p(u) + Psi y + u = 0` is piecewise smooth without infinite slopes, from a contact problem without wear
//! (`step = 0`, where Newton's method is the primal-dual active set method) to wear alone.

use crate::gap_rate::GapRate;
use crate::pace::Pace;
use crate::packed_lu::PackedLu;
pub(crate) use crate::stage_contact::Contact;
use contact::ContactSystem;
use faer::Mat;
use std::borrow::Cow;

/// A load stage prepared for implicit steps: one load, or several that act by turns and are averaged. Of these each has contact points of its own, one load
/// after the other, on the gap at the same places; gaps and errors of gaps have one value a place, the rest one a point.
pub(crate) struct Load<'a> {
    pub(crate) system: Cow<'a, ContactSystem>,
    pub(crate) rate: GapRate,
    pub(crate) weights: Vec<f64>,
    /// `A_ii W_i`.
    sigma: Vec<f64>,
    /// Coordinates that move some point by 1.
    unit: Vec<f64>,
    /// Whether the contact grows, so that points come into it in numbers.
    growing: bool,
}

/// A solved stage with its last linearisation.
pub(crate) struct Solved {
    pub(crate) contact: Contact,
    pub(crate) linear: Linear,
    pub(crate) iterations: usize,
}

/// An iteration that does not settle.
#[derive(Debug, Default)]
pub(crate) struct Unsettled {
    /// Points that still enter and leave the contact.
    pub(crate) points: Vec<usize>,
}

/// The linearised problem on the points in contact.
pub(crate) struct Linear {
    /// Length of the implicit step.
    step: f64,
    active: Vec<usize>,
    /// `dp/du` on the active points.
    slope: Vec<f64>,
    /// Factors by which the balance rows are divided.
    row: Vec<f64>,
    factor: PackedLu,
}

/// A stage to be solved.
struct Stage<'k> {
    /// Gap without the wear of this stage.
    known: &'k [f64],
    step: f64,
}

/// Where Newton's method stands.
struct Iterate {
    contact: Contact,
    /// Recession of the counter-face within the stage.
    recession: f64,
    /// The normal map.
    u: Vec<f64>,
    /// Pressure and slope at points where they are known already for this normal map.
    known: Vec<Option<(f64, f64)>>,
    /// Newton steps so far, this one counted.
    steps: usize,
    pace: Pace,
    /// The fewest points that a step has moved into the contact or out of it.
    fewest: usize,
}

/// What a Newton step has changed.
struct Update {
    /// Pressure after the step.
    pressure: Vec<f64>,
    /// Largest change of the normal map at an active point: relative, absolute, and what it is measured by.
    relative: f64,
    absolute: f64,
    size: f64,
    /// Points that have entered or left the contact.
    changed: Vec<usize>,
}

impl<'a> Load<'a> {
    pub(crate) fn new(system: Cow<'a, ContactSystem>, rate: GapRate, weights: Vec<f64>) -> Load<'a> {
        let n = weights.len();
        let diagonal: Vec<f64> = (0..n).map(|i| system.compliance[(i, i)].abs()).collect();
        let largest = diagonal.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let sigma = (0..n).map(|i| weights[i] * diagonal[i].max(1e-14 * largest)).collect();
        let unit = (0..system.load.len())
            .map(|j| (0..n).map(|i| system.influence[(i, j)].abs()).fold(0.0, f64::max))
            .map(|size| if size > 0.0 { 1.0 / size } else { 1.0 })
            .collect();
        Load { system, rate, weights, sigma, unit, growing: false }
    }

    /// The same of a contact that may grow.
    pub(crate) fn growing(self, growing: bool) -> Load<'a> {
        Load { growing, ..self }
    }

    /// `A f` with `f = W p`.
    pub(crate) fn elastic(&self, pressure: &[f64]) -> Vec<f64> {
        let mut opening = vec![0.0; pressure.len()];
        for (j, p) in pressure.iter().enumerate().filter(|(_, p)| **p != 0.0) {
            let f = p * self.weights[j];
            self.system.compliance.col_as_slice(j).iter().zip(&mut opening).for_each(|(a, o)| *o += a * f);
        }
        opening
    }

    /// `load + B^T f - K y`.
    fn imbalance(&self, contact: &Contact) -> Vec<f64> {
        let system = &self.system;
        (0..system.load.len())
            .map(|j| {
                let contacts: f64 =
                    (0..self.weights.len()).map(|i| system.balance[(i, j)] * self.weights[i] * contact.pressure[i]).sum();
                let springs: f64 = (0..system.load.len()).map(|k| system.stiffness[(j, k)] * contact.coordinates[k]).sum();
                system.load[j] + contacts - springs
            })
            .collect()
    }

    /// Solves the contact on a gap, from a start that may be of another load: from every point just in contact where that leads nowhere.
    pub(crate) fn solve_anyhow(&self, gap: &[f64], start: &Contact) -> Option<Solved> {
        let n = self.weights.len();
        let free = self.system.load.len();
        let all = || Contact { pressure: vec![0.0; n], opening: vec![-f64::MIN_POSITIVE; n], coordinates: vec![0.0; free] };
        let from = |start: &Contact, pace: Pace| self.solve_within(&Stage { known: gap, step: 0.0 }, start, None, pace);
        from(start, Pace::Bold).or_else(|_| from(&all(), Pace::Patient)).ok()
    }

    /// Solves a stage. `known` is the gap without the wear of this stage.
    pub(crate) fn solve(&self, known: &[f64], step: f64, start: &Contact) -> Result<Solved, Unsettled> {
        self.solve_after(known, step, start, None)
    }

    /// The same after another stage, whose factors serve as long as they are the same.
    pub(crate) fn solve_after(
        &self,
        known: &[f64],
        step: f64,
        start: &Contact,
        before: Option<Linear>,
    ) -> Result<Solved, Unsettled> {
        let stage = Stage { known, step };
        match self.solve_within(&stage, start, before, Pace::Bold) {
            Err(unsettled) if self.growing && !unsettled.points.is_empty() => {
                self.solve_within(&stage, start, None, Pace::Careful)
            }
            done => done,
        }
    }

    /// The same at one pace.
    fn solve_within(
        &self,
        stage: &Stage<'_>,
        start: &Contact,
        mut before: Option<Linear>,
        pace: Pace,
    ) -> Result<Solved, Unsettled> {
        let (n, step) = (self.weights.len(), stage.step);
        let linear_rate = step == 0.0 || (self.rate.is_linear());
        let contact = start.clone();
        let recession = step * self.rate.recession(&contact.pressure);
        let u: Vec<f64> = (0..n)
            .map(|i| self.sigma[i] * contact.pressure[i] + step * self.rate.local(i, contact.pressure[i]) - contact.opening[i])
            .collect();
        let mut at = Iterate { contact, recession, u, known: vec![None; n], steps: 0, pace, fewest: usize::MAX };
        let mut relative_before = f64::INFINITY;
        let mut unsettled = Unsettled::default();
        for iteration in 1..=pace.limit(n) {
            let (pressure, slope): (Vec<f64>, Vec<f64>) = (0..n)
                .map(|i| match at.known[i] {
                    _ if at.u[i] <= 0.0 => (0.0, 0.0),
                    Some(known) => known,
                    None => self.rate.inverse(i, self.sigma[i], step, at.u[i]),
                })
                .unzip();
            (at.contact.pressure, at.steps) = (pressure, iteration);
            let active: Vec<usize> = (0..n).filter(|i| at.u[*i] > 0.0).collect();
            let same = before.take().filter(|linear| linear_rate && linear.fits(step, &active, &slope));
            let linear =
                same.or_else(|| self.linearise(step, &at.contact.pressure, active, &slope)).ok_or_else(Unsettled::default)?;
            let change = linear.solve(self.right(stage, &at, &linear.active)).ok_or_else(Unsettled::default)?;
            let update = self.update(stage, &mut at, &linear, &change).ok_or_else(Unsettled::default)?;
            // The error after this step is the square of the change before it, down to round-off.
            let round_off = update.absolute <= 1e-11 * update.size && update.relative > 0.5 * relative_before;
            let settled = update.changed.is_empty() && (linear_rate || update.relative < 1e-7 || round_off);
            relative_before = update.relative;
            if settled {
                let mut contact = at.contact;
                contact.pressure = update.pressure;
                contact.opening = at.u.iter().map(|v| (-v).max(0.0)).collect();
                return Ok(Solved { contact, linear, iterations: iteration });
            }
            let away = self.growing && pace.gives_up(update.changed.len(), at.fewest, n);
            unsettled.points = update.changed;
            if away {
                break;
            }
        }
        Err(unsettled)
    }

    /// Takes a Newton step, in which one point alone enters or leaves the contact where the pace asks for it. `None` if the step leads out of all numbers.
    fn update(&self, stage: &Stage<'_>, at: &mut Iterate, linear: &Linear, change: &[f64]) -> Option<Update> {
        let (n, step) = (self.weights.len(), stage.step);
        let (active, a) = (&linear.active, linear.active.len());
        let (u, contact) = (&at.u, &mut at.contact);
        let mut next = u.clone();
        let (mut relative, mut absolute) = (0.0_f64, 0.0_f64);
        let size = u.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        for (k, i) in active.iter().enumerate() {
            next[*i] = u[*i] + change[k];
            relative = relative.max(change[k].abs() / u[*i].abs());
            absolute = absolute.max(change[k].abs());
        }
        for j in 0..contact.coordinates.len() {
            contact.coordinates[j] += change[a + j] * self.unit[j];
        }
        if self.recedes(step) {
            at.recession += change[a + contact.coordinates.len()];
        }
        // Points in the open follow from the new pressures.
        let pressed = |i: usize| next[i] > 0.0 && u[i] > 0.0;
        at.known = (0..n).map(|i| pressed(i).then(|| self.rate.inverse(i, self.sigma[i], step, next[i]))).collect();
        let pressure: Vec<f64> = at.known.iter().map(|known| known.map_or(0.0, |(pressure, _)| pressure)).collect();
        let open: Vec<usize> = (0..n).filter(|i| u[*i] <= 0.0).collect();
        let mut spreading = pressure.clone();
        if at.pace == Pace::Careful {
            // Those that pull too, so that each step solves the contact on its points exactly.
            active.iter().enumerate().for_each(|(k, i)| spreading[*i] = contact.pressure[*i] + linear.slope[k] * change[k]);
        }
        let elastic = if open.is_empty() { Vec::new() } else { self.spread(step, &spreading) };
        for i in open {
            let rigid = self.rigid(i, &contact.coordinates);
            next[i] = -(stage.known[i % self.rate.places()] + self.system.opening[i] + elastic[i] + rigid + at.recession);
        }
        if !next.iter().all(|v| v.is_finite()) {
            return None;
        }
        // A step that opens the whole contact goes too far: the half of it that it opens least stays.
        if next.iter().filter(|v| **v > 0.0).count() < self.unit.len().max(1) {
            let mut least = active.clone();
            least.sort_by(|i, j| next[*j].total_cmp(&next[*i]));
            for i in least.into_iter().take(active.len() / 2) {
                next[i] = next[i].max(f64::MIN_POSITIVE.max(1e-12 * u[i]));
                at.known[i] = None;
            }
        }
        let changed: Vec<usize> = (0..n).filter(|i| (next[*i] > 0.0) != (u[*i] > 0.0)).collect();
        let single = at.pace.is_single(at.steps, changed.len(), at.fewest);
        at.fewest = at.fewest.min(changed.len());
        if let (true, Some(only)) = (single, changed.last()) {
            for i in changed.iter().copied().filter(|i| i != only) {
                next[i] = if u[i] > 0.0 { f64::MIN_POSITIVE.max(1e-12 * u[i]) } else { 0.0 };
                at.known[i] = None;
            }
        }
        at.u = next;
        Some(Update { pressure, relative, absolute, size, changed })
    }

    /// Right-hand side of a Newton step: openings of the active points, balance of the coordinates, and recession of the counter-face.
    fn right(&self, stage: &Stage<'_>, at: &Iterate, active: &[usize]) -> Vec<f64> {
        let (now, recession) = (&at.contact, at.recession);
        let elastic = self.spread(stage.step, &now.pressure);
        let residual = |i: usize| {
            stage.known[i % self.rate.places()]
                + self.system.opening[i]
                + elastic[i]
                + self.rigid(i, &now.coordinates)
                + recession
                - self.sigma[i] * now.pressure[i]
        };
        let mut right: Vec<f64> = active.iter().map(|i| -at.u[*i] - residual(*i)).collect();
        right.extend(self.imbalance(now).iter().map(|r| -r));
        if self.recedes(stage.step) {
            right.push(stage.step * self.rate.recession(&now.pressure) - recession);
        }
        right
    }

    /// What pressures open at other points too: the elastic opening, and in a step the groove or the wear under the other loads.
    fn spread(&self, step: f64, pressure: &[f64]) -> Vec<f64> {
        let mut opening = self.elastic(pressure);
        let elsewhere = if step > 0.0 { self.rate.elsewhere(pressure) } else { None };
        elsewhere.iter().for_each(|elsewhere| opening.iter_mut().zip(elsewhere).for_each(|(o, g)| *o += step * g));
        opening
    }

    /// Whether the counter-face recedes in a step.
    fn recedes(&self, step: f64) -> bool {
        self.rate.recedes() && step > 0.0
    }

    fn rigid(&self, i: usize, coordinates: &[f64]) -> f64 {
        coordinates.iter().enumerate().map(|(j, y)| self.system.influence[(i, j)] * y).sum()
    }

    /// Factorises `[I + (A W - sigma) D, Psi, 1; B^T W D, -K, 0; -dR/dp D, 0, 1]` on the active points.
    fn linearise(&self, step: f64, pressure: &[f64], active: Vec<usize>, slope: &[f64]) -> Option<Linear> {
        let recedes = self.recedes(step);
        let (a, m) = (active.len(), self.unit.len());
        let size = a + m + usize::from(recedes);
        if a < m.min(1) || size == 0 {
            return None;
        }
        let mut matrix = Mat::zeros(size, size);
        for (c, j) in active.iter().enumerate() {
            let scale = self.weights[*j] * slope[*j];
            let column = self.system.compliance.col_as_slice(*j);
            matrix.col_as_slice_mut(c).iter_mut().zip(&active).for_each(|(value, i)| *value = column[*i] * scale);
            if let Some((groove, rate)) = self.rate.groove_slope(*j, pressure[*j]).filter(|_| step > 0.0) {
                let rows = matrix.col_as_slice_mut(c).iter_mut().zip(&active);
                rows.for_each(|(value, i)| *value += step * (rate * groove[*i]) * slope[*j]);
            }
            let worn = 1.0 - self.sigma[*j] * slope[*j];
            matrix[(c, c)] += worn;
            if step > 0.0 && self.rate.turns() {
                let same = self.rate.at_place(j % self.rate.places()).filter(|i| i != j);
                same.filter_map(|i| active.binary_search(&i).ok()).for_each(|r| matrix[(r, c)] += worn);
            }
            (0..m).for_each(|r| matrix[(a + r, c)] = self.system.balance[(*j, r)] * scale);
            (0..m).for_each(|r| matrix[(c, a + r)] = self.system.influence[(*j, r)] * self.unit[r]);
            if recedes {
                matrix[(c, a + m)] = 1.0;
                matrix[(a + m, c)] = -step * self.rate.recession_slope(*j, pressure[*j]) * slope[*j];
            }
        }
        for r in 0..m {
            (0..m).for_each(|c| matrix[(a + r, a + c)] = -self.system.stiffness[(r, c)] * self.unit[c]);
        }
        if recedes {
            matrix[(a + m, a + m)] = 1.0;
        }
        let mut row = Vec::new();
        for r in 0..m {
            let largest = (0..size).map(|c| matrix[(a + r, c)].abs()).fold(0.0, f64::max);
            if !(largest > 0.0 && largest.is_finite()) {
                return None;
            }
            (0..size).for_each(|c| matrix[(a + r, c)] /= largest);
            row.push(largest);
        }
        let slope = active.iter().map(|i| slope[*i]).collect();
        Some(Linear { step, active, slope, row, factor: PackedLu::new(matrix) })
    }

    /// Filters an error of the gap through the stage: what is left of it after an implicit step, and the error of the pressure that
    /// belongs to it.
    pub(crate) fn filter(&self, linear: &Linear, error: &[f64]) -> Option<(Vec<f64>, Vec<f64>)> {
        let size = linear.factor.size();
        let mut right = vec![0.0; size];
        let places = error.len();
        linear.active.iter().enumerate().for_each(|(k, i)| right[k] = -error[*i % places]);
        let change = linear.solve_scaled(right)?;
        let recession = if size > linear.active.len() + self.unit.len() { change[size - 1] } else { 0.0 };
        let mut gap: Vec<f64> = error.iter().map(|e| e + recession).collect();
        let mut pressure = vec![0.0; self.weights.len()];
        for (k, i) in linear.active.iter().enumerate() {
            pressure[*i] = linear.slope[k] * change[k];
            gap[*i % places] += (1.0 - self.sigma[*i] * linear.slope[k]) * change[k];
        }
        Some((gap, pressure))
    }
}

impl Linear {
    /// Whether a step of linear rates has this matrix.
    fn fits(&self, step: f64, active: &[usize], slope: &[f64]) -> bool {
        let same = |(i, own): (&usize, &f64)| *own == slope[*i];
        self.step == step && self.active == active && self.active.iter().zip(&self.slope).all(same)
    }

    fn solve(&self, mut right: Vec<f64>) -> Option<Vec<f64>> {
        let a = self.active.len();
        self.row.iter().enumerate().for_each(|(r, s)| right[a + r] /= s);
        self.solve_scaled(right)
    }

    fn solve_scaled(&self, mut right: Vec<f64>) -> Option<Vec<f64>> {
        self.factor.solve(&mut right);
        right.iter().all(|v| v.is_finite()).then_some(right)
    }
}
