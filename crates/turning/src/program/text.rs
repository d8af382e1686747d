//! Writes the lines of a program and tracks the modal state of the control, so that words are repeated only on change.

use crate::turning::contour::{Curve, Piece, Turn};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::units::{Decimal, Micrometres, MillimetresPerRev};

use super::setting::Speed;
use super::whole::FreeEnd;
use super::words::{ControlWords, Use};

/// The rate of a move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Pace {
    /// As fast as the axes move.
    Rapid,
    /// At a feed.
    Feed(MillimetresPerRev),
    /// Synchronised with the spindle, by the pitch of a thread.
    Thread(MillimetresPerRev),
    /// Along a contour that a cycle reads: a line or an arc without a feed.
    Contour,
}

/// Lines of a program.
pub(super) struct ProgramWriter<'c> {
    words: &'c ControlWords,
    text: String,
    at: Option<Point>,
    motion: Option<Use>,
    feed: Option<String>,
}

impl<'c> ProgramWriter<'c> {
    pub const fn new(words: &'c ControlWords) -> Self {
        Self { words, text: String::new(), at: None, motion: None, feed: None }
    }

    /// A line; an empty one is left out.
    pub fn line(&mut self, text: &str) {
        if !text.is_empty() {
            self.text.push_str(text);
            self.text.push('\n');
        }
    }

    /// Complete lines.
    pub fn lines(&mut self, text: &str) {
        text.lines().for_each(|line| self.line(line));
    }

    /// The words for these uses in one line, where the control has them.
    pub fn put(&mut self, uses: &[Use]) {
        let words: Vec<&str> = uses.iter().map(|one| self.words.get(*one)).filter(|word| !word.is_empty()).collect();
        self.line(&words.join(" "));
    }

    /// A comment.
    pub fn comment(&mut self, text: &str) {
        let line = self.words.comment(text);
        self.line(&line);
    }

    /// Forgets the modes: the next move is written in full.
    pub fn forget(&mut self) {
        (self.at, self.motion, self.feed) = (None, None, None);
    }

    /// A rapid to a point, from the current position.
    pub fn rapid(&mut self, to: Point) {
        self.go(Piece::line(self.at.unwrap_or(to), to), Pace::Rapid);
    }

    /// A rapid to the first point of a tool, which comes from its change position: beside a tailstock Z moves before
    /// X.
    pub fn approach(&mut self, to: Point, end_of_part: FreeEnd) {
        if end_of_part == FreeEnd::Tailstock && self.at.is_none() {
            self.line(&format!("{} Z{}", self.words.get(Use::Rapid), self.words.figure(position(to.z))));
            self.line(&format!("X{}", self.words.figure(diameter(to.radius))));
            (self.at, self.motion) = (Some(to), Some(Use::Rapid));
        } else {
            self.rapid(to);
        }
    }

    /// One move. An arc always has its function: in LinuxCNC's G71 an arc without one is a G2.
    pub fn go(&mut self, piece: Piece, pace: Pace) {
        let motion = motion(piece.curve, pace);
        let mut words = Vec::new();
        if self.motion != Some(motion) || piece.curve != Curve::Line {
            words.push(self.words.get(motion).to_owned());
        }
        let mut axes = Vec::new();
        if self.at.is_none_or(|at| at.radius != piece.to.radius) {
            axes.push(format!("X{}", self.words.figure(diameter(piece.to.radius))));
        }
        if self.at.is_none_or(|at| at.z != piece.to.z) {
            axes.push(format!("Z{}", self.words.figure(position(piece.to.z))));
        }
        if axes.is_empty() {
            return;
        }
        words.append(&mut axes);
        if let Some(centre) = piece.centre() {
            let start = piece.from.vector();
            words.push(format!("I{}", self.words.figure(offset(centre.radius - start.radius))));
            words.push(format!("K{}", self.words.figure(offset(start.z - centre.z))));
        }
        if let Pace::Thread(lead) = pace {
            // On some controls the lead uses the word of the feed, so the feed is not known afterwards.
            let lead = number(self.words.lead(piece, lead), 4);
            words.push(format!("{}{}", self.words.get(Use::ThreadLead), self.words.figure(lead)));
            self.feed = None;
        }
        if let Pace::Feed(feed) = pace {
            let feed = self.words.figure(number(feed.0, 4));
            if self.feed.as_ref() != Some(&feed) {
                words.push(format!("F{feed}"));
                self.feed = Some(feed);
            }
        }
        self.line(&words.join(" "));
        (self.at, self.motion) = (Some(piece.to), Some(motion));
    }

    /// A tap from where it stands along a piece and back, as the control writes it.
    pub fn tap(&mut self, piece: Piece, speed: Speed, lead: MillimetresPerRev) {
        let rpm = match speed {
            Speed::Spindle(rpm) | Speed::Cutting { limit: rpm, .. } => number(rpm.0, 2),
        };
        let z = |z: Half| self.words.figure(position(z));
        let values = [
            ("from", z(piece.from.z)),
            ("below", z(piece.from.z + Half::of(Micrometres::from_mm(1)))),
            ("z", z(piece.to.z)),
            ("lead", self.words.figure(number(lead.0, 4))),
            ("speed", rpm),
        ];
        for part in [Use::TapBegins, Use::Tap, Use::TapEnds] {
            let line = self.words.filled(part, &values);
            self.line(&line);
        }
        (self.at, self.motion, self.feed) = (Some(piece.from), None, None);
    }

    pub fn finish(self) -> String {
        self.text
    }
}

/// The function of a move. Z points towards the chuck in a toolpath and away from it in a program, which mirrors
/// arcs: a left arc of the toolpath is clockwise, seen with Z to the right and X upwards (docs/turning-programs.md,
/// «Arcs»).
const fn motion(curve: Curve, pace: Pace) -> Use {
    match (curve, pace) {
        (Curve::Line, Pace::Rapid) => Use::Rapid,
        (Curve::Line, Pace::Thread(_)) => Use::Thread,
        (Curve::Line, _) => Use::Line,
        (Curve::Arc { turn: Turn::Left, .. }, _) => Use::Clockwise,
        (Curve::Arc { turn: Turn::Right, .. }, _) => Use::Counterclockwise,
    }
}

/// A radius as a diameter of the program; exact, in whole micrometres.
pub(super) fn diameter(radius: Half) -> String {
    radius.diameter().to_string()
}

/// Z of the program, away from the chuck; exact.
pub(super) fn position(z: Half) -> String {
    (Half::ZERO - z).to_string()
}

/// A distance to a centre, mm, to a tenth of a micrometre.
fn offset(millimetres: f64) -> String {
    number(millimetres, 4)
}

/// A calculated number with at most `places` decimals.
pub(super) fn number(value: f64, places: u32) -> String {
    Decimal::from_f64_rounded(crate::units::round_to(value, places)).to_string()
}
