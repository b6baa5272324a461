//! The lowest rigid part of a gap: a small semi-infinite linear programme.
//!
//! Given a jump `m(s)` and closing velocities `phi_k(s)` on a curve, find `a` with `g = m + sum_k a_k phi_k >= 0` everywhere and the
//! least `int g dS`. With one mode of one sign this is `a = -min_s m / phi`. In general a dual simplex method exchanges touching
//! points: as many as modes, with non-negative weights `y` such that `int phi_k dS = sum_i y_i phi_k(s_i)`.

use contact::maximum_between;
use nalgebra::{DMatrix, DVector};

/// A jump and closing velocities on a curve with a parameter in `[0, length]`.
pub trait Curve {
    /// End of the parameter range.
    fn length(&self) -> f64;
    /// Ascending parameters fine enough to see every dip.
    fn samples(&self) -> Vec<f64>;
    /// `m` and all `phi_k` at a parameter.
    fn value(&self, s: f64) -> (f64, Vec<f64>);
    /// `int phi_k dS`.
    fn mean_modes(&self) -> Vec<f64>;
}

/// The lowest rigid part.
pub(crate) struct Lowest {
    /// Coordinates of the modes.
    pub coordinates: Vec<f64>,
    /// Largest change of `g` on the curve by changes of `m` of 1 at the touching points: `max_s sum_i |(phi(s) M^-1)_i|`, where row `i` of `M` holds
    /// `phi(s_i)`. Touching points that run into one another leave a rotation to their tangent: it is then large.
    pub amplification: f64,
    /// Largest `|m|`.
    pub scale: f64,
}

/// Solves the programme; `None` if it is infeasible or unbounded.
pub fn lowest_nonnegative(curve: &impl Curve) -> Option<Vec<f64>> {
    lowest(curve).map(|lowest| lowest.coordinates)
}

/// A parameter, and the curve's value there.
#[derive(Clone)]
struct Place {
    s: f64,
    jump: f64,
    modes: Vec<f64>,
}

impl Place {
    fn on(curve: &impl Curve, s: f64) -> Place {
        let (jump, modes) = curve.value(s);
        Place { s, jump, modes }
    }

    fn gap(&self, coordinates: &[f64]) -> f64 {
        self.jump + coordinates.iter().zip(&self.modes).map(|(a, p)| a * p).sum::<f64>()
    }
}

/// Solves the programme, and tells how its solution rests on the touching points.
pub(crate) fn lowest(curve: &impl Curve) -> Option<Lowest> {
    let objective = curve.mean_modes();
    let places: Vec<Place> = curve.samples().into_iter().map(|s| Place::on(curve, s)).collect();
    let scale = places.iter().map(|v| v.jump.abs()).fold(0.0, f64::max).max(f64::MIN_POSITIVE);
    let touching = touching(curve, &places, &objective, scale)?;
    let coordinates = coordinates(&touching)?;
    let amplification = amplification(&touching, &places);
    let found = Lowest { coordinates, amplification, scale };
    let apart = touching.len() != 2 || (touching[0].s - touching[1].s).abs() > spacing(&places, touching[0].s);
    let found = if apart { found } else { at_tangent(curve, &places, &objective, scale).unwrap_or(found) };
    // A gap that is negative where no mode moves the body, as on the radius through a pin, is opened by none: what seems to open it is round-off.
    touching.iter().all(|place| is_moved(place, &places)).then_some(found)
}

/// Whether some mode moves the body at a place, over what it moves elsewhere.
fn is_moved(place: &Place, places: &[Place]) -> bool {
    let most = |k: usize| places.iter().map(|other| other.modes[k].abs()).fold(0.0, f64::max);
    (0..place.modes.len()).any(|k| place.modes[k].abs() > STILL * most(k))
}

/// Coordinates by which a gap vanishes at as many places as there are modes.
fn coordinates(touching: &[Place]) -> Option<Vec<f64>> {
    let right = DVector::from_iterator(touching.len(), touching.iter().map(|place| -place.jump));
    Some(matrix(touching).lu().solve(&right)?.iter().copied().collect())
}

/// `phi_k(s_i)` of touching points i and modes k.
fn matrix(touching: &[Place]) -> DMatrix<f64> {
    DMatrix::from_fn(touching.len(), touching.len(), |i, k| touching[i].modes[k])
}

/// Largest change of a gap by changes of 1 at its touching points.
fn amplification(touching: &[Place], places: &[Place]) -> f64 {
    let transposed = matrix(touching).transpose().lu();
    let spread = |phi: &[f64]| transposed.solve(&DVector::from_row_slice(phi)).map_or(f64::INFINITY, |z| z.lp_norm(1));
    places.iter().map(|place| spread(&place.modes)).fold(0.0, f64::max)
}

