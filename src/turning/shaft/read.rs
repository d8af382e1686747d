//! The shaft file: YAML to [`Shaft`], collecting every mistake.

use crate::knowledge::diagnostic::{Diagnostic, Place, Severity, nearest};
use crate::knowledge::yaml::{Fields, Node, Problems, parse};
use crate::knowledge::{Knowledge, Table};
use crate::note::Note;
use crate::units::{Micrometres, MillimetresPerMinute};

use super::check;
use super::keys::{BLANK, RATES, ROUGHING, SHAFT, STEP};
use super::shape::{self, Shape};
use super::{Blank, BlankKind, Division, Holding, Moves, Rates, Roughing, Shaft, Step};

/// The largest length or diameter of a file, mm: sums of passes stay exact.
const LARGEST: Micrometres = Micrometres::from_mm(100_000);
/// The approach where the file gives rates and no approach, mm: our choice; the lecture names δ without a figure.
const APPROACH: Micrometres = Micrometres::from_mm(2);
/// The retract where the file gives rates and no retract: 0.5 mm (lecture 12.4).
const RETRACT: Micrometres = Micrometres::new(500);

/// A mistake of a shaft file.
#[derive(Clone, Debug)]
pub enum Mistake {
    /// Of the file's form: how it is written.
    Form(Diagnostic),
    /// Of what it says, by the code that is the note's too: `report::sentence` and `report::remedy` have the words.
    Meaning(&'static str, Note, Place),
}

impl Mistake {
    /// Where it stands.
    pub const fn place(&self) -> Option<&Place> {
        match self {
            Self::Form(diagnostic) => diagnostic.place.as_ref(),
            Self::Meaning(_, _, place) => Some(place),
        }
    }

    /// Its code.
    pub const fn code(&self) -> &'static str {
        match self {
            Self::Form(diagnostic) => diagnostic.code,
            Self::Meaning(code, ..) => code,
        }
    }
}

/// Reads a shaft file.
///
/// # Errors
/// Every mistake of the file, each with its place, in the order of the file.
pub fn read_shaft(file: &str, text: &str, knowledge: &Knowledge) -> Result<Shaft, Vec<Mistake>> {
    let (root, diagnostics) = parse(file, text);
    let mut reader = Reader { knowledge, problems: Problems(diagnostics), meant: Vec::new(), shape: None };
    let shaft = root.and_then(|root| reader.shaft(&root));
    let Reader { problems, meant, .. } = reader;
    let broken = !meant.is_empty() || problems.0.iter().any(|problem| problem.severity == Severity::Error);
    match shaft {
        Some(shaft) if !broken => Ok(shaft),
        _ => {
            let form = problems.0.into_iter().map(Mistake::Form);
            let mut all: Vec<Mistake> = form.chain(meant).collect();
            all.sort_by(|a, b| a.place().cmp(&b.place()));
            Err(all)
        }
    }
}

/// A value with its place.
pub(super) type Placed<T> = (T, Place);

/// A step as far as it could be read.
pub(super) struct PlacedStep {
    pub(super) diameter: Option<Placed<Micrometres>>,
    pub(super) length: Option<Placed<Micrometres>>,
}

pub(super) struct Reader<'a> {
    knowledge: &'a Knowledge,
    problems: Problems,
    meant: Vec<Mistake>,
    /// The steps of the blank, as far as they could be read.
    shape: Option<Shape>,
}

