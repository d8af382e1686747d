//! What the operator keys into the control, in order: the correctors of the tools, then the zeros of each set-up.

use crate::knowledge::Knowledge;
use crate::note::{Figure, Note};
use crate::plan::{OtherZero, Plan, Stand};
use crate::program::Setting;
use crate::tables::controls::{OperatorKeys, OperatorStage as Stage};
use crate::units::Micrometres;

use super::Lang;

/// The steps for a control; none where the knowledge does not have its keys, or where the plan has no set-up.
pub(super) fn steps(
    plan: &Plan,
    setting: &Setting,
    control: &str,
    knowledge: &Knowledge,
    lang: Lang,
) -> Option<Vec<String>> {
    let rows: Vec<OperatorKeys<'_>> = knowledge.rows().ok()?;
    let keys = Keys { rows: rows.into_iter().filter(|row| row.control == control).collect(), lang };
    let mut steps = keys.correctors(plan, setting)?;
    for stand in &plan.setup.stands {
        steps.extend(keys.zeros(stand, plan)?);
    }
    (!plan.setup.stands.is_empty())
        .then(|| (1..).zip(steps).map(|(number, step)| format!("{number}. {step}")).collect())
}

struct Keys<'k> {
    rows: Vec<OperatorKeys<'k>>,
    lang: Lang,
}

impl Keys<'_> {
    /// A step as it is said, with its keys.
    fn step(&self, stage: Stage, note: Note) -> Option<String> {
        let keys = self.rows.iter().find(|row| row.stage == stage)?.keys;
        Some(self.lang.say(&note.with("keys", keys)))
    }

    /// The lengths of the tools against the reference tool, on one gauge block (textbook 4.2.1.4).
    fn correctors(&self, plan: &Plan, setting: &Setting) -> Option<Vec<String>> {
        let held = |corrector: u32| setting.correctors.get(&corrector).copied().unwrap_or_default();
        let mut steps = vec![
            self.step(Stage::Input, Note::new("keys-input"))?,
            self.step(Stage::Correctors, Note::new("keys-correctors"))?,
        ];
        let is_reference = |tool: &&crate::plan::ToolPlan| held(tool.corrector) == Micrometres::ZERO;
        let reference = plan.tools.iter().find(is_reference);
        let named =
            reference.map_or_else(String::new, |tool| format!(" T{} (H{:02} = 0)", tool.number, tool.corrector));
        steps.push(self.step(Stage::Reference, Note::new("keys-reference").with("tool", named))?);
        for tool in plan.tools.iter().filter(|tool| reference != Some(*tool)) {
            let keys = self.rows.iter().find(|row| row.stage == Stage::Corrector)?.keys;
            let note = Note::new("keys-corrector")
                .with("tool", tool.number)
                .with("corrector", tool.corrector)
                .with("value", held(tool.corrector))
                .with("keys", keys.replace('#', &tool.corrector.to_string()));
            steps.push(self.lang.say(&note));
        }
        steps.push(self.step(Stage::Restore, Note::new("keys-restore"))?);
        steps.push(self.step(Stage::Leave, Note::new("keys-leave"))?);
        Some(steps)
    }

    /// The zeros of a set-up (textbook 4.2.1.6).
    fn zeros(&self, stand: &Stand, plan: &Plan) -> Option<Vec<String>> {
        let mut steps = vec![self.step(Stage::Zeros, Note::new("keys-zeros").with("setup", stand.set_up))?];
        let frames = std::iter::once((stand.frame, crate::sheet::zero_sums(stand, plan, self.lang)));
        let radii = |other: &OtherZero| crate::sheet::less_radii(other.sides_mm, other.touched, self.lang);
        let others = stand.other_zeros.iter().map(|other| (other.frame, radii(other)));
        let mut shown = 1;
        for (frame, [x, y]) in frames.chain(others) {
            let name = format!("G{frame}");
            // The additional shifts are on the first page, then two zeros on each.
            let page = (frame.saturating_sub(54)) / 2 + 2;
            if page != shown {
                let note = Note::new("keys-page").with("frame", name.as_str()).with("page", page);
                steps.push(self.step(Stage::Page, note)?);
            }
            shown = page;
            let [about_x, about_y, about_z] = stand.zero_mm;
            let note = Note::new("keys-value").with("frame", name.as_str()).with("x", x).with("y", y);
            let keyed = self.step(Stage::Value, note.with("about_x", about_x).with("about_y", about_y))?;
            // The first zero stays where stops or pins put every part; another one is found at a side that no stop holds.
            let often = if frame == stand.frame { crate::sheet::once(stand, plan) } else { Some("keys-each-part") };
            steps.push(
                [Some(keyed.as_str()), often.map(|code| self.lang.word(code))]
                    .into_iter()
                    .flatten()
                    .collect::<Vec<_>>()
                    .join(". "),
            );
            let tool = stand.reference_tool.map_or_else(String::new, |tool| format!(" T{tool}"));
            let note = |code: &'static str| {
                Note::new(code)
                    .with("frame", name.as_str())
                    .with("tool", Figure::Text(tool.clone().into()))
                    .with("about", about_z)
            };
            // What is shown at the face is the zero itself only where the zero of the drawing lies there.
            steps.push(match stand.face_mm {
                Micrometres::ZERO => self.step(Stage::ReadZ, note("keys-read-z"))?,
                face => {
                    let less = crate::sheet::less(face, self.lang);
                    self.step(Stage::Value, note("keys-value-z").with("less", less))?
                }
            });
        }
        steps.push(self.step(Stage::Leave, Note::new("keys-leave"))?);
        Some(steps)
    }
}
