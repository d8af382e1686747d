//! A turned part of any contour, its blank, and the machining data of its file.
//!
//! [`read_turned`] reads the file and reports every mistake at once. `outer` is the contour; `steps` is short for that of a
//! stepped shaft, which then is a [`Shaft`], too.
//!
//! From the file to the contour: `steps` reads the short form; `drawn` makes items of points, `items` reads the items, `walk` makes surfaces of them, `groove` the shape of grooves,
//! and `check` compares the contours with themselves and with the blank.

pub mod blank;
mod check;
mod cross;
mod drawn;
pub mod file;
mod grade;
mod groove;
pub mod item_file;
mod items;
mod lengths;
mod preparation;
mod read;
mod read_blank;
mod relief;
mod settings;
mod steps;
mod thread;
mod thread_limits;
mod walk;
mod walk_groove;

use serde::{Serialize, Serializer};

use crate::material::MaterialState;
use crate::note::{Because, Finding};
use crate::units::{Decimal, Micrometres, MillimetresPerMinute};

use super::contour::{Profile, Side, SurfaceName};
use super::length::Half;
use super::shaft::{self, Holding, Shaft};
pub use crate::tables::turning::part::{HeatTreatment, JawKind};
pub use crate::tables::turning::passes::Scheme;
pub use blank::{Blank, StockKind};
pub use drawn::{Drawings, files_named};
pub use file::schema;
pub use preparation::{Advice, advice};
pub use read::{read_turned, read_turned_node, read_turned_with};
pub use thread_limits::{ThreadLimits, ToleranceRow, longest_run_out, tolerance_rows};

/// A turned part and its blank. Z is positive from the finished face of the free end towards the chuck.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Workpiece {
    /// Its name.
    pub name: String,
    /// The id of its material in the catalog `materials`.
    pub material: String,
    /// Its hardness or strength, if the file gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub material_state: Option<MaterialState>,
    /// Its blank.
    pub blank: Blank,
    /// The id of a lathe, as in the file; it is not checked here.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub machine: Option<String>,
    /// The way of clamping.
    pub holding: Holding,
    /// The jaws of its chuck.
    #[serde(skip_serializing_if = "is_usual")]
    pub jaws: JawKind,
    /// The steady rest of its first set-up.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub steady_rest: Option<SteadyRest>,
    /// Whether and when it is heat-treated.
    pub heat_treatment: HeatTreatment,
    /// Its outside, from the axis or the bore at the free end towards the chuck.
    pub outer: Profile,
    /// Its bore, from the free end; it ends on the axis or at the far end.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inner: Option<Profile>,
    /// The threads on its surfaces.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub threads: Vec<Thread>,
    /// The limits of roughing.
    pub roughing: Roughing,
    /// The source of allowances.
    pub allowances: Allowances,
    /// The rates of the tool, if the file gives them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rates: Option<Rates>,
    /// What the search of the paper takes of it, if its file gives it by steps.
    #[serde(skip)]
    pub shaft: Option<Shaft>,
    /// Findings for the reader: figures from tables that are not confirmed.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub findings: Vec<Finding>,
}

/// Whether jaws are the usual three.
fn is_usual(jaws: &JawKind) -> bool {
    *jaws == JawKind::Three
}

impl Workpiece {
    /// Its length: Z of the end of its outside.
    pub fn length(&self) -> Half {
        self.outer.contour().end().map_or(Half::ZERO, |end| end.z)
    }

    /// Its outside, or its bore if it has one.
    pub const fn profile(&self, side: Side) -> Option<&Profile> {
        match side {
            Side::Outer => Some(&self.outer),
            Side::Inner => self.inner.as_ref(),
        }
    }

    /// The thread on a surface.
    pub fn thread_on(&self, surface: &SurfaceName) -> Option<&Thread> {
        self.threads.iter().find(|thread| thread.surface == *surface)
    }

    /// Whether its file gives no allowance at all, as steps do, whose diameters are those after roughing.
    pub fn is_only_roughed(&self) -> bool {
        let none = Micrometres::ZERO;
        self.allowances == Allowances::Stated { on_diameter: none, on_face: none }
    }

    /// Its largest diameter.
    pub fn largest_diameter(&self) -> Micrometres {
        self.outer.contour().radii().map_or(Micrometres::ZERO, |(_, most)| most.diameter())
    }
}

/// A steady rest on a cylinder of the blank.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct SteadyRest {
    /// Z of its middle, mm.
    pub z_mm: Half,
    /// Its length along the axis, mm.
    pub width_mm: Micrometres,
    /// The diameter on which it runs, mm.
    pub seat_mm: Micrometres,
}

