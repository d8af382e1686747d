//! The title block around a page that has other parts than a laboratory report: a turned part, an audit.

use crate::document::{Document, Inlines};

use super::super::words::say;
use super::{Lang, TitleBlock, by_author, head};

/// The page with what its author has written: the block, aim and task before it, the conclusions behind it. `asks` leaves a
/// marked place for conclusions that are not written yet.
pub fn framed(page: Document, title: &TitleBlock, asks: bool, lang: Lang) -> Document {
    let name = title.work.as_deref().map_or(page.title, Inlines::from);
    let mut framed = Document::new(page.lang, name);
    head(&mut framed, title, lang);
    for own in [&title.aim, &title.task, &title.fixture].into_iter().flatten() {
        framed.paragraph(own.as_str());
    }
    framed.blocks.extend(page.blocks);
    if asks || title.conclusions.is_some() {
        framed.heading(2, say!(lang, "lab-conclusions"));
        by_author(&mut framed, title.conclusions.as_deref(), "lab-write-conclusions", lang);
    }
    framed
}
