# Figures.
audit-figure = не виходить за формулою
audit-decimal-point = десяткова кома не на місці
audit-sign = знак протилежний
audit-follows = наслідок: { $fields }
audit-ground = каталог цього позначення має { $own } мм: під { $size } мм його треба перешліфувати
audit-bought = каталог цього позначення має { $own } мм: придбаний для належного поля H він лишає { $size } мм
audit-no-such-reference = довжини такого комплекту немає: еталонний інструмент – один із комплектів плану
audit-sign-by-g44 = знак для G44; ні план, ні програма не кажуть, G43 чи G44, а для G43 він протилежний
audit-other-corrector = { $tool } має коректор { $corrector }, а решта інструментів – коректор свого номера
audit-tools-exchanged = { $tool } і { $other } переплутано: кожен годиться для того, що має робити інший (рядки { $rows })
audit-two-sizes = { $tool } має лишити тут Ø{ $size }, а в рядку { $row } – Ø{ $other }: такий інструмент лишає один розмір
audit-correctors-exchanged = { $tool } і { $other } мають кожен коректор з номером іншого
audit-exchanged = переплутано з тим, що в рядку { $other }
audit-exchanged-figures = переплутано з величиною: { $other }
audit-card-row = це з рядка карти для переходу «{ $operation }» Ø{ $diameter }
audit-untried = із { $total } поєднань записаних і правильних величин перевірено лише { $tried }: можливо, це все ж наслідок інших
audit-order-opening = «{ $operation }» потребує отвору для цапфи, а «{ $instead }» – лише в рядку { $row }
audit-scheme-transitions = схема { $stated } – це { $printed }, а в рядках { $transitions }
audit-program-left-out = T{ $tool } обробляє інші точки { $hole }, а { $points } пропускає
audit-exchanged-tool = переплутано з тим, що в T{ $other }
audit-program-short = { $hole }: на глибину { $depth } мм у { $points } не йде жоден різ; найглибший там – { $reached } мм
audit-program-inches = точки програми – це точки креслення в дюймах: бракує G21 або зайвий G20
audit-by-table = { $share } % від { $value }, що дають таблиці
audit-clamp-not-largest = рахували для M = { $torque }, а найбільшої сили закріплення потребує рядок { $row }: M = { $other }
audit-mistake = саме стільки виходить, якщо { $mistake }
audit-mistake-row = саме стільки виходить, якщо { $mistake } (рядок { $row })
audit-overhang = за приміткою до 5.2 п. 5 виліт від { $least } до { $most } мм
audit-no-step = верстат такого ступеня не має (сусідні { $below } і { $above }); для розрахункових { $computed } це { $step }, написане відхиляється на { $excess } %
audit-step-fast = на { $excess } % вище за розрахункові { $computed }: період стійкості зменшується; правило дає { $step }
audit-step-lost = на { $excess } % від розрахункових { $computed }, ніби загублено нуль; правило дає { $step }
audit-step-slow = на { $excess } % від розрахункових { $computed }: безпечно, але довше; правило дає { $step }
audit-not-in-series = верстат такого ступеня не має: сусідні { $below } і { $above }
audit-outside-series = шпиндель верстата обертається від { $least } до { $most } об/хв
audit-series = ряд частот верстата
audit-step-rule = як із ряду вибирають ступінь
audit-limit = межа верстата
audit-tool-change = час однієї заміни
audit-rank = черга { $rank }
audit-beyond-machine = понад межу верстата { $limit } ({ $quantity })
audit-clamps = закріплення не симетричне: 5.2 п. 7 радить { $needed } притискачі
audit-load-low = { $share } % від { $load }, що дають формули довідника за подачі { $feed } мм/об: усе, що з цього рахують, може бути занижене
audit-load-high = { $share } % від { $load }, що дають формули довідника за подачі { $feed } мм/об
# Designations.
named = рядок каталогу
audit-designation-misprinted = позначення { $tool } у каталогах немає; можливо, це { $known } без початку
audit-designation-unknown = позначення { $tool } у каталогах немає; найближче { $known }
audit-designation-alien = позначення { $tool } перевірити ні за чим: у каталогах його немає
audit-designation-unchecked = позначення { $tool } перевірити ні за чим: у каталогах його немає; найближче { $known }
audit-designation-printed = так { $tool } надруковано в посібнику; у його ж таблиці це { $known }
audit-standard-printed = так { $standard } надруковано в посібнику; сам стандарт – { $known }
audit-clamping-other = у посібнику { $value }; у довідниках із пристроїв трапляються й інші значення, тож пораховане з цього чинне
audit-dimensions-of = написані розміри має не { $tool }, а { $known }: помилка в позначенні
audit-tool-table = { $tool } стоїть у { $known }, а не в { $table }
audit-standard-misprinted = стандарт { $standard } написано з помилкою: за каталогом це { $known }
audit-standard-other = стандарт { $standard } не цього позначення: його каталог за { $known }
audit-standard-unchecked = стандарт { $standard } перевірити ні за чим: каталог його не називає
audit-shank = хвостовик не { $shank }: за каталогом це { $name }
audit-no-catalog = { $designation }: каталогу немає, не перевірено
tool-of-other-operation = { $tool } не для переходу «{ $operation }», а для: { $transitions }
tool-of-other-size = { $tool }: Ø{ $own }, а перехід вимагає Ø{ $needed }
holder-of-other-shank = { $holder } не тримає { $tool }: його хвостовик – { $shank }
# The route.
audit-hole-not-made = групу (отворів – { $count }) не обробляє жоден перехід
audit-slot-not-checked = це паз: перевірено його фрезу, ширину й навантаження, а робочі ходи і швидкості – ні
audit-hole-not-made-either = групу (отворів – { $count }) не обробляє жоден перехід; маршруту для неї програма теж не знайшла
audit-order = { $operation } стоїть після переходу { $row } ({ $instead }), а за 1.1.2 має бути до нього
audit-not-opened = перехід лишає Ø{ $diameter }, а перед ним уже Ø{ $before }
audit-last-diameter = останній перехід лишає Ø{ $diameter }, а креслення вимагає { $hole }
audit-scheme-unknown = таблиці не дають схеми { $stated }; найкращий маршрут – { $way ->
        [search] пошук: { $scheme }
        [complex] комплекс { $scheme } ({ $table })
       *[table] схема { $scheme } ({ $table })
    }
