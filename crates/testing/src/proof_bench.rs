//! A part as the programs of a control are compared with it.

use technolog::job::{self, Job};
use technolog::machine::Machine;
use technolog::motion::time::Clock;
use technolog::motion::{MotionStep, Position};
use technolog::part::Part;
use technolog::plan::{CuttingMethod, Plan};
use technolog::program::proof::{Proof, ProofInput, Tolerated, prove};
use technolog::program::written::Form;
use technolog::program::{Fault, Language, Setting};
use technolog::shop::Shop;
use technolog::units::Micrometres;

use super::mutants::Run;
use super::{KNOWLEDGE, planned, read, root};

pub struct ProofBench {
    pub plan: Plan,
    pub job: Job,
    pub machine: Machine<'static>,
    pub setting: Setting,
    pub own_correctors: bool,
    pub tolerated: Tolerated,
    form: Form,
}

impl ProofBench {
    /// The part of a file, by its path from the root of the project.
    pub fn new(path: &str) -> Self {
        Self::of(&read(&std::fs::read_to_string(root().join(path)).unwrap()))
    }

    pub fn of(part: &Part) -> Self {
        Self::of_plan(planned(part, CuttingMethod::default()))
    }

    /// A plan as it was once made: what programs are compared with does not change with planning.
    pub fn of_plan(plan: Plan) -> Self {
        let shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
        Self::in_shop(plan, shop)
    }

    /// The part of a file, made with a magazine of so many places.
    pub fn with_magazine(path: &str, places: u32) -> Self {
        let part = read(&std::fs::read_to_string(root().join(path)).unwrap());
        let mut plan = planned(&part, CuttingMethod::default());
        for tool in &mut plan.tools {
            tool.load = (tool.number - 1) / places + 1;
        }
        let mut shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
        shop.machine.magazine = places as usize;
        Self::in_shop(plan, shop)
    }

    fn in_shop(plan: Plan, shop: Shop<'static>) -> Self {
        let job = job::make(&plan, &shop).unwrap();
        let setting = Setting::of_job(&job);
        let tolerated = Tolerated::read(&plan.part, &KNOWLEDGE).unwrap();
        let form = Form::read(&shop).unwrap();
        Self { plan, job, machine: shop.machine, setting, own_correctors: false, tolerated, form }
    }

    /// With the operator's own correctors: numbers and micrometres.
    pub fn with_correctors(mut self, correctors: &[(u32, i64)]) -> Self {
        self.setting.correctors =
            correctors.iter().map(|(number, value)| (*number, Micrometres::new(*value))).collect();
        self.own_correctors = true;
        self
    }

    /// The job for that control, which leaves out what the control cannot do.
    pub fn job_for(&self, language: &Language) -> Job {
        self.planned_for(language).map_or_else(|| self.job.clone(), |(_, job)| job)
    }

    /// The plan and job for that control, where it leaves something out.
    fn planned_for(&self, language: &Language) -> Option<(Plan, Job)> {
        let mut plan = self.plan.clone();
        if !language.leave(&mut plan) {
            return None;
        }
        let mut shop = Shop::new(&plan.part, plan.cutting, &KNOWLEDGE).unwrap();
        shop.machine.magazine = self.machine.magazine;
        let job = job::make(&plan, &shop).unwrap();
        Some((plan, job))
    }

    /// The program that is written for it.
    pub fn written(&self, language: &Language) -> String {
        language.write(&self.job_for(language), self.form).text()
    }

    /// The same with a number of its own, and with or without subprograms.
    pub fn written_as(&self, language: &Language, program: Option<u32>, subprograms: bool) -> String {
        language.write(&self.job_for(language), Form { program, subprograms, ..self.form }).text()
    }

    /// What the proof says of a program, by its codes.
    pub fn codes(&self, language: &Language, text: &str) -> Vec<&'static str> {
        self.run(language, text).1.findings.iter().map(|finding| finding.code.name()).collect()
    }

    pub fn run(&self, language: &Language, text: &str) -> (Vec<Fault>, Proof, Run) {
        let own = self.planned_for(language);
        let setting = match &own {
            Some((_, job)) if !self.own_correctors => Setting::of_job(job),
            _ => self.setting.clone(),
        };
        let mut sink = (Vec::<MotionStep>::new(), Clock::new(&self.machine, setting.start));
        let faults = language.check(text, &self.machine, &setting, &mut sink);
        let (steps, clock) = sink;
        let (plan, job) = own.as_ref().map_or((&self.plan, &self.job), |(plan, job)| (plan, job));
        let zeros: Vec<Position> = job.setups.iter().map(|setup| setup.zero).collect();
        let tap_word = language.tap_word();
        let input = ProofInput {
            plan,
            job,
            zeros: &zeros,
            start: self.setting.start,
            tolerated: &self.tolerated,
            tap_word: tap_word.as_deref(),
            turning_at_change: language.turning_at_change(),
            own_correctors: self.own_correctors,
        };
        let proof = prove(&steps, &input);
        let texts = faults.iter().map(|fault| format!("{:?} {:?}", fault.severity, fault.note));
        let texts =
            texts.chain(proof.findings.iter().map(|finding| format!("{:?} {:?}", finding.severity, finding.note)));
        let run = Run::of(&steps, self.setting.start, texts, format!("{:?}", clock.times()));
        (faults, proof, run)
    }
}
