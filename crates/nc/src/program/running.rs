//! The state that every interpreter keeps, whatever the control: the sink of its steps, the reported faults, and the
//! remaining budget.

use std::collections::BTreeSet;

use super::alone::{Habits, Radius, Watch};
use super::below::{Below, Measure};
use super::contour::Contour;
use super::limits::{NOT_CHECKED, Spans, without_zero};
use super::named::Names;
use super::setting::Assumed;
use super::{Call, Fault, TextSpan, left_over, stay};
use crate::motion::{MotionStep, Sink};

/// The most blocks and steps of a check: nested repeats might never end.
pub(super) const BUDGET: usize = 500_000;

/// Makes a fault for a broken rule of one control: its code, its place, the number of the block.
type NewFault = fn(&'static str, TextSpan, Option<u32>) -> Fault;

/// Where execution continues after a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum BlockOutcome {
    /// To the next block.
    On,
    /// Back to where it was called.
    Back,
    /// To the end of the run: the end of the main program, or no more blocks.
    Out,
}

/// What of a run its blocks are watched by.
pub(super) struct Watched {
    /// What comments say of the tools.
    pub names: Names,
    /// The contour beside which the control goes.
    pub contour: Contour,
    /// What is done below the zero.
    pub below: Below,
    /// The registers of the radius that tools have had.
    pub radii: Vec<Radius>,
}

/// A run, apart from the language.
pub(super) struct Running<'a, S> {
    sink: &'a mut S,
    breach: NewFault,
    /// Faults already reported for a word: a block may run many times.
    reported: BTreeSet<(u32, u32, &'static str)>,
    faults: Vec<Fault>,
    /// The calls that led to the block that runs.
    pub calls: Vec<Call>,
    /// The range of axes without a zero.
    pub spans: Spans,
    pub watched: Watched,
    watch: Watch,
    budget: usize,
    /// How many blocks and steps may still be carried out.
    pub left: usize,
}

impl<'a, S: Sink> Running<'a, S> {
    /// At the beginning of a program.
    pub fn new(sink: &'a mut S, breach: NewFault, habits: Habits, text: &str, budget: usize) -> Self {
        let (reported, faults, calls, spans) = (BTreeSet::new(), Vec::new(), Vec::new(), Spans::new());
        let words = (habits.of_taps.as_slice(), habits.of_edges.as_slice());
        let names = Names::read(text, &habits.coarse, words, &habits.of_kinds);
        let below = Below::new(Measure {
            around: habits.cuts_around,
            times: habits.feed_beside,
            beyond: habits.tap_beyond,
            tap_beside: habits.tap_beside,
            depth_beside: habits.depth_beside,
            tap_near: habits.tap_near,
            threads: names.pitches(),
            of_edges: names.of_edges(),
            drill_feed: habits.drill_feed,
            tap_hole: habits.tap_hole,
            reamer_beyond: habits.reamer_beyond,
            reamer_stock: habits.reamer_stock,
            names: names.clone(),
        });
        let watch = Watch::new(habits, names.clone());
        let watched = Watched { names, contour: Contour::default(), below, radii: Vec::new() };
        Self { sink, breach, reported, faults, calls, spans, watched, watch, budget, left: budget }
    }

    /// Counts one more block; false, with a fault, where the budget is spent.
    pub fn spend(&mut self, span: TextSpan, number: Option<u32>) -> bool {
        if self.left == 0 {
            self.report((self.breach)("run-too-long", span, number).with("budget", self.budget));
            return false;
        }
        self.left -= 1;
        true
    }

    /// Executes a block; a block with an error makes no steps. `made` is the cost of its steps in the budget.
    pub fn carry_out(&mut self, steps: &[MotionStep], faults: Vec<Fault>, made: usize) {
        if !faults.iter().any(Fault::is_error) {
            for step in steps {
                self.take(step);
            }
        }
        self.left = self.left.saturating_sub(made);
        for fault in faults {
            self.report(fault);
        }
    }

    /// A step; one that no block makes belongs to the last.
    pub fn take(&mut self, step: &MotionStep) {
        self.watch.take(step);
        self.sink.take(step);
    }

    /// A return in the main program.
    pub fn nowhere_to_return(&mut self, span: TextSpan, number: Option<u32>) -> BlockOutcome {
        self.report((self.breach)("return-without-call", span, number));
        BlockOutcome::Out
    }

    /// Whether a call is nested deeper than the control allows; reports it if so.
    pub fn too_deep(&mut self, depth: usize, limit: usize, span: TextSpan, number: Option<u32>) -> bool {
        let deep = depth >= limit;
        if deep {
            self.report((self.breach)("calls-too-deep", span, number).with("limit", limit));
        }
        deep
    }

    /// Reports a fault once for each word and rule, with the calls that led there.
    pub fn report(&mut self, mut fault: Fault) {
        // What is not checked is said once, and so is what the builder of the machine decides.
        if matches!(fault.code, NOT_CHECKED | "change-turning-maybe")
            && self.faults.iter().any(|known| known.note == fault.note)
        {
            return;
        }
        if self.reported.insert((fault.span.line, fault.span.column, fault.code)) {
            fault.calls.clone_from(&self.calls);
            self.faults.push(fault);
        }
    }

    /// The faults found, at the end: systems without a zero are reported at the first block. A run with an error has left
    /// out what that block says, so nothing more is told of it.
    pub fn finish(mut self, first: TextSpan, assumed: Assumed) -> Vec<Fault> {
        for (system, axes) in without_zero(&self.spans, assumed) {
            self.report((self.breach)("zero-not-set", first, None).with("system", system).with("axes", axes));
        }
        if self.faults.iter().any(Fault::is_error) {
            self.faults.retain(|fault| !stay::TOLD.contains(&fault.code));
        } else {
            let below = std::mem::take(&mut self.watched.below).finish();
            let radii = std::mem::take(&mut self.watched.radii);
            for (block, code, note) in self.watch.clone().finish(&radii).into_iter().chain(below) {
                let span = TextSpan { line: block.line, column: 1, width: 1 };
                let mut fault = (self.breach)(code, span, block.number);
                (fault.note, fault.of_program_alone) = (note, true);
                self.report(fault);
            }
        }
        left_over::as_one(&mut self.faults);
        self.faults
    }
}
