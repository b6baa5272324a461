//! What is known of the largest pressure of a contact.

use wearshape::Solution;

use crate::common::{scene, solved};

/// Levels tell the L2 error of a pressure; its peak under a light load is known less well: 3.6e-4 where 5e-5 of the pressure was told and nothing of the peak.
#[test]
fn the_error_of_the_largest_pressure_is_told() {
    let of = |accuracy: &str| solved(&scene("knee", &["load.force=222", "contact.friction=0.07", accuracy]));
    let [rough, fine] = ["accuracy=1e-4", "accuracy=1e-7"].map(of);
    let largest = |solution: &Solution| solution.contact.as_ref().unwrap().p_max.unwrap();
    let error = (largest(&rough) / largest(&fine) - 1.0).abs();
    let told = rough.error.as_ref().unwrap();
    assert!(error > 2.0 * told.pressure_relative.unwrap() && error < told.p_max_relative.unwrap(), "{error:.1e} {told:?}");
}

/// The edge of a punch 21 times as soft as its plate has a pressure like d^-0.019, which no layers show: its largest value was told as one.
#[test]
fn a_pressure_that_grows_slowly_towards_an_edge_has_no_largest_value() {
    let of = |settings: &[&str]| {
        let all: Vec<&str> = ["tasks=[contact]", "accuracy=1e-3"].iter().chain(settings).copied().collect();
        let solution = solved(&scene("translating-punch", &all));
        (solution.contact.unwrap().p_max.is_some(), solution.remarks.into_iter().find(|remark| remark.code == "edge-unbounded"))
    };
    let (told, remark) = of(&["contact.friction=0", "body1.material.young=1e4"]);
    assert!(told && remark.unwrap().message.contains("d^(-0.019) towards x = -30.000000 mm"));
    // Where the exponent is seen in the layers, it stands in place of the largest value; a plate of the punch's own width has none.
    assert_eq!(of(&["contact.friction=0"]), (false, None));
    assert_eq!(of(&["contact.friction=0", "body2.geometry.rectangle={x=[-30,30],z=[0,100]}"]), (true, None));
}
