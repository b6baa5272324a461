//! A fault of the program itself: what to report, and where.

use std::backtrace::{Backtrace, BacktraceStatus};
use std::io::Write;
use std::panic::PanicHookInfo;

/// From here on a panic is told in two lines on stderr; with `RUST_BACKTRACE=1` the calls follow. The program ends with 101.
pub fn tell_panics() {
    std::panic::set_hook(Box::new(|panic| {
        let calls = Backtrace::capture();
        let mut text = words(panic);
        if calls.status() == BacktraceStatus::Captured {
            text += &format!("{calls}\n");
        }
        // Nothing is left to be done where not even this can be written.
        let _ = std::io::stderr().write_all(text.as_bytes());
    }));
}

/// The two lines.
fn words(panic: &PanicHookInfo<'_>) -> String {
    let place = panic.location().map_or_else(|| "an unknown place".to_string(), ToString::to_string);
    let (payload, said) = (panic.payload(), "no message");
    let said = payload.downcast_ref::<&str>().copied().or(payload.downcast_ref::<String>().map(String::as_str)).unwrap_or(said);
    let what = said.replace('\n', " ");
    format!(
        "fault of wearshape {} itself, at {place}: {what}\n\
         please report this line with the call and its scene in the issue tracker of the project; files written before are as they were\n",
        env!("CARGO_PKG_VERSION")
    )
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    /// Called by the test below in a process of its own.
    #[test]
    #[ignore = "panics on purpose"]
    fn falls() {
        super::tell_panics();
        panic!("in two\nlines");
    }

    #[test]
    fn a_panic_says_in_two_lines_what_to_report_and_where() {
        let mut tests = std::process::Command::new(std::env::current_exe().unwrap());
        let call = ["--ignored", "--exact", "--nocapture", "panics::tests::falls"];
        let output = tests.args(call).env_remove("RUST_BACKTRACE").output().unwrap();
        assert_eq!(output.status.code(), Some(101));
        let said = String::from_utf8(output.stderr).unwrap();
        let lines: Vec<&str> = said.lines().collect();
        assert_eq!(lines.len(), 2, "{said}");
        assert!(lines[0].contains(env!("CARGO_PKG_VERSION")) && lines[0].contains("panics.rs:"), "{said}");
        assert!(lines[0].ends_with("in two lines") && lines[1].contains("issue tracker"), "{said}");
    }
}
