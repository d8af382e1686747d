//! The jobs of an operation, tool by tool: the page that an operator reads first.

use crate::document::{Block, Column, Document, Inlines, Item, Keep};
use crate::units::{Micrometres, MillimetresPerRev, Minutes};
use technolog_turning::jobs::{Body, Job, Pace, Work};
use technolog_turning::length::Half;
use technolog_turning::operation::times::Times;
use technolog_turning::operation::turret::{station, stations};
use technolog_turning::operation::{Operation, SetUpWork};
use technolog_turning::program::{Seat, Speed};
use technolog_turning::toolpath::Purpose;
use technolog_turning::zones::Hold;
use technolog_words::say;

use super::super::super::sheet::MARK;
use super::super::Lang;
use super::super::cells::{Cell, fixed, table};

/// The jobs of every set-up.
pub(super) fn jobs(page: &mut Document, operation: &Operation, times: &[Times], lang: Lang) {
    let stations = stations(operation);
    for set_up in operation.set_ups.iter().filter(|set_up| !set_up.jobs.is_empty()) {
        let rows =
            set_up.jobs.iter().map(|job| row(job, set_up, station(&stations, job).map(|one| one.seat), lang)).collect();
        page.heading(3, say!(lang, "turn-set-up", number = set_up.set_up.number));
        let mut jobs = table(columns(lang), rows, lang);
        if set_up.jobs.iter().any(|job| !mark(job).is_empty()) {
            jobs.notes.push(say!(lang, "plan-mark", mark = MARK).into());
        }
        page.push(jobs);
        if let Some(times) = times.iter().find(|times| times.set_up == set_up.set_up.number) {
            page.paragraph(time(times, lang));
        }
        let items = set_up.jobs.iter().flat_map(|job| {
            let place = station(&stations, job)
                .map(|one| one.seat)
                .map_or_else(String::new, |seat| format!("{}: ", seated(seat)));
            job.notes.iter().map(move |note| Item::from(format!("{place}{}", lang.say(note))))
        });
        page.blocks.push(Block::List(items.collect()));
    }
    if !times.is_empty() {
        page.paragraph(Inlines::sentence(say!(lang, "turn-job-time-without")));
    }
}

/// A tool by its place; where several tools share places, with its own number behind it.
pub(super) fn seated(seat: Seat) -> String {
    if seat.place == seat.offset { format!("T{}", seat.place) } else { format!("T{}/{}", seat.place, seat.offset) }
}

/// What stands behind the tool of a job that rests on an unconfirmed row.
fn mark(job: &Job) -> &'static str {
    let conditions = job.conditions.iter().flat_map(|conditions| &conditions.because);
    super::super::super::sheet::mark(job.because.iter().chain(conditions))
}

fn columns(lang: Lang) -> [Column; 9] {
    [
        Column::text("T"),
        Column::text(say!(lang, "turn-job")),
        Column::text(say!(lang, "turn-side")).keep(Keep::Useful),
        Column::text(say!(lang, "turn-tool")),
        Column::number(say!(lang, "turn-job-nose"), lang.word("unit-mm")).keep(Keep::Optional),
        Column::number(say!(lang, "turn-job-feed"), lang.word("unit-mm-rev")),
        Column::number("V", lang.word("unit-m-min")),
        Column::number("n", lang.word("unit-1-min")),
        Column::number(say!(lang, "turn-time"), lang.word("unit-min")),
    ]
}

