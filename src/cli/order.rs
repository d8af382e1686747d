//! `technolog order`: the order of tools and the path of each over the holes, or the path over a list of points.

use std::borrow::Cow;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::ValueEnum;
use serde::Serialize;
use technolog::cases::FileKind;
use technolog::knowledge::{Diagnostic, Knowledge};
use technolog::note::Finding;
use technolog::part::Point;
use technolog::plan::{CuttingMethod, Times, ToolVisit, Visiting};
use technolog::report;
use technolog::report::order::Tour;
use technolog::report::order_drawing::{self, Panel};
use technolog::sequence::list::{Form, List, ListFault, read_list};
use technolog::sequence::metric::Metric;
use technolog::sequence::tour::{Effort, Path, Space, nearest_rule, path_while, usual_tries};
use technolog::sequence::visiting::not_kept;
use technolog::sequence::{bound, sequence, timed, tool_change_point, visit_bound};
use technolog::shop::Shop;
use technolog::units::{Micrometres, Minutes};

use super::control::machine;
use super::diagnostics::Texts;
use super::usage::whole_number;
use super::{CliError, Context, Format, Outcome, kind, knowledge, plan, words};

// The order of tools and the path over the holes, with its length, time and a lower bound; also of a list of points
#[derive(Debug, clap::Args)]
pub struct Args {
    #[arg(value_name = "FILE")]
    file: PathBuf,
    #[arg(long, value_enum, hide_possible_values = true)]
    metric: Option<MetricName>,
    #[arg(long)]
    closed: bool,
    #[arg(long, value_name = "N", value_parser = whole_number::<0, 100_000>, conflicts_with_all = ["tries", "time"])]
    effort: Option<u32>,
    #[arg(long, value_name = "N", value_parser = whole_number::<0, { u32::MAX }>, conflicts_with = "time")]
    tries: Option<u32>,
    #[arg(long, value_name = "TIME", value_parser = duration)]
    time: Option<Duration>,
    #[arg(long, value_name = "ID")]
    machine: Option<String>,
}

/// The machine whose rapids are used if none is given.
const MACHINE: &str = "gf2171";

/// The time limit of a search: `500ms`, `1s`, `2.5s`.
fn duration(text: &str) -> Result<Duration, String> {
    let bounds = || format!("{:?} … {:?}", TIMES.0, TIMES.1);
    let (number, unit) = match text.strip_suffix("ms") {
        Some(number) => (number, 0.001),
        None => (text.strip_suffix('s').ok_or_else(bounds)?, 1.0),
    };
    let seconds: f64 = number.parse().map_err(|_| bounds())?;
    let time = Duration::try_from_secs_f64(seconds * unit).map_err(|_| bounds())?;
    if (TIMES.0..=TIMES.1).contains(&time) { Ok(time) } else { Err(bounds()) }
}

const TIMES: (Duration, Duration) = (Duration::from_millis(1), Duration::from_secs(3600));

/// The metrics of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum MetricName {
    Euclid,
    Rapid,
}

/// The formats of its answers.
pub const FORMATS: &[Format] = &[Format::Text, Format::Markdown, Format::Html, Format::Json, Format::Svg];

/// Shows the order of a part, or of a list of points.
///
/// # Errors
/// The file cannot be used; every mistake in it is told at once.
pub fn run(args: &Args, context: &Context) -> Result<Outcome, CliError> {
    let format = context.format("order", FORMATS)?;
    let knowledge = knowledge::load(context)?;
    let part = args.file.extension().is_some_and(|kind| kind == "yaml" || kind == "yml");
    if part { of_part(args, format, knowledge, context) } else { of_list(args, format, knowledge, context) }
}

/// The order of a part in JSON.
#[derive(Serialize)]
struct PartAnswer<'p> {
    sequence: &'p [ToolVisit],
    visiting: &'p [Visiting],
    time: Times,
    tool_change_at: Point,
}

fn of_part(args: &Args, format: Format, knowledge: &Knowledge, context: &Context) -> Result<Outcome, CliError> {
    let of_lists = [
        ("--metric", args.metric.is_some()),
        ("--closed", args.closed),
        ("--machine", args.machine.is_some()),
        ("--tries", args.tries.is_some()),
        ("--time", args.time.is_some()),
    ];
    if let Some((option, _)) = of_lists.into_iter().find(|(_, given)| *given) {
        let message = words::option_of_lists(context.lang, option);
        return Err(Diagnostic::error("option-of-lists", message, None)
            .help(words::leave_out(context.lang, option))
            .into());
    }
    let mut plan = plan::make(&args.file, CuttingMethod::default(), knowledge, context)?;
    let machine = machine(&plan.part.machine, knowledge, context)?;
    if let Some(effort) = args.effort {
        plan.sequence = sequence(&plan.part, &plan.holes, &machine, Some(Effort(effort)));
        let shop = Shop::new(&plan.part, plan.cutting, knowledge);
        shop.and_then(|shop| timed(&mut plan, &shop)).map_err(|error| CliError::of_knowledge(&error, context.lang))?;
    }
    for at in 0..plan.sequence.len() {
        plan.sequence[at].bound_min = visit_bound(&plan.sequence[at], &plan, &machine);
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
            let panel = |visit: &ToolVisit| {
                let mut path = vec![home];
                path.extend(visit.stops.iter().map(|stop| stop.at));
                path.dedup();
                let title = report::order::visit_title(visit, context.lang);
                Panel { title, path, from_change: true, closed: true }
            };
            let panels: Vec<Panel> = plan.sequence.iter().map(panel).collect();
            context.emit_cleaned(&order_drawing::drawing(&panels, Some(&plan.part)))?;
        }
        _ => {
            let not_kept: Vec<Finding> =
                plan.visiting.iter().filter_map(|visiting| not_kept(visiting, &machine)).collect();
            context.emit_document(&report::order::part_page(&plan, home, &not_kept, context.lang), format)?;
        }
    }
    Ok(if plan.has_errors() { Outcome::Findings } else { Outcome::Done })
}

