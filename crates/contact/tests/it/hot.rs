//! Contacts whose bodies their frictional heat bends, against closed forms.

use crate::common::punch::rectangle;
use contact::{ContactLoad, ContactOperator, Pair, faer::Mat};
use hpfem::*;

const YOUNG: f64 = 210e3;
const POISSON: f64 = 0.3;
const CONDUCTIVITY: f64 = 50.0;
const EXPANSION: f64 = 12e-6;
const WIDTH: f64 = 10.0;

/// A half-plane that slides on a rigid insulator, as a strip between planes of symmetry, tall against its width.
///
/// Burton, Nerlikar and Kilaparti 1973: a pressure `cos(m x)` lasts where `mu V = 2 m k / (E alpha)`, in plane strain `1 - nu` of it. In the
/// strip `m = n pi / L` without any error but that of its height, `exp(-2 m H)`.
///
/// ```text
///        T = 0
///       |     |   u_x = 0, insulated
///       |     |
///       +--L--+   q = mu V p
/// ```
fn on_strip<T>(kinematics: Kinematics, speed: f64, asked: impl Fn(&ContactOperator<'_>, &ContactLoad) -> T) -> T {
    let mesh = || rectangle(&[0.0, WIDTH], &[0.0, 0.5, 1.0, 2.0, 4.0].map(|z| z * WIDTH), hpfem::Side::Bottom, [0.0, WIDTH]);
    let thickness = kinematics.thickness().unwrap();
    let warm = BodyProblem::new(mesh(), 16, Kinematics::Potential { thickness })
        .material(Material::conductor(CONDUCTIVITY).unwrap())
        .support(Support::moved("top", Direction::First, 0.0))
        .keep("contact");
    let warm = Body::new(warm).unwrap();
    let body = BodyProblem::new(mesh(), 16, kinematics)
        .material(Material::isotropic(YOUNG, POISSON).unwrap())
        .support(Support::hold("left", Direction::First))
        .support(Support::hold("right", Direction::First))
        .load("force", EdgeTraction::new("top", |_| [0.0, -1.0]))
        .keep("contact");
    let body = Body::new(body).unwrap();
    let units = Pair::new(&warm.interface, None).unwrap().unit_heats(contact::Side::Shaped).unwrap();
    let columns = warm.interface.columns.ncols();
    let case = |k: usize| TemperatureCase {
        name: format!("heat {k}"),
        state: InterfaceState {
            unknowns: units.col(k).iter().copied().collect(),
            factors: vec![0.0; columns],
            load: TraceLoad::default(),
        },
        reference: 0.0,
    };
    let cases: Vec<TemperatureCase> = (0..units.ncols()).map(case).collect();
    let hot = body.heated(&warm, &cases, &[EXPANSION]).unwrap();
    let pair = Pair::new(&hot, None).unwrap();
    let operator = ContactOperator::new(&pair, false).unwrap();
    let n = operator.points().len();
    let factors: Vec<f64> = (0..=n).map(|k| if k == 0 { 1.0 } else { 0.0 }).collect();
    let mut load = ContactLoad::factors(&factors, &[]);
    // At mu V = 1 the heat is the force.
    load.following[0] = Some(Mat::from_fn(n + 1, n, |i, j| if i == j + 1 { speed } else { 0.0 }));
    asked(&operator, &load)
}

/// Speeds at which waves last.
fn critical(kinematics: Kinematics) -> Vec<f64> {
    on_strip(kinematics, 1.0, |operator, load| {
        let found = operator.speed_factors(load, &vec![true; operator.points().len()]).unwrap();
        assert_eq!(found.staggered, found.singular.first().copied());
        found.singular
    })
}

/// Of the same strip in plane stress, a depth `cos(m x)` more worn off makes a pressure `-E m / 2 / (1 - V / V_m)`, and wears by `k` times that: between the
/// speeds of the first two waves the first one grows, and no other.
#[test]
fn between_the_first_two_speeds_the_first_wave_grows_as_fast_as_its_closed_form() {
    const SLOPE: f64 = 1e-7;
    let plane = Kinematics::PlaneStress { thickness: 3.0 };
    let first = std::f64::consts::PI / WIDTH;
    let at = |share: f64| {
        let speed = share * 2.0 * first * CONDUCTIVITY / (YOUNG * EXPANSION);
        on_strip(plane, speed, |operator, load| {
            let points = operator.points();
            let area: f64 = points.iter().map(|point| point.weight).sum();
            let waves = Mat::from_fn(points.len(), 9, |i, k| {
                let size = if k == 0 { 1.0 } else { 2.0 };
                (size / area).sqrt() * (k as f64 * first * points[i].position[0]).cos()
            });
            let closed = vec![true; points.len()];
            operator.deviation_growth(load, &closed, (&vec![SLOPE; points.len()], &waves)).unwrap().unwrap()
        })
    };
    for share in [1.2, 1.5, 1.9] {
        let wanted = SLOPE * YOUNG * first / 2.0 / (share - 1.0);
        assert!((at(share) / wanted - 1.0).abs() < 1e-7, "{share}: {} for {wanted}", at(share));
    }
    // What is left of slower ones is the mean, which the load holds.
    assert_eq!([at(0.1), at(0.5), at(0.99)], [0.0; 3]);
}

#[test]
fn waves_of_pressure_last_at_the_speeds_that_burton_found() {
    let thickness = 3.0;
    for (kinematics, hindered) in
        [(Kinematics::PlaneStress { thickness }, 1.0), (Kinematics::PlaneStrain { thickness }, 1.0 - POISSON)]
    {
        let found = critical(kinematics);
        for (n, found) in found.iter().enumerate().take(4) {
            let m = (n + 1) as f64 * std::f64::consts::PI / WIDTH;
            let wanted = 2.0 * hindered * m * CONDUCTIVITY / (YOUNG * EXPANSION);
            assert!((found / wanted - 1.0).abs() < 1e-8, "{kinematics:?}, {n}: {found} for {wanted}");
        }
    }
}
