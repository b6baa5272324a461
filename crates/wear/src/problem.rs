//! A wear problem: surface, rule, load, and what is to be made stationary.

use crate::mode::MAX_MODES;
use crate::{Balance, Functional, Modes, OwnRule, RigidMode, Rule, Shape, Surface, SurfacePoint, WearError, WearPair};

/// The way body 2's points pass through the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counterface {
    /// Long fresh plate under a translating punch: its profile is stationary in the punch frame and drops out of the gap rate.
    Fresh,
    /// Ring on ring: each point of body 2 always meets the same pressure; the wear rates add.
    Congruent,
    /// Drum under a shoe, disc under a pad: body 2 recedes uniformly along its closed track by the mean of its wear over a turn.
    Revolving,
}

/// All that determines an optimal pressure. Every field is meaningful by itself; `new` fills the usual choices.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// Contact surface with its sliding motion.
    pub surface: Surface,
    /// Wear rules of the two bodies.
    pub wear: WearPair,
    /// Friction coefficient mu >= 0: in the power mu p v, and in the balance when `shear_in_balance`.
    pub friction: f64,
    /// Whether the shear mu p acts in the balance (psi) or not (psi = phi).
    pub shear_in_balance: bool,
    /// Free rigid modes with their resultants.
    pub modes: Vec<RigidMode>,
    /// What is made stationary.
    pub functional: Functional,
    /// Exponent q of the functional: any real, 0, negative or infinite.
    pub q: f64,
    /// How the pressure is scaled to the load.
    pub balance: Balance,
    /// Kinematic or associated modes.
    pub mode_kind: Modes,
    /// How body 2 passes under body 1.
    pub counterface: Counterface,
    /// Largest admissible pressure in MPa.
    pub p_max: Option<f64>,
}

impl Problem {
    /// Steady state of body 1's wear rule, a [`WearLaw`](crate::WearLaw) or an [`OwnRule`](crate::OwnRule), under one force or several modes, frictionless
    /// balance, one wearing body.
    pub fn new(surface: Surface, rule: impl Into<Rule>, modes: Vec<RigidMode>) -> Self {
        Self {
            surface,
            wear: WearPair::alone(rule),
            friction: 0.0,
            shear_in_balance: true,
            modes,
            functional: Functional::Steady,
            q: 1.0,
            balance: Balance::Equilibrium,
            mode_kind: Modes::Kinematic,
            counterface: Counterface::Fresh,
            p_max: None,
        }
    }

    pub(crate) fn check(&self) -> Result<(), WearError> {
        let count = self.modes.len();
        if count == 0 || count > MAX_MODES {
            return Err(WearError::Modes { count, why: "between one and six are needed" });
        }
        if !(self.friction >= 0.0 && self.friction.is_finite()) {
            let value = self.friction;
            return Err(WearError::OutOfRange { name: "friction coefficient", value, wanted: ">= 0 and finite" });
        }
        if self.q.is_nan() {
            return Err(WearError::OutOfRange { name: "q", value: self.q, wanted: "a number or infinite" });
        }
        for mode in &self.modes {
            if !mode.resultant.is_finite() {
                return Err(WearError::OutOfRange { name: "resultant", value: mode.resultant, wanted: "finite" });
            }
            if !mode.motion.is_sound() {
                return Err(WearError::Modes { count, why: "a direction or an axis is no unit vector through a finite point" });
            }
        }
        if let Some(cap) = self.p_max
            && (cap.is_nan() || cap <= 0.0)
        {
            return Err(WearError::OutOfRange { name: "p_max", value: cap, wanted: "> 0" });
        }
        if matches!(self.surface.shape(), Shape::Annulus { .. }) && self.modes.iter().any(|mode| !mode.keeps_axial_symmetry()) {
            let why = "a full ring carries axial modes only; use a sector of one turn for moments";
            return Err(WearError::Modes { count, why });
        }
        self.surface.check_track()?;
        for rule in &self.wear.rules {
            rule.check()?;
        }
        self.check_functional()?;
        self.check_rates()
    }

    /// Refuses a functional of one's own that is no number at the speeds of the surface.
    fn check_functional(&self) -> Result<(), WearError> {
        let Functional::Own(own) = &self.functional else { return Ok(()) };
        let mut sound = Ok(());
        self.surface.survey(&mut |SurfacePoint { sliding_speed: speed, .. }| {
            if *speed > 0.0 && sound.is_ok() {
                sound = own.check_numbers(*speed, self.friction);
            }
        });
        sound
    }

    /// Refuses functions whose rates are no numbers at the speeds of the surface, or do not grow with the pressure at the lowest and the highest.
    fn check_rates(&self) -> Result<(), WearError> {
        let own = |rule: &Rule| if let Rule::Own(rule) = rule { Some(rule.clone()) } else { None };
        let rules: Vec<OwnRule> = self.wear.rules.iter().filter_map(own).collect();
        if rules.is_empty() {
            return Ok(());
        }
        let mut wrong = Ok(());
        let [mut lowest, mut highest] = [f64::INFINITY, 0.0_f64];
        self.surface.survey(&mut |SurfacePoint { sliding_speed: speed, .. }| {
            if *speed > 0.0 && wrong.is_ok() {
                [lowest, highest] = [lowest.min(*speed), highest.max(*speed)];
                wrong = rules.iter().try_for_each(|rule| rule.check_numbers(*speed));
            }
        });
        wrong?;
        let speeds = [lowest, highest].into_iter().filter(|speed| highest > 0.0 && speed.is_finite());
        speeds
            .flat_map(|speed| rules.iter().map(move |rule| (rule, speed)))
            .try_for_each(|(rule, speed)| rule.check_growth(speed))
    }
}
