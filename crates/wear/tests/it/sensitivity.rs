//! One per cent more of each given number: against central differences of full solves, and against the relations that units demand.

use nalgebra::Vector3;
use wear::{
    Counterface, Functional, Given, Modes, Optimum, Problem, Regime, RigidMode, RigidMotion, Sensitivity, Shape, SlidingMotion,
    Surface, SurfacePoint, WearLaw, WearPair, one_percent, optimal_pressure,
};

use crate::surfaces::{annulus, drum, punch};

/// A problem of body factors beta mu^b, so that all numbers can be moved one by one.
#[derive(Clone, Debug)]
struct Data {
    name: &'static str,
    surface: Surface,
    beta: [f64; 2],
    a: [f64; 2],
    b: [f64; 2],
    mu: f64,
    modes: Vec<RigidMode>,
    functional: Functional,
    q: f64,
    kind: Modes,
    counterface: Counterface,
    p_max: Option<f64>,
}

impl Data {
    fn new(name: &'static str, surface: Surface) -> Data {
        Data {
            name,
            surface,
            beta: [3e-7, 0.0],
            a: [0.8, 1.0],
            b: [1.4, 1.0],
            mu: 0.3,
            modes: vec![RigidMode::press_down(900.0)],
            functional: Functional::Steady,
            q: 1.0,
            kind: Modes::Kinematic,
            counterface: Counterface::Fresh,
            p_max: None,
        }
    }

    /// Two wearing bodies with different rules.
    fn two(name: &'static str, surface: Surface) -> Data {
        Data { beta: [3e-7, 5e-7], a: [0.8, 1.3], b: [1.4, 2.1], counterface: Counterface::Congruent, ..Data::new(name, surface) }
    }

    fn tilted(mut self, moment: f64) -> Data {
        self.modes.push(RigidMode::tilt(moment, Vector3::zeros()));
        self
    }

    fn problem(&self) -> Problem {
        Problem {
            wear: WearPair::from_beta(self.beta, self.mu, self.a, self.b).unwrap(),
            friction: self.mu,
            functional: self.functional.clone(),
            q: self.q,
            mode_kind: self.kind,
            counterface: self.counterface,
            p_max: self.p_max,
            ..Problem::new(self.surface.clone(), WearLaw::NONE, self.modes.clone())
        }
    }

    /// The same with one number multiplied.
    fn scaled(&self, given: Given, factor: f64) -> Data {
        let mut data = self.clone();
        let motion = |by: f64| {
            let m = self.surface.motion();
            SlidingMotion { velocity: m.velocity * by, angular_velocity: m.angular_velocity * by, about: m.about }
        };
        match given {
            Given::Resultant(k) => data.modes[k].resultant *= factor,
            Given::Friction => data.mu *= factor,
            Given::WearFactor(i) => data.beta[i] *= factor,
            Given::PressureExponent(i) => data.b[i] *= factor,
            Given::SpeedExponent(i) => data.a[i] *= factor,
            Given::SlidingSpeed if self.surface.range() == (0.0, 0.0) => {
                let moved = |p: &SurfacePoint| SurfacePoint { sliding_speed: p.sliding_speed * factor, ..*p };
                let points = self.surface.sample(0).iter().map(moved).collect();
                data.surface = with_track(Surface::from_points(points).unwrap(), &self.surface);
            }
            Given::SlidingSpeed => data.surface = Surface::new(self.surface.shape().clone(), motion(factor)).unwrap(),
            Given::Thickness => {
                let mut shape = self.surface.shape().clone();
                if let Shape::Arc { thickness, .. } | Shape::Strip { thickness, .. } = &mut shape {
                    *thickness *= factor;
                }
                data.surface = Surface::new(shape, motion(1.0)).unwrap();
            }
            Given::PressureCap => data.p_max = data.p_max.map(|cap| cap * factor),
        }
        data
    }
}

fn with_track(surface: Surface, like: &Surface) -> Surface {
    match like.track_area() {
        Some(area) => surface.with_track_area(area),
        None => surface,
    }
}

/// Mean rate of the gap times the area, from the pressures of an answer; constants that no number moves are left out.
fn wear_rate(data: &Data, optimum: &Optimum) -> f64 {
    let problem = data.problem();
    let volume = |i: usize| -> f64 {
        let rule = &problem.wear.rules[i];
        optimum.points.iter().zip(&optimum.pressure).map(|(pt, p)| pt.weight * rule.rate(*p, pt.sliding_speed)).sum()
    };
    let area = data.surface.area();
    match data.counterface {
        Counterface::Fresh => volume(0) / area,
        Counterface::Congruent => (volume(0) + volume(1)) / area,
        Counterface::Revolving => volume(0) / area + volume(1) / data.surface.track_area().unwrap(),
    }
}

/// Friction power over a speed.
fn torque(data: &Data, optimum: &Optimum) -> f64 {
    let motion = data.surface.motion();
    let speed = motion.velocity.norm() + motion.angular_velocity.norm();
    optimum.friction_power / if speed > 0.0 { speed } else { data.surface.sample(0)[0].sliding_speed }
}

