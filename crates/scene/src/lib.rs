#![doc = include_str!("../README.md")]

mod builtin;
mod counterface;
mod document;
mod fault;
mod flags;
mod gap;
mod gap_sum;
mod geometry;
mod hash;
mod heat;
mod known;
mod layer;
mod material;
mod numbers;
mod optimum;
mod output;
mod point_shape;
mod read;
mod reversing;
mod scene;
#[cfg(feature = "schema")]
mod schema;
mod spin;
mod support;
mod tree;
mod units;
mod value;
mod visible;
mod wear_function;
mod write;
mod written;

pub use builtin::{Builtin, SCENES, builtin};
pub use document::Document;
pub use fault::{Fault, Place, Spot, did_you_mean};
pub use gap::{Gap, Until};
pub use gap_sum::{Cosine, GapSum, Rows};
pub use geometry::{
    ArcShape, Blocks, CellShape, CurveShape, DiscPad, EllipticPunch, Geometry, HalfDisc, JournalArc, MeshFile, PinnedShoe,
    PivotedShoe, Rectangle, RectangularPunch, Ring, RingSegment, ShoeBlock, SplineShape, SurfaceShape,
};
pub use hash::sha256;
pub use heat::{EdgeHeat, Heat};
pub use known::{KnownMaterial, known_materials};
pub use layer::Layer;
pub use material::Material;
pub use numbers::{number_text, short, with_short_numbers};
pub use point_shape::{PointShape, PolarPoint};
pub use reversing::{Cycle, Reversing};
pub use scene::{
    Balance, Body, Contact, Counterface, FieldPath, Functional, Kinematics, Load, LoadKind, Mesh, Modes, Optimum, Output, Scene,
    Schedule, Sliding, Task, Units, Wear,
};
pub use spin::Spin;
pub use support::{Component, Support};
pub use units::{
    Acceleration, Angle, AngularSpeed, Axes, Conductance, Conductivity, Density, Expansion, Force, Frequency, HeatFlux,
    HeatTransfer, Length, Moment, Pair, Pressure, Scale, Speed, Steps, Temperature, Time, Volume, WearFactor,
};
pub use value::{missing, positive};
pub use visible::{acts, bounded, visible};
pub use wear_function::WearFunction;
pub use write::scene_text;
pub use written::{Written, rewritten, written};
