//! Every word the command line shows, in Ukrainian and in English.
//!
//! Plain words are a [`Word`]; sentences with something in them are functions of the same name in
//! both languages; the help of commands and options stands in English beside them in the code and
//! in Ukrainian in [`super::help_uk`]. What is wrong with a file of a user stands in `report::mistakes`; the
//! messages for authors of knowledge are English in both.

use std::fmt::Display;

use technolog::knowledge::{Column, ColumnType};
pub use technolog::report::Lang;
use technolog::units::Unit;

macro_rules! words {
    ($($key:ident: $uk:literal, $en:literal;)*) => {
        /// A word or a heading.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Word { $(#[doc = $en] $key),* }

        impl Word {
            /// The word in a language.
            pub const fn text(self, lang: Lang) -> &'static str {
                match self { $(Self::$key => lang.pick($uk, $en)),* }
            }
        }
    };
}

words! {
    // Levels of diagnostics.
    Error: "помилка", "error";
    Warning: "попередження", "warning";
    Note: "зауваження", "note";
    Help: "підказка", "help";

    // Heads of tables.
    Table: "таблиця", "table";
    RowCount: "рядків", "rows";
    Kind: "вид", "kind";
    Title: "назва", "title";
    RowNumber: "№", "No.";
    RowSource: "походження", "origin";
    Catalog: "каталог", "catalog";
    Decision: "рішення", "decision";

    // Where the figures of a row come from.
    Seed: "текст", "text";
    Standard: "стандарт", "standard";
    Reconstructed: "відновлено", "reconstructed";

    // Parts of a printed table.
    Source: "Джерело", "Source";
    Columns: "Графи", "Columns";
    Input: "вхід", "input";
    Output: "відповідь", "output";
    Optional: "не в кожному рядку", "not in every row";
    List: "список", "list";
    Corrections: "Виправлено (*): у джерелі надруковано інакше", "Corrected (*): the source prints otherwise";
    Unconfirmed: "Не підтверджено (?)", "Unconfirmed (?)";
    Reasons: "З чого відновлено", "Reconstructed from";
    Places: "Місце в джерелі, якщо інше", "Place in the source, where another";
    RowNotes: "Примітки до рядків", "Notes on rows";
    Notes: "Примітки", "Notes";
    Gaps: "Чого в таблиці немає", "What the table does not hold";

    // The order.
    QuickerThanBoth: "швидше за обидва способи", "quicker than either method";
    NotQuicker: "не швидше за паралельний чи послідовний спосіб", "not quicker than parallel or sequential";

    // A lookup.
    Result: "Результат", "Result";
    NoRow: "жоден рядок не підходить", "no row applies";
    ByDefault: "за замовчуванням", "by default";
    PassedOver: "Підходять теж, але не взяті", "Match too, but not taken";
    Rejected: "Відкинуто, за першою графою, що не підійшла", "Rejected, by the first column that failed";
    Nearest: "Найближчі рядки й що в них не підійшло", "Nearest rows and what failed in them";
    NearestValues: "Найближчі значення", "Nearest values";
    Gap: "Прогалина джерела", "Gap of the source";
    Question: "Запит", "Query";
    EachAlone: "Кожен ключ окремо знаходить", "Each key on its own finds";
    EmptyCell: "(порожньо)", "(empty)";
    CommandLine: "командний рядок", "command line";
    AllRejected: "усі рядки поодинці: --all", "every row on its own: --all";
    Trace:
        "Рухи: рядок, кадр, рух, положення осей верстата, мм", "Motions: line, block, motion, machine position in mm";
    AlsoSays: "Рядок каже також", "The row also says";

    // The proof.
    ProofHead: "Зроблено з того, що вимагає план:", "Made of what the plan asks for:";
    Hole: "отвір", "hole";
    Transition: "перехід", "transition";
    Made: "зроблено", "made";

    // The order.
    Tool: "T", "T";
    Stops: "зупинок", "stops";
    Points: "точок", "points";
    PathMm: "шлях, мм", "path, mm";
    RapidsMin: "холості ходи, хв", "rapids, min";
    NearestMin: "за правилом посібника, хв", "by the book's rule, min";
    NearestMm: "за правилом посібника, мм", "by the book's rule, mm";
    Saved: "економія", "saved";
    BoundMin: "не менше, хв", "at least, min";
    BoundMm: "не менше, мм", "at least, mm";
    VisitingHead: "Метод обходу за 1.3.1 (план обходить паралельно):", "Method of visiting by 1.3.1 (the plan visits in parallel):";
}

