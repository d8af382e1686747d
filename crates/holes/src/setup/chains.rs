//! Chains of dimensions: from which side each zero of the part is found, and whether what errs on the way from a base of the
//! drawing to a hole stays within the tolerance.
//!
//! Every term is the width of a field of error, as the centre tolerance of a group is a width. Of two holes of one set-up and one
//! zero the tool errs at both axes: section 1.2.1 gives the accuracy of the position of holes. It does not say whether that of an axis
//! or that of two to each other, so the second is a term that nothing confirms. Worst case Σω, statistically √Σω², the field of
//! 99.7 % of parts where the errors are normal.

use crate::error::KnowledgeError;
use crate::note::{Because, Figure, Finding, Note, Severity};
use crate::part::{Along, Base, Face, Part, Side};
use crate::plan::{Chain, ChainClosing, ChainError, ChainTerm, Feature, HeldBy, HolePlan, PartZero};
use crate::shop::Shop;
use crate::tables::holes::PositionAccuracy;
use crate::tables::materials::{SettingError, SettingErrorOf};
use crate::tables::rules::{ChainClosingFor, ChainSeverity, ChainZeros, ChainZerosFor};
use crate::units::Micrometres;

use super::fixture::locating_error;

/// The zeros and chains of a part, with what does not close.
#[derive(Debug, Default)]
pub struct Chains {
    /// The zeros of the first set-up; none where the drawing says nothing of its dimensions.
    pub zeros: Vec<PartZero>,
    /// The chains of the dimensions that are made here.
    pub chains: Vec<Chain>,
    /// What does not close, or is not known to.
    pub findings: Vec<Finding>,
}

/// The zeros and chains of a planned part, held by that.
///
/// # Errors
/// The knowledge base has no answer.
pub fn chains(part: &Part, holes: &[HolePlan], held: HeldBy, shop: &Shop<'_>) -> Result<Chains, KnowledgeError> {
    if part.dimensions.is_empty() {
        return Ok(Chains::default());
    }
    let errors = Errors::read(held, shop)?;
    let one = one_zero(part);
    let each = a_zero_for_each(part, &one);
    let of_one = Measured { part, holes, zeros: std::slice::from_ref(&one), errors: &errors }.chains(shop)?;
    let of_each = Measured { part, holes, zeros: &each, errors: &errors }.chains(shop)?;
    let close =
        |chains: &[(Chain, _)]| chains.iter().filter(|(chain, _)| chain.closing == Some(ChainClosing::AtWorst)).count();
    let ask = ChainZerosFor { several: each.len() > 1, more_close: close(&of_each) > close(&of_one) };
    let answer = shop.knowledge.ask(&ask)?;
    let because = Because::answer(&answer.answer, Note::new("chain-zeros"));
    let (zeros, chains) = match answer.need("several")?.zeros {
        ChainZeros::One => (vec![one], of_one),
        ChainZeros::Each => (each, of_each),
    };
    let mut findings = Vec::new();
    for (chain, lacks) in &chains {
        findings.extend(told(chain, *lacks, shop)?);
    }
    let with_reason = |(mut chain, _): (Chain, _)| {
        chain.because.push(because.clone());
        chain
    };
    Ok(Chains { zeros, chains: chains.into_iter().map(with_reason).collect(), findings })
}

/// A zero at the sides where most dimensions begin; where none does, or as many, at those where the zero of the drawing lies.
fn one_zero(part: &Part) -> PartZero {
    let side = |axis: Along| {
        let own = part.side_of_zero(axis);
        let begin = |side: Side| {
            let holes = part.holes.iter().filter(|hole| part.datum_side(&hole.name, axis) == Some(side));
            (holes.count(), side == own)
        };
        let [low, high] = sides(axis);
        if begin(high) > begin(low) { high } else { low }
    };
    let (x, y) = (side(Along::X), side(Along::Y));
    PartZero { x, y, holes: part.holes.iter().map(|hole| hole.name.clone()).collect() }
}

