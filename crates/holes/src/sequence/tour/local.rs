//! Local improvement of a tour: exchanges of two or three edges, chained (Lin and Kernighan, 1973), over lists of
//! likely edges. A queue holds the nodes whose neighbours changed.
//!
//! The tour is an array of nodes with the index of each. Exchanges are evaluated on the indices only. The array
//! changes only for the exchange that is taken, by reversing stretches of it (the shorter of a stretch and its
//! complement). Every reversal is logged, so that an attempt is undone exactly.

use super::Space;
use super::candidates::Candidates;

/// The most exchanges in a chain.
const CHAIN: usize = 3;
/// The number of likely edges tried for the first and for the second edge that an exchange adds: fewer at the end of
/// a chain.
const BREADTH: [[usize; 2]; CHAIN] = [[6, 6], [6, 6], [2, 2]];
/// The most edges that a chain adds: two with each exchange.
const ADDED: usize = 2 * CHAIN;

/// The tour under improvement.
pub(super) struct Tour<'s> {
    space: &'s Space<'s>,
    candidates: &'s Candidates,
    order: Vec<u32>,
    place: Vec<u32>,
    /// Whether the array is read backwards.
    backwards: bool,
    /// Whether the tour is temporarily read in the other direction.
    mirror: bool,
    /// The reversals since the last [`Tour::accept`]: the ends of each stretch, as they were before it and without
    /// the mirror.
    log: Vec<(u32, u32)>,
    queue: Vec<u32>,
    queued: Vec<bool>,
}

/// How an exchange reconnects the tour. It removes the edges `base → end`, one at `a` and one at `c`, and adds
/// `end – a`, `b – c`, and, where the chain ends, `d – base`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reconnection {
    /// Two edges only: `end … b` reversed; `b` comes before `a`. There is no `c`.
    Two,
    /// `end … b` reversed, then `b … d` of what that makes.
    Twice,
    /// `end … c` and `d … a` change places; `b` comes after `a`.
    Swapped,
    /// `end … d` reversed and `c … a` reversed; `b` comes after `a`.
    BothReversed,
}

/// An exchange, and by how much the removed edges cost more than the added ones while the tour is open between its
/// last node and the base.
#[derive(Clone, Copy, Debug)]
struct Exchange {
    open: i64,
    kind: Reconnection,
    a: u32,
    b: u32,
    c: u32,
    d: u32,
}

impl Exchange {
    const fn last(&self) -> u32 {
        match self.kind {
            Reconnection::Two => self.b,
            _ => self.d,
        }
    }
}

