//! Dimensions of tools and holders by their catalogs, lengths of assemblies, corrections.

use crate::error::KnowledgeError;
use crate::note::{Because, Note, Severity};
use crate::plan::Operation;
use crate::tables::audit::AuditOverhangFor;
use crate::tables::tools::CutterRow;
use crate::tooling::named;
use crate::units::Micrometres;

use super::super::context::Context;
use super::super::figures::nature;
use super::super::graph::{Formula, Graph, Judge, Rule, Status};
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::super::stated::Row;
use super::{by_its_text, equal_figures, fixed_figure, largest};

const DIMENSION: Rule = Rule { id: "tool-dimension", formula: "" };
const HOLDER: Rule = Rule { id: "holder-dimension", formula: "" };
const OVERHANG: Rule = Rule { id: "overhang", formula: "lв" };
const HOLDER_USED: Rule = Rule { id: "one-holder-length", formula: "lопр" };
const ASSEMBLY: Rule = Rule { id: "assembly-length", formula: "Lк = lв + lопр" };
const REFERENCE: Rule = Rule { id: "reference-tool", formula: "Lет = max Lк" };
const PLUS: Rule = Rule { id: "correction", formula: "K = Lк − Lет" };
const MINUS: Rule = Rule { id: "correction-g44", formula: "K = Lет − Lк" };
const BOOK: Rule = Rule { id: "book-correction", formula: "K = Lет − Lк" };

pub(super) const RULES: &[Rule] = &[DIMENSION, HOLDER, OVERHANG, HOLDER_USED, ASSEMBLY, REFERENCE, PLUS, MINUS, BOOK];

/// The dimensions of a cutter that its catalog states.
pub(crate) fn dimensions(row: &CutterRow<'_>) -> [(Q, Option<Micrometres>); 5] {
    [
        (Q::Diameter, row.diameter),
        (Q::Length, row.length),
        (Q::FluteLength, row.flute_length),
        (Q::Projection, row.projection),
        (Q::ShankDiameter, row.shank_diameter),
    ]
}

/// Whether the cutter of a transition may be ground, or set, to another diameter than that of its catalog.
pub(crate) const fn may_be_ground(operation: Option<Operation>) -> bool {
    !matches!(operation, Some(Operation::Drill | Operation::DrillOut | Operation::CentreDrill))
}

pub(super) fn add<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>) -> Result<(), KnowledgeError> {
    let stated = context.stated;
    for (at, tool) in stated.tools.iter().enumerate() {
        let scope = Scope::Tool(at);
        let id = |quantity| Id::new(scope, quantity);
        let operation = stated.rows_of_tool(tool.number).next().map(|(_, row)| row.operation.value);
        if let Some(cutter) = context.cutter(at) {
            let because = || [Because::row(cutter.row.row, Note::new("named"))];
            for (quantity, length) in dimensions(&cutter.row) {
                let Some(length) = length else { continue };
                // A core drill or reamer may be ground, and a bar set, to the size of its row.
                let set = quantity == Q::Diameter && may_be_ground(operation);
                if set && stated.is_own {
                    continue;
                }
                let mut dimension = fixed_figure(&DIMENSION, id(quantity), length.to_mm(), because());
                if set {
                    let rows: Vec<usize> = sized_rows(context, tool.number).map(|(row, _)| row).collect();
                    dimension.inputs = rows.iter().map(|row| Id::new(Scope::Row(*row), Q::Diameter)).collect();
                    dimension.judge = Some(ground(context, tool.number, length));
                }
                graph.add(dimension);
            }
            if let Some(morse) = cutter.row.morse {
                graph.add(fixed_figure(&DIMENSION, id(Q::Morse), morse as f64, because()));
            }
            if let Some(angle) = named::point_angle(cutter) {
                graph.add(fixed_figure(&DIMENSION, id(Q::PointAngle), angle, because()));
            }
            if let Some(operation) = operation {
                overhang(context, graph, at, cutter, operation)?;
            }
        }
        if let Some(holder) = context.holder(at) {
            let because = || [Because::row(holder.row, Note::new("named"))];
            let lengths = [
                (Q::HolderLength, Some(holder.length)),
                (Q::ClampMin, holder.clamp_min),
                (Q::ClampMax, holder.clamp_max),
            ];
            for (quantity, length) in lengths {
                if let Some(length) = length {
                    graph.add(fixed_figure(&HOLDER, id(quantity), length.to_mm(), because()));
                }
            }
            if let Some(morse) = holder.morse {
                graph.add(fixed_figure(&HOLDER, id(Q::HolderMorse), morse as f64, because()));
            }
        }
        graph.add(equal_figures(&HOLDER_USED, id(Q::HolderUsed), id(Q::HolderLength)));
        let (overhang, holder) = (id(Q::Overhang), id(Q::HolderUsed));
        // The overhang of a cutter with the taper of the machine is its whole length.
        if context.has_machine_taper(at) {
            graph.add(equal_figures(&ASSEMBLY, id(Q::Assembly), overhang));
        } else {
            graph.add(by_its_text(&ASSEMBLY, id(Q::Assembly), vec![overhang, holder]));
        }
        corrections(context, graph, at);
    }
    Ok(())
}