macro_rules! phrases {
    ($($name:ident($($arg:ident),*): $uk:literal, $en:literal;)*) => {$(
        #[doc = $en]
        pub fn $name(lang: Lang, $($arg: impl Display),*) -> String {
            match lang {
                Lang::Uk => format!($uk),
                Lang::En => format!($en),
            }
        }
    )*};
}

phrases! {
    unknown_table(id): "таблиці `{id}` немає", "there is no table `{id}`";
    did_you_mean(name): "мабуть, `{name}`?", "did you mean `{name}`?";
    list_tables(): "перелік таблиць дає `technolog table`", "`technolog table` lists them";
    no_format(command, format):
        "команда {command} не має формату {format}", "the command {command} has no format {format}";
    formats(known): "її формати: {known}", "its formats are {known}";
    cannot_write(path, error): "{path}: не вдалося записати: {error}", "{path}: cannot be written: {error}";
    check_folder():
        "назвіть файл у теці, яка є і дозволяє запис", "name a file in a folder that exists and can be written";
    cannot_print(error): "не вдалося вивести відповідь: {error}", "the answer cannot be printed: {error}";
    print_to_file(): "назвіть файл для відповіді: -o FILE", "name a file for the answer: -o FILE";
    broken_build(error):
        "вбудована база знань не читається: {error}", "the embedded knowledge cannot be read: {error}";
    rebuild():
        "перезберіть програму або вкажіть теку з базою: --knowledge DIR",
        "build the program anew, or name a folder with --knowledge DIR";

    cannot_read(path, error): "{path}: не вдалося прочитати: {error}", "{path}: cannot be read: {error}";
    check_path(): "перевірте шлях до файлу", "check the path of the file";
    no_hole(path, name): "{path}: групи отворів `{name}` немає", "{path}: there is no group of holes `{name}`";
    known(names): "є: {names}", "there are: {names}";

    name_machine():
        "назвіть верстат із catalogs/machines, наприклад gf2171", "name a machine of catalogs/machines, such as gf2171";
    point(x, y): "[{x};{y}]", "[{x};{y}]";
    order_of(part, home):
        "{part}. Порядок інструментів і шлях кожного від точки заміни {home} і назад.",
        "{part}. The order of tools, and the path of each from the tool-change position {home} and back.";
    visit_title(tool, setup, time): "T{tool}, установ {setup}: {time} хв", "T{tool}, set-up {setup}: {time} min";
    list_title(points, length): "точок {points}, шлях {length} мм", "{points} points, path {length} mm";
    mixture(tools, time, both):
        "найшвидша суміш, останні інструменти ({tools}) послідовно: {time} хв, {both}",
        "the quickest mixture, the last {tools} tools in sequence: {time} min, {both}";
    option_of_lists(option):
        "{option} стосується лише списків точок, а не файлу деталі", "{option} is for lists of points, not for a part file";
    leave_out(option): "приберіть {option}", "leave out {option}";
    visiting_line(hole, why, parallel, sequential, true_sequential):
        "{hole}: {why}; Tпар = {parallel} хв, Tпосл = {sequential} хв, на цьому верстаті послідовно {true_sequential} хв",
        "{hole}: {why}; Tpar = {parallel} min, Tseq = {sequential} min, sequential on this machine {true_sequential} min";

    not_a_pair(text): "`{text}` не має вигляду ключ=значення", "`{text}` is not of the form key=value";
    write_pair(example): "пишіть, наприклад, {example}", "write, for example, {example}";
    no_such_key(table, key): "таблиця {table} не має ключа `{key}`", "table {table} has no key `{key}`";
    is_output(table, key):
        "`{key}` - це відповідь таблиці {table}, а не її вхід", "`{key}` is an output of table {table}, not an input";
    no_such_key_but(near, known):
        "мабуть, `{near}`? ключі таблиці: {known}", "did you mean `{near}`? the keys of the table are {known}";
    the_keys_are(known): "ключі таблиці: {known}", "the keys of the table are {known}";
    key_twice(key): "ключ `{key}` стоїть двічі", "the key `{key}` stands twice";
    keep_one(): "лишіть один", "keep one of them";
    bad_value(key, value): "ключ `{key}`: `{value}` не підходить", "key `{key}`: `{value}` does not do";
    bad_value_because(key, why): "ключ `{key}`: {why}", "key `{key}`: {why}";
    expected_is(expected): "очікується: {expected}", "expected: {expected}";
    out_of_domain(key, value, domain):
        "ключ `{key}`: {value} поза межами таблиці, {domain}", "key `{key}`: {value} is outside the table's domain {domain}";
    missing_keys(table, keys): "таблиці {table} бракує: {keys}", "table {table} also needs {keys}";
    give_keys(example): "допишіть, наприклад, {example}", "add, for example, {example}";
    stand_of_part(setup, supports, nose):
        "установ {setup}: деталь на опорах {supports} мм; від столу до торця шпинделя при верхньому повзуні {nose} мм",
        "set-up {setup}: the part on supports of {supports} mm; {nose} mm from the table to the spindle's nose with the quill up";
    tool_in_place(place, corrector, name, diameter, length):
        "T{place} H{corrector}: {name}, Ø{diameter}, довжина {length} мм",
        "T{place} H{corrector}: {name}, Ø{diameter}, {length} mm long";
    other_machine(asked, own):
        "верстат {asked}, а деталь - для {own}", "the machine is {asked}, and the part is for {own}";
    leave_machine():
        "приберіть --machine або змініть machine у файлі деталі", "leave out --machine, or change the part's machine";
    no_control(machine):
        "запис верстата `{machine}` не каже, який на ньому ПЧПК",
        "the record of the machine `{machine}` does not say which control it has";
    alien_control(machine, control):
        "на верстаті `{machine}` ПЧПК `{control}`, мови якого тут немає",
        "the machine `{machine}` has the control `{control}`, whose language is not known here";
    name_control(known): "назвіть його: --control, є {known}", "name one with --control: there are {known}";
    no_machine(id): "верстата `{id}` в каталозі немає", "the catalog has no machine `{id}`";
    by_rule(what, section): "{what} (правило: {section})", "{what} (rule: {section})";
    times(total, feed, rapid, dwell, change):
        "Час, хв: {total} (подача {feed}, прискорено {rapid}, паузи {dwell}, заміна інструмента {change})",
        "Time, min: {total} (feed {feed}, rapid {rapid}, dwell {dwell}, tool change {change})";
    run_lint(): "це вада таблиці; її показує `technolog lint`", "the table is at fault; `technolog lint` shows where";

    printed_otherwise(column, printed, reason):
        "{column}: надруковано «{printed}»: {reason}", "{column}: printed as \"{printed}\": {reason}";
    all_rows_of_one_source(source): "походження всіх рядків: {source}", "origin of every row: {source}";
    default_is(value): "якщо не вказано, {value}", "{value} unless given";
    refers_to(table, column): "див. {table}, {column}", "see {table}, {column}";
    one_of(values): "одне з: {values}", "one of {values}";
    and_more(count): "і ще {count}", "and {count} more";
}

