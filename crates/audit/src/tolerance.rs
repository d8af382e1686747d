//! The rounding tolerances: the table `audit-tolerance`.

use std::collections::BTreeMap;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::Severity;
use crate::tables::audit::Tolerance as Row;

use super::quantity::Quantity;
use super::stated::StatedFigure;

pub use crate::tables::audit::Range;

/// How far each quantity may differ from its right value.
#[derive(Clone, Debug, Default)]
pub struct Tolerances(BTreeMap<Quantity, Tolerance>);

/// A row of the table.
#[derive(Clone, Copy, Debug)]
struct Tolerance {
    half_places: f64,
    /// As a share.
    relative: f64,
    own_places: i64,
    rounded: bool,
    severity: Severity,
    range: Range,
    whole_number: bool,
}

impl Tolerance {
    fn of(row: &Row<'_>) -> Self {
        let &Row { half_places, own_places, rounded, severity, range, whole: whole_number, .. } = row;
        Self { half_places, relative: row.relative.0 / 100.0, own_places, rounded, severity, range, whole_number }
    }
}

impl Tolerances {
    /// Reads the table.
    ///
    /// # Errors
    /// It is missing, or lacks a quantity.
    pub fn read(knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let table = knowledge.table_of::<Row<'_>>()?;
        let rows = table.rows::<Row<'_>>().map(|row| row.map(|row| (row.quantity, Tolerance::of(&row))));
        let read: BTreeMap<_, _> = rows.collect::<Result<_, _>>()?;
        match Quantity::ALL.iter().find(|quantity| !read.contains_key(quantity)) {
            Some(quantity) => Err(KnowledgeError::no_row(table, quantity.key())),
            None => Ok(Self(read)),
        }
    }

    /// How far a stated figure may be from a value, in the unit of its quantity.
    pub fn allowed_difference(&self, quantity: Quantity, stated: &StatedFigure, value: f64) -> f64 {
        let Some(tolerance) = self.0.get(&quantity) else { return 0.0 };
        // Binary fractions are not exact: a millionth of the value is no deviation.
        tolerance.half_places * stated.last_place / 2.0 + tolerance.relative * value.abs() + 1e-9 * value.abs().max(1.0)
    }

    /// How far a figure of a quantity may be from a value, as a share of it.
    pub fn share(&self, quantity: Quantity) -> f64 {
        self.0.get(&quantity).map_or(0.0, |tolerance| tolerance.relative)
    }

    /// Whether a printed figure of this quantity may stand for a longer one.
    pub fn rounded(&self, quantity: Quantity) -> bool {
        self.0.get(&quantity).is_some_and(|tolerance| tolerance.rounded)
    }

    /// The decimal places to which `technolog plan` rounds it.
    pub fn own_places(&self, quantity: Quantity) -> i64 {
        self.0.get(&quantity).map_or(0, |tolerance| tolerance.own_places)
    }

    /// The possible range of its figures.
    pub fn range(&self, quantity: Quantity) -> Range {
        self.0.get(&quantity).map_or(Range::Any, |tolerance| tolerance.range)
    }

    /// Whether it is a whole number.
    pub fn is_whole_number(&self, quantity: Quantity) -> bool {
        self.0.get(&quantity).is_some_and(|tolerance| tolerance.whole_number)
    }

    /// How grave a deviation is.
    pub fn severity(&self, quantity: Quantity) -> Severity {
        self.0.get(&quantity).map_or(Severity::Wrong, |tolerance| tolerance.severity)
    }
}
