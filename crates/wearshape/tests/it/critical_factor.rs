//! The critical speed of a hot contact does not depend on how fine its last mesh is.

use wearshape::SpeedFactor;

use crate::common::{scene, solved};

#[test]
fn coarse_meshes_have_the_critical_speed_of_fine_ones() {
    for omega in [1.0, 1.5] {
        let of = |how: &str| {
            let settings = ["tasks=[contact]", "contact.friction=0.1", &format!("sliding.omega={omega}"), how];
            let heat = solved(&scene("drum-brake-hot", &settings)).heat.unwrap();
            match heat.critical_speed_factor {
                Some(SpeedFactor::At(factor)) => factor,
                other => panic!("{how}: {other:?}"),
            }
        };
        let fine = of("mesh={ degree = 10, layers = 10 }");
        for accuracy in ["accuracy=1e-2", "accuracy=1e-3"] {
            let coarse = of(accuracy);
            assert!((coarse / fine - 1.0).abs() < 0.03, "{omega} {accuracy}: {coarse} {fine}");
        }
    }
}
