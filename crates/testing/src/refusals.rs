//! What becomes of the holes of the grid, told as a table of refusals by their limits.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use technolog::note::Severity;
use technolog::plan::CuttingMethod;
use technolog::words::Lang;

use crate::grid::GridHole;

/// The limits of tools and machine that refuse a hole, the plainest first: of several that a plan names, the first counts.
pub const LIMITS: [&str; 16] = [
    "drills-too-short",
    "assembly-too-long",
    "assembly-too-heavy",
    "does-not-reach",
    "no-bar-enters",
    "bar-does-not-enter",
    "stands-out-too-little",
    "not-proven",
    "too-shallow-for-flat",
    "no-mill-enters",
    "mill-too-large",
    "no-drill-so-large",
    "no-drill-before-boring",
    "no-cutter-of-size",
    "no-drill",
    "no-path",
];

/// What becomes of a hole.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Planned to the end on this machine.
    Planned,
    /// Planned here, finished on another machine.
    LeftElsewhere,
    /// Planned, but something of the drawing is not held.
    Wanting(String),
    /// Refused here, and planned without an error on another machine, which the plan names.
    OtherMachine {
        /// The id of that machine.
        machine: String,
        /// The code of the limit of this machine.
        limit: String,
    },
    /// Refused: the code of the limit, its sentence, and what is possible beside it.
    Refused {
        /// The code of the limit.
        limit: String,
        /// Its sentence.
        why: String,
        /// The nearest possible hole.
        nearest: Option<String>,
    },
}

/// Plans a hole of the grid.
pub fn verdict(hole: &GridHole) -> Verdict {
    let plan = crate::planned(&crate::read(&hole.part()), CuttingMethod::Formula);
    let errors = plan.findings.iter().filter(|finding| finding.severity <= Severity::Wrong);
    let errors: Vec<_> = errors.map(|finding| &finding.note).collect();
    let own = &plan.holes[0];
    if own.route.is_none() {
        let of_limit = |limit: &&str| errors.iter().find(|note| note.code() == *limit);
        let why = LIMITS.iter().find_map(of_limit).or(errors.first());
        let limit_code = why.map_or_else(String::new, |note| note.code().to_owned());
        let named = plan.findings.iter().filter(|finding| finding.note.code() == "nearest-machine");
        for machine in named.filter_map(|finding| finding.note.figure_text("machine")) {
            let there = hole.part().replace("machine: gf2171", &format!("machine: {machine}"));
            let plan = crate::planned(&crate::read(&there), CuttingMethod::Formula);
            if !plan.has_errors() {
                return Verdict::OtherMachine { machine, limit: limit_code };
            }
        }
        let is_near = |code: &str| code.starts_with("nearest-") && code != "nearest-machine";
        let nearest = plan.findings.iter().find(|finding| is_near(finding.note.code()));
        return Verdict::Refused {
            limit: limit_code,
            why: why.map_or_else(String::new, |note| Lang::EN.say(note)),
            nearest: nearest.map(|finding| Lang::EN.say(&finding.note)),
        };
    }
    match errors.first() {
        Some(note) => Verdict::Wanting(Lang::EN.say(note)),
        None if own.transitions.iter().any(|step| step.elsewhere) => Verdict::LeftElsewhere,
        None => Verdict::Planned,
    }
}

/// A table of refusals by their limits, in Markdown.
pub fn table(outcomes: &[(GridHole, Verdict)]) -> String {
    let count = |is: fn(&Verdict) -> bool| outcomes.iter().filter(|(_, verdict)| is(verdict)).count();
    let refused = count(|verdict| matches!(verdict, Verdict::Refused { .. }));
    let share = |part: usize| 100.0 * part as f64 / outcomes.len().max(1) as f64;
    let (planned, left) = (count(|it| *it == Verdict::Planned), count(|it| *it == Verdict::LeftElsewhere));
    let other = count(|verdict| matches!(verdict, Verdict::OtherMachine { .. }));
    let wanting = outcomes.len() - refused - planned - left - other;
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{} holes: {planned} planned here, {left} finished on another machine, {wanting} planned with a requirement that is not held,\n\
         {other} beyond this machine and planned on another one that the plan names ({:.1} %), {refused} refused ({:.1} %).\n",
        outcomes.len(),
        share(other),
        share(refused)
    );
    let mut limits: BTreeMap<&str, Vec<(&GridHole, &Verdict)>> = BTreeMap::new();
    for (hole, verdict) in outcomes {
        if let Verdict::Refused { limit, .. } = verdict {
            limits.entry(limit).or_default().push((hole, verdict));
        }
    }
    let mut limits: Vec<_> = limits.into_iter().collect();
    limits.sort_by(|a, b| b.1.len().cmp(&a.1.len()).then(a.0.cmp(b.0)));
    text.push_str("| limit | holes | for example | what it says | nearest |\n|---|---|---|---|---|\n");
    for (limit, holes) in limits {
        let Some((hole, Verdict::Refused { why, nearest, .. })) = holes.get(holes.len() / 2) else { continue };
        let nearest = nearest.as_deref().unwrap_or("–");
        let _ = writeln!(text, "| `{limit}` | {} | {hole} | {why} | {nearest} |", holes.len());
    }
    text
}

/// A page with the section under a heading replaced.
///
/// # Panics
/// The page has no such heading.
pub fn replaced(page: &str, heading: &str, section: &str) -> String {
    let start = page.find(heading).unwrap_or_else(|| panic!("no {heading}")) + heading.len();
    let end = page[start..].find("\n## ").map_or(page.len(), |end| start + end);
    let behind = &page[end..];
    format!("{}\n\n{}\n{behind}", &page[..start], section.trim_end())
}
