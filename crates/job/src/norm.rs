//! The norm of time of an operation: per piece, and with the share of the lot's preparation.
//!
//! The formulas are those of every text on norms of machining (largeeconomic.ru/laecos-249-2.html, formulas 24 to 26, has all
//! of them with figures): time per piece Tp = (Tb + Ta)·(1 + (service + rest)/100), with the lot Tp + Tset/n. The times of manual
//! work are those of the tables `loading-time` and `time-norms`, or what the shop gives.

use serde::{Serialize, Serializer};

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::note::{Because, Note};
use crate::part::Hole;
use crate::plan::Plan;
use crate::tables::practice::{LoadedBy, LoadingTimeFor, TimeNorm, TimeNorms};
use crate::tables::rules::HeldBy;
use crate::units::{Kilograms, Minutes};
use crate::zone::mass;

use super::Job;

/// How many clamps the time of loading under straps has.
const CLAMPS: usize = 3;

/// What the shop knows better than a table.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GivenTimes {
    /// Parts of a lot.
    pub lot: Option<u32>,
    /// To load, clamp and unload a part, min.
    pub loading: Option<Minutes>,
    /// To prepare and to close a lot, min.
    pub preparatory: Option<Minutes>,
}

/// An element of the norm.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NormItem {
    /// The key of its words.
    pub key: &'static str,
    /// How often it is done.
    pub count: usize,
    /// How long it takes each time, min.
    #[serde(rename = "each_min")]
    pub each: Minutes,
    /// Its row; absent for what the shop gives and what the plan has.
    pub because: Option<Because>,
}

impl NormItem {
    /// All of it, min.
    pub fn total(&self) -> Minutes {
        Minutes(self.each.0 * self.count as f64)
    }
}

/// The work of an operation, whatever planned it.
#[derive(Clone, Debug, PartialEq)]
pub struct NormedWork {
    /// Cutting, Tb.
    pub cutting: Minutes,
    /// What the machine does beside cutting.
    pub machine: Minutes,
    /// The operator's hands while the program waits.
    pub hands: Minutes,
    /// Loading; none where nobody knows how long it takes.
    pub loading: Vec<NormItem>,
    /// How each gauged place is gauged.
    pub gauges: Vec<TimeNorm>,
    /// How often the machine is set for a lot.
    pub settings: usize,
    /// How often soft jaws are bored for a lot.
    pub soft_jaws: usize,
    /// The tools that are put in.
    pub tools: usize,
    /// The zeros that are set.
    pub zeros: usize,
}

/// The hundredths of a share without their row.
fn share<S: Serializer>(share: &(f64, Because), serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_f64(share.0)
}

/// The norm of time of an operation, min.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Norm {
    /// Cutting, Tb.
    #[serde(rename = "basic_min")]
    pub basic: Minutes,
    /// What the machine does beside cutting: rapids, tool changes, dwells.
    #[serde(rename = "machine_min")]
    pub machine: Minutes,
    /// The operator's hands while the program waits.
    #[serde(rename = "hands_min")]
    pub hands: Minutes,
    /// Loading, and of gauging what does not go on while the machine cuts the next part.
    pub of_piece: Vec<NormItem>,
    /// Gauging of holes: it goes on while the machine cuts the next part.
    pub gauging: Vec<NormItem>,
    /// Gauging that is longer than the program.
    #[serde(rename = "gauging_beyond_min")]
    pub gauging_beyond: Minutes,
    /// The auxiliary time Ta: all of the above but cutting; absent where nobody knows how long loading takes.
    #[serde(rename = "auxiliary_min")]
    pub auxiliary: Option<Minutes>,
    /// Looking after the place of work, in hundredths of Tb + Ta.
    #[serde(rename = "service_percent", serialize_with = "share")]
    pub service: (f64, Because),
    /// Rest and needs, in hundredths of Tb + Ta.
    #[serde(rename = "rest_percent", serialize_with = "share")]
    pub rest: (f64, Because),
    /// Time per piece.
    #[serde(rename = "piece_min")]
    pub piece: Option<Minutes>,
    /// The elements of preparation of a lot.
    pub of_lot: Vec<NormItem>,
    /// Their sum, Tset.
    #[serde(rename = "preparatory_min")]
    pub preparatory: Minutes,
    /// The number of parts of a lot.
    pub lot: Option<u32>,
    /// Time per piece with the share of the lot's preparation.
    #[serde(rename = "with_lot_min")]
    pub with_lot: Option<Minutes>,
}

