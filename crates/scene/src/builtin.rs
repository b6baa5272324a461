//! The scenes that come with the program.

/// A scene in the program itself.
pub struct Builtin {
    /// Its name, and that of its file without the ending.
    pub name: &'static str,
    /// The text of the file.
    pub text: &'static str,
}

impl Builtin {
    /// Its title: what the file says after `title =`.
    pub fn title(&self) -> &'static str {
        let line = self.text.lines().find(|line| line.starts_with("title = "));
        line.and_then(|line| line.split('"').nth(1)).unwrap_or("")
    }

    /// Its file in messages.
    pub fn file(&self) -> String {
        format!("{}.toml (built in)", self.name)
    }
}

macro_rules! scenes {
    ($($name:literal),* $(,)?) => {
        [$(Builtin { name: $name, text: include_str!(concat!("../scenes/", $name, ".toml")) }),*]
    };
}

/// All built-in scenes.
pub const SCENES: [Builtin; 26] = scenes![
    "drum-brake-block",
    "drum-brake-ring",
    "lining-on-back",
    "drum-brake-hot",
    "internal-shoe",
    "pinned-shoe-elastic",
    "translating-punch",
    "punch-wear",
    "trapezoidal-punch",
    "annular-punch",
    "clutch-hot",
    "reciprocating-pad",
    "hertz-cylinder",
    "hertz-sphere",
    "cattaneo-mindlin",
    "bushing",
    "knee",
    "journal",
    "cam",
    "pin-on-disc",
    "disc-pad",
    "pinned-shoe",
    "pivoted-shoe",
    "rectangular-punch",
    "elliptic-punch",
    "journal-arc",
];

/// The built-in scene of a name.
pub fn builtin(name: &str) -> Option<&'static Builtin> {
    SCENES.iter().find(|scene| scene.name == name)
}
