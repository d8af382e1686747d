//! The words of notes: one sentence per code, in Ukrainian and English, with `{figures}` to fill in.
//!
//! A decision elsewhere in the program is a [`Note`], a code with its figures; only here does it become
//! a sentence. The tables stand in the files of this room, one for each field; here they are looked up. A test finds every
//! code the program uses and holds it against them.

use crate::note::Note;

use super::Lang;

mod allowances;
mod audit;
mod audit_program;
mod audit_routes;
mod conditions;
mod holes;
mod iso;
mod jobs;
mod lathe_programs;
mod lists;
mod operation;
mod programs;
mod proof;
mod routes;
mod schemes;
mod terms;
mod tools;
mod turning;
mod turning_tools;
mod workpiece;
mod zones;

/// Every sentence.
fn sentences() -> impl Iterator<Item = &'static (&'static str, &'static str, &'static str)> {
    let all = holes::SENTENCES.iter().chain(tools::SENTENCES).chain(conditions::SENTENCES);
    let all = all.chain(routes::SENTENCES).chain(programs::SENTENCES);
    let all = all.chain(iso::SENTENCES).chain(jobs::SENTENCES).chain(lists::SENTENCES);
    let all = all.chain(proof::SENTENCES).chain(turning::SENTENCES).chain(schemes::SENTENCES);
    let all = all.chain(turning_tools::SENTENCES).chain(zones::SENTENCES).chain(workpiece::SENTENCES);
    let all = all.chain(audit::SENTENCES).chain(audit_routes::SENTENCES).chain(audit_program::SENTENCES);
    all.chain(lathe_programs::SENTENCES).chain(allowances::SENTENCES).chain(operation::SENTENCES)
}

/// Every code that a note can have.
pub fn codes() -> impl Iterator<Item = &'static str> {
    sentences().map(|(code, ..)| *code)
}

/// A note as a sentence. A code without words shows itself with its figures, so that nothing is lost.
#[expect(clippy::disallowed_methods, reason = "words are made of notes here")]
pub fn sentence(note: &Note, lang: Lang) -> String {
    let Some((_, uk, en)) = sentences().find(|(code, ..)| *code == note.code()) else {
        let figures: Vec<String> = note.figures().map(|(name, value)| format!("{name} = {value}")).collect();
        return format!("{} ({})", note.code(), figures.join(", "));
    };
    let mut text = lang.pick(uk, en).to_owned();
    for (name, value) in note.figures() {
        text = text.replace(&format!("{{{name}}}"), &shown(name, value, lang));
    }
    if let Some(more) = note.figure("more") {
        text.push_str(&lang.pick(" (подібних іще {})", " (and {} more like it)").replace("{}", more));
    }
    if let Some(scheme) = note.figure("scheme").filter(|_| !uk.contains("{scheme}")) {
        text = format!("{} {scheme}: {text}", lang.pick("схема", "scheme"));
    }
    text
}

/// What to do about a mistake of a program, of a list of points or of a shaft.
#[expect(clippy::disallowed_methods, reason = "words are made of notes here")]
pub fn remedy(note: &Note, lang: Lang) -> Option<&'static str> {
    let mut remedies = programs::REMEDIES
        .iter()
        .chain(iso::REMEDIES)
        .chain(lists::REMEDIES)
        .chain(turning::REMEDIES)
        .chain(schemes::REMEDIES)
        .chain(lathe_programs::REMEDIES)
        .chain(operation::REMEDIES)
        .chain(workpiece::REMEDIES);
    let of_program = remedies.find(|(code, ..)| *code == note.code()).map(|(_, uk, en)| lang.pick(uk, en));
    let of_proof = || proof::REMEDIES.iter().find(|(code, _)| *code == note.code());
    of_program.or_else(|| of_proof().map(|(_, (uk, en))| lang.pick(uk, en)))
}

/// Figures whose values are words of the program are translated too.
fn shown(name: &str, value: &str, lang: Lang) -> String {
    match name {
        "operation" | "instead" => super::operation_noun(value, lang).to_owned(),
        "transitions" | "better" => {
            value.split(", ").map(|name| super::operation_noun(name, lang)).collect::<Vec<_>>().join(", ")
        }
        "kind" | "method" | "variant" | "direction" | "rival" => term(value, lang).to_owned(),
        "take" | "by" | "name" | "shank" | "bound" | "feature" => term(value, lang).to_owned(),
        "stages" => value.split(" + ").map(|stage| term(stage, lang)).collect::<Vec<_>>().join(" + "),
        "scheme" | "same" | "first" => scheme_name(value, lang),
        // A decimal number as people write it; designations and table names are none.
        _ if value.parse::<f64>().is_ok() => lang.pick(&value.replace('.', ","), value).to_owned(),
        _ => value.to_owned(),
    }
}

