//! A cache: values computed once and shared between threads.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// A cache of values by key. The first thread that needs a value computes it; others wait for that value only.
#[derive(Debug)]
pub struct Memo<V>(Mutex<BTreeMap<String, Arc<OnceLock<V>>>>);

impl<V> Default for Memo<V> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}

impl<V: Clone> Memo<V> {
    /// The value of that key, computed if it does not exist yet.
    pub fn get(&self, key: String, make: impl FnOnce() -> V) -> V {
        // A thread that failed while it held the lock has added at most an empty cell.
        let cell = self.0.lock().unwrap_or_else(PoisonError::into_inner).entry(key).or_default().clone();
        cell.get_or_init(make).clone()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::Memo;

    #[test]
    fn a_value_is_made_once_by_however_many_threads() {
        let (memo, made) = (Memo::default(), AtomicUsize::new(0));
        std::thread::scope(|scope| {
            for number in 0..8 {
                let (memo, made) = (&memo, &made);
                scope.spawn(move || {
                    let key = if number % 2 == 0 { "even" } else { "odd" };
                    let value = memo.get(key.to_owned(), || {
                        made.fetch_add(1, Ordering::Relaxed);
                        key.len()
                    });
                    assert_eq!(value, key.len());
                });
            }
        });
        assert_eq!(made.into_inner(), 2);
    }
}
