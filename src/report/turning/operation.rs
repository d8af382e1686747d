//! A turning operation as its reader sees it: the blank, the surfaces, the allowances, the zones with their tools, the
//! schemes side by side.

use std::fmt::Display;

use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::note::Because;
use crate::turning::contour::Side;
use crate::turning::elements::{Class, Element};
use crate::turning::length::Half;
use crate::turning::operation::programs::Written;
use crate::turning::operation::work::{Work, ZoneWork};
use crate::turning::operation::{Operation, SetUpWork, SideWork};
use crate::turning::transitions::Transition;
use crate::turning::zones::{Feed, Stretch};
use crate::units::round_to;

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
        page.push_str(&surfaces(operation, set_up, lang));
    }
    section(&mut page, lang.pick("Припуски (лекція 12.2)", "Allowances (lecture 12.2)"));
    page.push_str(&allowances(operation, lang));
    section(&mut page, lang.pick("Зони та різці (лекція 12.3)", "Zones and tools (lecture 12.3)"));
    page.push_str(&zones(operation, lang));
    let extra = additional(operation, lang);
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
            page.push_str(&schemes(set_up, side, zone, work, lang));
        }
    }
    page.push_str(&total(operation, lang));
    if !operation.findings.is_empty() {
        section(&mut page, lang.pick("Зауваження", "Findings"));
        for finding in &operation.findings {
            let severity = term(severity(finding.severity), lang);
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
            .replace("{side}", term(side_name(program.side), lang))
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

const fn severity(severity: crate::note::Severity) -> &'static str {
    match severity {
        crate::note::Severity::Error => "error",
        crate::note::Severity::Wrong => "wrong",
        crate::note::Severity::Doubtful => "doubtful",
        crate::note::Severity::Note => "note",
    }
}

pub(super) const fn side_name(side: Side) -> &'static str {
    match side {
        Side::Outer => "outer",
        Side::Inner => "inner",
    }
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

fn surfaces(operation: &Operation, set_up: &SetUpWork, lang: Lang) -> String {
    let one = &set_up.set_up;
    let mut page = grid::paragraph(
        &lang.pick("Установ {number}", "Set-up {number}").replace("{number}", &one.number.to_string()),
        0,
    );
    for note in &one.notes {
        page.push_str(&grid::paragraph(&sentence(note, lang), 2));
    }
    page.push_str(&grid::paragraph(&reasoned(&sentence(&one.because.note, lang), &one.because, lang), 2));
    for (side, stretch) in [(Side::Outer, &one.outer), (Side::Inner, &one.inner)] {
        let Some(stretch) = stretch else { continue };
        let work = set_up.sides.iter().find(|work| work.side == side);
        page.push_str(&grid::paragraph(term(side_name(side), lang), 2));
        page.push_str(&elements(operation, stretch, work, lang));
    }
    page
}

fn elements(operation: &Operation, stretch: &Stretch, work: Option<&SideWork>, lang: Lang) -> String {
    let head = [
        lang.pick("Поверхня", "Surface"),
        lang.pick("Вид", "Kind"),
        "Ø",
        "Z",
        "IT",
        lang.pick("Шорсткість", "Roughness"),
        lang.pick("Елемент", "Element"),
        lang.pick("Чистовий, мм", "Finish, mm"),
        lang.pick("Остаточно", "Finished"),
    ]
    .map(str::to_owned);
    let arrow = |from: String, to: String| if from == to { to } else { format!("{from} → {to}") };
    let mut rows = Vec::new();
    for (index, (surface, class)) in stretch.profile.surfaces.iter().zip(&stretch.classes).enumerate() {
        let ends = surface.pieces.first().zip(surface.pieces.last());
        let (from, to) = ends.map(|(first, last)| (first.from, last.to)).unwrap_or_default();
        let allowance = work.and_then(|work| work.layers.allowances.get(index)).and_then(|one| one.allowance_mm);
        let later = operation.elsewhere.iter().find(|one| one.surface == surface.name);
        let later = later.map_or(String::new(), |later| {
            format!("{} +{}", term(&later.operation, lang), figure(later.allowance_mm, lang))
        });
        rows.push(vec![
            surface.name.clone(),
            term(surface.kind.name(), lang).to_owned(),
            arrow(figure(from.radius.diameter(), lang), figure(to.radius.diameter(), lang)),
            arrow(z(from.z, lang), z(to.z, lang)),
            surface.grade.map_or(String::new(), |grade| grade.to_string()),
            surface.roughness.map_or(String::new(), |roughness| roughness.to_string()),
            said_of(class, lang),
            allowance.map_or(String::new(), |allowance| figure(allowance, lang)),
            later,
        ]);
    }
    grid::ruled(&head, &rows).unwrap_or_else(|| grid::columns(&rows, 4))
}

/// A main element by one word; of the others why, without the name that stands in the row.
fn said_of(class: &Class, lang: Lang) -> String {
    if class.element == Element::Main {
        return term("main-element", lang).to_owned();
    }
    let said = sentence(&class.because.note, lang);
    let said = said.strip_prefix(&format!("{}: ", class.name)).unwrap_or(&said);
    if class.element == Element::OtherSide { format!("{}: {said}", term("other-side", lang)) } else { said.to_owned() }
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
                |area: &crate::turning::allowances::areas::Area| figure(round_to(area.area_mm2.0, 2) + 0.0, lang);
            rows.push(vec![
                set_up.set_up.number.to_string(),
                term(side_name(side.side), lang).to_owned(),
                area(&areas.rough_main),
                area(&areas.additional),
                area(&areas.finish),
                figure(round_to(areas.rough_main.volume_mm3.0 / 1000.0, 2), lang),
            ]);
        }
    }
    grid::ruled(&head, &rows).unwrap_or_else(|| grid::columns(&rows, 2))
}