/// The rows of a tool that state their diameter.
fn sized_rows<'a>(context: &'a Context<'a>, tool: u32) -> impl Iterator<Item = (usize, &'a Row)> {
    context.stated.rows_of_tool(tool).filter(|(_, row)| row.figures.contains_key(&Q::Diameter))
}

/// Another size than that of the catalog is right where the tool is ground down to the size of its row, or as bought makes it.
fn ground<'a>(context: &'a Context<'a>, tool: u32, catalog: Micrometres) -> Judge<'a> {
    // A row whose diameter is misprinted has its right one here.
    Box::new(move |value, diameters| {
        let stated = Micrometres::from_mm_rounded(value);
        if stated == catalog {
            return None;
        }
        let rows = sized_rows(context, tool).map(|(_, row)| row).zip(diameters);
        let made: Vec<_> = rows
            .filter(|(_, diameter)| Micrometres::from_mm_rounded(**diameter) == stated)
            .map(|(row, _)| row)
            .collect();
        if made.iter().any(|row| context.bought_size(row, stated) == Some(catalog)) {
            return Some((Severity::Note, Note::new("audit-bought").with("own", catalog).with("size", stated)));
        }
        let limit = context.shop.grind_limit(stated).unwrap_or_default();
        let grindable = !made.is_empty() && stated < catalog && catalog - stated <= limit;
        let note = Note::new("audit-ground").with("own", catalog).with("size", stated);
        Some(if grindable { (Severity::Note, note) } else { (Severity::Wrong, Note::new("audit-figure")) })
    })
}

fn overhang<'a>(
    context: &'a Context<'a>,
    graph: &mut Graph<'a>,
    at: usize,
    cutter: &named::NamedCutter<'a>,
    operation: Operation,
) -> Result<(), KnowledgeError> {
    let (least, most, because) = named::overhang(cutter, operation, &context.shop)?;
    graph.add(overhang_of(context, Id::new(Scope::Tool(at), Q::Overhang), (least, most), most.to_mm(), because));
    Ok(())
}

/// The overhang as it should be, mm, and the judgement of any other by the range that the note allows.
fn overhang_of<'a>(
    context: &'a Context<'a>,
    id: Id,
    (least, most): (Micrometres, Micrometres),
    right: f64,
    because: Because,
) -> Formula<'a> {
    let (least, most) = (least.to_mm(), most.to_mm());
    let mut formula = fixed_figure(&OVERHANG, id, right, [because]);
    formula.judge = Some(Box::new(move |value, _| {
        if (least - 1e-6..=most + 1e-6).contains(&value) {
            return None;
        }
        let note = Note::new("audit-overhang").with("least", least).with("most", most);
        // Typed lengths may be anything; beyond a metre nothing is distinguished.
        let excess = if value < least { value - least } else { value - most };
        let excess = Micrometres::from_mm_rounded(excess.clamp(-1000.0, 1000.0));
        let rule = context.shop.knowledge.ask(&AuditOverhangFor { excess }).ok()?.winner().ok()??;
        Some((rule.severity, note))
    }));
    formula
}

