//! Columns of tables and keys of plans by the names that people give them, in every language of the program.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

use technolog_core::lang::Lang;

use crate::knowledge::alike::latin;
use crate::knowledge::form::Form;
use crate::knowledge::units::Unit;

use super::super::file::{Card, Clamping, Conditions, Factors, Holder, PlanFile, Program, Row, Times, Tool};
use super::super::quantity::Quantity;

/// The mapping of a plan file that a key belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Of {
    /// The plan itself.
    Plan,
    /// What of the part a table can say beside the plan: its material and machine.
    Part,
    /// A row of the route.
    Row,
    /// The place of a tool, in a table of tools.
    Place,
    /// A tool.
    Tool,
    /// Its holder.
    Holder,
    /// Conditions.
    Conditions,
    /// Their card.
    Card,
    /// Their factors.
    Factors,
    /// The clamping.
    Clamping,
    /// The program.
    Program,
    /// The times.
    Times,
}

/// A key of a plan file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Column {
    /// The mapping it stands in.
    pub of: Of,
    /// The key.
    pub key: &'static str,
}

fn keys<F: Form>() -> Vec<&'static str> {
    F::KEYS.iter().map(|key| key.name()).collect()
}

/// What a column is called, as names are compared.
struct Called {
    /// In every language, and by its key.
    names: BTreeSet<String>,
    /// Also where its table holds one mapping only.
    alone: BTreeSet<String>,
    /// In formulas.
    symbol: Option<String>,
}

impl Called {
    fn new(column: Column) -> Self {
        let of_message = |message: &str| -> BTreeSet<String> {
            Lang::all().flat_map(|lang| called(lang, message)).map(norm).collect()
        };
        let mut names = of_message(&column.message());
        names.insert(match column.of {
            Of::Card => norm(&format!("card.{}", column.key)),
            Of::Holder => norm(&format!("holder.{}", column.key)),
            _ => norm(column.key),
        });
        let alone = match column.of {
            Of::Tool | Of::Clamping => of_message(&format!("column-{}", column.key)),
            _ => BTreeSet::new(),
        };
        // `Подача S`: the name with its symbol behind it.
        if let Some(symbol) = column.quantity().map(Quantity::symbol) {
            let with_symbol = |message: &str| -> Vec<String> {
                Lang::all()
                    .flat_map(|lang| called(lang, message))
                    .map(|name| norm(&format!("{name} {symbol}")))
                    .collect()
            };
            names.extend(with_symbol(&column.message()));
        }
        Self { names, alone, symbol: column.quantity().map(|quantity| norm(quantity.symbol())) }
    }
}

static CALLED: LazyLock<BTreeMap<Column, Called>> =
    LazyLock::new(|| Of::ALL.into_iter().flat_map(Of::columns).map(|column| (column, Called::new(column))).collect());

/// Units by what people write for them.
static UNITS: LazyLock<BTreeMap<String, Unit>> = LazyLock::new(|| {
    let mut units = BTreeMap::new();
    for unit in Unit::ALL.iter().copied() {
        let id = unit.text().replace(['*', '/'], "-");
        let of_lang = |lang: Lang| {
            let also = lang.find(&format!("written-unit-{id}")).unwrap_or_default().split("; ");
            [lang.find(&format!("unit-{id}")).unwrap_or(unit.text())].into_iter().chain(also)
        };
        for name in Lang::all().flat_map(of_lang).chain([unit.text()]).map(bare).filter(|name| !name.is_empty()) {
            units.entry(name).or_insert(unit);
        }
    }
    units
});

impl Of {
    const ALL: [Self; 12] = [
        Self::Plan,
        Self::Part,
        Self::Row,
        Self::Place,
        Self::Tool,
        Self::Holder,
        Self::Conditions,
        Self::Card,
        Self::Factors,
        Self::Clamping,
        Self::Program,
        Self::Times,
    ];

    /// Its columns, in the order of the format.
    pub fn columns(self) -> Vec<Column> {
        let keys = match self {
            Self::Plan => keys::<PlanFile>(),
            Self::Part => vec!["material", "machine"],
            Self::Row => keys::<Row>(),
            Self::Place => vec!["tool"],
            Self::Tool => keys::<Tool>(),
            Self::Holder => keys::<Holder>(),
            Self::Conditions => keys::<Conditions>(),
            Self::Card => keys::<Card>(),
            Self::Factors => keys::<Factors>(),
            Self::Clamping => keys::<Clamping>(),
            Self::Program => keys::<Program>(),
            Self::Times => keys::<Times>(),
        };
        keys.into_iter().map(|key| Column { of: self, key }).collect()
    }

