//! One case, one name: data/scenes/X.toml, data/reference/X.json, fn X() here.
