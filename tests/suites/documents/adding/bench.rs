//! A copy of the knowledge in which a recipe is carried out, block by block.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use technolog::knowledge::{Knowledge, SourceFile};
use technolog::tables;
use technolog_testing::root;

use super::page::{Block, Doing, is_answer, stands_for};

/// A text with the lines of a change gone and come. Its other lines must stand together in one place of the text.
fn changed(text: &str, change: &[&str]) -> Result<String, String> {
    let there = |line: &&&str| !line.starts_with('+');
    let old: Vec<&str> = change.iter().filter(there).map(|line| line.get(1..).unwrap_or_default()).collect();
    let lines: Vec<&str> = text.lines().collect();
    let is_here =
        |at: &usize| lines[*at..].iter().zip(&old).filter(|(line, page)| stands_for(page, line)).count() == old.len();
    let places: Vec<usize> = (0..lines.len()).filter(is_here).collect();
    let [place] = places[..] else { return Err(format!("stands in {} places:\n{}", places.len(), old.join("\n"))) };
    let mut kept = lines[place..].iter();
    let mut new = lines[..place].to_vec();
    for line in change {
        match line.strip_prefix('+') {
            Some(line) => new.push(line),
            None => new.extend(kept.next().filter(|_| !line.starts_with('-'))),
        }
    }
    new.extend(kept);
    Ok(new.iter().map(|line| format!("{line}\n")).collect())
}

/// The words of a command line; double quotes hold words together.
fn arguments(command: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut inside = false;
    for letter in command.chars() {
        match letter {
            '"' => inside = !inside,
            ' ' if !inside => words.push(String::new()),
            letter => words.last_mut().unwrap().push(letter),
        }
    }
    words
}

fn copy_folder(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        let into = to.join(path.file_name().unwrap());
        if path.is_dir() {
            copy_folder(&path, &into);
        } else {
            fs::copy(&path, into).unwrap();
        }
    }
}

/// A copy of the knowledge in which a recipe is carried out.
pub struct Bench {
    pub folder: PathBuf,
    /// Files that the recipe makes or changes.
    pub touched: BTreeSet<String>,
    /// What is put back after the next answer.
    pub tried: Vec<(PathBuf, String)>,
}

impl Bench {
    pub fn new(title: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("adding").join(title.replace(' ', "-"));
        if folder.exists() {
            fs::remove_dir_all(&folder).unwrap();
        }
        for inside in ["catalogs", "rules", "examples"] {
            copy_folder(&root().join(inside), &folder.join(inside));
        }
        fs::create_dir(folder.join("docs")).unwrap();
        fs::copy(root().join("docs/provenance.md"), folder.join("docs/provenance.md")).unwrap();
        Self { folder, touched: BTreeSet::new(), tried: Vec::new() }
    }

    pub fn carry_out(&mut self, block: &Block) {
        let place = &block.place;
        match block.doing {
            Doing::Rust => {}
            Doing::Answer => self.answer(block),
            Doing::New => {
                let [path] = &block.paths[..] else { panic!("{place}: one new file at a time") };
                let file = self.folder.join(path);
                assert!(!root().join(path).exists() && !file.exists(), "{place}: {path} is there already");
                fs::write(file, block.text()).unwrap();
                self.touched.insert(path.clone());
            }
            Doing::Append | Doing::Change | Doing::Try => {
                for path in &block.paths {
                    let file = self.folder.join(path);
                    let text = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{place}: {path}: {error}"));
                    let new = match block.doing {
                        Doing::Append => Ok(text.clone() + &block.text()),
                        _ => changed(&text, &block.lines),
                    };
                    fs::write(&file, new.unwrap_or_else(|error| panic!("{place}: {path}: {error}"))).unwrap();
                    if block.doing == Doing::Try {
                        self.tried.push((file, text));
                    } else {
                        self.touched.insert(path.clone());
                    }
                }
            }
        }
    }

    fn answer(&mut self, block: &Block) {
        let place = &block.place;
        let command = block.lines[0].strip_prefix("$ technolog ").unwrap_or_else(|| panic!("{place}: not technolog"));
        let (answer, code) = self.run(command);
        // What was found stands in the answer; nothing stops.
        assert!(matches!(code, Some(0 | 1)), "{place}: exit code {code:?}\n{answer}");
        assert!(!answer.ends_with(" 0 findings\n") || code == Some(0), "{place}: exit code {code:?}\n{answer}");
        let lines: Vec<&str> = answer.trim_end().lines().collect();
        assert!(is_answer(&block.lines[1..], &lines), "{place}: the answer is\n{answer}");
        for (file, text) in self.tried.drain(..) {
            fs::write(file, text).unwrap();
        }
    }

    /// The answer of a command, screen and complaints together, and its exit code.
    fn run(&self, command: &str) -> (String, Option<i32>) {
        let mut technolog = Command::new(env!("CARGO_BIN_EXE_technolog"));
        let output = technolog.args(arguments(command)).current_dir(&self.folder).output().unwrap();
        (String::from_utf8([output.stdout, output.stderr].concat()).unwrap(), output.status.code())
    }

    /// The knowledge as it stands now, compared with the contracts of the code.
    pub fn knowledge(&self) -> Knowledge {
        let files = Knowledge::read_folder(&self.folder).unwrap();
        let files: Vec<SourceFile<'_>> = files.iter().map(|(path, text)| SourceFile { path, text }).collect();
        tables::load(&files).unwrap_or_else(|problems| panic!("{problems:?}"))
    }
}
