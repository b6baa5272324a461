use crate::common::at_arc;
use crate::common::drum::{Drum, HALF_ANGLE, RADIUS};
use crate::common::punch::Punch;
use contact::*;
#[test]
#[ignore]
fn scan() {
    for (degree, layers) in [(8, 8), (10, 10), (12, 10), (14, 12), (16, 14), (16, 10)] {
        let punch = Punch::annular(degree, layers);
        let (body, disc) = punch.bodies();
        let pair = Pair::new(&body.interface, Some(&disc.interface)).unwrap();
        let operator = ContactOperator::new(&pair, false).unwrap();
        let gap = vec![0.0; operator.points().len()];
        let solution = operator.solve(&gap, &ContactLoad::factors(&[1.0], &[]), None).unwrap();
        print!("{degree} {layers} ");
        for r in [22.5, 70.0, 107.5] {
            print!("{:.6} ", at_arc(&operator, &solution.pressure, r - 20.0));
        }
        let drum = Drum::new(degree, layers, [210e3; 2]);
        let (shoe, ring) = drum.bodies();
        let pair = Pair::new(&shoe.interface, Some(&ring.interface)).unwrap();
        let operator = ContactOperator::new(&pair, false).unwrap();
        let n = operator.points().len();
        let solution = operator.solve(&vec![0.0; n], &ContactLoad::factors(&[1.0], &[]), None).unwrap();
        for a in [0.0f64, 15.0, 22.5, 28.5] {
            print!("{:.7} ", at_arc(&operator, &solution.pressure, RADIUS * (a.to_radians() + HALF_ANGLE)));
        }
        println!();
    }
}
