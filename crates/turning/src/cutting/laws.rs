//! Speed and forces as power laws of the depth of cut, for one cut and one feed.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::{Input, QueryError, RowRef};
use crate::note::{Because, Note};
use crate::units::{Decimal, MetresPerMinute, MillimetresPerRev, Minutes, Newtons, Unit, round_to};
use technolog_cutting::factors;
use technolog_cutting::figures::{self, feed_input, number};

use super::{Cut, Lacking, Of, of_tables};

/// The tables know the tools of this room by this word.
const TOOL_MATERIAL: &str = "carbide";

/// `factor · t^depth · V^speed`, with t in mm and V in m/min; the feed stands in the factor.
#[derive(Clone, Copy, Debug, PartialEq)]
struct PowerLaw {
    factor: f64,
    depth: f64,
    speed: f64,
}

/// A component of the cutting force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Component {
    /// Pz, along the cutting speed.
    Main,
    /// Py, which pushes the tool out of the cut, across the feed.
    Radial,
    /// Px, against the feed.
    Axial,
}

impl Component {
    const fn name(self) -> &'static str {
        match self {
            Self::Main => "pz",
            Self::Radial => "py",
            Self::Axial => "px",
        }
    }
}

/// The speed of a tool's life.
#[derive(Clone, Debug)]
pub(super) struct SpeedLaw {
    law: PowerLaw,
    /// The life it is reckoned for.
    pub life: Minutes,
    /// m of V ~ 1/T^m.
    pub life_exponent: f64,
    pub because: Vec<Because>,
}

impl SpeedLaw {
    pub fn at(&self, depth_mm: f64) -> MetresPerMinute {
        MetresPerMinute(self.law.factor * libm::pow(depth_mm, self.law.depth))
    }
}

/// A component of the force.
#[derive(Clone, Debug)]
pub(super) struct ForceLaw {
    law: PowerLaw,
    pub because: Vec<Because>,
}

impl ForceLaw {
    pub fn at(&self, depth_mm: f64, speed: MetresPerMinute) -> Newtons {
        Newtons(self.law.factor * libm::pow(depth_mm, self.law.depth) * libm::pow(speed.0, self.law.speed))
    }

    /// n of P ~ V^n.
    pub const fn speed_exponent(&self) -> f64 {
        self.law.speed
    }
}

/// The speed at which the tool lasts as long as `boring-parameters` says (Косилова/Мещеряков т.2):
///
/// V = Cv / (T^m · t^x · s^y) · Kmv · Kpv · Kiv · Kφv, and 0.9 of it in a bore; in grooving without t, Kφv and the 0.9.
///
/// # Errors
/// A table has no figure for this material or tool.
pub(super) fn speed(cut: &Cut<'_, '_>, feed: MillimetresPerRev) -> Tried<SpeedLaw, Lacking> {
    let parameters = cut.knowledge.table("boring-parameters")?;
    let parameter = |name: &str| parameters.find("name", name).ok_or_else(|| KnowledgeError::no_row(parameters, name));
    let life_row = parameter("tool-life")?;
    let life = life_row.number_in("time", Unit::Minute)?;
    let mut because = vec![Because::row(life_row, Note::new("tool-life").with("minutes", life))];
    let figures = if cut.tool.plunges() {
        of_tables(figures::ask("grooving-speed", &[], cut))?
    } else {
        of_tables(figures::ask("boring-speed", &[("feed", feed_input(feed))], cut))?
    };
    let row = figures.row;
    because.extend(figures.because(Note::new("speed-coefficients").with("cv", number(row, "cv")?)));
    let (cv, x, y, m) = (number(row, "cv")?, number(row, "x")?, number(row, "y")?, number(row, "m")?);
    let mut factor = cv / (libm::pow(life, m) * libm::pow(feed.0, y));
    let mut corrections = vec![of_tables(factors::surface(cut.surface, cut))?];
    if figures.own() {
        corrections.push(of_tables(factors::material_speed("turning", TOOL_MATERIAL, cut))?);
    }
    corrections.extend(grade(cut, row)?);
    if !cut.tool.plunges() {
        corrections.push(angle(cut, "turning-speed-angle", "factor", "angle-speed-factor")?);
        if cut.is_inner() {
            let internal = parameter("internal-factor")?;
            let value = number(internal, "factor")?;
            corrections.push((value, Because::row(internal, Note::new("internal-factor").with("factor", value))));
        }
    }
    for (correction, reason) in corrections {
        factor *= correction;
        because.push(reason);
    }
    let law = PowerLaw { factor, depth: -x, speed: 0.0 };
    Ok(SpeedLaw { law, life: Minutes(life), life_exponent: m, because })
}

