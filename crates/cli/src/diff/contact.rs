//! The curves of two tables of contact points: pressure, and gap without its best rigid part.

/// Largest and mean-square difference of a column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Apart {
    /// Largest difference, in the unit of the column.
    pub(crate) largest: f64,
    /// It, relative to the largest value of the first.
    pub(crate) largest_relative: f64,
    /// L2 norm of the difference over the area, relative to that of the first.
    pub(crate) l2_relative: f64,
    /// What interpolation may have added to the largest, relative: how far a cubic through four points is from a straight line between two.
    pub(crate) interpolation_relative: f64,
}

/// What two tables are apart by.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Contact {
    /// Points of the first table that were compared.
    pub(crate) points: usize,
    /// Whether the second was interpolated over s: the points are not the same.
    pub(crate) interpolated: bool,
    /// Of the pressures, where both have one.
    pub(crate) pressure: Option<Apart>,
    /// Of the gaps, where both have one.
    pub(crate) gap: Option<Apart>,
}

/// One table: its places, and its columns.
pub(crate) struct Table<'a>(pub(crate) &'a str);

impl Table<'_> {
    fn column(&self, name: &str) -> Vec<f64> {
        report::column(self.0, name).unwrap_or_default()
    }

    fn vectors(&self, names: [&str; 3]) -> Vec<[f64; 3]> {
        let [x, y, z] = names.map(|name| self.column(name));
        x.iter().zip(&y).zip(&z).map(|((x, y), z)| [*x, *y, *z]).collect()
    }

    /// Positions and normals of the points.
    pub(crate) fn places(&self) -> [Vec<[f64; 3]>; 2] {
        [self.vectors(["x_mm", "y_mm", "z_mm"]), self.vectors(["nx", "ny", "nz"])]
    }
}

/// Compares two tables; `closing` are the closing velocities of the free rigid modes at the points of the first, one list a mode.
///
/// # Errors
/// Why they cannot be compared.
pub(crate) fn compare(a: &Table<'_>, b: &Table<'_>, closing: &[Vec<f64>]) -> Result<Contact, String> {
    let (places, others) = (a.column("s_mm"), b.column("s_mm"));
    let same = places == others && a.places()[0] == b.places()[0];
    let ascending = |s: &[f64]| s.len() > 1 && s.windows(2).all(|pair| pair[0] < pair[1]);
    let lines = ascending(&places) && ascending(&others);
    if !same && !lines {
        return Err("their points are not the same, and not in order along a line: compare runs with the same --sample N".into());
    }
    let (first, last) = (others.first().copied().unwrap_or(0.0), others.last().copied().unwrap_or(0.0));
    let within: Vec<usize> = (0..places.len()).filter(|k| same || (first..=last).contains(&places[*k])).collect();
    if within.is_empty() {
        return Err("their surfaces have no s in common".into());
    }
    let weight = a.column("weight_mm2");
    let area: Vec<f64> = within.iter().map(|k| weight.get(*k).copied().unwrap_or(1.0)).collect();
    let apart = |name: &str, modes: &[Vec<f64>]| {
        let (of_a, of_b) = (a.column(name), b.column(name));
        let value = |k: usize| if same { of_b.get(k).map(|b| [*b, *b]) } else { interpolated(&others, &of_b, places[k]) };
        let rows = within.iter().zip(&area).filter_map(|(k, area)| Some((*k, *area, *of_a.get(*k)?, value(*k)?)));
        let rows: Vec<_> = rows.filter(|(_, _, a, [b, _])| a.is_finite() && b.is_finite()).collect();
        let pick = |mode: &Vec<f64>| rows.iter().map(|(k, ..)| mode.get(*k).copied().unwrap_or(0.0)).collect();
        let weights: Vec<f64> = rows.iter().map(|(_, area, ..)| *area).collect();
        let difference = rows.iter().map(|(_, _, a, [b, _])| a - b).collect();
        let difference = without(difference, modes.iter().map(pick).collect(), &weights);
        let first: Vec<f64> = rows.iter().map(|(_, _, a, _)| *a).collect();
        let doubt: Vec<f64> = rows.iter().map(|(_, _, _, [cubic, straight])| cubic - straight).collect();
        (!rows.is_empty()).then(|| Apart {
            largest: largest(&difference),
            largest_relative: per(largest(&difference), largest(&first)),
            l2_relative: per(dot(&difference, &difference, &weights).sqrt(), dot(&first, &first, &weights).sqrt()),
            interpolation_relative: per(largest(&doubt), largest(&first)),
        })
    };
    let (pressure, gap) = (apart("pressure_MPa", &[]), apart("gap_um", closing));
    Ok(Contact { points: within.len(), interpolated: !same, pressure, gap })
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, value| largest.max(value.abs()))
}

