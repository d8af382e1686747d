//! Route card and operation card in the manner of GOST 3.1118-82 and 3.1404-86, on sheets with the title block of GOST
//! 3.1103.
//!
//! Widths of columns, rows and the order of lines are those of drawn and of filled cards; the widths of the lines М01,
//! М02 and of the strips of the operation card are ours, because no drawing of them was found. What a plan does not
//! know (section, place of work, what the title block does not give) is an empty field, never a guess.
//!
//! - `route` the route card; `operation` the operation card; here what they share: title block, lines, sheets.

use crate::document::{Block, CellKind, Document, Form, FormCell, FormRow, Inlines};
use crate::error::KnowledgeError;
use crate::note::Note;
use crate::plan::{Plan, ToolPlan, Transition};
use crate::words::say;
use crate::zone::{Mass, mass};

use super::super::sheet::{self, exactly};
use super::limits::kilograms;
use super::norm::marked;
use super::{Lang, Sources, TitleBlock};

mod operation;
mod route;

pub(super) use operation::card as operation_card;
pub(super) use route::card as route_card;

/// A line of the body: its letter, and the cells right of the line's code.
struct Line {
    /// `А`, `Б`, `О`, `Т`, `Р`; empty for a line that nothing is written on.
    letter: &'static str,
    /// Whether it goes on with the text of the line above: it has its letter only at the head of a sheet.
    goes_on: bool,
    cells: Vec<FormCell>,
}

/// Lines that stand on one sheet: a step with its tool and its figures.
type Group = Vec<Line>;

/// Characters of the code of a line.
const CODE: u16 = 5;
/// Characters right of it.
const REST: u16 = 105;

