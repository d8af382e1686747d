//! Row types: audit, with the rules by which it judges.

use technolog_knowledge::units::Percent;
use technolog_knowledge::vocabulary::Severity;
use technolog_knowledge::{rows, vocabulary};

use crate::quantity::Quantity;

vocabulary! {
    /// A constant people compute with.
    pub enum Constant {
        /// π, as exactly as somebody took it.
        Pi = "pi",
    }

    /// Which figures of a quantity there can be.
    pub enum Range {
        /// Above zero.
        Positive = "positive",
        /// Zero or above.
        NotNegative = "not-negative",
        /// Any.
        Any = "any",
    }

    /// What a plan by hand takes from tables.
    pub enum Tabulated {
        /// A feed.
        Feed = "feed",
        /// Of centring.
        SpotFeed = "spot-feed",
        /// A point of the cards.
        Card = "card",
        /// A factor of the cards.
        Factor = "factor",
        /// The time of rapids, which a table does not have but our own order does.
        Rapid = "rapid",
    }

    /// How a load stands to the formula.
    pub enum Judgement {
        /// Too low.
        Low = "low",
        /// As it should be.
        Fine = "fine",
        /// Too high.
        High = "high",
    }
}

impl Range {
    /// Whether a figure is in it.
    pub fn holds(self, value: f64) -> bool {
        match self {
            Self::Positive => value > 0.0,
            Self::NotNegative => value >= 0.0,
            Self::Any => true,
        }
    }
}

rows! {
    /// Constants people compute with, each as often as there are values of it.
    pub struct Constants of One("audit-constants") complete name {
        name: Constant,
        value: f64,
    }

    /// What of a program has one cause: the codes of two findings, and the figures in which they must agree.
    pub struct ProgramCauses of One("audit-program-causes") {
        cause: &'t str,
        consequence: &'t str,
        alike: Option<Vec<&'t str>>,
    }

    /// How a program may differ from its plan.
    pub struct ProgramTolerance of One("audit-program-tolerance") {
        quantity: Quantity,
        whole: f64,
        relative: Percent,
        severity: Severity,
    }

    /// What may be rounded how.
    pub struct Tolerance of One("audit-tolerance") complete quantity {
        quantity: Quantity,
        half_places: f64,
        relative: Percent,
        own_places: i64,
        rounded: bool,
        severity: Severity,
        range: Range,
        whole: bool,
    }

    /// A figure taken from a table beside the table.
    pub struct AuditByTable of One("audit-by-table") asked by AuditByTableFor {
        quantity: Tabulated,
        of_table: Percent,
    } {
        severity: Severity,
    }

    /// A stated figure beside the handbook's formula.
    pub struct AuditFormula of One("audit-formula") asked by AuditFormulaFor {
        quantity: Quantity,
        of_formula: Percent,
    } {
        severity: Severity,
    }

    /// A force or torque beside the handbook's formula.
    pub struct AuditLoad of One("audit-load") asked by AuditLoadFor {
        of_formula: Percent,
    } {
        judgement: Judgement,
    }

    /// A spindle speed that is not the rule's.
    pub struct AuditSpindle of One("audit-spindle") asked by AuditSpindleFor {
        excess: Percent,
    } {
        severity: Severity,
    }
}
