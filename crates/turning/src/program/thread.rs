//! A thread as the cycle of a control, which makes the passes itself: G76 of LinuxCNC and of Fanuc, CYCLE97 of Sinumerik.
//!
//! Each control has a law of infeed of its own. The arguments are chosen so that the law makes the passes of equal areas of
//! the plan (single passes are divided as makers do); where it cannot, to `NEAR`, the passes are written one by one. In all laws h is the whole depth from the crests and d the
//! depth of pass n; a is the angle of infeed, so that a pass is shifted by d·tan a along the flank.
//!
//! - LinuxCNC (manual, G76; run in rs274): d = J·n^(1/R) while that is less than K = h, then K, then H spring passes. R is
//!   the degression: 2 makes equal areas, 1 equal depths. With the compound slide angle Q a whole pass is shifted, so
//!   that a shallow one also ends earlier, by (h − d)·tan Q.
//! - Fanuc, two blocks (from memory of the 0i manual): d = Δd·√n, at least the least depth below the pass before, while
//!   that is less than k = h; then k, as many times as the first two figures of P say. The infeed angle is half of that of
//!   the tip, the last two figures: 80, 60, 55, 30, 29 or 0.
//! - Sinumerik (from memory of the Cycles manual of 840D): NRC passes, d = TDEP·√(n/NRC) with VARI 3 and 4 (equal areas,
//!   outside and inside), d = TDEP·n/NRC with VARI 1 and 2; then NID idle passes. IANG is the angle along one flank. SPL
//!   and FPL are the ends of the thread, APP and ROP the ways before and behind it, _VRT the lift over the crests.

use crate::note::Note;
use crate::turning::contour::Side;
use crate::turning::jobs::ThreadCut;
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::units::round_to;

use super::Control;
use super::text::{diameter, number, position};
use super::words::{ControlWords, Use};

/// How far the passes of a cycle may be off the planned ones, mm: in depth and along Z.
const NEAR: f64 = 0.005;

/// The angles of the tip that G76 of Fanuc has, degrees.
const FANUC_ANGLES: [f64; 6] = [80.0, 60.0, 55.0, 30.0, 29.0, 0.0];

/// The calls of a thread that a control has, the usual law of infeed first.
pub(super) type ThreadWriter = fn(&ControlWords, &ThreadCut, Side) -> Vec<ThreadCall>;

/// Why a thread is written by single passes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NotCycled {
    /// The cycle of the control is not known.
    Unknown,
    /// The tool is withdrawn over the run-out, which cycles do otherwise.
    PulledOut,
    /// The cycle makes another number of passes.
    Count {
        /// The planned number.
        planned: usize,
        /// The number that the cycle makes.
        made: usize,
    },
    /// The passes of the cycle differ from the planned ones.
    Passes {
        /// By how much at most.
        off: Half,
    },
}

impl NotCycled {
    /// It as a sentence.
    pub fn note(self) -> Note {
        match self {
            Self::Unknown => Note::new("not-cycled-unknown"),
            Self::PulledOut => Note::new("not-cycled-pulled-out"),
            Self::Count { planned, made } => Note::new("not-cycled-count").with("planned", planned).with("made", made),
            Self::Passes { off } => Note::new("not-cycled-passes").with("off", off),
        }
    }

    /// Its name, for a comment of a program in no language.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Unknown => "not-cycled-unknown",
            Self::PulledOut => "not-cycled-pulled-out",
            Self::Count { .. } => "not-cycled-count",
            Self::Passes { .. } => "not-cycled-passes",
        }
    }
}

/// The call of a cycle, and what the control makes of it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ThreadCall {
    /// Its lines.
    pub lines: String,
    /// Where the tool stands before it.
    pub start: Point,
    passes: Vec<Pass>,
}

/// A pass, mm: its depth below the crests, and where it begins and ends, Z towards the chuck.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Pass {
    depth: f64,
    from: f64,
    to: f64,
}

