//! Waves of measured rows, and their noise.

use super::rows::RowCurve;

/// Share of all that the rows rise by which a turn has to be left behind to be one: what is less are the digits of a file.
const TURN: f64 = 1e-3;
/// Share of the rows that lie on the other side of the line through their neighbours than the row before does, from which they are noise: of independent
/// ones it is `acos(-2/3) / pi` = 0.73, of a wave with six rows a third, of a smooth curve none.
const NOISY: f64 = 0.5;
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
    /// Rows that bend to the other side than the one before, of how many.
    pub bends: [usize; 2],
    /// Standard deviation (um) of independent rows with the same distances from the lines through their neighbours.
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
        let bends = off.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
        let deviation = (off.iter().map(|off| off * off).sum::<f64>() / inner.max(1) as f64).sqrt();
        let noisy = s.len() >= ENOUGH && bends as f64 >= NOISY * inner as f64 && deviation > TURN * rise(&values);
        noisy.then_some(Noise { bends: [bends, s.len()], deviation })
    }
}

/// Largest less smallest value.
fn rise(values: &[f64]) -> f64 {
    let (least, most) = values.iter().fold((f64::MAX, f64::MIN), |(least, most), v| (least.min(*v), most.max(*v)));
    most - least
}

#[cfg(test)]
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

    #[test]
    fn noise_is_told_with_its_deviation_beside_any_smooth_curve() {
        let noisy = rows(601, |s, i| 2.0 + 20.0 * (s / 30.0).powi(2) + 0.3 * random(i));
        let noise = noisy.noise(SURFACE).map(|noise| noise.deviation).unwrap_or_default();
        assert!((noise - 0.3).abs() < 0.03, "{noise}");
        assert_eq!(rows(601, |s, _| 20.0 * (s / 30.0).powi(2)).noise(SURFACE), None);
    }
}
