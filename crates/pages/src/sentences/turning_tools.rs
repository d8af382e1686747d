//! The words about lathes, turning tools, the limiting depth of cut and the cutting conditions of turning.

/// Code, Ukrainian, English.
pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    // What is not known, and what does not fit.
    (
        "lathe-lacks",
        "каталог верстата {lathe} не має `{quantity}`",
        "the record of the lathe {lathe} has no `{quantity}`",
    ),
    ("turning-tool-lacks", "рядок різця {tool} не має `{quantity}`", "the row of the tool {tool} has no `{quantity}`"),
    (
        "bound-not-reckoned",
        "обмеження «{bound}» не враховано: {of} не має `{what}`",
        "the bound {bound} is left out: {of} has no `{what}`",
    ),
    (
        "limit-not-known",
        "граничну глибину різання не знайти: {of} не має `{what}` ({bound})",
        "the limiting depth of cut is not known: {of} has no `{what}` ({bound})",
    ),
    (
        "angle-beyond-table",
        "кут {angle}° поза таблицею {table}",
        "an angle of {angle} degrees is outside the table {table}",
    ),
    (
        "lathe-too-small",
        "верстат {lathe}: {is} > {most} мм, `{quantity}`",
        "lathe {lathe}: {is} > {most} mm, `{quantity}`",
    ),
    (
        "shank-too-high",
        "верстат {lathe}: державка різця {tool} {is} > {most} мм",
        "lathe {lathe}: the shank of {tool} is {is} > {most} mm high",
    ),
    (
        "nothing-to-cut",
        "`{quantity}` дорівнює {is}, а має бути більше за 0",
        "`{quantity}` is {is}, and must be above 0",
    ),
    (
        "tool-has-no-depth",
        "різець {tool} не має глибини різання, яку можна вибирати: канавку він ріже на свою ширину, різь - на її профіль",
        "the tool {tool} has no depth of cut to choose: a groove is as wide as its blade, a thread as deep as its profile",
    ),
    (
        "threads-not-reckoned",
        "режими нарізання різі різцем {tool} ще не рахуються",
        "cutting conditions of threading with {tool} are not reckoned yet",
    ),
    (
        "too-fine-to-turn",
        "{roughness} - чистіше, ніж мають таблиці подач точіння",
        "{roughness} is finer than the feed tables of turning go",
    ),
    (
        "too-fine-for-lathe",
        "верстат {lathe}: {roughness} чистіше за найкращу для нього {best}",
        "lathe {lathe}: {roughness} is finer than its best, {best}",
    ),
    // Why a figure.
    ("turning-feed", "подача {feed} мм/об, різець {tool}", "feed {feed} mm/rev, tool {tool}"),
    ("turning-finish-feed", "подача за шорсткістю {feed} мм/об", "feed by the roughness {feed} mm/rev"),
    ("feed-strength-factor", "подача × {factor}: міцність сталі", "feed × {factor}: strength of the steel"),
    ("force-coefficients", "коефіцієнти сили {component}", "coefficients of the force {component}"),
    (
        "grade-factor",
        "швидкість × {factor}: сплав {grade} замість {reference}",
        "speed × {factor}: grade {grade} in place of {reference}",
    ),
    ("internal-factor", "швидкість × {factor}: в отворі", "speed × {factor}: in a bore"),
    ("angle-speed-factor", "швидкість × {factor}: кут {angle}°", "speed × {factor}: angle {angle} degrees"),
    ("angle-force-factor", "сила × {factor}: кут {angle}°", "force × {factor}: angle {angle} degrees"),
    ("rake-force-factor", "сила × {factor}: передній кут {angle}°", "force × {factor}: rake {angle} degrees"),
    ("lathe-limit", "верстат дає {limit}", "the lathe gives {limit}"),
    ("turning-limit", "{name} = {value}", "{name} = {value}"),
    ("overhang", "виліт {length} мм", "overhang {length} mm"),
    (
        "insert-edge",
        "у роботі не більше {share} кромки {edge} мм: {depth} мм глибини",
        "at most {share} of the edge of {edge} mm may cut: {depth} mm of depth",
    ),
];

/// Names of the bounds of the depth of cut, and of what else held the conditions.
pub(super) const TERMS: &[(&str, &str, &str)] = &[
    ("shank-strength", "міцність державки", "strength of the shank"),
    ("shank-stiffness", "жорсткість державки", "stiffness of the shank"),
    ("insert-edge", "кромка пластини", "edge of the insert"),
    ("cutting-force", "сила різання на супорті", "cutting force on the carriage"),
    ("feed-force", "привод подачі", "feed drive"),
    ("side-force", "привод поперек подачі", "drive across the feed"),
    ("part-radius", "радіус деталі", "radius of the part"),
    ("handbook", "межа таблиць довідника", "end of the handbook's tables"),
    ("tool-life", "стійкість різця", "tool life"),
];

#[cfg(test)]
mod tests {
    use crate::report::Lang;
    use crate::report::sentences::term;
    use technolog_turning::cutting::Bound;

    #[test]
    fn every_bound_has_its_words() {
        let all = [
            Bound::ShankStrength,
            Bound::ShankStiffness,
            Bound::InsertEdge,
            Bound::CuttingForce,
            Bound::FeedForce,
            Bound::SideForce,
            Bound::SpindleTorque,
            Bound::SpindlePower,
            Bound::PartRadius,
            Bound::Handbook,
        ];
        for bound in all {
            assert_ne!(term(bound.name(), Lang::En), bound.name());
            assert_ne!(term(bound.name(), Lang::Uk), bound.name());
        }
    }
}
