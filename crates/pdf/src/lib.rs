//! Pages as PDF: the document tree set by Typst on A4, with the margins and the spacing of ДСТУ 3008.
//!
//! Without the feature `typeset` there is nothing here: Typst takes longer to build than all the rest of the program.
//!
//! - `markup` a page as a text of Typst, in which every word of the page is a quoted string; `world` the fonts and files
//!   that Typst may read: its own fonts and the drawings of the page, nothing of the disk and nothing of a network.
#![cfg(feature = "typeset")]

mod markup;
mod world;

use technolog_document::{Document, Words};
use typst::layout::PagedDocument;

/// A page could not be set. It is a defect of the program: every page can be.
#[derive(Debug)]
pub struct NotSet(
    /// What Typst says of it.
    pub String,
);

/// The document as PDF: fonts are embedded, drawings are vectors, the same bytes on every run.
///
/// # Errors
/// Typst refuses the page, as it does a drawing that is no SVG.
pub fn pdf(document: &Document, words: &Words) -> Result<Vec<u8>, NotSet> {
    let told = |faults: &[typst::diag::SourceDiagnostic]| {
        NotSet(faults.iter().map(|fault| fault.message.to_string()).collect::<Vec<_>>().join("; "))
    };
    let (text, drawings) = markup::of(document, words);
    let world = world::Pages::new(text, drawings);
    let set = typst::compile::<PagedDocument>(&world).output.map_err(|faults| told(&faults))?;
    typst_pdf::pdf(&set, &typst_pdf::PdfOptions::default()).map_err(|faults| told(&faults))
}
