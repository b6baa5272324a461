//! p-version finite elements.