/// A zero for every pair of sides that holes are dimensioned from; the first is the one zero, with what is dimensioned from neither.
fn a_zero_for_each(part: &Part, one: &PartZero) -> Vec<PartZero> {
    let mut zeros = vec![PartZero { holes: Vec::new(), ..one.clone() }];
    for hole in &part.holes {
        let [x, y] = [Along::X, Along::Y].map(|axis| part.datum_side(&hole.name, axis).unwrap_or(one.side(axis)));
        match zeros.iter_mut().find(|zero| (zero.x, zero.y) == (x, y)) {
            Some(zero) => zero.holes.push(hole.name.clone()),
            None => zeros.push(PartZero { x, y, holes: vec![hole.name.clone()] }),
        }
    }
    zeros.retain(|zero| !zero.holes.is_empty());
    zeros
}

const fn sides(axis: Along) -> [Side; 2] {
    match axis {
        Along::X => [Side::Left, Side::Right],
        Along::Y => [Side::Front, Side::Back],
    }
}

/// The errors of setting, each with its row.
struct Errors<'k> {
    /// None where nothing that the plan knows holds the part.
    locating: Option<SettingError<'k>>,
    touch: SettingError<'k>,
    truing: SettingError<'k>,
    /// Why both axes err between two holes of one zero.
    both_axes: Because,
}

impl<'k> Errors<'k> {
    fn read(held: HeldBy, shop: &Shop<'k>) -> Result<Self, KnowledgeError> {
        let row =
            |wanted: SettingErrorOf| shop.knowledge.need(wanted.name(), |row: &SettingError<'_>| row.name.is(wanted));
        let locating = locating_error(held, shop)?;
        let of_positions = shop.knowledge.table_of::<PositionAccuracy<'_>>()?;
        let both_axes = Because::table(of_positions, Note::new("chain-both-axes"));
        Ok(Self { locating, touch: row(SettingErrorOf::Touch)?, truing: row(SettingErrorOf::Truing)?, both_axes })
    }
}

/// The transition that makes the axis of a hole here: the field of its error, and the face it is entered from. None where another
/// machine finishes the hole, or the axis is that of the blank.
fn axis_of(plan: &HolePlan) -> Option<(Micrometres, Face)> {
    let of_bore = || plan.transitions.iter().filter(|one| one.feature == Feature::Bore && one.step.is_none());
    if of_bore().any(|one| one.elsewhere) {
        return None;
    }
    let made = of_bore().rfind(|one| one.achieved.as_ref().is_some_and(|achieved| achieved.position_mm.is_some()))?;
    Some((made.achieved.as_ref()?.position_mm?, made.face))
}

/// What chains are computed from.
struct Measured<'a, 'k> {
    part: &'a Part,
    holes: &'a [HolePlan],
    zeros: &'a [PartZero],
    errors: &'a Errors<'k>,
}

/// What nobody says, so that a chain is not known to close.
#[derive(Clone, Copy, Debug)]
enum Lacking {
    /// How far the part is off in a fixture of the shop's own.
    Locating,
    /// The tolerance of the blank between two sides.
    Size,
}

/// The terms of a chain as they are found.
#[derive(Default)]
struct Terms {
    all: Vec<ChainTerm>,
    because: Vec<Because>,
    /// What lacks, the last of several.
    lacks: Option<Lacking>,
}

impl Terms {
    fn push(&mut self, what: ChainError, field_mm: Micrometres) {
        self.all.push(ChainTerm { what, field_mm, unconfirmed: false });
    }

