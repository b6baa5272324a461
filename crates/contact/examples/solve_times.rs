//! Time of a contact solve on a prepared operator with about 100, 200 and 400 points: full contact, partial contact, a wear-like warm start.

use contact::{ContactLoad, ContactOperator, Pair};
use hpfem::{Body, BodyProblem, Curve, Direction, EdgeTraction, Kinematics, Material, Mesh, Named, Ruled, Side};
use std::error::Error;
use std::time::{Duration, Instant};

/// Strip `-1 <= x <= 1` between two heights with `cells` cells along it.
fn strip(low: f64, high: f64, cells: usize, contact: Side, back: Side) -> Result<Mesh, hpfem::Error> {
    let breaks: Vec<f64> = (0..=cells).map(|i| 2.0 * i as f64 / cells as f64 - 1.0).collect();
    Mesh::ruled(&Ruled {
        bottom: Curve::Line { start: [-1.0, low], end: [1.0, low] },
        top: Curve::Line { start: [-1.0, high], end: [1.0, high] },
        breaks: &breaks,
        levels: &[0.0, 0.5, 1.0],
        closed: false,
        material: 0,
        names: &[Named { side: contact, range: None, name: "contact" }, Named { side: back, range: None, name: "back" }],
    })
}

/// Shortest of several runs.
fn best(mut run: impl FnMut()) -> Duration {
    (0..20)
        .map(|_| {
            let start = Instant::now();
            run();
            start.elapsed()
        })
        .min()
        .unwrap_or_default()
}

fn main() -> Result<(), Box<dyn Error>> {
    let kinematics = Kinematics::PlaneStrain { thickness: 1.0 };
    let steel = Material::isotropic(210e3, 0.3)?;
    println!("points  prepare_us  full_us  partial_us  steps  warm_us  steps  sliding_us");
    for cells in [12, 25, 50] {
        let upper = strip(0.0, 1.0, cells, Side::Bottom, Side::Top)?;
        let lower = strip(-1.0, 0.0, cells, Side::Top, Side::Bottom)?;
        let problem = |mesh| BodyProblem::new(mesh, 8, kinematics).material(steel).keep("contact");
        let press = EdgeTraction::new("back", |_| [0.0, -10.0]);
        let one = Body::new(problem(upper).hold("back", Direction::First).load("press", press))?;
        let two = Body::new(problem(lower).clamp("back"))?;
        let pair = Pair::new(&one.interface, Some(&two.interface))?;
        let operator = ContactOperator::new(&pair, true)?;
        let prepare = best(|| drop(ContactOperator::new(&pair, true)));
        let points = operator.points();
        let flat = vec![0.0; points.len()];
        let round: Vec<f64> = points.iter().map(|p| 5e-4 * p.position[0].powi(2)).collect();
        let worn: Vec<f64> = round.iter().map(|g| 0.999 * g).collect();
        let press = ContactLoad::factors(&[1.0], &[]);
        let slide = press.clone().sliding(0.25, vec![1.0; points.len()]);
        let partial = operator.solve(&round, &press, None)?;
        let warm = operator.solve(&worn, &press, Some(&partial))?;
        let micros = |d: Duration| d.as_secs_f64() * 1e6;
        println!(
            "{:6}  {:10.0}  {:7.0}  {:10.0}  {:5}  {:7.0}  {:5}  {:10.0}",
            points.len(),
            micros(prepare),
            micros(best(|| drop(operator.solve(&flat, &press, None)))),
            micros(best(|| drop(operator.solve(&round, &press, None)))),
            partial.iterations,
            micros(best(|| drop(operator.solve(&worn, &press, Some(&partial))))),
            warm.iterations,
            micros(best(|| drop(operator.solve(&round, &slide, None)))),
        );
    }
    Ok(())
}
