//! Classifies a surface as main or additional, with the reasons.

use std::collections::BTreeMap;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Figure, Note};
use crate::tables::turning::part::TurningElementFor;
use crate::turning::contour::{Surface, SurfaceName};
use crate::units::{Degrees, round_to};

use super::bridge::BridgeSpan;
use super::reach::Shade;
use super::view::{Bit, steepness};
use super::{Angles, Class, Element, ElementReason};

/// An undercut is steeper than this, degrees. 0.06° above 90° are allowed for the rounded ends of an upright arc.
const UPRIGHT: f64 = 90.06;

/// A bit, the reach of the tool there, and the bridge over it.
#[derive(Clone, Copy)]
pub(super) struct SeenBit<'s> {
    bit: &'s Bit,
    shade: Option<Shade>,
    reached: bool,
    under: Option<&'s BridgeSpan>,
}

/// The reach of the tool along the contour.
pub(super) struct Seen<'s> {
    /// In the order of the feed.
    bits: Vec<SeenBit<'s>>,
    /// The same by surface.
    by_surface: BTreeMap<usize, Vec<SeenBit<'s>>>,
}

impl<'s> Seen<'s> {
    pub fn new(bits: &'s [Bit], shades: &[(Option<Shade>, bool)], spans: &'s [BridgeSpan]) -> Self {
        let seen = |(bit, (shade, reached)): (&'s Bit, &(Option<Shade>, bool))| SeenBit {
            bit,
            shade: *shade,
            reached: *reached,
            under: None,
        };
        let mut bits: Vec<SeenBit<'s>> = bits.iter().zip(shades).map(seen).collect();
        for span in spans {
            let under = bits.iter_mut().take(span.bits.1).skip(span.bits.0);
            under.for_each(|bit| bit.under = bit.under.or(Some(span)));
        }
        let mut by_surface: BTreeMap<usize, Vec<SeenBit<'s>>> = BTreeMap::new();
        for one in &bits {
            by_surface.entry(one.bit.surface).or_default().push(*one);
        }
        Self { bits, by_surface }
    }

    fn of(&self, surface: usize) -> &[SeenBit<'s>] {
        self.by_surface.get(&surface).map_or(&[], Vec::as_slice)
    }

    /// The steepest fall of a valley, and whether the tool reaches part of its floor.
    fn valley(&self, span: &BridgeSpan) -> (f64, bool) {
        let fall = span.under.iter().map(|bit| steepness(bit.piece).1).fold(0.0, f64::max);
        let floor = span.under.iter().map(|bit| bit.piece.from.radius.min(bit.piece.to.radius)).min();
        let on_floor = |bit: &Bit| bit.piece.to.radius <= bit.piece.from.radius && Some(bit.piece.to.radius) == floor;
        let mut under = self.bits.iter().take(span.bits.1).skip(span.bits.0);
        (fall, under.any(|one| on_floor(one.bit) && one.reached))
    }
}

/// Classifies a surface by the reach of the tool and the bridges over it.
///
/// # Errors
/// The knowledge base lacks the rule `turning-element` or a row of it.
pub(super) fn class(
    index: usize,
    surface: &Surface,
    tool: Angles,
    seen: &Seen<'_>,
    knowledge: &Knowledge,
) -> Result<Class, KnowledgeError> {
    let own = seen.of(index);
    let steep = own.iter().map(|one| steepness(one.bit.piece));
    let (rise, fall) = steep.fold((0.0_f64, 0.0_f64), |most, one| (most.0.max(one.0), most.1.max(one.1)));
    let has = |shade| own.iter().any(|one| one.shade == Some(shade));
    let covered = !own.is_empty() && own.iter().all(|one| one.under.is_some());
    let beyond = !own.is_empty() && own.iter().all(|one| one.under.is_some_and(|span| span.open));
    let ground = if surface.kind.is_additional() {
        ElementReason::Kind
    } else if beyond {
        ElementReason::Beyond
    } else if has(Shade::Over) {
        ElementReason::Back
    } else if has(Shade::Behind) {
        if fall > UPRIGHT {
            ElementReason::Back
        } else if fall > tool.secondary.0 {
            ElementReason::Fall
        } else {
            ElementReason::Shadow
        }
    } else if has(Shade::Ahead) {
        if rise > UPRIGHT {
            ElementReason::Back
        } else if rise > tool.main.0 {
            ElementReason::Rise
        } else {
            ElementReason::Corner
        }
    } else if covered {
        ElementReason::Valley
    } else {
        ElementReason::Reach
    };
    let valley = own.iter().find_map(|one| one.under).map(|span| seen.valley(span));
    let (element, tool_kind, because) = {
        let note = note(ground, &surface.name, (rise, fall), tool);
        let (valley_fall, reached) = valley.unwrap_or((fall, true));
        ask(surface, ground, valley_fall, reached, note, knowledge)?
    };
    let reached_somewhere = own.iter().any(|one| one.reached);
    let partly =
        !matches!(ground, ElementReason::Reach | ElementReason::Kind | ElementReason::Valley | ElementReason::Beyond)
            && reached_somewhere;
    let notes = partly.then(|| Note::new("element-partly").with("surface", &surface.name)).into_iter().collect();
    Ok(Class {
        surface: index,
        name: surface.name.clone(),
        element,
        ground,
        partly,
        rise: Degrees(round_to(rise, 4)),
        fall: Degrees(round_to(fall, 4)),
        tool: tool_kind,
        because,
        notes,
    })
}

/// The element and the kind of tool from the rule `turning-element`.
fn ask(
    surface: &Surface,
    ground: ElementReason,
    fall: f64,
    reached: bool,
    note: Note,
    knowledge: &Knowledge,
) -> Result<(Element, String, Because), KnowledgeError> {
    let asked = knowledge.ask(&TurningElementFor {
        kind: surface.kind,
        ground,
        valley_fall: Degrees(round_to(fall, 4)),
        floor_reached: reached,
    })?;
    let rule = asked.need(surface.kind.name())?;
    let because = Because::answer(&asked.answer, note.with("take", Figure::word(rule.tool.to_owned())));
    Ok((rule.element, rule.tool.to_owned(), because))
}

/// The sentence that compares the angles of the element with those of the tool.
fn note(ground: ElementReason, surface: &SurfaceName, (rise, fall): (f64, f64), tool: Angles) -> Note {
    let angle = |degrees: f64| round_to(degrees, 2);
    let (main, secondary) = (angle(tool.main.0), angle(tool.secondary.0));
    let note = match ground {
        ElementReason::Reach => Note::new("element-main")
            .with("rise", angle(rise))
            .with("fall", angle(fall))
            .with("main", main)
            .with("secondary", secondary),
        ElementReason::Kind => Note::new("element-by-kind"),
        ElementReason::Rise => Note::new("element-rises").with("rise", angle(rise)).with("main", main),
        ElementReason::Fall => Note::new("element-falls").with("fall", angle(fall)).with("secondary", secondary),
        ElementReason::Back => Note::new("element-leads-back"),
        ElementReason::Shadow => Note::new("element-in-shadow").with("secondary", secondary),
        ElementReason::Corner => Note::new("element-in-corner").with("main", main),
        ElementReason::Valley => Note::new("element-in-valley"),
        ElementReason::Beyond => Note::new("element-beyond").with("fall", angle(fall)).with("secondary", secondary),
    };
    note.with("surface", surface)
}
