//! Regions of the half-plane, on a grid on which their sums and differences are exact.

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::{IntOverlayOptions, Overlay, ShapeType};
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::i_float::int::point::IntPoint;

use super::clip::{Boxes, HalfPlane, clipped};
use super::{Convex, Vector, Window};

/// Steps of the grid in a millimetre: 10 nm, a five-hundredth of the tolerance of findings.
pub(super) const GRID: f64 = 100_000.0;

/// Smaller regions are dropped, in cells of the grid: 10⁻⁶ mm², such as 5 µm by 0.2 µm.
const CRUMB: u64 = 10_000;

/// A closed chain of corners on the grid.
pub(super) type Contour = Vec<IntPoint<i32>>;

/// An operation on two regions.
#[derive(Clone, Copy, Debug)]
pub enum Rule {
    Both,
    Without,
    Either,
}

/// A region: its contours are counter-clockwise, those of its holes clockwise.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Region {
    contours: Vec<Contour>,
    windows: Vec<Window>,
    boxes: Vec<Boxes>,
}

pub(super) fn grid(spot: Vector) -> IntPoint<i32> {
    IntPoint::new((spot.z * GRID).round() as i32, (spot.r * GRID).round() as i32)
}

pub(super) fn spot(point: IntPoint<i32>) -> Vector {
    Vector::new(f64::from(point.x) / GRID, f64::from(point.y) / GRID)
}

impl Region {
    fn of(contours: Vec<Contour>) -> Self {
        let boxes: Vec<Boxes> = contours.iter().map(|contour| Boxes::of(contour)).collect();
        let windows = boxes.iter().map(Boxes::window).collect();
        Self { contours, windows, boxes }
    }

    /// The area enclosed by closed chains, in whichever direction they run.
    pub fn enclosed(chains: impl IntoIterator<Item = Vec<Vector>>) -> Self {
        let mut all = Self::default();
        for chain in chains {
            let mut contour: Contour = chain.into_iter().map(grid).collect();
            let area: f64 = edges(&contour).map(|(a, b)| a.cross(b)).sum();
            if area < 0.0 {
                contour.reverse();
            }
            all = all.made(&Self::of(vec![contour]), Rule::Either);
        }
        all
    }

