//! The words that writers need themselves, in the language of the document.

/// Stands for a width in [`Words::see_all`].
pub const WIDTH: &str = "<width>";

/// The words of the writers. They are given by the caller, because all words of the program are in one place, which
/// is not here.
#[derive(Clone, Copy, Debug)]
pub struct Words<'w> {
    /// The text before the names of columns that were left out: `columns left out`.
    pub left_out: &'w str,
    /// How to see them, with [`WIDTH`] in place of the width that shows all; backticks mark code. Empty for no hint.
    pub see_all: &'w str,
    /// The text before the remedy of a finding: `help`.
    pub help: &'w str,
    /// The text before the caption of a drawing that text cannot show: `drawing`.
    pub figure: &'w str,
}