/// What differs between the two cards.
struct Kind {
    /// Marks of the first and of the following sheets.
    marks: [&'static str; 2],
    /// The code in the bottom line, and the key of its name.
    code: &'static str,
    name: &'static str,
    /// How many body lines fit on the first sheet and on each that follows.
    fits: [usize; 2],
}

fn name(width: u16, words: impl Into<Inlines>) -> FormCell {
    FormCell::new(CellKind::Name, width, words)
}

fn value(width: u16, words: impl Into<Inlines>) -> FormCell {
    FormCell::new(CellKind::Value, width, words)
}

fn gap(width: u16) -> FormCell {
    FormCell::new(CellKind::Gap, width, "")
}

/// A row of names, each by the key of its word.
fn names(lang: Lang, columns: &[(u16, &'static str)]) -> FormRow {
    let cell = |(width, key): &(u16, &'static str)| name(*width, if key.is_empty() { "" } else { lang.word(key) });
    FormRow { lines: 1, cells: columns.iter().map(cell).collect() }
}

/// A row of values under those names.
fn values(lang: Lang, columns: &[(u16, &'static str)], held: Vec<Inlines>) -> FormRow {
    let cells = columns
        .iter()
        .zip(held)
        .map(|((width, key), words)| value(*width, words).named(if key.is_empty() { "" } else { lang.word(key) }));
    FormRow { lines: 2, cells: cells.collect() }
}

/// A line of the body whose columns have names.
fn line(letter: &'static str, lang: Lang, columns: &[(u16, &'static str)], held: Vec<Inlines>) -> Line {
    let cells = columns.iter().zip(held).map(|((width, key), words)| {
        FormCell::new(CellKind::Line, *width, words).named(if key.is_empty() { "" } else { lang.word(key) })
    });
    Line { letter, goes_on: false, cells: cells.collect() }
}

/// A text over the whole width, on as many lines as it needs.
fn text(letter: &'static str, text: &str, tail: &[FormCell]) -> Group {
    whole(letter, &text.split_whitespace().collect::<Vec<_>>(), tail)
}

/// Pieces over the whole width; what is one piece stays on one line, unless no line holds it.
fn whole(letter: &'static str, pieces: &[&str], tail: &[FormCell]) -> Group {
    let room = REST - tail.iter().map(|cell| cell.width).sum::<u16>();
    let width = usize::from(room);
    let letters = |text: &str| text.chars().count();
    let pieces = pieces.iter().flat_map(|piece| match letters(piece) > width {
        true => piece.split(' ').collect(),
        false => vec![*piece],
    });
    let mut rows: Vec<String> = vec![String::new()];
    for piece in pieces {
        let long = rows.last().map_or(0, |row| letters(row));
        if long > 0 && long + 1 + letters(piece) > width {
            rows.push(String::new());
        }
        if let Some(row) = rows.last_mut() {
            row.push_str(if row.is_empty() { "" } else { " " });
            row.push_str(piece);
        }
    }
    let row = |(at, words): (usize, String)| {
        let mut cells = vec![FormCell::new(CellKind::Line, room, words)];
        // The figures of a step stand on its first line.
        cells.extend(tail.iter().map(|cell| match at {
            0 => cell.clone(),
            _ => FormCell { words: Inlines::default(), ..cell.clone() },
        }));
        Line { letter, goes_on: at > 0, cells }
    };
    rows.into_iter().enumerate().map(row).collect()
}

/// An empty line, as stands between operations.
fn empty() -> Line {
    Line { letter: "", goes_on: false, cells: vec![FormCell::new(CellKind::Line, REST, "")] }
}

/// The lines of each sheet: a group that the rest of a sheet does not hold begins the next one, unless no sheet holds it.
fn paged(body: Vec<Group>, [first, following]: [usize; 2]) -> Vec<Vec<Line>> {
    let mut sheets: Vec<Vec<Line>> = vec![Vec::new()];
    for group in body {
        let long = group.len();
        for (at, line) in group.into_iter().enumerate() {
            let fits = if sheets.len() == 1 { first } else { following };
            let held = sheets.last().map_or(0, Vec::len);
            if held == fits || (at == 0 && held + long > fits && long <= following) {
                sheets.push(Vec::new());
            }
            if let Some(sheet) = sheets.last_mut() {
                sheet.push(line);
            }
        }
    }
    sheets
}

/// The sheets of a card: the title block, what stands under it, the heads of the body, and the body over as many sheets
/// as it needs. The lines are numbered from 1 on each.
fn sheets(
    kind: &Kind,
    [under_title, heads]: [Vec<FormRow>; 2],
    body: Vec<Group>,
    own: &Sources<'_>,
    title: &TitleBlock,
    lang: Lang,
) -> Vec<Form> {
    let [first, following] = kind.fits;
    let paged = paged(body, kind.fits);
    let count = paged.len();
    let mut forms = Vec::new();
    for (sheet, lines) in (1..).zip(paged) {
        let mut lines = lines.into_iter();
        let fits = if sheet == 1 { first } else { following };
        let mut rows = changes(sheet, count, lang);
        match sheet {
            1 => {
                rows.extend(signatures(own, title, lang));
                rows.extend(under_title.iter().cloned());
            }
            _ => rows.extend(strip(own)),
        }
        rows.extend(heads.iter().cloned());
        for number in 1..=fits {
            let line = lines.next().unwrap_or_else(empty);
            let letter = if line.goes_on && number > 1 { "" } else { line.letter };
            let code = FormCell::new(CellKind::Line, CODE, format!("{letter}{number:02}"));
            // A line that nothing is written on is not told by what prints lines of text.
            let is_empty = line.cells.iter().all(|cell| cell.words.is_empty());
            let code = if is_empty { FormCell { kind: CellKind::Name, ..code } } else { code };
            rows.push(FormRow { lines: 2, cells: std::iter::once(code).chain(line.cells).collect() });
        }
        let bottom = vec![name(9, kind.code), name(101, lang.word(kind.name))];
        rows.push(FormRow { lines: 2, cells: bottom });
        forms.push(Form { mark: kind.marks[usize::from(sheet > 1)].to_owned(), rows });
    }
    forms
}

const CHANGES: [(u16, &str); 5] =
    [(4, "card-change"), (4, "card-leaf"), (9, "card-document"), (8, "card-signature"), (6, "card-date")];

/// Blocks Б3, Б4 and Б5: changes, inventory numbers, sheets.
fn changes(sheet: usize, count: usize, lang: Lang) -> Vec<FormRow> {
    let blank = || CHANGES.map(|(width, _)| value(width, "")).to_vec();
    let named = || CHANGES.map(|(width, key)| name(width, lang.word(key))).to_vec();
    let numbers = |key: &'static str| vec![name(7, lang.word(key)), value(8, ""), value(8, ""), value(6, "")];
    let row = |cells: Vec<Vec<FormCell>>| FormRow { lines: 1, cells: cells.concat() };
    vec![
        row(vec![vec![gap(79)], blank()]),
        row(vec![numbers("card-duplicate"), vec![gap(50)], blank()]),
        row(vec![numbers("card-replaces"), vec![gap(19)], blank(), blank()]),
        row(vec![numbers("card-original"), vec![gap(19)], named(), named()]),
        row(vec![
            vec![value(57, "").over(2), value(23, "").over(2), value(18, "").over(2)],
            vec![name(6, lang.word("card-leaves")), name(6, lang.word("card-leaf-number"))],
        ]),
        row(vec![vec![name(6, count.to_string()), name(6, sheet.to_string())]]),
    ]
}

/// Blocks Б1 and Б2 of the first sheet: who signs, the organisation, the part.
fn signatures(own: &Sources<'_>, title: &TitleBlock, lang: Lang) -> Vec<FormRow> {
    let told = |text: &Option<String>| Inlines::from(text.clone().unwrap_or_default());
    let signs = |key: &'static str, who: Inlines, date: Inlines| {
        let label = if key.is_empty() { "" } else { lang.word(key) };
        vec![name(9, label), value(14, who).named(label), value(8, ""), value(6, date)]
    };
    let row = |cells: Vec<FormCell>, more: Vec<FormCell>| FormRow { lines: 1, cells: [cells, more].concat() };
    let letters = [4, 4, 4].map(|width| value(width, "").over(2));
    let part = value(61, own.plan.part.part.as_str()).named(lang.word("card-part")).over(2);
    vec![
        row(
            signs("card-made", told(&title.author), told(&title.date)),
            vec![
                value(16, told(&title.institution)).named(lang.word("card-organisation")).over(3),
                value(23, "").over(3),
                value(16, "").over(3),
                value(18, "").over(3),
            ],
        ),
        row(signs("card-checked", told(&title.lecturer), Inlines::default()), Vec::new()),
        row(signs("card-accepted", Inlines::default(), Inlines::default()), Vec::new()),
        row(signs("", Inlines::default(), Inlines::default()), [vec![part], letters.to_vec()].concat()),
        row(signs("card-norms", Inlines::default(), Inlines::default()), Vec::new()),
    ]
}

/// The strip of the following sheets.
fn strip(own: &Sources<'_>) -> Vec<FormRow> {
    let signed = || std::iter::once(7).chain(CHANGES.map(|(width, _)| width)).chain(CHANGES.map(|(width, _)| width));
    let row =
        |more: Vec<FormCell>| FormRow { lines: 1, cells: signed().map(|width| value(width, "")).chain(more).collect() };
    vec![row(vec![name(23, own.plan.part.part.as_str()).over(3), value(18, "").over(3)]), row(vec![]), row(vec![])]
}

/// A card with its remarks: the standing of the form, what its marks mean, what is to be written by hand.
fn page(key: &'static str, forms: Vec<Form>, own: &Sources<'_>, remarks: &[&'static str], lang: Lang) -> Document {
    let mut page = Document::new(lang.tag(), lang.say(&Note::new(key).with("part", own.plan.part.part.as_str())));
    page.blocks.extend(forms.into_iter().map(Block::from));
    remarks.iter().for_each(|key| page.paragraph(lang.word(key)));
    page
}

/// Time per piece and preparatory time of the norm, with the mark of what nothing confirms.
fn times(own: &Sources<'_>, lang: Lang) -> [Inlines; 2] {
    let Some(norm) = own.norm else { return [Inlines::default(), Inlines::default()] };
    let [of_piece, of_lot] = norm.unconfirmed();
    [marked(norm.piece, of_piece, lang), marked(Some(norm.preparatory), of_lot, lang)]
}

/// A cutter and its holder with their words, in the order of the line Т: `ДІ …;` and `РІ …`.
fn equipment(own: &Sources<'_>, tool: &ToolPlan, lang: Lang) -> Vec<String> {
    let standard = |id: &str| own.knowledge.table(id).ok().and_then(|table| table.standard.clone());
    let with = |key: &'static str, what: String, id: &str| {
        // A designation that is an order text has its standard already.
        let standard = standard(id).filter(|standard| !what.contains(standard.as_str()));
        let what = [Some(what), standard].into_iter().flatten().collect::<Vec<_>>().join(" ");
        lang.say(&Note::new(key).with("what", what))
    };
    let named = sheet::named(tool, "", lang);
    let cutter = match named.contains('Ø') {
        true => named,
        false => say!(lang, "card-tool", tool = named, diameter = tool.diameter_mm),
    };
    let cutter = with("card-cutter", cutter, &tool.table);
    // A cutter with the machine's taper needs no holder.
    match tool.holder == tool.designation {
        true => vec![cutter],
        false => vec![with("card-holder", tool.holder.clone(), &tool.holder_table), cutter],
    }
}

/// The line Т of tools: each designation with its prefix and its standard is one piece.
fn tools_line(tools: &[String]) -> Group {
    let last = tools.len().saturating_sub(1);
    let pieces = tools.iter().enumerate().map(|(at, tool)| if at < last { format!("{tool};") } else { tool.clone() });
    let pieces: Vec<String> = pieces.collect();
    whole("Т", &pieces.iter().map(String::as_str).collect::<Vec<_>>(), &[])
}

fn tool_of<'p>(plan: &'p Plan, transition: &Transition) -> Option<&'p ToolPlan> {
    plan.tools.iter().find(|tool| tool.number == transition.tool.number && !transition.elsewhere)
}

/// The mass of the blank, kg; an empty field for the shop where it is not one figure.
fn blank_mass(own: &Sources<'_>, lang: Lang) -> Result<Inlines, KnowledgeError> {
    let mass = mass(&own.plan.part, own.knowledge)?.and_then(Mass::exact);
    Ok(mass.map(|mass| Inlines::number(lang.figure(&kilograms(mass)))).unwrap_or_default())
}

/// A time in min with two decimal places.
fn minutes(value: f64, lang: Lang) -> Inlines {
    Inlines::number(lang.figure(&exactly(value, 2)))
}

/// The auxiliary time of the program: all its time but that of cutting and of hands, min.
fn machine_auxiliary(plan: &Plan) -> f64 {
    let time = &plan.time;
    time.feed_out_min.0 + time.dwell_min.0 + time.rapid_min.0 + time.tool_change_min.0
}
