//! Which schemes the tables A.6, A.8 and A.9 give a hole, best first.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::query::roughness_points;
use crate::knowledge::units::Unit;
use crate::knowledge::{Answer, Input, Knowledge, QueryError, RowRef};
use crate::note::{Because, Note};
use crate::part::{CentreTolerance, Hole, Part};
use crate::plan::Operation;
use crate::shop::Shop;
use crate::units::{Decimal, ItGrade, Micrometres, Roughness};

use super::Candidate;

/// What the tables were asked, and the schemes they give.
#[derive(Clone, Debug)]
pub struct Candidates {
    /// The schemes, best first.
    pub schemes: Vec<Candidate>,
    /// The tolerance on centre distances the tables were asked with.
    pub centre_tolerance: Micrometres,
    /// The row of A.6, or that it has none.
    pub stages: Because,
    /// Whether A.6 finishes the hole on another machine.
    pub stages_end_elsewhere: bool,
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

/// Every scheme the tables allow the hole, best first: its own cell, then finer roughness of the same
/// grade, then finer grades (rule `empty-cell`).
///
/// # Errors
/// The knowledge cannot answer, or the centre tolerance names a grade at no distance.
pub fn candidates(hole: &Hole, part: &Part, drills: &[Micrometres], shop: &Shop<'_>) -> Tried<Candidates> {
    let knowledge = shop.knowledge;
    let centre_tolerance = centre_tolerance(hole, knowledge).map_err(Refusal::Not)?;
    let (stages, stages_end_elsewhere) = stages(hole, part, centre_tolerance, shop)?;

    let own = cells(hole.diameter.it, hole, centre_tolerance, knowledge)?;
    let mut finer = Vec::new();
    for grade in (6..hole.diameter.it.number()).rev().filter_map(ItGrade::new) {
        for cell in cells(grade, hole, centre_tolerance, knowledge)?.filled {
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
        return Err(Refusal::Not(
            Note::new("no-scheme")
                .with("it", hole.diameter.it)
                .with("roughness", hole.roughness)
                .with("centre", centre_tolerance)
                .with("columns", columns_of(&own.table_columns)),
        ));
    }
    let taken = Because::answer(&answer, Note::new("cell").with("take", decision.text("take")?));

    let mut schemes = Vec::new();
    for cell in own.filled.into_iter().chain(finer) {
        let mut because = cell.because.clone();
        because.push(taken.clone());
        let position = part.position_tolerance.unwrap_or(centre_tolerance);
        for (scheme, reason) in in_order(&cell, hole, position, drills, knowledge)? {
            let mut because = because.clone();
            let note =
                Note::new("scheme").with("scheme", &scheme).with("it", cell.grade).with("roughness", cell.roughness);
            because.push(Because::answer(&cell.answer, note));
            because.extend(reason);
            if let Some(candidate) = with_centring(scheme, &cell, because, hole, shop)? {
                schemes.push(candidate);
            }
        }
    }
    Ok(Candidates { schemes, centre_tolerance, stages, stages_end_elsewhere })
}

/// The width of the tolerance on centre distances; a grade is taken at the group's smallest distance.
fn centre_tolerance(hole: &Hole, knowledge: &Knowledge) -> Result<Micrometres, Note> {
    match hole.centre_tolerance {
        CentreTolerance::Width(width) => Ok(width),
        CentreTolerance::Grade { it } => {
            let distance =
                hole.smallest_centre_distance().ok_or_else(|| Note::new("grade-without-distance").with("it", it))?;
            crate::part::tolerance_width(it, distance, knowledge).map_err(|why| {
                Note::new("grade-outside-table").with("it", it).with("distance", distance).with("why", why)
            })
        }
    }
}

/// The stages of A.6, and whether they end on another machine.
fn stages(
    hole: &Hole,
    part: &Part,
    centre_tolerance: Micrometres,
    shop: &Shop<'_>,
) -> Result<(Because, bool), KnowledgeError> {
    let table = shop.knowledge.table("A.6")?;
    let delta = part.position_tolerance.unwrap_or(centre_tolerance);
    let sigma = shop.machine.position_accuracy;
    let position = if delta > sigma { "above" } else { "not-above" };
    let answer = table.decide(&[
        ("hole", Input::Text("plain")),
        ("it", Input::Grade(hole.diameter.it)),
        ("diameter", Input::Length(hole.diameter.nominal)),
        ("position", Input::Text(position)),
    ])?;
    let note = |code: &str| Note::new(code).with("delta", delta).with("sigma", sigma).with("it", hole.diameter.it);
    Ok(match answer.winner() {
        None => (Because::answer(&answer, note("no-stages")), false),
        Some(row) => {
            let stages = row.texts("stages")?;
            let elsewhere = stages.contains(&"final-other");
            (Because::answer(&answer, note("stages").with("stages", stages.join(" + "))), elsewhere)
        }
    })
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
    hole: &Hole,
    centre_tolerance: Micrometres,
    knowledge: &'k Knowledge,
) -> Result<GradeCells<'k>, KnowledgeError> {
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
    for (position, roughness) in columns.into_iter().filter(|column| *column <= hole.roughness).enumerate() {
        let cell = ask(table, asked_grade, hole.diameter.nominal, asked_centre, roughness)?;
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
    diameter: Micrometres,
    centre: Micrometres,
    roughness: Roughness,
) -> Result<Answer<'k>, QueryError> {
    table.decide(&[
        ("it", Input::Grade(grade)),
        ("diameter", Input::Length(diameter)),
        ("centre_tolerance", Input::Length(centre)),
        ("roughness", Input::Roughness(roughness)),
    ])
}

fn columns_of(columns: &[Roughness]) -> String {
    columns.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

/// The schemes of a cell in the order of the rule `which-of-two-schemes`.
fn in_order(
    cell: &Cell<'_>,
    hole: &Hole,
    position: Micrometres,
    drills: &[Micrometres],
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
        ("drill_of_that_diameter", Input::Bool(super::diameters::final_drill(hole, drills).is_some())),
        ("position", Input::Length(position)),
    ])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this cell"))?;
    let note = Note::new("which-of-two").with("schemes", schemes.join(", ")).with("take", row.text("take")?);
    if row.text("take")? == "second" {
        schemes.reverse();
    }
    Ok(schemes.into_iter().map(|scheme| (scheme, Some(Because::answer(&answer, note.clone())))).collect())
}

