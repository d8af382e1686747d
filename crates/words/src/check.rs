//! Checks the catalogue: keys that a language lacks, different gaps, plurals without a form, mixed alphabets.

use std::collections::{BTreeMap, BTreeSet};

use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement};
use fluent_syntax::parser::parse;

use super::catalogue::{Language, gaps};

/// One message of a file.
pub struct CatalogueMessage {
    /// The file it stands in.
    pub file: &'static str,
    /// The figures of its gaps; those of an attribute under the attribute's name.
    pub gaps: BTreeMap<String, BTreeSet<String>>,
}

/// The messages of a language by their names, and the faults of its files.
pub fn entries(language: &Language) -> (BTreeMap<String, CatalogueMessage>, Vec<String>) {
    let (mut entries, mut faults) = (BTreeMap::new(), Vec::new());
    for (file, text) in language.files() {
        let place = format!("{}/{file}", language.tag);
        let resource = match parse(text) {
            Ok(resource) => resource,
            Err((resource, errors)) => {
                faults.extend(errors.into_iter().map(|error| {
                    let line = text[..error.pos.start.min(text.len())].lines().count();
                    format!("{place}:{line}: {error}")
                }));
                resource
            }
        };
        for entry in resource.body {
            let Entry::Message(message) = entry else { continue };
            let name = message.id.name.to_owned();
            if !language.has_message(&name) {
                faults.push(format!("{place}: {name}: its name must stand at the beginning of a line"));
            }
            let values = message.value.iter().map(|value| (String::new(), value));
            let forms = message.attributes.iter().map(|form| (form.id.name.to_owned(), &form.value));
            let mut of_forms = BTreeMap::new();
            for (form, pattern) in values.chain(forms) {
                faults.extend(
                    plural_faults(language.tag, pattern).into_iter().map(|what| format!("{place}: {name}: {what}")),
                );
                faults.extend(
                    mixed_words(pattern)
                        .into_iter()
                        .map(|word| format!("{place}: {name}: Latin and Cyrillic in `{word}`")),
                );
                of_forms.insert(form, gaps(pattern).into_iter().map(str::to_owned).collect());
            }
            if entries.insert(name.clone(), CatalogueMessage { file, gaps: of_forms }).is_some() {
                faults.push(format!("{place}: {name} stands twice"));
            }
        }
    }
    (entries, faults)
}

/// The messages that a language lacks compared with English, and those that English lacks.
pub fn differences(language: &Language, english: &Language) -> (Vec<String>, Vec<String>) {
    let ((own, _), (whole, _)) = (entries(language), entries(english));
    let lacks = whole.keys().filter(|name| !own.contains_key(*name)).cloned().collect();
    let wrong = own.iter().filter_map(|(name, entered)| match whole.get(name) {
        None if LOCAL.contains(&name.as_str()) => None,
        None => Some(format!("{}/{}: {name} is no message of the program", language.tag, entered.file)),
        Some(there) if there.gaps != entered.gaps => {
            Some(format!("{}/{}: {name} has other gaps than in English", language.tag, entered.file))
        }
        Some(_) => None,
    });
    (lacks, wrong.collect())
}

/// Messages about the language itself.
const LOCAL: &[&str] = &["decimal-comma", "table-letter"];

/// The plural forms that a language requires.
const PLURALS: &[(&str, &[&str])] = &[("uk", &["one", "few", "many"]), ("en", &["one", "other"])];

fn plural_faults(tag: &str, pattern: &Pattern<&str>) -> Vec<String> {
    let Some((_, forms)) = PLURALS.iter().find(|(known, _)| *known == tag) else { return Vec::new() };
    let mut faults = Vec::new();
    for element in &pattern.elements {
        let PatternElement::Placeable { expression: Expression::Select { variants, .. } } = element else { continue };
        let keys: BTreeSet<&str> = variants
            .iter()
            .map(|variant| match variant.key {
                fluent_syntax::ast::VariantKey::Identifier { name } => name,
                fluent_syntax::ast::VariantKey::NumberLiteral { value } => value,
            })
            .collect();
        let is_plural = ["zero", "one", "two", "few", "many"].iter().any(|form| keys.contains(form));
        if is_plural {
            faults.extend(
                forms.iter().filter(|form| !keys.contains(*form)).map(|form| format!("no plural form `{form}`")),
            );
        }
    }
    faults
}

