//! The set-up as a sheet that a setter follows from top to bottom: the part on the table, what holds it, the knee, the zeros, the
//! first motion.

use crate::document::Document;
use crate::note::{Figure, Note};
use crate::part::{Face, Part};
use crate::plan::{Clamping, FixturePlan, OtherZero, OwnFixture, Plan, Stand, Touched, Vice};
use crate::units::Micrometres;

use super::{Lang, chains, clamps_of, mark, rounded, say, weak_screw};

/// The steps of all set-ups, numbered throughout.
pub(crate) fn section(page: &mut Document, plan: &Plan, lang: Lang) {
    let mut steps: Vec<String> = plan.setup.fixture.iter().map(|fixture| kind(fixture, lang)).collect();
    for stand in &plan.setup.stands {
        match &plan.setup.vice {
            Some(vice) => steps.push(in_vice(vice, stand, lang)),
            None => steps.extend(on_table(stand, plan, lang)),
        }
        steps.extend(place(stand, lang));
    }
    for (number, step) in (1..).zip(steps) {
        page.paragraph(format!("{number}. {step}"));
    }
    if !plan.setup.chains.is_empty() {
        page.push(chains::table(&plan.setup.chains, lang));
    }
}

/// The kind of fixture, its place on the table, and the part in it.
fn kind(fixture: &FixturePlan, lang: Lang) -> String {
    let said = |code: String| lang.say(&Note::new(code));
    let mut sentences = vec![said(format!("plan-fixture-{}-{}", fixture.fixture_kind.name(), fixture.held.name()))];
    sentences.extend(fixture.keying.map(|keying| said(format!("plan-keying-{}", keying.name()))));
    let play = fixture.keying_play_mm.map(|play| lang.say(&Note::new("plan-keying-play").with("play", play)));
    sentences.extend(play);
    sentences.push(said(format!("plan-locating-{}", fixture.locating.name())));
    let error = fixture
        .locating_error_mm
        .map(|[least, most]| lang.say(&Note::new("plan-locating-error").with("least", least).with("most", most)));
    sentences.extend(error);
    sentences.join(" ")
}

/// The part on supports, and its clamps.
fn on_table(stand: &Stand, plan: &Plan, lang: Lang) -> Vec<String> {
    let key = match plan.part.fixture.height {
        Some(_) => "plan-supports-given",
        None if stand.height_mm > Micrometres::ZERO => "plan-supports-assumed",
        None => "plan-supports-none",
    };
    let supports = lang.say(&Note::new(key).with("setup", stand.set_up).with("height", stand.height_mm));
    let lies = lang.say(&lies(stand));
    let held = match plan.clamping_of(stand.set_up) {
        None if stand.face == Face::Back && plan.setup.own.is_none() => {
            say!(lang, "setting-clamps-of-second", setup = stand.set_up).to_owned()
        }
        Some(clamping) => {
            let turned = (stand.face == Face::Back).then(|| lang.word("plan-clamps-turned").to_owned());
            [Some(clamps(clamping, &plan.part, lang)), turned].into_iter().flatten().collect::<Vec<_>>().join(" ")
        }
        None if plan.setup.own.is_some() => plan.setup.own.iter().map(|own| own_fixture(own, lang)).collect(),
        None => lang.word("plan-no-clamping").to_owned(),
    };
    // What stands under a part by the file is not ours to place.
    let where_ = (key == "plan-supports-assumed").then(|| lang.word("plan-supports-where").to_owned());
    let part: Vec<String> = [Some(supports), where_, Some(lies)].into_iter().flatten().collect();
    vec![part.join(" "), held]
}

/// What the fixture of the file must hold.
pub(crate) fn own_fixture(own: &OwnFixture, lang: Lang) -> String {
    let note = Note::new(if own.side_force_n.is_some() { "plan-own-fixture-pushed" } else { "plan-own-fixture" });
    let side = own.side_force_n.map_or(0.0, |side| side.0);
    let note = note
        .with("name", Figure::called(&own.name))
        .with("hole", Figure::called(&own.hole))
        .with("torque", rounded(own.torque_n_m.0, 2))
        .with("side", rounded(side, 0))
        .with("safety", rounded(own.safety, 2));
    lang.say(&if own.side_force_n.is_some() { note } else { note.without("side") })
}

/// Where the corner of the part lies on the table.
fn lies(stand: &Stand) -> Note {
    Note::new("plan-lies").with("x", stand.corner_mm.x).with("y", stand.corner_mm.y)
}

/// The part in the vice.
pub(crate) fn in_vice(vice: &Vice, stand: &Stand, lang: Lang) -> String {
    let on = match vice.parallels_mm {
        Some(height) => Note::new("plan-on-parallels")
            .with("height", height)
            .with("thickness", vice.thickest_parallels_mm.unwrap_or_default()),
        None => Note::new("plan-on-ways"),
    };
    let held = Note::new("plan-vice")
        .with("setup", stand.set_up)
        .with("vice", format!("{}{}", vice.designation, mark(&vice.because)))
        .with("axis", vice.jaws_along.letter())
        .with("opened", vice.opened_mm)
        .with("on", lang.say(&on))
        .with("height", stand.height_mm);
    let grips = Note::new("plan-vice-grips")
        .with("grip", vice.grip_mm)
        .with("below", vice.below_face_mm)
        .with("force", rounded(vice.force_n.0, 0))
        .with("hole", Figure::called(&vice.hole))
        .with("gives", rounded(vice.gives_n.0, 0));
    [lang.say(&held), lang.say(&grips), lang.say(&lies(stand))].join(" ")
}

