//! A turning operation as a drawing: for each side of a set-up the allowances with the zones, then the toolpath over
//! each zone.

use super::super::canvas::{Anchor, Canvas, Pen, THIN, width_of};
use super::Lang;
use super::cells::{figure, fixed, rounded};
use super::phrases::word;
use super::view::{View, pen_of};
use crate::note::{Figure, Note};
use technolog_turning::contour::{Contour, Piece, Side, SurfaceKind};
use technolog_turning::length::Half;
use technolog_turning::operation::ground::ground;
use technolog_turning::operation::work::{Work, ZoneWork};
use technolog_turning::operation::{Operation, SetUpWork, SideWork, SizeOf};
use technolog_turning::point::Point;
use technolog_turning::toolpath::Purpose;
use technolog_turning::transitions::Transition;
use technolog_words::say;

const WIDE: f64 = 1100.0;
const TALL: f64 = 460.0;
const MARGIN: f64 = 40.0;
const TITLE: f64 = 30.0;
const STEEL: &str = "#d9d9d9";
/// Allowances 1, 2 and 3.
const ALLOWANCES: [(&str, &str); 3] = [
    ("#f3ead2", "turn-allowance-rough"),
    ("#cc79a7", "turn-allowance-additional"),
    ("#8fd3b6", "turn-allowance-finish"),
];

/// The whole drawing, with the chosen toolpath over each zone, or with those of all schemes.
pub fn operation_drawing(operation: &Operation, all: bool, lang: Lang) -> String {
    let mut canvas = Canvas::default();
    let mut top = 0.0;
    for set_up in &operation.set_ups {
        for side in &set_up.sides {
            top = layers(&mut canvas, operation, (set_up, side), top, lang);
            for zone in &side.zones {
                for work in &zone.works {
                    for transition in work.transitions.iter().filter(|one| all || work.taken == Some(one.scheme)) {
                        top = draw_toolpath(&mut canvas, (set_up, side, zone), work, transition, top, lang);
                    }
                }
            }
        }
    }
    canvas.page(WIDE, top.max(TITLE) + MARGIN)
}

/// The same as single drawings with their captions, for pages of paper: the allowances of each side, then the chosen
/// toolpath over each zone.
pub(super) fn figures(operation: &Operation, lang: Lang) -> Vec<(String, String)> {
    let mut all = Vec::new();
    for set_up in &operation.set_ups {
        for side in &set_up.sides {
            let (number, side_of) = (set_up.set_up.number, word(side.side.name()));
            let mut canvas = Canvas::default();
            let bottom = layers(&mut canvas, operation, (set_up, side), 0.0, lang);
            let caption = say!(lang, "turn-layers", set_up = number, side = side_of.clone());
            all.push((caption, canvas.page(WIDE, bottom + MARGIN / 2.0)));
            for (zone, work) in side.zones.iter().flat_map(|zone| zone.works.iter().map(move |work| (zone, work))) {
                let Some(taken) = work.transition() else { continue };
                let mut canvas = Canvas::default();
                let bottom = draw_toolpath(&mut canvas, (set_up, side, zone), work, taken, 0.0, lang);
                let zone = format!("{number}.{}", zone.zone.number);
                let caption = say!(lang, "turn-report-way", set_up = number, side = side_of.clone(), zone = zone);
                all.push((caption, canvas.page(WIDE, bottom + MARGIN / 2.0)));
            }
        }
    }
    all
}

/// The corners of the box around contours and, with `axis`, the axis.
fn corners(contours: &[&Contour], axis: bool) -> (Point, Point) {
    let points: Vec<Point> =
        contours.iter().flat_map(|contour| contour.pieces.iter().flat_map(|piece| piece.extremes())).collect();
    let least = |of: fn(&Point) -> Half| points.iter().map(of).min().unwrap_or_default();
    let most = |of: fn(&Point) -> Half| points.iter().map(of).max().unwrap_or_default();
    let low = if axis { Half::ZERO } else { least(|point| point.radius) };
    (
        Point { radius: low, z: least(|point| point.z) },
        Point { radius: most(|point| point.radius), z: most(|point| point.z) },
    )
}

