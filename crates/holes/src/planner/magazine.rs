//! The tools of the whole part: one centring drill, tool numbers in the order of work, length corrections.

use std::rc::Rc;

use crate::error::{KnowledgeError, Refusal};
use crate::note::{Because, Finding, Note, Severity};
use crate::part::{Face, Part};
use crate::plan::{HolePlan, Operation, ToolPlan, Transition};
use crate::shop::Shop;
use crate::tooling::{self, CutterNeed};
use crate::units::{ItGrade, Micrometres, round_to};

use super::HoleDraft;
use super::fit::{Fitted, FittedTool, Fitting, widest_spot};

/// Chooses one centring tool for all holes that need one: the smallest drill of A.14 that makes every chamfer, or is
/// wider than every first drill.
pub(super) fn choose_centre_drill(
    part: &Part,
    drafts: &mut [HoleDraft],
    shop: &Shop<'_>,
    findings: &mut Vec<Finding>,
) -> Result<(), KnowledgeError> {
    let widest = widest_spot(shop)?;
    let mut needed = Micrometres::ZERO;
    let mut why = Note::new("centre-drill-for-all");
    for draft in &*drafts {
        let Some(centre) = draft.steps.iter().find(|one| one.step.operation == Operation::CentreDrill) else {
            continue;
        };
        let spot = centre.step.diameter;
        let first = draft.steps.iter().find(|one| one.step.operation == Operation::Drill).map(|one| one.step.diameter);
        let note = |code: &'static str, diameter| Note::new(code).with("needed", diameter);
        let (own, note) = match first {
            // The tool is wider than the first drill, so that the drill starts on the cone and not on its rim.
            Some(drill) if !centre.makes_edge && drill < widest => {
                (drill + Micrometres::new(1), note("centre-drill-for-all-over", drill))
            }
            Some(_) if !centre.makes_edge => (widest, note("centre-drill-for-all", widest)),
            _ => (spot, note("centre-drill-for-all-least", spot)),
        };
        if own > needed {
            (needed, why) = (own, note);
        }
    }
    if needed == Micrometres::ZERO {
        return Ok(());
    }
    let need = CutterNeed::plain(Operation::CentreDrill, needed);
    let fitted = tooling::find_tool(&need, shop)?.map(|(cutter, mut assembly)| {
        let mut because = vec![Because { note: why.clone(), ..cutter.because() }];
        because.append(&mut assembly.because);
        Rc::new(FittedTool {
            designation: cutter.designation.to_owned(),
            table: cutter.row.row.table.id.clone(),
            diameter: cutter.diameter,
            front: cutter.row.tip_diameter,
            ground_from: None,
            pilot: None,
            lead_pitches: None,
            centre_cutting: false,
            size: cutter.diameter,
            assembly,
            because,
        })
    });
    for (draft, hole) in drafts.iter_mut().zip(&part.holes) {
        let Some(centre) = draft.steps.iter_mut().find(|one| one.step.operation == Operation::CentreDrill) else {
            continue;
        };
        match &fitted {
            Ok(tool) => {
                // The permitted spot depends on the tool that makes it.
                let fitting = Fitting::new(hole, &[], part, shop)?;
                match Refusal::split(fitting.spotting(&centre.step, centre.travel, tool.diameter))? {
                    Ok(conditions) => centre.conditions = conditions.into(),
                    Err(why) => findings.push(Finding::of_hole(Severity::Error, &hole.name, why.note())),
                }
                centre.tool = Some(Rc::clone(tool));
            }
            Err(why) => {
                findings.extend(why.iter().map(|unfit| Finding::of_hole(Severity::Error, &hole.name, unfit.note())));
                draft.route = None;
                draft.steps.clear();
            }
        }
    }
    Ok(())
}

/// Whether two steps use one tool: the same cutter, setting and holder.
fn same_tool(a: &FittedTool, b: &FittedTool) -> bool {
    a.designation == b.designation
        && a.table == b.table
        && a.size == b.size
        && a.ground_from == b.ground_from
        && a.pilot == b.pilot
        && a.lead_pitches == b.lead_pitches
        && a.assembly.holder == b.assembly.holder
}

/// The finest grade of the fields H that a tool is bought for in the holes it finishes; tools of other sizes are other tools.
fn bought_for(tool: &FittedTool, drafts: &[HoleDraft]) -> Option<ItGrade> {
    let made = drafts.iter().flat_map(|draft| &draft.steps).filter(|fitted| !fitted.step.elsewhere);
    let own = made.filter(|fitted| fitted.tool.as_ref().is_some_and(|known| same_tool(known, tool)));
    own.filter_map(|fitted| fitted.step.bought_for).min().filter(|_| tool.ground_from.is_none())
}

