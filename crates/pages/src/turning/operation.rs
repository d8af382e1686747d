//! A turning operation as a page: the blank, the surfaces, the allowances, the zones with their tools, the schemes
//! side by side.

mod jobs;
mod schemes;
mod surfaces;
mod zones;

use crate::document::{Block, Column, Document, Item, Table};
use crate::job::Norm;
use crate::knowledge::Knowledge;
use technolog_turning::allowances::areas::Area;
use technolog_turning::operation::Operation;
use technolog_turning::operation::gauging::gauges_outside;
use technolog_turning::operation::programs::OperationProgram;
use technolog_turning::operation::times::Times;
use technolog_turning::operation::work::Work;
use technolog_words::say;

use super::super::laboratory::norm::elements;
use super::cells::{Cell, fixed, table};
use super::phrases::{material, rests_on, word};
use super::{Doubts, Lang, fields, findings, section};

/// The whole page.
pub fn operation_page(
    operation: &Operation,
    times: &[Times],
    norm: Option<&Norm>,
    knowledge: &Knowledge,
    doubts: Doubts,
    lang: Lang,
) -> Document {
    let mut page = Document::new(lang.tag(), operation.workpiece.name.as_str());
    head(&mut page, operation, knowledge, lang);
    if !operation.blank_advice.is_empty() {
        section(&mut page, say!(lang, "turn-blank-label"));
        let advice = operation
            .blank_advice
            .iter()
            .map(|advice| Item::from(rests_on(&lang.say(&advice.finding.note), &advice.because, lang)));
        page.blocks.push(Block::List(advice.collect()));
    }
    section(&mut page, say!(lang, "turn-set-ups"));
    for set_up in &operation.set_ups {
        surfaces::surfaces(&mut page, operation, set_up, lang);
    }
    section(&mut page, say!(lang, "turn-allowances"));
    page.push(allowances(operation, lang));
    section(&mut page, say!(lang, "turn-zones"));
    zones::zones(&mut page, operation, lang);
    zones::additional(&mut page, operation, lang);
    section(&mut page, say!(lang, "turn-transitions"));
    for (set_up, side, zone) in operation.zones() {
        for work in &zone.works {
            schemes::schemes(&mut page, set_up, side, zone, work, lang);
        }
    }
    page.heading(3, say!(lang, "turn-total"));
    page.paragraph(total(operation, lang));
    section(&mut page, say!(lang, "turn-jobs"));
    jobs::jobs(&mut page, operation, times, lang);
    if !times.is_empty() {
        of_time(&mut page, operation, norm, knowledge, lang);
    }
    findings(&mut page, operation.findings.iter(), doubts, lang);
    page
}

/// The programs of an operation, one on each line.
pub fn programs_list(programs: &[OperationProgram], lang: Lang) -> String {
    let line = |(index, program): (usize, &OperationProgram)| {
        let tools: Vec<String> = program.seats.iter().map(|seat| jobs::seated(*seat)).collect();
        let summary = say!(
            lang,
            "turn-program",
            number = index + 1,
            set_up = program.set_up,
            count = tools.len(),
            tools = tools.join(", ")
        );
        match &program.files {
            Ok(_) => format!("{summary}\n"),
            Err(error) => {
                format!("{}\n", say!(lang, "turn-program-not-written", program = summary, why = error.note()))
            }
        }
    };
    programs.iter().enumerate().map(line).collect()
}

/// The norm of time of the whole part, in all its set-ups.
fn of_time(page: &mut Document, operation: &Operation, norm: Option<&Norm>, knowledge: &Knowledge, lang: Lang) {
    section(page, say!(lang, "norm-heading"));
    let Some(norm) = norm else {
        page.paragraph(say!(lang, "norm-not-whole"));
        return;
    };
    elements(page, norm, false, knowledge, lang);
    if gauges_outside(operation) {
        page.paragraph(say!(lang, "turn-norm-outside"));
    }
}

fn head(page: &mut Document, operation: &Operation, knowledge: &Knowledge, lang: Lang) {
    let part = &operation.workpiece;
    let blank = operation.blank_before.as_ref().unwrap_or(&part.blank);
    let kind = word(blank.kind.name());
    let holding = word(part.holding.name());
    let (diameter, length) = (blank.largest_diameter(), blank.length());
    let blank = match blank.inner.as_ref().and_then(|inner| inner.radii()) {
        None => say!(lang, "turn-blank", kind = kind, diameter = diameter, length = length, holding = holding),
        Some((least, _)) => say!(
            lang,
            "turn-blank-with-bore",
            kind = kind,
            diameter = diameter,
            bore = least.diameter(),
            length = length,
            holding = holding
        ),
    };
    let machine = part.machine.as_deref().map_or(say!(lang, "turn-no-lathe"), |id| {
        let record = knowledge.table(&format!("lathe-{id}"));
        record.map_or(id, |table| table.title.text(lang.tag()))
    });
    page.push(fields([
        (say!(lang, "turn-material").to_owned(), material(&part.material, knowledge)),
        (say!(lang, "turn-blank-label").to_owned(), blank),
        (say!(lang, "turn-machine").to_owned(), machine.to_owned()),
    ]));
}

fn allowances(operation: &Operation, lang: Lang) -> Table {
    let area = say!(lang, "turn-unit-mm2");
    let columns = [
        Column::number(say!(lang, "turn-set-up-column"), ""),
        Column::text(say!(lang, "turn-side")),
        Column::number(say!(lang, "turn-allowance-rough"), area),
        Column::number(say!(lang, "turn-allowance-additional"), area),
        Column::number(say!(lang, "turn-allowance-finish"), area),
        Column::number(say!(lang, "turn-rough-volume"), say!(lang, "turn-unit-cm3")),
    ];
    let mut rows = Vec::new();
    for set_up in &operation.set_ups {
        for side in &set_up.sides {
            let areas = &side.layers.areas;
            let area = |area: &Area| Cell::Figure(area.area_mm2.0, 2);
            rows.push(vec![
                Cell::count(usize::from(set_up.set_up.number)),
                lang.term("turn-side", side.side.name()).into(),
                area(&areas.rough_main),
                area(&areas.additional),
                area(&areas.finish),
                Cell::Figure(areas.rough_main.volume_mm3.0 / 1000.0, 2),
            ]);
        }
    }
    table(columns, rows, lang)
}

fn total(operation: &Operation, lang: Lang) -> String {
    let taken: Vec<_> = operation.zones().flat_map(|(_, _, zone)| &zone.works).filter_map(Work::transition).collect();
    let cutting: f64 = taken.iter().map(|one| one.measures.cutting_mm).sum();
    let time: f64 = taken.iter().map(|one| one.measures.time_min.0).sum();
    let (cutting, time) = (fixed(cutting, 1, lang), fixed(time, 2, lang));
    say!(lang, "turn-total-of", count = taken.len(), cutting = cutting, time = time)
}
