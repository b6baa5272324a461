//! A contact with its heat, found on bodies bent by the heat of its pressure.

use contact::{ContactLoad, ContactOperator, ContactSolution, SharedHeat};
use scene::Fault;

use crate::faults::unsolved;
use crate::steps::heat::following::Following;
use crate::steps::heat::known::PointHeat;
use crate::steps::heat::warmed::into_bodies;

/// Contact solves until the points that conduct are those in contact, and how many of them in which points may begin to conduct.
const ROUNDS: usize = 60;
const FREE: usize = 10;

/// Sets of points in contact, which conduct, before both are looked for one by one.
const TOGETHER: usize = 20;

/// Steps of the sliding speed from the cold bodies to the hot ones.
const STEPS: u32 = 16;

/// Relative L2 difference of pressures up to which they are those of one contact. Where part of the surface touches without a pressure, what conducts there follows
/// every error: a punch beyond its kern had .07, the narrow contact of a brake 1.07.
const ALIKE: f64 = 0.2;

/// Part of the points that touch first.
const NEAREST: usize = 8;

/// A contact with its heat.
pub(crate) struct Hot {
    pub found: ContactSolution,
    pub heat: PointHeat,
    /// The load of the last solve.
    pub load: ContactLoad,
    /// Where the contact of the cold bodies was lost as the sliding speed grew; none where there is an answer.
    pub lost: Option<Lost>,
}

/// A contact that was followed from the cold bodies and lost on its mesh.
pub(crate) struct Lost {
    /// Part of the sliding speed.
    pub at: f64,
}

impl Hot {
    /// A contact with the heat that its forces make at these rates (mm/s).
    fn new(found: ContactSolution, load: ContactLoad, (shared, rates): (&SharedHeat, &[f64])) -> Hot {
        let friction: Vec<f64> = rates.iter().zip(&found.nodal_force).map(|(rate, force)| rate * force.max(0.0)).collect();
        let into = into_bodies(shared, &friction);
        Hot { heat: PointHeat { friction, into }, found, load, lost: None }
    }
}

impl Lost {
    /// Why there is no contact.
    pub(super) fn words(&self) -> String {
        let part = if self.at < 1.0 { format!("{} of ", scene::short(self.at)) } else { String::new() };
        let what = "frictional heat narrows the contact, and none was found that carries the load";
        format!("{what}: that of the cold bodies could not be followed to {part}the sliding speed; slide more slowly")
    }
}

