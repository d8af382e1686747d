//! A page of docs/ or a README, taken apart.

use std::fs;
use std::path::Path;

use technolog_testing::root;

/// What a test of its own holds: docs/adding.md is carried out recipe by recipe.
const HELD_ELSEWHERE: [&str; 1] = ["docs/adding.md"];

/// A text of Markdown.
pub struct Page {
    /// Its path from the root of the repository.
    pub path: String,
    pub text: String,
}

/// A fenced block of a page.
pub struct Block {
    /// The number of its first line after the fence, from 0.
    pub line: usize,
    /// What stands behind the fence: the language, and perhaps the name of a file.
    pub info: String,
    pub lines: Vec<String>,
}

impl Page {
    pub fn read(path: &str) -> Self {
        let text = fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"));
        Self { path: path.to_owned(), text }
    }

    /// The fenced blocks, which never lie in a list here: a fence begins its line.
    pub fn blocks(&self) -> Vec<Block> {
        let mut blocks: Vec<Block> = Vec::new();
        let mut open = false;
        for (number, line) in self.text.lines().enumerate() {
            match (line.strip_prefix("```"), open) {
                (Some(info), false) => {
                    blocks.push(Block { line: number + 1, info: info.to_owned(), lines: Vec::new() });
                    open = true;
                }
                (Some(_), true) => open = false,
                (None, true) => blocks.last_mut().unwrap().lines.push(line.to_owned()),
                (None, false) => {}
            }
        }
        assert!(!open, "{}: a fence is not closed", self.path);
        blocks
    }

    /// The lines outside of blocks.
    pub fn prose(&self) -> Vec<&str> {
        let mut open = false;
        let mut outside = |line: &&str| {
            let fence = line.starts_with("```");
            open ^= fence;
            !open && !fence
        };
        self.text.lines().filter(|line| outside(line)).collect()
    }

    /// Depth and words of every heading.
    pub fn headings(&self) -> Vec<(usize, &str)> {
        let marked = self.prose().into_iter().filter(|line| line.starts_with('#'));
        marked.filter_map(|line| line.split_once(' ')).map(|(marks, words)| (marks.len(), words)).collect()
    }

    /// The targets of its links.
    pub fn links(&self) -> Vec<String> {
        let prose = self.prose().join("\n");
        let targets = prose.split("](").skip(1).filter_map(|rest| rest.split_once(')'));
        targets.map(|(target, _)| target.to_owned()).collect()
    }
}

impl Block {
    /// The language that the fence names.
    pub fn language(&self) -> &str {
        self.info.split(' ').next().unwrap_or_default()
    }

    /// The file that the reader is told to write; its name stands behind the language.
    pub fn file(&self) -> Option<&str> {
        self.info.split_once(' ').map(|(_, name)| name)
    }

    pub fn text(&self) -> String {
        self.lines.iter().map(|line| format!("{line}\n")).collect()
    }
}

/// Every page of docs/ and both READMEs, in the order of their paths.
pub fn pages() -> Vec<Page> {
    let mut paths = vec!["README.md".to_owned(), "README.uk.md".to_owned()];
    collect("docs", &mut paths);
    paths.sort();
    paths.iter().map(|path| Page::read(path)).collect()
}

/// The pages whose commands are run here.
pub fn carried_out() -> impl Iterator<Item = Page> {
    pages().into_iter().filter(|page| !HELD_ELSEWHERE.contains(&page.path.as_str()))
}

fn collect(folder: &str, paths: &mut Vec<String>) {
    for entry in fs::read_dir(root().join(folder)).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let path = format!("{folder}/{name}");
        if root().join(&path).is_dir() {
            collect(&path, paths);
        } else if Path::new(&name).extension().is_some_and(|extension| extension == "md") {
            paths.push(path);
        }
    }
}
