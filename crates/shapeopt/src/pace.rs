//! How points enter and leave the contact from one Newton step to the next.

const NEWTON_LIMIT: usize = 60;
/// Newton steps after which active points change one at a time.
const PATIENCE: usize = 25;
/// A contact whose points change this many times as many as before, and this part of all of them, runs away.
const AWAY: usize = 4;
const AWAY_PART: usize = 8;

/// How points enter and leave the contact.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Pace {
    /// All at once; one at a time after long patience. Given up where the contact runs away.
    Bold,
    /// The same in more steps, wherever it leads.
    Patient,
    /// All at once as long as fewer have to than ever before, one at a time else (block pivoting of Judice and Pires 1994, which ends where the
    /// matrix has positive principal minors).
    Careful,
}

impl Pace {
    /// Most Newton steps with so many contact points: one at a time changes sides in the end, and each may have to.
    pub(crate) fn limit(self, points: usize) -> usize {
        match self {
            Pace::Bold => NEWTON_LIMIT,
            Pace::Careful => NEWTON_LIMIT + points,
            Pace::Patient => NEWTON_LIMIT + 4 * points,
        }
    }

    /// Whether one point alone changes sides in a step, of those that have to; `fewest` have had to in a step before it.
    pub(crate) fn is_single(self, steps: usize, changed: usize, fewest: usize) -> bool {
        if self == Pace::Careful { changed >= fewest } else { steps > PATIENCE }
    }

    /// Whether so many points that have to change sides, of all, lead nowhere.
    pub(crate) fn gives_up(self, changed: usize, fewest: usize, points: usize) -> bool {
        self == Pace::Bold && changed > (AWAY * fewest).max(points / AWAY_PART)
    }
}
