#![no_main]
//! No bytes make the gmsh reader panic. Start from the files in tests/meshes: `cargo fuzz run gmsh tests/meshes`.

use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let _ = hpfem::GmshMesh::read(bytes);
});
