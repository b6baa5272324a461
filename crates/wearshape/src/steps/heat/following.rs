//! Bodies bent by the heat of a pressure that is yet to be found: one thermal load for each contact point, whose factor follows the force there.

use std::sync::Arc;

use contact::faer::Mat;
use contact::{ContactLoad, ContactOperator, SharedHeat, SpeedFactors};
use meshing::Cut;
use scene::Fault;

use crate::bodies::Reduced;
use crate::effort::Effort;
use crate::faults::unsolved;
use crate::heat::Split;
use crate::level::Level;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::heat::bodies::{Asked, HotBodies, Warm};
use crate::steps::heat::known::PointHeat;
use crate::steps::heat::smooth::Smooth;
use crate::steps::heat::warmed::{Second, Surfaces, Warmed};

/// What of a body's temperature follows the pressure.
pub(crate) enum Follows {
    /// The heat at each point by itself.
    Each,
    /// Sums of the heat at the points, one a row.
    Sums(Mat<f64>),
    /// Nothing: it is not distorted.
    Nothing,
}

/// Bodies bent by heat that follows the pressure.
pub(crate) struct Following<'a> {
    pub reduced: Arc<Reduced>,
    /// The bodies as problems of temperature.
    pub warmed: Arc<Warmed<'a>>,
    pub(crate) surfaces: Arc<Surfaces>,
    pub(super) follows: [Follows; 2],
    /// Heat into each body (mW) whose temperature is the load case of the heat; what follows the pressure is what is beyond it.
    about: [Vec<f64>; 2],
}

/// Factors on the sliding speed.
pub(crate) struct Speeds {
    /// Those of the points in contact.
    pub factors: SpeedFactors,
    /// That of separation by the heat of friction, of surfaces without a gap, whose points all are; one that there is is not told where heat bends the bodies
    /// without friction too, for then it is the load that holds them together.
    pub separation: Option<Option<f64>>,
}

impl<'a> Following<'a> {
    /// Bodies of a level; none of a scene without heat.
    pub(crate) fn new(stage: Stage<'a>, level: Level, cut: Cut<'_>) -> Result<Option<(Following<'a>, Effort)>, Fault> {
        let Some((bodies, mut effort)) = HotBodies::new(stage, level, (cut, Asked::Anything))? else { return Ok(None) };
        let following = effort.timed(Step::Heat, stage.clock(), |_| Following::of(&bodies))?;
        Ok(Some((following, effort)))
    }