/// The scheme's transitions, with the centring that section 1.2.1 asks for.
fn with_centring(
    scheme: String,
    cell: &Cell<'_>,
    mut because: Vec<Because>,
    hole: &Hole,
    shop: &Shop<'_>,
) -> Result<Option<Candidate>, KnowledgeError> {
    let knowledge = shop.knowledge;
    let schemes = knowledge.table("A.7")?;
    let row = schemes.find("scheme", &scheme).ok_or_else(|| KnowledgeError::no_row(schemes, &scheme))?;
    let Some(mut transitions) = operations(row)? else { return Ok(None) };
    let mut name = scheme;
    let rule = knowledge.table("centre-first")?;
    let ratio = Decimal::from_f64_rounded(hole.depth.to_mm() / hole.diameter.nominal.to_mm());
    let answer = rule.decide(&[
        ("it", Input::Grade(hole.diameter.it)),
        ("diameter", Input::Length(hole.diameter.nominal)),
        ("depth_ratio", Input::Number(ratio, Unit::None)),
    ])?;
    let asked = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this hole"))?;
    let has = transitions.first() == Some(&Operation::CentreDrill);
    let note = Note::new(if asked.flag("centre") { "centre" } else { "no-centre" })
        .with("ratio", ratio)
        .with("it", hole.diameter.it)
        .with("diameter", hole.diameter.nominal);
    because.push(Because::answer(&answer, note));
    if asked.flag("centre") && !has {
        let twins = knowledge.table("centred-twin")?;
        if let Some(twin) = twins.find("scheme", &name) {
            let centred = twin.text("centred")?;
            because.push(Because::row(twin, Note::new("twin").with("scheme", &name).with("centred", centred)));
            centred.clone_into(&mut name);
            let row = schemes.find("scheme", &name).ok_or_else(|| KnowledgeError::no_row(schemes, &name))?;
            if let Some(own) = operations(row)? {
                transitions = own;
            }
        } else {
            because.push(Because::table(twins, Note::new("no-twin").with("scheme", &name)));
            name = format!("{name} + centre");
            transitions.insert(0, Operation::CentreDrill);
        }
    }
    let row = schemes.find("scheme", name.trim_end_matches(" + centre"));
    because.extend(row.map(|row| Because::row(row, Note::new("transitions").with("scheme", &name))));
    Ok(Some(Candidate {
        table: cell.row.table.id.clone(),
        scheme: name,
        transitions,
        finish_elsewhere: cell.finish_elsewhere,
        because,
    }))
}

fn operations(row: RowRef<'_>) -> Result<Option<Vec<Operation>>, KnowledgeError> {
    Ok(row.texts("transitions")?.into_iter().map(Operation::from_name).collect())
}
