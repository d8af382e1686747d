//! Reads the file of a turned part in either form; the contour form is here.

use std::collections::BTreeMap;

use crate::knowledge::form::{Form, similar_key};
use crate::knowledge::yaml::{Node, NodeKind, missing_key, parse};
use crate::knowledge::{Diagnostic, Knowledge};
use crate::turning::contour::Side;
use crate::turning::reading::{Mistake, Placed, Reader, given, mistake};
use crate::turning::shaft::Holding;
use crate::turning::shaft::file::ShaftFile;

use super::check;
use super::file::WorkpieceFile;
use super::items::Owner;
use super::lengths;
use super::walk::{Walked, walk};
use super::{Drawings, HeatTreatment, JawKind, Turned, Workpiece};

/// Reads the file of a turned part: with `steps` it is a stepped shaft, with `outer` a contour.
///
/// # Errors
/// Every mistake of the file, each with its place, in the order of the file; a file with both or neither is one.
pub fn read_turned(file: &str, text: &str, knowledge: &Knowledge) -> Result<Turned, Vec<Mistake>> {
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
) -> Result<Turned, Vec<Mistake>> {
    let (root, problems) = parse(file, text);
    turned(root, problems, drawings, knowledge)
}

/// The same for a turned part inside another file.
///
/// # Errors
/// As for [`read_turned`].
pub fn read_turned_node(node: &Node, knowledge: &Knowledge) -> Result<Turned, Vec<Mistake>> {
    turned(Some(node.clone()), Vec::new(), &Drawings::NONE, knowledge)
}

fn turned(
    root: Option<Node>,
    problems: Vec<Diagnostic>,
    drawings: &Drawings,
    knowledge: &Knowledge,
) -> Result<Turned, Vec<Mistake>> {
    let keys: Vec<&str> = match root.as_ref().map(|root| &root.kind) {
        Some(NodeKind::Map(entries)) => entries.iter().map(|(key, _)| key.text.as_str()).collect(),
        _ => Vec::new(),
    };
    let has = |key: &str| keys.contains(&key);
    let nearly = |key: &str| keys.iter().any(|typed| similar_key(typed, &[key]).is_some());
    let (outer, steps) = (WorkpieceFile::outer.name(), ShaftFile::steps.name());
    // Keys that only the contour form has: a file with one of them and without `outer` is meant as a contour.
    let shafts: Vec<&str> = ShaftFile::KEYS.iter().map(|key| key.name()).collect();
    let mut only = WorkpieceFile::KEYS.iter().map(|key| key.name()).filter(|key| !shafts.contains(key));
    let contour = has(outer) || !has(steps) && !nearly(steps) && only.any(nearly);
    let mut reader = Reader { drawings, ..Reader::over(problems, knowledge) };
    if contour {
        let workpiece = root.and_then(|root| reader.workpiece(&root));
        return reader.close(workpiece).map(|workpiece| Turned::Contoured(Box::new(workpiece)));
    }
    let shaft = root.as_ref().and_then(|root| reader.shaft(root));
    let read = reader.close(shaft).map(Turned::Stepped);
    // For a file with neither key, that is the mistake, not the missing key of one form.
    read.map_err(|mut mistakes| {
        let Some(place) = root.map(|root| root.place) else { return mistakes };
        let lacks = missing_key(steps, &place);
        let all = mistakes.len();
        let is_lack = |problem: &Diagnostic| problem.message == lacks.message && problem.place == lacks.place;
        mistakes.retain(|one| !matches!(one, Mistake::Form(problem) if is_lack(problem)));
        if mistakes.len() < all {
            mistakes.push(Mistake::of("neither-steps-nor-outer", &place));
            mistakes.sort_by(|a, b| a.place().cmp(&b.place()));
        }
        mistakes
    })
}

/// Reads the contour form.
///
/// # Errors
/// Every mistake of the file, each with its place, in the order of the file.
pub fn read_workpiece(file: &str, text: &str, knowledge: &Knowledge) -> Result<Workpiece, Vec<Mistake>> {
    let (mut reader, root) = Reader::open(file, text, knowledge);
    let workpiece = root.and_then(|root| reader.workpiece(&root));
    reader.close(workpiece)
}

impl Reader<'_> {
    fn workpiece(&mut self, root: &Node) -> Option<Workpiece> {
        let mut fields = self.problems.map(root)?;
        let name = fields.need(WorkpieceFile::shaft, &mut self.problems).and_then(|node| self.name(node));
        let material =
            fields.need(WorkpieceFile::material, &mut self.problems).and_then(|node| self.stated_material(node));
        let blank_node = fields.need(WorkpieceFile::blank, &mut self.problems);
        let machine = given(fields.take(WorkpieceFile::machine), |node| self.lathe(node));
        let holding = given(fields.take(WorkpieceFile::holding), |node| self.choice(node, Holding::NAMES));
        let jaws = given(fields.take(WorkpieceFile::jaws), |node| self.choice(node, JawKind::NAMES));
        let rest_node = fields.take(WorkpieceFile::steady_rest);
        let heat_treatment =
            given(fields.take(WorkpieceFile::heat_treatment), |node| self.choice(node, HeatTreatment::NAMES));
        let (outer_node, inner_node) =
            (fields.need(WorkpieceFile::outer, &mut self.problems), fields.take(WorkpieceFile::inner));
        let roughing = given(fields.take(WorkpieceFile::roughing), |node| self.roughing(node));
        let allowances = given(fields.take(WorkpieceFile::allowances), |node| self.allowances(node));
        let rates = given(fields.take(WorkpieceFile::rates), |node| self.all_rates(node));
        if let Some(steps) = fields.take_foreign(ShaftFile::steps) {
            self.fault::<()>(mistake!("both-steps-and-outer"), &steps.place);
        }
        fields.finish(&mut self.problems);

        let blank = blank_node.and_then(|node| self.blank(node));
        let (outer, outer_names) = outer_node.map(|node| self.contour(node, Side::Outer)).unzip();
        let (inner, inner_names) = inner_node.map(|node| self.contour(node, Side::Inner)).unzip();
        self.names(outer_names.into_iter().chain(inner_names).flatten());
        let outer = outer?;
        check::ends(&outer, inner.as_ref(), blank.as_ref(), self);
        let start = |walked: &Walked| walked.start.as_ref().map(|(start, _)| *start);
        let together = |inner: &&Walked| inner.whole && outer.whole && start(inner) == start(&outer);
        if let Some(inner) = inner.as_ref().filter(together) {
            check::walls(&outer, inner, self);
        }
        if let Some(blank) = &blank {
            check::within_blank(&outer, inner.as_ref(), blank, self);
        }
        let inner_profile = given(inner.as_ref(), Walked::profile)?;
        let steady_rest = given(rest_node, |node| self.steady_rest(node, blank.as_ref()?))?;
        let walked = || std::iter::once(&outer).chain(&inner);
        let (outer_profile, inner_profile) = lengths::in_the_middle(outer.profile()?, inner_profile);
        let (material, material_state) = material?;
        Some(Workpiece {
            name: name?,
            material,
            material_state,
            blank: blank?,
            machine: machine?,
            holding: holding?.unwrap_or_default(),
            jaws: jaws?.unwrap_or_default(),
            steady_rest,
            heat_treatment: heat_treatment?.unwrap_or_default(),
            outer: outer_profile,
            inner: inner_profile,
            threads: walked().flat_map(|walked| walked.threads.clone()).collect(),
            roughing: roughing?.unwrap_or_default(),
            allowances: allowances?.unwrap_or_default(),
            rates: rates?,
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