/// The points where the lowest gap touches.
fn touching(curve: &impl Curve, places: &[Place], objective: &[f64], scale: f64) -> Option<Vec<Place>> {
    let mut touching = initial_basis(places, objective)?;
    for _ in 0..1000 {
        let a = coordinates(&touching)?;
        let entering = lowest_place(curve, places, &a, SLACK * scale)?;
        if entering.gap(&a) >= -SLACK * scale {
            break;
        }
        // Ratio test: phi(entering) = sum z_i phi(touching_i), weights y_i.
        let transposed = matrix(&touching).transpose().lu();
        let z = transposed.solve(&DVector::from_row_slice(&entering.modes))?;
        let y = transposed.solve(&DVector::from_row_slice(objective))?;
        let leaving = (0..touching.len()).filter(|i| z[*i] > 1e-14).min_by(|i, j| (y[*i] / z[*i]).total_cmp(&(y[*j] / z[*j])))?;
        touching[leaving] = entering;
    }
    Some(touching)
}

/// Where a gap with the rigid part `a` is lowest: about its lowest sample, or where it dips lower between samples that are no lower. Beside a kink, which
/// the end of a cell is, a dip has no sample of its own that is lower than both beside it.
fn lowest_place(curve: &impl Curve, places: &[Place], a: &[f64], slack: f64) -> Option<Place> {
    let gap = |s: f64| Place::on(curve, s).gap(a);
    let gaps: Vec<f64> = places.iter().map(|place| place.gap(a)).collect();
    let lowest = (0..gaps.len()).min_by(|i, j| gaps[*i].total_cmp(&gaps[*j]))?;
    let found = lowest_about(gap, places, lowest, slack);
    let to_beat = gap(found) - slack;
    let searched = places[lowest.saturating_sub(1)].s..=places[(lowest + 1).min(gaps.len() - 1)].s;
    let inner = (1..gaps.len().saturating_sub(1)).filter(|i| *i != lowest);
    let dips = inner.filter(|i| {
        let about = [i - 1, *i, i + 1].map(|k| [places[k].s, gaps[k]]);
        let Some([at, parabola]) = vertex(about) else { return false };
        let [[_, f], [_, g], [_, h]] = about;
        let (least, most) = (f.min(g).min(h), f.max(g).max(h));
        // No dip is deeper than twice what a parabola tells, and what the parabola does not know is less than a part of what its ends tell.
        2.0 * parabola - least - BEYOND_PARABOLA * (most - least) < to_beat
            && (g <= least || parabola < least - slack && !searched.contains(&at) && 2.0 * gap(at) - least < to_beat)
    });
    let others = dips.map(|i| lowest_about(gap, places, i, slack)).filter(|s| gap(*s) < to_beat);
    let lower = others.min_by(|s, t| gap(*s).total_cmp(&gap(*t)));
    Some(Place::on(curve, lower.unwrap_or(found)))
}

/// The lowest place of the parabola through three points, if it has one between them, and its value there.
fn vertex([[x, f], [y, g], [z, h]]: [[f64; 2]; 3]) -> Option<[f64; 2]> {
    let [left, right] = [(g - f) / (y - x), (h - g) / (z - y)];
    let bend = (right - left) / (z - x);
    let slope = left + bend * (y - x);
    let lowest = y - slope / (2.0 * bend);
    (bend > 0.0 && (x..=z).contains(&lowest)).then(|| [lowest, g - slope * slope / (4.0 * bend)])
}

/// The lowest place between the samples beside one. Ends of cells are samples: there slopes may jump by the error of the discretisation, so that either
/// side may have a minimum of its own, lower by more than `slack` than what a search over both has found.
fn lowest_about(gap: impl Fn(f64) -> f64, places: &[Place], sample: usize, slack: f64) -> f64 {
    let [before, at, after] = [sample.saturating_sub(1), sample, (sample + 1).min(places.len() - 1)].map(|i| places[i].s);
    let over_both = minimise(&gap, [before, after], at);
    let sides = [[before, at], [at, after]].map(|side| minimise(&gap, side, at));
    let lower = sides.into_iter().filter(|s| gap(*s) < gap(over_both) - slack);
    lower.min_by(|a, b| gap(*a).total_cmp(&gap(*b))).unwrap_or(over_both)
}

/// Distance of the samples about a parameter, the smaller one.
fn spacing(places: &[Place], s: f64) -> f64 {
    let next = places.partition_point(|place| place.s <= s).clamp(1, places.len() - 1);
    let about = next.saturating_sub(1).max(1)..(next + 2).min(places.len());
    about.map(|i| places[i].s - places[i - 1].s).fold(f64::INFINITY, f64::min)
}

