//! The scheme of a group of holes: whether the tables allow it, whether the rows are its transitions, and how it ranks
//! beside the others.

use crate::error::KnowledgeError;
use crate::knowledge::Source;
use crate::note::{Because, Figure, Note, Severity};
use crate::part::Hole;
use crate::plan::{Alternative, Operation, Route, RouteSource, Transition};
use crate::route::table_answer::{self, TableAnswer};
use crate::tables::audit::PlanPart;
use crate::tables::holes::HoleDefault;
use crate::units::{Micrometres, round_to};

use super::super::context::Context;
use super::super::finding::{AuditFinding, Section};
use super::super::graph::Graph;
use super::super::near::{same_scheme, same_table};
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::stated::{Row, Text};
use super::route::hole_subject;

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    for hole in context.stated.part.holes.iter().filter(|hole| hole.slot.is_none()) {
        let rows: Vec<(usize, &Row)> = context.stated.rows_of_hole(&hole.name).collect();
        let Some(plan) = context.plan.holes.iter().find(|plan| plan.name == hole.name) else { continue };
        let (Some((_, first)), Some(route)) = (rows.first(), &plan.route) else { continue };
        let here = |made: &&Transition| made.operation.is_of_scheme(made.elsewhere);
        let ours = plan.transitions.iter().filter(here).map(|transition| transition.operation).collect();
        let answer = table_answer::ask(hole, &context.stated.part, &context.shop)?;
        let group = Group { context, graph, hole, route, rows: &rows, first, ours, answer };
        group.check(findings)?;
    }
    Ok(())
}

/// A group of holes with its stated rows and the program's route.
struct Group<'c, 'a> {
    context: &'c Context<'a>,
    graph: &'c Graph<'a>,
    hole: &'c Hole,
    route: &'c Route,
    rows: &'c [(usize, &'c Row)],
    first: &'c Row,
    /// The transitions of the program's plan.
    ours: Vec<Operation>,
    /// The answer of the tables, before any scheme is tried.
    answer: TableAnswer<'a>,
}

impl Group<'_, '_> {
    fn check(&self, findings: &mut Vec<AuditFinding>) -> Result<(), KnowledgeError> {
        let scheme = self.rows.iter().find_map(|(_, row)| row.scheme.as_ref());
        if !self.names(findings)? {
            return Ok(());
        }
        self.tables(findings);
        if self.is_whole() { self.transitions(scheme, findings) } else { Ok(()) }
    }

    /// Whether the rows are all transitions of the scheme: a plan that does not cover the route may lack some of them.
    fn is_whole(&self) -> bool {
        self.context.stated.covers(PlanPart::Holes)
    }

    /// The row that names a scheme first; the first row where none does.
    fn named(&self) -> &Row {
        self.rows.iter().map(|(_, row)| *row).find(|row| row.scheme.is_some()).unwrap_or(self.first)
    }

    /// Whether the program's route, or a candidate compared with it, has that scheme; 1 of A.5 is a complex, not
    /// scheme 01.
    fn weighed(&self, scheme: &str) -> bool {
        let is =
            |own: &str, source: RouteSource| own == scheme || source == RouteSource::Tables && same_scheme(scheme, own);
        is(&self.route.scheme, self.route.source)
            || self.route.alternatives.iter().any(|other| is(&other.scheme, other.source))
    }

    /// Whether the hole's own cell of the tables has that scheme.
    fn printed(&self, scheme: &str) -> bool {
        self.answer.schemes.iter().any(|own| same_scheme(scheme, own))
    }

    fn finding(&self, severity: Severity, row: &Row, key: &str, note: Note) -> AuditFinding {
        self.finding_of(severity, row, key, note, (&self.route.scheme, &self.route.table))
    }

