//! The messages of one language, parsed when the first of them is said.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::types::FluentNumber;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement};
use technolog_note::Figure;

type Bundle = FluentBundle<FluentResource>;

/// The folders of all languages: the tag of each, then name and text of its files.
pub type Folders = &'static [(&'static str, &'static [(&'static str, &'static str)])];

/// A language: its files, and its messages once they are asked for.
pub struct Language {
    pub(crate) tag: &'static str,
    folders: Folders,
    messages: OnceLock<Bundle>,
    remarks: OnceLock<BTreeMap<&'static str, &'static str>>,
    places: OnceLock<Vec<(&'static str, &'static str)>>,
    /// Messages without gaps that are written in several pieces, as those with a brace are; by name and form.
    joined: OnceLock<BTreeMap<(String, String), String>>,
}

impl Language {
    /// A language by the name of its folder.
    pub const fn new(tag: &'static str, folders: Folders) -> Self {
        Self {
            tag,
            folders,
            messages: OnceLock::new(),
            remarks: OnceLock::new(),
            places: OnceLock::new(),
            joined: OnceLock::new(),
        }
    }

    /// Its tag.
    pub const fn tag(&self) -> &'static str {
        self.tag
    }

    /// Its files of messages, name and text of each.
    pub fn files(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        self.all_files().iter().copied().filter(|(name, _)| name.ends_with(".ftl"))
    }

    fn all_files(&self) -> &'static [(&'static str, &'static str)] {
        self.folders.iter().find(|(tag, _)| *tag == self.tag).map_or(&[], |(_, files)| files)
    }

    /// The remarks of table rows that this language has: English, translation.
    pub fn remarks(&self) -> &BTreeMap<&'static str, &'static str> {
        self.remarks.get_or_init(|| self.pairs("remarks.tsv").collect())
    }

    /// The words and phrases of places in sources, the longest first: English, translation.
    pub fn places(&self) -> &[(&'static str, &'static str)] {
        self.places.get_or_init(|| {
            let mut places: Vec<_> = self.pairs("places.tsv").collect();
            places.sort_by_key(|(english, _)| std::cmp::Reverse(english.len()));
            places
        })
    }

    fn pairs(&self, file: &'static str) -> impl Iterator<Item = (&'static str, &'static str)> {
        let texts = self.all_files().iter().filter(move |(name, _)| *name == file);
        texts.flat_map(|(_, text)| text.lines()).filter_map(|line| line.split_once('\t'))
    }

    /// A message with its figures filled in; nothing where this language has none of that name.
    pub(crate) fn message(
        &self,
        key: &str,
        form: Option<&str>,
        figures: &[(&str, &Figure)],
        shown: &dyn Fn(&Figure) -> String,
    ) -> Option<String> {
        let pattern = self.pattern(key, form)?;
        let mut arguments = FluentArgs::with_capacity(figures.len());
        for (name, figure) in figures {
            let value = match figure {
                // As a number, so that plurals can go by it; one with its plus would lose it.
                Figure::Number(number) if !number.starts_with('+') => {
                    number.parse::<FluentNumber>().map(FluentValue::Number).ok()
                }
                _ => None,
            };
            arguments.set(*name, value.unwrap_or_else(|| FluentValue::String(shown(figure).into())));
        }
        let mut faults = Vec::new();
        let text = self.bundle().format_pattern(pattern, Some(&arguments), &mut faults).into_owned();
        debug_assert!(faults.is_empty(), "{}: message `{key}`: {faults:?}", self.tag);
        Some(text)
    }

    /// A message that is nothing but text.
    pub(crate) fn plain(&self, key: &str, form: Option<&str>) -> Option<&str> {
        let pattern = self.pattern(key, form)?;
        if let [PatternElement::TextElement { value }] = pattern.elements.as_slice() {
            return Some(value);
        }
        if !gaps(pattern).is_empty() {
            return None;
        }
        let joined = self.joined.get_or_init(|| self.join());
        joined.get(&(key.to_owned(), form.unwrap_or_default().to_owned())).map(String::as_str)
    }

    fn join(&self) -> BTreeMap<(String, String), String> {
        let mut joined = BTreeMap::new();
        for (key, form) in self.files().flat_map(|(_, text)| names(text)) {
            let pattern = self.pattern(&key, Some(form.as_str()).filter(|form| !form.is_empty()));
            let Some(pattern) = pattern.filter(|pattern| pattern.elements.len() > 1 && gaps(pattern).is_empty()) else {
                continue;
            };
            let text = self.bundle().format_pattern(pattern, None, &mut Vec::new()).into_owned();
            joined.insert((key, form), text);
        }
        joined
    }

    fn pattern(&self, key: &str, form: Option<&str>) -> Option<&Pattern<&str>> {
        let message = self.bundle().get_message(key)?;
        match form {
            None => message.value(),
            Some(form) => Some(message.get_attribute(form)?.value()),
        }
    }

    /// Whether a message has a gap for this figure; nothing where there is no such message.
    pub(crate) fn mentions(&self, key: &str, figure: &str) -> Option<bool> {
        Some(gaps(self.pattern(key, None)?).contains(&figure))
    }

    /// A number as people write it in this language.
    pub(crate) fn number(&self, written: &str) -> String {
        if self.bundle().has_message("decimal-comma") { with_comma(written) } else { written.to_owned() }
    }

    fn bundle(&self) -> &Bundle {
        self.messages.get_or_init(|| {
            let mut bundle = Bundle::new_concurrent(vec![self.tag.parse().unwrap_or_default()]);
            // No invisible marks around figures: pages are copied into other programs.
            bundle.set_use_isolating(false);
            for (_, text) in self.files() {
                // A file with a fault gives its sound messages; the check of the catalogue tells the fault.
                let resource = match FluentResource::try_new(text.to_owned()) {
                    Ok(resource) | Err((resource, _)) => resource,
                };
                // The same name twice: the first stays, and the check tells it.
                let _ = bundle.add_resource(resource);
            }
            if bundle.has_message("decimal-comma") {
                bundle.set_formatter(Some(|value, _| match value {
                    FluentValue::Number(number) => Some(with_comma(&number.as_string())),
                    _ => None,
                }));
            }
            bundle
        })
    }
}

/// A number with a comma before its decimals; where that is the rule, a minus is a sign of its own and no hyphen.
fn with_comma(written: &str) -> String {
    let (sign, digits) = written.strip_prefix('-').map_or(("", written), |digits| ("−", digits));
    format!("{sign}{}", digits.replace('.', ","))
}

/// The names of all messages of a file, and of their forms.
fn names(text: &str) -> Vec<(String, String)> {
    let resource = fluent_syntax::parser::parse(text).unwrap_or_else(|(sound, _)| sound);
    let mut names = Vec::new();
    for entry in resource.body {
        let Entry::Message(message) = entry else { continue };
        let key = message.id.name.to_owned();
        names.extend(message.attributes.iter().map(|form| (key.clone(), form.id.name.to_owned())));
        names.push((key, String::new()));
    }
    names
}

/// The names of the figures that a pattern has gaps for.
pub fn gaps<'p>(pattern: &Pattern<&'p str>) -> Vec<&'p str> {
    let mut names = Vec::new();
    for element in &pattern.elements {
        let PatternElement::Placeable { expression } = element else { continue };
        let inline = match expression {
            Expression::Inline(inline) => inline,
            Expression::Select { selector, variants } => {
                names.extend(variants.iter().flat_map(|variant| gaps(&variant.value)));
                selector
            }
        };
        if let InlineExpression::VariableReference { id } = inline {
            names.push(id.name);
        }
    }
    names
}
