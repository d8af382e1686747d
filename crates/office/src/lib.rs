//! Pages as files that people correct and calculate with: Word (DOCX, ECMA-376) and workbooks (XLSX).
//!
//! Both come of the same tree as text and HTML, and add no words of their own. They write the same bytes on every run.
//!
//! - `docx` the pages of DSTU 3008, every table a real one; `xlsx` a sheet for each table, its figures typed;
//! - `svg` reads the drawings that pages have, `emf` writes them for Words that know no SVG.

mod docx;
mod emf;
mod svg;
mod xlsx;

pub use docx::docx;
pub use xlsx::xlsx;

/// A file could not be put together.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct OfficeError(String);

impl From<zip::result::ZipError> for OfficeError {
    fn from(error: zip::result::ZipError) -> Self {
        Self(error.to_string())
    }
}

impl From<std::io::Error> for OfficeError {
    fn from(error: std::io::Error) -> Self {
        Self(error.to_string())
    }
}

impl From<rust_xlsxwriter::XlsxError> for OfficeError {
    fn from(error: rust_xlsxwriter::XlsxError) -> Self {
        Self(error.to_string())
    }
}