    /// A finding that names another scheme than that of the program's route.
    fn finding_of(
        &self,
        severity: Severity,
        row: &Row,
        key: &str,
        note: Note,
        (scheme, table): (&str, &str),
    ) -> AuditFinding {
        let stated = if key == "table" { &row.table } else { &row.scheme };
        let place = stated.as_ref().map_or(&row.place, |text| &text.place);
        let note = note.with("way", way(self.route.source)).with("scheme", Figure::scheme(scheme)).with("table", table);
        let finding =
            AuditFinding::new(severity, Section::Route, format!("route.{}.{key}", row.number), note).at(place);
        finding.about(hole_subject(self.hole)).resting_on(self.route.because.iter().take(3).cloned())
    }

    /// Checks every scheme that a row names: whether the tables permit it, and whether the other rows name the same.
    /// Returns whether the transitions must still be judged.
    fn names(&self, findings: &mut Vec<AuditFinding>) -> Result<bool, KnowledgeError> {
        let mut reported: Vec<&str> = Vec::new();
        // The scheme of the group: the first permitted one that rows name.
        let schemes = || self.rows.iter().filter_map(|(_, row)| Some((*row, row.scheme.as_ref()?)));
        let own = schemes().map(|(_, scheme)| &scheme.value).find(|name| self.weighed(name) || self.printed(name));
        let mut judged = true;
        for (row, scheme) in schemes() {
            let name = scheme.value.as_str();
            if reported.iter().any(|known| same_scheme(known, name)) {
                continue;
            }
            reported.push(name);
            if self.weighed(name) {
                if let Some(own) = own.filter(|own| !same_scheme(own, name)) {
                    let note = Note::new("audit-scheme-mixed").with("stated", name).with("other", own);
                    findings.push(self.finding(Severity::Wrong, row, "scheme", note).with_values(name, own));
                }
            } else if self.printed(name) && self.answer.centred && (self.centres() || !self.is_whole()) {
                // Written as its table prints it, and carried out with the centring that the text asks for.
            } else if self.printed(name) && self.answer.centred {
                findings.push(self.uncentred(row, name)?);
                let of_scheme = table_answer::transitions(&full(name), &self.context.shop)?;
                judged &= !self.is_ours() && of_scheme.is_none_or(|own| main(&own) != main(&self.stated()));
            } else if !self.printed(name) {
                let note = Note::new("audit-scheme-unknown").with("stated", name);
                findings.push(self.finding(Severity::Wrong, row, "scheme", note).with_values(name, &self.route.scheme));
                // If the scheme is not permitted, its transitions are not judged as well.
                judged &= own.is_some();
            }
        }
        Ok(judged)
    }

    /// Whether the rows begin with centring.
    fn centres(&self) -> bool {
        self.stated().first() == Some(&Operation::CentreDrill)
    }

    /// Whether a stated scheme is that one, or its form without the centring that the rows have.
    fn means(&self, stated: &str, own: &str) -> Result<bool, KnowledgeError> {
        if same_scheme(stated, own) {
            return Ok(true);
        }
        let uncentred = self.answer.centred && self.centres() && self.printed(stated);
        Ok(uncentred && same_scheme(&table_answer::centred(&full(stated), &self.context.shop)?, own))
    }

    /// The cell has the scheme, but the hole is centred first: by the text, or only by the program's reading of it. Right is the form of
    /// that scheme with its centring, whatever the program's route is.
    fn uncentred(&self, row: &Row, name: &str) -> Result<AuditFinding, KnowledgeError> {
        let by_text = self.answer.centring.source == Some(Source::Seed);
        let severity = if by_text { Severity::Wrong } else { Severity::Doubtful };
        let printed = self.answer.row.map_or_else(String::new, |row| row.table.id.clone());
        let note = Note::new("audit-scheme-uncentred").with("stated", name).with("printed", printed);
        let centred = table_answer::centred(&full(name), &self.context.shop)?;
        let mut finding =
            self.finding_of(severity, row, "scheme", note, (&centred, SCHEMES)).with_values(name, &centred);
        finding.because.clear();
        finding.because.extend(self.answer.row.map(|row| Because::row(row, Note::new("named"))));
        finding.because.push(self.answer.centring.clone());
        Ok(finding)
    }

