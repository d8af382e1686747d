//! The proof of plans, applied to a plan by hand as far as its figures are complete enough.
//!
//! A fault by figures of practice is doubtful: the author may know a better drill. What is impossible by geometry,
//! such as a tool wider than the hole, is wrong. A requirement that the last transition reaches only at best, or not at
//! all, is judged as in a plan of ours. Faults that other checks report with their place are left to those
//! checks.

use technolog_proof::Fault;

use crate::error::KnowledgeError;
use crate::note::Severity;
use crate::plan::Operation;
use crate::tables::audit::PlanPart;

use super::super::context::Context;
use super::super::finding::{AuditFinding, Section};
use super::super::graph::{Graph, Status};
use super::super::quantity::Quantity;
use super::super::stated::Row;
use super::program::stated_holes;

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    if context.stated.is_own || !context.stated.covers(PlanPart::Holes) {
        return Ok(());
    }
    // A figure that contradicts another is reported as such; a proof on top of it would mean nothing.
    if graph.verdicts().iter().any(|verdict| !matches!(verdict.status, Status::Fine)) {
        return Ok(());
    }
    let Some(holes) = stated_holes(context, graph)? else { return Ok(()) };
    for (hole, planned) in context.stated.part.holes.iter().zip(&holes) {
        let faults = technolog_proof::prove_hole(hole, &planned.transitions, &context.stated.part, &context.shop)?;
        for fault in faults {
            let severity = match &fault {
                Fault::NoStock { .. }
                | Fault::TooMuch { .. }
                | Fault::TooWide { .. }
                | Fault::Overload { .. }
                | Fault::TooFast { .. }
                | Fault::TooHard { .. }
                | Fault::Hard { .. }
                | Fault::Twists { .. }
                | Fault::Buckles { .. }
                | Fault::FlutesClose { .. }
                | Fault::BarSlender { .. }
                | Fault::ThinFloor { .. }
                | Fault::MeetsFloor { .. }
                | Fault::BarOutOfRange { .. }
                | Fault::BarBeyondMachine { .. }
                | Fault::BarEnters { .. }
                | Fault::MiddleInMetal { .. }
                | Fault::SolidCore { .. }
                | Fault::BarSprings { .. } => Severity::Doubtful,
                Fault::Wanting { .. } | Fault::UnderSkin { .. } => fault.severity(),
                Fault::Enters { .. } | Fault::Gouges { .. } | Fault::TapHole { .. } => Severity::Wrong,
                // The blank is the drawing's, not the plan's, and assemblies are those of a whole plan: `prove_hole` leaves them out.
                Fault::Wall { .. }
                | Fault::NoWall { .. }
                | Fault::CastStock { .. }
                | Fault::CastDepth { .. }
                | Fault::PilotMeetsFloor { .. }
                | Fault::HolderLow { .. }
                | Fault::PlateSprings { .. }
                | Fault::NotFinished { .. }
                | Fault::SpotStays { .. }
                | Fault::TooShallow { .. }
                | Fault::BreaksThrough { .. }
                | Fault::Floor { .. } => continue,
            };
            // What our own plans only doubt, the author may know better.
            if fault.severity() == Severity::Doubtful
                && !matches!(fault, Fault::Wanting { .. } | Fault::UnderSkin { .. })
            {
                continue;
            }
            // A depth that is not written is ours.
            let drills = |row: &Row| matches!(row.operation.value, Operation::Drill | Operation::DrillOut);
            let mut drilled = context.stated.rows_of_hole(&hole.name).filter(|(_, row)| drills(row));
            if matches!(fault, Fault::SolidCore { .. })
                && !drilled.all(|(_, row)| row.figures.contains_key(&Quantity::Depth))
            {
                continue;
            }
            let place = context.stated.rows_of_hole(&hole.name).next().map(|(_, row)| row.place.clone());
            let field = format!("proof.{}", hole.name);
            let finding = AuditFinding::new(severity, Section::Route, field, fault.note());
            findings.push(match place {
                Some(place) => finding.at(&place),
                None => finding,
            });
        }
    }
    Ok(())
}
