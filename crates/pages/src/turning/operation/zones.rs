//! The zones with their tools and depths, and those of additional elements.

use crate::note::Note;
use crate::units::round_to;
use technolog_turning::contour::Side;
use technolog_turning::operation::work::ZoneWork;
use technolog_turning::operation::{Operation, SetUpWork, SideWork};
use technolog_turning::zones::Feed;

use super::super::super::sentences::term;
use super::super::super::{Lang, grid, sentence};
use super::super::figure;
use super::z;

pub(super) fn zones(operation: &Operation, lang: Lang) -> String {
    let head = [
        lang.pick("Зона", "Zone"),
        lang.pick("Вид", "Kind"),
        "Z",
        "Ø",
        "φ ≥",
        "φ1 ≥",
        lang.pick("Різець", "Tool"),
        lang.pick("t_гр, мм", "t_lim, mm"),
        lang.pick("t_p, мм", "t_p, mm"),
        lang.pick("Схема", "Scheme"),
    ]
    .map(str::to_owned);
    let mut rows = Vec::new();
    for (set_up, side, one) in operation.zones() {
        let zone = &one.zone;
        let schemes: Vec<&str> = one.works.iter().filter_map(|work| Some(term(work.taken?.name(), lang))).collect();
        let depths: Vec<String> = one.works.iter().map(|work| figure(work.levels.depth, lang)).collect();
        let tool = one.tool.as_ref().map_or("-".to_owned(), |tool| {
            format!(
                "{} (φ {}, φ1 {})",
                tool.designation,
                figure(tool.main_angle_deg.0, lang),
                figure(tool.secondary_angle_deg.0, lang)
            )
        });
        let kind = match zone.feed {
            Feed::Across => lang.pick("торець", "face").to_owned(),
            Feed::Along => term(zone.kind.name(), lang).to_owned(),
        };
        rows.push(vec![
            place(set_up, side, one, lang),
            kind,
            format!("{} → {}", z(zone.from_z, lang), z(zone.to_z, lang)),
            format!(
                "{} … {}",
                figure(zone.least_radius.diameter(), lang),
                figure(zone.greatest_radius.diameter(), lang)
            ),
            figure(round_to(zone.needs.main.0, 2), lang),
            figure(round_to(zone.needs.secondary.0, 2), lang),
            tool,
            one.depth.as_ref().map_or(String::new(), |depth| figure(depth.limiting_depth_mm, lang)),
            depths.join("; "),
            schemes.join(" + "),
        ]);
    }
    let mut page = grid::table(&head, &rows, 2);
    let mut told: Vec<String> = Vec::new();
    for (set_up, side, one) in operation.zones() {
        let name = place(set_up, side, one, lang);
        if let Some(limit) = one.depth.as_ref().and_then(|depth| depth.limit.as_ref()) {
            let bounds = limit.bounds.iter().filter_map(|bound| {
                let name = serde_json::to_value(bound.bound).ok()?;
                let depth = bound.depth_mm.map_or("0".to_owned(), |depth| figure(depth, lang));
                Some(format!("{} {depth}", term(name.as_str()?, lang)))
            });
            let line = lang.pick(
                "{name}: t_гр за подачі {feed} мм/об: {bounds}",
                "{name}: t_lim at a feed of {feed} mm/rev: {bounds}",
            );
            let bounds = bounds.collect::<Vec<_>>().join("; ");
            let line = line.replace("{name}", &name).replace("{feed}", &figure(limit.feed_mm_per_rev.0, lang));
            told.push(line.replace("{bounds}", &bounds));
        }
        if let Some(returns) = one.returns.filter(|returns| returns.saved > 0) {
            let note = Note::new("returns-saved").with("depth", returns.depth_mm);
            let note = note.with("joined", returns.joined).with("split", returns.split);
            told.push(format!("{name}: {}", sentence(&note, lang)));
        }
        for refused in &one.fit.refused {
            let why: Vec<String> = refused.why.iter().map(|why| sentence(why, lang)).collect();
            let line = lang.pick("{name}: не {tool}: {why}", "{name}: not {tool}: {why}");
            told.push(line.replace("{name}", &name).replace("{tool}", &refused.tool).replace("{why}", &why.join("; ")));
        }
    }
    for line in told {
        page.push_str(&grid::paragraph(&line, 2));
    }
    page
}

/// The zones under the bridges; where no tool fits, why not each of them.
pub(super) fn additional(operation: &Operation, lang: Lang) -> String {
    let head = [
        lang.pick("Установ", "Set-up"),
        lang.pick("Бік", "Side"),
        "Z",
        "Ø",
        "φ ≥",
        "φ1 ≥",
        lang.pick("Різець", "Tool"),
        lang.pick("Схема", "Scheme"),
    ]
    .map(str::to_owned);
    let (mut rows, mut refused) = (Vec::new(), Vec::new());
    for (set_up, side) in
        operation.set_ups.iter().flat_map(|set_up| set_up.sides.iter().map(move |side| (set_up, side)))
    {
        for one in &side.additional {
            let zone = &one.zone;
            let span = format!("{} → {}", z(zone.from_z, lang), z(zone.to_z, lang));
            let tool = one.tool.as_ref().map(|tool| match tool.width_mm {
                Some(width) => format!("{} ({} {})", tool.designation, figure(width, lang), lang.pick("мм", "mm")),
                None => format!("{} (φ1 {})", tool.designation, figure(tool.secondary_angle_deg.0, lang)),
            });
            let schemes: Vec<&str> = one.works.iter().filter_map(|work| Some(term(work.taken?.name(), lang))).collect();
            if tool.is_none() {
                for one in &one.fit.refused {
                    let why: Vec<String> = one.why.iter().map(|why| sentence(why, lang)).collect();
                    let line = lang.pick("Z {span}: не {tool}: {why}", "Z {span}: not {tool}: {why}");
                    let line = line.replace("{span}", &span).replace("{tool}", &one.tool);
                    refused.push(line.replace("{why}", &why.join("; ")));
                }
            }
            rows.push(vec![
                set_up.set_up.number.to_string(),
                term(side.side.name(), lang).to_owned(),
                span,
                format!(
                    "{} … {}",
                    figure(zone.least_radius.diameter(), lang),
                    figure(zone.greatest_radius.diameter(), lang)
                ),
                figure(round_to(zone.needs.main.0, 2), lang),
                figure(round_to(zone.needs.secondary.0, 2), lang),
                tool.unwrap_or_else(|| lang.pick("жоден", "none").to_owned()),
                schemes.join(" + "),
            ]);
        }
    }
    if rows.is_empty() {
        return String::new();
    }
    let mut page = grid::table(&head, &rows, 2);
    for line in refused {
        page.push_str(&grid::paragraph(&line, 2));
    }
    page
}

/// `1.2`: the second zone of the first set-up; of a bore with its side.
pub(super) fn place(set_up: &SetUpWork, side: &SideWork, zone: &ZoneWork, lang: Lang) -> String {
    let inner = if side.side == Side::Inner { lang.pick(" отв.", " bore") } else { "" };
    format!("{}.{}{inner}", set_up.set_up.number, zone.zone.number)
}
