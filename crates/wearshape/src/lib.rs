#![doc = include_str!("../README.md")]

mod bodies;
mod body_field;
mod brake;
mod effort;
mod error_result;
mod faults;
mod fixed;
mod forecast;
mod freedom;
mod functional;
mod gap;
mod gap_profile;
mod held;
mod hindsight;
mod holding;
mod ladder;
mod level;
mod load;
mod machined;
mod machining;
mod machining_result;
mod one_way;
mod options;
mod outlines;
mod parts;
mod plan;
mod problem;
mod profile;
mod remark;
mod results;
mod reversing_result;
mod scope;
mod series;
mod setup;
mod solution;
mod solve;
mod stage;
mod step;
mod steps;
mod study;
mod surface;
mod watch;
mod words;

pub use hpfem::{CellGrid, Stress};
pub use meshing::Files;
pub use scene::{Builtin, Document, Fault, Place, SCENES, Spot, Task, builtin};
pub use shapeopt::{Measure, WearState};

pub use bodies::Bodies;
pub use body_field::{BodyField, CellField, FieldFrame};
pub use brake::{BrakeResult, Sense, SupportForce};
pub use effort::{Clock, Counters, Effort};
pub use forecast::Forecast;
pub use functional::functional_row;
pub use holding::{HeldBy, Holding};
pub use machined::{Machined, SurfacePoint};
pub use machining_result::MachiningResult;
pub use options::{CURVE, Options, Sampling};
pub use outlines::{Area, BodyOutline};
pub use plan::{Plan, Stage};
pub use problem::Problem;
pub use profile::Profile;
pub use remark::Remark;
pub use results::{
    ByRole, ContactResult, EnergyResult, ErrorResult, InterfaceResult, LifeResult, PointForce, PressureResult, Reaction,
    RunLifeResult, SensitivityResult, Settled, ShapeResult, ToleranceResult, TurnsResult, TwistResult, UniquenessResult,
    WearResult,
};
pub use reversing_result::{ReversingResult, SenseResult};
pub use solution::{PressureMap, Rung, RunningIn, RunningInStep, Solution, Status};
pub use solve::solve;
pub use step::Step;
pub use study::{DEGREES, Level as StudyLevel, Quantity, Truth, outermost, study};
pub use watch::{Event, FinishedLevel, Resume, RunLevel, Watch, WearStep};
pub use wear::{OwnRule, Shape};
pub use words::{Character, ContactStatus, PointStatus, Regime, TwistStatus, Uniqueness, WearStatus, word};
