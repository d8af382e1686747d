//! Deflection and stress of a turned part under the cutting force: the part is a beam in chuck or centres.
//!
//! The part is stepped, so its bending is integrated over its sections (Castigliano), each with its own diameter and
//! bore. Chuck and centres are assumed rigid; their compliance is not known for any lathe here.

use std::f64::consts::PI;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::note::{Because, Note};
use crate::tables::turning::part::{ElasticModulus, PartSupport};
use crate::turning::length::Half;
use crate::units::{Micrometres, Newtons};

/// A section of the part between two distances from the jaws (between centres, from the far one).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartSection {
    /// Where it begins.
    pub from: Half,
    /// Where it ends.
    pub to: Half,
    /// The least radius on it.
    pub radius: Half,
    /// The radius of the bore; zero for a solid part.
    pub bore: Half,
}

/// A part as it is held in a set-up.
#[derive(Clone, Debug)]
pub struct HeldPart {
    support: PartSupport,
    /// The distance of a steady rest from the jaws, mm.
    rest: Option<f64>,
    sections: Vec<PartSection>,
    /// E, MPa.
    modulus: f64,
    /// Tensile strength, MPa.
    strength: f64,
    because: Vec<Because>,
}

/// The compliance of a part over a range of it, at the place where it is largest.
#[derive(Clone, Debug)]
pub struct Flexibility {
    /// Compliance, mm per newton.
    compliance: f64,
    /// Its place, from the jaws, mm.
    at: f64,
    /// Stress, MPa per newton, at the place where it is largest.
    stress: f64,
    /// The tensile strength, MPa.
    pub(super) strength: f64,
    /// The tolerance of the diameter that the cut finishes; none for roughing.
    pub(super) tolerance: Option<Micrometres>,
    pub(super) because: Vec<Because>,
}

impl Flexibility {
    /// The deflection of the axis, mm.
    pub fn bend_mm(&self, force: Newtons) -> f64 {
        self.compliance * force.0
    }

    /// The largest bending stress, MPa.
    pub fn stress_mpa(&self, force: Newtons) -> f64 {
        self.stress * force.0
    }

    /// The force that causes this deflection.
    pub(super) fn force_to_bend(&self, mm: f64) -> Newtons {
        Newtons(mm / self.compliance)
    }

    /// The force that causes this stress, MPa.
    pub(super) fn force_to_stress(&self, mpa: f64) -> Newtons {
        Newtons(mpa / self.stress)
    }

    /// The place of the largest deflection, mm from the jaws.
    pub const fn at_mm(&self) -> f64 {
        self.at
    }
}

