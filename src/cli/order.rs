//! `technolog order`: the order of tools and the path of each over the holes, or the path over a list of points.

use std::borrow::Cow;
use std::path::PathBuf;

use clap::ValueEnum;
use serde::Serialize;
use technolog::knowledge::yaml::text_of;
use technolog::knowledge::{Diagnostic, Knowledge};
use technolog::machine::Machine;
use technolog::note::Finding;
use technolog::part::Point;
use technolog::plan::{CuttingMethod, Plan, Times, Visit, Visiting};
use technolog::report::order_drawing::{self, Panel};
use technolog::report::{grid, remedy, sentence};
use technolog::sequence::list::{Form, List, Slip, read_list};
use technolog::sequence::metric::Metric;
use technolog::sequence::tour::{Effort, Space, nearest_rule, path};
use technolog::sequence::visiting::not_kept;
use technolog::sequence::{bound, sequence, tool_change_point, visit_bound};
use technolog::units::{Micrometres, Minutes, round_to};

use super::diagnostics::Texts;
use super::{CliError, Context, Format, Outcome, knowledge, plan, words};

// The order of tools and the path over the holes, with its length, time and a lower bound; also of a list of points
#[derive(Debug, clap::Args)]
pub struct Args {
    #[arg(value_name = "FILE")]
    file: PathBuf,
    #[arg(long, value_enum, hide_possible_values = true)]
    metric: Option<MetricName>,
    #[arg(long)]
    closed: bool,
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(..=100_000))]
    effort: Option<u32>,
    #[arg(long, value_name = "ID")]
    machine: Option<String>,
}

/// The machine whose rapids are meant where none is named.
const MACHINE: &str = "gf2171";

/// Metrics of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum MetricName {
    Euclid,
    Rapid,
}

/// Shows the order of a part, or of a list of points.
///
/// # Errors
/// The file cannot be used; every mistake in it is told at once.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let format = context.format("order", &[Format::Text, Format::Json, Format::Svg])?;
    let knowledge = knowledge::load(context)?;
    let part = args.file.extension().is_some_and(|kind| kind == "yaml" || kind == "yml");
    if part { of_part(args, format, knowledge, context) } else { of_list(args, format, knowledge, context) }
}

/// The order of a part, for programs.
#[derive(Serialize)]
struct PartAnswer<'p> {
    sequence: &'p [Visit],
    visiting: &'p [Visiting],
    time: Times,
    tool_change_at: Point,
}

fn of_part(args: &Args, format: Format, knowledge: &Knowledge, context: &Context) -> Result<Outcome, CliError> {
    let of_lists =
        [("--metric", args.metric.is_some()), ("--closed", args.closed), ("--machine", args.machine.is_some())];
    if let Some((option, _)) = of_lists.into_iter().find(|(_, given)| *given) {
        let message = words::option_of_lists(context.lang, option);
        return Err(Diagnostic::error("option-of-lists", message, None)
            .help(words::leave_out(context.lang, option))
            .into());
    }
    let mut plan = plan::make(&args.file, CuttingMethod::default(), knowledge, context)?;
    let machine = machine(&plan.part.machine, knowledge, context)?;
    if let Some(effort) = args.effort {
        (plan.sequence, plan.time) = sequence(&plan.part, &plan.holes, &machine, Some(Effort(effort)));
    }
    for at in 0..plan.sequence.len() {
        plan.sequence[at].bound_min = visit_bound(&plan.sequence[at], &plan.part, &machine);
    }
    let home = tool_change_point(&plan.part, &machine);
    match format {
        Format::Json => context.emit_json(&PartAnswer {
            sequence: &plan.sequence,
            visiting: &plan.visiting,
            time: plan.time,
            tool_change_at: home,
        })?,
        Format::Svg => {
            let panel = |visit: &Visit| {
                let mut path = vec![home];
                path.extend(visit.stops.iter().map(|stop| stop.at));
                path.dedup();
                let time = minutes(visit.rapid_min, context);
                let title = words::visit_title(context.lang, visit.tool, visit.setup, time);
                Panel { title, path, from_change: true, closed: true }
            };
            let panels: Vec<Panel> = plan.sequence.iter().map(panel).collect();
            context.emit(&order_drawing::drawing(&panels, Some(&plan.part)))?;
        }
        _ => context.emit(&part_text(&plan, &machine, home, context))?,
    }
    Ok(if plan.has_errors() { Outcome::Findings } else { Outcome::Done })
}

fn machine<'k>(id: &str, knowledge: &'k Knowledge, context: &Context) -> Result<Machine<'k>, CliError> {
    Machine::find(knowledge, id).map_err(|error| {
        Diagnostic::error("knowledge", technolog::note::Note::from(&error), None)
            .help(words::name_machine(context.lang))
            .into()
    })
}

/// A time as people write it, in minutes.
fn minutes(time: Minutes, context: &Context) -> String {
    decimal(time.0, 3, context)
}

