//! Why something cannot be done, as types with figures: planning decides by the types, and sentences are made only
//! here.
//!
//! - [`Reason`]: why a hole, or a part of it, cannot be made by a route, and why a route is not taken;
//! - [`Unfit`]: why a cutter or a holder is not suitable; [`Uncut`]: why there are no cutting conditions.

mod cutting;
mod tools;

pub use cutting::Uncut;
pub use tools::{CutterFault, HolderFault, NoSize, OfOther, Unfit};

use crate::note::{Figure, IntoFigure, Note};
use crate::plan::Operation;
use crate::units::{ItGrade, Micrometres, Roughness};

/// Why a hole, or a part of it, cannot be made or is not made by a route.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)] // the figures have the names of those of the sentences
pub enum Reason {
    /// A grade for centre distances, but there is no distance.
    GradeWithoutDistance { it: ItGrade },
    /// The tables have no tolerance of that grade at that distance.
    GradeOutsideTable { it: ItGrade, distance: Micrometres, why: Note },
    /// A.8 and A.9 have no scheme in any column of roughness.
    NoScheme { it: ItGrade, roughness: Roughness, centre: Micrometres, columns: Vec<Roughness> },
    /// A.10 has no scheme for the kind of hole.
    NoAuxiliaryScheme { kind: &'static str, diameter: Micrometres, centre: Micrometres },
    /// The hole is of no group of A.4.
    NoComplexGroup { it: ItGrade, diameter: Micrometres, centre: Micrometres },
    /// A.4 has no complex for it.
    NoComplex { it: ItGrade, diameter: Micrometres, centre: Micrometres },
    /// The search found no path to the finished cylinder.
    NoPath { it: ItGrade, roughness: Roughness },
    /// Inside the search: nothing leads to a state.
    Unreachable { state: String, diameter: Micrometres },
    /// Inside the search: another transition replaces boring.
    BoredByAnother { operation: Operation },
    /// There is no hole to open.
    NoHoleToOpen { operation: Operation },
    /// The hole already has that width.
    OpenedAlready { operation: Operation, diameter: Micrometres, start: Micrometres },
    /// Less stock than a drill or mill needs.
    StockTooSmall {
        operation: Operation,
        diameter: Micrometres,
        start: Micrometres,
        stock: Micrometres,
        least: Micrometres,
    },
    /// The existing hole leaves a stock that the allowance of the transition does not permit.
    StockOutsideAllowance {
        operation: Operation,
        stock: Micrometres,
        low: Micrometres,
        high: Micrometres,
        diameter: Micrometres,
    },
    /// No drill of the diameter; the next below and above it.
    NoDrill { diameter: Micrometres, below: Option<Micrometres>, above: Option<Micrometres> },
    /// The machine cannot drive so large a drill.
    NoDrillSoLarge { diameter: Micrometres, limit: Micrometres },
    /// No drill up to that size before a mill or counterbore.
    NoDrillBefore { operation: Operation, diameter: Micrometres, largest: Micrometres },
    /// No drill up to that size before boring; the smallest hole that a bar enters.
    NoDrillBeforeBoring { diameter: Micrometres, largest: Micrometres, smallest: Micrometres },
    /// No drill within the allowance of the next transition.
    NoDrillInAllowance { operation: Operation, low: Micrometres, high: Micrometres, diameter: Micrometres },
    /// No counterbore within the allowance of the next transition.
    NoCounterboreInAllowance { operation: Operation, low: Micrometres, high: Micrometres, diameter: Micrometres },
    /// No boring bar enters the hole, on the way to a diameter.
    NoBarEnters { hole: Micrometres, diameter: Micrometres, most: Micrometres },
    /// No boring bar is so small, and there is no replacement.
    TooSmallToBore { operation: Operation, diameter: Micrometres, smallest: Micrometres },
    /// A transition that routes do not plan.
    NotPlanned { operation: Operation },
    /// Tapping without a thread.
    NoThreadToTap,
    /// No cutter leaves the shoulder flat; the next counterbores below and above it.
    NoFlatOpening { diameter: Micrometres, below: Option<Micrometres>, above: Option<Micrometres> },
    /// Nothing opens a wider cylinder from a diameter.
    NoOpening { diameter: Micrometres, start: Micrometres },
    /// No route at all.
    NoRoute,
    /// The point of the drill does not fit into a blind hole with a flat floor.
    TooShallowForFlat { depth: Micrometres, diameter: Micrometres },
    /// The circularity of the machine is too coarse for the tolerance.
    MilledNotRound { roundness: Micrometres, most: Micrometres, diameter: Micrometres },
    /// The route has no drill that a step drill could replace.
    NothingToStep,
    /// No step drill of both diameters.
    NoStepDrill { narrow: Micrometres, wide: Micrometres },
    /// Centring makes the chamfer that a step drill would make.
    ChamferedByCentring,
    /// No cutter with a holder for a transition: the most informative reason, if any, and the number of further ones.
    NoTool { operation: Operation, first: Option<Box<Unfit>>, more: usize },
    /// No conditions for a transition.
    NoConditions { operation: Operation, why: Uncut },
    /// The drills of a size that a route lacks are too short.
    DrillsTooShort { diameter: Micrometres, reach: Micrometres, needed: Micrometres },
    /// The tables rank it after the scheme that is taken.
    RankedLater { first: String },
    /// It makes the same as another route.
    SameAs { table: String, scheme: String },
    /// The proof does not accept it.
    NotProven { why: Note },
    /// The position requires boring, and it does not bore.
    BoringAsked { position: Micrometres },
    /// The position does not require boring, and it bores.
    BoringNotAsked { position: Micrometres },
    /// It leaves the finish to another machine, and another route finishes the hole here.
    FinishedHere,
    /// The tables leave the finish to another machine, and this route holds the drawing at best or not at all.
    NotSurelyFinishedHere,
}

impl Reason {
    /// No cutter with a holder for a transition: one reason stands for all, with their number; the first one that
    /// concerns the cutter and not only a holder for other shanks.
    pub fn no_tool(operation: Operation, why: Vec<Unfit>) -> Self {
        let more = why.len().saturating_sub(1);
        let telling = why.iter().position(|unfit| !unfit.is_of_other_holder()).unwrap_or_default();
        Self::NoTool { operation, first: why.into_iter().nth(telling).map(Box::new), more }
    }

