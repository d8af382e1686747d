//! The route card: form 1 of GOST 3.1118-82, following sheets by form 1б.

use crate::document::{Document, FormRow, Inlines};
use crate::error::KnowledgeError;
use crate::words::say;

use super::super::super::sheet::route::{WorkStep, told as told_step, work_steps};
use super::super::super::sheet::{blank_of, exactly, material_of};
use super::{Group, Kind, Lang, Sources, TitleBlock};
use super::{blank_mass, empty, equipment, line, names, page, sheets, text, times, tools_line, value, values};

const KIND: Kind = Kind {
    marks: ["ГОСТ 3.1118-82  форма 1", "ГОСТ 3.1118-82  форма 1б"],
    code: "МК",
    name: "card-route-name",
    fits: [13, 16],
};

const MATERIAL: [(u16, &str); 11] = [
    (5, ""),
    (18, "card-code"),
    (5, "card-unit"),
    (7, "card-mass"),
    (4, "card-norm-unit"),
    (7, "card-consumption"),
    (5, "card-use"),
    (12, "card-blank-code"),
    (32, "card-profile"),
    (5, "card-parts"),
    (10, "card-blank-mass"),
];
const A: [(u16, &str); 6] = [
    (4, "card-shop"),
    (4, "card-section"),
    (4, "card-workplace"),
    (5, "card-operation"),
    (29, "card-operation-name"),
    (59, "card-papers"),
];
const B: [(u16, &str); 12] = [
    (46, "card-equipment"),
    (4, "card-mechanisation"),
    (7, "card-profession"),
    (4, "card-grade"),
    (5, "card-conditions"),
    (4, "card-workers"),
    (5, "card-at-once"),
    (5, "card-norm-unit"),
    (5, "card-lot"),
    (5, "card-many"),
    (7, "card-preparatory"),
    (8, "card-piece"),
];

/// The card.
pub(in super::super) fn card(own: &Sources<'_>, title: &TitleBlock, lang: Lang) -> Result<Document, KnowledgeError> {
    let heads = [("А", &A[..]), ("Б", &B[..])].map(|(letter, columns)| {
        let mut row = names(lang, columns);
        row.cells.insert(0, super::name(5, letter));
        row
    });
    let forms = sheets(&KIND, [material(own, lang)?, heads.to_vec()], body(own, title, lang), own, title, lang);
    Ok(page("card-route-title", forms, own, &["card-standing", "card-route-legend", "card-by-hand"], lang))
}

/// The lines М01 and М02.
fn material(own: &Sources<'_>, lang: Lang) -> Result<Vec<FormRow>, KnowledgeError> {
    let part = &own.plan.part;
    let profile = blank_of(part, lang);
    let mass = blank_mass(own, lang)?;
    let none = Inlines::default;
    let unit = if mass.is_empty() { none() } else { Inlines::from("166") };
    let first = vec![super::name(5, "М01"), value(105, material_of(own.plan, own.knowledge, lang)).named("М01")];
    let held = vec![
        Inlines::from("М02"),
        none(),
        unit,
        none(),
        Inlines::from("1"),
        none(),
        none(),
        none(),
        profile.into(),
        Inlines::from("1"),
        mass,
    ];
    Ok(vec![FormRow { lines: 2, cells: first }, names(lang, &MATERIAL), values(lang, &MATERIAL, held)])
}

fn body(own: &Sources<'_>, title: &TitleBlock, lang: Lang) -> Vec<Group> {
    let plan = own.plan;
    let none = Inlines::default;
    let mut groups = Vec::new();
    let (number, name) = (lang.word("plan-operation-number"), lang.word("plan-operation-name"));
    let told = |text: &Option<String>| Inlines::from(text.clone().unwrap_or_default());
    let operation = line("А", lang, &A, vec![told(&title.shop), none(), none(), number.into(), name.into(), none()]);
    let [piece, preparatory] = times(own, lang);
    let lot = title.lot.map(|lot| Inlines::number(lot.to_string())).unwrap_or_default();
    let held = vec![
        Inlines::from(own.sheet.equipment.as_str()),
        none(),
        told(&title.profession),
        told(&title.grade),
        none(),
        none(),
        // One part at once, times for one.
        "1".into(),
        "1".into(),
        lot,
        none(),
        preparatory,
        piece,
    ];
    groups.push(vec![operation, line("Б", lang, &B, held)]);
    let steps = work_steps(plan);
    let here = steps.iter().filter(|step| !matches!(step, WorkStep::Elsewhere { .. }));
    for (at, step) in (1..).zip(here) {
        groups.push(text("О", &format!("{at}. {}", told_step(plan, step, lang)), &[]));
    }
    let times = say!(
        lang,
        "card-times",
        basic = exactly(plan.time.machine_min.0, 2),
        auxiliary = exactly(super::machine_auxiliary(plan), 2),
        hand = exactly(plan.time.hand_min.0, 2),
        total = exactly(plan.time.total_min.0, 2)
    );
    groups.push(text("О", &times, &[]));
    let tools: Vec<String> = plan.tools.iter().flat_map(|tool| equipment(own, tool, lang)).collect();
    if !tools.is_empty() {
        groups.push(tools_line(&tools));
    }
    let elsewhere: Vec<String> = steps
        .iter()
        .filter(|step| matches!(step, WorkStep::Elsewhere { .. }))
        .map(|step| told_step(plan, step, lang))
        .collect();
    if !elsewhere.is_empty() {
        let held = vec![none(), none(), none(), "010".into(), lang.word("card-elsewhere").into(), none()];
        groups.push(vec![empty(), line("А", lang, &A, held)]);
        for (at, step) in (1..).zip(elsewhere) {
            groups.push(text("О", &format!("{at}. {step}"), &[]));
        }
    }
    groups
}