    /// What its messages begin with where its key alone means something else.
    const fn prefix(self) -> &'static str {
        match self {
            Self::Part => "part-",
            Self::Tool => "tool-",
            Self::Holder => "holder-",
            Self::Card => "card-",
            Self::Clamping => "clamping-",
            _ => "",
        }
    }
}

impl Column {
    /// Its figure, if it holds one.
    pub fn quantity(self) -> Option<Quantity> {
        match (self.of, self.key) {
            (Of::Card | Of::Factors | Of::Holder, key) => {
                let of = match self.of {
                    Of::Card => "card",
                    Of::Factors => "factors",
                    _ => "holder",
                };
                Quantity::of_key(&format!("{of}.{key}"))
            }
            (Of::Clamping, "force") => Some(Quantity::ClampForce),
            (_, key) => Quantity::of_key(key),
        }
    }

    /// The message of its names.
    pub fn message(self) -> String {
        match (self.of, self.key) {
            // The cell of a holder holds its designation.
            (Of::Holder, "designation") => "column-holder".to_owned(),
            (of, key) => {
                let own = format!("column-{}{key}", of.prefix());
                if Lang::EN.find(&own).is_some() { own } else { format!("column-{key}") }
            }
        }
    }

    /// The name that the program writes at its head.
    pub fn name(self, lang: Lang) -> &'static str {
        lang.find(&self.message()).unwrap_or(self.key)
    }

    /// Whether one of its names is that; `alone` where its table holds one mapping only.
    pub fn is_called(self, name: &str, alone: bool) -> bool {
        self.has_name(&norm(name), alone)
    }

    /// The same of a name as it is compared.
    pub fn has_name(self, name: &str, alone: bool) -> bool {
        self.with_names(|own| own.names.contains(name) || alone && own.alone.contains(name))
    }

    /// What it is called: worked out once, as every cell above a head is held against every column.
    fn with_names(self, of: impl Fn(&Called) -> bool) -> bool {
        match CALLED.get(&self) {
            Some(own) => of(own),
            None => of(&Called::new(self)),
        }
    }

    /// Whether the program itself calls it so.
    pub fn is_named(self, name: &str) -> bool {
        Lang::all().any(|lang| norm(self.name(lang)) == norm(name))
    }

    /// Whether its symbol in formulas is that, as it is compared.
    pub fn has_symbol(self, name: &str) -> bool {
        self.with_names(|own| own.symbol.as_deref() == Some(name))
    }

    /// Its unit, if it has one.
    pub fn unit(self) -> Option<Unit> {
        self.quantity().map(Quantity::unit)
    }
}

/// The names of a message: the one that is written, and others in use.
fn called(lang: Lang, message: &str) -> impl Iterator<Item = &'static str> {
    let also = lang.find_form(message, "also").unwrap_or_default();
    lang.find(message).into_iter().chain(also.split("; ").filter(|name| !name.is_empty()))
}

/// A written word as the id that it means: `за картами` is `card`.
pub(crate) fn written<'n>(text: &str, ids: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    let wanted = norm(text);
    let means = |id: &&str| {
        let message = format!("written-{id}");
        Lang::all().any(|lang| called(lang, &message).any(|own| norm(own) == wanted))
    };
    ids.into_iter().find(means)
}

/// A name as it is compared: short ones are symbols, in which the size of a letter means something.
pub(crate) fn norm(text: &str) -> String {
    let text = text.trim().trim_end_matches(['.', ':']).replace(['’', 'ʼ', '`'], "'");
    let text: String = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if text.chars().count() > 3 { latin(&text.to_lowercase()) } else { latin(&text) }
}

/// The unit of a text, as people write it.
pub(crate) fn unit(text: &str) -> Option<Unit> {
    UNITS.get(&bare(text)).copied()
}

/// A unit as it is compared.
fn bare(text: &str) -> String {
    let signs = text.chars().filter(|sign| !sign.is_whitespace() && !matches!(sign, '·' | '*' | '.' | '⋅' | '×'));
    latin(&signs.collect::<String>().to_lowercase())
}

/// A head of a column apart: its name, and its unit behind a comma or in brackets.
pub(crate) fn head(text: &str) -> (&str, Option<Unit>) {
    let at = text.rfind([',', '(', '[']).filter(|at| *at > 0);
    let Some((name, rest)) = at.and_then(|at| text.split_at_checked(at)) else { return (text, None) };
    let rest = rest.trim_matches([',', '(', ')', '[', ']', ' ']);
    match unit(rest) {
        Some(unit) => (name.trim(), Some(unit)),
        None => (text, None),
    }
}
