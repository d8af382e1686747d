//! What the rules and checks of an audit share: the stated plan, the shop, the catalog rows of its tools, and the
//! program's plan of the same part.

use std::collections::BTreeMap;

use crate::error::KnowledgeError;
use crate::knowledge::units::Percent;
use crate::knowledge::vocabulary::Shank;
use crate::knowledge::{Question, TypedAnswer};
use crate::note::{Figure, IntoFigure, Note, Severity};
use crate::part::{Hole, Point};
use crate::plan::{Operation, Plan, Transition};
use crate::shop::Shop;
use crate::tables::audit::{StandardsAlike, Threshold};
use crate::tables::holders::HolderRow;
use crate::tables::machines::MachineQuantity;
use crate::tooling::named::NamedCutter;
use crate::units::{Micrometres, RevsPerMinute};

use super::auditor::Auditor;
use super::near::{Likeness, NameMatch, likeness, plain, same_table};
use super::of_dimensions;
use super::quantity::{Id, Quantity, Scope};
use super::stated::{Row, Stated, Text, Tool};

/// The context of an audit.
#[derive(Debug)]
pub struct Context<'a> {
    /// The plan as stated.
    pub stated: &'a Stated,
    /// The knowledge, the machine and the material.
    pub shop: Shop<'a>,
    /// The program's plan of the same part, by the same method.
    pub plan: &'a Plan,
    /// What audits share.
    pub auditor: &'a Auditor<'a>,
    cutters: Vec<NameMatch<NamedCutter<'a>>>,
    holders: Vec<NameMatch<HolderRow<'a>>>,
    /// The cutters that the stated dimensions belong to, where they are not those of the designation.
    of_dimensions: Vec<Option<NamedCutter<'a>>>,
    /// The word that calls each offset register in the program: `G43` or `G44`.
    calls: BTreeMap<u32, &'static str>,
}

impl<'a> Context<'a> {
    /// Looks up the tools.
    ///
    /// # Errors
    /// The knowledge base has no answer.
    pub fn new(stated: &'a Stated, plan: &'a Plan, auditor: &'a Auditor<'a>) -> Result<Self, KnowledgeError> {
        let shop = Shop::new(&stated.part, stated.method, auditor.knowledge)?;
        let mut cutters = Vec::new();
        let mut holders = Vec::new();
        let mut by_dimensions = Vec::new();
        for (at, tool) in stated.tools.iter().enumerate() {
            let table = tool.table.as_ref().map(|table| table.value.as_str());
            let named = tool.designation.as_ref().map(|text| text.value.as_str());
            // A stated table decides between equal designations; if it is the table of another, the check of
            // designations says so.
            let of_table =
                |cutter: &NamedCutter<'_>| table.is_none_or(|table| same_table(&cutter.row.row.table.id, table));
            let mut found = auditor.cutters.find(named, of_table);
            if matches!(found, NameMatch::Unknown(_)) {
                found = auditor.cutters.find(named, |_| true);
            }
            if let Some(own) = of_standard(stated, tool, auditor) {
                found = NameMatch::Found(own);
            }
            let named = found.value();
            by_dimensions.push(named.and_then(|named| of_dimensions::meant(stated, at, named, auditor, &shop)));
            cutters.push(found);
            let named = tool.holder.as_ref().map(|text| text.value.as_str());
            holders.push(auditor.holders.find(named, |_| true));
        }
        let calls = stated.program.as_ref().map(|program| calls(&program.text)).unwrap_or_default();
        Ok(Self { stated, shop, plan, auditor, cutters, holders, of_dimensions: by_dimensions, calls })
    }

