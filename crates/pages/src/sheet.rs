//! The plan as a page to pin to the wall: route, tools, conditions, clamping, corrections, time, findings.

use crate::knowledge::Knowledge;
use crate::machine::Machine;
use crate::material::Material;
use crate::note::{Because, Severity};
use crate::plan::{Conditions, Limit, Plan, ToolPlan, Transition};
use crate::units::{Micrometres, round_to};

use super::sentences::term;
use super::{Lang, grid, operation_noun, operation_verb, sentence};

pub(crate) mod route;

/// The mark of a figure that rests on an unconfirmed row.
const MARK: &str = "*";

/// The whole page.
pub fn page(plan: &Plan, knowledge: &Knowledge, lang: Lang) -> String {
    let sections = [
        head(plan, knowledge, lang),
        section(1, lang.pick("Технологічний маршрут", "Route"), &route::section(plan, lang)),
        section(2, lang.pick("Різальний і допоміжний інструмент", "Cutters and holders"), &tools(plan, lang)),
        section(3, lang.pick("Режими різання", "Cutting conditions"), &conditions(plan, lang)),
        section(4, lang.pick("Закріплення", "Clamping"), &clamping(plan, lang)),
        section(5, lang.pick("Корекція довжини інструмента", "Tool-length corrections"), &corrections(plan, lang)),
        section(6, lang.pick("Час", "Time"), &time(plan, lang)),
        section(7, lang.pick("Зауваження", "Findings"), &findings(plan, lang)),
    ];
    sections.into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join("\n")
}

fn section(number: usize, title: &str, body: &str) -> String {
    if body.is_empty() { String::new() } else { format!("{number}. {title}\n{body}") }
}

/// A table, or its rows one under the other when it cannot be narrow enough.
fn table(head: &[&str], rows: &[Vec<String>]) -> String {
    let head: Vec<String> = head.iter().map(|&cell| cell.to_owned()).collect();
    grid::table(&head, rows, 2)
}

/// A number as people write it: a comma in Ukrainian, no trailing zeros.
pub(crate) fn number(value: f64, places: u32, lang: Lang) -> String {
    let text = round_to(value, places).to_string();
    lang.pick(&text.replace('.', ","), &text).to_owned()
}

pub(crate) fn mm(value: Micrometres, lang: Lang) -> String {
    let text = value.to_string();
    lang.pick(&text.replace('.', ","), &text).to_owned()
}

fn mark(because: &[Because]) -> &'static str {
    if because.iter().any(|reason| reason.unconfirmed.is_some()) { MARK } else { "" }
}

fn head(plan: &Plan, knowledge: &Knowledge, lang: Lang) -> String {
    let part = &plan.part;
    let material = Material::find(knowledge, &part.material);
    let material = material.map_or(part.material.as_str(), |material| material.designation());
    let machine = Machine::find(knowledge, &part.machine).map(|machine| &machine.table.title);
    let machine = machine.map_or(part.machine.as_str(), |title| lang.pick(&title.uk, &title.en));
    let blank = &part.blank;
    format!(
        "{}. {}. {} {} × {} × {} {}. {}.\n",
        part.part,
        material,
        lang.pick("Заготовка: плита", "Blank: plate"),
        mm(blank.length, lang),
        mm(blank.width, lang),
        mm(blank.thickness, lang),
        lang.pick("мм", "mm"),
        machine
    )
}

fn tools(plan: &Plan, lang: Lang) -> String {
    let rows: Vec<Vec<String>> = plan
        .tools
        .iter()
        .map(|tool| {
            vec![
                format!("T{}", tool.number),
                format!("{}{}", tool.designation, mark(&tool.because)),
                tool.table.clone(),
                mm(tool.diameter_mm, lang),
                tool_name(plan, tool, lang),
                tool.holder.clone(),
                mm(tool.length_mm - tool.overhang_mm, lang),
                mm(tool.overhang_mm, lang),
                mm(tool.length_mm, lang),
            ]
        })
        .collect();
    let head = [
        "T",
        lang.pick("Позначення", "Designation"),
        lang.pick("Таблиця", "Table"),
        "Ø",
        lang.pick("Для", "For"),
        lang.pick("Допоміжний", "Holder"),
        lang.pick("l, мм", "l, mm"),
        lang.pick("Виліт, мм", "Overhang, mm"),
        lang.pick("Комплект, мм", "Assembly, mm"),
    ];
    if rows.is_empty() { String::new() } else { table(&head, &rows) }
}

/// What a tool does, over all holes.
fn tool_name(plan: &Plan, tool: &ToolPlan, lang: Lang) -> String {
    let mut names: Vec<&str> = Vec::new();
    for transition in plan.holes.iter().flat_map(|hole| &hole.transitions) {
        let name = operation_noun(transition.operation.name(), lang);
        if transition.tool.number == tool.number && !names.contains(&name) {
            names.push(name);
        }
    }
    names.join(", ")
}

