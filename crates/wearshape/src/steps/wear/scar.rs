//! The ends of a contact that grows as it wears, between the contact points.

/// Where the contact ends on both sides, from its places (mm, ascending), pressures and worn depths; on the axis of revolution the first is 0.
/// Between the last point that presses and the next one, the depth of a flat worn on a round body falls to 0 with the square of the
/// distance from the middle, and so does the square of the pressure of a round one that is not worn: the nearer of both counts.
pub(super) fn ends(places: &[f64], pressure: &[f64], worn: &[f64]) -> Option<[f64; 2]> {
    let pressed = |i: &usize| pressure[*i] > 0.0;
    let first = (0..places.len()).find(pressed)?;
    let last = (0..places.len()).rfind(pressed)?;
    let end = |at: usize, inner: Option<usize>, outer: Option<usize>| {
        let (Some(inner), Some(outer)) = (inner, outer) else { return places[at] };
        let zero = |value: &dyn Fn(usize) -> f64| {
            let [x, y] = [inner, at].map(|i| places[i] * places[i]);
            let [a, b] = [inner, at].map(value);
            (a > b).then(|| (y + b * (y - x) / (a - b)).sqrt())
        };
        let nearest = [zero(&|i| worn[i]), zero(&|i| pressure[i] * pressure[i])].into_iter().flatten().reduce(f64::min);
        let [low, high] = [places[at].abs(), places[outer].abs()];
        nearest.unwrap_or(low).clamp(low, high.max(low)).copysign(places[at])
    };
    let from =
        if places[first] <= 0.0 && first == 0 { places[first] } else { end(first, after(first, last), first.checked_sub(1)) };
    let outer = (last + 1 < places.len()).then_some(last + 1);
    Some([from, end(last, last.checked_sub(1).filter(|i| *i >= first), outer)])
}

fn after(at: usize, last: usize) -> Option<usize> {
    (at < last).then_some(at + 1)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::ends;

    #[test]
    fn ends_between_points_are_those_of_a_flat_and_of_a_round_contact() {
        let places: Vec<f64> = (-10..=10).map(f64::from).collect();
        let flat: Vec<f64> = places.iter().map(|x| (7.3_f64.powi(2) - x * x).max(0.0)).collect();
        let uniform: Vec<f64> = flat.iter().map(|w| if *w > 0.0 { 2.0 } else { 0.0 }).collect();
        let [from, to] = ends(&places, &uniform, &flat).unwrap();
        assert!((from + 7.3).abs() < 1e-12 && (to - 7.3).abs() < 1e-12, "{from} {to}");
        let hertz: Vec<f64> = places.iter().map(|x| (1.0 - (x / 4.6).powi(2)).max(0.0).sqrt()).collect();
        let [from, to] = ends(&places, &hertz, &[0.0; 21]).unwrap();
        assert!((from + 4.6).abs() < 1e-12 && (to - 4.6).abs() < 1e-12, "{from} {to}");
        assert_eq!(ends(&places, &[0.0; 21], &flat), None);
        let [from, to] = ends(&places[10..], &hertz[10..], &[0.0; 11]).unwrap();
        assert!(from == 0.0 && (to - 4.6).abs() < 1e-12, "{from} {to}");
    }
}
