//! Opening a hole with an end mill that moves in circles.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::Question;
use crate::note::{Because, Note};
use crate::plan;
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::tables::cutting::{
    Coefficients, EndMillFeedFor, Mill, MillingDepth, MillingFinishFeedFor, MillingSpeedFor, MillingStep,
    MillingToolLifeFor, Process,
};
use crate::tables::rules::{MillingFinishRoundFor, PlungeFeedFor, ToolLifeBeyondFor};
use crate::units::{MetresPerMinute, Micrometres, MillimetresPerRev, MillimetresPerTooth, Minutes, round_to};

use super::figures::{self, missing};
use super::milling_force::{self, MilledPass};
use super::{AnotherFeed, Cut, CutMotion, CutterShape, DraftConditions, Loads, factors, slotting};

/// The kind of mill in the milling tables: a solid end mill.
const MILL: Mill = Mill::End;

/// Conditions of milling a hole along circles (Косилова/Мещеряков т.2; facts 1.9).
///
/// - V = Cv·D^q / (T^m·t^x·sz^y·B^u·z^p)·Kv, m/min, with Kv = Kmv·Kpv;
/// - the torque is that of [`milling_force`]; no thrust is known;
/// - D is the mill's diameter, t the radial depth of one pass, B the axial depth of one level, all in mm;
///   sz in mm/tooth, T in min, z the number of teeth.
///
/// sz applies where the teeth meet the wall. The centre of the mill moves on a smaller circle than the wall, so its
/// feed is smaller too: s = sz·z·(d1 - D)/d1, mm/rev, with d1 the diameter after the first and narrowest pass; all
/// passes use it.
pub(super) fn draft(cut: &Cut, taken: Option<MillimetresPerRev>, shop: &Shop<'_>) -> Tried<DraftConditions, Uncut> {
    let whole = |mill: &CutterShape| {
        mill.teeth > 0 && mill.diameter > Micrometres::ZERO && mill.cutting_length > Micrometres::ZERO
    };
    let mill = cut.cutter.filter(whole).ok_or(Refusal::Not(Uncut::NoCutterShape))?;
    // In a slot it makes its way itself.
    if cut.slot.is_none() && mill.diameter >= cut.from {
        return Err(Refusal::Not(Uncut::MillDoesNotEnter { diameter: mill.diameter, hole: cut.from }));
    }
    let (tabulated, reasons) = feed_per_tooth(cut, mill, shop)?;
    let (rounds, mut because) = match cut.slot {
        Some(slot) => {
            let tooth_feed = taken.map_or(tabulated, |feed| feed.0 / f64::from(mill.teeth));
            slotting::rounds(cut, mill, slot, tooth_feed, shop)?
        }
        None => rounds(cut, mill, shop)?,
    };
    because.extend(reasons);
    // Centre feed per revolution over feed per tooth at the wall.
    let ratio = f64::from(mill.teeth) * rounds.centre_share;
    let tooth_feed = taken.map_or(tabulated, |feed| feed.0 / ratio);
    let (life, reasons) = tool_life(cut, mill, shop)?;
    because.extend(reasons);

    let (d, z) = (mill.diameter.to_mm(), f64::from(mill.teeth));
    let (t, b) = (rounds.radial_depth, rounds.axial_depth);
    let (tool_material, feed_per_tooth) = (cut.tool_material, MillimetresPerTooth(tooth_feed));
    let question = |material_group| MillingSpeedFor { mill: MILL, material_group, tool_material, feed_per_tooth };
    let figures = figures::ask(question, shop)?;
    let row = &figures.row;
    because.extend(figures.because(Note::new("speed-coefficients").with("cv", row.cv)));
    let mut speed = row.cv * libm::pow(d, row.q)
        / (libm::pow(life.0, row.m)
            * libm::pow(t, row.x)
            * libm::pow(tooth_feed, row.y)
            * libm::pow(b, row.u)
            * libm::pow(z, row.p));
    let life_exponent = row.m;
    let mut corrections = vec![factors::surface(cut.surface, shop)?];
    if figures.is_own_group() {
        corrections.push(factors::material_speed(Process::Milling, tool_material, shop)?);
    }
    for (factor, reason) in corrections {
        speed *= factor;
        because.push(reason);
    }

    let mut loads = Loads::default();
    // Without figures of forces the pass is cut all the same; its torque is left out, not guessed.
    let pass =
        MilledPass { mill: MILL, tool_material, shape: mill, radial_depth: t, axial_depth: b, feed_ratio: ratio };
    if let Some((torque, reasons)) = milling_force::torque(&pass, shop)? {
        loads.torque = Some(torque);
        because.extend(reasons);
    }
    Ok(DraftConditions {
        feed: MillimetresPerRev(tooth_feed * ratio),
        speed: MetresPerMinute(speed),
        fastest: None,
        tool_life: life,
        life_exponent,
        coolant: None,
        loads,
        motion: CutMotion { turned: mill.diameter, depth_of_cut: t, path: rounds.path, synchronous: false },
        because,
        doubts: Vec::new(),
        card: None,
        rounds: Some(rounds.planned),
        plunge: rounds.plunge,
        arcs: rounds.arcs,
    })
}

