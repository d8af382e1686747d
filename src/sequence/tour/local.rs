//! A tour that is improved where it is touched: chains of exchanged edges (Lin and Kernighan, 1973) and moves of
//! short segments (Or, 1976), over lists of near nodes, from a queue of the nodes whose surroundings changed.
//!
//! The tour is an array of nodes with the place of each. Everything is done by reversing a stretch of it, the
//! shorter of a stretch and its complement, and every reversal is logged, so that a try is undone exactly.

use super::Space;
use super::neighbours::Neighbours;

/// The longest chain of exchanges.
const DEPTH: usize = 6;
/// Continuations tried at the first levels of a chain; deeper only the best one.
const BREADTH: [usize; 3] = [5, 2, 1];
/// The longest segment that is moved as a whole.
const SEGMENT: usize = 3;

/// The tour under improvement.
pub(super) struct Tour<'s> {
    space: &'s Space<'s>,
    neighbours: &'s Neighbours,
    order: Vec<u32>,
    place: Vec<u32>,
    /// Whether the array is read backwards.
    backwards: bool,
    /// Whether the tour is looked at the other way round for the time being.
    mirror: bool,
    /// What was reversed since the last [`Tour::accept`]: a stretch by its ends, as they stood before without
    /// the mirror.
    log: Vec<(u32, u32)>,
    queue: Vec<u32>,
    queued: Vec<bool>,
}

impl<'s> Tour<'s> {
    pub(super) fn new(space: &'s Space<'s>, neighbours: &'s Neighbours, order: Vec<u32>) -> Self {
        let count = order.len();
        let mut place = vec![0; count];
        for (at, &node) in order.iter().enumerate() {
            place[node as usize] = at as u32;
        }
        Self {
            space,
            neighbours,
            order,
            place,
            backwards: false,
            mirror: false,
            log: Vec::new(),
            queue: Vec::new(),
            queued: vec![false; count],
        }
    }

    pub(super) fn order(&self) -> &[u32] {
        &self.order
    }

    /// The node at that place of the array, counted round it.
    pub(super) fn at(&self, place: usize) -> u32 {
        self.order[place % self.order.len()]
    }

    #[inline]
    fn cost(&self, from: u32, to: u32) -> i64 {
        self.space.cost(from as usize, to as usize)
    }

    #[inline]
    fn beside(&self, node: u32, before: bool) -> u32 {
        let place = self.place[node as usize] as usize;
        let last = self.order.len() - 1;
        match before {
            true if place == 0 => self.order[last],
            true => self.order[place - 1],
            false if place == last => self.order[0],
            false => self.order[place + 1],
        }
    }

    #[inline]
    pub(super) fn next(&self, node: u32) -> u32 {
        self.beside(node, self.backwards != self.mirror)
    }

    #[inline]
    fn previous(&self, node: u32) -> u32 {
        self.beside(node, self.backwards == self.mirror)
    }

    /// Reverses the stretch from one node on to another, and remembers it.
    pub(super) fn reverse(&mut self, from: u32, to: u32) {
        let (from, to) = if self.mirror { (to, from) } else { (from, to) };
        self.log.push((from, to));
        self.turn(from, to);
    }

    fn turn(&mut self, from: u32, to: u32) {
        let (from, to) = if self.backwards { (to, from) } else { (from, to) };
        let count = self.order.len();
        let (mut low, mut high) = (self.place[from as usize] as usize, self.place[to as usize] as usize);
        let inside = if high >= low { high - low + 1 } else { high + count - low + 1 };
        let mut swaps = inside / 2;
        if inside * 2 > count {
            // The rest is shorter: turn that, and read the array the other way.
            (low, high) = ((high + 1) % count, (low + count - 1) % count);
            swaps = (count - inside) / 2;
            self.backwards = !self.backwards;
        }
        for _ in 0..swaps {
            let (a, b) = (self.order[low], self.order[high]);
            self.order[low] = b;
            self.order[high] = a;
            self.place[b as usize] = low as u32;
            self.place[a as usize] = high as u32;
            low = if low + 1 == count { 0 } else { low + 1 };
            high = if high == 0 { count - 1 } else { high - 1 };
        }
    }

    /// Takes back everything logged beyond that many reversals.
    fn undo_to(&mut self, kept: usize) {
        while self.log.len() > kept {
            if let Some((from, to)) = self.log.pop() {
                self.turn(to, from);
            }
        }
    }

    /// Takes back everything since the last [`Tour::accept`].
    pub(super) fn undo(&mut self) {
        self.undo_to(0);
    }

    /// Keeps the tour as it is.
    pub(super) fn accept(&mut self) {
        self.log.clear();
    }

    /// Marks a node as worth looking at.
    pub(super) fn touch(&mut self, node: u32) {
        if !std::mem::replace(&mut self.queued[node as usize], true) {
            self.queue.push(node);
        }
    }

