//! The words of an audit.

/// Code, Ukrainian, English.
pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    // Figures.
    ("audit-figure", "не виходить за формулою", "does not come out of the formula"),
    ("audit-decimal-point", "десяткова кома не на місці", "the decimal point is in the wrong place"),
    ("audit-sign", "знак протилежний", "the sign is the opposite one"),
    ("audit-follows", "наслідок: {fields}", "follows from {fields}"),
    (
        "audit-ground",
        "каталог цього позначення має {own} мм: під {size} мм його треба перешліфувати",
        "the catalog of this designation has {own} mm: it must be ground down to {size} mm",
    ),
    (
        "audit-no-such-reference",
        "довжини такого комплекту немає: еталонний інструмент - один із комплектів плану",
        "no assembly has that length: the reference tool is one of the plan's assemblies",
    ),
    (
        "audit-sign-by-g44",
        "знак для G44; ні план, ні програма не кажуть, G43 чи G44, а для G43 він протилежний",
        "the sign for G44; neither plan nor program says G43 or G44, and for G43 it is the opposite one",
    ),
    (
        "audit-other-corrector",
        "{tool} має коректор {corrector}, а решта інструментів - коректор свого номера",
        "{tool} has the corrector {corrector}, and every other tool that of its own number",
    ),
    ("audit-by-table", "{share} % від {value}, що дають таблиці", "{share} % of the {value} that the tables give"),
    (
        "audit-clamp-not-largest",
        "рахували для M = {torque}, а найбільшого зусилля потребує рядок {row}: M = {other}",
        "it was computed for M = {torque}, and the largest force is needed by row {row}: M = {other}",
    ),
    (
        "audit-overhang",
        "за приміткою до 5.2 п. 5 виліт від {least} до {most} мм",
        "by the note of section 5.2 item 5 the overhang is {least} to {most} mm",
    ),
    (
        "audit-no-step",
        "верстат такого ступеня не має (сусідні {below} і {above}); для розрахункових {computed} це {step}, написане \
         відхиляється на {excess} %",
        "no step of the machine (its neighbours are {below} and {above}); for the computed {computed} it is {step}, and \
         what is stated is {excess} % off",
    ),
    (
        "audit-step-fast",
        "на {excess} % вище за розрахункові {computed}: стійкість падає; правило дає {step}",
        "{excess} % above the computed {computed}: tool life falls; the rule gives {step}",
    ),
    (
        "audit-step-slow",
        "на {excess} % від розрахункових {computed}: безпечно, але довше; правило дає {step}",
        "{excess} % from the computed {computed}: safe but slower; the rule gives {step}",
    ),
    (
        "audit-not-in-series",
        "верстат такого ступеня не має: сусідні {below} і {above}",
        "no step of the machine: its neighbours are {below} and {above}",
    ),
    ("audit-series", "ряд частот верстата", "the machine's series of speeds"),
    ("audit-step-rule", "як із ряду вибирають ступінь", "how a step of the series is chosen"),
    ("audit-limit", "межа верстата", "a limit of the machine"),
    ("audit-tool-change", "час однієї заміни", "the time of one change"),
    ("audit-rank", "черга {rank}", "rank {rank}"),
    (
        "audit-beyond-machine",
        "понад межу верстата {limit} ({quantity})",
        "beyond the machine's limit of {limit} ({quantity})",
    ),
    (
        "audit-clamps",
        "закріплення не симетричне: 5.2 п. 7 радить {needed} притискачі",
        "the clamping is not symmetric: section 5.2 item 7 asks for {needed} clamps",
    ),
    (
        "audit-load-low",
        "{share} % від {load}, що дають формули довідника при подачі {feed} мм/об: усе, що з цього рахують, може бути заслабке",
        "{share} % of the {load} that the handbook's formulas give at a feed of {feed} mm/rev: whatever is reckoned from it may be too weak",
    ),
    (
        "audit-load-high",
        "{share} % від {load}, що дають формули довідника при подачі {feed} мм/об",
        "{share} % of the {load} that the handbook's formulas give at a feed of {feed} mm/rev",
    ),
    // Designations.
    ("named", "рядок каталогу", "the row of the catalog"),
    (
        "audit-designation-misprinted",
        "позначення {tool} у каталогах немає; мабуть, це {known} без початку",
        "no catalog has {tool}; doubtless {known}, its beginning lost",
    ),
    (
        "audit-designation-unknown",
        "позначення {tool} у каталогах немає; найближче {known}",
        "no catalog has {tool}; the nearest is {known}",
    ),
    ("audit-designation-alien", "позначення {tool} у каталогах немає", "no catalog has {tool}"),
    ("audit-dimensions-of", "розміри не {tool}, а {known}", "the dimensions are not those of {tool} but of {known}"),
    ("audit-tool-table", "{tool} стоїть у {known}, а не в {table}", "{tool} stands in {known}, not in {table}"),
    (
        "audit-standard-misprinted",
        "стандарт {standard} надруковано з помилкою: каталог цього позначення за {known}",
        "the standard {standard} is misprinted: the catalog of this designation is of {known}",
    ),
    (
        "audit-standard-other",
        "стандарт {standard} не цього позначення: його каталог за {known}",
        "{standard} is not the standard of this designation: its catalog is of {known}",
    ),
    (
        "audit-standard-unchecked",
        "стандарт {standard} перевірити ні за чим: каталог його не називає",
        "the standard {standard} cannot be checked: the catalog names none",
    ),
    (
        "audit-shank",
        "хвостовик не {shank}: у каталозі цього позначення він {name}",
        "the shank is not {shank}: in the catalog of this designation it is {name}",
    ),
    (
        "audit-no-catalog",
        "{designation}: каталогу немає, не перевірено",
        "{designation}: there is no catalog of it, so it was not checked",
    ),
    (
        "tool-of-other-operation",
        "{tool} не для переходу «{operation}», а для: {transitions}",
        "{tool} is not for {operation} but for {transitions}",
    ),
    (
        "tool-of-other-size",
        "{tool}: Ø{own}, а перехід вимагає Ø{needed}",
        "{tool} is Ø{own}, and the transition asks for Ø{needed}",
    ),
    (
        "holder-of-other-shank",
        "{holder} не тримає {tool}: хвостовик {shank}",
        "{holder} does not hold {tool}: its shank is {shank}",
    ),
    // The route.
    (
        "audit-hole-not-made",
        "групу {hole} (отворів {count}) не обробляє жоден перехід",
        "no transition makes the group {hole} ({count} holes)",
    ),
    (
        "audit-order",
        "{operation} стоїть після переходу {row} ({instead}), а за 1.1.2 має бути до нього",
        "{operation} stands after row {row} ({instead}), and by section 1.1.2 it comes before",
    ),
    (
        "audit-not-opened",
        "перехід лишає Ø{diameter}, а перед ним уже Ø{before}",
        "the transition leaves Ø{diameter}, and the hole is Ø{before} already",
    ),
    (
        "audit-last-diameter",
        "останній перехід лишає Ø{diameter}, а креслення вимагає {hole}",
        "the last transition leaves Ø{diameter}, and the drawing asks for {hole}",
    ),
    (
        "audit-scheme-unknown",
        "{hole}: таблиці не дають схеми {stated}; найкраща {scheme} ({table})",
        "{hole}: the tables give no scheme {stated}; the best is {scheme} ({table})",
    ),
    (
        "audit-scheme-table",
        "{hole}: схеми немає в таблиці {stated}; вона в {table} ({scheme})",
        "{hole}: the scheme is not of table {stated}; it stands in {table} ({scheme})",
    ),
    (
        "audit-route-dominated",
        "{hole}: маршрут можливий, але {rank}-й за порядком, довший на {slower} хв; кращий {scheme} ({table}): {better}",
        "{hole}: the route is possible but ranks {rank}, slower by {slower} min; better is {scheme} ({table}): {better}",
    ),
    (
        "audit-route-refused",
        "{hole}: маршрут «{transitions}» не здійсненний; найкращий {scheme} ({table})",
        "{hole}: the route \"{transitions}\" cannot be carried out; the best is {scheme} ({table})",
    ),
    (
        "audit-route-unknown",
        "{hole}: маршруту «{transitions}» таблиці не дають; найкращий {scheme} ({table})",
        "{hole}: the tables give no route \"{transitions}\"; the best is {scheme} ({table})",
    ),
    (
        "audit-tool-changes",
        "замін інструмента {changes} ({order}), а вистачило б {needed}: зайві {time} хв",
        "{changes} tool changes ({order}) where {needed} would do: {time} min too much",
    ),
    // Clamping, lengths, magazine.
    ("audit-no-screw", "гвинта {screw} у таблиці немає: {known}", "the table has no screw {screw}: {known}"),
    (
        "audit-screw-weak",
        "гвинт {screw} тримає {bears} Н, а потрібно {force} Н",
        "the screw {screw} bears {bears} N, and {force} N are needed",
    ),
    (
        "audit-screw-large",
        "гвинт {screw} більший, ніж треба для {force} Н",
        "the screw {screw} is larger than {force} N asks for",
    ),
    (
        "audit-same-corrector",
        "коректор {corrector} уже в {other}",
        "the corrector {corrector} is that of {other} already",
    ),
    (
        "audit-magazine",
        "інструментів {tools}, а місць у магазині {places}",
        "{tools} tools, and the magazine has {places} places",
    ),
    // A plan of ours, changed.
    (
        "audit-not-ours",
        "{field}: написано {stated}, а `technolog plan` дає {right}",
        "{field}: stated {stated}, and `technolog plan` gives {right}",
    ),
    (
        "audit-tool-of-transition",
        "перехід називає {tool}, а інструмент T{number} - це {other}",
        "the transition names {tool}, and the tool T{number} is {other}",
    ),
    // What is missing.
    ("audit-missing", "{section}: {what}", "{section}: {what}"),
    // Beside the handbook's formulas.
    (
        "audit-by-formula",
        "{share} % від {value}, що дає формула довідника з написаних величин",
        "{share} % of the {value} that the handbook's formula makes of what is stated",
    ),
    (
        "audit-tool-life",
        "{share} % від {value} хв, для яких довідник дає швидкості за цього діаметра",
        "{share} % of the {value} min for which the handbook gives speeds at this diameter",
    ),
    // The working zone.
    (
        "audit-zone-turned",
        "повернуті на 90°, отвори займали б {span} <= {travel} мм по {axis}",
        "turned by 90°, the holes would span {span} <= {travel} mm along {axis}",
    ),
    (
        "audit-blank-off-table",
        "заготовка по {axis}: {size} > {table} мм стола, звисає на {over} мм; покладіть її інакше або на пристрій",
        "the blank along {axis}: {size} > {table} mm of table, {over} mm stand out; lay it otherwise or on a fixture",
    ),
    (
        "audit-zone-over",
        "комплект не проходить над деталлю: {length} + недобіг {approach} + деталь {thickness} + пристрій {fixture} = \
         {needed} > {most} мм від стола до торця шпинделя; пройшов би комплект до {fits} мм",
        "the assembly does not pass over the part: {length} + approach {approach} + part {thickness} + fixture {fixture} = \
         {needed} > {most} mm from table to spindle nose; one of up to {fits} mm would pass",
    ),
    (
        "audit-zone-under",
        "повзун не опускає інструмент до дна: комплект T{other} {longest} − {length} + недобіг {approach} + глибина вістря {depth} = \
         {way} > {travel} мм ходу; досить було б комплекту від {fits} мм",
        "the quill does not bring the tool to the bottom: assembly of T{other} {longest} − {length} + approach {approach} + \
         depth of the tip {depth} = {way} > {travel} mm of travel; an assembly of {fits} mm or more would do",
    ),
    (
        "audit-zone-low",
        "повзун не опускає інструмент до дна: торець шпинделя щонайменше {least} над столом − {length} − дно {lowest} = \
         {way} > {travel} мм ходу; досить було б комплекту від {fits} мм",
        "the quill does not bring the tool to the bottom: spindle nose at least {least} over the table − {length} − \
         bottom {lowest} = {way} > {travel} mm of travel; an assembly of {fits} mm or more would do",
    ),
    (
        "audit-zone-unknown",
        "висоту не перевірено: у записі верстата немає відстані від стола до торця шпинделя",
        "the height was not checked: the record of the machine has no distance from table to spindle nose",
    ),
    // The reach.
    (
        "audit-holder-hits",
        "вістря опускається на {needed} мм нижче торця, а інструмент виступає з оправки на {reach}: оправка вдарить у деталь",
        "the tip goes {needed} mm below the face and the tool stands {reach} out of its holder: the holder would hit the part",
    ),
    (
        "audit-flute-short",
        "робоча довжина {reach} < {needed} мм: глибина, вістря і перебіг",
        "flutes of {reach} < {needed} mm: depth, point and overrun",
    ),
    // Clamps.
    (
        "audit-clamp-standard",
        "{standard} не стандарт притискача {designation}: той за {known}",
        "{standard} is not the standard of the clamp {designation}: it is of {known}",
    ),
    (
        "audit-clamp-screw",
        "гвинт {screw} не той, що в притискача {designation}: у нього {known}",
        "{screw} is not the screw of the clamp {designation}: it has {known}",
    ),
];