fn zones(operation: &Operation, lang: Lang) -> String {
    let head = [
        lang.pick("Зона", "Zone"),
        lang.pick("Вид", "Kind"),
        "Z",
        "Ø",
        "φ ≥",
        "φ1 ≥",
        lang.pick("Різець", "Tool"),
        lang.pick("t_гр, мм", "t_lim, mm"),
        lang.pick("t_p, мм", "t_p, mm"),
        lang.pick("Схема", "Scheme"),
    ]
    .map(str::to_owned);
    let mut rows = Vec::new();
    for (set_up, side, one) in operation.zones() {
        let zone = &one.zone;
        let schemes: Vec<&str> = one.works.iter().filter_map(|work| Some(term(work.taken?.name(), lang))).collect();
        let depths: Vec<String> = one.works.iter().map(|work| figure(work.levels.depth, lang)).collect();
        let tool = one.tool.as_ref().map_or("-".to_owned(), |tool| {
            format!(
                "{} (φ {}, φ1 {})",
                tool.designation,
                figure(tool.main_angle_deg.0, lang),
                figure(tool.secondary_angle_deg.0, lang)
            )
        });
        let kind = match zone.feed {
            Feed::Across => lang.pick("торець", "face").to_owned(),
            Feed::Along => term(zone.kind.name(), lang).to_owned(),
        };
        rows.push(vec![
            place(set_up, side, one, lang),
            kind,
            format!("{} → {}", z(zone.from_z, lang), z(zone.to_z, lang)),
            format!(
                "{} … {}",
                figure(zone.least_radius.diameter(), lang),
                figure(zone.greatest_radius.diameter(), lang)
            ),
            figure(round_to(zone.needs.main.0, 2), lang),
            figure(round_to(zone.needs.secondary.0, 2), lang),
            tool,
            one.depth.as_ref().map_or(String::new(), |depth| figure(depth.limiting_depth_mm, lang)),
            depths.join("; "),
            schemes.join(" + "),
        ]);
    }
    let mut page = grid::ruled(&head, &rows).unwrap_or_else(|| grid::columns(&rows, 2));
    let mut told: Vec<String> = Vec::new();
    for (set_up, side, one) in operation.zones() {
        let name = place(set_up, side, one, lang);
        if let Some(limit) = one.depth.as_ref().and_then(|depth| depth.limit.as_ref()) {
            let bounds = limit.bounds.iter().filter_map(|bound| {
                let name = serde_json::to_value(bound.bound).ok()?;
                let depth = bound.depth_mm.map_or("0".to_owned(), |depth| figure(depth, lang));
                Some(format!("{} {depth}", term(name.as_str()?, lang)))
            });
            let line = lang.pick(
                "{name}: t_гр за подачі {feed} мм/об: {bounds}",
                "{name}: t_lim at a feed of {feed} mm/rev: {bounds}",
            );
            let bounds = bounds.collect::<Vec<_>>().join("; ");
            let line = line.replace("{name}", &name).replace("{feed}", &figure(limit.feed_mm_per_rev.0, lang));
            told.push(line.replace("{bounds}", &bounds));
        }
        for refused in &one.fit.refused {
            let why: Vec<String> = refused.why.iter().map(|why| sentence(why, lang)).collect();
            let line = lang.pick("{name}: не {tool}: {why}", "{name}: not {tool}: {why}");
            told.push(line.replace("{name}", &name).replace("{tool}", &refused.tool).replace("{why}", &why.join("; ")));
        }
    }
    for line in told {
        page.push_str(&grid::paragraph(&line, 2));
    }
    page
}

