//! Roughing, allowances and rates of the contour form.

use crate::knowledge::yaml::Node;
use crate::turning::reading::Reader;
use crate::units::{Decimal, Micrometres, MillimetresPerMinute};

use super::keys::{ALLOWANCES, ERRORS, RATES, ROUGHING};
use super::{Allowances, Errors, Microns, Rates, Roughing, Scheme};

/// How allowances are found, as files name it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Method {
    Table,
    Analytic,
    Stated,
}

impl Reader<'_> {
    pub(super) fn roughing(&mut self, node: &Node) -> Option<Roughing> {
        let mut fields = self.problems.map(node)?;
        let depth = fields.take("limiting_depth");
        let limiting_depth = match depth {
            Some(_) => Some(self.length(depth, "limiting_depth")?.0),
            None => None,
        };
        let scheme = match fields.take("scheme") {
            Some(node) => Some(self.choice(node, Scheme::NAMES)?),
            None => None,
        };
        fields.finish(ROUGHING, &mut self.problems);
        Some(Roughing { limiting_depth, scheme })
    }

    pub(super) fn allowances(&mut self, node: &Node) -> Option<Allowances> {
        let mut fields = self.problems.map(node)?;
        let methods = [("table", Method::Table), ("analytic", Method::Analytic), ("stated", Method::Stated)];
        let method = fields.need("method", &mut self.problems).and_then(|node| self.choice(node, &methods));
        let mut of = |key: &'static str, owner: Method, reader: &mut Self| -> Option<&Node> {
            // Needed by one method, and of no use to the others.
            let node = if method == Some(owner) { fields.need(key, &mut reader.problems) } else { fields.take(key) };
            match node {
                Some(node) if method.is_some_and(|method| method != owner) => {
                    let owner = if owner == Method::Stated { "stated" } else { "analytic" };
                    reader.fault("allowance-of-another-method", &[("key", &key), ("owner", &owner)], &node.place)
                }
                node => node,
            }
        };
        let on_diameter = of("on_diameter", Method::Stated, self);
        let on_face = of("on_face", Method::Stated, self);
        let errors = of("errors", Method::Analytic, self);
        fields.finish(ALLOWANCES, &mut self.problems);
        let on_diameter = on_diameter.map(|node| self.not_below_zero(node, "on_diameter"));
        let on_face = on_face.map(|node| self.not_below_zero(node, "on_face"));
        let errors = errors.map(|node| self.errors(node));
        match method? {
            Method::Table => Some(Allowances::Table),
            Method::Analytic => Some(Allowances::Analytic(errors??)),
            Method::Stated => Some(Allowances::Stated { on_diameter: on_diameter??, on_face: on_face?? }),
        }
    }

    fn errors(&mut self, node: &Node) -> Option<Errors> {
        let mut fields = self.problems.map(node)?;
        let mut of = |key: &'static str, reader: &mut Self| {
            let node = fields.need(key, &mut reader.problems)?;
            let error = reader.problems.scalar::<Decimal>(node)?;
            if error < Decimal::from_int(0) {
                return reader.fault("below-zero", &[("key", &key), ("length", &error)], &node.place);
            }
            Some(Microns::new(error))
        };
        let (rz, layer) = (of("rz_um", self), of("defect_layer_um", self));
        let (deviation, set_up) = (of("spatial_deviation_um", self), of("setup_error_um", self));
        fields.finish(ERRORS, &mut self.problems);
        Some(Errors { rz_um: rz?, defect_layer_um: layer?, spatial_deviation_um: deviation?, setup_error_um: set_up? })
    }

    pub(super) fn all_rates(&mut self, node: &Node) -> Option<Rates> {
        let mut fields = self.problems.map(node)?;
        let main = self.rates_of(&mut fields);
        let mut of = |key: &str, reader: &mut Self| {
            let node = fields.take(key)?;
            Some(reader.length(Some(node), key).map(|(feed, _): (Micrometres, _)| MillimetresPerMinute(feed.to_mm())))
        };
        let (infeed, pick_up) = (of("infeed", self), of("pick_up_feed", self));
        let (semi_finishing, finishing) = (of("semi_finishing_feed", self), of("finishing_feed", self));
        fields.finish(RATES, &mut self.problems);
        Some(Rates {
            main: main?,
            infeed: infeed.flatten(),
            pick_up_feed: pick_up.flatten(),
            semi_finishing_feed: semi_finishing.flatten(),
            finishing_feed: finishing.flatten(),
        })
    }
}
