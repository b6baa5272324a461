//! `cargo xtask outputs`: the files of a run opened by other programs.
//!
//! VTK opens the fields and compares them with contact.csv, ezdxf draws the profile, the official reader of MCAP reads the recording and
//! each message is held against its schema, and headless Chromium opens and uses the page: nothing asked of the network, nothing said on its
//! console. A page with faults shows first that Chromium would tell.

use crate::verify;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

/// Debian's packages.
const PACKAGES: [&str; 2] = ["chromium", "python3-venv"];
/// Python's packages, in an environment of their own under target/.
const MODULES: [&str; 5] = ["numpy", "vtk", "ezdxf", "mcap", "jsonschema"];

/// Scene, changes, and how far stress and displacement may be from contact.csv, relative to the largest there: displacements are as
/// accurate as the scene asks for (1e-6), stresses at single points of the boundary less, by what differentiation costs.
const CASES: [(&str, &[&str], [&str; 2]); 4] = [
    ("drum-brake-block", &[], ["1e-4", "1e-6"]),
    ("annular-punch", &["tasks=[\"contact\"]", "accuracy=1e-5"], ["1e-4", "1e-6"]),
    ("punch-wear", &[], ["1e-3", "1e-6"]),
    // Quadrilaterals and triangles of a gmsh file.
    ("data/meshes/lining.toml", &["accuracy=1e-6"], ["1e-4", "1e-6"]),
];

/// Widths of a window (pixels): a screen, and the narrowest that Chromium opens, where the page has the letters of a phone.
const WIDTHS: [usize; 2] = [1280, 500];

/// Uses the page: reads every chart, zooms and resets, drags the slider to its end; no word may stand beyond the picture that it is in.
const USE: &str = r#"<script nonce="check">
document.querySelectorAll("figure svg").forEach(svg => {
  if (!svg.onpointermove) return;
  const box = svg.getBoundingClientRect();
  const send = (type, share) => svg.dispatchEvent(new PointerEvent(type, { clientX: box.left + share * box.width, clientY: box.top + 9 }));
  send("pointermove", 0.5); send("pointerdown", 0.4); send("pointermove", 0.6); send("pointerup", 0.7);
  send("pointermove", 0.5); send("dblclick", 0.5); send("pointerleave", 0.5);
});
const slider = document.getElementById("step");
if (slider) { slider.value = slider.max; slider.dispatchEvent(new Event("input")); }
const beyond = [...document.querySelectorAll("figure svg")].flatMap(svg => {
  const box = svg.getBoundingClientRect();
  return [...svg.querySelectorAll("text")].filter(text => {
    const at = text.getBoundingClientRect();
    // A line of letters has some room about them.
    return at.width > 0 && (at.left < box.left - 1 || at.right > box.right + 1);
  });
});
document.body.dataset.beyond = beyond.map(text => text.textContent).join(", ");
document.body.dataset.used = document.querySelectorAll("figure svg path").length > 10 ? "well" : "without charts";
</script>"#;

const FAULTY: &str = "<!doctype html><body><img src=\"http://localhost:9/x.png\"><script>fetch(\"https://localhost:9/\").catch(() => 0); missing();</script>";

/// Installs what is missing, runs the scenes, and opens their files.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    let install = words.iter().any(|word| word == "--install");
    match check(root, install) {
        Ok(()) => {
            println!("outputs: every file opens and says what it should");
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("outputs: {message}");
            ExitCode::FAILURE
        }
    }
}

fn check(root: &Path, install: bool) -> Result<(), String> {
    let folder = root.join("target/outputs");
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let python = folder.join("venv/bin/python");
    if install {
        verify::debian::install_packages(&PACKAGES)?;
        environment(&folder, &python)?;
    }
    faults_are_seen(&folder)?;
    let wearshape = verify::programs::build(root)?;
    for (scene, changes, limits) in CASES {
        println!("{scene}");
        let name = Path::new(scene).file_stem().unwrap_or_default();
        let out = folder.join(name);
        let mut command = Command::new(&wearshape);
        command.args([
            "run",
            scene,
            "-q",
            "--sample",
            "4001",
            "--set",
            "output.fields=true",
            "--set",
            "output.recording=true",
            "-o",
        ]);
        command.arg(&out);
        changes.iter().for_each(|change| {
            command.args(["--set", change]);
        });
        finished(command.current_dir(root))?;
        finished(script(root, &python, "outputs_vtk.py").arg(&out).args(limits))?;
        finished(script(root, &python, "outputs_files.py").arg(&out))?;
        page(&folder, &out)?;
    }
    Ok(())
}

