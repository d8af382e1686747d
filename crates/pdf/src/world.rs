//! What Typst may read.

use std::sync::LazyLock;

use typst::diag::{FileError, FileResult};
use typst::foundations::{Bytes, Datetime};
use typst::syntax::{FileId, Source, VirtualPath};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Library, LibraryExt, World};

/// The fonts that Typst brings along: Libertinus (OFL) and DejaVu Sans Mono have Cyrillic.
static FONTS: LazyLock<Vec<Font>> =
    LazyLock::new(|| typst_assets::fonts().flat_map(|data| Font::iter(Bytes::new(data))).collect());

/// One page with its drawings.
pub struct Pages {
    library: LazyHash<Library>,
    book: LazyHash<FontBook>,
    main: Source,
    drawings: Vec<(FileId, Bytes)>,
}

impl Pages {
    /// The text of a page, and its drawings in the order of their names: `0.svg`, `1.svg`, …
    pub fn new(text: String, drawings: Vec<String>) -> Self {
        let file = |name: &str| FileId::new(None, VirtualPath::new(name));
        let drawings = drawings.into_iter().enumerate();
        Self {
            library: LazyHash::new(Library::default()),
            book: LazyHash::new(FontBook::from_fonts(FONTS.iter())),
            main: Source::new(file("main.typ"), text),
            drawings: drawings.map(|(at, svg)| (file(&format!("{at}.svg")), Bytes::from_string(svg))).collect(),
        }
    }
}

impl World for Pages {
    fn library(&self) -> &LazyHash<Library> {
        &self.library
    }

    fn book(&self) -> &LazyHash<FontBook> {
        &self.book
    }

    fn main(&self) -> FileId {
        self.main.id()
    }

    fn source(&self, id: FileId) -> FileResult<Source> {
        if id == self.main.id() { Ok(self.main.clone()) } else { Err(FileError::AccessDenied) }
    }

    fn file(&self, id: FileId) -> FileResult<Bytes> {
        let drawing = self.drawings.iter().find(|(own, _)| *own == id);
        drawing.map(|(_, bytes)| bytes.clone()).ok_or(FileError::AccessDenied)
    }

    fn font(&self, index: usize) -> Option<Font> {
        FONTS.get(index).cloned()
    }

    fn today(&self, _: Option<i64>) -> Option<Datetime> {
        None
    }
}
