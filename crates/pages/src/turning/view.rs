//! The half section on a page: the free end on the right, as on a lathe, the axis below.

use std::fmt::Write;

use super::super::canvas::{At, Canvas, Pen};
use technolog_turning::contour::{Curve, Piece, Turn};
use technolog_turning::length::Half;
use technolog_turning::point::Point;
use technolog_turning::toolpath::{Purpose, Toolpath};

/// A part of the half section on the page.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    /// The position of radius 0, Z 0.
    origin: At,
    /// Units of the page for a millimetre.
    scale: f64,
}

impl View {
    /// The view of the rectangle between two corners (first the one nearest to the axis and the free end), within a
    /// box of the page.
    pub(super) fn within(near: Point, far: Point, left: f64, top: f64, wide: f64, tall: f64) -> Self {
        let size = near.to(far);
        let scale = (wide / size.z.max(0.001)).min(tall / size.radius.max(0.001));
        let right = left + (wide + size.z * scale) / 2.0;
        let bottom = top + size.radius * scale;
        let origin = (right + near.z.to_mm() * scale, bottom + near.radius.to_mm() * scale);
        Self { origin, scale }
    }

    /// The position of a point.
    pub(super) fn at(&self, point: Point) -> At {
        (self.origin.0 - point.z.to_mm() * self.scale, self.origin.1 - point.radius.to_mm() * self.scale)
    }

    /// The length on the page.
    pub(super) fn long(&self, length: Half) -> f64 {
        length.to_mm() * self.scale
    }

    /// Pieces as an SVG path; each chain of them begins anew.
    fn path(&self, pieces: impl IntoIterator<Item = Piece>) -> String {
        let mut path = String::new();
        let mut here: Option<Point> = None;
        for piece in pieces {
            if here != Some(piece.from) {
                let (x, y) = self.at(piece.from);
                // Writing to a text cannot fail.
                let _ = write!(path, "M{x:.2} {y:.2}");
            }
            let (x, y) = self.at(piece.to);
            let _ = match piece.curve {
                Curve::Line => write!(path, "L{x:.2} {y:.2}"),
                Curve::Arc { radius, turn } => {
                    let radius = self.long(radius);
                    // Z goes to the left here, so a left turn is clockwise on the page.
                    let sweep = u8::from(turn == Turn::Left);
                    write!(path, "A{radius:.3} {radius:.3} 0 0 {sweep} {x:.2} {y:.2}")
                }
            };
            here = Some(piece.to);
        }
        path
    }

    /// Pieces as a line.
    pub(super) fn line(&self, canvas: &mut Canvas, pieces: impl IntoIterator<Item = Piece>, pen: Pen) {
        let path = self.path(pieces);
        if !path.is_empty() {
            canvas.path(&path, pen);
        }
    }

    /// Pieces as the edge of an area, closed straight.
    pub(super) fn area(&self, canvas: &mut Canvas, pieces: impl IntoIterator<Item = Piece>, fill: &str) {
        let path = self.path(pieces);
        if !path.is_empty() {
            canvas.push_element(format_args!("<path d=\"{path}Z\" fill=\"{fill}\" fill-rule=\"evenodd\"/>"));
        }
    }

    /// A toolpath, each move with the pen of its purpose and an arrow in its middle.
    pub(super) fn toolpath(&self, canvas: &mut Canvas, path: &Toolpath) {
        for (piece, purpose) in path.pieces() {
            let pen = pen_of(purpose);
            self.line(canvas, [piece], pen);
            let (from, to) = (self.at(piece.from), self.at(piece.to));
            if piece.curve == Curve::Line && libm::hypot(to.0 - from.0, to.1 - from.1) > 26.0 {
                let middle = ((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0);
                canvas.head(from, middle, pen);
            }
        }
    }
}

/// The pen of a move.
pub(super) const fn pen_of(purpose: Purpose) -> Pen {
    match purpose {
        Purpose::Rapid => Pen::dashed("#999999", 0.9),
        Purpose::Cut => Pen::solid("#0072b2", 1.3),
        Purpose::Infeed => Pen::solid("#e69f00", 1.3),
        Purpose::PickUp => Pen::solid("#d55e00", 1.3),
        Purpose::SemiFinish => Pen::solid("#009e73", 1.5),
        Purpose::Finish => Pen::solid("#000000", 1.5),
        Purpose::Return => Pen::solid("#cc79a7", 1.0),
        Purpose::Plunge => Pen::solid("#e69f00", 1.8),
        Purpose::Thread => Pen::solid("#56b4e9", 1.3),
    }
}
