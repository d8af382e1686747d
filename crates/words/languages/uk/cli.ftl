# Levels of diagnostics.
cli-error = помилка
cli-warning = попередження
cli-note = зауваження
cli-help = підказка
# Heads of tables.
cli-table = Таблиця
cli-row-count = Рядки
cli-kind = Вид
cli-title = Назва
cli-row = Рядок
cli-row-number = №
cli-row-source = Походження
cli-catalog = каталог
cli-decision = рішення
# Parts of a printed table.
cli-source = Джерело
cli-columns = Графи
cli-input = вхід
cli-output = відповідь
cli-optional = не в кожному рядку
cli-list = список
cli-corrections = Виправлено (*): у джерелі надруковано інакше
cli-unconfirmed = Не підтверджено (?)
cli-choices = Вибрано нами (?)
cli-reasons = З чого відновлено
cli-places = Місце в джерелі, якщо інше
cli-row-notes = Примітки до рядків
cli-notes = Примітки
cli-gaps = Чого в таблиці немає
# A lookup.
cli-result = Результат
cli-no-row = жоден рядок не підходить
cli-passed-over = Підходять теж, але не взяті
cli-rejected = Відкинуто, за першою графою, що не підійшла
cli-nearest = Найближчі рядки й що в них не підійшло
cli-nearest-values = Найближчі значення
cli-gap = Прогалина джерела
cli-question = Запит
cli-each-alone = Кожен ключ окремо знаходить
cli-empty-cell = (порожньо)
cli-command-line = командний рядок
cli-all-rejected = усі рядки поодинці: --all
cli-also-says = Рядок каже також
# The proof.
cli-hole = Отвір
cli-transition = Перехід
cli-made = Зроблено
cli-tool = T
# Phrases of commands.
cli-unknown-table = таблиці `{ $id }` немає
cli-did-you-mean = можливо, `{ $name }`?
cli-list-tables = перелік таблиць дає `technolog table`
cli-no-format = команда { $command } не має формату { $format }
cli-formats = її формати: { $known }
cli-cannot-write = { $path }: не вдалося записати: { $error }
cli-write-not-permitted = { $path }: немає дозволу на запис
cli-check-folder = назвіть файл у теці, яка є і дозволяє запис
cli-replace-link = назвіть сам файл або вилучіть посилання
cli-would-replace-input = { $file } – вхідний файл цієї команди; його не перезаписано
cli-another-file = назвіть в -o інший файл
cli-cannot-print = не вдалося вивести відповідь: { $error }
cli-print-to-file = назвіть файл для відповіді: -o FILE
cli-broken-build = вбудована база знань не читається: { $error }
cli-rebuild = перезберіть програму або вкажіть теку з базою: --knowledge DIR
cli-cannot-read = { $path }: не вдалося прочитати: { $error }
cli-not-found = { $path }: немає такого файлу
cli-not-permitted = { $path }: немає дозволу на читання
cli-is-a-folder = { $path }: це тека, а не файл
cli-check-path = перевірте шлях до файлу
cli-no-hole = { $path }: групи отворів `{ $name }` немає
cli-hole-missing = котру групу отворів пояснити? назвіть її: --hole NAME
cli-known = є: { $names }
cli-option-of-lists = { $option } стосується лише списків точок, а не файлу деталі
cli-leave-out = приберіть { $option }
cli-not-a-pair = `{ $text }` не має вигляду ключ=значення
cli-write-pair = пишіть, наприклад, { $example }
cli-no-such-key = таблиця { $table } не має ключа `{ $key }`
cli-is-output = `{ $key }` – це відповідь таблиці { $table }, а не її вхід
cli-no-such-key-but = можливо, `{ $near }`? ключі таблиці: { $known }
cli-the-keys-are = ключі таблиці: { $known }
cli-keep-one = лишіть один
cli-bad-value = ключ `{ $key }`: `{ $value }` не підходить
cli-bad-value-because = ключ `{ $key }`: { $why }
cli-expected-is = очікується: { $expected }
cli-out-of-domain = ключ `{ $key }`: { $value } поза межами таблиці: { $domain }
cli-within-domain = задайте значення в цих межах
cli-missing-keys = таблиці { $table } бракує: { $keys }
cli-give-keys = допишіть, наприклад, { $example }
cli-other-machine = верстат { $asked }, а деталь – для { $own }
cli-leave-machine = приберіть --machine або змініть machine у файлі деталі
cli-no-control = запис верстата `{ $machine }` не каже, який на ньому пристрій ЧПК
cli-unknown-control = пристрою ЧПК `{ $control }` немає
cli-alien-control = на верстаті `{ $machine }` пристрій ЧПК `{ $control }`, мови якого тут немає
cli-name-control = назвіть його: --control, є { $known }
check-of-lathe = це програма токарного верстата, а { $control } – пристрій ЧПК фрезерного
check-name-lathe = назвіть пристрій ЧПК токарного верстата: { $controls }
check-more-of-a-kind = і ще { $count }, рядки { $lines }
check-read-as = програму прочитано як програму для { $control }, бо пристрою ЧПК не названо
check-read-as-other = інший назвіть через --control: { $controls }
cli-no-machine = верстата `{ $id }` в каталозі немає
cli-by-rule = { $what } (правило: { $section ->
        [text] як пишуть програму
        [words] слова
        [blocks] кадр
        [motions] переміщення
        [cycles] цикли
        [calls] підпрограми
        [spindle] шпиндель
        [machine] верстат
        [start] стан на початку
        [part] звірення з деталлю
       *[other] посібник { $section }
    })
