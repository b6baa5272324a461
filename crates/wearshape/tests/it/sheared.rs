//! A shear force moves a contact along the surface, by as much as bodies are no half-spaces.

use crate::common::{scene, solved};

#[test]
fn the_ends_of_a_sheared_contact_are_those_of_its_points_and_of_its_mirror_image() {
    let of = |shear: f64| solved(&scene("cattaneo-mindlin", &["accuracy=1e-5", &format!("load.shear_force={shear}")]));
    let (right, left) = (of(38.75), of(-38.75));
    let [forth, back] = [&right, &left].map(|solution| solution.contact.as_ref().unwrap());
    let told = right.error.as_ref().unwrap().ends.unwrap();
    assert!((1e-6..1e-4).contains(&told), "{told:e}");
    for (a, b) in [(&forth.ends, &back.ends), (&forth.stick_ends, &back.stick_ends)] {
        assert!((a[0] + b[1]).abs() < 1e-6 && (a[1] + b[0]).abs() < 1e-6, "{a:?} {b:?}");
        // By no half-space's symmetry.
        assert!((a[0] + a[1]).abs() > 3e-4, "{a:?}");
    }
    let [most, mirrored] = [forth, back].map(|contact| contact.q_max.unwrap());
    assert!((most - mirrored).abs() < 3e-5 * most, "{most} {mirrored}");
    // The last points that press and the first that do not.
    let profile = right.profile.as_ref().unwrap();
    let pressed: Vec<usize> = (0..profile.s.len()).filter(|i| profile.pressure[*i] > 0.0).collect();
    let (first, last) = (pressed[0], pressed[pressed.len() - 1]);
    for (end, [outside, inside]) in forth.ends.iter().zip([[first - 1, first], [last + 1, last]]) {
        let between = [profile.s[outside], profile.s[inside]];
        assert!(*end > between[0].min(between[1]) - told && *end < between[0].max(between[1]) + told, "{end} {between:?}");
    }
}