/// A scheme as people read it: `04 + centre`, or the transitions that a search found.
pub fn scheme_name(scheme: &str, lang: Lang) -> String {
    let part = |part| super::operation_noun(if part == "centre" { "centre-drill" } else { part }, lang);
    scheme.split(" + ").map(part).collect::<Vec<_>>().join(" + ")
}

/// A word that stands in a table as an id.
pub fn term(id: &str, lang: Lang) -> &str {
    let terms = terms::TERMS.iter().chain(schemes::TERMS).chain(turning_tools::TERMS).chain(zones::TERMS);
    let terms = terms.chain(operation::TERMS).chain(audit_routes::TERMS);
    terms.into_iter().find(|(known, ..)| *known == id).map_or(id, |(_, uk, en)| lang.pick(uk, en))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use std::path::Path;

    /// Codes as the program writes them: `Note::new("code")`, and `note("code")`, `new("code")`, `done("code")` of local
    /// helpers.
    fn codes_in(folder: &Path, codes: &mut BTreeSet<String>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                codes_in(&path, codes);
                continue;
            }
            let text = std::fs::read_to_string(&path).unwrap();
            for opening in [
                "Note::new(\"",
                " note(\"",
                " new(\"",
                "done(\"",
                "series(\"",
                "shown(\"",
                "fault(\"",
                "fault::<()>(\"",
                "tell(\"",
            ] {
                for rest in text.split(opening).skip(1) {
                    let code = rest.split('"').next().unwrap();
                    if !code.is_empty() && code.chars().all(|c| c.is_ascii_lowercase() || c == '-') {
                        codes.insert(code.to_owned());
                    }
                }
            }
        }
    }

    #[test]
    fn every_code_of_the_program_has_its_words() {
        let mut codes = BTreeSet::new();
        for room in ["core", "cutting", "holes", "nc", "turning", "audit"] {
            codes_in(&Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../{room}/src")), &mut codes);
        }
        assert!(codes.len() > 50, "the search for codes finds too few: {}", codes.len());
        let unknown: Vec<_> = codes.iter().filter(|code| !sentences().any(|(known, ..)| known == code)).collect();
        assert!(unknown.is_empty(), "codes without words: {unknown:?}");
    }

    #[test]
    fn every_mistake_of_a_program_says_what_to_do() {
        let codes = |table: &[(&'static str, &str, &str)]| -> BTreeSet<&'static str> {
            table.iter().map(|(code, ..)| *code).collect()
        };
        for (sentences, remedies, page) in [
            (programs::SENTENCES, programs::REMEDIES, include_str!("../../../docs/control-2c42-65.md")),
            (iso::SENTENCES, iso::REMEDIES, include_str!("../../../docs/control-linuxcnc.md")),
            (lathe_programs::SENTENCES, lathe_programs::REMEDIES, include_str!("../../../docs/turning-programs.md")),
        ] {
            let said = codes(sentences);
            assert_eq!(said, codes(remedies));
            let untold: Vec<_> = said.iter().filter(|code| !page.contains(&format!("`{code}`"))).collect();
            assert!(untold.is_empty(), "the page of the control does not name {untold:?}");
        }
    }

    #[test]
    fn both_languages_use_the_same_figures() {
        let figures = |text: &str| -> BTreeSet<String> {
            text.split('{').skip(1).filter_map(|rest| rest.split('}').next()).map(str::to_owned).collect()
        };
        for (code, uk, en) in sentences() {
            assert_eq!(figures(uk), figures(en), "{code}");
        }
    }

    #[test]
    fn a_figure_is_filled_in_and_the_failing_inequality_is_shown() {
        let note =
            Note::new("does-not-reach").with("tool", "X").with("table", "A.11").with("reach", 90).with("needed", 96);
        assert_eq!(sentence(&note, Lang::En), "X (A.11): reach 90 < 96 mm");
    }
}
