//! A shape in words: what to take off where, and a hollow or a crown where it truly is one.

use wearshape::{Problem, Solution};

use crate::brief::brief;
use crate::place::place;

/// Part of the surface at each end that is no middle.
const END: f64 = 0.15;
/// Share of the largest gap above which an end is cut down as well.
const CUT_DOWN: f64 = 0.5;

/// What the gap along a surface looks like.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Form {
    /// Proud in the middle: both ends are taken down.
    Crown,
    /// Hollow inside: both ends stay.
    Hollow,
    /// Neither.
    Slope,
}

/// Places and gaps (mm, um) of the largest and the smallest gap, and the form.
struct Read {
    most: [f64; 2],
    least: [f64; 2],
    form: Form,
}

fn read(rows: &[[f64; 2]]) -> Option<Read> {
    let rows: Vec<[f64; 2]> = rows.iter().copied().filter(|row| row[1].is_finite()).collect();
    let (first, last) = (*rows.first()?, *rows.last()?);
    let (mut most, mut least) = (first, first);
    for row in &rows {
        most = if row[1] > most[1] { *row } else { most };
        least = if row[1] < least[1] { *row } else { least };
    }
    let depth = most[1] - least[1];
    let inside = |row: [f64; 2]| {
        let share = (row[0] - first[0]) / (last[0] - first[0]);
        share > END && share < 1.0 - END
    };
    let ends = [first, last].map(|end| (end[1] - least[1]) / depth);
    let form = if inside(least) && ends.iter().all(|end| *end >= CUT_DOWN) {
        Form::Crown
    } else if inside(most) && ends.iter().all(|end| *end <= CUT_DOWN) {
        Form::Hollow
    } else {
        Form::Slope
    };
    Some(Read { most, least, form })
}

/// What to take off where, of a run that has found a shape.
pub(crate) fn taken_off(problem: &Problem, solution: &Solution) -> Option<String> {
    let shape = solution.shape.as_ref()?;
    if shape.flat {
        return Some("nothing is to be taken off".into());
    }
    shape_words(problem, solution).or_else(|| {
        let at = shape.gap_where.map(|s| format!(" at {}", place(problem, s))).unwrap_or_default();
        shape.gap_max.map(|most| format!("take off most, {} um,{at}", brief(most)))
    })
}

/// "take off most, 1.09 um, at 30 deg; nothing at -12.6 deg": none without a gap.
fn shape_words(problem: &Problem, solution: &Solution) -> Option<String> {
    let rows: Vec<[f64; 2]> = match (&solution.machined, &solution.profile) {
        (Some(machined), _) => machined.points.iter().map(|point| [point.s, 1e3 * point.gap]).collect(),
        (None, Some(profile)) => profile.s.iter().zip(&profile.gap).map(|(s, gap)| [*s, *gap]).collect(),
        (None, None) => return None,
    };
    let Read { mut most, mut least, form } = read(&rows)?;
    let shape = solution.shape.as_ref()?;
    // Between the points.
    if let (Some(deepest), Some(at), Some(crown)) = (shape.gap_max, shape.gap_where, shape.crown) {
        (most, least) = ([at, deepest], [shape.gap_least_where.unwrap_or(least[0]), deepest - crown]);
    } else if let Some(machined) = &solution.machined {
        (most, least) = ([machined.deepest.s, 1e3 * machined.deepest.gap], [machined.datum.s, 1e3 * machined.datum.gap]);
    }
    let size = most[1].abs().max(least[1].abs());
    if size <= 0.0 {
        return Some("nothing is to be taken off".into());
    }
    let at = |row: [f64; 2]| format!("at {}", place(problem, row[0]));
    if most[1] < 0.0 {
        // A prescribed rigid part may ask for more material than is drawn.
        return Some(format!(
            "leave on most, {} um, {}; least, {} um, {}",
            brief(-least[1]),
            at(least),
            brief(-most[1]),
            at(most)
        ));
    }
    let rest = match least[1] {
        gap if gap.abs() <= 1e-3 * size => format!("nothing {}", at(least)),
        gap if gap < 0.0 => format!("leave on {} um {}", brief(-gap), at(least)),
        gap => format!("least, {} um, {}", brief(gap), at(least)),
    };
    let reach = rows.last()?[0] - rows.first()?[0];
    let centred = (most[0] - 0.5 * (rows.last()?[0] + rows.first()?[0])).abs() <= 0.05 * reach;
    Some(match form {
        Form::Hollow if centred => format!("a hollow of {} um in the middle; {rest}", brief(most[1])),
        Form::Hollow => format!("a hollow of {} um {}; {rest}", brief(most[1]), at(most)),
        Form::Crown => format!("a crown: take off most, {} um, {}; {rest}", brief(most[1]), at(most)),
        Form::Slope => format!("take off most, {} um, {}; {rest}", brief(most[1]), at(most)),
    })
}

#[cfg(test)]
mod tests {
    use super::{Form, read};

    fn form(gap: fn(f64) -> f64) -> Form {
        let rows: Vec<[f64; 2]> = (0..=100).map(|k| [f64::from(k) - 50.0, gap(f64::from(k) / 50.0 - 1.0)]).collect();
        read(&rows).map(|read| read.form).unwrap_or(Form::Slope)
    }

    #[test]
    fn a_crown_is_proud_in_the_middle_and_a_hollow_is_hollow_there() {
        assert_eq!(form(|t| t * t), Form::Crown);
        assert_eq!(form(|t| 1.0 - t * t), Form::Hollow);
        assert_eq!(form(|t| 1.0 + t), Form::Slope);
        // Deep at one end, a little at the other.
        assert_eq!(form(|t| if t < 0.0 { t * t } else { 0.2 * t * t }), Form::Slope);
        // High at one end alone: no hollow.
        assert_eq!(form(|t| if t < -0.5 { 1.0 } else { 1.0 - 0.5 * (t + 0.5) }), Form::Slope);
    }
}
