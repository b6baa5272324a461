//! A page that is not of the repository.

/// A page that is made.
pub(super) struct Made {
    pub title: String,
    pub path: String,
    pub text: String,
}
