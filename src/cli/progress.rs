//! A bar on the screen while many things are done.

use std::io::{IsTerminal, Write, stderr};

/// Its width, in columns.
const WIDTH: usize = 40;

/// A progress bar; none if the output goes into a file.
#[derive(Debug)]
pub struct Progress {
    total: usize,
    seen: bool,
}

impl Progress {
    /// Of so many things.
    pub fn new(total: usize) -> Self {
        Self { total, seen: stderr().is_terminal() }
    }

    /// That many are done. The bar is redrawn when it grows, not every time.
    pub fn show(&self, done: usize) {
        let columns = |done: usize| done * WIDTH / self.total.max(1);
        if self.seen && (columns(done) != columns(done.saturating_sub(1)) || done == self.total) {
            // Where it cannot be drawn there is nobody to tell.
            let _ = write!(stderr().lock(), "\r{}", bar(done, self.total));
        }
    }

    /// Takes it away, so that the answer stands alone.
    pub fn clear(&self) {
        if self.seen {
            let _ = write!(stderr().lock(), "\r\x1b[K");
        }
    }
}

/// `[####----] 12/24`.
fn bar(done: usize, total: usize) -> String {
    let full = (done * WIDTH / total.max(1)).min(WIDTH);
    format!("[{}{}] {done}/{total}", "#".repeat(full), "-".repeat(WIDTH - full))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_is_as_long_as_what_is_done() {
        assert_eq!(bar(0, 0), format!("[{}] 0/0", "-".repeat(WIDTH)));
        assert_eq!(bar(12, 24), format!("[{}{}] 12/24", "#".repeat(20), "-".repeat(20)));
        assert_eq!(bar(24, 24), format!("[{}] 24/24", "#".repeat(WIDTH)));
    }
}
