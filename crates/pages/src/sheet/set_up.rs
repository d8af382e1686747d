//! The set-up as a sheet that a setter follows from top to bottom: the part on the table, what holds it, the knee, the zeros, the
//! first motion.

use crate::document::Document;
use crate::note::{Figure, Note};
use crate::part::{Along, Face, Holding, Part};
use crate::plan::{
    BarSetting, Chuck, Clamping, FixtureKind, FixturePlan, Held, HeldBy, OtherZero, OwnFixture, PartLocating, Plan,
    Stand, Touched, Vice,
};
use crate::units::Micrometres;

use super::{Lang, chains, clamps_of, mark, mm, pins, rounded, say, surface, weak_screw};

/// The steps of all set-ups, numbered throughout.
pub(crate) fn section(page: &mut Document, plan: &Plan, lang: Lang) {
    let fixture = plan.setup.fixture.as_ref();
    let asks_chuck = plan.part.fixture.holding == Some(Holding::Chuck);
    let mut steps: Vec<String> = fixture.iter().map(|fixture| kind(fixture, asks_chuck, lang)).collect();
    steps.extend(fixture.and_then(|fixture| pins::told(fixture, &plan.part, lang)));
    for stand in &plan.setup.stands {
        match plan.held(stand.set_up) {
            Held::Vice(vice) => steps.push(in_vice(vice, stand, plan, lang)),
            Held::Chuck(chuck) => steps.push(in_chuck(chuck, stand, plan, lang)),
            held => steps.extend(on_table(held, stand, plan, lang)),
        }
        steps.extend(place(stand, plan, lang));
        steps.extend(stand.bars.iter().map(|bar| bar_set(bar, lang)));
        steps.push(start(stand, lang));
    }
    for (number, step) in (1..).zip(steps) {
        page.paragraph(format!("{number}. {step}"));
    }
    if !plan.setup.chains.is_empty() {
        page.push(chains::table(&plan.setup.chains, lang));
    }
}

/// The kind of fixture, its place on the table, and the part in it.
fn kind(fixture: &FixturePlan, asks_chuck: bool, lang: Lang) -> String {
    let said = |code: String| lang.say(&Note::new(code));
    // Straps hold the part on a plate made for it, because the table has no holes for pins.
    let on_pins = matches!((fixture.fixture_kind, fixture.held), (FixtureKind::Special, HeldBy::Straps));
    let mut sentences = vec![match on_pins && !fixture.pins.is_empty() {
        true => said("plan-fixture-special-pins".to_owned()),
        // Nothing else was tried.
        false if fixture.held == HeldBy::Nothing && asks_chuck => said("plan-fixture-special-not-in-chuck".to_owned()),
        false => said(format!("plan-fixture-{}-{}", fixture.fixture_kind.name(), fixture.held.name())),
    }];
    sentences.extend(fixture.keying.map(|keying| said(format!("plan-keying-{}", keying.name()))));
    let play = fixture.keying_play_mm.map(|play| lang.say(&Note::new("plan-keying-play").with("play", play)));
    sentences.extend(play);
    sentences.push(said(format!("plan-locating-{}", fixture.locating.name())));
    // Figures of sides are remembered, those of a pin follow from its field.
    let costs = match fixture.locating {
        PartLocating::PlaneAndTwoHoles => "plan-locating-error-pins",
        _ => "plan-locating-error",
    };
    let error = fixture
        .locating_error_mm
        .map(|[least, most]| lang.say(&Note::new(costs).with("least", least).with("most", most)));
    sentences.extend(error);
    sentences.join(" ")
}

/// The part on supports against its stops, and its clamps.
fn on_table(held: Held<'_>, stand: &Stand, plan: &Plan, lang: Lang) -> Vec<String> {
    let key = match plan.part.fixture.height {
        Some(_) if plan.part.fixture.own.is_some() => "plan-in-own",
        Some(_) if stand.set_up == 1 && !plan.part.fixture.pins.is_empty() => "plan-on-plate",
        Some(_) => "plan-supports-given",
        None if stand.height_mm > Micrometres::ZERO => "plan-supports-assumed",
        None => "plan-supports-none",
    };
    let supports = lang.say(&Note::new(key).with("setup", stand.set_up).with("height", stand.height_mm));
    let lies = lang.say(&lies(stand, &plan.part));
    let clamped = match held {
        Held::Straps(clamping) => {
            let turned = (stand.face == Face::Back).then(|| lang.word("plan-clamps-turned").to_owned());
            [Some(clamps(clamping, &plan.part, lang)), turned].into_iter().flatten().collect::<Vec<_>>().join(" ")
        }
        Held::Own(own) => own_fixture(own, &plan.part, lang),
        Held::Vice(_) | Held::Chuck(_) | Held::Nothing if stand.face == Face::Back => {
            say!(lang, "setting-clamps-of-second", setup = stand.set_up).to_owned()
        }
        Held::Vice(_) | Held::Chuck(_) | Held::Nothing => lang.word("plan-no-clamping").to_owned(),
    };
    // How supports must stand holds for those of the file, too.
    let where_ = matches!(key, "plan-supports-assumed" | "plan-supports-given")
        .then(|| lang.word("plan-supports-where").to_owned());
    let stops = stops(stand, plan, lang);
    let part = [turned_over(stand, plan, lang), Some(supports), where_, Some(lies), stops];
    vec![part.into_iter().flatten().collect::<Vec<_>>().join(" "), clamped]
}

