//! Optimal and steady pressures on points of one's own: the crate `wear`.

use std::sync::Arc;

use pyo3::prelude::*;
use wear::nalgebra::Vector3;
use wear::{Functional, Problem, RigidMode, RigidMotion, Surface, SurfacePoint, WearLaw};

use crate::array::Array;
use crate::fault::refused;

/// A problem in plain numbers.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Given {
    position: Vec<[f64; 3]>,
    normal: Vec<[f64; 3]>,
    weight: Vec<f64>,
    sliding_speed: Vec<f64>,
    drag: Vec<[f64; 3]>,
    /// Factor, speed exponent, pressure exponent of body 1.
    law: [f64; 3],
    friction: f64,
    functional: String,
    q: f64,
    modes: Vec<Mode>,
}

/// A rigid motion: the direction of a translation, or the axis of a rotation with a point of it, and the resultant.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Mode {
    direction: [f64; 3],
    about: Option<[f64; 3]>,
    resultant: f64,
}

impl From<Mode> for RigidMode {
    fn from(mode: Mode) -> RigidMode {
        let direction = Vector3::from(mode.direction);
        let motion = match mode.about {
            None => RigidMotion::Translation { direction },
            Some(about) => RigidMotion::Rotation { axis: direction, about: about.into() },
        };
        RigidMode { motion, resultant: mode.resultant }
    }
}

/// An optimal pressure and what follows from it.
#[pyclass(frozen, module = "wearshape._core")]
pub(crate) struct Optimum {
    found: Arc<wear::Optimum>,
}

/// The optimal pressure of a problem.
#[pyfunction]
pub(crate) fn optimal_pressure(py: Python<'_>, given: Given) -> PyResult<Optimum> {
    let remedy = "the words are told by help(wearshape.wear.optimal_pressure)";
    let functional = Functional::ALL.into_iter().find(|known| known.word() == given.functional);
    let functional =
        functional.ok_or_else(|| refused(py, "functional", format!("no functional is called {}", given.functional), remedy))?;
    let columns = given.position.iter().zip(&given.normal).zip(&given.weight).zip(&given.sliding_speed).zip(&given.drag);
    let points = columns.map(|((((position, normal), weight), sliding_speed), drag)| SurfacePoint {
        position: (*position).into(),
        normal: (*normal).into(),
        weight: *weight,
        sliding_speed: *sliding_speed,
        drag: (*drag).into(),
    });
    let surface =
        Surface::from_points(points.collect()).map_err(|error| refused(py, "surface", error, "give points with area"))?;
    let [factor, speed_exponent, pressure_exponent] = given.law;
    let law = WearLaw { factor, speed_exponent, pressure_exponent };
    let modes = given.modes.into_iter().map(RigidMode::from).collect();
    let problem = Problem { friction: given.friction, functional, q: given.q, ..Problem::new(surface, law, modes) };
    let found = py.detach(|| wear::optimal_pressure(&problem));
    let found = found.map_err(|error| refused(py, "pressure", error, "change load, exponents or points"))?;
    Ok(Optimum { found: Arc::new(found) })
}

#[pymethods]
impl Optimum {
    /// Pressure at the points (MPa).
    #[getter]
    fn pressure(&self) -> Array {
        Array::line(&self.found, |found| &found.pressure)
    }

    /// Multiplier of each mode.
    #[getter]
    fn multipliers(&self) -> Vec<f64> {
        self.found.multipliers.clone()
    }

    /// Rigid velocity of wear in each mode, mm/s or rad/s.
    #[getter]
    fn feed(&self) -> Option<Vec<f64>> {
        self.found.feed.clone()
    }

    /// Resultants that the modes carry, friction included.
    #[getter]
    fn resultants(&self) -> Vec<f64> {
        self.found.resultants.clone()
    }

    /// Regime and character, as the summary of a run has them.
    #[getter]
    fn words(&self) -> (String, String) {
        let words = (wearshape::Regime::from(self.found.regime), wearshape::Character::from(self.found.character));
        (wearshape::word(&words.0), wearshape::word(&words.1))
    }

    /// Numbers by name.
    #[getter]
    fn numbers(&self) -> Vec<(&'static str, Option<f64>)> {
        let found = &self.found;
        vec![
            ("p_min", Some(found.p_min)),
            ("p_max", Some(found.p_max)),
            ("p_mean", Some(found.p_mean)),
            ("normal_force", Some(found.normal_force)),
            ("wear_volume_rate", Some(found.wear_volume_rate)),
            ("friction_power", Some(found.friction_power)),
            ("wear_power", Some(found.wear_power)),
            ("torque", found.torque),
            ("steadiness_residual", found.steadiness_residual),
        ]
    }
}
