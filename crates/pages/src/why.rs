//! Why one hole is made as it is: every decision with its row, and what was passed over.

use crate::note::Because;
use crate::plan::{HolePlan, Plan};

use super::sentences::scheme_name;
use super::sheet::{mm, number};
use super::{Lang, grid, operation_verb, sentence};

/// The reasons of one group of holes.
pub fn explain(plan: &Plan, hole: &HolePlan, lang: Lang) -> String {
    let mut text = String::new();
    let diameter = plan.part.holes.iter().find(|known| known.name == hole.name).map(|known| known.diameter.to_string());
    let title = lang.pick("Отвір", "Hole");
    text.push_str(&format!("{title} {} {}\n\n", hole.name, diameter.unwrap_or_default()));
    match &hole.route {
        Some(route) => {
            text.push_str(&format!(
                "{} {} ({})\n",
                lang.pick("Схема", "Scheme"),
                scheme_name(&route.scheme, lang),
                route.table
            ));
            text.push_str(&reasons(&route.because, lang));
            if !route.alternatives.is_empty() {
                text.push_str(&format!(
                    "\n{}\n",
                    lang.pick("Інші маршрути і чому не вони", "Other routes, and why not they")
                ));
                text.push_str(&super::sheet::route::alternatives(route, lang));
            }
        }
        None => {
            for finding in plan.findings.iter().filter(|finding| finding.hole.as_deref() == Some(hole.name.as_str())) {
                text.push_str(&grid::paragraph(&sentence(&finding.note, lang), 2));
            }
        }
    }
    for (index, transition) in hole.transitions.iter().enumerate() {
        text.push_str(&format!(
            "\n{}. {} Ø{} — T{} {}, {}\n",
            index + 1,
            operation_verb(transition.operation.name(), lang),
            mm(transition.diameter_mm, lang),
            transition.tool.number,
            transition.tool.designation,
            transition.holder.designation
        ));
        text.push_str(&reasons(&transition.because, lang));
        let conditions = &transition.conditions;
        text.push_str(&grid::paragraph(
            &format!(
                "s = {} {}, V = {} {}, n = {} {}",
                number(conditions.feed_mm_per_rev.0, 3, lang),
                lang.pick("мм/об", "mm/rev"),
                number(conditions.speed_m_per_min.0, 2, lang),
                lang.pick("м/хв", "m/min"),
                number(conditions.spindle_rpm.0, 1, lang),
                lang.pick("об/хв", "1/min")
            ),
            2,
        ));
        text.push_str(&reasons(&conditions.because, lang));
    }
    text
}

fn reasons(because: &[Because], lang: Lang) -> String {
    because.iter().map(|reason| one(reason, lang)).collect()
}

fn one(reason: &Because, lang: Lang) -> String {
    let row = reason.row.map_or_else(String::new, |row| format!(", {} {row}", lang.pick("рядок", "row")));
    let source = reason.source.as_ref().map_or_else(String::new, |source| format!(", {source}"));
    let place = format!("{}{row}{source}: {}", reason.table, reason.place);
    let mut text = grid::paragraph(&format!("- {} [{place}]", sentence(&reason.note, lang)), 2);
    if let Some(why) = &reason.reason {
        text.push_str(&grid::paragraph(&format!("{}: {why}", lang.pick("підстава", "because")), 4));
    }
    if let Some(why) = &reason.unconfirmed {
        text.push_str(&grid::paragraph(&format!("* {}: {why}", lang.pick("не підтверджено", "unconfirmed")), 4));
    }
    for passed in &reason.rejected {
        text.push_str(&grid::paragraph(
            &format!("{}: {}", lang.pick("не взято", "not taken"), sentence(passed, lang)),
            4,
        ));
    }
    text
}
