//! The schemes of the tables A.6, A.8 and A.9 for a cylinder, best first.

use std::rc::Rc;

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::query::TypedAnswer;
use crate::knowledge::{Column, Knowledge};
use crate::note::{Because, Figure, Note};
use crate::plan::{Operation, RouteSource};
use crate::reason::Reason;
use crate::shop::Shop;
use crate::tables::holes::{
    HoleDefault, PositionAsked, RouteStagesFor, Scheme, SchemesOfMainHole, SchemesOfMainHoleFor, Stage, StagedHole,
};
use crate::tables::rules::{
    BlankState, CellTaken, CentreColumn, CentreFirstFor, CentredTwin, EmptyCellFor, GradeAsked, SchemeTaken,
    StockForElsewhereFor, TableForHole, TableForHoleFor, WhichOfTwoSchemesFor,
};
use crate::units::{Decimal, ItGrade, Micrometres, Roughness, round_to};

use super::bores::Bore;
use super::{Candidate, Promise};

/// The arguments of a table query.
#[derive(Clone, Copy, Debug)]
pub struct SchemeQuestion<'a> {
    /// The cylinder.
    pub bore: &'a Bore,
    /// The tolerance on centre distances for the query.
    pub centre_tolerance: Micrometres,
    /// The tolerance of the drawing: for an unmachined face the query uses a tighter one.
    pub drawn_tolerance: Micrometres,
    /// Permitted position of the axis, Δ0 of A.6.
    pub position: Micrometres,
    /// Whether the hole lies in an outer wall.
    pub outer_wall: bool,
    /// Every drill that reaches, ascending.
    pub drills: &'a [Micrometres],
}

/// A filled cell of A.8 or A.9.
struct Cell<'k> {
    grade: ItGrade,
    roughness: Roughness,
    row: SchemesOfMainHole<'k>,
    answer: TypedAnswer<'k, SchemesOfMainHole<'k>>,
    /// Why its table was asked.
    table_asked: Rc<TableAsked<'k>>,
    finish_elsewhere: bool,
}

/// The reason for a table query, kept as data because most of them are never printed.
struct TableAsked<'k> {
    answer: TypedAnswer<'k, TableForHole<'k>>,
    table: &'k str,
    grade: ItGrade,
    asked_grade: ItGrade,
    asked_centre: Micrometres,
}

impl TableAsked<'_> {
    fn because(&self) -> Because {
        let note = Note::new("table-for-hole")
            .with("it", self.grade)
            .with("table", self.table)
            .with("asked-it", self.asked_grade)
            .with("centre", self.asked_centre);
        Because::answer(&self.answer.answer, note)
    }
}

impl Cell<'_> {
    fn is_of_row(&self, other: &Cell<'_>) -> bool {
        let (row, other) = (self.row.row, other.row.row);
        row.table.id == other.table.id && row.index == other.index
    }
}

