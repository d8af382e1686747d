//! All rules for lathe programs: code, severity, and the section of docs/lathe-programs-read.md that explains it.

use crate::note::Severity;
use crate::program::{Fault, Rule, TextSpan};

use Severity::{Doubtful, Error, Note, Wrong};

/// Code, severity, section.
pub(super) const RULES: &[Rule] = &[
    // The text.
    ("unknown-character", Error, "text"),
    ("cyrillic-letter", Error, "text"),
    ("unknown-word", Error, "words"),
    ("number-missing", Error, "text"),
    ("number-without-point", Note, "text"),
    ("point-missing", Error, "text"),
    ("lathe-decimal-comma", Error, "text"),
    ("lathe-expression", Error, "text"),
    ("lathe-parameter-unknown", Error, "text"),
    ("lathe-two-calls", Error, "text"),
    ("lathe-call-open", Error, "text"),
    ("comment-open", Error, "text"),
    ("empty-program", Error, "text"),
    ("too-many-blocks", Error, "text"),
    ("word-twice", Error, "words"),
    ("word-unused", Error, "words"),
    ("group-exclusive", Error, "words"),
    ("number-not-whole", Error, "text"),
    ("subprogram-missing", Error, "calls"),
    ("sub-without-pair", Error, "calls"),
    ("program-without-end", Error, "calls"),
    ("return-without-call", Error, "calls"),
    ("calls-too-deep", Error, "calls"),
    ("run-too-long", Error, "calls"),
    // The start.
    ("lathe-start-unsaid", Wrong, "start"),
    ("lathe-inches", Error, "start"),
    ("lathe-plane", Error, "start"),
    ("lathe-no-tool-yet", Error, "start"),
    ("lathe-no-offset", Wrong, "start"),
    ("lathe-offset-shared", Wrong, "start"),
    ("lathe-offset-of-two", Doubtful, "start"),
    ("lathe-tool-named", Note, "start"),
    // Spindle and feed.
    ("spindle-without-speed", Error, "spindle"),
    ("feed-without-spindle", Error, "spindle"),
    ("feed-zero", Error, "spindle"),
    ("stop-turning", Wrong, "spindle"),
    ("stop-turning-maybe", Doubtful, "spindle"),
    ("lathe-no-limit", Wrong, "spindle"),
    ("lathe-limit-without-speed", Error, "spindle"),
    ("lathe-thread-at-cutting-speed", Doubtful, "spindle"),
    // Motions.
    ("motion-missing", Error, "motions"),
    ("dwell-time-missing", Error, "motions"),
    ("lathe-place-unknown", Error, "motions"),
    ("arc-without-centre", Error, "motions"),
    ("arc-radius", Error, "motions"),
    ("arc-radius-alone", Error, "motions"),
    ("arc-radius-short", Error, "motions"),
    ("lathe-no-lead", Error, "motions"),
    ("lathe-compensation", Note, "motions"),
    ("lathe-corner-alone", Error, "motions"),
    ("lathe-corner-long", Error, "motions"),
    // Cycles.
    ("lathe-cycle-field", Error, "cycles"),
    ("lathe-cycle-fields-too-many", Error, "cycles"),
    ("lathe-cycle-value", Error, "cycles"),
    ("lathe-cycle-not-read", Error, "cycles"),
    ("lathe-not-carried-out", Doubtful, "cycles"),
    ("lathe-cycle-first-block", Error, "cycles"),
    ("lathe-contour-missing", Error, "cycles"),
    ("lathe-contour-behind", Note, "cycles"),
    ("lathe-contour-short", Error, "cycles"),
    ("lathe-contour-word", Error, "cycles"),
    ("lathe-not-monotone", Error, "cycles"),
    ("lathe-cycle-begins-inside", Error, "cycles"),
    ("lathe-cycle-from-memory", Doubtful, "cycles"),
    ("lathe-tap-counterclockwise", Error, "cycles"),
    ("lathe-arc-unsaid", Error, "cycles"),
];

/// A broken rule.
pub(super) fn fault(code: &'static str, span: TextSpan, block: Option<u32>) -> Fault {
    Fault::of(RULES, code, span, block)
}
