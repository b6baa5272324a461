//! How far the ends of contact may be off, by the places that successive levels give them: pressure that falls slowly towards an end moves it by more than
//! its own error.

use crate::fixed;
use crate::series::rest_after;

/// Largest estimated error (mm) of the ends of the last of these levels, in order along the surface. Of a fixed discretisation the level beside it tells it.
/// `None` where levels differ in the number of ends, where fewer than three are there, and where no end moves: contact fills its surface.
/// Levels may have their nodes alike away from the ends, by `misplaced` over the length of the contact.
pub(crate) fn of(levels: &[&[f64]], beside: Option<&[f64]>, misplaced: f64) -> Option<f64> {
    let last = *levels.last()?;
    // What is near is small beside the shortest part between two ends.
    let extent = last.windows(2).map(|pair| pair[1] - pair[0]).reduce(f64::min)?;
    let moved = |x: &[f64], y: &[f64]| most(x, y).map(|most| most / extent);
    let error = match beside {
        Some(beside) => Some(moved(last, beside)?).filter(|off| *off > 0.0).map(fixed::error),
        None => {
            let [.., a, b, c] = levels else { return None };
            let (older, newer) = (moved(a, b)?, moved(b, c)?);
            let before = levels.len().checked_sub(4).and_then(|first| moved(levels[first], a));
            (older + newer > 0.0).then(|| rest_after(before, older, newer))
        }
    };
    error.map(|error| (error * extent).max(misplaced * length(last)))
}

/// Largest distance of the ends of two levels over the length of the contact; 0 where they differ in number.
pub(crate) fn apart(x: &[f64], y: &[f64]) -> f64 {
    most(x, y).map_or(0.0, |most| most / length(y))
}

/// Largest distance of as many ends, of which there are some (mm).
fn most(x: &[f64], y: &[f64]) -> Option<f64> {
    let distances = x.iter().zip(y).map(|(x, y)| (x - y).abs());
    if x.len() == y.len() { distances.reduce(f64::max) } else { None }
}

/// Length of the contact between its ends (mm).
fn length(ends: &[f64]) -> f64 {
    ends.chunks_exact(2).map(|zone| zone[1] - zone[0]).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_that_settle_have_the_error_of_what_is_left() {
        // Errors of 1e-2, 1e-3, 1e-4 of one end, and the other one does not move.
        let levels = [[0.0, 10.01], [0.0, 10.001], [0.0, 10.0001]];
        let levels: Vec<&[f64]> = levels.iter().map(|ends| ends.as_slice()).collect();
        let told = of(&levels, None, 0.0).unwrap_or_default();
        assert!((1e-4..4e-4).contains(&told), "{told}");
        // The level beside is the better one.
        assert_eq!(of(&levels[2..], Some(&[0.0, 10.0]), 0.0).map(|off| (off * 1e6).round()), Some(100.0));
    }

    #[test]
    fn ends_of_the_surface_and_other_ends_tell_none() {
        let filled: [&[f64]; 3] = [&[-25.0, 25.0]; 3];
        assert_eq!(of(&filled, None, 0.0), None);
        assert_eq!(of(&filled[2..], Some(&[-25.0, 25.0]), 0.0), None);
        let parted: [&[f64]; 3] = [&[-25.0, 25.0], &[-25.0, 20.0], &[-25.0, -3.0, 3.0, 20.0]];
        assert_eq!(of(&parted, None, 0.0), None);
        assert_eq!(of(&parted[..2], None, 0.0), None);
        assert_eq!(of(&[], None, 0.0), None);
    }
}