/// The circles of one hole, or the ways of a mill in one slot.
pub(super) struct Rounds {
    /// t, radial depth of one pass, mm.
    pub radial_depth: f64,
    /// B, axial depth of one level, mm.
    pub axial_depth: f64,
    /// Radius of the centre's first circle over that of the wall; 1 along a slot.
    pub centre_share: f64,
    /// Length of all moves at the working feed, mm.
    pub path: f64,
    /// The same, as in the plan.
    pub planned: plan::Rounds,
    pub plunge: Option<AnotherFeed>,
    pub arcs: Vec<AnotherFeed>,
}

/// Divides the stock into radial passes and axial levels (table `milling-depth`), and measures the path.
///
/// A cylinder of a fine grade has one pass more, of the little stock that the rule `milling-finish-round` leaves.
///
/// 1. approach and descent along the hole's axis, `travel` in all;
/// 2. at each level and for each pass: out from the axis to the circle, radius (di - D)/2;
/// 3. once round, π·(di - D);
/// 4. back to the axis.
///
/// A mill that cuts on its way down is fed there by a share of the feed at the wall (rule `plunge-feed`); its descent is then not
/// part of the path.
fn rounds(cut: &Cut, mill: CutterShape, shop: &Shop<'_>) -> Result<(Rounds, Vec<Because>), KnowledgeError> {
    let step = |step: MillingStep| shop.knowledge.need(step.name(), |row: &MillingDepth<'_>| row.name == step);
    let d = mill.diameter.to_mm();
    let (radial, axial) = (step(MillingStep::Radial)?, step(MillingStep::Axial)?);
    let stock = (cut.diameter - cut.from).to_mm() / 2.0;
    // What finishes the cylinder to a fine grade takes little: the spring of the mill goes with its stock.
    let finish = match cut.it.zip(cut.roughness) {
        Some((it, roughness)) => {
            Some(shop.knowledge.ask(&MillingFinishRoundFor { it, roughness })?.need(&format!("IT {it}"))?)
        }
        None => None,
    };
    let last = finish.as_ref().map_or(0.0, |row| row.stock.to_mm());
    let last = if last < stock { last } else { 0.0 };
    let roughing = parts(stock - last, radial.share * d).max(cut.passes);
    let passes = roughing + u32::from(last > 0.0);
    let deepest = mill.cutting_length.to_mm().min(axial.share * d);
    let levels = parts(cut.depth.to_mm(), deepest);
    let radial_depth = (stock - last) / f64::from(roughing);
    let rough: f64 = (1..=roughing).map(|pass| cut.from.to_mm() + 2.0 * radial_depth * f64::from(pass) - d).sum();
    let circles = rough + if last > 0.0 { cut.diameter.to_mm() - d } else { 0.0 };
    let first = cut.from.to_mm() + 2.0 * radial_depth;
    let axial_depth = cut.depth.to_mm() / f64::from(levels);
    let centre_share = (first - d) / first;
    let (mut plunge, mut because) = (None, Vec::new());
    if cut.plunges {
        let material_group = shop.material.group;
        let row = shop.knowledge.ask(&PlungeFeedFor { material_group })?.need(material_group)?;
        plunge = Some(AnotherFeed { share: row.share / centre_share, travel: cut.travel.to_mm() });
        because.push(Because::row(row.row, Note::new("plunge-feed").with("percent", round_to(row.share * 100.0, 0))));
    }
    let across = f64::from(levels) * circles * (std::f64::consts::PI + 1.0);
    let whole = across + cut.travel.to_mm();
    let path = if plunge.is_some() { across } else { whole };
    let note = Note::new("milling-rounds")
        .with("passes", passes)
        .with("levels", levels)
        .with("t", round_to(radial_depth, 3))
        .with("b", round_to(axial_depth, 3))
        .with("path", round_to(whole, 1))
        .with("factor", round_to(centre_share, 3));
    because.insert(0, Because::row(radial.row, note));
    if let Some(row) = finish.filter(|_| last > 0.0) {
        because.push(Because::row(row.row, Note::new("milling-finish-round").with("stock", row.stock)));
    }
    let planned = plan::Rounds {
        from_diameter_mm: cut.from,
        mill_diameter_mm: mill.diameter,
        passes,
        levels,
        finish_mm: (last > 0.0).then(|| Micrometres::from_mm_rounded(last)),
        plunge_feed_mm_per_min: None,
        arc_feed_mm_per_min: None,
        along_middle: false,
    };
    Ok((Rounds { radial_depth, axial_depth, centre_share, path, planned, plunge, arcs: Vec::new() }, because))
}

/// The number of equal parts, at least one, of a length, so that none is longer than `longest`.
pub(super) fn parts(length: f64, longest: f64) -> u32 {
    // A micrometre of slack, so that 10 mm in steps of 5 are two parts whatever the last bit.
    libm::ceil((length - 0.001) / longest).max(1.0) as u32
}

/// sz by the mill's diameter (table `end-mill-feed`); for the last pass less, by the required roughness (table
/// `milling-finish-feed`).
fn feed_per_tooth(cut: &Cut, mill: CutterShape, shop: &Shop<'_>) -> Tried<(f64, Vec<Because>), Uncut> {
    let diameter = mill.diameter;
    let figures = figures::ask(|material_group| EndMillFeedFor { material_group, diameter }, shop)?;
    let mut feed = figures.row.feed_per_tooth.0;
    let mut because = figures.because(Note::new("feed-per-tooth").with("feed", feed));
    if let Some(roughness) = cut.roughness {
        let answer = shop.knowledge.ask(&MillingFinishFeedFor { roughness })?;
        let row = answer.winner()?.ok_or_else(|| missing(MillingFinishFeedFor::TABLE, shop))?;
        feed *= row.factor;
        let note = Note::new("milling-finish-feed").with("factor", row.factor).with("roughness", roughness);
        because.push(Because::row(row.row, note));
    }
    Ok((feed, because))
}

/// T of an end mill (table `milling-tool-life`), beyond it by `tool-life-beyond`.
fn tool_life(cut: &Cut, mill: CutterShape, shop: &Shop<'_>) -> Tried<(Minutes, Vec<Because>), Uncut> {
    let (tool_material, diameter) = (cut.tool_material, mill.diameter);
    if let Some(row) = shop.knowledge.ask(&MillingToolLifeFor { mill: MILL, diameter })?.winner()? {
        return Ok((row.life, vec![Because::row(row.row, factors::tool_life_text(row.life))]));
    }
    let operation = Coefficients::Mill;
    let question = |material_group| ToolLifeBeyondFor { operation, material_group, tool_material, diameter };
    let figures = figures::ask(question, shop)?;
    let life = figures.row.life;
    Ok((life, figures.because(factors::tool_life_text(life))))
}