impl HeldPart {
    /// A part of a material with its sections, the first at the jaws. None without sections, or with a section that
    /// is no solid body.
    ///
    /// # Errors
    /// The knowledge base has no modulus of elasticity for the material's group.
    pub fn of(
        support: PartSupport,
        sections: Vec<PartSection>,
        material: &Material<'_>,
        knowledge: &Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        let body = |one: &PartSection| one.to > one.from && one.radius > one.bore && one.bore >= Half::ZERO;
        let sections: Vec<PartSection> = sections.into_iter().filter(|one| one.to > one.from).collect();
        if sections.is_empty() || !sections.iter().all(body) {
            return Ok(None);
        }
        let group = material.group;
        let row = knowledge.need(group, |row: &ElasticModulus<'_>| row.material_group == group)?;
        let modulus = row.modulus.0.to_f64();
        let because = vec![Because::row(row.row, Note::new("elastic-modulus").with("modulus", row.modulus.0))];
        let strength = material.strength.to_f64();
        Ok(Some(Self { support, rest: None, sections, modulus, strength, because }))
    }

    /// With a steady rest at a distance from the jaws, which holds the axis there.
    #[must_use]
    pub fn with_rest(self, at: Half) -> Self {
        Self { rest: Some(at.to_mm()).filter(|at| *at > 0.0 && *at < self.length_mm()), ..self }
    }

    /// How it is held.
    pub const fn support(&self) -> PartSupport {
        self.support
    }

    /// The free length, mm.
    pub fn length_mm(&self) -> f64 {
        self.sections.last().map_or(0.0, |last| last.to.to_mm())
    }

    /// Its free length divided by the diameter of a plain bar with the same deflection at mid-length (for a part in
    /// the chuck, at its free end).
    pub fn slenderness(&self) -> f64 {
        let (length, (compliance, _)) = (self.length_mm(), self.answers(self.weakest_point()));
        // Of a plain solid bar: compliance = L³ / (k·E·I), so d = (64·L³ / (k·π·E·compliance))^(1/4).
        let k = match self.support {
            PartSupport::Chuck => 3.0,
            PartSupport::Centres => 48.0,
            PartSupport::ChuckAndCentre => 101.9,
        };
        let fourth = 64.0 * length * length * length / (k * PI * self.modulus * compliance);
        length / libm::pow(fourth, 0.25)
    }

    /// The place of the largest deflection of a plain bar held in the same way, mm from the jaws.
    fn weakest_point(&self) -> f64 {
        self.length_mm()
            * match self.support {
                PartSupport::Chuck => 1.0,
                PartSupport::Centres => 0.5,
                PartSupport::ChuckAndCentre => 0.586,
            }
    }

    /// The compliance under a force between two distances from the jaws, at the worst place; `tolerance` is that of
    /// the finished diameter.
    pub fn over(&self, from: Half, to: Half, tolerance: Option<Micrometres>) -> Flexibility {
        let length = self.length_mm();
        let within = |at: f64| at.clamp(0.0, length);
        let (from, to) = (within(from.to_mm()), within(to.to_mm()));
        // Both ends, seven points between them, and the weakest place of a plain bar.
        let weakest = self.weakest_point().clamp(from.min(to), to.max(from));
        let mut places: Vec<f64> = (0..=8).map(|part| from + (to - from) * f64::from(part) / 8.0).collect();
        places.push(weakest);
        let (mut compliance, mut stress, mut at) = (0.0_f64, 0.0_f64, from);
        for place in places {
            let (bends, stressed) = self.answers(place);
            if bends > compliance {
                (compliance, at) = (bends, place);
            }
            stress = stress.max(stressed);
        }
        Flexibility { compliance, at, stress, strength: self.strength, tolerance, because: self.because.clone() }
    }

    /// Compliance at a place, mm/N, and the largest stress of a force there, MPa/N.
    ///
    /// Castigliano: compliance = ∫ M²/(E·I) dx with the moment M of a force of 1 N. M is linear between the borders of
    /// sections and the force, so Simpson's rule is exact.
    fn answers(&self, place: f64) -> (f64, f64) {
        let reactions = self.reactions(place);
        let moment = |x: f64| {
            let held = reactions.iter().map(|(at, force)| force * self.base_moment(*at, x));
            self.base_moment(place, x) - held.sum::<f64>()
        };
        let (mut compliance, mut stress) = (0.0, 0.0_f64);
        for (from, to, section) in self.stretches(place) {
            let (inertia, modulus) = section_figures(section);
            let square = |x: f64| {
                let moment = moment(x);
                moment * moment
            };
            let simpson = (square(from) + 4.0 * square((from + to) / 2.0) + square(to)) * (to - from) / 6.0;
            compliance += simpson / (self.modulus * inertia);
            stress = stress.max(moment(from).abs().max(moment(to).abs()) / modulus);
        }
        (compliance, stress)
    }

    /// The sections, divided at a place and at the rest.
    fn stretches(&self, place: f64) -> Vec<(f64, f64, &PartSection)> {
        let mut stretches = Vec::with_capacity(self.sections.len() + 2);
        let mut cuts: Vec<f64> = [Some(place), self.rest].into_iter().flatten().collect();
        cuts.sort_by(f64::total_cmp);
        for section in &self.sections {
            let (mut from, to) = (section.from.to_mm(), section.to.to_mm());
            for &cut in &cuts {
                if from < cut && cut < to {
                    stretches.push((from, cut, section));
                    from = cut;
                }
            }
            stretches.push((from, to, section));
        }
        stretches
    }

    /// The bending moment at x of 1 N perpendicular to the part at a place, N·mm, without centre beside the chuck and without rest:
    ///
    /// - in the chuck a − x up to the force, nothing beyond;
    /// - between centres b·x/L up to it and a·(L − x)/L beyond, with b = L − a.
    fn base_moment(&self, place: f64, x: f64) -> f64 {
        let length = self.length_mm();
        match self.support {
            PartSupport::Centres if x <= place => (length - place) * x / length,
            PartSupport::Centres => place * (length - x) / length,
            PartSupport::Chuck | PartSupport::ChuckAndCentre => (place - x).max(0.0),
        }
    }

    /// Where the centre beside a chuck and a rest hold the axis, and their forces under 1 N at a place. Each holds its place still:
    /// the forces R solve Σ δ(i, j)·R(j) = δ(i, place), with δ(a, b) = ∫ M(a)·M(b)/I dx of the part without them.
    fn reactions(&self, place: f64) -> Vec<(f64, f64)> {
        let centre = (self.support == PartSupport::ChuckAndCentre).then(|| self.length_mm());
        let places: Vec<f64> = centre.into_iter().chain(self.rest).collect();
        let across = |one: f64, other: f64| self.across(one, other);
        match *places.as_slice() {
            [one] => vec![(one, across(one, place) / across(one, one))],
            [one, two] => {
                let (a, b, c) = (across(one, one), across(one, two), across(two, two));
                let (p, q) = (across(one, place), across(two, place));
                let share = a * c - b * b;
                vec![(one, (p * c - q * b) / share), (two, (q * a - p * b) / share)]
            }
            _ => Vec::new(),
        }
    }

    /// ∫ M(a)·M(b)/I dx of the part without centre beside the chuck and without rest.
    fn across(&self, one: f64, other: f64) -> f64 {
        let stretches = self.stretches(one).into_iter().flat_map(|(from, to, section)| {
            let cut = [(from, other, section), (other, to, section)];
            let within = from < other && other < to;
            if within { cut.to_vec() } else { vec![(from, to, section)] }
        });
        let of = |(from, to, section): (f64, f64, &PartSection)| {
            let (inertia, _) = section_figures(section);
            let product = |x: f64| self.base_moment(one, x) * self.base_moment(other, x);
            (product(from) + 4.0 * product((from + to) / 2.0) + product(to)) * (to - from) / (6.0 * inertia)
        };
        stretches.map(of).sum()
    }
}

/// I = π·(d⁴ − b⁴)/64, mm⁴, and W = 2·I/d, mm³.
fn section_figures(section: &PartSection) -> (f64, f64) {
    let fourth = |radius: Half| {
        let diameter = 2.0 * radius.to_mm();
        diameter * diameter * diameter * diameter
    };
    let inertia = PI * (fourth(section.radius) - fourth(section.bore)) / 64.0;
    (inertia, inertia / section.radius.to_mm())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bar(support: PartSupport, length: f64, diameters: &[(f64, f64)]) -> HeldPart {
        let mut from = 0.0;
        let sections = diameters.iter().map(|&(long, diameter)| {
            let section = PartSection {
                from: Half::from(from),
                to: Half::from(from + long),
                radius: Half::from(diameter / 2.0),
                bore: Half::ZERO,
            };
            from += long;
            section
        });
        let sections = sections.collect();
        assert!((from - length).abs() < 1e-9 || from > 0.0);
        HeldPart { support, rest: None, sections, modulus: 210_000.0, strength: 600.0, because: Vec::new() }
    }

    fn near(is: f64, must: f64) {
        assert!((is / must - 1.0).abs() < 0.002, "{is} is not {must}");
    }

    /// Ø40, 160 mm free, 300 N: in the chuck F·L³/(3·E·I) = 300·160³/(3·210000·125664) = 0.0155 mm; between centres in the
    /// middle F·L³/(48·E·I), a sixteenth; in the chuck and at the centre 0.00981·F·L³/(E·I) at 0.586·L.
    #[test]
    fn a_plain_bar_bends_as_textbooks_have_it() {
        let whole = |support| {
            let bar = bar(support, 160.0, &[(160.0, 40.0)]);
            bar.over(Half::ZERO, Half::from(160.0), None)
        };
        let chuck = whole(PartSupport::Chuck);
        near(chuck.bend_mm(Newtons(300.0)), 0.015_52);
        near(chuck.at_mm(), 160.0);
        near(whole(PartSupport::Centres).bend_mm(Newtons(300.0)), 0.015_52 / 16.0);
        near(whole(PartSupport::ChuckAndCentre).bend_mm(Newtons(300.0)), 0.015_52 * 3.0 * 0.009_81);
        // 300 N·160 mm / (π·40³/32) = 48000/6283.2 = 7.64 MPa at the jaws.
        near(chuck.stress_mpa(Newtons(300.0)), 7.639);
    }

    /// Half the length Ø40 at the jaws, half Ø20: F/E·(∫ of the thin half L³/24·1/I₂ + of the thick (L³ − L³/8)/3·1/I₁), with
    /// L 100, I₁ 125664, I₂ 7854: 100³/24/7854 + 7/8·100³/3/125664 = 5.3051 + 2.3210 = 7.6261 mm²/N·E; over 210000: 3.6315e-5.
    #[test]
    fn a_stepped_bar_bends_over_its_steps() {
        let bar = bar(PartSupport::Chuck, 100.0, &[(50.0, 40.0), (50.0, 20.0)]);
        let end = bar.over(Half::from(100.0), Half::from(100.0), None);
        near(end.bend_mm(Newtons(1000.0)), 0.036_315);
        // The thin half is stressed most where it begins: 50 N·mm/N over π·20³/32 = 785.4: 0.06366 MPa/N, the jaws 0.0159.
        near(end.stress_mpa(Newtons(1.0)), 0.063_66);
    }

    /// The example of the task: a bar 15 times as long as thick and 606 N in the chuck: Ø20, 300 mm:
    /// 606·300³/(3·210000·7854) = 3.31 mm; between centres 0.207 mm, more than the whole of h8 (0.033 mm).
    #[test]
    fn a_slender_bar_bends_beyond_its_tolerance() {
        let of = |support| bar(support, 300.0, &[(300.0, 20.0)]);
        let whole = |support| of(support).over(Half::ZERO, Half::from(300.0), None).bend_mm(Newtons(606.0));
        near(whole(PartSupport::Chuck), 3.307);
        near(whole(PartSupport::Centres), 0.2067);
        for support in [PartSupport::Chuck, PartSupport::Centres, PartSupport::ChuckAndCentre] {
            near(of(support).slenderness(), 15.0);
        }
    }

    /// A bore takes the fourth power of its share: Ø40 with a bore of Ø30 keeps 1 − 0.75⁴ = 0.68359 of the stiffness.
    #[test]
    fn a_bore_weakens() {
        let mut hollow = bar(PartSupport::Chuck, 160.0, &[(160.0, 40.0)]);
        let solid = hollow.over(Half::ZERO, Half::from(160.0), None).bend_mm(Newtons(1.0));
        hollow.sections.iter_mut().for_each(|section| section.bore = Half::from(15.0));
        near(solid / hollow.over(Half::ZERO, Half::from(160.0), None).bend_mm(Newtons(1.0)), 0.683_59);
    }

    /// Ø40, 400 mm between centres with a rest in the middle is two spans: a force at 100 mm bends a beam on three supports
    /// (textbook: 23·F·l³/(1536·E·I) with the span l under a force in the middle of one of two equal spans):
    /// 23·1000·200³/(1536·210000·125664) = 4.5394e-3 mm, and nothing at the rest. In the chuck with a rest at its free end it is as
    /// with a centre there.
    #[test]
    fn a_rest_halves_the_free_length() {
        let rested = bar(PartSupport::Centres, 400.0, &[(400.0, 40.0)]).with_rest(Half::from(200.0));
        let at = |part: &HeldPart, z: f64| part.over(Half::from(z), Half::from(z), None).bend_mm(Newtons(1000.0));
        near(at(&rested, 100.0), 4.5394e-3);
        assert!(at(&rested, 200.0).abs() < 1e-9, "{}", at(&rested, 200.0));
        let long = bar(PartSupport::Chuck, 400.0, &[(400.0, 40.0)]);
        let by_rest = long.clone().with_rest(Half::from(399.999));
        let by_centre = HeldPart { support: PartSupport::ChuckAndCentre, ..long };
        near(at(&by_rest, 150.0), at(&by_centre, 150.0));
    }
}
