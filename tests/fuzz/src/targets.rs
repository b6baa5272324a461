//! What reads an input, and what must hold of it whatever the input is.

use std::fs;
use std::path::{Path, PathBuf};

use scene::{Document, Fault, SCENES};
use wearshape::Problem;

use crate::random::Random;
use crate::recording::Recordings;

/// A flat punch with a place for a gap profile, and one with a place for a mesh.
const PROFILE_SCENE: &str = include_str!("../corpus/profile.toml");
const MESH_SCENE: &str = include_str!("../corpus/mesh.toml");
/// A run in time whose load changes, which no built-in scene has.
const SCHEDULE_SCENE: &str = include_str!("../corpus/schedule.toml");
/// Gap profiles: commas, semicolons with units, blanks with comments.
const PROFILES: [&[u8]; 3] = [
    b"s_mm,gap_um\n-30,12.5\n-10.5,3\n0,0\n12,1e1\n30,13\n",
    b"\"gap_um\";\"s_cm\"\n12,5;-3,0\n0;0\n1.5e1;3\n",
    b"# measured\ns_mm gap_um note\n-30 1 a\n-29 2 b\n\n30 0.5 c\n",
];

/// What became of an input.
#[derive(Debug)]
pub(crate) enum Outcome {
    /// It was read, or computed from.
    Accepted,
    /// It was refused in words.
    Refused,
}

/// A reader of inputs.
pub(crate) enum Target {
    /// Scenes.
    Scene,
    /// gmsh files.
    Gmsh,
    /// Gap profiles.
    Profile,
    /// Recordings of a run.
    Recording(Box<Recordings>),
}

impl Target {
    /// A target by its name; it may write to a folder.
    pub(crate) fn new(name: &str, folder: &Path) -> Result<Target, String> {
        match name {
            "scene" => Ok(Target::Scene),
            "gmsh" => Ok(Target::Gmsh),
            "profile" => Ok(Target::Profile),
            "recording" => Ok(Target::Recording(Box::new(Recordings::new(folder)?))),
            _ => Err(format!("there is no target `{name}`: write scene, gmsh, profile or recording")),
        }
    }

    /// Sound inputs to begin with.
    pub(crate) fn corpus(&self) -> Result<Vec<Vec<u8>>, String> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        match self {
            Target::Scene => {
                let own = SCENES.iter().map(|scene| scene.text).chain([SCHEDULE_SCENE, PROFILE_SCENE, MESH_SCENE]);
                Ok(own.map(|text| text.as_bytes().to_vec()).collect())
            }
            Target::Gmsh => {
                let packed = root.join("crates/hpfem/tests/meshes/gmsh.corpus");
                let mut found = unpacked(&fs::read(&packed).map_err(|error| format!("{}: {error}", packed.display()))?);
                // Sound ones as often as those that were worth keeping.
                let mut sound = meshes(&root.join("crates/hpfem/tests/meshes"))?;
                sound.extend(meshes(&root.join("data/meshes"))?);
                let times = found.len() / sound.len().max(1);
                (0..times).for_each(|_| found.extend(sound.iter().cloned()));
                Ok(found)
            }
            Target::Profile => Ok(PROFILES.map(<[u8]>::to_vec).to_vec()),
            Target::Recording(recordings) => Ok(vec![recordings.whole().to_vec()]),
        }
    }

    /// A changed input; those of recordings get right checksums.
    pub(crate) fn mutated(
        &self,
        corpus: &[Vec<u8>],
        random: &mut Random,
        mutated: fn(&[Vec<u8>], &mut Random) -> Vec<u8>,
    ) -> Vec<u8> {
        match self {
            Target::Recording(recordings) if random.below(4) > 0 => recordings.rebuilt(random, mutated),
            _ => mutated(corpus, random),
        }
    }

    /// Reads an input.
    ///
    /// # Errors
    /// The program disagrees with itself.
    pub(crate) fn give(&self, input: &[u8]) -> Result<Outcome, String> {
        match self {
            Target::Scene => match std::str::from_utf8(input) {
                Ok(text) => posed(text, &|name| fs::read(meshes_folder().join(name)).map_err(|error| error.to_string())),
                Err(_) => Ok(Outcome::Refused),
            },
            Target::Gmsh => {
                let read = hpfem::GmshMesh::read(input);
                // Most meshes are none of this scene.
                match (posed(MESH_SCENE, &|_| Ok(input.to_vec()))?, read) {
                    (Outcome::Accepted, Err(_)) => Err("a mesh that cannot be read is solved".into()),
                    (Outcome::Refused, Err(_)) => Ok(Outcome::Refused),
                    _ => Ok(Outcome::Accepted),
                }
            }
            Target::Profile => posed(PROFILE_SCENE, &|_| Ok(input.to_vec())),
            Target::Recording(recordings) => recordings.give(input),
        }
    }
}

fn meshes_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/meshes")
}

/// Poses the problem of a scene. One that is sound is written with every default, and that scene poses the same problem.
fn posed(text: &str, files: &dyn Fn(&str) -> Result<Vec<u8>, String>) -> Result<Outcome, String> {
    let pose = |text: &str, files: &dyn Fn(&str) -> Result<Vec<u8>, String>| {
        Document::read("scene.toml", text, &[]).and_then(|document| Problem::new(&document, files))
    };
    let problem = match pose(text, files) {
        Ok(problem) => problem,
        Err(fault) => return refused(&fault),
    };
    let _ = problem.outlines();
    let resolved = problem.resolved();
    let beside = problem.files();
    let file = |name: &str| {
        let found = beside.iter().find(|(known, _)| known == name);
        found.map(|(_, bytes)| bytes.clone()).ok_or_else(|| format!("{name} is not beside the resolved scene"))
    };
    match pose(&resolved, &file) {
        Err(fault) => Err(format!("the resolved scene is refused: {}", fault.message)),
        Ok(again) if again.resolved() != resolved => Err("the resolved scene resolves to another".into()),
        Ok(_) => Ok(Outcome::Accepted),
    }
}

/// A refusal says what is wrong and what to do.
fn refused(fault: &Fault) -> Result<Outcome, String> {
    if fault.message.is_empty() || fault.remedy.is_empty() {
        return Err(format!("a refusal without words: {fault:?}"));
    }
    Ok(Outcome::Refused)
}

/// The gmsh files of a folder, by name.
fn meshes(folder: &Path) -> Result<Vec<Vec<u8>>, String> {
    let entries = fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "msh"));
    paths.sort();
    paths.iter().map(|path| fs::read(path).map_err(|error| format!("{}: {error}", path.display()))).collect()
}

/// Inputs packed one after another, each behind its length as four bytes, the lowest first.
fn unpacked(mut packed: &[u8]) -> Vec<Vec<u8>> {
    let mut found = Vec::new();
    while let Some((length, rest)) = packed.split_first_chunk::<4>() {
        let (one, rest) = rest.split_at((u32::from_le_bytes(*length) as usize).min(rest.len()));
        found.push(one.to_vec());
        packed = rest;
    }
    found
}
