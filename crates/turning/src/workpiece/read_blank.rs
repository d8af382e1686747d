//! The blank: a bar or tube by its sizes, a forging or casting by steps or contours.

use crate::knowledge::form::{Form, KeyOf};
use crate::knowledge::yaml::{Fields, Node};
use crate::turning::contour::Side;
use crate::turning::length::Half;
use crate::turning::reading::{Reader, given, mistake};
use crate::turning::shaft::{self, Step};
use crate::units::Micrometres;

use super::file::BlankFile;
use super::items::Owner;
use super::steps::PlacedSteps;
use super::walk::{Walked, walk};
use super::{Blank, StockKind, check};

/// A blank as its file describes it.
pub(super) struct ReadBlank {
    pub(super) blank: Blank,
    /// Its sizes, unless it has contours.
    pub(super) sizes: Option<shaft::Blank>,
    /// Its own steps.
    pub(super) steps: Vec<Step>,
}

impl Reader<'_> {
    /// The blank of a part, which may be given by steps.
    pub(super) fn blank(&mut self, node: &Node, part: Option<&PlacedSteps>) -> Option<ReadBlank> {
        type F = BlankFile;
        let mut fields = self.problems.map(node)?;
        let kind = fields.need(F::kind, &mut self.problems).and_then(|node| match node.text() {
            // A tube has a bore, which steps cannot describe.
            Some("tube") if part.is_some() => self.fault(mistake!("tube-with-steps"), &node.place),
            _ => self.choice(node, StockKind::NAMES),
        });
        let length_tolerance =
            given(fields.take(F::length_tolerance), |node| self.not_below_zero(node, F::length_tolerance.name()));
        let shaped = if part.is_some() { None } else { fields.take(F::outer) };
        let read = match (kind, shaped) {
            (None, _) if part.is_none() => {
                let _ = fields.remaining();
                None
            }
            (Some(kind @ (StockKind::Forging | StockKind::Casting)), Some(outer)) => {
                let inner = fields.take(F::inner);
                let sizes = [F::diameter, F::length, F::face, F::bore, F::steps];
                self.refuse(&mut fields, &sizes, "blank-key-beside-outer", kind);
                let blank = self.shaped(kind, outer, inner);
                blank.map(|blank| ReadBlank { blank, sizes: None, steps: Vec::new() })
            }
            (kind, shaped) => {
                if let (Some(outer), Some(kind)) = (shaped, kind) {
                    self.fault::<()>(
                        mistake!("blank-key-of-another-kind", key = F::outer.name(), stock = kind.name()),
                        &outer.place,
                    );
                }
                self.sized_blank(kind, &mut fields, part)
            }
        };
        let of_steps = [F::kind, F::diameter, F::length, F::length_tolerance, F::steps];
        fields.finish_among(if part.is_some() { &of_steps } else { F::KEYS }, &mut self.problems);
        let (length_tolerance, read) = (length_tolerance?, read?);
        Some(ReadBlank { blank: Blank { length_tolerance, ..read.blank }, ..read })
    }

    /// Refuses keys that do not belong to this blank.
    fn refuse(
        &mut self,
        fields: &mut Fields<'_, BlankFile>,
        keys: &[KeyOf<BlankFile>],
        code: &'static str,
        kind: StockKind,
    ) {
        for key in keys {
            if let Some(node) = fields.take(*key) {
                self.fault::<()>(mistake!(code, key = key.name(), stock = kind.name()), &node.place);
            }
        }
    }

    /// A cylinder, with a bore if it is a tube, with steps if it is a forging or casting.
    fn sized_blank(
        &mut self,
        kind: Option<StockKind>,
        fields: &mut Fields<'_, BlankFile>,
        part: Option<&PlacedSteps>,
    ) -> Option<ReadBlank> {
        type F = BlankFile;
        let diameter = self.need(fields, F::diameter);
        let length = self.need(fields, F::length);
        let mut face = Some(Micrometres::ZERO);
        let mut bore = None;
        if let (Some(kind), None) = (kind, part) {
            self.refuse(fields, &[F::inner], "blank-key-of-another-kind", kind);
            if let Some(node) = fields.take(F::face) {
                face = self.not_below_zero(node, F::face.name());
            }
            if kind == StockKind::Tube {
                bore = Some(self.need(fields, F::bore));
            } else {
                self.refuse(fields, &[F::bore], "blank-key-of-another-kind", kind);
            }
        }
        if let Some(kind @ (StockKind::Bar | StockKind::Tube)) = kind {
            self.refuse(fields, &[F::steps], "blank-key-of-another-kind", kind);
        }
        let shape = given(fields.take(F::steps), |node| self.steps(node));
        if let Some(steps) = part {
            self.check_steps(steps, diameter.as_ref(), length.as_ref());
        }
        if let Some(Some(shape)) = &shape {
            self.check_blank_steps(shape, diameter.as_ref(), length.as_ref());
            if let Some(steps) = part {
                self.check_under_blank(steps, shape);
            }
        }
        if let (Some(Some((bore, place))), Some((diameter, _))) = (&bore, &diameter)
            && bore >= diameter
        {
            return self.fault(mistake!("bore-beyond-diameter", bore = bore, diameter = diameter), place);
        }
        if let (Some(face), Some((length, place))) = (face, &length)
            && face >= *length
        {
            return self.fault(mistake!("face-beyond-length", face = face, length = length), place);
        }
        let bore = given(bore, |bore| Some(Half::radius_of(bore?.0)))?;
        let steps = given(shape?, |shape| shape.whole())?.unwrap_or_default();
        let sizes = shaft::Blank { kind: kind?, diameter: diameter?.0, length: length?.0 };
        let (radius, length) = (Half::radius_of(sizes.diameter), Half::of(sizes.length));
        let blank = Blank::cylinder(sizes.kind, radius, bore, Half::of(face?), length).with_steps(&steps);
        Some(ReadBlank { blank, sizes: Some(sizes), steps })
    }

    /// A forging or casting by its contours.
    fn shaped(&mut self, kind: StockKind, outer: &Node, inner: Option<&Node>) -> Option<Blank> {
        let outside = self.blank_contour(outer, Side::Outer);
        let bore = inner.map(|node| self.blank_contour(node, Side::Inner));
        if let (Some((start, place)), expected) = (&outside.start, bore.as_ref().map(|bore| &bore.start)) {
            match expected {
                None if start.radius != Half::ZERO => {
                    self.fault::<()>(
                        mistake!("does-not-begin-on-the-axis", d = start.radius.diameter(), bore = Micrometres::ZERO),
                        place,
                    );
                }
                Some(Some((bore, place))) if bore != start => {
                    check::do_not_meet(*bore, *start, place, self);
                }
                _ => {}
            }
        }
        if let Some(bore) = bore.as_ref().filter(|bore| bore.whole && outside.whole) {
            check::walls(&outside, bore, self);
        }
        let contour = |walked: &Walked| walked.profile().map(|profile| profile.contour());
        let inner = given(bore.as_ref(), contour)?;
        Some(Blank { kind, outer: contour(&outside)?, inner, length_tolerance: None })
    }

    fn blank_contour(&mut self, node: &Node, side: Side) -> Walked {
        let items = self.items(node, side, Owner::Blank);
        let walked = walk(&items, side, self);
        if walked.whole {
            check::crosses_itself(&walked, self);
        }
        walked
    }
}
