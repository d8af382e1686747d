//! Reads a plan written by `technolog plan --format json` or `yaml` as a stated plan.

use std::collections::BTreeMap;
use technolog_note::note;

use serde::Deserialize;

use crate::error::KnowledgeError;
use crate::knowledge::yaml::{Node, NodeKind, Problems};
use crate::knowledge::{Knowledge, Place};
use crate::part::{Face, Part, Point};
use crate::plan::{CuttingMethod, Feature, Limit, Operation};

use super::limits;
use super::quantity::Quantity;
use super::read::{MOST, number};
use super::stated::{Author, Clamping, Conditions, Figures, Row, Stated, StatedFigure, StatedValue, Text, Tool};
use super::tolerance::Tolerances;

/// The fields read as a whole; all others are read with their places.
#[derive(Deserialize)]
struct Head {
    part: Part,
    #[serde(default)]
    cutting: CuttingMethod,
}

const CONDITIONS: [(&str, Quantity); 10] = [
    ("depth_of_cut_mm", Quantity::DepthOfCut),
    ("feed_mm_per_rev", Quantity::Feed),
    ("computed_speed_m_per_min", Quantity::Speed),
    ("speed_m_per_min", Quantity::SpeedTaken),
    ("spindle_rpm", Quantity::Rpm),
    ("feed_mm_per_min", Quantity::MinuteFeed),
    ("axial_force_n", Quantity::Force),
    ("torque_n_m", Quantity::Torque),
    ("power_kw", Quantity::Power),
    ("machine_time_min", Quantity::Time),
];

const CLAMPING: [(&str, Quantity); 5] = [
    ("side_force_n", Quantity::SideForce),
    ("torque_n_m", Quantity::Torque),
    ("distance_mm", Quantity::Distance),
    ("force_n", Quantity::ClampForce),
    ("force_per_clamp_n", Quantity::ForcePerClamp),
];

const TOOL: [(&str, Quantity); 6] = [
    ("diameter_mm", Quantity::Diameter),
    ("overhang_mm", Quantity::Overhang),
    ("length_mm", Quantity::Assembly),
    ("corrector", Quantity::Corrector),
    ("correction_mm", Quantity::Correction),
    ("book_correction_mm", Quantity::BookCorrection),
];

const TIMES: [(&str, Quantity); 7] = [
    ("machine_min", Quantity::MachineTime),
    ("feed_out_min", Quantity::FeedOutTime),
    ("dwell_min", Quantity::DwellTime),
    ("hand_min", Quantity::HandTime),
    ("rapid_min", Quantity::RapidTime),
    ("tool_change_min", Quantity::ChangeTime),
    ("total_min", Quantity::TotalTime),
];

