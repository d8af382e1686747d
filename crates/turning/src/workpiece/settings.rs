//! Roughing, allowances and rates of the contour form.

use crate::knowledge::form::KeyOf;
use crate::knowledge::yaml::Node;
use crate::turning::contour::Piece;
use crate::turning::length::Half;
use crate::turning::reading::{Reader, given, mistake};
use crate::units::{Decimal, Micrometres, MillimetresPerMinute};

use super::file::{AllowancesFile, ContourRates, ContourRoughing, ErrorsFile, MethodFile as Method, SteadyRestFile};
use super::{Allowances, Blank, Errors, Microns, Rates, Roughing, Scheme, SteadyRest};

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
        let mut fields = self.problems.map(node)?;
        let depth = fields.take(ContourRoughing::limiting_depth);
        let limiting_depth = given(depth, |depth| self.length(Some(depth), ContourRoughing::limiting_depth.name()))?
            .map(|depth| depth.0);
        let scheme = given(fields.take(ContourRoughing::scheme), |node| self.choice(node, Scheme::NAMES))?;
        fields.finish(&mut self.problems);
        Some(Roughing { limiting_depth, scheme })
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

    pub(super) fn all_rates(&mut self, node: &Node) -> Option<Rates> {
        let mut fields = self.problems.map(node)?;
        let keys = [
            ContourRates::longitudinal_feed,
            ContourRates::transverse_feed,
            ContourRates::rapid,
            ContourRates::approach,
            ContourRates::retract,
        ];
        let main = self.rates_of(&mut fields, keys);
        let mut of = |key: KeyOf<ContourRates>, reader: &mut Self| {
            let node = fields.take(key)?;
            Some(
                reader
                    .length(Some(node), key.name())
                    .map(|(feed, _): (Micrometres, _)| MillimetresPerMinute(feed.to_mm())),
            )
        };
        let (infeed, pick_up) = (of(ContourRates::infeed, self), of(ContourRates::pick_up_feed, self));
        let (semi_finishing, finishing) =
            (of(ContourRates::semi_finishing_feed, self), of(ContourRates::finishing_feed, self));
        fields.finish(&mut self.problems);
        Some(Rates {
            main: main?,
            infeed: infeed.flatten(),
            pick_up_feed: pick_up.flatten(),
            semi_finishing_feed: semi_finishing.flatten(),
            finishing_feed: finishing.flatten(),
        })
    }
}
