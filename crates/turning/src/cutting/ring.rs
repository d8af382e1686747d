//! A hollow part between the jaws of a chuck: a ring under equal radial forces, which springs into lobes.

use std::f64::consts::PI;

use crate::error::KnowledgeError;
use crate::knowledge::Knowledge;
use crate::material::Material;
use crate::note::Because;
use crate::tables::turning::part::ElasticModulus;
use crate::tables::turning::tools::Limit;
use crate::units::{Micrometres, Newtons};

use super::bounds::ratio;
use super::stiffness::PartSection;

/// The jaws of a chuck.
const JAWS: f64 = 3.0;

/// Poisson's ratio of metals.
const POISSON: f64 = 0.3;

/// The stretch of a part that its jaws press, as rings beside each other.
#[derive(Clone, Debug)]
pub struct PressedRing {
    sections: Vec<Section>,
    /// E, MPa.
    modulus: f64,
    /// What a wall bears, MPa; none where the strength of the material is not known.
    bears: Option<f64>,
    /// The share of the tolerance that the lobes may take, a side.
    share: f64,
    /// Half of the angle over which a jaw touches, radians.
    contact: f64,
    /// How many times a floor or a thick wall beside the jaws makes it stiffer.
    stiffer: f64,
    /// The rows behind it.
    pub because: Vec<Because>,
}

/// A ring, mm.
#[derive(Clone, Copy, Debug)]
struct Section {
    length: f64,
    /// The mean radius.
    radius: f64,
    wall: f64,
}

impl Section {
    fn of(section: &PartSection) -> Self {
        let (radius, bore) = (section.radius.to_mm(), section.bore.to_mm());
        Self { length: (section.to - section.from).to_mm(), radius: (radius + bore) / 2.0, wall: radius - bore }
    }

    /// b·t³/(12·R³): its share of the stiffness, over E.
    fn stiffness(self) -> f64 {
        let slim = self.wall / self.radius;
        self.length * slim * slim * slim / 12.0
    }
}

