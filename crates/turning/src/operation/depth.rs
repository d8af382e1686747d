//! The depth of passes and their conditions: as given, or by tool and lathe (lecture 12.4, l. 614-626).

use serde::Serialize;

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::note::{Because, Figure, Finding, Note, Severity};
use crate::tables::practice::RoughOrFinish;
use crate::tables::turning::part::TurningSkinFor;
use crate::turning::cutting::{
    Bound, CuttingRefusal, Direction, Flexibility, LimitingDepth, Speed, TurningConditions, TurningCut, bar_reaches,
    conditions, least_sensible_depth, limiting_depth, rough_feed, within_part,
};
use crate::turning::length::Half;
use crate::turning::schemes::rates;
use crate::turning::shaft;
use crate::turning::tooling::TurningTool;
use crate::turning::transitions::Feeds;
use crate::units::{Micrometres, MillimetresPerMinute, MillimetresPerRev, RevsPerMinute, Roughness, round_to};

use super::tools::Bench;

/// The depth of the passes over a zone.
#[derive(Clone, Debug, Serialize)]
pub struct Depth {
    /// The limiting depth t_lim, mm: the most that one pass may remove. The passes use t_p of each work.
    pub limiting_depth_mm: Half,
    /// Whether the file gives it.
    pub given: bool,
    /// Its calculation, if it was not given. Tool and lathe may bear more at the feed for this depth.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<LimitingDepth>,
}

/// Feeds and speeds of the tool over a zone.
#[derive(Clone, Debug, Serialize)]
pub struct Pace {
    /// Feed, speed, spindle step and loads at the depth of the passes, if a lathe is named.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub conditions: Option<TurningConditions>,
    /// Rates of all motions.
    pub feeds: Feeds,
    /// δ, mm.
    pub approach_mm: Half,
    /// The retract of the tool, mm.
    pub retract_mm: Half,
}

impl Pace {
    /// What its passes exceed.
    pub fn exceeded(&self) -> Vec<Bound> {
        self.conditions.as_ref().map(exceeded).unwrap_or_default()
    }
}

/// What conditions exceed; the grip of the jaws is a finding of the set-up.
fn exceeded(conditions: &TurningConditions) -> Vec<Bound> {
    conditions.exceeded.iter().copied().filter(|bound| !matches!(bound, Bound::Grip | Bound::Tipping)).collect()
}

/// The cut over a zone.
#[derive(Clone, Copy, Debug)]
pub struct ZoneCut<'a, 'k> {
    /// The tool.
    pub tool: &'a TurningTool<'k>,
    /// The largest diameter that is cut.
    pub diameter: Micrometres,
    /// The direction of the feed.
    pub direction: Direction,
    /// The most stock over the zone, radial, or axial before a face.
    pub stock: Half,
    /// The depth of the cut in a bore; none outside.
    pub bore_depth: Option<Micrometres>,
    /// Z where it begins, before the finished face on the stock that stands there.
    pub begins: Half,
    /// The deflection of the part there.
    pub part: Option<&'a Flexibility>,
    /// The spindle speed of the pass that it is a part of; none for a cut of its own.
    pub spindle_most: Option<RevsPerMinute>,
}

