//! How the part is set up on the machine: what holds it, where it stands, and its zeros.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::note::Because;
use crate::part::{Along, Deviations, Face, Outline, Part, Point, Standing};
use crate::tables::rules::{FixtureKind, HeldBy, PartLocating, PinKind, TableKeying};
use crate::units::{Micrometres, NewtonMetres, Newtons};

use super::{Chain, Clamping, PartZero};

/// How the part is set up.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Setup {
    /// What kind of fixture it is and how it locates; absent when no hole could be planned.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fixture: Option<FixturePlan>,
    /// The vice, where straps find no place on the face; without one the part lies on the table, or on what the file says.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vice: Option<Vice>,
    /// The chuck on the table, for a round part that straps do not hold, or where the file asks for one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub chuck: Option<Chuck>,
    /// The clamps of the second set-up, in which the part lies turned over: places as it lies then. Absent where nothing is cut there,
    /// the file gives what stands there, or no straps find a place.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub second_clamping: Option<Clamping>,
    /// The fixture of the shop's own that the file names, and what it must hold.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub own: Option<OwnFixture>,
    /// The zeros of the part where the drawing says from where it dimensions its holes, the first for all that it does not
    /// say it of.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub zeros: Vec<PartZero>,
    /// The chains of the dimensions that are made here.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub chains: Vec<Chain>,
    /// How the part stands in each set-up.
    pub stands: Vec<Stand>,
}

/// A fixture of the shop's own: what it must hold, without the safety factor of the table `clamping`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OwnFixture {
    /// Its name.
    pub name: String,
    /// The group of holes with the largest torque.
    pub hole: String,
    /// That torque, N·m.
    pub torque_n_m: NewtonMetres,
    /// The largest side force, where a transition pushes the part, N.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub side_force_n: Option<Newtons>,
    /// By how much more it must hold.
    pub safety: f64,
    /// Why.
    pub because: Vec<Because>,
}

/// The kind of fixture, and how table, fixture and part are located to each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FixturePlan {
    /// Its kind.
    pub fixture_kind: FixtureKind,
    /// What holds the part in it.
    pub held: HeldBy,
    /// How it is keyed to the table; absent where the record of the machine does not say what its table has.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub keying: Option<TableKeying>,
    /// How much play its keys or pins have there at most, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub keying_play_mm: Option<Micrometres>,
    /// How the part is located in it.
    pub locating: PartLocating,
    /// How far part after part is off its place in it, at least and at most, mm; absent where nobody knows the fixture.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub locating_error_mm: Option<[Micrometres; 2]>,
    /// The pins that locate the part in the first set-up, the round one of two first: X and Y are then found at it, because the
    /// sides of every part lie otherwise.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub pins: Vec<LocatingPin>,
    /// How two pins belong together; absent where there are not two.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pair: Option<PinPair>,
    /// Why.
    pub because: Vec<Because>,
}

/// A pin of the fixture in a finished hole of the blank.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LocatingPin {
    /// Round, or cut away to two lands.
    pub kind: PinKind,
    /// Its axis, in the drawing.
    pub at: Point,
    /// Its nominal diameter, that of its hole, mm.
    pub diameter_mm: Micrometres,
    /// Its field: `g6`.
    pub field: String,
    /// The deviations of its diameter, mm.
    pub upper_mm: Micrometres,
    /// The same, the lower one.
    pub lower_mm: Micrometres,
    /// Its standard.
    pub standard: String,
    /// How wide each land of a cut pin is, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub land_mm: Option<Micrometres>,
    /// The least and the greatest clearance in its hole, mm: as far as the part may shift on it.
    pub clearance_mm: [Micrometres; 2],
}

impl LocatingPin {
    /// The deviations of its diameter.
    pub const fn deviations(&self) -> Deviations {
        Deviations { upper: self.upper_mm, lower: self.lower_mm }
    }
}

/// Two pins of one part.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PinPair {
    /// How far apart their axes are, mm.
    pub apart_mm: Micrometres,
    /// The tolerances of the distances of the pins and of the holes together, full widths, that every part still goes on with:
    /// X1 + X2·D2/b of the least clearances X1 and X2, the diameter D2 and the land b of the cut pin, mm.
    pub distance_tolerances_mm: Micrometres,
    /// How far the hole farthest from the round pin is turned aside at most: its distance times (S1 + S2)/(2·L) of the greatest
    /// clearances, mm.
    pub turned_mm: Micrometres,
}

