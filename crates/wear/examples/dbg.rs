//! d
use nalgebra::Vector3;
use wear::*;
fn main() {
    let s = Surface::new(
        Shape::Strip {
            x: [-25.0, 25.0],
            z: 0.0,
            thickness: 7.0,
        },
        SlidingMotion::along_x(3.0),
    )
    .unwrap();
    let b = 2.8935466706027184;
    let share = 0.11546251315103799;
    let k = 1.0 / b;
    let kern = 25.0 * k / (k + 2.0);
    let e = kern + (25.0 - kern) * share;
    let law = WearLaw {
        factor: 3e-6,
        speed_exponent: 1.0,
        pressure_exponent: b,
    };
    let p = Problem::new(
        s,
        law,
        vec![
            RigidMode::press_down(500.0),
            RigidMode::tilt(500.0 * e, Vector3::zeros()),
        ],
    );
    println!("{:?}", optimal_pressure(&p).map(|o| o.p_max));
}
