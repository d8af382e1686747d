//! The figures of a plan as a graph: which figure follows from which, its right value, and where a deviation begins.
//!
//! A figure is compared with its formula. Where it does not fit, the slip is its own. Where it fits only because one
//! of its inputs is wrong, it is a consequence and names the root. An author who misprints a figure but continues
//! with the right value makes one slip, not two; therefore a formula is tried with the stated and with the right
//! value of every input.

use std::cell::{OnceCell, RefCell};
use std::collections::{BTreeMap, BTreeSet};

use crate::note::{Because, Note, Severity};

use super::mistakes::OtherLaw;
use super::quantity::{Id, Quantity, Scope};
use super::stated::{Stated, StatedFigure};
use super::tolerance::Tolerances;

/// A rule that computes a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rule {
    /// Stable id; the message `audit-source-` with this id names its source.
    pub id: &'static str,
    /// Its formula in symbols.
    pub formula: &'static str,
}

/// The judgement of a chosen value: nothing against it, or severity and reason.
pub type Judged = Option<(Severity, Note)>;

mod what_if;

pub(super) type Compute<'a> = Box<dyn Fn(&[f64]) -> Option<f64> + 'a>;
/// Judges a stated value, given the inputs of its formula.
pub(super) type Judge<'a> = Box<dyn Fn(f64, &[f64]) -> Judged + 'a>;

/// Other laws of a formula, made when they are asked for.
pub(super) type Others<'a> = Box<dyn Fn() -> Vec<OtherLaw<'a>> + 'a>;

/// A rule applied to one figure.
pub struct Formula<'a> {
    /// The rule.
    pub rule: &'static Rule,
    /// What it computes.
    pub output: Id,
    /// What it computes it from.
    pub inputs: Vec<Id>,
    /// The formula with `{0}`, `{1}` … for the inputs.
    pub numbers: String,
    /// The computation.
    pub compute: Compute<'a>,
    /// For chosen values: whether a stated value is acceptable although it is not the computed one.
    pub judge: Option<Judge<'a>>,
    /// What comes out with other laws, for mistakes that are recognised.
    pub(super) others: Option<Others<'a>>,
    /// The rows it rests on.
    pub because: Vec<Because>,
}

/// A constant: its values in use, the exact one first.
#[derive(Clone, Debug)]
pub struct Constant {
    /// The values.
    pub values: Vec<f64>,
    /// The rows that give them.
    pub because: Vec<Because>,
}

/// The judgement of a stated figure.
#[derive(Clone, Debug, PartialEq)]
pub enum Status {
    /// It is as it should be.
    Fine,
    /// It is wrong by itself.
    Root(Severity, Option<Note>),
    /// It follows from figures that are wrong.
    Follows(BTreeSet<Id>),
}

/// A stated figure beside its formula.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The figure.
    pub id: Id,
    /// What it should be.
    pub right: f64,
    /// What the formula makes of the stated inputs, where that is another value.
    pub by_stated: Option<f64>,
    /// The inputs as the right value was computed from.
    pub inputs: Vec<f64>,
    /// Inputs that the plan does not state, computed or taken from tables.
    pub supplied: Vec<Id>,
    /// What became of it.
    pub status: Status,
}

/// The figures with their formulas.
pub struct Graph<'a> {
    stated: &'a Stated,
    tolerances: &'a Tolerances,
    constants: BTreeMap<Id, Constant>,
    formulas: BTreeMap<Id, Vec<Formula<'a>>>,
    right: RefCell<BTreeMap<Id, Option<f64>>>,
    open: RefCell<BTreeSet<Id>>,
    /// The formula used for each figure, where there are several.
    taken: RefCell<BTreeMap<Id, Option<usize>>>,
    /// For each figure, the figures computed from it.
    users: OnceCell<BTreeMap<Id, Vec<Id>>>,
    verdicts: OnceCell<Vec<Verdict>>,
    /// Misprinted figures, each with a figure that the author computed from the right value.
    misprinted: BTreeMap<Id, Id>,
    /// What the tables give for figures that no formula computes.
    tables: BTreeMap<Id, f64>,
    /// Stated figures that are known to be wrong or right.
    off: RefCell<BTreeMap<Id, bool>>,
    untried: RefCell<BTreeMap<Id, usize>>,
}

