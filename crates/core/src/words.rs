//! Names of operations: plans written by people are read by them, pages print them.

use crate::knowledge::Word as _;
use crate::lang::Lang;
use crate::plan::Operation;

/// The operation as an instruction: `Центрувати`, `Centre`.
pub fn operation_verb(name: &str, lang: Lang) -> &str {
    lang.form("operation", name, "verb")
}

/// The operation that is called so, as an instruction or as a noun, in whatever case.
pub fn operation_named(text: &str, lang: Lang) -> Option<Operation> {
    let text = text.trim().to_lowercase();
    let name = Operation::WORDS.iter().find(|name| {
        operation_verb(name, lang).to_lowercase() == text || operation_noun(name, lang).to_lowercase() == text
    })?;
    Operation::from_name(name)
}

/// The operation as a noun: `центрування`, `centring`.
pub fn operation_noun(name: &str, lang: Lang) -> &str {
    lang.term("operation", name)
}
