//! The pins that locate a part, in words.

use crate::note::{Figure, IntoFigure, Note};
use crate::part::{Along, Part};
use crate::plan::{FixturePlan, LocatingPin, PinKind};

use super::{Lang, mark, say};

/// The pins with their sizes, and how two of them belong together; none without pins.
pub(super) fn told(fixture: &FixturePlan, part: &Part, lang: Lang) -> Option<String> {
    let mut sentences: Vec<String> = fixture.pins.iter().map(|one| pin(one, fixture, part, lang)).collect();
    sentences.extend(fixture.pair.map(|pair| {
        let note = Note::new("plan-pin-pair").with("apart", pair.apart_mm);
        lang.say(&note.with("together", pair.distance_tolerances_mm).with("turned", pair.turned_mm))
    }));
    (!sentences.is_empty()).then(|| sentences.join(" "))
}

fn pin(pin: &LocatingPin, fixture: &FixturePlan, part: &Part, lang: Lang) -> String {
    let [least, most] = pin.clearance_mm;
    let key = match pin.kind {
        PinKind::Round => "plan-pin-round",
        PinKind::Cut if fixture.pair.is_some() => "plan-pin-cut",
        PinKind::Cut => "plan-pin-cut-alone",
    };
    let note = Note::new(key)
        .with("standard", format!("{}{}", pin.standard, mark(&fixture.because)))
        .with("diameter", pin.diameter_mm)
        .with("field", pin.field.clone())
        .with("upper", pin.upper_mm)
        .with("lower", pin.lower_mm)
        .with("at", say!(lang, "plan-point", x = pin.at.x, y = pin.at.y))
        .with("least", least)
        .with("most", most);
    let hole = part.fixture.pins.iter().find(|hole| hole.at == pin.at);
    let note =
        note.with("hole", hole.map_or_else(|| Figure::Text("".into()), |hole| hole.diameter.clone().into_figure()));
    lang.say(&match pin.kind {
        PinKind::Round => note,
        PinKind::Cut => {
            let note = note.with("land", pin.land_mm.unwrap_or_default());
            // The longer side already holds the part across it.
            let along = if part.blank.length >= part.blank.width { Along::X } else { Along::Y };
            if fixture.pair.is_some() { note } else { note.with("axis", along.letter()) }
        }
    })
}
