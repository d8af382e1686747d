//! The call of a roughing cycle: its fields as table lathe-cycle-fields lists them, filled from a task.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::turning::contour::Side;
use crate::turning::length::Half;

use super::cycle::{Direction, Task};
use super::setting::Feeds;
use super::sheet::{diameter, number, position};

/// What a field holds: the column `holds` of table lathe-cycle-fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Holds {
    Contour,
    StartX,
    StartZ,
    Allowance,
    AllowanceX,
    AllowanceZ,
    Depth,
    Retract,
    RoughFeed,
    PlungeFeed,
    FinishFeed,
    Machining,
    Nothing,
}

const HOLDS: [(&str, Holds); 13] = [
    ("contour", Holds::Contour),
    ("start-x", Holds::StartX),
    ("start-z", Holds::StartZ),
    ("allowance", Holds::Allowance),
    ("allowance-x", Holds::AllowanceX),
    ("allowance-z", Holds::AllowanceZ),
    ("depth", Holds::Depth),
    ("retract", Holds::Retract),
    ("rough-feed", Holds::RoughFeed),
    ("plunge-feed", Holds::PlungeFeed),
    ("finish-feed", Holds::FinishFeed),
    ("machining", Holds::Machining),
    ("nothing", Holds::Nothing),
];

/// A field of the call.
#[derive(Clone, Debug)]
struct Field {
    name: String,
    holds: Holds,
    on_diameter: bool,
}

/// A cycle for a direction and a side.
#[derive(Clone, Debug)]
struct Cycle {
    direction: String,
    side: String,
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
    pub fn read(control: &str, knowledge: &Knowledge) -> Result<Self, KnowledgeError> {
        let mut found = Self::default();
        let table = knowledge.table("lathe-cycles")?;
        for row in table.all_rows().filter(|row| row.text("control") == Ok(control)) {
            found.cycles.push(Cycle {
                direction: row.text("direction")?.to_owned(),
                side: row.text("side")?.to_owned(),
                code: row.text("cycle")?.to_owned(),
                machining: row.int("machining").ok(),
            });
        }
        for direction in [Direction::Longitudinal, Direction::Facing] {
            for side in [Side::Outer, Side::Inner] {
                if found.cycle(direction, side).is_none() {
                    let wanted = format!("control {control}, {} {}", direction.name(), side.name());
                    return Err(KnowledgeError::no_row(table, &wanted));
                }
            }
        }
        let table = knowledge.table("lathe-cycle-fields")?;
        let mut fields = Vec::new();
        for row in table.all_rows().filter(|row| row.text("control") == Ok(control)) {
            let holds = row.text("holds")?;
            let known = HOLDS.iter().find(|(name, _)| *name == holds);
            let Some((_, holds)) = known else { return Err(KnowledgeError::no_row(table, holds)) };
            let field = Field {
                name: row.text("field")?.to_owned(),
                holds: *holds,
                on_diameter: row.text("measure") == Ok("diameter"),
            };
            fields.push((row.int("place_in_call")?, field));
        }
        if fields.is_empty() {
            return Err(KnowledgeError::no_row(table, &format!("control {control}")));
        }
        fields.sort_by_key(|(place, _)| *place);
        found.fields = fields.into_iter().map(|(_, field)| field).collect();
        Ok(found)
    }

    fn cycle(&self, direction: Direction, side: Side) -> Option<&Cycle> {
        self.cycles.iter().find(|cycle| cycle.direction == direction.name() && cycle.side == side.name())
    }

    /// The function that calls the cycle of a task.
    pub fn code(&self, task: &Task<'_>) -> &str {
        self.cycle(task.roughing.direction, task.rough.side).map(|cycle| cycle.code.as_str()).unwrap_or_default()
    }

    /// The fields of the call in their order, each with its name and what stands in it. An allowance along the contour is
    /// never asked for: what is left stands along X and Z.
    pub fn filled(&self, task: &Task<'_>, contour: &str, feeds: &Feeds) -> Vec<(&str, String)> {
        let machining = self.cycle(task.roughing.direction, task.rough.side).and_then(|cycle| cycle.machining);
        let value = |field: &Field| {
            let length = |half: Half| if field.on_diameter { diameter(half) } else { half.to_string() };
            let start = task.begins();
            match field.holds {
                Holds::Contour => contour.to_owned(),
                Holds::StartX => length(start.radius),
                Holds::StartZ => position(start.z),
                Holds::Allowance => Half::ZERO.to_string(),
                Holds::AllowanceX => length(task.roughing.allowance.radius),
                Holds::AllowanceZ => task.roughing.allowance.z.to_string(),
                Holds::Depth => length(task.roughing.depth),
                Holds::Retract => length(task.roughing.retract),
                Holds::RoughFeed => number(feeds.cut.0, 4),
                Holds::PlungeFeed => number(feeds.infeed.0, 4),
                Holds::FinishFeed => number(feeds.finish.0, 4),
                Holds::Machining => machining.map(|kind| kind.to_string()).unwrap_or_default(),
                Holds::Nothing => String::new(),
            }
        };
        self.fields.iter().map(|field| (field.name.as_str(), value(field))).collect()
    }
}
