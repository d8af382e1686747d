//! The grid of ordinary holes that drawings have every day, as parts of one hole each.

use std::fmt;

/// Diameters, mm: below 20, and from there on those of bearings and bushes.
const DIAMETERS: [u32; 22] = [3, 4, 5, 6, 8, 10, 12, 14, 16, 18, 20, 22, 25, 28, 30, 35, 40, 47, 52, 62, 72, 80];
/// Grades of H with the roughness Ra that goes with them.
const FINISHES: [(u8, &str); 9] =
    [(6, "0.8"), (7, "0.8"), (7, "1.6"), (8, "1.6"), (8, "3.2"), (9, "3.2"), (11, "6.3"), (12, "12.5"), (14, "12.5")];
/// Depths in tenths of the diameter.
const DEPTHS: [u32; 7] = [5, 10, 20, 30, 50, 80, 120];
/// One material of each group, and a second steel.
const MATERIALS: [&str; 7] = ["Сталь 45", "40Х", "СЧ20", "Д16", "12Х18Н10Т", "БрО10Ф1", "ЛС59-1"];
/// Holes of blanks begin at this diameter, mm.
const OF_BLANK: u32 = 30;
/// The thickest and the thinnest plate, tenths of mm.
const PLATES: std::ops::RangeInclusive<u32> = 30..=2500;

/// What is there before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Blank {
    /// Solid metal.
    Solid,
    /// A cast hole, 10 mm narrower.
    Cast,
    /// A hole that was machined before, 5 mm narrower.
    PreMachined,
}

/// A hole of the grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct GridHole {
    /// Diameter, mm.
    pub diameter: u32,
    /// Grade of the field H.
    pub it: u8,
    /// Roughness Ra.
    pub ra: &'static str,
    /// Depth, tenths of the diameter.
    pub depth: u32,
    /// Material.
    pub material: &'static str,
    /// Whether it goes through.
    pub through: bool,
    /// What is there before.
    pub blank: Blank,
}

/// `Ø40H7 Ra 1.6 through 80 mm in 40Х, solid`.
impl fmt::Display for GridHole {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { diameter, it, ra, material, .. } = self;
        let way = if self.through { "through" } else { "blind" };
        let blank = match self.blank {
            Blank::Solid => "solid",
            Blank::Cast => "cast",
            Blank::PreMachined => "pre-machined",
        };
        write!(f, "Ø{diameter}H{it} Ra {ra} {way} {} mm in {material}, {blank}", tenths(self.deep()))
    }
}

impl GridHole {
    /// Depth, tenths of mm.
    fn deep(&self) -> u32 {
        self.diameter * self.depth
    }

    /// The thickness of its plate, tenths of mm: under a blind hole there is metal for the point of a drill.
    fn plate(&self) -> u32 {
        if self.through { self.deep() } else { self.deep() + (self.diameter * 6).max(50) }
    }

    /// Its part file.
    pub fn part(&self) -> String {
        let Self { diameter, it, ra, material, .. } = self;
        let side = (diameter * 3).max(200);
        let depth = if self.through { "through: true".to_owned() } else { format!("depth: {}", tenths(self.deep())) };
        let state = match self.blank {
            Blank::Solid => String::new(),
            Blank::Cast => format!(", state: cast, state_diameter: {}", diameter - 10),
            Blank::PreMachined => format!(", state: pre-machined, state_diameter: {}", diameter - 5),
        };
        format!(
            "part: P\nmachine: gf2171\nmaterial: {material}\n\
             blank: {{kind: plate, length: {side}, width: {side}, thickness: {}}}\n\
             holes:\n  - {{name: A, at: [[0, 0]], diameter: {diameter}H{it}, roughness: Ra {ra}, centre_tolerance: 0.5, \
             {depth}{state}}}\n",
            tenths(self.plate())
        )
    }
}

fn tenths(value: u32) -> String {
    if value.is_multiple_of(10) { (value / 10).to_string() } else { format!("{}.{}", value / 10, value % 10) }
}

/// The whole grid, in a fixed order.
pub fn holes() -> Vec<GridHole> {
    let mut holes = Vec::new();
    for diameter in DIAMETERS {
        for (it, ra) in FINISHES {
            for depth in DEPTHS {
                for material in MATERIALS {
                    for through in [true, false] {
                        for blank in [Blank::Solid, Blank::Cast, Blank::PreMachined] {
                            let hole = GridHole { diameter, it, ra, depth, material, through, blank };
                            let fits = blank == Blank::Solid || diameter >= OF_BLANK;
                            if fits && PLATES.contains(&hole.plate()) {
                                holes.push(hole);
                            }
                        }
                    }
                }
            }
        }
    }
    holes
}