/// All schemes that the tables A.8 and A.9 permit, best first: those of its own cell, then of finer roughness in the
/// same grade, then of finer grades; where there is none, those of the tightest centre distances (rule `empty-cell`).
///
/// # Errors
/// The knowledge base has no answer, or the tables give no scheme.
pub fn candidates(question: &SchemeQuestion<'_>, shop: &Shop<'_>) -> Tried<Vec<Candidate>> {
    let knowledge = shop.knowledge;
    let bore = question.bore;
    let own = cells(bore.diameter.it, question, knowledge)?;
    let mut finer = Vec::new();
    for grade in (6..bore.diameter.it.number()).rev().filter_map(ItGrade::new) {
        for cell in cells(grade, question, knowledge)?.filled {
            // A finer cell that this machine only prepares does not hold the coarser grade.
            if cell.finish_elsewhere && !own.filled.iter().any(|own| own.finish_elsewhere) {
                continue;
            }
            let known = finer.iter().chain(&own.filled).any(|other: &Cell<'_>| other.is_of_row(&cell));
            if !known {
                finer.push(cell);
            }
        }
    }
    let mut tighter = Vec::new();
    if own.filled.is_empty() && finer.is_empty() {
        // The upper limit of the first column stands for it.
        let centre_tolerance = question.centre_tolerance.min(shop.convention(HoleDefault::FinestCentres)?);
        tighter = cells(bore.diameter.it, &SchemeQuestion { centre_tolerance, ..*question }, knowledge)?.filled;
    }
    let answer = knowledge.ask(&EmptyCellFor {
        own_cell: own.own_is_filled,
        finer_roughness: !own.own_is_filled && !own.filled.is_empty(),
        finer_grade: !finer.is_empty(),
        tighter_centres: !tighter.is_empty(),
    })?;
    let take = answer.need("this cell")?.take;
    if take == CellTaken::Nothing {
        return Err(Refusal::Not(Reason::NoScheme {
            it: bore.diameter.it,
            roughness: bore.roughness,
            centre: question.centre_tolerance,
            columns: own.table_columns,
        }));
    }
    let taken = Because::answer(&answer.answer, Note::new("cell").with("take", Figure::word(take.name())));
    // Where no work of another machine mends the position, the hole is finished here.
    let diameter = bore.diameter.target();
    let left = knowledge.ask(&StockForElsewhereFor { diameter })?.need("this diameter")?.transitions.is_some();

    let mut schemes = Vec::new();
    for cell in own.filled.into_iter().chain(finer).chain(tighter) {
        let because = [cell.table_asked.because(), taken.clone()];
        for (scheme, reason) in in_order(&cell, question, shop)? {
            let mut because = because.to_vec();
            let note = Note::new("scheme")
                .with("scheme", Figure::scheme(&scheme))
                .with("it", cell.grade)
                .with("roughness", cell.roughness);
            because.push(Because::answer(&cell.answer.answer, note));
            because.extend(reason);
            let candidate = Candidate {
                source: RouteSource::Tables,
                table: cell.row.row.table.id.clone(),
                scheme,
                transitions: Vec::new(),
                finish_elsewhere: cell.finish_elsewhere && left,
                last_resort: take == CellTaken::TighterCentres,
                promise: Some(Promise {
                    it: cell.grade,
                    roughness: Some(cell.roughness),
                    position: (left || !cell.finish_elsewhere).then_some(question.drawn_tolerance),
                }),
                because,
            };
            schemes.push(with_transitions(candidate, bore, shop)?);
        }
    }
    Ok(schemes)
}

/// The stages of A.6, and whether the last one is on another machine.
///
/// # Errors
/// The knowledge base has no answer.
pub fn stages(
    question: &SchemeQuestion<'_>,
    hole: StagedHole,
    diameter: Micrometres,
    shop: &Shop<'_>,
) -> Result<(Because, bool), KnowledgeError> {
    let (delta, grade) = (question.position, question.bore.diameter.it);
    let sigma = shop.machine.position_accuracy;
    let position = if delta > sigma { PositionAsked::Above } else { PositionAsked::NotAbove };
    let answer = shop.knowledge.ask(&RouteStagesFor { hole, it: grade, diameter, position })?;
    let note = |code: &'static str| Note::new(code).with("delta", delta).with("sigma", sigma).with("it", grade);
    Ok(match answer.winner()? {
        None => (Because::answer(&answer.answer, note("no-stages")), false),
        Some(row) => {
            let stages = Figure::sum_of_words(row.stages.iter().map(|stage| stage.name()));
            let note = note("stages").with("stages", stages);
            (Because::answer(&answer.answer, note), row.stages.contains(&Stage::FinalElsewhere))
        }
    })
}

/// The filled cell of A.8 or A.9 for the own grade and roughness of a cylinder; none if it is empty.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn own_cell<'k>(
    question: &SchemeQuestion<'_>,
    knowledge: &'k Knowledge,
) -> Result<Option<SchemesOfMainHole<'k>>, KnowledgeError> {
    let own = cells(question.bore.diameter.it, question, knowledge)?;
    Ok(own.filled.into_iter().next().filter(|_| own.own_is_filled).map(|cell| cell.row))
}

/// The filled cells of one grade.
struct GradeCells<'k> {
    /// Whether the cell of the required roughness itself is filled.
    own_is_filled: bool,
    /// The filled cells, coarsest admissible roughness first.
    filled: Vec<Cell<'k>>,
    /// The roughness columns of the table.
    table_columns: Vec<Roughness>,
}

fn cells<'k>(
    grade: ItGrade,
    question: &SchemeQuestion<'_>,
    knowledge: &'k Knowledge,
) -> Result<GradeCells<'k>, KnowledgeError> {
    let (bore, centre_tolerance) = (question.bore, question.centre_tolerance);
    let answer = knowledge.ask(&TableForHoleFor { it: grade, centre_tolerance })?;
    let choice = answer.need(&format!("IT {grade}"))?;
    let table = knowledge.table(choice.scheme_table)?;
    let asked_grade = match choice.grade {
        GradeAsked::Own => grade,
        GradeAsked::It13 => ItGrade::new(13).unwrap_or(grade),
    };
    let asked_centre = match choice.centre_column {
        CentreColumn::Own => centre_tolerance,
        // The upper limit of a named column stands for the column.
        CentreColumn::UpTo03 => Micrometres::new(300),
    };
    let columns = SchemesOfMainHoleFor::roughness(table).map(Column::roughness_points).unwrap_or_default();
    let table_asked = Rc::new(TableAsked { answer, table: &table.id, grade, asked_grade, asked_centre });
    let mut found = GradeCells { own_is_filled: false, filled: Vec::new(), table_columns: columns.clone() };
    for (position, roughness) in columns.into_iter().filter(|column| *column <= bore.roughness).enumerate() {
        let cell = table.ask(&SchemesOfMainHoleFor {
            it: asked_grade,
            diameter: bore.diameter.nominal,
            centre_tolerance: asked_centre,
            roughness,
            state: bore.before.state(),
            outer_wall: question.outer_wall,
        })?;
        let Some(row) = cell.winner()? else { continue };
        found.own_is_filled |= position == 0;
        found.filled.push(Cell {
            grade,
            roughness,
            finish_elsewhere: choice.finish_elsewhere || row.finish_elsewhere == Some(true),
            row,
            answer: cell,
            table_asked: Rc::clone(&table_asked),
        });
    }
    Ok(found)
}