/// A machine vice with the part in it, on parallels.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Vice {
    /// Its designation.
    pub designation: String,
    /// Its table.
    pub table: String,
    /// The axis along which its jaws stand.
    pub jaws_along: Along,
    /// How wide its jaws are, mm.
    pub jaw_width_mm: Micrometres,
    /// How far they open for the part, mm.
    pub opened_mm: Micrometres,
    /// From the table to the ways the parallels stand on, mm.
    pub bed_height_mm: Micrometres,
    /// How high the parallels are, mm; absent where the part lies on the ways.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub parallels_mm: Option<Micrometres>,
    /// The thickest parallels that no hole comes out into, mm; absent without parallels.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thickest_parallels_mm: Option<Micrometres>,
    /// How deep the jaws grip the part, mm.
    pub grip_mm: Micrometres,
    /// How far the jaws stay below the face, mm: nothing of the vice stands over it.
    pub below_face_mm: Micrometres,
    /// The force that the jaws must press with, N.
    pub force_n: Newtons,
    /// The group of holes that needs it.
    pub hole: String,
    /// The least force that the vice gives, N.
    pub gives_n: Newtons,
    /// Why.
    pub because: Vec<Because>,
}

impl Vice {
    /// How high the part lies over the table, mm.
    pub fn height(&self) -> Micrometres {
        self.bed_height_mm + self.parallels_mm.unwrap_or_default()
    }
}

/// A three-jaw chuck that lies on the table, with the part on a step of its jaws.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Chuck {
    /// Its designation.
    pub designation: String,
    /// Its table.
    pub table: String,
    /// Its diameter, mm.
    pub diameter_mm: Micrometres,
    /// The wall of the jaws that holds the part: 2 the outer one, 1 the one inside it.
    pub step: u32,
    /// From the table to the part, mm.
    pub part_height_mm: Micrometres,
    /// Below the part to the body, beside the jaws, mm.
    pub room_mm: Micrometres,
    /// How deep the jaws grip the part, mm.
    pub grip_mm: Micrometres,
    /// How far the jaws stay below the face, mm: nothing of the chuck stands over it.
    pub below_face_mm: Micrometres,
    /// Where the first jaw stands, degrees from X towards Y in the drawing, the others 120° on: no tool that comes out below meets one.
    pub jaw_deg: u32,
    /// How wide a jaw is, mm.
    pub jaw_width_mm: Micrometres,
    /// From the axis to where the steps of the jaws end that a tool coming out below could meet, mm.
    pub jaws_from_mm: Micrometres,
    /// The force that all jaws must press with together, N.
    pub force_n: Newtons,
    /// The group of holes that needs it.
    pub hole: String,
    /// The force that the chuck gives, N.
    pub gives_n: Newtons,
    /// Its mass, kg.
    pub mass_kg: f64,
    /// Why.
    pub because: Vec<Because>,
}

impl Chuck {
    /// Where its jaws stand, degrees from X as the part lies with that face up: turned over, left and right change places.
    pub fn jaws(&self, face: Face) -> [u32; 3] {
        let first = if face == Face::Back { (180 + 360 - self.jaw_deg) % 120 } else { self.jaw_deg % 120 };
        [first, first + 120, first + 240]
    }
}

/// A strap of a proposed clamp: a rectangle that reaches outward over the nearest side of the part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Strap {
    /// Its width, mm.
    pub width_mm: Micrometres,
    /// Its length, mm.
    pub length_mm: Micrometres,
    /// How high it stands over the face, with nut and stud, mm.
    pub height_mm: Micrometres,
}

impl Strap {
    /// How it stands where it presses at a point: half its width farther in than the point, the rest of its length outward.
    pub fn standing(&self, at: Point, part: &Part) -> Standing {
        let (blank, datum, half) = (&part.blank, &part.datum, self.width_mm.half());
        let (left, front) = (at.x - datum.left, at.y - datum.front);
        let (right, back) = (blank.length - left, blank.width - front);
        let nearest = left.min(right).min(front).min(back);
        let out = self.length_mm - half;
        let reach = |toward: bool| if toward { out } else { half };
        // Toward one side alone, where a corner is as near to two.
        let [to_left, to_right, to_front] = [left == nearest, right == nearest, front == nearest];
        let along = to_left || to_right;
        let (to_right, to_front, to_back) = (to_right && !to_left, to_front && !along, !to_front && !along);
        let low = Point { x: at.x - reach(to_left), y: at.y - reach(to_front) };
        let high = Point { x: at.x + reach(to_right), y: at.y + reach(to_back) };
        Standing { at, outline: Outline::Box(low, high), height: self.height_mm, proposed: true }
    }
}

