//! Names of the points of a toolpath, as the figures of the lecture number them.

use std::collections::BTreeMap;

use super::point::Point;

/// Numbers points in the order of the first visit. A point that is visited again keeps its name.
#[derive(Clone, Debug, Default)]
pub struct Numbering {
    names: BTreeMap<(i64, i64), String>,
    last: usize,
}

impl Numbering {
    /// The next number is the one after this.
    pub fn after(last: usize) -> Self {
        Self { names: BTreeMap::new(), last }
    }

    /// Gives a place a name of its own.
    pub fn put(&mut self, at: Point, name: &str) {
        self.names.insert(key(at), name.to_owned());
    }

    /// Numbers a point before it is visited, even if it has a name already.
    pub fn number(&mut self, at: Point) {
        self.last += 1;
        self.names.insert(key(at), self.last.to_string());
    }

    /// The name of a point: the next number if it has none yet.
    pub fn name(&mut self, at: Point) -> String {
        if let Some(name) = self.names.get(&key(at)) {
            return name.clone();
        }
        self.number(at);
        self.last.to_string()
    }
}

fn key(at: Point) -> (i64, i64) {
    (at.radius.halves(), at.z.halves())
}