/// The cycle of a control for a thread.
///
/// # Errors
/// Why its passes must be written one by one.
pub(super) fn call(control: &Control, cut: &ThreadCut, side: Side) -> Result<ThreadCall, NotCycled> {
    let (Some(words), Some(writer)) = (&control.words, control.threads) else { return Err(NotCycled::Unknown) };
    if words.get(Use::ThreadCycle).is_empty() {
        return Err(NotCycled::Unknown);
    }
    if cut.pulled_out {
        return Err(NotCycled::PulledOut);
    }
    let mut why = NotCycled::Unknown;
    let cut = &ThreadCut { depths_mm: cut.cycle_depths_mm.clone(), ..cut.clone() };
    for call in writer(words, cut, side).into_iter().rev() {
        match compared(&call.passes, cut) {
            Ok(()) => return Ok(call),
            Err(other) => why = other,
        }
    }
    Err(why)
}

/// Holds the passes of a cycle against the planned ones. A pass may end before the planned end, but not within the thread.
fn compared(made: &[Pass], cut: &ThreadCut) -> Result<(), NotCycled> {
    if made.len() != cut.depths_mm.len() {
        return Err(NotCycled::Count { planned: cut.depths_mm.len(), made: made.len() });
    }
    let (slope, whole) = (slope(cut), whole(cut));
    let off = made.iter().zip(&cut.depths_mm).map(|(pass, depth)| {
        let from = cut.from_z_mm.to_mm() - (whole - depth.to_mm()) * slope;
        let past = pass.to - cut.to_z_mm.to_mm();
        let short = cut.ends_z_mm.to_mm() - pass.to;
        (pass.depth - depth.to_mm()).abs().max((pass.from - from).abs()).max(past).max(short)
    });
    let off = off.fold(0.0, f64::max);
    if off <= NEAR { Ok(()) } else { Err(NotCycled::Passes { off: Half::from(off) }) }
}

/// The whole depth, mm.
fn whole(cut: &ThreadCut) -> f64 {
    cut.depths_mm.last().copied().unwrap_or_default().to_mm()
}

/// The way along Z for a depth of 1.
fn slope(cut: &ThreadCut) -> f64 {
    libm::tan(cut.infeed_angle_deg.0.to_radians())
}

/// The number of passes up to the first at the whole depth, and how many repeat that.
fn counted(cut: &ThreadCut) -> (usize, usize) {
    let last = cut.depths_mm.last();
    let count = cut.depths_mm.iter().take_while(|depth| Some(*depth) != last).count() + 1;
    (count, cut.depths_mm.len().saturating_sub(count))
}

/// The height over the crests at which the tool returns.
fn lift(cut: &ThreadCut) -> Half {
    Half::new((cut.return_radius_mm - cut.crest_radius_mm).halves().abs())
}

/// Where a cycle begins whose first pass is shifted back by the whole depth along the flank.
fn start(cut: &ThreadCut, slope: f64) -> Point {
    Point { radius: cut.return_radius_mm, z: cut.from_z_mm - Half::from(whole(cut) * slope) }
}

/// A number of that many decimals that is a little larger, so that the law comes to the whole depth in its last pass and
/// not just above it.
fn more(value: f64, places: u32) -> f64 {
    let unit = libm::pow(10.0, -f64::from(places));
    round_to(libm::floor(value / unit) * unit + unit, places)
}

/// G76 of LinuxCNC; I, J and K are diameters (G7).
pub(super) fn linuxcnc(words: &ControlWords, cut: &ThreadCut, side: Side) -> Vec<ThreadCall> {
    let (slope, whole, (count, springs)) = (slope(cut), whole(cut), counted(cut));
    let start = start(cut, slope);
    let made = |degression: u32| {
        let power = 1.0 / f64::from(degression);
        let first = more(2.0 * whole / libm::pow(count as f64, power), 4);
        let peak = if side == Side::Outer { Half::ZERO - lift(cut) } else { lift(cut) };
        let values = [
            ("lead", cut.pitch_mm.to_string()),
            ("end", position(cut.to_z_mm)),
            ("peak", diameter(peak)),
            ("first", number(first, 4)),
            ("depth", number(2.0 * whole, 4)),
            ("degression", degression.to_string()),
            ("angle", number(cut.infeed_angle_deg.0, 4)),
            ("springs", springs.to_string()),
        ];
        let steps = (1..).map(|pass| first / 2.0 * libm::pow(f64::from(pass), power));
        let depths = steps.take(MOST).take_while(|depth| *depth < whole).chain(std::iter::repeat_n(whole, springs + 1));
        let pass = |depth: f64| Pass {
            depth,
            from: start.z.to_mm() + depth * slope,
            to: cut.to_z_mm.to_mm() - (whole - depth) * slope,
        };
        ThreadCall { lines: words.filled(Use::ThreadCycle, &values), start, passes: depths.map(pass).collect() }
    };
    [2, 1].map(made).into()
}

