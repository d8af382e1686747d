//! Forces as power laws of the depth of cut, for one cut and one feed.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::Question;
use crate::knowledge::vocabulary::ToolMaterial;
use crate::note::{Because, Note};
use crate::practice_speed::practice_group;
use crate::tables::cutting::{
    BoringForceFor, Process, Reference, ToolMaterialFactor, ToolMaterialFactorFor, TurningForce, TurningForceFor,
    TurningForceShareFor,
};
use crate::tables::practice::SpecificCuttingForceFor;
use crate::tables::turning::tools::{InsertRake, TurningForceAngle, TurningForceAngleFor, TurningForceRakeFor};
use crate::units::{Decimal, Degrees, MetresPerMinute, MillimetresPerRev, Newtons, round_to};
use technolog_cutting::factors;
use technolog_cutting::figures;

pub(super) use crate::tables::cutting::Component;

use super::{FigureOwner, MissingFigure, TurningCut, of_tables};

/// The material of all tools in this room.
pub(super) const TOOL_MATERIAL: ToolMaterial = ToolMaterial::Carbide;

/// `factor · t^depth · V^speed`, with t in mm and V in m/min; the feed is part of the factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PowerLaw {
    pub factor: f64,
    pub depth: f64,
    pub speed: f64,
}

impl PowerLaw {
    /// Its value at a depth, mm, and a speed.
    pub fn at(self, depth_mm: f64, speed: MetresPerMinute) -> f64 {
        self.factor * libm::pow(depth_mm, self.depth) * libm::pow(speed.0, self.speed)
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
        Newtons(self.law.at(depth_mm, speed))
    }

    /// n of P ~ V^n.
    pub const fn speed_exponent(&self) -> f64 {
        self.law.speed
    }
}