fn conditions(plan: &Plan, lang: Lang) -> String {
    let mut rows = Vec::new();
    for hole in &plan.holes {
        for transition in &hole.transitions {
            let conditions = &transition.conditions;
            let row = condition_row(&hole.name, transition, conditions, lang);
            // Groups that share a transition in all its figures share its line.
            let same = rows.iter_mut().find(|known: &&mut Vec<String>| known[1..] == row[1..]);
            match same {
                Some(known) if known[0].split(", ").any(|name| name == hole.name) => {}
                Some(known) => known[0] = format!("{}, {}", known[0], hole.name),
                None => rows.push(row),
            }
        }
    }
    if rows.is_empty() {
        return String::new();
    }
    let head: [&str; 12] = match lang {
        _ if lang == Lang::UK => [
            "Отв.",
            "Перехід",
            "Ø, мм",
            "t, мм",
            "s, мм/об",
            "V, м/хв",
            "n, об/хв",
            "sхв, мм/хв",
            "P, Н",
            "M, Н·м",
            "N, кВт",
            "To, хв",
        ],
        _ => [
            "Hole",
            "Transition",
            "Ø, mm",
            "t, mm",
            "s, mm/rev",
            "V, m/min",
            "n, 1/min",
            "vf, mm/min",
            "P, N",
            "M, N·m",
            "N, kW",
            "Tm, min",
        ],
    };
    let mut text = table(&head, &rows);
    let once = lang.pick("To - на один отвір.", "Tm is for one hole.");
    text.push_str(&grid::paragraph(&format!("{once} {}", coolant(plan, lang)), 2));
    text.push_str(&limits(plan, lang));
    text
}

/// Which transitions the speeds take coolant for; the tables do not say it of every transition.
fn coolant(plan: &Plan, lang: Lang) -> String {
    let mut names: Vec<&str> = Vec::new();
    for transition in plan.holes.iter().flat_map(|hole| &hole.transitions) {
        let name = operation_noun(transition.operation.name(), lang);
        if transition.conditions.coolant == Some(true) && !names.contains(&name) {
            names.push(name);
        }
    }
    match names.as_slice() {
        [] => String::new(),
        _ => format!("{}: {}.", lang.pick("З охолодженням", "With coolant"), names.join(", ")),
    }
}

fn condition_row(hole: &str, transition: &Transition, conditions: &Conditions, lang: Lang) -> Vec<String> {
    let optional =
        |value: Option<f64>, places: u32| value.map_or_else(|| "-".to_owned(), |value| number(value, places, lang));
    vec![
        hole.to_owned(),
        format!("{}{}", operation_noun(transition.operation.name(), lang), mark(&conditions.because)),
        mm(transition.diameter_mm, lang),
        number(conditions.depth_of_cut_mm, 2, lang),
        number(conditions.feed_mm_per_rev.0, 3, lang),
        number(conditions.speed_m_per_min.0, 1, lang),
        number(conditions.spindle_rpm.0, 0, lang),
        number(conditions.feed_mm_per_min.0, 0, lang),
        optional(conditions.axial_force_n.map(|force| force.0), 0),
        optional(conditions.torque_n_m.map(|torque| torque.0), 1),
        optional(conditions.power_kw.map(|power| power.0), 2),
        number(conditions.machine_time_min.0, 2, lang),
    ]
}

/// What held the conditions back, where it is not simply the cutting speed; and the card's own figures.
fn limits(plan: &Plan, lang: Lang) -> String {
    let mut lines = Vec::new();
    for hole in &plan.holes {
        for transition in &hole.transitions {
            let conditions = &transition.conditions;
            let name = operation_noun(transition.operation.name(), lang);
            if conditions.limited_by != Limit::CuttingSpeed {
                let by = term(conditions.limited_by.name(), lang);
                let size = mm(transition.diameter_mm, lang);
                let line = format!("{} {name} Ø{size}: {} {by}", hole.name, lang.pick("обмежує", "limited by"));
                if !lines.contains(&line) {
                    lines.push(line);
                }
            }
            if let Some(card) = &conditions.card {
                let optional =
                    |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| number(value, 2, lang));
                lines.push(format!(
                    "{} {}: {} s = {}, V = {}, P = {}, N = {}",
                    hole.name,
                    name,
                    lang.pick("карта", "card"),
                    number(card.feed_mm_per_rev.0, 3, lang),
                    number(card.speed_m_per_min.0, 1, lang),
                    optional(card.axial_force_n.map(|force| force.0)),
                    optional(card.power_kw.map(|power| power.0)),
                ));
            }
        }
    }
    lines.iter().map(|line| grid::paragraph(line, 2)).collect()
}

