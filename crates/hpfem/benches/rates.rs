//! Rates of convergence, drawn: the stress error of the manufactured solutions in every kinematics on a turned curved mesh of
//! quadrilaterals and triangles, and the energy-norm error of the L-shape on a fixed and on graded meshes. Prints tables; a file
//! name ending in .svg receives the picture. The tests of the crate assert the same rates.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used)]

#[path = "../tests/it/common.rs"]
mod common;
#[path = "../tests/it/exact.rs"]
mod exact;
#[path = "../tests/it/lshape.rs"]
mod lshape;

use common::*;
use exact::Exact;
use hpfem::*;

/// A curve: name and points.
type Line = (String, Vec<[f64; 2]>);

fn main() {
    let manufactured: Vec<Line> = [PLANE_STRESS, PLANE_STRAIN, Kinematics::Axisymmetric, Kinematics::Torsion]
        .iter()
        .zip(["plane stress", "plane strain", "axisymmetric", "torsion"])
        .map(|(kinematics, name)| (name.to_string(), (1..=12).map(|p| [p as f64, stress(*kinematics, p)]).collect()))
        .collect();
    let mesh = lshape::l_shape();
    let error = |(u, unknowns): (f64, usize)| [unknowns as f64, (1.0 - u / lshape::ENERGY).abs().sqrt()];
    let fixed = (1..=20).map(|p| error(lshape::energy(&mesh, vec![p; 3]))).collect();
    let graded = (2..=10)
        .map(|p| {
            let mesh = mesh.refined_towards(&[0], 0.15, p).unwrap();
            let degrees = mesh.cells.iter().map(|c| (p + 1 - c.layer.min(p)).max(2)).collect();
            error(lshape::energy(&mesh, degrees))
        })
        .collect();
    let corner = vec![("three cells, p = 1 .. 20".to_string(), fixed), ("p layers, p = 2 .. 10".to_string(), graded)];
    for (name, points) in manufactured.iter().chain(&corner) {
        let numbers: Vec<String> = points.iter().map(|[x, y]| format!("{x} {y:.1e}")).collect();
        println!("{name}: {}", numbers.join(", "));
    }
    if let Some(path) = std::env::args().find(|a| a.ends_with(".svg")) {
        let left = panel(60.0, "stress error over degree", &manufactured, &|p| p / 12.0, [-9, 1]);
        let right =
            panel(470.0, "energy-norm error of the L-shape over unknowns", &corner, &|n| (n.log10() - 1.0) / 3.0, [-5, 0]);
        let open = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"820\" height=\"400\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"820\" height=\"400\" fill=\"white\"/>\n";
        std::fs::write(path, format!("{open}{left}{right}</svg>\n")).unwrap();
    }
}

fn stress(kinematics: Kinematics, degree: usize) -> f64 {
    let exact = Exact { kinematics, material: Material::isotropic(1.7, 0.28).unwrap() };
    let mesh = mixed(TURNS[6], Shape::Arcs, 0.0);
    let body = Body::new(exact.loaded(&mesh, degree).keep("right")).unwrap();
    stress_error(&body.field(&solved(&body, &[1.0])).unwrap(), &mesh, |x| exact.stress(x))
}

/// One plot with decades as its vertical scale; `share` places an abscissa between 0 and 1.
fn panel(left: f64, title: &str, lines: &[Line], share: &dyn Fn(f64) -> f64, decades: [i32; 2]) -> String {
    let colours = ["#1f77b4", "#d62728", "#2ca02c", "#9467bd"];
    let y = |v: f64| 360.0 - 320.0 * (v.log10() - f64::from(decades[0])) / f64::from(decades[1] - decades[0]);
    let mut svg = format!("<text x=\"{left}\" y=\"25\">{title}</text>\n");
    for decade in decades[0]..=decades[1] {
        let h = y(10.0_f64.powi(decade));
        svg += &format!("<path d=\"M{left},{h:.1}h320\" stroke=\"#ddd\"/>");
        svg += &format!("<text x=\"{:.0}\" y=\"{:.1}\" text-anchor=\"end\">1e{decade}</text>\n", left - 6.0, h + 4.0);
    }
    let places: &[f64] = if title.contains("degree") { &[2.0, 4.0, 6.0, 8.0, 10.0, 12.0] } else { &[10.0, 100.0, 1000.0] };
    for x in places {
        let at = left + 320.0 * share(*x);
        svg += &format!(
            "<path d=\"M{at:.1},40V360\" stroke=\"#ddd\"/><text x=\"{at:.1}\" y=\"378\" text-anchor=\"middle\">{x}</text>\n"
        );
    }
    for (number, ((name, points), colour)) in lines.iter().zip(colours).enumerate() {
        let points: Vec<String> = points.iter().map(|[a, b]| format!("{:.1},{:.1}", left + 320.0 * share(*a), y(*b))).collect();
        svg += &format!("<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.5\"/>\n", points.join(" "));
        svg += &format!("<text x=\"{:.0}\" y=\"{}\" fill=\"{colour}\">{name}</text>\n", left + 10.0, 300 + 15 * number);
    }
    svg
}
