# What all pages of turning say.
turn-by-row = { $said } ({ $table }, рядок { $row }; { $place })
turn-by-table = { $said } ({ $table }; { $place })
turn-findings = Зауваження
turn-figure = Половина осьового перерізу; вільний торець праворуч.
turn-map-figure = Те саме графіком; L/D за логарифмічною шкалою.
turn-figure-seen = Рисунок до цієї сторінки; його показує -o FILE.html
turn-material = Матеріал
turn-blank-label = Заготовка
turn-blank = { $kind } Ø{ $diameter } × { $length } мм, { $holding }
turn-blank-with-bore = { $kind } Ø{ $diameter }/{ $bore } × { $length } мм, { $holding }
turn-scheme = Схема
turn-passes = Робочі ходи
turn-cutting = Шлях різання
turn-time = Час
turn-zone = Зона
turn-depth = Глибина
turn-length = Довжина
# Names that surfaces have by their place on the contour.
surface-outer = зовн.
surface-inner = внутр.
# The page of a stepped shaft.
turn-steps = Ступені від вільного торця
turn-levels = Рівні, глибина до { $depth } мм
turn-slices = Шари, глибина до { $depth } мм
turn-objective = Мета
turn-least-path = найменший шлях різання
turn-least-path-and-passes = найменший шлях різання; кожен робочий хід додає { $per_pass } мм
turn-least-time = найменший час
turn-fewest-passes = найменше робочих ходів
turn-equal-division = Припуск між уступами поділено порівну.
turn-rich-moves = Ходи розширені: робочий хід може зупинитися будь-де на сітці й знімати менше за повну глибину.
turn-ways = Способи чорнової обробки
turn-ways-name = Спосіб
turn-ways-refused = × { $way }: { $why }
turn-ways-leaves = { $way }: лишається метал для чистового ходу: { $what }
turn-ways-program = Програма цього способу: `--show program --variant { $name }`; так само пишеться кожен безпечний спосіб таблиці.
turn-path = Шлях різання
turn-passes-across = Поперечні ходи
turn-proven = Доведено: на сітці з { $radii } { $radii ->
        [one] радіуса
        [few] радіусів
       *[many] радіусів
    } і { $zs } Z кращої послідовності немає.
turn-bounded = На сітці з { $radii } { $radii ->
        [one] радіуса
        [few] радіусів
       *[many] радіусів
    } і { $zs } Z жодна послідовність не може дати менше за { $bound }; показано найкращу знайдену.
