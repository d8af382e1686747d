//! The schemes for each zone side by side.

use crate::document::{Block, Column, Document, Inlines, Item, Keep, Table};
use technolog_turning::operation::work::{Work, ZoneWork};
use technolog_turning::operation::{SetUpWork, SideWork};
use technolog_turning::transitions::Transition;
use technolog_turning::transitions::support_points::SupportPoint;
use technolog_words::say;

use super::super::Lang;
use super::super::cells::{Cell, figure, fixed, rounded, table};
use super::super::phrases::{note_line, reasoned, schemes_column, word, z};
use super::zones::place;
use crate::units::round_to;

pub(super) fn schemes(
    page: &mut Document,
    set_up: &SetUpWork,
    side: &SideWork,
    zone: &ZoneWork,
    work: &Work,
    lang: Lang,
) {
    let (from, to) = (z(work.stock.from, lang), z(work.stock.to, lang));
    page.heading(3, say!(lang, "turn-work", zone = place(set_up, side, zone, lang), from = from, to = to));
    page.paragraph(say!(lang, "turn-depth-of-work", depth = rounded(work.levels.depth.to_mm(), lang)));
    page.paragraph(conditions(work, lang));
    let because = work.pace.conditions.iter().flat_map(|found| &found.because);
    if let Some(nose_bound) = because.into_iter().find(|reason| technolog_turning::cutting::is_nose_bound(reason)) {
        page.paragraph(reasoned(nose_bound, lang));
    }
    page.paragraph(reasoned(&work.because, lang));
    page.push(compared(work, lang));
    let even = work.quickest_even.as_ref().filter(|even| Some(*even) != work.quickest.as_ref());
    let mut items: Vec<Inlines> = Vec::new();
    items.extend(work.quickest.iter().map(|best| note_line(&best.note, lang)));
    items.extend(even.map(|best| Inlines::sentence(&say!(lang, "turn-even", best = &best.note))));
    items.extend(work.refused.iter().map(|refused| {
        let scheme = word(refused.scheme.name());
        Inlines::sentence(&say!(lang, "turn-scheme-refused", scheme = scheme, why = &refused.why))
    }));
    if let Some(taken) = work.transition() {
        if let Some(even) = work.quickest_even.as_ref().filter(|even| even.scheme != taken.scheme.name()) {
            let (scheme, quicker) = (word(taken.scheme.name()), word(even.scheme));
            items.push(say!(lang, "turn-taken-by-rule", scheme = scheme, quicker = quicker).into());
        }
        if let Some(coordinates) = coordinates(&taken.points, lang) {
            let points: Vec<&str> = taken.points.iter().map(|point| point.name.as_str()).collect();
            items.push(say!(lang, "turn-support-points", points = points.join(", ")).into());
            items.push(coordinates.into());
        }
    }
    page.blocks.push(Block::List(items.into_iter().map(Item::from).collect()));
}

/// Where the support points are, each once; none where a path has more of them than a reader wants to see.
fn coordinates(points: &[SupportPoint], lang: Lang) -> Option<String> {
    const MOST: usize = 12;
    let mut each: Vec<&SupportPoint> = Vec::new();
    for point in points {
        if each.iter().all(|known| known.name != point.name) {
            each.push(point);
        }
    }
    let shown = |point: &&SupportPoint| {
        let (diameter, z) = (round_to(point.diameter_mm.to_mm(), 2), round_to(point.z_mm.to_mm(), 2));
        say!(
            lang,
            "turn-support-point",
            name = point.name.as_str(),
            diameter = figure(diameter, lang),
            z = figure(z, lang)
        )
    };
    (each.len() <= MOST).then(|| each.iter().map(shown).collect::<Vec<_>>().join("; "))
}

/// Feed and speed with the loads; empty if they are not known.
fn conditions(work: &Work, lang: Lang) -> String {
    let Some(found) = &work.pace.conditions else { return String::new() };
    let feed = figure(round_to(found.feed_mm_per_rev.0, 3), lang);
    let speed = fixed(found.speed_m_per_min.0, 1, lang);
    let (rpm, rate) = (rounded(found.spindle_rpm.0, lang), rounded(found.feed_mm_per_min.0, lang));
    match (found.main_force_n, found.power_kw) {
        (Some(force), Some(power)) => say!(
            lang,
            "turn-conditions-with-force",
            feed = feed,
            speed = speed,
            rpm = rpm,
            rate = rate,
            force = fixed(force.0, 0, lang),
            power = fixed(power.0, 2, lang)
        ),
        _ => say!(lang, "turn-conditions", feed = feed, speed = speed, rpm = rpm, rate = rate),
    }
}

fn compared(work: &Work, lang: Lang) -> Table {
    let (mm, min) = (say!(lang, "unit-mm"), say!(lang, "unit-min"));
    let columns = [
        Column::text(say!(lang, "turn-taken")),
        schemes_column(say!(lang, "turn-scheme")),
        Column::number(say!(lang, "turn-passes"), ""),
        Column::number(say!(lang, "turn-cutting"), mm),
        Column::number(say!(lang, "turn-beside"), mm).keep(Keep::Optional),
        Column::number(say!(lang, "turn-rapid"), mm).keep(Keep::Optional),
        Column::number(say!(lang, "turn-time"), min),
        Column::number(say!(lang, "turn-ridges"), mm),
    ];
    let row = |transition: &Transition| {
        let name = lang.term("word", transition.scheme.name());
        let taken = work.taken == Some(transition.scheme);
        vec![
            if taken { "+" } else { "" }.into(),
            if taken { Inlines::default().strong(name) } else { name.into() }.into(),
            Cell::count(transition.measures.passes),
            Cell::Figure(transition.measures.cutting_mm, 1),
            Cell::Figure(transition.measures.beside_mm, 1),
            Cell::Figure(transition.measures.rapid_mm, 1),
            Cell::Figure(transition.measures.time_min.0, 3),
            // With three decimals: 0 means an even allowance.
            Cell::Figure(transition.ridges_mm.to_mm(), 3),
        ]
    };
    table(columns, work.transitions.iter().map(row).collect(), lang)
}