    /// Improves around every touched node until nothing near gets better; gives what was saved.
    pub(super) fn improve(&mut self) -> i64 {
        let mut saved = 0;
        let mut head = 0;
        while let Some(&node) = self.queue.get(head) {
            head += 1;
            self.queued[node as usize] = false;
            while let Some(gain) = self.improve_at(node) {
                saved += gain;
            }
            if head > 1024 && head * 2 > self.queue.len() {
                self.queue.drain(..head);
                head = 0;
            }
        }
        self.queue.clear();
        saved
    }

    fn improve_at(&mut self, node: u32) -> Option<i64> {
        let mut gain = None;
        for mirror in [false, true] {
            self.mirror = mirror;
            gain = gain.or_else(|| self.chain(node)).or_else(|| self.move_segment(node));
        }
        self.mirror = false;
        gain
    }

    /// A chain of exchanges that begins by removing the edge from a node to its next.
    fn chain(&mut self, base: u32) -> Option<i64> {
        let kept = self.log.len();
        let end = self.next(base);
        let mut added = Vec::with_capacity(DEPTH);
        let gain = self.exchange(base, end, self.cost(base, end), &mut added)?;
        for at in kept..self.log.len() {
            let (from, to) = self.log[at];
            for node in [from, to] {
                self.touch(node);
            }
        }
        self.touch(base);
        self.touch(self.next(base));
        for (from, to) in added {
            self.touch(from);
            self.touch(to);
        }
        Some(gain)
    }

    /// Goes on with a chain: the path leads from `end`, next after `base`, once round to `base`, and `open` is
    /// what the removed edges cost more than the added ones. An edge from `end` to a near node is added, the
    /// one before that node removed, the stretch between reversed.
    fn exchange(&mut self, base: u32, end: u32, open: i64, added: &mut Vec<(u32, u32)>) -> Option<i64> {
        let level = added.len();
        if level >= DEPTH {
            return None;
        }
        let breadth = BREADTH.get(level).copied().unwrap_or(1);
        let mut best = [(i64::MIN, 0_u32, 0_u32); BREADTH[0]];
        let mut held = 0;
        for &near in self.neighbours.near(end as usize) {
            let left = open - self.cost(end, near);
            if left <= 0 {
                break;
            }
            let before = self.previous(near);
            // An edge that the chain added is not removed again: so the chain ends.
            let own = |&(a, b): &(u32, u32)| (a == near && b == before) || (a == before && b == near);
            if near == base || before == end || added.iter().any(own) {
                continue;
            }
            let value = left + self.cost(before, near);
            if held == breadth && best[held - 1].0 >= value {
                continue;
            }
            let mut place = if held < breadth { held } else { held - 1 };
            held = (held + 1).min(breadth);
            while place > 0 && best[place - 1].0 < value {
                best[place] = best[place - 1];
                place -= 1;
            }
            best[place] = (value, near, before);
        }
        for &(value, near, before) in &best[..held] {
            let kept = self.log.len();
            self.reverse(end, before);
            added.push((end, near));
            let closed = value - self.cost(before, base);
            // Further, if that is better still.
            let stop = (self.log.len(), added.len());
            match self.exchange(base, before, value, added) {
                Some(gain) if gain > closed => return Some(gain),
                _ if closed > 0 => {
                    self.undo_to(stop.0);
                    added.truncate(stop.1);
                    return Some(closed);
                }
                _ => {
                    self.undo_to(kept);
                    added.pop();
                }
            }
        }
        None
    }

    /// Moves a segment that begins at a node and is at most [`SEGMENT`] long between two near nodes.
    fn move_segment(&mut self, first: u32) -> Option<i64> {
        let before = self.previous(first);
        let mut last = first;
        for _ in 0..SEGMENT {
            let after = self.next(last);
            if after == before {
                return None;
            }
            let freed = self.cost(before, first) + self.cost(last, after) - self.cost(before, after);
            for &near in self.neighbours.near(first as usize) {
                let left = freed - self.cost(first, near);
                if left <= 0 {
                    break;
                }
                if self.within(first, last, near) {
                    continue;
                }
                // Behind the near node: near, first … last, its next.
                if near != before {
                    let next = self.next(near);
                    let gain = left - self.cost(last, next) + self.cost(near, next);
                    if gain > 0 {
                        self.reverse(first, near);
                        self.reverse(near, after);
                        self.reverse(last, first);
                        self.touch_all([before, first, last, after, near, next]);
                        return Some(gain);
                    }
                }
                // Before the near node, turned: its previous, last … first, near.
                if near != after {
                    let previous = self.previous(near);
                    let gain = left - self.cost(last, previous) + self.cost(near, previous);
                    if gain > 0 {
                        self.reverse(first, previous);
                        self.reverse(previous, after);
                        self.touch_all([before, first, last, after, near, previous]);
                        return Some(gain);
                    }
                }
            }
            last = after;
        }
        None
    }

    /// Whether a node lies on the short stretch from one node on to another.
    fn within(&self, first: u32, last: u32, node: u32) -> bool {
        let mut here = first;
        loop {
            if here == node {
                return true;
            }
            if here == last {
                return false;
            }
            here = self.next(here);
        }
    }

    fn touch_all(&mut self, nodes: [u32; 6]) {
        for node in nodes {
            self.touch(node);
        }
    }
}
