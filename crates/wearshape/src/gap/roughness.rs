//! Waves of measured rows, their noise, and what their digits make of smooth ones.

use super::rows::RowCurve;

/// Share of all that the rows rise by which a turn has to be left behind to be one: what is less are the digits of a file.
const TURN: f64 = 1e-3;
/// Share of the rows that lie on the other side of the line through their neighbours than the row before does, from which they are noise: of independent
/// ones it is `acos(-2/3) / pi` = 0.73, of a wave with six rows a third, of a smooth curve none.
const NOISY: f64 = 0.5;
/// Part of the deviation up to which a row is on the line through its neighbours.
const BESIDE: f64 = 1e-3;
/// Share of the rows beside that line from which not a few corners but few digits make the rows bend.
const STEPPING: f64 = 0.2;
/// Most digits (um) behind the point that are few.
const FEW: i32 = 5;
/// Rows that say something about noise.
const ENOUGH: usize = 12;

/// The rows at which a curve turns from rising to falling or back.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Turns(Vec<f64>);

impl Turns {
    /// Mean length of the waves between the first turn and the last, two turns each; none of a curve without a whole wave.
    pub(super) fn wavelength(&self) -> Option<f64> {
        let [first, .., last] = self.0[..] else { return None };
        (self.0.len() > 2).then(|| 2.0 * (last - first) / (self.0.len() - 1) as f64)
    }
}

/// Noise of measured rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Noise {
    /// Rows that bend to the other side than the one before, of how many that bend, both ends among them.
    pub bends: [usize; 2],
    /// The last digit (um) of rows that are rounded to more than they bend.
    pub digit: Option<f64>,
    /// Standard deviation (um) of independent rows with the same distances from the lines through their neighbours; of rounded ones that of their digit.
    pub deviation: f64,
}

impl RowCurve {
    /// The turns of the curve on a surface.
    pub(super) fn turns(&self, surface: [f64; 2]) -> Turns {
        let (s, values) = self.rows(surface);
        let enough = TURN * rise(&values);
        let mut turns = Vec::new();
        // The row farthest in the direction the curve goes, once that is known.
        let (mut rises, mut far) = (None, 0);
        for row in 1..values.len() {
            let on = values[row] - values[far];
            match rises {
                None if on.abs() > enough => (rises, far) = (Some(on > 0.0), row),
                Some(up) if (on > 0.0) == up && on != 0.0 => far = row,
                Some(up) if on.abs() > enough => {
                    turns.push(s[far]);
                    (rises, far) = (Some(!up), row);
                }
                _ => {}
            }
        }
        Turns(turns)
    }

    /// The noise of the rows on a surface, if they are noisy.
    pub(super) fn noise(&self, surface: [f64; 2]) -> Option<Noise> {
        let (s, values) = self.rows(surface);
        let inner = s.len().saturating_sub(2);
        // Distance from the line through the neighbours, over the deviation that it has where each row has 1.
        let off = |i: usize| {
            let share = (s[i] - s[i - 1]) / (s[i + 1] - s[i - 1]);
            let between = values[i - 1] + share * (values[i + 1] - values[i - 1]);
            (values[i] - between) / (1.0 + share * share + (1.0 - share).powi(2)).sqrt()
        };
        let off: Vec<f64> = (1..=inner).map(off).collect();
        let deviation = (off.iter().map(|off| off * off).sum::<f64>() / inner.max(1) as f64).sqrt();
        // Rows of few digits stand on the line through their neighbours, and beside it where they step to the next digit.
        let beside: Vec<f64> = off.into_iter().filter(|off| off.abs() > BESIDE * deviation).collect();
        let bends = beside.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
        if beside.len() + 2 < ENOUGH {
            return None;
        }
        let (many, bends) = (beside.len(), [bends, beside.len() + 2]);
        if bends[0] as f64 >= NOISY * many as f64 && deviation > TURN * rise(&values) {
            return Some(Noise { bends, digit: None, deviation });
        }
        let digit = digit(&values).filter(|digit| many as f64 >= STEPPING * inner as f64 && deviation < *digit)?;
        Some(Noise { bends, digit: Some(digit), deviation: digit / 12f64.sqrt() })
    }
}