    /// The catalog entry near to the designation of a tool.
    pub fn cutter_near(&self, tool: usize) -> &NameMatch<NamedCutter<'a>> {
        self.cutters.get(tool).unwrap_or(&NameMatch::Unstated)
    }

    /// The cutter of a tool, where its designation is known or clearly misprinted.
    pub fn cutter(&self, tool: usize) -> Option<&NamedCutter<'a>> {
        self.of_dimensions(tool).or_else(|| self.cutter_near(tool).value())
    }

    /// The cutter that the stated dimensions of a tool belong to, where its designation names another one.
    pub fn of_dimensions(&self, tool: usize) -> Option<&NamedCutter<'a>> {
        self.of_dimensions.get(tool)?.as_ref()
    }

    /// Whether the dimensions that a tool states, two or more, are all those of that cutter.
    pub fn has_dimensions_of(&self, tool: usize, known: &str) -> bool {
        let mut cutters = self.auditor.cutters.values().filter(|cutter| cutter.designation == known);
        cutters.any(|cutter| of_dimensions::has(&self.stated.tools[tool], cutter))
    }

    /// The catalog entry near to the designation of a holder.
    pub fn holder_near(&self, tool: usize) -> &NameMatch<HolderRow<'a>> {
        self.holders.get(tool).unwrap_or(&NameMatch::Unstated)
    }

    /// The holder of a tool.
    pub fn holder(&self, tool: usize) -> Option<&HolderRow<'a>> {
        self.holder_near(tool).value()
    }

    /// Whether a cutter has the taper of the machine, so that it needs no holder.
    pub fn has_machine_taper(&self, tool: usize) -> bool {
        self.cutter(tool).is_some_and(|cutter| cutter.head.shank == Shank::Taper)
    }

    /// The group of holes of a row.
    pub fn hole(&self, row: &Row) -> Option<&'a Hole> {
        let name = &row.hole.as_ref()?.value;
        self.stated.part.holes.iter().find(|hole| hole.name == *name)
    }

    /// The size of the reamer or core drill whose field H reaches into a field above the nominal size: Ø25 as bought for 25G7.
    pub fn bought_size(&self, row: &Row, diameter: Micrometres) -> Option<Micrometres> {
        let hole = self.hole(row)?;
        let step = row.step.and_then(|number| hole.steps.get(number.checked_sub(1)?));
        let required = step.map_or(&hole.diameter, |step| &step.diameter);
        let above = diameter > required.nominal && diameter >= required.smallest() && diameter <= required.largest();
        let operation = row.operation.value;
        let fixed = operation.is_reaming() || operation == Operation::CoreDrill;
        let bought = || self.shop.bought_for(required).ok().flatten();
        (fixed && above && bought().is_some()).then_some(required.nominal)
    }

    /// The same transition in the program's plan: of the same hole, operation and place, and of the stated diameter,
    /// if any.
    pub fn reference(&self, row: usize) -> Option<&'a Transition> {
        let diameter = self.stated.rows.get(row)?.figures.get(&Quantity::Diameter).filter(|_| !self.stated.is_own);
        let alike =
            |found: &&Transition| diameter.is_none_or(|figure| (figure.value - found.diameter_mm.to_mm()).abs() < 1e-6);
        self.same_transition(row).filter(alike)
    }

    /// Whether the depth of a row may be the way of its tool: a list of tools does not say which it is, and through a hole the tool goes on.
    pub fn runs_out(&self, hole: &Hole, row: usize) -> bool {
        let through = hole.through && hole.steps.is_empty();
        through && self.stated.is_list && self.stated.rows.get(row).is_some_and(Row::of_main_cylinder)
    }

    /// Whether a depth, mm, is that of a through hole with the point of the drill and what goes beyond it: as far again as the point, and no
    /// more than a diameter.
    pub fn is_overrun(&self, hole: &Hole, depth: f64) -> bool {
        let beyond = Micrometres::from_mm_rounded(self.auditor.threshold(Threshold::OverrunLeast));
        let (least, most) = (hole.depth, hole.depth + hole.diameter.nominal.max(beyond));
        (least..=most).contains(&Micrometres::from_mm_rounded(depth))
    }

    /// Whether the countersink of a row goes round its edge, as that of the program's plan does: it is narrower than the edge.
    pub fn goes_round(&self, row: usize) -> bool {
        let Some(own) = self.stated.rows.get(row).filter(|own| own.operation.value.is_of_edge()) else { return false };
        let rounds = self.same_transition(row).is_some_and(|ours| ours.conditions.rounds.is_some());
        let cutter = self.stated.tool_of(own).and_then(|tool| self.cutter(tool)?.row.diameter);
        let edge = own.figures.get(&Quantity::Diameter).map(|figure| figure.value);
        rounds && cutter.zip(edge).is_some_and(|(cutter, edge)| cutter.to_mm() < edge)
    }

    /// As `reference`, but of any diameter.
    pub fn same_transition(&self, row: usize) -> Option<&'a Transition> {
        // Of a part that is made of a list nothing is known that the list does not say.
        let own = self.stated.rows.get(row).filter(|_| self.stated.unsaid.is_none())?;
        let name = &own.hole.as_ref()?.value;
        let hole = self.plan.holes.iter().find(|hole| hole.name == *name)?;
        if self.stated.is_own {
            let turn = self.stated.rows_of_hole(name).position(|(at, _)| at == row)?;
            return hole.transitions.get(turn).filter(|other| other.operation == own.operation.value);
        }
        let alike = |(at, _): &(usize, &Row)| self.stated.rows[*at].operation.value == own.operation.value;
        let turn = self.stated.rows_of_hole(name).filter(alike).position(|(at, _)| at == row)?;
        hole.transitions.iter().filter(|other| other.operation == own.operation.value).nth(turn)
    }

    /// The group of holes that the clamping is computed for.
    pub fn clamped_hole(&self) -> Option<&'a Hole> {
        let clamping = self.stated.clamping.as_ref()?;
        match (&clamping.hole, &clamping.row) {
            (Some(hole), _) => self.stated.part.holes.iter().find(|known| known.name == hole.value),
            (None, Some(row)) => self.hole(self.stated.rows.get(row.value)?),
            (None, None) => None,
        }
    }

    /// The distance from the hole of a group to its nearest clamp: by the clamps of the plan, otherwise of the
    /// drawing. A hole under a clamp has no distance.
    pub fn distance_to_clamp(&self, hole: &Hole) -> Option<Micrometres> {
        let stated = self.stated.clamping.as_ref().map(|clamping| clamping.at.as_slice()).unwrap_or_default();
        let drawn: Vec<Point> = self.stated.part.fixture.clamps.iter().map(|clamp| clamp.at).collect();
        let clamps = if stated.is_empty() { &drawn } else { stated };
        let nearest = hole.ways().flat_map(|way| clamps.iter().map(move |clamp| way.nearest(*clamp)));
        nearest.filter(|distance| distance.micrometres() > 0).min()
    }

    /// The same factor where other conditions of the plan give it a value.
    pub fn same_factor(&self, but: usize, quantity: Quantity, name: &str) -> Option<Id> {
        let conditions = self.stated.conditions.iter().enumerate().filter(|(at, _)| *at != but);
        conditions.into_iter().find_map(|(at, conditions)| {
            let factors = conditions.factors.get(&quantity)?;
            let index = factors.iter().position(|factor| factor.name.value == name && factor.value.is_some())?;
            Some(Id { scope: Scope::Conditions(at), quantity, index })
        })
    }

    /// The tools in the order of their changes by the rows; the same tool in successive rows counts once.
    pub fn changes(&self) -> Vec<u32> {
        if let Some(changes) = &self.stated.changes {
            let mut changes = changes.clone();
            // A tool that stays in the spindle while the part is turned over is not changed.
            changes.dedup();
            return changes;
        }
        let rows = self.stated.rows.iter();
        let mut changes: Vec<u32> = rows.filter_map(|row| Some(row.tool.as_ref()?.value)).collect();
        changes.dedup();
        changes
    }

    /// How grave a speed beside the steps of the machine is: a series that nobody has confirmed makes it doubtful at most.
    pub fn of_series(&self, severity: Severity) -> Severity {
        let series = self.shop.machine.row(MachineQuantity::SpindleSpeeds);
        let confirmed = series.is_ok_and(|row| row.row().unconfirmed.is_none());
        if confirmed { severity } else { severity.max(Severity::Doubtful) }
    }

    /// What is wrong with a speed that the machine cannot turn at all.
    pub fn beyond_series(&self, speed: f64) -> Option<Note> {
        let steps = &self.shop.machine.spindle_steps;
        let (least, most) = (steps.first()?.0, steps.last()?.0);
        let beyond = speed > most * 1.001 || speed < least / 1.001;
        beyond.then(|| Note::new("audit-outside-series").with("least", least).with("most", most))
    }

    /// The steps of the machine below and above a spindle speed, 1/min, `-` where there is none; none if the speed is a
    /// step itself.
    pub fn steps_around(&self, speed: f64) -> Option<(Figure, Figure)> {
        let steps = &self.shop.machine.spindle_steps;
        if steps.iter().any(|step| (step.0 - speed).abs() < 1e-6) {
            return None;
        }
        let shown = |step: Option<&RevsPerMinute>| step.map_or_else(|| "-".into_figure(), |step| step.0.into_figure());
        let below = steps.iter().rev().find(|step| step.0 < speed);
        let above = steps.iter().find(|step| step.0 > speed);
        Some((shown(below), shown(above)))
    }

    /// The answer of a threshold rule for a stated value, given as a share of what it is compared with: the share,
    /// per cent, and the answer.
    ///
    /// # Errors
    /// The rule cannot answer.
    pub fn by_share<Q: Question>(
        &self,
        share: f64,
        question: impl FnOnce(Percent) -> Q,
    ) -> Result<(f64, TypedAnswer<'a, Q::Row<'a>>), KnowledgeError> {
        let percent = share * 100.0;
        // The columns begin at zero, and above ten thousand times nothing is distinguished.
        Ok((percent, self.shop.knowledge.ask(&question(Percent(percent.clamp(0.0, 1e6))))?))
    }

    /// Whether the correction of a tool is subtracted: as the plan says, else as its program calls it; otherwise it
    /// is added.
    pub fn subtracts(&self, tool: usize) -> bool {
        self.correction_word(tool) == Some("G44")
    }

    /// `G43` or `G44`, by the plan or else by the program.
    pub fn correction_word(&self, tool: usize) -> Option<&str> {
        let tool = self.stated.tools.get(tool)?;
        if let Some(word) = &tool.correction_word {
            return Some(&word.value);
        }
        let corrector = tool.figures.get(&Quantity::Corrector)?;
        self.calls.get(&(corrector.value as u32)).copied()
    }
}

