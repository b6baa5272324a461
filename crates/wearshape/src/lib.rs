#![doc = include_str!("../README.md")]

mod bodies;
mod body_field;
mod cell_grid;
mod effort;
mod forecast;
mod freedom;
mod functional;
mod gap_profile;
mod ladder;
mod level;
mod machined;
mod options;
mod parts;
mod plan;
mod problem;
mod profile;
mod remarks;
mod scope;
mod setup;
mod solution;
mod solve;
mod stage;
mod steps;
mod study;
mod surface;
mod watch;

pub use meshing::Files;
pub use scene::{Builtin, Document, Fault, Place, SCENES, Spot, Task, builtin};
pub use shapeopt::{Measure, WearState};

pub use bodies::Bodies;
pub use body_field::{BodyField, CellField, FieldFrame};
pub use cell_grid::CellGrid;
pub use effort::{Clock, Counters, Effort};
pub use forecast::Forecast;
pub use machined::{Machined, SurfacePoint};
pub use options::{CURVE, Options, Sampling};
pub use plan::{Plan, Stage, Step};
pub use problem::Problem;
pub use profile::Profile;
pub use remarks::Remark;
pub use solution::{
    ByRole, ContactResult, EnergyResult, ErrorResult, InterfaceResult, PointForce, PressureResult, Reaction, Rung, RunningIn,
    RunningInStep, Settled, ShapeResult, Solution, Status, ToleranceResult, TwistResult, UniquenessResult, WearResult,
};
pub use solve::solve;
pub use study::{DEGREES, Level as StudyLevel, Quantity, Truth, outermost, study};
pub use wear::Shape;

pub use watch::{Event, FinishedLevel, Resume, RunLevel, Watch, WearStep};
