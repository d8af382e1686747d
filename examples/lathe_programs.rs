//! Random ways and contours with their programs for LinuxCNC, one JSON object on a line, for tests/oracles/lathe.py:
//!
//!     cargo run -q --example lathe_programs -- 200 1     # so many of each kind, by this seed
//!
//! Random numbers are those of a small generator of this file, so that a seed gives the same programs everywhere.

use serde_json::{Value, json};
use technolog::knowledge::Knowledge;
use technolog::shipped;
use technolog::turning::contour::{Contour, Piece, Side, Turn};
use technolog::turning::length::Half;
use technolog::turning::point::Point;
use technolog::turning::program::{Allowance, Control, Direction, Feeds, Roughing, Setting, Speed, cycle, plain};
use technolog::turning::toolpath::{Purpose, Toolpath};
use technolog::units::{MetresPerMinute, MillimetresPerRev, RevsPerMinute};
use technolog_testing::oracle_json::told_piece;

/// A generator of random numbers (splitmix64).
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, end: u64) -> u64 {
        self.roll() % end
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.below(1 << 40) as f64) / (1_u64 << 40) as f64
    }

    /// A length in half micrometres, half of the time in whole millimetres.
    fn length(&mut self, low: f64, high: f64) -> Half {
        let length = self.between(low, high);
        if self.below(2) == 0 { Half::from(length.round().clamp(low, high)) } else { Half::from(length) }
    }
}

fn setting(dice: &mut Dice) -> Setting {
    let feed = |value: f64| MillimetresPerRev(value);
    let speed = if dice.below(2) == 0 {
        Speed::Cutting { speed: MetresPerMinute(120.0), limit: RevsPerMinute(2500.0) }
    } else {
        Speed::Spindle(RevsPerMinute(800.0))
    };
    let feeds = Feeds {
        cut: feed(0.3),
        infeed: feed(0.15),
        pick_up: feed(0.2),
        semi_finish: feed(0.25),
        finish: feed(0.1),
        back: feed(0.6),
        plunge: feed(0.1),
        thread: feed(1.0),
    };
    Setting { name: "Вал".to_owned(), tool: 1, speed, feeds, coolant: dice.below(2) == 0 }
}

fn random_way(dice: &mut Dice) -> Toolpath {
    let point = |dice: &mut Dice| Point::new(dice.length(-1.0, 60.0), dice.length(-5.0, 120.0));
    let mut toolpath = Toolpath::at(point(dice));
    let feeds = [Purpose::Cut, Purpose::Infeed, Purpose::PickUp, Purpose::SemiFinish, Purpose::Finish, Purpose::Return];
    for _ in 0..3 + dice.below(20) {
        let mut to = point(dice);
        // Half of the moves go along one axis.
        match dice.below(4) {
            0 => to.z = toolpath.end().z,
            1 => to.radius = toolpath.end().radius,
            _ => {}
        }
        let purpose = feeds[dice.below(6) as usize];
        match dice.below(3) {
            0 => toolpath.go(to, Purpose::Rapid),
            1 => toolpath.go(to, purpose),
            _ => {
                let half = toolpath.end().to(to).length() / 2.0;
                let share = if dice.below(4) == 0 { 1.0 } else { dice.between(1.0, 3.0) };
                let radius = Half::new((half * share * 2000.0).ceil() as i64);
                let turn = if dice.below(2) == 0 { Turn::Left } else { Turn::Right };
                toolpath.follow(Piece::arc(toolpath.end(), to, radius, turn), purpose);
            }
        }
    }
    toolpath
}

/// The next piece of a contour: along, up, a slope, or a part of a quarter circle; with `down` also downwards.
fn random_piece(dice: &mut Dice, from: Point, down: bool) -> Piece {
    let to = |dz: Half, dr: Half| Point::new(from.radius + dr, from.z + dz);
    let falls = down && from.radius > Half::from(8.0) && dice.below(3) == 0;
    let sign = |half: Half| if falls { Half::ZERO - half } else { half };
    match dice.below(5) {
        0 => Piece::line(from, to(dice.length(1.0, 15.0), Half::ZERO)),
        1 => Piece::line(from, to(Half::ZERO, sign(dice.length(1.0, 6.0)))),
        2 => Piece::line(from, to(dice.length(1.0, 8.0), sign(dice.length(1.0, 6.0)))),
        kind => {
            let quarter = std::f64::consts::FRAC_PI_2;
            let radius = dice.length(1.0, 7.0);
            let (begin, end) =
                if dice.below(2) == 0 { (0.0, quarter) } else { (dice.between(0.0, 0.6), dice.between(0.9, quarter)) };
            let (short, long) = (
                radius.to_mm() * (libm::cos(begin) - libm::cos(end)),
                radius.to_mm() * (libm::sin(end) - libm::sin(begin)),
            );
            // A hollow that rises begins level, a ball that rises begins upright; walked downwards it is the other way.
            let hollow = kind == 3;
            let (dz, dr) = if hollow == falls { (short, long) } else { (long, short) };
            let turn = if hollow { Turn::Left } else { Turn::Right };
            Piece::arc(from, to(Half::from(dz), sign(Half::from(dr))), radius, turn)
        }
    }
}

