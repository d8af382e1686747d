//! Checks of the blank under the plan: walls beside the holes, the stock of cast holes, the spring of a thin plate.

use std::collections::BTreeMap;

use crate::error::KnowledgeError;
use crate::note::Finding;
use crate::part::{BlankHole, CentreTolerance, Face, Hole, Part, Point, tolerance_width};
use crate::plan::{Plan, Transition};
use crate::shop::Shop;
use crate::tables::practice::ProofLimit;
use crate::tables::turning::part::ElasticModulus;
use crate::units::Micrometres;

use super::tool::limit;
use super::{Beside, Fault};

/// What the blank does not hold, as findings of the holes concerned.
pub(crate) fn faults(plan: &Plan, shop: &Shop<'_>) -> Result<Vec<Finding>, KnowledgeError> {
    let part = &plan.part;
    let mut faults = walls(part, shop)?;
    let cast = Micrometres::from_mm_rounded(limit(ProofLimit::CastHoleStock, shop)?);
    for hole in &part.holes {
        if let BlankHole::Cast(own) = hole.state {
            let stock = (hole.diameter.nominal - own).half();
            if stock < cast {
                faults.push((&hole.name, Fault::CastStock { cast: own, stock, least: cast }));
            }
            // The file has no key for its depth.
            if !hole.through {
                faults.push((&hole.name, Fault::CastDepth { cast: own, depth: hole.depth }));
            }
        }
    }
    faults.extend(springing(plan, shop)?);
    Ok(faults.into_iter().map(|(hole, fault)| Finding::of_hole(fault.severity(), hole, fault.note())).collect())
}

/// Whether the plate springs under some tool by more than the feed.
pub(crate) fn plate_springs(plan: &Plan, shop: &Shop<'_>) -> Result<bool, KnowledgeError> {
    Ok(!springing(plan, shop)?.is_empty())
}

fn springing<'p>(plan: &'p Plan, shop: &Shop<'_>) -> Result<Vec<(&'p String, Fault)>, KnowledgeError> {
    let mut faults = Vec::new();
    for (hole, planned) in plan.part.holes.iter().zip(&plan.holes) {
        faults.extend(springs(hole, &planned.transitions, plan, shop)?.map(|fault| (&hole.name, fault)));
    }
    Ok(faults)
}

/// A cylinder of a hole, its ends measured from the entry face.
struct Span {
    diameter: Micrometres,
    from: Micrometres,
    to: Micrometres,
}

fn spans(hole: &Hole, thickness: Micrometres) -> Vec<Span> {
    let from_entry = |diameter, to| Span { diameter, from: Micrometres::ZERO, to };
    let main = hole.thread.as_ref().map_or(hole.diameter.largest(), |thread| thread.size);
    let mut spans = vec![from_entry(main, if hole.through { thickness } else { hole.depth })];
    spans.extend(hole.counterbore.iter().map(|it| from_entry(it.diameter, it.depth)));
    spans.extend(hole.steps.iter().map(|step| match step.face {
        Face::Entry => from_entry(step.diameter.largest(), step.depth),
        Face::Back => Span { diameter: step.diameter.largest(), from: thickness - step.depth, to: thickness },
    }));
    spans
}

/// The thinnest wall of each group of holes to the edge of the blank, and between each two groups.
fn walls<'p>(part: &'p Part, shop: &Shop<'_>) -> Result<Vec<(&'p String, Fault)>, KnowledgeError> {
    let least = Micrometres::from_mm_rounded(limit(ProofLimit::LeastWall, shop)?);
    let share = limit(ProofLimit::LeastWallShare, shop)?;
    let of_height = |height: Micrometres| least.max(Micrometres::from_mm_rounded(height.to_mm() * share));
    let thickness = part.blank.thickness;
    let spans: Vec<Vec<Span>> = part.holes.iter().map(|hole| spans(hole, thickness)).collect();
    // The thinnest wall of a pair of groups; of a group with itself as well, and with the edge as none.
    let mut thinnest: BTreeMap<(usize, Option<usize>), (Micrometres, Micrometres)> = BTreeMap::new();
    let mut note = |pair, wall: Micrometres, least: Micrometres| {
        if wall < least {
            let known = thinnest.entry(pair).or_insert((wall, least));
            *known = (*known).min((wall, least));
        }
    };
    let mut points: Vec<(Point, usize)> = Vec::new();
    for (index, hole) in part.holes.iter().enumerate() {
        points.extend(hole.at.iter().filter(|_| hole.slot.is_none()).map(|at| (*at, index)));
        // Where a slot is open nothing is left between it and the edge.
        let open = |end: &Point| {
            hole.slot.is_some_and(|slot| hole.at.iter().any(|at| slot.outside(*at).any(|out| out == *end)))
        };
        let ends = hole.ways().flat_map(|way| [(way.from, way.thinner), (way.to, way.thinner)]);
        for (at, thinner) in ends.filter(|(end, _)| !open(end)) {
            let edge = part.to_edge(at) + thinner;
            for span in &spans[index] {
                note((index, None), edge - span.diameter.half(), of_height(span.to - span.from));
            }
        }
    }
    // Only neighbours are compared: along X no further apart than the widest hole and the thickest wall asked for.
    points.sort_unstable();
    let widest = spans.iter().flatten().map(|span| span.diameter).max().unwrap_or_default();
    let near = widest + of_height(thickness);
    for (index, (at, group)) in points.iter().enumerate() {
        for (other, their) in points[index + 1..].iter().take_while(|(other, _)| other.x - at.x < near) {
            let (a, b) = ((*group).min(*their), (*group).max(*their));
            for (own, theirs) in spans[a].iter().flat_map(|own| spans[b].iter().map(move |theirs| (own, theirs))) {
                let height = own.to.min(theirs.to) - own.from.max(theirs.from);
                if height > Micrometres::ZERO {
                    let wall = at.distance(*other) - (own.diameter + theirs.diameter).half();
                    note((a, Some(b)), wall, of_height(height));
                }
            }
        }
    }
    // Slots are few: each is held against all others.
    for (a, slot) in part.holes.iter().enumerate().filter(|(_, hole)| hole.slot.is_some()) {
        let others = part.holes.iter().enumerate().filter(|(b, other)| other.slot.is_none() || *b < a);
        for (b, other) in others {
            let apart = slot.ways().flat_map(|own| other.ways().map(move |theirs| own.apart(theirs))).min();
            for (own, theirs) in spans[a].iter().flat_map(|own| spans[b].iter().map(move |theirs| (own, theirs))) {
                let height = own.to.min(theirs.to) - own.from.max(theirs.from);
                if let Some(apart) = apart.filter(|_| height > Micrometres::ZERO) {
                    note(
                        (b.min(a), Some(b.max(a))),
                        apart - (own.diameter + theirs.diameter).half(),
                        of_height(height),
                    );
                }
            }
        }
    }
    let name = |index: usize| &part.holes[index].name;
    let mut faults = Vec::with_capacity(thinnest.len());
    for ((own, other), (wall, least)) in thinnest {
        let beside = match other {
            None => Beside::Edge,
            Some(other) if other == own => Beside::Twin,
            Some(other) => Beside::Other(name(other).clone()),
        };
        let shift = shift(&part.holes[own], shop).max(shift(&part.holes[other.unwrap_or(own)], shop));
        let gone = wall <= shift;
        faults.push((
            name(own),
            if gone { Fault::NoWall { beside, wall, shift } } else { Fault::Wall { beside, wall, least } },
        ));
    }
    Ok(faults)
}