cli-run-lint = це вада таблиці; її показує `technolog lint`
cli-printed-otherwise = { $column }: надруковано «{ $printed }»: { $reason }
cli-all-rows-of-one-source = Походження всіх рядків: { $source }
cli-default-is = якщо не задано, { $value }
cli-refers-to = див. { $table }, { $column }
cli-one-of = одне з: { $values }
cli-word-of = слово таблиці { $table }
cli-and-more = і ще { $count }
# Counts.
cli-rows-counted = { $count } { $count ->
        [one] рядок
        [few] рядки
       *[many] рядків
    }
cli-tables-counted = { $count } { $count ->
        [one] таблиця
        [few] таблиці
       *[many] таблиць
    }
cli-problems-hidden = і ще { $count }: усі показує `--all-problems`
cli-findings-counted = { $count } { $count ->
        [one] зауваження
        [few] зауваження
       *[many] зауважень
    }
# What a column expects.
cli-expected-unit = одиниця, як-от `mm/min`
cli-expected-number = число
cli-expected-length = довжина
cli-expected-angle = кут
cli-expected-it = квалітет, від 1 до 18
cli-expected-roughness = шорсткість, наприклад "Ra 2.5"
cli-expected-in-unit = { $what }, { $unit }
cli-alien-ending = команда `{ $command }` не пише файлів { $ending }
cli-known-endings = вона пише { $known }
cli-unknown-ending = закінчення { $file } не каже, що друкувати
cli-file-twice = { $file } названо в -o двічі
cli-one-file = кілька файлів за раз пише тільки `report`
cli-not-built = цю програму зібрано без друку в { $format }
cli-build-it = зберіть її разом з ним: { $command }
cli-other-kind = це { $is }, а тут потрібен { $wanted }
cli-kind-command = для нього є команда `{ $command }`
cli-kind-turned = для нього є команда `technolog turn { $file }`, а програму до нього перевіряє `technolog check PROGRAM --control linuxcnc-lathe --part { $file }`
cli-kind-setting-of = він потрібен для `technolog check … --setting { $file }`
cli-kind-marks-of = він потрібен для `technolog audit … --marks { $file }`
cli-kind-table-of = він потрібен для `technolog lint --knowledge …`
cli-kind-help = команди й файли, які вони беруть, перелічує `technolog --help`
kind-part = файл деталі з отворами
kind-turned = файл токарної деталі
kind-plan = файл плану
kind-cases = файл випадків
kind-setting = файл налагодження
kind-marks = файл схеми оцінювання
kind-table = файл таблиці бази знань
kind-program = файл програми ЧПК
kind-list = список точок
kind-yaml = файл YAML чи JSON
cli-other-alphabet = деякі букви латинки й кирилиці виглядають однаково: у файлі деталі стоїть `{ $name }`, скопіюйте назву звідти
cli-format-contradiction = { $file }: за закінченням це { $meant }, а --format вимагає { $asked }
cli-format-contradiction-help = приберіть --format або дайте файлові інше закінчення
cli-report-no-parts = `parts` вибирає частини звіту про деталь з отворами, а це звіт про інше
cli-report-leave-parts = приберіть `parts` з основного напису
cli-report-lathe-control = для токарної деталі немає пристрою ЧПК `{ $control }`
cli-report-lathe-controls = відомі: { $known }
cli-report-audit-control = у звіті про перевірку плану `--control` нічого не означає
cli-report-no-forms = окремі форми (`--only`) має лише звіт про деталь з отворами
cli-report-leave-only = приберіть `--only`
cli-not-on-screen = { $format } – не текст, екран його не покаже
cli-name-a-file = назвіть файл: `-o звіт{ $ending }`