    /// Whether a mill cannot make the flat floor of a hole.
    pub fn is_of_milled_floor(&self) -> bool {
        match self {
            Self::TooShallowForFlat { .. } | Self::MilledNotRound { .. } => true,
            Self::NoConditions { why, .. } => matches!(why, Uncut::MillDoesNotEnter { .. }),
            Self::NoTool { operation: Operation::Mill, first: Some(first), .. } => {
                matches!(**first, Unfit::NoSize(NoSize::NoMillEnters { .. })) || first.is_of_reach()
            }
            _ => false,
        }
    }

    /// Whether another depth may mend it: a tool or an assembly that does not reach, a point that comes out.
    pub fn is_of_depth(&self) -> bool {
        match self {
            Self::DrillsTooShort { .. } | Self::TooShallowForFlat { .. } | Self::NotProven { .. } => true,
            Self::NoTool { first: Some(first), .. } => {
                first.is_of_reach() || matches!(**first, Unfit::Holder { fault: HolderFault::TooLong { .. }, .. })
            }
            _ => false,
        }
    }

    /// The drilling for which the machine does not bear the drill in its holder: a smaller one may do.
    pub fn drill_not_borne(&self) -> Option<Operation> {
        let Self::NoTool {
            operation: operation @ (Operation::Drill | Operation::DrillOut), first: Some(first), ..
        } = self
        else {
            return None;
        };
        let unborne =
            matches!(**first, Unfit::Holder { fault: HolderFault::TooLong { .. } | HolderFault::TooHeavy { .. }, .. });
        unborne.then_some(*operation)
    }

