//! A half-plane of boundary elements through the solver of plain matrices: a cylinder pressed on and sheared by less than friction carries.
//!
//! Strips of constant traction on the surface of a half-plane (Johnson, Contact Mechanics, 2.5): a unit force on a strip of half width `h` moves
//! the surface at a distance `x` by
//!
//! ```text
//! A(x) = -1 / (pi E' h) ((x + h) ln |x + h| / d - (x - h) ln |x - h| / d - 2 h)
//! ```
//!
//! along itself, `E'` the reduced modulus of both bodies; the length `d` is free, an approach and a shift take it up. Equal materials: no coupling of
//! pressure and slip. Known: Hertz, and the stick zone `c / a = sqrt(1 - Q / (mu P))` of Cattaneo (1938) and Mindlin (1949).

use contact::faer::Mat;
use contact::{ContactState, Error, Friction, MatrixContact, Motions};
use std::f64::consts::PI;

/// Reduced modulus (MPa), radius (mm), forces per length (N/mm), coefficient of friction.
const MODULUS: f64 = 115e3;
const RADIUS: f64 = 10.0;
const NORMAL: f64 = 100.0;
const SHEAR: f64 = 20.0;
const FRICTION: f64 = 0.3;

/// Surface displacement at a distance by a unit force on a strip of half width `h`; zero far away, at a length of 10 mm.
fn strip(x: f64, h: f64) -> f64 {
    let part = |x: f64| x * (x.abs() / 10.0).ln();
    -(part(x + h) - part(x - h) - 2.0 * h) / (PI * MODULUS * h)
}

/// Relative errors of the highest pressure, of the contact length and of the stick zone with a number of strips.
pub fn errors(strips: usize) -> Result<[f64; 3], Error> {
    let a = (4.0 * NORMAL * RADIUS / (PI * MODULUS)).sqrt();
    // Strips from -1.2 a to 1.2 a.
    let h = 1.2 * a / strips as f64;
    let x: Vec<f64> = (0..strips).map(|i| (2.0 * i as f64 + 1.0) * h - 1.2 * a).collect();
    let compliance = Mat::from_fn(2 * strips, 2 * strips, |i, j| match (i < strips, j < strips) {
        (true, true) | (false, false) => strip(x[i % strips] - x[j % strips], h),
        (true, false) | (false, true) => 0.0,
    });
    // An approach closes the gap; a shift slips body 1 along.
    let motion = |which: usize, value: f64| Mat::from_fn(strips, 2, |_, j| if j == which { value } else { 0.0 });
    let contact =
        MatrixContact::from_compliance(&compliance, &vec![2.0 * h; strips], &Motions::free(motion(0, -1.0), motion(1, 1.0)))?;

    let gap: Vec<f64> = x.iter().map(|x| x * x / (2.0 * RADIUS)).collect();
    let pressed = contact.solve(&gap, &[NORMAL, 0.0], &Friction::None, None)?;
    let friction = Friction::Coulomb { coefficient: FRICTION, slip_before: pressed.slip.clone() };
    let sheared = contact.solve(&gap, &[NORMAL, SHEAR], &friction, None)?;

    let highest = pressed.pressure.iter().fold(0.0, |most: f64, p| most.max(*p));
    let width = |wanted: &dyn Fn(ContactState) -> bool| 2.0 * h * sheared.states.iter().filter(|s| wanted(**s)).count() as f64;
    let length = width(&|state| state != ContactState::Open);
    let stick = width(&|state| state == ContactState::Stick) / length;
    let known = [2.0 * NORMAL / (PI * a), 2.0 * a, (1.0 - SHEAR / (FRICTION * NORMAL)).sqrt()];
    Ok([highest / known[0] - 1.0, length / known[1] - 1.0, stick / known[2] - 1.0])
}

#[allow(dead_code)]
fn main() -> Result<(), Error> {
    println!("strips  highest pressure  contact length  stick zone   (relative errors)");
    for strips in [60, 120, 240] {
        let [pressure, length, stick] = errors(strips)?;
        println!("{strips:6}  {pressure:16.1e}  {length:14.1e}  {stick:10.1e}");
        // The ends are known to a strip.
        let one = 1.2 / strips as f64;
        assert!(pressure.abs() < one * one && length.abs() < 2.0 * one && stick.abs() < 4.0 * one);
    }
    Ok(())
}
