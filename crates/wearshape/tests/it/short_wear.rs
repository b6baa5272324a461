//! Runs that end while little is worn: the depth at the corners of a punch, which wear fast at first, is the answer.

use crate::common::{scene, solved};

#[test]
fn the_corners_of_a_punch_are_as_accurate_as_asked_for_however_short_the_run() {
    for end in ["1", "0.01", "1e-4"] {
        let gap = |accuracy: f64| {
            let wear = format!("wear={{k=[1e-6,0],a=1,b=1,until={end}}}");
            let settings = [wear.as_str(), &format!("accuracy={accuracy}")];
            let solution = solved(&scene("punch-wear", &settings));
            let error = solution.error.unwrap();
            assert!(error.how.ends_with("of the steps"), "{end} {accuracy}: {}", error.how);
            (solution.profile.unwrap().gap[0], error.gap_relative.unwrap())
        };
        let (truth, _) = gap(1e-6);
        for accuracy in [1e-2, 1e-3, 1e-4] {
            let (corner, told) = gap(accuracy);
            let error = (corner - truth).abs() / truth;
            println!("{end} {accuracy}: {error:.1e}, told {told:.1e}");
            assert!(error < accuracy && error < 6.0 * told, "{end} {accuracy}: {error:.1e}, told {told:.1e}");
        }
    }
}
