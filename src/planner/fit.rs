//! Gives the steps of one hole their cutters, holders and conditions, or says why one cannot have them.

use crate::cutting::{self, Cut};
use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::units::Unit;
use crate::knowledge::{Input, Knowledge, RowRef};
use crate::note::{Because, Note};
use crate::part::{Entry, Hole, Part};
use crate::plan::{Conditions, Operation};
use crate::route::Step;
use crate::shop::Shop;
use crate::tooling::{self, Assembly, CutterNeed};
use crate::units::{Decimal, Micrometres, round_to};

/// A step with what it is done with.
#[derive(Clone, Debug)]
pub(super) struct Fitted {
    pub step: Step,
    /// Absent for centring until the whole part is known.
    pub tool: Option<FittedTool>,
    pub travel: Micrometres,
    pub conditions: Conditions,
    pub because: Vec<Because>,
}

/// A cutter in its holder, in plain data.
#[derive(Clone, Debug)]
pub(super) struct FittedTool {
    pub designation: String,
    pub table: String,
    pub diameter: Micrometres,
    /// The size it is ground or set to; distinguishes two tools of one designation.
    pub size: Micrometres,
    pub assembly: Assembly,
    pub because: Vec<Because>,
}

/// What every step of a hole shares.
pub(super) struct Fitting<'p, 'k> {
    hole: &'p Hole,
    shop: &'p Shop<'k>,
    approach: Micrometres,
    overrun: Micrometres,
    /// The widest spot a centring drill of the catalogs makes.
    pub(super) widest_spot: Micrometres,
    /// Point angles, degrees.
    drill_point: f64,
    core_drill_point: f64,
    surface: &'k str,
    lead: &'k str,
    shared: Vec<Because>,
}

