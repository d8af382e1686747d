//! Lists the message files of every folder in `languages/` and the place of each message, so that a language is added
//! by adding its folder.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    list("languages", "files.rs")?;
    // A third, partial language for the tests.
    list("tests/languages", "test_files.rs")
}

/// Writes the folders inside `root` as a slice of `Folder`.
fn list(root: &str, to: &str) -> io::Result<()> {
    let root = Path::new(&env::var("CARGO_MANIFEST_DIR").map_err(io::Error::other)?).join(root);
    println!("cargo::rerun-if-changed={}", root.display());
    let mut list = "&[\n".to_owned();
    for folder in sorted(&root)? {
        // Read once: the places must be those of exactly this text.
        let read = |file: PathBuf| Ok((name(&file), fs::read_to_string(file)?));
        let files = sorted(&folder)?.into_iter().map(read).collect::<io::Result<Vec<_>>>()?;
        writeln!(list, "Folder {{ tag: {:?}, files: &[", name(&folder)).map_err(io::Error::other)?;
        for file in &files {
            writeln!(list, "{file:?},").map_err(io::Error::other)?;
        }
        list.push_str("], messages: &[\n");
        for (_, [file, begin, end]) in messages(&files) {
            writeln!(list, "MessageSpan({file}, {begin}, {end}),").map_err(io::Error::other)?;
        }
        list.push_str("] },\n");
    }
    list.push_str("]\n");
    fs::write(Path::new(&env::var("OUT_DIR").map_err(io::Error::other)?).join(to), list)
}

/// Name of each message, number of its file, begin and end there, ordered by name. If a name occurs twice, the first
/// stays, and the check of the catalogue reports it.
fn messages(files: &[(String, String)]) -> Vec<(&str, [usize; 3])> {
    let mut messages = Vec::new();
    for (number, (_, text)) in files.iter().enumerate().filter(|(_, (name, _))| name.ends_with(".ftl")) {
        let places = divided(text).into_iter();
        messages.extend(places.map(|(begin, end)| {
            let name = text[begin..end].split([' ', '=']).next().unwrap_or_default();
            (name, [number, begin, end])
        }));
    }
    messages.sort();
    messages.dedup_by(|later, first| later.0 == first.0);
    messages
}

/// The places of the messages of a file. A message begins with its name at the beginning of a line and ends before
/// the next message or comment.
fn divided(text: &str) -> Vec<(usize, usize)> {
    let mut places = Vec::new();
    let (mut begin, mut at) = (None, 0);
    for line in text.split_inclusive('\n') {
        let first = line.as_bytes().first().copied().unwrap_or_default();
        if first.is_ascii_alphabetic() || first == b'#' {
            places.extend(begin.map(|begin| (begin, at)));
            begin = first.is_ascii_alphabetic().then_some(at);
        }
        at += line.len();
    }
    places.extend(begin.map(|begin| (begin, at)));
    places
}

fn sorted(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut inside = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    inside.sort();
    Ok(inside)
}

fn name(path: &Path) -> String {
    path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}
