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

/// The operation of a word, given as an instruction or as a noun, in any letter case and order of its words.
pub fn operation_named(text: &str, lang: Lang) -> Option<Operation> {
    let wanted = sorted_words(text);
    let name = Operation::WORDS.iter().find(|name| calls(name, lang).any(|call| sorted_words(call) == wanted))?;
    Operation::from_name(name)
}

/// The operations that a text may mean: `розточити` is one of three.
pub fn operations_like(text: &str, lang: Lang) -> Vec<&'static str> {
    let wanted = sorted_words(text);
    let like = |call: &str| {
        let own = sorted_words(call);
        !wanted.is_empty() && wanted.iter().all(|word| own.contains(word))
    };
    let names = Operation::NAMES.iter().map(|(name, _)| *name);
    names.filter(|name| calls(name, lang).any(like)).collect()
}

/// What an operation is called: the instruction, the noun and other names in use.
fn calls(name: &'static str, lang: Lang) -> impl Iterator<Item = &'static str> {
    let also = lang.form("operation", name, "also").split("; ").filter(move |call| *call != name);
    [operation_verb(name, lang), operation_noun(name, lang)].into_iter().chain(also)
}

fn sorted_words(text: &str) -> Vec<String> {
    let mut words: Vec<String> = text.split_whitespace().map(str::to_lowercase).collect();
    words.sort_unstable();
    words
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
