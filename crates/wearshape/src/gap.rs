//! The unloaded gap at the start, as a function of the place along the contact surface.

mod roughness;
mod rows;
mod smoothing;

use scene::{Cosine, Gap, GapSum, Rows};

use self::rows::RowCurve;
use self::smoothing::smoothed;
use crate::circles::Circles;
use crate::surface::Patch;

pub(crate) use self::roughness::Noise;
pub(crate) use self::smoothing::Residual;

/// Share of the contact surface within which a ring begins on the axis.
const ON_AXIS: f64 = 1e-12;

/// Most corners that get nodes, and how far from the ends of the surface and from each other they are at least, over half of it: others are rows as close as cells.
const MOST: usize = 8;
const APART: f64 = 1e-4;

/// The unloaded gap at the start: a sum of terms, none where both surfaces are one.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct StartGap {
    terms: Vec<Term>,
    /// How far a smooth curve is from the rows it was made of.
    pub residual: Option<Residual>,
}

/// A term of the gap. Lengths in mm.
#[derive(Debug, Clone, PartialEq)]
enum Term {
    /// `height ((s - middle) / half)^2`.
    Crown { middle: f64, half: f64, height: f64 },
    /// `slope (s - from)`.
    Wedge { from: f64, slope: f64 },
    /// `amplitude (1 - cos(2 pi s / length))`.
    Wave { amplitude: f64, length: f64 },
    /// A curve through or near measured rows.
    Rows(RowCurve),
    /// Two circles that touch.
    Circles(Circles),
}

impl StartGap {
    /// The gap of a checked scene: what `contact.gap` says, and the clearance of two circles. `patch` gives the ends of the surface, for a crown and
    /// a tilt; without one there is neither.
    pub(crate) fn new(given: Option<&Gap>, circles: Option<Circles>, patch: Option<&Patch>) -> StartGap {
        let mut gap = StartGap::default();
        match given {
            None | Some(Gap::Constant(_) | Gap::File(_)) => {}
            Some(Gap::Profile { s, gap: heights }) => gap.terms.push(Term::Rows(RowCurve::through(s, heights))),
            Some(Gap::Sum(sum)) => gap.add(sum, patch),
        }
        gap.terms.extend(circles.map(Term::Circles));
        gap
    }

    fn add(&mut self, sum: &GapSum, patch: Option<&Patch>) {
        if let Some([from, to]) = patch.and_then(Patch::places) {
            let on_axis = patch.is_some_and(Patch::is_ring) && from <= ON_AXIS * to;
            let (middle, half) = if on_axis { (0.0, to) } else { (0.5 * (from + to), 0.5 * (to - from)) };
            self.terms.extend(sum.crown.map(|height| Term::Crown { middle, half, height: height.0 }));
            let wedge = |slope: f64| Term::Wedge { from: if slope < 0.0 { to } else { from }, slope };
            self.terms.extend(sum.tilt.map(|angle| wedge(angle.0.tan())));
        }
        let wave = |Cosine { amplitude, wavelength }| Term::Wave { amplitude: amplitude.0, length: wavelength.0 };
        self.terms.extend(sum.cosine.map(wave));
        let Some(Rows::Columns { s, gap }) = &sum.profile else { return };
        let Some(most) = sum.smooth else {
            self.terms.push(Term::Rows(RowCurve::through(s, gap)));
            return;
        };
        let (curve, residual) = smoothed(s, gap, 1e3 * most.0);
        self.terms.push(Term::Rows(curve));
        self.residual = Some(residual);
    }

    /// Length (mm) of the waves that the gap has on a surface, the shorter ones where there are two kinds; none of a gap without waves.
    pub(crate) fn wavelength(&self, surface: [f64; 2]) -> Option<f64> {
        let of = |term: &Term| match term {
            Term::Wave { amplitude, length } => Some(*length).filter(|_| *amplitude > 0.0),
            Term::Rows(curve) => curve.turns(surface).wavelength(),
            _ => None,
        };
        self.terms.iter().filter_map(of).reduce(f64::min)
    }

    /// What the rows of a profile have of noise on a surface, if it is rough.
    pub(crate) fn noise(&self, surface: [f64; 2]) -> Option<Noise> {
        self.terms.iter().find_map(|term| if let Term::Rows(curve) = term { curve.noise(surface) } else { None })
    }

    /// Places from -1 to 1 along a surface at which the gap has a corner, under which the pressure is singular and needs nodes; none of a profile that has too many.
    pub(crate) fn corners(&self, [from, to]: [f64; 2]) -> Vec<f64> {
        let of = |term: &Term| if let Term::Rows(curve) = term { curve.corners() } else { Vec::new() };
        let places = self.terms.iter().flat_map(of).map(|s| (2.0 * s - from - to) / (to - from));
        let mut corners: Vec<f64> = places.filter(|t| t.abs() < 1.0 - APART).collect();
        corners.sort_unstable_by(f64::total_cmp);
        corners.dedup_by(|next, before| *next - *before < APART);
        if corners.len() > MOST { Vec::new() } else { corners }
    }

