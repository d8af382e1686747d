//! The clearing of a zone: its tool and depth, the levels of its parts, the schemes over each, and the chosen one.

use super::depth::{self, Pace, ZoneCut};
use super::pocket::pieceworks;
use super::tools::{self, Bench};
use super::work::{RefusedScheme, Work, ZoneWork};
use crate::error::{KnowledgeError, Refusal};
use crate::note::{Figure, Finding, Note, Severity};
use crate::turning::allowances::equidistant;
use crate::turning::contour::{Contour, Side};
use crate::turning::cutting::{Bound, Direction, cuts_back, least_sensible_depth};
use crate::turning::length::Half;
use crate::turning::nose::up_to;
use crate::turning::point::Point;
use crate::turning::tooling::TurningTool;
use crate::turning::transitions::check::{MOST_PASSES, Unsuited};
use crate::turning::transitions::measures::best;
use crate::turning::transitions::split::Split;
use crate::turning::transitions::{self, PreparedZone, Scheme, Settings, Stock, Transition};
use crate::turning::zones::{self, Feed, Zone, fit, idle_returns};
use crate::units::{Degrees, Micrometres};

/// The contours that bound the stock of a zone.
#[derive(Clone, Debug)]
pub(super) struct ZoneContours {
    pub rough: Contour,
    pub blank: Contour,
}

impl ZoneContours {
    /// Both as the nose of a tool meets them. If a contour has no such offset, it stays unchanged, with a finding.
    pub fn seen(&self, tool: &TurningTool<'_>, findings: &mut Vec<Finding>) -> Self {
        let nose = tools::nose(tool);
        let mut seen = |contour: &Contour| {
            nose.seen(contour).unwrap_or_else(|error| {
                let note = Note::new("no-contour-of-nose").with("tool", tool.designation).with("why", error);
                findings.push(Finding::of_part(Severity::Wrong, note));
                contour.clone()
            })
        };
        let nearest = self.rough.narrowest().and_then(|bore| tools::nearest_to_axis(tool, bore));
        Self { rough: up_to(seen(&self.rough), nearest), blank: seen(&self.blank) }
    }
}