fn clamping(plan: &Plan, lang: Lang) -> String {
    let Some(clamping) = &plan.clamping else { return String::new() };
    let points: Vec<String> =
        clamping.clamps.iter().map(|point| format!("[{}; {}]", mm(point.x, lang), mm(point.y, lang))).collect();
    let proposed = if clamping.proposed { lang.pick(" (запропоновано)", " (proposed)") } else { "" };
    let (bears, each) = (clamping.screw_bears_n.0, clamping.force_per_clamp_n.0);
    let weak = if bears < each {
        let (bears, each) = (number(bears, 0, lang), number(each, 0, lang));
        match lang {
            _ if lang == Lang::UK => format!(" (заслабкий: витримує {bears} < {each} Н)"),
            _ => format!(" (too weak: bears {bears} < {each} N)"),
        }
    } else {
        String::new()
    };
    let lines = match lang {
        _ if lang == Lang::UK => [
            format!(
                "Найбільшої сили потребує отвір {}: M = {} Н·м, до прихоплювача {} мм, W = k·M/(f·d) = {} Н",
                clamping.hole,
                number(clamping.torque_n_m.0, 2, lang),
                number(clamping.distance_mm.to_mm(), 1, lang),
                number(clamping.force_n.0, 0, lang)
            ),
            format!(
                "Прихоплювачі {}{proposed}: по {} Н, гвинт {}{}{weak}, вихідна точка не ближче {} мм",
                points.join(", "),
                number(clamping.force_per_clamp_n.0, 0, lang),
                clamping.screw,
                mark(&clamping.because),
                mm(clamping.safe_distance_mm, lang)
            ),
        ],
        _ => [
            format!(
                "Hole {} needs the largest force: M = {} N·m, {} mm from its clamp, W = k·M/(f·d) = {} N",
                clamping.hole,
                number(clamping.torque_n_m.0, 2, lang),
                number(clamping.distance_mm.to_mm(), 1, lang),
                number(clamping.force_n.0, 0, lang)
            ),
            format!(
                "Clamps {}{proposed}: {} N each, screw {}{}{weak}, start point at least {} mm away",
                points.join(", "),
                number(clamping.force_per_clamp_n.0, 0, lang),
                clamping.screw,
                mark(&clamping.because),
                mm(clamping.safe_distance_mm, lang)
            ),
        ],
    };
    lines.iter().map(|line| grid::paragraph(line, 2)).collect()
}

fn corrections(plan: &Plan, lang: Lang) -> String {
    let rows: Vec<Vec<String>> = plan
        .tools
        .iter()
        .map(|tool| {
            vec![
                format!("T{}", tool.number),
                format!("H{:02}", tool.corrector),
                mm(tool.length_mm, lang),
                mm(tool.correction_mm, lang),
                mm(tool.book_correction_mm, lang),
            ]
        })
        .collect();
    let head = [
        "T",
        "H",
        lang.pick("Довжина, мм", "Length, mm"),
        lang.pick("Коректор (G43 додає), мм", "Corrector (added by G43), mm"),
        lang.pick("У посібнику (Lmax - L), мм", "As the book writes it (Lmax - L), mm"),
    ];
    if rows.is_empty() { String::new() } else { table(&head, &rows) }
}

fn time(plan: &Plan, lang: Lang) -> String {
    if plan.tools.is_empty() {
        return String::new();
    }
    let time = &plan.time;
    let values =
        [time.machine_min, time.rapid_min, time.tool_change_min, time.total_min].map(|value| number(value.0, 2, lang));
    let [machine, rapid, change, total] = values;
    let line = match lang {
        _ if lang == Lang::UK => {
            format!("Машинний {machine} + холості ходи {rapid} + заміна інструмента {change} = {total} хв")
        }
        _ => format!("Machine {machine} + rapids {rapid} + tool changes {change} = {total} min"),
    };
    grid::paragraph(&line, 2)
}

fn findings(plan: &Plan, lang: Lang) -> String {
    let rows: Vec<String> = plan
        .findings
        .iter()
        .map(|finding| {
            let severity = match finding.severity {
                Severity::Error => lang.pick("неможливо", "impossible"),
                Severity::Wrong => lang.pick("хибно", "wrong"),
                Severity::Doubtful => lang.pick(MARK, MARK),
                Severity::Note => lang.pick("до відома", "note"),
            };
            let hole = finding.hole.as_ref().map_or_else(String::new, |hole| format!(" {}", hole));
            grid::paragraph(&format!("{severity}{hole}: {}", sentence(&finding.note, lang)), 2)
        })
        .collect();
    rows.concat()
}
