//! A stepped shaft as a workpiece, so that code for contours works for both forms.

use crate::turning::contour::{Contour, Piece, Profile, Side, Surface, SurfaceKind, SurfaceName};
use crate::turning::length::Half;
use crate::turning::shaft::{BlankKind, Shaft, Step};
use crate::units::Micrometres;

use super::blank::corners;
use super::{Allowances, Blank, HeatTreatment, JawKind, Rates, Roughing, StockKind, Workpiece};

impl From<&Shaft> for Workpiece {
    /// The diameters of a stepped shaft are those after roughing, so its finishing allowances are zero. Its limiting
    /// depth is the longitudinal one.
    fn from(shaft: &Shaft) -> Self {
        let kind = match shaft.blank.kind {
            BlankKind::Bar => StockKind::Bar,
            BlankKind::Forging => StockKind::Forging,
            BlankKind::Casting => StockKind::Casting,
        };
        let (radius, length) = (Half::radius_of(shaft.blank.diameter), Half::of(shaft.blank.length));
        let blank = Blank::cylinder(kind, radius, None, Half::ZERO, length).with_steps(&shaft.blank_steps);
        Self {
            name: shaft.shaft.clone(),
            material: shaft.material.clone(),
            material_state: shaft.material_state,
            blank,
            machine: shaft.machine.clone(),
            holding: shaft.holding,
            jaws: JawKind::default(),
            steady_rest: None,
            heat_treatment: HeatTreatment::default(),
            outer: outer(&shaft.steps),
            inner: None,
            threads: Vec::new(),
            roughing: Roughing { limiting_depth: Some(shaft.roughing.longitudinal_depth), scheme: None },
            allowances: Allowances::Stated { on_diameter: Micrometres::ZERO, on_face: Micrometres::ZERO },
            rates: shaft.rates.map(|main| Rates {
                main,
                infeed: None,
                pick_up_feed: None,
                semi_finishing_feed: None,
                finishing_feed: None,
            }),
            findings: Vec::new(),
        }
    }
}

fn outer(steps: &[Step]) -> Profile {
    let mut surfaces: Vec<Surface> = Vec::new();
    for piece in Contour::through(Side::Outer, &corners(Half::ZERO, steps)).pieces {
        let kind = if piece.is_face() { SurfaceKind::Face } else { SurfaceKind::Cylinder };
        // Steps of one diameter are one cylinder.
        if let Some(last) = surfaces.last_mut().filter(|last| last.kind == kind) {
            if let Some(before) = last.pieces.first_mut() {
                *before = Piece::line(before.from, piece.to);
            }
            continue;
        }
        let name = SurfaceName::Place(Side::Outer, surfaces.len() + 1);
        let pieces = vec![piece];
        surfaces.push(Surface::plain(name, kind, pieces));
    }
    Profile { side: Side::Outer, surfaces }
}
