#![doc = include_str!("../README.md")]

mod blocks;
mod cells;
mod coarse;
mod contact_line;
mod couple;
mod cuts;
mod extent;
mod given;
mod gmsh_file;
mod half_disc;
mod ledge;
mod line;
mod matching;
mod meshes;
mod names;
mod near_ends;
mod outline;
mod placing;
mod read;
mod round_cells;
mod sound;
mod template;

pub use blocks::unused as unused_in_blocks;
pub use coarse::RATIO;
pub use contact_line::contact_line;
pub use couple::{Body, Couple, LoadedEdge, Strip};
pub use extent::{Cut, Extent};
pub use given::{Files, Given};
pub use half_disc::{CANDIDATE, HalfDiscOnFlat};
pub use line::ContactLine;
pub use meshes::{CoarseMeshes, coarse_meshes, meshes};
pub use names::{AXIS, CONTACT, LOAD};
pub use outline::{Edge, Outline, outline, outside};
pub use read::read_cells;
pub use sound::{sound, sound_material};
