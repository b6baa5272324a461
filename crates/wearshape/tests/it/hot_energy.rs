//! Strain energies of bodies that heat bends, where their inside is recovered, against closed forms.

use crate::common::{read, solved};
use crate::heat::{SLABS, near};

/// Next to no heat of friction, so that each slab is as warm as it is held, and fields inside.
const STILL: [&str; 2] = ["contact.friction=1e-9", "output.fields=true"];

/// Strain energies of both bodies.
fn energies(settings: &[&str]) -> [f64; 2] {
    let energy = solved(&read(SLABS, &[&STILL, settings].concat())).energy.unwrap();
    [energy.body1.unwrap(), energy.body2.unwrap()]
}

/// Young's modulus, Poisson's ratio, thermal expansion and volume of each slab.
const BODIES: [[f64; 4]; 2] = [[200e3, 0.3, 12e-6, 24e3], [100e3, 0.25, 20e-6, 18e3]];
/// The pressure on them.
const PRESSURE: f64 = 1.0;

/// Energy of an even state of plane stress or plane strain under the pressure, warmer by `rise`, between walls across it or not: strains are
/// `alpha dT + (s_x - nu (s_y + s_z)) / E` and so on, and zero where they are hindered.
fn even(body: usize, rise: f64, plane_stress: bool, walls: bool) -> f64 {
    let [young, nu, alpha, volume] = BODIES[body];
    let z = -PRESSURE;
    let hindered = nu * z - young * alpha * rise;
    let [x, y] = match (plane_stress, walls) {
        (true, false) => [0.0, 0.0],
        (true, true) => [hindered, 0.0],
        (false, false) => [0.0, hindered],
        (false, true) => [hindered / (1.0 - nu); 2],
    };
    0.5 * volume / young * (x * x + y * y + z * z - 2.0 * nu * (x * y + y * z + z * x))
}

#[test]
fn warm_slabs_hold_the_energy_of_what_hinders_them() {
    let held = ["body1.heat={ top = { temperature = 120 } }", "body2.heat={ bottom = { temperature = 70 } }"];
    let rises = [100.0, 50.0];
    for (word, plane) in [("plane-stress", true), ("plane-strain", false)] {
        let kinematics = format!("kinematics={word}");
        let free = energies(&[&held[..], &[&kinematics]].concat());
        let walls = [
            "body1.support={ left = [\"x\"], right = [\"x\"] }",
            "body2.support={ bottom = [\"z\"], left = [\"x\"], right = [\"x\"] }",
        ];
        let hindered = energies(&[&held[..], &walls, &[&kinematics]].concat());
        for body in [0, 1] {
            near(free[body], even(body, rises[body], plane, false), 1e-7);
            near(hindered[body], even(body, rises[body], plane, true), 1e-7);
        }
    }
}

/// A linear temperature through a body that bends freely causes no stress: what is left is the energy of the pressure.
#[test]
fn a_slab_that_bends_freely_holds_the_energy_of_its_pressure_alone() {
    let sliding = "sliding.speed=\"250e6 mm/s\"";
    for settings in [&[sliding][..], &["body1.material.expansion=0"], &[]] {
        near(energies(settings)[0], even(0, 0.0, true, false), 1e-7);
    }
}

#[test]
fn energies_of_hot_bodies_are_told_where_their_inside_is_recovered() {
    let energy = |settings: &[&str]| solved(&read(SLABS, settings)).energy.unwrap();
    assert!(energy(&[]).body1.is_none());
    assert!(energy(&["output.fields=true"]).body1.is_some());
}
