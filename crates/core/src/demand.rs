//! What a plan asks of its machine, each beside what the machine has.

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::machine::Machine;
use crate::part::{Hole, Point};
use crate::plan::{Conditions, Operation, Plan, ToolPlan};
use crate::units::{Kilowatts, Micrometres, NewtonMetres, Newtons};
use crate::zone::{Mass, mass};

/// One side asked for, and the other there.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Beside<T> {
    /// What the plan asks for.
    pub needed: T,
    /// What the machine has.
    pub available: T,
}

/// What a plan asks of its machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Demand {
    /// From the first to the last hole along X, and the travel.
    SpanX(Beside<Micrometres>),
    /// From the first to the last hole along Y, and the travel.
    SpanY(Beside<Micrometres>),
    /// The longest assembly, and the greatest overhang.
    Assembly(Beside<Micrometres>),
    /// The largest drill, one for centres among them, and the largest that the machine drives.
    Drill(Beside<Micrometres>),
    /// The largest end mill, and the largest that the machine drives.
    EndMill(Beside<Micrometres>),
    /// The largest tool of any other kind, and the widest that the machine takes: a face mill.
    OtherTool(Beside<Micrometres>),
    /// The greatest cutting power.
    Power(Beside<Kilowatts>),
    /// The greatest torque.
    Torque(Beside<NewtonMetres>),
    /// The greatest axial force.
    Thrust(Beside<Newtons>),
    /// The mass of the blank, and what the table bears, kg.
    MassKg(Mass, f64),
}

impl Demand {
    /// Whether the machine has it; absent where the figure is known too coarsely to say.
    pub fn is_met(&self) -> Option<bool> {
        Some(match self {
            Self::SpanX(own)
            | Self::SpanY(own)
            | Self::Assembly(own)
            | Self::Drill(own)
            | Self::EndMill(own)
            | Self::OtherTool(own) => own.needed <= own.available,
            Self::Power(own) => own.needed.0 <= own.available.0,
            Self::Torque(own) => own.needed.0 <= own.available.0,
            Self::Thrust(own) => own.needed.0 <= own.available.0,
            Self::MassKg(mass, limit) if mass.least <= *limit && mass.most > *limit => return None,
            Self::MassKg(mass, limit) => mass.most <= *limit,
        })
    }
}

/// All of them; that of a kind of tool only where the plan has one, that of the mass only where it is known.
///
/// # Errors
/// The knowledge base is broken.
pub fn demands(plan: &Plan, machine: &Machine<'_>, knowledge: &Knowledge) -> Result<Vec<Demand>, KnowledgeError> {
    let here = || plan.holes.iter().flat_map(|hole| &hole.transitions).filter(|own| !own.elsewhere);
    let most =
        |of: &dyn Fn(&Conditions) -> Option<f64>| here().filter_map(|own| of(&own.conditions)).fold(0.0, f64::max);
    let span = |of: &dyn Fn(&Point) -> Micrometres| {
        let all = || plan.part.holes.iter().flat_map(Hole::ends).map(|at| of(&at));
        all().max().zip(all().min()).map_or(Micrometres::ZERO, |(most, least)| most - least)
    };
    let longest = |of: &dyn Fn(&ToolPlan) -> Micrometres| plan.tools.iter().map(of).max().unwrap_or(Micrometres::ZERO);
    let power = Kilowatts(most(&|own| own.power_kw.map(|it| it.0)));
    let torque = NewtonMetres(most(&|own| own.torque_n_m.map(|it| it.0)));
    let thrust = Newtons(most(&|own| own.axial_force_n.map(|it| it.0)));
    let mut all = vec![
        Demand::SpanX(Beside { needed: span(&|at| at.x), available: machine.travel_x }),
        Demand::SpanY(Beside { needed: span(&|at| at.y), available: machine.travel_y }),
        Demand::Assembly(Beside { needed: longest(&|tool| tool.length_mm), available: machine.overhang_max }),
    ];
    // Each kind of tool has its own limit.
    let does = |tool: &ToolPlan, what: fn(Operation) -> bool| {
        here().any(|own| own.tool.number == tool.number && what(own.operation))
    };
    let drills = |tool: &&ToolPlan| {
        does(tool, |own| matches!(own, Operation::CentreDrill | Operation::Drill | Operation::DrillOut))
    };
    let mills = |tool: &&ToolPlan| does(tool, |own| own == Operation::Mill);
    let widest = |of: &dyn Fn(&&ToolPlan) -> bool| plan.tools.iter().filter(of).map(|tool| tool.diameter_mm).max();
    let beside = |needed: Option<Micrometres>, available| needed.map(|needed| Beside { needed, available });
    all.extend(beside(widest(&drills), machine.drill_max).map(Demand::Drill));
    all.extend(beside(widest(&mills), machine.end_mill_max).map(Demand::EndMill));
    let others = |tool: &&ToolPlan| !drills(tool) && !mills(tool);
    all.extend(beside(widest(&others), machine.tool_diameter_max).map(Demand::OtherTool));
    all.extend([
        Demand::Power(Beside { needed: power, available: machine.spindle_power }),
        Demand::Torque(Beside { needed: torque, available: machine.spindle_torque }),
        Demand::Thrust(Beside { needed: thrust, available: machine.thrust }),
    ]);
    all.extend(mass(&plan.part, knowledge)?.map(|mass| Demand::MassKg(mass, machine.load_max_kg)));
    Ok(all)
}
