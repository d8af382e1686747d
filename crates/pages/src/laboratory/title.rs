//! The title block of a report: who hands in what. A file of its own, so that one serves for many parts.

use schemars::{Schema, schema_for};
use technolog_knowledge::forms;

use crate::job::GivenTimes;
use crate::knowledge::Diagnostic;
use crate::knowledge::form::KeyOf;
use crate::knowledge::yaml::{Fields, Node, Problems, parse};
use crate::units::{Decimal, Minutes};
use technolog_note::note;

use super::PARTS;

/// The JSON Schema of the file.
pub fn schema() -> Schema {
    schema_for!(TitleBlock)
}

forms! {
    /// The title block of `technolog report --title`. Everything may be left out.
    #[derive(Default, PartialEq)]
    pub struct TitleBlock {
        /// University, plant.
        pub institution: Option<String>,
        /// Department, workshop.
        pub department: Option<String>,
        /// The name of the work: the title of the report.
        pub work: Option<String>,
        /// Its author.
        pub author: Option<String>,
        /// The author's group.
        pub group: Option<String>,
        /// The variant of the task.
        pub variant: Option<String>,
        /// Who accepts it.
        pub lecturer: Option<String>,
        /// The date, as it is to be printed.
        pub date: Option<String>,
        /// The aim of the work (part 1).
        pub aim: Option<String>,
        /// The task in words (part 2).
        pub task: Option<String>,
        /// How the fixture locates the part, in words (part 10).
        pub fixture: Option<String>,
        /// The author's conclusions (part 16).
        pub conclusions: Option<String>,
        /// How many parts a lot has, for the time per piece with the share of the lot.
        pub lot: Option<u32>,
        /// The shop's own time to load, clamp and unload a part, min.
        pub loading: Option<f64>,
        /// The shop's own time to prepare and close a lot, min.
        pub preparatory: Option<f64>,
        /// The workshop that makes the part, on the route card.
        pub shop: Option<String>,
        /// The trade of the operator, on the route card.
        pub profession: Option<String>,
        /// The grade of the work, on the route card.
        pub grade: Option<String>,
        /// The numbers of the parts that are printed, 1 to 16; all of them unless said.
        pub parts: Option<Vec<u8>>,
    }
}

impl TitleBlock {
    /// Whether a part is printed.
    pub fn has(&self, number: u8) -> bool {
        self.parts.as_ref().is_none_or(|parts| parts.contains(&number))
    }

    /// The times that the shop gives.
    pub fn times(&self) -> GivenTimes {
        GivenTimes { lot: self.lot, loading: self.loading.map(Minutes), preparatory: self.preparatory.map(Minutes) }
    }

    /// The lines of the block that are filled in, each with the key of its label.
    pub(super) fn fields(&self) -> Vec<(&'static str, &str)> {
        let all = [
            ("lab-institution", &self.institution),
            ("lab-department", &self.department),
            ("lab-author", &self.author),
            ("lab-group", &self.group),
            ("lab-variant", &self.variant),
            ("lab-lecturer", &self.lecturer),
            ("lab-date", &self.date),
        ];
        all.into_iter().filter_map(|(key, text)| Some((key, text.as_deref()?))).collect()
    }
}

/// Reads a title block.
///
/// # Errors
/// Every mistake of the file, each with its place and what to do.
pub fn read_title(file: &str, text: &str) -> Result<TitleBlock, Vec<Diagnostic>> {
    let (root, diagnostics) = parse(file, text);
    let mut problems = Problems(diagnostics);
    let title = root.and_then(|root| title(&root, &mut problems));
    match title {
        Some(title) if problems.0.is_empty() => Ok(title),
        _ => {
            problems.0.sort_by(|a, b| a.place.cmp(&b.place));
            Err(problems.0)
        }
    }
}