/// The force of the clamps, and where they press.
fn clamps(clamping: &Clamping, part: &Part, lang: Lang) -> String {
    let note = match clamping.side_force_n {
        Some(side) => Note::new("plan-largest-side-force").with("side", rounded(side.0, 0)),
        None => Note::new("plan-largest-force").with("distance", rounded(clamping.distance_mm.to_mm(), 1)),
    };
    let note = note
        .with("hole", Figure::called(&clamping.hole))
        .with("torque", rounded(clamping.torque_n_m.0, 2))
        .with("force", rounded(clamping.force_n.0, 0));
    let mut sentences = vec![clamps_of(clamping, part, lang), lang.say(&note)];
    if clamping.screw_bears_n.0 < clamping.force_per_clamp_n.0 {
        sentences.push(weak_screw(clamping, lang));
    }
    sentences.join(" ")
}

/// The knee, the zeros and the first motion.
fn place(stand: &Stand, lang: Lang) -> Vec<String> {
    let [x, y, z] = stand.zero_mm;
    let knee = stand.nose_to_table_mm.map(|nose| lang.say(&Note::new("plan-knee").with("nose", nose)));
    let frame = format!("G{}", stand.frame);
    let sides = touching("plan-zero-by-sides", &frame, stand.touched, stand.sides_mm, lang).with("x", x).with("y", y);
    let mut sides = vec![lang.say(&sides)];
    // A blank is not as long as drawn: what both set-ups make must be counted from one face.
    if stand.face == Face::Back {
        sides.push(lang.word("plan-same-face").to_owned());
    }
    let others = stand.other_zeros.iter().map(|other| other_zero(other, &frame, lang));
    let face = Note::new("plan-zero-by-face")
        .with("frame", frame.as_str())
        .with("tool", stand.reference_tool.map_or_else(String::new, |tool| format!(" T{tool}")))
        .with("face", if stand.face_mm == Micrometres::ZERO { String::new() } else { less(stand.face_mm) })
        .with("z", z);
    let start =
        Note::new("plan-start").with("x", stand.start.x).with("y", stand.start.y).with("level", stand.first_level_mm);
    let start = match stand.start_to_clamp_mm {
        Some(away) => {
            [lang.say(&start), lang.say(&Note::new("plan-start-to-clamp").with("away", rounded(away.to_mm(), 0)))]
                .join(" ")
        }
        None => lang.say(&start),
    };
    let face = [lang.say(&face).as_str(), lang.word("plan-lengths-measured")].join(" ");
    knee.into_iter().chain([sides.join(" "), face]).chain(others).chain([start]).collect()
}

/// The sides that an arbor touches for a zero, and what is taken away from what it shows there.
fn touching(key: &'static str, frame: &str, touched: Touched, sides: [Micrometres; 2], lang: Lang) -> Note {
    let [right, back] = less_radii(sides, touched);
    Note::new(key)
        .with("frame", frame)
        .with("side", lang.word(if touched.left { "plan-side-left" } else { "plan-side-right" }).to_owned())
        .with("end", lang.word(if touched.front { "plan-side-front" } else { "plan-side-back" }).to_owned())
        .with("right", right)
        .with("back", back)
}

/// A further zero, of the holes that the drawing dimensions from other sides.
fn other_zero(zero: &OtherZero, first: &str, lang: Lang) -> String {
    let holes = Figure::list(zero.holes.iter().map(|name| Figure::called(name)));
    let frame = format!("G{}", zero.frame);
    let note = touching("plan-other-zero", &frame, zero.touched, zero.sides_mm, lang);
    lang.say(&note.with("holes", holes).with("first", first))
}

/// The same for the two sides of a zero, as sums to key in.
pub(crate) fn less_radii([along, across]: [Micrometres; 2], touched: Touched) -> [String; 2] {
    [less_radius(along, touched.left), less_radius(across, touched.front)]
}

/// What is taken away from what an arbor Ø d at a side shows: ` − 250 − d/2`, at a left or front side ` + d/2`.
fn less_radius(length: Micrometres, low: bool) -> String {
    let length = if length == Micrometres::ZERO { String::new() } else { less(length) };
    format!("{length} {} d/2", if low { '+' } else { '−' })
}

/// A length taken away in a sum: ` − 250`, or ` + 250` where it lies on the other side of the zero.
pub(crate) fn less(length: Micrometres) -> String {
    let sign = if length < Micrometres::ZERO { '+' } else { '−' };
    format!(" {sign} {}", length.abs())
}