fn of_list(args: &Args, format: Format, knowledge: &Knowledge, context: &Context) -> Result<Outcome, CliError> {
    let List { form, points, names } = read(args, context)?;
    // A missing machine is reported even if no rapids are requested.
    let rapids = machine(args.machine.as_deref().unwrap_or(MACHINE), knowledge, context)?.rapids();
    let name = args.metric.unwrap_or(MetricName::Euclid);
    let metric = match (name, form) {
        (MetricName::Euclid, Form::Csv) => Metric::Euclid,
        (MetricName::Euclid, Form::Tsplib) => Metric::EuclidWhole,
        (MetricName::Rapid, _) => Metric::Rapid(rapids),
    };
    let space = if args.closed { Space::closed(&points, metric) } else { Space::open(&points, metric) };
    let found = search(args, &space);
    let book = nearest_rule(&space);
    let bound = match found.optimal {
        true => Some(found.cost),
        // A longer search gets a longer computation of the bound.
        false => {
            let seconds = args.time.map_or(1, |time| time.as_secs().max(1) as usize);
            Some(bound::lower_bound(&space, found.cost, bound::rounds(space.nodes()).saturating_mul(seconds)))
        }
    };
    // With an acceleration the cost is a time; its length is that of the slower axis.
    let timed = matches!(metric, Metric::Rapid(rapid) if rapid.acceleration.is_some());
    let length = |order: &[usize], cost: i64| match metric {
        Metric::Rapid(rapid) if timed => {
            let even = Metric::Rapid(technolog::machine::Rapid { acceleration: None, ..rapid });
            let space = if args.closed { Space::closed(&points, even) } else { Space::open(&points, even) };
            Micrometres::new(space.length(order))
        }
        _ => Micrometres::new(cost),
    };
    let tour = Tour {
        points: points.len(),
        metric: if name == MetricName::Rapid { "rapid" } else { "euclid" },
        closed: args.closed,
        tries: found.tries,
        order: found.order.iter().map(|&point| names[point]).collect(),
        length_mm: length(&found.order, found.cost),
        time_min: metric.minutes(found.cost).map(|time| time.rounded(4)),
        nearest_length_mm: length(&book.order, book.cost),
        nearest_time_min: metric.minutes(book.cost).map(|time| time.rounded(4)),
        // Rounded down, so that it stays a bound.
        bound_min: bound
            .and_then(|bound| metric.minutes(bound))
            .map(|time| Minutes((time.0 * 10_000.0).floor() / 10_000.0)),
        bound_mm: bound.filter(|_| !timed).map(Micrometres::new),
        optimal: found.optimal,
    };
    match format {
        Format::Json => context.emit_json(&tour)?,
        Format::Svg => {
            let path = found.order.iter().map(|&point| points[point]).collect();
            let title = report::order::tour_title(&tour, context.lang);
            let panel = Panel { title, path, from_change: false, closed: args.closed };
            context.emit_cleaned(&order_drawing::drawing(&[panel], None))?;
        }
        _ => context.emit_document(&report::order::list_page(&tour, context.lang), format)?,
    }
    Ok(Outcome::Done)
}

/// The path of a list, searched as long as the arguments say. The clock is read here, never by the search.
fn search(args: &Args, space: &Space<'_>) -> Path {
    let points = space.points().len();
    match args.time {
        Some(time) => {
            let start = Instant::now();
            path_while(space, &mut |_| start.elapsed() < time)
        }
        None => {
            let of_effort = args.effort.map(|effort| Effort(effort).tries(points));
            let most = args.tries.map(u64::from).or(of_effort).unwrap_or_else(|| usual_tries(points));
            path_while(space, &mut |tries| tries < most)
        }
    }
}

fn read(args: &Args, context: &Context) -> Result<List, CliError> {
    let shown = args.file.display().to_string();
    let text = context.text(&args.file)?;
    read_list(&shown, &text).map_err(|slips| CliError::Unusable {
        problems: {
            let problems = slips.into_iter().map(|slip| problem(slip, context)).collect();
            kind::or_other(&shown, &text, FileKind::List, problems, context)
        },
        texts: Texts::default().with(&shown, shown.clone(), Cow::Owned(text)),
    })
}

fn problem(slip: ListFault, context: &Context) -> Diagnostic {
    let problem = Diagnostic::error(slip.code, context.lang.say(&slip.note), slip.place);
    match context.lang.remedy(&slip.note) {
        Some(remedy) => problem.help(remedy),
        None => problem,
    }
}
