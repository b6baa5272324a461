//! What leaving out saves: whole runs of the block shoe, files included, with less and less asked for.
#![allow(missing_docs)]

use std::path::PathBuf;
use std::time::Instant;

/// Repetitions; the least counts.
const REPEAT: usize = 5;

fn main() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("leave-out-bench").display().to_string();
    let seconds = |settings: &[&str]| {
        let fixed = ["wearshape", "run", "drum-brake-block", "-q", "--threads", "1", "-o", &folder];
        let set = settings.iter().flat_map(|setting| ["--set", setting]);
        let words: Vec<String> = fixed.into_iter().chain(["--set", "mesh.degree=10"]).chain(set).map(String::from).collect();
        let once = || {
            let start = Instant::now();
            cli::run(words.clone());
            start.elapsed().as_secs_f64()
        };
        (0..REPEAT).map(|_| once()).fold(f64::INFINITY, f64::min)
    };
    let whole = "whole";
    println!("bench {whole} {:.3e}", seconds(&["output.fields=true"]));
    let less: [(&str, &[&str]); 5] = [
        ("no-fields", &[]),
        ("no-fields-no-proof", &["check=false"]),
        ("no-fields-no-proof-no-page", &["check=false", "output.report=false"]),
        ("contact-alone-without-friction", &["tasks=[contact]", "contact.friction=0", "output.report=false"]),
        ("pressure-alone", &["tasks=[pressure]", "output.report=false"]),
    ];
    for (name, settings) in less {
        println!("bench {name} {:.3e} {whole}", seconds(settings));
    }
}
