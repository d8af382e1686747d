//! The laboratory report: the sixteen parts that the textbook asks for (5.3, l. 4888-4921), from one plan and its
//! program. What only the author can write has a marked place.
//!
//! - `forms` one form of it by itself, `cards` route and operation card, `tool_list` the tools; `title` the title block, read
//!   from a file, `framed` the same around other pages; `limits` what the part needs of the machine, `norm` the
//!   norm of time;
//! - `from_above` the drawing of the part; `clamping`, `assemblies` and `zone` those of the set-up.

use crate::document::{Block, Column, Document, Drawing, Field, Inlines, Item, Table};
use crate::error::KnowledgeError;
use crate::job::{Job, Norm};
use crate::knowledge::Knowledge;
use crate::machine::Machine;
use crate::motion::MotionStep;
use crate::note::{Finding, Note};
use crate::part::{BlankHole, CentreTolerance, Hole, HoleStep};
use crate::plan::{Feature, HolePlan, Plan, Transition};
use crate::program::Setting;
use crate::units::Micrometres;
use crate::zone::mass;

use super::backplot::{Frame, sheets};
use super::doubts::unconfirmed;
use super::encoding::EncodingSheet;
use super::sheet::{self, exactly, mm, rounded, route};
use super::words::say;
use super::{Doubts, Lang, cycles, operation_noun, setting, transitions};

mod assemblies;
mod cards;
mod clamping;
mod forms;
mod framed;
mod from_above;
mod limits;
pub(crate) mod norm;
mod title;
mod tool_list;
mod zone;

pub use forms::Form;
pub use framed::framed;
pub use title::{TitleBlock, read_title, schema};

/// How many parts a report has.
pub const PARTS: u8 = 16;

/// What a report is made of: a plan, its job, and the program that was written and read back.
#[derive(Clone, Copy, Debug)]
pub struct Sources<'a> {
    /// The plan.
    pub plan: &'a Plan,
    /// Its job.
    pub job: &'a Job,
    /// The operator's setting.
    pub setting: &'a Setting,
    /// The program on its encoding sheet.
    pub sheet: &'a EncodingSheet,
    /// The motions of the program, read back.
    pub steps: &'a [MotionStep],
    /// All that is wrong with plan and program, the gravest first.
    pub wrong: &'a [Finding],
    /// Why the program must not be run, in words; none if it may.
    pub warning: Option<&'a str>,
    /// What is left undone of the part when the program has run, in words.
    pub left: &'a [String],
    /// The norm of time; none for a part that is not made whole.
    pub norm: Option<&'a Norm>,
    /// The control, by its name on the command line.
    pub control: &'a str,
    /// The tables.
    pub knowledge: &'a Knowledge,
}

impl Sources<'_> {
    /// Whether nothing is wrong with plan and program, and the program leaves nothing undone.
    pub fn is_clean(&self) -> bool {
        !self.plan.has_errors() && self.wrong.is_empty() && self.warning.is_none() && self.left.is_empty()
    }

    /// What is wrong with the program that the plan does not say itself.
    fn of_program(&self) -> impl Iterator<Item = &Finding> {
        let of_plan = |finding: &Finding| self.plan.findings.iter().any(|own| own.note == finding.note);
        self.wrong.iter().filter(move |finding| !of_plan(finding))
    }
}

/// The report.
///
/// # Errors
/// The tables lack the machine of the part.
pub fn page(sources: &Sources<'_>, title: &TitleBlock, lang: Lang) -> Result<Document, KnowledgeError> {
    let machine = Machine::find(sources.knowledge, &sources.plan.part.machine)?;
    let named = title.work.clone().unwrap_or_else(|| say!(lang, "lab-title", part = sources.plan.part.part.as_str()));
    let mut page = Document::new(lang.tag(), named);
    head(&mut page, title, lang);
    for number in (1..=PARTS).filter(|number| title.has(*number)) {
        let name = lang.word(PART_NAMES[usize::from(number) - 1]);
        page.heading(2, say!(lang, "lab-part", number = number, name = name));
        part(&mut page, number, sources, title, &machine, lang)?;
    }
    // The cards belong to the whole report; who chooses parts has them by themselves.
    if title.parts.is_none() {
        annex(&mut page, say!(lang, "lab-annex-route"), cards::route_card(sources, title, lang)?);
        annex(&mut page, say!(lang, "lab-annex-operation"), cards::operation_card(sources, title, lang)?);
    }
    Ok(page)
}

