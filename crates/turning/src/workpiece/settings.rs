//! Roughing, allowances and rates.

use crate::knowledge::form::KeyOf;
use crate::knowledge::yaml::Node;
use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::reading::{Reader, given, mistake};
use crate::turning::shaft::{self, Division, Moves};
use crate::units::{Decimal, Micrometres, MillimetresPerMinute};

use super::file::{AllowancesFile, ErrorsFile, MethodFile as Method, RatesFile, RoughingFile, SteadyRestFile};
use super::{Allowances, Blank, Errors, Microns, Rates, Roughing, Scheme, SteadyRest};

/// The approach if the file gives rates and no approach, mm: a choice of the program; the lecture names δ without a
/// figure.
const APPROACH: Micrometres = Micrometres::from_mm(2);
/// The retract if the file gives rates and no retract: 0.5 mm (lecture 12.4).
const RETRACT: Micrometres = Micrometres::new(500);

impl Reader<'_> {
    /// A steady rest, which must stand on one cylinder of the blank.
    pub(super) fn steady_rest(&mut self, node: &Node, blank: &Blank) -> Option<SteadyRest> {
        let mut fields = self.problems.map(node)?;
        let z = fields.need(SteadyRestFile::z, &mut self.problems);
        let width = self.need(&mut fields, SteadyRestFile::width);
        fields.finish(&mut self.problems);
        let z_node = z?;
        let z = self.problems.scalar::<Micrometres>(z_node)?;
        let (width_mm, _) = width?;
        let mut rest = SteadyRest { z_mm: Half::ZERO - Half::of(z), width_mm, seat_mm: Micrometres::ZERO };
        let [front, back] = rest.sides();
        let stands = |piece: &&Piece| piece.is_cylinder() && piece.from.z <= front && piece.to.z >= back;
        match blank.outer.pieces.iter().find(stands) {
            Some(piece) => rest.seat_mm = piece.from.radius.diameter(),
            None => {
                let note = mistake!("rest-on-no-cylinder", from = Half::ZERO - front, to = Half::ZERO - back);
                return self.fault(note, &z_node.place);
            }
        }
        Some(rest)
    }

    pub(super) fn roughing(&mut self, node: &Node) -> Option<Roughing> {
        type F = RoughingFile;
        let mut fields = self.problems.map(node)?;
        let depth = fields.take(F::limiting_depth);
        let limiting_depth =
            given(depth, |depth| self.length(Some(depth), F::limiting_depth.name()))?.map(|depth| depth.0);
        let scheme = given(fields.take(F::scheme), |node| self.choice(node, Scheme::NAMES))?;
        fields.finish_among(&[F::limiting_depth, F::scheme], &mut self.problems);
        Some(Roughing { limiting_depth, scheme })
    }

    /// The same beside `steps:`.
    pub(super) fn depths(&mut self, node: &Node) -> Option<shaft::Roughing> {
        type F = RoughingFile;
        let mut fields = self.problems.map(node)?;
        let longitudinal = self.need(&mut fields, F::longitudinal_depth);
        let transverse = self.need(&mut fields, F::transverse_depth);
        let division = given(fields.take(F::division), |node| self.choice(node, Division::NAMES));
        let moves = given(fields.take(F::moves), |node| self.choice(node, Moves::NAMES));
        let known = [F::longitudinal_depth, F::transverse_depth, F::division, F::moves];
        fields.finish_among(&known, &mut self.problems);
        Some(shaft::Roughing {
            longitudinal_depth: longitudinal?.0,
            transverse_depth: transverse?.0,
            division: division?.unwrap_or_default(),
            moves: moves?.unwrap_or_default(),
        })
    }

    pub(super) fn allowances(&mut self, node: &Node) -> Option<Allowances> {
        let mut fields = self.problems.map(node)?;
        let method =
            fields.need(AllowancesFile::method, &mut self.problems).and_then(|node| self.choice(node, Method::NAMES));
        let mut of = |key: KeyOf<AllowancesFile>, owner: Method, reader: &mut Self| -> Option<&Node> {
            // Required by one method, useless for the others.
            let node = if method == Some(owner) { fields.need(key, &mut reader.problems) } else { fields.take(key) };
            match node {
                Some(node) if method.is_some_and(|method| method != owner) => {
                    let mistake = mistake!("allowance-of-another-method", key = key.name(), owner = owner.name());
                    reader.fault(mistake, &node.place)
                }
                node => node,
            }
        };
        let on_diameter = of(AllowancesFile::on_diameter, Method::Stated, self);
        let on_face = of(AllowancesFile::on_face, Method::Stated, self);
        let errors = of(AllowancesFile::errors, Method::Analytic, self);
        fields.finish(&mut self.problems);
        let on_diameter = on_diameter.map(|node| self.not_below_zero(node, AllowancesFile::on_diameter.name()));
        let on_face = on_face.map(|node| self.not_below_zero(node, AllowancesFile::on_face.name()));
        let errors = errors.map(|node| self.errors(node));
        match method? {
            Method::Table => Some(Allowances::Table),
            Method::Analytic => Some(Allowances::Analytic(errors??)),
            Method::Stated => Some(Allowances::Stated { on_diameter: on_diameter??, on_face: on_face?? }),
        }
    }

    fn errors(&mut self, node: &Node) -> Option<Errors> {
        let mut fields = self.problems.map(node)?;
        let mut of = |key: KeyOf<ErrorsFile>, reader: &mut Self| {
            let node = fields.need(key, &mut reader.problems)?;
            let error = reader.problems.scalar::<Decimal>(node)?;
            if error < Decimal::from_int(0) {
                return reader.fault(mistake!("below-zero", key = key.name(), length = error), &node.place);
            }
            Some(Microns::new(error))
        };
        let (rz, layer) = (of(ErrorsFile::rz_um, self), of(ErrorsFile::defect_layer_um, self));
        let (deviation, set_up) = (of(ErrorsFile::spatial_deviation_um, self), of(ErrorsFile::setup_error_um, self));
        fields.finish(&mut self.problems);
        Some(Errors { rz_um: rz?, defect_layer_um: layer?, spatial_deviation_um: deviation?, setup_error_um: set_up? })
    }

    pub(super) fn rates(&mut self, node: &Node) -> Option<Rates> {
        type F = RatesFile;
        let mut fields = self.problems.map(node)?;
        let [longitudinal, transverse, rapid] =
            [F::longitudinal_feed, F::transverse_feed, F::rapid].map(|key| self.need(&mut fields, key));
        let mut optional = |key: KeyOf<F>| given(fields.take(key), |node| Some(self.length(Some(node), key.name())?.0));
        let (approach, retract) = (optional(F::approach), optional(F::retract));
        let feeds = [F::infeed, F::pick_up_feed, F::semi_finishing_feed, F::finishing_feed].map(optional);
        fields.finish(&mut self.problems);
        let rate = |length: Micrometres| MillimetresPerMinute(length.to_mm());
        let main = shaft::Rates {
            longitudinal_feed: rate(longitudinal?.0),
            transverse_feed: rate(transverse?.0),
            rapid: rate(rapid?.0),
            approach: approach?.unwrap_or(APPROACH),
            retract: retract?.unwrap_or(RETRACT),
        };
        // A feed that cannot be read is a mistake already.
        let [infeed, pick_up_feed, semi_finishing_feed, finishing_feed] = feeds.map(|feed| feed.flatten().map(rate));
        Some(Rates { main, infeed, pick_up_feed, semi_finishing_feed, finishing_feed })
    }
}
