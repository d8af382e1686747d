//! What to do about a program that deviates from the job of a part.

const CHECK_POINT: (&str, &str) = ("перевірте координати й підпрограму", "check the coordinates and the subprogram");
const CHECK_LEVEL: (&str, &str) =
    ("перевірте рівні циклу, нуль деталі й коректор", "check the levels of the cycle, the zero and the corrector");
const CHECK_FIGURE: (&str, &str) = (
    "візьміть величину плану або переконайтеся, що ця годиться",
    "take the plan's figure, or be sure that this one does",
);
const CHECK_CYCLE: (&str, &str) =
    ("візьміть цикл, якого вимагає перехід", "take the cycle that the transition asks for");
const CHECK_CIRCLE: (&str, &str) =
    ("перевірте коло: рівень, радіус, центр, бік", "check the circle: level, radius, centre, sense");
const ADD_STOP: (&str, &str) = ("поставте M00 перед цим інструментом", "put M00 before this tool");
const CHECK_TOOL: (&str, &str) = ("перевірте T і H цього інструмента", "check T and H of this tool");
const CHECK_IDLE: (&str, &str) =
    ("приберіть зайве або переконайтеся, що це навмисно", "remove it, or be sure that it is meant");

/// Code, Ukrainian, English: what to do.
pub const REMEDIES: &[(&str, (&str, &str))] = &[
    ("not-made", ("додайте ці точки", "add these points")),
    ("cut-again", ("приберіть повтор", "remove the repetition")),
    ("cut-not-planned", CHECK_POINT),
    ("cut-elsewhere", CHECK_POINT),
    (
        "wrong-order",
        ("поставте переходи отвору в порядку плану", "put the transitions of the hole in the plan's order"),
    ),
    ("wrong-tool", CHECK_TOOL),
    ("tool-unknown", CHECK_TOOL),
    ("tool-by-work", ("перевірте, що стоїть у магазині", "check what stands in the magazine")),
    ("not-loaded", ADD_STOP),
    ("no-correction", ("введіть корекцію: G43 H", "bring it in: G43 H")),
    ("wrong-correction", CHECK_TOOL),
    ("other-corrector", CHECK_TOOL),
    (
        "wrong-sign",
        (
            "коректор - це довжина інструмента мінус довжина найдовшого",
            "a corrector is the tool's length less that of the longest",
        ),
    ),
    ("feed-per-turn", ("узгодьте F і S", "make F and S agree")),
    ("changes-elsewhere", ("перед заміною відведіть стіл і повзун", "bring table and quill there before the change")),
    ("no-corrector", CHECK_TOOL),
    ("shared-corrector", CHECK_TOOL),
    ("correction-otherwise", ("перевірте довжину інструмента", "check the length of the tool")),
    ("rapid-across", ("спершу вийдіть з деталі", "leave the part first")),
    ("rapid-into-part", ("заходьте в метал подачею", "go into the metal at feed")),
    ("rapid-into-metal", CHECK_LEVEL),
    ("spindle-stands", ("запустіть шпиндель: S і M03", "start the spindle: S and M03")),
    ("wrong-turn", ("для правого інструмента M03", "a right-hand tool needs M03")),
    ("slot", CHECK_POINT),
    ("travel-low", ("підніміть інструмент перед переходом", "raise the tool before it goes on")),
    ("too-shallow", CHECK_LEVEL),
    ("less-overrun", CHECK_LEVEL),
    ("deeper", CHECK_LEVEL),
    ("begins-lower", CHECK_LEVEL),
    ("begins-higher", CHECK_LEVEL),
    ("other-speed", CHECK_FIGURE),
    ("other-feed", CHECK_FIGURE),
    ("other-dwell", CHECK_FIGURE),
    ("dwell-elsewhere", CHECK_IDLE),
    ("coolant-missing", ("увімкніть охолодження", "switch the coolant on")),
    ("coolant-superfluous", CHECK_IDLE),
    ("steps-not-planned", CHECK_CYCLE),
    ("step-too-large", CHECK_FIGURE),
    ("step-smaller", CHECK_FIGURE),
    ("step-clearance", CHECK_FIGURE),
    ("step-return", CHECK_CYCLE),
    ("out-at-rapid", CHECK_CYCLE),
    ("out-at-feed", CHECK_CYCLE),
    ("out-other-feed", CHECK_FIGURE),
    ("out-too-high", CHECK_CYCLE),
    ("out-too-low", CHECK_CYCLE),
    ("out-elsewhere", CHECK_CYCLE),
    ("out-turning", CHECK_CYCLE),
    ("out-standing", CHECK_CYCLE),
    ("circle-missing", CHECK_CIRCLE),
    ("circle-superfluous", CHECK_CIRCLE),
    ("circle-level", CHECK_CIRCLE),
    ("circle-radius", CHECK_CIRCLE),
    ("circle-centre", CHECK_CIRCLE),
    ("circle-sense", CHECK_CIRCLE),
    ("circle-open", CHECK_CIRCLE),
    ("circle-again", CHECK_CIRCLE),
    ("ways-between-circles", CHECK_IDLE),
    ("ways-down", CHECK_IDLE),
    ("oblique", CHECK_POINT),
    ("not-in-the-middle", CHECK_POINT),
    ("no-stop-to-load", ADD_STOP),
    ("no-stop-to-turn-over", ADD_STOP),
    ("no-stop-to-set-bar", ADD_STOP),
    ("not-turned-over", ADD_STOP),
    ("stop-for-nothing", CHECK_IDLE),
    ("other-order", ("порівняйте з `technolog order`", "compare with `technolog order`")),
    ("idle-point", CHECK_IDLE),
    ("idle-height", CHECK_IDLE),
    ("air-at-feed", CHECK_IDLE),
    ("travel-at-feed", CHECK_IDLE),
    ("travel-high", CHECK_IDLE),
    ("travel-not-up", ("спершу підніміть повзун", "raise the quill first")),
    ("radius-correction", ("скасуйте її: G40", "end it: G40")),
    ("approach-standing", ("запустіть шпиндель раніше: S і M03", "start the spindle before it: S and M03")),
    ("dwell-in-air", CHECK_IDLE),
    ("turns-to-change", ("зупиніть шпиндель: M05", "stop the spindle: M05")),
    ("correction-at-change", ("скасуйте її: G49", "cancel it: G49")),
    ("turns-at-change", ("зупиніть шпиндель: M05", "stop the spindle: M05")),
    ("coolant-at-change", ("вимкніть охолодження: M09", "switch it off: M09")),
    ("turns-at-end", ("зупиніть шпиндель: M05", "stop the spindle: M05")),
    ("coolant-at-end", ("вимкніть охолодження: M09", "switch it off: M09")),
    ("ends-elsewhere", ("відведіть стіл і повзун до точки заміни", "bring table and quill to the place of the change")),
    ("no-end", ("закінчіть програму M02 або M30", "end the program with M02 or M30")),
];
