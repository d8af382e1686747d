//! The ways of roughing a shaft as a page: side by side with the one to take, and the optimum pass by pass.

mod cells;
mod drawing;
mod frames;
mod map;
mod operation;
mod operation_drawing;
mod phrases;
mod report;
mod schemes;
mod schemes_drawing;
mod setting;
mod view;
mod ways;

use crate::document::{Block, Column, Document, Drawing, Field, Keep, Table};
use crate::knowledge::Knowledge;
use crate::note;
use technolog_turning::length::Half;
use technolog_turning::passes::Variant;
use technolog_turning::passes::cost::Objective;
use technolog_turning::shaft::{Division, Moves};
use technolog_turning::ways::Ways;
use technolog_words::say;

use super::doubts::is_of_row;
use super::{Doubts, Lang};
use cells::{Cell, arrow, figure, span, table};
use phrases::{finding, material, note_line, unconfirmed, word};

pub use drawing::drawing;
pub use frames::frames;
pub use map::{map_drawing, map_page};
pub use operation::{operation_page, programs_list};
pub use operation_drawing::operation_drawing;
pub use report::{Printed, report_page};
pub use setting::setting_page;

/// The whole page of a shaft.
pub fn page(ways: &Ways, knowledge: &Knowledge, doubts: Doubts, lang: Lang) -> Document {
    let found = &ways.sequences;
    let mut page = Document::new(lang.tag(), ways.shaft.as_str());
    head(&mut page, ways, knowledge, lang);
    ways::sections(&mut page, ways, lang);
    if let Some(best) = found.variants.last().filter(|best| !best.passes.is_empty()) {
        section(&mut page, say!(lang, "turn-optimum"));
        page.push(passes(best, lang));
        if let Some(proof) = found.proof {
            let (radii, zs) = proof.lines;
            page.paragraph(match proof.optimal_on_the_grid {
                true => say!(lang, "turn-proven", radii = radii, zs = zs),
                false => say!(lang, "turn-bounded", radii = radii, zs = zs, bound = proof.lower_bound),
            });
        }
    }
    schemes::section_of_levels(&mut page, &ways.schemes, lang);
    findings(&mut page, found.findings.iter().chain(&ways.operation_findings), doubts, lang);
    page
}

/// A drawing as a block of its page.
pub fn figure_of(svg: String, caption: &str, lang: Lang) -> Drawing {
    let alternative = say!(lang, "turn-figure-seen").to_owned();
    Drawing { svg, caption: caption.into(), alternative }
}

/// Begins the next numbered section.
fn section(page: &mut Document, title: &str) {
    let before = page.blocks.iter().filter(|block| matches!(block, Block::Heading { level: 2, .. })).count();
    page.heading(2, format!("{}. {title}", before + 1));
}

/// The section of findings; none if there are none.
fn findings<'f>(page: &mut Document, all: impl Iterator<Item = &'f note::Finding>, doubts: Doubts, lang: Lang) {
    let (listed, counted) = doubts.split(all);
    if counted.is_some() || !listed.is_empty() {
        section(page, say!(lang, "turn-findings"));
    }
    if let Some(counted) = counted {
        page.push(unconfirmed(&counted, lang));
    }
    for listed_finding in listed {
        page.push(if is_of_row(&listed_finding.note) {
            unconfirmed(&listed_finding.note, lang)
        } else {
            finding(listed_finding, lang)
        });
    }
}

fn head(page: &mut Document, ways: &Ways, knowledge: &Knowledge, lang: Lang) {
    let found = &ways.sequences;
    let shaft = &found.shaft;
    let blank = &shaft.blank;
    let steps: Vec<String> = shaft
        .steps
        .iter()
        .map(|step| format!("Ø{} × {}", figure(step.diameter, lang), figure(step.length, lang)))
        .collect();
    let mut levels = vec![figure(blank.diameter, lang)];
    levels.extend(found.levels.iter().map(|level| figure(level.to.diameter(), lang)));
    let mut slices = vec!["0".to_owned()];
    slices.extend(found.slices.iter().map(|slice| figure(Half::ZERO - slice.to, lang)));
    let objective = match found.objective {
        Objective::Path => say!(lang, "turn-least-path").to_owned(),
        Objective::PathAndPasses { per_pass_mm } => say!(lang, "turn-least-path-and-passes", per_pass = per_pass_mm),
        Objective::Time { .. } => say!(lang, "turn-least-time").to_owned(),
        Objective::Passes => say!(lang, "turn-fewest-passes").to_owned(),
    };
    let blank = say!(
        lang,
        "turn-blank",
        kind = word(blank.kind.name()),
        diameter = blank.diameter,
        length = blank.length,
        holding = word(ways.holding.name())
    );
    let (along, across) = (shaft.roughing.longitudinal_depth, shaft.roughing.transverse_depth);
    let fields_of_task = [
        (say!(lang, "turn-material").to_owned(), material(&ways.material, knowledge)),
        (say!(lang, "turn-blank-label").to_owned(), blank),
        (say!(lang, "turn-steps").to_owned(), steps.join(", ")),
        (say!(lang, "turn-levels", depth = along), format!("Ø{}", levels.join(" → "))),
        (say!(lang, "turn-slices", depth = across), format!("Z {}", slices.join(" → "))),
        (say!(lang, "turn-objective").to_owned(), objective),
    ];
    page.push(fields(fields_of_task));
    if shaft.roughing.division == Division::Equal {
        page.paragraph(say!(lang, "turn-equal-division"));
    }
    if found.moves == Moves::Rich {
        page.paragraph(say!(lang, "turn-rich-moves"));
    }
}

fn passes(variant: &Variant, lang: Lang) -> Table {
    let mm = say!(lang, "unit-mm");
    let columns = [
        Column::number(lang.word("cli-row-number"), ""),
        Column::text(say!(lang, "turn-direction")),
        span("Ø", mm),
        span("Z", mm),
        Column::number(say!(lang, "turn-depth"), mm),
        Column::number(say!(lang, "turn-length"), mm),
        Column::text(say!(lang, "turn-why")).keep(Keep::Optional).min_width(20),
    ];
    let rows = variant.passes.iter().map(|pass| {
        let (from, to) = (&pass.from, &pass.to);
        vec![
            Cell::count(pass.number),
            lang.term("word", pass.kind.name()).into(),
            arrow(figure(from.radius.diameter(), lang), figure(to.radius.diameter(), lang)).into(),
            arrow(figure(Half::ZERO - from.z, lang), figure(Half::ZERO - to.z, lang)).into(),
            Cell::Figure(pass.depth_mm.to_mm(), 2),
            Cell::Figure(pass.length_mm.to_mm(), 2),
            note_line(&pass.reason, lang).into(),
        ]
    });
    table(columns, rows.collect(), lang)
}

/// Labels with their values, as one block.
fn fields(all: impl IntoIterator<Item = (String, String)>) -> Block {
    Block::Fields(all.into_iter().map(|(label, value)| Field::new(label, value)).collect())
}
