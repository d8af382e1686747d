//! The machine's working zone: the blank on the table, the holes within its travels, every tool between the part and
//! the spindle. Motions beyond the travels are reported by the run of the program.
//!
//! Only what is impossible at any setting of the operator is an error: the knee may have any height, and where the
//! plan does not give the height of the fixture, the least height that the tools need is assumed.

use crate::error::KnowledgeError;
use crate::knowledge::RowRef;
use crate::motion::Axis;
use crate::note::{Because, Note, Severity};
use crate::tables::machines::MachineQuantity;
use crate::units::Micrometres;
use crate::zone::{self, OffTable, Stroke};

use super::super::context::Context;
use super::super::finding::{AuditFinding, Section};
use super::super::graph::Graph;
use super::super::quantity::{Id, Quantity as Q, Scope};
use super::reach::Tips;

pub(super) fn check<'a>(
    context: &Context<'a>,
    graph: &Graph<'a>,
    findings: &mut Vec<AuditFinding>,
) -> Result<(), KnowledgeError> {
    table(context, findings)?;
    // A plan of the program reports these itself.
    if !context.stated.is_own {
        travels(context, findings)?;
    }
    height(context, graph, findings)
}

fn about_part(severity: Severity, field: &str, note: Note) -> AuditFinding {
    AuditFinding::new(severity, Section::Route, field.to_owned(), note)
}

/// A blank that extends beyond the table.
fn table(context: &Context<'_>, findings: &mut Vec<AuditFinding>) -> Result<(), KnowledgeError> {
    let (blank, machine) = (context.stated.part.blank, &context.shop.machine);
    let (length, width) = (machine.table_length, machine.table_width);
    let sides = [
        (Axis::X, blank.length, length, MachineQuantity::TableLength, "part.blank.length"),
        (Axis::Y, blank.width, width, MachineQuantity::TableWidth, "part.blank.width"),
    ];
    for (axis, size, most, quantity, field) in sides {
        // Not every record says how large its table is.
        let Some(most) = most else { continue };
        if size > most {
            let note = Note::new("audit-blank-off-table").with("axis", axis.letter()).with("size", size);
            let note = note.with("table", most).with("over", size - most);
            let finding = about_part(Severity::Doubtful, field, note).with_values(size, format!("<= {most}"));
            findings.push(finding.resting_on([limit(machine.row(quantity)?)]));
        }
    }
    Ok(())
}

fn limit(row: RowRef<'_>) -> Because {
    Because::row(row, Note::new("audit-limit"))
}

/// The findings of planning for the same part: too heavy for the table, holes wider apart than its travel.
fn travels(context: &Context<'_>, findings: &mut Vec<AuditFinding>) -> Result<(), KnowledgeError> {
    let (part, machine) = (&context.stated.part, &context.shop.machine);
    for fault in zone::off_table(part, &context.shop)? {
        let (field, row) = match fault {
            OffTable::TooHeavy { .. } | OffTable::PlateTooHeavy { .. } => {
                ("part.mass", machine.row(MachineQuantity::LoadMassMax)?)
            }
            OffTable::BeyondTravel { axis: Axis::X, .. } => ("part.holes", machine.row(MachineQuantity::TravelX)?),
            OffTable::BeyondTravel { .. } => ("part.holes", machine.row(MachineQuantity::TravelY)?),
        };
        let mut finding = about_part(fault.severity(), field, fault.note()).resting_on([limit(row)]);
        if matches!(fault, OffTable::BeyondTravel { .. }) {
            finding.reasons = turned(context);
        }
        findings.push(finding);
    }
    Ok(())
}