/// Of an overhang that cannot be, the author meant the one from which the plan went on, where the note allows that: its length of the
/// assembly, else its correction, gives it.
pub(crate) fn meant_overhangs<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>) -> Result<(), KnowledgeError> {
    for (at, tool) in context.stated.tools.iter().enumerate() {
        let id = |quantity| Id::new(Scope::Tool(at), quantity);
        let is_wrong = |severity| severity <= Severity::Wrong;
        let verdict = graph.verdict(id(Q::Overhang)).map(|verdict| &verdict.status);
        if !matches!(verdict, Some(Status::Root(severity, _)) if is_wrong(*severity)) {
            continue;
        }
        let operation = context.stated.rows_of_tool(tool.number).next().map(|(_, row)| row.operation.value);
        let Some((cutter, operation)) = context.cutter(at).zip(operation) else { continue };
        let (least, most, because) = named::overhang(cutter, operation, &context.shop)?;
        let written = |quantity| context.stated.figure(id(quantity)).map(|figure| figure.value);
        let holder = if context.has_machine_taper(at) { Some(0.0) } else { graph.right(id(Q::HolderUsed)) };
        let corrected = written(Q::Correction).zip(graph.right(id(Q::LongestAssembly)));
        let corrected = corrected.map(|(own, longest)| longest + if context.subtracts(at) { -own } else { own });
        let lengths = [written(Q::Assembly), corrected].into_iter().flatten().zip(holder.into_iter().cycle());
        let mut meant = lengths.map(|(assembly, holder)| assembly - holder);
        let allowed = least.to_mm() - 1e-6..=most.to_mm() + 1e-6;
        if let Some(meant) = meant.find(|own| allowed.contains(own)) {
            graph.replace(overhang_of(context, id(Q::Overhang), (least, most), meant, because));
        }
    }
    Ok(())
}

/// Corrections against the reference tool: the one stated, else the longest.
fn corrections<'a>(context: &'a Context<'a>, graph: &mut Graph<'a>, at: usize) {
    let stated = context.stated;
    let id = |quantity| Id::new(Scope::Tool(at), quantity);
    let lengths: Vec<Id> = (0..stated.tools.len()).map(|tool| Id::new(Scope::Tool(tool), Q::Assembly)).collect();
    // Any tool may be the reference tool; the longest is the usual one.
    let mut reference = largest(&REFERENCE, id(Q::LongestAssembly), lengths);
    reference.judge = Some(Box::new(move |value, inputs| {
        let known = inputs.iter().any(|length| (length - value).abs() < 1e-6);
        (!known).then(|| (Severity::Wrong, Note::new("audit-no-such-reference")))
    }));
    graph.add(reference);
    let [own, longest] = [Q::Assembly, Q::LongestAssembly].map(id);
    let subtracts = context.subtracts(at);
    let mut correction = if subtracts {
        by_its_text(&MINUS, id(Q::Correction), vec![longest, own])
    } else {
        by_its_text(&PLUS, id(Q::Correction), vec![own, longest])
    };
    // Where neither plan nor program has G43 or G44, both signs are accepted.
    if context.correction_word(at).is_none() && !stated.is_own {
        correction.judge = Some(Box::new(move |value, inputs| {
            let by_formula = inputs.first()? - inputs.get(1)?;
            let plus = if subtracts { -by_formula } else { by_formula };
            let near = |right: f64| (value - right).abs() < 1e-6;
            if near(plus) {
                None
            } else if near(-plus) {
                Some((Severity::Doubtful, Note::new("audit-sign-by-g44")))
            } else {
                Some((Severity::Error, Note::new(nature(value, if value * plus < 0.0 { -plus } else { plus }).code())))
            }
        }));
    }
    graph.add(correction);
    graph.add(by_its_text(&BOOK, id(Q::BookCorrection), vec![longest, own]));
}