/// A component of the force (Косилова/Мещеряков т.2 tables 9, 22, 23):
///
/// P = 10 · Cp · t^x · s^y · V^n · Kmp · Kφp · Kγp, N. In grooving t is the width of the blade, and there is no factor
/// for an angle.
///
/// For a material whose group has no coefficients, the force comes from `specific-cutting-force`. If its grade has no
/// group of VDI 3323 either, the figures of another group are used, and the reason names that group.
///
/// # Errors
/// A table has no figure for this material, or the tool's row has no insert, so that its rake is unknown.
pub(super) fn force(
    cut: &TurningCut<'_, '_>,
    component: Component,
    feed: MillimetresPerRev,
) -> Tried<ForceLaw, MissingFigure> {
    let tool_material = TOOL_MATERIAL;
    let turning = !cut.tool.plunges();
    if !has_own(cut, component)?
        && let Some(law) = specific(cut, component, feed)?
    {
        return Ok(law);
    }
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
    if figures.is_own_group() {
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

/// Whether the handbook has force coefficients for the material's own group.
fn has_own(cut: &TurningCut<'_, '_>, component: Component) -> Result<bool, KnowledgeError> {
    let (material_group, tool_material) = (cut.material.group, TOOL_MATERIAL);
    if component == Component::Main && !cut.tool.plunges() {
        let question = BoringForceFor { material_group, tool_material };
        return Ok(figures::within_reach(&question, cut.knowledge)?.is_some());
    }
    let question = TurningForceFor { process: cut.process(), component, material_group, tool_material };
    Ok(figures::within_reach(&question, cut.knowledge)?.is_some())
}

/// A component by the specific cutting force of VDI 3323 (`specific-cutting-force`), N; none if the grade has no
/// group there:
///
/// P = share · kc1 · h^(−mc) · s · t, with the thickness of the chip h = s · sin φ, mm. The share is that of
/// `turning-force-share`; the rake of the seat is compared with 0°, for which kc1 is given. In grooving φ is 90° and
/// t the width of the blade.
fn specific(
    cut: &TurningCut<'_, '_>,
    component: Component,
    feed: MillimetresPerRev,
) -> Tried<Option<ForceLaw>, MissingFigure> {
    let Some(group) = practice_group(cut.material, cut.knowledge)? else { return Ok(None) };
    let question = TurningForceShareFor { process: cut.process(), component };
    let Some(share) = cut.knowledge.ask(&question)?.winner()? else { return Ok(None) };
    let row = cut.knowledge.ask(&SpecificCuttingForceFor { vdi: group.vdi })?.need(&group.vdi.to_string())?;
    let turning = !cut.tool.plunges();
    let sine = if turning { libm::sin(cut.edge_angle().to_f64().to_radians()) } else { 1.0 };
    let note = Note::new("specific-force").with("group", group.vdi).with("kc", row.kc1.0).with("mc", row.mc);
    let mut because = vec![Because::row(row.row, note)];
    let mut factor = row.kc1.0.to_f64() * libm::pow(feed.0 * sine, -row.mc) * feed.0;
    let mut corrections = Vec::new();
    corrections.push((share.share, Because::row(share.row, shown("force-share", share.share))));
    if turning {
        if component != Component::Main {
            let question = TurningForceAngleFor { lead_angle: degrees(cut.edge_angle()) };
            let factor = |row: TurningForceAngle<'_>| of_component(component, [row.pz, row.py, row.px]);
            corrections.push(angle(cut, &question, factor, "angle-force-factor")?);
        }
        let (own, reason) = rake(cut, component)?;
        let straight = cut.knowledge.ask(&TurningForceRakeFor { rake: Degrees(0.0) })?.need("a rake of 0°")?;
        let straight = of_component(component, [straight.pz, straight.py, straight.px]);
        corrections.push((own / straight, reason));
    }
    for (correction, reason) in corrections {
        factor *= correction;
        because.push(reason);
    }
    Ok(Some(ForceLaw { law: PowerLaw { factor, depth: 1.0, speed: 0.0 }, because }))
}

/// Kmp of a row of `turning-force`: (σB/750)^n of steel, (HB/190)^n of iron, with the row's own n.
fn material(cut: &TurningCut<'_, '_>, row: &TurningForce<'_>) -> (f64, Because) {
    let ratio = match row.reference {
        Reference::Strength750 => cut.material.strength.to_f64() / 750.0,
        _ => cut.material.hardness.to_f64() / 190.0,
    };
    let factor = libm::pow(ratio, row.material_exponent);
    (factor, Because::row(row.row, shown("material-force-factor", factor)))
}

/// Kiv: of the tool's grades the first that `tool-material-factor` has for the material, relative to the grade of the
/// coefficients. A tool without a grade, or with exactly that grade, needs no factor.
pub(super) fn grade(cut: &TurningCut<'_, '_>, reference: &str) -> Tried<Option<(f64, Because)>, MissingFigure> {
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

/// A factor by the angle of the cutting edge.
pub(super) fn angle<'k, Q: Question>(
    cut: &TurningCut<'_, 'k>,
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
fn rake(cut: &TurningCut<'_, '_>, component: Component) -> Tried<(f64, Because), MissingFigure> {
    let clearance = cut.tool.insert_clearance().ok_or_else(|| Refusal::Not(cut.tool_lacks("insert")))?;
    let seat = cut.knowledge.find(|row: &InsertRake<'_>| row.clearance == clearance)?;
    let rake = seat.ok_or_else(|| Refusal::Not(cut.tool_lacks("rake")))?.rake;
    let row = cut.knowledge.ask(&TurningForceRakeFor { rake })?.need("this rake")?;
    let factor = of_component(component, [row.pz, row.py, row.px]);
    let note = shown("rake-force-factor", factor).with("angle", Decimal::from_f64_rounded(rake.0));
    Ok((factor, Because::row(row.row, note)))
}

/// The factor of a component, chosen from those of Pz, Py and Px.
const fn of_component(component: Component, [pz, py, px]: [f64; 3]) -> f64 {
    match component {
        Component::Main => pz,
        Component::Radial => py,
        Component::Axial => px,
    }
}

/// An angle for a query of the tables.
pub(super) fn degrees(angle: Decimal) -> Degrees {
    Degrees(angle.to_f64())
}

fn shown(code: &'static str, factor: f64) -> Note {
    Note::new(code).with("factor", round_to(factor, 3))
}
