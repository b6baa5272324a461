//! What one per cent more of each given number does, by differentiating the stationarity condition and the balance.
//!
//! With sum_i Q_i v^(A_i) p^(m_i) = f, f = lambda . phi - W2', and the shares t_i of the terms,
//!
//! ```text
//! d log p = (df / f - sum_i t_i (d log Q_i + d(A_i log v) + dm_i log p)) / sum_i t_i m_i      below the cap
//! d log p = d log p_max                                                                       at the cap
//! ```
//!
//! and the changes of lambda, of the ratio of two bodies' norms (q != 1) and of the recession W2' of a revolving counter-face follow from the
//! same number of linear equations: int (d psi_j + psi_j d log(p dS)) p dS = dF_j, the definition of Q_2/Q_1, that of W2'.

use nalgebra::{DMatrix, DVector};

use crate::answer::Optimum;
use crate::density::Density;
use crate::given::{Change, Given, times};
use crate::pressure_law::Node;
use crate::quadrature::graded;
use crate::stage::Stage;
use crate::stationarity::{Term, shares, terms};
use crate::{Balance, Counterface, Functional, Modes, Problem, Shape, wear_rate};

/// What one per cent more of a given number does to first order, in per cent.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Sensitivity {
    /// The number.
    pub given: Given,
    /// Of the wear rate: the rate at which wear opens the gap, mean over the surface; in the steady state under one force that of the feed.
    /// `None` where nothing wears.
    pub wear_rate: Option<f64>,
    /// Of the friction torque where body 2 turns, of the friction force where it translates; `None` without friction.
    pub torque: Option<f64>,
    /// Of the largest pressure, at its present place.
    pub p_max: f64,
}

/// Effect of one per cent more of each given number that is not zero, on `optimum`, the answer to `problem`.
///
/// Exact derivatives; where the largest pressure is reached at several places, that of one of them. `None` where the pressure has no derivative or is
/// no function: s = 1, several modes with q infinite or a uniform pressure, two wearing bodies with q infinite, a revolving counter-face that wears
/// under a sector, a wear rule or a functional of one's own.
pub fn one_percent(problem: &Problem, optimum: &Optimum) -> Option<Vec<Sensitivity>> {
    let system = System::new(problem, optimum)?;
    let lu = system.matrix().lu();
    let of = |given: Given| {
        let change = given.change(problem);
        let unknowns = lu.solve(&system.side(&change))?;
        Some(system.sensitivity(given, &change, &unknowns))
    };
    Given::all(problem).into_iter().filter(|given| system.defined(*given)).map(of).collect()
}

/// A point of the surface with what the change of its pressure is made of.
struct Place {
    node: Node,
    log_pressure: f64,
    log_speed: f64,
    /// Shares of the terms, and d log p by each unknown; empty where the pressure is zero or at the cap.
    shares: Vec<f64>,
    reach: Vec<f64>,
    capped: bool,
}

/// The linear equations for the changes of the multipliers (of the common factor where p = C v^-A) and of what else the pressure depends on.
struct System<'a> {
    problem: &'a Problem,
    optimum: &'a Optimum,
    /// Empty where p = C v^-A whatever f.
    terms: Vec<Term>,
    places: Vec<Place>,
    /// Whether Q_2/Q_1 depends on the pressure.
    ratio: bool,
    /// Whether body 2 recedes by its mean wear.
    recedes: bool,
}