/// The spans of the holes with the part turned by 90°, where both are then within the travels.
fn turned(context: &Context<'_>) -> Vec<Note> {
    let machine = &context.shop.machine;
    let other = |axis| if axis == Axis::X { Axis::Y } else { Axis::X };
    let spans: Vec<(Axis, Micrometres)> =
        zone::spans(&context.stated.part).map(|(axis, low, high)| (other(axis), high - low)).collect();
    if spans.iter().any(|(axis, span)| *span > machine.travel(*axis)) {
        return Vec::new();
    }
    let note = |(axis, span): &(Axis, Micrometres)| {
        let note = Note::new("audit-zone-turned").with("axis", axis.letter()).with("span", *span);
        note.with("travel", machine.travel(*axis))
    };
    spans.iter().map(note).collect()
}

/// A tool of the plan over the part.
#[derive(Clone, Copy)]
struct Reach {
    /// Its place in the list of tools.
    tool: usize,
    /// The row in which it goes deepest.
    row: usize,
    /// How far below its face it goes there.
    tip: Micrometres,
    stroke: Stroke,
}

/// Every tool must pass above the part and reach the bottom of its deepest hole.
fn height(context: &Context<'_>, graph: &Graph<'_>, findings: &mut Vec<AuditFinding>) -> Result<(), KnowledgeError> {
    let part = &context.stated.part;
    let tips = Tips::read(context)?;
    let mut deepest = Vec::new();
    for (tool, own) in context.stated.tools.iter().enumerate() {
        let rows = context.stated.rows_of_tool(own.number);
        let row = rows.filter_map(|(at, _)| Some((at, tips.tip_depth(context, at)?))).max_by_key(|(_, tip)| *tip);
        deepest.extend(row.map(|(row, tip)| (tool, row, tip)));
    }
    let below = |tip: Micrometres| (tip - part.blank.thickness).max(Micrometres::ZERO);
    let needed = deepest.iter().map(|(.., tip)| below(*tip)).max().unwrap_or_default();
    let fixture = part.fixture.height.unwrap_or(needed);
    for (tool, row, tip) in deepest.iter().filter(|(.., tip)| below(*tip) > fixture) {
        let note = Note::new("no-room-under-part").with("below", below(*tip)).with("height", fixture);
        let own = &context.stated.rows[*row];
        let field = format!("route.{}.depth", own.number);
        let place = own.figures.get(&Q::Depth).map_or(&own.place, |figure| &figure.place);
        let mut finding = AuditFinding::new(no_room_severity(context), Section::Route, field, note).at(place);
        finding.subject = context.subject(Scope::Row(*row));
        finding.subject.tool = Some(context.stated.tools[*tool].number);
        findings.push(finding);
    }
    let face = fixture + part.blank.thickness;
    let reaches = |of: &dyn Fn(Id) -> Option<f64>| -> Vec<Reach> {
        let one = |(tool, row, tip): &(usize, usize, Micrometres)| {
            let length = Micrometres::from_mm_rounded(of(Id::new(Scope::Tool(*tool), Q::Assembly))?);
            let stroke = Stroke { length, highest: face + tips.approach, lowest: face - *tip };
            Some(Reach { tool: *tool, row: *row, tip: *tip, stroke })
        };
        deepest.iter().filter_map(one).collect()
    };
    let zone = ZoneCheck { context, approach: tips.approach, fixture };
    let stated = zone.beyond(&reaches(&|id| graph.written(id)))?;
    let right = zone.beyond(&reaches(&|id| graph.right(id)))?;
    for (tool, mut finding) in stated {
        // Lengths that are slips, and whose right values fit.
        if !right.iter().any(|(other, _)| *other == tool) {
            let lengths = deepest.iter().map(|(tool, ..)| Id::new(Scope::Tool(*tool), Q::Assembly));
            let off = lengths.filter(|id| graph.written(*id) != graph.right(*id));
            finding.follows_from = off.map(|id| context.field(id)).collect();
        }
        findings.push(finding);
    }
    if context.shop.machine.nose_to_table.is_none() && !context.stated.is_own && !deepest.is_empty() {
        let note = Note::new("audit-zone-unknown");
        findings.push(AuditFinding::new(Severity::Note, Section::Lengths, "tools".to_owned(), note));
    }
    Ok(())
}

