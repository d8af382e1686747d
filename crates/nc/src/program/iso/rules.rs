//! All rules for programs: stable code, severity, and the section of docs/control-linuxcnc.md and
//! docs/control-fanuc.md that explains it. The messages are in the catalogue of the crate `words`.

use crate::note::Severity;
use crate::program::{Fault, Rule, Subject, TextSpan};

use Severity::{Doubtful as Warning, Error, Note as Remark, Wrong};

/// Code, severity, section.
pub(super) const RULES: &[Rule] = &[
    // The text.
    ("unknown-character", Error, "text"),
    ("cyrillic-letter", Error, "text"),
    ("unknown-word", Error, "words"),
    ("not-carried-out", Wrong, "words"),
    ("traced-as-written", Warning, "words"),
    ("passed-over", Remark, "words"),
    ("macro-not-run", Error, "words"),
    ("comma-for-point", Error, "text"),
    ("number-missing", Error, "text"),
    ("number-too-long", Error, "text"),
    ("number-not-whole", Error, "text"),
    ("number-out-of-range", Error, "text"),
    ("number-without-point", Remark, "text"),
    ("point-missing", Error, "text"),
    ("peck-in-increments", Warning, "text"),
    ("comment-open", Error, "text"),
    ("active-comment", Warning, "text"),
    ("message-comment", Remark, "text"),
    ("empty-program", Error, "text"),
    ("too-many-blocks", Error, "text"),
    ("word-twice", Error, "blocks"),
    ("word-unused", Error, "blocks"),
    ("group-twice", Warning, "blocks"),
    ("group-exclusive", Error, "blocks"),
    ("exclusive-m-twice", Error, "blocks"),
    ("too-many-m", Error, "blocks"),
    ("subprogram-missing", Error, "calls"),
    ("call-without-number", Error, "calls"),
    ("program-number-twice", Error, "calls"),
    ("sub-without-pair", Error, "calls"),
    ("program-without-end", Error, "calls"),
    // The run.
    ("return-without-call", Error, "calls"),
    ("main-begins-anew", Warning, "calls"),
    ("branch-unknown", Error, "calls"),
    ("modes-not-kept", Error, "calls"),
    ("calls-too-deep", Error, "calls"),
    ("run-too-long", Error, "calls"),
    // The limits of the machine. What the control carries out all the same is wrong and traced.
    ("mode-left-over", Wrong, "blocks"),
    ("habit-left-over", Warning, "blocks"),
    ("height-unknown", Wrong, "blocks"),
    ("shift-not-traced", Remark, "cycles"),
    ("shift-missing", Wrong, "cycles"),
    ("rapid-from-hole", Wrong, "motions"),
    ("rapid-at-depth", Warning, "motions"),
    ("feed-beyond-machine", Wrong, "machine"),
    ("speed-beyond-machine", Wrong, "machine"),
    ("no-spindle-step", Warning, "machine"),
    ("finer-than-machine", Warning, "machine"),
    ("tool-beyond-magazine", Warning, "machine"),
    ("no-tool", Error, "machine"),
    ("tool-not-brought", Wrong, "machine"),
    ("change-elsewhere", Warning, "machine"),
    ("machine-not-named", Remark, "machine"),
    ("change-low", Wrong, "machine"),
    ("change-low-maybe", Warning, "machine"),
    ("change-not-withdrawn", Wrong, "machine"),
    ("ends-in-cut", Wrong, "motions"),
    ("change-turning", Error, "machine"),
    ("spindle-without-speed", Wrong, "machine"),
    ("feed-without-spindle", Wrong, "machine"),
    ("feed-of-tool-before", Warning, "machine"),
    ("speed-of-tool-before", Warning, "machine"),
    ("feed-zero", Error, "machine"),
    ("beyond-travel-of", Error, "machine"),
    ("limit-not-checked", Remark, "machine"),
    ("span-beyond-travel", Wrong, "machine"),
    ("cannot-tap", Error, "machine"),
    ("turning-at-change", Wrong, "machine"),
    ("stop-turning", Wrong, "machine"),
    ("stop-turning-maybe", Warning, "machine"),
    ("change-stops-spindle", Remark, "machine"),
    ("no-length-offset", Wrong, "machine"),
    ("length-by-hand", Warning, "machine"),
    ("offset-of-other-tool", Wrong, "machine"),
    ("offset-of-other-number", Warning, "machine"),
    ("offset-of-strange-number", Warning, "machine"),
    ("offset-of-tool-before", Wrong, "machine"),
    ("drilling-backwards", Wrong, "machine"),
    ("milling-backwards", Warning, "machine"),
    ("dwell-unit", Wrong, "machine"),
    ("dwell-odd", Warning, "machine"),
    ("zero-not-set", Remark, "machine"),
    // Motions.
    ("motion-missing", Error, "motions"),
    ("machine-position-with-g91", Error, "motions"),
    ("axes-missing", Error, "motions"),
    ("axes-taken-twice", Error, "motions"),
    ("fixed-point-unknown", Error, "motions"),
    ("fixed-point-not-given", Remark, "motions"),
    ("fixed-point-assumed", Warning, "motions"),
    ("dwell-time-missing", Error, "motions"),
    ("corrector-missing", Error, "motions"),
    ("corrector-unknown", Remark, "motions"),
    ("offset-of-no-tool", Wrong, "motions"),
    ("arc-without-end", Error, "motions"),
    ("arc-without-centre", Error, "motions"),
    ("arc-without-radius", Error, "motions"),
    ("arc-radius", Error, "motions"),
    ("arc-radius-alone", Error, "motions"),
    ("arc-radius-short", Error, "motions"),
    // Cycles.
    ("cycle-parameter-missing", Error, "cycles"),
    ("cycle-step-not-positive", Error, "cycles"),
    ("cycle-levels", Error, "cycles"),
    ("cycle-plane", Error, "cycles"),
    ("polar-plane", Error, "motions"),
    ("tap-counterclockwise", Error, "cycles"),
    ("tap-without-spindle", Error, "cycles"),
    ("tap-not-rigid", Warning, "cycles"),
    ("tap-feed", Wrong, "cycles"),
    ("tap-feed-odd", Warning, "cycles"),
];

/// A broken rule.
pub(super) fn fault(code: &'static str, span: TextSpan, block: Option<u32>) -> Fault {
    Fault::of(RULES, code, span, block)
}

/// A rule that a word of the program breaks, told once for each word.
pub(super) fn word_fault(code: &'static str, span: TextSpan, block: Option<u32>, word: impl Into<String>) -> Fault {
    let word = word.into();
    fault(code, span, block).with("word", word.clone()).about(Subject::Function(word))
}