impl<'p, 'k> Fitting<'p, 'k> {
    /// Approach, overrun, surface and reamer lead by their rules.
    pub fn new(hole: &'p Hole, part: &'p Part, shop: &'p Shop<'k>) -> Result<Self, KnowledgeError> {
        let knowledge = shop.knowledge;
        let entry = if part.entry == Entry::Rough { "rough" } else { "machined" };
        let rule = knowledge.table("approach")?;
        let answer = rule.decide(&[("entry", Input::Text(entry)), ("through", Input::Bool(hole.through))])?;
        let travel = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, entry))?;
        let (approach, overrun) = (travel.length("approach")?, travel.length("overrun")?);

        let rule = knowledge.table("surface")?;
        let group = Input::Text(shop.material.group);
        let answer = rule.decide(&[("skin", Input::Bool(hole.skin)), ("material_group", group)])?;
        let surface = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, shop.material.group))?;

        let rule = knowledge.table("reamer-lead")?;
        let answer = rule.decide(&[("material_group", group)])?;
        let lead = answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, shop.material.group))?;
        let note = Note::new("travel").with("approach", approach).with("overrun", overrun);
        Ok(Self {
            hole,
            shop,
            approach,
            overrun,
            widest_spot: widest_spot(knowledge)?,
            drill_point: point_angle(knowledge, Operation::Drill),
            core_drill_point: point_angle(knowledge, Operation::CoreDrill),
            surface: surface.text("surface")?,
            lead: lead.text("lead")?,
            shared: vec![Because::row(travel, note)],
        })
    }

    /// How deep a drill of that diameter must reach: depth, point and overrun.
    pub fn drill_reach(&self, diameter: Micrometres) -> Micrometres {
        self.hole.depth + cone(diameter, self.drill_point) + self.overrun
    }

    /// Fits every step; the first that cannot be fitted says why.
    pub fn fit(&self, steps: Vec<Step>, finish_elsewhere: bool) -> Tried<Vec<Fitted>> {
        let drill = steps.iter().find(|step| step.operation == Operation::Drill).map(|step| step.diameter);
        let mut fitted = Vec::with_capacity(steps.len());
        for index in 0..steps.len() {
            let follows = steps.get(index + 1).map(|step| step.operation);
            let step = steps[index].clone();
            fitted.push(if step.operation == Operation::CentreDrill {
                self.centre(step, drill.unwrap_or(self.hole.diameter.nominal))?
            } else {
                let last = follows.is_none() && !finish_elsewhere;
                self.one(step, follows, last)?
            });
        }
        Ok(fitted)
    }

    /// Centring: the spot by the rule `centre-spot`; its tool is chosen for the whole part.
    fn centre(&self, step: Step, drill: Micrometres) -> Tried<Fitted> {
        let rule = self.shop.knowledge.table("centre-spot")?;
        let diameter = self.hole.diameter.nominal;
        let ask = |chamfer: bool| -> Result<RowRef<'_>, KnowledgeError> {
            let answer = rule.decide(&[("chamfer", Input::Bool(chamfer)), ("diameter", Input::Length(diameter))])?;
            answer.winner().ok_or_else(|| KnowledgeError::no_row(rule, "this hole"))
        };
        let row = ask(self.hole.chamfer.is_some())?;
        let by_chamfer = row.text("spot")? == "chamfer";
        let wide = self.hole.chamfer.map(|chamfer| diameter + chamfer + chamfer);
        let (row, spot, note) = match wide.filter(|spot| by_chamfer && *spot <= self.widest_spot) {
            Some(spot) => (row, spot, Note::new("spot-by-chamfer")),
            None => {
                // Where no centring drill is wide enough for the chamfer, the spot is that of a hole without one.
                let row = if by_chamfer { ask(false)? } else { row };
                let share = row.number_in("share", Unit::None)?;
                let spot = Micrometres::from_mm_rounded(drill.to_mm() * share);
                (row, spot, Note::new("spot-by-drill").with("share", share))
            }
        };
        let note = note.with("spot", spot).with("drill", drill);
        let depth = spot.half();
        let travel = self.approach + depth;
        let step = Step { diameter: spot, nominal: spot, ..step };
        let cut = Cut { depth, travel, ..self.cut(&step, None, "HSS", travel) };
        let conditions = cutting::conditions(&cut, self.shop)?;
        let because = vec![Because::row(row, note)];
        Ok(Fitted { step, tool: None, travel, conditions, because })
    }

    /// One step that is not centring.
    fn one(&self, step: Step, follows: Option<Operation>, last: bool) -> Tried<Fitted> {
        let (travel, reach) = self.travel(&step);
        let need = CutterNeed {
            operation: step.operation,
            diameter: step.diameter,
            nominal: step.nominal,
            enters: step.from,
            reach,
            through: self.hole.through,
            lead: self.lead,
        };
        let (cutter, assembly) = tooling::find_tool(&need, self.shop.knowledge, &self.shop.machine)?
            .map_err(|why| Refusal::Not(first_of(why, step.operation)))?;
        let nose_radius = cutter.row.length("nose_radius").ok();
        let cut = Cut { nose_radius, ..self.cut(&step, follows, &cutter.head.material, travel) };
        // The surface asked for is left by a last single pass; passes before it, and stock for another
        // machine, need no finish feed.
        let roughness = (last && step.passes == 1).then_some(self.hole.roughness);
        let cut = Cut { roughness, ..cut };
        let conditions = cutting::conditions(&cut, self.shop)?;
        let mut because = step.because.clone();
        because.extend(self.shared.clone());
        let mut tool_because = vec![cutter.order.clone(), cutter.because.clone()];
        tool_because.extend(assembly.because.clone());
        let tool = FittedTool {
            designation: cutter.designation.to_owned(),
            table: cutter.row.table.id.clone(),
            diameter: cutter.diameter,
            size: step.diameter,
            assembly,
            because: tool_because,
        };
        Ok(Fitted { step, tool: Some(tool), travel, conditions, because })
    }

    fn cut<'c>(&'c self, step: &Step, follows: Option<Operation>, material: &'c str, travel: Micrometres) -> Cut<'c> {
        Cut {
            operation: step.operation,
            diameter: step.diameter,
            from: step.from,
            passes: step.passes,
            depth: self.hole.depth,
            travel,
            tool_material: material,
            nose_radius: None,
            roughness: None,
            reamer_follows: follows.is_some_and(Operation::is_reaming),
            blind: !self.hole.through,
            surface: self.surface,
            it: Some(self.hole.diameter.it),
            pitch: None,
            cutter: None,
        }
    }

    /// Working travel of one pass, and how far the cutter must reach into the hole.
    fn travel(&self, step: &Step) -> (Micrometres, Micrometres) {
        let lead = match step.operation {
            Operation::Drill | Operation::DrillOut => cone(step.diameter, self.drill_point),
            Operation::CoreDrill => cone(step.diameter - step.from, self.core_drill_point),
            _ => Micrometres::ZERO,
        };
        let reach = self.hole.depth + lead + self.overrun;
        (self.approach + reach, reach)
    }

    /// What the tools do beyond the hole: a drill's point through a blind hole's floor, a spot deeper than
    /// the hole.
    pub fn beyond(&self, fitted: &[Fitted], thickness: Micrometres) -> Vec<Note> {
        let mut notes = Vec::new();
        for one in fitted {
            let step = &one.step;
            let (depth, limit, code) = match step.operation {
                Operation::Drill | Operation::DrillOut if !self.hole.through => {
                    (self.hole.depth + cone(step.diameter, self.drill_point), thickness, "point-breaks-through")
                }
                Operation::CentreDrill => (step.diameter.half(), self.hole.depth, "spot-too-deep"),
                _ => continue,
            };
            if depth >= limit {
                notes.push(Note::new(code).with("depth", depth).with("limit", limit).with("diameter", step.diameter));
            }
        }
        notes
    }

    /// Says what the second drill costs in time and saves in thrust against one drill of full size.
    pub fn compare_with_one_drill(&self, fitted: &mut [Fitted]) -> Result<(), KnowledgeError> {
        let Some(second) = fitted.iter().position(|one| one.step.operation == Operation::DrillOut) else {
            return Ok(());
        };
        let single = Step {
            operation: Operation::Drill,
            from: Micrometres::ZERO,
            because: Vec::new(),
            ..fitted[second].step.clone()
        };
        let (travel, _) = self.travel(&single);
        let follows = fitted.get(second + 1).map(|one| one.step.operation);
        let cut = self.cut(&single, follows, "HSS", travel);
        let Ok(one) = cutting::conditions(&cut, self.shop) else { return Ok(()) };
        let pair = &fitted[second.saturating_sub(1)..=second];
        let time: f64 = pair.iter().map(|step| step.conditions.machine_time_min.0).sum();
        let thrust = pair
            .iter()
            .filter_map(|step| step.conditions.axial_force_n)
            .fold(0.0, |most: f64, force| most.max(force.0));
        let table = self.shop.knowledge.table("two-pass-drilling")?;
        let note = Note::new("two-passes-cost")
            .with("time", format!("{:+.3}", time - one.machine_time_min.0))
            .with("thrust", round_to(thrust, 0))
            .with(
                "one-thrust",
                one.axial_force_n.map_or_else(|| "-".to_owned(), |force| round_to(force.0, 0).to_string()),
            );
        fitted[second].because.push(Because::table(table, note));
        Ok(())
    }
}