/// The cutter of a tool that is named by its kind, its standard and its size alone: `Свердло ГОСТ 10903-77`, Ø10.
fn of_standard<'a>(stated: &Stated, tool: &Tool, auditor: &Auditor<'a>) -> Option<NamedCutter<'a>> {
    let has_number = |text: &Text| text.value.chars().any(|sign| sign.is_ascii_digit());
    let standard = &tool.standard.as_ref().filter(|_| !tool.designation.as_ref().is_some_and(has_number))?.value;
    let diameter = Micrometres::from_mm_rounded(tool.figures.get(&Quantity::Diameter)?.value);
    let alike = auditor.knowledge.rows::<StandardsAlike<'_>>().unwrap_or_default();
    let also: Vec<&str> =
        alike.iter().filter(|row| plain(row.standard) == plain(standard)).map(|row| row.tools).collect();
    let belongs = |cutter: &&NamedCutter<'a>| {
        let row = cutter.row.row;
        let of_table = row.table.standard.as_deref().is_some_and(|own| likeness(standard, own) == Likeness::Same);
        of_table || also.contains(&row.table.id.as_str())
    };
    let makes = |cutter: &&NamedCutter<'a>| {
        let mut rows = stated.rows_of_tool(tool.number);
        rows.all(|(_, row)| cutter.head.operations.contains(&row.operation.value))
    };
    let of_size = |cutter: &&NamedCutter<'a>| cutter.row.diameter == Some(diameter);
    auditor.cutters.values().find(|cutter| of_size(cutter) && makes(cutter) && belongs(cutter)).cloned()
}

/// The word with which a program calls each offset register.
fn calls(program: &str) -> BTreeMap<u32, &'static str> {
    let mut calls = BTreeMap::new();
    for line in program.lines() {
        let word = ["G43", "G44"].into_iter().find(|word| line.contains(word));
        let number: String = line
            .split_once('H')
            .map(|(_, rest)| rest.chars().take_while(char::is_ascii_digit).collect())
            .unwrap_or_default();
        if let Some((word, number)) = word.zip(number.parse().ok()) {
            calls.entry(number).or_insert(word);
        }
    }
    calls
}
