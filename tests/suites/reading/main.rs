//! Files that people write: what is too large, too deep or no file at all, and how what is wrong with them is told.

#![allow(clippy::disallowed_methods, reason = "tests hold the codes of notes against what is expected")]
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "clippy allows it in tests, but not in the functions they share"
)]

mod arguments;
mod files;
mod fuzz;
mod kinds;
mod limits;
mod missing;
mod paths;
mod problems;
mod signs;

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// An empty folder of that name.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("reading").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// What a command answered.
struct Said {
    answer: String,
    beside: String,
    code: Option<i32>,
}

/// Runs a command in a folder, with what it gets from a pipe.
fn command(folder: &Path, arguments: &[&str], piped: &[u8]) -> Said {
    let mut command = Command::new(env!("CARGO_BIN_EXE_technolog"));
    command.args(arguments).args(["--lang", "en"]).current_dir(folder);
    let mut child =
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    // Where it reads no more than a bound the pipe breaks, which is what is asked for.
    let _ = child.stdin.take().unwrap().write_all(piped);
    let output = child.wait_with_output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Said { answer: text(output.stdout), beside: text(output.stderr), code: output.status.code() }
}
