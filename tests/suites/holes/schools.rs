//! Worked problems of schools, each computed by the program itself and not by a copy of its formulas.
//!
//! `tests/data/school-problems.yaml` says how, and why ours differs where it does.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use technolog::audit::read_plan;
use technolog::cutting::{self, Cut, handbook};
use technolog::knowledge::vocabulary::ToolMaterial;
use technolog::machine::Machine;
use technolog::material::Material;
use technolog::part::Face;
use technolog::plan::{CuttingMethod, Feature, Operation};
use technolog::planner;
use technolog::route::{RouteStep, StepLocation};
use technolog::shop::Shop;
use technolog::units::{Micrometres, Microns, MillimetresPerRev, Roughness};
use technolog_testing::cuts::plain_cut;
use technolog_testing::{AUDITOR, KNOWLEDGE, read};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Problem {
    id: String,
    page: String,
    school: String,
    by: By,
    #[serde(default = "steel")]
    material: String,
    hardness: Option<f64>,
    hole: Drawn,
    #[serde(default)]
    given: Given,
    published: BTreeMap<String, Published>,
    ours: BTreeMap<String, f64>,
    #[serde(default)]
    differs: BTreeMap<String, String>,
    slip: Option<String>,
    note: Option<String>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(rename_all = "lowercase")]