impl SteadyRest {
    /// Z of its sides, the one towards the free end first.
    pub fn sides(&self) -> [Half; 2] {
        let half = Half::new(self.width_mm.micrometres());
        [self.z_mm - half, self.z_mm + half]
    }
}

/// A thread on a surface.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Thread {
    /// The name of the surface.
    pub surface: SurfaceName,
    /// The thread as the drawing writes it.
    pub written: String,
    /// Its nominal diameter, mm.
    pub size: Micrometres,
    /// Its pitch, mm.
    pub pitch: Micrometres,
    /// The limits of its crests, outside; none where the tables have none of its class.
    #[serde(skip)]
    pub crests: Option<ThreadLimits>,
    /// The limits of its pitch diameter; none where the tables have none of its class.
    #[serde(skip)]
    pub flanks: Option<ThreadLimits>,
    /// The longest run-out that the standard allows behind it; none for a pitch below those of the table.
    #[serde(skip)]
    pub longest_run_out: Option<Micrometres>,
    /// Its hole, in a bore and where a tap cuts it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tapped: Option<Tapped>,
    /// Why it is tapped or turned, in a bore and once that is decided.
    #[serde(skip)]
    pub way: Option<Because>,
}

/// The hole under a tapped thread.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Tapped {
    /// The thread as the tables of taps name it.
    #[serde(skip)]
    pub id: String,
    /// Its diameter: that of the drill, mm.
    pub hole_mm: Micrometres,
    /// The least diameter that it may have, mm.
    pub smallest_hole_mm: Micrometres,
    /// The largest diameter that it may have, mm.
    pub largest_hole_mm: Micrometres,
    /// How far behind the full thread its tap goes on, mm.
    #[serde(skip)]
    pub run_out_mm: Micrometres,
}

impl Thread {
    /// The pitch diameter of the basic profile, 3/4 H = 0.6495 P below the nominal one (ISO 724).
    pub fn basic_pitch_diameter(&self) -> Micrometres {
        thread_limits::basic_pitch_diameter(self.size, self.pitch)
    }
}

/// The limits of roughing; missing ones follow from tool, lathe and rules.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Serialize)]
pub struct Roughing {
    /// The limiting depth of a pass, radial, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limiting_depth: Option<Micrometres>,
    /// The scheme of roughing passes that the file requires.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scheme: Option<Scheme>,
}

/// The source of finishing allowances (lecture 12.2, l. 155-171). A surface that states its own keeps it.
#[derive(Clone, Debug, PartialEq, Eq, Default, Serialize)]
#[serde(tag = "method", rename_all = "kebab-case")]
pub enum Allowances {
    /// From tables.
    #[default]
    Table,
    /// From stated errors of the passes.
    Analytic(Errors),
    /// As the file states them.
    Stated {
        /// On the diameter, mm.
        on_diameter: Micrometres,
        /// On a face, mm.
        on_face: Micrometres,
    },
}

/// The errors of the analytic method.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Errors {
    /// Rz after the previous pass.
    pub rz_um: Microns,
    /// The defect layer after the previous pass.
    pub defect_layer_um: Microns,
    /// The remaining spatial deviation of the blank.
    pub spatial_deviation_um: Microns,
    /// The error of set-up of this pass.
    pub setup_error_um: Microns,
}

/// A height or an error, in micrometres, exact to a millionth of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Microns(Decimal);

impl Microns {
    /// From micrometres.
    pub const fn new(micrometres: Decimal) -> Self {
        Self(micrometres)
    }

    /// Millimetres, for formulas.
    pub fn to_mm(self) -> f64 {
        self.0.to_f64() / 1000.0
    }
}

impl Serialize for Microns {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0.to_int() {
            Some(whole) => serializer.serialize_i64(whole),
            None => serializer.serialize_f64(self.0.to_f64()),
        }
    }
}

/// The rates of the tool; an absent feed is found by planning.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Rates {
    /// The rates without which no time is told.
    #[serde(flatten)]
    pub main: shaft::Rates,
    /// Feed of cutting in.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub infeed: Option<MillimetresPerMinute>,
    /// Feed of picking up along the contour.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pick_up_feed: Option<MillimetresPerMinute>,
    /// Feed of the semi-finishing pass.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub semi_finishing_feed: Option<MillimetresPerMinute>,
    /// Feed of finishing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub finishing_feed: Option<MillimetresPerMinute>,
}
