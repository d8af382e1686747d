//! What a plan asks of its machine, each beside what the machine has.

use crate::machine::Machine;
use crate::part::{Hole, Point};
use crate::plan::{Conditions, Plan, ToolPlan};
use crate::units::{Kilowatts, Micrometres, NewtonMetres, Newtons};

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
    /// The largest tool.
    ToolDiameter(Beside<Micrometres>),
    /// The greatest cutting power.
    Power(Beside<Kilowatts>),
    /// The greatest torque.
    Torque(Beside<NewtonMetres>),
    /// The greatest axial force.
    Thrust(Beside<Newtons>),
    /// The mass of the blank, kg.
    MassKg(Beside<f64>),
}

impl Demand {
    /// Whether the machine has it.
    pub fn is_met(&self) -> bool {
        match self {
            Self::SpanX(own) | Self::SpanY(own) | Self::Assembly(own) | Self::ToolDiameter(own) => {
                own.needed <= own.available
            }
            Self::Power(own) => own.needed.0 <= own.available.0,
            Self::Torque(own) => own.needed.0 <= own.available.0,
            Self::Thrust(own) => own.needed.0 <= own.available.0,
            Self::MassKg(own) => own.needed <= own.available,
        }
    }
}

/// All of them; that of the mass only where the part says it.
pub fn demands(plan: &Plan, machine: &Machine<'_>) -> Vec<Demand> {
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
        Demand::ToolDiameter(Beside {
            needed: longest(&|tool| tool.diameter_mm),
            available: machine.tool_diameter_max,
        }),
        Demand::Power(Beside { needed: power, available: machine.spindle_power }),
        Demand::Torque(Beside { needed: torque, available: machine.spindle_torque }),
        Demand::Thrust(Beside { needed: thrust, available: machine.thrust }),
    ];
    let mass = plan.part.mass_kg.map(|needed| Beside { needed, available: machine.load_max_kg });
    all.extend(mass.map(Demand::MassKg));
    all
}