/// The severity for a tool without room; lower for plans of the program, because their program reports it again.
fn no_room_severity(context: &Context<'_>) -> Severity {
    if context.stated.is_own { Severity::Doubtful } else { Severity::Error }
}

struct ZoneCheck<'c, 'a> {
    context: &'c Context<'a>,
    approach: Micrometres,
    /// Height of the support under the part.
    fixture: Micrometres,
}

impl ZoneCheck<'_, '_> {
    /// Tools that have no room at any position of the knee, each with its finding.
    fn beyond(&self, reaches: &[Reach]) -> Result<Vec<(usize, AuditFinding)>, KnowledgeError> {
        let machine = &self.context.shop.machine;
        let mut found = Vec::new();
        let most = machine.nose_to_table.map(|(_, most)| most);
        for reach in reaches {
            let needed = reach.stroke.passes_from();
            let Some(most) = most.filter(|most| needed > *most) else { continue };
            let note = Note::new("audit-zone-over").with("length", reach.stroke.length).with("approach", self.approach);
            let note = note.with("thickness", self.context.stated.part.blank.thickness).with("fixture", self.fixture);
            let fits = (most - reach.stroke.highest).max(Micrometres::ZERO);
            let note = note.with("needed", needed).with("most", most).with("fits", fits);
            let finding = self.finding(reach, note, format!("<= {fits}"));
            found.push((reach.tool, finding.resting_on([limit(machine.row(MachineQuantity::NoseToTableMax)?)])));
        }
        let least = machine.nose_to_table.map(|(least, _)| least);
        let strokes: Vec<Stroke> = reaches.iter().map(|one| one.stroke).collect();
        let longest = reaches.iter().max_by_key(|one| one.stroke.passes_from());
        let (Some(nose), Some(longest)) = (zone::lowest_nose(&strokes, least), longest) else { return Ok(found) };
        let bounded = least.filter(|_| nose > longest.stroke.passes_from());
        for one in reaches {
            let travel = one.stroke.travel(nose);
            let is_reported = found.iter().any(|(tool, _)| *tool == longest.tool || *tool == one.tool);
            if travel <= machine.travel_z || is_reported {
                continue;
            }
            let fits = one.stroke.length + travel - machine.travel_z;
            let note = match bounded {
                Some(least) => Note::new("audit-zone-low").with("least", least).with("lowest", one.stroke.lowest),
                None => {
                    let other = self.context.stated.tools.get(longest.tool).map_or(0, |tool| tool.number);
                    let note = Note::new("audit-zone-under").with("other", other).with("approach", self.approach);
                    note.with("longest", longest.stroke.length).with("depth", one.tip)
                }
            };
            let note = note.with("length", one.stroke.length).with("way", travel).with("travel", machine.travel_z);
            let finding = self.finding(one, note.with("fits", fits), format!(">= {fits}"));
            found.push((one.tool, finding.resting_on([limit(machine.row(MachineQuantity::TravelZ)?)])));
        }
        Ok(found)
    }

    fn finding(&self, reach: &Reach, note: Note, right: String) -> AuditFinding {
        let context = self.context;
        let tool = &context.stated.tools[reach.tool];
        let field = context.field(Id::new(Scope::Tool(reach.tool), Q::Assembly));
        let figure = tool.figures.get(&Q::Assembly);
        let place = figure.map_or(&tool.place, |figure| &figure.place);
        let mut finding = AuditFinding::new(no_room_severity(context), Section::Lengths, field, note).at(place);
        finding.subject = context.subject(Scope::Row(reach.row));
        finding.subject.tool = Some(tool.number);
        finding.quantity = Some(Q::Assembly);
        let stated = figure.map_or_else(|| reach.stroke.length.to_string(), |figure| figure.text.clone());
        finding.with_values(stated, right)
    }
}
