//! Reads the file of a turned part.

use std::collections::BTreeMap;

use crate::knowledge::form::{Form, KeyOf, similar_key};
use crate::knowledge::yaml::{Node, NodeKind, parse};
use crate::knowledge::{Diagnostic, Knowledge};
use crate::note::Finding;
use crate::turning::contour::{Profile, Side};
use crate::turning::reading::{Mistake, Placed, Reader, given, mistake};
use crate::turning::shaft::{Holding, Shaft};
use crate::units::Micrometres;

use super::check;
use super::file::WorkpieceFile;
use super::items::Owner;
use super::lengths;
use super::steps;
use super::walk::{Walked, walk};
use super::{Allowances, Blank, Drawings, HeatTreatment, JawKind, Roughing, Thread, Workpiece};

type F = WorkpieceFile;

/// Reads the file of a turned part, by its contour (`outer`) or by steps.
///
/// # Errors
/// Every mistake of the file, each with its place, in the order of the file; a file with both or neither is one.
pub fn read_turned(file: &str, text: &str, knowledge: &Knowledge) -> Result<Workpiece, Vec<Mistake>> {
    read_turned_with(file, text, &Drawings::NONE, knowledge)
}

/// The same for a file whose contours name other files ([`super::files_named`]).
///
/// # Errors
/// As for [`read_turned`]; or a table of points or a drawing is not there or cannot be used, with its own place.
pub fn read_turned_with(
    file: &str,
    text: &str,
    drawings: &Drawings,
    knowledge: &Knowledge,
) -> Result<Workpiece, Vec<Mistake>> {
    let (root, problems) = parse(file, text);
    turned(root.as_ref(), problems, drawings, knowledge)
}

/// The same for a turned part inside another file.
///
/// # Errors
/// As for [`read_turned`].
pub fn read_turned_node(node: &Node, knowledge: &Knowledge) -> Result<Workpiece, Vec<Mistake>> {
    turned(Some(node), Vec::new(), &Drawings::NONE, knowledge)
}

fn turned(
    root: Option<&Node>,
    problems: Vec<Diagnostic>,
    drawings: &Drawings,
    knowledge: &Knowledge,
) -> Result<Workpiece, Vec<Mistake>> {
    let mut reader = Reader::over(problems, drawings, knowledge);
    let workpiece = root.and_then(|root| reader.workpiece(root));
    reader.close(workpiece)
}

/// Keys that a part given by steps cannot have.
const ONLY_OF_CONTOURS: [KeyOf<F>; 3] = [F::outer, F::inner, F::allowances];

/// How a file gives its outside.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Outside {
    Contour,
    Steps,
    /// It is not there, not even mistyped.
    Missing,
}

impl Outside {
    /// A file without either key is meant as a contour if it has a key that only contours have.
    fn of(root: &Node) -> Self {
        let keys: Vec<&str> = match &root.kind {
            NodeKind::Map(entries) => entries.iter().map(|(key, _)| key.text.as_str()).collect(),
            _ => Vec::new(),
        };
        let has = |key: KeyOf<F>| keys.contains(&key.name());
        let nearly = |key: KeyOf<F>| keys.iter().any(|typed| similar_key(typed, &[key.name()]).is_some());
        if has(F::outer) {
            Self::Contour
        } else if has(F::steps) || nearly(F::steps) {
            Self::Steps
        } else if ONLY_OF_CONTOURS.into_iter().any(nearly) {
            Self::Contour
        } else {
            Self::Missing
        }
    }
}

/// The contours of a part.
struct Contours {
    outer: Profile,
    inner: Option<Profile>,
    threads: Vec<Thread>,
    findings: Vec<Finding>,
}