/// How the part is turned over for a later set-up, what is made of it already, and what is made now.
pub(crate) fn turned_over(stand: &Stand, plan: &Plan, lang: Lang) -> Option<String> {
    let named = |holes: &[String]| Figure::list(holes.iter().map(|name| Figure::called(name)));
    let before: Vec<String> =
        plan.setup.stands.iter().filter(|one| one.set_up < stand.set_up).fold(Vec::new(), |mut all, one| {
            all.extend(one.holes.iter().filter(|hole| !all.contains(hole)).cloned().collect::<Vec<_>>());
            all
        });
    let note = Note::new(if before.is_empty() { "plan-turned-first" } else { "plan-turned" });
    let note = note.with("setup", stand.set_up).with("now", named(&stand.holes));
    (stand.face == Face::Back)
        .then(|| lang.say(&if before.is_empty() { note } else { note.with("made", named(&before)) }))
}

/// The side of the part, as it lies, that is touched along an axis.
fn side(touched: Touched, axis: Along, lang: Lang) -> &'static str {
    lang.word(match (axis, touched.left, touched.front) {
        (Along::X, true, _) => "plan-side-left",
        (Along::X, false, _) => "plan-side-right",
        (Along::Y, _, true) => "plan-side-front",
        (Along::Y, _, false) => "plan-side-back",
    })
}

/// The stops that straps hold the part against: two points of the longer side and one of the shorter, as three planes have it; none
/// where pins locate it.
pub(crate) fn stops(stand: &Stand, plan: &Plan, lang: Lang) -> Option<String> {
    let fixture = plan.setup.fixture.as_ref().filter(|_| !plan.part.blank.is_round())?;
    let straps = matches!(plan.held(stand.set_up), Held::Straps(_));
    let first = stand.set_up == 1;
    let blank = &plan.part.blank;
    let (long, short) = if blank.length >= blank.width { (Along::Y, Along::X) } else { (Along::X, Along::Y) };
    let [long, short] = [long, short].map(|axis| side(stand.touched, axis, lang).to_owned());
    let note = match fixture.locating {
        PartLocating::PlaneAndTwoHoles if first => return None,
        PartLocating::TwoPlanesAndHole if first => Note::new("plan-stops-one").with("long", long),
        _ => Note::new("plan-stops").with("long", long).with("short", short),
    };
    straps.then(|| lang.say(&note))
}

/// What a bar is set to, and when.
pub(crate) fn bar_set(bar: &BarSetting, lang: Lang) -> String {
    let holes = Figure::list(bar.holes.iter().map(|name| Figure::called(name)));
    let note = Note::new(if bar.at_stop { "plan-bar-at-stop" } else { "plan-bar-before" });
    lang.say(&note.with("tool", bar.tool).with("diameter", bar.diameter_mm).with("holes", holes))
}

/// What the fixture of the file must hold.
pub(crate) fn own_fixture(own: &OwnFixture, part: &Part, lang: Lang) -> String {
    let note = Note::new(if own.side_force_n.is_some() { "plan-own-fixture-pushed" } else { "plan-own-fixture" });
    let side = own.side_force_n.map_or(0.0, |side| side.0);
    let note = note
        .with("name", Figure::called(&own.name))
        .with("surface", surface(part, &own.hole, lang))
        .with("hole", Figure::called(&own.hole))
        .with("torque", rounded(own.torque_n_m.0, 2))
        .with("side", rounded(side, 0))
        .with("safety", rounded(own.safety, 2));
    lang.say(&if own.side_force_n.is_some() { note } else { note.without("side") })
}

