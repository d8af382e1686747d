//! The plan as a page: route, tools, conditions, clamping, corrections, time, findings.

use crate::document::{Column, Document, Field, FindingBlock, Inlines, Severity as Shown};
use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::machine::Machine;
use crate::material::Material;
use crate::note::{Because, Figure, Finding, IntoFigure, Note, Severity};
use crate::part::Part;
use crate::plan::{Clamping, Plan};
use crate::units::{Micrometres, round_to};

use super::doubts::is_of_row;
use super::words::say;
use super::{Doubts, Lang};

mod chains;
mod conditions;
mod pins;
pub(crate) mod route;
mod set_up;
mod tools;

pub(super) use conditions::section as conditions;
pub(crate) use set_up::{
    bar_set, in_chuck, in_vice, less, less_radii, once, own_fixture, section as set_up, stops, turned_over, zero_sums,
};
pub(crate) use tools::named;
pub(super) use tools::{corrections, tools};

/// The mark of a figure from an unconfirmed row.
pub(super) const MARK: &str = "*";
/// The content of a cell without a figure.
pub(crate) const NONE: &str = "–";

/// The whole page.
pub fn page(plan: &Plan, knowledge: &Knowledge, doubts: Doubts, lang: Lang) -> Document {
    let mut page = Document::new(lang.tag(), say!(lang, "plan-title", part = plan.part.part.as_str()));
    head(&mut page, plan, knowledge, lang);
    if !plan.sequence.is_empty() {
        page.heading(2, say!(lang, "plan-route"));
        route::section(&mut page, plan, lang);
    }
    if !plan.tools.is_empty() {
        page.heading(2, say!(lang, "plan-tools"));
        page.push(tools(plan, lang));
    }
    if plan.holes.iter().any(|hole| !hole.transitions.is_empty()) {
        page.heading(2, say!(lang, "plan-conditions"));
        conditions(&mut page, plan, lang);
        page.heading(2, say!(lang, "plan-clamping"));
        set_up(&mut page, plan, lang);
    }
    if !plan.tools.is_empty() {
        page.heading(2, say!(lang, "plan-corrections"));
        page.push(corrections(plan, lang));
        page.heading(2, say!(lang, "plan-time"));
        page.paragraph(time(plan, lang));
    }
    if !plan.findings.is_empty() {
        page.heading(2, say!(lang, "plan-findings"));
        findings(&mut page, plan, doubts, lang);
    }
    page
}

/// A number with the separator of the language, without trailing zeros.
pub(crate) fn number(value: f64, places: u32, lang: Lang) -> String {
    lang.figure(&rounded(value, places))
}

/// A length in mm with the separator of the language, without trailing zeros.
pub(crate) fn mm(value: Micrometres, lang: Lang) -> String {
    lang.figure(&value.into_figure())
}

/// A number for a sentence, without trailing zeros.
pub(crate) fn rounded(value: f64, places: u32) -> Figure {
    Figure::number(round_to(value, places).to_string())
}

/// A number for a sentence, with all its decimal places.
pub(crate) fn exactly(value: f64, places: u32) -> Figure {
    Figure::fixed(round_to(value, places), places as usize)
}

/// A number for a column: with the same number of decimal places as the others.
pub(crate) fn cell(value: f64, places: u32, lang: Lang) -> Inlines {
    Inlines::number(lang.figure(&exactly(value, places)))
}

/// Lengths of one column, all with the number of decimal places that one of them needs; mm.
pub(crate) fn column(values: &[Micrometres], lang: Lang) -> Vec<Inlines> {
    let needs = |value: &Micrometres| value.to_string().split_once('.').map_or(0, |(_, places)| places.len());
    let places = values.iter().map(needs).max().unwrap_or(0);
    values.iter().map(|value| Inlines::number(lang.figure(&Figure::fixed(value.to_mm(), places)))).collect()
}

/// A heading that may be of two alphabets, such as `Sхв`.
fn heading(key: &'static str, lang: Lang) -> String {
    lang.say(&Note::new(key))
}

