//! Contacts with more ends than usual, as a rough gap has them: how far their levels are worth climbing.

use crate::effort::Effort;
use crate::ladder::{FIRST, LEAST};
use crate::level::Level;

/// Ends of contact inside the surface of a usual contact.
const USUAL_ENDS: usize = 4;
/// Ends of contact beyond which no mesh with nodes on all of them is looked for.
const MOST_ENDS: usize = 48;
/// Levels whose nodes do not settle on the ends after which these are not looked for any more (the coarsest may not know them): of few ends, and of more
/// than usual.
const MOST_LOST: [usize; 2] = [4, 2];
/// Unknowns of both surfaces together beyond which finer levels of a contact with more ends than usual are left out: eliminations take the cube of them.
const MOST_UNKNOWNS: usize = 7000;

/// Whether nodes on so many ends are looked for, after levels on which they did not settle.
pub(crate) fn are_looked_for(ends: usize, lost: usize) -> bool {
    ends > 0 && ends <= MOST_ENDS && lost < MOST_LOST[usize::from(ends > USUAL_ENDS)]
}

/// Whether a mesh with nodes on the ends of contact, with so many unknowns of both surfaces, leaves room for finer ones from which an error can be told.
pub(crate) fn leaves_room(unknowns: usize, level: Level) -> bool {
    let told = FIRST + 2 * (LEAST - 1);
    unknowns * told.max(level.degree).pow(2) <= MOST_UNKNOWNS * level.degree.pow(2)
}

/// A contact with more ends inside its surface than usual.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ManyEnds {
    number: usize,
    /// Whether the next level would have too many unknowns.
    pub crowded: bool,
}

impl ManyEnds {
    /// Of a level with so many ends; none of a usual contact.
    pub(crate) fn of(number: usize, level: Level, effort: &Effort) -> Option<ManyEnds> {
        let grown = effort.counters.trace_dofs * (level.degree + 2).pow(2) / level.degree.pow(2);
        (number > USUAL_ENDS).then_some(ManyEnds { number, crowded: grown > MOST_UNKNOWNS })
    }

    /// What to say where the accuracy is missed or not known.
    pub(crate) fn words(&self) -> String {
        format!("it has {} ends of contact inside the surface, and a smoother gap has fewer", self.number)
    }
}