fn decimal(value: f64, places: u32, context: &Context) -> String {
    let text = round_to(value, places).to_string();
    context.lang.pick(&text.replace('.', ","), &text).to_owned()
}

/// By how much less, in percent.
fn saving(now: f64, before: f64, context: &Context) -> String {
    let saved = if before > 0.0 { (1.0 - now / before) * 100.0 } else { 0.0 };
    decimal(saved, 1, context) + " %"
}

fn part_text(plan: &Plan, machine: &Machine<'_>, home: Point, context: &Context) -> String {
    let lang = context.lang;
    let at = |point: Point| words::point(lang, point.x, point.y);
    let mut text = words::order_of(lang, &plan.part.part, at(home)) + "\n\n";
    let head =
        ["cli-tool", "cli-stops", "cli-path-mm", "cli-rapids-min", "cli-nearest-min", "cli-saved", "cli-bound-min"];
    let head: Vec<String> = head.map(|word| context.word(word).to_owned()).into();
    let mut rows = Vec::new();
    for visit in &plan.sequence {
        rows.push(vec![
            format!("T{}", visit.tool),
            visit.stops.len().to_string(),
            decimal(visit.path_mm.to_mm(), 1, context),
            minutes(visit.rapid_min, context),
            minutes(visit.nearest_rapid_min, context),
            saving(visit.rapid_min.0, visit.nearest_rapid_min.0, context),
            visit.bound_min.map_or_else(|| "-".to_owned(), |bound| minutes(bound, context)),
        ]);
    }
    if !rows.is_empty() {
        text.push_str(&grid::table(&head, &rows, 2));
        text.push('\n');
    }
    for visit in &plan.sequence {
        let mut stops: Vec<String> = Vec::new();
        let mut before = None;
        for stop in visit.stops.iter().filter(|stop| before.replace(stop.at) != Some(stop.at)) {
            stops.push(format!("{} {}", stop.hole, at(stop.at)));
        }
        text.push_str(&grid::paragraph(&format!("T{}: {}", visit.tool, stops.join(", ")), 0));
    }
    if !plan.visiting.is_empty() {
        text.push_str(&format!("\n{}\n", context.word("cli-visiting-head")));
    }
    for visiting in &plan.visiting {
        let why = visiting.because.iter().map(|why| sentence(&why.note, lang)).collect::<Vec<_>>().join("; ");
        let line = words::visiting_line(
            lang,
            &visiting.hole,
            why,
            decimal(visiting.book_parallel_min.0, 2, context),
            decimal(visiting.book_sequential_min.0, 2, context),
            decimal(visiting.sequential_min.0, 2, context),
        );
        let quickest = visiting.book_parallel_min.0.min(visiting.sequential_min.0);
        let mixture = visiting.mixture.map(|mixture| {
            let saves = mixture.time_min.0 < quickest;
            let both = context.word(if saves { "cli-quicker-than-both" } else { "cli-not-quicker" });
            words::mixture(lang, mixture.sequential_tools, decimal(mixture.time_min.0, 2, context), both)
        });
        let line = mixture.map_or_else(|| line.clone(), |mixture| format!("{line}; {mixture}"));
        text.push_str(&grid::paragraph(&line, 2));
    }
    let not_kept: Vec<Finding> = plan.visiting.iter().filter_map(|own| not_kept(own, machine)).collect();
    for finding in plan.findings.iter().filter(|finding| not_kept.contains(finding)) {
        let hole = finding.hole.as_deref().unwrap_or_default();
        text.push_str(&grid::paragraph(&format!("{hole}: {}", sentence(&finding.note, lang)), 2));
    }
    text
}

/// The path over a list of points, for programs.
#[derive(Serialize)]
struct ListAnswer<'l> {
    points: usize,
    metric: &'static str,
    closed: bool,
    effort: u32,
    /// The points by their numbers in the list, from 1.
    order: &'l [u64],
    length_mm: Micrometres,
    #[serde(skip_serializing_if = "Option::is_none")]
    time_min: Option<Minutes>,
    nearest_length_mm: Micrometres,
    #[serde(skip_serializing_if = "Option::is_none")]
    nearest_time_min: Option<Minutes>,
    /// Absent where axes speed up: the time is bounded then.
    #[serde(skip_serializing_if = "Option::is_none")]
    bound_mm: Option<Micrometres>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bound_min: Option<Minutes>,
    optimal: bool,
}

