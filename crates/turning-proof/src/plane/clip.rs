//! The part of a contour on one side of some lines. Long contours have boxes around stretches of them, so that what lies
//! far off is passed over stretch by stretch.

use i_overlay::i_float::int::point::IntPoint;

use super::region::{Contour, GRID, grid, spot};
use super::{Convex, Window};

/// The number of corners of a stretch.
const STRETCH: usize = 32;

/// Boxes around the stretches of a contour, in their order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Boxes(Vec<[IntPoint<i32>; 2]>);

impl Boxes {
    pub fn of(contour: &[IntPoint<i32>]) -> Self {
        Self(contour.chunks(STRETCH).map(boxed).collect())
    }

    pub fn window(&self) -> Window {
        Window::around(self.0.iter().flatten().copied().map(spot))
    }
}

fn boxed(stretch: &[IntPoint<i32>]) -> [IntPoint<i32>; 2] {
    let none = [IntPoint::new(i32::MAX, i32::MAX), IntPoint::new(i32::MIN, i32::MIN)];
    stretch.iter().fold(none, |[least, most], point| {
        let least = IntPoint::new(least.x.min(point.x), least.y.min(point.y));
        [least, IntPoint::new(most.x.max(point.x), most.y.max(point.y))]
    })
}

/// One side of a line: where `z`·x + `r`·y + `by` is not negative, with x and y in steps of the grid.
#[derive(Clone, Copy, Debug)]
pub struct HalfPlane {
    z: f64,
    r: f64,
    by: f64,
}

impl HalfPlane {
    /// The inner sides of a window.
    pub fn of_window(window: Window) -> Vec<Self> {
        let (least, most) = (grid(window.least), grid(window.most));
        let side = |z, r, by: i32| Self { z, r, by: f64::from(by) };
        // Not negated as a whole number: the edge of the grid has no opposite.
        let least = [side(1.0, 0.0, least.x), side(0.0, 1.0, least.y)].map(|side| Self { by: -side.by, ..side });
        let most = [side(-1.0, 0.0, most.x), side(0.0, -1.0, most.y)];
        vec![least[0], most[0], least[1], most[1]]
    }

    /// The inner sides of the window of a convex piece and of its longer edges, each moved out by two steps of the grid.
    pub fn around(piece: &Convex) -> Vec<Self> {
        const OUT: f64 = 2.0;
        /// Shorter edges than this share of the window cut off little.
        const SHARE: f64 = 0.1;
        let window = piece.window();
        let across = window.most.minus(window.least);
        let long = SHARE * SHARE * across.dot(across);
        let corners = piece.corners();
        let ends = corners.iter().zip(corners.iter().skip(1).chain(corners.first()));
        let lines = ends.map(|(from, to)| (*from, to.minus(*from)));
        let tilted = lines.filter(|(_, path)| path.dot(*path) > long).map(|(from, path)| {
            let along = path.unit();
            // Counter-clockwise: inside is to the left.
            Self { z: -along.r, r: along.z, by: (along.r * from.z - along.z * from.r) * GRID + OUT }
        });
        Self::of_window(window.grown(OUT / GRID)).into_iter().chain(tilted).collect()
    }

    fn measure(self, point: IntPoint<i32>) -> f64 {
        self.z * f64::from(point.x) + self.r * f64::from(point.y) + self.by
    }

    /// Whether it has nothing of a box.
    fn misses(self, [least, most]: [IntPoint<i32>; 2]) -> bool {
        let x = if self.z > 0.0 { most.x } else { least.x };
        let y = if self.r > 0.0 { most.y } else { least.y };
        self.measure(IntPoint::new(x, y)) < 0.0
    }
}

/// The part of a contour on the inner side of all lines; none if nothing is left.
pub fn clipped(contour: &[IntPoint<i32>], boxes: &Boxes, sides: &[HalfPlane]) -> Option<Contour> {
    let mut kept = reduced(contour, boxes, sides);
    for side in sides {
        if kept.len() < 3 {
            return None;
        }
        kept = cut(&kept, *side);
    }
    (kept.len() > 2).then_some(kept)
}

/// A contour of which the same is left: of stretches on the outer side of one line only the ends are kept.
fn reduced(contour: &[IntPoint<i32>], boxes: &Boxes, sides: &[HalfPlane]) -> Contour {
    let mut kept = Contour::with_capacity(contour.len().min(4 * STRETCH));
    let mut beyond: Option<HalfPlane> = None;
    for (stretch, around) in contour.chunks(STRETCH).zip(&boxes.0) {
        let goes_on = beyond.filter(|side| side.misses(*around));
        beyond = goes_on.or_else(|| sides.iter().copied().find(|side| side.misses(*around)));
        match (beyond, stretch) {
            (Some(_), [first, .., last]) => {
                if goes_on.is_some() {
                    kept.pop();
                } else {
                    kept.push(*first);
                }
                kept.push(*last);
            }
            _ => kept.extend(stretch),
        }
    }
    kept
}

/// The part of a contour on the inner side of a line.
fn cut(contour: &[IntPoint<i32>], side: HalfPlane) -> Contour {
    let Some(&last) = contour.last() else { return Contour::new() };
    let mut kept = Contour::with_capacity(contour.len() + 4);
    let (mut before, mut was) = (last, side.measure(last));
    for &here in contour {
        let is = side.measure(here);
        if (was < 0.0) != (is < 0.0) {
            let part = was / (was - is);
            let between = |a: i32, b: i32| (f64::from(a) + (f64::from(b) - f64::from(a)) * part).round() as i32;
            kept.push(IntPoint::new(between(before.x, here.x), between(before.y, here.y)));
        }
        if is >= 0.0 {
            kept.push(here);
        }
        (before, was) = (here, is);
    }
    kept
}
