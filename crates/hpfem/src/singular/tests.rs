//! Whether the starts are enough.

use super::*;

/// Numbers from 0 to 1, the same each time.
fn numbers() -> impl FnMut() -> f64 {
    let mut state = 2007_u64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / (1_u64 << 31) as f64
    }
}

/// Corners of one to three sectors, held in any way, of moduli up to nine powers of ten apart; half of them with angles of whole parts of a circle.
#[test]
fn ten_times_as_many_starts_find_no_other_exponent() {
    let mut next = numbers();
    let mut tried = 0;
    while tried < 400 {
        let kinematics = match (4.0 * next()) as usize {
            0 => Kinematics::Torsion,
            1 => Kinematics::PlaneStress { thickness: 1.0 },
            2 => Kinematics::PlaneStrain { thickness: 1.0 },
            _ => Kinematics::Axisymmetric,
        };
        let (count, even) = (1 + (3.0 * next()) as usize, next() < 0.5);
        let mut sector = || {
            let angle = if even { (1.0 + (11.0 * next()).floor()) * PI / 6.0 } else { 0.05 + next() * TAU / count as f64 };
            Sector { angle, constants: Constants { young: 10_f64.powf(9.0 * next() - 2.0), poisson: 0.499 * next() } }
        };
        let sectors: Vec<Sector> = (0..count).map(|_| sector()).collect();
        let around = sectors.iter().map(|sector| sector.angle).sum::<f64>();
        if around > TAU + 1e-9 {
            continue;
        }
        let mut face = || match (4.0 * next()) as usize {
            0 => Face::Free,
            1 => Face::Fixed,
            2 => Face::Held(PI / 2.0),
            _ => Face::Held(PI * next()),
        };
        let faces = [face(), face()];
        let faces = if count > 1 && (around - TAU).abs() < 1e-9 { None } else { Some(faces) };
        let [found, sure] = [STARTS, [30, 12]].map(|starts| smallest_root(&sectors, faces, kinematics, starts));
        // Where it is all but 1, the derivatives are all but bounded.
        assert!((found - sure).abs() < 1e-6 || found.min(sure) > 0.9999, "{found} and {sure}: {sectors:?} {faces:?}");
        tried += 1;
    }
}
