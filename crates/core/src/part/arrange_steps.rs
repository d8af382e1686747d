//! Orders the cylinders of a stepped hole: which one is the main cylinder, and from which face the others are
//! entered.

use crate::knowledge::diagnostic::Place;
use crate::units::{Micrometres, Roughness};
use technolog_note::note;

use super::check::BoreSpan;
use super::file::hole as form;
use super::read::Reader;
use super::read_steps::{GroupValues, depth_or_length};
use super::{Bottom, Face, HoleStep, Thread, ToleratedDiameter};

/// The cylinders of a hole: the main one, and the wider ones beside it.
pub(super) struct Cylinders {
    pub diameter: ToleratedDiameter,
    pub thread: Option<Thread>,
    pub depth: Micrometres,
    pub bottom: Bottom,
    pub roughness: Roughness,
    pub chamfer: Option<Micrometres>,
    pub steps: Vec<HoleStep>,
    /// All of them, from the entry face inwards.
    pub spans: Vec<BoreSpan>,
}

/// A cylinder as it is written.
pub(super) struct Cylinder {
    pub diameter: ToleratedDiameter,
    pub thread: Option<Thread>,
    pub roughness: Roughness,
    pub bottom: Option<Bottom>,
    pub chamfer: Option<Micrometres>,
    /// From the entry face, mm.
    pub end: Micrometres,
    pub place: Place,
}

impl Cylinder {
    const fn nominal(&self) -> Micrometres {
        self.diameter.nominal
    }

    /// The diameter of the removed metal: for a thread its own.
    fn widest(&self) -> Micrometres {
        self.thread.as_ref().map_or(self.nominal(), |thread| thread.size.max(self.nominal()))
    }

    fn step(self, face: Face, depth: Micrometres) -> HoleStep {
        HoleStep {
            diameter: self.diameter,
            face,
            depth,
            bottom: self.bottom.unwrap_or(Bottom::Flat),
            roughness: self.roughness,
            thread: self.thread,
            chamfer: self.chamfer,
        }
    }
}

