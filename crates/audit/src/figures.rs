//! Turns the verdicts of the graph into findings: the stated value, the right value, and what else changes because of
//! it.

use crate::note::{Note, Severity};

use super::context::Context;
use super::finding::{AuditFinding, Change, FindingKind, Shown};
use super::graph::{Graph, MOST_MIXTURES, Status, Verdict};
use super::mistakes;
use super::quantity::{Id, Quantity};
use super::stated::StatedFigure;

/// The number of significant digits of figures for people.
const DIGITS: i32 = 5;

/// A finding for every stated figure that is not what it should be.
pub(super) fn findings(context: &Context<'_>, graph: &Graph<'_>) -> Vec<AuditFinding> {
    let verdicts = graph.verdicts();
    let one = |verdict: &Verdict| finding(verdict, verdicts, context, graph);
    let mut findings: Vec<AuditFinding> = verdicts.iter().filter_map(one).collect();
    // What was not tried may be an explanation: who reads the finding is to know.
    for (id, total) in graph.untried() {
        let Some(figure) = context.stated.figure(id) else { continue };
        let note = Note::new("audit-untried").with("tried", MOST_MIXTURES).with("total", total);
        let finding = AuditFinding::new(Severity::Note, Context::section(id), context.field(id), note);
        findings.push(finding.at(&figure.place).about(context.subject(id.scope)));
    }
    findings
}

fn finding(verdict: &Verdict, all: &[Verdict], context: &Context<'_>, graph: &Graph<'_>) -> Option<AuditFinding> {
    let id = verdict.id;
    let figure = context.stated.figure(id)?;
    let formula = graph.formula(id)?;
    let changes = changes(id, all, context);
    let mut is_slip = false;
    let mistake = match &verdict.status {
        Status::Root(severity, _) if *severity < Severity::Note && !context.stated.is_own => {
            mistakes::recognised(context, graph, formula, figure)
        }
        _ => None,
    };
    let (severity, note, roots) = match &verdict.status {
        Status::Fine => return None,
        Status::Root(severity, Some(note)) => (*severity, note.clone(), Vec::new()),
        Status::Root(severity, None) => {
            // A slip of the decimal point or of the sign is recognised by the value from the stated inputs.
            let by_stated = verdict.by_stated.map(|by| nature(figure.value, by)).filter(|own| *own != Nature::Figure);
            let note = Note::new(by_stated.unwrap_or_else(|| nature(figure.value, verdict.right)).code());
            // Later figures use the right value, so it is a misprint.
            let went_on = graph.dependents(id).into_iter().any(|other| {
                context.stated.figure(other).is_some()
                    && all.iter().any(|verdict| verdict.id == other && verdict.status == Status::Fine)
            });
            is_slip = changes.is_empty() && went_on;
            (*severity, if is_slip { note.with("carried", "no") } else { note }, Vec::new())
        }
        Status::Follows(roots) => {
            let fields: Vec<String> = roots.iter().map(|root| context.field(*root)).collect();
            (Severity::Wrong, follows(&fields), fields)
        }
    };
    let mut finding = AuditFinding::new(severity, Context::section(id), context.field(id), note).at(&figure.place);
    if let Some(mistake) = mistake {
        finding.severity = mistake.severity.map_or(finding.severity, |proven| proven.min(finding.severity));
        finding.mistake = Some(mistake.note);
    }
    finding.rule = formula.rule.id.to_owned();
    finding.is_slip = is_slip;
    finding.kind = match verdict.status {
        Status::Follows(_) => FindingKind::Follows(formula.rule),
        _ => FindingKind::Formula(formula.rule),
    };
    finding.source = Some(Note::new(format!("audit-source-{}", formula.rule.id)));
    finding.factor = context.factor(id);
    finding.subject = context.subject(id.scope);
    finding.quantity = Some(id.quantity);
    finding.stated = Some(figure.text.clone());
    // What is only to be known has nothing to be put right.
    finding.right = (severity < Severity::Note).then(|| shown(verdict.right));
    let off = (figure.value - verdict.right) / verdict.right * 100.0;
    let off = off.is_finite().then(|| crate::units::round_to(off, 1));
    // For a value from a series or a count a deviation in per cent means nothing.
    finding.deviation_percent = off.filter(|_| !matches!(verdict.status, Status::Root(_, Some(_))));
    let by_stated = verdict.by_stated.map(shown).filter(|by| Some(by) != finding.right.as_ref());
    finding.by_stated = by_stated.filter(|_| roots.is_empty());
    // A misprinted figure is shown with a figure that was computed from its right value.
    let shown_by = graph.computed_from_right(id).and_then(|other| {
        let formula = graph.formula(other)?;
        Some((all.iter().find(|verdict| verdict.id == other)?, formula))
    });
    let (verdict_of, by) = shown_by.unwrap_or((verdict, formula));
    finding.formula = with_numbers(verdict_of, by.rule.formula, &by.numbers);
    finding.supplied = verdict
        .supplied
        .iter()
        .filter_map(|id| Some(Shown { quantity: id.quantity, value: shown(graph.right(*id)?) }))
        .collect();
    finding.follows_from = roots;
    finding.changes = changes;
    finding.because = graph.because(id);
    Some(finding)
}

