//! Which points of a sweep are drawn.

/// Points that still can be told apart in one picture.
const MOST_DRAWN: usize = 12;

/// The points with a curve that a sweep draws: all where they are few, else some that are evenly spread, with the first and the last. How many points
/// have one is known at the end alone, so that more curves are kept until then.
#[derive(Debug, Default)]
pub(crate) struct Drawn {
    /// Points with a curve so far.
    count: usize,
    /// Those of them whose curve is kept: which of them, and which point.
    kept: Vec<(usize, usize)>,
}

impl Drawn {
    /// Takes note of a point with a curve, of `all` points of the sweep; whether its curve is to be kept.
    pub(crate) fn see(&mut self, point: usize, all: usize) -> bool {
        let number = self.count;
        self.count += 1;
        // If all points have a curve, these are drawn; if not, the others stand at most as far apart as what will be drawn of them.
        let even = all <= MOST_DRAWN || (0..MOST_DRAWN).any(|place| point == Drawn::at(place, all));
        let apart = 1_usize << (number / MOST_DRAWN).max(1).ilog2();
        let keep = even || number.is_multiple_of(apart);
        if keep {
            self.kept.push((number, point));
        }
        keep
    }

    /// The points that are drawn.
    pub(crate) fn points(&self) -> Vec<usize> {
        let nearest = |place: usize| {
            let wanted = Drawn::at(place, self.count);
            self.kept.iter().min_by_key(|(number, _)| number.abs_diff(wanted)).map(|(_, point)| *point)
        };
        let mut points: Vec<usize> = match self.count <= MOST_DRAWN {
            true => self.kept.iter().map(|(_, point)| *point).collect(),
            false => (0..MOST_DRAWN).filter_map(nearest).collect(),
        };
        points.dedup();
        points
    }

    /// The number in a place of those that are evenly spread among some.
    fn at(place: usize, count: usize) -> usize {
        place * (count - 1) / (MOST_DRAWN - 1)
    }

    /// Whether all curves that are kept are drawn.
    pub(crate) fn all_kept(&self) -> bool {
        self.points().len() == self.kept.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The points that are drawn where those have a curve for which it is said.
    fn drawn(all: usize, has: impl Fn(usize) -> bool) -> Vec<usize> {
        let mut drawn = Drawn::default();
        (0..all).filter(|point| has(*point)).for_each(|point| _ = drawn.see(point, all));
        assert!(drawn.kept.len() < 300, "{}", drawn.kept.len());
        drawn.points()
    }

    #[test]
    fn at_most_twelve_points_are_drawn_with_the_first_and_the_last() {
        assert!(drawn(7, |_| false).is_empty());
        for count in [1, 2, 12, 13, 100, 1_000_000] {
            let found = drawn(count, |_| true);
            let even: Vec<usize> = (0..MOST_DRAWN).map(|place| Drawn::at(place, count)).collect();
            assert!(found.len() == count.min(MOST_DRAWN) && (count <= MOST_DRAWN || found == even), "{count}: {found:?}");
        }
    }

    #[test]
    fn twelve_points_are_drawn_of_those_with_a_curve() {
        for (all, from, to) in [(100, 0, 50), (100, 60, 100), (1000, 300, 325), (100_000, 0, 4711)] {
            let found = drawn(all, |point| (from..to).contains(&point));
            let apart = (to - from) / 11;
            assert!(found.len() == MOST_DRAWN && found[0] == from && found[11] + apart >= to, "{found:?}");
            assert!(found.windows(2).all(|pair| pair[1] - pair[0] <= 2 * apart + 1), "{found:?}");
        }
        assert_eq!(drawn(100, |point| point % 9 == 1), (0..11).map(|number| 1 + 9 * number).collect::<Vec<_>>());
    }
}
