//! Two modes by the direction of their multipliers, the whole turn searched.
//!
//! f = lambda . phi closes the same points whatever the length of lambda, so that for two modes one angle is left: that at which the
//! resultant int psi p dS points along the load. Newton's method looks for it among the lambda with lambda . F > 0, where it is as long as
//! psi = phi. Where friction bends (psi != phi, kinematic modes) lambda may point anywhere.

use crate::WearError;
use crate::balance::Balanced;
use crate::bracket::Bracket;
use crate::cells::{BEYOND, is_beyond};
use crate::density::Density;
use crate::pressure_law::Node;
use crate::singular;
use crate::stage::Stage;
use crate::sums::sums;
use crate::why::{BOUNDED, Why, none};

/// Directions of the first search, over the whole turn.
const DIRECTIONS: usize = 360;
/// Directions tried on either side of the middle of a range that closes, graded towards its ends.
const TRIES: i32 = 80;
/// Ratio of the distances of successive directions from an end, as a logarithm.
const GRADING: f64 = 0.4;
/// Largest relative residual of a balance.
const BALANCED: f64 = 1e-10;
/// Largest relative difference of what an absolute law carries from the load: steep laws know it less well than its direction.
const SIZED: f64 = 1e-8;
/// Part of the load that is missing where a wear rule is at its bound.
const SHORT: f64 = 1e-6;
/// Part of f at which a pressure that grows towards f = 0 is a force on the edge.
const AT_THE_EDGE: f64 = 1e-3;
const NO_MOTION: Why = none("the friction holds body 1: no rigid motion of it wears the surface under this load (jammed)");

/// Whether an error of Newton's method may be one of its way, not of the load.
pub(crate) fn may_help(stage: &Stage<'_>, error: &WearError) -> bool {
    if stage.law.count != 2 || matches!(stage.law.density, Density::Exponential) {
        return false;
    }
    match error {
        WearError::NotConverged { .. } => stage.bends() || stage.law.density.front_exponent() >= 0.0,
        WearError::Infeasible { .. } | WearError::Unresolved { .. } => stage.bends() && singular::carries(stage),
        WearError::EmptySurface { .. }
        | WearError::MixedExponents { .. }
        | WearError::Modes { .. }
        | WearError::NoWear { .. }
        | WearError::OutOfRange { .. }
        | WearError::OwnRule { .. }
        | WearError::TooSteep { .. } => false,
    }
}

/// Balances two modes. Absolute laws and densities that know no common factor are scaled at every direction.
pub(crate) fn balance_by_turning(stage: &mut Stage<'_>, nodes: &mut Vec<Node>) -> Result<Balanced, WearError> {
    stage.law.absolute |= !stage.law.density.scale_free();
    let everywhere = stage.law.density.front_exponent() < 0.0;
    let mut turn = Turn { stage, nodes, everywhere, tried: 0, bounded: false };
    let mut last = WearError::NotConverged { iterations: 0, residual: f64::INFINITY };
    let mut found = false;
    for range in turn.ranges() {
        for root in turn.roots(range) {
            match turn.balanced(root) {
                Some(Ok(balanced)) => return Ok(balanced),
                Some(Err(error)) => (last, found) = (error, true),
                None => {}
            }
        }
    }
    turn.stage.affordable()?;
    Err(if found { last } else { turn.stage.infeasible(NO_MOTION) })
}

struct Turn<'a, 'b> {
    stage: &'a mut Stage<'b>,
    nodes: &'a mut Vec<Node>,
    /// Whether every point has to close (s < 1), not only some.
    everywhere: bool,
    tried: usize,
    /// Whether the scale of the last direction ends where a wear rule is at its bound.
    bounded: bool,
}

/// The resultant of a pressure relative to the load: cosine and sine of the angle between them, and the logarithm of their ratio.
#[derive(Clone, Copy)]
struct Resultant {
    along: f64,
    across: f64,
    log_size: f64,
}

