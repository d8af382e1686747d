//! Writes a plan of the program in the form of a hand-written one, to edit and audit.
//!
//! `read` reads it back. A hand-written plan has no reasons and no rejected candidates.

use std::collections::BTreeMap;
use std::fmt::{Display, Write as _};

use crate::cutting::rpm_at;
use crate::part::Face;
use crate::plan::{Conditions, CuttingMethod, HolePlan, Limit, Operation, Plan, ToolPlan, Transition};
use crate::units::round_to;

/// A transition of a group of holes, by their places in the plan.
type At = (usize, usize);

/// The plan as hand-written YAML; `part` is the path of its part, relative to the place of the new file.
pub fn by_hand(plan: &Plan, part: &str) -> String {
    let rows = rows(plan);
    let mut text = String::new();
    push_line(&mut text, &format!("plan: {}", scalar(&plan.part.part)));
    push_line(&mut text, &format!("part: {}", scalar(part)));
    if plan.cutting != CuttingMethod::default() {
        push_line(&mut text, &format!("cutting: {}", plan.cutting.name()));
    }
    list(&mut text, "route", rows.iter().enumerate().map(|(at, row)| self::row(plan, at, *row)));
    if !plan.tools.is_empty() {
        push_line(&mut text, "tools:");
        plan.tools.iter().for_each(|tool| self::tool(&mut text, tool));
    }
    list(&mut text, "conditions", all_conditions(plan, &rows));
    text.push_str(&clamping(plan));
    let time = plan.time;
    let mut times = Flow::default();
    times.push_field("machine", time.machine_min.0);
    let more = [("feed_out", time.feed_out_min), ("dwell", time.dwell_min)];
    for (key, time) in more.into_iter().filter(|(_, time)| time.0 > 0.0) {
        times.push_field(key, time.0);
    }
    times.push_field("rapid", time.rapid_min.0).push_field("tool_change", time.tool_change_min.0);
    if time.hand_min.0 > 0.0 {
        times.push_field("hand", time.hand_min.0);
    }
    times.push_field("total", time.total_min.0);
    push_line(&mut text, &format!("times: {}", times.done()));
    text
}

/// Every transition once, in the order in which the tools come to it; then the work on another machine.
fn rows(plan: &Plan) -> Vec<At> {
    let place = |name: &str| plan.holes.iter().position(|hole| hole.name == name);
    let stops = plan.sequence.iter().flat_map(|visit| &visit.stops);
    let visited = stops.filter_map(|stop| Some((place(&stop.hole)?, stop.transition)));
    let of_hole = |(at, hole): (usize, &HolePlan)| (0..hole.transitions.len()).map(move |one| (at, one)).collect();
    let all: Vec<At> = plan.holes.iter().enumerate().flat_map(|one| -> Vec<At> { of_hole(one) }).collect();
    let mut rows: Vec<At> = Vec::new();
    for row in visited.chain(all) {
        if !rows.contains(&row) && transition(plan, row).is_some() {
            rows.push(row);
        }
    }
    rows
}

fn transition(plan: &Plan, (hole, one): At) -> Option<&Transition> {
    plan.holes.get(hole)?.transitions.get(one)
}

fn row(plan: &Plan, at: usize, own: At) -> String {
    let mut flow = Flow::default();
    let (Some(hole), Some(transition)) = (plan.holes.get(own.0), transition(plan, own)) else { return flow.done() };
    flow.push_field("row", at + 1)
        .push_field("operation", transition.operation.name())
        .push_field("hole", scalar(&hole.name));
    flow.push_field("count", hole.count);
    if transition.feature != crate::plan::Feature::Bore {
        flow.push_field("feature", transition.feature.name());
    }
    flow.maybe("step", transition.step);
    if transition.face == Face::Back {
        flow.push_field("setup", 2);
    }
    if transition.operation != Operation::CentreDrill && transition.operation != Operation::Tap {
        flow.push_field("from", transition.from_diameter_mm);
    }
    flow.push_field("diameter", transition.diameter_mm).maybe("also", transition.also_diameter_mm);
    flow.push_field("depth", transition.depth_mm);
    if transition.passes > 1 {
        flow.push_field("passes", transition.passes);
    }
    if transition.elsewhere {
        flow.push_field("elsewhere", true);
    } else {
        flow.push_field("tool", format!("T{}", transition.tool.number));
    }
    if let Some(route) = hole.route.as_ref().filter(|route| own.1 == 0 && !route.scheme.is_empty()) {
        flow.push_field("scheme", scalar(&route.scheme)).push_field("table", scalar(&route.table));
    }
    flow.done()
}

fn tool(text: &mut String, tool: &ToolPlan) {
    push_line(text, &format!("  T{}:", tool.number));
    let mut line = |key: &str, value: &dyn Display| push_line(text, &format!("    {key}: {value}"));
    line("designation", &scalar(&tool.designation));
    line("table", &scalar(&tool.table));
    line("diameter", &tool.diameter_mm);
    let holder = tool.links.iter().find(|link| link.kind == "holder");
    if let Some(holder) = holder {
        line("holder", &format!("{{designation: {}, length: {}}}", scalar(&tool.holder), holder.length_mm));
    }
    line("overhang", &tool.overhang_mm);
    if let Some(holder) = holder {
        line("holder_used", &holder.length_mm);
    }
    line("assembly", &tool.length_mm);
    line("corrector", &tool.corrector);
    line("correction", &tool.correction_mm);
    line("with", &"G43");
}