/// Where the corner of the part lies on the table, or the axis of a disc.
fn lies(stand: &Stand, part: &Part) -> Note {
    if part.blank.is_round() {
        let radius = part.blank.length.half();
        return Note::new("plan-lies-axis").with("x", stand.corner_mm.x + radius).with("y", stand.corner_mm.y + radius);
    }
    Note::new("plan-lies").with("x", stand.corner_mm.x).with("y", stand.corner_mm.y)
}

/// The part in the vice.
pub(crate) fn in_vice(vice: &Vice, stand: &Stand, plan: &Plan, lang: Lang) -> String {
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
        .with("surface", surface(&plan.part, &vice.hole, lang))
        .with("hole", Figure::called(&vice.hole))
        .with("gives", rounded(vice.gives_n.0, 0));
    // The jaws stand along one axis, so that they press along the other.
    let (jaw, end) = match vice.jaws_along {
        Along::X => (Along::Y, Along::X),
        Along::Y => (Along::X, Along::Y),
    };
    let [jaw, end] = [jaw, end].map(|axis| side(stand.touched, axis, lang).to_owned());
    let against = lang.say(&Note::new("plan-vice-stop").with("jaw", jaw).with("side", end));
    let turned = turned_over(stand, plan, lang);
    let said = [lang.say(&held), against, lang.say(&grips), lang.say(&lies(stand, &plan.part))];
    turned.into_iter().chain(said).collect::<Vec<_>>().join(" ")
}

/// The part in the chuck.
pub(crate) fn in_chuck(chuck: &Chuck, stand: &Stand, plan: &Plan, lang: Lang) -> String {
    let [first, second, third] = chuck.jaws(stand.face);
    let held = Note::new("plan-chuck")
        .with("setup", stand.set_up)
        .with("chuck", format!("{}{}", chuck.designation, mark(&chuck.because)))
        .with("first", first)
        .with("second", second)
        .with("third", third)
        .with("step", chuck.step)
        .with("height", stand.height_mm);
    let grips = Note::new("plan-chuck-grips")
        .with("grip", chuck.grip_mm)
        .with("below", chuck.below_face_mm)
        .with("room", chuck.room_mm)
        .with("force", rounded(chuck.force_n.0, 0))
        .with("surface", surface(&plan.part, &chuck.hole, lang))
        .with("hole", Figure::called(&chuck.hole))
        .with("gives", rounded(chuck.gives_n.0, 0));
    let turned = turned_over(stand, plan, lang);
    let said = [lang.say(&held), lang.say(&grips), lang.say(&lies(stand, &plan.part))];
    turned.into_iter().chain(said).collect::<Vec<_>>().join(" ")
}

/// The force of the clamps, and where they press.
fn clamps(clamping: &Clamping, part: &Part, lang: Lang) -> String {
    let note = match clamping.side_force_n {
        Some(side) => Note::new("plan-largest-side-force").with("side", rounded(side.0, 0)),
        None => Note::new("plan-largest-force").with("distance", rounded(clamping.distance_mm.to_mm(), 1)),
    };
    let note = note
        .with("surface", surface(part, &clamping.hole, lang))
        .with("hole", Figure::called(&clamping.hole))
        .with("torque", rounded(clamping.torque_n_m.0, 2))
        .with("force", rounded(clamping.force_n.0, 0));
    let mut sentences = vec![clamps_of(clamping, part, lang), lang.say(&note)];
    if clamping.screw_bears_n.0 < clamping.force_per_clamp_n.0 {
        sentences.push(weak_screw(clamping, lang));
    }
    sentences.join(" ")
}

