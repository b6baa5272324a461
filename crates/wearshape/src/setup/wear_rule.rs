//! The wear rule: factors, exponents, counter-face.

mod function;
mod table;

use scene::{Counterface, Fault, Functional, Pair, Scene, Task, Wear, WearFactor, missing};
use wear::{WearError, WearPair};

use crate::problem;
use crate::setup::{duty, threshold};
use crate::surface::{Patch, PatchKind};

/// Checks the wear rule and the sliding, and fills in their defaults.
pub(super) fn resolve(scene: &mut Scene, tasks: &[Task], patch: Option<&Patch>) -> Result<(), Fault> {
    let contact_only = tasks == [Task::Contact];
    let uniform = scene.optimum.as_ref().and_then(|optimum| optimum.functional) == Some(Functional::Uniform);
    let wants_wear = tasks.contains(&Task::Wear) || (!contact_only && !uniform);
    let friction = scene.contact.as_ref().and_then(|contact| contact.friction).unwrap_or(0.0);
    if scene.sliding.is_none() && (wants_wear || (!contact_only && friction > 0.0)) {
        let turning = patch.is_none_or(|patch| patch.kind != PatchKind::Plane);
        let example = if turning { "sliding = { omega = \"2.5 rad/s\" }" } else { "sliding = { speed = \"5 mm/s\" }" };
        return Err(missing("sliding", "wear needs sliding", example));
    }
    let Some(wear) = &mut scene.wear else {
        if wants_wear {
            return Err(missing("wear", "the wear rule is not given", "wear = { beta = 2e-4, a = 1, b = 1 }"));
        }
        return Ok(());
    };
    exponents(wear)?;
    if !wants_wear && !wear.has_rule() {
        return Ok(());
    }
    if !wear.is_function() {
        let name = factors(wear)?;
        if name == "beta" && friction == 0.0 && !contact_only {
            without_friction(wear, tasks)?;
        }
    }
    let two_wear = wear.wearing() == [true; 2];
    let sliding = scene.sliding.as_ref();
    let axisymmetric = scene.kinematics == Some(scene::Kinematics::Axisymmetric);
    let to_and_fro = axisymmetric && sliding.is_some_and(|sliding| sliding.cycle.is_some());
    let default = match patch.map(|patch| patch.kind) {
        // A ball.
        None if sliding.is_some_and(|sliding| sliding.track_radius.is_some()) => Counterface::Revolving,
        // A ball to and fro over a plate, in which it wears a groove.
        None if two_wear && to_and_fro => Counterface::Revolving,
        None if sliding.is_some_and(|sliding| sliding.speed.is_some()) => Counterface::Fresh,
        Some(PatchKind::Plane) => Counterface::Fresh,
        Some(PatchKind::Ring) => Counterface::Congruent,
        Some(PatchKind::Turning) => Counterface::Revolving,
        None if axisymmetric => Counterface::Congruent,
        None => Counterface::Fresh,
    };
    let counterface = *wear.counterface.get_or_insert(default);
    let steady = scene.optimum.as_ref().and_then(|optimum| optimum.functional).is_none_or(|wanted| wanted == Functional::Steady);
    let optimal = steady && two_wear && tasks.iter().any(|task| matches!(task, Task::Pressure | Task::Shape));
    if counterface == Counterface::Revolving {
        revolves(tasks.contains(&Task::Wear), optimal, patch)?;
    }
    if tasks.contains(&Task::Wear) {
        duty::end(scene, patch)?;
    }
    function::resolve(scene, tasks)
}

/// Refuses factors that vanish with the friction where nothing else is asked for, or where they leave open which body wears more.
fn without_friction(wear: &Wear, tasks: &[Task]) -> Result<(), Fault> {
    let remedy = "give Archard's factors without friction in them, as in wear.k = 1e-7, or contact.friction > 0";
    if tasks == [Task::Wear] {
        let message = "contact.friction = 0 with wear.beta means no wear, and wear is all that is asked for";
        return Err(Fault::at("contact.friction", "no-wear", message, remedy));
    }
    match wear.b {
        Some(Pair::Two([b1, b2])) if b1 != b2 && wear.wearing() == [true; 2] => {
            let message = format!("contact.friction = 0 with wear.beta leaves open which body wears more (b = [{b1}, {b2}])");
            Err(Fault::at("wear.beta", "no-wear", message, remedy))
        }
        _ => Ok(()),
    }
}

/// Refuses a counter-face that revolves without a track, where a run in time or a steady pressure asks for its mean wear.
fn revolves(wears: bool, optimal: bool, patch: Option<&Patch>) -> Result<(), Fault> {
    let closed = patch.is_none_or(|patch| patch.surface.track_area().is_some());
    // The tracks on a sector are circles about its centre.
    let tracked = closed || patch.is_some_and(|patch| matches!(patch.surface.shape(), wear::Shape::Sector { .. }));
    if (!wears || closed) && (!optimal || tracked) {
        return Ok(());
    }
    let message = "a revolving counter-face carries the contact along a closed track, and this surface has none";
    let remedy = "write \"fresh\" for a long plate, \"congruent\" where the same points always meet (ring on disc)";
    Err(Fault::at("wear.counterface", "wrong-value", message, remedy))
}