fn of_list(args: &Args, format: Format, knowledge: &Knowledge, context: &Context) -> Result<Outcome, CliError> {
    let List { form, points, names } = read(args, context)?;
    let name = args.metric.unwrap_or(MetricName::Euclid);
    let effort = args.effort.map_or_else(Effort::default, Effort);
    let metric = match (name, form) {
        (MetricName::Euclid, Form::Csv) => Metric::Euclid,
        (MetricName::Euclid, Form::Tsplib) => Metric::EuclidWhole,
        (MetricName::Rapid, _) => {
            let id = args.machine.as_deref().unwrap_or(MACHINE);
            Metric::Rapid(machine(id, knowledge, context)?.rapids())
        }
    };
    let space = if args.closed { Space::closed(&points, metric) } else { Space::open(&points, metric) };
    let found = path(&space, effort);
    let book = nearest_rule(&space);
    let bound = match found.optimal {
        true => Some(found.cost),
        false if space.nodes() > bound::BOUND_NODES => None,
        false => Some(bound::lower_bound(&space, found.cost, bound::rounds(space.nodes()))),
    };
    // Where axes speed up the cost is a time; its length is that of the slower axis.
    let timed = matches!(metric, Metric::Rapid(rapid) if rapid.acceleration.is_some());
    let way = |order: &[usize], cost: i64| match metric {
        Metric::Rapid(rapid) if timed => {
            let even = Metric::Rapid(technolog::machine::Rapid { acceleration: None, ..rapid });
            let space = if args.closed { Space::closed(&points, even) } else { Space::open(&points, even) };
            Micrometres::new(space.length(order))
        }
        _ => Micrometres::new(cost),
    };
    let order: Vec<u64> = found.order.iter().map(|&point| names[point]).collect();
    let answer = ListAnswer {
        points: points.len(),
        metric: if name == MetricName::Rapid { "rapid" } else { "euclid" },
        closed: args.closed,
        effort: effort.0,
        order: &order,
        length_mm: way(&found.order, found.cost),
        time_min: metric.minutes(found.cost).map(|time| time.rounded(4)),
        nearest_length_mm: way(&book.order, book.cost),
        nearest_time_min: metric.minutes(book.cost).map(|time| time.rounded(4)),
        // Rounded down, so that it stays a bound.
        bound_min: bound
            .and_then(|bound| metric.minutes(bound))
            .map(|time| Minutes((time.0 * 10_000.0).floor() / 10_000.0)),
        bound_mm: bound.filter(|_| !timed).map(Micrometres::new),
        optimal: found.optimal,
    };
    match format {
        Format::Json => context.emit_json(&answer)?,
        Format::Svg => {
            let path = found.order.iter().map(|&point| points[point]).collect();
            let title = words::list_title(context.lang, answer.points, answer.length_mm);
            let panel = Panel { title, path, from_change: false, closed: args.closed };
            context.emit(&order_drawing::drawing(&[panel], None))?;
        }
        _ => context.emit(&list_text(&answer, context))?,
    }
    Ok(Outcome::Done)
}

fn list_text(answer: &ListAnswer<'_>, context: &Context) -> String {
    let mm = |value: Micrometres| decimal(value.to_mm(), 3, context);
    let mut rows = vec![
        vec![context.word("cli-points").to_owned(), answer.points.to_string()],
        vec![context.word("cli-path-mm").to_owned(), mm(answer.length_mm)],
    ];
    if let Some(time) = answer.time_min {
        rows.push(vec![context.word("cli-rapids-min").to_owned(), decimal(time.0, 4, context)]);
    }
    rows.push(vec![context.word("cli-nearest-mm").to_owned(), mm(answer.nearest_length_mm)]);
    // Where axes speed up the shortest time is looked for, not the shortest way.
    let saved = match (answer.time_min, answer.nearest_time_min) {
        (Some(time), Some(book)) => {
            rows.push(vec![context.word("cli-nearest-min").to_owned(), decimal(book.0, 4, context)]);
            saving(time.0, book.0, context)
        }
        _ => saving(answer.length_mm.to_mm(), answer.nearest_length_mm.to_mm(), context),
    };
    rows.push(vec![context.word("cli-saved").to_owned(), saved]);
    if let Some(bound) = answer.bound_mm {
        rows.push(vec![context.word("cli-bound-mm").to_owned(), mm(bound)]);
    }
    if let Some(bound) = answer.bound_min {
        rows.push(vec![context.word("cli-bound-min").to_owned(), decimal(bound.0, 4, context)]);
    }
    let order: Vec<String> = answer.order.iter().map(u64::to_string).collect();
    format!("{}\n{}", grid::columns(&rows, 0), grid::paragraph(&order.join(" "), 0))
}

fn read(args: &Args, context: &Context) -> Result<List, CliError> {
    let shown = args.file.display().to_string();
    let text = std::fs::read(&args.file).map_err(|error| {
        let message = words::cannot_read(context.lang, &shown, error);
        CliError::from(Diagnostic::error("unreadable", message, None).help(words::check_path(context.lang)))
    })?;
    let text = text_of(&shown, text)?;
    read_list(&shown, &text).map_err(|slips| CliError::Unusable {
        problems: slips.into_iter().map(|slip| problem(slip, context)).collect(),
        texts: Texts::default().with(&shown, shown.clone(), Cow::Owned(text)),
    })
}

fn problem(slip: Slip, context: &Context) -> Diagnostic {
    let problem = Diagnostic::error(slip.code, sentence(&slip.note, context.lang), slip.place);
    match remedy(&slip.note, context.lang) {
        Some(remedy) => problem.help(remedy),
        None => problem,
    }
}