fn cases() -> Vec<Data> {
    let internal = Shape::Arc { radius: 100.0, centre: Vector3::zeros(), angles: [0.3, 1.9], thickness: 12.0, internal: true };
    let shoe = Surface::new(internal, SlidingMotion::in_plane(3.0, Vector3::zeros())).unwrap();
    let pad = Shape::Sector { radii: [60.0, 110.0], angles: [-0.4, 0.5] };
    let pad = Surface::new(pad, SlidingMotion::about_z(4.0)).unwrap();
    let pinned = RigidMode {
        motion: RigidMotion::Rotation { axis: Vector3::y(), about: Vector3::new(-30.0, 0.0, -80.0) },
        resultant: 2e5,
    };
    let listed = |n: usize| {
        let ring = annulus().sample(n);
        Surface::from_points(ring).unwrap().with_track_area(9e4)
    };
    let mut cases = vec![
        Data::new("annulus, steady", annulus()),
        Data::new("drum, steady", drum()),
        Data { kind: Modes::Associated, ..Data::new("drum, associated", drum()) },
        Data::new("punch, full contact", punch()).tilted(1500.0),
        Data::new("punch beyond the kern", punch()).tilted(16000.0),
        Data { modes: vec![pinned], ..Data::new("pinned internal shoe", shoe) },
        Data { functional: Functional::FrictionPower, q: 2.0, ..Data::new("friction power", annulus()) },
        Data { functional: Functional::Uniform, ..Data::new("uniform", drum()) },
        Data { functional: Functional::WearVolume, q: 0.0, ..Data::new("q = 0", drum()) },
        Data { functional: Functional::WearVolume, q: f64::INFINITY, ..Data::new("q infinite", annulus()) },
        Data { functional: Functional::WearVolume, q: 1.7, ..Data::new("wear volume", pad.clone()) }.tilted(74000.0),
        Data { functional: Functional::WearPower, q: 0.2, ..Data::new("maximum", punch()) }.tilted(1500.0),
        Data::two("two bodies, steady", annulus()),
        Data { b: [1.4; 2], ..Data::two("two bodies, one b", annulus()) },
        Data { a: [0.8; 2], b: [1.4; 2], ..Data::two("two bodies, one rule", annulus()) },
        Data { counterface: Counterface::Fresh, ..Data::two("fresh plate", punch()) }.tilted(1500.0),
        Data { functional: Functional::WearPower, q: 1.6, ..Data::two("two bodies, q", annulus()) },
        Data { functional: Functional::WearVolume, q: 1.6, b: [1.4; 2], ..Data::two("two bodies, q, one b", annulus()) },
        Data { functional: Functional::WearPower, q: 1.6, a: [0.8; 2], b: [1.4; 2], ..Data::two("two bodies, q, one rule", pad) },
        Data { functional: Functional::WearPower, q: 1.3, ..Data::two("two bodies, q, moment", punch()) }.tilted(1500.0),
        Data { counterface: Counterface::Revolving, ..Data::two("revolving drum", drum()) },
        Data { counterface: Counterface::Revolving, ..Data::two("revolving, listed", listed(40)) },
        Data::new("listed points", listed(40)),
    ];
    let mut capped = Data::new("capped", annulus());
    capped.p_max = Some(0.8 * optimal_pressure(&capped.problem()).unwrap().p_max);
    cases.push(capped);
    let mut capped = Data::two("capped, two bodies and a moment", punch()).tilted(6000.0);
    capped.p_max = Some(0.85 * optimal_pressure(&capped.problem()).unwrap().p_max);
    let mut one = Data::new("capped in full contact", punch()).tilted(2500.0);
    one.p_max = Some(0.95 * optimal_pressure(&one.problem()).unwrap().p_max);
    cases.push(one);
    let mut one = Data::new("capped beyond the kern", punch()).tilted(14000.0);
    one.p_max = Some(0.85 * optimal_pressure(&one.problem()).unwrap().p_max);
    cases.push(one);
    cases.push(Data::two("two bodies beyond the kern", punch()).tilted(16000.0));
    cases.push(capped);
    cases
}

fn solved(data: &Data) -> (Optimum, Vec<Sensitivity>) {
    let problem = data.problem();
    let optimum = optimal_pressure(&problem).unwrap_or_else(|error| panic!("{}: {error}", data.name));
    let all = one_percent(&problem, &optimum).unwrap_or_else(|| panic!("{} has no sensitivities", data.name));
    (optimum, all)
}

