//! Speed and forces as power laws of the depth of cut, for one cut and one feed.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::Question;
use crate::knowledge::vocabulary::ToolMaterial;
use crate::note::{Because, Note};
use crate::tables::cutting::{
    BoringForceFor, BoringSpeedFor, GroovingSpeedFor, Process, Reference, ToolMaterialFactor, ToolMaterialFactorFor,
    TurningForce, TurningForceFor,
};
use crate::tables::turning::tools::{
    InsertRake, TurningForceAngle, TurningForceAngleFor, TurningForceRakeFor, TurningSpeedAngleFor,
};
use crate::units::{Decimal, Degrees, MetresPerMinute, MillimetresPerRev, Minutes, Newtons, round_to};
use technolog_cutting::factors;
use technolog_cutting::figures;

pub(super) use crate::tables::cutting::Component;

use super::{Cut, FigureOwner, MissingFigure, of_tables};

/// What the tools of this room are of.
const TOOL_MATERIAL: ToolMaterial = ToolMaterial::Carbide;

/// `factor · t^depth · V^speed`, with t in mm and V in m/min; the feed is part of the factor.
#[derive(Clone, Copy, Debug, PartialEq)]
struct PowerLaw {
    factor: f64,
    depth: f64,
    speed: f64,
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

/// The speed for the tool life of `boring-parameters` (Косилова/Мещеряков т.2):
///
/// V = Cv / (T^m · t^x · s^y) · Kmv · Kpv · Kiv · Kφv, and 0.9 of it in a bore; in grooving without t, Kφv and the 0.9.
///
/// # Errors A table has no figure for this material or tool.
pub(super) fn speed(cut: &Cut<'_, '_>, feed: MillimetresPerRev) -> Tried<SpeedLaw, MissingFigure> {
    let (life, reason) = factors::single_point_life(cut.knowledge)?;
    let mut because = vec![reason];
    let figures = if cut.tool.plunges() {
        let figures = of_tables(figures::ask(|material_group| GroovingSpeedFor { material_group }, cut))?;
        figures.map(|row| ([row.cv, row.x, row.y, row.m], row.tool_grade))
    } else {
        let figures = of_tables(figures::ask(|material_group| BoringSpeedFor { material_group, feed }, cut))?;
        figures.map(|row| ([row.cv, row.x, row.y, row.m], row.tool_grade))
    };
    let ([cv, x, y, m], tool_grade) = figures.row;
    because.extend(figures.because(Note::new("speed-coefficients").with("cv", cv)));
    let mut factor = cv / (libm::pow(life.0, m) * libm::pow(feed.0, y));
    let mut corrections = vec![of_tables(factors::surface(cut.surface, cut))?];
    if figures.own() {
        corrections.push(of_tables(factors::material_speed(Process::Turning, TOOL_MATERIAL, cut))?);
    }
    corrections.extend(grade(cut, tool_grade)?);
    if !cut.tool.plunges() {
        let question = TurningSpeedAngleFor { lead_angle: degrees(cut.edge_angle()) };
        corrections.push(angle(cut, &question, |row| row.factor, "angle-speed-factor")?);
        if cut.is_inner() {
            corrections.push(factors::internal(cut.knowledge)?);
        }
    }
    for (correction, reason) in corrections {
        factor *= correction;
        because.push(reason);
    }
    let law = PowerLaw { factor, depth: -x, speed: 0.0 };
    Ok(SpeedLaw { law, life, life_exponent: m, because })
}

/// A component of the force (Косилова/Мещеряков т.2 tables 9, 22, 23):
///
/// P = 10 · Cp · t^x · s^y · V^n · Kmp · Kφp · Kγp, N. In grooving t is the width of the blade, and there is no factor
/// for an angle.
///
/// # Errors A table has no figure for this material, or the tool's row has no insert, so that its rake is unknown.
pub(super) fn force(
    cut: &Cut<'_, '_>,
    component: Component,
    feed: MillimetresPerRev,
) -> Tried<ForceLaw, MissingFigure> {
    let tool_material = TOOL_MATERIAL;
    let turning = !cut.tool.plunges();
    let of_boring = turning && component == Component::Main;
    // For Pz of turning the factor of the material belongs to the whole process, otherwise to the row.
    let figures = if of_boring {
        let figures = of_tables(figures::ask(|material_group| BoringForceFor { material_group, tool_material }, cut))?;
        figures.map(|row| ([row.cp, row.x, row.y, row.n], None))
    } else {
        let process = cut.process();
        let question = |material_group| TurningForceFor { process, component, material_group, tool_material };
        let figures = of_tables(figures::ask(question, cut))?;
        figures.map(|row| ([row.cp, row.x, row.y, row.n], Some(row)))
    };
    let ([cp, x, y, n], own) = &figures.row;
    let mut because = figures.because(Note::new("force-coefficients").with("component", component.name()));
    let mut factor = 10.0 * cp * libm::pow(feed.0, *y);
    let mut corrections = Vec::new();
    if figures.own() {
        corrections.push(match own {
            None => of_tables(factors::material_force(Process::Turning, TOOL_MATERIAL, cut))?,
            Some(row) => material(cut, row),
        });
    }
    if turning {
        let question = TurningForceAngleFor { lead_angle: degrees(cut.edge_angle()) };
        let factor = |row: TurningForceAngle<'_>| of_component(component, [row.pz, row.py, row.px]);
        corrections.push(angle(cut, &question, factor, "angle-force-factor")?);
        corrections.push(rake(cut, component)?);
    }
    for (correction, reason) in corrections {
        factor *= correction;
        because.push(reason);
    }
    let law = PowerLaw { factor, depth: *x, speed: *n };
    Ok(ForceLaw { law, because })
}

/// Kmp of a row of `turning-force`: (σB/750)^n of steel, (HB/190)^n of iron, with the row's own n.
fn material(cut: &Cut<'_, '_>, row: &TurningForce<'_>) -> (f64, Because) {
    let ratio = match row.reference {
        Reference::Strength750 => cut.material.strength.to_f64() / 750.0,
        _ => cut.material.hardness.to_f64() / 190.0,
    };
    let factor = libm::pow(ratio, row.material_exponent);
    (factor, Because::row(row.row, shown("material-force-factor", factor)))
}

/// Kiv: the first grade of the tool that `tool-material-factor` has for the material, relative to the grade of the
/// coefficients. A tool without a grade, or with that very grade, needs no factor.
fn grade(cut: &Cut<'_, '_>, reference: &str) -> Tried<Option<(f64, Because)>, MissingFigure> {
    if cut.tool.grades.is_empty() || cut.tool.grades.contains(&reference) {
        return Ok(None);
    }
    let material_group = cut.material.group;
    let ask = |grade: &str| -> Result<Option<ToolMaterialFactor<'_>>, KnowledgeError> {
        Ok(cut.knowledge.ask(&ToolMaterialFactorFor { material_group, grade })?.winner()?)
    };
    let base = ask(reference)?;
    for own in &cut.tool.grades {
        if let (Some(row), Some(base)) = (ask(own)?, &base) {
            let factor = row.factor / base.factor;
            let note = shown("grade-factor", factor).with("grade", own).with("reference", reference);
            return Ok(Some((factor, Because::row(row.row, note))));
        }
    }
    of_tables(Err(figures::missing(ToolMaterialFactorFor::TABLE, cut)))
}