fn per(difference: f64, size: f64) -> f64 {
    if difference == 0.0 { 0.0 } else { difference / size.max(f64::MIN_POSITIVE) }
}

/// The value at a place, by the cubic through the four points around it, and by the straight line between two of them.
fn interpolated(s: &[f64], values: &[f64], at: f64) -> Option<[f64; 2]> {
    let right = s.partition_point(|place| *place < at).clamp(1, s.len() - 1);
    // At a point itself its neighbours do not matter, known or not.
    if let Some(known) = [right - 1, right].into_iter().find(|k| s[*k] == at) {
        return Some([*values.get(known)?; 2]);
    }
    let from = right.saturating_sub(2).min(s.len().saturating_sub(4));
    let through = |points: std::ops::Range<usize>| -> Option<f64> {
        let weight = |k: usize| {
            points.clone().filter(|other| *other != k).map(|other| (at - s[other]) / (s[k] - s[other])).product::<f64>()
        };
        points.clone().map(|k| Some(values.get(k)? * weight(k))).sum()
    };
    let straight = through(right - 1..right + 1)?;
    let cubic = through(from..s.len().min(from + 4)).filter(|value| value.is_finite());
    Some([cubic.unwrap_or(straight), straight])
}

fn dot(a: &[f64], b: &[f64], weights: &[f64]) -> f64 {
    a.iter().zip(b).zip(weights).map(|((a, b), weight)| a * b * weight).sum()
}

/// Values without their best combination of some modes: those are made orthogonal one after another, and taken off.
fn without(mut values: Vec<f64>, modes: Vec<Vec<f64>>, weights: &[f64]) -> Vec<f64> {
    let take_off = |values: &mut [f64], mode: &[f64]| {
        let share = dot(values, mode, weights) / dot(mode, mode, weights);
        values.iter_mut().zip(mode).for_each(|(value, mode)| *value -= share * mode);
    };
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for mut mode in modes {
        let size = dot(&mode, &mode, weights);
        // Twice is enough.
        (0..2).for_each(|_| basis.iter().for_each(|known| take_off(&mut mode, known)));
        if dot(&mode, &mode, weights) > 1e-20 * size {
            basis.push(mode);
        }
    }
    (0..2).for_each(|_| basis.iter().for_each(|mode| take_off(&mut values, mode)));
    values
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn table(count: usize, gap: impl Fn(f64) -> f64) -> String {
        let row = |k: usize| {
            let x = -1.0 + 2.0 * k as f64 / (count - 1) as f64;
            format!("{x},{x},0,0,0,0,1,1,{},{}\n", 2.0 + x, gap(x))
        };
        "s_mm,x_mm,y_mm,z_mm,nx,ny,nz,weight_mm2,pressure_MPa,gap_um\n".to_string() + &(0..count).map(row).collect::<String>()
    }

    #[test]
    fn the_best_rigid_part_of_a_gap_is_no_difference() {
        let (a, b) = (table(21, |x| x * x), table(21, |x| x * x + 3.0 - 0.5 * x));
        let closing = vec![vec![1.0; 21], (0..21).map(|k| -1.0 + 0.1 * f64::from(k)).collect()];
        let gap = |closing: &[Vec<f64>]| compare(&Table(&a), &Table(&b), closing).unwrap().gap.unwrap().largest;
        assert!((gap(&[]) - 3.5).abs() < 1e-12 && gap(&closing) < 1e-12);
        // A mode that is there twice is one.
        assert!(gap(&[closing.clone(), closing.clone()].concat()) < 1e-12);
    }

    #[test]
    fn other_points_are_interpolated_over_s() {
        let (a, b) = (table(21, |x| 3.0 * x), table(8, |x| 3.0 * x + 0.25));
        let found = compare(&Table(&a), &Table(&b), &[]).unwrap();
        assert!(found.interpolated && found.points == 21 && found.pressure.unwrap().largest < 1e-14);
        assert!((found.gap.unwrap().largest - 0.25).abs() < 1e-14);
    }
}
