//! The report of a turned part: the operation, its drawings one by one, the setting sheet and the programs.

use crate::document::{Block, Document};
use crate::job::Norm;
use crate::knowledge::Knowledge;
use technolog_turning::operation::Operation;
use technolog_turning::operation::setting::Setting;
use technolog_turning::operation::times::Times;
use technolog_words::say;

use super::operation_drawing::figures;
use super::{Doubts, Lang, figure_of, operation_page, section, setting_page};

/// A program of an operation: what it makes, and its text or why there is none.
#[derive(Clone, Debug)]
pub struct Printed {
    /// What it makes, with which tools.
    pub makes: String,
    /// Its text; otherwise why it must not be run.
    pub text: Result<String, String>,
    /// What the operator has to know of it.
    pub remarks: Vec<String>,
}

/// The whole report.
pub fn report_page(
    operation: &Operation,
    times: &[Times],
    norm: Option<&Norm>,
    setting: &Setting,
    programs: &[Printed],
    knowledge: &Knowledge,
    lang: Lang,
) -> Document {
    let mut page = operation_page(operation, times, norm, knowledge, Doubts::Counted, lang);
    page.title = say!(lang, "turn-report-title", part = operation.workpiece.name.as_str()).into();
    section(&mut page, say!(lang, "turn-report-drawings"));
    for (caption, svg) in figures(operation, lang) {
        page.push(figure_of(svg, &caption, lang));
    }
    section(&mut page, say!(lang, "turn-report-setting"));
    // Its sections are parts of this one.
    page.blocks.extend(setting_page(setting, lang).blocks.into_iter().map(|block| match block {
        Block::Heading { level, words } => Block::Heading { level: level + 1, words },
        other => other,
    }));
    section(&mut page, say!(lang, "turn-report-programs"));
    if programs.is_empty() {
        page.paragraph(say!(lang, "turn-no-programs"));
    }
    for program in programs {
        page.heading(3, program.makes.trim());
        program.remarks.iter().for_each(|remark| page.paragraph(remark.as_str()));
        match &program.text {
            Ok(text) => page.push(Block::Code(text.clone())),
            Err(why) => page.paragraph(say!(lang, "lab-not-to-run", why = why.as_str())),
        }
    }
    page
}
