//! What writers have to say themselves, in the language of the document.

/// Stands for a width in [`Words::see_all`].
pub const WIDTH: &str = "<width>";

/// The words of the writers. They are given because all words of the program stand in one place, which is not here.
#[derive(Clone, Copy, Debug)]
pub struct Words<'w> {
    /// Stands before the names of columns for which a table had no room: `columns left out`.
    pub left_out: &'w str,
    /// How to see them, with [`WIDTH`] instead of the width that shows all; backticks mark code. Empty to say nothing.
    pub see_all: &'w str,
    /// Stands before what helps against a finding: `help`.
    pub help: &'w str,
    /// Stands before the caption of a drawing that text cannot show: `drawing`.
    pub figure: &'w str,
}
