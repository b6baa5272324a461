//! What a sweep keeps of its points: rows in a file that grows, curves in another, and the few figures that a person looks at.

pub(crate) mod curves;
pub(crate) mod drawn;
pub(crate) mod figures;
pub(crate) mod rows;