    /// Whether circles are among what makes the gap.
    pub(crate) fn has_circles(&self) -> bool {
        self.terms.iter().any(|term| matches!(term, Term::Circles(_)))
    }

    /// Whether both surfaces are one.
    pub(crate) fn is_none(&self) -> bool {
        self.terms.is_empty()
    }

    /// The gap (mm) at a place along the surface (mm).
    pub(crate) fn at(&self, s: f64) -> f64 {
        self.terms.iter().map(|term| term.at(s)).sum()
    }

    /// Where circles alone make the gap: the place where they touch (mm), and the radius (mm) of the cylinder on a plane with the same gap there.
    pub(crate) fn touch(&self) -> Option<(f64, f64)> {
        if let [Term::Circles(circles)] = self.terms.as_slice() { Some(circles.touch()) } else { None }
    }

    /// Largest less smallest gap (mm) of the rows of a profile, and of all terms but circles at the ends and the middle of a surface.
    pub(crate) fn spread(&self, surface: Option<[f64; 2]>) -> Option<f64> {
        let terms = || self.terms.iter().filter(|term| !matches!(term, Term::Circles(_)));
        let rows = terms().flat_map(|term| if let Term::Rows(curve) = term { curve.knots() } else { Vec::new() });
        let places = rows.chain(surface.into_iter().flat_map(|[from, to]| [from, 0.5 * (from + to), to]));
        let gaps: Vec<f64> = places.map(|s| terms().map(|term| term.at(s)).sum()).collect();
        let most = gaps.iter().copied().reduce(f64::max).filter(|_| terms().next().is_some())?;
        gaps.into_iter().reduce(f64::min).map(|least| most - least)
    }
}

impl Term {
    fn at(&self, s: f64) -> f64 {
        match self {
            Term::Crown { middle, half, height } => height * ((s - middle) / half).powi(2),
            Term::Wedge { from, slope } => slope * (s - from),
            // 1 - cos x = 2 sin^2(x/2), without cancellation.
            Term::Wave { amplitude, length } => {
                let number = std::f64::consts::TAU / length;
                2.0 * amplitude * (0.5 * number * s).sin().powi(2)
            }
            Term::Rows(curve) => 1e-3 * curve.at(s),
            Term::Circles(circles) => circles.gap(s),
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use scene::{Angle, Cosine, Gap, GapSum, Length, Rows};

    use super::StartGap;
    use crate::surface::Patch;
    use hpfem::Kinematics;

    fn gap(sum: GapSum, kinematics: Kinematics, x: [f64; 2]) -> StartGap {
        let patch = Patch::flat(kinematics, x, 0.0, None).unwrap();
        StartGap::new(Some(&Gap::Sum(sum)), None, Some(&patch))
    }

    #[test]
    fn a_sum_is_that_of_its_terms_each_zero_at_its_lowest_place() {
        let plane = Kinematics::PlaneStrain { thickness: 1.0 };
        let rows = Rows::Columns { s: vec![-20.0, 20.0], gap: vec![1.0, 3.0] };
        let all = GapSum {
            crown: Some(Length(0.01)),
            tilt: Some(Angle(1e-4)),
            cosine: Some(Cosine { amplitude: Length(1e-3), wavelength: Length(20.0) }),
            profile: Some(rows),
            smooth: None,
        };
        let sum = gap(all, plane, [10.0, 50.0]);
        for s in [-20.0_f64, -3.3, 0.0, 7.1, 20.0] {
            let wave = 1e-3 * (1.0 - (std::f64::consts::TAU * s / 20.0).cos());
            let expected = 0.01 * (s / 20.0).powi(2) + 1e-4_f64.tan() * (s + 20.0) + wave + 1e-3 * (2.0 + s / 20.0);
            assert!((sum.at(s) - expected).abs() < 1e-15, "{s}: {} {expected}", sum.at(s));
        }
        let falling = gap(GapSum { tilt: Some(Angle(-1e-4)), ..GapSum::default() }, plane, [10.0, 50.0]);
        assert!(falling.at(20.0) == 0.0 && (falling.at(-20.0) - 40.0 * 1e-4_f64.tan()).abs() < 1e-15);
    }

    #[test]
    fn a_crown_stands_on_the_axis_where_the_surface_begins_there() {
        let crown = GapSum { crown: Some(Length(0.01)), ..GapSum::default() };
        let disc = gap(crown.clone(), Kinematics::Axisymmetric, [0.0, 20.0]);
        assert_eq!([disc.at(0.0), disc.at(20.0)], [0.0, 0.01]);
        let ring = gap(crown, Kinematics::Axisymmetric, [10.0, 20.0]);
        assert_eq!([ring.at(10.0), ring.at(15.0), ring.at(20.0)], [0.01, 0.0, 0.01]);
    }
}