/// The limiting depth of a zone; none, with a finding, if no source gives it.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn depth(
    task: ZoneCut<'_, '_>,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Option<Depth>, KnowledgeError> {
    if let Some(given) = bench.workpiece.roughing.limiting_depth {
        return Ok(Some(Depth { limiting_depth_mm: Half::of(given), given: true, limit: None }));
    }
    let Some((cut, skin)) = cut(task, bench)? else {
        findings.push(Finding::of_part(Severity::Error, CuttingRefusal::NoLimitingDepth.note()));
        return Ok(None);
    };
    let mut found = Refusal::split(sensible(&cut, task.stock))?;
    // What a chuck holds is no figure of its own record: it makes passes as shallow as roughing is, but never forbids them.
    let least = Half::of(least_sensible_depth(bench.knowledge)?);
    if cut.grip.is_some() && found.as_ref().map_or(true, |(_, depth)| *depth < least) {
        let freely = Refusal::split(sensible(&TurningCut { grip: None, ..cut }, task.stock))?;
        found = freely.map(|(limit, depth)| (limit, depth.min(least)));
    }
    match found {
        Ok((mut limit, depth)) => {
            limit.because.push(skin);
            findings.extend(limit.findings());
            if let Some((finding, because)) = asks(&limit, task.stock, bench)? {
                findings.push(finding);
                limit.because.push(because);
            }
            if depth <= Half::ZERO {
                let note = Note::new("no-depth-allowed").with("tool", task.tool.designation);
                let note = note.with("bound", Figure::word(limit.decided_by.name()));
                findings.push(Finding::of_part(Severity::Error, note));
                return Ok(None);
            }
            Ok(Some(Depth { limiting_depth_mm: depth, given: false, limit: Some(limit) }))
        }
        Err(why) => {
            findings.push(Finding::of_part(Severity::Error, why.note()));
            Ok(None)
        }
    }
}

/// The required support, where the deflection of the part leaves no useful depth of the stock.
///
/// # Errors
/// The knowledge base lacks a table.
fn asks(
    limit: &LimitingDepth,
    stock: Half,
    bench: &Bench<'_, '_>,
) -> Result<Option<(Finding, Because)>, KnowledgeError> {
    let Some(held) = &bench.held else { return Ok(None) };
    let bends = matches!(limit.decided_by, Bound::PartStiffness | Bound::PartStrength);
    let least = Half::of(least_sensible_depth(bench.knowledge)?).min(stock);
    let shallow = bends && limit.depth_mm.is_none_or(|depth| Half::of(depth) < least);
    shallow.then(|| held.asks(limit.depth_mm, bench.knowledge)).transpose()
}

/// The most passes into which the search divides the stock.
const MOST_PASSES: i64 = 60;

/// The most that one pass may remove, at the feed of the table; where the part bends so far or is so weak that this is no sensible
/// depth of roughing, a sensible one at a smaller feed, if the part bears one: that with the least feeding over the stock.
fn sensible(cut: &TurningCut<'_, '_>, stock: Half) -> Tried<(LimitingDepth, Half), CuttingRefusal> {
    let usual = limit(cut, stock);
    let Ok((limit, depth)) = &usual else { return usual };
    let least = Half::of(least_sensible_depth(cut.knowledge)?).min(stock);
    let of_part = matches!(limit.decided_by, Bound::PartStiffness | Bound::PartStrength);
    if *depth >= least || !of_part {
        return usual;
    }
    let mut best: Option<(f64, (LimitingDepth, Half))> = None;
    for passes in 1..=MOST_PASSES {
        let depth = stock.part(passes);
        // One division may be a little shallower: between the two no pass may be borne.
        if passes > 1 && stock.part(passes - 1) < least {
            break;
        }
        let whole = depth.rounded_up();
        let Ok(table) = Refusal::split(rough_feed(cut, whole))? else { continue };
        let feed = within_part(cut, whole, table.feed, RoughOrFinish::Rough, &mut Vec::new())?;
        let limit = bearable(cut, feed, depth)?;
        let turns = passes as f64 / feed.0;
        let bears = limit.depth_mm.is_some_and(|most| Half::of(most) >= depth);
        if bears && best.as_ref().is_none_or(|(known, _)| turns < *known) {
            best = Some((turns, (limit, depth)));
        }
    }
    best.map_or(usual, |(_, found)| Ok(found))
}

