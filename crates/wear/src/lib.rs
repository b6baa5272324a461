//! Wear rules, functionals and optimal pressures, without finite elements: a surface is points with position, normal, area weight,
//! sliding speed and drag direction.
//!
//! Theory, formulas with their equation numbers and corrections: see the README below. Units: N, mm, MPa, s, rad.

#![doc = include_str!("../README.md")]

mod absolute;
mod cells;
mod character;
mod continuation;
mod counterface;
mod density;
mod durability;
mod error;
mod extremes;
mod functional;
mod law;
mod lines;
mod mode;
mod motion;
mod objective;
mod optimum;
mod point;
mod problem;
mod quadrature;
mod ratio;
mod recession;
mod reduce;
mod report;
mod rule;
mod sensitivity;
mod simplex;
mod singular;
mod solve;
mod stage;
mod steady;
mod surface;
mod workspace;

pub use continuation::optima_over_q;
pub use counterface::{Counterface, counterface_depth, counterface_depth_from_feed};
pub use durability::{distance_to_depth, time_to_depth};
pub use error::WearError;
pub use functional::Functional;
pub use law::{WearLaw, WearPair, log_wear_rate, wear_rate, wear_rate_curvature, wear_rate_slope, wear_rate_speed_slope};
pub use mode::{Balance, MAX_MODES, Modes, RigidMode, RigidMotion};
pub use motion::SlidingMotion;
pub use objective::{functional_curvature, functional_gradient, functional_value};
pub use optimum::{Character, Optimum, PointForce, Regime, optimal_pressure, optimal_pressure_with, stationary_pressures};
pub use point::SurfacePoint;
pub use problem::Problem;
pub use rule::{WearRule, steady_pressure_of_rule};
pub use sensitivity::{Parameter, Sensitivity, sensitivity};
pub use singular::{LimitSide, singular_limit};
pub use surface::{Shape, Surface};
pub use workspace::Workspace;