/// Checks the exponents and fills in their defaults.
fn exponents(wear: &mut Wear) -> Result<(), Fault> {
    let pair = |key: &str, given: Option<Pair<f64>>, lowest: f64, remedy: &str| {
        let (values, keys) = match given {
            None => ([1.0, 1.0], [key.to_string(), key.to_string()]),
            Some(Pair::One(value)) => ([value, value], [key.to_string(), key.to_string()]),
            Some(Pair::Two(values)) => (values, [format!("{key}.0"), format!("{key}.1")]),
        };
        for (value, key) in values.iter().zip(keys) {
            if !value.is_finite() || *value < lowest {
                return Err(Fault::at(key, "wrong-value", format!("the exponent {value} is out of range"), remedy));
            }
        }
        Ok(values)
    };
    let a = pair("wear.a", wear.a, 0.0, "give an exponent of the speed of 0 or more, as in a = 1")?;
    let b = pair("wear.b", wear.b, 1e-3, "give an exponent of the pressure greater than 0, as in b = 1")?;
    wear.a = Some(Pair::Two(a));
    wear.b = Some(Pair::Two(b));
    Ok(())
}

/// Checks the factors and fills in their default; gives their key.
fn factors(wear: &mut Wear) -> Result<&'static str, Fault> {
    let (name, given) = match (wear.beta, wear.k) {
        (Some(_), Some(_)) => {
            let message = "both `wear.beta` and `wear.k` are given";
            let remedy = "keep beta (w' = beta (mu p)^b v^a) or k (w' = k p^b v^a)";
            return Err(Fault::at("wear.k", "two-alternatives", message, remedy));
        }
        (Some(beta), None) => ("beta", beta),
        (None, Some(k)) => ("k", k),
        (None, None) => {
            return Err(missing("wear.beta", "no wear factor is given", "wear.beta = 2e-4 (or wear.k)"));
        }
    };
    let factors = match given {
        Pair::One(factor) => [factor, WearFactor::default()],
        Pair::Two(factors) => factors,
    };
    let Some(Pair::Two([a1, a2])) = wear.a else {
        return Ok(name);
    };
    let Some(Pair::Two([b1, b2])) = wear.b else {
        return Ok(name);
    };
    for (place, (factor, (a, b))) in factors.iter().zip([(a1, b1), (a2, b2)]).enumerate() {
        let key = if matches!(given, Pair::One(_)) { format!("wear.{name}") } else { format!("wear.{name}.{place}") };
        if factor.value < 0.0 {
            let message = format!("negative wear factor {}", factor.value);
            return Err(Fault::at(key, "wrong-value", message, "give a factor of 0 or more"));
        }
        if factor.has_unit && (a != 1.0 || b != 1.0) {
            let message = format!("a wear factor with a unit is for a = b = 1, and here a = {a}, b = {b}");
            return Err(Fault::at(key, "wrong-unit", message, "give the bare number in N, mm, s"));
        }
    }
    if factors.iter().all(|factor| factor.value == 0.0) {
        let message = "both wear factors are 0: nothing wears";
        return Err(Fault::at(format!("wear.{name}"), "no-wear", message, "give one of them a value greater than 0"));
    }
    let plain = factors.map(|factor| WearFactor { has_unit: false, ..factor });
    match name {
        "beta" => wear.beta = Some(Pair::Two(plain)),
        _ => wear.k = Some(Pair::Two(plain)),
    }
    Ok(name)
}

/// The rules of a resolved scene.
pub(super) fn numbers(scene: &Scene) -> problem::Wear {
    let friction = scene.contact.as_ref().and_then(|contact| contact.friction).unwrap_or(0.0);
    let laws = laws(scene.wear.as_ref(), friction).map(|pair| pair.above(threshold::numbers(scene)));
    let powers = laws.as_ref().ok().is_none_or(|pair| pair.rules.iter().all(|rule| rule.power().is_some()));
    problem::Wear {
        exponents: super::optimum::exponents(scene).into_iter().filter(|_| powers).collect(),
        laws,
        counterface: match scene.wear.as_ref().and_then(|wear| wear.counterface) {
            Some(Counterface::Congruent) => wear::Counterface::Congruent,
            Some(Counterface::Revolving) => wear::Counterface::Revolving,
            Some(Counterface::Fresh) | None => wear::Counterface::Fresh,
        },
        until: duty::until(scene),
        of_friction: scene.wear.as_ref().is_some_and(|wear| wear.beta.is_some()),
        wearable: duty::wearable(scene),
        own_rule: false,
    }
}

/// The wear rules of both bodies.
fn laws(rule: Option<&Wear>, friction: f64) -> Result<WearPair, WearError> {
    let Some(rule) = rule else {
        return Ok(WearPair::archard([0.0; 2], [1.0; 2], [1.0; 2]));
    };
    let pair = |given: Option<Pair<f64>>| match given {
        Some(Pair::Two(values)) => values,
        Some(Pair::One(value)) => [value, value],
        None => [1.0, 1.0],
    };
    let factors = |given: Pair<WearFactor>| match given {
        Pair::Two(values) => values.map(|factor| factor.value),
        Pair::One(factor) => [factor.value, 0.0],
    };
    if let Some(by_function) = function::pair(rule) {
        return Ok(by_function);
    }
    let (a, b) = (pair(rule.a), pair(rule.b));
    match (rule.k, rule.beta) {
        (Some(k), _) => Ok(WearPair::archard(factors(k), a, b)),
        (None, Some(beta)) => WearPair::from_beta(factors(beta), friction, a, b),
        (None, None) => Ok(WearPair::archard([0.0; 2], a, b)),
    }
}