/// Motion of a place, over the largest of the surface, that is round-off.
const STILL: f64 = 1e-13;
/// Violation of `g >= 0`, over the largest jump, that is round-off.
const SLACK: f64 = 1e-15;
/// What a dip may be deeper than a parabola tells, over the rise from its lowest sample to the higher of those beside it.
const BEYOND_PARABOLA: f64 = 0.25;
/// Violation of `g >= 0`, over the largest jump, that a tangent may have.
const DIP: f64 = 1e-12;

/// Where two touching points run into one another, the gap touches in one point, which the objective alone tells: `int phi dS = y phi(s)`. There it
/// has a horizontal tangent; the mean of both sides where they differ by the error of the discretisation. Two points a rounding error apart
/// would tell no slope. `None` where that is no solution.
fn at_tangent(curve: &impl Curve, places: &[Place], objective: &[f64], scale: f64) -> Option<Lowest> {
    let side = |modes: &[f64]| modes[0] * objective[1] - modes[1] * objective[0];
    let crossing = places.windows(2).find(|pair| side(&pair[0].modes) * side(&pair[1].modes) <= 0.0)?;
    let s = root(|s| side(&curve.value(s).1), [crossing[0].s, crossing[1].s]);
    let step = spacing(places, s) / 16.0;
    let [far_below, below, above, far_above] = [-2.0, -1.0, 1.0, 2.0].map(|k| Place::on(curve, s + k * step));
    let at = Place::on(curve, s);
    // Slopes of fourth order.
    let slope =
        |of: &dyn Fn(&Place) -> f64| (8.0 * (of(&above) - of(&below)) - (of(&far_above) - of(&far_below))) / (12.0 * step);
    let modes = (0..2).map(|k| slope(&|place| place.modes[k])).collect();
    let tangent = [at, Place { s, jump: slope(&|place| place.jump), modes }];
    let coordinates = coordinates(&tangent)?;
    let lowest = places.iter().map(|place| place.gap(&coordinates)).fold(f64::INFINITY, f64::min);
    let amplification = amplification(&[below, above], places);
    (lowest >= -DIP * scale).then_some(Lowest { coordinates, amplification, scale })
}

/// A root between two parameters at which a function has not the same sign, by bisection.
fn root(f: impl Fn(f64) -> f64, [mut lower, mut upper]: [f64; 2]) -> f64 {
    let rising = f(upper) > f(lower);
    for _ in 0..80 {
        let middle = 0.5 * (lower + upper);
        match f(middle) {
            0.0 => return middle,
            value if (value > 0.0) == rising => upper = middle,
            _ => lower = middle,
        }
    }
    0.5 * (lower + upper)
}

/// Touching points with non-negative weights, searched among a coarse subset of the samples.
fn initial_basis(places: &[Place], objective: &[f64]) -> Option<Vec<Place>> {
    let modes = objective.len();
    let step = (places.len() / 24).max(1);
    let coarse: Vec<usize> = (0..places.len()).step_by(step).chain([places.len() - 1]).collect();
    let mut combination: Vec<usize> = (0..modes).collect();
    loop {
        let chosen: Vec<usize> = combination.iter().map(|i| coarse[*i]).collect();
        let matrix = DMatrix::from_fn(modes, modes, |k, i| places[chosen[i]].modes[k]);
        if let Some(y) = matrix.lu().solve(&DVector::from_row_slice(objective))
            && y.iter().all(|v| v.is_finite() && *v >= 0.0)
        {
            return Some(chosen.iter().map(|i| places[*i].clone()).collect());
        }
        // Next combination in lexicographic order.
        let position = (0..modes).rev().find(|p| combination[*p] < coarse.len() - modes + p)?;
        combination[position] += 1;
        for later in position + 1..modes {
            combination[later] = combination[later - 1] + 1;
        }
    }
}

