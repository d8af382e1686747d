//! The same work on many inputs, on all cores.

use std::num::NonZero;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// The results in the order of the inputs. After each one `report` is called with the number of finished inputs.
pub fn map<T: Sync, R: Send>(things: &[T], work: impl Fn(&T) -> R + Sync, report: impl Fn(usize) + Sync) -> Vec<R> {
    let cores = thread::available_parallelism().map_or(1, NonZero::get).min(things.len());
    let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let take = || {
        let mut own = Vec::new();
        // Threads take one input at a time, not a share each, because inputs take different times.
        loop {
            let at = next.fetch_add(1, Ordering::Relaxed);
            let Some(thing) = things.get(at) else { return own };
            own.push((at, work(thing)));
            report(done.fetch_add(1, Ordering::Relaxed) + 1);
        }
    };
    let mut results: Vec<(usize, R)> = thread::scope(|scope| {
        let threads: Vec<_> = (1..cores).map(|_| scope.spawn(take)).collect();
        let mut results = take();
        for thread in threads {
            match thread.join() {
                Ok(own) => results.extend(own),
                // A panic is a defect of the program, not of its input: it is passed on as in one thread.
                Err(defect) => std::panic::resume_unwind(defect),
            }
        }
        results
    });
    results.sort_by_key(|(at, _)| *at);
    results.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_stand_in_the_order_of_the_things_and_every_one_is_told() {
        let things: Vec<usize> = (0..1000).collect();
        let most = AtomicUsize::new(0);
        let results = map(
            &things,
            |thing| thing * 2,
            |done| {
                most.fetch_max(done, Ordering::Relaxed);
            },
        );
        assert_eq!(results, things.iter().map(|thing| thing * 2).collect::<Vec<_>>());
        assert_eq!(most.into_inner(), 1000);
        assert!(map(&[], |thing: &usize| *thing, |_| ()).is_empty());
    }
}