/// More passes than a thread has.
const MOST: usize = 1000;

/// G76 of Fanuc; P and Q are whole micrometres on the radius.
pub(super) fn fanuc(words: &ControlWords, cut: &ThreadCut, _: Side) -> Vec<ThreadCall> {
    let (whole, (count, springs)) = (whole(cut), counted(cut));
    let nearest = |a: &f64, b: &f64| {
        let off = |tip: f64| (tip - 2.0 * cut.infeed_angle_deg.0).abs();
        off(*a).total_cmp(&off(*b))
    };
    let tip = FANUC_ANGLES.into_iter().min_by(nearest).unwrap_or_default();
    let slope = libm::tan((tip / 2.0).to_radians());
    let start = start(cut, slope);
    let depth = round_to(whole, 3);
    let first = more(whole / libm::sqrt(count as f64), 3);
    let steps = cut.depths_mm.windows(2).take(count.saturating_sub(1)).map(|two| (two[1] - two[0]).to_mm());
    let least = libm::floor(steps.fold(whole, f64::min) * 1000.0) / 1000.0;
    let micrometres = |length: f64| number(length * 1000.0, 0);
    let values = [
        ("finishes", format!("{:02}", springs + 1)),
        ("tip", format!("{tip:02}")),
        ("least", micrometres(least)),
        ("root", words.figure(diameter(cut.root_radius_mm))),
        ("end", words.figure(position(cut.to_z_mm))),
        ("depth", micrometres(depth)),
        ("first", micrometres(first)),
        ("lead", words.figure(cut.pitch_mm.to_string())),
    ];
    let mut depths: Vec<f64> = Vec::new();
    for pass in 1..=MOST {
        let before = depths.last().map_or(0.0, |before| before + least);
        let next = (first * libm::sqrt(pass as f64)).max(before);
        if next >= depth {
            break;
        }
        depths.push(next);
    }
    depths.extend(std::iter::repeat_n(depth, springs + 1));
    // Depths of the control count from the root.
    let pass =
        |one: f64| Pass { depth: one + whole - depth, from: start.z.to_mm() + one * slope, to: cut.to_z_mm.to_mm() };
    let lines = [Use::ThreadCycleFirst, Use::ThreadCycle].map(|block| words.filled(block, &values)).join("\n");
    vec![ThreadCall { lines, start, passes: depths.into_iter().map(pass).collect() }]
}

/// CYCLE97 of Sinumerik.
pub(super) fn sinumerik(words: &ControlWords, cut: &ThreadCut, side: Side) -> Vec<ThreadCall> {
    let (slope, whole, (count, springs)) = (slope(cut), whole(cut), counted(cut));
    let start = start(cut, slope);
    let made = |area: bool| {
        let variant = if area { 3 } else { 1 } + i32::from(side == Side::Inner);
        let values = [
            ("lead", cut.pitch_mm.to_string()),
            ("begin", position(cut.begins_z_mm)),
            ("end", position(cut.ends_z_mm)),
            ("crest", diameter(cut.crest_radius_mm)),
            ("before", (cut.begins_z_mm - start.z).to_string()),
            ("behind", (cut.to_z_mm - cut.ends_z_mm).to_string()),
            ("depth", number(whole, 4)),
            ("angle", number(cut.infeed_angle_deg.0, 4)),
            ("passes", count.to_string()),
            ("springs", springs.to_string()),
            ("variant", variant.to_string()),
            ("lift", lift(cut).to_string()),
        ];
        let share = |pass: usize| pass as f64 / count as f64;
        let depths = (1..=count).map(|pass| whole * if area { libm::sqrt(share(pass)) } else { share(pass) });
        let pass = |depth: f64| Pass { depth, from: start.z.to_mm() + depth * slope, to: cut.to_z_mm.to_mm() };
        let passes = depths.chain(std::iter::repeat_n(whole, springs)).map(pass).collect();
        ThreadCall { lines: words.filled(Use::ThreadCycle, &values), start, passes }
    };
    [true, false].map(made).into()
}
