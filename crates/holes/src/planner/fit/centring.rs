//! Centring: the diameter of its spot, by the rule `centre-spot`, and the edge that it makes.

use std::rc::Rc;
use technolog_note::note;

use crate::cutting::{self, Cut};
use crate::error::{KnowledgeError, Tried};
use crate::knowledge::vocabulary::ToolMaterial;
use crate::note::{Because, Note};
use crate::part::Face;
use crate::plan::{Conditions, Feature, Operation};
use crate::route::bores::EdgeCut;
use crate::route::{RouteStep, StepLocation};
use crate::shop::Shop;
use crate::tables::rules::{CentreSpot, CentreSpotFor, Spot};
use crate::units::Micrometres;

use super::{Fitted, Fitting};

/// The point angle of the centring drills (A.14: 2φ = 90°), thousandths of a degree.
const CENTRING_ANGLE: u32 = 90_000;

impl<'k> Fitting<'_, 'k> {
    /// The edge at the entry that the centring spot makes, by the rule `centre-spot`: a chamfer or a countersink of
    /// 90° around the main cylinder, where the catalogs have a centring drill wide enough.
    pub fn edge_by_centring(&self) -> Result<Option<EdgeCut>, KnowledgeError> {
        let around = self.hole.diameter.nominal;
        // A face that is cut later would remove the spot.
        if self.edges.iter().any(|edge| edge.feature == Feature::Face) {
            return Ok(None);
        }
        let edge = self.edges.iter().find(|edge| {
            edge.face == Face::Entry
                && edge.start == Micrometres::ZERO
                && matches!(edge.feature, Feature::Chamfer | Feature::Countersink)
                && edge.angle_millideg == CENTRING_ANGLE
                && edge.cylinder_diameter == around
                && edge.diameter <= self.widest_spot
        });
        let Some(edge) = edge else { return Ok(None) };
        Ok((self.spot_rule(true)?.spot == Spot::Chamfer).then_some(*edge))
    }

    fn spot_rule(&self, chamfer: bool) -> Result<CentreSpot<'k>, KnowledgeError> {
        let question = CentreSpotFor { chamfer, diameter: self.hole.diameter.nominal };
        self.shop.knowledge.ask(&question)?.need("this hole")
    }

    /// Centring: the spot by the rule `centre-spot`; its tool is chosen for the whole part.
    pub(super) fn centre(&self, step: RouteStep, drill: Micrometres) -> Tried<Fitted> {
        let edge = self.edge_by_centring()?;
        let (rule, spot, note) = match edge {
            Some(edge) => (self.spot_rule(true)?, edge.diameter, Note::new("spot-by-chamfer")),
            None => {
                // Where no centring drill is wide enough for the chamfer, the spot is that of a hole without a
                // chamfer.
                let rule = match self.spot_rule(self.hole.chamfer.is_some())? {
                    rule if rule.spot == Spot::Chamfer => self.spot_rule(false)?,
                    rule => rule,
                };
                let share = rule
                    .share
                    .ok_or_else(|| KnowledgeError::missing(&rule.row.table.id, note!("order-share-drill")))?;
                let spot = Micrometres::from_mm_rounded(drill.to_mm() * share);
                // The depth of a 90° spot is half its width: in a thin plate it stays within half of the hole.
                let most = self.hole.depth;
                if spot > most {
                    (rule, most, Note::new("spot-by-depth").with("share", share))
                } else {
                    (rule, spot, Note::new("spot-by-drill").with("share", share))
                }
            }
        };
        let note = note.with("spot", spot).with("drill", drill);
        let depth = spot.half();
        let travel = self.travels(false).0 + depth;
        let place = StepLocation { depth, through: false, ..step.place };
        let mut step = RouteStep { diameter: spot, nominal: spot, place, ..step };
        // Until the tool is chosen for the whole part, the widest of the catalogs stands for it.
        let key = (step.place, step.diameter, step.from, step.passes, travel);
        let known = self.spots.borrow().get(&key).cloned();
        let conditions = match known {
            Some(conditions) => conditions,
            None => {
                let conditions = Rc::new(self.spotting(&step, travel, self.widest_spot)?);
                self.spots.borrow_mut().insert(key, Rc::clone(&conditions));
                conditions
            }
        };
        let mut because = std::mem::take(&mut step.because);
        because.push(Because::row(rule.row, note));
        let (approach, doubts, makes_edge) = (self.travels(false).0, Vec::new(), edge.is_some());
        let took = self.pass_time(&step, travel, approach, &conditions)?;
        Ok(Fitted { step, tool: None, travel, approach, conditions, pass_time: took, doubts, makes_edge, because })
    }

    /// The conditions of centring with a drill of the diameter `tool`.
    pub fn spotting(&self, step: &RouteStep, travel: Micrometres, tool: Micrometres) -> Tried<Conditions> {
        let cut = Cut { tool_diameter: Some(tool), ..self.cut(step, None, ToolMaterial::HighSpeedSteel, travel) };
        cutting::conditions(&cut, self.shop)
    }
}

/// The widest centring drill of the catalogs.
pub fn widest_spot(shop: &Shop<'_>) -> Result<Micrometres, KnowledgeError> {
    let drills = shop.shelf.cutters_for(Operation::CentreDrill)?;
    Ok(drills.iter().filter_map(|row| row.diameter).max().unwrap_or_default())
}