/// The most that one pass may remove at the feed of the passes.
///
/// The feed depends on the depth. So the stock is divided into one, two, three… passes until there is a feed for
/// their depth and tool and lathe can bear it. The limit is the depth that they can bear at that feed, as long as the
/// table has that feed for it: deeper passes have another feed. The number of passes at which the search ends is the
/// least that the limit permits.
fn limit(cut: &TurningCut<'_, '_>, stock: Half) -> Tried<(LimitingDepth, Half), CuttingRefusal> {
    bar_reaches(cut)?;
    let mut first: Option<Tried<LimitingDepth, CuttingRefusal>> = None;
    for passes in 1..=MOST_PASSES {
        let depth = stock.part(passes);
        let whole = depth.rounded_up();
        match rough_feed(cut, whole).and_then(|feed| bearable(cut, feed.feed, depth)) {
            Err(Refusal::Knowledge(error)) => return Err(Refusal::Knowledge(error)),
            Ok(limit) if limit.depth_mm.is_some_and(|most| Half::of(most) >= depth) => {
                let most = limit.depth_mm.unwrap_or(whole);
                // One pass takes the whole stock, so no deeper pass is needed.
                let most = if passes == 1 { most } else { of_one_feed(cut, limit.feed_mm_per_rev, whole, most)? };
                return Ok((limit, Half::of(most).max(depth)));
            }
            other => {
                first.get_or_insert(other);
            }
        }
    }
    match first {
        Some(Ok(limit)) => Ok((LimitingDepth { depth_mm: None, ..limit }, Half::ZERO)),
        Some(Err(refusal)) => Err(refusal),
        None => Err(Refusal::Not(CuttingRefusal::NoLimitingDepth)),
    }
}

/// The depth that tool and lathe can bear at a feed: at the speed of the tool life if that is enough for a depth,
/// otherwise at the slower speed that the spindle power requires. One more pass takes less time than all passes at a
/// slower spindle.
fn bearable(cut: &TurningCut<'_, '_>, feed: MillimetresPerRev, depth: Half) -> Tried<LimitingDepth, CuttingRefusal> {
    let quick = limiting_depth(cut, feed, Speed::ForToolLife)?;
    if quick.depth_mm.is_some_and(|limit| Half::of(limit) >= depth) {
        return Ok(quick);
    }
    limiting_depth(cut, feed, Speed::WithinPower)
}

/// The largest depth up to a limit that still has the feed of a smaller depth, downwards from the limit in tenths of a
/// millimetre.
fn of_one_feed(
    cut: &TurningCut<'_, '_>,
    feed: MillimetresPerRev,
    depth: Micrometres,
    limit: Micrometres,
) -> Tried<Micrometres, CuttingRefusal> {
    let mut deepest = limit;
    while deepest > depth {
        match Refusal::split(rough_feed(cut, deepest))? {
            Ok(rough) if rough.feed == feed => return Ok(deepest),
            _ => deepest = deepest - Micrometres::new(100),
        }
    }
    Ok(depth)
}

/// The cut, with the skin of the blank by the rule `turning-skin` and its row; none without a lathe.
fn cut<'a, 'k>(
    task: ZoneCut<'a, 'k>,
    bench: &'a Bench<'_, 'k>,
) -> Result<Option<(TurningCut<'a, 'k>, Because)>, KnowledgeError> {
    let Some(cut) = bench.cut(task.tool, task.diameter, task.direction) else { return Ok(None) };
    let stock = bench.workpiece.blank.kind;
    let asked = bench.knowledge.ask(&TurningSkinFor { stock, group: bench.material.group })?;
    let surface = asked.need(stock.name())?.surface;
    let note = Note::new("turning-skin").with("kind", Figure::word(stock.name())).with("surface", surface.name());
    let because = Because::answer(&asked.answer, note);
    let ZoneCut { bore_depth, part, spindle_most, .. } = task;
    let stands_out = (Half::ZERO - task.begins).max(Half::ZERO);
    let cut = TurningCut { surface, bore_depth, part, grip: bench.grip.as_ref(), stands_out, spindle_most, ..cut };
    Ok(Some((cut, because)))
}

/// Rates and distances at a depth of passes, for finishing with the roughness that the pass must leave.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn pace(
    task: ZoneCut<'_, '_>,
    depth: Half,
    roughness: Option<Roughness>,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Pace, KnowledgeError> {
    let conditions = found(task, depth, roughness, bench, findings)?;
    with_rates(task.direction, conditions, bench, findings)
}

