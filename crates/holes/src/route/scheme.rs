//! Which schemes the tables A.6, A.8 and A.9 give a cylinder, best first.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::query::roughness_points;
use crate::knowledge::units::Unit;
use crate::knowledge::{Answer, Input, Knowledge, QueryError, RowRef};
use crate::note::{Because, Note};
use crate::part::BlankHole;
use crate::plan::{Operation, Way};
use crate::reason::Reason;
use crate::shop::Shop;
use crate::units::{Decimal, ItGrade, Micrometres, Roughness};

use super::bores::{Before, Bore};
use super::{Candidate, Promise};

/// What the tables are asked about.
#[derive(Clone, Copy, Debug)]
pub struct Question<'a> {
    /// The cylinder.
    pub bore: &'a Bore,
    /// The tolerance on centre distances that the tables are asked with.
    pub centre_tolerance: Micrometres,
    /// The same as the drawing has it: an unmachined face makes the tables be asked with a tighter one.
    pub drawn_tolerance: Micrometres,
    /// Permitted position of the axis, Δ0 of A.6.
    pub position: Micrometres,
    /// Whether the hole lies in an outer wall.
    pub outer_wall: bool,
    /// Every drill that reaches, ascending.
    pub drills: &'a [Micrometres],
}

impl Question<'_> {
    fn state(&self) -> &'static str {
        match self.bore.before {
            Before::Blank(BlankHole::Solid) => "solid",
            _ => "cast-or-pre-machined",
        }
    }
}

/// A filled cell of A.8 or A.9.
struct Cell<'k> {
    grade: ItGrade,
    roughness: Roughness,
    row: RowRef<'k>,
    answer: Answer<'k>,
    because: Vec<Because>,
    finish_elsewhere: bool,
}