/// The part with its three allowances and the zones of area 1; returns its lower end.
fn layers(
    canvas: &mut Canvas,
    operation: &Operation,
    (set_up, side): (&SetUpWork, &SideWork),
    top: f64,
    lang: Lang,
) -> f64 {
    let layers = &side.layers;
    let (near, far) = corners(&[&layers.blank, &layers.rough, &layers.part], true);
    let room = (WIDE - 2.0 * MARGIN, TALL);
    let view = View::within(near, far, MARGIN, top + TITLE + MARGIN, room.0, room.1);
    let tall = view.long(far.radius);
    let (number, side_of) = (set_up.set_up.number, word(side.side.name()));
    let title = say!(lang, "turn-layers", set_up = number, side = side_of);
    canvas.text((MARGIN, top + TITLE - 8.0), 15.0, Anchor::Start, &title);
    view.area(canvas, solid(&layers.part, far.radius), STEEL);
    // What is hollow from the beginning is not drawn as metal.
    let bore = operation.workpiece.blank.inner.as_ref().filter(|_| side.side == Side::Outer);
    if let Some((least, _)) = bore.and_then(Contour::radii) {
        let at = |radius, z| view.at(Point { radius, z });
        canvas.rectangle(at(Half::ZERO, near.z), at(least, far.z), "white", None);
        canvas.line(&[at(least, near.z), at(least, far.z)], Pen::dashed("#666666", 1.2));
    }
    let areas = [&layers.areas.rough_main, &layers.areas.additional, &layers.areas.finish];
    for (area, (fill, _)) in areas.iter().zip(ALLOWANCES) {
        view.area(canvas, area.boundary.iter().copied(), fill);
    }
    let pens = [
        (&layers.blank, Pen::dashed("#666666", 1.2)),
        (&layers.rough, Pen::solid("#0072b2", 1.2)),
        (&layers.main, Pen::dashed("#d55e00", 0.8)),
        (&layers.part, Pen::solid("#333333", 1.4)),
    ];
    for (contour, pen) in pens {
        view.line(canvas, contour.pieces.iter().copied(), pen);
    }
    axis(canvas, &view, near, far);
    sizes(canvas, &view, operation, (set_up, side), lang);
    for zone in &side.zones {
        let one = &zone.zone;
        let middle = |a: Half, b: Half| Half::new(i64::midpoint(a.halves(), b.halves()));
        let at =
            view.at(Point { radius: middle(one.least_radius, one.greatest_radius), z: middle(one.from_z, one.to_z) });
        for edge in [one.from_z, one.to_z] {
            let line = [Point { radius: one.least_radius, z: edge }, Point { radius: one.greatest_radius, z: edge }];
            view.line(canvas, [Piece::line(line[0], line[1])], Pen::dashed("#009e73", 0.9));
        }
        let at = (at.0, top + TITLE + MARGIN - 8.0 + f64::from(u8::from(side.side == Side::Inner)) * (tall + 24.0));
        canvas.circle(at, 10.0, "white", Some(Pen::solid("#009e73", 1.2)));
        canvas.text((at.0, at.1 + 4.0), 12.0, Anchor::Middle, &one.number.to_string());
    }
    let deep = lengths(canvas, &view, (set_up, side), top + TITLE + MARGIN + tall, lang);
    let below = if side.side == Side::Inner { 46.0 } else { 28.0 };
    let bottom = top + TITLE + MARGIN + tall + deep + below;
    let mut left = MARGIN;
    for (fill, name) in ALLOWANCES {
        canvas.rectangle((left, bottom - 14.0), (left + 18.0, bottom - 2.0), fill, Some(Pen::solid("#666", 0.5)));
        canvas.text((left + 24.0, bottom - 3.0), 12.0, Anchor::Start, lang.word(name));
        left += 210.0;
    }
    bottom + 14.0
}