    /// The sentence.
    pub fn note(&self) -> Note {
        let new = Note::new;
        let done =
            |code: &'static str, operation: Operation| new(code).with("operation", Figure::operation(operation.name()));
        match self {
            Self::NotProven { why } => new("not-proven").with("why", why),
            Self::GradeWithoutDistance { it: grade } => new("grade-without-distance").with("it", grade),
            Self::GradeOutsideTable { it, distance, why } => {
                new("grade-outside-table").with("it", it).with("distance", distance).with("why", why)
            }
            Self::NoScheme { it, roughness, centre, columns } => {
                // Ukrainian numbers contain commas themselves.
                let columns = Figure::List(columns.iter().map(IntoFigure::into_figure).collect(), "; ");
                new("no-scheme")
                    .with("it", it)
                    .with("roughness", roughness)
                    .with("centre", centre)
                    .with("columns", columns)
            }
            Self::NoAuxiliaryScheme { kind, diameter, centre } => {
                new("no-auxiliary-scheme").with("kind", kind).with("diameter", diameter).with("centre", centre)
            }
            Self::NoComplexGroup { it, diameter, centre } => {
                new("no-complex-group").with("it", it).with("diameter", diameter).with("centre", centre)
            }
            Self::NoComplex { it, diameter, centre } => {
                new("no-complex").with("it", it).with("diameter", diameter).with("centre", centre)
            }
            Self::NoPath { it, roughness } => new("no-path").with("it", it).with("roughness", roughness),
            Self::Unreachable { state, diameter } => {
                new("state-unreachable").with("state", state).with("diameter", diameter)
            }
            Self::BoredByAnother { operation } => done("bored-by-another", *operation),
            Self::NoHoleToOpen { operation } => done("no-hole-to-open", *operation),
            Self::OpenedAlready { operation, diameter, start } => {
                done("opened-already", *operation).with("diameter", diameter).with("start", start)
            }
            Self::StockTooSmall { operation, diameter, start, stock, least } => done("stock-too-small", *operation)
                .with("diameter", diameter)
                .with("start", start)
                .with("stock", stock)
                .with("least", least),
            Self::StockOutsideAllowance { operation, stock, low, high, diameter } => {
                done("stock-outside-allowance", *operation)
                    .with("stock", stock)
                    .with("low", low)
                    .with("high", high)
                    .with("diameter", diameter)
            }
            Self::NoDrill { diameter, below, above } => new("no-drill")
                .with("diameter", diameter)
                .with("below", size(*below))
                .with("above", size(*above))
                .with("sides", sides(*below, *above)),
            Self::NoDrillSoLarge { diameter, limit } => {
                new("no-drill-so-large").with("diameter", diameter).with("limit", limit)
            }
            Self::NoDrillBefore { operation, diameter, largest } => {
                done("no-drill-before", *operation).with("diameter", diameter).with("largest", largest)
            }
            Self::NoDrillBeforeBoring { diameter, largest, smallest } => new("no-drill-before-boring")
                .with("diameter", diameter)
                .with("largest", largest)
                .with("smallest", smallest),
            Self::NoDrillInAllowance { operation, low, high, diameter } => {
                done("no-drill-in-allowance", *operation).with("low", low).with("high", high).with("diameter", diameter)
            }
            Self::NoCounterboreInAllowance { operation, low, high, diameter } => {
                done("no-counterbore-in-allowance", *operation)
                    .with("low", low)
                    .with("high", high)
                    .with("diameter", diameter)
            }
            Self::NoBarEnters { hole, diameter, most } => {
                new("no-bar-enters").with("hole", hole).with("diameter", diameter).with("most", most)
            }
            Self::TooSmallToBore { operation, diameter, smallest } => {
                done("too-small-to-bore", *operation).with("diameter", diameter).with("smallest", smallest)
            }
            Self::NotPlanned { operation } => done("not-planned", *operation),
            Self::NoThreadToTap => new("no-thread-to-tap"),
            Self::NoFlatOpening { diameter, below, above } => new("no-flat-opening")
                .with("diameter", diameter)
                .with("below", size(*below))
                .with("above", size(*above))
                .with("sides", sides(*below, *above)),
            Self::NoOpening { diameter, start } => new("no-opening").with("diameter", diameter).with("start", start),
            Self::NoRoute => new("no-route").with("tried", 0),
            Self::TooShallowForFlat { depth, diameter } => {
                new("too-shallow-for-flat").with("depth", depth).with("diameter", diameter)
            }
            Self::MilledNotRound { roundness, most, diameter } => {
                new("milled-not-round").with("roundness", roundness).with("most", most).with("diameter", diameter)
            }
            Self::NothingToStep => new("no-step-drill"),
            Self::NoStepDrill { narrow, wide } => new("no-step-drill").with("narrow", narrow).with("wide", wide),
            Self::ChamferedByCentring => new("chamfered-by-centring"),
            Self::NoTool { operation, first, more } => {
                let note = first.as_ref().map_or_else(|| new("no-cutter"), |first| first.note());
                let note = note.with("operation", Figure::operation(operation.name()));
                if *more > 0 { note.with("more", more) } else { note }
            }
            Self::NoConditions { operation, why } => why.note().with("operation", Figure::operation(operation.name())),
            Self::DrillsTooShort { diameter, reach, needed } => {
                new("drills-too-short").with("diameter", diameter).with("reach", reach).with("needed", needed)
            }
            Self::RankedLater { first } => new("ranked-later").with("first", Figure::scheme(first)),
            Self::SameAs { table, scheme } => {
                let table = Figure::word_of("route-table", table.clone());
                new("same-as").with("table", table).with("same", Figure::scheme(scheme))
            }
            Self::BoringAsked { position } => new("position-asks-boring").with("position", position),
            Self::FinishedHere => new("finished-here"),
            Self::NotSurelyFinishedHere => new("not-surely-finished-here"),
            Self::BoringNotAsked { position } => new("boring-not-asked").with("position", position),
        }
    }
}

/// On which sides of a size there is another one.
const fn sides(below: Option<Micrometres>, above: Option<Micrometres>) -> &'static str {
    match (below, above) {
        (Some(_), Some(_)) => "both",
        (Some(_), None) => "below",
        (None, Some(_)) => "above",
        (None, None) => "none",
    }
}

/// The next existing size, as sentences show it.
fn size(size: Option<Micrometres>) -> Figure {
    size.map_or_else(|| "-".into_figure(), |size| Figure::List(vec!["Ø".into_figure(), size.into_figure()], ""))
}