/// Every scheme the tables A.8 and A.9 allow, best first: the own cell, then finer roughness of the same
/// grade, then finer grades (rule `empty-cell`).
///
/// # Errors
/// The knowledge cannot answer, or the tables give no scheme.
pub fn candidates(question: &Question<'_>, shop: &Shop<'_>) -> Tried<Vec<Candidate>> {
    let knowledge = shop.knowledge;
    let bore = question.bore;
    let own = cells(bore.diameter.it, question, knowledge)?;
    let mut finer = Vec::new();
    for grade in (6..bore.diameter.it.number()).rev().filter_map(ItGrade::new) {
        for cell in cells(grade, question, knowledge)?.filled {
            // A finer grade that this machine only prepares does not hold the coarser one.
            if cell.finish_elsewhere && !own.filled.iter().any(|own| own.finish_elsewhere) {
                continue;
            }
            let known = finer
                .iter()
                .chain(&own.filled)
                .any(|other: &Cell<'_>| other.row.table.id == cell.row.table.id && other.row.index == cell.row.index);
            if !known {
                finer.push(cell);
            }
        }
    }
    let rule = knowledge.table("empty-cell")?;
    let answer = rule.decide(&[
        ("own_cell", Input::Bool(own.own_is_filled)),
        ("finer_roughness", Input::Bool(!own.own_is_filled && !own.filled.is_empty())),
        ("finer_grade", Input::Bool(!finer.is_empty())),
    ])?;
    let decision = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this cell"))?;
    if decision.text("take")? == "nothing" {
        return Err(Refusal::Not(Reason::NoScheme {
            it: bore.diameter.it,
            roughness: bore.roughness,
            centre: question.centre_tolerance,
            columns: own.table_columns,
        }));
    }
    let taken = Because::answer(&answer, Note::new("cell").with("take", decision.text("take")?));

    let mut schemes = Vec::new();
    for cell in own.filled.into_iter().chain(finer) {
        let mut because = cell.because.clone();
        because.push(taken.clone());
        for (scheme, reason) in in_order(&cell, question, knowledge)? {
            let mut because = because.clone();
            let note =
                Note::new("scheme").with("scheme", &scheme).with("it", cell.grade).with("roughness", cell.roughness);
            because.push(Because::answer(&cell.answer, note));
            because.extend(reason);
            let candidate = Candidate {
                way: Way::Tables,
                table: cell.row.table.id.clone(),
                scheme,
                transitions: Vec::new(),
                finish_elsewhere: cell.finish_elsewhere,
                promise: Some(Promise {
                    it: cell.grade,
                    roughness: Some(cell.roughness),
                    position: Some(question.drawn_tolerance),
                }),
                because,
            };
            schemes.extend(with_transitions(candidate, bore, shop)?);
        }
    }
    Ok(schemes)
}

/// The stages of A.6, and whether they end on another machine.
///
/// # Errors
/// The knowledge cannot answer.
pub fn stages(
    question: &Question<'_>,
    hole: &str,
    diameter: Micrometres,
    shop: &Shop<'_>,
) -> Result<(Because, bool), KnowledgeError> {
    let table = shop.knowledge.table("A.6")?;
    let (delta, it) = (question.position, question.bore.diameter.it);
    let sigma = shop.machine.position_accuracy;
    let position = if delta > sigma { "above" } else { "not-above" };
    let answer = table.decide(&[
        ("hole", Input::Text(hole)),
        ("it", Input::Grade(it)),
        ("diameter", Input::Length(diameter)),
        ("position", Input::Text(position)),
    ])?;
    let note = |code: &str| Note::new(code).with("delta", delta).with("sigma", sigma).with("it", it);
    Ok(match answer.winner() {
        None => (Because::answer(&answer, note("no-stages")), false),
        Some(row) => {
            let stages = row.texts("stages")?;
            let elsewhere = stages.contains(&"final-other");
            (Because::answer(&answer, note("stages").with("stages", stages.join(" + "))), elsewhere)
        }
    })
}

/// The filled cell of A.8 or A.9 of a cylinder's own grade and roughness; nothing where it is empty.
///
/// # Errors
/// The knowledge cannot answer.
pub(super) fn own_cell<'k>(
    question: &Question<'_>,
    knowledge: &'k Knowledge,
) -> Result<Option<RowRef<'k>>, KnowledgeError> {
    let own = cells(question.bore.diameter.it, question, knowledge)?;
    Ok(own.filled.first().filter(|_| own.own_is_filled).map(|cell| cell.row))
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
    question: &Question<'_>,
    knowledge: &'k Knowledge,
) -> Result<GradeCells<'k>, KnowledgeError> {
    let (bore, centre_tolerance) = (question.bore, question.centre_tolerance);
    let rule = knowledge.table("table-for-hole")?;
    let answer = rule.decide(&[("it", Input::Grade(grade)), ("centre_tolerance", Input::Length(centre_tolerance))])?;
    let choice = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, &format!("IT {grade}")))?;
    let table = knowledge.table(choice.text("scheme_table")?)?;
    let asked_grade = choice.text("grade")?.parse().unwrap_or(grade);
    let asked_centre = match choice.text("centre_column")? {
        "own" => centre_tolerance,
        // The upper end of the named column stands for the column.
        _ => Micrometres::new(300),
    };
    let columns = roughness_points(table, "roughness");
    let mut found = GradeCells { own_is_filled: false, filled: Vec::new(), table_columns: columns.clone() };
    for (position, roughness) in columns.into_iter().filter(|column| *column <= bore.roughness).enumerate() {
        let cell = ask(table, asked_grade, asked_centre, roughness, question)?;
        let Some(row) = cell.winner() else { continue };
        found.own_is_filled |= position == 0;
        let note = Note::new("table-for-hole")
            .with("it", grade)
            .with("table", &table.id)
            .with("asked-it", asked_grade)
            .with("centre", asked_centre);
        found.filled.push(Cell {
            grade,
            roughness,
            row,
            answer: cell,
            because: vec![Because::answer(&answer, note)],
            finish_elsewhere: choice.flag("finish_elsewhere") || row.flag("finish_elsewhere"),
        });
    }
    Ok(found)
}

fn ask<'k>(
    table: &'k crate::knowledge::Table,
    grade: ItGrade,
    centre: Micrometres,
    roughness: Roughness,
    question: &Question<'_>,
) -> Result<Answer<'k>, QueryError> {
    table.decide(&[
        ("it", Input::Grade(grade)),
        ("diameter", Input::Length(question.bore.diameter.nominal)),
        ("centre_tolerance", Input::Length(centre)),
        ("roughness", Input::Roughness(roughness)),
        ("state", Input::Text(question.state())),
        ("outer_wall", Input::Bool(question.outer_wall)),
    ])
}

