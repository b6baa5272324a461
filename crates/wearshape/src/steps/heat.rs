//! Frictional heat of two bodies that touch: temperatures by the heat of the contact, and the bodies that they bend.

pub(crate) mod bodies;
pub(crate) mod boundary;
pub(crate) mod branched;
pub(crate) mod conduction;
pub(crate) mod contact;
pub(crate) mod continued;
pub(crate) mod deviations;
pub(crate) mod drum;
pub(crate) mod fields;
pub(crate) mod following;
pub(crate) mod hot;
pub(crate) mod known;
pub(crate) mod report;
pub(crate) mod running;
pub(crate) mod smooth;
pub(crate) mod warmed;
