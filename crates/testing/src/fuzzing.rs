//! Seeded mutations of files: the part of fuzzing that every `cargo test` does.

use std::fs;
use std::ops::Range;
use std::path::PathBuf;

use crate::root;

/// The files of folders and of folders in them, in the order of their paths, as far as their paths are wanted.
pub fn files(folders: &[&str], wanted: impl Fn(&std::path::Path) -> bool) -> Vec<Vec<u8>> {
    let mut paths: Vec<PathBuf> = Vec::new();
    let mut folders: Vec<PathBuf> = folders.iter().map(|folder| root().join(folder)).collect();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if wanted(&path) {
                paths.push(path);
            }
        }
    }
    paths.sort();
    paths.into_iter().map(|path| fs::read(path).unwrap()).collect()
}

/// Xorshift: the same numbers everywhere.
pub struct Random(u64);

impl Random {
    /// By a seed.
    pub const fn new(seed: u64) -> Self {
        Self(seed | 1)
    }

    /// A number below a limit.
    pub fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 16) as usize % limit.max(1)
    }

    /// A stretch of so many bytes, some bytes long or some lines.
    fn stretch(&mut self, length: usize) -> Range<usize> {
        let begin = self.below(length + 1);
        let most = if self.below(3) == 0 { length } else { 12 };
        begin..(begin + self.below(most + 1)).min(length)
    }
}

/// One of the files with up to six changes: a bit, something left out, something twice, a stretch of another file, litter.
pub fn mutated(files: &[Vec<u8>], litter: &[&str], random: &mut Random) -> Vec<u8> {
    let mut bytes = files[random.below(files.len())].clone();
    for _ in 0..=random.below(6) {
        let stretch = random.stretch(bytes.len());
        match random.below(5) {
            0 if !bytes.is_empty() => {
                let at = random.below(bytes.len());
                bytes[at] ^= 1 << random.below(8);
            }
            1 => drop(bytes.drain(stretch)),
            2 => {
                let again = bytes[stretch.clone()].to_vec();
                bytes.splice(stretch.end..stretch.end, again);
            }
            3 => {
                let other = &files[random.below(files.len())];
                bytes.splice(stretch, other[random.stretch(other.len())].to_vec());
            }
            _ => drop(bytes.splice(stretch, litter[random.below(litter.len())].bytes())),
        }
    }
    bytes
}
