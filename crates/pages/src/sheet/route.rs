//! The route section of the page: transitions in the order of work, the accuracy of each, the order over the holes,
//! and the rejected candidates.

use crate::document::{Align, Block, Column, Document, Field, Inlines, Item, Keep, Table};
use crate::note::{Figure, IntoFigure, Note};
use crate::part::{Face, Hole, ToleratedDiameter};
use crate::plan::{Achieved, Alternative, Feature, HolePlan, Operation, Plan, Route, RouteSource, Stop, Transition};
use crate::units::Micrometres;

use super::super::words::say;
use super::{Lang, NONE, exactly, mark};
use crate::report::operation_verb;

/// The route, and why it was taken.
pub(super) fn section(page: &mut Document, plan: &Plan, lang: Lang) {
    work(page, plan, lang);
    let choices: Vec<Field> = plan.holes.iter().filter_map(|hole| choice(plan, hole, lang)).collect();
    if !choices.is_empty() {
        page.heading(3, say!(lang, "plan-choices"));
        page.push(Block::Fields(choices));
    }
}

/// The route in the form of the worked example: one line per transition of a group, in the order of work; and the path
/// of every tool.
pub(crate) fn work(page: &mut Document, plan: &Plan, lang: Lang) {
    let (number, name) = (lang.word("plan-operation-number"), lang.word("plan-operation-name"));
    page.heading(3, say!(lang, "plan-operation", number = number, name = name));
    let rows = rows(plan, lang);
    // Without transitions there is only loading and unloading of the part.
    if rows.len() > 2 {
        let mut table = Table::new([
            Column { align: Align::Right, ..Column::text(lang.word("cli-row-number")) },
            Column::text(say!(lang, "plan-step-head")).min_width(22),
            Column::text(say!(lang, "plan-scheme")).keep(Keep::Optional),
            Column::text("T"),
            Column::text(say!(lang, "plan-cutter")),
            Column::text(say!(lang, "plan-reached")),
        ]);
        for (number, row) in (1..).zip(rows) {
            table.row([Inlines::number(format!("{number}"))].into_iter().chain(row));
        }
        page.push(table);
    }
    page.heading(3, say!(lang, "plan-order"));
    let visits = plan
        .sequence
        .iter()
        .map(|visit| Field::new(format!("T{}", visit.tool), stops(plan.by_zero(visit).concat(), lang)));
    page.push(Block::Fields(visits.collect()));
}

/// A step of the operation.
pub(crate) enum WorkStep<'p> {
    /// The blank is set up.
    SetUp,
    /// The part is turned over for that set-up.
    TurnOver(u32),
    /// A transition of a group of holes.
    Make { hole: &'p HolePlan, transition: &'p Transition },
    /// The part is taken off.
    TakeOff,
    /// A transition on another machine.
    Elsewhere { hole: &'p HolePlan, transition: &'p Transition },
}

/// The steps of the operation in the order of work; then what another machine does.
pub(crate) fn work_steps(plan: &Plan) -> Vec<WorkStep<'_>> {
    let mut steps = vec![WorkStep::SetUp];
    let mut setup = 1;
    for visit in &plan.sequence {
        if visit.setup != setup {
            setup = visit.setup;
            steps.push(WorkStep::TurnOver(setup));
        }
        let mut done: Vec<(&str, usize)> = Vec::new();
        for stop in &visit.stops {
            if !done.contains(&(&stop.hole, stop.transition)) {
                done.push((&stop.hole, stop.transition));
            }
        }
        done.sort_unstable();
        for (name, index) in done {
            let Some(hole) = plan.holes.iter().find(|hole| hole.name == name) else { continue };
            let Some(transition) = hole.transitions.get(index) else { continue };
            steps.push(WorkStep::Make { hole, transition });
        }
    }
    steps.push(WorkStep::TakeOff);
    for hole in &plan.holes {
        let elsewhere = hole.transitions.iter().filter(|own| own.elsewhere);
        steps.extend(elsewhere.map(|transition| WorkStep::Elsewhere { hole, transition }));
    }
    steps
}

