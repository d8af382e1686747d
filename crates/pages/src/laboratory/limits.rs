//! What the part needs of the machine beside what the machine has: the ground of the conclusion that it can be made.

use crate::document::{Block, Column, Document, Inlines, Table};
use crate::machine::Machine;
use crate::note::Figure;
use crate::part::Point;
use crate::plan::{Conditions, Plan, ToolPlan, Transition};
use crate::units::Micrometres;

use super::super::sheet::findings_of_errors;
use super::super::words::say;
use super::{Lang, Sources};

/// The record of the machine: every characteristic that is a number or a word, with its unit.
pub(super) fn record(machine: &Machine<'_>, lang: Lang) -> Table {
    let mut table = Table::new([
        Column::text(say!(lang, "lab-characteristic")).min_width(24),
        Column::text(say!(lang, "lab-figure")),
        Column::text(say!(lang, "lab-unit")).min_width(4),
    ]);
    // The control has a line of its own, by its name for people.
    for own in machine.characteristics().filter(|own| own.name != "control") {
        let Some(label) = lang.find(&format!("characteristic-{}", own.name)) else { continue };
        let figures: Vec<String> = own.values.iter().map(|figure| lang.figure(&short(*figure))).collect();
        let said = if figures.is_empty() { own.text.unwrap_or_default().to_owned() } else { figures.join("; ") };
        table.row([label.to_owned(), said, crate::report::unit(own.unit, lang).to_owned()]);
    }
    table
}

/// The inequalities, each with both sides; then what stands against the part.
pub(super) fn section(page: &mut Document, own: &Sources<'_>, machine: &Machine<'_>, lang: Lang) {
    let plan = own.plan;
    let mut table = Table::new([
        Column::text(say!(lang, "lab-limit")).min_width(24),
        Column::text(say!(lang, "lab-needed")),
        Column::text(say!(lang, "lab-available")),
        Column::text(say!(lang, "lab-enough")).min_width(4),
    ]);
    for limit in limits(plan, machine) {
        let enough = lang.word(if limit.needed <= limit.available { "lab-yes" } else { "lab-no" });
        let unit = lang.word(limit.unit);
        let side = |value: f64| format!("{} {unit}", lang.figure(&short(value))).trim_end().to_owned();
        let row = [lang.word(limit.name).to_owned(), side(limit.needed), side(limit.available), enough.to_owned()];
        table.row(row);
    }
    page.push(table);
    let key = match (plan.has_errors() || own.warning.is_some(), own.left.is_empty()) {
        (true, _) => "lab-cannot-be-made",
        (false, true) => "lab-can-be-made",
        (false, false) => "lab-can-be-made-but",
    };
    page.paragraph(lang.word(key));
    findings_of_errors(page, plan, lang);
    page.push(Block::List(own.left.iter().map(|left| Inlines::sentence(left).into()).collect()));
}

struct Limit {
    name: &'static str,
    needed: f64,
    available: f64,
    unit: &'static str,
}

fn limits(plan: &Plan, machine: &Machine<'_>) -> Vec<Limit> {
    let here = || plan.holes.iter().flat_map(|hole| &hole.transitions).filter(|own| !own.elsewhere);
    let most = |of: &dyn Fn(&Transition) -> Option<f64>| here().filter_map(of).fold(0.0, f64::max);
    let of = |own: &dyn Fn(&Conditions) -> Option<f64>| most(&|it| own(&it.conditions));
    let span = |of: &dyn Fn(&Point) -> Micrometres| {
        let all = || plan.part.holes.iter().flat_map(|hole| &hole.at).map(of);
        all().max().zip(all().min()).map_or(0.0, |(most, least)| (most - least).to_mm())
    };
    let longest = |of: &dyn Fn(&ToolPlan) -> Micrometres| plan.tools.iter().map(of).max().unwrap_or_default().to_mm();
    let limit = |name, needed, available, unit| Limit { name, needed, available, unit };
    let mut all = vec![
        limit("lab-span-x", span(&|at| at.x), machine.travel_x.to_mm(), "unit-mm"),
        limit("lab-span-y", span(&|at| at.y), machine.travel_y.to_mm(), "unit-mm"),
        limit("lab-tool-length", longest(&|tool| tool.length_mm), machine.overhang_max.to_mm(), "unit-mm"),
        limit("lab-tool-diameter", longest(&|tool| tool.diameter_mm), machine.tool_diameter_max.to_mm(), "unit-mm"),
        limit("lab-power", of(&|own| own.power_kw.map(|it| it.0)), machine.spindle_power.0, "lab-kw"),
        limit("lab-torque", of(&|own| own.torque_n_m.map(|it| it.0)), machine.spindle_torque.0, "lab-nm"),
        limit("lab-thrust", of(&|own| own.axial_force_n.map(|it| it.0)), machine.thrust.0, "lab-n"),
    ];
    if let Some(mass) = plan.part.mass_kg {
        all.push(limit("lab-mass", mass, machine.load_max_kg, "lab-kg"));
    }
    all
}

/// A figure with as many places as a reader of a characteristic wants.
fn short(value: f64) -> Figure {
    super::super::sheet::rounded(value, 3)
}
