//! The rest of a hole: wider cylinders, and the edges and faces at its ends.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::note::{Because, Note};
use crate::plan::{Feature, Operation};
use crate::reason::Reason;
use crate::shop::Shop;
use crate::tables::holes::{HoleDefault, SchemesOfAuxiliaryHole};
use crate::tables::rules::{ToolTablesFor, TransitionOrder};
use crate::units::Micrometres;

use super::bores::{Bore, EdgeCut};
use super::diameters::Sizes;
use super::scheme::{self, SchemeQuestion};
use super::search::{self, Cost, cuts_shoulder};
use super::{Candidate, RouteStep, StepLocation};

/// The candidates for a wider cylinder: for a step of the drawing, those of the tables for an existing hole, and
/// those of the search. For a flat shoulder only those that leave one.
///
/// # Errors
/// The knowledge base has no answer, or nothing opens the cylinder.
pub fn candidates(
    bore: &Bore,
    question: &SchemeQuestion<'_>,
    sizes: &Sizes<'_>,
    cost: &Cost<'_>,
    shop: &Shop<'_>,
) -> Tried<Vec<Candidate>> {
    let mut found = Vec::new();
    let mut failed = None;
    if bore.place.feature == Feature::Step && bore.thread.is_none() {
        match Refusal::split(scheme::candidates(question, shop))? {
            Ok(schemes) => found.extend(schemes),
            Err(why) => failed = Some(why),
        }
    }
    match Refusal::split(search::candidates(bore, sizes, cost, shop))? {
        Ok(routes) => found.extend(routes),
        // The reason of the search says more than that a table has no cell.
        Err(why) => failed = Some(why),
    }
    found.retain(|candidate| !bore.flat || cuts_shoulder(&candidate.transitions));
    if let Some(thread) = &bore.thread {
        for candidate in &mut found {
            candidate.transitions.push(Operation::Tap);
            candidate.because.push(Because::table(
                shop.knowledge.table_of::<SchemesOfAuxiliaryHole<'_>>()?,
                Note::new("thread-of-step").with("thread", &thread.written),
            ));
        }
    }
    if found.is_empty() {
        return Err(Refusal::Not(match failed {
            Some(why) if !bore.flat => why,
            _ => no_flat_opening(bore, shop)?,
        }));
    }
    Ok(found)
}

/// The catalog sizes of counterbores near that diameter.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn counterbores(diameter: Micrometres, shop: &Shop<'_>) -> Result<Vec<Micrometres>, KnowledgeError> {
    let rule = shop.knowledge.ask(&ToolTablesFor { operation: Operation::Counterbore, diameter })?.winner()?;
    let mut sizes = Vec::new();
    for id in rule.map(|rule| rule.tables).unwrap_or_default() {
        sizes.extend(shop.shelf.cutters_of(id)?.rows()?.iter().filter_map(|row| row.diameter));
    }
    Ok(sizes)
}

/// No cutter leaves this shoulder flat; the nearest counterbores of the catalogs are named.
fn no_flat_opening(bore: &Bore, shop: &Shop<'_>) -> Result<Reason, KnowledgeError> {
    let diameter = bore.diameter.nominal;
    let sizes = counterbores(diameter, shop)?;
    let below = sizes.iter().copied().filter(|size| *size < diameter).max();
    let above = sizes.into_iter().filter(|size| *size > diameter).min();
    Ok(Reason::NoFlatOpening { diameter, below, above })
}

/// The step that cuts an edge: a chamfer, a countersink, a cone or a face. `cylinder_diameter` is
/// that of the cylinder when it is cut.
///
/// # Errors
/// The knowledge lacks a convention.
pub fn edge(edge: &EdgeCut, cylinder_diameter: Micrometres, shop: &Shop<'_>) -> Tried<RouteStep> {
    let stock = shop.convention(HoleDefault::FaceStock)?;
    let depth = EdgeCut { cylinder_diameter, ..*edge }.depth(stock);
    // Depths of the drawing are measured from the machined face; the stock of the face lies above it.
    let above = if edge.feature == Feature::Face { depth } else { Micrometres::ZERO };
    let start = edge.start - above;
    let place = StepLocation {
        feature: edge.feature,
        step: None,
        face: edge.face,
        start,
        depth: start + depth,
        through: false,
    };
    let operation = match edge.feature {
        Feature::Face => Operation::Counterbore,
        Feature::Chamfer => Operation::Chamfer,
        _ => Operation::Countersink,
    };
    let mut step = RouteStep {
        entry_cylinder: edge.entry_cylinder,
        ..RouteStep::plain(operation, place, edge.diameter, cylinder_diameter)
    };
    if edge.feature != Feature::Face {
        step.angle_millideg = Some(edge.angle_millideg);
    }
    step.because.push(Because::table(
        shop.knowledge.table_of::<TransitionOrder<'_>>()?,
        Note::new("edge").with("diameter", edge.diameter).with("depth", depth),
    ));
    Ok(step)
}