/// A count with its noun: `3 рядки`, `3 rows`.
pub fn counted(lang: Lang, count: usize, uk: [&str; 3], en: [&str; 2]) -> String {
    let noun = match lang {
        Lang::En => en[usize::from(count != 1)],
        Lang::Uk => match (count % 100, count % 10) {
            (11..=14, _) => uk[2],
            (_, 1) => uk[0],
            (_, 2..=4) => uk[1],
            _ => uk[2],
        },
    };
    format!("{count} {noun}")
}

/// `5 рядків`, `5 rows`.
pub fn rows(lang: Lang, count: usize) -> String {
    counted(lang, count, ["рядок", "рядки", "рядків"], ["row", "rows"])
}

/// `5 таблиць`, `5 tables`.
pub fn tables(lang: Lang, count: usize) -> String {
    counted(lang, count, ["таблиця", "таблиці", "таблиць"], ["table", "tables"])
}

/// `5 зауважень`, `5 findings`.
pub fn findings(lang: Lang, count: usize) -> String {
    counted(lang, count, ["зауваження", "зауваження", "зауважень"], ["finding", "findings"])
}

/// `рядок 3`, `рядки 3, 5-8`: rows by their numbers.
pub fn rows_named(lang: Lang, numbers: &[usize]) -> String {
    let noun = match (lang, numbers.len()) {
        (Lang::Uk, 1) => "рядок",
        (Lang::Uk, _) => "рядки",
        (Lang::En, 1) => "row",
        (Lang::En, _) => "rows",
    };
    let mut spans: Vec<(usize, usize)> = Vec::new();
    for &number in numbers {
        match spans.last_mut() {
            Some((_, last)) if *last + 1 == number => *last = number,
            _ => spans.push((number, number)),
        }
    }
    let shown: Vec<String> = spans
        .iter()
        .map(|&(first, last)| match last - first {
            0 => first.to_string(),
            1 => format!("{first}, {last}"),
            _ => format!("{first}-{last}"),
        })
        .collect();
    format!("{noun} {}", shown.join(", "))
}

