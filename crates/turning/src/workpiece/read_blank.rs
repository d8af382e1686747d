//! The blank of the contour form: a bar or tube by its sizes, a forging or casting by steps or contours.

use crate::knowledge::form::KeyOf;
use crate::knowledge::yaml::{Fields, Node};
use crate::turning::contour::Side;
use crate::turning::length::Half;
use crate::turning::reading::{Reader, given, mistake};
use crate::turning::shaft::BlankKind;
use crate::turning::shaft::shape::{self, BlankShape};
use crate::units::Micrometres;

use super::file::BlankFile;
use super::items::Owner;
use super::walk::{Walked, walk};
use super::{Blank, StockKind, check};

impl Reader<'_> {
    pub(super) fn blank(&mut self, node: &Node) -> Option<Blank> {
        let mut fields = self.problems.map(node)?;
        let kind =
            fields.need(BlankFile::kind, &mut self.problems).and_then(|node| self.choice(node, StockKind::NAMES));
        let length_tolerance = given(fields.take(BlankFile::length_tolerance), |node| {
            self.not_below_zero(node, BlankFile::length_tolerance.name())
        });
        let shaped = fields.take(BlankFile::outer);
        let blank = match (kind, shaped) {
            (None, _) => {
                let _ = fields.remaining();
                None
            }
            (Some(kind @ (StockKind::Forging | StockKind::Casting)), Some(outer)) => {
                let inner = fields.take(BlankFile::inner);
                self.refuse(
                    &mut fields,
                    &[BlankFile::diameter, BlankFile::length, BlankFile::face, BlankFile::bore, BlankFile::steps],
                    "blank-key-beside-outer",
                    kind,
                );
                self.shaped(kind, outer, inner)
            }
            (Some(kind), shaped) => {
                if let Some(outer) = shaped {
                    self.fault::<()>(
                        mistake!("blank-key-of-another-kind", key = BlankFile::outer.name(), stock = kind.name()),
                        &outer.place,
                    );
                }
                self.refuse(&mut fields, &[BlankFile::inner], "blank-key-of-another-kind", kind);
                self.sized_blank(kind, &mut fields)
            }
        };
        fields.finish(&mut self.problems);
        Some(Blank { length_tolerance: length_tolerance?, ..blank? })
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
    fn sized_blank(&mut self, kind: StockKind, fields: &mut Fields<'_, BlankFile>) -> Option<Blank> {
        let diameter = self.need(fields, BlankFile::diameter);
        let length = self.need(fields, BlankFile::length);
        let face = match fields.take(BlankFile::face) {
            Some(node) => self.not_below_zero(node, BlankFile::face.name()),
            None => Some(Micrometres::ZERO),
        };
        if kind != StockKind::Tube {
            self.refuse(fields, &[BlankFile::bore], "blank-key-of-another-kind", kind);
        }
        let bore = match kind {
            StockKind::Tube => Some(self.need(fields, BlankFile::bore)),
            _ => None,
        };
        if matches!(kind, StockKind::Bar | StockKind::Tube) {
            self.refuse(fields, &[BlankFile::steps], "blank-key-of-another-kind", kind);
        }
        let steps =
            fields.take(BlankFile::steps).map(|node| BlankShape { steps: self.steps(node), place: node.place.clone() });
        if let Some(shape) = &steps {
            shape::check(shape, Some(BlankKind::Forging), &[], diameter.as_ref(), length.as_ref(), self);
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
        let (diameter, length, face) = (diameter?.0, length?.0, Half::of(face?));
        let blank = Blank::cylinder(kind, Half::radius_of(diameter), bore, face, Half::of(length));
        match steps {
            Some(shape) => Some(blank.with_steps(&shape.whole()?)),
            None => Some(blank),
        }
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
