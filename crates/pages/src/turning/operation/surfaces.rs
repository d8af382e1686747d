//! The surfaces of each set-up: their data from the drawing, their class (main or additional), and their allowances.

use crate::document::{Block, Column, Document, Inlines, Item, Keep};
use crate::note::IntoFigure;
use technolog_turning::contour::Side;
use technolog_turning::elements::Element;
use technolog_turning::operation::{Operation, SetUpWork, SideWork};
use technolog_turning::zones::TurnedSide;
use technolog_words::say;

use super::super::Lang;
use super::super::cells::{Cell, arrow, figure, span, table};
use super::super::phrases::{note_line, reasoned, word, z};
use super::super::setting::fitted;

pub(super) fn surfaces(page: &mut Document, operation: &Operation, set_up: &SetUpWork, lang: Lang) {
    let one = &set_up.set_up;
    page.heading(3, say!(lang, "turn-set-up", number = one.number));
    let notes = one.notes.iter().map(|note| note_line(note, lang)).chain([reasoned(&one.because, lang)]);
    let notes = notes.chain(set_up.jaws.iter().map(|jaws| note_line(&jaws.note(), lang)));
    let notes = notes.chain(set_up.jaws.iter().filter_map(|jaws| jaws.bored()).map(|note| note_line(&note, lang)));
    let notes = notes.chain(set_up.grip.iter().map(|grip| note_line(&grip.note(), lang)));
    let notes = notes.chain(set_up.tailstock.iter().map(|tailstock| note_line(&tailstock.note(), lang)));
    page.blocks.push(Block::List(notes.map(Item::from).collect()));
    for (side, stretch) in [(Side::Outer, &one.outer), (Side::Inner, &one.inner)] {
        let Some(stretch) = stretch else { continue };
        let work = set_up.sides.iter().find(|work| work.side == side);
        page.heading(4, lang.term("turn-contour", side.name()));
        elements(page, operation, stretch, work, lang);
        let axial = set_up.axial.iter().filter(|_| side == Side::Inner).flat_map(|axial| &axial.holes);
        let axial: Vec<Item> = axial.map(|hole| Item::from(reasoned(&hole.because, lang))).collect();
        if !axial.is_empty() {
            page.blocks.push(Block::List(axial));
        }
    }
}

fn elements(page: &mut Document, operation: &Operation, stretch: &TurnedSide, work: Option<&SideWork>, lang: Lang) {
    let mm = say!(lang, "unit-mm");
    let columns = [
        Column::text(say!(lang, "turn-surface")),
        Column::text(say!(lang, "turn-surface-kind")),
        span("Ø", mm),
        span("Z", mm),
        Column::number("IT", "").keep(Keep::Useful),
        span("Ra, Rz", "").keep(Keep::Useful),
        Column::number(say!(lang, "turn-finish-allowance"), mm).keep(Keep::Useful),
    ];
    let (mut rows, mut under) = (Vec::new(), Vec::<Inlines>::new());
    for (index, (surface, class)) in stretch.profile.surfaces.iter().zip(&stretch.classes).enumerate() {
        let ends = surface.pieces.first().zip(surface.pieces.last());
        let (from, to) = ends.map(|(first, last)| (first.from, last.to)).unwrap_or_default();
        let allowance = work.and_then(|work| work.layers.allowances.get(index)).and_then(|one| one.allowance_mm);
        // The reason, if it is not a main element.
        under.extend((class.element != Element::Main).then(|| note_line(&class.because.note, lang)));
        if let Some(later) = operation.elsewhere.iter().find(|one| one.surface == surface.name) {
            let (operation, allowance) = (word(later.operation.name()), later.allowance_mm);
            under.push(
                say!(lang, "turn-later", surface = &surface.name, operation = operation, allowance = allowance).into(),
            );
        }
        let sized = operation.sizes.of_surface(&surface.name);
        under.extend(sized.map(|sized| {
            let (drawn, made) = (fitted(sized, lang), sized.made_mm);
            let (least, most) = (sized.least_mm, sized.most_mm);
            say!(lang, "turn-sized", surface = &surface.name, drawn = drawn, least = least, most = most, made = made)
                .into()
        }));
        rows.push(vec![
            lang.figure(&(&surface.name).into_figure()).into(),
            lang.term("word", surface.kind.name()).into(),
            arrow(figure(from.radius.diameter(), lang), figure(to.radius.diameter(), lang)).into(),
            arrow(z(from.z, lang), z(to.z, lang)).into(),
            surface.grade.map_or(String::new(), |grade| grade.to_string()).into(),
            surface.roughness.map_or(String::new(), |roughness| figure(roughness, lang)).into(),
            allowance.map_or_else(Cell::empty, |allowance| Cell::Figure(allowance.to_mm(), 2)),
        ]);
    }
    let mut surfaces = table(columns, rows, lang);
    let all = stretch.classes.iter().all(|class| class.element == Element::Main);
    surfaces.notes.push(if all { say!(lang, "turn-all-main") } else { say!(lang, "turn-rest-main") }.into());
    page.push(surfaces);
    if !under.is_empty() {
        page.blocks.push(Block::List(under.into_iter().map(Item::from).collect()));
    }
}
