//! A wear rule of the caller's own in place of the scene's.

use scene::{Fault, Functional, Task};
use wear::{Counterface, OwnRule, WearPair};

use crate::problem::Problem;
use crate::setup::remarks;
use crate::setup::tasks::word;

impl Problem {
    /// The problem with a wear rule of the caller's own in place of the scene's: body 1 wears by it, body 2 stays fresh, and pressure and shape
    /// are those of the steady state, `w'(p, v) = V . phi` where the rigid wear `V . phi` is positive, `p = 0` elsewhere.
    ///
    /// A load that leaves the whole surface below the threshold of the rule is refused by the solve. What needs powers of the pressure is left out
    /// of the solution: `s`, `k`, sensitivities.
    ///
    /// # Errors
    /// Tasks and functionals that a rule has no say in, or that need powers of the pressure: anything but the pressure of the steady state, its
    /// shape, and a contact beside them.
    pub fn with_wear_rule(&self, rule: OwnRule) -> Result<Problem, Fault> {
        let tasks = self.scene.tasks.clone().unwrap_or_default();
        if tasks.contains(&Task::Wear) {
            let message = format!("{} follows powers of the pressure, and no wear rule given as a function", word(Task::Wear));
            return Err(Fault::at("tasks", "not-available", message, "ask for tasks = [\"pressure\", \"shape\"]"));
        }
        if !tasks.contains(&Task::Pressure) && !tasks.contains(&Task::Shape) {
            let message = "no task asks for a pressure that a wear rule decides";
            return Err(Fault::at("tasks", "not-available", message, "ask for tasks = [\"pressure\"], or \"shape\" too"));
        }
        if self.optimum.functional != Functional::Steady {
            let message = "a wear rule given as a function has a steady state, and no other optimum";
            let remedy = "leave optimum.functional out, or write \"steady\"";
            return Err(Fault::at("optimum.functional", "not-available", message, remedy));
        }
        let mut problem = self.clone();
        problem.wear.own_rule = true;
        problem.wear.laws = Ok(WearPair::alone(rule));
        problem.wear.exponents = Vec::new();
        problem.wear.counterface = Counterface::Fresh;
        problem.wear.of_friction = false;
        problem.remarks = remarks::remarks(&problem, &tasks);
        Ok(problem)
    }
}
