//! The output form of a path: points with names, lengths and time.

use serde::Serialize;

use crate::turning::length::Half;
use crate::turning::numbering::Numbering;
use crate::turning::point::Point;
use crate::turning::shaft::Rates;
use crate::units::{MillimetresPerMinute, Minutes, round_to};

use super::levels::Levels;
use super::path::{Motion, Vertex, VertexRole};

/// A point of the path.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SchemePoint {
    /// Its name: `A` is home, the corners of the rough contour have the first numbers from the free end, and the other
    /// points the next ones in the order of the first visit, as in the figures of the lecture. A point that is visited
    /// again keeps its name.
    pub name: String,
    /// Its position, its role and the motion to it.
    #[serde(flatten)]
    pub vertex: Vertex,
}

/// The points of a path with their names.
pub fn points(path: &[Vertex], levels: &Levels) -> Vec<SchemePoint> {
    let mut numbers = Numbering::after(0);
    for cylinder in &levels.cylinders {
        numbers.number(Point { radius: cylinder.radius, z: cylinder.from });
    }
    let point = |vertex: &Vertex| {
        let name = if vertex.role == VertexRole::Home { "A".to_owned() } else { numbers.name(vertex.at) };
        SchemePoint { name, vertex: *vertex }
    };
    path.iter().map(point).collect()
}

/// The measures of a path.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SchemeMeasures {
    /// Length at the working feed in metal, faces of the contour included, mm.
    pub cutting_mm: Half,
    /// All other motion: rapids, and the approach δ at the working feed, mm.
    pub idle_mm: f64,
    /// Feeds and rapids together.
    pub time_min: Minutes,
    /// Motions along the axis at the working feed.
    pub passes: usize,
}

/// Measures a path. A rapid moves both axes at once, so its time is that of the longer motion.
pub fn measure(path: &[Vertex], rates: &Rates) -> SchemeMeasures {
    let (mut cutting, mut idle, mut time, mut passes) = (Half::ZERO, 0.0, 0.0, 0);
    for (before, vertex) in path.iter().zip(path.iter().skip(1)) {
        let across = (vertex.at.radius - before.at.radius).halves().abs();
        let along = (vertex.at.z - before.at.z).halves().abs();
        let minutes = |halves: i64, rate: MillimetresPerMinute| Half::new(halves).to_mm() / rate.0;
        match vertex.motion {
            Motion::Rapid => {
                idle += libm::hypot(Half::new(across).to_mm(), Half::new(along).to_mm());
                time += minutes(across.max(along), rates.rapid);
            }
            Motion::Along => {
                cutting = cutting + Half::new(along) - vertex.air;
                idle += vertex.air.to_mm();
                time += minutes(along, rates.longitudinal_feed);
                passes += 1;
            }
            Motion::Across => {
                cutting = cutting + Half::new(across);
                time += minutes(across, rates.transverse_feed);
            }
        }
    }
    SchemeMeasures { cutting_mm: cutting, idle_mm: round_to(idle, 3), time_min: Minutes(round_to(time, 4)), passes }
}
