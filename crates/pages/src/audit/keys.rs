//! The names of keys in plan files: hand-written plans and those of `technolog plan`.

use technolog_audit::quantity::Quantity;

use super::super::Lang;
use super::words::name;

/// The name of the last key of a path: `діаметр D` for `route.2.diameter`. None if it is no key.
pub(super) fn words(path: &str, lang: Lang) -> Option<String> {
    let number = |key: &&str| !key.is_empty() && key.bytes().all(|letter| letter.is_ascii_digit());
    let mut parts = path.split('.').rev().skip_while(number);
    let (key, before) = (parts.next()?, parts.next());
    let text = |key: &str| lang.find(&format!("audit-key-{key}")).map(str::to_owned);
    let figure = |quantity| Some(name(quantity, lang));
    // In this place the word has another meaning.
    match (before, key) {
        (Some("clamping"), "force") => return figure(Quantity::ClampForce),
        (Some("clamping"), "clamps") if !path.ends_with(key) => return text("clamp-place"),
        (Some("card"), "feed_mm_per_rev") => return figure(Quantity::CardFeed),
        (Some("card"), "speed_m_per_min") => return figure(Quantity::CardSpeed),
        (Some("card"), "axial_force_n") => return figure(Quantity::CardForce),
        (Some("card"), "power_kw") => return figure(Quantity::CardPower),
        (Some("holder"), "designation") => return text("holder-designation"),
        (Some("holder"), "standard") => return text("holder-standard"),
        (Some("holder"), "table") => return text("holder_table"),
        (_, "length_mm") if path.contains(".links.") => return text("link-length"),
        (_, "length_mm") if path.starts_with("tools.") => return figure(Quantity::Assembly),
        _ => {}
    }
    let own = OWN.iter().find(|(known, _)| *known == key).map(|(_, quantity)| *quantity);
    if let Some(quantity) = own.or_else(|| Quantity::of_key(key)) {
        return Some(name(quantity, lang));
    }
    text(key)
}

/// Figures of a plan written by the program.
const OWN: &[(&str, Quantity)] = &[
    ("diameter_mm", Quantity::Diameter),
    ("from_diameter_mm", Quantity::From),
    ("depth_mm", Quantity::Depth),
    ("travel_mm", Quantity::Travel),
    ("depth_of_cut_mm", Quantity::DepthOfCut),
    ("feed_mm_per_rev", Quantity::Feed),
    ("speed_m_per_min", Quantity::SpeedTaken),
    ("computed_speed_m_per_min", Quantity::Speed),
    ("spindle_rpm", Quantity::Rpm),
    ("feed_mm_per_min", Quantity::MinuteFeed),
    ("axial_force_n", Quantity::Force),
    ("torque_n_m", Quantity::Torque),
    ("power_kw", Quantity::Power),
    ("machine_time_min", Quantity::Time),
    ("tool_life_min", Quantity::ToolLife),
    ("length_mm", Quantity::HolderLength),
    ("overhang_mm", Quantity::Overhang),
    ("correction_mm", Quantity::Correction),
    ("book_correction_mm", Quantity::BookCorrection),
    ("side_force_n", Quantity::SideForce),
    ("distance_mm", Quantity::Distance),
    ("force_n", Quantity::ClampForce),
    ("force_per_clamp_n", Quantity::ForcePerClamp),
    ("machine_min", Quantity::MachineTime),
    ("feed_out_min", Quantity::FeedOutTime),
    ("dwell_min", Quantity::DwellTime),
    ("hand_min", Quantity::HandTime),
    ("rapid_min", Quantity::RapidTime),
    ("tool_change_min", Quantity::ChangeTime),
    ("total_min", Quantity::TotalTime),
];

#[cfg(test)]
mod tests {
    use super::words;
    use crate::report::Lang;

    #[test]
    fn a_path_is_told_by_its_last_key() {
        for (path, uk) in [
            ("route.2.diameter", "діаметр D"),
            ("clamping.force", "сила закріплення W"),
            ("conditions.2.force", "осьова сила P"),
            ("holes.1.transitions.2.conditions.spindle_rpm", "прийнята частота обертання nпр"),
            ("clamping.clamps", "кількість притискачів zп"),
            ("clamping.clamps.1.2", "місце притискача"),
            ("tools.T1.holder.designation", "позначення допоміжного інструмента"),
        ] {
            assert_eq!(words(path, Lang::UK).as_deref(), Some(uk), "{path}");
        }
        assert_eq!(words("route.A", Lang::UK), None);
    }
}