/// So many mixtures of stated and right inputs of one figure are tried.
pub(super) const MOST_MIXTURES: usize = 4096;

impl<'a> Graph<'a> {
    /// A graph without formulas.
    pub fn new(stated: &'a Stated, tolerances: &'a Tolerances) -> Self {
        Self {
            stated,
            tolerances,
            constants: BTreeMap::new(),
            formulas: BTreeMap::new(),
            right: RefCell::default(),
            open: RefCell::default(),
            taken: RefCell::default(),
            users: OnceCell::new(),
            verdicts: OnceCell::new(),
            misprinted: BTreeMap::new(),
            tables: BTreeMap::new(),
            off: RefCell::default(),
            untried: RefCell::default(),
        }
    }

    /// Adds a formula. Of several for one figure the first whose inputs are known is used.
    pub fn add(&mut self, formula: Formula<'a>) {
        self.formulas.entry(formula.output).or_default().push(formula);
    }

    /// Takes on a constant.
    pub fn constant(&mut self, id: Id, constant: Constant) {
        self.constants.insert(id, constant);
    }

    /// Adds table values for figures without a formula; they require nothing.
    pub fn add_table_values(&mut self, tables: BTreeMap<Id, f64>) {
        self.tables = tables;
    }

    /// What the tables give for figures that no formula computes.
    pub fn tables(&self) -> &BTreeMap<Id, f64> {
        &self.tables
    }

