//! The schemes over each zone side by side.

use std::fmt::Display;

use crate::units::round_to;
use technolog_turning::operation::work::{Work, ZoneWork};
use technolog_turning::operation::{SetUpWork, SideWork};
use technolog_turning::transitions::Transition;

use super::super::super::sentences::term;
use super::super::super::{Lang, grid, sentence};
use super::super::figure;
use super::zones::place;
use super::{reasoned, z};

pub(super) fn schemes(set_up: &SetUpWork, side: &SideWork, zone: &ZoneWork, work: &Work, lang: Lang) -> String {
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
    grid::table(&head, &rows, 2)
}