fn title(root: &Node, problems: &mut Problems) -> Option<TitleBlock> {
    let mut fields = problems.map(root)?;
    let title = TitleBlock {
        institution: line(&mut fields, TitleBlock::institution, problems),
        department: line(&mut fields, TitleBlock::department, problems),
        work: line(&mut fields, TitleBlock::work, problems),
        author: line(&mut fields, TitleBlock::author, problems),
        group: line(&mut fields, TitleBlock::group, problems),
        variant: line(&mut fields, TitleBlock::variant, problems),
        lecturer: line(&mut fields, TitleBlock::lecturer, problems),
        date: line(&mut fields, TitleBlock::date, problems),
        aim: line(&mut fields, TitleBlock::aim, problems),
        task: line(&mut fields, TitleBlock::task, problems),
        fixture: line(&mut fields, TitleBlock::fixture, problems),
        conclusions: line(&mut fields, TitleBlock::conclusions, problems),
        lot: fields.take(TitleBlock::lot).and_then(|node| lot(node, problems)),
        loading: minutes(&mut fields, TitleBlock::loading, problems),
        preparatory: minutes(&mut fields, TitleBlock::preparatory, problems),
        shop: line(&mut fields, TitleBlock::shop, problems),
        profession: line(&mut fields, TitleBlock::profession, problems),
        grade: line(&mut fields, TitleBlock::grade, problems),
        parts: fields.take(TitleBlock::parts).map(|node| parts(node, problems)),
    };
    fields.finish(problems);
    Some(title)
}

fn line(fields: &mut Fields<'_, TitleBlock>, key: KeyOf<TitleBlock>, problems: &mut Problems) -> Option<String> {
    fields.take(key).and_then(|node| problems.lines(node)).map(str::to_owned)
}

fn lot(node: &Node, problems: &mut Problems) -> Option<u32> {
    let text = problems.text(node)?;
    match text.parse::<u32>() {
        Ok(lot) if lot > 0 => Some(lot),
        _ => problems.error("bad-value", note!("lab-bad-lot", text = text), &node.place),
    }
}

/// A time in min, above zero.
fn minutes(fields: &mut Fields<'_, TitleBlock>, key: KeyOf<TitleBlock>, problems: &mut Problems) -> Option<f64> {
    let node = fields.take(key)?;
    let time: Decimal = problems.scalar(node)?;
    if time.millionths() <= 0 {
        return problems.error("bad-value", note!("lab-bad-minutes", key = key.name()), &node.place);
    }
    Some(time.to_f64())
}

fn parts(node: &Node, problems: &mut Problems) -> Vec<u8> {
    let list = problems.list(node).unwrap_or_default();
    let mut read = Vec::new();
    for node in list {
        let Some(text) = problems.text(node) else { continue };
        match text.parse::<u8>() {
            Ok(number) if (1..=PARTS).contains(&number) => read.push(number),
            _ => {
                let help = note!("lab-parts-are", most = PARTS);
                problems.error_help::<()>("bad-value", note!("lab-no-such-part", text = text), &node.place, help);
            }
        }
    }
    read
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_schema_in_docs_is_the_generated_one() {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/report.schema.json");
        let generated = serde_json::to_string_pretty(&schema()).unwrap() + "\n";
        if std::env::var_os("UPDATE_SCHEMA").is_some() {
            std::fs::write(&path, &generated).unwrap();
        }
        let kept = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(kept == generated, "docs/report.schema.json is old: run `UPDATE_SCHEMA=1 cargo test schema`");
    }

    #[test]
    fn every_mistake_of_a_title_block_is_told_at_its_place() {
        let text = "author: Ковальчук\nparts: [1, 17, x]\ngrop: МТ-31\n";
        let told = read_title("report.yaml", text).unwrap_err();
        let lines: Vec<u32> = told.iter().filter_map(|one| one.place.as_ref()).map(|place| place.line).collect();
        assert_eq!(lines, [2, 2, 3], "{told:?}");
    }

    #[test]
    fn without_a_list_all_parts_are_printed() {
        let title = read_title("report.yaml", "author: Ковальчук\n").unwrap();
        assert!((1..=PARTS).all(|number| title.has(number)));
        let few = read_title("report.yaml", "parts: [7, 15]\n").unwrap();
        assert_eq!((1..=PARTS).filter(|number| few.has(*number)).collect::<Vec<_>>(), [7, 15]);
    }
}