/// A card behind the report: its remarks under the heading, then its sheets, which fill pages of their own.
fn annex(page: &mut Document, name: &str, card: Document) {
    page.heading(2, name);
    let (sheets, remarks): (Vec<Block>, Vec<Block>) =
        card.blocks.into_iter().partition(|block| matches!(block, Block::Form(_)));
    page.blocks.extend(remarks.into_iter().chain(sheets));
}

const PART_NAMES: [&str; PARTS as usize] = [
    "lab-aim",
    "lab-task",
    "lab-equipment",
    "lab-possible",
    "lab-blank",
    "lab-steps",
    "lab-route",
    "lab-tools",
    "lab-conditions",
    "lab-fixture",
    "lab-setting",
    "lab-zeros",
    "lab-change",
    "lab-charts",
    "lab-program",
    "lab-conclusions",
];

fn part(
    page: &mut Document,
    number: u8,
    own: &Sources<'_>,
    title: &TitleBlock,
    machine: &Machine<'_>,
    lang: Lang,
) -> Result<(), KnowledgeError> {
    let plan = own.plan;
    match number {
        1 => by_author(page, title.aim.as_deref(), "lab-write-aim", lang),
        2 => task(page, plan, title, lang),
        3 => equipment(page, own, machine, lang),
        4 => limits::section(page, own, machine, lang)?,
        5 => blank(page, plan, own.knowledge, lang)?,
        6 => steps(page, plan, lang),
        7 => route::work(page, plan, lang),
        8 => tool_list::section(page, own, lang),
        9 => {
            sheet::conditions(page, plan, lang);
            allowances(page, plan, lang);
            norm::section(page, own, lang);
        }
        10 => {
            sheet::set_up(page, plan, lang);
            let scheme = clamping::scheme(plan, lang).map(|svg| figure(svg, say!(lang, "lab-clamping-scheme")));
            page.blocks.extend(scheme.map(Block::from));
            by_author(page, title.fixture.as_deref(), "lab-write-fixture", lang);
        }
        11 => {
            page.push(sheet::corrections(plan, lang));
            let sheets = assemblies::sheets(plan, lang).into_iter();
            page.blocks.extend(sheets.map(|svg| figure(svg, say!(lang, "lab-assemblies")).into()));
            setting::loads(own.job, lang).into_iter().for_each(|line| page.paragraph(line));
        }
        12 => {
            page.push(setting::zeros(own.setting, lang));
            for (tool, svg) in plan.setup.stands.iter().filter_map(|stand| zone::drawing(plan, stand, machine, lang)) {
                page.push(figure(svg, &say!(lang, "lab-zone", tool = tool)));
            }
        }
        13 => change(page, own, lang),
        14 => charts(page, own, lang),
        15 => program(page, own, lang),
        _ => conclusions(page, own, title, lang),
    }
    Ok(())
}

