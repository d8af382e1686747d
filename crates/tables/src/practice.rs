//! Row types: what shops reach, whatever a drawing asks.

use technolog_knowledge::rows;
use technolog_knowledge::units::{ItGrade, Micrometres, Microns};

use crate::rules::ReamingCase;

rows! {
    /// What a way of working reaches on an ordinary machine tool.
    pub struct ReachOfTransition of One("reach-of-transition") asked by ReachOfTransitionFor<'t> {
        way: &'t str,
        diameter: Micrometres,
    } {
        it_best: Option<ItGrade>,
        it_ordinary: Option<ItGrade>,
        ra_best: Microns,
        ra_ordinary: Microns,
    } shown { thread_best, thread_ordinary, sources }

    /// Position error of the axis by way of working.
    pub struct HolePositionReach of One("hole-position-reach") asked by HolePositionReachFor<'t> {
        way: &'t str,
    } {
        follows: bool,
        error_best: Option<Micrometres>,
        error_ordinary: Option<Micrometres>,
    }

    /// Drift of the axis of a drilled hole.
    pub struct DrillDrift of One("drill-drift") asked by DrillDriftFor {
        diameter: Micrometres,
    } {
        drift: f64,
    } shown { offset }

    /// Stock before reaming, on diameter.
    pub struct StockBeforeReaming of One("stock-before-reaming") asked by StockBeforeReamingFor {
        case: ReamingCase,
        diameter: Micrometres,
    } {
        stock_min: Micrometres,
        stock_max: Micrometres,
    } shown { american_min, american_max, european_min, european_max, soviet_min, soviet_max, pages }
}