impl Turn<'_, '_> {
    /// The mode beside the pivot.
    fn other(&self) -> usize {
        1 - self.stage.law.pivot
    }

    /// lambda = (cos, sin) in the scaled modes, the pivot first.
    fn set(&mut self, angle: f64) {
        let (sine, cosine) = angle.sin_cos();
        let other = self.other();
        let law = &mut self.stage.law;
        let level = cosine + law.ratio[other] * sine;
        law.side = if level < 0.0 { -1.0 } else { 1.0 };
        law.y[other] = sine / level.abs().max(f64::EPSILON * f64::EPSILON);
    }

    /// Whether some point closes; for s < 1 whether all do.
    fn closes(&mut self, angle: f64) -> bool {
        self.set(angle);
        let law = &self.stage.law;
        let (mut some, mut all) = (false, true);
        self.stage.problem.surface.survey(&mut |point| {
            let closes = law.force_function(point, &law.mode_values(point)).0 > 0.0;
            (some, all) = (some || closes, all && closes);
        });
        if self.everywhere { all } else { some }
    }

    /// Ranges of directions in which points close.
    fn ranges(&mut self) -> Vec<[f64; 2]> {
        let step = std::f64::consts::TAU / DIRECTIONS as f64;
        // Off the axes, where a mode alone may close nothing but the last bit.
        let at = |i: usize| (i as f64 + 0.5) * step;
        let closes: Vec<bool> = (0..DIRECTIONS).map(|i| self.closes(at(i))).collect();
        let Some(open) = closes.iter().position(|closes| !closes) else {
            return vec![[at(0), at(DIRECTIONS)]];
        };
        let mut ranges = Vec::new();
        let mut first = None;
        for i in open..=open + DIRECTIONS {
            match (closes[i % DIRECTIONS], first) {
                (true, None) => first = Some(self.border(at(i), at(i - 1))),
                (false, Some(from)) => {
                    ranges.push([from, self.border(at(i - 1), at(i))]);
                    first = None;
                }
                _ => {}
            }
        }
        ranges
    }

    /// The last direction that closes between one that does and one that does not.
    fn border(&mut self, mut inside: f64, mut outside: f64) -> f64 {
        for _ in 0..60 {
            let middle = 0.5 * (inside + outside);
            if self.closes(middle) { inside = middle } else { outside = middle }
        }
        inside
    }

    /// Directions in which the resultant lies along the load or against it.
    fn roots(&mut self, [lo, hi]: [f64; 2]) -> Vec<f64> {
        let place = |i: i32| {
            let off = (hi - lo) / (1.0 + (GRADING * f64::from(i.abs())).exp());
            if i < 0 { lo + off } else { hi - off }
        };
        let mut roots = Vec::new();
        let mut before: Option<(f64, f64)> = None;
        for angle in (-TRIES..=TRIES).map(place) {
            let found = self.resultant(angle).map(|found| (angle, found.across));
            if let (Some((a, value_a)), Some((b, value_b))) = (before, found)
                && (value_a > 0.0) != (value_b > 0.0)
            {
                roots.push(self.refined(Bracket { a, value_a, b, value_b }));
            }
            before = found;
        }
        roots
    }

    fn refined(&mut self, mut root: Bracket) -> f64 {
        for _ in 0..100 {
            if root.value_b == 0.0 || (root.b - root.a).abs() <= f64::EPSILON * root.b.abs() {
                break;
            }
            let c = root.next();
            let Some(found) = self.resultant(c) else { break };
            root.take(c, found.across);
        }
        if root.value_a.abs() < root.value_b.abs() { root.a } else { root.b }
    }

