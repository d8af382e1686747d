//! The words of an audit about the program of a plan.

/// Code, Ukrainian, English.
pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    // Why a program is not held against its plan.
    (
        "audit-program-no-route",
        "програму не порівняно з планом: у плані немає маршруту (`route`)",
        "the program was not held against the plan: the plan states no route (`route`)",
    ),
    (
        "audit-program-row-hole",
        "програму не порівняно з планом: рядок {row} не називає групи отворів (`hole`)",
        "the program was not held against the plan: row {row} names no group of holes (`hole`)",
    ),
    (
        "audit-program-row-tool",
        "програму не порівняно з планом: рядок {row} ({operation}) не називає інструмента (`tool`); якщо перехід на іншому \
         верстаті, напишіть `elsewhere: true`",
        "the program was not held against the plan: row {row} ({operation}) names no tool (`tool`); if it is done on \
         another machine, write `elsewhere: true`",
    ),
    (
        "audit-program-row-diameter",
        "програму не порівняно з планом: рядок {row} ({operation}) не має діаметра (`diameter`)",
        "the program was not held against the plan: row {row} ({operation}) has no diameter (`diameter`)",
    ),
    (
        "audit-program-row-depth",
        "програму не порівняно з планом: рядок {row} ({operation}) не має глибини (`depth`)",
        "the program was not held against the plan: row {row} ({operation}) has no depth (`depth`)",
    ),
    (
        "audit-program-row-thread",
        "програму не порівняно з планом: рядок {row} нарізає різь в отворі, який її на кресленні не має",
        "the program was not held against the plan: row {row} taps a hole that has no thread on the drawing",
    ),
    (
        "audit-program-row-mill",
        "програму не порівняно з планом: рядок {row} ({operation}) не каже, від якого діаметра (`from`) і якою фрезою",
        "the program was not held against the plan: row {row} ({operation}) does not say from what diameter (`from`) and \
         with which mill",
    ),
    (
        "audit-program-row-conditions",
        "програму не порівняно з планом: рядок {row} ({operation}) не має режимів (`rpm` і `feed` чи `minute_feed`)",
        "the program was not held against the plan: row {row} ({operation}) has no conditions (`rpm` and `feed` or \
         `minute_feed`)",
    ),
    (
        "audit-setting-correction",
        "наладка: H{corrector} = {value}, а за планом корекція T{tool} дорівнює {needed}",
        "the setting has H{corrector} = {value}, and by the plan the correction of T{tool} is {needed}",
    ),
];
