//! Two folders of results side by side: the numbers of their summaries, the curves of their contact, the keys of their scenes.

pub(crate) mod contact;
pub(crate) mod scenes;
pub(crate) mod summaries;
