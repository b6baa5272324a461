//! wearshape: see the library.

fn main() {}