    fn row(&mut self, what: ChainError, row: &SettingError<'_>, field_mm: Micrometres) {
        let because = Because::row(row.row, Note::new("chain-term").with("field", field_mm));
        self.all.push(ChainTerm { what, field_mm, unconfirmed: because.unconfirmed.is_some() });
        if !self.because.contains(&because) {
            self.because.push(because);
        }
    }
}

impl Measured<'_, '_> {
    fn chains(&self, shop: &Shop<'_>) -> Result<Vec<(Chain, Option<Lacking>)>, KnowledgeError> {
        let mut chains = Vec::new();
        for dimension in &self.part.dimensions {
            let Base::Hole(hole) = &dimension.to else { continue };
            let Some(terms) = self.terms(hole, &dimension.from, dimension.axis) else { continue };
            let mut chain = Chain {
                hole: hole.clone(),
                from: dimension.from.clone(),
                axis: dimension.axis,
                tolerance_mm: dimension.tolerance_mm,
                terms: terms.all,
                worst_mm: None,
                likely_mm: None,
                closing: None,
                because: terms.because,
            };
            chain.terms.sort_by_key(|term| (std::cmp::Reverse(term.field_mm), term.what));
            if terms.lacks.is_none() {
                let (worst, likely) = (worst(&chain.terms), likely(chain.terms.iter()));
                (chain.worst_mm, chain.likely_mm) = (Some(worst), Some(likely));
                let answer = shop.knowledge.ask(&closing_of(&chain, worst, likely))?;
                chain.closing = Some(answer.need("worst")?.closing);
                chain.because.push(Because::answer(&answer.answer, Note::new("chain-closing")));
            }
            chains.push((chain, terms.lacks));
        }
        Ok(chains)
    }

    /// What errs between a base and a hole; none where an end of it is not made here.
    fn terms(&self, hole: &str, from: &Base, axis: Along) -> Option<Terms> {
        let (field, face) = self.axis(hole)?;
        let mut terms = Terms::default();
        match from {
            Base::Side(side) => {
                terms.push(ChainError::Axis, field);
                self.of_side(hole, face, *side, axis, &mut terms);
            }
            Base::Hole(base) => {
                let (other, other_face) = self.axis(base)?;
                let (zero, of_base) = (self.zero(hole, face), self.zero(base, other_face));
                if face == other_face && zero == of_base {
                    terms.push(ChainError::Axis, field.max(other));
                    // Were the figures of two holes to each other, the field would end here.
                    terms.all.push(ChainTerm {
                        what: ChainError::OtherAxis,
                        field_mm: field.min(other),
                        unconfirmed: true,
                    });
                    terms.because.push(self.errors.both_axes.clone());
                } else {
                    terms.push(ChainError::Axis, field);
                    terms.push(ChainError::OtherAxis, other);
                    // The holes meet by the side that the first of the two zeros is found at.
                    let side = of_base.side(axis);
                    self.of_side(hole, face, side, axis, &mut terms);
                    self.of_side(base, other_face, side, axis, &mut terms);
                }
            }
        }
        Some(terms)
    }

    fn axis(&self, hole: &str) -> Option<(Micrometres, Face)> {
        axis_of(self.holes.iter().find(|plan| plan.name == hole)?)
    }

    /// The zero that a hole is counted from: in the second set-up there is one, at the sides of the first.
    fn zero(&self, hole: &str, face: Face) -> &PartZero {
        let own = self.zeros.iter().filter(|_| face == Face::Entry);
        let mut own = own.filter(|zero| zero.holes.iter().any(|name| name == hole));
        own.next().unwrap_or(&self.zeros[0])
    }

    /// What errs between a side and the axes of the machine where a hole is made.
    fn of_side(&self, hole: &str, face: Face, side: Side, axis: Along, terms: &mut Terms) {
        let zero = self.zero(hole, face);
        terms.row(ChainError::Touch, &self.errors.touch, self.errors.touch.most);
        // Every other zero is found at each part anew.
        if *zero == self.zeros[0] {
            match &self.errors.locating {
                Some(row) => terms.row(ChainError::Locating, row, row.most),
                None => terms.lacks = Some(Lacking::Locating),
            }
        }
        let lever = self.lever(hole, axis);
        let truing = &self.errors.truing;
        let over = truing.over.filter(|over| *over > Micrometres::ZERO);
        let turned = over.map_or(truing.most, |over| truing.most.ratio(lever.micrometres(), over.micrometres()));
        terms.row(ChainError::Truing, &self.errors.truing, turned);
        if zero.side(axis) != side {
            match self.part.size_tolerance(axis) {
                Some(tolerance) => terms.push(ChainError::Size, tolerance),
                None => terms.lacks = Some(Lacking::Size),
            }
        }
    }

