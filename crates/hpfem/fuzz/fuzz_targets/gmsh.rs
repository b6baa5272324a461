#![no_main]
//! No bytes make the gmsh reader panic.
//!
//! Needs no nightly compiler; in crates/hpfem, starting from sound files:
//!
//! ```text
//! mkdir -p fuzz/corpus/gmsh && cp tests/meshes/*.msh fuzz/corpus/gmsh
//! RUSTC_BOOTSTRAP=1 cargo fuzz run gmsh --sanitizer none -- -max_total_time=600 -max_len=8192
//! ```
//!
//! Inputs worth keeping (`cargo fuzz cmin`, short ones) are packed into tests/meshes/gmsh.corpus, each behind its length as four bytes, the
//! lowest first; a test of the crate replays them.

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let _ = hpfem::GmshMesh::read(bytes);
});
