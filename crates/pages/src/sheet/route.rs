//! The route section of the page: transitions in the order of work, what each achieves, the order over the
//! holes, and what every route was weighed against.

use crate::part::{Face, Hole, ToleratedDiameter};
use crate::plan::{Achieved, Alternative, Feature, HolePlan, Operation, Plan, Route, Transition, Way};
use crate::units::Micrometres;

use super::super::sentences::scheme_name;
use super::{Lang, grid, mark, mm, number, operation_noun, operation_verb, sentence, table};

/// The route in the form of the worked example: one line per transition of a group, in the order of work.
pub(super) fn section(plan: &Plan, lang: Lang) -> String {
    if plan.sequence.is_empty() {
        return String::new();
    }
    let mut rows = vec![vec!["1".to_owned(), lang.pick("Встановити заготовку", "Set up the blank").to_owned()]];
    let mut setup = 1;
    for visit in &plan.sequence {
        if visit.setup != setup {
            setup = visit.setup;
            let turn = lang.pick("Перевернути деталь: установ 2", "Turn the part over: set-up 2");
            rows.push(vec![(rows.len() + 1).to_string(), turn.to_owned()]);
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
            rows.push(step(plan, hole, transition, rows.len() + 1, lang));
        }
    }
    rows.push(vec![(rows.len() + 1).to_string(), lang.pick("Зняти деталь", "Take off the part").to_owned()]);
    for hole in &plan.holes {
        for transition in hole.transitions.iter().filter(|transition| transition.elsewhere) {
            rows.push(step(plan, hole, transition, rows.len() + 1, lang));
        }
        rows.extend(finish_elsewhere(plan, hole, rows.len() + 1, lang));
    }
    for row in &mut rows {
        row.resize(6, String::new());
    }
    let head = [
        "№",
        lang.pick("Зміст переходу", "Transition"),
        lang.pick("Схема", "Scheme"),
        "T",
        lang.pick("Різальний інструмент", "Cutter"),
        lang.pick("Досягається", "Reached"),
    ];
    let title = lang.pick("005 Багатоінструментальна з ЧПК", "005 Multi-tool NC operation");
    let shown = if rows.len() > 2 { table(&head, &rows) } else { String::new() };
    format!("{title}\n{shown}{}{}", visits(plan, lang), choices(plan, lang))
}

/// What the tables finish on another machine, with the stock left for it.
fn finish_elsewhere(plan: &Plan, own: &HolePlan, number: usize, lang: Lang) -> Option<Vec<String>> {
    let route = own.route.as_ref().filter(|route| route.finish_elsewhere)?;
    let last = own.transitions.iter().rev().find(|transition| transition.feature == Feature::Bore)?;
    let hole = hole(plan, &own.name)?;
    let stock = hole.diameter.target() - last.diameter_mm;
    let text = format!(
        "{} {} {} ({}), {} {} {}",
        lang.pick("Остаточно обробити на іншому верстаті", "Finish on another machine:"),
        hole.at.len(),
        format_args!("{} {}", lang.pick("отв.", "holes"), hole.diameter),
        own.name,
        lang.pick("припуск на діаметр", "stock on diameter"),
        mm(stock, lang),
        lang.pick("мм", "mm")
    );
    let scheme = route_name(route.way, &route.table, &route.scheme, lang);
    Some(vec![number.to_string(), text, scheme, "-".to_owned()])
}

/// The points of each tool in the order of its path.
fn visits(plan: &Plan, lang: Lang) -> String {
    let mut text = format!("{}\n", lang.pick("Обхід отворів:", "Order over the holes:"));
    for visit in &plan.sequence {
        let stops: Vec<String> = visit
            .stops
            .iter()
            .map(|stop| format!("{} [{};{}]", stop.hole, mm(stop.at.x, lang), mm(stop.at.y, lang)))
            .collect();
        text.push_str(&grid::paragraph(&format!("T{}: {}", visit.tool, stops.join(", ")), 2));
    }
    text
}

fn hole<'p>(plan: &'p Plan, name: &str) -> Option<&'p Hole> {
    plan.part.holes.iter().find(|hole| hole.name == name)
}

/// The holes of a group and the cylinder that a transition works on: `6 отв. Ø10H12 (A)`.
fn holes_of(plan: &Plan, name: &str, transition: &Transition, lang: Lang) -> String {
    hole(plan, name).map_or_else(String::new, |hole| {
        let step = transition.step.and_then(|number| hole.steps.get(number.checked_sub(1)?));
        let thread = hole.thread_at(transition.step).filter(|_| transition.operation == Operation::Tap);
        let size = match (thread, step) {
            (Some(thread), _) => thread.written.clone(),
            (None, Some(step)) => step.diameter.to_string(),
            (None, None) => hole.diameter.to_string(),
        };
        let holes = lang.pick("отв.", if hole.at.len() == 1 { "hole" } else { "holes" });
        format!("{} {holes} {size} ({name})", hole.at.len())
    })
}