/// A unit as people write it; nothing for a pure number.
pub fn unit(lang: Lang, unit: Unit) -> &'static str {
    let uk = match unit {
        Unit::None => return "",
        Unit::Degree => return "°",
        Unit::Millimetre => "мм",
        Unit::Micrometre => "мкм",
        Unit::Newton => "Н",
        Unit::NewtonMetre => "Н·м",
        Unit::Kilowatt => "кВт",
        Unit::MetrePerMinute => "м/хв",
        Unit::MillimetrePerRev => "мм/об",
        Unit::MillimetrePerTooth => "мм/зуб",
        Unit::MillimetrePerMinute => "мм/хв",
        Unit::MillimetrePerSecondSquared => "мм/с²",
        Unit::RevPerMinute => "об/хв",
        Unit::Minute => "хв",
        Unit::Second => "с",
        Unit::Kilogram => "кг",
        Unit::Megapascal => "МПа",
        Unit::Kilobyte => "кБ",
        other => other.text(),
    };
    lang.pick(uk, unit.text())
}

/// What a value of a column looks like: `довжина в мм`, `a length in mm`.
pub fn expected(lang: Lang, column: &Column) -> String {
    let unit = unit(lang, column.unit);
    let in_unit = match (unit, lang) {
        ("", _) => String::new(),
        (unit, Lang::Uk) => format!(", {unit}"),
        (unit, Lang::En) => format!(" in {unit}"),
    };
    match column.ty {
        ColumnType::Text => lang.pick("текст", "a text").to_owned(),
        ColumnType::Enum => one_of(lang, column.values.join(", ")),
        ColumnType::Bool => lang.pick("true або false", "true or false").to_owned(),
        ColumnType::Int => format!("{}{in_unit}", lang.pick("ціле число", "a whole number")),
        ColumnType::Number => format!("{}{in_unit}", lang.pick("число", "a number")),
        ColumnType::Length => format!("{}{in_unit}", lang.pick("довжина", "a length")),
        ColumnType::Angle => format!("{}{in_unit}", lang.pick("кут", "an angle")),
        ColumnType::It => lang.pick("квалітет, від 1 до 18", "a tolerance grade, 1 to 18").to_owned(),
        ColumnType::Roughness => {
            lang.pick("шорсткість, наприклад \"Ra 2.5\"", "a roughness such as \"Ra 2.5\"").to_owned()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_language_comes_from_the_first_part_of_lang() {
        for (variable, lang) in [
            (None, Lang::Uk),
            (Some(""), Lang::Uk),
            (Some("C"), Lang::Uk),
            (Some("uk_UA.UTF-8"), Lang::Uk),
            (Some("en_US.UTF-8"), Lang::En),
            (Some("en"), Lang::En),
            (Some("enm_XX"), Lang::Uk),
        ] {
            assert_eq!(Lang::of_environment(variable), lang, "{variable:?}");
        }
    }

    #[test]
    fn ukrainian_nouns_follow_their_number() {
        for (count, text) in
            [(0, "0 рядків"), (1, "1 рядок"), (3, "3 рядки"), (12, "12 рядків"), (21, "21 рядок"), (104, "104 рядки")]
        {
            assert_eq!(rows(Lang::Uk, count), text);
        }
    }

    #[test]
    fn row_numbers_are_drawn_together() {
        assert_eq!(rows_named(Lang::En, &[1, 2, 3, 5, 7, 8]), "rows 1-3, 5, 7, 8");
        assert_eq!(rows_named(Lang::Uk, &[4]), "рядок 4");
    }
}