/// The knee and the zeros.
fn place(stand: &Stand, plan: &Plan, lang: Lang) -> Vec<String> {
    let [x, y, z] = stand.zero_mm;
    let knee = stand.nose_to_table_mm.map(|nose| lang.say(&Note::new("plan-knee").with("nose", nose)));
    let frame = format!("G{}", stand.frame);
    let [right, back] = zero_sums(stand, plan, lang);
    let by_axis =
        |code| Note::new(code).with("frame", frame.as_str()).with("right", right.clone()).with("back", back.clone());
    let sides = match (plan.zero_pin(stand.set_up), plan.zero_axis(stand.set_up)) {
        (Some(_), _) => by_axis("plan-zero-by-pin"),
        (None, Some(_)) => by_axis("plan-zero-by-axis"),
        (None, None) => touching("plan-zero-by-sides", &frame, stand.touched, stand.sides_mm, lang),
    };
    let mut sides = vec![lang.say(&sides.with("x", x).with("y", y))];
    sides.extend(once(stand, plan).map(|code| lang.word(code).to_owned()));
    // A blank is not as long as drawn: what both set-ups make must be counted from one face.
    if stand.face == Face::Back {
        // No side of a disc says how far it is turned about its axis.
        let code = if plan.part.blank.is_round() { "plan-disc-angle" } else { "plan-same-face" };
        sides.push(lang.word(code).to_owned());
    }
    let others = stand.other_zeros.iter().map(|other| other_zero(other, &frame, lang));
    let face = Note::new("plan-zero-by-face")
        .with("frame", frame.as_str())
        .with("tool", stand.reference_tool.map_or_else(String::new, |tool| format!(" T{tool}")))
        .with("face", if stand.face_mm == Micrometres::ZERO { String::new() } else { less(stand.face_mm, lang) })
        .with("z", z);
    let face = [lang.say(&face).as_str(), lang.word("plan-lengths-measured")].join(" ");
    knee.into_iter().chain([sides.join(" "), face]).chain(others).collect()
}

/// Whether X and Y of the first zero are found once for all parts, in words: where each further part comes to lie at the same place.
pub(crate) fn once(stand: &Stand, plan: &Plan) -> Option<&'static str> {
    match plan.held(stand.set_up) {
        _ if plan.zero_pin(stand.set_up).is_some() => Some("plan-once-pins"),
        Held::Straps(_) if plan.part.blank.is_round() => Some("plan-once-axis"),
        Held::Chuck(_) => Some("plan-once-chuck"),
        Held::Straps(_) | Held::Vice(_) => Some("plan-once"),
        Held::Own(_) | Held::Nothing => None,
    }
}

/// What is added to the readings xM, yM for the zero of a set-up.
pub(crate) fn zero_sums(stand: &Stand, plan: &Plan, lang: Lang) -> [String; 2] {
    match plan.zero_axis(stand.set_up) {
        Some(at) => {
            [at.x, at.y].map(|length| if length == Micrometres::ZERO { String::new() } else { less(length, lang) })
        }
        None => less_radii(stand.sides_mm, stand.touched, lang),
    }
}

/// Where the spindle stands while the part is loaded, and the first motion.
fn start(stand: &Stand, lang: Lang) -> String {
    let start =
        Note::new("plan-start").with("x", stand.start.x).with("y", stand.start.y).with("level", stand.first_level_mm);
    let away = stand
        .start_to_clamp_mm
        .map(|away| lang.say(&Note::new("plan-start-to-clamp").with("away", rounded(away.to_mm(), 0))));
    let loading = stand.loading.map(|loading| {
        let note = Note::new(match (loading.beyond_mm, loading.start_is_safe) {
            (None, _) => "plan-loading",
            (Some(_), true) => "plan-loading-at-start",
            (Some(_), false) => "plan-loading-beyond",
        });
        let note = note.with("x", loading.at.x).with("y", loading.at.y).with("distance", loading.safe_mm);
        lang.say(&match loading.beyond_mm {
            Some(beyond) => note.with("beyond", beyond),
            None => note,
        })
    });
    loading.into_iter().chain([lang.say(&start)]).chain(away).collect::<Vec<_>>().join(" ")
}

/// The sides that an arbor touches for a zero, and what is taken away from what it shows there.
fn touching(key: &'static str, frame: &str, touched: Touched, sides: [Micrometres; 2], lang: Lang) -> Note {
    let [right, back] = less_radii(sides, touched, lang);
    Note::new(key)
        .with("frame", frame)
        .with("side", side(touched, Along::X, lang).to_owned())
        .with("end", side(touched, Along::Y, lang).to_owned())
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
pub(crate) fn less_radii([along, across]: [Micrometres; 2], touched: Touched, lang: Lang) -> [String; 2] {
    [less_radius(along, touched.left, lang), less_radius(across, touched.front, lang)]
}

/// What is taken away from what an arbor Ø d at a side shows: ` − 250 − d/2`, at a left or front side ` + d/2`.
fn less_radius(length: Micrometres, low: bool, lang: Lang) -> String {
    let length = if length == Micrometres::ZERO { String::new() } else { less(length, lang) };
    format!("{length} {} d/2", if low { '+' } else { '−' })
}

/// A length taken away in a sum: ` − 250`, or ` + 250` where it lies on the other side of the zero.
pub(crate) fn less(length: Micrometres, lang: Lang) -> String {
    let sign = if length < Micrometres::ZERO { '+' } else { '−' };
    format!(" {sign} {}", mm(length.abs(), lang))
}