/// A contour with the corner of its blank, and how it is roughed.
fn random_task(dice: &mut Dice) -> (Contour, Point, Roughing) {
    let direction = if dice.below(3) == 0 { Direction::Facing } else { Direction::Longitudinal };
    let down = direction == Direction::Longitudinal && dice.below(2) == 0;
    let start = if dice.below(2) == 0 { Half::ZERO } else { dice.length(3.0, 20.0) };
    let mut at = Point::new(start, Half::ZERO);
    let mut pieces: Vec<Piece> = Vec::new();
    for index in 0..2 + dice.below(9) {
        let mut piece = random_piece(dice, at, down);
        if at.radius == Half::ZERO && index == 0 {
            piece = Piece::line(at, Point::new(dice.length(4.0, 15.0), Half::ZERO));
        }
        pieces.push(piece);
        at = piece.to;
    }
    // Something to take off along Z too.
    let last = Piece::line(at, Point::new(at.radius, at.z + dice.length(1.0, 10.0)));
    pieces.push(last);
    let outer = Contour { side: Side::Outer, pieces };
    let most = outer.radii().map_or(Half::ZERO, |(_, most)| most);
    let over = if dice.below(4) == 0 { Half::ZERO } else { dice.length(0.5, 5.0) };
    let face = if dice.below(2) == 0 { Half::ZERO } else { Half::ZERO - dice.length(0.5, 3.0) };
    let clearance = Half::from(2.0);
    let retract = Half::from(0.5);
    let depth = dice.length(1.0, 4.0);
    let roughing = Roughing { direction, depth, clearance, retract, allowance: Allowance::default() };
    let corner = Point::new(most + over, face);
    if dice.below(3) > 0 {
        return (outer, corner, roughing);
    }
    // The same from inside: the blank has a bore of 5 mm, the contour grows outwards from it.
    let top = corner.radius + Half::from(5.0);
    (outer.inside_out(top), Point::new(top - corner.radius, face), roughing)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let count: u64 = arguments.next().map_or(Ok(200), |text| text.parse())?;
    let mut dice = Dice(arguments.next().map_or(Ok(1), |text| text.parse())?);
    let knowledge = Knowledge::from_sources(shipped::SOURCES).map_err(|_| "the shipped tables cannot be read")?;
    let control = Control::read("linuxcnc", &knowledge)?;
    for _ in 0..count {
        let (toolpath, setting) = (random_way(&mut dice), setting(&mut dice));
        let program = plain(&control, &toolpath, &setting).map_err(|refused| format!("{refused:?}"))?;
        let moves: Vec<Value> = toolpath
            .pieces()
            .map(|(piece, purpose)| {
                let mut piece = told_piece(piece);
                piece["feed"] = json!(setting.feeds.of(purpose).map(|feed| feed.0));
                piece
            })
            .collect();
        let from = [toolpath.from.radius.to_mm(), toolpath.from.z.to_mm()];
        println!("{}", json!({"kind": "plain", "from": from, "moves": moves, "program": program}));
    }
    for _ in 0..count {
        let ((contour, corner, roughing), setting) = (random_task(&mut dice), setting(&mut dice));
        let written = cycle(&control, &contour, corner, roughing, &setting);
        let pieces: Vec<Value> = contour.pieces.iter().map(|piece| told_piece(*piece)).collect();
        let mut line = json!({
            "kind": "cycle",
            "direction": roughing.direction.name(),
            "outer": contour.side == Side::Outer,
            "corner": [corner.radius.to_mm(), corner.z.to_mm()],
            "clearance": roughing.clearance.to_mm(),
            "depth": roughing.depth.to_mm(),
            "feed": setting.feeds.cut.0,
            "pieces": pieces,
        });
        match written {
            Ok(written) => line["program"] = json!(written.files.first().map(|file| &file.text)),
            Err(refused) => line["refused"] = json!(format!("{refused:?}")),
        }
        println!("{line}");
    }
    Ok(())
}
