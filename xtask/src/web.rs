//! `cargo xtask web`: the page that computes, into `target/web`: static files for any server. `--test` uses it in headless Chromium, and calls the module of
//! hpfem alone that is built beside it.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::time::Instant;

use super::packages::{cargo, done, printed};
use super::{tube, verify};

const WASM: &str = "wasm32-unknown-unknown";
/// The folder of the package: the page, what it takes from npm, the test.
const FOLDER: &str = "crates/web";
/// Debian's packages for the test.
const PACKAGES: [&str; 2] = ["chromium", "python3-venv"];
/// What drives Chromium.
const DRIVER: &str = "playwright>=1.50,<2";
/// What all processors of browsers since 2023 have, a stack as large as that of a program, and names of files without the folder of all crates.
const FLAGS: &str = "-C target-feature=+simd128 -C link-arg=-zstack-size=8388608 --remap-path-prefix=crates/=";
/// What takes 2 % off the module, of the steps after the compiler's (`wasm-opt` of Binaryen): the first level, as the others
/// make it larger by brotli, without sets of what is there already and arguments that nothing reads, again until it gets no smaller, without the
/// alignments of what is read, which processors find themselves; and what the module is built for.
const SMALLER: [&str; 13] = [
    "-O1",
    "--rse",
    "--vacuum",
    "--dae-optimizing",
    "--converge",
    "--dealign",
    "--enable-simd",
    "--enable-bulk-memory",
    "--enable-sign-ext",
    "--enable-nontrapping-float-to-int",
    "--enable-mutable-globals",
    "--enable-reference-types",
    "--enable-multivalue",
];
/// Prints name, bytes, and bytes by gzip and brotli of each file of a folder.
const COMPRESS: &str = r#"
import { readFileSync, readdirSync } from "node:fs";
import { brotliCompressSync, gzipSync } from "node:zlib";
for (const name of readdirSync(process.argv[1]).sort()) {
  const bytes = readFileSync(`${process.argv[1]}/${name}`);
  console.log(name, bytes.length, gzipSync(bytes, { level: 9 }).length, brotliCompressSync(bytes).length);
}"#;
/// Most bytes of the module by brotli, and of all files by gzip.
const MOST: [usize; 2] = [1_000_000, 2_000_000];

/// Builds the page, and tests it where asked for.
pub(crate) fn run(root: &Path, words: &[String]) -> ExitCode {
    let outcome = match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => built(root, false),
        ["--install"] => built(root, true),
        ["--test"] => built(root, false).and_then(|()| tested(root, false)),
        ["--test", "--install"] | ["--install", "--test"] => built(root, true).and_then(|()| tested(root, true)),
        _ => Err("takes `--test` and `--install` or nothing".into()),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("web: {message}");
            ExitCode::FAILURE
        }
    }
}

fn built(root: &Path, install: bool) -> Result<(), String> {
    let start = Instant::now();
    let flags = format!("CARGO_TARGET_{}_RUSTFLAGS", WASM.to_uppercase().replace('-', "_"));
    let mut build = cargo(root);
    build.args(["build", "--quiet", "--locked", "--profile", "browser", "--target", WASM]);
    build.args(["--package", "wearshape-web", "--package", tube::PACKAGE]);
    done(build.env(flags, format!("{FLAGS}{}", without_registry())))?;
    let out = root.join("target/web");
    if out.exists() {
        fs::remove_dir_all(&out).map_err(|error| format!("{}: {error}", out.display()))?;
    }
    fs::create_dir_all(&out).map_err(|error| format!("{}: {error}", out.display()))?;
    let packages = packages(root, install)?;
    copy(&smaller(root, &packages)?, &out.join("wearshape.wasm"))?;
    let page = root.join(FOLDER).join("page");
    for entry in fs::read_dir(&page).map_err(|error| format!("{}: {error}", page.display()))? {
        let path = entry.map_err(|error| format!("{}: {error}", page.display()))?.path();
        copy(&path, &out.join(path.file_name().unwrap_or_default()))?;
    }
    // What stands behind each note, which the module need not carry.
    copy(&root.join("docs/lints.md"), &out.join("notes.md"))?;
    charts(root, &packages.join("uplot"), &out)?;
    sizes(&out)?;
    println!("{:4.0} s  built into target/web", start.elapsed().as_secs_f64());
    Ok(())
}

