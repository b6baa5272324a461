//! What is kept between questions.

use std::collections::BTreeMap;

use wearshape::{Bodies, Problem, Solution};

use crate::outside;

/// The bodies that were factorised, what was solved last, and the files that scenes may name.
pub(crate) struct Engine {
    pub(crate) bodies: Bodies,
    pub(crate) solved: Option<(Problem, Solution)>,
    pub(crate) files: BTreeMap<String, Vec<u8>>,
}

impl Default for Engine {
    fn default() -> Self {
        outside::listen_to_faults();
        Engine { bodies: Bodies::default(), solved: None, files: BTreeMap::new() }
    }
}

impl Engine {
    /// The bytes of a file that a scene names: a page has no folders, so that the last part of a path counts.
    pub(crate) fn file(&self, path: &str) -> Result<Vec<u8>, String> {
        let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
        self.files
            .get(name)
            .cloned()
            .ok_or_else(|| format!("the page has no file `{name}`: choose it under \"Files of the scene\", or drop it here"))
    }
}