/// The widest centring drill of table A.14.
fn widest_spot(knowledge: &Knowledge) -> Result<Micrometres, KnowledgeError> {
    let table = knowledge.table("A.14")?;
    Ok(table.all_rows().filter_map(|row| row.length("diameter").ok()).max().unwrap_or_default())
}

/// The sharpest point among the tables of an operation's cutters, degrees: the longest cone, so that every
/// one of them clears the hole. 180, a flat end, where no table names an angle.
fn point_angle(knowledge: &Knowledge, operation: Operation) -> f64 {
    knowledge
        .tables()
        .filter_map(|table| table.tool.as_ref())
        .filter(|head| head.operations.iter().any(|name| name == operation.name()))
        .filter_map(|head| head.point_angle)
        .min()
        .map_or(180.0, Decimal::to_f64)
}

/// Height of a cone over a diameter: d/2 / tan(φ/2), the point of a drill or the lead of a core drill.
fn cone(diameter: Micrometres, angle_deg: f64) -> Micrometres {
    Micrometres::from_mm_rounded(diameter.to_mm() / 2.0 / libm::tan((angle_deg / 2.0).to_radians()))
}

/// The reason of the first candidate stands for all; how many there were is said with it.
fn first_of(why: Vec<Note>, operation: Operation) -> Note {
    let count = why.len();
    let first = why.into_iter().next().unwrap_or_else(|| Note::new("no-cutter"));
    let first = if first.params.contains_key("operation") { first } else { first.with("operation", operation.name()) };
    if count > 1 { first.with("more", count - 1) } else { first }
}
