//! The operation card: form 3 of GOST 3.1404-86 (without a sketch), following sheets by form 2а.

use crate::document::{CellKind, Document, FormCell, FormRow, Inlines};
use crate::error::KnowledgeError;
use crate::note::IntoFigure;
use crate::plan::Transition;

use super::super::super::sheet::route::{WorkStep, told, work_steps};
use super::super::super::sheet::{NONE, blank_of, material, material_of, number};
use super::super::norm::marked;
use super::{Group, Kind, Lang, Line, Sources, TitleBlock};
use super::{
    blank_mass, equipment, line, machine_auxiliary, minutes, names, page, sheets, text, times, tool_of, tools_line,
    values,
};

const KIND: Kind = Kind {
    marks: ["ГОСТ 3.1404-86  форма 3", "ГОСТ 3.1404-86  форма 2а"],
    code: "ОК",
    name: "card-operation-card-name",
    fits: [12, 16],
};

const FIRST: [(u16, &str); 8] = [
    (26, "card-operation-is"),
    (24, "card-material"),
    (10, "card-hardness"),
    (4, "card-unit"),
    (7, "card-mass"),
    (25, "card-profile"),
    (7, "card-blank-mass"),
    (7, "card-at-once"),
];
const SECOND: [(u16, &str); 7] = [
    (26, "card-control"),
    (24, "card-program"),
    (7, "card-basic"),
    (7, "card-auxiliary"),
    (7, "card-preparatory"),
    (7, "card-piece"),
    (32, "card-coolant"),
];
const P: [(u16, &str); 9] = [
    (41, ""),
    (7, "card-place"),
    (11, "card-diameter"),
    (9, "card-travel"),
    (7, "card-cut"),
    (5, "card-passes"),
    (9, "card-feed"),
    (8, "card-speed"),
    (8, "card-cutting-speed"),
];

/// The card.
pub(in super::super) fn card(own: &Sources<'_>, title: &TitleBlock, lang: Lang) -> Result<Document, KnowledgeError> {
    let mut head = names(lang, &P);
    head.cells.insert(0, super::name(5, "Р"));
    let [mm, feed, speed, cutting] = ["unit-mm", "unit-mm-rev", "unit-1-min", "unit-m-min"].map(|unit| lang.word(unit));
    let units = ["", "", mm, mm, mm, "–", feed, speed, cutting];
    let cells = std::iter::once(super::name(5, ""))
        .chain(P.iter().zip(units).map(|((width, _), unit)| super::name(*width, unit)));
    let units = FormRow { lines: 1, cells: cells.collect() };
    let forms = sheets(&KIND, [strips(own, lang)?, vec![head, units]], body(own, lang), own, title, lang);
    Ok(page("card-operation-title", forms, own, &["card-standing", "card-operation-legend", "card-by-hand"], lang))
}

fn strips(own: &Sources<'_>, lang: Lang) -> Result<Vec<FormRow>, KnowledgeError> {
    let plan = own.plan;
    let part = &plan.part;
    let none = Inlines::default;
    let hardness = material(part, own.knowledge)
        .map(|material| format!("HB {}", lang.figure(&material.hardness.into_figure())))
        .unwrap_or_default();
    let profile = blank_of(part, lang);
    let mass = blank_mass(own, lang)?;
    let unit = if mass.is_empty() { none() } else { Inlines::from("166") };
    let coolant = own.job.setups.iter().flat_map(|setup| &setup.works).any(|work| work.coolant);
    let first = vec![
        lang.word("plan-operation-name").into(),
        material_of(plan, own.knowledge, lang).into(),
        hardness.into(),
        unit,
        none(),
        profile.into(),
        mass,
        "1".into(),
    ];
    let [piece, preparatory] = times(own, lang);
    let doubtful = own.norm.is_some_and(|norm| norm.unconfirmed()[0]);
    let known = own.norm.and_then(|norm| norm.auxiliary);
    // Without a time of loading it is that of the machine alone, as the line of the legend says.
    let auxiliary = match known {
        Some(_) => marked(known, doubtful, lang),
        None => minutes(machine_auxiliary(plan), lang),
    };
    let second = vec![
        own.sheet.equipment.as_str().into(),
        none(),
        minutes(plan.time.machine_min.0, lang),
        auxiliary,
        preparatory,
        piece,
        lang.word(if coolant { "card-coolant-on" } else { "card-coolant-off" }).into(),
    ];
    Ok(vec![names(lang, &FIRST), values(lang, &FIRST, first), names(lang, &SECOND), values(lang, &SECOND, second)])
}

fn body(own: &Sources<'_>, lang: Lang) -> Vec<Group> {
    let mut groups = Vec::new();
    let steps = work_steps(own.plan);
    for (at, step) in (1..).zip(steps.iter().filter(|step| !matches!(step, WorkStep::Elsewhere { .. }))) {
        let what = format!("{at}. {}", told(own.plan, step, lang));
        match step {
            WorkStep::Make { hole, transition } => {
                let count = own.plan.part.holes.iter().find(|own| own.name == hole.name).map_or(1, |own| own.at.len());
                let time = transition.conditions.machine_time_min.0 * count as f64;
                let tail = [minutes(time, lang), Inlines::default()];
                let tail: Vec<FormCell> = [(8, "card-basic"), (8, "card-auxiliary")]
                    .into_iter()
                    .zip(tail)
                    .map(|((width, key), words)| FormCell::new(CellKind::Line, width, words).named(lang.word(key)))
                    .collect();
                let mut lines = text("О", &what, &tail);
                if let Some(tool) = tool_of(own.plan, transition) {
                    lines.extend(tools_line(&equipment(own, tool, lang)));
                }
                lines.push(conditions(own, transition, lang));
                groups.push(lines);
            }
            _ => groups.push(text("О", &what, &[])),
        }
    }
    groups
}

/// The line Р of a transition: the figures of the plan.
fn conditions(own: &Sources<'_>, transition: &Transition, lang: Lang) -> Line {
    let works = own.job.setups.iter().flat_map(|setup| &setup.works);
    let place = works.into_iter().find(|work| work.tool == transition.tool.number).map(|work| work.place.to_string());
    let its = &transition.conditions;
    let mm = |value: crate::units::Micrometres| Inlines::number(lang.figure(&value.into_figure()));
    let figure = |value: f64, places: u32| Inlines::number(number(value, places, lang));
    // The path of a mill is its rounds, which have no one length.
    let (travel, passes) = match &its.rounds {
        None => (figure(transition.travel_mm.to_mm(), 1), transition.passes),
        Some(rounds) => (NONE.into(), transition.passes * rounds.levels * rounds.passes),
    };
    let held = vec![
        Inlines::default(),
        Inlines::number(place.unwrap_or_default()),
        mm(transition.diameter_mm),
        travel,
        figure(its.depth_of_cut_mm, 3),
        Inlines::number(passes.to_string()),
        figure(its.feed_mm_per_rev.0, 3),
        figure(its.spindle_rpm.0, 1),
        figure(its.speed_m_per_min.0, 1),
    ];
    line("Р", lang, &P, held)
}