/// A factor by the angle of the edge that cuts.
fn angle<'k, Q: Question>(
    cut: &Cut<'_, 'k>,
    question: &Q,
    factor: impl FnOnce(Q::Row<'k>) -> f64,
    code: &'static str,
) -> Tried<(f64, Because), MissingFigure> {
    let angle = cut.edge_angle();
    let outside = || Refusal::Not(FigureOwner::Angle { table: Q::TABLE.to_owned(), angle }.into());
    let (row, cited) = figures::within_reach(question, cut.knowledge)?.ok_or_else(outside)?;
    let factor = factor(row);
    Ok((factor, Because::row(cited, shown(code, factor).with("angle", angle))))
}

/// Kγp by the rake of the seat, which follows from the clearance of the insert.
fn rake(cut: &Cut<'_, '_>, component: Component) -> Tried<(f64, Because), MissingFigure> {
    let clearance = cut.tool.insert_clearance().ok_or_else(|| Refusal::Not(cut.tool_lacks("insert")))?;
    let seat = cut.knowledge.find(|row: &InsertRake<'_>| row.clearance == clearance)?;
    let rake = seat.ok_or_else(|| Refusal::Not(cut.tool_lacks("rake")))?.rake;
    let row = cut.knowledge.ask(&TurningForceRakeFor { rake })?.need("this rake")?;
    let factor = of_component(component, [row.pz, row.py, row.px]);
    let note = shown("rake-force-factor", factor).with("angle", Decimal::from_f64_rounded(rake.0));
    Ok((factor, Because::row(row.row, note)))
}

/// The factor of a component, of those of Pz, Py and Px.
const fn of_component(component: Component, [pz, py, px]: [f64; 3]) -> f64 {
    match component {
        Component::Main => pz,
        Component::Radial => py,
        Component::Axial => px,
    }
}

/// An angle for a query of the tables.
fn degrees(angle: Decimal) -> Degrees {
    Degrees(angle.to_f64())
}

fn shown(code: &'static str, factor: f64) -> Note {
    Note::new(code).with("factor", round_to(factor, 3))
}