/// The module of the page made smaller, which takes a minute: once for each module, way of making it smaller and version of the packages.
fn smaller(root: &Path, packages: &Path) -> Result<PathBuf, String> {
    let module = module(root, "wearshape_web");
    let bytes = fs::read(&module).map_err(|error| format!("{}: {error}", module.display()))?;
    let mut made_of = DefaultHasher::new();
    (bytes, SMALLER, text(&root.join(FOLDER).join("package-lock.json"))?).hash(&mut made_of);
    let folder = root.join("target/web-smaller");
    let path = folder.join(format!("{:016x}.wasm", made_of.finish()));
    if path.exists() {
        return Ok(path);
    }
    if folder.exists() {
        fs::remove_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let partial = folder.join("partial");
    let mut tool = Command::new("node");
    tool.arg(packages.join("binaryen/bin/wasm-opt")).args(SMALLER).arg(module).arg("--output").arg(&partial);
    done(&mut tool)?;
    fs::rename(&partial, &path).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(path)
}

/// A module as the compiler made it.
fn module(root: &Path, name: &str) -> PathBuf {
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    target.join(WASM).join("browser").join(name).with_extension("wasm")
}

/// Flags that leave the folder of the registry out of the names of files that the module holds: it is this machine's, and takes place.
fn without_registry() -> String {
    let home = std::env::home_dir().unwrap_or_default();
    let cargo = std::env::var_os("CARGO_HOME").map_or_else(|| home.join(".cargo"), PathBuf::from);
    let folders = fs::read_dir(cargo.join("registry/src")).into_iter().flatten().flatten();
    let mut folders: Vec<String> = folders.map(|folder| folder.path().display().to_string()).collect();
    folders.sort();
    // Flags end at spaces.
    folders.retain(|folder| !folder.contains(' '));
    folders.iter().map(|folder| format!(" --remap-path-prefix={folder}/=")).collect()
}

fn copy(from: &Path, to: &Path) -> Result<(), String> {
    fs::copy(from, to).map(drop).map_err(|error| format!("{}: {error}", from.display()))
}

fn text(path: &Path) -> Result<String, String> {
    fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))
}

/// The folder of the packages from npm, in the versions that the lock file holds with their hashes.
fn packages(root: &Path, install: bool) -> Result<PathBuf, String> {
    let packages = root.join("target/web-packages");
    fs::create_dir_all(&packages).map_err(|error| format!("{}: {error}", packages.display()))?;
    for file in ["package.json", "package-lock.json"] {
        copy(&root.join(FOLDER).join(file), &packages.join(file))?;
    }
    let modules = packages.join("node_modules");
    let locked = text(&packages.join("package-lock.json"))?;
    let there = text(&modules.join(".package-lock.json")).unwrap_or_default();
    if hashes(&there) != hashes(&locked) {
        if install && Command::new("npm").arg("--version").output().is_err() {
            verify::debian::install_packages(&["npm"])?;
        }
        let mut npm = Command::new("npm");
        npm.args(["ci", "--ignore-scripts", "--no-audit", "--no-fund", "--loglevel=error"]);
        done(npm.current_dir(&packages).stdin(std::process::Stdio::null()))?;
    }
    Ok(modules)
}