fn row(job: &Job, set_up: &SetUpWork, seat: Option<Seat>, lang: Lang) -> Vec<Cell> {
    let nose = job.tool.nose_radius().to_mm();
    let rpm = match job.pace {
        Pace::PerRev { speed: Speed::Spindle(rpm), .. } => Some(rpm),
        Pace::PerRev { speed: Speed::Cutting { .. }, .. } => None,
        Pace::PerMinute { spindle, .. } => spindle,
    };
    let conditions = job.conditions.as_ref();
    let feed = conditions.map(|conditions| conditions.feed_mm_per_rev).or_else(|| main_feed(job));
    let speed = conditions
        .map(|conditions| conditions.speed_m_per_min)
        .or_else(|| job.pace.cutting_speed(diameter(job, set_up)));
    let or_empty = |figure: Option<f64>, places| figure.map_or_else(Cell::empty, |figure| Cell::Figure(figure, places));
    vec![
        seat.map_or_else(|| mark(job).into(), |seat| format!("{}{}", seated(seat), mark(job)).into()),
        lang.term("turn-does", job.work.name()).into(),
        lang.term("turn-side", job.side.name()).into(),
        job.tool.designation.as_str().into(),
        if nose > 0.0 { Cell::Figure(nose, 2) } else { Cell::empty() },
        match feeds(job) {
            Some((least, most)) => Cell::Range(least.0, most.0, 3),
            None => or_empty(feed.map(|feed| feed.0), 3),
        },
        or_empty(speed.map(|speed| speed.0), 1),
        or_empty(rpm.map(|rpm| rpm.0), 1),
        Cell::Figure(job.time_min.0, 2),
    ]
}

/// The least and the greatest feed of a finishing pass whose surfaces have different ones.
fn feeds(job: &Job) -> Option<(MillimetresPerRev, MillimetresPerRev)> {
    let base = job.pace.feeds()?;
    let own = job.path.moves.iter().filter(|one| one.purpose == Purpose::Finish);
    let all = own.map(|one| one.feed.unwrap_or(base.finish)).collect::<Vec<_>>();
    let least = all.iter().copied().min_by(|one, other| one.0.total_cmp(&other.0))?;
    let most = all.iter().copied().max_by(|one, other| one.0.total_cmp(&other.0))?;
    (job.work == Work::Finish && least != most).then_some((least, most))
}

/// The feed of a job without conditions of its own: that of the plunge, or the pitch.
fn main_feed(job: &Job) -> Option<MillimetresPerRev> {
    let feeds = job.pace.feeds()?;
    Some(match job.work {
        Work::Centre
        | Work::Drill
        | Work::Flatten
        | Work::Countersink
        | Work::CoreDrill
        | Work::Ream
        | Work::Groove
        | Work::PartOff => feeds.plunge,
        Work::Thread | Work::Tap => feeds.thread,
        Work::Face | Work::Rough => feeds.cut,
        Work::Finish => feeds.finish,
    })
}

/// The largest diameter cut by such a job.
fn diameter(job: &Job, set_up: &SetUpWork) -> Option<Micrometres> {
    match (job.work, &job.tool.body, &job.thread) {
        (Work::Drill | Work::Flatten, Body::Drill { diameter_mm, .. }, _)
        | (_, Body::Reamer { diameter_mm, .. } | Body::Tap { diameter_mm, .. }, _) => Some(*diameter_mm),
        (Work::Thread, _, Some(thread)) => Some(thread.crest_radius_mm.max(thread.root_radius_mm).diameter()),
        (Work::Centre, ..) => job.spot_diameter(set_up.rough_face()),
        (Work::PartOff, ..) => match set_up.set_up.holds_at {
            Some(Hold::Blank { diameter_mm, .. }) => Some(diameter_mm),
            _ => None,
        },
        (Work::Groove, ..) => {
            let sides = [&set_up.set_up.outer, &set_up.set_up.inner];
            let surfaces = sides.into_iter().flatten().flat_map(|side| &side.profile.surfaces);
            let made = surfaces.filter(|surface| job.surfaces.contains(&surface.name));
            let pieces = made.flat_map(|surface| &surface.pieces);
            pieces.map(|piece| piece.from.radius.max(piece.to.radius)).max().map(Half::diameter)
        }
        _ => None,
    }
}

fn time(times: &Times, lang: Lang) -> String {
    let shown = |time: Minutes| fixed(time.0, 2, lang);
    say!(
        lang,
        "turn-job-time",
        number = times.set_up,
        cutting = shown(times.cutting_min),
        rapids = shown(times.rapid_min),
        count = times.tool_changes,
        changes = shown(times.tool_change_min),
        starts = shown(times.spindle_start_min),
        load = shown(times.load_min),
        total = shown(times.total())
    )
}