    /// How far along its side a hole of the group is from where the side may be touched, at worst.
    fn lever(&self, hole: &str, axis: Along) -> Micrometres {
        let (datum, blank) = (&self.part.datum, &self.part.blank);
        let (low, size) = match axis {
            Along::X => (datum.front, blank.width),
            Along::Y => (datum.left, blank.length),
        };
        let across = if axis == Along::X { Along::Y } else { Along::X };
        let group = self.part.holes.iter().find(|group| group.name == hole);
        let points = group.into_iter().flat_map(|group| &group.at).map(|at| across.of(*at) - low);
        points.map(|from| from.max(size - from)).max().unwrap_or_default()
    }
}

fn worst(terms: &[ChainTerm]) -> Micrometres {
    terms.iter().fold(Micrometres::ZERO, |sum, term| sum + term.field_mm)
}

fn likely<'t>(terms: impl Iterator<Item = &'t ChainTerm>) -> Micrometres {
    let squares: f64 = terms.map(|term| term.field_mm.to_mm() * term.field_mm.to_mm()).sum();
    Micrometres::from_mm_rounded(squares.sqrt())
}

fn closing_of(chain: &Chain, worst: Micrometres, all: Micrometres) -> ChainClosingFor {
    let sure = likely(chain.terms.iter().filter(|term| !term.unconfirmed));
    let within = |field: Micrometres| field <= chain.tolerance_mm;
    ChainClosingFor { worst: within(worst), likely: within(all), sure: within(sure) }
}

/// What is to be said of a chain that does not close at worst.
fn told(chain: &Chain, lacks: Option<Lacking>, shop: &Shop<'_>) -> Result<Option<Finding>, KnowledgeError> {
    let told = |code: String| {
        let from = match &chain.from {
            Base::Side(side) => Figure::word_of("side", side.name()),
            Base::Hole(name) => Figure::called(name),
        };
        Note::new(code).with("axis", chain.axis.letter()).with("from", from).with("tolerance", chain.tolerance_mm)
    };
    if let Some(lacks) = lacks {
        let code = match lacks {
            Lacking::Locating => "chain-without-locating",
            Lacking::Size => "chain-without-size",
        };
        return Ok(Some(Finding::of_hole(Severity::Doubtful, &chain.hole, told(code.to_owned()))));
    }
    let (Some(worst), Some(likely)) = (chain.worst_mm, chain.likely_mm) else { return Ok(None) };
    let answer = shop.knowledge.ask(&closing_of(chain, worst, likely))?;
    let row = answer.need("worst")?;
    let severity = match row.severity {
        ChainSeverity::None => return Ok(None),
        ChainSeverity::Doubtful => Severity::Doubtful,
        ChainSeverity::Wrong => Severity::Wrong,
    };
    let sum = chain.terms.iter().map(|term| Figure::number(term.field_mm.to_string())).collect();
    let costliest = chain.terms.first().map_or("", |term| term.what.name());
    let note = told(format!("chain-{}", row.closing.name()))
        .with("sum", Figure::List(sum, " + "))
        .with("worst", worst)
        .with("likely", likely)
        .with("term", Figure::word_of("chain-term", costliest))
        .with("most", chain.terms.first().map(|term| term.field_mm).unwrap_or_default());
    Ok(Some(Finding::of_hole(severity, &chain.hole, note)))
}