/// Conditions, each once with all the rows it is for.
fn all_conditions(plan: &Plan, rows: &[At]) -> Vec<String> {
    let mut order: Vec<String> = Vec::new();
    let mut rows_by_text: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (at, row) in rows.iter().enumerate() {
        let Some(transition) = transition(plan, *row).filter(|transition| !transition.elsewhere) else { continue };
        // The same tool at the same conditions is written once.
        let key = format!("T{} {}", transition.tool.number, conditions(transition));
        let known = rows_by_text.entry(key.clone()).or_default();
        if known.is_empty() {
            order.push(key);
        }
        known.push(at + 1);
    }
    let with_rows = |key: &String| {
        let rows: Vec<String> = rows_by_text.get(key)?.iter().map(usize::to_string).collect();
        let (_, figures) = key.split_once(' ')?;
        Some(format!("{{for: [{}], {figures}}}", rows.join(", ")))
    };
    order.iter().filter_map(with_rows).collect()
}

fn conditions(transition: &Transition) -> String {
    let conditions: &Conditions = &transition.conditions;
    let mut flow = Flow::default();
    flow.push_field("depth_of_cut", conditions.depth_of_cut_mm).push_field("feed", conditions.feed_mm_per_rev.0);
    flow.push_field("speed", conditions.computed_speed_m_per_min.0);
    if conditions.rounds.is_none() && !matches!(transition.operation, Operation::Mill) {
        let diameter = transition.also_diameter_mm.unwrap_or(transition.diameter_mm);
        flow.push_field("rpm_computed", round_to(rpm_at(conditions.computed_speed_m_per_min, diameter).0, 1));
    }
    flow.push_field("rpm", conditions.spindle_rpm.0);
    if conditions.limited_by != Limit::CuttingSpeed {
        flow.push_field("limited_by", conditions.limited_by.name());
    }
    flow.push_field("speed_taken", conditions.speed_m_per_min.0)
        .push_field("minute_feed", conditions.feed_mm_per_min.0);
    flow.maybe("force", conditions.axial_force_n.map(|force| force.0));
    flow.maybe("torque", conditions.torque_n_m.map(|torque| torque.0));
    flow.maybe("power", conditions.power_kw.map(|power| power.0));
    flow.push_field("travel", transition.travel_mm).push_field("time", conditions.machine_time_min.0);
    // With another limit, the life is that of a lower load, not the one for which speeds are given.
    if conditions.limited_by == Limit::CuttingSpeed {
        flow.push_field("tool_life", conditions.tool_life_min.0);
    }
    flow.0.join(", ")
}

fn clamping(plan: &Plan) -> String {
    let Some(clamping) = &plan.clamping else { return String::new() };
    let mut flow = Flow::default();
    flow.push_field("hole", scalar(&clamping.hole)).push_field("torque", clamping.torque_n_m.0);
    flow.maybe("side_force", clamping.side_force_n.map(|force| force.0));
    flow.push_field("distance", clamping.distance_mm).push_field("force", clamping.force_n.0);
    let at: Vec<String> = clamping.clamps.iter().map(|point| format!("[{}, {}]", point.x, point.y)).collect();
    flow.push_field("clamps", clamping.clamps.len()).push_field("at", format!("[{}]", at.join(", ")));
    flow.push_field("force_per_clamp", clamping.force_per_clamp_n.0).push_field("screw", scalar(&clamping.screw));
    format!("clamping: {}\n", flow.done())
}

/// A mapping on one line: `{row: 1, operation: drill}`.
#[derive(Default)]
struct Flow(Vec<String>);

impl Flow {
    fn push_field(&mut self, key: &str, value: impl Display) -> &mut Self {
        self.0.push(format!("{key}: {value}"));
        self
    }

    fn maybe(&mut self, key: &str, value: Option<impl Display>) -> &mut Self {
        if let Some(value) = value {
            self.push_field(key, value);
        }
        self
    }

    fn done(&self) -> String {
        format!("{{{}}}", self.0.join(", "))
    }
}

fn push_line(text: &mut String, line: &str) {
    text.push_str(line);
    text.push('\n');
}

fn list(text: &mut String, key: &str, items: impl IntoIterator<Item = String>) {
    let mut items = items.into_iter().peekable();
    if items.peek().is_some() {
        push_line(text, &format!("{key}:"));
    }
    for item in items {
        let _ = writeln!(text, "  - {item}");
    }
}

/// A text as YAML reads it back as the same text, also within a mapping on one line.
fn scalar(text: &str) -> String {
    let plain = |letter: char| letter.is_alphanumeric() || matches!(letter, ' ' | '-' | '_' | '.' | '/');
    let word = text.starts_with(char::is_alphabetic) && !text.ends_with(' ') && text.chars().all(plain);
    let reserved =
        ["true", "false", "null", "yes", "no", "on", "off", "y", "n"].contains(&text.to_lowercase().as_str());
    if word && !reserved { text.to_owned() } else { serde_json::Value::from(text).to_string() }
}
