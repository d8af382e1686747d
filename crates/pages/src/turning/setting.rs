//! The setting of a lathe before a program runs: the tools in the turret, the tips, the points where offsets are
//! measured.

use crate::document::{Block, Column, Document, Inlines, Item, Keep};
use crate::note::{Figure, IntoFigure};
use technolog_turning::jobs::{Body, JobTool, Work};
use technolog_turning::operation::ground::Ground;
use technolog_turning::operation::setting::{SetSize, SetThread, SetTool, Setting, Stand};
use technolog_turning::operation::{SizeOf, Sized};
use technolog_turning::workpiece::ThreadLimits;
use technolog_words::say;

use super::Lang;
use super::cells::{Cell, figure, span, table};
use super::phrases::note_line;

/// The tool list and setting sheet of an operation.
pub fn setting_page(setting: &Setting, lang: Lang) -> Document {
    let mut page = Document::new(lang.tag(), say!(lang, "setting-title", part = setting.part.as_str()));
    page.paragraph(say!(lang, "turn-setting-zero", control = lang.term("control", &setting.control)));
    page.push(Block::List(setting.set_ups.iter().map(|stand| stand_item(stand, lang)).collect()));
    page.heading(2, say!(lang, "turn-setting-tools"));
    page.push(table(columns(lang), setting.tools.iter().map(|tool| row(tool, lang)).collect(), lang));
    if !setting.sizes.is_empty() {
        page.heading(2, say!(lang, "turn-setting-sizes"));
        let rows = setting.sizes.iter().map(|size| size_row(size, lang)).collect();
        page.push(table(size_columns(lang), rows, lang));
        page.paragraph(say!(lang, "turn-setting-size-corrected"));
    }
    if !setting.ground.is_empty() {
        page.heading(2, say!(lang, "turn-setting-ground"));
        let rows = setting.ground.iter().map(|one| ground_row(one, lang)).collect();
        page.push(table(ground_columns(lang), rows, lang));
        page.paragraph(say!(lang, "turn-setting-ground-allowance"));
    }
    if !setting.threads.is_empty() {
        page.heading(2, say!(lang, "turn-setting-threads"));
        let rows = setting.threads.iter().map(|thread| thread_row(thread, lang)).collect();
        page.push(table(thread_columns(lang), rows, lang));
        let wired = setting.threads.iter().any(|thread| thread.over_wires.is_some());
        let how = |thread: &SetThread| {
            let (written, how) = (thread.thread.as_str(), thread.cycle.as_ref()?);
            Some(Item::from(say!(lang, "turn-setting-thread-cut", thread = written, how = how)))
        };
        let cut: Vec<Item> = setting.threads.iter().filter_map(how).collect();
        if !cut.is_empty() {
            page.push(Block::List(cut));
        }
        page.paragraph(say!(lang, "turn-setting-thread-measured"));
        if wired {
            page.paragraph(say!(lang, "turn-setting-wires"));
        }
    }
    page.heading(2, say!(lang, "turn-setting-measured"));
    let measured = setting.tools.iter().map(|tool| {
        let (x, z) = (lang.say(&tool.x), lang.say(&tool.z));
        Item::from(say!(lang, "turn-setting-offsets", tool = seated(tool, lang), x = x, z = z))
    });
    page.push(Block::List(measured.collect()));
    page
}

fn stand_item(stand: &Stand, lang: Lang) -> Item {
    let holding = lang.say(&stand.held);
    let mut item: Item =
        say!(lang, "turn-setting-stand", number = stand.set_up, held = holding, stock = stand.face_stock_mm).into();
    item.items = stand.notes.iter().map(|note| Item::from(note_line(note, lang))).collect();
    item
}

fn size_columns(lang: Lang) -> [Column; 5] {
    let mm = lang.word("unit-mm");
    [
        Column::text(say!(lang, "turn-set-up-column")),
        Column::text(say!(lang, "turn-setting-surface")),
        Column::text(say!(lang, "turn-setting-drawn")),
        span(say!(lang, "turn-setting-limits"), mm),
        Column::number(say!(lang, "turn-setting-programmed"), mm),
    ]
}

fn size_row(size: &SetSize, lang: Lang) -> Vec<Cell> {
    let sized = &size.sized;
    vec![
        size.set_up.to_string().into(),
        lang.figure(&(&sized.surface).into_figure()).into(),
        fitted(sized, lang).into(),
        Cell::Range(sized.least_mm.to_mm(), sized.most_mm.to_mm(), 3),
        Cell::Figure(sized.made_mm.to_mm(), 3),
    ]
}

fn ground_columns(lang: Lang) -> [Column; 6] {
    let mm = lang.word("unit-mm");
    [
        Column::text(say!(lang, "turn-set-up-column")),
        Column::text(say!(lang, "turn-setting-surface")),
        Column::text(say!(lang, "turn-setting-drawn")),
        Column::text(say!(lang, "turn-setting-later")),
        Column::number(say!(lang, "turn-setting-turned"), mm),
        Column::number(say!(lang, "turn-setting-left"), mm),
    ]
}

