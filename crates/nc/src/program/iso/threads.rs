//! Motions that go with the turns of the spindle, G33 and G33.1 of LinuxCNC, and towards a probe, G38.2 to G38.5.

use super::block::Maker;
use super::control::Group;
use super::words::BlockWords;
use crate::motion::{Motion, Turning};
use crate::program::TextSpan;
use crate::units::MillimetresPerMinute;

impl Maker<'_> {
    /// G33 goes to a point by K for each turn; G33.1 comes back by as much with the spindle turned round.
    pub(super) fn thread(&mut self, words: &BlockWords, comes_back: bool) {
        let pitch = self.take(words, 'K');
        let start = (self.state.at, self.state.floating, self.state.lost);
        let target = self.target(words, false);
        let Some(span) = target.span else { return };
        let Some(feed) = self.by_turns(pitch.map(|pitch| pitch.exact_mm(self.state.inches())), span) else { return };
        self.go(feed.clone(), target.at, target.floating, span);
        self.state.lost = target.lost;
        if !comes_back {
            return;
        }
        let before = self.state.turning;
        self.spindle(if before == Turning::Clockwise { Turning::Counterclockwise } else { Turning::Clockwise });
        self.go(feed, start.0, start.1, span);
        self.state.lost = start.2;
        self.spindle(before);
    }

    /// The feed of a pitch, mm; none, and told, where there is no pitch or the spindle stands.
    fn by_turns(&mut self, pitch: Option<f64>, span: TextSpan) -> Option<Motion> {
        if self.machine.is_some_and(|machine| !machine.can_tap) {
            self.fault("cannot-tap", span);
        }
        if self.state.turning == Turning::Stopped {
            self.fault("tap-without-spindle", span);
        }
        let feed = pitch.unwrap_or_default() * self.state.speed * self.setting.speed_override as f64 / 100.0;
        if feed <= 0.0 {
            self.fault("feed-zero", span);
        }
        (!self.broken()).then_some(Motion::Feed { feed_mm_per_min: MillimetresPerMinute(feed) })
    }

    /// A way towards a probe, traced to its end as if nothing were touched; that it may end before is told.
    pub(super) fn probe(&mut self, words: &BlockWords) {
        if let Some(function) = words.function(Group::Motion) {
            self.not_carried_out(function, &function.name());
        }
        let target = self.target(words, false);
        let Some(span) = target.span else { return };
        let feed = self.state.feed * self.setting.feed_override as f64 / 100.0;
        if feed <= 0.0 {
            self.fault("feed-zero", span);
        }
        self.go(Motion::Feed { feed_mm_per_min: MillimetresPerMinute(feed) }, target.at, target.floating, span);
        self.state.lost = target.lost;
    }
}
