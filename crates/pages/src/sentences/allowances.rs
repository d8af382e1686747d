//! The words about allowances of turning.

pub(super) const SENTENCES: &[(&str, &str, &str)] = &[
    (
        "no-lathe-to-compare",
        "верстат не названо: точність і шорсткість поверхонь ні з чим порівняти",
        "no lathe is named: there is nothing to compare the accuracy and roughness of the surfaces with",
    ),
    (
        "no-grade-to-compare",
        "{surface}: ні квалітету, ні шорсткості не вказано, тож порівняти з верстатом нема що",
        "{surface}: neither grade nor roughness is given, so there is nothing to compare with the lathe",
    ),
    (
        "finished-elsewhere",
        "{surface}: верстат не забезпечує точності або шорсткості; подальша операція - {operation}",
        "{surface}: the lathe does not hold its accuracy or roughness; the later operation is {operation}",
    ),
    (
        "finished-elsewhere-unknown",
        "{surface}: верстат не забезпечує точності або шорсткості, а чим це доробити, не відомо; проміжного припуску не лишено",
        "{surface}: the lathe does not hold its accuracy or roughness, and what finishes it is not known; no intermediate allowance is left",
    ),
    (
        "elsewhere-allowance",
        "{surface}: проміжний припуск {allowance} мм на сторону",
        "{surface}: intermediate allowance {allowance} mm on one side",
    ),
    (
        "no-allowance-for-elsewhere",
        "{surface}: для подальшої операції таблиця не має припуску на цей розмір; його не лишено",
        "{surface}: the table has no allowance of this size for the later operation; none is left",
    ),
    (
        "finishing-allowance",
        "чистовий припуск за таблицею ({place}): {allowance} мм на сторону",
        "finishing allowance by the table ({place}): {allowance} mm on one side",
    ),
    (
        "analytic-allowance",
        "чистовий припуск за похибками ({place}): {allowance} мм на сторону",
        "finishing allowance by the errors ({place}): {allowance} mm on one side",
    ),
    (
        "no-finishing-allowance",
        "{surface}: чистового припуску немає ні в таблиці, ні у файлі; вкажіть його (`allowance`)",
        "{surface}: there is no finishing allowance in the table or the file; state it (`allowance`)",
    ),
];
