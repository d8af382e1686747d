//! The words of an audit of routes, openings, depths, allowances and tools.

/// Code, Ukrainian, English.
pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    // Schemes.
    (
        "audit-scheme-mixed",
        "рядок названо за схемою {stated}, а інші рядки групи за {other}",
        "the row names the scheme {stated}, and the other rows of the group {other}",
    ),
    (
        "audit-scheme-uncentred",
        "{printed} дає схему {stated}, але за 1.2.1 такий отвір спершу центрують, тож {scheme} ({table})",
        "{printed} gives the scheme {stated}, but by section 1.2.1 such a hole is centred first, so {scheme} ({table})",
    ),
    (
        "audit-route-by-scheme",
        "переходи {printed} для схеми {stated} слово в слово; `technolog plan` робить {scheme} ({table}) так: {better}",
        "the transitions of {printed} for the scheme {stated} word for word; `technolog plan` makes {scheme} ({table}): {better}",
    ),
    (
        "audit-one-drill",
        "Ø{diameter} одним свердлом: за 1.2.1 свердлять двома, перше 0,5-0,6 діаметра",
        "Ø{diameter} with one drill: section 1.2.1 asks for two, the first of 0.5-0.6 of the diameter",
    ),
    // Openings.
    (
        "audit-opening-not-made",
        "{feature} Ø{diameter} креслення не робить жоден перехід",
        "no transition makes the {feature} Ø{diameter} of the drawing",
    ),
    (
        "audit-opening-not-centred",
        "{feature} Ø{diameter} не робить жоден перехід, а лунка Ø{spot} вужча",
        "no transition makes the {feature} Ø{diameter}, and the centring spot Ø{spot} is narrower",
    ),
    (
        "audit-opening-unasked",
        "на кресленні цього отвору такого немає: {operation}",
        "the drawing of this hole has nothing of the kind: {operation}",
    ),
    ("audit-opening-diameter", "за кресленням: {feature}", "by the drawing: {feature}"),
    ("audit-opening-depth", "за кресленням: {feature}", "by the drawing: {feature}"),
    // Depths.
    (
        "audit-depth-of-hole",
        "отвір {hole} креслення такої глибини не має",
        "the hole {hole} of the drawing is not of that depth",
    ),
    (
        "audit-spot-depth",
        "глибина лунки t = (D/2)/tg φ за кутом центрувального свердла",
        "the depth of the spot is t = (D/2)/tan φ by the angle of the centring drill",
    ),
    (
        "audit-breaks-through",
        "вершина інструмента на {end} мм, а деталь завтовшки {thickness} мм: глухий отвір стане наскрізним",
        "the tip of the tool is at {end} mm, and the part is {thickness} mm thick: the blind hole goes through",
    ),
    // Threads.
    ("audit-tap-drill", "отвір під {thread} від {low} до {high} мм", "the hole under {thread} is {low} to {high} mm"),
    (
        "audit-thread-short",
        "різь {thread} креслення завглибшки {depth} мм",
        "the thread {thread} of the drawing is {depth} mm deep",
    ),
    (
        "audit-thread-runout",
        "під різь {thread} завглибшки {depth} мм бракує місця для забірної частини мітчика",
        "under the thread {thread} of {depth} mm there is no room for the lead of the tap",
    ),
    (
        "audit-thread-deep",
        "різь {thread} креслення завглибшки лише {depth} мм",
        "the thread {thread} of the drawing is only {depth} mm deep",
    ),
    (
        "audit-thread-elsewhere",
        "різь {thread} у плані не нарізають: цей верстат не може, отже її ріжуть на іншому (рядок `operation: tap` з `elsewhere: true` скаже це явно)",
        "the plan does not cut the thread {thread}: this machine cannot, so it is cut on another (a row `operation: tap` with `elsewhere: true` says so)",
    ),
    (
        "audit-cannot-tap",
        "верстат {machine} різь не нарізає: перехід роблять на іншому (`elsewhere: true`)",
        "the machine {machine} cuts no threads: it is done on another (`elsewhere: true`)",
    ),
    // Allowances.
    (
        "audit-allowance",
        "перехід {row} ({operation}) знаходить {stock} мм на діаметр, а за 1.2.1 від {low} до {high}",
        "row {row} ({operation}) finds {stock} mm on diameter, and section 1.2.1 permits {low} to {high}",
    ),
    (
        "audit-passes",
        "{stock} мм на діаметр за 1.2.1 (до {high} за прохід) розточують за стільки проходів: {needed}",
        "{stock} mm on diameter are bored in {needed} passes by section 1.2.1 (up to {high} in each)",
    ),
    // Cutters, holders, places.
    ("bar-of-other-stage-rough", "{tool}: оправка для чорнового розточування", "{tool} is a bar for rough boring"),
    ("bar-of-other-stage-finish", "{tool}: оправка для чистового розточування", "{tool} is a bar for finish boring"),
    (
        "bar-of-other-range",
        "{tool} розточує Ø{low}-{high}, а перехід вимагає Ø{needed}",
        "{tool} bores Ø{low}-{high}, and the transition asks for Ø{needed}",
    ),
    (
        "tap-of-other-thread",
        "{tool}: мітчик {own}, а різь {needed}",
        "{tool} is a tap {own}, and the thread is {needed}",
    ),
    (
        "tool-of-other-angle",
        "{tool}: кут {own}°, а перехід вимагає {needed}°",
        "{tool} has an angle of {own}°, and the transition asks for {needed}°",
    ),
    (
        "tool-for-blind-holes",
        "{tool} для глухих отворів, а отвір наскрізний: для нього {known}",
        "{tool} is for blind holes, and the hole goes through: for it {known}",
    ),
    (
        "tool-for-through-holes",
        "{tool} для наскрізних отворів, а отвір глухий: для нього {known}",
        "{tool} is for through holes, and the hole is blind: for it {known}",
    ),
    (
        "holder-of-whole-tool",
        "{tool} має власний конус 7:24 і стоїть у шпинделі сам: {holder} його не тримає",
        "{tool} has its own 7:24 taper and stands in the spindle itself: {holder} does not hold it",
    ),
    (
        "holder-of-other-family",
        "{holder} не для такого хвостовика, як у {tool}: для нього {known}",
        "{holder} is not for such a shank as that of {tool}: for it {known}",
    ),
    (
        "audit-no-place",
        "місця T{number} немає: у магазині їх {places}",
        "there is no place T{number}: the magazine has {places}",
    ),
];

/// Words of the drawing's openings, as of `super::TERMS`.
pub(super) const TERMS: &[(&str, &str, &str)] =
    &[("countersink", "зенківка", "countersink"), ("chamfer", "фаска", "chamfer")];
