//! Random scenes: built-in ones with other sizes, materials and friction.

/// A generator of numbers (Steele, Lea and Flood 2014, splitmix).
pub(super) struct Random(u64);

impl Random {
    /// The numbers of a seed.
    pub(super) fn new(seed: u64) -> Random {
        Random(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Evenly between two numbers.
    fn within(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Evenly in the logarithm.
    fn scale(&mut self, from: f64, to: f64) -> f64 {
        self.within(from.ln(), to.ln()).exp()
    }

    /// A whole number below another.
    fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }
}

/// A random scene at a fixed discretisation.
pub(super) struct Scene {
    /// The built-in scene.
    pub base: &'static str,
    /// What is changed in it.
    pub set: Vec<String>,
    /// Rigid motions that its gap leaves open: along z, and turning.
    pub modes: usize,
    pub degree: usize,
    pub layers: usize,
}

const BASES: [(&str, usize); 6] = [
    ("annular-punch", 1),
    ("translating-punch", 2),
    ("drum-brake-block", 1),
    ("drum-brake-ring", 1),
    ("internal-shoe", 1),
    ("hertz-cylinder", 1),
];

impl Scene {
    /// The next scene.
    pub(super) fn draw(random: &mut Random) -> Scene {
        let (base, modes) = BASES[random.below(BASES.len())];
        let degree = 5 + random.below(7);
        let layers = random.below(degree + 3);
        let task = if base == "hertz-cylinder" || random.below(3) == 0 { "contact" } else { "shape" };
        let mut set = vec![format!("tasks=[\"{task}\"]"), "output.fields=false".into()];
        if task == "shape" {
            set.push("check=false".into());
        }
        let mut material = |body: usize| {
            let (young, poisson) = (random.scale(1e2, 3e5), random.within(0.05, 0.45));
            format!("body{body}.material={{young={young},poisson={poisson}}}")
        };
        set.push(material(2));
        if base != "internal-shoe" {
            set.push(material(1));
        }
        if base == "hertz-cylinder" {
            // Softer bodies would touch over half their width.
            set.push(format!("load.force={}", random.scale(1e-3, 1.0)));
        } else {
            set.push(format!("contact.friction={}", random.within(0.0, 0.6)));
            set.push(format!("wear.b={}", random.within(0.4, 2.0)));
        }
        set.extend(sizes(base, random));
        Scene { base, set, modes, degree, layers }
    }
}

/// Other sizes of a scene's bodies.
fn sizes(base: &str, random: &mut Random) -> Option<String> {
    match base {
        "annular-punch" => {
            let (inner, top) = (random.within(12.0, 90.0), random.within(55.0, 150.0));
            Some(format!("body1.geometry.rectangle={{x=[{inner},120],z=[50,{top}]}}"))
        }
        "translating-punch" => {
            let (half, top) = (random.within(8.0, 50.0), random.within(110.0, 250.0));
            Some(format!("body1.geometry.rectangle={{x=[{},{half}],z=[100,{top}]}}", -half))
        }
        "drum-brake-block" => Some(format!("body1.geometry.shoe-block.half_angle={}", random.within(0.15, 0.8))),
        "drum-brake-ring" => Some(format!("body1.geometry.ring-segment.outer={}", random.within(210.0, 240.0))),
        _ => None,
    }
}
