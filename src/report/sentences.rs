//! The words of notes: one sentence per code, in Ukrainian and English, with `{figures}` to fill in.
//!
//! A decision elsewhere in the program is a [`Note`], a code with its figures; only here does it become
//! a sentence. A test finds every code the program uses and holds it against this table.

use crate::note::Note;

use super::Lang;

mod allowances;
mod audit;
mod audit_program;
mod iso;
mod jobs;
mod lathe_programs;
mod lists;
mod operation;
mod programs;
mod proof;
mod routes;
mod schemes;
mod turning;
mod turning_tools;
mod workpiece;
mod zones;

/// Every sentence.
fn sentences() -> impl Iterator<Item = &'static (&'static str, &'static str, &'static str)> {
    let all = SENTENCES.iter().chain(routes::SENTENCES).chain(programs::SENTENCES);
    let all = all.chain(iso::SENTENCES).chain(jobs::SENTENCES).chain(lists::SENTENCES);
    let all = all.chain(proof::SENTENCES).chain(turning::SENTENCES).chain(schemes::SENTENCES);
    let all = all.chain(turning_tools::SENTENCES).chain(zones::SENTENCES).chain(workpiece::SENTENCES);
    let all = all.chain(audit::SENTENCES).chain(audit_program::SENTENCES);
    all.chain(lathe_programs::SENTENCES).chain(allowances::SENTENCES).chain(operation::SENTENCES)
}

/// Every code that a note can have.
pub fn codes() -> impl Iterator<Item = &'static str> {
    sentences().map(|(code, ..)| *code)
}

/// A note as a sentence. A code without words shows itself with its figures, so that nothing is lost.
pub fn sentence(note: &Note, lang: Lang) -> String {
    let Some((_, uk, en)) = sentences().find(|(code, ..)| *code == note.code) else {
        let figures: Vec<String> = note.params.iter().map(|(name, value)| format!("{name} = {value}")).collect();
        return format!("{} ({})", note.code, figures.join(", "));
    };
    let mut text = lang.pick(uk, en).to_owned();
    for (name, value) in &note.params {
        text = text.replace(&format!("{{{name}}}"), &shown(name, value, lang));
    }
    if let Some(more) = note.params.get("more") {
        text.push_str(&lang.pick(" (подібних іще {})", " (and {} more like it)").replace("{}", more));
    }
    if let Some(scheme) = note.params.get("scheme").filter(|_| !uk.contains("{scheme}")) {
        text = format!("{} {scheme}: {text}", lang.pick("схема", "scheme"));
    }
    text
}

/// What to do about a mistake of a program, of a list of points or of a shaft.
pub fn remedy(note: &Note, lang: Lang) -> Option<&'static str> {
    let mut remedies = programs::REMEDIES
        .iter()
        .chain(iso::REMEDIES)
        .chain(lists::REMEDIES)
        .chain(turning::REMEDIES)
        .chain(schemes::REMEDIES)
        .chain(lathe_programs::REMEDIES)
        .chain(operation::REMEDIES)
        .chain(workpiece::REMEDIES);
    let of_program = remedies.find(|(code, ..)| *code == note.code).map(|(_, uk, en)| lang.pick(uk, en));
    let of_proof = || proof::REMEDIES.iter().find(|(code, _)| *code == note.code);
    of_program.or_else(|| of_proof().map(|(_, (uk, en))| lang.pick(uk, en)))
}

/// Figures whose values are words of the program are translated too.
fn shown(name: &str, value: &str, lang: Lang) -> String {
    match name {
        "operation" | "instead" => super::operation_noun(value, lang).to_owned(),
        "transitions" => value.split(", ").map(|name| super::operation_noun(name, lang)).collect::<Vec<_>>().join(", "),
        "kind" | "method" | "variant" | "direction" | "rival" => term(value, lang).to_owned(),
        "take" | "by" | "name" | "shank" | "bound" => term(value, lang).to_owned(),
        "stages" => value.split(" + ").map(|stage| term(stage, lang)).collect::<Vec<_>>().join(" + "),
        "scheme" | "same" | "first" => scheme_name(value, lang),
        // A decimal number as people write it; designations and table names are none.
        _ if value.parse::<f64>().is_ok() => lang.pick(&value.replace('.', ","), value).to_owned(),
        _ => value.to_owned(),
    }
}