/// Reads the plan. Missing fields are not stated; a text in place of a figure is a mistake.
pub(super) fn read(
    root: &Node,
    text: &str,
    file: &str,
    problems: &mut Problems,
    knowledge: &Knowledge,
) -> Option<Stated> {
    // JSON is YAML, but its enums are written differently.
    let json = text.trim_start().starts_with('{');
    let head: Result<Head, (String, Option<(usize, usize)>)> = if json {
        serde_json::from_str(text).map_err(|error| (error.to_string(), Some((error.line(), error.column()))))
    } else {
        serde_yaml::from_str(text).map_err(|error: serde_yaml::Error| {
            (error.to_string(), error.location().map(|at| (at.line(), at.column())))
        })
    };
    let head = match head {
        Ok(head) => head,
        Err((error, at)) => {
            let help = note!("planfile-write-anew-with-technolog-plan");
            let number = |at: usize| u32::try_from(at).unwrap_or(u32::MAX).max(1);
            let place = at.map_or_else(
                || root.place.clone(),
                |(line, column)| Place { line: number(line), column: number(column), width: 1, ..root.place.clone() },
            );
            return problems.error_help("bad-plan", note!("planfile-no-plan-ours", error = error), &place, help);
        }
    };
    if let Some((message, help)) = head.part.beyond_bounds().or_else(|| head.part.outside_tables(knowledge)) {
        let place = &root.get("part").unwrap_or(root).place;
        return problems.error_help("bad-value", message, place, help);
    }
    if let Some(node) = several_lines(root) {
        return problems.text(node).and(None);
    }
    if let Some((node, text)) = endless(root) {
        let message = note!("planfile-beyond-all-figures", text = text, most = MOST);
        return problems.error_help(
            "bad-value",
            message,
            &node.place,
            note!("planfile-write-anew-with-technolog-plan"),
        );
    }
    let tolerances: Result<Tolerances, KnowledgeError> = Tolerances::read(knowledge);
    let Ok(tolerances) = tolerances else {
        return problems.error("knowledge", note!("planfile-table-audit-tolerance-cannot-used"), &root.place);
    };
    let mut reader = OwnPlanReader { problems, tolerances };
    let (mut rows, mut conditions) = (Vec::new(), Vec::new());
    for hole in items(root.get("holes")) {
        let name = text_of(hole, "name");
        let scheme = hole.get("route").and_then(|route| text_of(route, "scheme"));
        let table = hole.get("route").and_then(|route| text_of(route, "table"));
        for node in items(hole.get("transitions")) {
            let Some(mut row) = reader.row(node, rows.len()) else { continue };
            row.hole.clone_from(&name);
            row.scheme.clone_from(&scheme);
            row.table.clone_from(&table);
            row.figures.extend(
                hole.get("count").and_then(|node| reader.figure(node, Quantity::Count)).map(|f| (Quantity::Count, f)),
            );
            if let Some(own) = node.get("conditions") {
                conditions.push(reader.conditions(own, node, rows.len()));
            }
            rows.push(row);
        }
    }
    limits::rows(&rows, |row: &Row| &row.place, reader.problems);
    let tools = limits::tools(items(root.get("tools")), |tool| &tool.place, reader.problems)
        .iter()
        .filter_map(|node| reader.tool(node))
        .collect();
    let changes: Vec<u32> =
        items(root.get("sequence")).iter().filter_map(|visit| visit.get("tool")?.text()?.parse().ok()).collect();
    let clamping = root.get("clamping").filter(|node| !node.is_null()).map(|node| reader.clamping(node));
    let times = root.get("time").map(|node| reader.figures(node, &TIMES)).unwrap_or_default();
    Some(Stated {
        name: head.part.part.clone(),
        file: file.to_owned(),
        part: head.part,
        method: head.cutting,
        scope: None,
        is_own: true,
        tree: Some(root.clone()),
        rows,
        tools,
        conditions,
        clamping,
        program: None,
        times,
        changes: Some(changes),
        author: Author::default(),
        is_list: false,
        unsaid: None,
        remarks: Vec::new(),
    })
}

/// A number such as `1e400`, which every formula reads as infinite; a later message could not quote what is written.
fn endless(node: &Node) -> Option<(&Node, &str)> {
    match &node.kind {
        NodeKind::Scalar { text, quoted: false } => {
            let is_endless = text.parse::<f64>().is_ok_and(f64::is_infinite);
            (is_endless && text.contains(|sign: char| sign.is_ascii_digit())).then_some((node, text.as_str()))
        }
        NodeKind::Scalar { .. } => None,
        NodeKind::Seq(items) => items.iter().find_map(endless),
        NodeKind::Map(entries) => entries.iter().find_map(|(_, node)| endless(node)),
    }
}

struct OwnPlanReader<'a> {
    problems: &'a mut Problems,
    tolerances: Tolerances,
}

