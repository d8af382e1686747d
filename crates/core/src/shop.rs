//! The context of planning one part: the knowledge, its machine and its material.

use std::sync::Arc;

use crate::error::KnowledgeError;
use crate::knowledge::{Knowledge, RowRef};
use crate::machine::Machine;
use crate::material::Material;
use crate::note::{Because, Figure, Note};
use crate::part::{LimitsOf, Part, ToleratedDiameter, tolerance_width};
use crate::plan::{CuttingMethod, Operation};
use crate::shelf::Shelf;
use crate::tables::controls::{Convention, ProgramConventions};
use crate::tables::holes::{HoleConvention, HoleDefault};
use crate::tables::rules::CoolantFor;
use crate::units::{ItGrade, Kilowatts, Micrometres, Microns, MillimetresPerMinute, NewtonMetres, Roughness};
use technolog_note::note;

/// The knowledge, the machine at hand and the material.
#[derive(Clone, Debug)]
pub struct Shop<'k> {
    /// Every table.
    pub knowledge: &'k Knowledge,
    /// The machine.
    pub machine: Machine<'k>,
    /// The material.
    pub material: Material<'k>,
    /// How cutting conditions are found.
    pub method: CuttingMethod,
    /// Tables that are read again and again.
    pub shelf: Arc<Shelf<'k>>,
}

impl<'k> Shop<'k> {
    /// A share of the conventions in `hole-defaults`.
    ///
    /// # Errors
    /// The table does not name it.
    pub fn share(&self, name: HoleDefault) -> Result<f64, KnowledgeError> {
        Ok(self.default_row(name)?.value)
    }