/// A step in words, as on a route card.
pub(crate) fn told(plan: &Plan, step: &WorkStep<'_>, lang: Lang) -> String {
    match step {
        WorkStep::SetUp => say!(lang, "plan-set-up").to_owned(),
        WorkStep::TurnOver(setup) => say!(lang, "plan-turn-over", setup = *setup),
        WorkStep::TakeOff => say!(lang, "plan-take-off").to_owned(),
        WorkStep::Make { hole, transition } | WorkStep::Elsewhere { hole, transition } => {
            content(plan, hole, transition, lang)
        }
    }
}

fn rows(plan: &Plan, lang: Lang) -> Vec<Vec<Inlines>> {
    let row = |own: &WorkStep<'_>| match own {
        WorkStep::Make { hole, transition } | WorkStep::Elsewhere { hole, transition } => {
            step(plan, hole, transition, lang)
        }
        other => vec![told(plan, other, lang).into()],
    };
    work_steps(plan).iter().map(row).collect()
}

/// The points of a tool in the order of its path; a hole and its point stay on one line.
pub(crate) fn stops<'s>(stops: impl IntoIterator<Item = &'s Stop>, lang: Lang) -> Inlines {
    let stop = |stop: &Stop| {
        let point = say!(lang, "plan-point", x = stop.at.x, y = stop.at.y);
        Inlines::default().quantity(stop.hole.as_str(), point)
    };
    Inlines::joined(stops.into_iter().map(stop), ", ")
}

fn hole<'p>(plan: &'p Plan, name: &str) -> Option<&'p Hole> {
    plan.part.holes.iter().find(|hole| hole.name == name)
}

/// The thread that a transition of its bore comes before: what is made is another size.
pub(crate) fn thread_later<'p>(hole: &'p Hole, transition: &Transition) -> Option<&'p str> {
    let bores = matches!(transition.feature, Feature::Bore | Feature::Step) && transition.operation != Operation::Tap;
    hole.thread_at(transition.step).filter(|_| bores).map(|thread| thread.written.as_str())
}

/// The size towards which a transition works: a thread, a step, or the hole itself.
pub(crate) fn size_of(hole: &Hole, transition: &Transition) -> Figure {
    let step = transition.step.and_then(|number| hole.steps.get(number.checked_sub(1)?));
    let thread = hole.thread_at(transition.step).filter(|_| transition.operation == Operation::Tap);
    // A chamfer at the face is on the step that opens there.
    let opens = matches!(transition.feature, Feature::Chamfer | Feature::Countersink) && transition.face != Face::Back;
    let step = step.or_else(|| hole.steps.first().filter(|_| opens));
    match (thread, step) {
        (Some(thread), _) => thread.written.clone().into_figure(),
        (None, Some(step)) => (&step.diameter).into_figure(),
        (None, None) => (&hole.diameter).into_figure(),
    }
}

/// That size in words: a bore before its thread is one for the thread.
pub(crate) fn size_text(hole: &Hole, transition: &Transition, lang: Lang) -> String {
    match thread_later(hole, transition) {
        Some(thread) => say!(lang, "plan-size-for-thread", thread = thread),
        None => lang.figure(&size_of(hole, transition)),
    }
}

/// The width of a slot with its tolerance, and its length over all; none for a round hole.
pub(crate) fn slot_size(hole: &Hole, lang: Lang) -> Option<String> {
    let slot = hole.slot?;
    let length = slot.drawn(hole.diameter.nominal);
    let width = lang.figure(&(&hole.diameter).into_figure());
    let width = width.trim_start_matches('Ø');
    Some(match slot.corner {
        None if slot.open.is_some() => say!(lang, "plan-open-slot-size", width = width, length = length),
        None => say!(lang, "plan-slot-size", width = width, length = length),
        Some(corner) => say!(lang, "plan-pocket-size", width = width, length = length, corner = corner),
    })
}

/// Whether a transition reaches that size, so that its own diameter need not be printed.
pub(crate) fn finishes(hole: &Hole, transition: &Transition) -> bool {
    let own = cylinder(hole, transition).is_some_and(|own| own.nominal == transition.diameter_mm);
    transition.operation == Operation::Tap || own && thread_later(hole, transition).is_none()
}

/// The diameter of the cylinder that a transition works on, by the drawing; none for edges and faces.
fn cylinder<'p>(hole: &'p Hole, transition: &Transition) -> Option<&'p ToleratedDiameter> {
    let step = transition.step.and_then(|number| hole.steps.get(number.checked_sub(1)?));
    let own = step.map_or(&hole.diameter, |step| &step.diameter);
    matches!(transition.feature, Feature::Bore | Feature::Step).then_some(own)
}

