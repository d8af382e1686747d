//! The handbook's power laws of drills, core drills and reamers, from their rows.

use crate::error::Tried;
use crate::knowledge::vocabulary::ToolMaterial;
use crate::reason::Uncut;
use crate::tables::cutting::{Coefficients, CuttingSpeed, CuttingSpeedFor, TorqueAndThrust, TorqueAndThrustFor};
use crate::units::MillimetresPerRev;

use super::figures::{self, Asking, Figures};

/// V = Cv·D^q / (T^m·t^x·s^y), m/min (Косилова/Мещеряков т.2, tables 28 and 29; facts 1.1, 1.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedLaw {
    /// Cv.
    pub cv: f64,
    /// Exponent of the diameter.
    pub q: f64,
    /// Exponent of the depth of cut; 0 in drilling.
    pub x: f64,
    /// Exponent of the feed.
    pub y: f64,
    /// Exponent of the tool life.
    pub m: f64,
}

impl SpeedLaw {
    /// The law of a row.
    pub const fn of(row: &CuttingSpeed<'_>) -> Self {
        let &CuttingSpeed { cv, q, x, y, m, .. } = row;
        Self { cv, q, x, y, m }
    }

    /// The speed, m/min: diameter and depth of cut in mm, feed in mm/rev, tool life in min.
    pub fn at(&self, diameter: f64, depth_of_cut: f64, feed: f64, life: f64) -> f64 {
        self.cv * libm::pow(diameter, self.q)
            / (libm::pow(life, self.m) * libm::pow(depth_of_cut, self.x) * libm::pow(feed, self.y))
    }

    /// The tool life at another speed than that of `life`, min: T·(V/V1)^(1/m).
    pub fn life_at(&self, life: f64, speed: f64, other: f64) -> f64 {
        life * libm::pow(speed / other, 1.0 / self.m)
    }
}

/// 10·C·D^q·t^x·s^y: torque in N·m with Cm, thrust in N with Cp (table 32; facts 1.4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadLaw {
    /// 10·Cm or 10·Cp.
    pub factor: f64,
    /// Exponent of the diameter.
    pub q: f64,
    /// Exponent of the depth of cut.
    pub x: f64,
    /// Exponent of the feed.
    pub y: f64,
}

impl LoadLaw {
    /// The law of the torque of a row: its 10 makes N·m of kgf·m.
    pub const fn torque(row: &TorqueAndThrust<'_>) -> Self {
        Self { factor: 10.0 * row.cm, q: row.qm, x: row.xm, y: row.ym }
    }

    /// The law of the thrust of a row.
    pub const fn thrust(row: &TorqueAndThrust<'_>) -> Self {
        Self { factor: 10.0 * row.cp, q: row.qp, x: row.xp, y: row.yp }
    }

    /// The load, N or N·m: diameter and depth of cut in mm, feed in mm/rev.
    pub fn at(&self, diameter: f64, depth_of_cut: f64, feed: f64) -> f64 {
        self.without_feed(diameter, depth_of_cut) * libm::pow(feed, self.y)
    }

    /// The factor on the power of the feed.
    pub(super) fn without_feed(&self, diameter: f64, depth_of_cut: f64) -> f64 {
        self.factor * libm::pow(diameter, self.q) * libm::pow(depth_of_cut, self.x)
    }
}

/// The law of the speed with its row.
pub(super) fn speed<'k>(
    operation: Coefficients,
    tool_material: ToolMaterial,
    feed: MillimetresPerRev,
    shop: &impl Asking<'k>,
) -> Tried<(SpeedLaw, Figures<'k, CuttingSpeed<'k>>), Uncut> {
    let question = |material_group| CuttingSpeedFor { operation, material_group, tool_material, feed };
    let figures = figures::ask(question, shop)?;
    Ok((SpeedLaw::of(&figures.row), figures))
}

/// The laws of torque and thrust with their row.
pub(super) fn loads<'k>(
    operation: Coefficients,
    tool_material: ToolMaterial,
    shop: &impl Asking<'k>,
) -> Tried<(LoadLaw, LoadLaw, Figures<'k, TorqueAndThrust<'k>>), Uncut> {
    let question = |material_group| TorqueAndThrustFor { operation, material_group, tool_material };
    let figures = figures::ask(question, shop)?;
    Ok((LoadLaw::torque(&figures.row), LoadLaw::thrust(&figures.row), figures))
}
