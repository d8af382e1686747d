//! The messages of one language. The build finds the place of each in its file; a message is parsed at its first use.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::types::FluentNumber;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use fluent_syntax::ast::{Entry, Expression, InlineExpression, Message, Pattern, PatternElement};
use technolog_note::Figure;

type Bundle = FluentBundle<FluentResource>;

/// The folder of a language, as the build lists it.
pub struct Folder {
    /// The tag of the language.
    pub tag: &'static str,
    /// Name and text of each file.
    pub files: &'static [(&'static str, &'static str)],
    /// Every message in the order of the names.
    pub messages: &'static [MessageSpan],
}

/// The place of a message: the number of its file, and its bytes there. The text begins with the name.
pub struct MessageSpan(pub u16, pub u32, pub u32);

/// A language: its files, and the messages used so far.
pub struct Language {
    pub(crate) tag: &'static str,
    folders: &'static [Folder],
    messages: OnceLock<Vec<Source>>,
    /// A bundle without messages: its rules of numbers and plurals format the messages in use.
    bundle: OnceLock<Bundle>,
    remarks: OnceLock<BTreeMap<&'static str, &'static str>>,
    places: OnceLock<Vec<(&'static str, &'static str)>>,
}

/// A message in use.
#[derive(Default)]
struct Source {
    parsed: OnceLock<FluentResource>,
    /// Its texts without gaps that consist of several pieces, such as texts with a brace.
    joined: OnceLock<BTreeMap<String, String>>,
}

impl Source {
    /// The message of a text; none if it has a syntax error, which the check of the catalogue reports.
    fn message(&self, text: &str) -> Option<&Message<&str>> {
        let read = || match FluentResource::try_new(text.to_owned()) {
            Ok(resource) | Err((resource, _)) => resource,
        };
        self.parsed.get_or_init(read).entries().find_map(|entry| match entry {
            Entry::Message(message) => Some(message),
            _ => None,
        })
    }
}

impl Language {
    /// A language by the tag of its folder.
    pub const fn new(tag: &'static str, folders: &'static [Folder]) -> Self {
        Self {
            tag,
            folders,
            messages: OnceLock::new(),
            bundle: OnceLock::new(),
            remarks: OnceLock::new(),
            places: OnceLock::new(),
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

    fn folder(&self) -> Option<&'static Folder> {
        self.folders.iter().find(|folder| folder.tag == self.tag)
    }

    fn all_files(&self) -> &'static [(&'static str, &'static str)] {
        self.folder().map_or(&[], |folder| folder.files)
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

    /// A message with its figures; none if this language lacks it.
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
                // As a number, for plurals; a number with a plus sign would lose the sign.
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

    /// A message without figures.
    pub(crate) fn plain(&self, key: &str, form: Option<&str>) -> Option<&str> {
        let (source, message) = self.found(key)?;
        let pattern = pattern(message, form)?;
        if let [PatternElement::TextElement { value }] = pattern.elements.as_slice() {
            return Some(value);
        }
        if !gaps(pattern).is_empty() {
            return None;
        }
        let joined = source.joined.get_or_init(|| self.joined(message));
        joined.get(form.unwrap_or_default()).map(String::as_str)
    }

    fn joined(&self, message: &Message<&str>) -> BTreeMap<String, String> {
        let forms = message.attributes.iter().map(|form| (form.id.name, &form.value));
        let value = message.value.iter().map(|value| ("", value));
        let without_gaps = value.chain(forms).filter(|(_, pattern)| gaps(pattern).is_empty());
        let text = |pattern| self.bundle().format_pattern(pattern, None, &mut Vec::new()).into_owned();
        without_gaps.map(|(form, pattern)| (form.to_owned(), text(pattern))).collect()
    }

    fn pattern(&self, key: &str, form: Option<&str>) -> Option<&Pattern<&str>> {
        pattern(self.found(key)?.1, form)
    }

    fn found(&self, key: &str) -> Option<(&Source, &Message<&str>)> {
        let (index, text) = self.text(key)?;
        let folder = self.folder()?;
        let messages = self.messages.get_or_init(|| folder.messages.iter().map(|_| Source::default()).collect());
        let source = messages.get(index)?;
        Some((source, source.message(text)?))
    }

    /// The number of a message, and its text in its file.
    fn text(&self, key: &str) -> Option<(usize, &'static str)> {
        let folder = self.folder()?;
        let text = |MessageSpan(file, begin, end): &MessageSpan| {
            let (_, text) = folder.files.get(usize::from(*file))?;
            text.get(*begin as usize..*end as usize)
        };
        let name = |place| text(place).map_or("", |text| text.split([' ', '=']).next().unwrap_or_default());
        let index = folder.messages.binary_search_by(|place| name(place).cmp(key)).ok()?;
        Some((index, text(&folder.messages[index])?))
    }

    /// Whether it has a message of that name.
    pub(crate) fn has_message(&self, key: &str) -> bool {
        self.text(key).is_some()
    }

    /// Whether a message has a gap for this figure; none if there is no such message.
    pub(crate) fn mentions(&self, key: &str, figure: &str) -> Option<bool> {
        Some(gaps(self.pattern(key, None)?).contains(&figure))
    }

    /// A number as written in this language.
    pub(crate) fn number(&self, written: &str) -> String {
        if self.has_message("decimal-comma") { with_comma(written) } else { written.to_owned() }
    }

    fn bundle(&self) -> &Bundle {
        self.bundle.get_or_init(|| {
            let mut bundle = Bundle::new_concurrent(vec![self.tag.parse().unwrap_or_default()]);
            // No invisible marks around figures: pages are copied into other programs.
            bundle.set_use_isolating(false);
            if self.has_message("decimal-comma") {
                bundle.set_formatter(Some(|value, _| match value {
                    FluentValue::Number(number) => Some(with_comma(&number.as_string())),
                    _ => None,
                }));
            }
            bundle
        })
    }
}

fn pattern<'m>(message: &'m Message<&'m str>, form: Option<&str>) -> Option<&'m Pattern<&'m str>> {
    match form {
        None => message.value.as_ref(),
        Some(form) => message.attributes.iter().find(|own| own.id.name == form).map(|own| &own.value),
    }
}

/// A number with a decimal comma; in such languages the minus is a separate character, not a hyphen.
fn with_comma(written: &str) -> String {
    let (sign, digits) = written.strip_prefix('-').map_or(("", written), |digits| ("−", digits));
    format!("{sign}{}", digits.replace('.', ","))
}

/// The names of the figures for which a pattern has gaps.
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