/// The schemes of a cell in the order of the rule `which-of-two-schemes`.
fn in_order(
    cell: &Cell<'_>,
    question: &Question<'_>,
    knowledge: &Knowledge,
) -> Result<Vec<(String, Option<Because>)>, KnowledgeError> {
    let mut schemes: Vec<String> = cell.row.texts("schemes")?.into_iter().map(str::to_owned).collect();
    if schemes.len() < 2 {
        return Ok(schemes.into_iter().map(|scheme| (scheme, None)).collect());
    }
    let starred = cell.row.texts("if_drill_differs").unwrap_or_default();
    let rule = knowledge.table("which-of-two-schemes")?;
    let answer = rule.decide(&[
        ("for_other_drill", Input::Bool(!starred.is_empty())),
        (
            "drill_of_that_diameter",
            Input::Bool(super::diameters::final_drill(&question.bore.diameter, question.drills).is_some()),
        ),
        ("position", Input::Length(question.position)),
    ])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this cell"))?;
    let note = Note::new("which-of-two").with("schemes", schemes.join(", ")).with("take", row.text("take")?);
    if row.text("take")? == "second" {
        schemes.reverse();
    }
    Ok(schemes.into_iter().map(|scheme| (scheme, Some(Because::answer(&answer, note.clone())))).collect())
}

/// A candidate with its scheme's transitions and the centring that section 1.2.1 asks for; nothing where
/// the scheme has a transition that no catalog names.
///
/// # Errors
/// The knowledge cannot answer.
pub(super) fn with_transitions(
    mut candidate: Candidate,
    bore: &Bore,
    shop: &Shop<'_>,
) -> Result<Option<Candidate>, KnowledgeError> {
    let knowledge = shop.knowledge;
    let schemes = knowledge.table("A.7")?;
    let scheme = candidate.scheme.clone();
    let row = schemes.find("scheme", &scheme).ok_or_else(|| KnowledgeError::no_row(schemes, &scheme))?;
    let Some(mut transitions) = operations(row)? else { return Ok(None) };
    let (centre, reason) = centre_first(bore, shop)?;
    candidate.because.push(reason);
    if centre && transitions.first() != Some(&Operation::CentreDrill) {
        let twins = knowledge.table("centred-twin")?;
        if let Some(twin) = twins.find("scheme", &scheme) {
            let centred = twin.text("centred")?;
            let note = Note::new("twin").with("scheme", &scheme).with("centred", centred);
            candidate.because.push(Because::row(twin, note));
            centred.clone_into(&mut candidate.scheme);
            let row = schemes.find("scheme", centred).ok_or_else(|| KnowledgeError::no_row(schemes, centred))?;
            if let Some(own) = operations(row)? {
                transitions = own;
            }
        } else {
            candidate.because.push(Because::table(twins, Note::new("no-twin").with("scheme", &scheme)));
            candidate.scheme = format!("{scheme} + centre");
            transitions.insert(0, Operation::CentreDrill);
        }
    }
    let row = schemes.find("scheme", candidate.scheme.trim_end_matches(" + centre"));
    let note = Note::new("transitions").with("scheme", &candidate.scheme);
    candidate.because.extend(row.map(|row| Because::row(row, note)));
    candidate.transitions = transitions;
    Ok(Some(candidate))
}

/// Whether a cylinder is centred first, by the rule `centre-first`.
///
/// # Errors
/// The knowledge cannot answer.
pub(super) fn centre_first(bore: &Bore, shop: &Shop<'_>) -> Result<(bool, Because), KnowledgeError> {
    let rule = shop.knowledge.table("centre-first")?;
    let diameter = bore.diameter.nominal;
    let ratio = Decimal::from_f64_rounded(bore.place.depth.to_mm() / diameter.to_mm());
    let state = if bore.before.is_solid() { "solid" } else { "cast-or-pre-machined" };
    let answer = rule.decide(&[
        ("state", Input::Text(state)),
        ("it", Input::Grade(bore.diameter.it)),
        ("diameter", Input::Length(diameter)),
        ("depth_ratio", Input::Number(ratio, Unit::None)),
    ])?;
    let asked = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this hole"))?.flag("centre");
    let code = match (asked, bore.before.is_solid()) {
        (true, _) => "centre",
        (false, true) => "no-centre",
        (false, false) => "no-centre-in-a-hole",
    };
    let note = Note::new(code).with("ratio", ratio).with("it", bore.diameter.it).with("diameter", diameter);
    Ok((asked, Because::answer(&answer, note)))
}

pub(super) fn operations(row: RowRef<'_>) -> Result<Option<Vec<Operation>>, KnowledgeError> {
    Ok(row.texts("transitions")?.into_iter().map(Operation::from_name).collect())
}
