//! Mistakes of files of cases.

use super::Pair;

pub(super) const SENTENCES: &[Pair] = &[
    // Questions.
    ("there are no cases here", "тут немає випадків"),
    ("write them under `tests`", "пишіть їх під `tests`"),
    ("this case asks nothing", "цей випадок нічого не питає"),
    (
        "one of `table`, `part`, `hole`, `turn`, `program`, `audit`",
        "одне з `table`, `part`, `hole`, `turn`, `program`, `audit`",
    ),
    ("two questions in one case: `{0}` and `{1}`", "два запитання в одному випадку: `{0}` і `{1}`"),
    ("make two cases of it", "зробіть з нього два випадки"),
    ("the part has `holes`, and the case has a `hole`", "деталь має `holes`, а випадок - `hole`"),
    ("leave one of them out", "приберіть одне з них"),
    ("paths are relative to the file of cases", "шляхи відлічують від файлу випадків"),
    ("`{0}` is none of the choices", "`{0}` немає серед можливого"),
    ("there is no table `{0}`", "таблиці `{0}` немає"),
    ("`technolog table` lists them", "перелік дає `technolog table`"),
    ("table {0} has no input `{1}`", "таблиця {0} не має входу `{1}`"),
    ("table {0} gives no `{1}`", "таблиця {0} не дає `{1}`"),
    ("`technolog table` shows its columns", "її графи показує `technolog table`"),
    ("table {0} needs the input `{1}` ({2})", "таблиці {0} бракує входу `{1}` ({2})"),
    (
        "table {0}, input `{1}`: {2} is outside the table's domain {3}",
        "таблиця {0}, вхід `{1}`: {2} поза межами таблиці {3}",
    ),
    ("without rates there is no time", "без подач і швидкостей немає часу"),
    ("give the shaft its `rates`", "додайте валу `rates`"),
    ("the machine is {0}, and the part is for {1}", "верстат {0}, а деталь - для {1}"),
    ("leave out `machine`", "приберіть `machine`"),
    // Expectations.
    ("`{0}` is no severity", "`{0}` - не вага зауваження"),
    ("`{0}` is not a number", "`{0}` - не число"),
    ("no number is from {0} to {1}", "немає чисел від {0} до {1}"),
    ("write the smaller one first", "спершу пишіть менше"),
    ("`within` of what?", "`within` від чого?"),
    ("write {is: 0.28, within: 5%}", "пишіть {is: 0.28, within: 5%}"),
    ("`{0}` is no tolerance", "`{0}` - не допуск"),
    (
        "write a share such as 5%, or a number above zero in the unit of the figure",
        "пишіть частку, наприклад 5%, або число, більше за нуль, в одиниці величини",
    ),
    ("`{0}` is no word of a transition", "`{0}` - не слово переходу"),
    (
        "write the operation, then what is known of it: `drill 9.8`",
        "пишіть операцію, а далі що про неї відомо: `drill 9.8`",
    ),
    ("no finding has the code `{0}`", "жодне зауваження не має коду `{0}`"),
    (
        "write a severity, or a code as the findings of --format json have it",
        "пишіть вагу або код, як їх мають зауваження у --format json",
    ),
    // Filling in.
    ("case {0} cannot be filled in where it stands", "випадок {0} не можна дописати там, де він стоїть"),
    ("write `expect: ~` on a line of its own", "напишіть `expect: ~` окремим рядком"),
];