/// What holds the part in a set-up.
#[derive(Clone, Copy, Debug)]
pub enum Held<'p> {
    /// Straps.
    Straps(&'p Clamping),
    /// A vice.
    Vice(&'p Vice),
    /// A chuck.
    Chuck(&'p Chuck),
    /// A fixture of the shop's own.
    Own(&'p OwnFixture),
    /// Nothing that the plan knows.
    Nothing,
}

/// How the part stands on the table in a set-up.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Stand {
    /// The set-up, from 1.
    pub set_up: u32,
    /// The face that is up.
    pub face: Face,
    /// The groups of holes that are worked on in it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub holes: Vec<String>,
    /// The bars of boring tools and what they are set to, in the order of the work.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bars: Vec<BarSetting>,
    /// How high the part lies over the table, mm.
    pub height_mm: Micrometres,
    /// The left side and the front side of the part from the middle of the table, mm.
    pub corner_mm: Point,
    /// From the table to the nose of the spindle with the quill retracted, mm: how the knee is set; absent where the record of
    /// the machine does not say how high it can be.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nose_to_table_mm: Option<Micrometres>,
    /// The function of its zero: 54 for G54.
    pub frame: u8,
    /// Where the zero of the drawing then lies in the frame of the machine: X and Y as the part lies, Z with the reference
    /// tool; mm.
    pub zero_mm: [Micrometres; 3],
    /// From the zero of the drawing to the two sides that an arbor of diameter d touches, as the part lies: the B and H of
    /// x0 = xM − B − d/2, y0 = yM − H − d/2 (textbook 1.12.2) at the right and the back side, and x0 = xM − B + d/2 at the left
    /// one; mm.
    pub sides_mm: [Micrometres; 2],
    /// Which sides these are: those from which the drawing gives dimensions. The part turned over is touched on the same face,
    /// which is then on the other side.
    #[serde(default)]
    pub touched: Touched,
    /// The other zeros of the set-up: of holes that the drawing dimensions from other sides.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub other_zeros: Vec<OtherZero>,
    /// From the zero of the drawing up to the face, which the reference tool touches; mm.
    pub face_mm: Micrometres,
    /// The tool that all lengths are counted from.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub reference_tool: Option<u32>,
    /// How high over the face tools go from hole to hole, mm.
    pub first_level_mm: Micrometres,
    /// Where the tool changes, in the drawing: the point where the work starts.
    pub start: Point,
    /// From there to the nearest clamp with a screw, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start_to_clamp_mm: Option<Micrometres>,
    /// Where the spindle stands while the part is loaded; absent where no clamps with screws hold it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loading: Option<Loading>,
}

/// Where the spindle stands while the part is loaded: at the far left from the worker, and from every clamp as far as a wrench needs
/// (textbook 1.11).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Loading {
    /// The point, in the drawing.
    pub at: Point,
    /// The distance from the nearest clamp that its wrench needs, mm.
    pub safe_mm: Micrometres,
    /// From where the axis X ends to that point, mm; absent where the axes reach it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub beyond_mm: Option<Micrometres>,
    /// Whether the place of the tool change is as far from every clamp, so that the spindle may stay there.
    pub start_is_safe: bool,
}

/// A boring bar set to a diameter.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct BarSetting {
    /// The tool.
    pub tool: u32,
    /// The diameter that it bores, mm.
    pub diameter_mm: Micrometres,
    /// The groups of holes that are bored so.
    pub holes: Vec<String>,
    /// Whether the program stops for it; otherwise the bar is set before the program begins.
    pub at_stop: bool,
}

/// Another zero of a set-up, found at other sides of each part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OtherZero {
    /// Its function: 55 for G55.
    pub frame: u8,
    /// As `sides_mm` of the set-up.
    pub sides_mm: [Micrometres; 2],
    /// Which sides these are.
    pub touched: Touched,
    /// The groups of holes that are counted from it.
    pub holes: Vec<String>,
}

/// The sides of the part that an arbor touches, as it lies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Touched {
    /// The left one, or else the right one.
    pub left: bool,
    /// The front one, or else the back one.
    pub front: bool,
}
