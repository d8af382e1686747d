//! A progress bar for work on many inputs.

use std::io::{IsTerminal, Write, stderr};

/// Its width, in columns.
const WIDTH: usize = 40;

/// A progress bar; not shown if the output goes to a file.
#[derive(Debug)]
pub struct Progress {
    total: usize,
    seen: bool,
}

impl Progress {
    /// A bar for so many inputs.
    pub fn new(total: usize) -> Self {
        Self { total, seen: stderr().is_terminal() }
    }

    /// Shows the number of finished inputs. The bar is redrawn only when it grows.
    pub fn show(&self, done: usize) {
        let columns = |done: usize| done * WIDTH / self.total.max(1);
        if self.seen && (columns(done) != columns(done.saturating_sub(1)) || done == self.total) {
            // If it cannot be drawn, the error is ignored.
            let _ = write!(stderr().lock(), "\r{}", bar(done, self.total));
        }
    }

    /// Removes the bar, so that only the answer remains.
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
