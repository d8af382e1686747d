//! A class side by side: whose each work is, which mistakes its works make most, and which of them share figures that nobody else has.

use std::collections::{BTreeMap, BTreeSet};

use crate::note::{Note, Severity};
use crate::tables::audit::Threshold;

use super::auditor::Auditor;
use super::finding::{Audit, AuditFinding};
use super::many::Audited;
use super::stated::Author;

impl Author {
    /// What the plan does not say, by the name of its file: `Коваль_Іван_ТМ-31_7.yaml`. A part with letters and digits is the group, one of
    /// digits the variant, the others are the name.
    #[must_use]
    pub fn or_by_file(mut self, file: &str) -> Self {
        let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
        let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
        let parts: Vec<&str> = stem.split('_').filter(|part| !part.is_empty()).collect();
        if parts.len() < 2 {
            return self;
        }
        let digits = |part: &str| part.chars().any(|sign| sign.is_ascii_digit());
        let number = |part: &str| part.bytes().all(|sign| sign.is_ascii_digit());
        let variant = |part: &str| part.trim_start_matches(|sign: char| sign.is_alphabetic()).to_owned();
        let of_variant = |part: &&str| {
            number(part) || part.chars().take(1).all(|sign| "vVвВ".contains(sign)) && number(&variant(part))
        };
        let found = parts.iter().copied().find(of_variant);
        self.variant = self.variant.or_else(|| found.map(variant));
        self.group = self
            .group
            .or_else(|| parts.iter().find(|part| digits(part) && Some(**part) != found).map(|part| (*part).to_owned()));
        let names: Vec<&str> = parts.iter().copied().filter(|part| !digits(part)).collect();
        self.student = self.student.or_else(|| (!names.is_empty()).then(|| names.join(" ")));
        self
    }
}

/// A mistake of a class.
#[derive(Clone, Debug)]
pub struct Common<'a> {
    /// One finding of it, to tell it by.
    pub example: &'a AuditFinding,
    /// The works that make it, by their places in the list.
    pub works: Vec<usize>,
}

/// The mistakes that more than one work makes, the most frequent first: roots only, told apart by their rule, their figure and the usual
/// mistake behind them.
pub fn common(audited: &[Audited]) -> Vec<Common<'_>> {
    let mut mistakes: BTreeMap<(String, String), Common<'_>> = BTreeMap::new();
    for (at, audit) in works(audited) {
        let mut seen = BTreeSet::new();
        for finding in roots(audit) {
            let quantity = finding.quantity.map(|quantity| quantity.key()).unwrap_or_default();
            let mistake = finding.mistake.as_ref().map(Note::to_string).unwrap_or_default();
            let key = (finding.rule.clone(), format!("{quantity} {mistake}"));
            if !seen.insert(key.clone()) {
                continue;
            }
            mistakes.entry(key).or_insert_with(|| Common { example: finding, works: Vec::new() }).works.push(at);
        }
    }
    let mut common: Vec<Common<'_>> = mistakes.into_values().filter(|one| one.works.len() > 1).collect();
    common.sort_by_key(|one| std::cmp::Reverse(one.works.len()));
    common
}

/// Two works with the same unusual figures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Alike {
    /// The works, by their places in the list.
    pub works: (usize, usize),
    /// The figures: what they are, and as both state them.
    pub figures: Vec<(String, String)>,
}

/// Pairs of works that state the same wrong figures which hardly any other work states, by the table `audit-thresholds`. A wrong figure that follows from another counts,
/// too: it was copied with it or computed from it.
pub fn alike(audited: &[Audited], auditor: &Auditor<'_>) -> Vec<Alike> {
    let mut stated: BTreeMap<(String, String), Vec<usize>> = BTreeMap::new();
    for (at, audit) in works(audited) {
        for finding in audit.findings.iter().filter(|finding| finding.is_wrong() && finding.quantity.is_some()) {
            let Some(own) = finding.stated.clone() else { continue };
            let works = stated.entry((finding.field.clone(), own)).or_default();
            if works.last() != Some(&at) {
                works.push(at);
            }
        }
    }
    let share = auditor.threshold(Threshold::AlikeShare) * audited.len() as f64;
    let most = auditor.threshold(Threshold::AlikeWorks).max(share);
    let mut pairs: BTreeMap<(usize, usize), Vec<(String, String)>> = BTreeMap::new();
    for (figure, works) in stated.into_iter().filter(|(_, works)| works.len() as f64 <= most) {
        for (at, one) in works.iter().enumerate() {
            for other in works.iter().skip(at + 1) {
                pairs.entry((*one, *other)).or_default().push(figure.clone());
            }
        }
    }
    let alike =
        pairs.into_iter().filter(|(_, figures)| figures.len() as f64 >= auditor.threshold(Threshold::AlikeFigures));
    let mut alike: Vec<Alike> = alike.map(|(works, figures)| Alike { works, figures }).collect();
    alike.sort_by_key(|one| std::cmp::Reverse(one.figures.len()));
    alike
}

fn works(audited: &[Audited]) -> impl Iterator<Item = (usize, &Audit)> {
    audited.iter().enumerate().filter_map(|(at, one)| Some((at, one.audit()?)))
}

/// What is wrong by itself.
fn roots(audit: &Audit) -> impl Iterator<Item = &AuditFinding> {
    audit.findings.iter().filter(|finding| finding.severity <= Severity::Wrong && finding.follows_from.is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_says_whose_work_it_is() {
        let of = |file: &str| {
            let author = Author::default().or_by_file(file);
            [author.student, author.group, author.variant].map(Option::unwrap_or_default)
        };
        assert_eq!(of("роботи/Коваль_Іван_ТМ-31_7.yaml"), ["Коваль Іван", "ТМ-31", "7"]);
        assert_eq!(of("ТМ-31_Коваль_в12.xlsx"), ["Коваль", "ТМ-31", "12"]);
        assert_eq!(of("plan.yaml"), ["", "", ""]);
        let said = Author { student: Some("Шевчук".to_owned()), ..Author::default() };
        assert_eq!(said.or_by_file("Коваль_7.yaml").student.as_deref(), Some("Шевчук"));
    }
}
