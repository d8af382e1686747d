//! The stock as a staircase on a grid of lines, and the passes that cut its corners.

use crate::note::Note;
use crate::turning::length::Half;

use super::super::cost::Objective;
use super::super::grid::Grid;
use super::super::pass::{Pass, PassDirection};
use crate::turning::point::Point;

/// The lines on which passes run and stop.
///
/// Between two shoulders they lie at full depths from the outer (or nearer) one, like the levels and slices of the
/// paper, and at full depths from the inner (or farther) one, so that the thin rest of a division can be cut first,
/// last or between.
#[derive(Clone, Debug)]
pub struct Lines {
    /// Radii from the bar inwards.
    pub radii: Vec<Half>,
    /// Z from the free end.
    pub zs: Vec<Half>,
    /// For each column between two lines of Z, the line of radii of the part.
    pub floor: Vec<u16>,
    /// For each column and line of radii, the least cost of the stock from there down to the part, times the depth
    /// across.
    over: Vec<Vec<u128>>,
    /// For each row between two lines of radii, the first column of the part.
    reach: Vec<usize>,
    longitudinal_depth: Half,
    transverse_depth: Half,
}

/// For each column the line of radii of the stock. Lines are numbered inwards, so the numbers never rise towards the
/// chuck.
pub type Stairs = Vec<u16>;

/// A pass: it removes the columns from `from` up to `to` down to the line `line`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StairPass {
    /// Its direction.
    pub kind: PassDirection,
    /// The line of radii it goes down to.
    pub line: u16,
    /// The first column that it takes from.
    pub from: usize,
    /// The column before which it ends.
    pub to: usize,
    /// Its length in metal.
    pub length: Half,
}

impl StairPass {
    /// Its cost.
    pub fn cost(self, objective: Objective) -> u64 {
        let length = self.length.halves().unsigned_abs();
        match objective {
            Objective::Path | Objective::Time { .. } => length,
            Objective::PathAndPasses { per_pass_mm } => length + per_pass_mm.halves().unsigned_abs(),
            Objective::Passes => 1,
        }
    }
}

impl Lines {
    /// The lines of a grid.
    pub fn of(grid: &Grid) -> Self {
        let mut radii: Vec<Half> = grid.levels.iter().map(|level| level.to).chain([grid.bar]).collect();
        let mut zs: Vec<Half> = grid.slices.iter().map(|slice| slice.to).chain([Half::ZERO]).collect();
        let mut outer = grid.bar;
        for cylinder in grid.cylinders.iter().rev() {
            radii.extend(steps_up(cylinder.radius, outer, grid.longitudinal_depth));
            zs.extend(steps_down(cylinder.to, cylinder.from, grid.transverse_depth));
            outer = cylinder.radius;
        }
        radii.sort_unstable();
        radii.dedup();
        radii.reverse();
        zs.sort_unstable();
        zs.dedup();
        let line_of = |radius: Half| radii.iter().position(|line| *line <= radius).unwrap_or_default();
        let mut floor = Vec::new();
        for at in zs.iter().take(zs.len().saturating_sub(1)) {
            let under = grid.cylinders.iter().find(|one| one.from <= *at && *at < one.to);
            let line = under.map_or(0, |cylinder| line_of(cylinder.radius));
            floor.push(u16::try_from(line).unwrap_or(u16::MAX));
        }
        let least = Half::new(1);
        let (along, across) = (grid.longitudinal_depth.max(least), grid.transverse_depth.max(least));
        let over = floor.iter().zip(zs.windows(2)).map(|(floor, pair)| {
            let bottom = radii.get(usize::from(*floor)).copied().unwrap_or_default();
            let width = u128::from(size(pair[1] - pair[0]));
            let of = |from: &Half| width * u128::from(cheapest(size(*from - bottom), size(along), size(across)));
            radii.iter().take(usize::from(*floor)).map(of).collect()
        });
        let over = over.collect();
        let reach = (0..radii.len()).map(|line| floor.partition_point(|floor| usize::from(*floor) > line)).collect();
        Self { radii, zs, floor, over, reach, longitudinal_depth: along, transverse_depth: across }
    }

    /// The whole bar.
    pub fn bar(&self) -> Stairs {
        vec![0; self.floor.len()]
    }

    fn radius(&self, line: u16) -> Half {
        self.radii.get(usize::from(line)).copied().unwrap_or_default()
    }

    fn z(&self, column: usize) -> Half {
        self.zs.get(column).copied().unwrap_or_default()
    }