impl<'a> System<'a> {
    fn new(problem: &'a Problem, optimum: &'a Optimum) -> Option<System<'a>> {
        if problem.wear.has_other() {
            return None;
        }
        let uniform = matches!(optimum.law.density, Density::Power { k: 0.0, .. });
        let (count, two) = (problem.modes.len(), problem.wear.powers().iter().all(|law| law.factor > 0.0));
        let of_wear = matches!(problem.functional, Functional::WearVolume | Functional::WearPower);
        let recedes = matches!(optimum.law.density, Density::Receding { .. });
        let excluded = uniform && (count > 1 || (two && of_wear)) || (recedes && optimum.law.recession.radii.is_some());
        if optimum.points.is_empty() || excluded {
            return None;
        }
        let terms = if uniform { Vec::new() } else { terms(problem, optimum)? };
        let ratio = terms.len() == 2 && of_wear && problem.q != 1.0;
        let mut system = System { problem, optimum, terms, places: Vec::new(), ratio, recedes };
        let mut stage = Stage::new(problem, optimum.law.density.clone()).ok()?;
        stage.law = optimum.law.clone();
        // Where contact ends inside the surface p has other powers of the distance than its derivatives.
        stage.front_rule = stage.front_rule.is_some().then(graded);
        let mut nodes = Vec::new();
        stage.collect(&mut nodes);
        system.places = nodes.into_iter().map(|node| system.place(node)).collect();
        Some(system)
    }

    /// Whether the answer has a derivative by the number: not by one exponent b of two bodies whose factors beta mu^b vanish with mu.
    fn defined(&self, given: Given) -> bool {
        let vanishing = self.problem.wear.friction_driven && self.problem.friction == 0.0;
        !(vanishing && self.terms.len() == 2 && matches!(given, Given::PressureExponent(_)))
    }

    fn unknowns(&self) -> usize {
        self.problem.modes.len() + usize::from(self.ratio) + usize::from(self.recedes)
    }

    fn place(&self, node: Node) -> Place {
        let log_pressure = self.optimum.law.log_pressure(&node);
        let log_speed = node.point.sliding_speed.ln();
        let capped = node.excess >= 0.0;
        let mut place = Place { node, log_pressure, log_speed, shares: Vec::new(), reach: vec![0.0; self.unknowns()], capped };
        if capped || log_pressure == f64::NEG_INFINITY {
            return place;
        }
        if self.terms.is_empty() {
            place.reach[0] = 1.0;
            return place;
        }
        place.shares = shares(&self.terms, log_pressure, log_speed);
        let m: f64 = self.terms.iter().zip(&place.shares).map(|(term, share)| share * term.m).sum();
        let count = self.problem.modes.len();
        (0..count).for_each(|k| place.reach[k] = place.node.modes.phi[k] / (place.node.f * m));
        if self.ratio {
            place.reach[count] = -place.shares[1] / m;
        }
        if self.recedes {
            place.reach[count] = -1.0 / (place.node.f * m);
        }
        place
    }

    /// d log p at a place with all unknowns unchanged.
    fn known(&self, place: &Place, change: &Change) -> f64 {
        if place.capped {
            return change.log_cap;
        }
        if place.log_pressure == f64::NEG_INFINITY {
            return 0.0;
        }
        if self.terms.is_empty() {
            return self.by_speed(place, change);
        }
        let own = self.terms.iter().zip(&place.shares);
        let m: f64 = own.clone().map(|(term, share)| share * term.m).sum();
        let resistance: f64 = own.map(|(term, share)| share * term.change(change, place.log_pressure, place.log_speed)).sum();
        let gauge = self.optimum.law.gauge_multipliers();
        let associated = self.problem.mode_kind == Modes::Associated;
        let bent = |k: usize| gauge[k] * self.optimum.law.scale[k] * self.bent(place, k, change);
        let force: f64 = if associated { (0..self.problem.modes.len()).map(bent).sum() } else { 0.0 };
        (force / place.node.f - resistance) / m
    }

    /// d log p of p = C v^(-a/e), q infinite.
    fn by_speed(&self, place: &Place, change: &Change) -> f64 {
        let body = usize::from(self.problem.wear.powers()[0].factor == 0.0 && self.problem.wear.powers()[1].factor > 0.0);
        let law = self.problem.wear.powers()[body];
        let (a, e) = (law.speed_exponent, self.problem.functional.pressure_power(law.pressure_exponent));
        match self.problem.functional {
            Functional::Uniform => 0.0,
            Functional::FrictionPower => -change.log_speed,
            Functional::WearVolume | Functional::WearPower | Functional::Steady | Functional::Own(_) => {
                let d_power = change.speed_exponents[body] / e - a / (e * e) * change.pressure_exponents[body];
                -times(d_power, place.log_speed) - a / e * change.log_speed
            }
        }
    }

    /// d psi_k by friction, in the scaled modes.
    fn bent(&self, place: &Place, k: usize, change: &Change) -> f64 {
        if self.problem.balance == Balance::Paper || !self.problem.shear_in_balance {
            return 0.0;
        }
        let point = &place.node.point;
        let displacement = self.problem.modes[k].motion.displacement(&point.position);
        -change.friction * point.drag.dot(&displacement) / self.optimum.law.scale[k]
    }

    /// Area weight and pressure of a place, N.
    fn force(&self, place: &Place) -> f64 {
        place.node.point.weight * place.log_pressure.exp()
    }

    /// Sum over the places of weights times (d log p by each unknown).
    fn sums(&self, weight: impl Fn(&Place) -> f64) -> Vec<f64> {
        let mut sums = vec![0.0; self.unknowns()];
        for place in &self.places {
            let weight = weight(place);
            sums.iter_mut().zip(&place.reach).for_each(|(sum, reach)| *sum += weight * reach);
        }
        sums
    }

    /// Weight of a place in the norm A_i of a term's body, and the norm's share: X_i^q dS / A_i.
    fn norm_weights(&self, term: &Term) -> Vec<f64> {
        let body = term.body.unwrap_or(0);
        let a = self.problem.wear.powers()[body].speed_exponent;
        let log = |place: &Place| (term.m + 1.0) * place.log_pressure + times(a * self.problem.q, place.log_speed);
        normalised(&self.places, log)
    }

    /// Weight of a place in the wear of body 2.
    fn wear_weights(&self) -> Vec<f64> {
        let law = self.problem.wear.powers()[1];
        normalised(&self.places, |place| law.pressure_exponent * place.log_pressure + times(law.speed_exponent, place.log_speed))
    }

    /// Recession of body 2 in the gauge of f.
    fn recession(&self) -> f64 {
        let law = &self.optimum.law;
        law.recession.at(&self.optimum.points[0]) * (-law.log_scale).exp()
    }

    fn matrix(&self) -> DMatrix<f64> {
        let (size, count) = (self.unknowns(), self.problem.modes.len());
        let mut matrix = DMatrix::<f64>::zeros(size, size);
        for j in 0..count {
            let row = self.sums(|place| self.force(place) * place.node.modes.psi[j]);
            row.iter().enumerate().for_each(|(l, value)| matrix[(j, l)] = *value);
        }
        let mut subtract = |factor: f64, weights: &[f64]| {
            for (place, weight) in self.places.iter().zip(weights) {
                (0..size).for_each(|l| matrix[(count, l)] -= factor * weight * place.reach[l]);
            }
        };
        if self.ratio {
            // x = (1 - q)/q (d log A_2 - d log A_1), d log A_i = q (... + e_i d log p).
            for (term, sign) in self.terms.iter().zip([-1.0, 1.0]) {
                let e = (term.m + 1.0) / self.problem.q;
                subtract(sign * (1.0 - self.problem.q) * e, &self.norm_weights(term));
            }
            matrix[(count, count)] += 1.0;
        } else if self.recedes {
            subtract(self.recession() * self.problem.wear.powers()[1].pressure_exponent, &self.wear_weights());
            matrix[(count, count)] += 1.0;
        }
        matrix
    }

    fn side(&self, change: &Change) -> DVector<f64> {
        let count = self.problem.modes.len();
        let known: Vec<f64> = self.places.iter().map(|place| self.known(place, change)).collect();
        let mut side = DVector::<f64>::zeros(self.unknowns());
        for j in 0..count {
            side[j] = change.resultants[j] / self.optimum.law.scale[j];
            for (place, known) in self.places.iter().zip(&known) {
                let psi = place.node.modes.psi[j];
                side[j] -= self.force(place) * (self.bent(place, j, change) + psi * (known + change.log_thickness));
            }
        }
        if self.ratio {
            for (term, sign) in self.terms.iter().zip([-1.0, 1.0]) {
                let (body, e) = (term.body.unwrap_or(0), (term.m + 1.0) / self.problem.q);
                for ((place, known), weight) in self.places.iter().zip(&known).zip(self.norm_weights(term)) {
                    let rate = change.log_rate(self.problem, body, place.log_pressure, place.log_speed);
                    side[count] += sign * (1.0 - self.problem.q) * weight * (rate + e * known);
                }
            }
        } else if self.recedes {
            let b = self.problem.wear.powers()[1].pressure_exponent;
            for ((place, known), weight) in self.places.iter().zip(&known).zip(self.wear_weights()) {
                let rate = change.log_rate(self.problem, 1, place.log_pressure, place.log_speed);
                side[count] += self.recession() * weight * (rate + b * known);
            }
        }
        side
    }

    fn sensitivity(&self, given: Given, change: &Change, unknowns: &DVector<f64>) -> Sensitivity {
        let log_pressure = |place: &Place| {
            let reached: f64 = place.reach.iter().zip(unknowns.iter()).map(|(reach, unknown)| reach * unknown).sum();
            self.known(place, change) + reached
        };
        let highest = self.place(self.optimum.law.node(self.optimum.highest));
        let changes: Vec<f64> = self.places.iter().map(log_pressure).collect();
        Sensitivity {
            given,
            wear_rate: self.wear_rate(change, &changes),
            torque: self.torque(change, &changes),
            p_max: log_pressure(&highest),
        }
    }

    /// Relative change of int p v dS mu / speed.
    fn torque(&self, change: &Change, log_pressures: &[f64]) -> Option<f64> {
        let power = |place: &Place| self.force(place) * place.node.point.sliding_speed;
        let swept: f64 = self.places.iter().map(power).sum();
        let changed: f64 = self.places.iter().zip(log_pressures).map(|(place, change)| power(place) * change).sum();
        let mu = self.problem.friction;
        (mu > 0.0 && swept > 0.0).then(|| change.friction / mu + changed / swept + change.log_thickness)
    }

    /// Relative change of the mean rate of the gap.
    fn wear_rate(&self, change: &Change, log_pressures: &[f64]) -> Option<f64> {
        let (mut whole, mut changed) = (0.0, 0.0);
        for (i, part) in [1.0, self.share_of_body2()].into_iter().enumerate().filter(|(i, _)| self.problem.wear.wears(*i)) {
            let law = self.problem.wear.powers()[i];
            let touching = self.places.iter().zip(log_pressures).filter(|(place, _)| place.log_pressure > f64::NEG_INFINITY);
            for (place, log_pressure) in touching {
                let point = &place.node.point;
                let rate = part * point.weight * wear_rate(&law, place.log_pressure.exp(), point.sliding_speed);
                let own = change.log_rate(self.problem, i, place.log_pressure, place.log_speed);
                whole += rate;
                changed += rate * (own + law.pressure_exponent * log_pressure);
            }
        }
        (whole > 0.0).then(|| changed / whole)
    }

    /// Part of body 2's wear volume by which the gap grows.
    fn share_of_body2(&self) -> f64 {
        let surface = &self.problem.surface;
        match (self.problem.counterface, surface.shape()) {
            (Counterface::Fresh, _) => 0.0,
            (Counterface::Congruent, _) | (Counterface::Revolving, Shape::Annulus { .. }) => 1.0,
            (Counterface::Revolving, Shape::Sector { angles, .. }) => (angles[1] - angles[0]) / std::f64::consts::TAU,
            (
                Counterface::Revolving,
                Shape::Points(_) | Shape::Arc { .. } | Shape::Strip { .. } | Shape::Rectangle { .. } | Shape::Ellipse { .. },
            ) => surface.track_area().map_or(0.0, |track| surface.area() / track),
        }
    }
}

/// Weights exp(log) dS of the places, divided by their sum.
fn normalised(places: &[Place], log: impl Fn(&Place) -> f64) -> Vec<f64> {
    let touching = |place: &&Place| place.log_pressure > f64::NEG_INFINITY;
    let largest = places.iter().filter(touching).map(&log).fold(f64::NEG_INFINITY, f64::max);
    let size = |place: &Place| if touching(&place) { place.node.point.weight * (log(place) - largest).exp() } else { 0.0 };
    let sum: f64 = places.iter().map(size).sum();
    places.iter().map(|place| size(place) / sum).collect()
}
