//! Names of operations, quantities and units. Hand-written plans are read by the names of operations; pages print all
//! of them.

use crate::knowledge::Word as _;
use crate::knowledge::units::Unit;
use crate::lang::Lang;
use crate::plan::Operation;
use crate::tables::quantity::Quantity;

/// The operation as an instruction: `Центрувати`, `Centre`.
pub fn operation_verb(name: &str, lang: Lang) -> &str {
    lang.form("operation", name, "verb")
}

/// The operation of a word, given as an instruction or as a noun, in any letter case.
pub fn operation_named(text: &str, lang: Lang) -> Option<Operation> {
    let text = text.trim().to_lowercase();
    // The letters of these words have the same length in lower case.
    let same = |word: &str| word.len() == text.len() && word.to_lowercase() == text;
    let name =
        Operation::WORDS.iter().find(|name| same(operation_verb(name, lang)) || same(operation_noun(name, lang)))?;
    Operation::from_name(name)
}

/// The operation as a noun: `центрування`, `centring`.
pub fn operation_noun(name: &str, lang: Lang) -> &str {
    lang.term("operation", name)
}

/// The name of a figure of a plan: `глибина різання`.
pub fn quantity_noun(quantity: Quantity, lang: Lang) -> &'static str {
    let key = quantity.key();
    // A key of two parts has a point, which names of messages cannot have.
    lang.find(&format!("quantity-{}", key.replace('.', "-"))).unwrap_or(key)
}

/// A unit as people write it; none for a pure number.
pub fn unit(unit: Unit, lang: Lang) -> &'static str {
    match unit {
        Unit::None => "",
        // Some are the same in every language.
        _ => lang.find(&format!("unit-{}", unit.text().replace(['*', '/'], "-"))).unwrap_or(unit.text()),
    }
}

/// A figure with its unit: `0,25 мм/об`, `118°`.
pub fn with_unit(figure: &str, unit: Unit, lang: Lang) -> String {
    match self::unit(unit, lang) {
        "" => figure.to_owned(),
        unit if unit.starts_with('°') => format!("{figure}{unit}"),
        unit => format!("{figure} {unit}"),
    }
}
