//! Opening a hole with an end mill that goes round along circles.

use crate::error::{KnowledgeError, Refusal, Tried};
use crate::knowledge::units::Unit;
use crate::knowledge::{Input, RowRef};
use crate::note::{Because, Note};
use crate::plan;
use crate::reason::Uncut;
use crate::shop::Shop;
use crate::units::{Decimal, MetresPerMinute, Micrometres, MillimetresPerRev, Minutes, round_to};

use super::figures::{self, missing, number};
use super::{Cut, CutterShape, Draft, Loads, Motion, PowerLaw, factors};

/// The kind of mill in the milling tables: a solid end mill.
const MILL: &str = "end";

/// Conditions of milling a hole round (Косилова/Мещеряков т.2; facts 1.9).
///
/// - V = Cv·D^q / (T^m·t^x·sz^y·B^u·z^p)·Kv, m/min, with Kv = Kmv·Kpv;
/// - Pz = 10·Cp·t^x·sz^y·B^u·z / (D^q·n^w)·Kmp, N, with n the step that is driven; the torque is Pz·D/2000, N·m. No thrust is known;
/// - D is the mill's diameter, t the radial depth of one pass, B the axial depth of one level, all in mm;
///   sz in mm/tooth, T in min, z the number of teeth.
///
/// sz is meant where the teeth meet the wall. The mill's centre goes round a smaller circle than the wall,
/// so its feed is smaller too: s = sz·z·(d1 - D)/d1, mm/rev, with d1 the diameter that the first and
/// narrowest pass leaves; all passes are made with it.
pub(super) fn draft(cut: &Cut<'_>, taken: Option<MillimetresPerRev>, shop: &Shop<'_>) -> Tried<Draft, Uncut> {
    let whole = |mill: &CutterShape| {
        mill.teeth > 0 && mill.diameter > Micrometres::ZERO && mill.cutting_length > Micrometres::ZERO
    };
    let mill = cut.cutter.filter(whole).ok_or(Refusal::Not(Uncut::NoCutterShape))?;
    if mill.diameter >= cut.from {
        return Err(Refusal::Not(Uncut::MillDoesNotEnter { diameter: mill.diameter, hole: cut.from }));
    }
    let (rounds, reason) = rounds(cut, mill, shop)?;
    let mut because = vec![reason];
    let (tabulated, reasons) = feed_per_tooth(cut, mill, shop)?;
    because.extend(reasons);
    // Centre feed per revolution over feed per tooth at the wall.
    let ratio = f64::from(mill.teeth) * rounds.centre_share;
    let tooth_feed = taken.map_or(tabulated, |feed| feed.0 / ratio);
    let (life, reasons) = tool_life(cut, mill, shop)?;
    because.extend(reasons);

    let (d, z) = (mill.diameter.to_mm(), f64::from(mill.teeth));
    let (t, b) = (rounds.radial_depth, rounds.axial_depth);
    let mill_input = ("mill", Input::Text(MILL));
    let tool = ("tool_material", Input::Text(cut.tool_material));
    let by_feed = Input::Number(Decimal::from_f64_rounded(tooth_feed), Unit::MillimetrePerTooth);
    let figures = figures::ask("milling-speed", &[mill_input, tool, ("feed_per_tooth", by_feed)], shop)?;
    let row = figures.row;
    because.extend(figures.because(Note::new("speed-coefficients").with("cv", number(row, "cv")?)));
    let mut speed = number(row, "cv")? * libm::pow(d, number(row, "q")?)
        / (libm::pow(life, number(row, "m")?)
            * libm::pow(t, number(row, "x")?)
            * libm::pow(tooth_feed, number(row, "y")?)
            * libm::pow(b, number(row, "u")?)
            * libm::pow(z, number(row, "p")?));
    let life_exponent = number(row, "m")?;
    let mut corrections = vec![factors::surface(cut.surface, shop)?];
    if figures.own() {
        corrections.push(factors::material_speed("milling", cut.tool_material, shop)?);
    }
    for (factor, reason) in corrections {
        speed *= factor;
        because.push(reason);
    }

    let mut loads = Loads::default();
    // Without a row of forces the pass is still cut; its torque is left out and not guessed.
    if let Ok(figures) = Refusal::split(figures::ask("milling-force", &[mill_input, tool], shop))? {
        let row = figures.row;
        let w = number(row, "w")?;
        // n^w as (n/V)^w·V^w, for the speed that is driven.
        let turns = super::rpm_at(MetresPerMinute(1.0), mill.diameter);
        let mut force =
            10.0 * number(row, "cp")? * libm::pow(t, number(row, "x")?) * libm::pow(b, number(row, "u")?) * z
                / (libm::pow(d, number(row, "q")?) * libm::pow(turns.0, w));
        if figures.own() {
            let (factor, reason) = factors::material_force("milling", cut.tool_material, shop)?;
            force *= factor;
            because.push(reason);
        }
        because.extend(figures.because(Note::new("milling-load-coefficients")));
        let exponent = number(row, "y")?;
        let factor = force * d / 2000.0 / libm::pow(ratio, exponent);
        loads.torque = Some(PowerLaw { factor, exponent, of_speed: -w });
    }
    Ok(Draft {
        feed: MillimetresPerRev(tooth_feed * ratio),
        speed: MetresPerMinute(speed),
        tool_life: Minutes(life),
        life_exponent,
        coolant: None,
        loads,
        motion: Motion { turned: mill.diameter, depth_of_cut: t, path: rounds.path, synchronous: false },
        because,
        doubts: Vec::new(),
        card: None,
        rounds: Some(rounds.planned),
    })
}