impl Reader<'_> {
    fn workpiece(&mut self, root: &Node) -> Option<Workpiece> {
        let outside = Outside::of(root);
        let mut fields = self.problems.map(root)?;
        let name = fields.need(F::shaft, &mut self.problems).and_then(|node| self.name(node));
        let material = fields.need(F::material, &mut self.problems).and_then(|node| self.stated_material(node));
        let blank_node = fields.need(F::blank, &mut self.problems);
        let machine = given(fields.take(F::machine), |node| self.lathe(node));
        let holding = given(fields.take(F::holding), |node| self.choice(node, Holding::NAMES));
        let jaws = given(fields.take(F::jaws), |node| self.choice(node, JawKind::NAMES));
        let rest_node = fields.take(F::steady_rest);
        let heat_treatment = given(fields.take(F::heat_treatment), |node| self.choice(node, HeatTreatment::NAMES));
        let steps_node = match outside {
            Outside::Steps => fields.need(F::steps, &mut self.problems),
            Outside::Missing => self.fault(mistake!("neither-steps-nor-outer"), fields.place),
            Outside::Contour => {
                if let Some(steps) = fields.take(F::steps) {
                    self.fault::<()>(mistake!("both-steps-and-outer"), &steps.place);
                }
                None
            }
        };
        let of_contour = outside == Outside::Contour;
        let outer_node = if of_contour { fields.need(F::outer, &mut self.problems) } else { None };
        let [inner_node, allowances_node] =
            [F::inner, F::allowances].map(|key| if of_contour { fields.take(key) } else { None });
        let roughing_node =
            if of_contour { fields.take(F::roughing) } else { fields.need(F::roughing, &mut self.problems) };
        let rates = given(fields.take(F::rates), |node| self.rates(node));
        let foreign: &[KeyOf<F>] = if of_contour { &[F::steps] } else { &ONLY_OF_CONTOURS };
        let is_foreign = |key: &KeyOf<F>| foreign.iter().any(|other| other.name() == key.name());
        let known: Vec<KeyOf<F>> = F::KEYS.iter().copied().filter(|key| !is_foreign(key)).collect();
        fields.finish_among(&known, &mut self.problems);

        let steps = steps_node.and_then(|node| self.steps(node));
        let blank = blank_node.and_then(|node| self.blank(node, steps.as_ref()));
        let stock = blank.as_ref().map(|read| &read.blank);
        let steady_rest = given(rest_node, |node| self.steady_rest(node, stock?));
        let rates = rates?;
        let (contours, roughing, allowances, shaft) = if of_contour {
            let roughing = given(roughing_node, |node| self.roughing(node));
            let allowances = given(allowances_node, |node| self.allowances(node));
            let contours = outer_node.and_then(|node| self.contours(node, inner_node, stock));
            (contours?, roughing?.unwrap_or_default(), allowances?.unwrap_or_default(), None)
        } else {
            let depths = roughing_node.and_then(|node| self.depths(node));
            let (steps, blank) = (steps.as_ref()?.whole()?, blank.as_ref()?);
            let (outer, main) = (steps::outer(&steps), rates.map(|rates| rates.main));
            let shaft =
                Shaft { blank: blank.sizes?, blank_steps: blank.steps.clone(), steps, roughing: depths?, rates: main };
            if let Some(node) = roughing_node.filter(|_| self.meant.is_empty()) {
                self.check_grid(&shaft, &node.place);
            }
            let contours = Contours { outer, inner: None, threads: Vec::new(), findings: Vec::new() };
            // Its limiting depth is the longitudinal one, and its diameters are those after roughing.
            let roughing = Roughing { limiting_depth: Some(shaft.roughing.longitudinal_depth), scheme: None };
            let none = Allowances::Stated { on_diameter: Micrometres::ZERO, on_face: Micrometres::ZERO };
            (contours, roughing, none, Some(shaft))
        };
        let (material, material_state) = material?;
        Some(Workpiece {
            name: name?,
            material,
            material_state,
            blank: blank?.blank,
            machine: machine?,
            holding: holding?.unwrap_or_default(),
            jaws: jaws?.unwrap_or_default(),
            steady_rest: steady_rest?,
            heat_treatment: heat_treatment?.unwrap_or_default(),
            outer: contours.outer,
            inner: contours.inner,
            threads: contours.threads,
            roughing,
            allowances,
            rates,
            shaft,
            findings: contours.findings,
        })
    }

    /// The contours of a part, compared with each other and with the blank.
    fn contours(&mut self, outer: &Node, inner: Option<&Node>, blank: Option<&Blank>) -> Option<Contours> {
        let (outer, outer_names) = self.contour(outer, Side::Outer);
        let (inner, inner_names) = inner.map(|node| self.contour(node, Side::Inner)).unzip();
        self.names(outer_names.into_iter().chain(inner_names.into_iter().flatten()));
        check::ends(&outer, inner.as_ref(), blank, self);
        let start = |walked: &Walked| walked.start.as_ref().map(|(start, _)| *start);
        let together = |inner: &&Walked| inner.whole && outer.whole && start(inner) == start(&outer);
        if let Some(inner) = inner.as_ref().filter(together) {
            check::walls(&outer, inner, self);
        }
        if let Some(blank) = blank {
            check::within_blank(&outer, inner.as_ref(), blank, self);
        }
        let inner_profile = given(inner.as_ref(), Walked::profile)?;
        let walked = || std::iter::once(&outer).chain(&inner);
        let (outer_profile, inner_profile) = lengths::in_the_middle(outer.profile()?, inner_profile);
        Some(Contours {
            outer: outer_profile,
            inner: inner_profile,
            threads: walked().flat_map(|walked| walked.threads.clone()).collect(),
            findings: walked().flat_map(|walked| walked.findings.clone()).collect(),
        })
    }

    /// A contour of the part, with the names of its items.
    fn contour(&mut self, node: &Node, side: Side) -> (Walked, Vec<Placed<String>>) {
        let items = self.items(node, side, Owner::Part);
        let names = items.iter().flatten().filter_map(|item| item.attributes.name.clone()).collect();
        let walked = walk(&items, side, self);
        if walked.whole {
            check::crosses_itself(&walked, self);
        }
        (walked, names)
    }

    /// Checks that no name is given twice.
    fn names(&mut self, names: impl Iterator<Item = Placed<String>>) {
        let mut known: BTreeMap<String, u32> = BTreeMap::new();
        for (name, place) in names {
            match known.get(&name) {
                Some(line) => {
                    self.fault::<()>(mistake!("name-twice", surface = name, line = line), &place);
                }
                None => {
                    known.insert(name, place.line);
                }
            }
        }
    }
}