    /// Checks every table that a row names with its scheme.
    fn tables(&self, findings: &mut Vec<AuditFinding>) {
        let mut reported: Vec<(&str, &str)> = Vec::new();
        for (_, row) in self.rows {
            let (Some(scheme), Some(table)) = (&row.scheme, &row.table) else { continue };
            let pair = (scheme.value.as_str(), table.value.as_str());
            let fits = |(own, stands): (&str, &str)| same_scheme(pair.0, own) && same_table(pair.1, stands);
            let printed = self.answer.row.is_some_and(|row| same_table(pair.1, &row.table.id)) && self.printed(pair.0);
            let known = printed
                || fits((&self.route.scheme, &self.route.table))
                || self.route.alternatives.iter().any(|other| fits((&other.scheme, &other.table)));
            if known || reported.contains(&pair) || !self.weighed(pair.0) {
                continue;
            }
            reported.push(pair);
            let note = Note::new("audit-scheme-table").with("stated", &table.value);
            findings
                .push(self.finding(Severity::Wrong, row, "table", note).with_values(&table.value, &self.route.table));
        }
    }

    /// The stated transitions, with the thread that another machine cuts where this one cannot.
    fn stated(&self) -> Vec<Operation> {
        // What finishes the hole on another machine is no transition of the scheme.
        let here = |row: &&(usize, &Row)| row.1.operation.value.is_of_scheme(row.1.elsewhere);
        let mut stated: Vec<Operation> = self.rows.iter().filter(here).map(|(_, row)| row.operation.value).collect();
        if self.hole.thread.is_some() && !self.context.shop.machine.can_tap && !stated.contains(&Operation::Tap) {
            stated.push(Operation::Tap);
        }
        stated
    }

    fn is_ours(&self) -> bool {
        main(&self.stated()) == main(&self.ours)
    }

    /// Compares the transitions with the candidates of the program, and with those that A.7 gives for the scheme.
    fn transitions(&self, scheme: Option<&Text>, findings: &mut Vec<AuditFinding>) -> Result<(), KnowledgeError> {
        // Edges are judged in another check; here only whether the scheme has them as the rows do, where the
        // program's plan differs.
        let merged = self.is_ours();
        if merged && self.is_of_other_transitions(scheme, findings)? {
            return Ok(());
        }
        if merged && (self.context.stated.is_own || !self.has_edges_of(scheme)?) {
            return Ok(());
        }
        let stated = self.stated();
        let row = self.named();
        let [names, ours] = [&stated, &self.ours]
            .map(|list| list.iter().map(|operation| operation.name()).collect::<Vec<_>>().join(", "));
        let figure = |list: &[Operation]| Figure::operations(list.iter().map(|operation| operation.name()));
        let finding = |severity, note: Note| {
            self.finding(
                severity,
                row,
                "scheme",
                note.with("transitions", figure(&stated)).with("better", figure(&self.ours)),
            )
            .with_values(&names, &ours)
        };
        let alike = |other: &Alternative| {
            let here = other.operations.iter().filter(|made| made.operation.is_of_scheme(made.elsewhere));
            main(&here.map(|made| made.operation).collect::<Vec<_>>()) == main(&stated)
        };
        let others = || self.route.alternatives.iter().enumerate();
        let ranked = others().find(|(_, other)| alike(other) && can_be(other)).filter(|_| !merged);
        if let Some((rank, other)) = ranked {
            let (severity, note) = self.dominated(rank, other)?;
            findings.push(finding(severity, note));
            return Ok(());
        }
        if let Some(given) = self.word_for_word(&stated, scheme)? {
            if let Some(alone) = self.drill_alone()? {
                findings.push(alone);
                return Ok(());
            }
            let own = scheme.map_or(given.as_str(), |scheme| scheme.value.as_str());
            let other = others().find(|(_, other)| same_scheme(own, &other.scheme) && can_be(other));
            let same = self.means(own, &self.route.scheme)?;
            findings.push(match other.filter(|_| !same) {
                Some((rank, other)) => {
                    let (severity, note) = self.dominated(rank, other)?;
                    finding(severity, note)
                }
                None => {
                    let severity = if same { Severity::Note } else { Severity::Doubtful };
                    finding(severity, Note::new("audit-route-by-scheme").with("stated", own).with("printed", SCHEMES))
                }
            });
            return Ok(());
        }
        let refused = others().find(|(_, other)| alike(other));
        let code = if refused.is_some() { "audit-route-refused" } else { "audit-route-unknown" };
        let mut finding = finding(Severity::Wrong, Note::new(code));
        finding.reasons.extend(refused.map(|(_, other)| other.why.clone()));
        findings.push(finding);
        Ok(())
    }