/// The sizes with limits at their surfaces, on the side of the metal.
fn sizes(canvas: &mut Canvas, view: &View, operation: &Operation, (set_up, side): (&SetUpWork, &SideWork), lang: Lang) {
    let later = ground(operation);
    for surface in set_up.set_up.side(side.side).iter().flat_map(|stretch| &stretch.profile.surfaces) {
        let Some(piece) = surface.pieces.first() else { continue };
        let left = later.iter().find(|one| one.surface == surface.name);
        let note = match (operation.sizes.of_surface(&surface.name), left.and_then(|one| Some((one, one.turned_mm?)))) {
            (Some(sized), _) => {
                let code = match sized.of {
                    SizeOf::Diameter => "turn-drawn-diameter",
                    SizeOf::Length => "turn-drawn-length",
                };
                let note = Note::new(code).with("nominal", sized.nominal_mm).with("fit", &*sized.fit);
                note.with("least", sized.least_mm).with("most", sized.most_mm)
            }
            (None, Some((one, turned))) => {
                let operation = Figure::word(one.operation.name());
                let note = Note::new("turn-drawn-ground").with("turned", turned).with("operation", operation);
                note.with("left", one.allowance_mm)
            }
            (None, None) => match surface.cylinder().filter(|_| surface.kind == SurfaceKind::Cylinder) {
                Some(piece) => Note::new("turn-drawn-plain").with("diameter", piece.from.radius.diameter()),
                None => continue,
            },
        };
        let ends = [view.at(piece.from), view.at(piece.to)];
        let below = if side.side == Side::Outer { 14.0 } else { -5.0 };
        let at = ((ends[0].0 + ends[1].0) / 2.0, (ends[0].1 + ends[1].1) / 2.0 + below);
        canvas.text(at, 11.0, Anchor::Middle, &lang.say(&note));
    }
}

/// The lengths from the free end to the faces that a set-up turns outside, one dimension line under the other; returns how far they
/// reach down.
fn lengths(canvas: &mut Canvas, view: &View, (set_up, side): (&SetUpWork, &SideWork), axis: f64, lang: Lang) -> f64 {
    const NEXT: f64 = 24.0;
    if side.side == Side::Inner {
        return 0.0;
    }
    let stretch = set_up.set_up.side(side.side);
    let surfaces = stretch.iter().flat_map(|stretch| &stretch.profile.surfaces);
    let pieces = surfaces.filter(|surface| surface.kind == SurfaceKind::Face).flat_map(|surface| &surface.pieces);
    let mut faces: Vec<(Half, Half)> = Vec::new();
    for piece in pieces.filter(|piece| piece.is_face() && piece.from.z > Half::ZERO) {
        let lowest = piece.from.radius.min(piece.to.radius);
        if !faces.iter().any(|(z, _)| *z == piece.from.z) {
            faces.push((piece.from.z, lowest));
        }
    }
    faces.sort();
    let start = view.at(Point { radius: Half::ZERO, z: Half::ZERO });
    let mut y = axis;
    for (z, radius) in faces {
        y += NEXT;
        let face = view.at(Point { radius, z });
        canvas.line(&[face, (face.0, y + 4.0)], THIN);
        canvas.dimension([(face.0, y), (start.0, y)], &figure(z, lang));
    }
    if y > axis {
        canvas.line(&[(start.0, axis), (start.0, y + 4.0)], THIN);
    }
    y - axis
}

/// The section of the part: from an outer contour down to the axis, for a bore up to a radius.
fn solid(part: &Contour, far: Half) -> Vec<Piece> {
    let (Some(start), Some(end)) = (part.start(), part.end()) else { return Vec::new() };
    let base = if part.side == Side::Outer { Half::ZERO } else { far };
    let (low, back) = (Point { radius: base, z: end.z }, Point { radius: base, z: start.z });
    let mut pieces = part.pieces.clone();
    pieces.extend([Piece::line(end, low), Piece::line(low, back), Piece::line(back, start)]);
    pieces
}

fn axis(canvas: &mut Canvas, view: &View, near: Point, far: Point) {
    let (right, left) =
        (view.at(Point { radius: Half::ZERO, z: near.z }), view.at(Point { radius: Half::ZERO, z: far.z }));
    canvas.push_element(format_args!(
        "<path d=\"M{:.2} {:.2} H{:.2}\" fill=\"none\" stroke=\"#333\" stroke-width=\"0.8\" stroke-dasharray=\"12 3 2 3\"/>",
        left.0 - 14.0,
        left.1,
        right.0 + 14.0
    ));
}