    /// The union of convex pieces; they may overlap.
    pub fn pieces<'c>(pieces: impl IntoIterator<Item = &'c Convex>) -> Self {
        Self::of(pieces.into_iter().map(|piece| piece.corners().iter().copied().map(grid).collect()).collect())
    }

    pub fn is_empty(&self) -> bool {
        self.contours.is_empty()
    }

    pub fn window(&self) -> Window {
        self.windows.iter().fold(Window::NONE, |all, one| all.with(*one))
    }

    /// The intersection, the difference, or the union with another.
    #[must_use]
    pub fn made(&self, other: &Self, rule: Rule) -> Self {
        match rule {
            _ if !self.window().meets(other.window()) && !matches!(rule, Rule::Either) => {
                return if matches!(rule, Rule::Both) { Self::default() } else { self.clone() };
            }
            Rule::Either if other.is_empty() => return self.clone(),
            _ => {}
        }
        let rule = match rule {
            Rule::Both => OverlayRule::Intersect,
            Rule::Without => OverlayRule::Difference,
            Rule::Either => OverlayRule::Union,
        };
        let count = self.corners() + other.corners();
        let options = IntOverlayOptions { min_output_area: CRUMB, ..IntOverlayOptions::default() };
        let mut overlay = Overlay::<i32>::new_custom(count, options, Default::default());
        overlay.add_source(&self.contours, ShapeType::Subject);
        overlay.add_source(&other.contours, ShapeType::Clip);
        Self::of(overlay.overlay(rule, FillRule::NonZero).into_iter().flatten().collect())
    }

    /// Its corners, contour by contour.
    pub fn chains(&self) -> impl Iterator<Item = Vec<Vector>> {
        self.contours.iter().map(|contour| contour.iter().map(|&point| spot(point)).collect())
    }

    /// Its edges.
    pub fn edges(&self) -> impl Iterator<Item = (Vector, Vector)> {
        self.contours.iter().flat_map(|contour| edges(contour))
    }

    /// Each connected piece separately, without its holes.
    pub fn outer_pieces(&self) -> impl Iterator<Item = Self> {
        let outer = |contour: &&Contour| edges(contour).map(|(a, b)| a.cross(b)).sum::<f64>() > 0.0;
        self.contours.iter().filter(outer).map(|contour| Self::of(vec![contour.clone()]))
    }

    /// The part of it inside a window. Along the window's edges lines may run there and back.
    #[must_use]
    pub fn within(&self, window: Window) -> Self {
        let sides = HalfPlane::of_window(window);
        Self::of(self.near(window).filter_map(|(contour, boxes)| clipped(contour, boxes, &sides)).collect())
    }

    /// The part of it around some pieces, which lie in a window: of one piece what lies near its own edges.
    #[must_use]
    pub fn about(&self, pieces: &[Convex], window: Window) -> Self {
        let [piece] = pieces else { return self.within(window) };
        let sides = HalfPlane::around(piece);
        Self::of(self.near(piece.window()).filter_map(|(contour, boxes)| clipped(contour, boxes, &sides)).collect())
    }

    /// With the contours of another, which may overlap: what is taken off need not be united.
    #[must_use]
    pub fn beside(mut self, other: Self) -> Self {
        self.contours.extend(other.contours);
        self.windows.extend(other.windows);
        self.boxes.extend(other.boxes);
        self
    }

    /// Whether some of it may lie within a convex piece. Only its longer edges are looked at, and these generously: where it says
    /// that there is nothing, there is nothing.
    pub fn may_meet(&self, piece: &Convex) -> bool {
        let sides = HalfPlane::around(piece);
        self.near(piece.window()).any(|(contour, boxes)| clipped(contour, boxes, &sides).is_some())
    }

    /// The contours whose windows meet another one.
    fn near(&self, window: Window) -> impl Iterator<Item = (&Contour, &Boxes)> {
        let all = self.contours.iter().zip(&self.boxes).zip(&self.windows);
        all.filter(move |(_, around)| around.meets(window)).map(|(contour, _)| contour)
    }

    /// How many corners it has.
    pub fn corners(&self) -> usize {
        self.contours.iter().map(Vec::len).sum()
    }

    /// Whether a point is inside it.
    pub fn holds(&self, place: Vector) -> bool {
        let mut winding = 0;
        for (a, b) in self.edges() {
            let left = b.minus(a).cross(place.minus(a));
            if a.r <= place.r && b.r > place.r && left > 0.0 {
                winding += 1;
            } else if a.r > place.r && b.r <= place.r && left < 0.0 {
                winding -= 1;
            }
        }
        winding != 0
    }

    /// Its area, mm².
    pub fn area(&self) -> f64 {
        self.edges().map(|(a, b)| a.cross(b)).sum::<f64>() / 2.0
    }

    /// The length of its edges, mm.
    pub fn around(&self) -> f64 {
        self.edges().map(|(a, b)| b.minus(a).length()).sum()
    }

    /// Its volume of revolution about the axis, mm³ (Pappus: 2π times its static moment, edge by edge).
    pub fn turned_volume(&self) -> f64 {
        std::f64::consts::TAU / 6.0 * self.edges().map(|(a, b)| a.cross(b) * (a.r + b.r)).sum::<f64>()
    }

    /// Mirrored along the axis: z becomes `about` − z.
    #[must_use]
    pub fn mirrored(&self, about: f64) -> Self {
        let mirror = |contour: Vec<Vector>| {
            let mut contour: Contour = contour.iter().map(|spot| grid(Vector::new(about - spot.z, spot.r))).collect();
            contour.reverse();
            contour
        };
        Self::of(self.chains().map(mirror).collect())
    }
}

fn edges(contour: &[IntPoint<i32>]) -> impl Iterator<Item = (Vector, Vector)> {
    let shifted = contour.iter().skip(1).chain(contour.first());
    contour.iter().zip(shifted).map(|(&a, &b)| (spot(a), spot(b)))
}
