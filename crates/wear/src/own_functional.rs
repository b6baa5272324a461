//! A functional given as a function.

use std::fmt;
use std::sync::Arc;

use crate::WearError;

/// Density with its first and second derivative by the pressure, from pressure (MPa), sliding speed (mm/s) and friction coefficient.
type Density = dyn Fn(f64, f64, f64) -> [f64; 3] + Send + Sync;

/// A functional J = int X(p, v, mu) dS of one's own, for both bodies together.
///
/// X must be convex in the pressure: dX/dp is zero up to some pressure p0 >= 0, continuous, and grows from there without bound, as in X = p^s
/// with s > 1. Its stationary pressure, dX/dp = f = sum lambda_k phi_k, is then the minimum of J under the load (with associated modes, or
/// where friction does not bend the balance). A [`Problem`](crate::Problem) is refused where one of the three is no number, looked for at 1e-3, 1 and
/// 1e3 MPa with the speeds of the surface that slides. Two functionals are equal if one is a clone of the other.
#[derive(Clone)]
pub struct OwnFunctional {
    density: Arc<Density>,
}

impl OwnFunctional {
    /// The functional of a function `density(pressure, sliding_speed, friction)` that gives `[X, dX/dp, d2X/dp2]` in any unit per mm^2 from MPa
    /// and mm/s. It is called at pressures above 0 only.
    pub fn new(density: impl Fn(f64, f64, f64) -> [f64; 3] + Send + Sync + 'static) -> OwnFunctional {
        OwnFunctional { density: Arc::new(density) }
    }

    /// Refuses densities and derivatives that are no numbers, at a few pressures (MPa).
    pub(crate) fn check_numbers(&self, sliding_speed: f64, friction: f64) -> Result<(), WearError> {
        let all = [-3, 0, 3].map(|decade| self.at(10_f64.powi(decade), sliding_speed, friction));
        let name = "density of a functional given as a function, or one of its derivatives";
        let wrong = all.into_iter().flatten().find(|value| value.is_nan());
        wrong.map_or(Ok(()), |value| Err(WearError::OutOfRange { name, value, wanted: "finite" }))
    }

    /// `[X, dX/dp, d2X/dp2]` at a pressure above 0.
    pub(crate) fn at(&self, pressure: f64, sliding_speed: f64, friction: f64) -> [f64; 3] {
        (self.density)(pressure, sliding_speed, friction)
    }
}

impl fmt::Debug for OwnFunctional {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("OwnFunctional(..)")
    }
}

impl PartialEq for OwnFunctional {
    fn eq(&self, other: &OwnFunctional) -> bool {
        std::ptr::addr_eq(Arc::as_ptr(&self.density), Arc::as_ptr(&other.density))
    }
}