/// The place of its tool in the magazine; work on another machine has none.
pub(super) fn place(transition: &Transition) -> String {
    if transition.elsewhere { NONE.to_owned() } else { format!("T{}", transition.tool.number) }
}

fn step(plan: &Plan, hole: &HolePlan, transition: &Transition, lang: Lang) -> Vec<Inlines> {
    vec![
        content(plan, hole, transition, lang).into(),
        hole.route.as_ref().map_or_else(String::new, |route| route_text(route, lang)).into(),
        place(transition).into(),
        match transition.tool.designation.as_str() {
            "" => NONE.into(),
            own => format!("{own}{}", mark(&transition.because)).into(),
        },
        achieved(transition.achieved.as_ref(), lang).into(),
    ]
}

/// The content of a transition, as on a route card.
fn content(plan: &Plan, hole_plan: &HolePlan, transition: &Transition, lang: Lang) -> String {
    let Some(hole) = hole(plan, &hole_plan.name) else { return String::new() };
    if let Some(size) = slot_size(hole, lang) {
        let verb = operation_verb(transition.operation.name(), lang);
        let (name, size, width) = (hole.name.as_str(), size.as_str(), transition.diameter_mm);
        if hole.slot.is_some_and(|slot| slot.corner.is_some()) {
            return say!(lang, "plan-step-pocket", verb = verb, size = size, hole = name, width = width);
        }
        return say!(lang, "plan-step-slot", verb = verb, size = size, hole = name, width = width);
    }
    let key = match transition.operation {
        Operation::CentreDrill => "plan-step-spot",
        // A mill that widens nothing levels the floor.
        Operation::Mill if transition.from_diameter_mm == transition.diameter_mm => "plan-step-floor",
        _ if transition.feature == Feature::Face => "plan-step-face",
        _ if finishes(hole, transition) => "plan-step",
        _ => "plan-step-to",
    };
    let mut note = Note::new(key)
        .with("verb", operation_verb(transition.operation.name(), lang))
        .with("count", hole.at.len())
        .with("size", size_text(hole, transition, lang))
        .with("hole", hole_plan.name.as_str());
    if key != "plan-step" {
        note = note.with("diameter", transition.diameter_mm);
    }
    let mut clauses = vec![lang.say(&note)];
    // A bar is set to a size inside the field: the operator is told how far it may lie off.
    let limits = cylinder(hole, transition).filter(|_| transition.operation.is_boring());
    if let Some(own) = limits.filter(|own| (own.smallest()..=own.largest()).contains(&transition.diameter_mm)) {
        clauses.push(say!(lang, "plan-step-within", smallest = own.smallest(), largest = own.largest()));
    }
    if let Some(also) = transition.also_diameter_mm {
        clauses.push(say!(lang, "plan-step-also", diameter = also));
    }
    if transition.passes > 1 {
        clauses.push(say!(lang, "plan-step-passes", count = transition.passes));
    }
    if transition.feature == Feature::Face && transition.depth_mm == Micrometres::ZERO {
        // Its floor is the face from which the drawing measures: the stock above it says what is cut.
        clauses.push(say!(lang, "plan-step-stock", stock = -transition.start_mm));
    } else if transition.feature != Feature::Bore && transition.operation != Operation::Tap {
        clauses.push(say!(lang, "plan-step-depth", depth = transition.depth_mm));
    }
    if transition.operation != Operation::Mill && transition.conditions.rounds.is_some() {
        clauses.push(say!(lang, "plan-step-round").to_owned());
    }
    if transition.face == Face::Back {
        clauses.push(say!(lang, "plan-step-back").to_owned());
    }
    if transition.elsewhere {
        clauses.push(say!(lang, "plan-step-elsewhere").to_owned());
    }
    clauses.join(", ")
}

/// Grade and roughness, as far as the tables say.
pub(crate) fn achieved(achieved: Option<&Achieved>, lang: Lang) -> String {
    let Some(achieved) = achieved else { return String::new() };
    let it = achieved.it.map(|grade| format!("IT{grade}"));
    let roughness = achieved.roughness.map(|roughness| lang.figure(&roughness.into_figure()));
    it.into_iter().chain(roughness).collect::<Vec<_>>().join(", ")
}