fn ground_row(one: &Ground, lang: Lang) -> Vec<Cell> {
    let drawn = one.nominal_mm.map(|size| format!("Ø{} {}", figure(size, lang), one.fit));
    vec![
        one.set_up.map_or_else(Cell::empty, |number| number.to_string().into()),
        lang.figure(&(&one.surface).into_figure()).into(),
        drawn.unwrap_or_else(|| one.fit.clone()).trim().into(),
        lang.figure(&Figure::word(one.operation.name())).into(),
        one.turned_mm.map_or_else(Cell::empty, |size| Cell::Figure(size.to_mm(), 3)),
        Cell::Figure(one.allowance_mm.to_mm(), 3),
    ]
}

/// A size as the drawing has it.
pub(super) fn fitted(sized: &Sized, lang: Lang) -> String {
    let sign = if sized.of == SizeOf::Diameter { "Ø" } else { "" };
    format!("{sign}{} {}", figure(sized.nominal_mm, lang), sized.fit)
}

fn thread_columns(lang: Lang) -> [Column; 7] {
    let mm = lang.word("unit-mm");
    [
        Column::text(say!(lang, "turn-set-up-column")),
        Column::text(say!(lang, "turn-setting-surface")),
        Column::text(say!(lang, "turn-setting-thread")).min_width(10),
        span("d2", mm),
        span(say!(lang, "turn-setting-crests"), mm).keep(Keep::Useful),
        Column::number(say!(lang, "turn-setting-wire"), mm).keep(Keep::Useful),
        span(say!(lang, "turn-setting-over-wires"), mm).keep(Keep::Useful),
    ]
}

fn thread_row(thread: &SetThread, lang: Lang) -> Vec<Cell> {
    let limits = |limits: &Option<ThreadLimits>| {
        limits.as_ref().map_or_else(Cell::empty, |one| Cell::Range(one.least.to_mm(), one.most.to_mm(), 3))
    };
    vec![
        thread.set_up.to_string().into(),
        lang.figure(&(&thread.surface).into_figure()).into(),
        thread.thread.as_str().into(),
        limits(&thread.pitch_diameter),
        limits(&thread.crests),
        thread.wire_mm.map_or_else(Cell::empty, |wire| Cell::Figure(wire.to_mm(), 3)),
        limits(&thread.over_wires),
    ]
}

fn columns(lang: Lang) -> [Column; 10] {
    let mm = lang.word("unit-mm");
    let number = |key| Column::number(lang.word(key), "");
    // A designation stays on one line.
    let text = |key| Column::text(lang.word(key));
    [
        Column::text("T"),
        text("turn-tool").min_width(14),
        text("turn-setting-insert").keep(Keep::Useful),
        Column::text(Inlines::from(say!(lang, "turn-setting-shank", unit = mm))).keep(Keep::Useful),
        Column::number(say!(lang, "turn-job-nose"), mm),
        number("turn-setting-tip"),
        text("turn-set-up-column"),
        text("turn-job"),
        Column::text("X"),
        Column::text("Z"),
    ]
}

fn row(tool: &SetTool, lang: Lang) -> Vec<Cell> {
    let station = &tool.station;
    let nose = station.tool.nose_radius().to_mm();
    let set_ups: Vec<String> = tool.set_ups.iter().map(u8::to_string).collect();
    let works: Vec<&str> = tool.works.iter().map(|work: &Work| lang.term("turn-does", work.name())).collect();
    vec![
        seated(tool, lang).into(),
        station.tool.designation.as_str().into(),
        tool.insert.as_deref().unwrap_or_default().into(),
        shank(&station.tool).into(),
        if nose > 0.0 { Cell::Figure(nose, 2) } else { Cell::empty() },
        tool.orientation.map_or_else(Cell::empty, |number| Cell::count(usize::from(number))),
        set_ups.join(", ").into(),
        works.join(", ").into(),
        // The operator writes the measured value.
        "______".into(),
        "______".into(),
    ]
}

/// A tool by its place, with its offset where several share places.
fn seated(tool: &SetTool, lang: Lang) -> String {
    let place = tool.station.seat.place;
    match tool.offset {
        Some(offset) => say!(lang, "turn-setting-seat", place = place, offset = offset),
        None => format!("T{place}"),
    }
}

/// The clamped part of a tool: height and width of a square shank, or the diameter of a bar; empty where the catalog
/// has neither.
fn shank(tool: &JobTool) -> String {
    match &tool.body {
        Body::Insert { shank_mm: Some((height, width)), .. } => format!("{height}×{width}"),
        Body::Insert { bar_mm: Some(bar), .. } => format!("Ø{bar}"),
        Body::Tap { shank_mm, .. } => format!("Ø{shank_mm}"),
        Body::Insert { .. } | Body::Drill { .. } | Body::Reamer { .. } | Body::CentreDrill { .. } => String::new(),
    }
}
