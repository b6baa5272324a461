//! Two programs on one case.

use super::case::Case;
use super::process::Taken;
use super::spread::{Spread, ratios};

/// Both programs on one case: the runs of each in the order of time; none where one of them has no answer.
pub(crate) struct Row {
    pub(crate) case: Case,
    pub(crate) runs: Option<[Vec<Taken>; 2]>,
}

impl Row {
    /// Processor seconds of this tree's program over those of the earlier one.
    pub(crate) fn ratio(&self) -> Option<Spread> {
        let [old, new] = self.runs.as_ref()?;
        let seconds = |runs: &[Taken]| -> Vec<f64> { runs.iter().map(Taken::seconds).collect() };
        Spread::of(&ratios(&seconds(old), &seconds(new)))
    }

    /// Least seconds of both.
    pub(crate) fn seconds(&self) -> Option<[f64; 2]> {
        self.runs.as_ref().map(|runs| runs.each_ref().map(|runs| runs.iter().map(Taken::seconds).fold(f64::INFINITY, f64::min)))
    }

    /// Largest peak memory of both, MB.
    pub(crate) fn peaks(&self) -> Option<[f64; 2]> {
        self.runs.as_ref().map(|runs| runs.each_ref().map(|runs| runs.iter().map(|run| run.peak).fold(0.0, f64::max)))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_row_has_the_median_of_the_ratios_the_least_seconds_and_the_largest_peak() {
        let run = |user: f64, peak: f64| Taken { user, system: 0.5, peak };
        let case = Case { name: "a".into(), command: "run".into(), scene: "a".into(), set: vec![] };
        let runs = Some([vec![run(1.5, 10.0), run(3.5, 30.0)], vec![run(0.5, 5.0), run(1.5, 4.0)]]);
        let row = Row { case, runs };
        assert_eq!(row.ratio().unwrap().median, 0.5);
        assert_eq!((row.seconds(), row.peaks()), (Some([2.0, 1.0]), Some([30.0, 5.0])));
    }
}
