//! A sweep of twenty points that meshes and factors each level once, against twenty sweeps of one point.
#![allow(missing_docs)]

use std::path::PathBuf;
use std::time::Instant;

const POINTS: usize = 20;

fn main() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("sweep-bench");
    let sweep = |over: String| {
        let out = folder.display().to_string();
        let args = ["wearshape", "sweep", "drum-brake-block", "-q", "--threads", "1", "-o", &out, "--over", &over];
        cli::run(args.map(String::from).to_vec());
    };
    let friction = |i: usize| 0.05 + 0.45 * i as f64 / (POINTS - 1) as f64;
    let seconds = |work: &dyn Fn()| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64()
    };
    let single = seconds(&|| (0..POINTS).for_each(|i| sweep(format!("contact.friction={}", friction(i)))));
    let shared = seconds(&|| sweep(format!("contact.friction={}:{}:{POINTS}", friction(0), friction(POINTS - 1))));
    println!("bench twenty-points-alone {single:.3e}");
    println!("bench twenty-points-in-one-sweep {shared:.3e} twenty-points-alone");
}
