//! The largest and the smallest pressure in words, with their places.

use wearshape::{PressureResult, Problem, Profile, Solution};

use crate::brief::brief;
use crate::contact_line::ContactLine;
use crate::place::place;

/// Largest relative difference of pressures that are one.
const SAME: f64 = 1e-9;
/// The same of extremes that a cut shows, over the largest.
const SEEN: f64 = 1e-6;
/// Most that a pressure between two points of a curve differs from those, relative.
const BETWEEN: f64 = 1e-2;

/// The largest and the smallest pressure of a surface of two dimensions, which no cut shows.
pub(crate) fn extremes(solution: &Solution, pressure: &PressureResult) -> Option<String> {
    let map = solution.map.as_ref()?;
    let (most, least) = (pressure.p_max?, pressure.p_min?);
    let cut = &solution.curve.as_ref()?.pressure;
    let seen = [cut.iter().copied().fold(0.0, f64::max), cut.iter().copied().fold(f64::INFINITY, f64::min)];
    if seen[0] >= most * (1.0 - SEEN) && seen[1] - least <= SEEN * most {
        return None;
    }
    let lowest = extreme(&map.pressure, |a, b| a < b * (1.0 - SAME))?;
    let Some([x, y, _]) = pressure.p_max_at.filter(|_| most - least > SAME * most) else {
        return Some(format!("{} MPa everywhere", brief(most)));
    };
    let round = |x: f64| if x.abs() < 1e-6 * map.position[0][0].hypot(map.position[0][1]) { 0.0 } else { x };
    let at = |[x, y]: [f64; 2]| format!("x = {}, y = {} mm", brief(round(x)), brief(round(y)));
    // The smallest pressure between points of the map has no place that is known.
    let is_there = map.pressure[lowest] <= least * (1.0 + SAME);
    let rest = if is_there {
        format!("{} MPa at {}", brief(least), at(map.position[lowest]))
    } else {
        format!("at least {} MPa", brief(least))
    };
    Some(format!("{} MPa at {}, {rest}", brief(most), at([x, y])))
}

fn extreme(values: &[f64], better: fn(f64, f64) -> bool) -> Option<usize> {
    let mut best: Option<usize> = None;
    for (row, value) in values.iter().enumerate().filter(|(_, value)| value.is_finite()) {
        if best.is_none_or(|best| better(*value, values[best])) {
            best = Some(row);
        }
    }
    best
}

/// "5.45455 MPa at 0 deg, 4.09091 MPa at -30 deg": of a curve of the wanted pressure its extremes between the points of the curve.
pub(crate) fn pressures(problem: &Problem, profile: &Profile, wanted: &PressureResult) -> Option<String> {
    let infinite = profile.pressure.iter().position(|pressure| *pressure == f64::INFINITY);
    let high = infinite.or_else(|| extreme(&profile.pressure, |a, b| a > b * (1.0 + SAME)))?;
    let low = extreme(&profile.pressure, |a, b| a < b * (1.0 - SAME))?;
    let (top, bottom) = (profile.pressure[high], profile.pressure[low]);
    if top.is_finite() && top - bottom <= SAME * top {
        return Some(format!("{} MPa everywhere", brief(top)));
    }
    let reach = profile.s.iter().fold(0.0f64, |most, s| most.max(s.abs()));
    let at = |row: usize, s: f64| {
        let mirrored = profile.pressure[profile.pressure.len() - 1 - row];
        let even = profile.s[row] < -SAME * reach && (mirrored - profile.pressure[row]).abs() <= SAME * top;
        if even { place(problem, -s.abs()).replacen('-', "+-", 1) } else { place(problem, s) }
    };
    let [peak, where_most] = largest(profile, high, wanted).unwrap_or([top, between(profile, high)]);
    let least =
        wanted.p_min.filter(|least| *least <= bottom * (1.0 + SAME) && *least >= bottom * (1.0 - BETWEEN)).unwrap_or(bottom);
    let most = if top.is_finite() { format!("{} MPa", brief(peak)) } else { "infinite".to_string() };
    Some(format!("{most} at {}, {} MPa at {}", at(high, where_most), brief(least), at(low, between(profile, low))))
}

/// The largest wanted pressure and its place along the curve, if the curve is that of the wanted pressure: if it lies beside the highest point.
fn largest(profile: &Profile, high: usize, wanted: &PressureResult) -> Option<[f64; 2]> {
    let (most, [x, y, z]) = wanted.p_max.zip(wanted.p_max_at)?;
    let top = profile.pressure[high];
    let s = ContactLine::new(&profile.position, &profile.s)?.nearest_value([x, z]);
    let beside =
        |row: Option<&f64>| row.is_some_and(|other| (s.abs() - profile.s[high].abs()).abs() <= (other - profile.s[high]).abs());
    let near = beside(profile.s.get(high + 1)) || beside(high.checked_sub(1).and_then(|row| profile.s.get(row)));
    // A curve is a cut of a surface of two dimensions, which may have its largest pressure elsewhere.
    let on_curve = (y - profile.position[high][1]).abs() <= SAME * x.hypot(z);
    (on_curve && near && top <= most * (1.0 + SAME) && top >= most * (1.0 - BETWEEN)).then_some([most, s])
}

/// Where the parabola through a point and its neighbours has its vertex; the point itself at an end, or where it is level with a neighbour.
fn between(profile: &Profile, row: usize) -> f64 {
    let here = profile.s[row];
    let neighbours = row.checked_sub(1).and_then(|before| Some([before, row + 1]).filter(|_| row + 1 < profile.s.len()));
    let Some([before, after]) = neighbours else { return here };
    let [a, b] = [before, after].map(|other| [profile.s[other] - here, profile.pressure[other] - profile.pressure[row]]);
    if !(a[1] * b[1] > 0.0 && (a[1] * b[1]).is_finite()) {
        return here;
    }
    // p = c1 x + c2 x^2 through both neighbours.
    let [slope_a, slope_b] = [a[1] / a[0], b[1] / b[0]];
    let bend = (slope_b - slope_a) / (b[0] - a[0]);
    here - 0.5 * (slope_a - bend * a[0]) / bend
}
