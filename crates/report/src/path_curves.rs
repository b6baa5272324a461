//! Stresses along the lines of `output.paths`, a plot each.

use wearshape::{PathProfile, Stress};

use crate::line_plot::{Axis, LinePlot, Series};

/// The plots with the names of their files, `path-NAME`.
pub(crate) fn path_plots(title: &str, paths: &[PathProfile]) -> Vec<(String, LinePlot)> {
    paths.iter().map(|path| (format!("path-{}", path.name), plot(title, path))).collect()
}

fn plot(title: &str, path: &PathProfile) -> LinePlot {
    let [x, y] = if path.revolved { ["r", "hoop"] } else { ["x", "y"] };
    let series = |name: String, value: &dyn Fn(&Stress) -> f64, dashed: bool| {
        let points = path.s.iter().copied().zip(path.stress.iter().map(value)).collect();
        Series { name, points, marks: false, dashed }
    };
    LinePlot {
        title: format!("{title}: stress along {}, body {}", path.name, path.body),
        x_label: "distance along the path (mm)".to_string(),
        y_label: "stress (MPa)".to_string(),
        axes: [Axis::Linear, Axis::Linear],
        from_zero: true,
        series: vec![
            series(format!("\u{3c3} {x}"), &|stress| stress.xx, false),
            series("\u{3c3} z".to_string(), &|stress| stress.zz, false),
            series(format!("\u{3c3} {y}"), &|stress| stress.yy, false),
            series(format!("\u{3c4} {x}z"), &|stress| stress.xz, false),
            series("von Mises".to_string(), &|stress| stress.von_mises(), true),
        ],
    }
}
