//! The blank of a turned part, and its preparation before it comes to the lathe (lecture 12.1).

use serde::Serialize;

use crate::turning::contour::{Contour, Side};
use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::shaft::Step;
use crate::units::Micrometres;

pub use super::preparation::{Advice, advice};
pub use crate::tables::turning::part::StockKind;

/// The blank, in the coordinates of the part: Z = 0 is the finished face of the free end.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Blank {
    /// Its kind.
    pub kind: StockKind,
    /// Its outside, from the axis or its bore at the free end; that of a bar or tube ends at its full diameter.
    pub outer: Contour,
    /// Its bore.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inner: Option<Contour>,
    /// The permitted deviation of its length, mm, if the file gives it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length_tolerance: Option<Micrometres>,
}

impl Blank {
    /// A bar or tube: its radius, that of its bore, the stock on the face of the free end, and its whole length.
    pub fn cylinder(kind: StockKind, radius: Half, bore: Option<Half>, face: Half, length: Half) -> Self {
        let (start, end) = (Half::ZERO - face, length - face);
        let at = |radius, z| Point { radius, z };
        let within = bore.unwrap_or(Half::ZERO);
        Self {
            kind,
            outer: Contour::through(Side::Outer, &[at(within, start), at(radius, start), at(radius, end)]),
            inner: bore.map(|bore| Contour::through(Side::Inner, &[at(bore, start), at(bore, end)])),
            length_tolerance: None,
        }
    }

    /// The same with steps from the free end, if there are any; behind them it has its full diameter.
    #[must_use]
    pub fn with_steps(self, steps: &[Step]) -> Self {
        if steps.is_empty() {
            return self;
        }
        let (radius, end) = (Half::radius_of(self.largest_diameter()), self.end());
        let mut points = corners(Half::ZERO - self.face(), steps);
        if let Some(last) = points.last().copied().filter(|last| last.z < end) {
            points.extend([Point { radius, z: last.z }, Point { radius, z: end }]);
        }
        Self { outer: Contour::through(Side::Outer, &points), ..self }
    }

    /// The stock on the finished face of the free end.
    pub fn face(&self) -> Half {
        Half::ZERO - self.outer.start().map_or(Half::ZERO, |start| start.z)
    }

    /// Z of its far end.
    pub fn end(&self) -> Half {
        self.outer.end().map_or(Half::ZERO, |end| end.z)
    }

    /// Its outside, or its bore if it has one.
    pub const fn contour(&self, side: Side) -> Option<&Contour> {
        match side {
            Side::Outer => Some(&self.outer),
            Side::Inner => self.inner.as_ref(),
        }
    }

    /// Its whole length.
    pub fn length(&self) -> Half {
        self.end() + self.face()
    }

    /// Its largest diameter.
    pub fn largest_diameter(&self) -> Micrometres {
        self.outer.radii().map_or(Micrometres::ZERO, |(_, most)| most.diameter())
    }
}

/// The corners of steps, from the axis at the free end.
pub(super) fn corners(begins: Half, steps: &[Step]) -> Vec<Point> {
    let mut z = begins;
    let mut points = vec![Point { radius: Half::ZERO, z }];
    for step in steps {
        let radius = Half::radius_of(step.diameter);
        points.push(Point { radius, z });
        z = z + Half::of(step.length);
        points.push(Point { radius, z });
    }
    points
}