audit-scheme-table = схеми немає в таблиці { $stated }; вона в { $table } ({ $scheme })
audit-route-dominated = маршрут можливий, але { $rank }-й за порядком, довший на { $slower } хв; кращий – { $way ->
        [search] пошук: { $scheme }
        [complex] комплекс { $scheme } ({ $table })
       *[table] схема { $scheme } ({ $table })
    }: { $better }
audit-route-as-good = маршрут { $rank }-й за порядком, довший лише на { $slower } хв: не гірший, ніж { $way ->
        [search] пошук: { $scheme }
        [complex] комплекс { $scheme } ({ $table })
       *[table] схема { $scheme } ({ $table })
    }: { $better }
audit-route-refused = маршрут «{ $transitions }» не здійсненний; найкращий – { $way ->
        [search] пошук: { $scheme }
        [complex] комплекс { $scheme } ({ $table })
       *[table] схема { $scheme } ({ $table })
    }
audit-route-unknown = маршруту «{ $transitions }» таблиці не дають; найкращий – { $way ->
        [search] пошук: { $scheme }
        [complex] комплекс { $scheme } ({ $table })
       *[table] схема { $scheme } ({ $table })
    }
audit-tool-changes = замін інструмента – { $changes } ({ $order }), а вистачило б { $needed }: зайві { $time } хв
# Clamping, lengths, magazine.
audit-no-screw = гвинта { $screw } у таблиці немає: { $known }
audit-screw-weak = гвинт { $screw } тримає { $bears } Н, а потрібно { $force } Н
audit-screw-large = гвинт { $screw } більший, ніж треба для { $force } Н
audit-same-corrector = коректор { $corrector } уже в { $other }
audit-magazine = інструментів { $tools }, а місць у магазині { $places }
# A plan of ours, changed.
audit-not-ours = { $field }: написано { $stated }, а `technolog plan` дає { $right }
audit-tool-of-transition = перехід називає { $tool }, а інструмент T{ $number } – це { $other }
# What is missing.
audit-missing = { $section }: { $what }
# Beside the handbook's formulas.
audit-by-formula = { $share } % від { $value }, що дає формула довідника з написаних величин
audit-tool-life = { $share } % від { $value } хв, для яких довідник дає швидкості за цього діаметра
# The working zone.
audit-zone-turned = повернуті на 90°, отвори займали б { $span } ≤ { $travel } мм по { $axis }
audit-blank-off-table = заготовка по { $axis } – { $size } мм, а стіл – { $table } мм: звисає на { $over } мм; покладіть її інакше або на пристосування
audit-zone-over = комплект не проходить над деталлю: { $length } + недобіг { $approach } + деталь { $thickness } + пристосування { $fixture } = { $needed } > { $most } мм від стола до торця шпинделя; пройшов би комплект до { $fits } мм
audit-zone-under = повзун не опускає інструмент до дна: комплект T{ $other } { $longest } − { $length } + недобіг { $approach } + глибина вістря { $depth } = { $way } > { $travel } мм ходу; досить було б комплекту від { $fits } мм
audit-zone-low = повзун не опускає інструмент до дна: торець шпинделя щонайменше { $least } над столом − { $length } − дно { $lowest } = { $way } > { $travel } мм ходу; досить було б комплекту від { $fits } мм
audit-zone-unknown = висоту не перевірено: у записі верстата немає відстані від стола до торця шпинделя
# The reach.
audit-holder-hits = вістря опускається на { $needed } мм нижче торця, а інструмент виступає з допоміжного інструмента на { $reach } мм: той вдарить у деталь
audit-flute-short = робоча довжина { $reach } мм, а на глибину, вістря й перебіг потрібно { $needed } мм
# Clamps.
audit-clamp-standard = { $standard } не стандарт притискача { $designation }: той за { $known }
audit-clamp-screw = гвинт { $screw } не той, що в притискача { $designation }: у нього { $known }
audit-impossible = { $name }: { $text } бути не може, { $must }
audit-column-unread = «{ $column }» не прочитано: так не зветься жодна колонка чи рядок плану
audit-column-read-as = колонку «{ $column }» прочитано як { $meant }, так само як у програмі
audit-list-without-part = перелік не називає ні деталі, ні матеріалу, ні верстата: перевірено позначення, інструменти, допоміжні інструменти й арифметику; подач, швидкостей і ступенів шпинделя не перевірено
    .help = назвіть деталь, `--part PART.yaml`, або напишіть матеріал і верстат над таблицею
audit-list-without-material = перелік не називає ні деталі, ні матеріалу: подач, швидкостей і сил із таблицями не порівняно
    .help = назвіть деталь, `--part PART.yaml`, або напишіть матеріал над таблицею
audit-list-without-machine = перелік не називає ні деталі, ні верстата: ступенів і меж верстата не перевірено
    .help = назвіть деталь, `--part PART.yaml`, або напишіть верстат над таблицею
audit-list-with-both = перелік не називає деталі: маршрутів, довжин і всього, що залежить від креслення, не перевірено
    .help = назвіть деталь: `--part PART.yaml`