/// The library that draws, as a module; and the licences of the page.
fn charts(root: &Path, library: &Path, out: &Path) -> Result<(), String> {
    let script = text(&library.join("dist/uPlot.iife.min.js"))?;
    write(&out.join("uplot.js"), &format!("{script}\nexport default uPlot;\n"))?;
    copy(&library.join("dist/uPlot.min.css"), &out.join("uplot.css"))?;
    let mut licences = format!("wearshape: MIT or Apache-2.0\n\n{}\n", text(&root.join("LICENSE-MIT"))?);
    licences += &format!("----\nuPlot, which draws the charts\n\n{}\n----\n", text(&library.join("LICENSE"))?);
    licences += &super::supply::notices_of(root, "wearshape-web", WASM)?;
    write(&out.join("licences.txt"), &licences)
}

/// The hashes of the packages in a lock file.
fn hashes(lock: &str) -> Vec<&str> {
    lock.split("\"integrity\": \"").skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

/// Prints the size of each file, as it is and as servers send it, compressed by gzip or brotli.
fn sizes(out: &Path) -> Result<(), String> {
    let table = printed(Command::new("node").args(["--input-type=module", "--eval", COMPRESS]).arg(out))?;
    let mut totals = [0; 3];
    for line in table.lines() {
        let (name, numbers) = line.split_once(' ').ok_or("node printed no sizes")?;
        let numbers: Vec<usize> = numbers.split(' ').filter_map(|number| number.parse().ok()).collect();
        let [raw, gzip, brotli] = numbers[..] else { return Err(format!("node printed `{line}`")) };
        totals = [totals[0] + raw, totals[1] + gzip, totals[2] + brotli];
        if raw > 20_000 {
            println!("{raw:>9} bytes, {gzip:>7} by gzip, {brotli:>7} by brotli  {name}");
        }
        if name.ends_with(".wasm") && brotli > MOST[0] {
            return Err(format!("the module has {brotli} bytes by brotli, more than {}", MOST[0]));
        }
    }
    let [raw, gzip, brotli] = totals;
    println!("{raw:>9} bytes, {gzip:>7} by gzip, {brotli:>7} by brotli  all {} files", table.lines().count());
    if gzip > MOST[1] {
        return Err(format!("the page has {gzip} bytes by gzip, more than {}", MOST[1]));
    }
    Ok(())
}

/// Uses the page in Chromium and compares its numbers with those of the program.
fn tested(root: &Path, install: bool) -> Result<(), String> {
    let start = Instant::now();
    if install {
        verify::debian::install_packages(&PACKAGES)?;
    }
    let folder = root.join("target/web-test");
    let python = folder.join("venv/bin/python");
    fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    if !python.exists() {
        done(Command::new(verify::programs::PYTHON).args(["-m", "venv"]).arg(folder.join("venv")))?;
    }
    let mut known = Command::new(&python);
    if !known.args(["-c", "import playwright"]).output().is_ok_and(|output| output.status.success()) {
        done(Command::new(&python).args(["-m", "pip", "install", "-q", "--disable-pip-version-check", DRIVER]))?;
    }
    let program = verify::programs::build(root)?;
    let mut test = Command::new(&python);
    test.arg(root.join(FOLDER).join("tests/browser.py")).arg(root.join("target/web")).arg(&program).arg(&folder);
    print!("{}", printed(test.current_dir(root).stdin(std::process::Stdio::null()))?);
    println!("{:4.0} s  used in Chromium; pictures in target/web-test", start.elapsed().as_secs_f64());
    println!("        {}", tube::compared(root, &module(root, tube::PACKAGE))?);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::hashes;

    #[test]
    fn the_hashes_of_a_lock_file_are_found() {
        let lock = r#"{ "packages": { "node_modules/uplot": { "version": "1.6.32", "integrity": "sha512-abc==", "dev": true },
            "node_modules/other": { "integrity": "sha512-d==" } } }"#;
        assert_eq!(hashes(lock), ["sha512-abc==", "sha512-d=="]);
        assert!(hashes("{}").is_empty());
    }
}
