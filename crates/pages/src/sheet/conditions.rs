//! The cutting conditions of a plan: a row for each transition, and what limits it.

use crate::document::{Block, Column, Document, Inlines, Item, Keep, Table};
use crate::note::Figure;
use crate::plan::{Limit, Plan, Transition};

use super::super::words::say;
use super::{Lang, MARK, NONE, cell, exactly, heading, mark, mm, rounded};
use crate::report::operation_noun;

/// The table, and notes under it.
pub(crate) fn section(page: &mut Document, plan: &Plan, lang: Lang) {
    let mut rows: Vec<(Vec<&str>, Vec<Inlines>)> = Vec::new();
    for hole in &plan.holes {
        for transition in hole.transitions.iter().filter(|own| !own.operation.is_only_elsewhere()) {
            let row = cells(transition, lang);
            // Groups with exactly the same transition share its line.
            match rows.iter_mut().find(|(_, known)| *known == row) {
                Some((names, _)) if names.contains(&hole.name.as_str()) => {}
                Some((names, _)) => names.push(&hole.name),
                None => rows.push((vec![&hole.name], row)),
            }
        }
    }
    let mut table = table(plan, lang);
    let marked = rows.iter().flat_map(|(_, cells)| cells.first()).any(|tool| tool.plain().ends_with(MARK));
    for (names, cells) in rows {
        table.row([Inlines::from(names.join(", "))].into_iter().chain(cells));
    }
    if marked {
        table.notes.push(say!(lang, "plan-mark", mark = MARK).into());
    }
    table.notes.push(say!(lang, "plan-for-one-hole").into());
    table.notes.extend(coolant(plan, lang));
    page.push(table);
    let limits = limits(plan, lang);
    if !limits.is_empty() {
        page.push(Block::List(limits));
    }
}

/// On a narrow screen forces and power are left out first, then the transition: tool and diameter identify the row.
fn table(plan: &Plan, lang: Lang) -> Table {
    let column = |key, unit| Column::number(heading(key, lang), lang.word(unit));
    Table::new([
        super::of_surface(plan, lang),
        Column::text("T"),
        Column::text(say!(lang, "plan-transition")).keep(Keep::Optional),
        Column::number("Ø", lang.word("unit-mm")),
        Column::number("L", lang.word("unit-mm")),
        Column::number("t", lang.word("unit-mm")),
        column("plan-feed", "unit-mm-rev"),
        Column::number("V", lang.word("unit-m-min")),
        Column::number("n", lang.word("unit-1-min")),
        column("plan-feed-per-min", "unit-mm-min"),
        column("plan-thrust", "unit-N").keep(Keep::Optional),
        column("plan-torque", "unit-N-m").keep(Keep::Optional),
        Column::number("N", lang.word("unit-kW")).keep(Keep::Optional),
        column("plan-machine-time", "unit-min"),
    ])
}

fn cells(transition: &Transition, lang: Lang) -> Vec<Inlines> {
    let conditions = &transition.conditions;
    // Programs use whole steps, rounded down: 283.5 is F283, and must not be read as 284.
    let whole = conditions.feed_mm_per_min.0.fract().abs() < 0.05;
    let optional = |value: Option<f64>, places| value.map_or_else(|| NONE.into(), |value| cell(value, places, lang));
    vec![
        format!("{}{}", super::route::place(transition), mark(&conditions.because)).into(),
        operation_noun(transition.operation.name(), lang).into(),
        Inlines::number(diameters(transition, lang)),
        // The path of a mill is its circles, not the travel along the axis.
        optional(conditions.rounds.is_none().then(|| transition.travel_mm.to_mm()), 1),
        cell(conditions.depth_of_cut_mm, 2, lang),
        cell(conditions.feed_mm_per_rev.0, 3, lang),
        cell(conditions.speed_m_per_min.0, 1, lang),
        cell(conditions.spindle_rpm.0, 0, lang),
        cell(conditions.feed_mm_per_min.0, if whole { 0 } else { 1 }, lang),
        optional(conditions.axial_force_n.map(|force| force.0), 0),
        optional(conditions.torque_n_m.map(|torque| torque.0), 1),
        optional(conditions.power_kw.map(|power| power.0), 2),
        cell(conditions.machine_time_min.0, 2, lang),
    ]
}

/// The diameter after the transition; a step drill leaves two, and its conditions are those of the wide one.
fn diameters(transition: &Transition, lang: Lang) -> String {
    let narrow = mm(transition.diameter_mm, lang);
    transition.also_diameter_mm.map_or(narrow.clone(), |wide| format!("{narrow}/{}", mm(wide, lang)))
}

/// The transitions whose speeds are for coolant; the tables do not say it of every transition.
fn coolant(plan: &Plan, lang: Lang) -> Option<Inlines> {
    let mut names: Vec<&str> = Vec::new();
    for transition in plan.holes.iter().flat_map(|hole| &hole.transitions).filter(|own| !own.elsewhere) {
        let name = transition.operation.name();
        if transition.conditions.coolant == Some(true) && !names.contains(&name) {
            names.push(name);
        }
    }
    (!names.is_empty()).then(|| say!(lang, "plan-coolant", operations = Figure::operations(names)).into())
}

/// The limits other than the cutting speed, and the figures of the card.
fn limits(plan: &Plan, lang: Lang) -> Vec<Item> {
    let mut lines: Vec<String> = Vec::new();
    for hole in &plan.holes {
        for transition in hole.transitions.iter().filter(|own| !own.operation.is_only_elsewhere()) {
            let conditions = &transition.conditions;
            let operation = || Figure::operation(transition.operation.name());
            if conditions.limited_by != Limit::CuttingSpeed {
                let line = say!(
                    lang,
                    "plan-limited",
                    hole = Figure::called(&hole.name),
                    operation = operation(),
                    diameter = transition.diameter_mm,
                    by = Figure::word(conditions.limited_by.name())
                );
                if !lines.contains(&line) {
                    lines.push(line);
                }
            }
            if let Some(card) = &conditions.card {
                let optional = |value: Option<f64>| value.map_or(Figure::Text(NONE.into()), |value| exactly(value, 2));
                lines.push(say!(
                    lang,
                    "plan-card",
                    hole = Figure::called(&hole.name),
                    operation = operation(),
                    feed = rounded(card.feed_mm_per_rev.0, 3),
                    speed = rounded(card.speed_m_per_min.0, 1),
                    force = card.axial_force_n.map_or(Figure::Text(NONE.into()), |force| rounded(force.0, 0)),
                    power = optional(card.power_kw.map(|power| power.0))
                ));
            }
        }
    }
    lines.into_iter().map(Item::from).collect()
}
