//! A material in a state, as files of parts write it: `{grade: 40Х, hardness: 250}`.

use crate::knowledge::Knowledge;
use crate::knowledge::yaml::{Node, NodeKind, Problems};
use crate::material::{self, MaterialState};
use crate::tables::materials::DeliveryState;
use crate::units::{Decimal, round_to};
use technolog_note::note;

use super::file::StatedMaterial;
use super::read::choice;

/// The range of the scale Rockwell C, HRC, by ISO 6508-1.
const ROCKWELL_C: std::ops::RangeInclusive<f64> = 20.0..=70.0;
/// The range of strength of the cutting tables, MPa.
const STATE_STRENGTH_MPA: (f64, f64) = (100.0, 2000.0);

/// The node that names the grade: the node itself, or its key `grade`; none where that is missing.
pub fn grade(node: &Node) -> Option<&Node> {
    match &node.kind {
        NodeKind::Map(entries) => {
            let mut entries = entries.iter();
            entries.find(|(key, _)| key.text == StatedMaterial::grade.name()).map(|(_, value)| value)
        }
        _ => Some(node),
    }
}

/// The stated state of a material; inside it none where the node names only a grade. Mistakes go to `problems`, and
/// nothing is returned.
pub fn state(
    node: &Node,
    grade: Option<&str>,
    problems: &mut Problems,
    knowledge: &Knowledge,
) -> Option<Option<MaterialState>> {
    if !matches!(node.kind, NodeKind::Map(_)) {
        return Some(None);
    }
    let mut fields = problems.map::<StatedMaterial>(node)?;
    fields.need(StatedMaterial::grade, problems);
    let stated = fields.take(StatedMaterial::state);
    let hardness = fields.take(StatedMaterial::hardness);
    let strength = fields.take(StatedMaterial::strength);
    fields.finish(problems);
    if stated.is_some() == hardness.or(strength).is_some() {
        return problems.error("bad-value", note!("part-hardness-or-strength"), &node.place);
    }
    if let Some(stated) = stated {
        let word = choice(stated, DeliveryState::NAMES, problems)?;
        let (grade, place) = (grade?, &stated.place);
        return match material::delivered(knowledge, grade, word) {
            Some(state) => Some(Some(state)),
            None => problems.error_help(
                "bad-value",
                note!("part-state-unknown", material = grade, state = word.name()),
                place,
                note!("part-state-by-hardness"),
            ),
        };
    }
    let of_strength = strength;
    let hardness = match hardness {
        Some(node) => Some(brinell(node, grade?, problems, knowledge)?),
        None => None,
    };
    let strength = match strength {
        Some(node) => Some(figure(node, STATE_STRENGTH_MPA, problems)?),
        None => None,
    };
    if let (Some(strength), Some(node)) = (strength, of_strength) {
        match hardness {
            Some(hardness) => one_bar(hardness, strength, grade?, (node, problems), knowledge)?,
            None => of_its_metal(strength, grade?, (node, problems), knowledge)?,
        }
    }
    Some(Some(MaterialState { hardness, strength }))
}

/// A hardness, HB, that metals of the grade's group have by the table `hardness-bounds`.
fn brinell(node: &Node, grade: &str, problems: &mut Problems, knowledge: &Knowledge) -> Option<f64> {
    let figure: Decimal = problems.scalar(node)?;
    let value = figure.to_f64();
    let Some(bounds) = material::hardness_bounds(knowledge, grade) else { return Some(value) };
    if (bounds.least.0..=bounds.most.0).contains(&figure) {
        return Some(value);
    }
    let (low, high) = (bounds.least.0, bounds.most.0);
    let message = note!("part-state-hardness-outside", value = figure, low = low, high = high, material = grade);
    let help = if figure < low && ROCKWELL_C.contains(&value) {
        note!("part-state-rockwell", value = figure)
    } else {
        note!("part-state-brinell")
    };
    problems.error_help("bad-value", message, &node.place, help)
}

/// Holds a strength, MPa, against the hardness that follows from it: no steel is softer or harder than the table
/// `hardness-bounds` says.
fn of_its_metal(
    strength: f64,
    grade: &str,
    (node, problems): (&Node, &mut Problems),
    knowledge: &Knowledge,
) -> Option<()> {
    let Some(row) = material::hardness_to_strength(knowledge, grade) else { return Some(()) };
    let Some(bounds) = material::hardness_bounds(knowledge, grade) else { return Some(()) };
    let follows = Decimal::from_f64_rounded(round_to(strength / row.ratio, 0));
    if (bounds.least.0..=bounds.most.0).contains(&follows) {
        return Some(());
    }
    let message = note!(
        "part-state-strength-outside",
        value = strength,
        hardness = follows,
        low = bounds.least.0,
        high = bounds.most.0,
        material = grade
    );
    problems.error("bad-value", message, &node.place)
}

/// Holds a hardness and a strength, HB and MPa, against each other by the table `hardness-strength`: two figures of
/// two states would give forces of one bar and feeds of another.
fn one_bar(
    hardness: f64,
    strength: f64,
    grade: &str,
    (node, problems): (&Node, &mut Problems),
    knowledge: &Knowledge,
) -> Option<()> {
    let Some(row) = material::hardness_to_strength(knowledge, grade) else { return Some(()) };
    let ratio = strength / hardness;
    if (row.least..=row.most).contains(&ratio) {
        return Some(());
    }
    let message = note!(
        "part-state-contradicts",
        hardness = hardness,
        strength = strength,
        ratio = round_to(ratio, 2),
        least = row.least,
        most = row.most
    );
    let help = note!(
        "part-state-follows",
        hardness = hardness,
        strength = strength,
        follows = round_to(hardness * row.ratio, 0),
        follows_hardness = round_to(strength / row.ratio, 0)
    );
    problems.error_help("bad-value", message, &node.place, help)
}

/// A strength within the range of the cutting tables.
fn figure(node: &Node, (low, high): (f64, f64), problems: &mut Problems) -> Option<f64> {
    let figure: Decimal = problems.scalar(node)?;
    let value = figure.to_f64();
    if !(low..=high).contains(&value) {
        let message = note!("part-state-outside", value = figure, low = low, high = high);
        return problems.error("bad-value", message, &node.place);
    }
    Some(value)
}
