//! Values along the contact surface, at any place near it.

/// The contact surface as a line through its points, with a value at each.
pub(crate) struct ContactLine<'a> {
    points: Vec<[f64; 2]>,
    values: &'a [f64],
}

impl<'a> ContactLine<'a> {
    /// A line through places (x, y, z) with a value at each; none of fewer than two, or of another number of values.
    pub(crate) fn new(position: &[[f64; 3]], values: &'a [f64]) -> Option<ContactLine<'a>> {
        let points: Vec<[f64; 2]> = position.iter().map(|[x, _, z]| [*x, *z]).collect();
        (points.len() > 1 && points.len() == values.len()).then_some(ContactLine { points, values })
    }

    /// The value at the foot of the perpendicular; 0 beyond the ends.
    pub(crate) fn at(&self, place: [f64; 2]) -> f64 {
        let (row, share, _) = self.nearest(place);
        if !(0.0..=1.0).contains(&share) {
            return 0.0;
        }
        (1.0 - share) * self.values[row] + share * self.values[row + 1]
    }

    /// The value at the nearest point of the line, beyond its ends that of the end.
    pub(crate) fn nearest_value(&self, place: [f64; 2]) -> f64 {
        let (row, share, _) = self.nearest(place);
        let share = share.clamp(0.0, 1.0);
        (1.0 - share) * self.values[row] + share * self.values[row + 1]
    }

    /// The nearest piece by its first point, the share along it, below 0 and above 1 beyond the ends of the line, and the distance.
    pub(crate) fn nearest(&self, place: [f64; 2]) -> (usize, f64, f64) {
        let mut best = (0, 0.0, f64::INFINITY);
        let last = self.points.len() - 2;
        let [first, end] = [self.points[0], self.points[last + 1]];
        let near = 1e-9 * (end[0] - first[0]).hypot(end[1] - first[1]);
        for (row, pair) in self.points.windows(2).enumerate() {
            let [a, b] = [pair[0], pair[1]];
            let (along, from) = ([b[0] - a[0], b[1] - a[1]], [place[0] - a[0], place[1] - a[1]]);
            let length = along[0] * along[0] + along[1] * along[1];
            if length == 0.0 {
                continue;
            }
            let share = (along[0] * from[0] + along[1] * from[1]) / length;
            let foot = share.clamp(0.0, 1.0);
            let distance = (from[0] - foot * along[0]).hypot(from[1] - foot * along[1]);
            if distance < best.2 {
                // An end found up to round-off is the end, however short the last piece.
                let over = (share - foot).abs() * length.sqrt() > near;
                let beyond = over && ((row == 0 && share < 0.0) || (row == last && share > 1.0));
                best = (row, if beyond { share } else { foot }, distance);
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::ContactLine;

    #[test]
    fn values_are_linear_between_points_and_nothing_beyond_the_ends() {
        let position = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [3.0, 0.0, 1.0]];
        let line = ContactLine::new(&position, &[2.0, 4.0, 0.0]);
        let at = |x: f64| line.as_ref().map(|line| line.at([x, 1.1]));
        assert_eq!([0.0, 0.5, 2.0, 3.0, 3.1, -0.1].map(at), [2.0, 3.0, 2.0, 0.0, 0.0, 0.0].map(Some));
        assert!(ContactLine::new(&position, &[1.0]).is_none());
    }
}
