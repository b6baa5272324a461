//! The tube of hpfem's front page for WebAssembly: one function by name, no glue. `tube.mjs` calls it.

#[path = "../../../crates/hpfem/examples/thick_cylinder.rs"]
mod thick_cylinder;

/// Radial displacement of the bore at a degree; NaN where there is none.
#[unsafe(no_mangle)]
pub extern "C" fn bore_displacement(degree: u32) -> f64 {
    thick_cylinder::bore_displacement(degree as usize).unwrap_or(f64::NAN)
}
