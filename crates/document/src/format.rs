//! The choice of a writer: by name, or by the extension of a file.

use std::path::Path;

/// The formats of a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Format {
    /// For a terminal.
    Text,
    /// CommonMark with the tables of GitHub.
    Markdown,
    /// One standalone page.
    Html,
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Text, Self::Markdown, Self::Html];

    /// Its name in `--format`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Markdown => "markdown",
            Self::Html => "html",
        }
    }

    /// The format for a file extension; none for an unknown one.
    pub fn from_ending(file: &Path) -> Option<Self> {
        match file.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "txt" => Some(Self::Text),
            "md" | "markdown" => Some(Self::Markdown),
            "html" | "htm" => Some(Self::Html),
            _ => None,
        }
    }
}

/// The extension of a file means another format than the requested one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Contradiction<F> {
    /// The requested format.
    pub requested: F,
    /// The format of the extension.
    pub ending: F,
}

/// The format by name and extension; either may be missing. `F` is [`Format`], or the formats of a command that has
/// more of them.
///
/// # Errors
/// They contradict each other.
pub fn agreed<F: Copy + PartialEq>(requested: Option<F>, ending: Option<F>) -> Result<Option<F>, Contradiction<F>> {
    match (requested, ending) {
        (Some(requested), Some(ending)) if requested != ending => Err(Contradiction { requested, ending }),
        _ => Ok(requested.or(ending)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ending_means_a_format() {
        for (file, format) in [
            ("a.txt", Some(Format::Text)),
            ("b/plan.md", Some(Format::Markdown)),
            ("plan.HTML", Some(Format::Html)),
            ("план.htm", Some(Format::Html)),
            ("plan.md.pdf", None),
            ("md", None),
            ("-", None),
        ] {
            assert_eq!(Format::from_ending(Path::new(file)), format, "{file}");
        }
    }

    #[test]
    fn name_and_ending_must_agree() {
        use Format::{Html, Markdown};
        assert_eq!(agreed::<Format>(None, None), Ok(None));
        assert_eq!(agreed(Some(Html), None), Ok(Some(Html)));
        assert_eq!(agreed(None, Some(Html)), Ok(Some(Html)));
        assert_eq!(agreed(Some(Html), Some(Html)), Ok(Some(Html)));
        assert_eq!(agreed(Some(Html), Some(Markdown)), Err(Contradiction { requested: Html, ending: Markdown }));
    }
}