/// A component of the force (Косилова/Мещеряков т.2 tables 9, 22, 23):
///
/// P = 10 · Cp · t^x · s^y · V^n · Kmp · Kφp · Kγp, N; in grooving t is the width of the blade, and there is no angle to
/// correct for.
///
/// # Errors
/// A table has no figure for this material, or the tool's row has no insert to know its rake by.
pub(super) fn force(cut: &Cut<'_, '_>, component: Component, feed: MillimetresPerRev) -> Tried<ForceLaw, Lacking> {
    let tool = ("tool_material", Input::Text(TOOL_MATERIAL));
    let turning = !cut.tool.plunges();
    let of_boring = turning && component == Component::Main;
    let figures = if of_boring {
        of_tables(figures::ask("boring-force", &[tool], cut))?
    } else {
        let others =
            [("process", Input::Text(cut.process().name())), ("component", Input::Text(component.name())), tool];
        of_tables(figures::ask("turning-force", &others, cut))?
    };
    let row = figures.row;
    let mut because = figures.because(Note::new("force-coefficients").with("component", component.name()));
    let mut factor = 10.0 * number(row, "cp")? * libm::pow(feed.0, number(row, "y")?);
    let mut corrections = Vec::new();
    if figures.own() {
        corrections.push(match of_boring {
            true => of_tables(factors::material_force("turning", TOOL_MATERIAL, cut))?,
            false => material(cut, row)?,
        });
    }
    if turning {
        corrections.push(angle(cut, "turning-force-angle", component.name(), "angle-force-factor")?);
        corrections.push(rake(cut, component)?);
    }
    for (correction, reason) in corrections {
        factor *= correction;
        because.push(reason);
    }
    let law = PowerLaw { factor, depth: number(row, "x")?, speed: number(row, "n")? };
    Ok(ForceLaw { law, because })
}

/// Kmp of a row of `turning-force`: (σB/750)^n of steel, (HB/190)^n of iron, with the row's own n.
fn material(cut: &Cut<'_, '_>, row: RowRef<'_>) -> Result<(f64, Because), KnowledgeError> {
    let ratio = match row.text("reference")? {
        "strength-750" => cut.material.strength.to_f64() / 750.0,
        _ => cut.material.hardness.to_f64() / 190.0,
    };
    let factor = libm::pow(ratio, number(row, "material_exponent")?);
    Ok((factor, Because::row(row, shown("material-force-factor", factor))))
}

/// Kiv: the first grade of the tool that `tool-material-factor` knows for the material, against the grade that the
/// coefficients are for. A tool whose row names no grade, or has that very grade, needs no factor.
fn grade(cut: &Cut<'_, '_>, coefficients: RowRef<'_>) -> Tried<Option<(f64, Because)>, Lacking> {
    let reference = coefficients.text("tool_grade")?;
    if cut.tool.grades.is_empty() || cut.tool.grades.contains(&reference) {
        return Ok(None);
    }
    let table = cut.knowledge.table("tool-material-factor")?;
    let ask = |grade: &str| -> Result<Option<RowRef<'_>>, KnowledgeError> {
        let group = ("material_group", Input::Text(cut.material.group));
        Ok(table.decide(&[group, ("grade", Input::Text(grade))])?.winner())
    };
    let base = ask(reference)?;
    for own in &cut.tool.grades {
        if let (Some(row), Some(base)) = (ask(own)?, base) {
            let factor = number(row, "factor")? / number(base, "factor")?;
            let note = shown("grade-factor", factor).with("grade", own).with("reference", reference);
            return Ok(Some((factor, Because::row(row, note))));
        }
    }
    of_tables(Err(figures::missing(table, cut)))
}

/// A factor by the angle of the edge that cuts.
fn angle(cut: &Cut<'_, '_>, id: &str, column: &str, code: &str) -> Tried<(f64, Because), Lacking> {
    let table = cut.knowledge.table(id)?;
    let angle = cut.edge_angle();
    let outside = || Refusal::Not(Of::Angle { table: id.to_owned(), angle }.into());
    let answer = match table.decide(&[("lead_angle", Input::Number(angle, Unit::Degree))]) {
        Err(QueryError::OutOfDomain { .. }) => return Err(outside()),
        answer => answer?,
    };
    let row = answer.winner().ok_or_else(outside)?;
    let factor = number(row, column)?;
    Ok((factor, Because::row(row, shown(code, factor).with("angle", angle))))
}

/// Kγp by the rake of the seat, which follows from the clearance of the insert.
fn rake(cut: &Cut<'_, '_>, component: Component) -> Tried<(f64, Because), Lacking> {
    let clearance = cut.tool.insert_clearance().ok_or_else(|| Refusal::Not(cut.tool_lacks("insert")))?;
    let seats = cut.knowledge.table("insert-rake")?;
    let seat = seats.find("clearance", clearance).ok_or_else(|| Refusal::Not(cut.tool_lacks("rake")))?;
    let angle = Decimal::from_f64_rounded(seat.number_in("rake", Unit::Degree)?);
    let table = cut.knowledge.table("turning-force-rake")?;
    let answer = table.decide(&[("rake", Input::Number(angle, Unit::Degree))])?;
    let row = answer.winner().ok_or_else(|| KnowledgeError::no_row(table, "this rake"))?;
    let factor = number(row, component.name())?;
    Ok((factor, Because::row(row, shown("rake-force-factor", factor).with("angle", angle))))
}

fn shown(code: &str, factor: f64) -> Note {
    Note::new(code).with("factor", round_to(factor, 3))
}