/// The schemes of a cell in the order of the rule `which-of-two-schemes`.
fn in_order(
    cell: &Cell<'_>,
    question: &SchemeQuestion<'_>,
    shop: &Shop<'_>,
) -> Result<Vec<(String, Option<Because>)>, KnowledgeError> {
    let mut schemes: Vec<String> = cell.row.schemes.iter().map(|scheme| (*scheme).to_owned()).collect();
    if schemes.len() < 2 {
        return Ok(schemes.into_iter().map(|scheme| (scheme, None)).collect());
    }
    let answer = shop.knowledge.ask(&WhichOfTwoSchemesFor {
        for_other_drill: cell.row.if_drill_differs.is_some(),
        drill_of_that_diameter: super::diameters::final_drill(&question.bore.diameter, question.drills, shop)?
            .is_some(),
        position: question.position,
    })?;
    let take = answer.need("this cell")?.take;
    let note = Note::new("which-of-two").with("schemes", schemes.join(", ")).with("take", Figure::word(take.name()));
    if take == SchemeTaken::Second {
        schemes.reverse();
    }
    Ok(schemes.into_iter().map(|scheme| (scheme, Some(Because::answer(&answer.answer, note.clone())))).collect())
}

/// A candidate with the transitions of its scheme and the centring that section 1.2.1 requires.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn with_transitions(
    mut candidate: Candidate,
    bore: &Bore,
    shop: &Shop<'_>,
) -> Result<Candidate, KnowledgeError> {
    let scheme = candidate.scheme.clone();
    let mut row = needed(&scheme, shop)?;
    let mut transitions = row.transitions.clone();
    let (centre, reason) = centre_first(bore, shop)?;
    candidate.because.push(reason);
    if centre && transitions.first() != Some(&Operation::CentreDrill) {
        if let Some(twin) = twin(&scheme, shop)? {
            let note = Note::new("twin").with("scheme", Figure::scheme(&scheme)).with("centred", twin.centred);
            candidate.because.push(Because::row(twin.row, note));
            twin.centred.clone_into(&mut candidate.scheme);
            row = needed(twin.centred, shop)?;
            transitions.clone_from(&row.transitions);
        } else {
            let twins = shop.knowledge.table_of::<CentredTwin<'_>>()?;
            candidate.because.push(Because::table(twins, Note::new("no-twin").with("scheme", Figure::scheme(&scheme))));
            candidate.scheme = format!("{scheme} + centre");
            transitions.insert(0, Operation::CentreDrill);
        }
    }
    candidate
        .because
        .push(Because::row(row.row, Note::new("transitions").with("scheme", Figure::scheme(&candidate.scheme))));
    candidate.transitions = transitions;
    Ok(candidate)
}

/// A scheme of A.7.
///
/// # Errors
/// There is no such table.
pub(super) fn find_scheme<'s, 'k>(scheme: &str, shop: &'s Shop<'k>) -> Result<Option<&'s Scheme<'k>>, KnowledgeError> {
    Ok(shop.shelf.schemes()?.iter().find(|row| row.scheme == scheme))
}

fn needed<'s, 'k>(scheme: &str, shop: &'s Shop<'k>) -> Result<&'s Scheme<'k>, KnowledgeError> {
    match find_scheme(scheme, shop)? {
        Some(row) => Ok(row),
        None => Err(KnowledgeError::no_row(shop.knowledge.table_of::<Scheme<'_>>()?, scheme)),
    }
}

/// The scheme with centring that replaces one without, where there is one.
///
/// # Errors
/// There is no such table.
pub(super) fn twin<'k>(scheme: &str, shop: &Shop<'k>) -> Result<Option<CentredTwin<'k>>, KnowledgeError> {
    Ok(shop.knowledge.find(|row: &CentredTwin<'_>| row.scheme == scheme)?)
}

/// Whether a cylinder is centred first, by the rule `centre-first`.
///
/// # Errors
/// The knowledge base has no answer.
pub(super) fn centre_first(bore: &Bore, shop: &Shop<'_>) -> Result<(bool, Because), KnowledgeError> {
    let (diameter, grade) = (bore.diameter.nominal, bore.diameter.it);
    let depth_ratio = Decimal::from_f64_rounded(bore.place.depth.to_mm() / diameter.to_mm());
    let state = bore.before.state();
    let answer = shop.knowledge.ask(&CentreFirstFor { state, it: grade, diameter, depth_ratio })?;
    let centre = answer.need("this hole")?.centre;
    let code = match (centre, state) {
        (true, _) => "centre",
        (false, BlankState::Solid) => "no-centre",
        (false, BlankState::WithHole) => "no-centre-in-a-hole",
    };
    let note =
        Note::new(code).with("ratio", round_to(depth_ratio.to_f64(), 2)).with("it", grade).with("diameter", diameter);
    Ok((centre, Because::answer(&answer.answer, note)))
}