impl OwnPlanReader<'_> {
    fn figure(&mut self, node: &Node, quantity: Quantity) -> Option<StatedFigure> {
        let text = node.text()?;
        if node.is_null() {
            return None;
        }
        let value = number(text).map(|(value, _)| value).or_else(|| text.parse().ok());
        // `1e400` is infinite, and larger than any figure written by hand.
        let Some(value) = value.filter(|value: &f64| value.abs() <= MOST) else {
            return self.problems.error("bad-value", note!("case-number", text = text), &node.place);
        };
        let places = i32::try_from(self.tolerances.own_places(quantity)).unwrap_or(0);
        let last_place = libm::pow(10.0, f64::from(-places));
        Some(StatedFigure { value, text: text.to_owned(), last_place, place: node.place.clone() })
    }

    fn figures(&mut self, node: &Node, keys: &[(&str, Quantity)]) -> Figures {
        let mut figures = Figures::new();
        for (key, quantity) in keys {
            figures
                .extend(node.get(key).and_then(|node| self.figure(node, *quantity)).map(|figure| (*quantity, figure)));
        }
        figures
    }

    fn row(&mut self, node: &Node, at: usize) -> Option<Row> {
        let operation = node.get("operation")?;
        let name = operation.text()?;
        let Some(value) = Operation::from_name(name) else {
            let names: Vec<&str> = Operation::NAMES.iter().map(|(name, _)| *name).collect();
            let help = note!("part-may", names = names.join(", "));
            return self.problems.error_help(
                "bad-value",
                note!("planfile-no-operation", name = name),
                &operation.place,
                help,
            );
        };
        let keys = [
            ("diameter_mm", Quantity::Diameter),
            ("from_diameter_mm", Quantity::From),
            ("depth_mm", Quantity::Depth),
            ("passes", Quantity::Passes),
            ("also_diameter_mm", Quantity::Also),
        ];
        let feature = node.get("feature").and_then(Node::text);
        let face = node.get("face").and_then(Node::text).and_then(|text| serde_yaml::from_str::<Face>(text).ok());
        let number_node = node.get("tool").and_then(|tool| tool.get("number"));
        let tool = number_node
            .and_then(|node| Some(StatedValue { value: node.text()?.parse().ok()?, place: node.place.clone() }));
        Some(Row {
            number: u32::try_from(at + 1).unwrap_or(u32::MAX),
            place: node.place.clone(),
            operation: StatedValue { value, place: operation.place.clone() },
            hole: None,
            feature: feature.and_then(|text| serde_yaml::from_str::<Feature>(text).ok()),
            step: node.get("step").and_then(Node::text).and_then(|text| text.parse().ok()),
            setup: face.map(|face| if face == Face::Back { 2 } else { 1 }),
            elsewhere: node.get("elsewhere").and_then(Node::text) == Some("true"),
            tool: tool.filter(|tool: &StatedValue<u32>| tool.value > 0),
            scheme: None,
            table: None,
            figures: self.figures(node, &keys),
        })
    }

    fn conditions(&mut self, node: &Node, transition: &Node, row: usize) -> Conditions {
        let mut figures = self.figures(node, &CONDITIONS);
        figures.extend(self.figures(transition, &[("travel_mm", Quantity::Travel)]));
        Conditions {
            place: node.place.clone(),
            rows: vec![row],
            is_limited: node
                .get("limited_by")
                .and_then(Node::text)
                .is_some_and(|limit| limit != Limit::CuttingSpeed.name()),
            rounds: node.get("rounds").is_some_and(|rounds| !rounds.is_null()),
            factors: BTreeMap::new(),
            figures,
        }
    }

    fn tool(&mut self, node: &Node) -> Option<Tool> {
        let number = node.get("number")?.text()?.parse().ok()?;
        let mut figures = self.figures(node, &TOOL);
        for link in items(node.get("links")) {
            let length = link.get("length_mm");
            if link.get("kind").and_then(Node::text) == Some("holder") {
                let used = length.and_then(|node| self.figure(node, Quantity::HolderUsed));
                figures.extend(used.map(|figure| (Quantity::HolderUsed, figure)));
            }
        }
        Some(Tool {
            number,
            place: node.place.clone(),
            designation: text_of(node, "designation"),
            standard: None,
            table: text_of(node, "table"),
            shank: None,
            holder: text_of(node, "holder"),
            holder_standard: None,
            correction_word: None,
            figures,
        })
    }

    fn clamping(&mut self, node: &Node) -> Clamping {
        let point = |node: &Node| {
            let [x, y] = ["x", "y"].map(|axis| node.get(axis).and_then(Node::text).and_then(|text| text.parse().ok()));
            let listed = || {
                let mut two = items(Some(node)).iter().filter_map(|node| node.text()?.parse().ok());
                Some(Point { x: two.next()?, y: two.next()? })
            };
            x.zip(y).map(|(x, y)| Point { x, y }).or_else(listed)
        };
        let at: Vec<Point> = items(node.get("clamps")).iter().filter_map(point).collect();
        let mut figures = self.figures(node, &CLAMPING);
        if let Some(clamps) = node.get("clamps") {
            let text = at.len().to_string();
            let figure = StatedFigure { value: at.len() as f64, text, last_place: 1.0, place: clamps.place.clone() };
            figures.insert(Quantity::Clamps, figure);
        }
        Clamping {
            place: node.place.clone(),
            row: None,
            hole: text_of(node, "hole"),
            screw: text_of(node, "screw"),
            designation: None,
            standard: None,
            at,
            figures,
        }
    }
}

/// The first text with several lines: no plan of the program has one.
fn several_lines(node: &Node) -> Option<&Node> {
    match &node.kind {
        NodeKind::Scalar { text, .. } => text.contains(['\n', '\t']).then_some(node),
        NodeKind::Seq(items) => items.iter().find_map(several_lines),
        NodeKind::Map(entries) => entries.iter().find_map(|(_, node)| several_lines(node)),
    }
}

/// The items of a list; none if the node is no list.
pub(super) fn items(node: Option<&Node>) -> &[Node] {
    match node.map(|node| &node.kind) {
        Some(NodeKind::Seq(items)) => items,
        _ => &[],
    }
}

fn text_of(node: &Node, key: &str) -> Option<Text> {
    let node = node.get(key).filter(|node| !node.is_null())?;
    Some(StatedValue { value: node.text()?.to_owned(), place: node.place.clone() })
}