    /// A row of the conventions in `hole-defaults`, for citing it.
    ///
    /// # Errors
    /// The table does not name it.
    pub fn default_row(&self, name: HoleDefault) -> Result<HoleConvention<'k>, KnowledgeError> {
        let found = self.shelf.conventions()?.iter().find(|row| row.name == name);
        match found {
            Some(row) => Ok(row.clone()),
            None => Err(KnowledgeError::no_row(self.knowledge.table_of::<HoleConvention<'_>>()?, name.name())),
        }
    }

    /// A roughness of the conventions in `hole-defaults`, whose names end in `-ra-um`.
    ///
    /// # Errors
    /// The table does not name it.
    pub fn roughness(&self, name: HoleDefault) -> Result<Roughness, KnowledgeError> {
        Ok(Roughness::from_ra(Microns(self.share(name)?)))
    }

    /// A length of the conventions in `hole-defaults`, whose names end in `-mm`.
    ///
    /// # Errors
    /// The table does not name it.
    pub fn convention(&self, name: HoleDefault) -> Result<Micrometres, KnowledgeError> {
        Ok(Micrometres::from_mm_rounded(self.share(name)?))
    }

    /// As [`grind_limit`].
    ///
    /// # Errors
    /// The table `hole-defaults` does not name them.
    pub fn grind_limit(&self, diameter: Micrometres) -> Result<Micrometres, KnowledgeError> {
        grind_limit(diameter, self.knowledge)
    }

    /// The grade of the field H whose reamer or core drill makes a hole as it is bought, the finest there is; none where each
    /// misses the limits. The widest hole of such a cutter is that of its field, and new it is at least `reamer-least-share` of the
    /// field above its size.
    ///
    /// # Errors
    /// The knowledge base is broken.
    pub fn bought_for(&self, diameter: &ToleratedDiameter) -> Result<Option<ItGrade>, KnowledgeError> {
        let share = self.share(HoleDefault::ReamerLeastShare)?;
        let (finest, coarsest) =
            (self.share(HoleDefault::FinestBoughtGrade)?, self.share(HoleDefault::CoarsestBoughtGrade)?);
        let makes = |grade: &ItGrade| {
            tolerance_width(*grade, diameter.nominal, self.knowledge).is_ok_and(|field| {
                field <= diameter.upper && Micrometres::from_mm_rounded(field.to_mm() * share) >= diameter.lower
            })
        };
        Ok((finest as u8..=coarsest as u8).filter_map(ItGrade::new).find(makes))
    }

    /// The diameter to aim at. Fine holes are made by what follows the field: the middle of one that does not begin at the nominal
    /// size (10K7, 30JS7), which a reamer bought for a field H would miss.
    ///
    /// # Errors
    /// The table `hole-defaults` does not name the coarsest grade that reamers are bought for.
    pub fn aimed(&self, diameter: &ToleratedDiameter) -> Result<Micrometres, KnowledgeError> {
        let fine = f64::from(diameter.it.number()) <= self.share(HoleDefault::CoarsestBoughtGrade)?;
        let own_field = diameter.lower != Micrometres::ZERO && diameter.limits != LimitsOf::Thread;
        Ok(if fine && own_field { (diameter.smallest() + diameter.largest()).half() } else { diameter.target() })
    }

    /// The diameter that the last transition aims at: of a finishing bar, which is set to any size, and of a mill, which goes round
    /// at any, the middle of the field, so that spring and wear of the tool and the roundness of the machine may go either way; of
    /// other tools, and of a size without a field, that of [`Self::aimed`].
    ///
    /// # Errors
    /// As for [`Self::aimed`].
    pub fn aimed_by(&self, operation: Operation, diameter: &ToleratedDiameter) -> Result<Micrometres, KnowledgeError> {
        let bored = matches!(operation, Operation::SemiFinishBore | Operation::FinishBore);
        let middle = match diameter.limits {
            LimitsOf::Drawing => bored || operation == Operation::Mill,
            LimitsOf::Free => bored,
            // The size of its drill, which is whole, lies well within its limits.
            LimitsOf::Thread => false,
        };
        if middle { Ok((diameter.smallest() + diameter.largest()).half()) } else { self.aimed(diameter) }
    }

    /// Whether an operation uses coolant where its speed does not say so, by the rule `coolant`.
    ///
    /// # Errors
    /// The rule does not say it.
    pub fn coolant(&self, operation: Operation) -> Result<(bool, Because), KnowledgeError> {
        let answer = self.knowledge.ask(&CoolantFor { operation, material_group: self.material.group })?;
        let cooled = answer.need(operation.name())?.coolant;
        let note = Note::new(if cooled { "cooled" } else { "dry" });
        Ok((cooled, Because::answer(&answer.answer, note.with("operation", Figure::operation(operation.name())))))
    }

    /// The shop with a machine without limits of load and tool: for work on another machine, whose limits are not
    /// known. Its spindle steps stay, as a guide.
    #[must_use]
    pub fn without_limits(&self) -> Self {
        let mut shop = self.clone();
        let machine = &mut shop.machine;
        machine.overhang_max = Micrometres::new(i64::MAX / 4);
        machine.tool_mass_max_kg = f64::INFINITY;
        machine.tool_diameter_max = machine.overhang_max;
        machine.spindle_torque = NewtonMetres(f64::INFINITY);
        machine.spindle_power = Kilowatts(f64::INFINITY);
        shop
    }

    /// The shop a part is planned in.
    ///
    /// # Errors
    /// The machine or the material is not in the knowledge base.
    pub fn new(part: &Part, method: CuttingMethod, knowledge: &'k Knowledge) -> Result<Self, KnowledgeError> {
        let machine = Machine::find(knowledge, &part.machine)?;
        let mut material = Material::find(knowledge, &part.material)?;
        if let Some(state) = part.material_state {
            material = material.in_state(state, knowledge)?;
        }
        Ok(Self::with(machine, material, method, knowledge))
    }

    /// The shop with that machine and material.
    pub fn with(machine: Machine<'k>, material: Material<'k>, method: CuttingMethod, knowledge: &'k Knowledge) -> Self {
        Self { knowledge, machine, material, method, shelf: Arc::new(Shelf::new(knowledge)) }
    }
}

/// A figure of the table `program-conventions`, in the unit of its name, and the row.
///
/// # Errors
/// The table lacks the figure, or has it in another unit.
pub fn convention(name: Convention, knowledge: &Knowledge) -> Result<(f64, RowRef<'_>), KnowledgeError> {
    let found = knowledge.need(name.name(), |row: &ProgramConventions<'_>| row.name == name)?;
    if found.unit != name.unit() {
        let problem = note!("nc-must", value = name.name(), unit = name.unit());
        return Err(KnowledgeError::missing(&found.row.table.id, problem));
    }
    Ok((found.value, found.row))
}

/// By how much a reamer or core drill of the catalogs may be ground down to that diameter: by a length and by a share of its own
/// diameter, whichever is less.
///
/// # Errors
/// The table `hole-defaults` does not name them.
pub fn grind_limit(diameter: Micrometres, knowledge: &Knowledge) -> Result<Micrometres, KnowledgeError> {
    let figure = |name| HoleConvention::of(name, knowledge).map(|row| row.value);
    let (limit, share) = (figure(HoleDefault::CutterGrindLimit)?, figure(HoleDefault::CutterGrindShare)?);
    Ok(Micrometres::from_mm_rounded(limit.min(diameter.to_mm() * share / (1.0 - share))))
}

/// The widest mill that may cut its way down over a hole: its middle, which has no teeth and is `core` of its diameter
/// (`mill-core-share` of `hole-defaults`), must lie over the hole.
pub fn widest_over_hole(hole: Micrometres, core: f64) -> Micrometres {
    Micrometres::from_mm_rounded(hole.to_mm() / core)
}

/// A feed in the steps of programs, rounded down so that no load grows; at least one step.
///
/// # Errors
/// The table `program-conventions` does not name the step.
pub fn programmed_feed(
    planned: MillimetresPerMinute,
    knowledge: &Knowledge,
) -> Result<MillimetresPerMinute, KnowledgeError> {
    let step = convention(Convention::FeedStep, knowledge)?.0;
    Ok(MillimetresPerMinute(libm::floor(planned.0 / step).max(1.0) * step))
}