enum By {
    Plan,
    Travel,
    Law,
    Own,
    Tap,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Drawn {
    operation: String,
    diameter: f64,
    #[serde(default)]
    from: f64,
    depth: f64,
    through: bool,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct Given {
    tool_material: Option<String>,
    speed: Option<f64>,
    feed: Option<f64>,
    rpm: Option<f64>,
    minute_feed: Option<f64>,
    travel: Option<f64>,
    pitch: Option<f64>,
    roughness: Option<f64>,
    count: Option<f64>,
}

#[derive(Clone, Copy, Deserialize)]
#[serde(untagged)]
enum Published {
    Figure(f64),
    Range([f64; 2]),
}

impl Published {
    /// Whether ours is within 5 % of it, or in its range.
    fn holds(self, ours: f64) -> bool {
        match self {
            Self::Figure(figure) => (ours / figure - 1.0).abs() < 0.05,
            Self::Range([from, to]) => (from..=to).contains(&ours),
        }
    }
}

fn steel() -> String {
    "steel-45".to_owned()
}

fn mm(length: f64) -> Micrometres {
    Micrometres::from_mm_rounded(length)
}

fn problems() -> Vec<Problem> {
    #[derive(Deserialize)]
    struct File {
        problems: Vec<Problem>,
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/school-problems.yaml");
    serde_yaml::from_str::<File>(&std::fs::read_to_string(path).unwrap()).unwrap().problems
}

impl Problem {
    fn operation(&self) -> Operation {
        Operation::from_name(&self.hole.operation).unwrap()
    }

    fn part(&self) -> String {
        let Drawn { diameter, depth, through, .. } = self.hole;
        let thickness = if through { depth } else { depth + 40.0 };
        format!(
            "part: P\nmaterial: {}\nmachine: gf2171\nblank: {{kind: plate, length: 300, width: 300, thickness: \
             {thickness}}}\nholes:\n  - {{name: A, diameter: {diameter}H12, depth: {depth}, through: {through}, \
             roughness: Ra 12.5, centre_tolerance: 0.4, at: [[0, 0]]}}\n",
            self.material
        )
    }

    fn shop(&self) -> Shop<'static> {
        let knowledge = &*KNOWLEDGE;
        let mut material = Material::find(knowledge, &self.material).unwrap();
        if let Some(hardness) = self.hardness {
            material.hardness = hardness.to_string().parse().unwrap();
        }
        Shop::with(Machine::find(knowledge, "gf2171").unwrap(), material, CuttingMethod::Formula, knowledge)
    }

    fn cut(&self) -> Cut {
        let tool_material = match self.given.tool_material.as_deref() {
            Some("carbide") => ToolMaterial::Carbide,
            _ => ToolMaterial::HighSpeedSteel,
        };
        let travel = mm(self.given.travel.unwrap_or(self.hole.depth));
        let (depth, blind, pitch) = (mm(self.hole.depth), !self.hole.through, self.given.pitch.map(mm));
        let plain = plain_cut(self.operation(), mm(self.hole.from), mm(self.hole.diameter));
        let roughness = self.given.roughness.map(|ra| Roughness::from_ra(Microns(ra)));
        Cut { depth, blind, travel, tool_material, pitch, roughness, ..plain }
    }

    /// The figure that the audit computes for a key of the conditions: it is stated a third larger, so that the audit
    /// says what it should be.
    fn by_audit(&self, key: &str) -> Option<f64> {
        let Given { speed, feed, rpm, minute_feed, travel, .. } = self.given;
        let mut stated: BTreeMap<&str, f64> = BTreeMap::new();
        let given = [("speed", speed), ("feed", feed), ("rpm", rpm), ("minute_feed", minute_feed), ("travel", travel)];
        stated.extend(given.into_iter().filter_map(|(key, value)| Some((key, value?))));
        let Drawn { operation, diameter, from, depth, .. } = &self.hole;
        stated.extend(self.ours.iter().map(|(key, value)| (key.as_str(), *value)));
        stated.insert(key, libm::round(self.ours[key] * 6_300.0) / 10_000.0);
        let stated: Vec<String> = stated.iter().map(|(key, value)| format!("{key}: {value}")).collect();
        let text = format!(
            "plan: P\npart: part.yaml\nroute: [{{operation: {operation}, hole: A, diameter: {diameter}, from: {from}, \
             depth: {depth}}}]\nconditions: [{{for: 1, diameter: {diameter}, {}}}]\n",
            stated.join(", ")
        );
        let plan = read_plan("plan.yaml", &text, &KNOWLEDGE, &|_: &str| Ok(self.part())).unwrap();
        let field = format!("conditions.1.{key}");
        let audit = AUDITOR.audit(&plan).unwrap();
        let found = audit.findings.iter().find(|one| one.field == field)?;
        found.by_stated.as_ref().or(found.right.as_ref())?.parse().ok()
    }

    /// The way of its tool at working feed.
    fn travel(&self) -> f64 {
        let part = read(&self.part());
        let Drawn { depth, through, .. } = self.hole;
        let place = StepLocation {
            feature: Feature::Bore,
            step: None,
            face: Face::Entry,
            start: Micrometres::ZERO,
            depth: mm(depth),
            through,
        };
        let step = RouteStep::plain(self.operation(), place, mm(self.hole.diameter), mm(self.hole.from));
        planner::feed_travel(&step, &part.holes[0], &part, &self.shop()).unwrap().0.to_mm()
    }

    fn by_law(&self) -> f64 {
        let (cut, shop) = (self.cut(), self.shop());
        let feed = self.given.feed.unwrap();
        let law = handbook::formulas(&cut, MillimetresPerRev(feed), &shop).unwrap().unwrap();
        let (life, _) = handbook::tool_life(&cut, &shop).unwrap().unwrap();
        let depth = (self.hole.diameter - self.hole.from) / 2.0;
        law.speed.at(self.hole.diameter, depth, feed, life.0) * law.speed_factor()
    }

    /// The time of its taps at the given spindle speed: that of the plan, with another speed.
    fn tapping(&self) -> f64 {
        let conditions = cutting::conditions(&self.cut(), &self.shop()).unwrap();
        let each = conditions.machine_time_min.0 * conditions.spindle_rpm.0 / self.given.rpm.unwrap();
        each * self.given.count.unwrap()
    }

    fn computed(&self, key: &str) -> f64 {
        match self.by {
            By::Plan => self.by_audit(key).unwrap_or_else(|| panic!("{}: {key} is not audited", self.id)),
            By::Travel => self.travel(),
            By::Law => self.by_law(),
            By::Own => {
                let own = cutting::conditions(&self.cut(), &self.shop()).unwrap();
                if key == "feed" { own.feed_mm_per_rev.0 } else { own.computed_speed_m_per_min.0 }
            }
            By::Tap => self.tapping(),
        }
    }
}

#[test]
fn problems_of_schools_come_out_as_published_or_it_is_said_why() {
    let (mut wrong, mut compared, mut as_published) = (Vec::new(), 0, 0);
    for problem in problems() {
        let id = &problem.id;
        let words = [&problem.school, &problem.page].into_iter().chain(&problem.slip).chain(&problem.note);
        assert!(words.chain(problem.differs.values()).all(|words| !words.is_empty()), "{id}");
        assert!(problem.ours.keys().eq(problem.published.keys()), "{id}");
        for (key, published) in &problem.published {
            let (found, ours) = (problem.computed(key), problem.ours[key]);
            let (near, told) = (published.holds(found), problem.differs.contains_key(key));
            if (found / ours - 1.0).abs() > 0.005 || near == told {
                wrong.push(format!("{id}: {key} {found}, as written {ours}, as published: {near}, told: {told}"));
            }
            compared += 1;
            as_published += usize::from(near);
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(compared >= 38 && as_published >= 27, "{compared} {as_published}");
}