/// The last digit of values that have few.
fn digit(values: &[f64]) -> Option<f64> {
    let whole = |value: f64, digit: f64| (value / digit - (value / digit).round()).abs() < 1e-6;
    (0..=FEW).map(|digits| 0.1f64.powi(digits)).find(|digit| values.iter().all(|value| whole(*value, *digit)))
}

/// Largest less smallest value.
fn rise(values: &[f64]) -> f64 {
    let (least, most) = values.iter().fold((f64::MAX, f64::MIN), |(least, most), v| (least.min(*v), most.max(*v)));
    most - least
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use crate::gap::rows::RowCurve;

    const SURFACE: [f64; 2] = [-30.0, 30.0];

    fn rows(count: usize, value: impl Fn(f64, usize) -> f64) -> RowCurve {
        let s: Vec<f64> = (0..count).map(|i| -30.0 + 60.0 * i as f64 / (count - 1) as f64).collect();
        let values: Vec<f64> = s.iter().enumerate().map(|(i, s)| value(*s, i)).collect();
        RowCurve::through(&s, &values)
    }

    /// Independent numbers with mean 0 and variance 1, by a congruential generator.
    fn random(number: usize) -> f64 {
        let mut state = number as u64 + 1;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as f64 / (1u64 << 31) as f64
        };
        next();
        (0..12).map(|_| next()).sum::<f64>() - 6.0
    }

    #[test]
    fn waves_are_as_long_as_they_are_and_smooth_curves_have_none() {
        let wave = rows(121, |s, _| 3.0 * (std::f64::consts::TAU * s / 10.0).cos());
        let length = wave.turns(SURFACE).wavelength().unwrap_or_default();
        assert!((length - 10.0).abs() < 1e-9, "{length}");
        assert_eq!(wave.noise(SURFACE), None);
        // A wave on a part of the surface is as short.
        let part = rows(121, |s, _| if s > 5.0 { (std::f64::consts::TAU * s / 4.0).sin() } else { 0.0 });
        let length = part.turns(SURFACE).wavelength().unwrap_or_default();
        assert!((length - 4.0).abs() < 0.1, "{length}");
        // Nor have digits of a file, nor rows beyond the surface.
        let digits = rows(121, |s, _| (1e4 * (0.01 * s * s)).round() * 1e-4);
        assert_eq!((digits.turns(SURFACE).wavelength(), digits.noise(SURFACE)), (None, None));
        assert_eq!(wave.turns([-4.0, 4.0]).wavelength(), None);
    }

    /// Rows that bend less than their last digit step; those that bend more, and corners on whole numbers, are as they are.
    #[test]
    fn rows_of_a_smooth_curve_are_rounded_where_they_bend_less_than_their_digit() {
        let rounded = |most: f64, digit: f64| rows(61, |s, _| (most * (s / 30.0).powi(2) / digit).round() * digit).noise(SURFACE);
        for (most, digit) in [(10.0, 0.1), (3.0, 0.1), (10.0, 0.01), (3.0, 0.01)] {
            let noise = rounded(most, digit).unwrap();
            let found = noise.digit.unwrap_or(0.1);
            assert!((found / digit - 1.0).abs() < 1e-9 && noise.deviation < digit, "{most} {digit}: {noise:?}");
        }
        assert_eq!(rounded(10.0, 1e-4), None);
        assert_eq!(rows(61, |s, _| (s.abs() - 20.0).max(0.0)).noise(SURFACE), None);
    }

    #[test]
    fn noise_is_told_with_its_deviation_beside_any_smooth_curve() {
        let noisy = rows(601, |s, i| 2.0 + 20.0 * (s / 30.0).powi(2) + 0.3 * random(i));
        let noise = noisy.noise(SURFACE).map(|noise| noise.deviation).unwrap_or_default();
        assert!((noise - 0.3).abs() < 0.03, "{noise}");
        assert_eq!(rows(601, |s, _| 20.0 * (s / 30.0).powi(2)).noise(SURFACE), None);
    }
}
