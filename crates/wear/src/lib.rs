//! Wear rules, functionals and optimal pressures, without finite elements: a surface is points with position, normal, area weight,
//! sliding speed and drag direction.
//!
//! Theory, formulas with their equation numbers and corrections: see the README below. Units: N, mm, MPa, s, rad.

#![doc = include_str!("../README.md")]
#![warn(clippy::missing_errors_doc, clippy::wildcard_enum_match_arm)]

mod absolute;
mod answer;
mod balance;
mod bracket;
mod cells;
mod character;
mod condition;
mod continuation;
mod density;
mod error;
mod extremes;
mod functional;
mod given;
mod invert;
mod law;
mod lines;
mod mode;
mod motion;
mod newton;
mod objective;
mod optimum;
mod own_functional;
mod own_rule;
mod pair;
mod point;
mod pressure_law;
mod problem;
mod quadrature;
mod ratio;
mod recession;
mod reduce;
mod report;
mod resisted;
mod rule;
mod sensitivity;
mod simplex;
mod singular;
mod singular_report;
mod solve;
mod stage;
mod stationarity;
mod steady;
mod sums;
mod surface;
mod tracks;

pub use answer::{Character, Optimum, PointForce, Regime};
pub use error::WearError;
pub use functional::{Functional, FunctionalRow, Needs};
pub use given::Given;
pub use law::{WearLaw, wear_rate};
pub use mode::{Balance, Modes, RigidMode, RigidMotion};
pub use motion::SlidingMotion;
pub use objective::functional_value;
pub use optimum::{optimal_pressure, stationary_pressures};
pub use own_functional::OwnFunctional;
pub use own_rule::OwnRule;
pub use pair::WearPair;
pub use point::SurfacePoint;
pub use problem::{Counterface, Problem};
pub use resisted::resisted_pressure;
pub use rule::{LocalRule, Rule};
pub use sensitivity::{Sensitivity, one_percent};
pub use singular::{LimitSide, singular_limit};
pub use surface::{Shape, Surface};
