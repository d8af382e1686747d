//! The clearing of each zone: its tool, its levels, the schemes over it, and the chosen one.

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::note::{Because, Finding, Note, Severity};
use crate::tables::turning::part::BlankShape;
use crate::turning::contour::{Contour, Piece, Profile};
use crate::turning::elements::{Main, Valley};
use crate::turning::length::Half;
use crate::turning::transitions::measures::Best;
use crate::turning::transitions::split::Split;
use crate::turning::transitions::{self, Scheme, Stock, Transition};
use crate::turning::zones::{self, Fit, Returns, SetUp, TurnedSide, Zone};

use super::Stage;
use super::clear::{ZoneContours, zone_work};
use super::depth::{Depth, Pace};
use super::layers::{self, Layers};
use super::pocket::cut;
use super::tools::{self, Bench, ChosenTool};

/// A zone and its clearing.
#[derive(Clone, Debug, Serialize)]
pub struct ZoneWork {
    /// The zone.
    pub zone: Zone,
    /// The tools that fit it, and why the others do not.
    pub fit: Fit,
    /// The chosen tool.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tool: Option<ChosenTool>,
    /// The limiting depth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub depth: Option<Depth>,
    /// The parts that are cleared separately, in the order of work.
    pub works: Vec<Work>,
    /// The returns saved because its parts are one zone (fig. 12.5), on levels of its largest t_p, for any scheme. None
    /// for a zone of one part, and for a face.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub returns: Option<Returns>,
}

impl ZoneWork {
    /// Whether every part of it has a toolpath.
    pub fn is_cleared(&self) -> bool {
        !self.works.is_empty() && self.works.iter().all(|work| work.transition().is_some())
    }
}

/// The work of one scheme.
#[derive(Clone, Debug, Serialize)]
pub struct Work {
    /// The stock to remove.
    #[serde(skip)]
    pub stock: Stock,
    /// Its levels, with the one depth t_p.
    pub levels: Split,
    /// Rates and conditions at t_p.
    pub pace: Pace,
    /// The chosen scheme: the one in the file, or the first of the rule.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub taken: Option<Scheme>,
    /// The reason for it.
    pub because: Because,
    /// Every scheme that can clear it.
    pub transitions: Vec<Transition>,
    /// The others, with the reason.
    pub refused: Vec<RefusedScheme>,
    /// The scheme with the least time of those that leave an even allowance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quickest_even: Option<Best>,
    /// The quickest of all.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quickest: Option<Best>,
}

/// A scheme that cannot clear a zone.
#[derive(Clone, Debug, Serialize)]
pub struct RefusedScheme {
    /// The scheme.
    pub scheme: Scheme,
    /// The reason.
    pub why: Note,
}

impl Work {
    /// The chosen transition.
    pub fn transition(&self) -> Option<&Transition> {
        let taken = self.taken?;
        self.transitions.iter().find(|one| one.scheme == taken)
    }
}

/// The zones of a side, with the clearing of each.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn zones(
    layers: &Layers,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Vec<ZoneWork>, KnowledgeError> {
    let knowledge = bench.knowledge;
    let candidates = tools::candidates(layers.rough.side, Stage::Roughing, bench)?;
    let angles: Vec<_> = candidates.iter().map(|tool| tools::angles(tool, knowledge)).collect::<Result<_, _>>()?;
    let near_part = BlankShape::of(bench.workpiece.blank.kind) == BlankShape::NearPart;
    let find = |ground: &ZoneContours| {
        let stock = zones::Stock { rough: &ground.rough, blank: &ground.blank, near_part, against_stop: false };
        zones::find(stock, &angles, knowledge)
    };
    // The chosen tools give the nose for offsetting the contours; the zones are those of the offset contours.
    let bare = ZoneContours { rough: layers.rough.clone(), blank: layers.blank.clone() };
    let first = tools::most_used(&tools::assign(&find(&bare)?, &angles)).and_then(|index| candidates.get(index));
    let seen = first.map(|tool| bare.seen(tool, findings));
    let usual = seen.as_ref().unwrap_or(&bare);
    let zones = find(usual)?;
    let taken = tools::assign(&zones, &angles);
    let mut works: Vec<ZoneWork> = Vec::new();
    for (zone, choice) in zones.iter().zip(&taken) {
        let tool = choice.and_then(|index| candidates.get(index));
        let count = taken.iter().filter(|other| *other == choice).count();
        let other = tool.filter(|tool| first.map(tools::nose) != Some(tools::nose(tool)));
        let own = other.map(|tool| bare.seen(tool, findings));
        let ground = own.as_ref().unwrap_or(usual);
        let mut work = zone_work(zone, tool, count, &angles, ground, bench, findings)?;
        if let Some(before) = works.iter().find(|before| !before.is_cleared()) {
            let note = Note::new("zone-behind-standing").with("zone", zone.number).with("before", before.zone.number);
            findings.push(Finding::of_part(Severity::Error, note));
            work.works.iter_mut().for_each(|work| work.taken = None);
        }
        works.push(work);
    }
    Ok(works)
}

