//! Chooses the tools that rough a side: as few as possible of those that fit the zones.

use std::cmp::Ordering;

use serde::Serialize;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::knowledge::vocabulary::Surface;
use crate::material::Material;
use crate::note::{Because, Note};
use crate::tables::turning::tools::{Preference, TurningToolOrderFor};
use crate::turning::allowances::capability::Elsewhere;
use crate::turning::contour::{Contour, Side, SurfaceName};
use crate::turning::elements::{self, Angles};
use crate::turning::jobs;
use crate::turning::length::Half;
use crate::turning::nose::Nose;
use crate::turning::schemes::rates;
use crate::turning::tooling::{Hand, Lathe, Place, Shank, ToolKind, TurningTool};
use crate::turning::workpiece::Workpiece;
use crate::turning::zones::{ToolAngles, Zone, fit};
use crate::units::{Degrees, Micrometres};

use super::held::Held;
use super::{Barred, Sizes, Stage};
use crate::turning::cutting::{Direction, GripLimit, TurningCut, bar_clearance, largest_overhang};

/// The context of planning an operation.
#[derive(Clone, Debug)]
pub struct Bench<'a, 'k> {
    /// The part.
    pub workpiece: &'a Workpiece,
    /// The lathe, if the file names one.
    pub lathe: Option<&'a Lathe<'k>>,
    /// The material.
    pub material: Material<'k>,
    /// The held part in the set-up; none if it is not held.
    pub held: Option<Held>,
    /// What the jaws hold; none between centres, and where the size of the chuck is not known.
    pub grip: Option<GripLimit>,
    /// The surfaces finished on another machine.
    pub elsewhere: &'a [Elsewhere],
    /// The sizes that are made.
    pub sizes: &'a Sizes,
    /// How deep a through hole is drilled, where the part is parted off behind its end: past the blade.
    pub through: Option<Half>,
    /// Z of the face at which this set-up parts the part off; none where it does not.
    pub parted: Option<Half>,
    /// The diameter of the hole that the set-up before has opened at the far face; zero where there is none.
    pub opened: Micrometres,
    /// The outside that the set-up before has left, in the coordinates of this one; none in the first one, and where it turned nothing.
    pub turned: Option<Contour>,
    /// The tools that the proof rejected in this set-up.
    pub barred: Vec<Barred>,
    /// Every table.
    pub knowledge: &'k Knowledge,
}

impl<'a, 'k> Bench<'a, 'k> {
    /// Before anything is known of the set-ups.
    pub const fn of(
        workpiece: &'a Workpiece,
        lathe: Option<&'a Lathe<'k>>,
        material: Material<'k>,
        sizes: &'a Sizes,
        knowledge: &'k Knowledge,
    ) -> Self {
        Self {
            workpiece,
            lathe,
            material,
            held: None,
            grip: None,
            elsewhere: &[],
            sizes,
            through: None,
            parted: None,
            opened: Micrometres::ZERO,
            turned: None,
            barred: Vec::new(),
            knowledge,
        }
    }

    /// The approach δ and the retract: of the file, otherwise of the table `turning-motion`.
    ///
    /// # Errors
    /// The knowledge base lacks the table, or a row of it.
    pub fn approach_and_retract(&self) -> Result<[Half; 2], KnowledgeError> {
        let rates = match self.workpiece.rates {
            Some(given) => given.main,
            None => rates::of_table(self.knowledge)?.0,
        };
        Ok([rates.approach, rates.retract].map(Half::of))
    }

    /// The tools of a kind that work at a place, with a known nose radius and a shank that the lathe clamps.
    ///
    /// # Errors
    /// A table of tools is broken.
    pub fn tools(&self, kind: ToolKind, works: Place) -> Result<Vec<TurningTool<'k>>, KnowledgeError> {
        let mut tools = TurningTool::all(self.knowledge)?;
        tools.retain(|tool| (tool.kind, tool.works) == (kind, works) && tool.nose_radius.is_some());
        tools.retain(|tool| self.lathe.is_none_or(|lathe| lathe.refuses_tool(tool).is_none()));
        Ok(tools)
    }

    /// A cut into turned metal; none without a lathe.
    pub fn cut<'b>(
        &'b self,
        tool: &'b TurningTool<'k>,
        diameter: Micrometres,
        direction: Direction,
    ) -> Option<TurningCut<'b, 'k>> {
        Some(TurningCut {
            knowledge: self.knowledge,
            lathe: self.lathe?,
            tool,
            material: &self.material,
            diameter,
            direction,
            surface: Surface::None,
            bore_depth: None,
            part: None,
            grip: None,
            stands_out: Half::ZERO,
            spindle_most: None,
        })
    }

    /// The narrowest diameter of the bore that the blank has; zero in solid metal.
    pub fn raw_bore(&self) -> Micrometres {
        let raw = self.workpiece.blank.inner.as_ref().and_then(Contour::radii);
        raw.map_or(Half::ZERO, |(least, _)| least).diameter()
    }

    /// How deep a hole is drilled that ends at a Z: past the blade, if it ends with the part and the part is parted there.
    pub fn through(&self, end: Half) -> Half {
        self.through.filter(|_| end >= self.workpiece.length()).map_or(end, |past| past.max(end))
    }

    /// The allowance that another machine takes off a surface; none of one that is finished here.
    pub fn later(&self, surface: &SurfaceName) -> Option<Half> {
        self.elsewhere.iter().find(|one| one.surface == *surface).map(|one| one.allowance_mm)
    }

    /// Whether a groove or a thread must be left, because the proof rejected its toolpath.
    pub fn leaves(&self, surface: &SurfaceName) -> bool {
        self.barred.iter().any(|one| one.stage == Stage::Cutting && one.surfaces.contains(surface))
    }
}

