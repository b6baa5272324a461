//! The estimate from embedded degrees against the true error: the pressure of one solve, and that of a much higher degree on the same layers.

use crate::common::drum::Drum;
use crate::common::punch::Punch;
use crate::hertz::{bodies, gap, positioned};
use contact::*;

/// Samples over the inner 95 % of the surface.
fn samples(operator: &ContactOperator<'_>, pressure: &[f64]) -> Vec<f64> {
    let length = operator.pair().trace().length();
    (0..191).map(|i| length * (0.025 + 0.95 * f64::from(i) / 190.0)).map(|arc| operator.value_at(pressure, arc)).collect()
}

/// The estimate and the samples of the pressure.
fn solved(
    pair: &Pair<'_>,
    gap: impl Fn(&ContactPoint) -> f64,
    load: impl Fn(usize) -> ContactLoad,
    shear: bool,
) -> (f64, Vec<f64>) {
    let operator = ContactOperator::new(pair, shear).unwrap();
    let gap: Vec<f64> = operator.points().iter().map(gap).collect();
    let load = load(gap.len());
    let solution = operator.solve(&gap, &load, None).unwrap();
    assert!(solution.status.is_solved());
    let estimate = operator.embedded_difference(&gap, &load, &solution).unwrap().unwrap();
    (estimate, samples(&operator, &solution.pressure))
}

fn difference(a: &[f64], b: &[f64]) -> f64 {
    let square = |f: &dyn Fn(usize) -> f64| (0..b.len()).map(|i| f(i).powi(2)).sum::<f64>();
    (square(&|i| a[i] - b[i]) / square(&|i| b[i])).sqrt()
}

type Case<'c> = (&'c str, [f64; 2], Box<dyn Fn(usize) -> (f64, Vec<f64>)>);

#[test]
fn the_differences_of_embedded_degrees_bound_the_true_error_of_the_pressure() {
    let end = positioned(14, 7, 350.0).0.ends[0];
    let cases: Vec<Case<'_>> = vec![
        (
            "drum, mu 0.25",
            [0.9, 1.6],
            Box::new(|degree| {
                let drum = Drum::new(degree, 8, [210e3; 2]);
                let (shoe, ring) = drum.bodies();
                let pair = Pair::new(&shoe.interface, Some(&ring.interface)).unwrap();
                solved(&pair, |_| 0.0, |n| ContactLoad::factors(&[1.0], &[]).sliding(0.25, vec![-1.0; n]), true)
            }),
        ),
        (
            "punch",
            [0.9, 1.6],
            Box::new(|degree| {
                let punch = Punch::translating(degree, 8, [false, true, false]);
                let (body, plate) = punch.bodies();
                let pair = Pair::new(&body.interface, Some(&plate.interface)).unwrap();
                let push = [Motion::FREE, Motion::Free { resultant: -1000.0 }, Motion::FREE];
                solved(&pair, |_| 0.0, |_| ContactLoad { motions: push, ..ContactLoad::factors(&[], &[]) }, false)
            }),
        ),
        (
            "cylinder, node on the end",
            [0.8, 4.5],
            Box::new(move |degree| {
                let bodies = bodies(end, 1.6, degree, 5, 350.0);
                solved(&bodies.pair().unwrap(), gap, |_| ContactLoad::factors(&[1.0], &[]), false)
            }),
        ),
        (
            "cylinder, end inside a cell",
            [2.0, 12.0],
            Box::new(move |degree| {
                let bodies = bodies(0.8 * end, 1.6, degree, 0, 350.0);
                solved(&bodies.pair().unwrap(), gap, |_| ContactLoad::factors(&[1.0], &[]), false)
            }),
        ),
    ];
    for (name, [low, high], solve) in cases {
        let fine = solve(16).1;
        for degree in [3, 4, 6, 8, 10] {
            let (estimate, pressure) = solve(degree);
            let true_error = difference(&pressure, &fine);
            let effectivity = estimate / true_error;
            println!("{name} {degree}: estimate {estimate:.1e} true {true_error:.1e}, {effectivity:.1} times");
            assert!((low..=high).contains(&effectivity), "{name} {degree}: {effectivity}");
        }
    }
}