/// The conditions at a depth of passes; none without a lathe, and, with a finding, where the tables have none.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn found(
    task: ZoneCut<'_, '_>,
    depth: Half,
    roughness: Option<Roughness>,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Option<TurningConditions>, KnowledgeError> {
    let Some((cut, skin)) = cut(task, bench)? else { return Ok(None) };
    match Refusal::split(conditions(&cut, depth.rounded_up(), roughness))? {
        Ok(mut conditions) => {
            conditions.because.push(skin);
            findings.extend(conditions.findings());
            let exceeded = exceeded(&conditions);
            let of_tool = |code| Note::new(code).with("tool", task.tool.designation).with("depth", depth);
            let is_short = bench.held.as_ref().map_or(Ok(false), |held| held.is_short(bench.knowledge))?;
            match (&exceeded[..], conditions.gives_way) {
                ([], _) => {}
                ([Bound::PartStiffness], Some(share)) if is_short => {
                    let note = of_tool("part-gives-way").with("percent", round_to(100.0 * share, 0));
                    findings.push(Finding::of_part(Severity::Doubtful, note));
                }
                _ => {
                    let note = of_tool("bounds-exceeded").with("bounds", Bound::list(&exceeded));
                    findings.push(Finding::of_part(Severity::Wrong, note));
                }
            }
            Ok(Some(conditions))
        }
        Err(why) => {
            findings.push(Finding::of_part(Severity::Doubtful, why.note()));
            Ok(None)
        }
    }
}

/// Rates and distances: from the file, otherwise from the conditions, otherwise from the table `turning-motion`. A motion for
/// which the file has no rate goes at the main feed, and a finding says so.
///
/// # Errors
/// The knowledge base lacks a table.
pub fn with_rates(
    direction: Direction,
    conditions: Option<TurningConditions>,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Pace, KnowledgeError> {
    let given = bench.workpiece.rates;
    let (table, unconfirmed) = rates::of_table(bench.knowledge)?;
    let shaft::Rates { longitudinal_feed, transverse_feed, rapid, approach, retract } = match given {
        Some(given) => given.main,
        None => {
            if conditions.is_none() {
                findings.extend(unconfirmed);
            }
            shaft::Rates { rapid: bench.lathe.map_or(table.rapid, |lathe| lathe.rapid_z), ..table }
        }
    };
    let stated = match direction {
        Direction::Longitudinal => longitudinal_feed,
        Direction::Transverse => transverse_feed,
    };
    let calculated = conditions.as_ref().map(|calculated| calculated.feed_mm_per_min).filter(|_| given.is_none());
    let main = calculated.unwrap_or(stated);
    let other = |rate: Option<MillimetresPerMinute>| rate.unwrap_or(main);
    let rate = |of: fn(&crate::turning::workpiece::Rates) -> Option<MillimetresPerMinute>| given.as_ref().and_then(of);
    let (infeed, pick_up) = (rate(|rates| rates.infeed), rate(|rates| rates.pick_up_feed));
    let (semi_finish, finish) = (rate(|rates| rates.semi_finishing_feed), rate(|rates| rates.finishing_feed));
    let named = [("infeed", infeed), ("pick_up_feed", pick_up), ("semi_finishing_feed", semi_finish)];
    let lacking: Vec<&str> = named.iter().filter(|(_, rate)| rate.is_none()).map(|(name, _)| *name).collect();
    if !lacking.is_empty() {
        let feeds = Figure::list(lacking.into_iter().map(|name| Figure::word_of("rate", name)));
        let note = Note::new("one-feed-for-all").with("feeds", feeds);
        findings.push(Finding::of_part(Severity::Note, note));
    }
    let feeds = Feeds {
        main,
        infeed: other(infeed),
        pick_up: other(pick_up),
        semi_finish: other(semi_finish),
        finish: other(finish),
        rapid,
    };
    Ok(Pace { conditions, feeds, approach_mm: Half::of(approach), retract_mm: Half::of(retract) })
}