/// How far a hole may lie aside: half of the width that the drawing permits; nothing where it has no width.
fn shift(hole: &Hole, shop: &Shop<'_>) -> Micrometres {
    let width = match hole.centre_tolerance {
        CentreTolerance::Width(width) => Some(width),
        CentreTolerance::Grade { it } => {
            hole.smallest_centre_distance().and_then(|distance| tolerance_width(it, distance, shop.knowledge).ok())
        }
    };
    width.unwrap_or_default().half()
}

/// A plate that springs under the largest thrust by more than the feed: as the point breaks through, it snatches.
///
/// The plate is a beam on two supports, which stand under the clamps: F·a²·b²/(3·E·I·L), or beyond the last of them a
/// cantilever: F·c³/(3·E·I); I = w·t³/12. A load spreads no wider than the span is long.
fn springs(
    hole: &Hole,
    transitions: &[Transition],
    plan: &Plan,
    shop: &Shop<'_>,
) -> Result<Option<Fault>, KnowledgeError> {
    let Some(clamping) = &plan.clamping else { return Ok(None) };
    let group = shop.material.group;
    // A new group of materials need not have a row: lathes ask for it, and a plate is then not checked.
    let Some(modulus) = shop.knowledge.find(|row: &ElasticModulus<'_>| row.material_group == group)? else {
        return Ok(None);
    };
    let feeds = limit(ProofLimit::PlateSpringFeeds, shop)?;
    // What the file names may stand on more supports than are under its clamps; nobody says so of our own straps.
    let gives = Some(limit(ProofLimit::PlateSpringMost, shop)?).filter(|_| clamping.proposed);
    let extent = |of: fn(&Point) -> Micrometres| {
        let ends = (clamping.clamps.iter().map(of).min(), clamping.clamps.iter().map(of).max());
        ends.0.zip(ends.1).map_or(Micrometres::ZERO, |(low, high)| high - low)
    };
    let along_x = extent(|at| at.x) >= extent(|at| at.y);
    let along = |at: &Point| if along_x { at.x } else { at.y };
    let (blank, across) = (&plan.part.blank, if along_x { plan.part.blank.width } else { plan.part.blank.length });
    let supports: Vec<Micrometres> = clamping.clamps.iter().map(along).collect();
    let mut worst: Option<(f64, Fault)> = None;
    for transition in transitions.iter().filter(|transition| !transition.elsewhere) {
        let Some(thrust) = transition.conditions.axial_force_n else { continue };
        for at in hole.at.iter().map(along) {
            let before = supports.iter().filter(|own| **own <= at).max().map(|own| (at - *own).to_mm());
            let after = supports.iter().filter(|own| **own >= at).min().map(|own| (*own - at).to_mm());
            let (span, shape) = match (before, after) {
                (Some(a), Some(b)) if a + b > 0.0 => (a + b, a * a * b * b / (a + b)),
                (Some(c), None) | (None, Some(c)) => (c, c * c * c),
                _ => continue,
            };
            let thickness = blank.thickness.to_mm();
            let inertia = across.to_mm().min(span) * thickness * thickness * thickness / 12.0;
            let spring = thrust.0 * shape / (3.0 * modulus.modulus.0.to_f64() * inertia);
            let most = feeds * transition.conditions.feed_mm_per_rev.0;
            if spring > most && worst.as_ref().is_none_or(|(known, _)| spring > *known) {
                let (operation, span) = (transition.operation, Micrometres::from_mm_rounded(span));
                // Beyond what such straps bear the plate is not held.
                let beyond = gives.filter(|gives| spring > *gives);
                let (most, gives) = (beyond.unwrap_or(most), beyond.is_some());
                let fault = Fault::PlateSprings { operation, thrust, spring, span, most, gives };
                worst = Some((spring, fault));
            }
        }
    }
    Ok(worst.map(|(_, fault)| fault))
}
