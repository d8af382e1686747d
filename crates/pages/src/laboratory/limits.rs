//! What the part needs of the machine beside what the machine has: the ground of the conclusion that it can be made.

use crate::demand::{Beside, Demand, demands};
use crate::document::{Block, Column, Document, Inlines, Table};
use crate::error::KnowledgeError;
use crate::machine::Machine;
use crate::note::Figure;
use crate::report::unit as unit_of;
use crate::tables::machines::MachineQuantity;
use crate::units::{Micrometres, Unit};
use crate::zone::Mass;

use super::super::sheet::{finding as finding_of, findings_of_errors, rounded};
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
    for own in machine.characteristics().filter(|own| own.name != MachineQuantity::Control.name()) {
        let Some(label) = lang.find(&format!("characteristic-{}", own.name)) else { continue };
        let figures: Vec<String> = own.values.iter().map(|figure| lang.figure(&short(*figure))).collect();
        let said = match figures.as_slice() {
            [] => own.text.unwrap_or_default().into(),
            [one] => Inlines::number(one),
            several => several.join("; ").into(),
        };
        table.row([label.into(), said, unit_of(own.unit, lang).into()]);
    }
    table
}

/// The inequalities, each with both sides; then what stands against the part.
///
/// # Errors
/// A table of the masses is broken.
pub(super) fn section(
    page: &mut Document,
    own: &Sources<'_>,
    machine: &Machine<'_>,
    lang: Lang,
) -> Result<(), KnowledgeError> {
    let plan = own.plan;
    let mut table = Table::new([
        Column::text(say!(lang, "lab-limit")).min_width(24),
        Column::text(say!(lang, "lab-needed")),
        Column::text(say!(lang, "lab-available")),
        Column::text(say!(lang, "lab-enough")).min_width(4),
    ]);
    for demand in demands(plan, machine, own.knowledge)? {
        let enough = lang.word(match demand.is_met() {
            Some(true) => "lab-yes",
            Some(false) => "lab-no",
            None => "lab-unsure",
        });
        let (name, unit, [needed, available]) = said(&demand);
        let side = |value: f64| Inlines::default().quantity(lang.figure(&short(value)), unit_of(unit, lang));
        let needed = match demand {
            Demand::MassKg(mass, _) => weight(mass, lang),
            _ => side(needed),
        };
        table.row([lang.word(name).into(), needed, side(available), enough.into()]);
    }
    page.push(table);
    let key = match (plan.has_errors() || own.warning.is_some(), own.left.is_empty()) {
        (true, _) => "lab-cannot-be-made",
        (false, true) => "lab-can-be-made",
        (false, false) => "lab-can-be-made-but",
    };
    page.paragraph(lang.word(key));
    findings_of_errors(page, plan, lang);
    own.of_program().for_each(|finding| finding_of(page, plan, finding, lang));
    page.push(Block::List(own.left.iter().map(|left| Inlines::sentence(left).into()).collect()));
    Ok(())
}

/// A mass with its unit: one figure, between two, or at most one.
pub(super) fn weight(mass: Mass, lang: Lang) -> Inlines {
    let kilogram = || unit_of(Unit::Kilogram, lang);
    let [least, most] = [mass.least, mass.most].map(|own| lang.figure(&kilograms(own)));
    match mass.exact() {
        Some(_) => Inlines::default().quantity(most, kilogram()),
        None if mass.least > 0.0 => format!("{least}–{most} {}", kilogram()).into(),
        None => Inlines::from("≤ ").quantity(most, kilogram()),
    }
}

/// A mass with three significant digits, as blanks are weighed.
pub(super) fn kilograms(mass: f64) -> Figure {
    rounded(
        mass,
        if mass < 1.0 {
            3
        } else if mass < 10.0 {
            2
        } else {
            1
        },
    )
}

/// The name of a demand, its unit, and both of its sides in that unit.
fn said(demand: &Demand) -> (&'static str, Unit, [f64; 2]) {
    let mm = |own: &Beside<Micrometres>| [own.needed.to_mm(), own.available.to_mm()];
    match demand {
        Demand::SpanX(own) => ("lab-span-x", Unit::Millimetre, mm(own)),
        Demand::SpanY(own) => ("lab-span-y", Unit::Millimetre, mm(own)),
        Demand::Assembly(own) => ("lab-tool-length", Unit::Millimetre, mm(own)),
        Demand::Drill(own) => ("lab-drill", Unit::Millimetre, mm(own)),
        Demand::EndMill(own) => ("lab-end-mill", Unit::Millimetre, mm(own)),
        Demand::OtherTool(own) => ("lab-tool-diameter", Unit::Millimetre, mm(own)),
        Demand::Power(own) => ("lab-power", Unit::Kilowatt, [own.needed.0, own.available.0]),
        Demand::Torque(own) => ("lab-torque", Unit::NewtonMetre, [own.needed.0, own.available.0]),
        Demand::Thrust(own) => ("lab-thrust", Unit::Newton, [own.needed.0, own.available.0]),
        Demand::MassKg(mass, limit) => ("lab-mass", Unit::Kilogram, [mass.most, *limit]),
    }
}

/// A figure with as many places as a reader of a characteristic wants.
fn short(value: f64) -> Figure {
    rounded(value, 3)
}
