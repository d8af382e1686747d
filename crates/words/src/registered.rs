//! The languages of the program. A new one is a folder in `languages/` and a line here.

use super::catalogue::{Folder, Language, MessageSpan};

static FOLDERS: &[Folder] = include!(concat!(env!("OUT_DIR"), "/files.rs"));

/// One static for each language, and the list of them.
macro_rules! languages {
    ($($(#[$doc:meta])* $name:ident = $tag:literal;)+) => {
        $($(#[$doc])* pub static $name: Language = Language::new($tag, FOLDERS);)+
        /// Every registered language.
        pub static LANGUAGES: &[&Language] = &[$(&$name),+];
    };
}

languages! {
    /// Ukrainian.
    UK = "uk";
    /// English.
    EN = "en";
}