    /// A route that takes longer is in doubt, one within the share of a near tie is as good.
    fn dominated(&self, rank: usize, other: &Alternative) -> Result<(Severity, Note), KnowledgeError> {
        let slower = other.time_min.map_or(0.0, |time| time.0 - self.route.time_min.0);
        let near_tie = self.context.shop.share(HoleDefault::NearTieShare)?;
        let (severity, code) = if slower <= near_tie * self.route.time_min.0 {
            (Severity::Note, "audit-route-as-good")
        } else {
            (Severity::Doubtful, "audit-route-dominated")
        };
        Ok((severity, Note::new(code).with("rank", rank + 2).with("slower", round_to(slower, 2))))
    }

    /// The scheme whose transitions by A.7 the rows are: the one that they name, or, where they name none, a permitted
    /// one. Two drills count as one drilling.
    fn word_for_word(&self, stated: &[Operation], scheme: Option<&Text>) -> Result<Option<String>, KnowledgeError> {
        // What the search finds is a scheme of A.7, too, where it does no more than that one.
        let by_name = |source, table: &str| source == RouteSource::Tables || same_table(table, SCHEMES);
        let mut schemes: Vec<&str> = Vec::new();
        schemes.extend(Some(self.route.scheme.as_str()).filter(|_| by_name(self.route.source, &self.route.table)));
        let of_tables = self.route.alternatives.iter().filter(|other| {
            by_name(other.source, &other.table) && (can_be(other) || other.source == RouteSource::Tables && other.meets)
        });
        schemes.extend(of_tables.map(|other| other.scheme.as_str()));
        let printed = |own: &String| match self.answer.centred {
            true => table_answer::centred(own, &self.context.shop),
            false => Ok(own.clone()),
        };
        let printed: Vec<String> = self.answer.schemes.iter().map(printed).collect::<Result<_, _>>()?;
        schemes.extend(printed.iter().map(String::as_str));
        for name in schemes {
            if let Some(scheme) = scheme
                && !self.means(&scheme.value, name)?
            {
                continue;
            }
            let given = table_answer::transitions(&full(name), &self.context.shop)?;
            let own = drilled_once(&main(stated));
            // A centring that the scheme does not ask for makes no hole worse.
            let more = own.split_first().filter(|(first, _)| **first == Operation::CentreDrill).map(|(_, rest)| rest);
            let is = |given: Vec<Operation>| main(&given) == own || more.is_some_and(|rest| main(&given) == rest);
            if given.is_some_and(is) {
                return Ok(Some(name.to_owned()));
            }
        }
        Ok(None)
    }

