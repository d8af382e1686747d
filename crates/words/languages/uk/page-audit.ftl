# The page of an audit.
audit-title = Перевірка плану «{ $plan }»
audit-summary = помилок – { $error }, хибних значень – { $wrong }, сумнівних – { $doubtful }, зауважень – { $note }; з них наслідки інших – { $follow }
audit-unconfirmed = { $count ->
        [one] { $count } запис спирається
        [few] { $count } записи спираються
        [many] { $count } записів спираються
       *[other] { $count } запису спирається
    } на непідтверджені рядки { $tables-count ->
        [1] таблиці
       *[other] таблиць
    } { $tables }: кожен такий рядок нижче позначено «не підтверджено», а чому – каже `technolog table NAME`
# Sections.
audit-section-route = Маршрут
audit-section-tools = Різальний інструмент
audit-section-holders = Допоміжний інструмент
audit-section-conditions = Режими різання
audit-section-clamping = Закріплення
audit-section-lengths = Довжини і корекції
audit-section-program = Керувальна програма
audit-section-times = Час
audit-section-missing = Не вказано
# How grave a finding is.
audit-severity-error = помилка
audit-severity-wrong = хибно
audit-severity-doubtful = сумнівно
audit-severity-note = зауваження
# Heads of tables.
audit-column-section = Розділ
audit-column-error = Помилки
audit-column-wrong = Хибні значення
audit-column-doubtful = Сумнівні
audit-column-note = Зауваження
audit-column-follow = Наслідки
audit-column-file = Файл
audit-column-root = Перша причина
audit-column-marks = Бали
audit-column-taken = Знято
audit-column-severity = Вага
audit-column-place = Місце
audit-column-ground = Підстава
audit-column-about = Чого стосується
audit-column-what = Величина
audit-column-difference = Різниця
# What a finding says.
audit-about = { $about }: { $said }
audit-of-figure = { $what }: { $said }
audit-is-stated = написано { $stated }
audit-beside = написано { $stated }, має бути { $right }
audit-beside-off = написано { $stated }, має бути { $right } ({ $off } %)
audit-and-so = { $figures }; { $said }
audit-quantity = { $name } { $symbol }
audit-what-in-unit = { $what }, { $unit }
audit-factor = { $quantity } ({ $factor })
audit-tool = T{ $number }
# What it rests on.
audit-by-stated = за написаними числами: { $value }
audit-is-slip = далі рахували з правильним значенням: описка
audit-supplied = поруч не вказано, взято: { $taken }
audit-supplied-one = { $what } = { $value }
audit-rests-on = підстава: { $reasons }
audit-row = таблиця { $table }, рядок { $row }
audit-row-unconfirmed = таблиця { $table }, рядок { $row } (не підтверджено)
audit-table = таблиця { $table }
audit-table-unconfirmed = таблиця { $table } (не підтверджено)
audit-follows-from = наслідок: { $fields }
audit-changes = через це хибне: { $fields }
audit-change = { $stated } → { $right }
# What is not stated.
audit-whole-section = увесь розділ
audit-lacks = { $whose } – { $what }
audit-lacking-rows = { $count ->
        [1] рядок
       *[other] рядки
    } { $rows }
