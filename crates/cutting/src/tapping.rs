//! Tapping.

use crate::error::{Refusal, Tried};
use crate::note::{Because, Note};
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::tables::cutting::{Process, TappingSpeedFor, TappingTorqueFor};
use crate::units::{MetresPerMinute, MillimetresPerRev, Minutes, NewtonMetres};

use super::figures::{self, Asking};
use super::{Cut, CutMotion, DraftConditions, Loads, PowerLaw, factors};

/// Speed and torque of a machine tap, whatever turns: the tap or the part.
#[derive(Clone, Debug)]
pub struct Tapping {
    /// The speed of the formula, m/min.
    pub speed: MetresPerMinute,
    /// The tool life of that speed.
    pub life: Minutes,
    /// m of V ~ 1/T^m.
    pub life_exponent: f64,
    /// The torque; none where no row of it is known.
    pub torque: Option<NewtonMetres>,
    /// Its factor and the exponent of the pitch, which is the feed.
    torque_law: Option<(f64, f64)>,
    /// The rows behind both.
    pub because: Vec<Because>,
}

/// Speed and torque of a machine tap (Косилова/Мещеряков т.2, tables 49, 51, from memory).
///
/// - the feed is the pitch P, mm/rev;
/// - V = Cv·D^q / (T^m·P^y)·Kmv, m/min;
/// - M = 10·Cm·D^q·P^y·Kp, N·m; a tap pulls itself in, so no thrust is known;
/// - D is the thread's nominal diameter and P its pitch, mm; T in min.
///
/// Kmv and Kp are those of drilling, by the rule `stand-in-operation`. Without a row of torque the thread is cut all the same; its
/// torque is left out, not guessed.
///
/// # Errors
/// The cut has no pitch; the tables have no figures for the material, or the knowledge base has no answer at all.
pub fn law<'k>(cut: &Cut, shop: &impl Asking<'k>) -> Tried<Tapping, Uncut> {
    let pitch = cut.pitch.ok_or(Refusal::Not(Uncut::NoPitch))?;
    let (d, p) = (cut.diameter.to_mm(), pitch.to_mm());
    let tool_material = cut.tool_material;
    let figures = figures::ask(|material_group| TappingSpeedFor { material_group, tool_material }, shop)?;
    let row = &figures.row;
    let note = Note::new("tapping-coefficients").with("cv", row.cv).with("minutes", row.life.0);
    let mut because = figures.because(note);
    because.push(Because::row(row.row, Note::new("feed-is-pitch").with("pitch", pitch)));
    because.push(figures::stand_in_operation(cut.operation, shop)?.1);
    let mut speed = row.cv * libm::pow(d, row.q) / (libm::pow(row.life.0, row.m) * libm::pow(p, row.y));
    if figures.is_own_group() {
        let (factor, reason) = factors::material_speed(Process::Drilling, tool_material, shop)?;
        speed *= factor;
        because.push(reason);
    }

    let mut torque_law = None;
    let question = |material_group| TappingTorqueFor { material_group, tool_material };
    if let Ok(figures) = Refusal::split(figures::ask(question, shop))? {
        let row = &figures.row;
        let mut factor = 10.0 * row.cm * libm::pow(d, row.q);
        if figures.is_own_group() {
            let (material, reason) = factors::material_force(Process::Drilling, tool_material, shop)?;
            factor *= material;
            because.push(reason);
        }
        because.extend(figures.because(Note::new("tapping-load-coefficients")));
        torque_law = Some((factor, row.y));
    }
    Ok(Tapping {
        speed: MetresPerMinute(speed),
        life: row.life,
        life_exponent: row.m,
        torque: torque_law.map(|(factor, y)| NewtonMetres(factor * libm::pow(p, y))),
        torque_law,
        because,
    })
}

/// Conditions of a machine tap. It goes in, the spindle reverses, and it comes out at the same feed rate: the path is twice the
/// travel.
pub(super) fn draft(cut: &Cut, shop: &Shop<'_>) -> Tried<DraftConditions, Uncut> {
    let Tapping { speed, life, life_exponent, torque_law, because, .. } = law(cut, shop)?;
    let feed = MillimetresPerRev(cut.pitch.unwrap_or_default().to_mm());
    let torque = torque_law.map(|(factor, exponent)| PowerLaw::of_feed(factor, exponent));
    let along = CutMotion::along_axis(cut);
    Ok(DraftConditions {
        feed,
        speed,
        fastest: None,
        tool_life: life,
        life_exponent,
        coolant: None,
        loads: Loads { torque, ..Loads::default() },
        motion: CutMotion { path: 2.0 * along.path, synchronous: true, ..along },
        because,
        doubts: Vec::new(),
        card: None,
        rounds: None,
        plunge: None,
        arcs: Vec::new(),
    })
}
