//! One form of the report by itself, as a shop pins it to the machine.

use crate::document::Document;
use crate::error::KnowledgeError;

use super::super::setting;
use super::super::words::say;
use super::{Lang, Sources, TitleBlock, cards, norm, tool_list};

/// A form that can be had by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// The route card, GOST 3.1118-82.
    RouteCard,
    /// The operation card, GOST 3.1404-86.
    OperationCard,
    /// What the operator keys in, and how tools and part stand.
    SettingSheet,
    /// Cutters and holders with their parameters.
    ToolList,
    /// The program on its encoding sheet, form 5a of GOST 3.1404-86.
    EncodingSheet,
}

impl Form {
    /// All of them, by their names on the command line.
    pub const NAMES: [(&'static str, Self); 5] = [
        ("route-card", Self::RouteCard),
        ("operation-card", Self::OperationCard),
        ("setting-sheet", Self::SettingSheet),
        ("tool-list", Self::ToolList),
        ("encoding-sheet", Self::EncodingSheet),
    ];

    /// The form of that name.
    pub fn named(name: &str) -> Option<Self> {
        Self::NAMES.iter().find(|(own, _)| *own == name).map(|(_, form)| *form)
    }

    /// The form as a page.
    ///
    /// # Errors
    /// The tables lack what it asks.
    pub fn page(self, own: &Sources<'_>, title: &TitleBlock, lang: Lang) -> Result<Document, KnowledgeError> {
        let mut page = match self {
            Self::RouteCard | Self::OperationCard => {
                let card = if self == Self::RouteCard { cards::route_card } else { cards::operation_card };
                let mut page = card(own, title, lang)?;
                norm::section(&mut page, own, lang);
                page
            }
            Self::SettingSheet => setting::page(own.setting, own.plan, own.job, (own.control, own.knowledge), lang),
            Self::ToolList => {
                let part = own.plan.part.part.as_str();
                let mut page = Document::new(lang.tag(), say!(lang, "form-tool-list", part = part));
                tool_list::section(&mut page, own, lang);
                page
            }
            Self::EncodingSheet => own.sheet.page(),
        };
        // What is pinned to the machine must say itself that it must not be run.
        let warnings = own.warning.map(|why| say!(lang, "lab-not-to-run", why = why));
        let left = own.left.iter().map(|what| say!(lang, "lab-left", what = what.as_str()));
        let told: Vec<_> =
            warnings.into_iter().chain(left).map(|told| crate::document::Block::Paragraph(told.into())).collect();
        page.blocks.splice(0..0, told);
        Ok(page)
    }
}
