//! The words of the summary.

use serde::Serialize;

/// A word as files and the screen have it.
pub fn word(value: &impl Serialize) -> String {
    serde_json::to_value(value).ok().and_then(|word| word.as_str().map(str::to_string)).unwrap_or_default()
}

/// What a pressure is for its functional.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Character {
    /// The least, proved.
    Minimum,
    /// The largest, proved.
    Maximum,
    /// Every admissible pressure gives the same.
    Indifferent,
    /// Stationary, and no more is known.
    Stationary,
}

impl From<wear::Character> for Character {
    fn from(character: wear::Character) -> Character {
        match character {
            wear::Character::Minimum => Character::Minimum,
            wear::Character::Maximum => Character::Maximum,
            wear::Character::Indifferent => Character::Indifferent,
            wear::Character::Stationary => Character::Stationary,
        }
    }
}

/// What kind of pressure it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Regime {
    /// Positive on the whole surface.
    Regular,
    /// Its exponent is next to the singular one.
    NearSingular,
    /// Concentrated on points or lines.
    Singular,
    /// Part of the surface is open.
    PartialContact,
    /// No pressure fulfils the balance.
    Infeasible,
    /// There are several.
    Several,
}

impl From<wear::Regime> for Regime {
    fn from(regime: wear::Regime) -> Regime {
        match regime {
            wear::Regime::Regular => Regime::Regular,
            wear::Regime::NearSingular => Regime::NearSingular,
            wear::Regime::Singular => Regime::Singular,
            wear::Regime::PartialContact => Regime::PartialContact,
            wear::Regime::Infeasible => Regime::Infeasible,
            wear::Regime::Several => Regime::Several,
        }
    }
}

/// How a contact solve ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ContactStatus {
    /// Part of the surface is in contact.
    #[default]
    Converged,
    /// All of it is.
    ClosedEverywhere,
    /// None of it is.
    NoContact,
    /// No contact balances the load.
    NoBalance,
    /// Friction locks.
    Jammed,
    /// Several contacts are right.
    NotUnique,
    /// The iteration did not arrive.
    IterationLimit,
}

impl From<&contact::Status> for ContactStatus {
    fn from(status: &contact::Status) -> ContactStatus {
        match status {
            contact::Status::Converged => ContactStatus::Converged,
            contact::Status::ClosedEverywhere => ContactStatus::ClosedEverywhere,
            contact::Status::NoContact => ContactStatus::NoContact,
            contact::Status::NoBalance => ContactStatus::NoBalance,
            contact::Status::Jammed => ContactStatus::Jammed,
            contact::Status::NotUnique => ContactStatus::NotUnique,
            _ => ContactStatus::IterationLimit,
        }
    }
}

/// How a contact stands that is turned about its axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum TwistStatus {
    /// All of it sticks.
    #[default]
    Sticks,
    /// Part of it slips.
    SlipsInPart,
    /// All of it slips, by a given angle.
    Slips,
    /// The torque is more than friction carries.
    TurnsThrough,
    /// The iteration did not arrive.
    IterationLimit,
}

impl From<&contact::TwistStatus> for TwistStatus {
    fn from(status: &contact::TwistStatus) -> TwistStatus {
        match status {
            contact::TwistStatus::Sticks => TwistStatus::Sticks,
            contact::TwistStatus::SlipsInPart => TwistStatus::SlipsInPart,
            contact::TwistStatus::Slips => TwistStatus::Slips,
            contact::TwistStatus::TurnsThrough => TwistStatus::TurnsThrough,
            contact::TwistStatus::IterationLimit { .. } => TwistStatus::IterationLimit,
        }
    }
}

/// Whether a contact with friction is the only one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Uniqueness {
    /// It is.
    #[default]
    Guaranteed,
    /// Nothing says so.
    NotGuaranteed,
    /// Its system has been singular on the way from no friction.
    Singular,
    /// Another one was found.
    Several,
}

/// How a run in time ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum WearStatus {
    /// The pressure no longer changes.
    #[default]
    Steady,
    /// The time asked for is over.
    TimeReached,
    /// The depth or volume asked for is worn off.
    WornOff,
    /// After the most steps that are made.
    StepLimit,
    /// No step succeeds any more, or nothing wears any more before what was to be worn off is worn off.
    Stuck,
    /// Frictional heat lets deviations of the pressure grow.
    Unstable,
}

impl From<&shapeopt::EvolutionStatus> for WearStatus {
    fn from(status: &shapeopt::EvolutionStatus) -> WearStatus {
        match status {
            shapeopt::EvolutionStatus::Steady => WearStatus::Steady,
            shapeopt::EvolutionStatus::TimeReached => WearStatus::TimeReached,
            shapeopt::EvolutionStatus::WornOff => WearStatus::WornOff,
            shapeopt::EvolutionStatus::Running => WearStatus::StepLimit,
            shapeopt::EvolutionStatus::Stuck { .. } | shapeopt::EvolutionStatus::Unreached { .. } => WearStatus::Stuck,
            shapeopt::EvolutionStatus::Unstable { .. } => WearStatus::Unstable,
        }
    }
}

/// What a point of the surface does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PointStatus {
    /// It is in contact.
    #[default]
    Contact,
    /// It is open.
    Open,
    /// It is in contact and sticks.
    Stick,
    /// It is in contact and slips.
    Slip,
}

impl PointStatus {
    /// Its word in the table.
    pub fn word(self) -> &'static str {
        match self {
            PointStatus::Contact => "contact",
            PointStatus::Open => "open",
            PointStatus::Stick => "stick",
            PointStatus::Slip => "slip",
        }
    }

    /// Of a point that presses or not.
    pub fn pressed(presses: bool) -> PointStatus {
        if presses { PointStatus::Contact } else { PointStatus::Open }
    }
}