/// The column of the names of holes, and of slots where there are any.
pub(super) fn of_surface(plan: &Plan, lang: Lang) -> Column {
    let slots = plan.part.holes.iter().any(|hole| hole.slot.is_some());
    Column::text(lang.word(if slots { "plan-hole-or-slot" } else { "plan-hole" })).min_width(4)
}

/// The word for a hole or a slot in `for the hole`.
pub(super) fn surface(part: &Part, name: &str, lang: Lang) -> &'static str {
    let slot = part.holes.iter().any(|own| own.name == name && own.slot.is_some());
    lang.find(if slot { "plan-slot-of" } else { "plan-hole-of" }).unwrap_or_default()
}

/// The mark after a figure from an unconfirmed row.
pub(super) fn mark<'b>(because: impl IntoIterator<Item = &'b Because>) -> &'static str {
    if because.into_iter().any(|reason| reason.unconfirmed.is_some()) { MARK } else { "" }
}

/// The material of the part in the state that the part gives.
///
/// # Errors
/// The tables lack it.
pub(super) fn material<'k>(part: &Part, knowledge: &'k Knowledge) -> Result<Material<'k>, KnowledgeError> {
    let material = Material::find(knowledge, &part.material)?;
    match part.material_state {
        Some(state) => material.in_state(state, knowledge),
        None => Ok(material),
    }
}

/// The material with the figure that holds for it.
pub(super) fn material_of(plan: &Plan, knowledge: &Knowledge, lang: Lang) -> String {
    let part = &plan.part;
    material(part, knowledge).map_or_else(
        |_| part.material.clone(),
        |material| {
            let (hardness, strength) = (material.hardness, material.strength);
            let key = if strength.millionths() > 0 { "plan-material-of-strength" } else { "plan-material-of-hardness" };
            lang.say(
                &Note::new(key)
                    .with("material", material.designation().to_owned())
                    .with("hardness", hardness)
                    .with("strength", strength),
            )
        },
    )
}

/// Material, blank and machine.
pub(super) fn head(page: &mut Document, plan: &Plan, knowledge: &Knowledge, lang: Lang) {
    let part = &plan.part;
    let material = material_of(plan, knowledge, lang);
    let machine = Machine::find(knowledge, &part.machine).map(|machine| &machine.table.title);
    // The title of a table stands in the table, in both languages.
    let machine = machine.map_or(part.machine.as_str(), |title| title.text(lang.tag()));
    let blank = blank_of(part, lang);
    page.push(crate::document::Block::Fields(vec![
        Field::new(say!(lang, "plan-material"), material),
        Field::new(say!(lang, "plan-blank"), blank),
        Field::new(say!(lang, "plan-machine"), machine),
    ]));
}

/// The blank by its sizes.
pub(crate) fn blank_of(part: &Part, lang: Lang) -> String {
    let (length, width, thickness) = (part.blank.length, part.blank.width, part.blank.thickness);
    match (part.blank.is_round(), part.blank.bore) {
        (false, _) => say!(lang, "plan-plate", length = length, width = width, thickness = thickness).to_owned(),
        (true, None) => say!(lang, "plan-disc", diameter = length, thickness = thickness).to_owned(),
        (true, Some(bore)) => say!(lang, "plan-ring", diameter = length, bore = bore, thickness = thickness).to_owned(),
    }
}

/// Where the clamps press, with which force and screw.
pub(super) fn clamps_of(clamping: &Clamping, part: &Part, lang: Lang) -> String {
    let points = clamping.clamps.iter().map(|point| say!(lang, "plan-point", x = point.x, y = point.y));
    let points = points.collect::<Vec<_>>().join(", ");
    let key = if clamping.proposed { "plan-clamps-proposed" } else { "plan-clamps" };
    let screw = format!("{}{}", clamping.screw, mark(&clamping.because));
    let sentence = Note::new(key).with("points", points).with("force", rounded(clamping.force_per_clamp_n.0, 0));
    let said = lang.say(&sentence.with("screw", screw).with("distance", clamping.safe_distance_mm));
    let Some(strap) = clamping.strap else { return said };
    let straps = match part.fixture.retract {
        Some(retract) => Note::new("plan-straps-lower").with("most", retract),
        None => Note::new("plan-straps")
            .with("width", strap.width_mm)
            .with("length", strap.length_mm)
            .with("height", strap.height_mm),
    };
    [&said, &lang.say(&straps), lang.word("plan-studs")].join(" ")
}

