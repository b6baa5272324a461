#![doc = include_str!("../README.md")]

mod curves;
mod dxf;
mod escape;
mod field_picture;
mod files;
mod isobands;
mod json;
mod line_plot;
mod machined;
mod missed;
mod one_percent;
mod page;
mod page_tables;
mod run_in;
mod section_plot;
mod summary;
mod table;
mod terminal;
mod tolerance;
mod verdict;
mod vtu;

pub use curves::abscissa;
pub use files::files;
pub use isobands::{Isobands, Placed};
pub use json::{SCHEMA_VERSION, pretty};
pub use line_plot::{Axis, LinePlot, Series, line_plot};
pub use page::page;
pub use section_plot::Section;
pub use summary::{numbers, summary};
pub use table::{column, columns_csv, numbers_row, table};
pub use terminal::first_screen;
