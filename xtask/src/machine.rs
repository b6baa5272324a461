//! What measured, and when.

use std::fs;
use std::process::Command;

/// Date, processor, cores and compiler, in one line.
pub(crate) fn machine() -> String {
    let cpu = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let cpu = cpu.lines().find(|line| line.starts_with("model name")).and_then(|line| line.split(": ").nth(1));
    let cores = std::thread::available_parallelism().map_or(0, usize::from);
    let date = first_line("date", &["-u", "+%Y-%m-%d"]);
    let rustc = first_line("rustc", &["--version"]);
    format!("{date}; {}, {cores} cores; {rustc}", cpu.unwrap_or("processor unknown"))
}

fn first_line(program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
    text.lines().next().unwrap_or("?").to_string()
}
