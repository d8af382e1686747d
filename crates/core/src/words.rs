//! Names of operations in both languages: plans written by people are read by them, pages print them.

use crate::lang::Lang;
use crate::plan::Operation;

const OPERATIONS: &[(&str, [&str; 2], [&str; 2])] = &[
    ("centre-drill", ["Центрувати", "Centre"], ["центрування", "centring"]),
    ("drill", ["Свердлити", "Drill"], ["свердління", "drilling"]),
    ("drill-out", ["Розсвердлити", "Drill out"], ["розсвердлювання", "drilling out"]),
    ("core-drill", ["Зенкерувати", "Core-drill"], ["зенкерування", "core drilling"]),
    ("rough-bore", ["Розточити начорно", "Rough-bore"], ["чорнове розточування", "rough boring"]),
    (
        "semi-finish-bore",
        ["Розточити напівначисто", "Semi-finish-bore"],
        ["напівчистове розточування", "semi-finish boring"],
    ),
    ("finish-bore", ["Розточити начисто", "Finish-bore"], ["чистове розточування", "finish boring"]),
    ("mill", ["Фрезерувати", "Mill"], ["фрезерування", "milling"]),
    ("counterbore", ["Цекувати", "Counterbore"], ["цекування", "counterboring"]),
    ("countersink", ["Зенкувати", "Countersink"], ["зенкування", "countersinking"]),
    ("chamfer", ["Зняти фаску", "Chamfer"], ["зняття фаски", "chamfering"]),
    ("rough-ream", ["Розвернути попередньо", "Rough-ream"], ["попереднє розвертання", "rough reaming"]),
    ("finish-ream", ["Розвернути остаточно", "Finish-ream"], ["остаточне розвертання", "finish reaming"]),
    ("tap", ["Нарізати різь", "Tap"], ["нарізання різі", "tapping"]),
    // Of lathes.
    ("turning", ["Точити", "Turn"], ["точіння", "turning"]),
    ("grooving", ["Прорізати канавку", "Groove"], ["прорізання", "grooving"]),
];

/// The operation as an instruction: `Центрувати`, `Centre`.
pub fn operation_verb(name: &str, lang: Lang) -> &str {
    OPERATIONS.iter().find(|(known, ..)| *known == name).map_or(name, |(_, [uk, en], _)| lang.pick(uk, en))
}

/// The operation that is called so, as an instruction or as a noun, in whatever case.
pub fn operation_named(text: &str, lang: Lang) -> Option<Operation> {
    let text = text.trim().to_lowercase();
    let called = |[uk, en]: &[&'static str; 2]| lang.pick(uk, en).to_lowercase() == text;
    let (name, ..) = OPERATIONS.iter().find(|(_, verb, noun)| called(verb) || called(noun))?;
    Operation::from_name(name)
}

/// The operation as a noun: `центрування`, `centring`.
pub fn operation_noun(name: &str, lang: Lang) -> &str {
    OPERATIONS.iter().find(|(known, ..)| *known == name).map_or(name, |(.., [uk, en])| lang.pick(uk, en))
}
