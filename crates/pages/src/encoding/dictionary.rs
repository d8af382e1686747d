//! The meanings of the words of a control: one dictionary from its tables.
//!
//! The meanings for 2C42-65 are in several tables of its manual; those of another control `NAME` are in one,
//! `NAME-words`, or else those of the functions and addresses that it has. A row with cycles is a parameter of those cycles.

use std::collections::{BTreeMap, BTreeSet};

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::Figure;
use crate::report::Lang;
use crate::tables::controls::control_2c42_65::{
    AddressUnit, Addresses, CycleParameters, GFunctions, MActions, MFunctions,
};
use crate::tables::controls::iso::{self, Words};
use crate::words::{Note, say};

use super::blocks::Word;

/// Functions whose block uses axis words for a setting or a wait, not for motion.
const NO_WAY: [&str; 4] = ["G04", "G10", "G52", "G92"];

/// A meaning in both languages.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Meaning {
    uk: String,
    en: String,
    /// The meaning with G91, if it differs.
    incremental: Option<(String, String)>,
    unit: Option<String>,
    /// Whether the number counts tenths of its unit.
    tenths: bool,
}

/// The meanings of a control's words.
#[derive(Clone, Debug, Default)]
pub struct Dictionary {
    /// By code (`G81`, `M06`) or address (`X`).
    words: BTreeMap<String, Meaning>,
    /// Parameters of cycles: by the cycle and the address.
    parameters: BTreeMap<(String, String), Vec<Meaning>>,
    /// The codes that begin a cycle.
    cycles: BTreeSet<String>,
}

/// Modal state that changes a meaning.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Modes {
    incremental: bool,
}

impl Dictionary {
    /// Reads the words of a control.
    ///
    /// # Errors
    /// There is no such table, or a row lacks a meaning.
    pub fn read(control: &str, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let mut dictionary = Self::default();
        if control == "2c42-65" {
            dictionary.take_2c42_65(knowledge)?;
            return Ok(dictionary);
        }
        let Ok(words) = knowledge.table(&format!("{control}-words")) else {
            dictionary.take_iso(control, knowledge)?;
            return Ok(dictionary);
        };
        for row in words.rows() {
            let row: Words<'_> = row?;
            let unit = row.unit.filter(|unit| *unit != AddressUnit::Ones.name()).map(str::to_owned);
            let incremental = row.incremental_uk.zip(row.incremental_en);
            let meaning = Meaning { unit, ..Meaning::new(row.meaning_uk, row.meaning_en, incremental) };
            dictionary.take(row.word, &row.cycles.unwrap_or_default(), meaning);
        }
        Ok(dictionary)
    }

