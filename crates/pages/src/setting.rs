//! The operator's setting before a program runs: the position of the part, the places of tools, zeros and offsets.

mod keys;

use super::Lang;
use super::words::say;
use crate::document::{Block, Column, Document, Inlines, Keep, Table};
use crate::job::{Job, Left, Pause, SetUp, Unfinished};
use crate::knowledge::Knowledge;
use crate::note::{Because, Severity};
use crate::plan::{Held, Plan, ToolPlan};
use crate::program::Setting;

/// The file of the setting, which `check` reads. Everything but its figures is in its comments.
pub fn file(setting: &Setting, plan: &Plan, job: &Job, lang: Lang) -> String {
    let tools = plan.tools.iter().map(|tool| {
        say!(
            lang,
            "setting-tool",
            place = place(tool, job),
            corrector = tool.corrector,
            designation = super::sheet::named(tool, "", lang),
            diameter = tool.diameter_mm,
            length = tool.length_mm
        )
    });
    let remarks = unfinished(job, lang).into_iter().chain(set_ups(plan, job, lang)).chain(tools);
    let remarks = remarks.chain([say!(lang, "setting-lengths").to_owned()]).chain(loads(job, lang));
    let remarks: String = remarks.map(|line| format!("# {line}\n")).collect();
    remarks + &setting.to_yaml()
}

/// The same as a page, with what is keyed into the control.
pub fn page(
    setting: &Setting,
    plan: &Plan,
    job: &Job,
    (control, knowledge): (&str, &Knowledge),
    lang: Lang,
) -> Document {
    let mut page = Document::new(lang.tag(), say!(lang, "setting-title", part = job.part.as_str()));
    let lines = unfinished(job, lang).into_iter().chain(set_ups(plan, job, lang));
    page.push(Block::List(lines.map(|line| Inlines::sentence(&line).into()).collect()));
    page.push(tools(setting, plan, job, lang));
    page.heading(2, say!(lang, "setting-zeros"));
    page.push(zeros(setting, lang));
    if let Some(steps) = keys::steps(plan, setting, control, knowledge, lang) {
        page.heading(2, say!(lang, "setting-keys"));
        steps.into_iter().for_each(|step| page.paragraph(step));
    }
    page.paragraph(Inlines::sentence(say!(lang, "setting-file")));
    page
}

/// The tools with their places in the magazine and their registers; below it, which of them are put in by hand.
fn tools(setting: &Setting, plan: &Plan, job: &Job, lang: Lang) -> Table {
    let mm = lang.word("unit-mm");
    let mut table = Table::new([
        Column::text("T"),
        Column::number(say!(lang, "setting-place"), ""),
        Column::text("H"),
        Column::text(say!(lang, "plan-designation")),
        Column::text(say!(lang, "plan-holder")).keep(Keep::Useful),
        Column::number("Ø", mm),
        Column::number(say!(lang, "plan-overhang"), mm).keep(Keep::Useful),
        Column::number(say!(lang, "setting-length"), mm),
        Column::number(say!(lang, "plan-correction"), mm),
    ]);
    let tools = plan.tools.iter();
    let column = |of: &dyn Fn(&ToolPlan) -> _| super::sheet::column(&tools.clone().map(of).collect::<Vec<_>>(), lang);
    let held = |tool: &ToolPlan| setting.correctors.get(&tool.corrector).copied().unwrap_or_default();
    let [diameters, overhangs] = [column(&|tool| tool.diameter_mm), column(&|tool| tool.overhang_mm)];
    let lengths = column(&|tool| tool.length_mm).into_iter().zip(column(&held));
    let figures = diameters.into_iter().zip(overhangs).zip(lengths);
    for (tool, ((diameter, overhang), (length, correction))) in plan.tools.iter().zip(figures) {
        let (number, register) = (format!("T{}", tool.number), format!("H{:02}", tool.corrector));
        let place = Inlines::number(place(tool, job).to_string());
        let designation = super::sheet::named(tool, "", lang).into();
        let holder = tool.holder.as_str().into();
        table.row([number.into(), place, register.into(), designation, holder, diameter, overhang, length, correction]);
    }
    table.notes.push(say!(lang, "setting-places").into());
    table.notes.push(say!(lang, "setting-lengths").into());
    table.notes.extend(loads(job, lang).into_iter().map(Inlines::from));
    table
}

/// The zeros of the frames of the part, in the frame of the machine.
pub(super) fn zeros(setting: &Setting, lang: Lang) -> Table {
    let axis = |letter: &str| Column::number(letter, lang.word("unit-mm"));
    let mut table = Table::new([Column::text(say!(lang, "setting-frame")), axis("X"), axis("Y"), axis("Z")]);
    for (number, zero) in (54..).zip(&setting.zeros).filter(|(_, zero)| zero.iter().any(Option::is_some)) {
        let figures =
            zero.map(|value| value.map_or_else(Inlines::default, |value| super::sheet::mm(value, lang).into()));
        table.row(std::iter::once(Inlines::from(format!("G{number}"))).chain(figures));
    }
    table
}