    /// The formula by which a figure is computed, if there is one whose inputs are known.
    pub fn formula(&self, id: Id) -> Option<&Formula<'a>> {
        let formulas = self.formulas.get(&id)?;
        if let Some(taken) = self.taken.borrow().get(&id) {
            return formulas.get((*taken)?);
        }
        let taken = formulas.iter().position(|formula| self.value_of(formula).is_some());
        // During a computation some figures are not known yet.
        if self.open.borrow().is_empty() {
            self.taken.borrow_mut().insert(id, taken);
        }
        formulas.get(taken?)
    }

    fn value_of(&self, formula: &Formula<'a>) -> Option<f64> {
        let inputs: Option<Vec<f64>> = formula.inputs.iter().map(|input| self.right(*input)).collect();
        (formula.compute)(&inputs?).filter(|value| value.is_finite())
    }

    /// The right value of a figure: by its formula, otherwise as stated. An acceptable choice is right.
    pub fn right(&self, id: Id) -> Option<f64> {
        if let Some(constant) = self.constants.get(&id) {
            return constant.values.first().copied();
        }
        if let Some(known) = self.right.borrow().get(&id) {
            return *known;
        }
        let stated = self.stated.figure(id).map(|figure| figure.value);
        // A formula that needs its own result does not help.
        if !self.open.borrow_mut().insert(id) {
            return stated;
        }
        let value = self.formula(id).and_then(|formula| {
            let inputs: Option<Vec<f64>> = formula.inputs.iter().map(|input| self.right(*input)).collect();
            let inputs = inputs?;
            match (&formula.judge, stated) {
                (Some(judge), Some(stated))
                    if may_stand(&judge(stated, &inputs)) && !self.fits_only_as_written(formula, stated, &inputs) =>
                {
                    Some(stated)
                }
                _ => {
                    let value = (formula.compute)(&inputs).filter(|value| value.is_finite())?;
                    // A plan of the program is printed from unrounded figures: the printed value is nearer to them
                    // than a value computed from other printed ones.
                    let figure = self.stated.figure(id).filter(|_| self.stated.is_own);
                    let nearer = figure.filter(|own| self.fits(id, own, value, self.slack(formula, &inputs)));
                    Some(nearer.map_or(value, |own| own.value))
                }
            }
        });
        let value = value.or(stated);
        self.open.borrow_mut().remove(&id);
        self.right.borrow_mut().insert(id, value);
        value
    }

    /// The stated value of a figure, otherwise its right value.
    pub fn stated_or_right(&self, id: Id) -> Option<f64> {
        self.stated.figure(id).map(|figure| figure.value).or_else(|| self.right(id))
    }

    /// The value of a figure as the plan has it: as stated, otherwise computed from stated values.
    pub(super) fn written(&self, id: Id) -> Option<f64> {
        self.written_if(id, None)
    }

    /// The rows behind a figure's formula and behind the constants it uses.
    pub fn because(&self, id: Id) -> Vec<Because> {
        let Some(formula) = self.formula(id) else { return Vec::new() };
        let constants = formula.inputs.iter().filter_map(|input| self.constants.get(input));
        formula.because.iter().cloned().chain(constants.flat_map(|constant| constant.because.clone())).collect()
    }

    /// The first row that conditions are for.
    pub(super) fn row_of(&self, scope: Scope) -> Option<usize> {
        match scope {
            Scope::Row(at) => Some(at),
            Scope::Conditions(at) => self.stated.conditions.get(at)?.rows.first().copied(),
            _ => None,
        }
    }

    /// The tool of conditions or of a row.
    pub(super) fn tool_of(&self, scope: Scope) -> Option<usize> {
        self.stated.tool_of(self.stated.rows.get(self.row_of(scope)?)?)
    }

    /// Whether a stated figure is what it should be, within its tolerance.
    fn fits(&self, id: Id, stated: &StatedFigure, value: f64, slack: f64) -> bool {
        (stated.value - value).abs() <= self.tolerances.allowed_difference(id.quantity, stated, value) + slack
    }

    /// Whether a figure, stated or computed from stated ones, differs from its right value.
    fn is_off(&self, id: Id) -> bool {
        let (Some(written), Some(right)) = (self.written(id), self.right(id)) else { return false };
        let Some(figure) = self.stated.figure(id) else {
            return (written - right).abs() > 1e-6 * right.abs().max(1.0) && !self.off_inputs(id).is_empty();
        };
        if let Some(known) = self.off.borrow().get(&id) {
            return *known;
        }
        // While its inputs are being judged, the figure is judged by itself.
        let alone = !self.fits(id, figure, right, 0.0);
        self.off.borrow_mut().insert(id, alone);
        // A difference explained by rounding of the inputs is no deviation.
        let off = alone && self.judged(id).is_none_or(|verdict| verdict.status != Status::Fine);
        self.off.borrow_mut().insert(id, off);
        off
    }

    /// The inputs of a figure's formula that differ from their right values.
    fn off_inputs(&self, id: Id) -> Vec<Id> {
        let inputs = self.formula(id).map(|formula| formula.inputs.as_slice()).unwrap_or_default();
        inputs.iter().copied().filter(|input| *input != id && self.is_off(*input)).collect()
    }

    /// Where the deviation of a figure begins.
    fn roots_of(&self, id: Id) -> BTreeSet<Id> {
        if self.stated.figure(id).is_none() {
            return self.off_inputs(id).into_iter().flat_map(|input| self.roots_of(input)).collect();
        }
        match self.judged(id).map(|verdict| verdict.status) {
            Some(Status::Follows(roots)) => roots,
            _ => BTreeSet::from([id]),
        }
    }

    /// The values that an input may have had when the author computed: as stated, as right, or any value in use.
    fn options(&self, input: Id) -> Vec<(f64, bool)> {
        if let Some(constant) = self.constants.get(&input) {
            return constant.values.iter().map(|value| (*value, false)).collect();
        }
        let right = self.right(input);
        let written = self.written(input);
        let mut options = Vec::new();
        options.extend(written.map(|written| (written, self.is_off(input))));
        options.extend(right.filter(|right| written != Some(*right)).map(|value| (value, false)));
        // Or as its table has it, where another value may stand: who prints another may have gone on with the table's.
        // How many clamps there are nobody looks up.
        let looked_up = |own: &&Formula<'a>| own.judge.is_some() && own.inputs.is_empty();
        let table = self.formula(input).filter(looked_up).filter(|_| input.quantity != Quantity::Clamps);
        let table = table.and_then(|own| (own.compute)(&[])).filter(|value| written != Some(*value));
        options.extend(table.filter(|value| right != Some(*value)).map(|value| (value, false)));
        // Or as it should be, rounded as the plan prints it.
        if let (Some(figure), Some(right)) = (self.stated.figure(input), right) {
            let rounded = (right / figure.last_place).round() * figure.last_place;
            options.extend((written != Some(rounded)).then_some((rounded, false)));
        }
        options
    }

    /// The first of these, and whether it may be wrong: the value the author saw. To find out whether it is wrong
    /// costs more.
    fn as_written(&self, input: Id) -> Option<(f64, bool)> {
        if let Some(constant) = self.constants.get(&input) {
            return constant.values.first().map(|value| (*value, false));
        }
        self.written(input).map(|written| (written, true)).or_else(|| Some((self.right(input)?, false)))
    }

    /// How much a result may differ because its inputs are printed rounded.
    fn slack(&self, formula: &Formula<'a>, inputs: &[f64]) -> f64 {
        let Some(middle) = (formula.compute)(inputs) else { return 0.0 };
        let mut slack = 0.0;
        let mut moved = inputs.to_vec();
        for (at, input) in formula.inputs.iter().enumerate() {
            let Some(figure) = self.stated.figure(*input) else { continue };
            // A formula gives an unrounded figure; only a plan of the program is printed from unrounded figures.
            let from_formula = !self.stated.is_own && self.formula(*input).is_some();
            if !self.tolerances.rounded(input.quantity) || from_formula {
                continue;
            }
            moved[at] += figure.last_place / 2.0;
            slack += (formula.compute)(&moved).map_or(0.0, |value| (value - middle).abs());
            moved[at] = inputs[at];
        }
        slack
    }

    /// The verdict on a stated figure; none if no formula computes it. Call it only when all formulas are added.
    pub fn verdict(&self, id: Id) -> Option<&Verdict> {
        let verdicts = self.verdicts();
        verdicts.binary_search_by(|verdict| verdict.id.cmp(&id)).ok().and_then(|at| verdicts.get(at))
    }

    fn judged(&self, id: Id) -> Option<Verdict> {
        let figure = self.stated.figure(id)?;
        let formula = self.formula(id)?;
        let right = self.right(id)?;
        let inputs: Vec<f64> = formula.inputs.iter().map(|input| self.right(*input)).collect::<Option<_>>()?;
        let stated_inputs: Vec<f64> = formula
            .inputs
            .iter()
            .zip(&inputs)
            .map(|(input, right)| self.as_written(*input).map_or(*right, |one| one.0))
            .collect();
        let by_stated = (formula.compute)(&stated_inputs);
        let supplied = formula.inputs.iter().copied();
        let supplied = supplied.filter(|id| !self.constants.contains_key(id) && self.stated.figure(*id).is_none());
        let mut verdict = Verdict { id, right, by_stated, inputs, supplied: supplied.collect(), status: Status::Fine };
        if let Some(judge) = &formula.judge {
            let judged = judge(figure.value, &verdict.inputs);
            if may_stand(&judged) && !self.fits_only_as_written(formula, figure.value, &verdict.inputs) {
                // Not the best, but acceptable: what follows from it is right.
                if let Some((severity, note)) = judged {
                    verdict.right = (formula.compute)(&verdict.inputs).unwrap_or(right);
                    verdict.status = Status::Root(severity, Some(note));
                }
                return Some(verdict);
            }
            // A right choice for wrong inputs.
            let by_wrong = judge(figure.value, &stated_inputs);
            let wrong = |at: usize| {
                let input = formula.inputs[at];
                self.as_written(input).is_some_and(|(_, may_be_off)| may_be_off && self.is_off(input))
            };
            let roots = self.roots(formula, wrong);
            verdict.status = match judged {
                _ if may_stand(&by_wrong) && !roots.is_empty() => Status::Follows(roots),
                Some((severity, note)) => Status::Root(severity, Some(note)),
                None => Status::Fine,
            };
            return Some(verdict);
        }
        if self.fits(id, figure, right, self.slack(formula, &verdict.inputs)) {
            return Some(verdict);
        }
        verdict.status = match self.explained(id, figure, formula) {
            Some(roots) if roots.is_empty() => Status::Fine,
            Some(roots) => Status::Follows(roots),
            None => Status::Root(self.tolerances.severity(id.quantity), None),
        };
        Some(verdict)
    }

    /// Whether a chosen value is out of line only because the plan states other inputs than it should: by those it is
    /// what the formula gives, and by the right ones there is something against it.
    fn fits_only_as_written(&self, formula: &Formula<'a>, stated: f64, right: &[f64]) -> bool {
        let Some(judge) = formula.judge.as_ref().filter(|_| !self.stated.is_own) else { return false };
        let against = |inputs: &[f64]| judge(stated, inputs).is_some_and(|(severity, _)| severity < Severity::Note);
        let mut inputs = right.to_vec();
        for ((input, value), right) in formula.inputs.iter().zip(&mut inputs).zip(right) {
            let Some(written) = self.written(*input).filter(|_| !self.constants.contains_key(input)) else { continue };
            // What rounding explains is no other input.
            let same = self.stated.figure(*input).is_none_or(|figure| self.fits(*input, figure, *right, 0.0));
            *value = if same { *right } else { written };
        }
        inputs != right && against(right) && !against(&inputs)
    }

    /// Whether some combination of stated and right inputs gives the stated result; returns the wrong inputs.
    fn explained(&self, id: Id, figure: &StatedFigure, formula: &Formula<'a>) -> Option<BTreeSet<Id>> {
        let options: Vec<Vec<(f64, bool)>> = formula.inputs.iter().map(|input| self.options(*input)).collect();
        // Only inputs with different values are tried.
        let total = options.iter().fold(1_usize, |total, one| total.saturating_mul(one.len().max(1)));
        let mut best: Option<BTreeSet<Id>> = None;
        for number in 0..total.min(MOST_MIXTURES) {
            let mut rest = number;
            let picked: Option<Vec<(f64, bool)>> = options
                .iter()
                .map(|own| {
                    let at = rest % own.len().max(1);
                    rest /= own.len().max(1);
                    own.get(at).copied()
                })
                .collect();
            let picked = picked?;
            let values: Vec<f64> = picked.iter().map(|one| one.0).collect();
            let Some(value) = (formula.compute)(&values) else { continue };
            if !self.fits(id, figure, value, self.slack(formula, &values)) {
                continue;
            }
            let roots = self.roots(formula, |at| picked[at].1);
            if best.as_ref().is_none_or(|known| roots.len() < known.len()) {
                best = Some(roots);
            }
        }
        if best.is_none() && total > MOST_MIXTURES {
            self.untried.borrow_mut().insert(id, total);
        }
        best
    }

    /// The figures of which not every mixture of inputs was tried, with how many there are.
    pub(super) fn untried(&self) -> Vec<(Id, usize)> {
        self.untried.borrow().iter().map(|(id, total)| (*id, *total)).collect()
    }

    /// The roots of the inputs that `wrong` picks.
    fn roots(&self, formula: &Formula<'a>, wrong: impl Fn(usize) -> bool) -> BTreeSet<Id> {
        let inputs = formula.inputs.iter().enumerate().filter(|(at, _)| wrong(*at));
        inputs.flat_map(|(_, input)| self.roots_of(*input)).collect()
    }

    /// Every stated figure with a formula, with its verdict. Call it only when all formulas are added.
    pub fn verdicts(&self) -> &[Verdict] {
        self.verdicts.get_or_init(|| self.formulas.keys().filter_map(|id| self.judged(*id)).collect())
    }

    fn users(&self) -> &BTreeMap<Id, Vec<Id>> {
        self.users.get_or_init(|| {
            let mut users: BTreeMap<Id, Vec<Id>> = BTreeMap::new();
            for output in self.formulas.keys() {
                for input in self.formula(*output).map(|formula| formula.inputs.as_slice()).unwrap_or_default() {
                    users.entry(*input).or_default().push(*output);
                }
            }
            users
        })
    }

    /// All figures that depend on a figure, directly or not. Call it only when all formulas are added.
    pub fn dependents(&self, id: Id) -> BTreeSet<Id> {
        let users = self.users();
        let mut found = BTreeSet::new();
        let mut open = vec![id];
        while let Some(next) = open.pop() {
            for output in users.get(&next).into_iter().flatten() {
                if *output != id && found.insert(*output) {
                    open.push(*output);
                }
            }
        }
        found
    }
}

/// Whether a judged choice is acceptable: without objection, or with a better one available.
fn may_stand(judged: &Judged) -> bool {
    judged.as_ref().is_none_or(|(severity, _)| *severity >= Severity::Doubtful)
}
