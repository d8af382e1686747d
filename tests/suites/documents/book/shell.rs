//! A shell in a separate folder, where the commands of a page are run as a reader would run them.

use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

use technolog_testing::root;

/// Where pages write what they show as a file, a drawing for one; the same folder stands in the repository.
pub const SHOWN: &str = "docs/shown";

/// What a reader sees of the repository.
const LINKED: [&str; 4] = ["tests", "catalogs", "rules", "README.md"];

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let to = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &to);
        } else {
            fs::copy(entry.path(), to).unwrap();
        }
    }
}

pub struct Shell {
    pub folder: PathBuf,
    /// The exit code of the last command.
    pub code: i32,
}

impl Shell {
    /// An empty folder named after the page, with the examples in it.
    pub fn new(name: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("docs").join(name.replace('/', "-"));
        if folder.exists() {
            fs::remove_dir_all(&folder).unwrap();
        }
        fs::create_dir_all(folder.join(SHOWN)).unwrap();
        for name in LINKED {
            symlink(root().join(name), folder.join(name)).unwrap();
        }
        // As files of the folder: a plan names only such.
        copy(&root().join("examples"), &folder.join("examples"));
        Self { folder, code: 0 }
    }

    /// What a command prints, and behind it what it writes to the error stream. `$?` is the code of the command before.
    pub fn run(&mut self, command: &str) -> String {
        let command = command.replace("cargo run -q --release -- ", "technolog ");
        let command = command.replace("cargo run --release -- ", "technolog ");
        let program = Path::new(env!("CARGO_BIN_EXE_technolog")).parent().unwrap();
        let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap_or_default());
        let script = format!("(exit {})\n{command}", self.code);
        let output = Command::new("sh")
            .args(["-c", &script])
            .current_dir(&self.folder)
            .env("PATH", path)
            .env_remove("LANG")
            .env_remove("COLUMNS")
            .output()
            .unwrap();
        self.code = output.status.code().unwrap_or_else(|| panic!("`{command}` was killed"));
        let streams = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
        streams.iter().flat_map(|text| text.lines()).map(|line| format!("{}\n", line.trim_end())).collect()
    }
}

/// Whether a line of a page is run: a command of ours, or one that prepares its files. Those of cargo are not.
pub fn is_run(command: &str) -> bool {
    let starts = ["technolog ", "cargo run --release -- ", "cargo run -q --release -- ", "COLUMNS=", "sed ", "echo $?"];
    starts.iter().any(|start| command.starts_with(start))
}