/// The toolpath over a zone, as large as possible; returns its lower end.
fn draw_toolpath(
    canvas: &mut Canvas,
    (set_up, side, zone): (&SetUpWork, &SideWork, &ZoneWork),
    work: &Work,
    transition: &Transition,
    top: f64,
    lang: Lang,
) -> f64 {
    let stock = &work.stock;
    let points = transition.path.pieces().map(|(piece, _)| piece).collect::<Vec<_>>();
    let moves = Contour { side: side.side, pieces: points };
    let (near, far) = corners(&[&stock.blank, &stock.rough, &moves], false);
    let view = View::within(near, far, MARGIN, top + TITLE + MARGIN, WIDE - 2.0 * MARGIN, TALL);
    let tall = view.long(far.radius - near.radius);
    let title = say!(
        lang,
        "turn-way",
        set_up = set_up.set_up.number,
        side = word(side.side.name()),
        // The same name as on the pages.
        zone = format!("{}.{}", set_up.set_up.number, zone.zone.number),
        scheme = word(transition.scheme.name()),
        depth = rounded(work.levels.depth.to_mm(), lang),
        cutting = fixed(transition.measures.cutting_mm, 1, lang),
        time = fixed(transition.measures.time_min.0, 2, lang)
    );
    canvas.text((MARGIN, top + TITLE - 8.0), 15.0, Anchor::Start, &title);
    let between = technolog_turning::allowances::areas::between(&stock.blank, &stock.rough);
    view.area(canvas, between.boundary, ALLOWANCES[0].0);
    let base = if side.side == Side::Outer { near.radius } else { far.radius };
    view.area(canvas, footing(&stock.rough, base), STEEL);
    for section in &work.levels.sections {
        for (index, level) in section.horizontals.iter().enumerate() {
            let line = Piece::line(Point { radius: *level, z: section.from }, Point { radius: *level, z: section.to });
            view.line(canvas, [line], Pen::solid("#bbbbbb", 0.5));
            let at = view.at(Point { radius: *level, z: section.to });
            canvas.text((at.0 - 12.0, at.1 + 4.0), 10.0, Anchor::Middle, &(index + 1).to_string());
        }
    }
    view.line(canvas, stock.rough.pieces.iter().copied(), Pen::solid("#333333", 1.3));
    view.toolpath(canvas, &transition.path);
    numbers(canvas, &view, transition);
    let bottom = top + TITLE + MARGIN + tall + 46.0;
    legend(canvas, transition, bottom, lang);
    bottom + 14.0
}

/// The metal under a section of the rough contour, down to a radius.
fn footing(rough: &Contour, base: Half) -> Vec<Piece> {
    let (Some(start), Some(end)) = (rough.start(), rough.end()) else { return Vec::new() };
    let (low, back) = (Point { radius: base, z: end.z }, Point { radius: base, z: start.z });
    let mut pieces = rough.pieces.clone();
    pieces.extend([Piece::line(end, low), Piece::line(low, back), Piece::line(back, start)]);
    pieces
}

/// The names of support points, each place once.
fn numbers(canvas: &mut Canvas, view: &View, transition: &Transition) {
    let mut put: Vec<&str> = Vec::new();
    for point in &transition.points {
        if put.contains(&point.name.as_str()) {
            continue;
        }
        put.push(&point.name);
        let (x, y) = view.at(Point { radius: Half::radius_of(point.diameter_mm), z: Half::ZERO - point.z_mm });
        canvas.circle((x, y), 1.8, "#333333", None);
        canvas.text((x + 5.0, y - 4.0), 10.0, Anchor::Start, &point.name);
    }
}

fn legend(canvas: &mut Canvas, transition: &Transition, bottom: f64, lang: Lang) {
    let mut left = MARGIN;
    let purposes = [
        (Purpose::Rapid, "turn-way-rapid"),
        (Purpose::Cut, "turn-way-cut"),
        (Purpose::Infeed, "turn-way-infeed"),
        (Purpose::PickUp, "turn-way-pick-up"),
        (Purpose::SemiFinish, "turn-way-semi-finish"),
        (Purpose::Finish, "turn-way-finish"),
        (Purpose::Return, "turn-way-return"),
        (Purpose::Plunge, "turn-way-plunge"),
        (Purpose::Thread, "turn-way-thread"),
    ];
    for (purpose, name) in purposes {
        if transition.path.moves.iter().any(|one| one.purpose == purpose) {
            canvas.line(&[(left, bottom - 7.0), (left + 34.0, bottom - 7.0)], pen_of(purpose));
            let name = lang.word(name);
            canvas.text((left + 40.0, bottom - 3.0), 12.0, Anchor::Start, name);
            left += (40.0 + width_of(name, 12.0) + 16.0).max(190.0);
        }
    }
}
