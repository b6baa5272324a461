//! `wearshape new`: a commented scene to start from.

use scene::{Fault, Place, SCENES, builtin, did_you_mean};

use crate::again::quoted;
use crate::args::NewArgs;
use crate::exit::Exit;
use crate::print::{print_out, talk};

/// Lists the templates, prints one, or writes it.
pub(crate) fn run(args: &NewArgs) -> Result<Exit, Fault> {
    let Some(name) = args.template.as_ref().filter(|_| !args.list) else {
        for scene in &SCENES {
            print_out(&format!("{:<20} {}\n", scene.name, scene.title()));
        }
        return Ok(Exit::Done);
    };
    let Some(scene) = builtin(name) else {
        let names: Vec<&str> = SCENES.iter().map(|scene| scene.name).collect();
        let message = format!("there is no template `{name}`");
        return Err(at(name, Fault::new("no-template", message, did_you_mean(name, &names))));
    };
    let Some(path) = &args.file else {
        print_out(scene.text);
        return Ok(Exit::Done);
    };
    let shown = path.display();
    let written =
        std::fs::File::create_new(path).and_then(|mut file| std::io::Write::write_all(&mut file, scene.text.as_bytes()));
    match written {
        Ok(()) => {
            talk(&format!("{shown} written; next: wearshape run {}", quoted(&shown.to_string())));
            Ok(Exit::Done)
        }
        Err(error) if error.kind() == std::io::ErrorKind::AlreadyExists => {
            let message = format!("{shown} exists already and is left as it is");
            Err(at(&shown, Fault::new("file-exists", message, "give another name, or remove the file first")))
        }
        Err(error) => {
            let message = format!("cannot write {shown}: {error}");
            Err(at(&shown, Fault::new("unwritable", message, "give a path in a folder that exists and can be written")))
        }
    }
}

/// A fault of one word of the call.
fn at(word: &impl std::fmt::Display, fault: Fault) -> Fault {
    Fault { place: Some(Place::Flag(word.to_string())), ..fault }
}
