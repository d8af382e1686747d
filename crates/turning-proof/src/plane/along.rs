//! Things found by where they lie along the axis.

/// Places in a list of things by their stretches along the axis: the whole range is divided into as many bins as there are
/// things, and each thing is in every bin that it touches.
#[derive(Clone, Debug)]
pub struct AlongAxis {
    from: f64,
    width: f64,
    bins: Vec<Vec<usize>>,
}

impl AlongAxis {
    /// By the ends of each thing, mm; the lower one first.
    pub fn of(stretches: impl Iterator<Item = [f64; 2]> + Clone) -> Self {
        let whole = stretches
            .clone()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |all, one| [all[0].min(one[0]), all[1].max(one[1])]);
        let count = stretches.clone().count().max(1);
        let width = ((whole[1] - whole[0]) / count as f64).max(1e-6);
        let mut along = Self { from: whole[0], width, bins: vec![Vec::new(); count] };
        for (place, [low, high]) in stretches.enumerate() {
            for bin in along.range(low, high) {
                along.bins[bin].push(place);
            }
        }
        along
    }

    /// The places of all things that may lie between two ends, ascending.
    pub fn between(&self, low: f64, high: f64) -> Vec<usize> {
        let mut places: Vec<usize> = self.bins[self.range(low, high)].iter().flatten().copied().collect();
        places.sort_unstable();
        places.dedup();
        places
    }

    fn range(&self, low: f64, high: f64) -> std::ops::RangeInclusive<usize> {
        // What lies beyond an end is in the bin there.
        let bin = |z: f64| (((z - self.from) / self.width).max(0.0) as usize).min(self.bins.len() - 1);
        bin(low)..=bin(high)
    }
}