impl PressedRing {
    /// The rings of a material, by how far each jaw touches around them, and how many times what stands beside them makes them stiffer.
    /// None without a section that is a body.
    ///
    /// # Errors
    /// The knowledge base lacks a row.
    pub fn of(
        sections: &[PartSection],
        contact_degrees: f64,
        stiffer: f64,
        material: &Material<'_>,
        knowledge: &Knowledge,
    ) -> Result<Option<Self>, KnowledgeError> {
        let sections: Vec<Section> = sections.iter().map(Section::of).collect();
        let body = |one: &Section| one.length > 0.0 && one.wall > 0.0 && one.radius > 0.0;
        if sections.is_empty() || !sections.iter().all(body) {
            return Ok(None);
        }
        let group = material.group;
        let modulus = knowledge.need(group, |row: &ElasticModulus<'_>| row.material_group == group)?.modulus.0;
        let (share, of_share) = ratio(knowledge, Limit::PartDeflectionShare)?;
        let (stress, of_stress) = ratio(knowledge, Limit::PartStressShare)?;
        let strength = material.strength.to_f64();
        Ok(Some(Self {
            sections,
            modulus: modulus.to_f64(),
            bears: (strength > 0.0).then_some(stress * strength),
            share,
            contact: contact_degrees.to_radians(),
            stiffer,
            because: vec![of_share, of_stress],
        }))
    }

    /// How high its lobes are from valley to crest, mm, under a force of all jaws together.
    ///
    /// A thin ring under n equal forces W, each spread over 2·α (theory of thin rings, Timoshenko; measured on chucked rings by
    /// J. Manuf. Sci. Eng. 126 (2004), p. 141, within 6 %): 2·n·W·R³/(π·E·I)·Σ sin(mα)/(mα)/(m² − 1)², m = n, 3n, 5n …, with
    /// I = b·t³/12. Rings beside each other share the force by their stiffness.
    pub fn lobes_mm(&self, force: Newtons) -> f64 {
        let stiffness: f64 = self.sections.iter().map(|one| one.stiffness()).sum();
        force.0 / JAWS * lobes(JAWS, self.contact) / (self.modulus * stiffness * self.stiffer)
    }

    /// The largest force of all jaws together under which no wall is stressed more than it bears; none where its strength is not known.
    ///
    /// Bending under a jaw, W·R/2·(1/θ − cot θ) with θ = π/n, less where the jaw is spread; and F/(2π·b·t) of the whole ring.
    pub fn bears(&self) -> Option<Newtons> {
        let stiffness: f64 = self.sections.iter().map(|one| one.stiffness()).sum();
        let spread = lobes(JAWS, self.contact) / lobes(JAWS, 0.0);
        let stress = |one: &Section| {
            let force = one.stiffness() / stiffness;
            let bending = force / JAWS * one.radius * moment(JAWS) * spread * 6.0 / (one.length * one.wall * one.wall);
            bending / self.stiffer + force / (2.0 * PI * one.length * one.wall)
        };
        let most = self.sections.iter().map(stress).fold(0.0, f64::max);
        self.bears.map(|bears| Newtons(bears / most))
    }

    /// What the lobes may be with a tolerance of a diameter, mm: the share of the deflection of a part, a side.
    pub fn allowed_mm(&self, tolerance: Micrometres) -> f64 {
        self.share * tolerance.to_mm()
    }

    /// How many times stiffer a tube is at a distance from a floor or a thick wall, which keeps its shape: 1 + 2/(β·l)⁴. A strip of the tube
    /// is a beam on a foundation, and with its foot held it bends like a cantilever, q·l⁴/(8·EI) beside q/k, where k/EI = 4β⁴.
    pub fn stiffened(radius: f64, bore: f64, distance_mm: f64) -> f64 {
        let along = distance_mm / (2.0 * Self::spread_mm(radius, bore));
        1.0 + 2.0 / (along * along * along * along)
    }

    /// How far the lobes spread along a tube beyond the jaws, mm: 1/(2β), with β of the mode of n lobes,
    /// 4β⁴ = n⁴·(n² − 1)²·t²/(12·(1 − ν²)·R⁶) (theory of shells without shear and hoop strain).
    pub fn spread_mm(radius: f64, bore: f64) -> f64 {
        let (mean, wall) = ((radius + bore) / 2.0, radius - bore);
        let n2 = JAWS * JAWS;
        let fourth = n2 * n2 * (n2 - 1.0) * (n2 - 1.0) * wall * wall / (48.0 * (1.0 - POISSON * POISSON));
        libm::sqrt(mean) * mean / (2.0 * libm::pow(fourth, 0.25))
    }
}

/// The lobes of a ring under n forces of 1 spread over twice an angle, over R³/(E·I).
fn lobes(n: f64, contact: f64) -> f64 {
    let part = |k: u32| {
        let m = n * f64::from(2 * k + 1);
        let at = m * contact;
        let spread = if at.abs() < 1e-9 { 1.0 } else { libm::sin(at) / at };
        spread / ((m * m - 1.0) * (m * m - 1.0))
    };
    (2.0 * n / PI * (0..8).map(part).sum::<f64>()).abs()
}

/// The moment under one of n forces of 1, over R.
fn moment(n: f64) -> f64 {
    let half = PI / n;
    (1.0 / half - 1.0 / libm::tan(half)) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(is: f64, must: f64) {
        assert!((is / must - 1.0).abs() < 0.005, "{is} is not {must}");
    }

    /// Textbooks of the strength of materials: two forces across a ring shorten one diameter by 0.149 and lengthen the other by
    /// 0.137 W·R³/(E·I), so the radii differ by half of the sum; the moment under them is 0.318 W·R, of three 0.189 W·R.
    #[test]
    fn a_ring_springs_as_textbooks_have_it() {
        near(lobes(2.0, 0.0), (0.149 + 0.137) / 2.0);
        near(moment(2.0), core::f64::consts::FRAC_1_PI);
        near(moment(3.0), 0.189);
    }

    /// Three forces by hand, from the closed form: towards the axis (θ + s·c)/(4·s²) − 1/(2θ) = 0.01594 under a jaw, outwards
    /// 1/(2θ) − (s + θ·c)/(4·s²) = 0.01426 between, θ = 60°.
    #[test]
    fn three_jaws_make_three_lobes() {
        near(lobes(3.0, 0.0), 0.015_94 + 0.014_26);
        // Spread over the whole third the force is even: nothing is left of the lobes.
        assert!(lobes(3.0, PI / 3.0) < 1e-9);
    }

    /// Ø65 with a wall of 2.5 over 15 mm, E 210000, 37 kN: R = 31.25, I = 15·2.5³/12 = 19.53 mm⁴, W = 12333 N:
    /// 0.0302·12333·30518/(210000·19.53) = 2.77 mm; bending 0.189·12333·31.25/(15·2.5²/6) = 4662 MPa and 37000/(2π·37.5) = 157.
    #[test]
    fn a_thin_ring_is_crushed() {
        let section = Section { length: 15.0, radius: 31.25, wall: 2.5 };
        let ring = PressedRing {
            sections: vec![section],
            modulus: 210_000.0,
            bears: Some(180.0),
            share: 0.2,
            contact: 0.0,
            stiffer: 1.0,
            because: Vec::new(),
        };
        near(ring.lobes_mm(Newtons(37_000.0)), 2.77);
        near(ring.bears().unwrap().0, 37_000.0 * 180.0 / (4662.0 + 157.0));
        // A floor as far away as 1/β, twice the spread, makes it three times stiffer.
        near(PressedRing::stiffened(32.5, 30.0, 2.0 * PressedRing::spread_mm(32.5, 30.0)), 3.0);
        // 0.152·R·√(R/t) by hand.
        near(PressedRing::spread_mm(32.5, 30.0), 0.1515 * 31.25 * libm::sqrt(12.5));
    }
}