    /// Bodies that are there.
    pub(crate) fn of(bodies: &HotBodies<'a>) -> Result<Following<'a>, Fault> {
        let n = bodies.warm.surfaces.points.len();
        Ok(Following::made(&bodies.warm, Arc::new(bodies.by_units()?), || Follows::Each, [vec![0.0; n], vec![0.0; n]]))
    }

    /// Bodies that were made for heat near a known one; none of others.
    pub(crate) fn as_asked(bodies: &HotBodies<'a>, wanted: Smooth) -> Result<Option<Following<'a>>, Fault> {
        let asked = bodies.asked()?;
        Ok(asked.map(|(heat, reduced)| Following::on(&bodies.warm, Arc::new(reduced), (heat, wanted))))
    }

    /// Bodies with the loads of heat near a known one: exact at that heat, and beyond it for what is smooth along the surface. It takes as many temperatures
    /// as [`Surfaces::smooth`] has, whatever the number of points.
    pub(crate) fn on(warm: &Warm<'a>, reduced: Arc<Reduced>, (heat, wanted): (&PointHeat, Smooth)) -> Following<'a> {
        let sums = || Follows::Sums(warm.surfaces.smooth(wanted).transpose().to_owned());
        Following::made(warm, reduced, sums, heat.into.clone())
    }

    fn made(warm: &Warm<'a>, reduced: Arc<Reduced>, body: impl Fn() -> Follows, about: [Vec<f64>; 2]) -> Following<'a> {
        let second = match warm.bodies.second {
            Second::Body(_) => body(),
            Second::Drum(_) => Follows::Sums(Mat::full(1, warm.surfaces.points.len(), 1.0)),
            Second::Fresh(_) => Follows::Nothing,
        };
        let (warmed, surfaces) = (Arc::clone(&warm.bodies), Arc::clone(&warm.surfaces));
        Following { reduced, warmed, surfaces, follows: [body(), second], about }
    }

    /// Factors on the sliding speed for points in contact whose heat acts as far as it is smooth along the surface: without what is as fine as the points.
    pub(crate) fn smooth_factors(
        &self,
        operator: &ContactOperator<'_>,
        (base, closed): (&ContactLoad, &[bool]),
    ) -> Result<SpeedFactors, Fault> {
        let (points, smooth) = (&self.surfaces.points, self.surfaces.smooth(Smooth::Coarse));
        let kept = Mat::from_fn(points.len(), smooth.ncols(), |i, k| points[i].weight * smooth[(i, k)]) * smooth.transpose();
        let mut shared = self.shared(closed)?;
        shared.into = shared.into.map(|into| &kept * into);
        operator.speed_factors(&self.fitting(base, &self.surfaces.rates, &shared), closed).map_err(unsolved)
    }

    /// Factors on the sliding speed for points in contact, and that of separation, where normal forces make heat at these rates (mm/s).
    pub(crate) fn speeds(
        &self,
        operator: &ContactOperator<'_>,
        (base, closed): (&ContactLoad, &[bool]),
        rates: &[f64],
    ) -> Result<Speeds, Fault> {
        let all = vec![true; closed.len()];
        let (whole, separation) = operator.closed_factors(&self.fitting(base, rates, &self.shared(&all)?)).map_err(unsolved)?;
        let factors = match closed == all {
            true => whole,
            false => operator.speed_factors(&self.fitting(base, rates, &self.shared(closed)?), closed).map_err(unsolved)?,
        };
        let is_told = separation.is_none() || self.warmed.heat.is_even_without_friction();
        let separation = is_told.then_some(separation);
        Ok(Speeds { factors, separation })
    }

    /// Factors on the sliding speed for these points in contact.
    pub(crate) fn factors(
        &self,
        operator: &ContactOperator<'_>,
        base: &ContactLoad,
        closed: &[bool],
    ) -> Result<SpeedFactors, Fault> {
        let load = self.fitting(base, &self.surfaces.rates, &self.shared(closed)?);
        operator.speed_factors(&load, closed).map_err(unsolved)
    }

    /// The load of bodies that fit where nothing heats them.
    pub(super) fn fitting(&self, base: &ContactLoad, rates: &[f64], shared: &SharedHeat) -> ContactLoad {
        let mut load = self.load(base, shared, rates);
        load.factors.iter_mut().zip(&base.factors).for_each(|(factors, base)| factors[base.len()..].fill(0.0));
        load
    }

    /// Heat that normal forces make at a part of the sliding speed (mm/s).
    pub(super) fn rates(&self, speed: f64) -> Vec<f64> {
        self.surfaces.rates.iter().map(|rate| speed * rate).collect()
    }

    /// Whether what points are in contact decides how the heat is shared.
    pub(crate) fn conducts(&self) -> bool {
        matches!(self.warmed.heat.split, Split::Conductance(_))
    }

    pub(super) fn shared(&self, closed: &[bool]) -> Result<SharedHeat, Fault> {
        self.surfaces.shared(self.warmed.heat, closed)
    }

    /// A load with that of the heat of points that are all in contact.
    pub(crate) fn all_closed(&self, base: &ContactLoad) -> Result<ContactLoad, Fault> {
        let shared = self.shared(&vec![true; self.surfaces.points.len()])?;
        Ok(self.load(base, &shared, &self.surfaces.rates))
    }

    /// A load with that of the heat that normal forces make at these rates (mm/s).
    pub(super) fn load(&self, base: &ContactLoad, shared: &SharedHeat, rates: &[f64]) -> ContactLoad {
        let mut load = base.clone();
        let n = self.surfaces.points.len();
        for (body, follows) in self.follows.iter().enumerate() {
            let cases = load.factors[body].len();
            let by_force = Mat::from_fn(n, n, |i, j| shared.into[body][(i, j)] * rates[j]);
            let beyond: Vec<f64> = shared.still[body].iter().zip(&self.about[body]).map(|(still, about)| still - about).collect();
            let (factors, rows) = match follows {
                Follows::Each => (beyond, by_force),
                Follows::Sums(sums) => (product(sums, &beyond), sums * by_force),
                Follows::Nothing => continue,
            };
            load.factors[body].push(1.0);
            load.factors[body].extend(factors);
            let following =
                Mat::from_fn(cases + 1 + rows.nrows(), n, |i, j| if i > cases { rows[(i - cases - 1, j)] } else { 0.0 });
            load.following[body] = Some(following);
        }
        load
    }
}

fn product(matrix: &Mat<f64>, x: &[f64]) -> Vec<f64> {
    (0..matrix.nrows()).map(|i| x.iter().enumerate().map(|(j, x)| matrix[(i, j)] * x).sum()).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::bodies::Bodies;
    use crate::options::Options;
    use crate::steps::heat::hot::Hot;
    use crate::steps::start_gap::start_gaps;

    /// What is asked of the hot bodies of a scene.
    fn on_bodies<T>(name: &str, settings: &[&str], asked: impl Fn(Stage<'_>, &HotBodies<'_>) -> T) -> T {
        let all: Vec<String> = ["tasks=[contact]"].iter().chain(settings).map(|text| text.to_string()).collect();
        let document = scene::Document::read("scene.toml", scene::builtin(name).unwrap().text, &all).unwrap();
        let problem = crate::problem::Problem::new(&document, &|file| Err(file.to_string())).unwrap();
        let (options, kept) = (Options::default(), Bodies::default());
        let stage = Stage::new(&problem, &options, &kept).unwrap();
        let level = Level { degree: 6, layers: 2, slow: false, even: false };
        let (bodies, _) = HotBodies::new(stage, level, (Cut::Plain, Asked::Anything)).unwrap().unwrap();
        asked(stage, &bodies)
    }

    /// Area norm of the difference of pressures over that of the pressure, of bodies whose heat is near a known one from those whose heat is of each point: near the
    /// heat of the contact itself, near half of it, and near half of it where what is beyond may only be even.
    fn misses(stage: Stage<'_>, bodies: &HotBodies<'_>) -> [f64; 3] {
        let solved = |following: &Following<'_>| {
            let pair = following.reduced.pair().unwrap();
            let operator = following.reduced.operator(&pair, stage.friction() > 0.0).unwrap();
            let gap = start_gaps(stage, &operator);
            let hot = following.solve(&operator, &gap, &stage.contact_load(operator.points())).unwrap();
            assert!(hot.found.status.is_solved(), "{:?}", hot.found.status);
            hot
        };
        let whole = solved(&Following::of(bodies).unwrap());
        let points = &bodies.warm.surfaces.points;
        let norm = |of: &dyn Fn(usize) -> f64| (0..points.len()).map(|i| points[i].weight * of(i).powi(2)).sum::<f64>().sqrt();
        let apart = |hot: &Hot| {
            let difference = |i: usize| whole.found.pressure[i] - hot.found.pressure[i];
            norm(&difference) / norm(&|i| whole.found.pressure[i])
        };
        let n = bodies.warm.surfaces.points.len();
        let halves = |of: &[f64]| of.iter().map(|heat| 0.5 * heat).collect::<Vec<f64>>();
        let half = PointHeat { friction: halves(&whole.heat.friction), into: [0, 1].map(|body| halves(&whole.heat.into[body])) };
        let area: f64 = bodies.warm.surfaces.points.iter().map(|point| point.weight).sum();
        let even = bodies.about(&half, &Mat::full(n, 1, 1.0)).unwrap();
        let even =
            Following::made(&bodies.warm, Arc::new(even), || Follows::Sums(Mat::full(1, n, 1.0 / area)), half.into.clone());
        let near = |heat: &PointHeat| Arc::new(bodies.about(heat, &bodies.warm.surfaces.smooth(Smooth::Little)).unwrap());
        let smooth =
            [&whole.heat, &half].map(|heat| apart(&solved(&Following::on(&bodies.warm, near(heat), (heat, Smooth::Little)))));
        [smooth[0], smooth[1], apart(&solved(&even))]
    }

    #[test]
    fn heat_near_a_known_one_gives_the_contact_of_all_heat() {
        for (name, settings) in [("clutch-hot", &[][..]), ("drum-brake-hot", &["sliding.omega=0.5"])] {
            let misses = on_bodies(name, settings, misses);
            assert!(misses[0] < 1e-9 && misses[1] < 1e-2 && misses[2] > 2.0 * misses[1], "{name} {misses:?}");
        }
    }

    #[test]
    fn points_in_contact_and_those_that_conduct_are_found_together() {
        on_bodies("drum-brake-hot", &[], |stage, bodies| {
            let following = Following::of(bodies).unwrap();
            let pair = following.reduced.pair().unwrap();
            let operator = following.reduced.operator(&pair, stage.friction() > 0.0).unwrap();
            let (gap, load) = (start_gaps(stage, &operator), stage.contact_load(operator.points()));
            let found = following.solve(&operator, &gap, &load).unwrap().found;
            assert!(found.status.is_solved() && found.iterations <= 2, "{:?} {}", found.status, found.iterations);
            // The points in contact are those that conduct.
            let held = following.held(&operator, &gap, &load, (1.0, &found.closed)).unwrap().unwrap().found;
            let largest = found.pressure.iter().fold(0.0, |most: f64, p| most.max(*p));
            assert!(held.complementarity < 1e-9 && found.closed.contains(&false) && found.closed.contains(&true));
            assert!(found.pressure.iter().zip(&held.pressure).all(|(a, b)| (a - b).abs() < 1e-9 * largest));
            // From a contact that is near it is found again.
            let again = following.solve_from(&operator, &gap, &load, &found).unwrap().found;
            assert_eq!(again.closed, found.closed);
        });
    }

    #[test]
    fn smooth_heat_has_the_first_speed_at_which_a_contact_is_singular_and_not_those_of_the_mesh() {
        let [all, smooth] = on_bodies("clutch-hot", &[], |stage, bodies| {
            let following = Following::of(bodies).unwrap();
            let pair = following.reduced.pair().unwrap();
            let operator = following.reduced.operator(&pair, stage.friction() > 0.0).unwrap();
            let at = (&stage.contact_load(operator.points()), &vec![true; operator.points().len()][..]);
            let all = following.speeds(&operator, at, &following.surfaces.rates).unwrap().factors;
            [all.singular, following.smooth_factors(&operator, at).unwrap().singular]
        });
        assert!((smooth[0] / all[0] - 1.0).abs() < 1e-6 && smooth.len() < all.len(), "{smooth:?} {all:?}");
    }
}
