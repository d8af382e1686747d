//! Marks: the points of an audit by a lecturer's scheme.

mod read;
pub mod scheme;

use std::collections::BTreeMap;

use serde::Serialize;

use crate::note::Severity;

use crate::tables::audit::PlanPart;

use super::coverage::Coverage;
use super::finding::{Audit, AuditFinding, Section};
pub use read::read_scheme;
pub use scheme::schema;

/// A marking scheme.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MarkingScheme {
    /// Its name.
    pub name: String,
    /// The maximum of points.
    pub points: f64,
    /// The number of points from which a plan passes.
    pub pass: Option<f64>,
    /// Deductions by severity.
    pub deduct: BySeverity,
    /// The deduction for what follows from another slip.
    pub consequences: f64,
    /// The most that one slip costs with all that follows from it.
    pub slip_at_most: Option<f64>,
    /// Sections with deductions or a cap of their own.
    pub sections: Vec<(Section, SectionScheme)>,
    /// Deductions by the ids of rules.
    pub rules: Vec<(String, BySeverity)>,
    /// What a part of the plan costs where it is missing; none: the shares of the table `audit-shares`.
    pub missing: Option<Vec<(PlanPart, f64)>>,
    /// What the work is to cover; none: what each plan says of itself.
    pub scope: Option<Vec<PlanPart>>,
}

/// Deductions by severity; none where the scheme gives none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[allow(missing_docs)] // the severities
pub struct BySeverity {
    pub error: Option<f64>,
    pub wrong: Option<f64>,
    pub doubtful: Option<f64>,
    pub note: Option<f64>,
}

/// The special rules of a section.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SectionScheme {
    /// Its own deductions.
    pub deduct: BySeverity,
    /// The most that the section can cost.
    pub at_most: Option<f64>,
}

/// Marks of a plan.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Marks {
    /// The name of the scheme.
    pub scheme: String,
    /// Points achieved.
    pub points: f64,
    /// Maximum of points.
    #[serde(rename = "of")]
    pub maximum: f64,
    /// Whether the plan passes, where the scheme gives a limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub passed: Option<bool>,
    /// What is taken off for parts that are missing.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub missing: Vec<MissingPart>,
    /// What the plan itself says that it does not cover, so that nothing is taken off for it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub uncovered: Vec<&'static str>,
    /// The deduction for each finding, in the order of the audit; findings without deduction are listed with the
    /// reason.
    pub deductions: Vec<Deduction>,
}

/// What a part costs that is missing.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MissingPart {
    /// The part, as `scope` names it.
    pub part: &'static str,
    /// How much of it is missing, per cent.
    pub percent: f64,
    /// Points taken off.
    pub points: f64,
}

/// What a finding costs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Deduction {
    /// The field of the finding.
    pub field: String,
    /// Its rule.
    pub rule: String,
    /// Its section.
    pub section: Section,
    /// Its severity.
    pub severity: Severity,
    /// Points taken off.
    pub points: f64,
    /// The entry of the scheme that applies.
    pub by: DeductedBy,
    /// Whether the cap of the section, or too few remaining points, reduced the deduction.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub capped: bool,
}

/// The entry of the scheme that gives a deduction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum DeductedBy {
    /// It follows from another slip.
    Consequence,
    /// Its rule is named.
    Rule,
    /// Its section says so.
    Section,
    /// Its severity.
    Severity,
}

impl BySeverity {
    const fn points(self, severity: Severity) -> Option<f64> {
        match severity {
            Severity::Error => self.error,
            Severity::Wrong => self.wrong,
            Severity::Doubtful => self.doubtful,
            Severity::Note => self.note,
        }
    }
}

impl MarkingScheme {
    /// What the parts of the plan cost that are missing, of the points that are left.
    fn missing(&self, audit: &Audit, left: &mut f64) -> Vec<MissingPart> {
        let asked = |own: &&Coverage| self.scope.as_ref().map_or(own.covered, |scope| scope.contains(&own.part));
        let parts: Vec<&Coverage> = audit.coverage.iter().filter(asked).collect();
        let all: f64 = parts.iter().map(|own| own.share).sum();
        let price = |own: &Coverage| match &self.missing {
            Some(prices) => prices.iter().find(|(part, _)| *part == own.part).map_or(0.0, |(_, points)| *points),
            // Of a part of the whole the shares are that part's.
            None if all > 0.0 => self.points * own.share / all,
            None => 0.0,
        };
        let mut found = Vec::new();
        for own in parts {
            let taken = (price(own) * own.missing).min(*left);
            if taken > 0.0 {
                let (percent, points) = (rounded(own.missing * 100.0), spent_of(left, taken));
                found.push(MissingPart { part: own.part.name(), percent, points });
            }
        }
        found
    }

