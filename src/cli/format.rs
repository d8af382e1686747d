//! The form of an answer, and what the endings of files say of it.

use std::path::Path;

use clap::ValueEnum;

/// The form of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For people.
    Text,
    /// For programs.
    Json,
    /// For programs and people.
    Yaml,
    /// For spreadsheets.
    Csv,
    /// For the eye.
    Svg,
    /// For documents.
    Markdown,
    /// For the browser.
    Html,
    /// A plan as somebody writes it by hand.
    Hand,
    /// For continuous integration.
    Junit,
}

impl Format {
    const ALL: [Self; 9] =
        [Self::Text, Self::Json, Self::Yaml, Self::Csv, Self::Svg, Self::Markdown, Self::Html, Self::Hand, Self::Junit];

    /// The endings of its files, the usual first.
    pub const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Text => &[".txt"],
            Self::Json => &[".json"],
            Self::Yaml | Self::Hand => &[".yaml", ".yml"],
            Self::Csv => &[".csv"],
            Self::Svg => &[".svg"],
            Self::Markdown => &[".md", ".markdown"],
            Self::Html => &[".html", ".htm"],
            Self::Junit => &[".xml"],
        }
    }

    /// What the ending of a file can mean, the usual first; none for an ending that says nothing, such as `.nc`.
    pub fn of_ending(file: &Path) -> Vec<Self> {
        let ending = ending(file);
        let means = |format: &Self| format.endings().contains(&ending.as_str());
        Self::ALL.into_iter().filter(means).collect()
    }

    /// Its name on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Text => "text",
            Self::Json => "json",
            Self::Yaml => "yaml",
            Self::Csv => "csv",
            Self::Svg => "svg",
            Self::Markdown => "markdown",
            Self::Html => "html",
            Self::Hand => "hand",
            Self::Junit => "junit",
        }
    }
}

/// Endings of formats that no command writes: such a file would contain text.
const OTHERS: &[&str] = &[
    ".pdf", ".ps", ".eps", ".doc", ".docx", ".odt", ".rtf", ".tex", ".epub", ".xls", ".xlsx", ".xlsm", ".ods", ".tsv",
    ".ppt", ".pptx", ".odp", ".png", ".jpg", ".jpeg", ".gif", ".bmp", ".tif", ".tiff", ".webp", ".ico", ".dxf", ".dwg",
    ".step", ".stp", ".iges", ".igs", ".stl", ".cdw", ".frw", ".spw", ".zip", ".gz", ".7z", ".rar", ".tar", ".toml",
    ".ini", ".js", ".py", ".sqlite", ".db", ".exe",
];

/// The ending of a file that belongs to a form that no command has.
pub fn of_others(file: &Path) -> Option<String> {
    Some(ending(file)).filter(|ending| OTHERS.contains(&ending.as_str()))
}

/// The ending of a file with its point, in small letters; empty where it has none.
fn ending(file: &Path) -> String {
    let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    if ending.is_empty() { String::new() } else { format!(".{}", ending.to_ascii_lowercase()) }
}
