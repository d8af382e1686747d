//! Results of formulas: floating-point numbers that carry their unit in their type.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Decimal;

macro_rules! quantities {
    ($($(#[$doc:meta])* $name:ident),* $(,)?) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Default, Serialize, Deserialize, JsonSchema)]
        #[serde(transparent)]
        pub struct $name(pub f64);

        impl $name {
            /// The larger of two.
            pub fn max(self, other: Self) -> Self {
                Self(self.0.max(other.0))
            }

            /// Rounded to `places` decimal places, half away from zero.
            pub fn rounded(self, places: u32) -> Self {
                Self(round_to(self.0, places))
            }
        }

        impl std::ops::Add for $name {
            type Output = Self;
            fn add(self, other: Self) -> Self {
                Self(self.0 + other.0)
            }
        }

        impl std::iter::Sum for $name {
            fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
                iter.fold(Self(0.0), |total, next| Self(total.0 + next.0))
            }
        }
    )*};
}

quantities! {
    /// Force, N.
    Newtons,
    /// Torque, N·m.
    NewtonMetres,
    /// Power, kW.
    Kilowatts,
    /// Cutting speed, m/min.
    MetresPerMinute,
    /// Feed per revolution, mm/rev.
    MillimetresPerRev,
    /// Feed rate, mm/min.
    MillimetresPerMinute,
    /// Angle, degrees.
    Degrees,
    /// Acceleration, mm/s².
    MillimetresPerSecondSquared,
    /// Spindle speed, 1/min.
    RevsPerMinute,
    /// Time, min.
    Minutes,
    /// Time, s.
    Seconds,
    /// Feed per tooth, mm.
    MillimetresPerTooth,
    /// Mass, kg.
    Kilograms,
    /// A share in hundredths.
    Percent,
    /// A height of roughness or depth of a layer, µm.
    Microns,
}

/// Brinell hardness, exactly as a table or a part has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Brinell(pub Decimal);

/// Stress or strength, MPa, exactly as a table or a part has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Megapascals(pub Decimal);

/// The rounding of all printed figures: to `places` decimal places, half away from zero.
pub fn round_to(value: f64, places: u32) -> f64 {
    let scale = 10_f64.powi(i32::try_from(places).unwrap_or(0));
    (value * scale).round() / scale
}