/// A scheme as people read it: `04 + centre`, or the transitions that a search found.
pub fn scheme_name(scheme: &str, lang: Lang) -> String {
    let part = |part| super::operation_noun(if part == "centre" { "centre-drill" } else { part }, lang);
    scheme.split(" + ").map(part).collect::<Vec<_>>().join(" + ")
}

/// A word that stands in a table as an id.
pub fn term(id: &str, lang: Lang) -> &str {
    let terms = TERMS.iter().chain(schemes::TERMS).chain(turning_tools::TERMS).chain(zones::TERMS);
    let terms = terms.chain(operation::TERMS);
    terms.into_iter().find(|(known, ..)| *known == id).map_or(id, |(_, uk, en)| lang.pick(uk, en))
}

const TERMS: &[(&str, &str, &str)] = &[
    ("parallel", "паралельно", "in parallel"),
    ("sequential", "послідовно", "in sequence"),
    ("longitudinal", "поздовжній", "longitudinal"),
    ("transverse", "поперечний", "transverse"),
    ("per-step", "за ступенями", "per step"),
    ("optimal", "оптимальний", "optimal"),
    ("chuck", "у патроні", "in a chuck"),
    ("centres", "у центрах", "between centres"),
    ("bar", "пруток", "bar"),
    ("forging", "поковка", "forging"),
    ("casting", "виливок", "casting"),
    (
        "first-parallel-finish-sequential",
        "перші переходи паралельно, кінцеві послідовно",
        "first transitions in parallel, finishing ones in sequence",
    ),
    ("own-cell", "власна клітинка", "the cell itself"),
    ("finer-roughness", "тонша шорсткість того ж квалітету", "a finer roughness of the same grade"),
    ("finer-grade", "точніший квалітет", "a finer grade"),
    ("first", "перша", "the first"),
    ("second", "друга", "the second"),
    ("practice-speed", "практика цеху", "shop practice"),
    ("drill-strength", "міцність свердла", "strength of the drill"),
    ("thrust", "осьова сила", "thrust"),
    ("spindle-torque", "крутний момент шпинделя", "spindle torque"),
    ("spindle-power", "потужність шпинделя", "spindle power"),
    ("cutting-speed", "швидкість різання", "cutting speed"),
    ("spindle-speed-max", "найбільша частота", "top spindle speed"),
    ("spindle-speed-min", "найменша частота", "lowest spindle speed"),
    ("feed-max", "найбільша подача", "top feed"),
    ("feed-min", "найменша подача", "lowest feed"),
    ("speed", "швидкість", "speed"),
    ("cylindrical", "циліндричний", "cylindrical"),
    ("morse", "конус Морзе", "Morse taper"),
    ("shell", "насадний", "shell"),
    ("finish-nc", "чистова на верстаті з ЧПК", "finishing on the NC machine"),
    ("rough-nc", "чорнова на верстаті з ЧПК", "roughing on the NC machine"),
    ("counterbored", "цекований", "counterbored"),
    ("smooth", "гладкий", "smooth"),
    ("countersunk", "зенкований", "countersunk"),
    ("threaded", "нарізний", "threaded"),
    ("precise", "точний", "precise"),
    ("thread-cylindrical", "циліндрична різь", "cylindrical thread"),
    ("thread-conical", "конічна різь", "conical thread"),
    ("counterbore", "цеківка", "counterbore"),
    ("countersink-90", "зенківка 90°", "countersink of 90°"),
    ("countersink-other", "зенківка іншого кута", "countersink of another angle"),
    ("practice-speed", "практика цеху", "shop practice"),
    ("drill-strength", "міцність свердла", "strength of the drill"),
    ("final-other", "остаточна на іншому верстаті", "final machining on another machine"),
];

