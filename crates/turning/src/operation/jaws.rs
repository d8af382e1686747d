//! The jaws and the body of the chuck in a set-up, which no tool may touch.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Finding, Note, Severity};
use crate::tables::turning::part::JawKind;
use crate::turning::allowances::Elsewhere;
use crate::turning::cutting::{jaw_clearance, soft_jaw_share};
use crate::turning::length::Half;
use crate::turning::tooling::Lathe;
use crate::turning::workpiece::Workpiece;
use crate::turning::zones::{Hold, JawLengths, SetUp};
use crate::units::Micrometres;

/// Jaws closed on a cylinder of the blank or the part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Jaws {
    /// Z of their front, in the coordinates of the set-up.
    pub front_mm: Half,
    /// The diameter that they grip.
    pub grips_mm: Micrometres,
    /// The length that they grip.
    pub length_mm: Half,
    /// The required length, by `turning-hold`.
    pub least_mm: Half,
    /// The length below which they hold nothing, by the same rule.
    #[serde(skip)]
    pub least_grip_mm: Half,
    /// Whether they grip a surface that is finished already, which hard jaws would mark.
    pub soft: bool,
    /// Whether they close nearly all around.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub full: bool,
    /// Whether they grip a bushing on a thread.
    #[serde(skip)]
    pub threaded: bool,
    /// Their body, if the lathe's record gives the size of its chuck.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body: Option<ChuckBody>,
}

/// The rotating body of the chuck: not smaller than the real one (`chuck-and-tailstock`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct ChuckBody {
    /// The swing diameter of the jaws.
    pub sweep_mm: Micrometres,
    /// The length of the jaws before the face of the chuck.
    pub out_mm: Micrometres,
    /// The diameter of the chuck.
    pub chuck_mm: Micrometres,
}

impl Jaws {
    /// The finding that they grip less than required, to stay clear of the tool.
    pub fn short(&self, set_up: u8) -> Option<Finding> {
        let (severity, code, least) = match self.length_mm {
            length if length < self.least_grip_mm => (Severity::Wrong, "jaws-grip-too-little", self.least_grip_mm),
            length if length < self.least_mm => (Severity::Doubtful, "jaws-grip-little", self.least_mm),
            _ => return None,
        };
        let note = Note::new(code).with("number", set_up).with("length", self.length_mm).with("least", least);
        Some(Finding::of_part(severity, note))
    }

    /// The note about them.
    pub fn note(&self) -> Note {
        let note = Note::new(if self.body.is_some() { "jaws-close" } else { "jaws-close-alone" })
            .with("grips", self.grips_mm)
            .with("z", Half::ZERO - self.front_mm)
            .with("length", self.length_mm);
        match self.body {
            Some(body) => note.with("sweep", body.sweep_mm),
            None => note,
        }
    }

    /// That jaws on a finished surface are soft and bored to it, or that a bushing goes between them and a thread.
    pub fn bored(&self) -> Option<Note> {
        let code = match self {
            Self { threaded: true, .. } => "jaws-on-bushing",
            Self { full: true, .. } => "jaws-full-bored",
            _ => "jaws-bored",
        };
        let note = Note::new(code).with("grips", self.grips_mm).with("length", self.length_mm);
        self.soft.then_some(note)
    }

    /// The jaws in a set-up; none between centres, and where no cylinder is long enough for them.
    ///
    /// Their clearance from the end of the turned range, or of the run-out of a thread there, is `jaw-clearance` of `turning-limits`, or the length of the
    /// cylinder beyond the required grip (`turning-hold`), but not less than `jaw-clearance-least`.
    ///
    /// # Errors
    /// The knowledge base lacks a table or a row.
    pub fn of(
        set_up: &SetUp,
        workpiece: &Workpiece,
        lathe: Option<&Lathe<'_>>,
        elsewhere: &[Elsewhere],
        knowledge: &Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        let length = workpiece.length();
        let turned = set_up.outer.as_ref().and_then(|outer| outer.main.contour.end());
        // Behind a thread at the end of it the tool runs out.
        let last = set_up.outer.as_ref().and_then(|outer| outer.profile.surfaces.last());
        let thread = last.and_then(|last| workpiece.thread_on(&last.name));
        let run_out = thread.and_then(|thread| thread.longest_run_out).map_or(Half::ZERO, Half::of);
        let turned = turned.map_or(Half::ZERO, |end| end.z) + run_out;
        let (from, to, grips_mm, touches) = match &set_up.holds_at {
            None | Some(Hold::Centres) => return Ok(None),
            Some(Hold::Blank { diameter_mm, length_mm, from }) => (*from, *from + *length_mm, *diameter_mm, *length_mm),
            // A cylinder that the first set-up made holds the part turned over.
            Some(Hold::Surface { name, diameter_mm, length_mm, over: (from, to), .. }) => {
                // What is ground later has its allowance yet.
                let left = elsewhere.iter().find(|one| one.surface.to_string() == *name);
                let left = left.map_or(Micrometres::ZERO, |one| one.allowance_mm.diameter());
                (length - *to, length - *from, *diameter_mm + left, *length_mm)
            }
        };
        let JawLengths { least, least_grip, .. } = JawLengths::of(grips_mm, knowledge)?;
        let [near, clear] = jaw_clearance(knowledge)?.map(|clearance| turned + Half::of(clearance));
        // Behind a steady rest the jaws stand as far from it as they can.
        let clear = if set_up.rest.is_some() { to } else { clear };
        let front_mm = clear.min(to - least).max(near).max(from).min(to);
        let held = lathe.map(|lathe| lathe.workholding(knowledge)).transpose()?.flatten();
        let full = workpiece.jaws == JawKind::FullGrip;
        let soft = full || matches!(set_up.holds_at, Some(Hold::Surface { .. }));
        // Nothing is gripped over more than the jaws are long, and soft ones are bored no longer than the grip needs.
        let jaw = held.map(|held| Half::of(held.grip));
        let needed = Half::from(length.to_mm() * soft_jaw_share(knowledge)?).max(least);
        let longest = Some(needed).filter(|_| soft).into_iter().chain(jaw).min();
        let passes = lathe.and_then(|lathe| lathe.bar_hole).is_none_or(|hole| workpiece.largest_diameter() <= hole);
        // What does not go through the spindle stands on the step that is bored for it.
        let front_mm = match longest {
            Some(longest) if soft && !passes && set_up.rest.is_none() => front_mm.max(to - longest),
            _ => front_mm,
        };
        let body = held.map(|held| ChuckBody {
            sweep_mm: held.jaws_sweep(grips_mm),
            out_mm: held.jaw,
            chuck_mm: held.chuck_diameter,
        });
        let threaded = matches!(set_up.holds_at, Some(Hold::Surface { threaded: true, .. }));
        let length_mm = [to - front_mm, touches].into_iter().chain(longest).min().unwrap_or_default();
        Ok(Some(Self {
            front_mm,
            grips_mm,
            length_mm,
            least_mm: least,
            least_grip_mm: least_grip,
            soft,
            full,
            threaded,
            body,
        }))
    }
}
