//! Pins of the fixture in finished holes of the blank: their sizes, and what they cost in accuracy (textbook 1.8, 1.9).

use crate::error::KnowledgeError;
use crate::knowledge::QueryError;
use crate::note::{Because, Finding, Note, Severity};
use crate::part::{Deviations, Part, PinHole};
use crate::plan::{LocatingPin, PartLocating, PinKind, PinPair};
use crate::shop::Shop;
use crate::tables::materials::LocatingPinFor;
use crate::units::Micrometres;

/// The pins of a part, with what does not fit.
#[derive(Debug, Default)]
pub(super) struct Pins {
    pub pins: Vec<LocatingPin>,
    pub pair: Option<PinPair>,
    pub because: Vec<Because>,
    pub findings: Vec<Finding>,
}

/// The pins for the holes that the file gives: on a plane and two holes the first is round and the second cut, on two planes and
/// a hole the one pin is cut, because a side already holds the part the other way (textbook 1.9, fig. 1.5).
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn pins(part: &Part, locating: PartLocating, shop: &Shop<'_>) -> Result<Pins, KnowledgeError> {
    let kinds: &[PinKind] = match locating {
        PartLocating::PlaneAndTwoHoles => &[PinKind::Round, PinKind::Cut],
        PartLocating::TwoPlanesAndHole | PartLocating::PlaneAndAxis => &[PinKind::Cut],
        PartLocating::ThreePlanes => &[],
    };
    let mut all = Pins::default();
    for (kind, hole) in kinds.iter().zip(&part.fixture.pins) {
        let made = pin(*kind, hole, shop)?;
        let Some((pin, why)) = made else {
            let note = Note::new("no-locating-pin").with("hole", &hole.diameter).with("at", hole.at.shown());
            all.findings.push(Finding::of_part(Severity::Doubtful, note));
            return Ok(all);
        };
        all.because.push(why);
        if pin.clearance_mm[0] < Micrometres::ZERO {
            let note = Note::new("pin-does-not-enter")
                .with("hole", &hole.diameter)
                .with("at", hole.at.shown())
                .with("smallest", hole.diameter.smallest())
                .with("field", pin.field.clone())
                .with("largest", pin.diameter_mm + pin.upper_mm);
            all.findings.push(Finding::of_part(Severity::Wrong, note));
        }
        all.pins.push(pin);
    }
    if let [round, cut] = &all.pins[..] {
        all.pair = pair(round, cut, part);
    }
    Ok(all)
}

/// The pin of a hole with its row; none where no pin of the table is that thick.
fn pin(kind: PinKind, hole: &PinHole, shop: &Shop<'_>) -> Result<Option<(LocatingPin, Because)>, KnowledgeError> {
    let diameter = hole.diameter.nominal;
    let answer = match shop.knowledge.ask(&LocatingPinFor { kind, diameter }) {
        Err(KnowledgeError::Query(QueryError::OutOfDomain { .. })) => return Ok(None),
        answer => answer?,
    };
    let row = answer.need(kind.name())?;
    let Some(limits) = Deviations::of_field(row.field, row.grade, diameter, shop.knowledge)? else { return Ok(None) };
    let least = hole.diameter.lower - limits.upper;
    let most = hole.diameter.upper - limits.lower;
    let why = Note::new("pin-clearance").with("least", least).with("most", most);
    let pin = LocatingPin {
        kind,
        at: hole.at,
        diameter_mm: diameter,
        field: format!("{}{}", row.field, row.grade.number()),
        upper_mm: limits.upper,
        lower_mm: limits.lower,
        standard: row.standard.to_owned(),
        land_mm: row.land,
        clearance_mm: [least, most],
    };
    Ok(Some((pin, Because::row(row.row, why))))
}

/// How two pins belong together; none where they stand in one place.
///
/// A cut pin of diameter D2 with lands b wide still enters its hole when it is off along the line of centres by e: the corner of
/// a land, b/2 aside, meets the hole where (b/2 + e)² + r² − b²/4 = R², with R − r = X2/2 and e small e = X2·D2/(2·b). The round
/// pin gives X1/2. What the distances may be off together, to both sides, is twice that. The part turns by (S1 + S2)/(2·L).
fn pair(round: &LocatingPin, cut: &LocatingPin, part: &Part) -> Option<PinPair> {
    let apart = round.at.distance(cut.at);
    let [[x1, s1], [x2, s2]] = [round.clearance_mm, cut.clearance_mm];
    let land = cut.land_mm.filter(|land| *land > Micrometres::ZERO)?;
    let farthest = part.holes.iter().flat_map(|hole| &hole.at).map(|at| at.distance(round.at)).max()?;
    if apart <= Micrometres::ZERO {
        return None;
    }
    let along = x1 + x2.ratio(cut.diameter_mm.micrometres(), land.micrometres());
    Some(PinPair {
        apart_mm: apart,
        distance_tolerances_mm: along.max(Micrometres::ZERO),
        turned_mm: (s1 + s2).half().ratio(farthest.micrometres(), apart.micrometres()),
    })
}
