//! A drum brake with a block shoe: from a scene in a string to the gap that lets it wear in a steady state from the first turn on. No file is touched.

use std::ops::ControlFlow;

use wearshape::{Bodies, Document, Fault, Options, Problem, Sampling, Solution, solve};

/// Shoe and drum: Paczelt and Mroz (2007), section 5.
const DRUM: &str = r#"
units = "N-mm"
kinematics = "plane-stress"
thickness = 10
tasks = ["pressure", "shape"]
accuracy = 1e-6

body1.geometry.shoe-block = { radius = 200, half_angle = "30 deg", top = 300 }
body1.material = { young = "210 GPa", poisson = 0.3 }
body1.support = { left = ["x"], right = ["x"] }

body2.geometry.ring = { inner = 100, outer = 200 }
body2.material = { young = "210 GPa", poisson = 0.3 }
body2.support = { inner = ["x", "z"] }

contact = { edges = ["inner", "outer"], friction = 0.25 }
sliding = { omega = "2.5 rad/s" }
load = { edge = "top", as = "pressure", force = "10 kN" }
wear = { beta = [2e-4, 0], a = 1, b = 0.5 }
optimum = { functional = "steady" }
"#;

/// Pressure and gap of the shoe at evenly spaced points.
pub fn solved(points: usize) -> Result<Solution, Fault> {
    let document = Document::read("drum.toml", DRUM, &[])?;
    let problem = Problem::new(&document, &|file| Err(format!("there is no file {file}")))?;
    let options = Options { sample: Some(Sampling::Even(points)), ..Options::default() };
    solve(&problem, &options, &Bodies::default(), &mut |_| ControlFlow::Continue(()))
}

#[allow(dead_code)]
fn main() -> Result<(), Fault> {
    let solution = solved(13)?;
    println!("   s, mm   pressure, MPa   gap, um");
    if let Some(profile) = &solution.profile {
        for ((s, pressure), gap) in profile.s.iter().zip(&profile.pressure).zip(&profile.gap) {
            println!("{s:8.2}   {pressure:13.6}   {gap:7.4}");
        }
    }
    for error in solution.error.iter().filter_map(|error| error.gap_relative) {
        println!("the gap is known to {error:.1e}");
    }
    Ok(())
}