/// That the screw does not bear its share.
pub(super) fn weak_screw(clamping: &Clamping, lang: Lang) -> String {
    let (bears, each) = (clamping.screw_bears_n.0, clamping.force_per_clamp_n.0);
    say!(lang, "plan-weak-screw", bears = rounded(bears, 0), force = rounded(each, 0))
}

/// The existing parts of the time, and their sum.
fn time(plan: &Plan, lang: Lang) -> String {
    let time = &plan.time;
    let parts = [
        ("plan-time-machine", time.machine_min, true),
        ("plan-time-feed-out", time.feed_out_min, false),
        ("plan-time-dwell", time.dwell_min, false),
        ("plan-time-rapid", time.rapid_min, true),
        ("plan-time-change", time.tool_change_min, true),
        ("plan-time-hand", time.hand_min, false),
    ];
    let there = parts.iter().filter(|(_, time, always)| *always || time.0 > 0.0);
    let texts = there.map(|(key, time, _)| lang.say(&Note::new(*key).with("time", exactly(time.0, 2))));
    let parts = texts.collect::<Vec<_>>().join(" + ");
    say!(lang, "plan-times", parts = parts, total = exactly(time.total_min.0, 2))
}

/// What stands against the part.
pub(super) fn findings_of_errors(page: &mut Document, plan: &Plan, lang: Lang) {
    plan.findings.iter().filter(|own| own.severity <= Severity::Wrong).for_each(|own| finding(page, plan, own, lang));
}

fn findings(page: &mut Document, plan: &Plan, doubts: Doubts, lang: Lang) {
    let (listed, counted) = doubts.split(plan.findings.iter());
    if let Some(counted) = counted {
        page.push(FindingBlock::new(Shown::Doubtful, MARK, Inlines::sentence(&lang.say(&counted))));
    }
    listed.into_iter().for_each(|own| finding(page, plan, own, lang));
}

/// A finding of a plan.
pub(super) fn finding(page: &mut Document, plan: &Plan, finding: &Finding, lang: Lang) {
    let (severity, word) = match finding.severity {
        Severity::Error => (Shown::Error, say!(lang, "plan-impossible")),
        Severity::Wrong => (Shown::Wrong, say!(lang, "plan-wrong")),
        // The mark belongs to unconfirmed rows; other doubts are written as a word.
        Severity::Doubtful if is_of_row(&finding.note) => (Shown::Doubtful, MARK),
        Severity::Doubtful => (Shown::Doubtful, say!(lang, "plan-doubtful")),
        Severity::Note => (Shown::Note, say!(lang, "plan-note")),
    };
    let text = match &finding.hole {
        Some(hole)
            if plan
                .part
                .holes
                .iter()
                .any(|own| own.name == *hole && own.slot.is_some_and(|slot| slot.corner.is_some())) =>
        {
            say!(lang, "plan-of-pocket", pocket = Figure::called(hole), finding = finding.note.clone())
        }
        Some(hole) if plan.part.holes.iter().any(|own| own.name == *hole && own.slot.is_some()) => {
            say!(lang, "plan-of-slot", slot = Figure::called(hole), finding = finding.note.clone())
        }
        Some(hole) => say!(lang, "plan-of-hole", hole = Figure::called(hole), finding = finding.note.clone()),
        None => lang.say(&finding.note),
    };
    page.push(FindingBlock::new(severity, word, Inlines::sentence(&text)));
}
