//! Lists the message files of every folder in `languages/`, so that a language is added by adding its folder.

use std::fmt::Write as _;
use std::path::Path;
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let root = Path::new(&env::var("CARGO_MANIFEST_DIR").map_err(io::Error::other)?).join("languages");
    println!("cargo::rerun-if-changed={}", root.display());
    let mut list = "/// The message files of each language: its folder, then name and text of each file.\n".to_owned();
    list.push_str("static FILES: &[(&str, &[(&str, &str)])] = &[\n");
    for folder in sorted(&root)? {
        writeln!(list, "({:?}, &[", name(&folder)).map_err(io::Error::other)?;
        for file in sorted(&folder)? {
            writeln!(list, "({:?}, include_str!({file:?})),", name(&file)).map_err(io::Error::other)?;
        }
        list.push_str("]),\n");
    }
    list.push_str("];\n");
    fs::write(Path::new(&env::var("OUT_DIR").map_err(io::Error::other)?).join("files.rs"), list)
}

fn sorted(folder: &Path) -> io::Result<Vec<std::path::PathBuf>> {
    let mut inside = fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    inside.sort();
    Ok(inside)
}

fn name(path: &Path) -> String {
    path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}