fn route_text(route: &Route, lang: Lang) -> String {
    route_name(route.source, &route.table, &route.scheme, lang)
}

/// The source of a route: `A.9 07`, `A.5 комплекс 13`, or the search.
fn route_name(source: RouteSource, table: &str, scheme: &str, lang: Lang) -> String {
    if scheme.is_empty() {
        return table.to_owned();
    }
    let name = Figure::scheme(scheme);
    match source {
        RouteSource::Tables => say!(lang, "plan-by-table", table = table, scheme = name),
        RouteSource::Complexes => say!(lang, "plan-by-complex", table = table, scheme = name),
        RouteSource::Search if scheme.starts_with(|first: char| first.is_ascii_digit()) => {
            say!(lang, "plan-by-search-as", table = table, scheme = name)
        }
        RouteSource::Search => say!(lang, "plan-by-search").to_owned(),
    }
}

/// The requirements of a group, the route taken, and the runner-up with its cost.
pub(crate) fn choice(plan: &Plan, hole_plan: &HolePlan, lang: Lang) -> Option<Field> {
    let route = hole_plan.route.as_ref()?;
    let against = match route.runner_up() {
        Some(other) => runner_up(other, lang),
        None => say!(lang, "plan-no-runner-up").to_owned(),
    };
    let text = say!(
        lang,
        "plan-choice",
        required = requirement(hole(plan, &hole_plan.name)?, route.centre_tolerance_mm, lang),
        route = chosen(hole_plan, route, lang),
        time = exactly(route.time_min.0, 2),
        against = against
    );
    Some(Field::new(hole_plan.name.as_str(), text))
}

/// The name of the route taken; with its transitions where the runner-up has the same name.
fn chosen(own: &HolePlan, route: &Route, lang: Lang) -> String {
    let name = route_text(route, lang);
    let alike = |other: &Alternative| route_name(other.source, &other.table, &other.scheme, lang) == name;
    if !route.runner_up().is_some_and(alike) {
        return name;
    }
    let operations = Figure::operations(own.transitions.iter().map(|made| made.operation.name()));
    say!(lang, "plan-route-made", route = name, operations = operations)
}

/// The requirements of the drawing for a group: grade, roughness, centre tolerance, and what its steps require.
fn requirement(hole: &Hole, centre: Micrometres, lang: Lang) -> String {
    let main = of_main(hole, centre, lang);
    let steps = hole.steps.iter().map(|step| match &step.thread {
        Some(thread) => thread.written.clone(),
        None => say!(lang, "plan-required-step", diameter = &step.diameter, roughness = step.roughness),
    });
    std::iter::once(main).chain(steps).collect::<Vec<_>>().join("; ")
}

fn of_main(hole: &Hole, centre: Micrometres, lang: Lang) -> String {
    match &hole.thread {
        Some(thread) => say!(lang, "plan-required-thread", thread = thread.written.as_str(), centre = centre),
        None => say!(lang, "plan-required", it = hole.diameter.it, roughness = hole.roughness, centre = centre),
    }
}

fn runner_up(other: &Alternative, lang: Lang) -> String {
    let operations = Figure::operations(other.operations.iter().map(|made| made.operation.name()));
    let route = route_name(other.source, &other.table, &other.scheme, lang);
    say!(lang, "plan-runner-up", route = route, operations = operations, why = other.why.clone())
}

/// The rejected routes, each with the reason, for `explain`.
pub(crate) fn alternatives(route: &Route, lang: Lang) -> Vec<Item> {
    let item = |other: &Alternative| {
        let made = other.operations.iter();
        let operations = made.map(|made| {
            let operation = Figure::operation(made.operation.name());
            say!(lang, "explain-made", operation = operation, diameter = made.diameter_mm)
        });
        let operations = operations.collect::<Vec<_>>().join(", ");
        let name = route_name(other.source, &other.table, &other.scheme, lang);
        let name = if operations.is_empty() { name } else { format!("{name} ({operations})") };
        let text = match other.time_min {
            Some(time) => {
                let time = exactly(time.0, 2);
                say!(lang, "explain-other-route-timed", route = name, time = time, why = other.why.clone())
            }
            None => say!(lang, "explain-other-route", route = name, why = other.why.clone()),
        };
        Inlines::sentence(&text).into()
    };
    route.alternatives.iter().map(item).collect()
}
