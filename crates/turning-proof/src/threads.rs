//! How much of the length of a thread its passes cut to the depth.

use crate::carry::TOLERANCE;
use crate::plane::Vector;
use crate::target::Threaded;

/// How long a stretch of a thread may lack its depth, in pitches: the profile of the last turn is half a pitch wide to each side
/// of the point that cuts it.
const SPARE: f64 = 0.5;

impl Threaded {
    /// The stretch along Z in which a straight pass is deep enough, ascending; a pass that is drawn out is so up to there.
    pub(crate) fn deep(&self, from: Vector, to: Vector) -> Option<[f64; 2]> {
        let (crest, shallow) = (self.thread.crest.0, self.thread.shallow.0);
        let beyond = |radius: f64| (radius - shallow) * (shallow - crest).signum() + TOLERANCE;
        let (first, last) = (beyond(from.r), beyond(to.r));
        let turns = || from.z + (to.z - from.z) * first / (first - last);
        let [one, other] = match (first >= 0.0, last >= 0.0) {
            (true, true) => [from.z, to.z],
            (true, false) => [from.z, turns()],
            (false, true) => [turns(), to.z],
            (false, false) => return None,
        };
        Some([one.min(other), one.max(other)])
    }

    /// The longest stretch that none of these covers, ascending; none if it is within the last turn.
    pub(crate) fn widest_gap(&self, full: &[[f64; 2]]) -> Option<[f64; 2]> {
        let [end, begin] = self.z;
        let mut full: Vec<[f64; 2]> = full.to_vec();
        full.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let (mut known, mut widest) = (end, [end, end]);
        for [least, most] in full.into_iter().chain([[begin, begin]]) {
            let gap = [known, least.min(begin)];
            if gap[1] - gap[0] > widest[1] - widest[0] {
                widest = gap;
            }
            known = known.max(most);
        }
        (widest[1] - widest[0] > SPARE * self.thread.pitch.0 + TOLERANCE).then_some(widest)
    }
}