    /// The words of a control that has no table of its own for the sheet.
    fn take_iso(&mut self, control: &str, knowledge: &Knowledge) -> Result<(), KnowledgeError> {
        let words = format!("{control}-words");
        let lacks = || KnowledgeError::missing(&words, crate::note::Note::new("table-no-words-of-control"));
        let mut names = vec![control];
        names.extend(iso::Record::text(control, iso::Characteristic::WordsOf, knowledge).map_err(|_| lacks())?);
        let has = |controls: &[&str]| controls.iter().any(|control| names.contains(control));
        for row in knowledge.rows::<iso::GFunctions<'_>>()?.into_iter().filter(|row| has(&row.controls)) {
            let code = two_digits('G', row.code.trim_start_matches('G'));
            self.take(&code, &[], Meaning::new(row.meaning_uk, row.meaning_en, None));
        }
        for row in knowledge.rows::<iso::MFunctions<'_>>()?.into_iter().filter(|row| has(&row.controls)) {
            let code = two_digits('M', row.code.trim_start_matches('M'));
            self.take(&code, &[], Meaning::new(row.meaning_uk, row.meaning_en, None));
        }
        for row in knowledge.rows::<iso::Addresses<'_>>()?.into_iter().filter(|row| has(&row.controls)) {
            let meaning = Meaning::new(row.meaning_uk, row.meaning_en, None);
            self.take(&row.address.0.to_string(), &[], meaning);
        }
        if self.words.is_empty() {
            return Err(lacks());
        }
        Ok(())
    }

    fn take_2c42_65(&mut self, knowledge: &Knowledge) -> Result<(), KnowledgeError> {
        for row in knowledge.rows::<GFunctions<'_>>()? {
            self.take(row.code, &[], Meaning::new(row.meaning_uk, row.meaning_en, None));
        }
        for row in knowledge.rows::<MFunctions<'_>>()? {
            self.take(row.code, &[], Meaning::new(row.meaning_uk, row.meaning_en, None));
        }
        // The table of actions has only what the other tables lack.
        for row in knowledge.rows::<MActions<'_>>()? {
            if let (Some(uk), Some(en)) = (row.meaning_uk, row.meaning_en) {
                self.take(row.code, &[], Meaning::new(uk, en, None));
            }
        }
        for row in knowledge.rows::<Addresses<'_>>()? {
            let unit = row.unit.filter(|unit| *unit != AddressUnit::Ones).map(|unit| unit.name().to_owned());
            let tenths = row.unit == Some(AddressUnit::Seconds);
            let meaning = Meaning { unit, tenths, ..Meaning::new(row.meaning_uk, row.meaning_en, None) };
            self.take(&row.address.0.to_string(), &[], meaning);
        }
        for row in knowledge.rows::<CycleParameters<'_>>()? {
            let incremental = row.incremental_uk.zip(row.incremental_en);
            let meaning = Meaning::new(row.meaning_uk, row.meaning_en, incremental);
            self.take(&row.word.0.to_string(), &row.cycles, meaning);
        }
        Ok(())
    }

    /// Adds a word, or for given cycles a parameter of these.
    fn take(&mut self, word: &str, cycles: &[&str], meaning: Meaning) {
        for cycle in cycles {
            self.cycles.insert((*cycle).to_owned());
            let key = ((*cycle).to_owned(), word.to_owned());
            self.parameters.entry(key).or_default().push(meaning.clone());
        }
        if cycles.is_empty() {
            self.words.entry(word.to_owned()).or_insert(meaning);
        }
    }

    /// The meaning of a block, word by word; its number has none.
    pub(super) fn meaning(&self, words: &[Word], modes: &mut Modes, lang: Lang) -> String {
        let codes: Vec<String> = words.iter().filter_map(code).collect();
        for code in &codes {
            match code.as_str() {
                "G90" => modes.incremental = false,
                "G91" => modes.incremental = true,
                _ => {}
            }
        }
        let is_motion = !codes.iter().any(|code| NO_WAY.contains(&code.as_str()));
        let mut cycle: Option<String> = None;
        let mut meanings = Vec::new();
        for word in words {
            match word {
                Word::Address('N', _) if cycle.is_none() => {}
                Word::Address(letter, number) => {
                    let text = self.word(*letter, number, cycle.as_deref(), words, *modes, is_motion, lang);
                    meanings.push(format!("{letter}{number}: {text}"));
                    cycle = cycle.or(code(word).filter(|code| self.cycles.contains(code)));
                }
                Word::Comment(text) => meanings.push(say!(lang, "encoding-comment", text = text.as_str())),
                Word::Skip => meanings.push(say!(lang, "encoding-skip").to_owned()),
                Word::Tape => meanings.push(say!(lang, "encoding-tape").to_owned()),
                Word::Statement(text) => {
                    let key = match text.split_whitespace().last() {
                        Some("sub") => "encoding-sub",
                        Some("endsub") => "encoding-endsub",
                        Some("call") => "encoding-call",
                        _ => "encoding-statement",
                    };
                    meanings.push(lang.say(&Note::new(key).with("text", text.as_str())));
                }
            }
        }
        meanings.join("; ")
    }

    /// The tool and the offset registers in a block, without parameters of a cycle: `T1`, `H01`.
    pub(super) fn tool(&self, words: &[Word]) -> Option<String> {
        let mut cycle: Option<String> = None;
        let mut named = Vec::new();
        for word in words {
            if let Word::Address(letter @ ('T' | 'H' | 'D'), number) = word {
                let key = |cycle: &String| (cycle.clone(), letter.to_string());
                if !cycle.as_ref().is_some_and(|cycle| self.parameters.contains_key(&key(cycle))) {
                    named.push(format!("{letter}{number}"));
                }
            }
            cycle = cycle.or(code(word).filter(|code| self.cycles.contains(code)));
        }
        (!named.is_empty()).then(|| named.join(", "))
    }

    /// The meaning of a word; after the G function of a cycle, as its parameter.
    #[allow(clippy::too_many_arguments, reason = "the word, what stands around it, and the language")]
    fn word(
        &self,
        letter: char,
        number: &str,
        cycle: Option<&str>,
        block: &[Word],
        modes: Modes,
        is_motion: bool,
        lang: Lang,
    ) -> String {
        let address = self.words.get(&letter.to_string());
        let parameter =
            |letter: char| cycle.and_then(|cycle| self.parameters.get(&(cycle.to_owned(), letter.to_string())));
        if let Some(meanings) = parameter(letter) {
            // If another word of the block has this meaning alone, this word does not have it: F beside a retract
            // with its own H.
            let elsewhere = |meaning: &Meaning| {
                block.iter().any(|word| match word {
                    Word::Address(other, _) if *other != letter => {
                        parameter(*other).is_some_and(|others| others.iter().any(|other| other.uk == meaning.uk))
                    }
                    _ => false,
                })
            };
            let several = meanings.len() > 1;
            let own: Vec<&Meaning> = meanings.iter().filter(|meaning| !(several && elsewhere(meaning))).collect();
            let texts = own.iter().map(|meaning| meaning.text(modes.incremental, lang).to_owned());
            let unit = own.first().and_then(|meaning| meaning.unit.as_ref());
            let unit = unit.or(address.and_then(|it| it.unit.as_ref())).or_else(|| self.unit_alike(cycle?, meanings));
            let tenths = address.is_some_and(|address| address.tenths);
            let both = |first: String, second: String| say!(lang, "encoding-both", first = first, second = second);
            let text = texts.reduce(both).unwrap_or_default();
            return match letter {
                'M' => format!("{text}: {}", self.code(letter, number, lang)),
                _ => valued(&text, "encoding-is", number, unit, tenths, lang),
            };
        }
        if matches!(letter, 'G' | 'M') {
            return self.code(letter, number, lang);
        }
        let Some(meaning) = address else { return unknown(lang) };
        let text = meaning.text(false, lang);
        // Behind the semicolon stands what they are beside G10, in a helix: in an arc they are its centre.
        let helix = || block.iter().any(|word| code(word).as_deref() == Some("G10"));
        let text = match text.split_once(';') {
            Some((centre, _)) if matches!(letter, 'I' | 'J' | 'K') && !helix() => centre,
            _ => text,
        };
        let between = match letter {
            'X' | 'Y' | 'Z' | 'A' | 'B' | 'C' if is_motion && modes.incremental => "encoding-moves-by",
            'X' | 'Y' | 'Z' | 'A' | 'B' | 'C' if is_motion => "encoding-moves-to",
            _ => "encoding-is",
        };
        valued(text, between, number, meaning.unit.as_ref(), meaning.tenths, lang)
    }

    /// The unit of the address with the same meaning in a cycle: H of a retract is a feed, like F.
    fn unit_alike(&self, cycle: &str, meanings: &[Meaning]) -> Option<&String> {
        let alike =
            |others: &[Meaning]| others.iter().any(|other| meanings.iter().any(|meaning| meaning.uk == other.uk));
        let of_cycle = self.parameters.iter().filter(|((own, _), _)| own == cycle);
        of_cycle.filter(|(_, others)| alike(others)).find_map(|((_, word), _)| self.words.get(word)?.unit.as_ref())
    }

    fn code(&self, letter: char, number: &str, lang: Lang) -> String {
        let code = two_digits(letter, number);
        self.words.get(&code).map_or_else(|| unknown(lang), |meaning| meaning.text(false, lang).to_owned())
    }
}