impl Reader<'_> {
    /// Notes a mistake of meaning with its figures.
    pub(super) fn fault<T>(
        &mut self,
        code: &'static str,
        figures: &[(&str, &dyn std::fmt::Display)],
        place: &Place,
    ) -> Option<T> {
        let note = figures.iter().fold(Note::new(code), |note, (name, value)| note.with(name, value));
        self.meant.push(Mistake::Meaning(code, note, place.clone()));
        None
    }

    fn shaft(&mut self, root: &Node) -> Option<Shaft> {
        let mut fields = self.problems.map(root)?;
        let name = fields.need("shaft", &mut self.problems).and_then(|node| self.name(node));
        let material = fields.need("material", &mut self.problems).and_then(|node| self.material(node));
        let blank_node = fields.need("blank", &mut self.problems);
        let holding = match fields.take("holding") {
            Some(node) => self.choice(node, &[("chuck", Holding::Chuck), ("centres", Holding::Centres)]),
            None => Some(Holding::default()),
        };
        let steps_node = fields.need("steps", &mut self.problems);
        let roughing_node = fields.need("roughing", &mut self.problems);
        let rates_node = fields.take("rates");
        fields.finish(SHAFT, &mut self.problems);

        let (kind, diameter, length) = blank_node.map_or((None, None, None), |node| self.blank(node));
        let steps = steps_node.map(|node| self.steps(node)).unwrap_or_default();
        let roughing = roughing_node.and_then(|node| self.roughing(node));
        let rates = match rates_node {
            Some(node) => self.rates(node).map(Some),
            None => Some(None),
        };
        check::steps(&steps, diameter.as_ref(), length.as_ref(), self);
        let shape = self.shape.take();
        if let Some(shape) = &shape {
            shape::check(shape, kind, &steps, diameter.as_ref(), length.as_ref(), self);
        }
        let whole = |step: PlacedStep| Some(Step { diameter: step.diameter?.0, length: step.length?.0 });
        let shaft = Shaft {
            shaft: name?,
            material: material?,
            blank: Blank { kind: kind?, diameter: diameter?.0, length: length?.0 },
            blank_steps: shape.map_or(Some(Vec::new()), |shape| shape.steps.into_iter().map(whole).collect())?,
            holding: holding?,
            steps: steps.into_iter().map(whole).collect::<Option<_>>()?,
            roughing: roughing?,
            rates: rates?,
        };
        if let Some(node) = roughing_node.filter(|_| self.meant.is_empty()) {
            check::grid(&shaft, &node.place, self);
        }
        Some(shaft)
    }

    fn name(&mut self, node: &Node) -> Option<String> {
        let text = self.problems.text(node)?.trim();
        if text.is_empty() {
            return self.fault("empty-name", &[], &node.place);
        }
        Some(text.to_owned())
    }

    /// The id of a material, by itself or by an alias.
    fn material(&mut self, node: &Node) -> Option<String> {
        let text = self.problems.text(node)?.to_owned();
        let names = |table: &str, column: &'static str| {
            let rows = self.knowledge.table(table).into_iter().flat_map(Table::all_rows);
            rows.filter_map(move |row| Some((row.text(column).ok()?, row.text("id").ok()?)))
        };
        let known: Vec<(&str, &str)> = names("materials", "id").chain(names("material-aliases", "alias")).collect();
        if let Some((_, id)) = known.iter().find(|(name, _)| *name == text) {
            return Some((*id).to_owned());
        }
        let near = nearest(&text, known.iter().map(|(name, _)| *name)).map(str::to_owned);
        match near {
            Some(near) => self.fault("unknown-material-near", &[("material", &text), ("near", &near)], &node.place),
            None => self.fault("unknown-material", &[("material", &text)], &node.place),
        }
    }

    fn choice<T: Copy>(&mut self, node: &Node, choices: &[(&str, T)]) -> Option<T> {
        let text = self.problems.text(node)?.to_owned();
        if let Some((_, value)) = choices.iter().find(|(name, _)| *name == text) {
            return Some(*value);
        }
        let known = choices.iter().map(|(name, _)| format!("`{name}`")).collect::<Vec<_>>().join(", ");
        self.fault("no-such-choice", &[("word", &text), ("known", &known)], &node.place)
    }

    /// A length above zero, with its place.
    fn length(&mut self, node: Option<&Node>, key: &str) -> Option<Placed<Micrometres>> {
        let node = node?;
        let length = self.problems.scalar::<Micrometres>(node)?;
        if length <= Micrometres::ZERO {
            return self.fault("not-above-zero", &[("key", &key), ("length", &length)], &node.place);
        }
        if length > LARGEST {
            let figures: [(&str, &dyn std::fmt::Display); 3] = [("key", &key), ("length", &length), ("most", &LARGEST)];
            return self.fault("length-too-large", &figures, &node.place);
        }
        Some((length, node.place.clone()))
    }

    fn need(&mut self, fields: &mut Fields<'_>, key: &str) -> Option<Placed<Micrometres>> {
        let node = fields.need(key, &mut self.problems);
        self.length(node, key)
    }

    #[allow(clippy::type_complexity, reason = "the three fields, each as far as it could be read")]
    fn blank(&mut self, node: &Node) -> (Option<BlankKind>, Option<Placed<Micrometres>>, Option<Placed<Micrometres>>) {
        let Some(mut fields) = self.problems.map(node) else { return (None, None, None) };
        let kinds = [BlankKind::Bar, BlankKind::Forging, BlankKind::Casting].map(|kind| (kind.name(), kind));
        let kind = fields.need("kind", &mut self.problems).and_then(|node| self.choice(node, &kinds));
        let diameter = self.need(&mut fields, "diameter");
        let length = self.need(&mut fields, "length");
        self.shape = fields.take("steps").map(|node| Shape { steps: self.steps(node), place: node.place.clone() });
        fields.finish(BLANK, &mut self.problems);
        (kind, diameter, length)
    }

    fn steps(&mut self, node: &Node) -> Vec<PlacedStep> {
        let Some(nodes) = self.problems.list(node) else { return Vec::new() };
        if nodes.is_empty() {
            self.fault::<()>("no-steps", &[], &node.place);
        }
        let mut steps = Vec::new();
        for node in nodes {
            let Some(mut fields) = self.problems.map(node) else { continue };
            let diameter = self.need(&mut fields, "diameter");
            let length = self.need(&mut fields, "length");
            fields.finish(STEP, &mut self.problems);
            steps.push(PlacedStep { diameter, length });
        }
        steps
    }

    fn roughing(&mut self, node: &Node) -> Option<Roughing> {
        let mut fields = self.problems.map(node)?;
        let longitudinal = self.need(&mut fields, "longitudinal_depth");
        let transverse = self.need(&mut fields, "transverse_depth");
        let division = match fields.take("division") {
            Some(node) => self.choice(node, &[("full", Division::Full), ("equal", Division::Equal)]),
            None => Some(Division::default()),
        };
        let moves = match fields.take("moves") {
            Some(node) => self.choice(node, &[("basic", Moves::Basic), ("rich", Moves::Rich)]),
            None => Some(Moves::default()),
        };
        fields.finish(ROUGHING, &mut self.problems);
        Some(Roughing {
            longitudinal_depth: longitudinal?.0,
            transverse_depth: transverse?.0,
            division: division?,
            moves: moves?,
        })
    }

    fn rates(&mut self, node: &Node) -> Option<Rates> {
        let mut fields = self.problems.map(node)?;
        let longitudinal = self.need(&mut fields, "longitudinal_feed");
        let transverse = self.need(&mut fields, "transverse_feed");
        let rapid = self.need(&mut fields, "rapid");
        let mut optional = |key: &str, default: Micrometres, reader: &mut Self| match fields.take(key) {
            None => Some(default),
            Some(node) => reader.length(Some(node), key).map(|(length, _)| length),
        };
        let approach = optional("approach", APPROACH, self);
        let retract = optional("retract", RETRACT, self);
        fields.finish(RATES, &mut self.problems);
        Some(Rates {
            longitudinal_feed: MillimetresPerMinute(longitudinal?.0.to_mm()),
            transverse_feed: MillimetresPerMinute(transverse?.0.to_mm()),
            rapid: MillimetresPerMinute(rapid?.0.to_mm()),
            approach: approach?,
            retract: retract?,
        })
    }
}
