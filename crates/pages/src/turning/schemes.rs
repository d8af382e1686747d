//! The sections about levels, zones and schemes of a shaft's page.

use crate::units::round_to;
use technolog_tables::turning::passes::Scheme;
use technolog_turning::schemes::{Schemes, Splitting};

use super::super::sentences::term;
use super::super::{Lang, grid, sentence};
use super::figure;

/// The sections, numbered from a number on; nothing where there is no stock.
pub(super) fn sections(found: &Schemes, first: usize, lang: Lang) -> String {
    let Some(best) = &found.best_scheme else { return String::new() };
    let mut page =
        format!("\n{first}. {}\n", lang.pick("Рівні та зони (лекція 12.4)", "Levels and zones (lecture 12.4)"));
    page.push_str(&levels(found, lang));
    let title = lang.pick("Схеми видалення припуску", "Schemes of removal");
    page.push_str(&format!("\n{}. {title}\n", first + 1));
    page.push_str(&schemes(found, lang));
    page.push_str(&grid::paragraph(&sentence(&best.because.note, lang), 2));
    if let Some(scheme) = found.schemes.iter().find(|scheme| scheme.name == best.scheme) {
        let points: Vec<&str> = scheme.points.iter().map(|point| point.name.as_str()).collect();
        let line = format!("{}: {}.", lang.pick("Точки", "Points"), points.join(", "));
        page.push_str(&grid::paragraph(&line, 2));
    }
    for finding in &found.findings {
        page.push_str(&grid::paragraph(&sentence(&finding.note, lang), 2));
    }
    page
}

fn levels(found: &Schemes, lang: Lang) -> String {
    let Splitting { limiting_depth_mm, depth_mm, cylinders, horizontals, .. } = &found.splitting;
    let line = lang.pick(
        "Гранична глибина {limit} мм; єдина глибина проходів t_p = {depth} мм.",
        "Limiting depth {limit} mm; the one depth of all passes t_p = {depth} mm.",
    );
    let line = line.replace("{limit}", &figure(limiting_depth_mm, lang));
    let mut page = grid::paragraph(&line.replace("{depth}", &figure(depth_mm, lang)), 0);
    let head = [
        "№",
        "Ø",
        lang.pick("з Ø", "from Ø"),
        "Z",
        lang.pick("t, мм", "t, mm"),
        "n",
        lang.pick("t/n, мм", "t/n, mm"),
        lang.pick("Зона", "Zone"),
        lang.pick("Схема ходів", "Scheme of passes"),
    ]
    .map(str::to_owned);
    let schemes = |all: &[Scheme]| all.iter().map(|scheme| term(scheme.name(), lang)).collect::<Vec<_>>().join(" + ");
    let mut rows = Vec::new();
    for (index, (one, zone)) in cylinders.iter().zip(&found.zones).enumerate() {
        rows.push(vec![
            (index + 1).to_string(),
            figure(one.diameter_mm, lang),
            figure(one.blank_diameter_mm, lang),
            format!("{} → {}", figure(one.from_z_mm, lang), figure(one.to_z_mm, lang)),
            figure(one.stock_mm, lang),
            one.passes.to_string(),
            figure(one.mean_depth_mm, lang),
            term(zone.zone.name(), lang).to_owned(),
            schemes(&zone.schemes),
        ]);
    }
    page.push_str(&grid::table(&head, &rows, 2));
    for section in horizontals {
        let diameters: Vec<String> = section.diameters_mm.iter().map(|diameter| figure(diameter, lang)).collect();
        let line = lang.pick("Горизонталі від Z {z}: Ø{list}.", "Horizontals from Z {z}: Ø{list}.");
        let line = line.replace("{z}", &figure(section.from_z_mm, lang)).replace("{list}", &diameters.join(" → "));
        page.push_str(&grid::paragraph(&line, 0));
    }
    if let Some(whole) = found.zones.get(cylinders.len()) {
        let line = lang.pick("Уся зона: {zone}; {schemes}.", "The whole zone: {zone}; {schemes}.");
        let line = line.replace("{zone}", term(whole.zone.name(), lang)).replace("{schemes}", &schemes(&whole.schemes));
        page.push_str(&grid::paragraph(&line, 0));
    }
    page
}

fn schemes(found: &Schemes, lang: Lang) -> String {
    let head = [
        lang.pick("Схема", "Scheme"),
        lang.pick("Проходів", "Passes"),
        lang.pick("Різання, мм", "Cutting, mm"),
        lang.pick("Холості ходи, мм", "Idle, mm"),
        lang.pick("Час, хв", "Time, min"),
        lang.pick("Що це", "What it is"),
    ]
    .map(str::to_owned);
    let mut rows = Vec::new();
    for scheme in &found.schemes {
        let measures = &scheme.measures;
        rows.push(vec![
            term(scheme.name, lang).to_owned(),
            measures.passes.to_string(),
            figure(measures.cutting_mm, lang),
            figure(round_to(measures.idle_mm, 1), lang),
            figure(round_to(measures.time_min.0, 3), lang),
            format!("{} ({})", sentence(&scheme.because.note, lang), scheme.because.place),
        ]);
    }
    grid::table(&head, &rows, 2)
}
