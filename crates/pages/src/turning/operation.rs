//! A turning operation as its reader sees it: the blank, the surfaces, the allowances, the zones with their tools, the
//! schemes side by side.

mod schemes;
mod surfaces;
mod zones;

use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::note::Because;
use crate::units::round_to;
use technolog_turning::length::Half;
use technolog_turning::operation::Operation;
use technolog_turning::operation::programs::Written;
use technolog_turning::operation::work::Work;

use super::super::sentences::term;
use super::super::{Lang, grid, sentence};
use super::figure;

/// The whole page.
pub fn operation_page(operation: &Operation, knowledge: &Knowledge, lang: Lang) -> String {
    let mut page = head(operation, knowledge, lang);
    let mut number = 0;
    let mut section = |page: &mut String, title: &str| {
        number += 1;
        page.push_str(&format!("\n{number}. {title}\n"));
    };
    section(&mut page, lang.pick("Заготовка", "Blank"));
    for advice in &operation.blank_advice {
        page.push_str(&grid::paragraph(&reasoned(&sentence(&advice.finding.note, lang), &advice.because, lang), 2));
    }
    section(&mut page, lang.pick("Установи та поверхні (лекція 12.1)", "Set-ups and surfaces (lecture 12.1)"));
    for set_up in &operation.set_ups {
        page.push_str(&surfaces::surfaces(operation, set_up, lang));
    }
    section(&mut page, lang.pick("Припуски (лекція 12.2)", "Allowances (lecture 12.2)"));
    page.push_str(&allowances(operation, lang));
    section(&mut page, lang.pick("Зони та різці (лекція 12.3)", "Zones and tools (lecture 12.3)"));
    page.push_str(&zones::zones(operation, lang));
    let extra = zones::additional(operation, lang);
    if !extra.is_empty() {
        section(&mut page, lang.pick("Додаткові елементи: закриті зони", "Additional elements: closed zones"));
        page.push_str(&extra);
    }
    section(
        &mut page,
        lang.pick("Схеми чорнових переходів (лекція 12.4)", "Schemes of rough transitions (lecture 12.4)"),
    );
    for (set_up, side, zone) in operation.zones() {
        for work in &zone.works {
            page.push_str(&schemes::schemes(set_up, side, zone, work, lang));
        }
    }
    page.push_str(&total(operation, lang));
    if !operation.findings.is_empty() {
        section(&mut page, lang.pick("Зауваження", "Findings"));
        for finding in &operation.findings {
            let severity = term(finding.severity.name(), lang);
            page.push_str(&grid::paragraph(&format!("{severity}: {}", sentence(&finding.note, lang)), 2));
        }
    }
    page
}

/// The programs of an operation, one a line.
pub fn programs_list(programs: &[Written], lang: Lang) -> String {
    let mut list = String::new();
    for (index, program) in programs.iter().enumerate() {
        let zones: Vec<String> = program.zones.iter().map(ToString::to_string).collect();
        let line = lang.pick(
            "{number}: установ {set_up}, {side}, зони {zones}, {tool}",
            "{number}: set-up {set_up}, {side}, zones {zones}, {tool}",
        );
        let line = line
            .replace("{number}", &(index + 1).to_string())
            .replace("{set_up}", &program.set_up.to_string())
            .replace("{side}", term(program.side.name(), lang))
            .replace("{zones}", &zones.join(", "))
            .replace("{tool}", &program.tool);
        list.push_str(&line);
        if let Err(error) = &program.files {
            list.push_str(&format!(": {}", sentence(&error.note(), lang)));
        }
        list.push('\n');
    }
    list
}

/// A sentence with the row that it rests on.
fn reasoned(text: &str, because: &Because, lang: Lang) -> String {
    match because.row {
        Some(row) => format!("{text} ({}, {} {row}; {})", because.table, lang.pick("рядок", "row"), because.place),
        None => format!("{text} ({}; {})", because.table, because.place),
    }
}

/// A length along the axis as it is told: negative towards the chuck.
fn z(value: Half, lang: Lang) -> String {
    figure(Half::ZERO - value, lang)
}

fn head(operation: &Operation, knowledge: &Knowledge, lang: Lang) -> String {
    let part = &operation.workpiece;
    let material = Material::find(knowledge, &part.material)
        .map_or_else(|_| part.material.clone(), |material| material.designation().to_owned());
    let blank = &part.blank;
    let bore = blank.inner.as_ref().and_then(|inner| inner.radii()).map(|(least, _)| least.diameter());
    let bore = bore.map_or_else(String::new, |bore| format!("/{}", figure(bore, lang)));
    let line = format!(
        "{}. {material}. {}: {} Ø{}{bore} × {} {}, {}. {}: {}.",
        part.name,
        lang.pick("Заготовка", "Blank"),
        term(blank.kind.name(), lang),
        figure(blank.largest_diameter(), lang),
        figure(blank.length(), lang),
        lang.pick("мм", "mm"),
        term(part.holding.name(), lang),
        lang.pick("Верстат", "Lathe"),
        part.machine.as_deref().unwrap_or(lang.pick("не вказано", "none named")),
    );
    grid::paragraph(&line, 0)
}

fn allowances(operation: &Operation, lang: Lang) -> String {
    let head = [
        lang.pick("Установ", "Set-up"),
        lang.pick("Бік", "Side"),
        lang.pick("1: чорновий, мм²", "1: rough, mm²"),
        lang.pick("2: додаткові, мм²", "2: additional, mm²"),
        lang.pick("3: чистовий, мм²", "3: finish, mm²"),
        lang.pick("1, см³", "1, cm³"),
    ]
    .map(str::to_owned);
    let mut rows = Vec::new();
    for set_up in &operation.set_ups {
        for side in &set_up.sides {
            let areas = &side.layers.areas;
            // Not −0 where two contours are one.
            let area =
                |area: &technolog_turning::allowances::areas::Area| figure(round_to(area.area_mm2.0, 2) + 0.0, lang);
            rows.push(vec![
                set_up.set_up.number.to_string(),
                term(side.side.name(), lang).to_owned(),
                area(&areas.rough_main),
                area(&areas.additional),
                area(&areas.finish),
                figure(round_to(areas.rough_main.volume_mm3.0 / 1000.0, 2), lang),
            ]);
        }
    }
    grid::table(&head, &rows, 2)
}

fn total(operation: &Operation, lang: Lang) -> String {
    let taken = operation.zones().flat_map(|(_, _, zone)| &zone.works).filter_map(Work::transition);
    let (mut time, mut cutting, mut count) = (0.0, 0.0, 0);
    for transition in taken {
        time += transition.measures.time_min.0;
        cutting += transition.measures.cutting_mm;
        count += 1;
    }
    let line = lang.pick(
        "Разом чорнових переходів {count}: різання {cutting} мм, {time} хв.",
        "{count} rough transitions in all: cutting {cutting} mm, {time} min.",
    );
    let line = line.replace("{count}", &count.to_string()).replace("{cutting}", &figure(round_to(cutting, 1), lang));
    grid::paragraph(&line.replace("{time}", &figure(round_to(time, 3), lang)), 0)
}
