//! Words shared by many tables, each defined once.
//!
//! Words that code must know are enums here; words that code only passes from table to table are tables in
//! `catalogs/vocabularies`. An enum column of any table says `of: NAME` instead of repeating the words.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::column::Label;
use crate::contract::Word;
use crate::table::Table;

crate::vocabulary! {
    /// A transition of hole machining.
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    #[allow(missing_docs, reason = "the names are the field's own (ISO 5419, ISO 13399)")]
    pub enum Operation {
        CentreDrill = "centre-drill",
        Drill = "drill",
        DrillOut = "drill-out",
        CoreDrill = "core-drill",
        RoughBore = "rough-bore",
        SemiFinishBore = "semi-finish-bore",
        FinishBore = "finish-bore",
        Mill = "mill",
        Counterbore = "counterbore",
        Countersink = "countersink",
        Chamfer = "chamfer",
        RoughReam = "rough-ream",
        FinishReam = "finish-ream",
        Tap = "tap",
        Hone = "hone",
    }

    /// The shank of the cutters in a tool table.
    #[derive(Serialize, Deserialize)]
    #[serde(rename_all = "lowercase")]
    pub enum Shank {
        /// A cylindrical shank.
        Cylindrical = "cylindrical",
        /// A Morse taper.
        Morse = "morse",
        /// A bore, on an arbor.
        Shell = "shell",
        /// The taper of the machine: the tool needs no holder.
        Taper = "taper",
    }

    /// The material of a cutter's edges.
    #[derive(Serialize, Deserialize)]
    pub enum ToolMaterial {
        /// High-speed steel.
        #[serde(rename = "HSS")]
        HighSpeedSteel = "HSS",
        /// Sintered carbide.
        #[serde(rename = "carbide")]
        Carbide = "carbide",
    }

    /// Controls of lathes.
    pub enum LatheControl {
        /// LinuxCNC 2.9.
        LinuxCnc = "linuxcnc",
        /// Sinumerik 840D.
        Sinumerik = "sinumerik",
        /// Fanuc 0i-TF, system A of G functions.
        Fanuc = "fanuc",
        /// Balt-System NC-201.
        Nc201 = "nc-201",
    }

    /// Kinds of blanks of turned parts.
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum StockKind {
        /// Bar: a full cylinder.
        Bar = "bar",
        /// Tube: a cylinder with a bore.
        Tube = "tube",
        /// A forging, near the shape of the part.
        Forging = "forging",
        /// A casting, near the shape of the part.
        Casting = "casting",
    }

    /// The place of a surface of a turned part, and the place where a lathe tool works.
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "kebab-case")]
    pub enum Place {
        /// Outside.
        Outer = "outer",
        /// In a bore.
        Inner = "inner",
        /// Across the axis.
        Face = "face",
    }

    /// The surface of the metal before the cut.
    pub enum Surface {
        /// Machined before, without a skin.
        None = "none",
        /// As rolled.
        Rolled = "rolled",
        /// As forged.
        Forged = "forged",
        /// As cast.
        Cast = "cast",
        /// As cast, with heavy soiling.
        CastDirty = "cast-dirty",
        /// As cast, of copper and aluminium alloys.
        CastCopperAluminium = "cast-copper-aluminium",
    }

    /// How cutting conditions are found.
    #[derive(Default, Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "lowercase")]
    pub enum CuttingMethod {
        /// By the empirical formulas.
        #[default]
        Formula = "formula",
        /// By the normative cards of the worked example, as far as they can be regenerated.
        Card = "card",
    }

    /// How grave a finding about a plan is.
    #[derive(Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "lowercase")]
    pub enum Severity {
        /// Unsafe or impossible.
        Error = "error",
        /// Contradicts the source or the arithmetic.
        Wrong = "wrong",
        /// Allowed, but dominated or resting on unconfirmed figures.
        Doubtful = "doubtful",
        /// Worth knowing.
        Note = "note",
    }
}

impl Operation {
    /// The operation of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::from_word(name)
    }

    /// Whether it is done with a boring bar.
    pub const fn is_boring(self) -> bool {
        matches!(self, Self::RoughBore | Self::SemiFinishBore | Self::FinishBore)
    }

    /// Whether its bar is set by hand between its passes.
    pub const fn is_set_by_hand(self, passes: u32) -> bool {
        self.is_boring() && passes > 1
    }

    /// Whether it is a transition of a scheme: finishing on another machine is none, tapping is one on any machine.
    pub const fn is_of_scheme(self, elsewhere: bool) -> bool {
        !elsewhere || matches!(self, Self::Tap)
    }

    /// Whether no machine of ours does it: it stands in plans as work of another machine, without tool and conditions.
    pub const fn is_only_elsewhere(self) -> bool {
        matches!(self, Self::Hone)
    }

    /// Whether it is done with a reamer.
    pub const fn is_reaming(self) -> bool {
        matches!(self, Self::RoughReam | Self::FinishReam)
    }

    /// Whether it works on the edge of a hole and does not change its cylinder.
    pub const fn is_of_edge(self) -> bool {
        matches!(self, Self::Chamfer | Self::Countersink | Self::Counterbore)
    }
}

/// Vocabularies by name: those of code, and those of `catalogs/vocabularies`.
#[derive(Clone, Debug)]
pub struct Vocabularies(BTreeMap<String, Words>);

/// The words of a vocabulary, and their names for people in the same order, where a table gives them.
#[derive(Clone, Debug, Default)]
pub struct Words {
    /// The words, as tables have them.
    pub words: Vec<String>,
    /// The names of the words; none for the words of code, whose names are in the message catalogue.
    pub names: Vec<Label>,
}

impl Vocabularies {
    /// The vocabularies that are enums.
    pub fn of_code() -> Self {
        let of = |name: &str, words: &[&str]| {
            let words = words.iter().map(ToString::to_string).collect();
            (name.to_owned(), Words { words, names: Vec::new() })
        };
        Self(BTreeMap::from([
            of("operations", Operation::WORDS),
            of("shanks", Shank::WORDS),
            of("tool-materials", ToolMaterial::WORDS),
            of("lathe-controls", LatheControl::WORDS),
            of("stock-kinds", StockKind::WORDS),
            of("places", Place::WORDS),
            of("surfaces", Surface::WORDS),
        ]))
    }

    /// With the words of a table: the texts of its column `word`, named by `name_uk` and `name_en`.
    pub fn add(&mut self, table: &Table) {
        let texts = |column: &str| {
            let column = table.column_index(column);
            table.rows.iter().filter_map(move |row| match &row.cells[column?] {
                crate::table::Cell::Value(value) => value.as_text().map(str::to_owned),
                _ => None,
            })
        };
        let names = texts("name_uk").zip(texts("name_en")).map(|(uk, en)| Label { uk, en });
        self.0.insert(table.id.clone(), Words { words: texts("word").collect(), names: names.collect() });
    }

    /// The words of a vocabulary.
    pub fn words(&self, name: &str) -> Option<&Words> {
        self.0.get(name)
    }

    /// Every name.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.0.keys().map(String::as_str)
    }
}
