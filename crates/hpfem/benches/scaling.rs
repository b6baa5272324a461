//! Seconds and bytes against unknowns: a square of `n x n` different cells with a kept edge, p = 2, 4, 8, reduced by this crate, and the same
//! skeleton handed to faer's sparse Cholesky factorisation. Prints a table with fitted exponents; a file name as an argument
//! receives the picture.
//!
//! `cargo bench -p wearshape-hpfem --bench scaling -- [largest number of unknowns] [picture.svg]`
//!
//! Every case is a process of its own, one thread, CPU seconds and peak memory by the system's account (Linux).

mod common;

use common::square;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{CholeskySymbolicParams, SymmetricOrdering, factorize_symbolic_cholesky};
use faer::sparse::{SparseColMat, Triplet};
use faer::{Par, Spec};
use hpfem::*;
use std::error::Error as StdError;
use std::process::Command;
use std::sync::Arc;

/// Largest number of unknowns; a first argument that is a number replaces it.
const LARGEST: usize = 200_000;

type Outcome<T> = Result<T, Box<dyn StdError>>;

/// One case: unknowns, CPU seconds, peak bytes, estimated bytes.
type Row = [f64; 4];

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|a| a != "--bench").collect();
    if let [case, n, p] = &arguments[..]
        && case.starts_with("case-")
    {
        let row = run(case == "case-faer", n.parse()?, p.parse()?)?;
        println!("{} {} {} {}", row[0], row[1], row[2], row[3]);
        return Ok(());
    }
    let largest = arguments.iter().find_map(|a| a.parse().ok()).unwrap_or(LARGEST);
    let mut curves = Vec::new();
    println!(
        "| p | unknowns | seconds | peak, MB | estimate, MB | faer: seconds | faer: peak, MB |\n|---|---|---|---|---|---|---|"
    );
    for p in [2, 4, 8] {
        let (mut own, mut other) = (Vec::new(), Vec::new());
        for k in 0.. {
            let n = ((500.0 * 4.0_f64.powi(k)).sqrt() / p as f64).round().max(2.0) as usize;
            if 2 * n * n * p * p > largest {
                break;
            }
            let (a, b) = (child("case-own", n, p)?, child("case-faer", n, p)?);
            let mb = |bytes: f64| 1e-6 * bytes;
            println!("| {p} | {} | {:.3} | {:.0} | {:.0} | {:.3} | {:.0} |", a[0], a[1], mb(a[2]), mb(a[3]), b[1], mb(b[2]));
            own.push(a);
            other.push(b);
        }
        curves.push((p, own, other));
    }
    println!("\nexponents over the upper half of each curve:");
    for (p, own, other) in &curves {
        println!(
            "p = {p}: seconds {:.2}, bytes {:.2}; faer: seconds {:.2}, bytes {:.2}",
            exponent(own, 1),
            exponent(own, 2),
            exponent(other, 1),
            exponent(other, 2)
        );
    }
    if let Some(path) = arguments.iter().find(|a| a.ends_with(".svg")) {
        std::fs::write(path, picture(&curves))?;
    }
    Ok(())
}

/// Least-squares slope of the logarithms over the upper half of a curve.
fn exponent(rows: &[Row], column: usize) -> f64 {
    let upper: Vec<[f64; 2]> = rows[rows.len() / 2..].iter().map(|r| [r[0].ln(), r[column].ln()]).collect();
    let n = upper.len() as f64;
    let [mx, my] = [0, 1].map(|i| upper.iter().map(|r| r[i]).sum::<f64>() / n);
    upper.iter().map(|r| (r[0] - mx) * (r[1] - my)).sum::<f64>() / upper.iter().map(|r| (r[0] - mx).powi(2)).sum::<f64>()
}

fn child(case: &str, n: usize, p: usize) -> Outcome<Row> {
    let mut command = Command::new(std::env::current_exe()?);
    command.args([case, &n.to_string(), &p.to_string()]).env("RAYON_NUM_THREADS", "1");
    let text = String::from_utf8(command.output()?.stdout)?;
    let numbers = text.split_whitespace().map(str::parse).collect::<Result<Vec<f64>, _>>()?;
    Ok(numbers.try_into().map_err(|_| format!("{case} {n} {p} ended early"))?)
}

/// CPU seconds of this process, in steps of 0.01.
fn cpu() -> Outcome<f64> {
    let stat = std::fs::read_to_string("/proc/self/stat")?;
    let fields: Vec<&str> = stat.rsplit(')').next().unwrap_or("").split_whitespace().collect();
    Ok(0.01 * (fields[11].parse::<f64>()? + fields[12].parse::<f64>()?))
}

/// Peak resident memory of this process, bytes.
fn peak() -> Outcome<f64> {
    let status = std::fs::read_to_string("/proc/self/status")?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:")).ok_or("no VmHWM")?;
    Ok(1024.0 * line.split_whitespace().nth(1).ok_or("no number")?.parse::<f64>()?)
}

/// Runs a case, small ones often enough for the clock.
fn run(faer: bool, n: usize, p: usize) -> Outcome<Row> {
    let mesh = Arc::new(square(n)?);
    let start = cpu()?;
    let mut runs = 0.0;
    let mut result = [0.0; 2];
    while runs == 0.0 || cpu()? - start < 0.3 {
        result = if faer { skeleton(n, p)? } else { reduce(&mesh, p)? };
        runs += 1.0;
    }
    Ok([result[0], (cpu()? - start) / runs, peak()?, result[1]])
}

