//! The operator's setting before a program runs: the position of the part, the places of tools, zeros and offsets.

use super::Lang;
use super::words::say;
use crate::document::{Block, Column, Document, Inlines, Table};
use crate::job::{Job, SetUp};
use crate::plan::{Plan, ToolPlan};
use crate::program::Setting;

/// The file of the setting, which `check` reads. Everything but its figures is in its comments.
pub fn file(setting: &Setting, plan: &Plan, job: &Job, lang: Lang) -> String {
    let set_ups = job.setups.iter().map(|setup| stand(setup, lang));
    let tools = plan.tools.iter().map(|tool| {
        say!(
            lang,
            "setting-tool",
            place = place(tool, job),
            corrector = tool.corrector,
            designation = tool.designation.as_str(),
            diameter = tool.diameter_mm,
            length = tool.length_mm
        )
    });
    let clamps = clamps(plan, job, lang);
    let remarks: String = set_ups.chain(clamps).chain(tools).map(|line| format!("# {line}\n")).collect();
    remarks + &setting.to_yaml()
}

/// The same as a page.
pub fn page(setting: &Setting, plan: &Plan, job: &Job, lang: Lang) -> Document {
    let mut page = Document::new(lang.tag(), say!(lang, "setting-title", part = job.part.as_str()));
    let stands = job.setups.iter().map(|setup| stand(setup, lang));
    page.push(Block::List(stands.chain(clamps(plan, job, lang)).map(Into::into).collect()));
    let mut table = Table::new([
        Column::text("T"),
        Column::text("H"),
        Column::text(say!(lang, "plan-designation")),
        Column::number("Ø", lang.word("unit-mm")),
        Column::number(say!(lang, "setting-length"), lang.word("unit-mm")),
    ]);
    let tools = plan.tools.iter();
    let column = |of: &dyn Fn(&ToolPlan) -> _| super::sheet::column(&tools.clone().map(of).collect::<Vec<_>>(), lang);
    let figures = column(&|tool| tool.diameter_mm).into_iter().zip(column(&|tool| tool.length_mm));
    for (tool, (diameter, length)) in plan.tools.iter().zip(figures) {
        let (place, register) = (format!("T{}", place(tool, job)), format!("H{:02}", tool.corrector));
        table.row([Inlines::from(place), register.into(), tool.designation.as_str().into(), diameter, length]);
    }
    page.push(table);
    page.heading(2, say!(lang, "setting-file"));
    page.push(Block::Code(setting.to_yaml()));
    page
}

fn stand(setup: &SetUp, lang: Lang) -> String {
    say!(lang, "setting-stand", setup = setup.number, supports = setup.supports, nose = setup.nose)
}

/// The clamps of the first set-up, and what their screws lack; of a second set-up, that no clamps are planned for it.
fn clamps(plan: &Plan, job: &Job, lang: Lang) -> Vec<String> {
    let Some(clamping) = &plan.clamping else { return vec![say!(lang, "plan-no-clamping").to_owned()] };
    let mut lines = vec![super::sheet::clamps_of(clamping, lang)];
    if clamping.because.iter().any(|because| because.unconfirmed.is_some()) {
        lines.push(say!(lang, "setting-mark").to_owned());
    }
    if clamping.screw_bears_n.0 < clamping.force_per_clamp_n.0 {
        lines.push(super::sheet::weak_screw(clamping, lang));
    }
    let turned = job.setups.iter().filter(|setup| setup.number > 1);
    lines.extend(turned.map(|setup| say!(lang, "setting-clamps-of-second", setup = setup.number)));
    lines
}

/// The magazine place of a tool.
fn place(tool: &ToolPlan, job: &Job) -> u32 {
    let work = job.setups.iter().flat_map(|setup| &setup.works).find(|work| work.tool == tool.number);
    work.map_or(tool.number, |work| work.place)
}