turn-optimum = Оптимальна послідовність за робочими ходами
turn-direction = Напрям
turn-why = Чому
turn-recommended = Рекомендація
turn-levels-and-zones = Рівні та зони (лекція 12.4)
turn-limiting-depth = Гранична глибина різання { $limit } мм; робочі ходи циклів завглибшки { $depth } мм, останній – скільки лишилося.
turn-from-diameter = з Ø
turn-scheme-of-passes = Схема ходів
turn-levels-key = t – припуск на сторону, i – кількість робочих ходів.
turn-horizontals = Горизонталі від Z { $z }: Ø{ $diameters }.
turn-whole-zone = Уся зона: { $zone }; { $schemes }.
turn-idle = Холості ходи
turn-scheme-is = { $scheme } – { $what } ({ $place })
turn-points = Опорні точки: { $points }.
# The map over length to diameter.
turn-map = { $shaft }: наскільки варіанти довші за оптимум, якщо вал розтягнути
turn-map-above = { $variant }, понад оптимум
turn-map-best = Найкращий із трьох
turn-map-along = Від L/D = { $ratio } самі поздовжні ходи не гірші за самі поперечні.
turn-map-across = Від L/D = { $ratio } самі поперечні ходи кращі за самі поздовжні.
# The page of an operation.
turn-machine = Обладнання
turn-no-lathe = верстата не вказано
turn-set-ups = Установи та поверхні (лекція 12.1)
turn-set-up = Установ { $number }
turn-contour-outer = Зовнішній контур
turn-contour-inner = Внутрішній контур
turn-surface = Поверхня
turn-surface-kind = Вид поверхні
turn-all-main = Усі поверхні – основні елементи.
turn-rest-main = Основні елементи – усі, крім названих нижче додаткових.
turn-finish-allowance = Чистовий припуск
turn-sized = { $surface }: { $drawn } – від { $least } до { $most } мм, програма робить { $made }
turn-later = { $surface }: подальша операція – { $operation }, припуск для неї { $allowance } мм
turn-allowances = Припуски (лекція 12.2)
turn-set-up-column = Установ
turn-side = Бік
turn-side-outer = зовнішній
turn-side-inner = внутрішній
turn-allowance-rough = 1: чорновий
turn-allowance-additional = 2: додаткових елементів
turn-allowance-finish = 3: чистовий
turn-rough-volume = Об’єм чорнового
turn-unit-mm2 = мм²
turn-unit-cm3 = см³
turn-zones = Зони та різці (лекція 12.3)
turn-zone-kind = Вид зони
turn-zone-face = торцева
turn-zone-inner = { $zone } внутр.
turn-tool = Різець
turn-no-tool = немає
turn-limit = t{"гр"}
turn-depth-of-pass = t{"р.х"}
turn-zones-key = t{"гр"} – гранична глибина різання, t{"р.х"} – глибина робочого ходу; φ, φ1 – потрібний кут ≤ кут різця.
turn-of-zone = зона { $zone }: { $said }
turn-limits = зона { $zone }: граничну глибину за подачі { $feed } мм/об визначає { $bound }; обмеження, мм: { $bounds }
turn-bound = { $bound } { $depth }
turn-tool-refused = зона { $zone }: { $tool } не підходить: { $why }
turn-closed-zones = Додаткові елементи: закриті зони
turn-closed-zone = Z { $from } → { $to } установа { $number }
turn-transitions = Схеми чорнових переходів (лекція 12.4)
turn-work = Зона { $zone }, Z { $from } → { $to }
turn-depth-of-work = Глибина робочого ходу t{"р.х"} = { $depth } мм.
turn-conditions = S = { $feed } мм/об, V = { $speed } м/хв, n = { $rpm } об/хв, S{"хв"} = { $rate } мм/хв.
turn-conditions-with-force = S = { $feed } мм/об, V = { $speed } м/хв, n = { $rpm } об/хв, S{"хв"} = { $rate } мм/хв; Pz = { $force } Н, N = { $power } кВт.
turn-even = серед схем із рівномірним припуском { $best }
turn-scheme-refused = схему «{ $scheme }» відхилено: { $why }
turn-support-point = { $name }: Ø{ $diameter }, Z { $z }
turn-support-points = опорні точки: { $points }
turn-taken-by-rule = узято «{ $scheme }», бо так каже файл або правило зони; «{ $quicker }» швидша
turn-taken = Взято
turn-beside = Робоча подача поза металом
turn-rapid = Прискорені переміщення
turn-ridges = Гребінці
# Переходи установу, інструмент за інструментом.
turn-jobs = Переходи за інструментами
turn-job = Перехід
turn-job-nose = r
turn-job-of = установ { $number }
turn-job-feed = S
turn-job-time = Установ { $number }: різання { $cutting } хв, прискорені переміщення { $rapids } хв, заміни інструмента ({ $count }) { $changes } хв, пуски шпинделя { $starts } хв, установлення і зняття деталі { $load } хв; разом { $total } хв.
turn-job-time-without = Різання і прискорені переміщення – ті, що в програмі; часи замін, пусків та установлення – з таблиці «Патрон і задня бабка, коли паспорт верстата їх не називає»; пуски й установлення не підтверджені. Шляхів до позиції заміни інструмента й назад у них немає: її вибирає наладчик.
turn-does-face = підрізати торець
turn-does-centre = зацентрувати
turn-does-drill = свердлити
turn-does-flatten = вирівняти дно
turn-does-countersink = зняти фаску зенківкою
turn-does-core-drill = зенкерувати
turn-does-ream = розвернути
turn-does-rough = точити начорно
turn-does-finish = точити начисто
turn-does-groove = проточити канавку
turn-does-thread = нарізати різь
turn-does-tap = нарізати різь мітчиком
turn-does-part-off = відрізати
turn-total = Разом
turn-total-of = { $count } { $count ->
        [one] чорновий перехід
        [few] чорнові переходи
       *[many] чорнових переходів
    }: шлях різання { $cutting } мм, час { $time } хв.
# The programs of an operation.
turn-program = { $number }: установ { $set_up }, { $count ->
        [one] інструмент
        [few] інструменти
       *[many] інструменти
    } { $tools }