/// The tool chosen for a zone.
#[derive(Clone, Debug, Serialize)]
pub struct ChosenTool {
    /// Its designation.
    pub designation: String,
    /// φ.
    pub main_angle_deg: Degrees,
    /// φ1.
    pub secondary_angle_deg: Degrees,
    /// Its nose radius, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub nose_radius_mm: Option<Micrometres>,
    /// Its width, of a grooving tool, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub width_mm: Option<Micrometres>,
    /// Its row, and the reason for it.
    pub because: Because,
    /// Why it precedes other tools that fit as many zones.
    pub because_order: Because,
}

/// Compares two tools by one preference.
fn compare(by: Preference, one: &TurningTool<'_>, other: &TurningTool<'_>) -> Ordering {
    match by {
        Preference::LeastTrailAngle => one.trail_angle.cmp(&other.trail_angle),
        Preference::LargestShank => other.shank.map(thickness).cmp(&one.shank.map(thickness)),
        Preference::WidestBlade => other.width.cmp(&one.width),
    }
}

/// The preferences for tools of a kind, the most important first, and their row.
fn order(kind: ToolKind, knowledge: &Knowledge) -> Result<(Vec<Preference>, Because), KnowledgeError> {
    let asked = knowledge.ask(&TurningToolOrderFor { kind })?;
    let order = asked.need(kind.name())?.prefer;
    let names: Vec<&str> = order.iter().map(|preference| preference.name()).collect();
    let because = Because::answer(&asked.answer, Note::new("tool-order").with("prefer", names.join(", ")));
    Ok((order, because))
}

/// Sorts tools of a kind by these preferences; equals keep the order of their tables.
fn put_in_order(tools: &mut [TurningTool<'_>], kind: ToolKind, knowledge: &Knowledge) -> Result<(), KnowledgeError> {
    let (order, _) = order(kind, knowledge)?;
    tools.sort_by(|one, other| {
        let decided = order.iter().map(|preference| compare(*preference, one, other));
        decided.fold(Ordering::Equal, Ordering::then)
    });
    Ok(())
}

/// The tools that may rough or finish a side: right-hand or neutral, with a shank that the lathe clamps and a known
/// nose radius; in the order of the rule `turning-tool-order`.
///
/// # Errors
/// A table of tools is broken.
pub fn candidates<'k>(side: Side, stage: Stage, bench: &Bench<'_, 'k>) -> Result<Vec<TurningTool<'k>>, KnowledgeError> {
    let (kind, works) = match side {
        Side::Outer => (ToolKind::Turning, Place::Outer),
        Side::Inner => (ToolKind::Boring, Place::Inner),
    };
    let mut tools = bench.tools(kind, works)?;
    tools.retain(|tool| tool.hand != Hand::L);
    let is_barred =
        |one: &Barred, tool: &TurningTool<'_>| (one.side, one.stage) == (side, stage) && one.tool == tool.designation;
    tools.retain(|tool| !bench.barred.iter().any(|one| is_barred(one, tool)));
    put_in_order(&mut tools, kind, bench.knowledge)?;
    Ok(tools)
}

/// The height of a square shank, the diameter of a bar.
const fn thickness(shank: Shank) -> Micrometres {
    match shank {
        Shank::Square { height, .. } => height,
        Shank::Round { diameter } => diameter,
    }
}

/// The deepest bore to whose end a bar reaches; none for a tool without a bar.
fn reach(tool: &TurningTool<'_>, knowledge: &Knowledge) -> Result<Option<Half>, KnowledgeError> {
    let clearance = bar_clearance(knowledge)?;
    Ok(largest_overhang(tool, knowledge)?.map(|(most, _)| Half::of(most - clearance)))
}

/// The tools that reach a depth; where none does, those that come nearest, whose cut is refused then.
///
/// # Errors
/// The knowledge base lacks a constant.
pub fn reaching<'k>(
    tools: Vec<TurningTool<'k>>,
    deep: Half,
    knowledge: &Knowledge,
) -> Result<Vec<TurningTool<'k>>, KnowledgeError> {
    let mut far = Vec::new();
    for tool in tools {
        far.push((reach(&tool, knowledge)?.map_or(deep, |reach| reach.min(deep)), tool));
    }
    let farthest = far.iter().map(|(reach, _)| *reach).max();
    Ok(far.into_iter().filter(|(reach, _)| Some(*reach) == farthest).map(|(_, tool)| tool).collect())
}

