//! What a cycle of a job is for, as a technologist says it: `Свердління 6-и отв. Ø10H12 (A)`.

use crate::job::{Pause, ToolWork};
use crate::part::{Hole, Part};
use crate::plan::{Feature, Operation, Plan, Transition};

use super::sheet::mm;
use super::{Lang, operation_noun};

/// The transitions that a work makes with some of its cycles: each as its group, its number and how many of its holes
/// are made, in the order of the work.
pub(super) fn of_work<'w>(work: &'w ToolWork, cycles: &[usize]) -> Vec<(&'w str, usize, usize)> {
    let mut found: Vec<(&str, usize, usize)> = Vec::new();
    for stop in work.stops.iter().filter(|stop| cycles.contains(&stop.cycle)) {
        let same = found.iter_mut().find(|(hole, transition, _)| *hole == stop.hole && *transition == stop.transition);
        match same {
            Some((.., count)) => *count += 1,
            None => found.push((&stop.hole, stop.transition, 1)),
        }
    }
    found
}

/// The transition of a plan that a stop names.
pub(super) fn of_plan<'p>(plan: &'p Plan, hole: &str, number: usize) -> Option<(&'p Hole, &'p Transition)> {
    let own = plan.holes.iter().find(|own| own.name == hole)?;
    Some((plan.part.holes.iter().find(|known| known.name == hole)?, own.transitions.get(number)?))
}

/// What some cycles of a work do, in one sentence; a work done pass by pass counts a hole once.
pub(super) fn sentence(plan: &Plan, work: &ToolWork, cycles: &[usize], lang: Lang) -> String {
    let mut text = String::new();
    let mut before: Option<Operation> = None;
    for (hole, number, count) in of_work(work, cycles) {
        let Some((hole, transition)) = of_plan(plan, hole, number) else { continue };
        let what = holes(hole, transition, count.min(hole.at.len()), lang);
        match before.replace(transition.operation) {
            None => text.push_str(&capital(operation_noun(transition.operation.name(), lang))),
            Some(same) if same == transition.operation => text.push(','),
            Some(_) => {
                text.push_str("; ");
                text.push_str(operation_noun(transition.operation.name(), lang));
            }
        }
        text.push(' ');
        text.push_str(&what);
    }
    text
}

/// `6-и отв. Ø10H12 (A)`, with the diameter reached where it is not yet the hole's own.
fn holes(hole: &Hole, transition: &Transition, count: usize, lang: Lang) -> String {
    let step = transition.step.and_then(|number| hole.steps.get(number.checked_sub(1)?));
    let own = step.map_or(&hole.diameter, |step| &step.diameter);
    let size = match hole.thread_at(transition.step).filter(|_| transition.operation == Operation::Tap) {
        Some(thread) => thread.written.clone(),
        None => own.to_string(),
    };
    let finished = matches!(transition.feature, Feature::Bore | Feature::Step) && own.nominal == transition.diameter_mm;
    let to = match transition.operation {
        Operation::CentreDrill | Operation::Tap => String::new(),
        _ if finished => String::new(),
        _ => format!(" {} Ø{}", lang.pick("до", "to"), mm(transition.diameter_mm, lang)),
    };
    let number = match lang {
        _ if lang == Lang::UK => format!("{count}-{} отв.", ending(count)),
        _ => format!("of {count} {}", if count == 1 { "hole" } else { "holes" }),
    };
    format!("{number} {size}{to} ({})", hole.name)
}

/// The ending of a Ukrainian numeral in the genitive, as drawings write it: 4-х, 6-и отворів. The worked example
/// writes so (l. 10408-10490).
const fn ending(count: usize) -> &'static str {
    match (count % 100, count % 10) {
        (11..=19, _) => "и",
        (40 | 90, _) => "а",
        (0, _) if count == 100 => "а",
        (0, _) if count < 1000 => "т",
        (_, 1) => "го",
        (_, 2..=4) => "х",
        _ => "и",
    }
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().collect::<String>() + letters.as_str())
}

/// What the operator does.
pub(super) fn pause(pause: Pause, part: &Part, lang: Lang) -> String {
    match pause {
        Pause::LoadTool { tool, place } => match lang {
            _ if lang == Lang::UK => format!("Встановити інструмент {tool} у гніздо {place} магазину"),
            _ => format!("Put tool {tool} into place {place} of the magazine"),
        },
        Pause::TurnOver => match lang {
            _ if lang == Lang::UK => format!("Перевернути деталь {} навколо осі Y", part.part),
            _ => format!("Turn the part {} over about Y", part.part),
        },
        Pause::SetBar { diameter_mm } => match lang {
            _ if lang == Lang::UK => format!("Налагодити різець оправки на Ø{}", mm(diameter_mm, lang)),
            _ => format!("Set the boring bar to Ø{}", mm(diameter_mm, lang)),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::ending;

    /// Genitives: двох, чотирьох, п'яти, одинадцяти, двадцяти одного, сорока, дев'яноста, ста, двохсот.
    #[test]
    fn numerals_end_as_they_are_spoken() {
        let known = [(1, "го"), (2, "х"), (4, "х"), (5, "и"), (6, "и"), (11, "и"), (21, "го"), (24, "х"), (30, "и")];
        for (count, end) in known.into_iter().chain([(40, "а"), (90, "а"), (100, "а"), (200, "т"), (112, "и")]) {
            assert_eq!(ending(count), end, "{count}");
        }
    }
}
