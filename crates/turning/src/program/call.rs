//! The call of a roughing cycle: the fields of table lathe-cycle-fields, filled from a task.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::tables::controls::lathe::{FieldContent, LatheControl, LatheCycleFields, LatheCycles, Measure};
use crate::turning::contour::Side;
use crate::turning::length::Half;

use super::cycle::{CycleTask, Direction};
use super::setting::Feeds;
use super::text::{diameter, number, position};

/// A field of the call.
#[derive(Clone, Debug)]
struct Field {
    name: String,
    holds: FieldContent,
    on_diameter: bool,
}

/// A cycle for a direction and a side.
#[derive(Clone, Debug)]
struct Cycle {
    direction: Direction,
    side: Side,
    code: String,
    machining: Option<i64>,
}

/// The roughing cycles of a control.
#[derive(Clone, Debug, Default)]
pub(super) struct Cycles {
    cycles: Vec<Cycle>,
    fields: Vec<Field>,
}

impl Cycles {
    /// The rows of a control.
    ///
    /// # Errors
    /// A table lacks a cycle for some direction or side, or has no field.
    pub fn read(control: LatheControl, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let mut cycles = Self::default();
        for row in knowledge.rows::<LatheCycles<'_>>()?.into_iter().filter(|row| row.control == control) {
            let LatheCycles { direction, side, machining, .. } = row;
            cycles.cycles.push(Cycle { direction, side, code: row.cycle.to_owned(), machining });
        }
        for direction in [Direction::Longitudinal, Direction::Facing] {
            for side in [Side::Outer, Side::Inner] {
                if cycles.cycle(direction, side).is_none() {
                    let wanted = format!("control {}, {} {}", control.name(), direction.name(), side.name());
                    return Err(KnowledgeError::no_row(knowledge.table_of::<LatheCycles<'_>>()?, &wanted));
                }
            }
        }
        let mut fields = knowledge.rows::<LatheCycleFields<'_>>()?;
        fields.retain(|row| row.control == control);
        if fields.is_empty() {
            let table = knowledge.table_of::<LatheCycleFields<'_>>()?;
            return Err(KnowledgeError::no_row(table, &format!("control {}", control.name())));
        }
        fields.sort_by_key(|row| row.place_in_call);
        let field = |row: LatheCycleFields<'_>| Field {
            name: row.field.to_owned(),
            holds: row.holds,
            on_diameter: row.measure == Some(Measure::Diameter),
        };
        cycles.fields = fields.into_iter().map(field).collect();
        Ok(cycles)
    }

    fn cycle(&self, direction: Direction, side: Side) -> Option<&Cycle> {
        self.cycles.iter().find(|cycle| cycle.direction == direction && cycle.side == side)
    }

    /// The function that calls the cycle of a task.
    pub fn code(&self, task: &CycleTask<'_>) -> &str {
        self.cycle(task.roughing.direction, task.rough.side).map(|cycle| cycle.code.as_str()).unwrap_or_default()
    }

    /// The fields of the call in their order, each with its name and value. The allowance along the contour is always
    /// left out: allowances are along X and Z.
    pub fn filled(&self, task: &CycleTask<'_>, contour: &str, feeds: &Feeds) -> Vec<(&str, String)> {
        let machining = self.cycle(task.roughing.direction, task.rough.side).and_then(|cycle| cycle.machining);
        let value = |field: &Field| {
            let length = |half: Half| if field.on_diameter { diameter(half) } else { half.to_string() };
            let start = task.begins();
            match field.holds {
                FieldContent::Contour => contour.to_owned(),
                FieldContent::StartX => length(start.radius),
                FieldContent::StartZ => position(start.z),
                FieldContent::Allowance => Half::ZERO.to_string(),
                FieldContent::AllowanceX => length(task.roughing.allowance.radius),
                FieldContent::AllowanceZ => task.roughing.allowance.z.to_string(),
                FieldContent::Depth => length(task.roughing.depth),
                FieldContent::Retract => length(task.roughing.retract),
                FieldContent::RoughFeed => number(feeds.cut.0, 4),
                FieldContent::PlungeFeed => number(feeds.infeed.0, 4),
                FieldContent::FinishFeed => number(feeds.finish.0, 4),
                FieldContent::Machining => machining.map(|kind| kind.to_string()).unwrap_or_default(),
                FieldContent::Nothing => String::new(),
            }
        };
        self.fields.iter().map(|field| (field.name.as_str(), value(field))).collect()
    }
}
