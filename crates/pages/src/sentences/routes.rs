//! The words of notes about routes: the three ways, what each holds, and why one lost.

/// Code, Ukrainian, English.
pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    // The three ways.
    ("auxiliary-scheme", "схема {scheme} для отвору «{kind}»", "scheme {scheme} for the hole `{kind}`"),
    (
        "no-auxiliary-scheme",
        "А.10 не дає схеми: {kind} Ø{diameter}, допуск міжосьової відстані {centre} мм",
        "A.10 gives no scheme: {kind} Ø{diameter}, centre tolerance {centre} mm",
    ),
    ("complex", "комплекс {complex} для отвору «{kind}»", "complex {complex} for the hole `{kind}`"),
    ("complex-transitions", "переходи комплексу {complex}", "the transitions of complex {complex}"),
    (
        "no-complex",
        "А.4 не дає комплексу: квалітет {it}, Ø{diameter}, допуск міжосьової відстані {centre} мм",
        "A.4 gives no complex: grade {it}, Ø{diameter}, centre tolerance {centre} mm",
    ),
    (
        "no-complex-group",
        "А.4 не має групи для отвору квалітету {it}, Ø{diameter}, допуск {centre} мм: вона для суцільного металу, квалітети 7-9 та 12 і грубіші",
        "A.4 has no group for a hole of grade {it}, Ø{diameter}, tolerance {centre} mm: it is for solid metal, grades 7-9 and 12 and coarser",
    ),
    (
        "searched",
        "знайдено пошуком за станами отвору: {transitions}",
        "found by the search over the states: {transitions}",
    ),
    ("searched-step", "можливий перехід: {operation}", "a transition that may follow: {operation}"),
    (
        "no-path",
        "жоден ланцюг переходів не дає квалітету {it} і {roughness}",
        "no chain of transitions reaches grade {it} and {roughness}",
    ),
    (
        "state-unreachable",
        "стан {state} з Ø{diameter} нічим не досягається",
        "nothing leads to the state {state} at Ø{diameter}",
    ),
    ("bored-by-another", "{operation} тут робить інший перехід", "{operation} is another transition's work here"),
    (
        "no-centre-in-a-hole",
        "центрування не потрібне: отвір уже є (квалітет {it}, Ø{diameter}, {ratio} D)",
        "no centring: there is a hole already (grade {it}, Ø{diameter}, {ratio} D)",
    ),
    // What a route holds.
    ("reaches", "досягається квалітет {it}, {roughness}", "reaches grade {it}, {roughness}"),
    (
        "rough-face",
        "свердління по необробленій поверхні: точність міжцентрових відстаней нижча на {percent} %; таблиці спитано з тіснішим допуском",
        "drilling into an unmachined face costs {percent} % of the accuracy of centre distances; the tables are asked with a tighter tolerance",
    ),
    (
        "misses-grade",
        "за таблицями досягається квалітет {it}, а потрібен {asked}",
        "by the tables it reaches grade {it}, and {asked} is asked",
    ),
    (
        "misses-roughness",
        "за таблицями досягається {roughness}, а потрібно {asked}",
        "by the tables it reaches {roughness}, and {asked} is asked",
    ),
    (
        "chamfer-inside-thread",
        "фаска Ø{diameter} вужча за різь {thread}: заходу мітчику не дає",
        "the chamfer Ø{diameter} is narrower than the thread {thread}: it leads no tap in",
    ),
    (
        "reaches-again",
        "те саме ще раз ширшим інструментом: квалітет {it}, {roughness}",
        "the same again by a wider tool: grade {it}, {roughness}",
    ),
    (
        "reaches-by-itself",
        "готує наступний перехід: сам по собі квалітет {it}, {roughness}",
        "prepares the next transition: by itself grade {it}, {roughness}",
    ),
    (
        "reaches-no-worse",
        "готує наступний перехід і не погіршує зробленого: квалітет {it}, {roughness}",
        "prepares the next transition and makes nothing worse: grade {it}, {roughness}",
    ),
    ("reaches-thread", "різь: {roughness}", "thread: {roughness}"),
    (
        "drills-too-short",
        "найбільше свердло, що сюди годиться, Ø{diameter}: сягає {reach} мм < {needed} мм",
        "the largest drill that would do, Ø{diameter}: it reaches {reach} mm < {needed} mm",
    ),
    (
        "promised-finer",
        "{table} обіцяє квалітет {it}, а за А.1 ці переходи дають {own}",
        "{table} promises grade {it}, and by A.1 these transitions give {own}",
    ),
    (
        "misses-position",
        "положення осі {position} > {asked} мм допустимих",
        "the position of the axis {position} > {asked} mm permitted",
    ),
    (
        "misses-axis",
        "інструмент іде за віссю литого отвору, положення якої невідоме, а допустимо {asked} мм",
        "the tool follows the axis of the cast hole, whose position is not known, and {asked} mm is permitted",
    ),
    ("misses-unknown", "таблиці не кажуть, що досягається", "the tables do not say what it reaches"),
    (
        "not-bored",
        "положення осі просить розточувального інструменту (1.2), але жодна оправка сюди не годиться; маршрут без розточування",
        "the position of the axis asks for boring (1.2), but no boring bar can be used here; the route does not bore",
    ),
    (
        "position-asks-boring",
        "не розточує, хоч допустиме відхилення осі {position} < 0.1 мм (1.2)",
        "does not bore, though the permitted position is {position} < 0.1 mm (1.2)",
    ),
    (
        "boring-not-asked",
        "розточує, хоч допустиме відхилення осі {position} >= 0.1 мм цього не просить (1.2)",
        "bores, though the permitted position {position} >= 0.1 mm does not ask for it (1.2)",
    ),
    (
        "milled-not-round",
        "фрезерований отвір Ø{diameter}: некруглість верстата {roundness} > {most} мм, частки допуску",
        "milled to Ø{diameter}: the machine's roundness {roundness} > {most} mm, its share of the tolerance",
    ),
    // Why a route lost.
    ("lost-by-time", "повільніше на {slower} хв", "slower by {slower} min"),
    (
        "lost-by-places",
        "швидше на {quicker} хв, але потребує більше місць у магазині, якого не вистачає",
        "quicker by {quicker} min, but takes more places of a magazine that does not suffice",
    ),
    ("lost-by-order", "рівний час; за порядком способів стоїть далі", "equal time; later in the order of the ways"),
    (
        "ranked-later",
        "за таблицями стоїть після {first}, яку можна здійснити",
        "the tables rank it after {first}, which can be carried out",
    ),
    ("same-as", "той самий маршрут, що {table} {same}", "the same route as {table} {same}"),
    // Diameters.
    (
        "core-drill-stock",
        "під зенкер лишають {stock} мм на діаметр від Ø{nominal}",
        "a core drill is left {stock} mm on diameter of Ø{nominal}",
    ),
    (
        "handbook-step",
        "проміжний діаметр довідника Ø{advised}; взято Ø{taken} (1.2.1: {low}-{high})",
        "the handbook's step Ø{advised}; taken Ø{taken} (1.2.1: {low}-{high})",
    ),
    (
        "handbook-step-outside",
        "проміжний діаметр довідника Ø{advised} поза межами 1.2.1 ({low}-{high}) або ряду свердел; взято Ø{taken}",
        "the handbook's step Ø{advised} is outside 1.2.1 ({low}-{high}) or the drills' series; taken Ø{taken}",
    ),
    (
        "handbook-first-drill",
        "довідник свердлить спершу Ø{first}, потім Ø{diameter}",
        "the handbook drills Ø{first} first, then Ø{diameter}",
    ),
    (
        "milled-instead",
        "Ø{diameter} великий: замість першого розточування - фрезерування (контурна система)",
        "Ø{diameter} is large: milled instead of the first boring (contouring control)",
    ),
    (
        "no-drill-before",
        "{operation} до Ø{diameter}: немає свердла, що лишає припуск (до Ø{largest})",
        "{operation} to Ø{diameter}: no drill leaves it stock (up to Ø{largest})",
    ),
    (
        "no-counterbore-in-allowance",
        "{operation} до Ø{diameter}: немає цеківки Ø{low}-{high} під припуск",
        "{operation} to Ø{diameter}: no counterbore of Ø{low}-{high} leaves the allowance",
    ),
    (
        "step-finished-elsewhere",
        "ступінь {diameter} за таблицями остаточно обробляють на іншому верстаті; тут лишено припуск",
        "the tables finish the step {diameter} on another machine; stock is left for it here",
    ),
    ("no-hole-to-open", "{operation}: немає отвору, який розкривати", "{operation}: there is no hole to open"),
    (
        "stock-too-small",
        "{operation} від Ø{start} до Ø{diameter}: припуск {stock} мм < {least} мм, інструмент не ріже",
        "{operation} from Ø{start} to Ø{diameter}: stock {stock} mm < {least} mm, the tool does not cut",
    ),
    (
        "tapped-at-once",
        "отвір заготовки Ø{start} вже під різь {thread}: лишається нарізати",
        "the blank's hole Ø{start} is that for the thread {thread} already: it is only tapped",
    ),
    (
        "opened-already",
        "{operation} до Ø{diameter}: отвір уже Ø{start}",
        "{operation} to Ø{diameter}: the hole is Ø{start} already",
    ),
    (
        "stock-outside-allowance",
        "{operation} до Ø{diameter}: припуск {stock} мм поза {low}-{high} мм",
        "{operation} to Ø{diameter}: stock {stock} mm is outside {low}-{high} mm",
    ),
    ("no-thread-to-tap", "у цього отвору немає різі", "this hole has no thread"),
    // The rest of a hole.
    ("edge", "край: до Ø{diameter}, глибина {depth} мм", "edge: to Ø{diameter}, {depth} mm deep"),
    (
        "flat-floor",
        "плоске дно: свердло спиняється на {stop} мм, фреза вирівнює до {depth} мм",
        "flat floor: the drill stops at {stop} mm, a mill levels it at {depth} mm",
    ),
    (
        "floor-not-flat",
        "плоского дна не зробити: лишається конус свердла",
        "the floor cannot be made flat: the drill's cone stays",
    ),
    (
        "flat-under-thread",
        "під різь глибиною {depth} мм отвір свердлять до {drilled} мм і конусом: плоске дно на {depth} мм неможливе; задайте `bottom: free`",
        "for a thread {depth} mm deep the hole is drilled to {drilled} mm, with a cone: no flat floor at {depth} mm; write `bottom: free`",
    ),
    (
        "too-shallow-for-flat",
        "отвір глибиною {depth} мм мілкіший за вершину свердла Ø{diameter}",
        "the hole is {depth} mm deep, shallower than the point of the drill Ø{diameter}",
    ),
    (
        "no-flat-opening",
        "Ø{diameter}: жоден інструмент не лишає плоского торця уступу; найближчі цеківки {below} і {above}",
        "Ø{diameter}: no cutter leaves a flat shoulder; the nearest counterbores are {below} and {above}",
    ),
    ("no-opening", "Ø{diameter}: нічим розкрити з Ø{start}", "Ø{diameter}: nothing opens it from Ø{start}"),
    (
        "step-too-deep",
        "ступінь глибиною {depth} >= {limit} мм, товщини заготовки",
        "the step is {depth} >= {limit} mm deep, the blank's thickness",
    ),
    (
        "groove-not-axial",
        "канавку Ø{diameter} шириною {width} мм на глибині {depth} мм осьовий інструмент не обробляє: потрібен різець на іншому верстаті",
        "no axial tool makes the groove Ø{diameter}, {width} mm wide, {depth} mm deep: it needs a recessing tool on another machine",
    ),
    ("thread-chamfer", "фаска під різь на крок {pitch} мм", "a chamfer of the pitch, {pitch} mm, for the thread"),
    ("thread-of-step", "різь {thread} на ступені", "thread {thread} on the step"),
    (
        "tap-elsewhere",
        "різь {thread}: верстат {machine} різі не нарізає; останній перехід - на іншому верстаті, його режими - орієнтир",
        "thread {thread}: the machine {machine} cannot tap; the last transition is on another machine, its conditions are a guide",
    ),
    (
        "second-setup",
        "ступені зі зворотного боку: другий установ після перевертання; координати - від першого; час перевертання не враховано",
        "steps from the back face: a second set-up after turning the part over; coordinates are those of the first; the time of turning it over is not counted",
    ),
    // Tools.
    (
        "step-drill",
        "ступінчасте свердло Ø{narrow}/Ø{wide} робить обидва діаметри за один хід",
        "a step drill Ø{narrow}/Ø{wide} makes both diameters with one stroke",
    ),
    ("no-step-drill", "немає ступінчастого свердла Ø{narrow}/Ø{wide}", "there is no step drill Ø{narrow}/Ø{wide}"),
    (
        "cutter-ground-down",
        "у каталогах немає цього розміру: Ø{own} перешліфувати на Ø{size}",
        "the catalogs lack this size: Ø{own} ground down to Ø{size}",
    ),
    (
        "mill-too-large",
        "{tool} ({table}): фреза Ø{diameter} > Ø{limit}",
        "{tool} ({table}): mill Ø{diameter} > Ø{limit}",
    ),
    (
        "tool-too-wide",
        "{tool} ({table}): Ø{diameter} > Ø{limit}, найбільшого в магазині",
        "{tool} ({table}): Ø{diameter} > Ø{limit}, the widest the magazine takes",
    ),
    (
        "assembly-too-heavy",
        "комплект з {holder}: маса {mass} > {limit} кг",
        "assembly with {holder}: mass {mass} > {limit} kg",
    ),
    (
        "practice-speed",
        "швидкість за формулою {formula} м/хв; практика цеху з швидкорізальною сталлю - до {limit} м/хв",
        "the formula gives {formula} m/min; shops drive high-speed steel at up to {limit} m/min",
    ),
    (
        "does-not-pass",
        "{tool} ({table}): Ø{diameter} >= Ø{within} ступеня, крізь який він мав би пройти",
        "{tool} ({table}): Ø{diameter} >= Ø{within} of the step it would have to pass",
    ),
    (
        "pilot-wider-than-hole",
        "{tool} ({table}): отвір під цапфу Ø{pilot} > Ø{hole}: середина лишиться невирізаною",
        "{tool} ({table}): its pilot bore Ø{pilot} > Ø{hole}: the middle would be left standing",
    ),
    (
        "chamfered-by-centring",
        "фаску тут знімає центрування: ступінчасте свердло зайве",
        "centring makes the chamfer here: a step drill has nothing to add",
    ),
    (
        "chamfer-in-countersink",
        "фаска {chamfer} мм і зенківка на тому самому краї: лишіть одну",
        "a chamfer of {chamfer} mm and a countersink at the same edge: keep one of them",
    ),
    (
        "promised",
        "таблиця схем обіцяє квалітет {it}; за А.1 цей ланцюг дає {own}",
        "the scheme table promises grade {it}; by A.1 this chain gives {own}",
    ),
    (
        "no-drill-so-large",
        "свердло Ø{diameter} > Ø{limit}, найбільшого для верстата",
        "a drill Ø{diameter} > Ø{limit}, the largest the machine takes",
    ),
    (
        "no-mill-enters",
        "жодна кінцева фреза не входить в отвір Ø{hole} із зазором {clearance} мм; найменша Ø10",
        "no end mill enters the hole Ø{hole} with {clearance} mm of room; the smallest is Ø10",
    ),
    ("no-tap", "немає мітчика {thread} у таблицях {tables}", "no tap {thread} in the tables {tables}"),
    (
        "no-cone-of-angle",
        "немає конічної зенківки {angle}° (до Ø{diameter}); у {tables} є {angles}°",
        "no countersink of {angle}° (to Ø{diameter}); {tables} has {angles}°",
    ),
    (
        "no-cone-so-wide",
        "немає зенківки {angle}° до Ø{diameter} для отвору Ø{hole}: найбільша в {tables} Ø{widest}",
        "no countersink of {angle}° to Ø{diameter} for a hole Ø{hole}: the widest of {tables} is Ø{widest}",
    ),
    ("overhang-tap", "виліт мітчика {free} мм", "a tap stands out {free} mm"),
    (
        "thread-outside-chuck",
        "різь {thread} поза патроном {low}-{high}",
        "thread {thread} is outside the chuck's {low}-{high}",
    ),
    (
        "magazine-reloaded",
        "{tools} інструментів на {places} місць: з T{first} по T{last} ставлять вручну, коли попередні відпрацювали (завантажень магазину: {loads}; час ручної заміни не враховано)",
        "{tools} tools for {places} places: from T{first} to T{last} they are loaded by hand when those before are done ({loads} loads of the magazine; the time of changing by hand is not counted)",
    ),
];