/// Words of both alphabets: a Latin `c` in a Ukrainian word is invisible to the eye, but not to a search.
fn mixed_words(pattern: &Pattern<&str>) -> Vec<String> {
    let mut texts = Vec::new();
    collect_text(pattern, &mut texts);
    let is_latin = |c: char| c.is_ascii_alphabetic();
    let is_cyrillic = |c: char| ('\u{400}'..='\u{4ff}').contains(&c);
    texts
        .iter()
        .flat_map(|text| text.split(|c: char| !c.is_alphabetic()))
        .filter(|word| word.chars().any(is_latin) && word.chars().any(is_cyrillic))
        .map(str::to_owned)
        .collect()
}

fn collect_text<'p>(pattern: &Pattern<&'p str>, texts: &mut Vec<&'p str>) {
    for element in &pattern.elements {
        match element {
            PatternElement::TextElement { value } => texts.push(value),
            PatternElement::Placeable { expression: Expression::Select { variants, .. } } => {
                variants.iter().for_each(|variant| collect_text(&variant.value, texts));
            }
            PatternElement::Placeable { expression: Expression::Inline(InlineExpression::StringLiteral { value }) } => {
                texts.push(value)
            }
            PatternElement::Placeable { .. } => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use technolog_note::{Figure, Note};

    use super::*;
    use crate::catalogue::{Folder, MessageSpan};
    use crate::{LANGUAGES, Lang};

    /// A language that was just begun: one folder, one line, three messages.
    static POLISH: Language = Language::new("pl", FOLDERS);

    static FOLDERS: &[Folder] = include!(concat!(env!("OUT_DIR"), "/test_files.rs"));

    #[test]
    fn a_third_language_may_be_partial() {
        let polish = Lang::of(&POLISH);
        assert_eq!(polish.term("operation", "drill"), "wiercenie");
        assert_eq!(polish.form("operation", "drill", "verb"), "Wiercić");
        // Missing messages are in English, with English numbers.
        assert_eq!(polish.term("operation", "tap"), "tapping");
        let note = Note::new("stages").with("stages", Figure::sum_of_words(["finish-nc"])).with("delta", 0.2);
        let note = note.with("sigma", 0.05);
        assert_eq!(polish.say(&note), "stages: finishing on the NC machine (Δ0 = 0.2 mm, σc = 0.05 mm)");
        let lacks = polish.untranslated();
        assert!(lacks.contains(&"operation-tap".to_owned()) && !lacks.contains(&"operation-drill".to_owned()));
        assert_eq!(entries(&POLISH).1, Vec::<String>::new());
    }

    #[test]
    fn a_message_of_several_pieces_is_a_word_too() {
        assert_eq!(Lang::UK.word("plan-holder-length"), "lопр");
        assert!(Lang::UK.word("case-write-within").contains("{is: 0.28, within: 5%}"));
        assert_eq!(Lang::UK.word("no-such-message"), "no-such-message");
    }

    #[test]
    fn what_the_user_wrote_is_not_translated() {
        let note = Note::new("unknown-material").with("material", "drill");
        assert!(Lang::UK.say(&note).contains("`drill`"), "{}", Lang::UK.say(&note));
    }

    #[test]
    fn plurals_follow_their_number() {
        for (count, text) in [(1, "1 рядок"), (3, "3 рядки"), (12, "12 рядків"), (21, "21 рядок"), (104, "104 рядки")]
        {
            assert_eq!(Lang::UK.say(&Note::new("cli-rows-counted").with("count", count)), text);
        }
    }

    #[test]
    fn the_catalogue_has_no_fault() {
        let english = LANGUAGES.iter().find(|language| language.tag == "en").unwrap();
        for language in LANGUAGES {
            let (_, faults) = entries(language);
            let (lacks, wrong) = differences(language, english);
            assert!(faults.is_empty(), "{faults:#?}");
            assert!(lacks.is_empty(), "{} lacks {lacks:#?}", language.tag);
            assert!(wrong.is_empty(), "{wrong:#?}");
        }
    }
}
