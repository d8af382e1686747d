//! A zone prepared for the schemes: checked, as an outer contour, in pieces that only rise or only fall.

use crate::error::{Refusal, Tried};
use crate::knowledge::Knowledge;
use crate::note::{Because, Note};
use crate::turning::contour::{Contour, Side};
use crate::turning::length::Half;
use crate::turning::point::Point;

use super::builder::ToolpathBuilder;
use super::check::{self, Unsuited};
use super::equidistant::Offset;
use super::in_process_stock::InProcessStock;
use super::monotone::MonotoneContour;
use super::split::Split;
use super::{Scheme, Settings, Stock, Tool, Transition};
use super::{contour, descent, equidistant, looped, measures, pick_up, semi_finishing, support_points, zigzag};

/// A zone prepared for work.
#[derive(Clone, Debug)]
pub struct PreparedZone {
    /// The rough contour.
    pub rough: MonotoneContour,
    /// The blank.
    pub blank: MonotoneContour,
    /// The whole blank, before any work.
    pub whole: InProcessStock,
    /// The highest radius of the blank.
    pub top: Half,
    /// The radius above which the tool cannot go: in a bore, inside out, the axis.
    pub ceiling: Option<Half>,
    /// Outside of this range blank and rough contour have the same pieces, so nothing is cut there.
    pub worked: (Half, Half),
    /// Both contours as given, as outer ones.
    pub stock: Stock,
    /// Why passes along the contour are not possible with this tool, if they are not.
    pub(super) steep: Option<Unsuited>,
    nose_radius: Half,
    settings: Settings,
    levels: Split,
}

impl PreparedZone {
    /// Prepares a zone, outer or inner, for a tool and its settings.
    ///
    /// # Errors
    /// No scheme can work it ([`check::zone`]).
    pub fn of(stock: &Stock, tool: &Tool, settings: &Settings) -> Tried<Self, Unsuited> {
        let (stock, ceiling) = if stock.rough.side == Side::Outer {
            (stock.clone(), None)
        } else {
            let Some((_, top)) = stock.rough.radii() else {
                return Err(Refusal::Not(Unsuited::NotMonotone { contour: "rough" }));
            };
            (Stock { rough: stock.rough.inside_out(top), blank: stock.blank.inside_out(top), ..*stock }, Some(top))
        };
        let (rough, blank) = (MonotoneContour::of(&stock.rough), MonotoneContour::of(&stock.blank));
        check::zone(&stock, &rough, &blank, settings)?;
        let worked = worked(&rough, &blank);
        let whole = InProcessStock::of(&blank);
        let top = blank.highest(blank.from(), blank.to()).unwrap_or_default();
        let levels = Split::with_depth(&rough, &blank, settings.depth).within(worked);
        let (steep, nose_radius, settings) = (check::steep(&rough, tool), tool.nose_radius, *settings);
        Ok(Self { rough, blank, whole, top, ceiling, worked, stock, steep, nose_radius, settings, levels })
    }

    /// A radius, limited to where the tool can be.
    pub fn limited(&self, radius: Half) -> Half {
        self.ceiling.map_or(radius, |ceiling| radius.min(ceiling))
    }

    /// Off the corner of the blank by the approach.
    pub fn home(&self, settings: &Settings) -> Point {
        Point { radius: self.limited(self.top + settings.approach), z: self.rough.from() - settings.approach }
    }

    /// The zone cleared by a scheme. `offset` makes offset curves for the equidistant scheme.
    ///
    /// # Errors
    /// The scheme does not suit ([`check::scheme`]), an offset curve cannot be made, or the knowledge base
    /// lacks the scheme.
    pub fn transition(&self, scheme: Scheme, offset: Offset<'_>, knowledge: &Knowledge) -> Tried<Transition, Unsuited> {
        let row = scheme.record(knowledge)?.row;
        check::scheme(self, &self.settings, scheme)?;
        let mut builder = ToolpathBuilder::new(self, &self.settings);
        match scheme {
            Scheme::Loop => looped::work(&mut builder, &self.levels),
            Scheme::LoopAgainstStop => looped::work(&mut builder, &self.levels.clone().against_stops(&self.rough)),
            Scheme::Zigzag => zigzag::work(&mut builder, &self.levels),
            Scheme::Descent => descent::work(&mut builder),
            Scheme::PickUp => pick_up::work(&mut builder, &self.levels, self.nose_radius),
            Scheme::SemiFinishing => semi_finishing::work(&mut builder, &self.levels),
            Scheme::Equidistant => {
                let outer = |contour: &Contour, distance: Half| match self.ceiling {
                    None => offset(contour, distance),
                    Some(top) => Some(offset(&contour.inside_out(top), distance)?.inside_out(top)),
                };
                equidistant::work(&mut builder, &outer)?;
            }
            Scheme::Contour => contour::work(&mut builder),
        }
        let builder = builder.home();
        let edge = (scheme == Scheme::Descent).then_some(self.settings.depth);
        let ridges_mm = builder.stock.ridge(self.rough.touching(self.worked.0, self.worked.1));
        let measures = measures::measure(&builder.path, self, &self.settings.feeds, builder.passes, edge);
        let path = self.ceiling.map_or(builder.path.clone(), |top| builder.path.inside_out(top));
        Ok(Transition {
            scheme,
            points: support_points::points(&path, &builder.roles),
            edge,
            ridges_mm,
            uniform: ridges_mm == Half::ZERO,
            measures,
            because: Because::row(row, Note::new(format!("transition-{}", scheme.name()))),
            path,
        })
    }

    /// The surface of the stock after a transition: the rough contour with its ridges. It is the blank of the next,
    /// deeper work.
    pub fn left(&self, transition: &Transition) -> Contour {
        let mut stock = self.whole.clone();
        let path = self.ceiling.map_or(transition.path.clone(), |top| transition.path.inside_out(top));
        for (piece, purpose) in path.pieces() {
            measures::cut(&mut stock, &piece, purpose, transition.edge);
        }
        let left = stock.surface(&self.rough);
        self.ceiling.map_or(left.clone(), |top| left.inside_out(top))
    }
}

/// The range between the pieces that two contours have in common at their ends.
fn worked(rough: &MonotoneContour, blank: &MonotoneContour) -> (Half, Half) {
    let same = |(one, other): &(&_, &_)| one == other;
    let before = rough.pieces.iter().zip(&blank.pieces).take_while(same).count();
    let behind = rough.pieces.iter().rev().zip(blank.pieces.iter().rev()).take_while(same).count();
    let from = rough.pieces.get(before).map_or(rough.to(), |piece| piece.from.z);
    let last = rough.pieces.len().checked_sub(behind + 1).and_then(|last| rough.pieces.get(last));
    let to = last.map_or(rough.from(), |piece| piece.to.z);
    (from, to.max(from))
}
