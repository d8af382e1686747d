//! The format of an answer, and the formats of file extensions.

use std::path::Path;

use clap::ValueEnum;

/// The format of an answer.
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
    /// A drawing.
    Svg,
    /// For documents.
    Markdown,
    /// For the browser.
    Html,
    /// For paper.
    Pdf,
    /// A plan in the form of a hand-written one.
    Hand,
    /// For continuous integration.
    Junit,
    /// For Word.
    Docx,
    /// For spreadsheets, with typed figures.
    Xlsx,
}

impl Format {
    const ALL: [Self; 12] = [
        Self::Text,
        Self::Json,
        Self::Yaml,
        Self::Csv,
        Self::Svg,
        Self::Markdown,
        Self::Html,
        Self::Pdf,
        Self::Hand,
        Self::Junit,
        Self::Docx,
        Self::Xlsx,
    ];

    /// The extensions of its files, the usual one first.
    pub const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Text => &[".txt"],
            Self::Json => &[".json"],
            Self::Yaml | Self::Hand => &[".yaml", ".yml"],
            Self::Csv => &[".csv"],
            Self::Svg => &[".svg"],
            Self::Markdown => &[".md", ".markdown"],
            Self::Html => &[".html", ".htm"],
            Self::Pdf => &[".pdf"],
            Self::Junit => &[".xml"],
            Self::Docx => &[".docx"],
            Self::Xlsx => &[".xlsx"],
        }
    }

    /// The formats for a file extension, the usual one first; none for an extension without meaning, such as `.nc`.
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
            Self::Pdf => "pdf",
            Self::Hand => "hand",
            Self::Junit => "junit",
            Self::Docx => "docx",
            Self::Xlsx => "xlsx",
        }
    }
}

/// What a command can show, by its name on the command line, each with its formats.
pub fn formats_of_each<S: ValueEnum>(
    shown: &[S],
    formats: impl Fn(&S) -> &'static [Format],
) -> Vec<(String, &'static [Format])> {
    let named = |show: &S| Some((show.to_possible_value()?.get_name().to_owned(), formats(show)));
    shown.iter().filter_map(named).collect()
}

/// The names of formats, the first being that of an answer for which none is named.
pub fn names(formats: &[Format]) -> String {
    formats.iter().map(|format| format.name()).collect::<Vec<_>>().join(", ")
}

/// The endings of the files of formats, in the order of these. A hand-written plan has the ending of any YAML.
pub fn endings(formats: &[Format]) -> String {
    let known = formats.iter().filter(|format| **format != Format::Hand || !formats.contains(&Format::Yaml));
    known.flat_map(|format| format.endings()).copied().collect::<Vec<_>>().join(", ")
}

/// Extensions of formats that no command writes, or only few: of the others such a file would contain text.
const OTHERS: &[&str] = &[
    ".pdf", ".ps", ".eps", ".doc", ".docx", ".odt", ".rtf", ".tex", ".epub", ".xls", ".xlsx", ".xlsm", ".ods", ".tsv",
    ".ppt", ".pptx", ".odp", ".png", ".jpg", ".jpeg", ".gif", ".bmp", ".tif", ".tiff", ".webp", ".ico", ".dxf", ".dwg",
    ".step", ".stp", ".iges", ".igs", ".stl", ".cdw", ".frw", ".spw", ".zip", ".gz", ".7z", ".rar", ".tar", ".toml",
    ".ini", ".js", ".py", ".sqlite", ".db", ".exe",
];

/// Extensions of programs of controls and of their tool tables.
const PROGRAMS: &[&str] = &[".nc", ".ngc", ".mpf", ".spf", ".tap", ".cnc", ".min", ".ptp", ".tbl"];

/// The extension of a file, if it belongs to a format that no command has, or to a program where none is written.
pub fn foreign_extension(file: &Path, writes_programs: bool) -> Option<String> {
    let is_foreign = |ending: &&str| OTHERS.contains(ending) || (!writes_programs && PROGRAMS.contains(ending));
    let ending = ending(file);
    is_foreign(&ending.as_str()).then_some(ending)
}

/// The extension of a file with its point, in small letters; empty if there is none.
fn ending(file: &Path) -> String {
    let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    if ending.is_empty() { String::new() } else { format!(".{}", ending.to_ascii_lowercase()) }
}