    /// The marks of an audit. The most specific entry of the scheme applies: rule before section before severity. A
    /// consequence of another slip is charged as a consequence, whatever its rule, unless it is graver than the slip.
    pub fn mark(&self, audit: &Audit) -> Marks {
        let mut left = self.points;
        let missing = self.missing(audit, &mut left);
        let uncovered = audit.coverage.iter().filter(|own| self.scope.is_none() && !own.covered);
        let uncovered = uncovered.map(|own| own.part.name()).collect();
        let mut spent: Vec<(Section, f64)> = Vec::new();
        let mut of_slips: BTreeMap<&str, f64> = BTreeMap::new();
        let mut deductions = Vec::new();
        for finding in &audit.findings {
            let (deduction, by) = self.instead_of_root(finding, audit).unwrap_or_else(|| self.charge(finding));
            let own = self.sections.iter().find(|(section, _)| *section == finding.section).map(|(_, own)| own);
            let before = spent.iter().find(|(section, _)| *section == finding.section).map_or(0.0, |(_, spent)| *spent);
            let room = own.and_then(|own| own.at_most).map_or(f64::INFINITY, |most| most - before);
            // What follows from several slips is counted with the first.
            let slip = of_slips.entry(finding.follows_from.first().unwrap_or(&finding.field)).or_default();
            let room = room.min(self.slip_at_most.map_or(f64::INFINITY, |most| most - *slip));
            let taken = deduction.min(room).min(left).max(0.0);
            *slip += taken;
            let points = spent_of(&mut left, taken);
            spent.retain(|(section, _)| *section != finding.section);
            spent.push((finding.section, before + taken));
            deductions.push(Deduction {
                field: finding.field.clone(),
                rule: finding.rule.clone(),
                section: finding.section,
                severity: finding.severity,
                points,
                by,
                capped: taken < deduction,
            });
        }
        let points = rounded(left);
        let passed = self.pass.map(|pass| points >= pass);
        Marks { scheme: self.name.clone(), points, maximum: self.points, passed, missing, uncovered, deductions }
    }

    /// What the gravest consequence costs of a root that is lighter than it, beyond what the root costs: one slip is paid once, at what it
    /// does. None for any other finding.
    fn instead_of_root(&self, finding: &AuditFinding, audit: &Audit) -> Option<(f64, DeductedBy)> {
        let root = finding.follows_from.first()?;
        let of_root = |one: &&AuditFinding| one.follows_from.is_empty() && finding.follows_from.contains(&one.field);
        let roots: Vec<&AuditFinding> = audit.findings.iter().filter(of_root).collect();
        let gravest = audit.findings.iter().filter(|one| one.follows_from.first() == Some(root));
        let first = gravest.min_by_key(|one| one.severity).is_some_and(|one| std::ptr::eq(one, finding));
        if !first || roots.is_empty() || roots.iter().any(|root| root.severity <= finding.severity) {
            return None;
        }
        let paid = roots.into_iter().map(|root| self.own(root).0).fold(0.0, f64::max);
        let (points, by) = self.own(finding);
        Some((points - paid, by)).filter(|(points, _)| *points > self.consequences)
    }

    fn charge(&self, finding: &AuditFinding) -> (f64, DeductedBy) {
        if !finding.follows_from.is_empty() {
            return (self.consequences, DeductedBy::Consequence);
        }
        self.own(finding)
    }

    /// What a finding costs by itself.
    fn own(&self, finding: &AuditFinding) -> (f64, DeductedBy) {
        let rule = self.rules.iter().find(|(rule, _)| *rule == finding.rule);
        if let Some(points) = rule.and_then(|(_, own)| own.points(finding.severity)) {
            return (points, DeductedBy::Rule);
        }
        let own = self.sections.iter().find(|(section, _)| *section == finding.section);
        if let Some(points) = own.and_then(|(_, own)| own.deduct.points(finding.severity)) {
            return (points, DeductedBy::Section);
        }
        (self.deduct.points(finding.severity).unwrap_or(0.0), DeductedBy::Severity)
    }
}

/// Takes points off what is left; what that is in hundredths. Each is the difference of what is left before and after it, so that what
/// is printed adds up to the whole, as thirds rounded one by one do not.
fn spent_of(left: &mut f64, taken: f64) -> f64 {
    let before = rounded(*left);
    *left -= taken;
    rounded(before - rounded(*left))
}

/// Rounded to hundredths: halves and quarters stay exact, binary noise is removed.
fn rounded(points: f64) -> f64 {
    crate::units::round_to(points, 2)
}