fn head(page: &mut Document, title: &TitleBlock, lang: Lang) {
    let fields = title.fields();
    let line = |(key, text): (&'static str, &str)| Field::new(lang.word(key), text);
    if !fields.is_empty() {
        page.push(Block::Fields(fields.into_iter().map(line).collect()));
    }
}

/// What the author has written, or a marked place for it.
fn by_author(page: &mut Document, text: Option<&str>, missing: &'static str, lang: Lang) {
    match text {
        Some(text) => page.paragraph(text),
        None => page.paragraph(say!(lang, "lab-place", what = lang.word(missing))),
    }
}

/// The surfaces to be made, as the drawing asks for them.
fn task(page: &mut Document, plan: &Plan, title: &TitleBlock, lang: Lang) {
    if let Some(task) = &title.task {
        page.paragraph(task.as_str());
    }
    let unit = lang.word("unit-mm");
    let mut table = Table::new([
        sheet::of_surface(plan, lang),
        Column::number(say!(lang, "lab-count"), ""),
        Column::text(say!(lang, "lab-size")),
        Column::number(say!(lang, "lab-depth"), unit),
        Column::text(say!(lang, "lab-roughness")),
        Column::text(say!(lang, "lab-more")),
        Column::text(say!(lang, "lab-places")).min_width(24),
    ]);
    for hole in &plan.part.holes {
        // Of a slot both middles of its end radii.
        let points = hole.ends().map(|at| say!(lang, "plan-point", x = at.x, y = at.y));
        table.row([
            Inlines::from(hole.name.as_str()),
            Inlines::number(hole.at.len().to_string()),
            size(hole, lang).into(),
            depth(hole, lang),
            lang.figure(&crate::note::IntoFigure::into_figure(hole.roughness)).into(),
            more(hole, lang).join("; ").into(),
            points.collect::<Vec<_>>().join(", ").into(),
        ]);
    }
    page.push(table);
    page.push(figure(from_above::drawing(&plan.part, lang), say!(lang, "lab-from-above")));
}

fn size(hole: &Hole, lang: Lang) -> String {
    if let Some(slot) = route::slot_size(hole, lang) {
        return slot;
    }
    match &hole.thread {
        Some(thread) => thread.written.clone(),
        None => lang.figure(&crate::note::IntoFigure::into_figure(&hole.diameter)),
    }
}

/// What else the drawing asks of a hole: steps, openings, edges, and the tolerance of its place.
fn more(hole: &Hole, lang: Lang) -> Vec<String> {
    let step = |step: &HoleStep| {
        let own = match &step.thread {
            Some(thread) => say!(lang, "lab-step-of", size = thread.written.as_str(), depth = step.depth),
            None => say!(lang, "lab-step-of", size = &step.diameter, depth = step.depth),
        };
        let rough = step.thread.is_none().then(|| lang.figure(&crate::note::IntoFigure::into_figure(step.roughness)));
        let edge = step.chamfer.map(|chamfer| say!(lang, "lab-chamfer", chamfer = chamfer));
        std::iter::once(own).chain(rough).chain(edge).collect::<Vec<_>>().join(", ")
    };
    let mut all: Vec<String> = match hole.state {
        BlankHole::Solid => Vec::new(),
        BlankHole::Cast(diameter) => vec![say!(lang, "lab-cast", diameter = diameter)],
        BlankHole::PreMachined(diameter) => vec![say!(lang, "lab-pre-machined", diameter = diameter)],
    };
    all.extend(hole.steps.iter().map(step));
    if let Some(own) = hole.counterbore {
        all.push(say!(lang, "lab-counterbore", diameter = own.diameter, depth = own.depth));
    }
    let angle = |millideg: u32| rounded(f64::from(millideg) / 1000.0, 3);
    if let Some(own) = hole.countersink {
        all.push(say!(lang, "lab-countersink", diameter = own.diameter, angle = angle(own.angle_millideg)));
    }
    if let Some(own) = hole.cone {
        all.push(say!(lang, "lab-cone", diameter = own.diameter, angle = angle(own.angle_millideg)));
    }
    all.extend(hole.face.map(|diameter| say!(lang, "lab-face", diameter = diameter)));
    all.extend(hole.groove.map(|own| say!(lang, "lab-groove", diameter = own.diameter, width = own.width)));
    all.extend(hole.chamfer.map(|chamfer| say!(lang, "lab-chamfer", chamfer = chamfer)));
    all.push(match hole.centre_tolerance {
        CentreTolerance::Width(width) => say!(lang, "lab-centre", width = width),
        CentreTolerance::Grade { it } => say!(lang, "lab-centre-of-grade", it = it),
    });
    all
}

fn depth(hole: &Hole, lang: Lang) -> Inlines {
    if hole.through { say!(lang, "lab-through").into() } else { Inlines::number(mm(hole.depth, lang)) }
}

/// The record of the machine, figure by figure.
fn equipment(page: &mut Document, own: &Sources<'_>, machine: &Machine<'_>, lang: Lang) {
    page.push(Block::Fields(vec![Field::new(say!(lang, "plan-machine"), own.sheet.equipment.as_str())]));
    page.push(limits::record(machine, lang));
}

fn blank(page: &mut Document, plan: &Plan, knowledge: &Knowledge, lang: Lang) -> Result<(), KnowledgeError> {
    sheet::head(page, plan, knowledge, lang);
    if let Some(mass) = mass(&plan.part, knowledge)? {
        let told = limits::weight(mass, lang).plain();
        let key = match plan.part.mass_kg {
            Some(_) => "lab-blank-mass",
            None if plan.part.blank.is_round() => "lab-disc-mass",
            None => "lab-plate-mass",
        };
        page.paragraph(lang.say(&Note::new(key).with("mass", told)));
    }
    Ok(())
}

/// What each transition takes off a hole that is there: the diameters before and after it, and the allowance on the diameter.
fn allowances(page: &mut Document, plan: &Plan, lang: Lang) {
    let mm = lang.word("unit-mm");
    let mut table = Table::new([
        sheet::of_surface(plan, lang),
        Column::text(say!(lang, "plan-transition")),
        Column::number(say!(lang, "lab-before"), mm),
        Column::number(say!(lang, "lab-after"), mm),
        Column::number(say!(lang, "lab-allowance"), mm),
    ]);
    for hole in &plan.holes {
        // A chamfer and a face have no stock on the diameter: theirs lies along the axis.
        let widened = |own: &&Transition| {
            own.from_diameter_mm > Micrometres::ZERO
                && own.from_diameter_mm < own.diameter_mm
                && !matches!(own.feature, Feature::Face | Feature::Chamfer | Feature::Countersink)
        };
        for own in hole.transitions.iter().filter(widened) {
            let figures = [own.from_diameter_mm, own.diameter_mm, own.diameter_mm - own.from_diameter_mm];
            let figures = figures.map(|figure| Inlines::number(self::mm(figure, lang)));
            let what = operation_noun(own.operation.name(), lang);
            table.row([Inlines::from(hole.name.as_str()), what.into()].into_iter().chain(figures));
        }
    }
    if !table.is_empty() {
        page.heading(3, say!(lang, "lab-allowances"));
        page.push(table);
    }
}

/// For every surface: its transitions with what each leaves, and the method.
fn steps(page: &mut Document, plan: &Plan, lang: Lang) {
    for hole in &plan.holes {
        let step = |own: &Transition| -> Item { Inlines::sentence(&step(own, lang)).into() };
        let Some(of) = plan.part.holes.iter().find(|own| own.name == hole.name) else { continue };
        page.heading(3, say!(lang, "lab-of-hole", hole = hole.name.as_str(), size = size(of, lang)));
        if hole.transitions.is_empty() {
            page.paragraph(say!(lang, "lab-not-planned"));
            continue;
        }
        page.push(Block::List(hole.transitions.iter().map(step).collect()));
        page.push(Block::Fields(route::choice(plan, hole, lang).into_iter().collect()));
    }
}

fn step(own: &Transition, lang: Lang) -> String {
    let what = operation_noun(own.operation.name(), lang);
    let reached = route::achieved(own.achieved.as_ref(), lang);
    let reached = if reached.is_empty() { String::new() } else { say!(lang, "lab-reaches", reached = reached) };
    let where_ = if own.elsewhere { say!(lang, "lab-elsewhere") } else { "" };
    let key = if own.feature == Feature::Face { "lab-step-face" } else { "lab-step" };
    let note = Note::new(key).with("what", what).with("diameter", own.diameter_mm);
    lang.say(&note.with("reached", reached).with("elsewhere", where_))
}

/// The position of table and quill while a tool is changed.
fn change(page: &mut Document, own: &Sources<'_>, lang: Lang) {
    let at = own.job.change_at;
    page.paragraph(say!(lang, "lab-change-at", x = at.x, y = at.y, z = at.z));
    if let Some(clamping) = &own.plan.clamping {
        page.paragraph(say!(lang, "lab-change-apart", distance = clamping.safe_distance_mm));
    }
}

/// The path of every tool over the holes, and the cycle of every tool.
fn charts(page: &mut Document, own: &Sources<'_>, lang: Lang) {
    for (tools, svg) in sheets(own.steps, &Frame::of(own.job, &own.plan.part), lang) {
        let tools: Vec<String> = tools.iter().map(|tool| format!("T{tool}")).collect();
        page.push(figure(svg, &say!(lang, "lab-path-of", tools = tools.join(", "))));
    }
    for chart in cycles::diagrams(own.job, own.plan, lang) {
        let works = own.job.setups.iter().filter(|setup| setup.number == chart.setup).flat_map(|setup| &setup.works);
        let work = works.into_iter().find(|work| work.tool == chart.tool);
        let does = work.map_or_else(String::new, |work| {
            let all: Vec<usize> = (0..work.cycles.len()).collect();
            transitions::sentence(own.plan, work, &all, lang)
        });
        let caption = say!(lang, "lab-chart", tool = chart.tool, does = does);
        page.push(figure(chart.svg, &caption));
    }
}

/// A drawing whose caption says what it shows.
fn figure(svg: String, caption: &str) -> Drawing {
    Drawing { svg, caption: caption.into(), alternative: caption.to_owned() }
}

/// The encoding sheet, under the heading of the part.
fn program(page: &mut Document, own: &Sources<'_>, lang: Lang) {
    if let Some(warning) = own.warning {
        page.paragraph(say!(lang, "lab-not-to-run", why = warning));
    }
    undone(page, own, lang);
    page.paragraph(say!(lang, "lab-program-form"));
    page.blocks.extend(own.sheet.page().blocks);
}

/// What the program leaves undone of the part.
fn undone(page: &mut Document, own: &Sources<'_>, lang: Lang) {
    own.left.iter().for_each(|left| page.paragraph(say!(lang, "lab-left", what = left.as_str())));
}

/// What the plan's own figures say, what stays undone, and the place for the author's words.
fn conclusions(page: &mut Document, own: &Sources<'_>, title: &TitleBlock, lang: Lang) {
    let plan = own.plan;
    let is_made = |hole: &&Hole| {
        let planned = plan.holes.iter().find(|own| own.name == hole.name);
        planned.is_some_and(|own| own.transitions.iter().any(|one| !one.elsewhere))
    };
    let count = |hole: &Hole| hole.at.len();
    let transitions: usize =
        plan.holes.iter().map(|own| own.transitions.iter().filter(|it| !it.elsewhere).count()).sum();
    let note = Note::new("lab-made")
        .with("holes", plan.part.holes.iter().filter(is_made).map(count).sum::<usize>())
        .with("slots", plan.part.holes.iter().filter(|hole| hole.slot.is_some()).count())
        .with("all", plan.part.holes.iter().map(count).sum::<usize>())
        .with("tools", plan.tools.len())
        .with("transitions", transitions)
        .with("setups", own.job.setups.len())
        .with("time", exactly(plan.time.total_min.0, 2));
    page.paragraph(lang.say(&note));
    undone(page, own, lang);
    if let Some((hole, time)) = slowest(plan) {
        page.paragraph(say!(lang, "lab-slowest", hole = hole.name.as_str(), time = exactly(time, 2)));
    }
    let (listed, _) = Doubts::Counted.split(plan.findings.iter());
    listed.into_iter().chain(own.of_program()).for_each(|finding| sheet::finding(page, plan, finding, lang));
    let count = unconfirmed(plan.findings.iter()).len();
    if count > 0 {
        page.paragraph(say!(lang, "lab-unconfirmed", count = count));
    }
    if own.is_clean() {
        page.paragraph(say!(lang, "lab-nothing-wrong"));
    }
    by_author(page, title.conclusions.as_deref(), "lab-write-conclusions", lang);
}

/// The group whose holes take the most time together, with that time in min.
fn slowest(plan: &Plan) -> Option<(&HolePlan, f64)> {
    let time = |hole: &HolePlan| hole.route.as_ref().map(|route| route.time_min.0);
    let timed = plan.holes.iter().filter_map(|hole| Some((hole, time(hole)?)));
    timed.max_by(|a, b| a.1.total_cmp(&b.1))
}
