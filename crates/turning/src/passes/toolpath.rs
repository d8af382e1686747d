//! A sequence of passes as a toolpath. Cylinders and faces are the same for a round nose and a sharp one
//! ([`crate::turning::nose`]), so the path of the theoretical point is safe unchanged.

use crate::turning::length::Half;
use crate::turning::point::Point;
use crate::turning::shaft::Rates;
use crate::turning::toolpath::{Purpose, Toolpath};

use super::pass::{Pass, PassDirection, PassEnd, legs};

/// The path from the home point through all passes and back. A pass across a face that ends on the axis is extended
/// by `beyond`, so that a round nose leaves nothing there.
pub fn toolpath(passes: &[Pass], bar: Half, rates: &Rates, beyond: Half) -> Toolpath {
    let mut path: Option<Toolpath> = None;
    let mut before: Option<PassEnd> = None;
    let mut walls: Vec<Point> = Vec::new();
    let mut floors: Vec<Half> = Vec::new();
    let starts = passes.iter().map(|pass| Some(pass.start())).chain([None]);
    for (start, pass) in starts.zip(passes.iter().map(Some).chain([None])) {
        for (from, to) in legs(before, start, bar, rates) {
            let path = path.get_or_insert_with(|| Toolpath::at(from));
            // Up to a wall and down beside it the tool moves at feed: the edge of a pass has left the wall inclined.
            let walls = walls.iter().filter(|wall: &&Point| wall.z == to.z && to.radius < wall.radius);
            if let Some(top) = walls.map(|wall| wall.radius).max() {
                let off = Half::of(rates.retract);
                let short = if from.z < to.z {
                    Point { radius: to.radius, z: (to.z - off).max(from.z) }
                } else {
                    Point { radius: (top + off).min(from.radius).max(to.radius), z: to.z }
                };
                path.go(short, Purpose::Rapid);
                path.go(to, Purpose::Return);
            } else if to.radius < from.radius && floors.contains(&to.radius) {
                // Between the ends of passes across, the nose has left crests on the cylinder.
                let short = Point { radius: (to.radius + Half::of(rates.retract)).min(from.radius), z: to.z };
                path.go(short, Purpose::Rapid);
                path.go(to, Purpose::Return);
            }
            path.go(to, Purpose::Rapid);
        }
        let (Some(pass), Some(path)) = (pass, &mut path) else { continue };
        let mut end = pass.end();
        if pass.kind == PassDirection::Transverse && end.at.radius == Half::ZERO {
            end.at.radius = Half::ZERO - beyond;
        }
        path.go(end.at, Purpose::Cut);
        match pass.kind {
            PassDirection::Longitudinal => walls.push(Point { radius: pass.to.radius + pass.depth, z: pass.to.z }),
            PassDirection::Transverse => floors.push(pass.to.radius),
        }
        before = Some(end);
    }
    path.unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::turning::part::StockKind;
    use crate::turning::passes::grid::Grid;
    use crate::turning::passes::variants::one_direction;
    use crate::turning::shaft::{Blank, Division, Moves, Roughing, Shaft, Step};
    use crate::units::{Micrometres, MillimetresPerMinute};

    /// The paper's shaft, its first level by hand: from home at Ø69, Z 2 to Ø57, along to Z −34, off by 0.5.
    #[test]
    fn the_first_level_of_the_papers_shaft() {
        let mm = |length: f64| Micrometres::from_mm_rounded(length);
        let shaft = Shaft {
            blank: Blank { kind: StockKind::Bar, diameter: mm(65.0), length: mm(34.0) },
            blank_steps: Vec::new(),
            steps: vec![Step { diameter: mm(40.0), length: mm(16.0) }, Step { diameter: mm(50.0), length: mm(18.0) }],
            roughing: Roughing {
                longitudinal_depth: mm(4.0),
                transverse_depth: mm(3.5),
                division: Division::Full,
                moves: Moves::Basic,
            },
            rates: None,
        };
        let rate = MillimetresPerMinute(150.0);
        let rates =
            Rates { longitudinal_feed: rate, transverse_feed: rate, rapid: rate, approach: mm(2.0), retract: mm(0.5) };
        let grid = Grid::of(&shaft);
        let path = toolpath(&one_direction(&grid, PassDirection::Longitudinal), grid.bar, &rates, Half::from(0.8));
        let at = |radius: f64, z: f64| Point { radius: Half::from(radius), z: Half::from(z) };
        assert_eq!(path.from, at(34.5, -2.0));
        let first: Vec<Point> = path.moves.iter().take(3).map(|one| one.to).collect();
        assert_eq!(first, [at(28.5, -2.0), at(28.5, 34.0), at(29.0, 33.5)]);
        assert_eq!(path.end(), path.from);
    }
}