impl Norm {
    /// Whether the figure of a table that no source confirms is in the time per piece; then in the preparatory time.
    pub fn unconfirmed(&self) -> [bool; 2] {
        let of = |items: &[NormItem]| items.iter().filter_map(|item| item.because.as_ref()).any(is_doubtful);
        let shares = [&self.service.1, &self.rest.1].into_iter().any(is_doubtful);
        [of(&self.of_piece) || shares, of(&self.of_lot)]
    }
}

fn is_doubtful(because: &Because) -> bool {
    because.unconfirmed.is_some()
}

/// The figures of `time-norms`.
struct Figures<'k>(&'k Knowledge);

impl Figures<'_> {
    fn figure(&self, name: TimeNorm) -> Result<(f64, Because), KnowledgeError> {
        let row = self.0.need(name.name(), |row: &TimeNorms<'_>| row.name == name)?;
        if row.unit != name.unit() {
            let problem = technolog_note::note!("nc-must", value = name.name(), unit = name.unit());
            return Err(KnowledgeError::missing(&row.row.table.id, problem));
        }
        Ok((row.value, Because::row(row.row, Note::new("time-norm"))))
    }

    fn item(&self, key: &'static str, name: TimeNorm, count: usize) -> Result<NormItem, KnowledgeError> {
        let (value, because) = self.figure(name)?;
        Ok(NormItem { key, count, each: Minutes(value), because: Some(because) })
    }
}

/// The norm of time of a plan and its job.
///
/// # Errors
/// A table lacks a figure.
pub fn norm(plan: &Plan, job: &Job, given: GivenTimes, knowledge: &Knowledge) -> Result<Norm, KnowledgeError> {
    let time = &plan.time;
    let work = NormedWork {
        cutting: time.machine_min,
        machine: time.feed_out_min + time.dwell_min + time.rapid_min + time.tool_change_min,
        hands: time.hand_min,
        loading: loading(plan, &Figures(knowledge))?,
        gauges: gauges(plan),
        settings: 1,
        soft_jaws: 0,
        tools: plan.tools.iter().filter(|tool| tool.number > 0).count(),
        zeros: job.setups.len(),
    };
    norm_of(work, given, knowledge)
}

/// The norm of time of any work.
///
/// # Errors
/// A table lacks a figure.
pub fn norm_of(work: NormedWork, given: GivenTimes, knowledge: &Knowledge) -> Result<Norm, KnowledgeError> {
    let figures = Figures(knowledge);
    let (cutting, machine, hands) = (work.cutting, work.machine, work.hands);
    let program = cutting + machine + hands;
    let gauging = gauging(&work.gauges, &figures)?;
    let beyond = Minutes((sum(&gauging).0 - program.0).max(0.0));
    let (service, rest) = (figures.figure(TimeNorm::Service)?, figures.figure(TimeNorm::Rest)?);
    let of_lot = preparation(&work, given, program, &figures)?;
    let of_piece = match given.loading {
        Some(each) => vec![NormItem { key: "norm-loading", count: 1, each, because: None }],
        None => work.loading,
    };
    let known = !of_piece.is_empty();
    let auxiliary = known.then(|| (machine + hands + sum(&of_piece) + beyond).rounded(2));
    let piece = auxiliary.map(|auxiliary| per_piece(cutting + auxiliary, service.0 + rest.0));
    let preparatory = sum(&of_lot).rounded(2);
    let lot = given.lot.filter(|lot| *lot > 0);
    let with_lot = piece.zip(lot).map(|(piece, lot)| with_share(piece, preparatory, lot));
    Ok(Norm {
        basic: cutting,
        machine: machine.rounded(2),
        hands,
        of_piece,
        gauging,
        gauging_beyond: beyond.rounded(2),
        auxiliary,
        service,
        rest,
        piece,
        of_lot,
        preparatory,
        lot,
        with_lot,
    })
}

/// Time per piece: Tp = Top·(1 + a/100), Top the time at work, a service and rest in hundredths of it.
fn per_piece(operative: Minutes, percent: f64) -> Minutes {
    Minutes(operative.0 * (1.0 + percent / 100.0)).rounded(2)
}

/// Time per piece with the share of the lot: Tp + Tset/n.
fn with_share(piece: Minutes, preparatory: Minutes, lot: u32) -> Minutes {
    Minutes(piece.0 + preparatory.0 / f64::from(lot)).rounded(2)
}

fn sum(items: &[NormItem]) -> Minutes {
    items.iter().map(NormItem::total).sum()
}