/// The angles of a tool for the check of its fit.
///
/// # Errors
/// The knowledge base lacks a constant.
pub fn angles(tool: &TurningTool<'_>, knowledge: &Knowledge) -> Result<ToolAngles, KnowledgeError> {
    Ok(ToolAngles {
        reach: reach(tool, knowledge)?,
        name: tool.designation.to_owned(),
        angles: Angles {
            main: Degrees(tool.lead_angle.to_f64()),
            secondary: Degrees(tool.trail_angle.to_f64()),
            hand: elements::Hand::Right,
        },
        least_bore: tool.min_bore,
        width: tool.width.filter(|_| tool.plunges()).map(Half::of),
    })
}

/// Its nose, for offsetting contours.
pub fn nose(tool: &TurningTool<'_>) -> Nose {
    let radius = Half::of(tool.nose_radius.unwrap_or(Micrometres::ZERO));
    Nose { radius, tip: jobs::tip(tool.kind, tool.works, tool.hand) }
}

/// The least distance from the axis of a boring tool's point in a bore, so that its bar stays clear of the opposite
/// wall: the bar is between the point and that wall. None for a tool without a bar.
///
/// A bar stands back from its point by four fifths of what its smallest bore is wider than it (ISO 6261: 3 of 4 mm for
/// 16 in 20, 6 of 8 for 32 in 40).
pub fn nearest_to_axis(tool: &TurningTool<'_>, bore: Half) -> Option<Half> {
    /// The clearance between bar and wall, mm.
    const FREE: f64 = 0.25;
    let (Some(Shank::Round { diameter }), Some(least)) = (tool.shank, tool.min_bore) else { return None };
    let bar = diameter.to_mm();
    let back = bar + 0.8 * (least.to_mm() - bar);
    Some(Half::from(back + FREE - bore.to_mm()))
}

/// The tool chosen for the most zones; among equals the first.
pub fn most_used(taken: &[Option<usize>]) -> Option<usize> {
    let count = |tool: usize| taken.iter().filter(|other| **other == Some(tool)).count();
    taken.iter().flatten().copied().rev().max_by_key(|tool| count(*tool))
}

/// For each zone the index of its tool; none if no tool fits. The tool that fits the most zones is taken for all of
/// them, then the one for the most of the rest (lecture, l. 540-546: the number of tools should be the least); among
/// equals the first.
pub fn assign(zones: &[Zone], tools: &[ToolAngles]) -> Vec<Option<usize>> {
    let fits: Vec<Vec<bool>> = zones
        .iter()
        .map(|zone| {
            let fitting = fit(zone, tools).fitting;
            tools.iter().map(|tool| fitting.contains(&tool.name)).collect()
        })
        .collect();
    let mut taken: Vec<Option<usize>> = vec![None; zones.len()];
    loop {
        let open = |tool: usize| {
            let zones = fits.iter().zip(&taken);
            zones.filter(|(fits, taken)| taken.is_none() && fits.get(tool) == Some(&true)).count()
        };
        let best = (0..tools.len()).map(|tool| (open(tool), tool)).rev().max_by_key(|(count, _)| *count);
        let Some((_, best)) = best.filter(|(count, _)| *count > 0) else { return taken };
        for (fits, taken) in fits.iter().zip(&mut taken) {
            if taken.is_none() && fits.get(best) == Some(&true) {
                *taken = Some(best);
            }
        }
    }
}

/// A tool as the output shows it.
///
/// # Errors
/// The knowledge base lacks the rule `turning-tool-order`, or a row of it.
pub fn chosen(tool: &TurningTool<'_>, zones: usize, bench: &Bench<'_, '_>) -> Result<ChosenTool, KnowledgeError> {
    let (_, because_order) = order(tool.kind, bench.knowledge)?;
    Ok(ChosenTool {
        width_mm: tool.width,
        designation: tool.designation.to_owned(),
        main_angle_deg: Degrees(tool.lead_angle.to_f64()),
        secondary_angle_deg: Degrees(tool.trail_angle.to_f64()),
        nose_radius_mm: tool.nose_radius,
        because: Because::row(
            tool.row,
            Note::new("turning-tool-taken").with("tool", tool.designation).with("zones", zones),
        ),
        because_order,
    })
}