/// The circles of one hole.
struct Rounds {
    /// t, radial depth of one pass, mm.
    radial_depth: f64,
    /// B, axial depth of one level, mm.
    axial_depth: f64,
    /// Radius of the centre's first circle over that of the wall.
    centre_share: f64,
    /// Length of all moves at the working feed, mm.
    path: f64,
    /// The same, as the plan tells it.
    planned: plan::Rounds,
}

/// Divides the stock into radial passes and axial levels (table `milling-depth`), and measures the path.
///
/// 1. approach and descent along the hole's axis, `travel` in all;
/// 2. at each level and for each pass: out from the axis to the circle, radius (di - D)/2;
/// 3. once round, π·(di - D);
/// 4. back to the axis.
fn rounds(cut: &Cut<'_>, mill: CutterShape, shop: &Shop<'_>) -> Result<(Rounds, Because), KnowledgeError> {
    let table = shop.knowledge.table("milling-depth")?;
    let share = |name: &str| -> Result<(RowRef<'_>, f64), KnowledgeError> {
        let row = table.find("name", name).ok_or_else(|| KnowledgeError::no_row(table, name))?;
        Ok((row, number(row, "share")?))
    };
    let d = mill.diameter.to_mm();
    let (row, radial) = share("radial")?;
    let (_, axial) = share("axial")?;
    let stock = (cut.diameter - cut.from).to_mm() / 2.0;
    let passes = parts(stock, radial * d).max(cut.passes);
    let deepest = mill.cutting_length.to_mm().min(axial * d);
    let levels = parts(cut.depth.to_mm(), deepest);
    let radial_depth = stock / f64::from(passes);
    let circles: f64 = (1..=passes).map(|pass| cut.from.to_mm() + 2.0 * radial_depth * f64::from(pass) - d).sum();
    let path = f64::from(levels) * circles * (std::f64::consts::PI + 1.0) + cut.travel.to_mm();
    let first = cut.from.to_mm() + 2.0 * radial_depth;
    let axial_depth = cut.depth.to_mm() / f64::from(levels);
    let centre_share = (first - d) / first;
    let note = Note::new("milling-rounds")
        .with("passes", passes)
        .with("levels", levels)
        .with("t", round_to(radial_depth, 3))
        .with("b", round_to(axial_depth, 3))
        .with("path", round_to(path, 1))
        .with("factor", round_to(centre_share, 3));
    let planned = plan::Rounds { from_diameter_mm: cut.from, mill_diameter_mm: mill.diameter, passes, levels };
    Ok((Rounds { radial_depth, axial_depth, centre_share, path, planned }, Because::row(row, note)))
}

/// In how many equal parts, at least one, a length is cut so that none is longer than `longest`.
fn parts(length: f64, longest: f64) -> u32 {
    // A micrometre of slack, so that 10 mm in steps of 5 are two parts whatever the last bit says.
    libm::ceil((length - 0.001) / longest).max(1.0) as u32
}

/// sz by the mill's diameter (table `end-mill-feed`); of the last pass less, for the roughness it must
/// leave (table `milling-finish-feed`).
fn feed_per_tooth(cut: &Cut<'_>, mill: CutterShape, shop: &Shop<'_>) -> Tried<(f64, Vec<Because>), Uncut> {
    let figures = figures::ask("end-mill-feed", &[("diameter", Input::Length(mill.diameter))], shop)?;
    let mut feed = figures.row.number_in("feed_per_tooth", Unit::MillimetrePerTooth)?;
    let mut because = figures.because(Note::new("feed-per-tooth").with("feed", feed));
    if let Some(roughness) = cut.roughness {
        let table = shop.knowledge.table("milling-finish-feed")?;
        let answer = table.decide(&[("roughness", Input::Roughness(roughness))])?;
        let row = answer.winner().ok_or_else(|| missing(table, shop))?;
        let factor = number(row, "factor")?;
        feed *= factor;
        let note = Note::new("milling-finish-feed").with("factor", factor).with("roughness", roughness);
        because.push(Because::row(row, note));
    }
    Ok((feed, because))
}

/// T of an end mill (table `milling-tool-life`), beyond it by `tool-life-beyond`.
fn tool_life(cut: &Cut<'_>, mill: CutterShape, shop: &Shop<'_>) -> Tried<(f64, Vec<Because>), Uncut> {
    let table = shop.knowledge.table("milling-tool-life")?;
    let diameter = ("diameter", Input::Length(mill.diameter));
    let answer = table.decide(&[("mill", Input::Text(MILL)), diameter])?;
    let shown = |row: RowRef<'_>| -> Result<(f64, Note), KnowledgeError> {
        let life = row.number_in("life", Unit::Minute)?;
        Ok((life, Note::new("tool-life").with("minutes", life)))
    };
    if let Some(row) = answer.winner() {
        let (life, note) = shown(row)?;
        return Ok((life, vec![Because::row(row, note)]));
    }
    let operation = ("operation", Input::Text(cut.operation.name()));
    let tool = ("tool_material", Input::Text(cut.tool_material));
    let figures = figures::ask("tool-life-beyond", &[operation, tool, diameter], shop)?;
    let (life, note) = shown(figures.row)?;
    Ok((life, figures.because(note)))
}