impl Reader<'_> {
    /// Compares the diameter of the group with its steps: it is the narrowest step, or a cylinder that continues
    /// after the last step and is then added. Returns whether it was added.
    pub(super) fn innermost(&mut self, cylinders: &mut Vec<Cylinder>, whole: &GroupValues<'_>) -> Option<bool> {
        let Some(sized) = &whole.diameter else { return Some(false) };
        let nominal = sized.diameter.nominal;
        let narrowest = cylinders.iter().map(Cylinder::nominal).min()?;
        let fault = if nominal < narrowest {
            None
        } else if nominal > narrowest {
            let (shown, help) = (&sized.diameter, note!("part-leave-out-give-narrowest"));
            Some((note!("part-hole-wider-than-narrowest-step", shown = shown, narrowest = narrowest), help))
        } else {
            let main = cylinders.iter_mut().find(|cylinder| cylinder.nominal() == narrowest)?;
            let same_field = (main.diameter.upper, main.diameter.lower) == (sized.diameter.upper, sized.diameter.lower);
            let (ours, theirs) = (&sized.diameter, &main.diameter);
            let differ =
                Some((note!("part-hole-step", ours = ours, theirs = theirs), note!("part-write-once-same-twice")));
            match (&sized.thread, &main.thread) {
                (Some(thread), Some(known)) if thread.id != known.id => differ,
                (Some(thread), _) => {
                    main.thread = Some(thread.clone());
                    main.diameter = sized.diameter.clone();
                    return Some(false);
                }
                (None, None) if !same_field => differ,
                (None, _) => return Some(false),
            }
        };
        if let Some((message, help)) = fault {
            return self.problems.error_help("bad-diameter", message, &sized.place, help);
        }
        let last = cylinders.last()?.end;
        let Some(depth) = whole.depth else {
            // If the blank could not be read, the depth of a through hole is unknown, and that is reported there.
            if !whole.through {
                let help = note!("part-holes-own-diameter-goes-on");
                self.problems.missing::<_, ()>(form::Hole::depth, whole.place, help);
            }
            return None;
        };
        if depth <= last {
            let message =
                note!("part-steps-end-at-which-leaves", last = last, depth = depth, diameter = sized.diameter);
            let place = cylinders.last()?.place.clone();
            return self.problems.error_help("bad-depth", message, &place, depth_or_length());
        }
        let roughness = match whole.roughness {
            Some(stated) => stated?,
            None if sized.thread.is_some() => self.thread_roughness(&sized.place)?,
            None => {
                let help = note!("part-holes-own-diameter-goes-on-2");
                return self.problems.missing(form::Hole::roughness, whole.place, help);
            }
        };
        cylinders.push(Cylinder {
            diameter: sized.diameter.clone(),
            thread: sized.thread.clone(),
            roughness,
            bottom: None,
            chamfer: None,
            end: depth,
            place: sized.place.clone(),
        });
        Some(true)
    }

    /// Checks that the cylinders narrow towards the main one from each side.
    pub(super) fn check_narrowing(&mut self, cylinders: &[Cylinder], through: bool) -> Option<()> {
        let mut sound = Some(());
        for (index, cylinder) in cylinders.iter().enumerate() {
            let wide = cylinder.nominal();
            if index > 0 && cylinders[index - 1].nominal() == wide {
                let message = note!("part-step-like-one-before", index = index + 1, wide = wide);
                sound = self.problems.error_help("bad-diameter", message, &cylinder.place, note!("part-join-two"));
                continue;
            }
            let narrower = |others: &[Cylinder]| others.iter().any(|other| other.nominal() < wide);
            if narrower(&cylinders[..index]) && (!through || narrower(&cylinders[index + 1..])) {
                let message = note!("part-step-wider-than-what-leads", index = index + 1, wide = wide);
                let help = note!("part-no-axial-tool-reaches-inner");
                sound = self.problems.error_help("inner-step", message, &cylinder.place, help);
            }
        }
        sound
    }

    /// Makes the narrowest cylinder the main one; those before it are entered from the entry face, those after it
    /// from the back.
    pub(super) fn arrange(&mut self, mut cylinders: Vec<Cylinder>, whole: GroupValues<'_>) -> Option<Cylinders> {
        if let (Some((chamfer, place)), Some(first)) = (whole.chamfer, cylinders.first_mut()) {
            if let Some(own) = first.chamfer.filter(|own| *own != chamfer) {
                let message = note!("part-chamfer-at-entry-here-first", chamfer = chamfer, own = own);
                self.problems.error_help::<()>("bad-value", message, &place, note!("part-keep-one-them"));
            }
            first.chamfer = Some(chamfer);
        }
        let mut spans = Vec::new();
        let mut start = Micrometres::ZERO;
        for cylinder in &cylinders {
            spans.push(BoreSpan::new(cylinder.widest(), start, cylinder.end));
            start = cylinder.end;
        }
        let depth = start;
        let narrowest = cylinders.iter().map(Cylinder::nominal).min()?;
        let main = cylinders.iter().position(|one| one.nominal() == narrowest)?;
        let mut behind = cylinders.split_off(main);
        let main = behind.remove(0);
        let back_starts = spans.iter().skip(spans.len() - behind.len()).map(|span| span.from);
        let entry = cylinders.into_iter().map(|one| {
            let end = one.end;
            one.step(Face::Entry, end)
        });
        let back = behind.into_iter().zip(back_starts).map(|(one, from)| one.step(Face::Back, depth - from));
        Some(Cylinders {
            diameter: main.diameter,
            thread: main.thread,
            depth,
            // The innermost end is the bottom of the hole, not a shoulder: the default of the hole applies.
            bottom: main.bottom.or(whole.bottom).unwrap_or_default(),
            roughness: main.roughness,
            chamfer: main.chamfer,
            steps: entry.chain(back).collect(),
            spans,
        })
    }
}