impl Following<'_> {
    /// The contact from one that is near on the same points, or as [`Following::solve`] finds it.
    pub(crate) fn solve_from(
        &self,
        operator: &ContactOperator<'_>,
        gap: &[f64],
        base: &ContactLoad,
        near: &ContactSolution,
    ) -> Result<Hot, Fault> {
        let hot = self.settled(operator, gap, base, 1.0, Some(near))?;
        if hot.found.status.is_solved() { Ok(hot) } else { self.solve(operator, gap, base) }
    }

    /// The contact of the bodies that grows from that of the cold ones: between surfaces with a gap heat may close more of it, so that there are several, and
    /// the one that touches everywhere is none to begin with. `base` holds the load without heat.
    pub(crate) fn grown(&self, operator: &ContactOperator<'_>, gap: &[f64], base: &ContactLoad) -> Result<Hot, Fault> {
        if gap.iter().any(|gap| *gap != 0.0) {
            let cold = self.settled(operator, gap, base, 0.0, None)?;
            if cold.found.status.is_solved() {
                let hot = self.settled(operator, gap, base, 1.0, Some(&cold.found))?;
                if self.is_grown(operator, base, &hot)? {
                    return Ok(hot);
                }
            }
        }
        self.solve(operator, gap, base)
    }

    /// The contact that grows from that of the cold bodies, where it is another one than that of these pressures at the points (MPa); `base` holds the load
    /// without heat. Where heat lets some points that are nearest grow into the known contact, the cold bodies are not asked.
    pub(crate) fn another(
        &self,
        operator: &ContactOperator<'_>,
        gap: &[f64],
        base: &ContactLoad,
        known: &[f64],
    ) -> Result<Option<Hot>, Fault> {
        let weights = || operator.points().iter().map(|point| point.weight);
        let squares = |of: &dyn Fn(usize) -> f64| weights().enumerate().map(|(i, weight)| weight * of(i).powi(2)).sum::<f64>();
        let is_known =
            |found: &ContactSolution| squares(&|i| found.pressure[i] - known[i]) <= ALIKE.powi(2) * squares(&|i| known[i]);
        let few = self.together(operator, gap, base, (1.0, nearest(gap)))?;
        if few.is_some_and(|few| is_known(&few)) {
            return Ok(None);
        }
        let grown = self.grown(operator, gap, base)?;
        Ok(Some(grown).filter(|grown| !is_known(&grown.found)))
    }

    /// The contact of the bodies, pressure and temperature at once: `base` holds the load without heat. What is not found so is followed from the
    /// contact of the cold bodies on, the sliding speed growing.
    pub(crate) fn solve(&self, operator: &ContactOperator<'_>, gap: &[f64], base: &ContactLoad) -> Result<Hot, Fault> {
        let at_once = self.settled(operator, gap, base, 1.0, None)?;
        if self.is_grown(operator, base, &at_once)? {
            return Ok(at_once);
        }
        let mut found: Option<ContactSolution> = None;
        for step in 1..=STEPS {
            let speed = f64::from(step) / f64::from(STEPS);
            let hot = self.settled(operator, gap, base, speed, found.as_ref())?;
            // Where signs do not tell a contact, nor do they lead on to the next one.
            if !hot.found.status.is_solved() || hot.found.closes_itself {
                return Ok(Hot { lost: Some(Lost { at: speed }), ..at_once });
            }
            if step == STEPS {
                return Ok(hot);
            }
            found = Some(hot.found);
        }
        Ok(at_once)
    }

    /// Whether there is a contact, and it has grown from the cold bodies: where each point is closed further by its own heat than its pressure opens it, no
    /// part of the speed may be singular on its points.
    fn is_grown(&self, operator: &ContactOperator<'_>, base: &ContactLoad, Hot { found, .. }: &Hot) -> Result<bool, Fault> {
        if !found.status.is_solved() || !found.closes_itself {
            return Ok(found.status.is_solved());
        }
        let factors = self.factors(operator, base, &found.closed)?;
        Ok(factors.singular.first().is_none_or(|first| *first > 1.0))
    }

    /// The contact at a factor on the sliding speed, from a contact that is near.
    pub(crate) fn settled(
        &self,
        operator: &ContactOperator<'_>,
        gap: &[f64],
        base: &ContactLoad,
        speed: f64,
        near: Option<&ContactSolution>,
    ) -> Result<Hot, Fault> {
        let together = |from: Vec<bool>| self.together(operator, gap, base, (speed, from));
        let mut last = match near {
            Some(near) => Some(together(near.closed.clone())?.unwrap_or_else(|| near.clone())),
            None => None,
        };
        let mut closed = last.as_ref().map_or_else(|| vec![true; gap.len()], |near| near.closed.clone());
        for round in 0..ROUNDS {
            let shared = self.shared(&closed)?;
            let rates = self.rates(speed);
            let load = self.load(base, &shared, &rates);
            let found = operator.solve(gap, &load, last.as_ref()).map_err(unsolved)?;
            // Surfaces that touch everywhere need no search.
            if round == 0
                && near.is_none()
                && !(found.closed == closed && found.status.is_solved())
                && let Some(held) = together(closed.clone())?
            {
                closed.clone_from(&held.closed);
                last = Some(held);
                continue;
            }
            // A point at an end of contact may open because it conducts and close because it does not: such points do not conduct.
            let late = round >= FREE && closed.iter().zip(&found.closed).all(|(conducts, closed)| *closed || !conducts);
            if late || found.closed == closed || !self.conducts() || !found.status.is_solved() {
                return Ok(Hot::new(found, load, (&shared, &rates)));
            }
            let kept = |(conducts, closed): (&bool, &bool)| *closed && (round < FREE || *conducts);
            closed = closed.iter().zip(&found.closed).map(kept).collect();
            last = Some(found);
        }
        let message = "the points that conduct heat and those in contact do not settle on each other";
        Err(Fault::at("heat.conductance", "not-converged", message, "give heat.share, or another gap"))
    }

    /// The contact whose points in contact are those that conduct, from some that are: points with tension leave, points that overlap enter, all at once
    /// (primal-dual active sets; Hintermueller, Ito and Kunisch, SIAM J. Optim. 13, 2002, 865-888). None where that does not settle.
    fn together(
        &self,
        operator: &ContactOperator<'_>,
        gap: &[f64],
        base: &ContactLoad,
        (speed, mut closed): (f64, Vec<bool>),
    ) -> Result<Option<ContactSolution>, Fault> {
        for _ in 0..TOGETHER {
            let Some(Hot { found: held, .. }) = self.held(operator, gap, base, (speed, &closed))? else { return Ok(None) };
            let pushed = |i: usize| if closed[i] { held.nodal_force[i] >= 0.0 } else { held.opening[i] < 0.0 };
            let next: Vec<bool> = (0..gap.len()).map(pushed).collect();
            if next == closed {
                return Ok(Some(held));
            }
            closed = next;
        }
        Ok(None)
    }

    /// The contact at a factor on the sliding speed with these points held in contact, pressure and temperature at once, whatever the signs; none where
    /// they cannot hold the bodies.
    pub(crate) fn held(
        &self,
        operator: &ContactOperator<'_>,
        gap: &[f64],
        base: &ContactLoad,
        (speed, closed): (f64, &[bool]),
    ) -> Result<Option<Hot>, Fault> {
        let (shared, rates) = (self.shared(closed)?, self.rates(speed));
        let load = self.load(base, &shared, &rates);
        let found = operator.solve_on(gap, &load, closed).map_err(unsolved)?;
        Ok(found.map(|found| Hot::new(found, load, (&shared, &rates))))
    }
}

/// The points where a gap is least, a part of all.
fn nearest(gap: &[f64]) -> Vec<bool> {
    let mut order: Vec<usize> = (0..gap.len()).collect();
    order.sort_by(|i, j| gap[*i].total_cmp(&gap[*j]));
    let mut closed = vec![false; gap.len()];
    order.iter().take(gap.len().div_ceil(NEAREST)).for_each(|i| closed[*i] = true);
    closed
}