const SENTENCES: &[(&str, &str, &str)] = &[
    // Visiting the holes.
    (
        "visiting-method",
        "{method} (квалітет {it}, допуск міжосьової відстані {centre} мм, K_T = {ratio})",
        "{method} (grade {it}, centre tolerance {centre} mm, K_T = {ratio})",
    ),
    (
        "position-lost-at-tool-change",
        "1.3.1 радить робити кінцеві переходи послідовно, не рухаючи деталь; верстат змінює інструмент у X {x} Y {y}, \
         тож стіл рухається і правила дотримати не можна: {tools} інструментами паралельно {parallel} хв, послідовно \
         {sequential} хв",
        "section 1.3.1 finishes each hole without moving the part; this machine changes tools at X {x} Y {y}, which \
         moves the table, so the rule cannot be kept: with {tools} tools {parallel} min in parallel, {sequential} min \
         in sequence",
    ),
    (
        "visited-in-parallel",
        "за 1.3.1 послідовний обхід був би швидший, але заміна інструмента в X {x} Y {y} рухає стіл: {tools} \
         інструментами паралельно {parallel} хв, послідовно {sequential} хв",
        "by 1.3.1 the sequential method would be quicker, but changing tools at X {x} Y {y} moves the table: with \
         {tools} tools {parallel} min in parallel, {sequential} min in sequence",
    ),
    // Schemes.
    (
        "stages",
        "етапи: {stages} (Δ0 = {delta} мм, σс = {sigma} мм)",
        "stages: {stages} (Δ0 = {delta} mm, σc = {sigma} mm)",
    ),
    ("no-stages", "для квалітету {it} етапів таблиця не дає", "the table gives no stages for grade {it}"),
    (
        "table-for-hole",
        "квалітет {it} шукаємо в {table} за рядками квалітету {asked-it}, допуск міжосьової відстані {centre} мм",
        "grade {it} is looked up in {table} by the rows of grade {asked-it}, centre tolerance {centre} mm",
    ),
    ("cell", "береться {take}", "taken: {take}"),
    ("scheme", "схема {scheme} (квалітет {it}, {roughness})", "scheme {scheme} (grade {it}, {roughness})"),
    ("which-of-two", "у клітинці {schemes}; береться {take}", "the cell offers {schemes}; taken: {take}"),
    (
        "centre",
        "центрувати: у суцільному металі, глибина {ratio} діаметра",
        "centre first: solid metal, {ratio} diameters deep",
    ),
    (
        "no-centre",
        "центрування не потрібне: квалітет {it}, Ø{diameter}, глибина {ratio} D",
        "no centring is asked for: grade {it}, Ø{diameter}, {ratio} D deep",
    ),
    ("twin", "схема {scheme} з центруванням - це схема {centred}", "scheme {scheme} with centring is scheme {centred}"),
    (
        "no-twin",
        "схема {scheme} не має пари з центруванням; воно додається",
        "scheme {scheme} has no centred twin; centring is added",
    ),
    ("transitions", "переходи схеми {scheme}", "the transitions of scheme {scheme}"),
    (
        "no-scheme",
        "таблиці не дають схеми: квалітет {it}, {roughness}, допуск {centre} мм; графи шорсткості {columns}",
        "the tables give no scheme: grade {it}, {roughness}, centre tolerance {centre} mm; roughness columns {columns}",
    ),
    (
        "no-route",
        "{diameter}: жодна зі схем не здійсненна (відхилено {tried})",
        "{diameter}: no scheme can be carried out ({tried} refused)",
    ),
    (
        "finish-elsewhere",
        "за таблицями отвір остаточно обробляють на верстаті іншого типу; тут схема {scheme}",
        "the tables finish this hole on a machine of another type; scheme {scheme} is what is done here",
    ),
    (
        "grade-without-distance",
        "centre_tolerance: IT{it} потребує двох отворів у групі; вкажіть ширину допуску в мм",
        "centre_tolerance: IT{it} needs two holes in the group; give the width in mm",
    ),
    (
        "grade-outside-table",
        "IT{it} на міжосьовій відстані {distance} мм поза таблицею: {why}",
        "IT{it} at a centre distance of {distance} mm is outside the table: {why}",
    ),
    (
        "point-breaks-through",
        "вершина свердла Ø{diameter} сягає {depth} >= {limit} мм товщини заготовки: глухий отвір проб’ється",
        "the point of the drill Ø{diameter} reaches {depth} >= {limit} mm, the blank's thickness: the blind hole breaks through",
    ),
    (
        "spot-too-deep",
        "лунка Ø{diameter} глибиною {depth} >= {limit} мм, глибини отвору",
        "the spot Ø{diameter} is {depth} >= {limit} mm deep, the depth of the hole",
    ),
    (
        "too-heavy",
        "маса {mass} > {limit} кг, найбільшої для верстата",
        "mass {mass} > {limit} kg, the most the machine takes",
    ),
    ("not-planned", "{operation}: цей перехід тут не проектується", "{operation}: not planned here"),
    ("rows-rejected", "рядки за графою {column}: {rows}", "rows by the column {column}: {rows}"),
    // Diameters.
    (
        "allowance",
        "{operation}: припуск {taken} мм на діаметр, діапазон {low}-{high} мм",
        "{operation}: allowance {taken} mm on diameter, range {low}-{high} mm",
    ),
    (
        "ground-to-size",
        "інструмент Ø{nominal} каталогу, виконаний на розмір Ø{size}",
        "the catalog's Ø{nominal} cutter, made to Ø{size}",
    ),
    (
        "rough-boring",
        "чорнове розточування: {stock} мм на діаметр за проходів: {passes}, по {low}-{high} мм",
        "rough boring: {stock} mm on diameter in passes: {passes}, {low}-{high} mm each at most",
    ),
    (
        "stock-for-elsewhere",
        "лишено {stock} мм на діаметр для іншого верстата",
        "{stock} mm on diameter left for the other machine",
    ),
    ("one-pass", "свердлити Ø{diameter} за один перехід", "drill Ø{diameter} in one pass"),
    (
        "two-passes",
        "свердлити у два переходи: спершу Ø{first}, далі Ø{diameter} (перше свердло {low}-{high} мм)",
        "drill in two passes: Ø{first} first, then Ø{diameter} (first drill {low}-{high} mm)",
    ),
    (
        "first-drill",
        "перше свердло Ø{first}: {share-min}-{share-max} від Ø{diameter}",
        "first drill Ø{first}: {share-min}-{share-max} of Ø{diameter}",
    ),
    (
        "two-passes-cost",
        "проти одного свердла: час {time} хв на отвір, осьова сила {thrust} Н замість {one-thrust} Н",
        "against one drill: {time} min per hole, thrust {thrust} N instead of {one-thrust} N",
    ),
    (
        "bored-by-stand-in",
        "Ø{diameter} замалий для оправки (від Ø{smallest}); замість розточування - {instead}",
        "Ø{diameter} is too small for a boring bar (from Ø{smallest}); {instead} stands in for boring",
    ),
    (
        "too-small-to-bore",
        "{operation}: Ø{diameter} < Ø{smallest}, найменшого отвору для оправки",
        "{operation}: Ø{diameter} < Ø{smallest}, the smallest hole a bar enters",
    ),
    (
        "no-drill",
        "немає свердла Ø{diameter}, що сягає дна; найближчі {below} і {above}",
        "no drill Ø{diameter} that reaches; the nearest are {below} and {above}",
    ),
    (
        "no-drill-in-allowance",
        "{operation} до Ø{diameter}: немає свердла від Ø{low} до Ø{high}",
        "{operation} to Ø{diameter}: no drill from Ø{low} to Ø{high}",
    ),
    (
        "no-drill-before-boring",
        "під розточування до Ø{diameter} немає свердла від Ø{smallest} до Ø{largest}",
        "boring to Ø{diameter}: no drill from Ø{smallest} to Ø{largest}",
    ),
    (
        "no-bar-enters",
        "до Ø{diameter}: жодна оправка не входить в отвір Ø{hole}",
        "to Ø{diameter}: no bar enters the hole Ø{hole}",
    ),
    (
        "bar-set-by-hand",
        "розточування за кілька проходів: між проходами оправку переналагоджують вручну; великі отвори доцільно фрезерувати (1.2.1)",
        "boring in several passes: the bar is set anew by hand between them; large holes are better milled (1.2.1)",
    ),
    ("spot-by-drill", "лунка Ø{spot}: {share} від свердла Ø{drill}", "spot Ø{spot}: {share} of the drill Ø{drill}"),
    (
        "spot-by-depth",
        "лунка Ø{spot}, не {share} від свердла Ø{drill}: глибша за половину отвору не буде",
        "spot Ø{spot}, not {share} of the drill Ø{drill}: no deeper than half of the hole",
    ),
    ("spot-by-chamfer", "лунка Ø{spot} утворює і фаску", "spot Ø{spot} makes the chamfer too"),
    ("travel", "недобіг {approach} мм, перебіг {overrun} мм", "approach {approach} mm, overrun {overrun} mm"),
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
    // Conditions.
    ("feed", "подача: верхня межа {upper} мм/об × {multiple}", "feed: upper end {upper} mm/rev × {multiple}"),
    ("feed-choice", "звідки береться подача", "where the feed comes from"),
    ("feed-before-finishing", "подача × {factor}: далі розвертання", "feed × {factor}: a reamer follows"),
    ("depth-feed-factor", "подача × {factor} за глибиною", "feed × {factor} for the depth"),
    ("depth-speed-factor", "швидкість × {factor} за глибиною", "speed × {factor} for the depth"),
    ("material-speed-factor", "швидкість × {factor} за матеріалом", "speed × {factor} for the material"),
    ("speed-alloy-factor", "швидкість × {factor} за сплавом", "speed × {factor} for the alloy"),
    ("material-force-factor", "сили × {factor} за матеріалом", "forces × {factor} for the material"),
    ("force-alloy-factor", "сили × {factor} за сплавом", "forces × {factor} for the alloy"),
    ("surface-factor", "швидкість × {factor} за станом поверхні", "speed × {factor} for the surface"),
    ("tool-life", "стійкість {minutes} хв", "tool life {minutes} min"),
    ("speed-coefficients", "коефіцієнти швидкості, Cv = {cv}", "speed coefficients, Cv = {cv}"),
    ("load-coefficients", "коефіцієнти моменту й осьової сили", "torque and thrust coefficients"),
    ("boring-feed", "подача розточування {feed} мм/об", "boring feed {feed} mm/rev"),
    ("boring-finish-feed", "подача за шорсткістю {feed} мм/об", "feed by roughness {feed} mm/rev"),
    ("too-fine-to-bore", "{roughness} розточуванням не досягається", "{roughness} is beyond boring"),
    (
        "spindle-step",
        "розрахункова частота {computed}; ступені {below} і {above} (вищий на {excess} %): {step} об/хв",
        "computed {computed}; steps {below} and {above} ({excess} % above): {step} 1/min",
    ),
    (
        "spindle-fastest",
        "розрахункова частота {computed} вища за найбільшу: {step} об/хв",
        "computed {computed} is above the top: {step} 1/min",
    ),
    (
        "spindle-slowest",
        "розрахункова частота {computed} нижча за найменшу: {step} об/хв",
        "computed {computed} is below the lowest: {step} 1/min",
    ),
    (
        "feed-reduced",
        "подачу зменшено з {from} до {to} мм/об: {by}, межа {limit}",
        "feed reduced from {from} to {to} mm/rev: {by}, limit {limit}",
    ),
    ("feed-held", "подачу обмежено {limit} мм/хв", "feed held at {limit} mm/min"),
    (
        "no-feed",
        "{operation}: таблиця {table} не має подачі для матеріалу {material}",
        "{operation}: table {table} has no feed for {material}",
    ),
    (
        "stand-in",
        "{table} не має числа для матеріалу {material}; береться {group}",
        "{table} has no figure for {material}; {group} stands in",
    ),
    (
        "no-figure",
        "{operation}: таблиця {table} не має числа для матеріалу {material}",
        "{operation}: table {table} has no figure for {material}",
    ),
    (
        "stand-in-operation",
        "{operation}: власних чисел немає; беруться числа переходу «{instead}»",
        "{operation}: no figures of its own; those of {instead} stand in",
    ),
    (
        "stand-in-tool-material",
        "{table} не має числа для інструмента {tool}; береться {other}",
        "{table} has no figure for tools of {tool}; {other} stands in",
    ),
    ("no-cutter-shape", "{operation}: фрезу не вказано", "{operation}: no mill is given"),
    ("no-pitch", "{operation}: крок різьби не вказано", "{operation}: no pitch is given"),
    (
        "mill-does-not-enter",
        "{operation}: фреза Ø{diameter} не входить в отвір Ø{hole}",
        "{operation}: the mill Ø{diameter} does not enter the hole Ø{hole}",
    ),
    (
        "milling-rounds",
        "проходів {passes}, рівнів {levels}: t = {t} мм, B = {b} мм; шлях осі фрези {path} мм, її подача × {factor}",
        "passes {passes}, levels {levels}: t = {t} mm, B = {b} mm; path of the mill's axis {path} mm, its feed × {factor}",
    ),
    ("feed-per-tooth", "подача на зуб {feed} мм", "feed per tooth {feed} mm"),
    (
        "milling-finish-feed",
        "подача на зуб × {factor}: останній прохід, {roughness}",
        "feed per tooth × {factor}: last pass, {roughness}",
    ),
    ("milling-load-coefficients", "коефіцієнти сили Pz фрези", "coefficients of the mill's main force"),
    (
        "tapping-coefficients",
        "коефіцієнти швидкості мітчика, Cv = {cv}, T = {minutes} хв",
        "speed coefficients of the tap, Cv = {cv}, T = {minutes} min",
    ),
    ("tapping-load-coefficients", "коефіцієнти моменту мітчика", "torque coefficients of the tap"),
    ("feed-is-pitch", "подача дорівнює крокові {pitch} мм", "the feed is the pitch, {pitch} mm"),
    (
        "spindle-step-below",
        "розрахункова частота {computed}; ступінь не вище неї: {step} об/хв",
        "computed speed {computed}; the step not above it: {step} 1/min",
    ),
    (
        "no-step-below",
        "{operation}: жоден ступінь шпинделя не нижчий за {computed} об/хв з достатньою потужністю й подачею",
        "{operation}: no spindle step up to {computed} 1/min has the power and the feed rate",
    ),
    (
        "torque-beyond-spindle",
        "{operation}: момент {torque} > {limit} Н·м шпинделя",
        "{operation}: torque {torque} > {limit} N·m of the spindle",
    ),
    ("reaming-feed", "подача розвертання × {factor}", "reaming feed × {factor}"),
    (
        "reaming-feed-blind",
        "глухий отвір: подача в межах {low}-{high} мм/об",
        "blind hole: feed within {low}-{high} mm/rev",
    ),
    ("reaming-load-coefficients", "коефіцієнти сили різання зуба розвертки", "force coefficients of a reamer's tooth"),
    ("reamer-teeth", "зубів розвертки {teeth}", "teeth of the reamer {teeth}"),
    (
        "too-deep",
        "{operation}: глибина {ratio} D поза таблицею {table}",
        "{operation}: {ratio} diameters deep is outside table {table}",
    ),
    ("card-calibration", "карта: {name} × {factor} від формули", "card: {name} × {factor} of the formula"),
    (
        "card-point",
        "карта друкує тут V = {speed} м/хв, P = {thrust} Н, N = {power} кВт",
        "the card prints V = {speed} m/min, P = {thrust} N, N = {power} kW here",
    ),
    (
        "card-point-forces-differ",
        "карта друкує тут V = {speed} м/хв, P = {thrust} Н, N = {power} кВт; силу й потужність формула не відтворює; навантаження взято за формулою",
        "the card prints V = {speed} m/min, P = {thrust} N, N = {power} kW here; the formula does not reproduce force and power; the loads are the formula's",
    ),
    (
        "card-corrections",
        "поправки прикладу: швидкість × {product}, матеріал {material}",
        "the example's factors: speed × {product}, material {material}",
    ),
    (
        "card-other-material",
        "поправки карт для матеріалу {material} невідомі",
        "the cards' factors for {material} are not known",
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
    ("unconfirmed", "не підтверджено: {table}, рядок {row}: {why}", "unconfirmed: {table}, row {row}: {why}"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use std::path::Path;

    /// Codes as the program writes them: `Note::new("code")`, and `note("code")` of local helpers.
    fn codes_in(folder: &Path, codes: &mut BTreeSet<String>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                codes_in(&path, codes);
                continue;
            }
            let text = std::fs::read_to_string(&path).unwrap();
            for opening in
                ["Note::new(\"", " note(\"", "series(\"", "shown(\"", "fault(\"", "fault::<()>(\"", "tell(\""]
            {
                for rest in text.split(opening).skip(1) {
                    let code = rest.split('"').next().unwrap();
                    if !code.is_empty() && code.chars().all(|c| c.is_ascii_lowercase() || c == '-') {
                        codes.insert(code.to_owned());
                    }
                }
            }
        }
    }

    #[test]
    fn every_code_of_the_program_has_its_words() {
        let mut codes = BTreeSet::new();
        for room in ["audit", "route", "tooling", "cutting", "planner", "job", "program", "turning"] {
            codes_in(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(room), &mut codes);
        }
        assert!(codes.len() > 50, "the search for codes finds too few: {}", codes.len());
        let unknown: Vec<_> = codes.iter().filter(|code| !sentences().any(|(known, ..)| known == code)).collect();
        assert!(unknown.is_empty(), "codes without words: {unknown:?}");
    }

    #[test]
    fn every_mistake_of_a_program_says_what_to_do() {
        let codes = |table: &[(&'static str, &str, &str)]| -> BTreeSet<&'static str> {
            table.iter().map(|(code, ..)| *code).collect()
        };
        for (sentences, remedies, page) in [
            (programs::SENTENCES, programs::REMEDIES, include_str!("../../docs/control-2c42-65.md")),
            (iso::SENTENCES, iso::REMEDIES, include_str!("../../docs/control-linuxcnc.md")),
            (lathe_programs::SENTENCES, lathe_programs::REMEDIES, include_str!("../../docs/turning-programs.md")),
        ] {
            let said = codes(sentences);
            assert_eq!(said, codes(remedies));
            let untold: Vec<_> = said.iter().filter(|code| !page.contains(&format!("`{code}`"))).collect();
            assert!(untold.is_empty(), "the page of the control does not name {untold:?}");
        }
    }

    #[test]
    fn both_languages_use_the_same_figures() {
        let figures = |text: &str| -> BTreeSet<String> {
            text.split('{').skip(1).filter_map(|rest| rest.split('}').next()).map(str::to_owned).collect()
        };
        for (code, uk, en) in sentences() {
            assert_eq!(figures(uk), figures(en), "{code}");
        }
    }

    #[test]
    fn a_figure_is_filled_in_and_the_failing_inequality_is_shown() {
        let note =
            Note::new("does-not-reach").with("tool", "X").with("table", "A.11").with("reach", 90).with("needed", 96);
        assert_eq!(sentence(&note, Lang::En), "X (A.11): reach 90 < 96 mm");
    }
}