/// Unknowns and estimated bytes.
fn reduce(mesh: &Arc<Mesh>, p: usize) -> Outcome<[f64; 2]> {
    let kinematics = Kinematics::PlaneStrain { thickness: 1.0 };
    let problem = BodyProblem::new(Arc::clone(mesh), p, kinematics).material(Material::isotropic(1.0, 0.3)?);
    let body = Body::new(problem.clamp("bottom").keep("top"))?;
    Ok([body.effort.unknowns as f64, body.effort.bytes as f64])
}

/// The skeleton of the same cells as one sparse matrix, factorised by faer with AMD. The pattern is that of the condensed cells; values,
/// which the work does not depend on, are diagonally dominant. Building the matrix is counted, making and condensing cells is not.
fn skeleton(n: usize, p: usize) -> Outcome<[f64; 2]> {
    let vertex = |i: usize, j: usize| j * (n + 1) + i;
    let (vertices, rows) = ((n + 1) * (n + 1), n * (n + 1));
    let first = |edge: usize| vertices + edge * (p - 1);
    let mut triplets = Vec::new();
    for j in 0..n {
        for i in 0..n {
            let mut modes = vec![vertex(i, j), vertex(i + 1, j), vertex(i, j + 1), vertex(i + 1, j + 1)];
            for edge in [j * n + i, (j + 1) * n + i, rows + i * n + j, rows + (i + 1) * n + j] {
                modes.extend(first(edge)..first(edge) + p - 1);
            }
            let unknowns: Vec<usize> = modes.iter().flat_map(|m| [2 * m, 2 * m + 1]).collect();
            for a in &unknowns {
                for b in unknowns.iter().filter(|b| *b <= a) {
                    triplets.push(Triplet::new(*a, *b, if a == b { unknowns.len() as f64 } else { -0.5 }));
                }
            }
        }
    }
    let size = 2 * (vertices + 2 * rows * (p - 1));
    let matrix = SparseColMat::<usize, f64>::try_new_from_triplets(size, size, &triplets)?;
    drop(triplets);
    let parameters =
        CholeskySymbolicParams { supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL, ..Default::default() };
    let symbolic = factorize_symbolic_cholesky(matrix.symbolic(), faer::Side::Lower, SymmetricOrdering::Amd, parameters)?;
    let mut values = vec![0.0; symbolic.len_val()];
    let mut buffer =
        MemBuffer::try_new(symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Spec::default())).map_err(|_| "no memory")?;
    symbolic
        .factorize_numeric_llt(
            &mut values,
            matrix.as_ref(),
            faer::Side::Lower,
            Default::default(),
            Par::Seq,
            MemStack::new(&mut buffer),
            Spec::default(),
        )
        .map_err(|e| format!("{e:?}"))?;
    let interior = 2 * n * n * (p - 1) * (p - 1);
    Ok([(size + interior) as f64, 8.0 * symbolic.len_val() as f64])
}

/// Two log-log plots, seconds and bytes over unknowns: this crate in full lines, faer in broken ones, by degree.
fn picture(curves: &[(usize, Vec<Row>, Vec<Row>)]) -> String {
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"820\" height=\"400\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"820\" height=\"400\" fill=\"white\"/>\n",
    );
    let colours = ["#1f77b4", "#d62728", "#2ca02c"];
    for (panel, (title, column, low, high)) in [("CPU seconds", 1, -3, 2), ("peak bytes", 2, 6, 10)].into_iter().enumerate() {
        let left = 60.0 + 400.0 * panel as f64;
        let x = |v: f64| left + 320.0 * (v.log10() - 2.9) / 3.2;
        let y = |v: f64| 350.0 - 310.0 * (v.log10() - f64::from(low)) / f64::from(high - low);
        svg += &format!("<text x=\"{left}\" y=\"25\">{title} over unknowns</text>\n");
        for decade in low..=high {
            let h = y(10.0_f64.powi(decade));
            svg += &format!(
                "<path d=\"M{left},{h:.1}h320\" stroke=\"#ddd\"/><text x=\"{:.0}\" y=\"{:.1}\" text-anchor=\"end\">1e{decade}</text>\n",
                left - 6.0,
                h + 4.0
            );
        }
        for decade in 3..=6 {
            let v = x(10.0_f64.powi(decade));
            svg += &format!(
                "<path d=\"M{v:.1},40V350\" stroke=\"#ddd\"/><text x=\"{v:.1}\" y=\"368\" text-anchor=\"middle\">1e{decade}</text>\n"
            );
        }
        for ((p, own, other), colour) in curves.iter().zip(colours) {
            for (rows, dash) in [(own, ""), (other, " stroke-dasharray=\"5 4\"")] {
                let points: Vec<String> = rows.iter().map(|r| format!("{:.1},{:.1}", x(r[0]), y(r[column]))).collect();
                svg += &format!("<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\"{dash}/>\n", points.join(" "));
            }
            if panel == 0 {
                let h = 55 + 8 * p;
                svg += &format!("<text x=\"80\" y=\"{h}\" fill=\"{colour}\">p = {p}, broken: faer</text>\n");
            }
        }
    }
    svg + "</svg>\n"
}