fn environment(folder: &Path, python: &Path) -> Result<(), String> {
    if !python.exists() {
        finished(Command::new(verify::programs::PYTHON).args(["-m", "venv"]).arg(folder.join("venv")))?;
    }
    finished(Command::new(python).args(["-m", "pip", "install", "-q", "--disable-pip-version-check"]).args(MODULES))
}

fn script(root: &Path, python: &Path, name: &str) -> Command {
    let mut command = Command::new(python);
    command.arg("-B").arg(root.join("verify").join(name)).env_remove("PYTHONPATH");
    command
}

fn finished(command: &mut Command) -> Result<(), String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let status = command.stdin(Stdio::null()).status();
    let status = status.map_err(|error| format!("{name}: {error}; remedy: cargo xtask outputs --install"))?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("{name} {:?} ended with {status}", command.get_args().collect::<Vec<_>>()))
    }
}

/// What Chromium said of a page.
struct Visit {
    /// Its document after the scripts.
    document: String,
    /// Lines of its console.
    console: Vec<String>,
    /// Addresses that it asked for.
    requests: Vec<String>,
}

/// Opens a page in headless Chromium, with a log of all that goes to the network.
fn visit(folder: &Path, page: &Path, width: usize) -> Result<Visit, String> {
    let log = folder.join("network.json");
    let _ = fs::remove_file(&log);
    let output = Command::new("timeout")
        .args(["60", "chromium", "--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking"])
        .args(["--no-first-run", "--disable-component-update", "--disable-sync", "--enable-logging=stderr", "--dump-dom"])
        // No name is ever resolved: what Chromium asks for itself goes nowhere either.
        .arg("--host-resolver-rules=MAP * ~NOTFOUND")
        .arg(format!("--user-data-dir={}", folder.join("chromium").display()))
        .arg(format!("--log-net-log={}", log.display()))
        .arg(format!("--window-size={width},900"))
        .arg(format!("file://{}", page.display()))
        .stdin(Stdio::null())
        .output()
        .map_err(|error| format!("chromium: {error}; remedy: cargo xtask outputs --install"))?;
    let events = fs::read_to_string(&log).map_err(|error| format!("{}: {error}", log.display()))?;
    let requests = events.lines().filter_map(request).collect();
    let words = String::from_utf8_lossy(&output.stderr);
    let console = words.lines().filter(|line| line.contains(":CONSOLE")).map(String::from).collect();
    Ok(Visit { document: String::from_utf8_lossy(&output.stdout).into_owned(), console, requests })
}

/// The address of a request by a page, in a line of the log; those of Chromium itself have no origin.
fn request(line: &str) -> Option<String> {
    let url = line.split_once("\"url\":\"")?.1.split('"').next()?;
    let by_page = line.contains("\"initiator\":\"") && !line.contains("\"initiator\":\"not an origin\"");
    (by_page && url.starts_with("http")).then(|| url.to_string())
}

fn page(folder: &Path, out: &Path) -> Result<(), String> {
    let report = out.join("report.html");
    let text = fs::read_to_string(&report).map_err(|error| format!("{}: {error}", report.display()))?;
    let used: PathBuf = folder.join("used.html");
    // The page lets no script run but its own, by hash; that of the check is let in by name beside it.
    let open = text.replacen("script-src '", "script-src 'nonce-check' '", 1);
    fs::write(&used, open + USE).map_err(|error| format!("{}: {error}", used.display()))?;
    for width in WIDTHS {
        let visit = visit(folder, &used, width)?;
        if !visit.document.contains("data-used=\"well\"") {
            return Err("report.html: its charts are not drawn".into());
        }
        let beyond = visit.document.split("data-beyond=\"").nth(1).and_then(|rest| rest.split('"').next()).unwrap_or("all");
        if !beyond.is_empty() {
            return Err(format!("report.html, {width} pixels wide: beyond their pictures stand {beyond}"));
        }
        if !visit.console.is_empty() || !visit.requests.is_empty() {
            return Err(format!("report.html: console {:?}, requests {:?}", visit.console, visit.requests));
        }
    }
    println!("  report.html in Chromium: drawn, used, on a screen and as on a phone; 0 requests, 0 words on the console");
    Ok(())
}

/// A page with a missing function and two requests must be caught, or the checks prove nothing.
fn faults_are_seen(folder: &Path) -> Result<(), String> {
    let page = folder.join("faulty.html");
    fs::write(&page, FAULTY).map_err(|error| format!("{}: {error}", page.display()))?;
    let visit = visit(folder, &page, WIDTHS[0])?;
    let error = visit.console.iter().any(|line| line.contains("missing is not defined"));
    let asked =
        ["http://localhost:9/x.png", "https://localhost:9/"].iter().all(|url| visit.requests.iter().any(|seen| seen == url));
    if error && asked {
        return Ok(());
    }
    Err(format!("a page with faults passes: console {:?}, requests {:?}", visit.console, visit.requests))
}