/// The zones under the bridges; where no tool fits, why not each of them.
fn additional(operation: &Operation, lang: Lang) -> String {
    let head = [
        lang.pick("Установ", "Set-up"),
        lang.pick("Бік", "Side"),
        "Z",
        "Ø",
        "φ ≥",
        "φ1 ≥",
        lang.pick("Різець", "Tool"),
        lang.pick("Схема", "Scheme"),
    ]
    .map(str::to_owned);
    let (mut rows, mut refused) = (Vec::new(), Vec::new());
    for (set_up, side) in
        operation.set_ups.iter().flat_map(|set_up| set_up.sides.iter().map(move |side| (set_up, side)))
    {
        for one in &side.additional {
            let zone = &one.zone;
            let span = format!("{} → {}", z(zone.from_z, lang), z(zone.to_z, lang));
            let tool = one.tool.as_ref().map(|tool| match tool.width_mm {
                Some(width) => format!("{} ({} {})", tool.designation, figure(width, lang), lang.pick("мм", "mm")),
                None => format!("{} (φ1 {})", tool.designation, figure(tool.secondary_angle_deg.0, lang)),
            });
            let schemes: Vec<&str> = one.works.iter().filter_map(|work| Some(term(work.taken?.name(), lang))).collect();
            if tool.is_none() {
                for one in &one.fit.refused {
                    let why: Vec<String> = one.why.iter().map(|why| sentence(why, lang)).collect();
                    let line = lang.pick("Z {span}: не {tool}: {why}", "Z {span}: not {tool}: {why}");
                    let line = line.replace("{span}", &span).replace("{tool}", &one.tool);
                    refused.push(line.replace("{why}", &why.join("; ")));
                }
            }
            rows.push(vec![
                set_up.set_up.number.to_string(),
                term(side_name(side.side), lang).to_owned(),
                span,
                format!(
                    "{} … {}",
                    figure(zone.least_radius.diameter(), lang),
                    figure(zone.greatest_radius.diameter(), lang)
                ),
                figure(round_to(zone.needs.main.0, 2), lang),
                figure(round_to(zone.needs.secondary.0, 2), lang),
                tool.unwrap_or_else(|| lang.pick("жоден", "none").to_owned()),
                schemes.join(" + "),
            ]);
        }
    }
    if rows.is_empty() {
        return String::new();
    }
    let mut page = grid::ruled(&head, &rows).unwrap_or_else(|| grid::columns(&rows, 2));
    for line in refused {
        page.push_str(&grid::paragraph(&line, 2));
    }
    page
}

/// `1.2`: the second zone of the first set-up; of a bore with its side.
fn place(set_up: &SetUpWork, side: &SideWork, zone: &ZoneWork, lang: Lang) -> String {
    let inner = if side.side == Side::Inner { lang.pick(" отв.", " bore") } else { "" };
    format!("{}.{}{inner}", set_up.set_up.number, zone.zone.number)
}