/// Numbers the tools in the order in which the holes need them, and computes their corrections.
pub(super) fn number_tools(
    part: &Part,
    drafts: Vec<HoleDraft>,
    shop: &Shop<'_>,
    findings: &mut Vec<Finding>,
) -> (Vec<HolePlan>, Vec<ToolPlan>) {
    let mut tools: Vec<(usize, Rc<FittedTool>)> = Vec::new();
    for fitted in drafts.iter().flat_map(|draft| &draft.steps).filter(|fitted| !fitted.step.elsewhere) {
        if let Some(tool) = &fitted.tool
            && !tools.iter().any(|(_, known)| same_tool(known, tool))
        {
            tools.push((0, Rc::clone(tool)));
        }
    }
    rank(&mut tools, &drafts);
    // Tools used only from the back face come after all tools of the first set-up.
    let of_back = |tool: &FittedTool| {
        let entry = drafts.iter().flat_map(|draft| &draft.steps).filter(|one| one.step.place.face == Face::Entry);
        !entry.filter_map(|one| one.tool.as_ref()).any(|known| same_tool(known, tool))
    };
    tools.sort_by_key(|(rank, tool)| (of_back(tool), *rank));
    let tools: Vec<Rc<FittedTool>> = tools.into_iter().map(|(_, tool)| tool).collect();
    let places = shop.machine.magazine;
    if tools.len() > places {
        // Tools beyond the magazine are loaded by hand: the last ones, when the tools before them have finished.
        let by_hand = tools.len() - places;
        let note = Note::new("magazine-reloaded")
            .with("tools", tools.len())
            .with("places", places)
            .with("count", by_hand)
            .with("first", places + 1)
            .with("last", tools.len())
            .with("loads", tools.len().div_ceil(places));
        findings.push(Finding::of_part(Severity::Doubtful, note));
    }

    let mut plans: Vec<ToolPlan> = tools
        .iter()
        .zip(1..)
        .map(|(tool, number)| ToolPlan {
            number,
            designation: tool.designation.clone(),
            table: tool.table.clone(),
            diameter_mm: tool.size,
            ground_from_mm: tool.ground_from,
            pilot_mm: tool.pilot,
            lead_pitches: tool.lead_pitches,
            bought_for_h: bought_for(tool, &drafts),
            holder: tool.assembly.holder.clone(),
            holder_table: tool.assembly.holder_table.clone(),
            overhang_mm: tool.assembly.overhang,
            length_mm: tool.assembly.length,
            links: tool.assembly.links.clone(),
            mass_kg: tool.assembly.mass_kg.map(|mass| round_to(mass, 2)),
            load: (number - 1) / u32::try_from(places).unwrap_or(u32::MAX) + 1,
            corrector: number,
            correction_mm: Micrometres::ZERO,
            book_correction_mm: Micrometres::ZERO,
            because: tool.because.clone(),
        })
        .collect();
    ToolPlan::correct(&mut plans);
    let holes = drafts
        .into_iter()
        .zip(&part.holes)
        .map(|(draft, hole)| HolePlan {
            name: hole.name.clone(),
            count: hole.at.len(),
            route: draft.route,
            transitions: draft.steps.iter().filter_map(|fitted| transition(fitted, &tools)).collect(),
        })
        .collect();
    (holes, plans)
}

/// The rank of a tool is the length of the longest chain of tools before it in any hole.
fn rank(tools: &mut [(usize, Rc<FittedTool>)], drafts: &[HoleDraft]) {
    // Each pass can lengthen a chain by one; a chain longer than the number of tools would be a circle.
    for _ in 0..tools.len() {
        for draft in drafts {
            let mut least = 0;
            for tool in
                draft.steps.iter().filter(|fitted| !fitted.step.elsewhere).filter_map(|fitted| fitted.tool.as_ref())
            {
                if let Some((rank, _)) = tools.iter_mut().find(|(_, known)| same_tool(known, tool)) {
                    *rank = (*rank).max(least);
                    least = *rank + 1;
                }
            }
        }
    }
}

fn transition(fitted: &Fitted, tools: &[Rc<FittedTool>]) -> Option<Transition> {
    if fitted.step.operation.is_only_elsewhere() {
        return Some(fitted.transition(0));
    }
    let tool = fitted.tool.as_ref()?;
    let number = tools.iter().zip(1..).find(|(known, _)| same_tool(known, tool)).map(|(_, number)| number);
    // Work on another machine has no place in this magazine.
    let number = if fitted.step.elsewhere { 0 } else { number? };
    Some(fitted.transition(number))
}