#[test]
fn one_per_cent_of_every_number_matches_central_differences_of_full_solves() {
    for data in cases() {
        let (optimum, all) = solved(&data);
        assert!(all.len() >= 5, "{}", data.name);
        // Differences err by step^2 slope^3, and the solves themselves by the quadrature next to an end of contact inside the surface.
        let tolerance = if optimum.regime == Regime::PartialContact { 1e-5 } else { 1e-7 };
        for found in all {
            let step = 1e-4;
            let at = |sign: f64| {
                let moved = data.scaled(found.given, (sign * step).exp());
                let optimum = optimal_pressure(&moved.problem()).unwrap();
                [wear_rate(&moved, &optimum).ln(), torque(&moved, &optimum).ln(), optimum.p_max.ln()]
            };
            let (plus, minus) = (at(1.0), at(-1.0));
            let found_of = [found.wear_rate.unwrap(), found.torque.unwrap(), found.p_max];
            for (k, what) in ["wear rate", "torque", "p_max"].iter().enumerate() {
                let slope = (plus[k] - minus[k]) / (2.0 * step);
                let error = (found_of[k] - slope).abs();
                assert!(
                    error < tolerance * (1.0 + slope.abs().powi(3)),
                    "{}: {:?} {what}: {} {slope}",
                    data.name,
                    found.given,
                    found_of[k]
                );
            }
        }
    }
}

/// Sum of factors times sensitivities.
fn total(all: &[Sensitivity], factor: impl Fn(Given) -> f64) -> [f64; 3] {
    let sum = |value: &dyn Fn(&Sensitivity) -> f64| all.iter().map(|s| factor(s.given) * value(s)).sum::<f64>();
    [sum(&|s| s.wear_rate.unwrap()), sum(&|s| s.torque.unwrap()), sum(&|s| s.p_max)]
}

#[test]
fn the_sensitivities_satisfy_eulers_relations_for_the_units_of_force_time_and_thickness() {
    for data in cases() {
        let (optimum, all) = solved(&data);
        let tolerance = if optimum.regime == Regime::PartialContact { 2e-6 } else { 1e-8 };
        let b = |i: usize| data.b[i];
        let a = |i: usize| data.a[i];
        let close = |what: &str, got: [f64; 3], wanted: [f64; 3]| {
            for (got, wanted) in got.iter().zip(wanted) {
                assert!((got - wanted).abs() < tolerance, "{} {what}: {got} {wanted}", data.name);
            }
        };
        // Force t F, cap t p_max and factors t^-b beta: the pressure is t p, the wear rate the same.
        let force = total(&all, |given| match given {
            Given::Resultant(_) | Given::PressureCap => 1.0,
            Given::WearFactor(i) => -b(i),
            _ => 0.0,
        });
        close("force", force, [0.0, 1.0, 1.0]);
        // Speed t v and factors t^(1 - a) beta: the wear rate is t w', all forces the same.
        let time = total(&all, |given| match given {
            Given::SlidingSpeed => 1.0,
            Given::WearFactor(i) => 1.0 - a(i),
            _ => 0.0,
        });
        close("time", time, [1.0, 0.0, 0.0]);
        // Force t F on a surface t times as thick: the pressure is the same.
        if all.iter().any(|s| s.given == Given::Thickness) {
            let thickness = total(&all, |given| f64::from(u8::from(matches!(given, Given::Resultant(_) | Given::Thickness))));
            close("thickness", thickness, [0.0, 1.0, 0.0]);
        }
    }
}

#[test]
fn textbook_cases_have_textbook_sensitivities() {
    // Archard clutch: p ~ 1/r, wear rate k F v / area, torque mu F r_mean.
    let clutch = Data { a: [1.0; 2], b: [1.0; 2], ..Data::new("clutch", annulus()) };
    let (_, all) = solved(&clutch);
    let of = |given: Given| *all.iter().find(|s| s.given == given).unwrap();
    let force = of(Given::Resultant(0));
    for value in [force.wear_rate.unwrap(), force.torque.unwrap(), force.p_max] {
        assert!((value - 1.0).abs() < 1e-12);
    }
    let factor = of(Given::WearFactor(0));
    assert!(
        (factor.wear_rate.unwrap() - 1.0).abs() < 1e-12 && factor.torque.unwrap().abs() < 1e-12 && factor.p_max.abs() < 1e-12
    );
    let friction = of(Given::Friction);
    assert!((friction.torque.unwrap() - 1.0).abs() < 1e-12 && (friction.wear_rate.unwrap() - 1.0).abs() < 1e-12);
    assert!((of(Given::SlidingSpeed).wear_rate.unwrap() - 1.0).abs() < 1e-12);
}

#[test]
fn what_has_no_derivative_has_no_sensitivities() {
    let linear = Data { functional: Functional::FrictionPower, q: 1.0, ..Data::new("s = 1", annulus()) };
    let problem = linear.problem();
    assert_eq!(one_percent(&problem, &optimal_pressure(&problem).unwrap()), None);
    let uniform = Data { functional: Functional::Uniform, ..Data::new("uniform", punch()) }.tilted(1500.0);
    let problem = uniform.problem();
    assert_eq!(one_percent(&problem, &optimal_pressure(&problem).unwrap()), None);
    // Nothing wears without friction: the pressure alone is known.
    let idle = Data { mu: 0.0, ..Data::new("no friction", annulus()) };
    let (_, all) = solved(&idle);
    assert!(all.iter().all(|s| s.wear_rate.is_none() && s.torque.is_none() && s.given != Given::Friction));
}