    /// The balance at a direction; none where the resultant points against the load.
    fn balanced(&mut self, angle: f64) -> Option<Result<Balanced, WearError>> {
        let found = self.resultant(angle)?;
        if found.along <= 0.0 {
            return None;
        }
        // What an absolute law carries has a size of its own.
        let missed = if self.stage.law.absolute { found.log_size.exp_m1() } else { 0.0 };
        if missed < -SHORT && self.bounded {
            return Some(Err(self.stage.infeasible(BOUNDED)));
        }
        let residual = if missed.abs() > SIZED { missed.abs() } else { found.across.abs() };
        if residual > BALANCED {
            return Some(Err(WearError::NotConverged { iterations: self.tried, residual }));
        }
        if self.stage.may_lack_function(self.stage.law.density.front_exponent()) && self.stage.closeness(self.nodes) < AT_THE_EDGE
        {
            return None;
        }
        let log_scale = if self.stage.law.absolute { self.stage.law.log_scale } else { -found.log_size };
        Some(Ok(Balanced { log_scale, iterations: self.tried, residual }))
    }

    /// The resultant at a direction, an absolute law scaled so that it is as large as the load; none where nothing carries or nothing
    /// scales.
    fn resultant(&mut self, angle: f64) -> Option<Resultant> {
        self.tried += 1;
        self.set(angle);
        if !self.stage.law.absolute {
            return self.measured();
        }
        let mut root = self.scales()?;
        for _ in 0..100 {
            if root.value_b == 0.0 || (root.b - root.a).abs() <= 1e-15 * root.b.abs().max(1.0) {
                break;
            }
            let beyond = root.value_a.max(root.value_b) >= 0.5 * BEYOND;
            let c = if beyond { 0.5 * (root.a + root.b) } else { root.next() };
            let value = self.size_at(c);
            root.take(c, value);
        }
        self.bounded = self.size_at(root.a.max(root.b)) >= BEYOND;
        self.size_at(if self.bounded { root.a.min(root.b) } else { root.b });
        self.measured()
    }

    /// Two scales between which the resultant becomes as large as the load.
    fn scales(&mut self) -> Option<Bracket> {
        let b = self.stage.law.log_scale;
        let mut bracket = Bracket { a: b, value_a: 0.0, b, value_b: self.size_at(b) };
        let mut step = 0.1;
        while step < 2000.0 {
            (bracket.a, bracket.value_a) = (bracket.b, bracket.value_b);
            bracket.b -= step * bracket.value_b.signum();
            bracket.value_b = self.size_at(bracket.b);
            if (bracket.value_a > 0.0) != (bracket.value_b > 0.0) {
                return Some(bracket);
            }
            step *= 2.0;
        }
        self.stage.law.log_scale = b;
        None
    }

    /// Logarithm of the resultant over the load at a scale; as good as none where nothing is carried.
    fn size_at(&mut self, scale: f64) -> f64 {
        self.stage.law.log_scale = scale;
        if matches!(self.stage.law.density, Density::Receding { .. }) {
            self.stage.settle_recession(self.nodes);
        }
        let size = self.measured().map_or(-700.0, |found| found.log_size);
        if is_beyond(self.nodes) { BEYOND } else { size }
    }

    /// The resultant of the present law.
    fn measured(&mut self) -> Option<Resultant> {
        if !self.stage.collect_within_reason(self.nodes) {
            return None;
        }
        let total = sums(self.stage, self.nodes);
        let (pivot, other) = (self.stage.law.pivot, self.other());
        let load = [self.stage.law.resultant(pivot), self.stage.law.resultant(other)];
        let force = [total.force[pivot], total.force[other]];
        let (carried, wanted) = (force[0].hypot(force[1]), load[0].hypot(load[1]));
        if !(carried > 0.0 && carried.is_finite()) {
            return None;
        }
        let along = (force[0] * load[0] + force[1] * load[1]) / (carried * wanted);
        let across = (force[1] * load[0] - force[0] * load[1]) / (carried * wanted);
        Some(Resultant { along, across, log_size: (carried / wanted).ln() + total.shift })
    }
}