audit-some-figure = число
# Marks.
audit-marks = Бали
audit-score = { $name }: { $points } з { $of }
audit-score-passed = { $name }: { $points } з { $of }, зараховано
audit-score-failed = { $name }: { $points } з { $of }, не зараховано
audit-by-consequence = як наслідок
audit-by-rule = за правилом { $rule }
audit-by-section = за розділом «{ $section }»
audit-by-severity = за вагою
audit-by-capped = { $by }, до межі
audit-by-missing = цього немає
audit-part-missing = немає: { $part }, { $percent } %
audit-not-covered = За власними словами план не охоплює: { $parts }; за це балів не знято.
audit-part-holes = маршрут
audit-part-tools = інструмент
audit-part-conditions = режими різання
audit-part-clamping = закріплення
audit-part-program = програма
audit-part-times = час
audit-free = без втрати балів: { $counts }
audit-free-follow = наслідків – { $count }
audit-free-capped = понад межу – { $count }
audit-free-other = інших – { $count }
audit-failed-mark = { $points } (не складено)
# A folder of plans.
audit-folder = Перевірка планів
audit-folder-summary = планів – { $plans }, з них не читається – { $unread }; помилок – { $error }, хибних значень – { $wrong }, сумнівних – { $doubtful }, зауважень – { $note }
audit-no-yaml = { $place } не читається: файл записано не за правилами YAML
audit-unreadable = { $place } не читається: { $message }
audit-root = { $whereabouts } { $change }
# Two plans.
audit-against = { $a } поруч із { $b }
audit-first-plan = План 1
audit-second-plan = План 2
audit-same = плани кажуть те саме
audit-costs = Чого це коштує
audit-cost-machine = основний (машинний) час, хв
audit-cost-rapid = час холостих ходів, хв
audit-cost-tool_change = час заміни інструмента, хв
audit-cost-total = загальний час, хв
audit-cost-changes = кількість замін інструмента
audit-cost-places = місць у магазині
# Keys of plan files that are no figures.
# Parts of a plan.
audit-key-route = маршрут
audit-key-tools = інструменти
audit-key-conditions = режими різання
audit-key-clamping = закріплення
audit-key-program = керувальна програма
audit-key-times = час
audit-key-time = час
audit-key-holes = групи отворів
audit-key-transitions = переходи
audit-key-sequence = порядок обходу
# Of rows.
audit-key-row = рядок маршруту
audit-key-order = порядок рядків
audit-key-operation = перехід
audit-key-hole = група отворів
audit-key-tool = інструмент
audit-key-scheme = схема
audit-key-table = таблиця
audit-key-name = назва
audit-key-way = спосіб вибору схеми
audit-key-finish_elsewhere = чи кінчають на іншому верстаті
audit-key-elsewhere = чи роблять на іншому верстаті
audit-key-meets = чи досягається потрібне
audit-key-centre_tolerance_mm = допуск міжосьової відстані
audit-key-time_min = час маршруту
audit-key-margin_min = виграш проти наступного маршруту
audit-key-cost = вартість маршруту
audit-key-feature = елемент отвору
audit-key-face = сторона деталі
audit-key-step = ступінь отвору
audit-key-start_mm = початок переходу
audit-key-approach_mm = недобіг
audit-key-also_diameter_mm = другий діаметр
audit-key-achieved = досягнуте
audit-key-it = квалітет
audit-key-roughness = шорсткість
audit-key-position_mm = точність розташування
# Of tools.
audit-key-number = номер інструмента
audit-key-designation = позначення
audit-key-standard = стандарт
audit-key-shank = хвостовик
audit-key-holder = допоміжний інструмент
audit-key-holder_table = таблиця допоміжного інструмента
audit-key-with = слово корекції
audit-key-links = ланки комплекту
audit-key-kind = вид
audit-key-mass_kg = маса
audit-key-load = завантаження магазину
# Of conditions.
audit-key-limited_by = чим обмежено режим
audit-key-coolant = МОР
audit-key-rounds = обходи фрези
audit-key-mill_diameter_mm = діаметр фрези
audit-key-levels = кількість рівнів
audit-key-card = режим за картою
audit-key-axial_force_by_book_n = осьова сила за посібником
audit-key-power_by_book_kw = потужність за посібником
# Of the clamping.
audit-key-screw = гвинт
audit-key-proposed = чи притискачі запропоновано
audit-key-safe_distance_mm = безпечна відстань
# Of the sequence.
audit-key-setup = установ
audit-key-stops = зупинки
audit-key-transition = номер переходу
audit-key-at = точка
audit-key-x = координата X
audit-key-y = координата Y
audit-key-nearest_rapid_min = холості ходи за найближчою точкою
audit-key-bound_min = нижня межа холостих ходів
audit-key-path_mm = довжина шляху
audit-key-clamp-place = місце притискача
audit-key-holder-designation = позначення допоміжного інструмента
audit-key-holder-standard = стандарт допоміжного інструмента
audit-key-link-length = довжина ланки
# Values of such keys.
audit-value-true = так
audit-value-false = ні
audit-value-null = немає
audit-value-tables = за таблицями
audit-value-complexes = за комплексами
audit-value-search = пошуком
audit-value-bore = основний циліндр
audit-value-step = ступінь
audit-value-thread = різь
audit-value-cone = конус
audit-value-counterbore = цековане заглиблення
audit-value-countersink = зенківка
audit-value-chamfer = фаска
audit-value-face = торець
audit-value-entry = вхідна
audit-value-back = зворотна
audit-value-cutter = різальний інструмент
audit-value-holder = допоміжний інструмент
# Bounds of a machine, and its own taper.
word-thrust-z-max = найбільша осьова сила
word-spindle-torque-max = найбільший крутний момент
word-tool-overhang-max = найбільший виліт інструмента
word-taper = конус шпинделя
# Factors of the cards.
factor-material = матеріал
factor-point-grinding = заточення вершини
factor-coolant = МОР
factor-tool-life = період стійкості
factor-coating = покриття
factor-tool-material = матеріал інструмента
factor-hole-depth = глибина отвору
factor-surface-state = стан поверхні
# The command.
audit-program-in-folder = { $file }: програма, окремою роботою не порахована; якщо її не називає жоден план теки, перевірте її саму разом з деталлю: technolog audit { $file } --part PART.yaml
audit-skipped-file = { $file }: не план, пропущено
audit-marks-legend = За що знято бали: за правилом – якщо схема називає правило; за розділом – якщо вона називає розділ плану; за вагою (помилка, хибно, сумнівно) – в усіх інших випадках.
audit-no-plans = у теці `{ $folder }` немає жодного плану
audit-what-is-a-plan = плани – це файли .yaml, .yml і .json, як їх описує docs/uk/audit.md
audit-folder-against = порівняти можна лише два плани, не теку
audit-name-a-plan = назвіть файл плану
audit-class-grades = Оцінки
audit-class-mistakes = У чому група помиляється найчастіше
audit-class-mistakes-note = Помилки, що є більш ніж в одній роботі; кожну пораховано в роботі один раз, а те, що лише випливає з іншого, не пораховано.
audit-class-alike = Схожі роботи, для викладача
audit-class-alike-note = Однакові хибні числа, яких майже ніхто інший не пише. Це може бути й випадок: спитайте, перш ніж робити висновок.
audit-column-mistake = помилка
audit-column-works = робіт
audit-column-where = чиї
audit-column-work = робота
audit-column-other-work = друга робота
audit-column-same = однакове в обох
audit-column-of = з
audit-column-passed = зараховано
audit-column-taken-by = знято: { $section }
audit-column-remark = примітка
audit-same-figure = { $about }: { $stated }
audit-sheet-marks = Зняті бали
audit-sheet-nothing = Немає нічого хибного й нічого сумнівного.
audit-sheet-notes = Зауважень для охочих знати більше: { $count }; їх показує `technolog audit`.
audit-sheet-follow = { $count ->
    [one] через це хибне ще { $count } число або вибір
    [few] через це хибні ще { $count } числа або вибори
   *[many] через це хибні ще { $count } чисел або виборів
}
audit-sheets-format = аркуші студентам – це сторінки: `--format html` або `--format markdown`
audit-sheets-format-help = додайте `--format html`; відомість оцінок – це інший запуск, з `--format csv` або `xlsx`
audit-sheet-lines = (рядки
audit-folder-part = у теці роботи з різних деталей; кожна називає свою
audit-folder-part-help = назвіть деталь у кожному плані, над кожним переліком: `деталь`; або перевірте один файл із `--part`
audit-sheets-of-one = аркуші пишуть для теки робіт
audit-sheets-of-one-help = назвіть теку; сторінка одного плану – це `-o FILE.html`