#[allow(clippy::too_many_arguments, reason = "a zone, its tool, and where both stand")]
pub(super) fn zone_work(
    zone: &Zone,
    tool: Option<&TurningTool<'_>>,
    count: usize,
    angles: &[zones::ToolAngles],
    ground: &ZoneContours,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<ZoneWork, KnowledgeError> {
    let held = fit(zone, angles);
    let mut work =
        ZoneWork { zone: zone.clone(), fit: held, tool: None, depth: None, works: Vec::new(), returns: None };
    let Some(tool) = tool else {
        let least = angles.iter().filter_map(|tool| tool.least_bore).min();
        let narrow = least.zip(zone.passage).filter(|(least, passage)| least > passage);
        let note = match narrow {
            Some((least, bore)) => Note::new("no-bar-for-bore").with("least", least).with("bore", bore),
            None => Note::new("no-tool-for-zone")
                .with("side", ground.rough.side.name())
                .with("main", zone.needs.main.0)
                .with("secondary", zone.needs.secondary.0),
        };
        let note = note.with("zone", zone.number);
        findings.push(Finding::of_part(Severity::Error, note));
        return Ok(work);
    };
    work.tool = Some(tools::chosen(tool, count, bench)?);
    let (direction, mut stocks) = match zone.feed {
        Feed::Across => (Direction::Transverse, vec![(facing(zone, ground, Overrun::default()), 0)]),
        Feed::Along => {
            let least = Half::of(least_sensible_depth(bench.knowledge)?);
            let all = pieceworks(zone, &ground.rough, &ground.blank, least).into_iter();
            (Direction::Longitudinal, all.map(|one| (one.stock, one.scheme)).collect())
        }
    };
    let diameter = zone.greatest_radius.diameter();
    let stock = match zone.feed {
        Feed::Across => zone.to_z - zone.from_z,
        Feed::Along => zone.greatest_radius - zone.least_radius,
    };
    let bore_depth = (ground.rough.side == Side::Inner).then(|| zone.to_z.rounded_up());
    let part = bench.held.as_ref().map(|held| held.over(zone.from_z, zone.to_z, None));
    let (begins, part) = (zone.from_z, part.as_ref());
    let task = ZoneCut { tool, diameter, direction, stock, bore_depth, begins, part, spindle_most: None };
    work.depth = depth::depth(task, bench, findings)?;
    let Some(limit) = work.depth.as_ref().map(|depth| depth.limiting_depth_mm) else { return Ok(work) };
    // Checked before the levels are made, because they might not fit into memory.
    let passes = stock.parts(limit);
    if passes > MOST_PASSES {
        let note = Unsuited::TooManyPasses { passes, most: MOST_PASSES }.note().with("zone", zone.number);
        findings.push(Finding::of_part(Severity::Error, note));
        return Ok(work);
    }
    if zone.feed == Feed::Across {
        let hollow = bench.workpiece.blank.inner.is_some();
        stocks = vec![(facing(zone, ground, Overrun::of(tool, limit.min(stock), hollow)), 0)];
    }
    let mut left: Option<Contour> = None;
    for (mut stock, scheme) in stocks {
        // This work begins with the stock after the previous one, ridges included.
        if let Some(left) = left.take() {
            stock.blank = left;
        }
        let done = clear(stock, scheme, limit, zone, task, bench, findings)?;
        left = done.left;
        work.works.push(done.work);
    }
    let deepest = work.works.iter().map(|work| work.levels.depth).max();
    let joined = zone.feed == Feed::Along && zone.parts.len() > 1;
    work.returns = deepest.filter(|_| joined).map(|depth| idle_returns(zone, depth));
    Ok(work)
}

/// The stock before the face of the free end: all of it is removed, down to the part. The tool goes as far as the
/// face of the blank, offset for its nose: beyond the axis if the face reaches it, and by the overrun.
fn facing(zone: &Zone, ground: &ZoneContours, overrun: Overrun) -> Stock {
    let (from, to) = (zone.from_z, zone.to_z);
    let at = |radius, z| Point { radius, z };
    let high = zone.greatest_radius;
    let low = ground.blank.start().map_or(zone.least_radius, |start| start.radius.min(zone.least_radius));
    let low = if low < Half::ZERO { low.min(Half::ZERO - overrun.past_axis) } else { low - overrun.into_bore };
    let side = ground.rough.side;
    Stock {
        rough: Contour::through(side, &[at(low, from), at(low, to), at(high, to)]),
        blank: Contour::through(side, &[at(high, from), at(high, to)]),
        from,
        to,
    }
}

/// The overrun of a tool that faces, so that its secondary edge, which cuts a face of some depth, leaves no pip on the axis and no
/// ring around a bore.
#[derive(Clone, Copy, Default)]
struct Overrun {
    past_axis: Half,
    into_bore: Half,
}

impl Overrun {
    fn of(tool: &TurningTool<'_>, depth: Half, hollow: bool) -> Self {
        let leans = Half::from(depth.to_mm() * libm::tan(tool.trail_angle.to_f64().to_radians()));
        let past_axis = leans + Half::of(tool.nose_radius.unwrap_or_default());
        Self { past_axis, into_bore: if hollow { leans } else { Half::ZERO } }
    }
}

/// A work, and the surface that its scheme leaves.
struct Cleared {
    work: Work,
    left: Option<Contour>,
}

fn clear(
    stock: Stock,
    scheme: usize,
    limit: Half,
    zone: &Zone,
    task: ZoneCut<'_, '_>,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<Cleared, KnowledgeError> {
    let knowledge = bench.knowledge;
    let (levels, pace) = borne(&stock, limit, zone, task, bench, findings)?;
    let settings =
        Settings { depth: levels.depth, approach: pace.approach_mm, retract: pace.retract_mm, feeds: pace.feeds };
    let tool = transitions::Tool {
        nose_radius: Half::of(task.tool.nose_radius.unwrap_or(Micrometres::ZERO)),
        main: Degrees(task.tool.lead_angle.to_f64()),
        secondary: Degrees(task.tool.trail_angle.to_f64()),
    };
    let offset = |contour: &Contour, distance: Half| equidistant(contour, &vec![distance; contour.pieces.len()]).ok();
    let all: &[Scheme] = if zone.feed == Feed::Across { &[Scheme::Descent] } else { &Scheme::ALL };
    let (mut possible, mut refused) = (Vec::new(), Vec::new());
    let prepared = Refusal::split(PreparedZone::of(&stock, &tool, &settings))?;
    let (back, _) = cuts_back(task.tool, knowledge)?;
    for &scheme in all {
        if scheme == Scheme::Zigzag && !back {
            let why = Note::new("cuts-not-back").with("tool", task.tool.designation);
            refused.push(RefusedScheme { scheme, why: why.with("angle", task.tool.trail_angle) });
            continue;
        }
        let made = match &prepared {
            Ok(prepared) => Refusal::split(prepared.transition(scheme, &offset, knowledge))?,
            Err(why) => Err(why.clone()),
        };
        match made {
            Ok(transition) => possible.push(transition),
            Err(why) => refused.push(RefusedScheme { scheme, why: why.note() }),
        }
    }
    let wanted = wanted(zone, scheme, bench);
    let taken = wanted.filter(|wanted| possible.iter().any(|one| one.scheme == *wanted));
    if let (Some(wanted), None) = (wanted, taken) {
        let note =
            Note::new("scheme-not-possible").with("scheme", Figure::scheme(wanted.name())).with("zone", zone.number);
        findings.push(Finding::of_part(if possible.is_empty() { Severity::Error } else { Severity::Doubtful }, note));
        if let Some(refused) = refused.iter().find(|one| one.scheme == wanted) {
            findings.push(Finding::of_part(Severity::Note, refused.why.clone()));
        }
    }
    let taken = taken.or_else(|| {
        let even = possible.iter().filter(|one| one.uniform);
        let order = |one: &&Transition| one.measures.time_min.0;
        even.min_by(|a, b| order(a).total_cmp(&order(b))).map(|one| one.scheme)
    });
    let transition = possible.iter().find(|one| Some(one.scheme) == taken);
    let left = prepared.ok().zip(transition).map(|(prepared, transition)| prepared.left(transition));
    let work = Work {
        levels,
        pace,
        taken,
        because: zone.scheme.because.clone(),
        quickest_even: best(possible.iter().filter(|one| one.uniform)),
        quickest: best(&possible),
        transitions: possible,
        refused,
        stock,
    };
    Ok(Cleared { work, left })
}

/// The levels of a stock with the pace of its passes: no deeper than the limit, and with as many more passes as tool, lathe and part
/// need to bear them. Where they bear none, or the file gives every rate, the limit counts.
fn borne(
    stock: &Stock,
    limit: Half,
    zone: &Zone,
    task: ZoneCut<'_, '_>,
    bench: &Bench<'_, '_>,
    findings: &mut Vec<Finding>,
) -> Result<(Split, Pace), KnowledgeError> {
    let least = Half::of(least_sensible_depth(bench.knowledge)?);
    let of = |limit: Half, findings: &mut Vec<Finding>| {
        let levels = levels(stock, limit, zone.feed);
        let task = ZoneCut { diameter: begins_at(&levels, stock).unwrap_or(task.diameter), ..task };
        let pace = depth::pace(task, levels.depth, None, bench, findings)?;
        Ok::<_, KnowledgeError>((levels, pace))
    };
    let mut found = Vec::new();
    let (levels, pace) = of(limit, &mut found)?;
    let exceeded = pace.exceeded();
    let (mut depth, mut tries) = (levels.depth, 0);
    while !exceeded.is_empty() && depth > least && tries < MOST_PASSES {
        tries += 1;
        let mut shallower = Vec::new();
        let next = of(depth - Half::new(1), &mut shallower)?;
        if next.1.exceeded().is_empty() && next.1.conditions.is_some() {
            let note = Note::new("passes-shallower").with("zone", zone.number).with("tool", task.tool.designation);
            let note = note.with("limit", levels.depth).with("depth", next.0.depth);
            shallower.push(Finding::of_part(Severity::Note, note.with("bounds", Bound::list(&exceeded))));
            findings.extend(shallower);
            return Ok(next);
        }
        depth = next.0.depth.min(depth - Half::new(1));
    }
    findings.extend(found);
    Ok((levels, pace))
}

/// The levels of a stock. A face is turned across, so its thickness is divided, not its height.
fn levels(stock: &Stock, limit: Half, feed: Feed) -> Split {
    if feed == Feed::Across {
        let thick = stock.to - stock.from;
        return Split { depth: thick.part(thick.parts(limit)), sections: Vec::new() };
    }
    match stock.rough.side {
        Side::Outer => Split::of(&stock.rough, &stock.blank, limit),
        Side::Inner => {
            let top = stock.rough.radii().map_or(Half::ZERO, |(_, most)| most);
            Split::of(&stock.rough.inside_out(top), &stock.blank.inside_out(top), limit).inside_out(top)
        }
    }
}

/// The largest diameter that a work cuts along the axis: outside its highest top, in a bore its deepest wall. Stock
/// removed by earlier works does not count.
fn begins_at(levels: &Split, stock: &Stock) -> Option<Micrometres> {
    let worked = levels.sections.iter().filter(|section| !section.stocks.is_empty());
    let radius = match stock.rough.side {
        Side::Outer => worked.map(|section| section.top).max(),
        Side::Inner => worked.flat_map(|section| &section.stocks).map(|stock| stock.deepest).max(),
    };
    radius.map(Half::diameter)
}

/// The scheme in the file, or that of the rule. A face is always turned across.
fn wanted(zone: &Zone, index: usize, bench: &Bench<'_, '_>) -> Option<Scheme> {
    if zone.feed == Feed::Across {
        return Some(Scheme::Descent);
    }
    if let Some(asked) = bench.workpiece.roughing.scheme {
        return Some(Scheme::from(asked));
    }
    let schemes = &zone.scheme.schemes;
    schemes.get(index).or_else(|| schemes.last()).map(|scheme| Scheme::from(*scheme))
}