    /// A lower bound for the cost from a staircase to the part.
    ///
    /// Over each column k longitudinal passes (a whole number) remove at most k depths of its height. The rest is cut
    /// across, and a transverse pass costs its length for at most its depth in thickness. So a column of width w and
    /// height H costs at least w·(k + (H - k·t)/s) for the best k, with the depths t along and s across. The same
    /// holds for each row with the directions exchanged; the larger sum is the bound. A pass lowers neither sum by
    /// more than its cost, so A* need not expand any staircase twice.
    pub fn at_least(&self, stairs: &Stairs, objective: Objective) -> u64 {
        let (along, across) = (size(self.longitudinal_depth), size(self.transverse_depth));
        if objective == Objective::Passes {
            let area = stairs.iter().zip(&self.floor).enumerate().map(|(column, (at, floor))| {
                let width = size(self.z(column + 1) - self.z(column));
                u128::from(width) * u128::from(size(self.radius(*at) - self.radius(*floor)))
            });
            let long = size(self.z(stairs.len()));
            let high = size(self.radius(0) - self.radii.last().copied().unwrap_or_default());
            // No pass removes more than the larger depth over the larger length.
            let most = u128::from(along.max(across)) * u128::from(long.max(high));
            return u64::try_from(area.sum::<u128>().div_ceil(most.max(1))).unwrap_or(u64::MAX);
        }
        let columns = stairs.iter().zip(&self.over).map(|(at, over)| over.get(usize::from(*at)).copied().unwrap_or(0));
        let columns: u128 = columns.sum();
        let mut rows = 0_u128;
        let mut from = stairs.len();
        for ((line, pair), to) in self.radii.windows(2).enumerate().zip(&self.reach) {
            // The columns that are cut deeper than this row lie before it; for inner rows they are fewer.
            from = stairs.iter().take(from).rposition(|at| usize::from(*at) > line).map_or(0, |last| last + 1);
            if from < *to {
                let width = size(self.z(*to) - self.z(from));
                rows += u128::from(size(pair[0] - pair[1])) * u128::from(cheapest(width, across, along));
            }
        }
        let least = columns.div_ceil(u128::from(across)).max(rows.div_ceil(u128::from(along)));
        u64::try_from(least).unwrap_or(u64::MAX)
    }

    /// Every pass that a staircase permits. A corner is a line of radii and a line of Z; the stock above the one and
    /// before the other is removed. It may be cut along if it is nowhere deeper than a longitudinal pass, and across
    /// if it is nowhere thicker than a slice.
    pub fn cuts(&self, stairs: &Stairs, cuts: &mut Vec<StairPass>) {
        cuts.clear();
        for to in 1..=stairs.len() {
            let (now, floor) = (stairs[to - 1], self.floor[to - 1]);
            for line in now + 1..=floor {
                // Columns before this one are cut as deep already.
                let from = stairs.partition_point(|at| *at >= line);
                let (long, deep) = (self.z(to) - self.z(from), self.radius(now) - self.radius(line));
                if deep <= self.longitudinal_depth {
                    cuts.push(StairPass { kind: PassDirection::Longitudinal, line, from, to, length: long });
                }
                if long <= self.transverse_depth {
                    cuts.push(StairPass { kind: PassDirection::Transverse, line, from, to, length: deep });
                }
            }
        }
    }

    /// Executes a pass.
    pub fn cut(&self, stairs: &mut Stairs, cut: StairPass) {
        for at in stairs.iter_mut().take(cut.to).skip(cut.from) {
            *at = cut.line;
        }
    }

    /// The pass in the form of the output.
    pub fn pass(&self, stairs: &Stairs, cut: StairPass, reason: Note) -> Pass {
        let (radius, before) =
            (self.radius(cut.line), self.radius(stairs.get(cut.to - 1).copied().unwrap_or_default()));
        let (face, end) = (self.z(cut.from), self.z(cut.to));
        let (from, depth) = match cut.kind {
            PassDirection::Longitudinal => (Point { radius, z: face }, before - radius),
            PassDirection::Transverse => (Point { radius: before, z: end }, end - face),
        };
        let mut removed: Vec<(Point, Point)> = Vec::new();
        for column in cut.from..cut.to {
            let outer = self.radius(stairs.get(column).copied().unwrap_or_default());
            let far = Point { radius: outer, z: self.z(column + 1) };
            match removed.last_mut() {
                Some((_, last)) if last.radius == outer => *last = far,
                _ => removed.push((Point { radius, z: self.z(column) }, far)),
            }
        }
        Pass { kind: cut.kind, from, to: Point { radius, z: end }, depth, removed, reason }
    }
}

fn size(length: Half) -> u64 {
    length.halves().max(0).unsigned_abs()
}

/// The least of k + (size - k·own)/other over whole k, times `other`: k passes of the depth `own`, the rest by others.
fn cheapest(size: u64, own: u64, other: u64) -> u64 {
    let most = size / own;
    let cost = |passes: u64| passes * other + size.saturating_sub(passes * own);
    cost(0).min(cost(most)).min(cost(most + 1))
}

/// `from + depth`, `from + 2·depth`, … below `to`.
fn steps_up(from: Half, to: Half, depth: Half) -> impl Iterator<Item = Half> {
    let next = move |at: &Half| Some(*at + depth.max(Half::new(1)));
    std::iter::successors(Some(from), next).skip(1).take_while(move |at| *at < to)
}

/// `from - depth`, `from - 2·depth`, … above `to`.
fn steps_down(from: Half, to: Half, depth: Half) -> impl Iterator<Item = Half> {
    let next = move |at: &Half| Some(*at - depth.max(Half::new(1)));
    std::iter::successors(Some(from), next).skip(1).take_while(move |at| *at > to)
}
