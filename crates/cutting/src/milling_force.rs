//! The torque of an end mill: by the handbook's main force, or by the specific cutting force of the grade.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::vocabulary::ToolMaterial;
use crate::note::{Because, Note};
use crate::practice_speed::practice_group;
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::tables::cutting::{Mill, MillingForceFor, Process};
use crate::tables::practice::SpecificCuttingForceFor;
use crate::units::MetresPerMinute;

use super::{CutterShape, PowerLaw, factors, figures};

/// One pass of a mill at one level.
pub(super) struct MilledPass {
    /// The kind of mill.
    pub mill: Mill,
    /// Material of its teeth.
    pub tool_material: ToolMaterial,
    /// Its shape.
    pub shape: CutterShape,
    /// t, radial depth, mm.
    pub radial_depth: f64,
    /// B, axial depth, mm.
    pub axial_depth: f64,
    /// Feed of the centre per revolution over the feed per tooth at the wall.
    pub feed_ratio: f64,
}

/// The torque by the feed of the centre, mm/rev, and its reasons; none where no table knows a force.
///
/// Pz = 10·Cp·t^x·sz^y·B^u·z / (D^q·n^w)·Kmp, N, and Pz·D/2000, N·m (Косилова/Мещеряков т.2, facts 1.9; table
/// `milling-force`). Where neither the grade's group nor what stands in for it has a row: [`specific`].
pub(super) fn torque(pass: &MilledPass, shop: &Shop<'_>) -> Tried<Option<(PowerLaw, Vec<Because>)>, Uncut> {
    let &MilledPass { mill, tool_material, .. } = pass;
    let question = |material_group| MillingForceFor { mill, material_group, tool_material };
    let Ok(figures) = Refusal::split(figures::ask(question, shop))? else { return Ok(specific(pass, shop)?) };
    let (row, mut because) = (&figures.row, Vec::new());
    let (d, z) = (pass.shape.diameter.to_mm(), f64::from(pass.shape.teeth));
    // n^w as (n/V)^w·V^w, for the speed used.
    let turns = super::rpm_at(MetresPerMinute(1.0), pass.shape.diameter);
    let mut force = 10.0 * row.cp * libm::pow(pass.radial_depth, row.x) * libm::pow(pass.axial_depth, row.u) * z
        / (libm::pow(d, row.q) * libm::pow(turns.0, row.w));
    if figures.is_own_group() {
        let (factor, reason) = factors::material_force(Process::Milling, tool_material, shop)?;
        force *= factor;
        because.push(reason);
    }
    because.extend(figures.because(Note::new("milling-load-coefficients")));
    let factor = force * d / 2000.0 / libm::pow(pass.feed_ratio, row.y);
    Ok(Some((PowerLaw { factor, exponent: row.y, of_speed: -row.w }, because)))
}

/// The torque by the specific cutting force of the grade's group of VDI 3323:
///
/// M = kc1·hm^-mc·t·B·sz·z / (2000·π), N·m, which is the power t·B·F·kc over the angular speed, with the mean thickness
/// of the chip hm = 2·t·sz / (D·arccos(1 − 2·t/D)), the area t·sz of a chip over its length; lengths in mm, sz in
/// mm/tooth, kc1 in MPa. For a shallow cut hm is the sz·√(t/D) of makers
/// (docs.steelcam.org/dijet/obshij-katalog-dijet-2018-page551; table `specific-cutting-force`).
fn specific(pass: &MilledPass, shop: &Shop<'_>) -> Result<Option<(PowerLaw, Vec<Because>)>, KnowledgeError> {
    let Some(group) = practice_group(&shop.material, shop.knowledge)? else { return Ok(None) };
    let Some(row) = shop.knowledge.ask(&SpecificCuttingForceFor { vdi: group.vdi })?.winner()? else { return Ok(None) };
    let (d, z) = (pass.shape.diameter.to_mm(), f64::from(pass.shape.teeth));
    let engaged = libm::acos(1.0 - 2.0 * (pass.radial_depth / d).min(1.0));
    let thickness = 2.0 * pass.radial_depth / (d * engaged);
    let of_tooth = row.kc1.0.to_f64() * libm::pow(thickness, -row.mc) * pass.radial_depth * pass.axial_depth * z
        / (2000.0 * std::f64::consts::PI);
    let exponent = 1.0 - row.mc;
    let note = Note::new("specific-force").with("group", group.vdi).with("kc", row.kc1.0).with("mc", row.mc);
    let law = PowerLaw::of_feed(of_tooth / libm::pow(pass.feed_ratio, exponent), exponent);
    Ok(Some((law, vec![Because::row(row.row, note)])))
}