impl<'s> Tour<'s> {
    pub(super) fn new(space: &'s Space<'s>, candidates: &'s Candidates, order: Vec<u32>) -> Self {
        let count = order.len();
        let mut place = vec![0; count];
        for (at, &node) in order.iter().enumerate() {
            place[node as usize] = at as u32;
        }
        Self {
            space,
            candidates,
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

    /// The node at that index of the array, modulo its length.
    pub(super) fn at(&self, place: usize) -> u32 {
        self.order[place % self.order.len()]
    }

    #[inline]
    fn cost(&self, from: u32, to: u32) -> i64 {
        self.space.cost(from as usize, to as usize)
    }

    #[inline]
    fn neighbour(&self, node: u32, before: bool) -> u32 {
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
        self.neighbour(node, self.backwards != self.mirror)
    }

    #[inline]
    fn previous(&self, node: u32) -> u32 {
        self.neighbour(node, self.backwards == self.mirror)
    }

    /// Whether a node lies on the path from one node forward to another.
    #[inline]
    fn between(&self, from: u32, node: u32, to: u32) -> bool {
        let (from, to) = if self.backwards == self.mirror { (from, to) } else { (to, from) };
        let (low, at, high) = (self.place[from as usize], self.place[node as usize], self.place[to as usize]);
        if low <= high { low <= at && at <= high } else { at >= low || at <= high }
    }

    /// Reverses the stretch from one node forward to another, and logs it.
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
            // The complement is shorter: reverse that, and read the array backwards.
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

    /// Undoes the reversals logged after the first `kept`.
    fn undo_to(&mut self, kept: usize) {
        while self.log.len() > kept {
            if let Some((from, to)) = self.log.pop() {
                self.turn(to, from);
            }
        }
    }

    /// Undoes everything since the last [`Tour::accept`].
    pub(super) fn undo(&mut self) {
        self.undo_to(0);
    }

    /// Keeps the tour as it is.
    pub(super) fn accept(&mut self) {
        self.log.clear();
    }

    /// Puts a node into the queue.
    pub(super) fn touch(&mut self, node: u32) {
        if !std::mem::replace(&mut self.queued[node as usize], true) {
            self.queue.push(node);
        }
    }

    /// Improves around every queued node until nothing near it gets better; returns the saving.
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
        self.mirror = false;
        let gain = self.chain(node);
        if gain.is_some() {
            return gain;
        }
        self.mirror = true;
        let gain = self.chain(node);
        self.mirror = false;
        gain
    }

    /// A chain of exchanges that begins by removing the edge from a node to the next; returns the saving, or leaves
    /// the tour unchanged.
    fn chain(&mut self, base: u32) -> Option<i64> {
        let kept = self.log.len();
        let mut end = self.next(base);
        let mut open = self.cost(base, end);
        let mut taken = [(0_u32, 0_u32); ADDED];
        let mut added = 0;
        for level in 0..CHAIN {
            let Some((exchange, gain)) = self.exchange(base, end, open, &taken[..added]) else { break };
            if gain <= 0 && level + 1 == CHAIN {
                break;
            }
            self.carry_out(end, &exchange);
            if gain > 0 {
                for at in kept..self.log.len() {
                    let (from, to) = self.log[at];
                    self.touch(from);
                    self.touch(to);
                }
                for &(from, to) in &taken[..added] {
                    self.touch(from);
                    self.touch(to);
                }
                for node in [base, end, exchange.a, exchange.b, exchange.c, exchange.d] {
                    self.touch(node);
                }
                return Some(gain);
            }
            taken[added] = (end, exchange.a);
            taken[added + 1] = (exchange.b, exchange.c);
            added += 2;
            (end, open) = (exchange.last(), exchange.open);
        }
        self.undo_to(kept);
        None
    }

    /// The best exchange that begins at `end`, next after `base`, with the gain `open` so far: the first one that
    /// pays when the tour is closed after it, with its saving; otherwise the one that leaves the largest gain.
    #[inline]
    fn exchange(&self, base: u32, end: u32, open: i64, taken: &[(u32, u32)]) -> Option<(Exchange, i64)> {
        // An edge that the chain added is not removed again, so the chain ends.
        let own = |from: u32, to: u32| taken.iter().any(|&(a, b)| (a, b) == (from, to) || (b, a) == (from, to));
        let breadth = BREADTH[taken.len() / 2];
        let mut best: Option<Exchange> = None;
        for &(cost, a) in self.candidates.of_node(end).iter().take(breadth[0]) {
            let first = open - cost;
            if first <= 0 {
                continue;
            }
            if a == base {
                continue;
            }
            let b = self.previous(a);
            if b != end && !own(a, b) {
                let second = first + self.cost(a, b);
                let gain = second - self.cost(b, base);
                if gain > 0 {
                    return Some((Exchange { open: second, kind: Reconnection::Two, a, b, c: b, d: b }, gain));
                }
                for &(cost, c) in self.candidates.of_node(b).iter().take(breadth[1]) {
                    let third = second - cost;
                    if third <= 0 {
                        continue;
                    }
                    if c == a || c == base {
                        continue;
                    }
                    let turned = self.between(end, c, b);
                    let d = if turned { self.next(c) } else { self.previous(c) };
                    if d == b || own(c, d) {
                        continue;
                    }
                    let open = third + self.cost(c, d);
                    let found = Exchange { open, kind: Reconnection::Twice, a, b, c, d };
                    let gain = open - self.cost(d, base);
                    if gain > 0 {
                        return Some((found, gain));
                    }
                    if best.is_none_or(|best| best.open < open) {
                        best = Some(found);
                    }
                }
            }
            let b = self.next(a);
            if !own(a, b) {
                let second = first + self.cost(a, b);
                for &(cost, c) in self.candidates.of_node(b).iter().take(breadth[1]) {
                    let third = second - cost;
                    if third <= 0 {
                        continue;
                    }
                    if c == a || !self.between(end, c, a) {
                        continue;
                    }
                    for kind in [Reconnection::Swapped, Reconnection::BothReversed] {
                        let d = if kind == Reconnection::Swapped { self.next(c) } else { self.previous(c) };
                        if (kind == Reconnection::BothReversed && c == end) || own(c, d) {
                            continue;
                        }
                        let open = third + self.cost(c, d);
                        let gain = open - self.cost(d, base);
                        let found = Exchange { open, kind, a, b, c, d };
                        if gain > 0 {
                            return Some((found, gain));
                        }
                        if best.is_none_or(|best| best.open < open) {
                            best = Some(found);
                        }
                    }
                }
            }
        }
        best.map(|found| (found, 0))
    }

    /// Reconnects the tour; afterwards the last node of the exchange is next after the base.
    fn carry_out(&mut self, end: u32, exchange: &Exchange) {
        let &Exchange { kind, a, b, c, d, .. } = exchange;
        match kind {
            Reconnection::Two => self.reverse(end, b),
            Reconnection::Twice => {
                self.reverse(end, b);
                self.reverse(b, d);
            }
            Reconnection::Swapped => {
                self.reverse(end, a);
                self.reverse(a, d);
                self.reverse(c, end);
            }
            Reconnection::BothReversed => {
                self.reverse(end, d);
                self.reverse(c, a);
            }
        }
    }
}