turn-program-not-written = { $program }: { $why }
turn-one-of-programs = записано програму { $number } з { $of }, лише для установа { $set_up }; решта: { $others }
turn-written-despite = Замовлене все одно записано: усієї деталі воно не робить, і пускати його не можна, доки помилок не усунуто.
turn-no-such-program = немає програми з таким номером
turn-programs-are = вкажіть у --number одну з цих: { $known }
turn-norm-outside = Зовнішні діаметри й зовнішні різі: часу на їх контроль немає в жодній доступній таблиці, тож у нормі його немає.
turn-no-programs = програм немає, бо жодної зони деталі не спроєктовано
turn-see-operation = чому – каже `technolog turn ФАЙЛ --show operation`
turn-tool-not-written = { $tool }: { $why }
# Карта налагодження токарного верстата.
turn-setting-zero = ПЧПК: { $control }. Z 0 – оброблений вільний торець, X 0 – вісь. Програми ведуть теоретичну вершину кожного різця вже з урахуванням радіуса: на ПЧПК корекція на радіус не вмикається.
turn-setting-stand = Установ { $number }: { $held }; заготовка виступає на { $stock } мм перед Z 0
turn-setting-tools = Інструменти
turn-setting-insert = Пластина
turn-setting-shank = Державка, { $unit }
turn-setting-tip = Положення вершини
turn-setting-sizes = Розміри з допусками
turn-setting-drawn = Креслення
turn-setting-limits = Межі
turn-setting-programmed = У програмі
turn-setting-size-corrected = У програмі – середина поля допуску: виміряйте першу деталь і введіть різницю в корекцію на знос.
turn-setting-ground = Розміри під подальшу обробку
turn-setting-later = Подальша операція
turn-setting-turned = Ø після точіння
turn-setting-left = Припуск на сторону
turn-setting-ground-allowance = Розмір креслення витримує подальша операція; на цьому верстаті вимірюють розмір із припуском.
turn-setting-threads = Різі
turn-setting-surface = Поверхня
turn-setting-thread = Різь
turn-setting-crests = Ø вершин
turn-setting-wire = Дріт
turn-setting-over-wires = На трьох дротах
turn-setting-thread-cut = { $thread }: { $how }
turn-single-passes = Різь у цій програмі нарізають окремі ходи: { $why }.
turn-setting-thread-measured = d2 – середній діаметр: чистовий робочий хід ведуть до середини його поля. Міряють різевим мікрометром, зовнішню різь – ще й трьома дротами, внутрішню – різевим калібром-пробкою.
turn-setting-wires = Дріт у таблиці – найвигідніший: P/√3, торкається профілю на d2. Для іншого дроту dw розмір на дротах M = d2 + 3·dw − 0,866·P.
turn-setting-measured = Як виміряти вильоти
turn-setting-offsets = { $tool }: X: { $x }; Z: { $z }
turn-setting-seat = T{ $place }, коректор { $offset }
turn-tool-table-head = { $part }: X і Z дорівнюють 0, доки їх не виміряно: торкніться деталі й уведіть їх у таблицю інструментів
set-x-diameter = торкнутися обточеного діаметра й увести його виміряне значення
set-x-bore = торкнутися розточеного отвору й увести його виміряний діаметр
set-x-axis = інструмент стоїть на осі шпинделя: X 0
set-z-face = торкнутися обробленого торця й увести його Z
set-z-blade = торкнутися обробленого торця боком леза з боку патрона й увести його Z
set-z-shoulder = торкнутися уступу, оберненого до патрона, й увести його Z
set-z-point = торкнутися обробленого торця вершиною й увести його Z
set-z-front = торкнутися обробленого торця торцем інструмента й увести його Z
set-z-thread = на око підвести вершину до обробленого торця й увести його Z
set-z-nose = центр радіуса вершини; торець його не торкається, тож виміряти приладом для налагодження
set-z-presetter = теоретична вершина; різальна кромка нависає над торцем, тож виміряти приладом для налагодження
set-zero-again = після перевертання Z 0 шукають знову: готова деталь завдовжки { $length } мм, тож Z 0 – на такій відстані від готового торця біля патрона
set-driver = повідка не вибрано: хомутик або торцевий повідок, менший за те, що точать на цьому кінці; у задній бабці – обертовий центр
turret-holds = T{ $place }: { $tool }, коректор { $offset }
turret-exchanged = T{ $place }: { $tool } замість { $out }, коректор { $offset }
turret-begins = на початку програми стоять: { $tools }
turret-stop = перед { $before } програма зупиняється (M0): { $tools }; поставте інструменти, задайте їхні корекції й пустіть програму далі
jaws-stop = перед { $before } програма зупиняється (M0): { $what } й пустіть програму далі
jaws-stop-loosen = попустіть кулачки до { $force } кН
jaws-stop-tighten = затисніть кулачки до { $force } кН
# Drawings.
turn-panel = { $variant }: шлях різання { $path } мм, { $count } { $count ->
        [one] робочий хід
        [few] робочі ходи
       *[many] робочих ходів
    }
turn-frames = { $variant }: { $path } мм, { $count } { $count ->
        [one] робочий хід
        [few] робочі ходи
       *[many] робочих ходів
    }; світлим показано ще не зняте
turn-frame = { $number }. { $kind }, { $length } мм, разом { $sum }
turn-scheme-panel = { $scheme }: різання { $cutting } мм, холості ходи { $idle } мм, { $time } хв
turn-working-feed = робоча подача
turn-drawn-diameter = Ø{ $nominal } { $fit }: { $least }…{ $most }
turn-drawn-plain = Ø{ $diameter }
turn-drawn-length = { $nominal } { $fit }: { $least }…{ $most }
turn-drawn-ground = Ø{ $turned } під { $operation }, припуск { $left } на сторону
turn-layers = Установ { $set_up }, { $side }: припуски та зони
turn-way = Установ { $set_up }, { $side }, зона { $zone }: { $scheme }, t{"р.х"} = { $depth } мм; різання { $cutting } мм, { $time } хв
turn-way-rapid = прискорене переміщення
turn-way-cut = робочий хід
turn-way-infeed = врізання
turn-way-pick-up = підбір
turn-way-semi-finish = напівчистовий хід
turn-way-finish = чистовий хід
turn-way-return = подача поза металом
turn-way-plunge = врізання
turn-way-thread = різь
turn-report-title = Звіт про токарну операцію: { $part }
turn-report-drawings = Ескізи операції та шляхи інструментів
turn-report-setting = Карта налагодження
turn-report-programs = Керувальні програми
turn-report-way = Установ { $set_up }, { $side }: шлях інструмента по зоні { $zone }