fn step(plan: &Plan, own: &HolePlan, transition: &Transition, number: usize, lang: Lang) -> Vec<String> {
    let name = own.name.as_str();
    let operation = transition.operation.name();
    let finished = hole(plan, name).is_some_and(|hole| {
        let step = transition.step.and_then(|number| hole.steps.get(number.checked_sub(1)?));
        step.map_or(hole.diameter.nominal, |step| step.diameter.nominal) == transition.diameter_mm
    });
    let size = mm(transition.diameter_mm, lang);
    let to = if transition.operation == Operation::CentreDrill {
        format!(", {} Ø{size}", lang.pick("лунка", "spot"))
    } else if transition.operation == Operation::Tap
        || (matches!(transition.feature, Feature::Bore | Feature::Step) && finished)
    {
        String::new()
    } else {
        format!(" {} Ø{size}", lang.pick("до", "to"))
    };
    let mut more = String::new();
    if let Some(also) = transition.also_diameter_mm {
        more.push_str(&format!(" {} Ø{}", lang.pick("разом з", "together with"), mm(also, lang)));
    }
    if transition.passes > 1 {
        more.push_str(&format!(", {} {}", transition.passes, lang.pick("прох.", "passes")));
    }
    if transition.feature != Feature::Bore && transition.operation != Operation::Tap {
        more.push_str(&format!(", {} {}", lang.pick("глибина", "depth"), mm(transition.depth_mm, lang)));
    }
    if transition.face == Face::Back {
        more.push_str(lang.pick(", зі зворотного боку", ", from the back"));
    }
    if transition.elsewhere {
        more.push_str(lang.pick(" - на іншому верстаті", " - on another machine"));
    }
    let place = if transition.elsewhere { "-".to_owned() } else { format!("T{}", transition.tool.number) };
    vec![
        number.to_string(),
        format!("{} {}{to}{more}", operation_verb(operation, lang), holes_of(plan, name, transition, lang)),
        own.route.as_ref().map_or_else(String::new, |route| route_name(route.way, &route.table, &route.scheme, lang)),
        place,
        format!("{}{}", transition.tool.designation, mark(&transition.because)),
        achieved(transition.achieved.as_ref()),
    ]
}

/// Grade and roughness, as far as the tables say.
fn achieved(achieved: Option<&Achieved>) -> String {
    let Some(achieved) = achieved else { return String::new() };
    let it = achieved.it.map(|it| format!("IT{it}"));
    let roughness = achieved.roughness.map(|roughness| roughness.to_string());
    it.into_iter().chain(roughness).collect::<Vec<_>>().join(", ")
}

/// Where a route was found: `A.9 07`, `A.5 комплекс 13`, or the search.
fn route_name(way: Way, table: &str, scheme: &str, lang: Lang) -> String {
    if scheme.is_empty() {
        return table.to_owned();
    }
    let name = scheme_name(scheme, lang);
    match way {
        Way::Tables => format!("{table} {name}"),
        Way::Complexes => format!("{table} {} {name}", lang.pick("комплекс", "complex")),
        Way::Search if scheme.starts_with(|first: char| first.is_ascii_digit()) => {
            format!("{} ({table} {name})", lang.pick("пошук", "search"))
        }
        Way::Search => lang.pick("пошук", "search").to_owned(),
    }
}

/// The winner of each group, the runner-up and the margin.
fn choices(plan: &Plan, lang: Lang) -> String {
    let mut text = String::new();
    for hole in &plan.holes {
        let Some(route) = &hole.route else { continue };
        let required = requirement(plan, &hole.name, lang);
        let winner = route_name(route.way, &route.table, &route.scheme, lang);
        let time = number(route.time_min.0, 2, lang);
        let against = match route.runner_up() {
            Some(other) => runner_up(other, lang),
            None => lang.pick("іншого здійсненного маршруту немає", "no other route can be carried out").to_owned(),
        };
        let minutes = lang.pick("хв", "min");
        text.push_str(&grid::paragraph(
            &format!("{}: {required}; {winner}, {time} {minutes}; {against}", hole.name),
            2,
        ));
    }
    if text.is_empty() {
        return text;
    }
    format!(
        "{}\n{text}",
        lang.pick("Вимоги, вибраний маршрут і другий за ним:", "Required, the route taken, and the runner-up:")
    )
}

/// What the drawing asks of a group: grade, roughness, centre tolerance.
fn requirement(plan: &Plan, name: &str, lang: Lang) -> String {
    let Some(hole) = hole(plan, name) else { return String::new() };
    let shown = |diameter: &ToleratedDiameter| format!("IT{}", diameter.it);
    let centre: Micrometres = plan
        .holes
        .iter()
        .find(|own| own.name == name)
        .and_then(|own| own.route.as_ref())
        .map_or(Micrometres::ZERO, |route: &Route| route.centre_tolerance_mm);
    let centre = format!("{} {}", lang.pick("міжцентрова", "centres"), mm(centre, lang));
    match &hole.thread {
        Some(thread) => format!("{}, {centre}", thread.written),
        None => format!("{}, {}, {centre}", shown(&hole.diameter), hole.roughness),
    }
}

fn runner_up(other: &Alternative, lang: Lang) -> String {
    let operations: Vec<&str> =
        other.operations.iter().map(|made| operation_noun(made.operation.name(), lang)).collect();
    let name = route_name(other.way, &other.table, &other.scheme, lang);
    format!("{} {name} ({}): {}", lang.pick("далі", "next"), operations.join(", "), sentence(&other.why, lang))
}

/// The routes that were not taken, each with why it lost, for `explain`.
pub(crate) fn alternatives(route: &Route, lang: Lang) -> String {
    let mut text = String::new();
    for other in &route.alternatives {
        let operations: Vec<String> = other
            .operations
            .iter()
            .map(|made| format!("{} Ø{}", operation_noun(made.operation.name(), lang), mm(made.diameter_mm, lang)))
            .collect();
        let mut line = format!("- {}", route_name(other.way, &other.table, &other.scheme, lang));
        if !operations.is_empty() {
            line.push_str(&format!(" ({})", operations.join(", ")));
        }
        if let Some(time) = other.time_min {
            line.push_str(&format!(", {} {}", number(time.0, 2, lang), lang.pick("хв", "min")));
        }
        line.push_str(&format!(": {}", sentence(&other.why, lang)));
        text.push_str(&grid::paragraph(&line, 2));
    }
    text
}