impl Meaning {
    fn new(uk: &str, en: &str, incremental: Option<(&str, &str)>) -> Self {
        let incremental = incremental.map(|(uk, en)| (uk.to_owned(), en.to_owned()));
        Self { uk: uk.to_owned(), en: en.to_owned(), incremental, ..Self::default() }
    }

    /// The text of the table, which is in both languages.
    fn text(&self, incremental: bool, lang: Lang) -> &str {
        let (uk, en) = match &self.incremental {
            Some((uk, en)) if incremental => (uk, en),
            _ => (&self.uk, &self.en),
        };
        if lang.tag() == "uk" { uk } else { en }
    }
}

fn unknown(lang: Lang) -> String {
    say!(lang, "encoding-unknown").to_owned()
}

/// A meaning with its number, if the number has a unit; other meanings are complete.
fn valued(text: &str, message: &'static str, number: &str, unit: Option<&String>, tenths: bool, lang: Lang) -> String {
    let Some(unit) = unit else { return text.to_owned() };
    let shown = match number.parse::<f64>() {
        Ok(value) if tenths => Figure::number((value / 10.0).to_string()),
        Ok(value) => Figure::number(value.to_string()),
        Err(_) => Figure::Text(number.to_owned().into()),
    };
    let unit = lang.find(&format!("unit-{}", unit.replace('/', "-"))).unwrap_or(unit);
    lang.say(&Note::new(message).with("meaning", text).with("value", shown).with("unit", unit))
}

/// The code of a function: `G0` is `G00`, `G54.1` stays.
fn code(word: &Word) -> Option<String> {
    match word {
        Word::Address(letter @ ('G' | 'M'), number) => Some(two_digits(*letter, number)),
        _ => None,
    }
}

fn two_digits(letter: char, number: &str) -> String {
    let whole = number.split('.').next().unwrap_or_default();
    let number = number.strip_suffix(".0").unwrap_or(number);
    match whole.len() {
        1 => format!("{letter}0{number}"),
        // M003 is M03, too.
        _ if !number.contains('.') && number.len() > 2 => format!("{letter}{:0>2}", number.trim_start_matches('0')),
        _ => format!("{letter}{number}"),
    }
}
