//! The grooves of a contour: their sizes, from the file or a standard, and how they are placed.

use crate::knowledge::diagnostic::Place;
use crate::turning::contour::{Piece, Side, SurfaceKind};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::reading::mistake;
use crate::units::{Decimal, Micrometres};

use super::groove::{self, GrooveFrame, Sizes};
use super::item_file::GrooveKind;
use super::items::{ContourItem, GrooveValues, ItemShape, Measure};
use super::relief;
use super::walk::Walk;

impl Walk<'_, '_, '_> {
    /// The pieces of a groove that begins here; none with a mistake if it is not possible.
    pub(super) fn drawn(
        &mut self,
        index: usize,
        here: Point,
        item: &ContourItem,
        values: &GrooveValues,
    ) -> Option<(SurfaceKind, Vec<Piece>)> {
        let sizes = self.sizes(index, here, item, values)?;
        let Some(frame) = self.frame(index, here, values.kind) else {
            self.fault(mistake!("groove-not-in-a-face"), &item.place);
            return None;
        };
        if frame.on_cylinder && frame.radial < 0 && sizes.depth >= here.radius {
            self.fault(mistake!("groove-deeper-than-radius", depth = sizes.depth, radius = here.radius), &item.place);
            return None;
        }
        match groove::pieces(sizes, frame) {
            Ok(pieces) if pieces.iter().any(|piece| piece.to.radius < Half::ZERO) => {
                self.fault(mistake!("below-the-axis"), &item.place);
                None
            }
            Ok(pieces) => Some((values.kind.surface(), pieces)),
            Err(code) => {
                self.fault(mistake!(code, width = sizes.width, depth = sizes.depth), &item.place);
                None
            }
        }
    }

    fn frame(&self, index: usize, here: Point, kind: GrooveKind) -> Option<GrooveFrame> {
        let outer = self.walked.side == Side::Outer;
        let hollow = self.hollow(true);
        if kind != GrooveKind::Face {
            let radial = if outer { -1 } else { 1 };
            return Some(GrooveFrame { at: here, on_cylinder: true, radial, axial: 1, hollow });
        }
        // On an outer contour a face that goes outwards faces the free end, so its metal is towards the chuck.
        let radial = self.radial_way(index)?;
        let axial = if outer { radial } else { -radial };
        Some(GrooveFrame { at: here, on_cylinder: false, radial, axial, hollow })
    }

    /// The sizes of a groove from the file; for a relief the missing ones from its standard.
    fn sizes(&mut self, index: usize, here: Point, item: &ContourItem, values: &GrooveValues) -> Option<Sizes> {
        let kind = values.kind;
        if let Some((_, place)) = values.angle.as_ref().filter(|_| !kind.has_angle()) {
            self.fault(mistake!("angle-of-a-straight-groove", kind_of_groove = kind.name()), place);
        }
        if values.unreadable {
            return None;
        }
        let given = |measure: &Measure| measure.as_ref().map(|(length, _)| *length);
        let (mut width, mut depth) = (given(&values.width), given(&values.depth));
        if (width.is_none() || depth.is_none())
            && let Some(relief) = self.standard(index, here, kind, width)
        {
            width = width.or(Some(relief.width));
            depth = depth.or(Some(relief.depth));
            self.walked.findings.extend(relief.finding);
        }
        let slant = match &values.angle {
            Some((angle, place)) => self.slant(*angle, place),
            None => Some(0.0),
        };
        let lacking: Vec<&str> = [
            ("width", width.is_none()),
            ("depth", depth.is_none()),
            ("angle", kind.has_angle() && values.angle.is_none()),
            ("radius", kind.needs_radius() && values.radius.is_none()),
        ]
        .iter()
        .filter_map(|(key, lacks)| lacks.then_some(*key))
        .collect();
        if !lacking.is_empty() {
            self.fault(mistake!("groove-sizes-needed", keys = lacking.join(", ")), &item.place);
        }
        let shoulder_first = self.last().is_none_or(|last| last.kind == SurfaceKind::Face);
        let radius = given(&values.radius).map(Half::of);
        Some(Sizes { kind, width: Half::of(width?), depth: Half::of(depth?), radius, slant: slant?, shoulder_first })
            .filter(|_| lacking.is_empty())
    }

    /// The tangent of half the angle between the walls.
    fn slant(&mut self, angle: Decimal, place: &Place) -> Option<f64> {
        if angle <= Decimal::from_int(0) || angle >= Decimal::from_int(180) {
            self.fault(mistake!("bad-groove-angle", angle = angle), place);
            return None;
        }
        Some(libm::tan((angle.to_f64() / 2.0).to_radians()))
    }

    fn standard(
        &self,
        index: usize,
        here: Point,
        kind: GrooveKind,
        width: Option<Micrometres>,
    ) -> Option<relief::Relief> {
        match kind {
            GrooveKind::GrindingRelief => relief::grinding(here.radius.diameter(), width, self.reader.knowledge),
            GrooveKind::ThreadRelief => {
                let before = self.last().filter(|last| last.kind == SurfaceKind::Thread);
                let before = before.and(self.walked.threads.last()).map(|thread| thread.pitch);
                let after = match self.items.get(index + 1).and_then(Option::as_ref).map(|next| &next.shape) {
                    Some(ItemShape::Thread { size: Some((size, _)), .. }) => Some(size.pitch),
                    _ => None,
                };
                relief::thread(before.or(after)?, self.walked.side, self.reader.knowledge)
            }
            _ => None,
        }
    }
}