    /// Whether the rows are a right route, and the scheme that they name another one of the same cell.
    fn is_of_other_transitions(
        &self,
        scheme: Option<&Text>,
        findings: &mut Vec<AuditFinding>,
    ) -> Result<bool, KnowledgeError> {
        let Some(scheme) = scheme.filter(|_| !self.context.stated.is_own) else { return Ok(false) };
        if self.means(&scheme.value, &self.route.scheme)? || !self.weighed(&scheme.value) {
            return Ok(false);
        }
        let Some(given) = table_answer::transitions(&full(&scheme.value), &self.context.shop)? else {
            return Ok(false);
        };
        let [given, own] = [main(&given), main(&self.stated())].map(|list| drilled_once(&list));
        // A centring more or less is another check's.
        let bare = |list: &[Operation]| -> Vec<Operation> {
            list.iter().copied().filter(|operation| *operation != Operation::CentreDrill).collect()
        };
        if bare(&given) == bare(&own) || own.len() >= given.len() {
            return Ok(false);
        }
        let figure = |list: &[Operation]| Figure::operations(list.iter().map(|operation| operation.name()));
        let note = Note::new("audit-scheme-transitions").with("stated", &*scheme.value);
        let note = note.with("printed", figure(&given)).with("transitions", figure(&own));
        let finding = self.finding(Severity::Wrong, self.named(), "scheme", note);
        findings.push(finding.with_values(&scheme.value, &self.route.scheme));
        Ok(true)
    }

    /// Whether the rows cut the edges that A.7 gives for the scheme, while the program's plan cuts them with another
    /// tool.
    fn has_edges_of(&self, scheme: Option<&Text>) -> Result<bool, KnowledgeError> {
        let edges = |list: &[Operation]| list.iter().filter(|operation| operation.is_of_edge()).count();
        let Some(scheme) = scheme else { return Ok(false) };
        let given = table_answer::transitions(&full(&scheme.value), &self.context.shop)?;
        let stated = edges(&self.stated());
        Ok(stated != edges(&self.ours) && given.is_some_and(|given| edges(&given) == stated))
    }

    /// A single drill where the rule `two-pass-drilling` requires two.
    fn drill_alone(&self) -> Result<Option<AuditFinding>, KnowledgeError> {
        if self.rows.iter().any(|(_, row)| row.operation.value == Operation::DrillOut) {
            return Ok(None);
        }
        let Some((at, row)) = self.rows.iter().find(|(_, row)| row.operation.value == Operation::Drill) else {
            return Ok(None);
        };
        let Some(diameter) = self.graph.stated_or_right(Id::new(Scope::Row(*at), Q::Diameter)) else { return Ok(None) };
        let diameter = Micrometres::from_mm_rounded(diameter);
        let Some(rule) = table_answer::two_drills(diameter, &self.context.shop)? else { return Ok(None) };
        let note = Note::new("audit-one-drill").with("diameter", diameter);
        let field = format!("route.{}.operation", row.number);
        let finding = AuditFinding::new(Severity::Wrong, Section::Route, field, note).at(&row.operation.place);
        let because = Because::row(rule, Note::new("named"));
        Ok(Some(finding.about(self.context.subject(Scope::Row(*at))).resting_on([because])))
    }
}

/// The table of the schemes with their transitions.
const SCHEMES: &str = "A.7";

/// Whether a route can be carried out. What the tables leave to another machine has no time to compare.
fn can_be(other: &Alternative) -> bool {
    other.meets && (other.time_min.is_some() || other.finishes_elsewhere())
}

/// A scheme as A.7 numbers it: two digits.
fn full(scheme: &str) -> String {
    if scheme.starts_with(|first: char| first.is_ascii_digit()) && !scheme.starts_with('0') && scheme.len() == 1 {
        format!("0{scheme}")
    } else {
        scheme.to_owned()
    }
}

/// The transitions without those of edges.
fn main(list: &[Operation]) -> Vec<Operation> {
    list.iter().copied().filter(|operation| !operation.is_of_edge()).collect()
}

/// The transitions with one drilling in place of two in a row.
fn drilled_once(list: &[Operation]) -> Vec<Operation> {
    let mut once: Vec<Operation> = Vec::new();
    for operation in list {
        if !(*operation == Operation::DrillOut && once.last() == Some(&Operation::Drill)) {
            once.push(*operation);
        }
    }
    once
}

/// What a sentence calls a route of that source.
const fn way(source: RouteSource) -> &'static str {
    match source {
        RouteSource::Tables => "table",
        RouteSource::Complexes => "complex",
        RouteSource::Search => "search",
    }
}
