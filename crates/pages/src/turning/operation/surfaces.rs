//! The surfaces of each set-up: what the drawing says of them, main or additional, and their allowances.

use technolog_turning::contour::Side;
use technolog_turning::elements::{Class, Element};
use technolog_turning::operation::{Operation, SetUpWork, SideWork};
use technolog_turning::zones::Stretch;

use super::super::super::sentences::term;
use super::super::super::{Lang, grid, sentence};
use super::super::figure;
use super::{reasoned, z};

pub(super) fn surfaces(operation: &Operation, set_up: &SetUpWork, lang: Lang) -> String {
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
        page.push_str(&grid::paragraph(term(side.name(), lang), 2));
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
            format!("{} +{}", term(later.operation.name(), lang), figure(later.allowance_mm, lang))
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
    grid::table(&head, &rows, 4)
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