fn schemes(set_up: &SetUpWork, side: &SideWork, zone: &ZoneWork, work: &Work, lang: Lang) -> String {
    let mut page = grid::paragraph(
        &format!(
            "{} {}, Z {} → {}: t_p = {} {}",
            lang.pick("Зона", "Zone"),
            place(set_up, side, zone, lang),
            z(work.stock.from, lang),
            z(work.stock.to, lang),
            figure(work.levels.depth, lang),
            lang.pick("мм", "mm"),
        ),
        0,
    );
    if let Some(found) = &work.pace.conditions {
        let line = lang.pick(
            "s = {s} мм/об, V = {v} м/хв, n = {n} об/хв, {f} мм/хв{rest}",
            "s = {s} mm/rev, V = {v} m/min, n = {n} 1/min, {f} mm/min{rest}",
        );
        let mut rest = String::new();
        if let (Some(force), Some(power)) = (found.main_force_n, found.power_kw) {
            rest = format!(
                "; Pz = {} {}, N = {} {}",
                figure(round_to(force.0, 0), lang),
                lang.pick("Н", "N"),
                figure(round_to(power.0, 2), lang),
                lang.pick("кВт", "kW")
            );
        }
        let line = line
            .replace("{s}", &figure(round_to(found.feed_mm_per_rev.0, 3), lang))
            .replace("{v}", &figure(round_to(found.speed_m_per_min.0, 1), lang))
            .replace("{n}", &figure(round_to(found.spindle_rpm.0, 1), lang))
            .replace("{f}", &figure(round_to(found.feed_mm_per_min.0, 1), lang))
            .replace("{rest}", &rest);
        page.push_str(&grid::paragraph(&line, 2));
    }
    page.push_str(&grid::paragraph(&reasoned(&sentence(&work.because.note, lang), &work.because, lang), 2));
    page.push_str(&compared(work, lang));
    let even = work.quickest_even.as_ref().filter(|even| Some(*even) != work.quickest.as_ref());
    if let Some(best) = &work.quickest {
        page.push_str(&grid::paragraph(&sentence(&best.note, lang), 2));
    }
    if let Some(best) = even {
        let line = lang.pick("з рівномірним припуском: {best}", "with an even allowance: {best}");
        let line = line.replace("{best}", &sentence(&best.note, lang));
        page.push_str(&grid::paragraph(&line, 2));
    }
    for refused in &work.refused {
        let line = lang.pick("не {scheme}: {why}", "not {scheme}: {why}");
        let line = line.replace("{scheme}", term(refused.scheme.name(), lang));
        page.push_str(&grid::paragraph(&line.replace("{why}", &sentence(&refused.why, lang)), 2));
    }
    if let Some(taken) = work.transition() {
        let points: Vec<&str> = taken.points.iter().map(|point| point.name.as_str()).collect();
        let line = format!("{}: {}.", lang.pick("Опорні точки", "Support points"), points.join(", "));
        page.push_str(&grid::paragraph(&line, 2));
    }
    page
}

fn compared(work: &Work, lang: Lang) -> String {
    let head = [
        "",
        lang.pick("Схема", "Scheme"),
        lang.pick("Проходів", "Passes"),
        lang.pick("Різання, мм", "Cutting, mm"),
        lang.pick("На подачі без металу", "At feed, no metal"),
        lang.pick("Прискорено, мм", "Rapid, mm"),
        lang.pick("Час, хв", "Time, min"),
        lang.pick("Гребінці, мм", "Ridges, mm"),
    ]
    .map(str::to_owned);
    let row = |one: &Transition| {
        let number = |value: &dyn Display| figure(value, lang);
        vec![
            if work.taken == Some(one.scheme) { "+" } else { "" }.to_owned(),
            term(one.scheme.name(), lang).to_owned(),
            one.measures.passes.to_string(),
            number(&round_to(one.measures.cutting_mm, 1)),
            number(&round_to(one.measures.beside_mm, 1)),
            number(&round_to(one.measures.rapid_mm, 1)),
            number(&round_to(one.measures.time_min.0, 3)),
            number(&one.ridges_mm),
        ]
    };
    let rows: Vec<Vec<String>> = work.transitions.iter().map(row).collect();
    grid::ruled(&head, &rows).unwrap_or_else(|| grid::columns(&rows, 2))
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
