//! The keys of plan files in words: of plans by hand and of those that `technolog plan` writes.

use technolog_audit::quantity::Quantity;

use super::super::Lang;
use super::words::name;

/// The last key of a path in words: `діаметр D` of `route.2.diameter`. Nothing where it is no key.
pub(super) fn words(path: &str, lang: Lang) -> Option<String> {
    let number = |key: &&str| !key.is_empty() && key.bytes().all(|letter| letter.is_ascii_digit());
    let mut parts = path.split('.').rev().skip_while(number);
    let (key, before) = (parts.next()?, parts.next());
    let text = |(uk, en): (&str, &str)| Some(lang.pick(uk, en).to_owned());
    let figure = |quantity| Some(name(quantity, lang));
    // The same word means another thing there.
    match (before, key) {
        (Some("clamping"), "force") => return figure(Quantity::ClampForce),
        (Some("clamping"), "clamps") if !path.ends_with(key) => return text(("місце притискача", "place of a clamp")),
        (Some("card"), "feed_mm_per_rev") => return figure(Quantity::CardFeed),
        (Some("card"), "speed_m_per_min") => return figure(Quantity::CardSpeed),
        (Some("card"), "axial_force_n") => return figure(Quantity::CardForce),
        (Some("card"), "power_kw") => return figure(Quantity::CardPower),
        (Some("holder"), "designation") => {
            return text(("позначення допоміжного інструмента", "designation of the holder"));
        }
        (Some("holder"), "standard") => return text(("стандарт допоміжного інструмента", "standard of the holder")),
        (Some("holder"), "table") => return text(("таблиця допоміжного інструмента", "table of the holder")),
        (_, "length_mm") if path.contains(".links.") => return text(("довжина ланки", "length of the link")),
        (_, "length_mm") if path.starts_with("tools.") => return figure(Quantity::Assembly),
        _ => {}
    }
    let own = OWN.iter().find(|(known, _)| *known == key).map(|(_, quantity)| *quantity);
    if let Some(quantity) = own.or_else(|| Quantity::of_key(key)) {
        return Some(name(quantity, lang));
    }
    KEYS.iter().find(|(known, ..)| *known == key).and_then(|(_, uk, en)| text((uk, en)))
}

/// The name of a factor; an author's own is as it is.
pub(super) fn factor(name: &str, lang: Lang) -> &str {
    FACTORS.iter().find(|(known, ..)| *known == name).map_or(name, |(_, uk, en)| lang.pick(uk, en))
}

/// A word that a plan has for a value.
pub(super) fn value(id: &str, lang: Lang) -> Option<&'static str> {
    VALUES.iter().find(|(known, ..)| *known == id).map(|(_, uk, en)| lang.pick(uk, en))
}

/// Figures of a plan of ours.
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
    ("distance_mm", Quantity::Distance),
    ("force_n", Quantity::ClampForce),
    ("force_per_clamp_n", Quantity::ForcePerClamp),
    ("machine_min", Quantity::MachineTime),
    ("rapid_min", Quantity::RapidTime),
    ("tool_change_min", Quantity::ChangeTime),
    ("total_min", Quantity::TotalTime),
];

