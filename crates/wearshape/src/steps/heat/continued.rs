//! Of several hot contacts the one that continues that of slower sliding: its ends are followed, with nodes on them, as the speed grows.

use contact::FreeEnds;
use meshing::Cut;
use scene::Fault;

use crate::effort::Effort;
use crate::level::Level;
use crate::stage::Stage;
use crate::steps::free_ends::position_at;
use crate::steps::heat::following::Following;
use crate::steps::start_gap::start_gaps;

/// Degree and layers of the bodies on which ends are followed, whatever the level that asks for them: on coarser ones other contacts lie near.
const DEGREE: usize = 8;
const LAYERS: usize = 2;
/// Accuracy of the nodes on the way: a search that comes no nearer is content with a hundred times that.
const WITHIN: f64 = 1e-6;
/// Times that nodes are moved onto the ends at a speed: contact may leave an end of the surface there, or come to one.
const ROUNDS: usize = 3;

/// The first step of the sliding speed, over it, and the smallest.
const FIRST: f64 = 1.0 / 8.0;
const SMALLEST: f64 = 1.0 / 256.0;
/// Part of the surface on which a contact may differ from the one foreseen for a step to be believed, and for one as long again to be tried with twice the length.
const BELIEVED: f64 = 0.06;
const FORESEEN: f64 = 0.01;
/// Times that the speed is halved between a contact that fills the surface and one that does not.
const HALVINGS: usize = 8;
/// Speeds beyond that at which a contact on nodes is looked for, the smallest step apart.
const OPENING: usize = 8;

/// Part of the surface that opens at once, from which on contact jumps.
const OPENED: f64 = 0.15;

/// Ends at a part of the sliding speed.
struct Place {
    speed: f64,
    ends: FreeEnds,
}

/// The hot contact that continues that of slower sliding.
#[derive(Clone, Default)]
pub(crate) struct Continued {
    /// Its ends; none where it fills the surface, or cannot be followed.
    pub ends: FreeEnds,
    /// Whether they were followed from the cold contact, or from where one that fills the surface begins to open; not if that jumps.
    pub smoothly: bool,
}

/// Follows the ends of a hot contact from slower sliding.
pub(crate) fn continued(stage: Stage<'_>, level: Level, work: &mut Effort) -> Result<Continued, Fault> {
    let level = Level { degree: DEGREE, layers: LAYERS, even: false, ..level };
    let Some((following, effort)) = Following::new(stage, level, Cut::Plain)? else { return Ok(Continued::default()) };
    *work += effort;
    let pair = following.reduced.pair()?;
    let operator = following.reduced.operator(&pair, stage.friction() > 0.0)?;
    let (gap, load) = (start_gaps(stage, &operator), stage.contact_load(operator.points()));
    let length = pair.trace().length();
    // Those that a mesh without nodes on them tells.
    let told = |speed: f64| {
        // Where what conducts and what is in contact do not settle on each other, it tells nothing.
        let Ok(hot) = following.settled(&operator, &gap, &load, speed, None) else { return Told::default() };
        let fills = hot.found.status.is_solved() && hot.found.closed.iter().all(|closed| *closed);
        Told { fills, ends: FreeEnds::of(&hot.found, length) }
    };
    let mut path = Path { stage, level, work, told: &told };
    let Some(from) = opening(&told) else { return Ok(Continued::default()) };
    for speed in (0..OPENING).map(|k| (from + k as f64 * SMALLEST).min(1.0)) {
        if let Some(ends) = path.positioned(&told(speed).ends, speed)? {
            let closed: f64 = ends.zones(1.0).iter().map(|[from, to]| to - from).sum();
            let smoothly = from == 0.0 || closed > 1.0 - OPENED;
            let ends = path.followed(Place { speed, ends })?;
            return Ok(Continued { smoothly: smoothly && ends.is_some(), ends: ends.unwrap_or_default() });
        }
    }
    Ok(Continued::default())
}

/// What a mesh without nodes on the ends tells of a contact.
#[derive(Default)]
struct Told {
    /// Whether it fills the surface.
    fills: bool,
    ends: FreeEnds,
}

/// The part of the sliding speed at which contact first ends inside the surface, or a little more; none where it does not.
fn opening(told: &dyn Fn(f64) -> Told) -> Option<f64> {
    let cold = told(0.0);
    if !cold.fills {
        return (!cold.ends.places.is_empty()).then_some(0.0);
    }
    let [mut full, mut partial] = [0.0, 1.0];
    for _ in 0..HALVINGS {
        let speed = 0.5 * (full + partial);
        if told(speed).fills { full = speed } else { partial = speed }
    }
    Some(partial)
}

/// What ends are followed with.
struct Path<'p, 'a> {
    stage: Stage<'a>,
    level: Level,
    work: &'p mut Effort,
    told: &'p dyn Fn(f64) -> Told,
}

impl Path<'_, '_> {
    /// Ends from trial ones, with nodes on them; where the contact has others once its points are free, from those once more.
    fn positioned(&mut self, trial: &FreeEnds, speed: f64) -> Result<Option<FreeEnds>, Fault> {
        let mut trial = trial.clone();
        for _ in 0..ROUNDS {
            let Some((ends, found)) = position_at(self.stage, self.level, (&trial, WITHIN, speed), self.work)? else {
                return Ok(None);
            };
            let others = found.ends_at(speed)?;
            let as_many = others.places.len() == ends.places.len() && others.starts_closed == ends.starts_closed;
            if as_many && others.apart(&ends) < BELIEVED {
                return Ok(Some(ends));
            }
            trial = others;
        }
        Ok(None)
    }

    /// Ends at the whole speed, each step from where the last two lead.
    fn followed(&mut self, first: Place) -> Result<Option<FreeEnds>, Fault> {
        let (mut now, mut before): (Place, Option<Place>) = (first, None);
        let mut step = FIRST;
        while now.speed < 1.0 {
            let speed = (now.speed + step).min(1.0);
            let foreseen = match &before {
                Some(before) => now.ends.ahead(&before.ends, (speed - now.speed) / (now.speed - before.speed)),
                None => now.ends.clone(),
            };
            // Contact that opens in its middle opens like the root of the speed.
            let most = |ends: &FreeEnds| match step <= SMALLEST && ends.places.len() != foreseen.places.len() {
                true => OPENED,
                false => BELIEVED,
            };
            let found = self.positioned(&foreseen, speed)?.filter(|ends| ends.apart(&foreseen) < most(ends));
            match found {
                Some(ends) => {
                    step *= if ends.apart(&foreseen) < FORESEEN { 2.0 } else { 1.0 };
                    before = Some(now).filter(|now| now.ends.places.len() == ends.places.len());
                    now = Place { speed, ends };
                }
                None if step > SMALLEST => step *= 0.5,
                // Contact may come to an end of the surface there.
                None => match self.positioned(&(self.told)(speed).ends, speed)?.filter(|ends| ends.apart(&foreseen) < OPENED) {
                    Some(ends) => (now, before) = (Place { speed, ends }, None),
                    None => return Ok(None),
                },
            }
        }
        Ok(Some(now.ends))
    }
}
