//! The words about cutters and holders, clamping and travel.

pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    // Tools.
    (
        "tool-tables",
        "{operation}: інструмент шукаємо в таблицях {order}",
        "{operation}: the cutter is looked for in the tables {order}",
    ),
    ("cutter", "перший інструмент, що підходить", "the first cutter that fits"),
    (
        "centre-drill-for-all",
        "найменше свердло для центрування всіх груп отворів: {needed}",
        "the smallest centring drill for all groups of holes: {needed}",
    ),
    (
        "holder",
        "перший допоміжний інструмент, що приймає хвостовик ({shank})",
        "the first holder that takes the shank ({shank})",
    ),
    (
        "overhang-cylindrical",
        "виліт: {free} мм поза посадкою + {extra} мм",
        "overhang: {free} mm outside the seat + {extra} mm",
    ),
    ("overhang-morse", "виліт: {projection} мм поза конусом", "overhang: {projection} mm outside the taper"),
    ("overhang-shell", "насадний інструмент: виліт - його довжина", "shell cutter: it stands out by its own length"),
    ("overhang-taper", "інструмент із хвостовиком верстата", "a tool with the machine's own taper"),
    (
        "does-not-reach",
        "{tool} ({table}): робоча довжина {reach} < {needed} мм",
        "{tool} ({table}): reach {reach} < {needed} mm",
    ),
    (
        "drill-too-large",
        "{tool} ({table}): Ø{diameter} > Ø{limit}, найбільшого свердла верстата",
        "{tool} ({table}): Ø{diameter} > Ø{limit}, the machine's largest drill",
    ),
    (
        "bar-does-not-enter",
        "{tool} ({table}): оправка Ø{bar} не входить в отвір Ø{hole}",
        "{tool} ({table}): the bar Ø{bar} does not enter the hole Ø{hole}",
    ),
    (
        "no-cutter-of-size",
        "{operation}: у таблицях {tables} немає Ø{diameter}; найближчі {below} і {above}",
        "{operation}: the tables {tables} have no Ø{diameter}; the nearest are {below} and {above}",
    ),
    ("no-cutter", "{operation}: інструмента немає", "{operation}: no cutter"),
    (
        "shank-outside-clamp",
        "{holder}: хвостовик Ø{shank} поза діапазоном {low}-{high} мм",
        "{holder}: shank Ø{shank} is outside {low}-{high} mm",
    ),
    (
        "other-morse",
        "{holder}: конус Морзе {taken}, а в інструмента {own}",
        "{holder}: Morse {taken}, the cutter has {own}",
    ),
    (
        "other-taper",
        "{holder}: конус 7:24 № {own}, а в шпинделя № {spindle}",
        "{holder}: 7:24 No. {own}, the spindle has No. {spindle}",
    ),
    ("stands-out-too-little", "{holder}: виліт {reach} < {needed} мм", "{holder}: it stands out {reach} < {needed} mm"),
    (
        "arbor-does-not-enter",
        "{holder}: оправка Ø{arbor} не входить в отвір Ø{hole}",
        "{holder}: the arbor Ø{arbor} does not enter the hole Ø{hole}",
    ),
    (
        "start-near-clamp",
        "точка заміни інструмента за {distance} мм від прихоплювача, менше безпечних {needed} мм: потрібні упори для ключа (1.11)",
        "the tool-change point is {distance} mm from a clamp, less than the safe {needed} mm: stops for the wrench are needed (1.11)",
    ),
    (
        "clamp-near-hole",
        "прихоплювач за {distance} мм від осі отвору, менше {needed} мм",
        "a clamp is {distance} mm from the hole's axis, less than {needed} mm",
    ),
    (
        "other-bore",
        "{holder}: посадка {taken} мм, а в інструмента {own} мм",
        "{holder}: seat {taken} mm, the cutter has {own} mm",
    ),
    (
        "assembly-too-long",
        "{tool} у {holder}: довжина {length} > {limit} мм, найбільшого вильоту верстата",
        "{tool} in {holder}: length {length} > {limit} mm, the machine's largest overhang",
    ),
    // Clamping, travel.
    ("safety", "коефіцієнт запасу k = {value}", "safety factor k = {value}"),
    ("friction", "коефіцієнт тертя f = {value}", "friction f = {value}"),
    (
        "screw",
        "потрібен {needed}, узято {taken}: витримує {bears} Н",
        "{needed} is needed, {taken} taken: bears {bears} N",
    ),
    (
        "no-screw",
        "жоден гвинт не витримує {force} Н на прихоплювач ({clamps})",
        "no screw bears {force} N per clamp ({clamps})",
    ),
    (
        "screw-too-weak",
        "гвинт {screw} витримує {bears} < {force} Н на прихоплювач; потрібен {needed}",
        "screw {screw} bears {bears} < {force} N per clamp; {needed} is needed",
    ),
    (
        "beyond-travel",
        "отвори по {axis} займають {span} > {travel} мм ходу стола",
        "the holes span {span} > {travel} mm of travel along {axis}",
    ),
];
