//! The list of tools with all that section 5.2, item 5, asks of them: what proves that the cutter suits the surface (Ø,
//! the length that cuts) and the holder the cutter (shank, Morse taper), and the lengths that make the assembly.

use crate::document::{Column, Document, Inlines, Keep, Table};
use crate::note::{Figure, IntoFigure};
use crate::plan::ToolPlan;
use crate::tables::tools::CutterRow;
use crate::units::Micrometres;
use crate::words::say;

use super::super::sheet;
use super::{Lang, Sources};

/// The assemblies, then the cutters as their catalogs have them.
pub(super) fn section(page: &mut Document, own: &Sources<'_>, lang: Lang) {
    page.push(sheet::tools(own.plan, lang));
    if own.plan.tools.is_empty() {
        return;
    }
    let mm = lang.word("unit-mm");
    let mut table = Table::new([
        Column::text("T"),
        Column::text(say!(lang, "tool-list-name")).min_width(20),
        Column::text(say!(lang, "tool-list-standard")),
        Column::number("Ø", mm),
        Column::number("L", mm),
        Column::number("l0", mm),
        Column::text(say!(lang, "tool-list-shank")),
        Column::number(say!(lang, "tool-list-shank-size"), ""),
        Column::text(say!(lang, "tool-list-holder")).keep(Keep::Useful),
    ]);
    own.plan.tools.iter().for_each(|tool| table.row(cutter(own, tool, lang)));
    table.notes.push(say!(lang, "tool-list-lengths").into());
    page.heading(3, say!(lang, "tool-list-cutters"));
    page.push(table);
}

/// A line of the cutters; a dash where the catalog has no such figure.
fn cutter(own: &Sources<'_>, tool: &ToolPlan, lang: Lang) -> Vec<Inlines> {
    let table = own.knowledge.table(&tool.table).ok();
    let standard = |id: &str| own.knowledge.table(id).ok().and_then(|table| table.standard.clone());
    let is_own = |row: &CutterRow<'_>| row.designations().any(|name| name == tool.designation);
    let row = table.and_then(|table| table.rows::<CutterRow<'_>>().filter_map(Result::ok).find(is_own));
    let length = |value: Option<Micrometres>| match value {
        Some(value) => Inlines::number(lang.figure(&value.into_figure())),
        None => sheet::NONE.into(),
    };
    let of_row = |figure: fn(&CutterRow<'_>) -> Option<Micrometres>| length(row.as_ref().and_then(figure));
    let shank = table.and_then(|table| table.tool.as_ref()).map(|head| lang.figure(&Figure::word(head.shank.name())));
    let morse = row.as_ref().and_then(|row| row.morse);
    let size = match (morse, row.as_ref().and_then(|row| row.shank_diameter.or(row.bore))) {
        (Some(morse), _) => Inlines::number(format!("№ {morse}")),
        (None, Some(size)) => Inlines::number(format!("Ø{}", lang.figure(&size.into_figure()))),
        (None, None) => sheet::NONE.into(),
    };
    let told = |text: Option<String>| text.unwrap_or_else(|| sheet::NONE.to_owned());
    vec![
        format!("T{}", tool.number).into(),
        told(table.map(|table| format!("{}: {}", table.title.text(lang.tag()), tool.designation))).into(),
        told(standard(&tool.table)).into(),
        length(Some(tool.diameter_mm)),
        of_row(|row| row.length),
        of_row(|row| row.flute_length.or(row.cutting_length)),
        told(shank).into(),
        size,
        told(standard(&tool.holder_table)).into(),
    ]
}