/// Minimum of a smooth function between two parameters, by golden section from a bracket, compared with its centre and ends.
fn minimise(f: impl Fn(f64) -> f64, [lower, upper]: [f64; 2], centre: f64) -> f64 {
    let middle = maximum_between(&|x| -f(x), [lower, upper]);
    [lower, upper, centre].into_iter().chain([middle]).min_by(|a, b| f(*a).total_cmp(&f(*b))).unwrap_or(middle)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A jump over a straight surface of length 2 that may shift and turn.
    struct Line<F: Fn(f64) -> f64>(F);

    impl<F: Fn(f64) -> f64> Curve for Line<F> {
        fn length(&self) -> f64 {
            2.0
        }

        fn samples(&self) -> Vec<f64> {
            (0..=100).map(|i| 0.02 * f64::from(i)).collect()
        }

        fn value(&self, s: f64) -> (f64, Vec<f64>) {
            ((self.0)(s), vec![1.0, s])
        }

        fn mean_modes(&self) -> Vec<f64> {
            vec![2.0, 2.0]
        }
    }

    /// A convex gap touches in the middle, where the moment of its lift vanishes, along its tangent.
    #[test]
    fn a_gap_that_touches_in_one_point_has_its_tangent_there() {
        for factor in [1.0, 3.33, -1.0] {
            let found = lowest(&Line(|s| (factor * 0.7 * s).exp())).expect("a solution");
            let [value, slope] = [(0.7 * factor).exp(), 0.7 * factor * (0.7 * factor).exp()];
            let [shift, turn] = [found.coordinates[0], found.coordinates[1]];
            assert!((turn + slope).abs() < 1e-10 * slope.abs(), "{turn} {slope}");
            assert!((shift + turn + value).abs() < 1e-13 * value, "{shift} {turn}");
            assert!(found.amplification < 1e3, "{}", found.amplification);
        }
    }

    /// With a small kink there every slope between those of both sides is a solution: the mean one has no side of its own.
    #[test]
    fn a_kink_where_it_touches_takes_no_side() {
        let found = lowest(&Line(|s| (s - 1.0).powi(2) + 1e-3 * (s - 1.0).abs())).expect("a solution");
        assert!(found.coordinates[1].abs() < 1e-12, "{:?}", found.coordinates);
    }

    /// Turning about the start of the surface opens no gap that is negative there, whatever round-off says of the distance.
    #[test]
    fn a_gap_that_no_mode_opens_has_no_lowest_rigid_part() {
        struct Pinned(f64);
        impl Curve for Pinned {
            fn length(&self) -> f64 {
                2.0
            }
            fn samples(&self) -> Vec<f64> {
                (0..=100).map(|i| 0.02 * f64::from(i)).collect()
            }
            fn value(&self, s: f64) -> (f64, Vec<f64>) {
                (s - self.0, vec![s + 1e-17])
            }
            fn mean_modes(&self) -> Vec<f64> {
                vec![2.0]
            }
        }
        assert!(lowest(&Pinned(1e-3)).is_none());
        assert!(lowest(&Pinned(-1e-3)).is_some());
    }

    /// A dip between samples is seen, also where another touching point is the lowest sample.
    #[test]
    fn no_gap_dips_below_zero_between_samples() {
        let gap = |s: f64| (s - 0.513).powi(2) * (2.0 - s);
        let found = lowest(&Line(gap)).expect("a solution");
        let [shift, turn] = [found.coordinates[0], found.coordinates[1]];
        assert!(shift.abs() < 1e-14 && turn.abs() < 1e-14, "{shift:e} {turn:e}");
    }

    /// A dip is seen, too, right beside a sample that stands no higher than the parabola through it and its neighbours tells.
    #[test]
    fn no_gap_dips_below_zero_beside_a_sample() {
        for k in 0..200 {
            let low = 0.5 + 1e-4 * f64::from(k);
            let found = lowest(&Line(|s| (s - low).powi(2) * (2.0 - s) * (1.0 + 8.0 * s * s))).expect("a solution");
            let [shift, turn] = [found.coordinates[0], found.coordinates[1]];
            assert!(shift.abs() < 1e-13 && turn.abs() < 1e-13, "{low}: {shift:e} {turn:e}");
        }
    }

    /// On one side of a kink a dip lies between two samples, on the other side two lower ones, so that none beside the first dip is lower than both beside it.
    #[test]
    fn no_gap_dips_below_zero_beside_a_kink() {
        let gap = |s: f64| if s < 1.0 { (s - 0.992).powi(2) } else { 0.07 * (s - 1.03).powi(2) + 1e-6 };
        let found = lowest(&Line(gap)).expect("a solution");
        let above = |k: i32| gap(1e-5 * f64::from(k)) + found.coordinates[0] + found.coordinates[1] * 1e-5 * f64::from(k);
        let lowest = (0..=200_000).map(above).fold(f64::INFINITY, f64::min);
        assert!((-1e-14..1e-10).contains(&lowest), "{lowest:e}");
    }

    /// Apart from each other they are touching points as they are.
    #[test]
    fn a_gap_that_touches_in_two_points_rests_on_them() {
        let found = lowest(&Line(|s| ((s - 0.5) * (s - 1.5)).powi(2) + 0.3 - 0.1 * s)).expect("a solution");
        assert!(
            (found.coordinates[0] + 0.3).abs() < 1e-12 && (found.coordinates[1] - 0.1).abs() < 1e-12,
            "{:?}",
            found.coordinates
        );
    }
}
