//! All rules for programs: stable code, severity, and the section that gives the rule.
//!
//! A section is one of the control's description (textbook sections 3 and 4); `*` after it marks an interpretation
//! where the text says little, explained in docs/control-2c42-65.md. The messages are in the catalogue of the crate
//! `words`; tests keep the three consistent.

use crate::note::Severity;
use crate::program::{Fault, Rule, TextSpan};

use Severity::{Doubtful as Warning, Error, Note as Remark, Wrong};

/// Code, severity, section.
pub(super) const RULES: &[Rule] = &[
    // The text.
    ("unknown-character", Error, "3.1"),
    ("cyrillic-letter", Error, "3.1"),
    ("unknown-address", Error, "3.1"),
    ("comma-for-point", Error, "3.5"),
    ("number-missing", Error, "3.5"),
    ("number-too-fine", Error, "3.8.2"),
    ("number-not-whole", Error, "3.2"),
    ("number-out-of-range", Error, "3.2"),
    ("block-too-long", Error, "3.4"),
    ("memory-full", Error, "2.3"),
    ("empty-program", Error, "3.6"),
    ("no-block-number", Warning, "3.7"),
    ("block-number-gap", Remark, "3.7*"),
    ("word-twice", Error, "3.5*"),
    ("unknown-function", Error, "3.10"),
    ("group-twice", Warning, "3.10"),
    ("too-many-m", Error, "3.13.3"),
    ("exclusive-m-twice", Error, "3.13.3"),
    ("machine-function", Remark, "3.13.3"),
    ("return-with-call", Error, "3.14.2"),
    ("subprogram-one-digit", Error, "3.14.2"),
    ("program-one-digit", Error, "3.6"),
    ("subprogram-missing", Error, "3.14.2"),
    ("program-number-twice", Error, "3.6"),
    ("too-many-programs", Error, "3.3"),
    ("program-without-end", Error, "3.6"),
    ("word-after-cycle", Warning, "3.12.1"),
    ("parameter-outside-cycle", Error, "3.12.1"),
    ("word-unused", Warning, "3.10*"),
    ("fourth-axis", Error, "3.8.1"),
    ("offset-with-radius-correction", Error, "3.11.4"),
    ("corrector-with-offset", Error, "3.11.4"),
    // The run.
    ("return-without-call", Error, "3.14"),
    ("calls-too-deep", Error, "3.14"),
    ("run-too-long", Error, "*"),
    // The limits of the machine.
    ("mode-left-over", Wrong, "3.10*"),
    ("habit-left-over", Warning, "3.10*"),
    ("height-unknown", Wrong, "3.13.3* (4)"),
    ("feed-beyond-machine", Error, "3.9.2"),
    ("speed-beyond-machine", Error, "3.13.1"),
    ("no-spindle-step", Warning, "3.13.1"),
    ("finer-than-machine", Warning, "3.8.2"),
    ("tool-beyond-magazine", Warning, "3.13.2"),
    ("no-tool", Error, "3.13.2*"),
    ("tool-not-brought", Wrong, "3.13.2*"),
    ("turning-at-change", Wrong, "3.13.2*"),
    ("stop-turning-maybe", Warning, "4.2.4.2*"),
    ("change-low", Wrong, "5.2 (11.1)*"),
    ("change-low-maybe", Warning, "5.2 (11.1)*"),
    ("change-not-withdrawn", Wrong, "5.2 (11.1)*"),
    ("ends-in-cut", Wrong, "3.13.2*"),
    ("machine-needed", Error, "2.2*"),
    ("rapid-from-hole", Wrong, "3.10.2*"),
    ("rapid-at-depth", Warning, "3.10.2*"),
    ("change-elsewhere", Warning, "5.2 (11.1)"),
    ("spindle-without-speed", Error, "3.13.1*"),
    ("feed-without-spindle", Error, "3.13.1*"),
    ("feed-zero", Error, "3.9.2*"),
    ("beyond-travel-of", Error, "3.8.3"),
    ("limit-not-checked", Remark, "3.8.3*"),
    ("span-beyond-travel", Error, "3.8.3"),
    ("not-homed", Error, "4.2.5 (4)"),
    ("no-length-offset", Wrong, "3.11.3*"),
    ("length-by-hand", Warning, "3.11.3*"),
    ("offset-of-other-tool", Wrong, "3.11.3*"),
    ("offset-of-other-number", Warning, "3.11.3*"),
    ("drilling-backwards", Wrong, "3.13.1*"),
    ("milling-backwards", Warning, "3.13.1*"),
    ("tap-feed", Wrong, "3.12.1.4*"),
    ("tap-feed-odd", Warning, "3.12.1.4*"),
    ("dwell-unit", Wrong, "3.10.6*"),
    ("offset-of-strange-number", Warning, "3.11.3*"),
    ("dwell-odd", Warning, "3.10.6*"),
    // Motions.
    ("arc-without-centre", Error, "3.10.4"),
    ("arc-without-radius", Error, "3.10.4*"),
    ("arc-radius", Error, "3.10.4*"),
    ("helix-without-function", Error, "3.10.5"),
    ("helix-without-arc", Error, "3.10.5"),
    ("helix-pitch-missing", Error, "3.10.5"),
    ("helix-pitch-sign", Error, "3.10.5"),
    ("helix-pitch", Error, "3.10.5*"),
    ("dwell-without-time", Error, "3.10.6"),
    ("time-without-dwell", Error, "3.10.6*"),
    ("until-signal", Remark, "3.10*"),
    ("one-sided", Remark, "3.10*"),
    ("fixed-point-unknown", Error, "3.10*"),
    ("nothing-stored", Error, "3.10*"),
    ("corrector-unknown", Remark, "3.11.2"),
    ("offset-in-cycle", Warning, "3.11.4"),
    ("zero-not-set", Remark, "3.10.8.2"),
    // Radius correction.
    ("correction-by-arc", Error, "3.11.1*"),
    ("arc-smaller-than-tool", Error, "3.11.1*"),
    ("contour-too-tight", Error, "3.11.1*"),
    // Cycles.
    ("cycle-parameter-missing", Error, "3.12.1"),
    ("cycle-step-not-positive", Error, "3.12.1.3"),
    ("cycle-clearance-over-step", Error, "3.12.1.3*"),
    ("cycle-upside-down", Error, "3.12.1*"),
    ("cycle-ends-deeper", Error, "3.12.1*"),
    ("cannot-tap", Error, "3.12.1.4"),
    ("hole-twice", Warning, "3.12.1*"),
    ("cycle-at-tool-change", Warning, "3.12.1*"),
];

/// A broken rule.
pub(super) fn fault(code: &'static str, span: TextSpan, block: Option<u32>) -> Fault {
    Fault::of(RULES, code, span, block)
}