/// The figures that follow from a slip.
fn changes(root: Id, all: &[Verdict], context: &Context<'_>) -> Vec<Change> {
    let follows = |verdict: &&Verdict| matches!(&verdict.status, Status::Follows(roots) if roots.contains(&root));
    let change = |verdict: &Verdict| {
        let figure = context.stated.figure(verdict.id)?;
        Some(Change {
            field: context.field(verdict.id),
            quantity: verdict.id.quantity,
            stated: figure.text.clone(),
            right: shown(verdict.right),
        })
    };
    all.iter().filter(follows).filter_map(change).collect()
}

/// The note that a figure is wrong only because others are.
pub(super) fn follows(fields: &[String]) -> Note {
    Note::new("audit-follows").with("fields", fields.join(", "))
}

/// What kind of slip a wrong figure is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Nature {
    /// The decimal point stands elsewhere.
    DecimalPoint,
    /// The sign is the other.
    Sign,
    /// Another figure.
    Figure,
}

impl Nature {
    /// The code of its sentence.
    pub const fn code(self) -> &'static str {
        match self {
            Self::DecimalPoint => "audit-decimal-point",
            Self::Sign => "audit-sign",
            Self::Figure => "audit-figure",
        }
    }
}

/// What kind of slip turns the right value into the stated one.
pub(super) fn nature(stated: f64, right: f64) -> Nature {
    let near = |a: f64, b: f64| (a - b).abs() <= 0.03 * b.abs();
    let moved = |shift: i32| shift != 0 && near(stated, right * libm::pow(10.0, f64::from(shift)));
    if (-4..=4).any(moved) && right != 0.0 {
        Nature::DecimalPoint
    } else if right != 0.0 && near(-stated, right) {
        Nature::Sign
    } else {
        Nature::Figure
    }
}

/// The formula in symbols and with its figures: `n = 1000·V/(π·D) = 1000·30.32/(3.14·6)`.
fn with_numbers(verdict: &Verdict, symbols: &str, numbers: &str) -> String {
    // A copied figure, chosen or given, has no arithmetic to show.
    if matches!(numbers, "" | "{0}") {
        return String::new();
    }
    let mut filled = numbers.to_owned();
    for (at, value) in verdict.inputs.iter().enumerate() {
        // A negative figure needs brackets behind a sign.
        let value = if *value < 0.0 { format!("({})", shown(*value)) } else { shown(*value) };
        filled = filled.replace(&format!("{{{at}}}"), &value);
    }
    let parts = [symbols, &filled, &shown(verdict.right)];
    let mut parts: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    parts.dedup();
    if parts.len() < 2 { String::new() } else { parts.join(" = ") }
}

/// A figure as people read it: five significant digits, no zeros at the end.
pub(super) fn shown(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return "0".to_owned();
    }
    let before = libm::floor(libm::log10(value.abs())) as i32 + 1;
    let places = usize::try_from((DIGITS - before).clamp(0, 4)).unwrap_or(0);
    let text = format!("{value:.places$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A stated figure's own text beside the right value.
pub(super) fn with_right_value(
    finding: AuditFinding,
    figure: &StatedFigure,
    right: impl ToString,
    quantity: Quantity,
) -> AuditFinding {
    let mut finding = finding.at(&figure.place).with_values(&figure.text, right);
    finding.quantity = Some(quantity);
    finding
}

#[cfg(test)]
mod tests {
    use super::{Nature, nature, shown};

    #[test]
    fn five_digits_are_shown() {
        for (value, text) in
            [(1608.333, "1608.3"), (27.456, "27.456"), (0.195, "0.195"), (-50.0, "-50"), (12345.6, "12346")]
        {
            assert_eq!(shown(value), text);
        }
    }

    #[test]
    fn a_slip_of_the_comma_is_told_from_another() {
        assert_eq!(nature(0.1235, 1.235), Nature::DecimalPoint);
        assert_eq!(nature(2746.0, 27.456), Nature::DecimalPoint);
        assert_eq!(nature(2.0, 0.195), Nature::DecimalPoint);
        assert_eq!(nature(50.0, -50.0), Nature::Sign);
        assert_eq!(nature(977.0, 937.0), Nature::Figure);
    }
}