/// The tools that the operator puts into a place while the program stops.
pub(super) fn loads(job: &Job, lang: Lang) -> Vec<String> {
    let pauses = job.setups.iter().flat_map(|setup| &setup.works).flat_map(|work| &work.pauses);
    let load = |pause: &Pause| match pause {
        Pause::LoadTool { tool, place } => Some(say!(lang, "setting-load", tool = *tool, place = *place)),
        Pause::TurnOver | Pause::SetBar { .. } => None,
    };
    pauses.filter_map(load).collect()
}

/// What the program leaves undone: a control without remarks cannot say it.
fn unfinished(job: &Job, lang: Lang) -> Vec<String> {
    let line = |one: &Unfinished| {
        let left = match (&one.left, one.finding(Severity::Wrong)) {
            (_, Some(finding)) => lang.say(&finding.note),
            (Left::Everything, None) => lang.word("setting-not-made").to_owned(),
            (_, None) => lang.word("setting-not-as-drawn").to_owned(),
        };
        say!(lang, "setting-unfinished", hole = one.hole.as_str(), left = left)
    };
    job.unfinished.iter().map(line).collect()
}

/// The knee, where the part lies in a set-up, and what its bars are set to.
fn stand(setup: &SetUp, plan: &Plan, lang: Lang) -> Vec<String> {
    let (number, nose) = (setup.number, setup.nose);
    // What lies under the part in a vice is told with the vice.
    let held = plan.held(number);
    let mut lines = vec![match held {
        Held::Vice(_) | Held::Chuck(_) => say!(lang, "setting-stand-vice", setup = number, nose = nose),
        Held::Own(_) => say!(lang, "setting-stand-own", setup = number, supports = setup.supports, nose = nose),
        _ => say!(lang, "setting-stand", setup = number, supports = setup.supports, nose = nose),
    }];
    if let Some(stand) = plan.setup.stands.iter().find(|stand| stand.set_up == number) {
        let turned =
            super::sheet::turned_over(stand, plan, lang).filter(|_| !matches!(held, Held::Vice(_) | Held::Chuck(_)));
        lines.extend(turned);
        lines.extend(super::sheet::stops(stand, plan, lang));
        lines.extend(stand.bars.iter().map(|bar| super::sheet::bar_set(bar, lang)));
    }
    lines
}

/// What holds the part in a set-up, and what its screws lack.
fn held(setup: &SetUp, plan: &Plan, lang: Lang) -> Vec<String> {
    let number = setup.number;
    match plan.held(number) {
        Held::Vice(vice) => {
            let stand = plan.setup.stands.iter().filter(|stand| stand.set_up == number);
            stand.map(|stand| super::sheet::in_vice(vice, stand, plan, lang)).collect()
        }
        Held::Chuck(chuck) => {
            let stand = plan.setup.stands.iter().filter(|stand| stand.set_up == number);
            stand.map(|stand| super::sheet::in_chuck(chuck, stand, plan, lang)).collect()
        }
        // It holds the part in both set-ups, and is told once.
        Held::Own(own) if number == 1 => vec![super::sheet::own_fixture(own, &plan.part, lang)],
        Held::Own(_) => Vec::new(),
        Held::Straps(clamping) => {
            let clamps = super::sheet::clamps_of(clamping, &plan.part, lang);
            let clamps = match number {
                1 => clamps,
                number => say!(lang, "setting-of-set-up", setup = number, clamps = clamps),
            };
            let weak = clamping.screw_bears_n.0 < clamping.force_per_clamp_n.0;
            std::iter::once(clamps).chain(weak.then(|| super::sheet::weak_screw(clamping, lang))).collect()
        }
        Held::Nothing if number == 1 => vec![say!(lang, "plan-no-clamping").to_owned()],
        Held::Nothing => vec![say!(lang, "setting-clamps-of-second", setup = number)],
    }
}

/// Set-up by set-up what a setter does before the tools; then what a mark means, where there is one.
fn set_ups(plan: &Plan, job: &Job, lang: Lang) -> Vec<String> {
    let lines = job.setups.iter().flat_map(|setup| {
        let mut lines = stand(setup, plan, lang);
        lines.extend(held(setup, plan, lang));
        lines
    });
    let marked = job.setups.iter().any(|setup| {
        let because: &[Because] = match plan.held(setup.number) {
            Held::Vice(vice) => &vice.because,
            Held::Chuck(chuck) => &chuck.because,
            Held::Straps(clamping) => &clamping.because,
            Held::Own(_) | Held::Nothing => &[],
        };
        because.iter().any(|because| because.unconfirmed.is_some())
    });
    lines.chain(marked.then(|| say!(lang, "setting-mark").to_owned())).collect()
}

/// The magazine place of a tool.
fn place(tool: &ToolPlan, job: &Job) -> u32 {
    let work = job.setups.iter().flat_map(|setup| &setup.works).find(|work| work.tool == tool.number);
    work.map_or(tool.number, |work| work.place)
}