/// The elements of loading; none where the part is held by what no table has.
fn loading(plan: &Plan, figures: &Figures<'_>) -> Result<Vec<NormItem>, KnowledgeError> {
    let held = match plan.setup.fixture.as_ref().map(|fixture| fixture.held) {
        Some(HeldBy::Straps) => LoadedBy::Straps,
        Some(HeldBy::Vice) => LoadedBy::Vice,
        Some(HeldBy::Chuck) => LoadedBy::Chuck,
        Some(HeldBy::Nothing | HeldBy::Own) | None => return Ok(Vec::new()),
    };
    let Some(mass) = mass(&plan.part, figures.0)? else { return Ok(Vec::new()) };
    let answer = figures.0.ask(&LoadingTimeFor { held, mass: Kilograms(mass.most) })?;
    // A part heavier than the table has no time.
    let Some(row) = answer.winner()? else { return Ok(Vec::new()) };
    let because = Because::row(row.row, Note::new("time-norm"));
    let mut items =
        vec![NormItem { key: "norm-loading", count: 1, each: Minutes(row.time.0 / 60.0), because: Some(because) }];
    let clamps = plan.clamping.as_ref().map_or(0, |clamping| clamping.clamps.len());
    if held == LoadedBy::Straps && clamps > CLAMPS {
        items.push(figures.item("norm-more-clamps", TimeNorm::MoreClamp, clamps - CLAMPS)?);
    }
    Ok(items)
}

/// A plug in each hole: of a thread, of a coarse or of a fine grade.
fn gauges(plan: &Plan) -> Vec<TimeNorm> {
    // What another machine finishes is gauged there.
    let is_finished = |hole: &&Hole| {
        let own = plan.holes.iter().find(|own| own.name == hole.name);
        own.is_some_and(|own| own.transitions.iter().all(|one| !one.elsewhere))
    };
    let plug = |hole: &Hole| match &hole.thread {
        Some(_) => TimeNorm::ThreadPlug,
        None => TimeNorm::plug(hole.diameter.it),
    };
    let holes = plan.part.holes.iter().filter(is_finished);
    holes.flat_map(|hole| hole.at.iter().map(move |_| plug(hole))).collect()
}

/// The elements of gauging, kind by kind.
fn gauging(gauges: &[TimeNorm], figures: &Figures<'_>) -> Result<Vec<NormItem>, KnowledgeError> {
    let kinds = [
        ("norm-plug-coarse", TimeNorm::PlugCoarse),
        ("norm-plug-fine", TimeNorm::PlugFine),
        ("norm-thread-plug", TimeNorm::ThreadPlug),
    ];
    let counted = kinds.map(|(key, name)| (key, name, gauges.iter().filter(|gauge| **gauge == name).count()));
    counted
        .into_iter()
        .filter(|(.., count)| *count > 0)
        .map(|(key, name, count)| figures.item(key, name, count))
        .collect()
}

/// The elements of preparing a lot, the trial run of the program among them.
fn preparation(
    work: &NormedWork,
    given: GivenTimes,
    program: Minutes,
    figures: &Figures<'_>,
) -> Result<Vec<NormItem>, KnowledgeError> {
    if let Some(each) = given.preparatory {
        return Ok(vec![NormItem { key: "norm-preparatory", count: 1, each, because: None }]);
    }
    let (tools_of_set_up, _) = figures.figure(TimeNorm::SetUpTools)?;
    let more = work.tools.saturating_sub(tools_of_set_up as usize);
    let mut items = vec![
        figures.item("norm-receive-order", TimeNorm::ReceiveOrder, 1)?,
        figures.item("norm-study-order", TimeNorm::StudyOrder, 1)?,
        figures.item("norm-instruction", TimeNorm::Instruction, 1)?,
        figures.item("norm-set-up", TimeNorm::SetUp, work.settings)?,
        figures.item("norm-tool", TimeNorm::Tool, more)?,
        figures.item("norm-soft-jaws", TimeNorm::SoftJaws, work.soft_jaws)?,
        figures.item("norm-zeros", TimeNorm::Zeros, work.zeros)?,
        NormItem { key: "norm-trial", count: 1, each: program.rounded(2), because: None },
    ];
    items.retain(|item| item.count > 0);
    Ok(items)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The worked example of largeeconomic.ru/laecos-249-2.html: 3.36 min at work with 4 % and 4 %, which it rounds each to 0.13 min.
    #[test]
    fn a_published_norm_comes_out() {
        let piece = per_piece(Minutes(3.36), 8.0);
        assert!((piece.0 - 3.62).abs() < 0.011, "{piece:?}");
        // 18/28 is 0.64; the page adds 0.70, a slip of its own.
        let with_lot = with_share(Minutes(3.62), Minutes(18.0), 28);
        assert!((with_lot.0 - 4.26).abs() < 0.005, "{with_lot:?}");
    }
}