/// Keys that are no figures of the audit.
const KEYS: &[(&str, &str, &str)] = &[
    // Parts of a plan.
    ("route", "маршрут", "route"),
    ("tools", "інструменти", "tools"),
    ("conditions", "режими різання", "cutting conditions"),
    ("clamping", "закріплення", "clamping"),
    ("program", "керуюча програма", "program"),
    ("times", "час", "times"),
    ("time", "час", "times"),
    ("holes", "групи отворів", "groups of holes"),
    ("transitions", "переходи", "transitions"),
    ("sequence", "порядок обходу", "sequence"),
    // Of rows.
    ("row", "рядок маршруту", "row of the route"),
    ("order", "порядок рядків", "order of the rows"),
    ("operation", "перехід", "transition"),
    ("hole", "група отворів", "group of holes"),
    ("tool", "інструмент", "tool"),
    ("scheme", "схема", "scheme"),
    ("table", "таблиця", "table"),
    ("name", "назва", "name"),
    ("way", "спосіб вибору схеми", "how the scheme was found"),
    ("finish_elsewhere", "чи кінчають на іншому верстаті", "whether it is finished elsewhere"),
    ("elsewhere", "чи роблять на іншому верстаті", "whether it is done elsewhere"),
    ("meets", "чи досягається потрібне", "whether it meets what is asked"),
    ("centre_tolerance_mm", "допуск міжосьової відстані", "centre tolerance"),
    ("time_min", "час маршруту", "time of the route"),
    ("margin_min", "виграш проти наступного маршруту", "gain over the next route"),
    ("cost", "вартість маршруту", "cost of the route"),
    ("feature", "елемент отвору", "element of the hole"),
    ("face", "сторона деталі", "face of the part"),
    ("step", "ступінь отвору", "step of the hole"),
    ("start_mm", "початок переходу", "start of the transition"),
    ("approach_mm", "недобіг", "approach"),
    ("also_diameter_mm", "другий діаметр", "second diameter"),
    ("achieved", "досягнуте", "what is reached"),
    ("it", "квалітет", "grade"),
    ("roughness", "шорсткість", "roughness"),
    ("position_mm", "точність розташування", "accuracy of position"),
    // Of tools.
    ("number", "номер інструмента", "number of the tool"),
    ("designation", "позначення", "designation"),
    ("standard", "стандарт", "standard"),
    ("shank", "хвостовик", "shank"),
    ("holder", "допоміжний інструмент", "holder"),
    ("holder_table", "таблиця допоміжного інструмента", "table of the holder"),
    ("with", "слово корекції", "word of the correction"),
    ("links", "ланки комплекту", "links of the assembly"),
    ("kind", "вид", "kind"),
    ("mass_kg", "маса", "mass"),
    ("load", "завантаження магазину", "load of the magazine"),
    // Of conditions.
    ("limited_by", "чим обмежено режим", "what limits the conditions"),
    ("coolant", "охолодження", "coolant"),
    ("rounds", "обходи фрези", "rounds of the mill"),
    ("mill_diameter_mm", "діаметр фрези", "diameter of the mill"),
    ("levels", "кількість рівнів", "levels"),
    ("card", "режим за картою", "conditions by the card"),
    ("axial_force_by_book_n", "осьова сила за посібником", "axial force by the book"),
    ("power_by_book_kw", "потужність за посібником", "power by the book"),
    // Of the clamping.
    ("screw", "гвинт", "screw"),
    ("proposed", "чи притискачі запропоновано", "whether the clamps are proposed"),
    ("safe_distance_mm", "безпечна відстань", "safe distance"),
    // Of the sequence.
    ("setup", "установ", "setup"),
    ("stops", "зупинки", "stops"),
    ("transition", "номер переходу", "number of the transition"),
    ("at", "точка", "point"),
    ("x", "координата X", "coordinate X"),
    ("y", "координата Y", "coordinate Y"),
    ("nearest_rapid_min", "холості ходи за найближчою точкою", "rapids by the nearest point"),
    ("bound_min", "нижня межа холостих ходів", "lower bound of the rapids"),
    ("path_mm", "довжина шляху", "length of the path"),
];

/// The factors of the table `card-corrections`.
const FACTORS: &[(&str, &str, &str)] = &[
    ("material", "матеріал", "material"),
    ("point-grinding", "заточення вершини", "point grinding"),
    ("coolant", "охолодження", "coolant"),
    ("tool-life", "стійкість", "tool life"),
    ("coating", "покриття", "coating"),
    ("tool-material", "матеріал інструмента", "tool material"),
    ("hole-depth", "глибина отвору", "hole depth"),
    ("surface-state", "стан поверхні", "state of the surface"),
];

const VALUES: &[(&str, &str, &str)] = &[
    // Bounds of a machine.
    ("thrust-z-max", "найбільша осьова сила", "largest thrust"),
    ("spindle-torque-max", "найбільший крутний момент", "largest torque"),
    ("tool-overhang-max", "найбільший виліт інструмента", "largest overhang of a tool"),
    // Of plans.
    ("taper", "конус шпинделя", "the spindle's taper"),
    ("tables", "за таблицями", "by the tables"),
    ("complexes", "за комплексами", "by complexes"),
    ("search", "пошуком", "by search"),
    ("bore", "основний циліндр", "main cylinder"),
    ("step", "ступінь", "step"),
    ("thread", "різь", "thread"),
    ("cone", "конус", "cone"),
    ("counterbore", "цеківка", "counterbore"),
    ("countersink", "зенківка", "countersink"),
    ("chamfer", "фаска", "chamfer"),
    ("face", "торець", "face"),
    ("entry", "вхідна", "entry"),
    ("back", "зворотна", "back"),
    ("cutter", "різальний інструмент", "cutter"),
    ("holder", "допоміжний інструмент", "holder"),
];

#[cfg(test)]
mod tests {
    use super::words;
    use crate::report::Lang;

    #[test]
    fn a_path_is_told_by_its_last_key() {
        for (path, uk) in [
            ("route.2.diameter", "діаметр D"),
            ("clamping.force", "зусилля закріплення W"),
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