/// A finding for each scheme that leaves a rougher surface than the part requires, so that finishing must follow.
///
/// # Errors
/// The knowledge base lacks the table of schemes.
pub fn finishing_after(
    zones: &[ZoneWork],
    profile: &Profile,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<(), KnowledgeError> {
    let Some(finest) = profile.surfaces.iter().filter_map(|surface| surface.roughness).min() else { return Ok(()) };
    for scheme in zones.iter().flat_map(|zone| &zone.works).filter_map(|work| work.taken) {
        findings.extend(transitions::finishing_must_follow(scheme, finest, bench.knowledge)?);
    }
    Ok(())
}

/// A hollow under the main contour that is no groove, and its clearing with a tool whose secondary edge is steeper.
#[derive(Clone, Debug, Serialize)]
pub struct Hollow {
    /// Its lips, Z from the free end.
    #[serde(skip)]
    pub lips: (Half, Half),
    /// Its surfaces, by index in the profile.
    #[serde(skip)]
    pub surfaces: Vec<usize>,
    /// The contours of the side with this hollow opened.
    #[serde(skip)]
    pub layers: Layers,
    /// Its pieces.
    #[serde(skip)]
    pub under: Vec<Piece>,
    /// Its zones; empty if a blade must cut it.
    pub zones: Vec<ZoneWork>,
    /// Why no turning tool cuts it.
    #[serde(skip)]
    pub lacking: Vec<Finding>,
}

/// The hollows of a side, in the order of Z. Grooves are cut by blades elsewhere; metal that no tool reaches is a
/// finding.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn hollows(
    stretch: &TurnedSide,
    set_up: &SetUp,
    outside: &Layers,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Vec<Hollow>, KnowledgeError> {
    let mut hollows: Vec<Hollow> = Vec::new();
    for valley in stretch.main.valleys.iter().filter(|valley| !valley.open) {
        let groove = |index: &usize| {
            let surface = stretch.profile.surfaces.get(*index);
            surface.is_some_and(|surface| surface.kind.is_additional())
        };
        if valley.surfaces.iter().any(groove) {
            continue;
        }
        let Some(contour) = opened(&stretch.main, valley).filter(Contour::is_monotone) else { continue };
        let main = Main { contour, valleys: Vec::new() };
        let stretch = TurnedSide { main, ..stretch.clone() };
        let mut found = Vec::new();
        let Some(layers) = layers::layers(&stretch, set_up, layers::Before::default(), bench, &mut found)? else {
            findings.extend(found);
            continue;
        };
        let ground = Layers { blank: outside.rough.clone(), ..layers.clone() };
        let mut zones = zones(&ground, bench, &mut found)?;
        let mut lacking = Vec::new();
        if zones.iter().all(ZoneWork::is_cleared) {
            findings.extend(found);
        } else {
            (zones, lacking) = (Vec::new(), found);
        }
        let (lips, under) = ((valley.lips.0.z, valley.lips.1.z), valley.under.clone());
        hollows.push(Hollow { lips, surfaces: valley.surfaces.clone(), layers, under, zones, lacking });
    }
    Ok(hollows)
}

/// The main contour with the part instead of a bridge, which may be one line with its neighbours.
fn opened(main: &Main, valley: &Valley) -> Option<Contour> {
    let contour = &main.contour;
    let mut pieces =
        if contour.start()? == valley.lips.0 { Vec::new() } else { cut(contour, contour.start()?, valley.lips.0) };
    pieces.extend(&valley.under);
    if contour.end()? != valley.lips.1 {
        pieces.extend(cut(contour, valley.lips.1, contour.end()?));
    }
    let opened = Contour { side: contour.side, pieces };
    opened.hangs_together().then_some(opened)
}
