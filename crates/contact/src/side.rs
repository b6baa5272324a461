//! The two bodies of a contact.

/// Which of the two bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Body 1, the shaped body (shoe, punch).
    Shaped,
    /// Body 2, the counter-face (drum, plate, disc).
    Counter,
}

impl Side {
    /// The other body.
    pub fn other(self) -> Side {
        match self {
            Side::Shaped => Side::Counter,
            Side::Counter => Side::Shaped,
        }
    }

    pub(crate) fn words(self) -> &'static str {
        match self {
            Side::Shaped => "shaped body",
            Side::Counter => "counter-face",
        }
    }
}
