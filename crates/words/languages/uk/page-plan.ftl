# The page of a plan.
plan-title = План оброблення: { $part }
plan-material = Матеріал
plan-material-of-strength = { $material } (HB { $hardness }, σв { $strength } МПа)
plan-material-of-hardness = { $material } (HB { $hardness })
plan-blank = Заготовка
plan-plate = плита { $length } × { $width } × { $thickness } мм
plan-disc = диск Ø{ $diameter } × { $thickness } мм
plan-ring = кільце Ø{ $diameter } / Ø{ $bore } × { $thickness } мм
plan-machine = Обладнання
# Its sections.
plan-route = 1. Технологічний маршрут
plan-tools = 2. Різальний і допоміжний інструмент
plan-conditions = 3. Режими різання
plan-clamping = 4. Установлення й закріплення
plan-no-clamping = План не призначає ні притискачів, ні лещат: деталь має тримати власне пристосування.
plan-corrections = 5. Корекція на довжину інструмента
plan-time = 6. Час
plan-findings = 7. Зауваження
# The route.
plan-operation = { $number } { $name }
plan-operation-number = 005
plan-operation-name = Комплексна з ЧПК
plan-step-head = Зміст переходу
plan-scheme = Схема
plan-cutter = Різальний інструмент
plan-reached = Квалітет і Ra (таблиці)
plan-set-up = Установити й закріпити заготовку
plan-turn-over = Перевернути деталь: установ { $setup }
plan-take-off = Зняти деталь
plan-step = { $verb } { $count } отв. { $size } ({ $hole })
plan-step-to = { $verb } { $count } отв. { $size } ({ $hole }) до Ø{ $diameter }
plan-step-spot = { $verb } { $count } отв. { $size } ({ $hole }), витримуючи Ø{ $diameter }
plan-step-floor = { $verb } дно { $count } отв. { $size } ({ $hole }), Ø{ $diameter }
plan-step-face = { $verb } торець Ø{ $diameter } { $count } отв. { $size } ({ $hole })
plan-step-slot = { $verb } паз { $size } ({ $hole }) до ширини { $width }
plan-step-pocket = { $verb } кишеню { $size } ({ $hole }) до ширини { $width }
plan-pocket-size = { $width } × { $length } R{ $corner }
plan-slot-size = { $width } × { $length }
plan-size-for-thread = під різь { $thread }
plan-open-slot-size = { $width } × { $length }, відкритий
plan-step-within = допускається від Ø{ $smallest } до Ø{ $largest }
plan-step-also = одночасно Ø{ $diameter }
plan-step-passes = { $count } { $count ->
    [one] робочий хід
    [few] робочі ходи
   *[many] робочих ходів
}
plan-step-round = обходячи край по колу
plan-step-stock = припуск { $stock } мм, до обробленого торця
plan-step-depth = глибина { $depth } мм
plan-step-back = зі зворотного боку
plan-step-elsewhere = на іншому верстаті
plan-by-table = { $table } { $scheme }
plan-by-complex = { $table } комплекс { $scheme }
plan-by-search = пошук
plan-by-search-as = пошук ({ $table } { $scheme })
plan-order = Порядок обходу
plan-point = [{ $x }; { $y }]
plan-choices = Вимоги, вибраний маршрут і наступний за ним
plan-choice = { $required }. Маршрут: { $route }, { $time } хв; { $against }
plan-required = IT{ $it }, { $roughness }, допуск міжосьової відстані { $centre } мм
plan-required-step = ступінь { $diameter }, { $roughness }
plan-route-made = { $route } ({ $operations })
plan-required-thread = { $thread }, допуск міжосьової відстані { $centre } мм
plan-no-runner-up = іншого здійсненного маршруту немає
plan-runner-up = наступний – { $route } ({ $operations }): { $why }
# The tools.
plan-designation = Позначення
plan-table = Таблиця
plan-does = Перехід
plan-holder = Допоміжний інструмент
plan-holder-length = { "l" }опр
plan-overhang = Виліт
plan-assembly = Довжина комплекту { "L" }к
plan-length = Довжина { "L" }к
plan-correction = Корекція (G43)
plan-book-correction = За посібником Lmax − L
# The cutting conditions.
plan-hole = Отв.
plan-hole-or-slot = Отв., паз
plan-transition = Перехід
plan-feed = S
plan-feed-per-min = { "S" }хв
plan-thrust = Ро
plan-torque = Мкр
plan-machine-time = То
plan-mark = { $mark } – спирається на рядок таблиці, якого ніщо не підтверджує: див. зауваження.
plan-for-one-hole = L – шлях на робочій подачі, t – глибина різання, S – подача, V – швидкість різання, n – частота обертання, { "S" }хв – хвилинна подача, Ро – осьова сила, Мкр – крутний момент, N, кВт – потужність, То – основний (машинний) час на один отвір або паз.
plan-coolant = З МОР: { $operations }.
plan-limited = { $hole }, { $operation } Ø{ $diameter }: режим обмежує { $by }
plan-card = { $hole }, { $operation }: за картою S = { $feed } мм/об, V = { $speed } м/хв, Ро = { $force } Н, N = { $power } кВт
# Clamping and time.
plan-largest-force = Найбільша потрібна сила закріплення – для { $surface } { $hole }: M = { $torque } Н·м, до притискача { $distance } мм, W = k·M/(f·d) = { $force } Н.
plan-largest-side-force = Найбільша потрібна сила закріплення – для { $surface } { $hole }: за M = { $torque } Н·м інструмент зсуває деталь із силою P = 2·M/D = { $side } Н; щоб вона не ковзала під притискачами й на опорах, W = k·P/(f + f2) = { $force } Н.
plan-clamps = Притискачі { $points }: сила на кожному Q = { $force } Н, гвинт { $screw }; точка заміни інструмента – не ближче ніж { $distance } мм від притискача.
plan-clamps-proposed = Притискачі { $points } (запропоновано): сила на кожному Q = { $force } Н, гвинт { $screw }; точка заміни інструмента – не ближче ніж { $distance } мм від притискача.
plan-weak-screw = Гвинт заслабкий: витримує { $bears } Н, а потрібно { $force } Н.
plan-lies = Лівий бік тоді на X{ $x }, передній – на Y{ $y } від середини стола, передній бік – уздовж пазів.
plan-lies-axis = Її вісь тоді – близько X{ $x } Y{ $y } від середини стола.
plan-vice = Установ { $setup }: лещата { $vice }, губки вздовж { $axis }, розведені на { $opened } мм; деталь { $on }, { $height } мм над столом.
plan-on-parallels = на підкладках заввишки { $height } мм, не товщих за { $thickness } мм
plan-on-ways = на напрямних
plan-vice-grips = Губки тримають { $grip } мм і кінчаються на { $below } мм нижче за поверхню; для { $surface } { $hole } вони стискають із силою { $force } Н, а лещата дають { $gives } Н.
plan-vice-stop = Нерухома губка – біля її { $jaw } боку, торцевий упор – біля { $side }.
plan-chuck = Установ { $setup }: патрон { $chuck } лежить на столі тильним боком, закріплений; кулачки повернуто для дисків, перший – під { $first }° від X, інші – під { $second }° і { $third }°; деталь на сходинці { $step } кулачків, { $height } мм над столом, її притискають донизу, перш ніж затиснути кулачки.
plan-chuck-grips = Кулачки тримають { $grip } мм і кінчаються на { $below } мм нижче за поверхню; під деталлю поряд із кулачками { $room } мм до корпуса; для { $surface } { $hole } вони стискають разом із силою { $force } Н, а патрон дає { $gives } Н.
plan-once-chuck = Їх знаходять один раз: вісь кожної наступної деталі кулачки ставлять туди ж.
plan-stops = Притуліть її до упорів: двох біля { $long } боку й одного біля { $short }.
plan-stops-one = Притуліть її до двох упорів біля { $long } боку.
plan-once = Їх знаходять один раз: кожна наступна деталь стає до тих самих упорів.
plan-once-pins = Їх знаходять один раз: кожна наступна деталь сідає на ті самі пальці.
plan-once-axis = На кожній деталі знову: де її вісь, каже лише її обвід.
plan-disc-angle = Поверніть її навколо осі, доки вже оброблений отвір поза віссю не стане туди, де його має перевернуте креслення.
plan-zero-by-pin = { $frame }: виведіть шпиндель на вісь круглого пальця за індикатором і зчитайте xM, yM: X = xM{ $right }, Y = yM{ $back }; близько X{ $x } Y{ $y }.
plan-zero-by-axis = { $frame }: обертайте індикатор у шпинделі по обводу диска або в його отворі, доки він не стоятиме нерухомо, і зчитайте xM, yM: X = xM{ $right }, Y = yM{ $back }; близько X{ $x } Y{ $y }.
plan-turned = Для установа { $setup } переверніть деталь навколо її лінії вздовж Y: лівий і правий боки міняються місцями, передній лишається спереду, поверхня установа 1 лягає вниз. Уже зроблено: { $made }; тепер з іншого боку: { $now }.
plan-turned-first = Для установа { $setup } покладіть деталь першою поверхнею креслення вниз, перевернувши навколо її лінії вздовж Y: лівий і правий боки міняються місцями, передній лишається спереду. Тепер роблять: { $now }.
plan-bar-before = T{ $tool }: борштангу налаштуйте на Ø{ $diameter } ({ $holes }) до початку програми.
plan-bar-at-stop = T{ $tool }: коли програма зупиниться перед { $holes }, налаштуйте борштангу на Ø{ $diameter }.
plan-loading = Поки деталь установлюють і закріплюють, шпиндель стоїть у лівому дальньому від вас куті, X{ $x } Y{ $y } креслення, не ближче ніж { $distance } мм від кожного притискача (1.11): виведіть його туди вручну.
plan-loading-beyond = У лівому дальньому від вас куті, за { $distance } мм від кожного притискача (1.11), – X{ $x } Y{ $y } креслення, на { $beyond } мм за межею ходу вздовж X: потрібні упори, що обмежують поворот ключа.
plan-loading-at-start = Лівий дальній від вас кут (1.11), X{ $x } Y{ $y } креслення, – на { $beyond } мм за межею ходу вздовж X: поки деталь установлюють і закріплюють, шпиндель стоїть там, де міняють інструмент; звідти до кожного притискача не менше ніж { $distance } мм.
plan-pin-round = Круглий палець { $standard } у точці { $at }: Ø{ $diameter }{ $field } ({ $upper }; { $lower }) в отворі { $hole }, зазор від { $least } до { $most } мм.
plan-pin-cut = Зрізаний палець { $standard } у точці { $at }: Ø{ $diameter }{ $field } ({ $upper }; { $lower }) в отворі { $hole }, зазор від { $least } до { $most } мм; його стрічки завширшки { $land } мм тримають поперек лінії до круглого пальця.
plan-pin-cut-alone = Зрізаний палець { $standard } у точці { $at }: Ø{ $diameter }{ $field } ({ $upper }; { $lower }) в отворі { $hole }, зазор від { $least } до { $most } мм; його стрічки завширшки { $land } мм тримають уздовж { $axis }.
plan-pin-pair = Між осями пальців { $apart } мм. Кожна деталь на них сяде, доки допуски цієї відстані, пальців і отворів разом, не ширші за { $together } мм; найдальший від круглого пальця отвір повертає вбік щонайбільше на { $turned } мм.
plan-locating-error-pins = Це коштує від { $least } до { $most } мм від деталі до деталі – зазор круглого пальця.
plan-knee = Консоль: { $nose } мм від стола до торця шпинделя, повзун угорі.
plan-zero-by-sides = { $frame }: торкніться { $side } й { $end } боку оправкою Ø d і зчитайте xM, yM: X = xM{ $right }, Y = yM{ $back }; близько X{ $x } Y{ $y }.
plan-side-left = лівого
plan-side-right = правого
plan-side-front = переднього
plan-side-back = заднього
plan-same-face = Уздовж X це та сама грань деталі, що й в установі 1, тепер з іншого боку: похибка довжини заготовки не зсуває отворів.
plan-lengths-measured = Ці довжини – суми з каталогів: кожен комплект виміряти й набрати виміряну довжину.
plan-straps = Притискачі { $width } мм завширшки й { $length } мм завдовжки, назовні через найближчий край; з гайками не вищі за { $height } мм над поверхнею, інструменти йдуть над ними.
plan-studs = Їхні шпильки стоять поза деталлю: де там немає паза стола – на плиті-основі, товщина якої входить у fixture.height.
plan-straps-lower = Притискачі з гайками мають бути нижчі ніж { $most } мм над поверхнею: на цій висоті за файлом ідуть інструменти.
plan-zero-by-face = { $frame }: торкніться поверхні еталонним інструментом{ $tool } і зчитайте zM: Z = zM{ $face }; близько Z{ $z } для довжин комплектів цього плану.
plan-start = Вихідна точка й заміна інструмента – X{ $x } Y{ $y } креслення, повзун угорі; між місцями оброблення – { $level } мм над поверхнею.
plan-start-to-clamp = До найближчого притискача звідти { $away } мм.
plan-fixture-universal-straps = Універсальне пристосування: притискачі на столі (1.6).
plan-fixture-universal-vice = Універсальне пристосування: лещата (1.6).
plan-fixture-special-nothing = Потрібне спеціальне пристосування (1.6): ні притискачі, ні лещата, ні патрон деталі не тримають.
plan-fixture-special-not-in-chuck = Потрібне пристосування (1.6), або приберіть `holding: chuck`: патрон, якого просить файл, деталі не тримає.
plan-fixture-special-straps = Потрібне спеціальне пристосування (1.6): під самими притискачами деталь пружинить.
plan-fixture-special-pins = Потрібне спеціальне пристосування (1.6): сталева плита з пальцями під деталь і притискачами на ній.
plan-fixture-special-vice = Потрібне спеціальне пристосування (1.6): у лещатах деталь пружинить.
plan-fixture-universal-chuck = Універсальне пристосування: трикулачковий патрон на столі (1.6).
plan-fixture-special-chuck = Потрібне спеціальне пристосування (1.6): у патроні деталь пружинить.
plan-fixture-specialised-chuck = Переналагоджуваний патрон, для всієї групи деталей (1.6).
plan-fixture-specialised-straps = Переналагоджуване пристосування з притискачами, для всієї групи деталей (1.6).
plan-fixture-specialised-vice = Переналагоджувані лещата, для всієї групи деталей (1.6).
plan-fixture-specialised-nothing = Переналагоджуване пристосування, для всієї групи деталей (1.6).
plan-keying-two-keys = На столі: дві шпонки в центральному пазу, з вивірянням уздовж нього – найменш точний спосіб (1.7, а).
plan-keying-coordinate-plate = На столі: штирі в отворах координатної плити (1.7, б).
plan-keying-cross-elements = На столі: за поперечним пазом або центральним отвором (1.7, в).
plan-locating-three-planes = Деталь: на трьох площинах – тій, на якій лежить, і двох бокових (1.9).
plan-locating-two-planes-and-hole = Деталь: на двох площинах і отворі (1.9).
plan-locating-plane-and-two-holes = Деталь: на площині й двох класних отворах, найточніше (1.9).
plan-locating-plane-and-axis = Деталь: на торці й за віссю; боків, до яких її притулити, диск не має.
plan-clamps-turned = X рахують, як деталь лежить тепер: навпаки, ніж на кресленні.
plan-keying-play = Це коштує до { $play } мм зазору*.
plan-locating-error = Це коштує від { $least } до { $most } мм від деталі до деталі*.
plan-fixture-special-own = Власне пристосування (1.6).
plan-own-fixture = Деталь тримає { $name }. Для { $surface } { $hole } воно має втримати { $safety } × M = { $torque } Н·м.
plan-own-fixture-pushed = Деталь тримає { $name }. Для { $surface } { $hole } воно має втримати { $safety } × M = { $torque } Н·м і { $safety } × бокову силу { $side } Н.
plan-other-zero = { $frame }, для { $holes }, на кожній деталі знову: торкніться { $side } й { $end } боку оправкою Ø d і зчитайте xM, yM: X = xM{ $right }, Y = yM{ $back }; на заготовці номінального розміру – X і Y від { $first }. Z – як у { $first }.
plan-chain-hole = Отвори
plan-chain-from = База
plan-chain-axis = Уздовж
plan-chain-sum = Похибки
plan-chain-worst = У найгіршому разі
plan-chain-likely = Імовірнісно
plan-chain-tolerance = Допуск
plan-chain-closes = Ланцюг
plan-chain-term = { $what } { $field }
plan-chains-how = Поля похибок, мм; імовірнісно – корінь із суми їхніх квадратів.
plan-supports-given = Установ { $setup }: деталь на опорах { $height } мм, як задано у файлі.
plan-in-own = Установ { $setup }: деталь лежить у своєму пристосуванні за { $height } мм над столом, як задано у файлі.
plan-on-plate = Установ { $setup }: деталь на опорах плити з пальцями, { $height } мм над столом, як задано у файлі; опори – не під наскрізними отворами.
plan-supports-assumed = Установ { $setup }: деталь на опорах { $height } мм, щоб інструментові було куди вийти під деталлю й вистачало ходу повзуна; у файлі висоти не задано (fixture.height).
plan-supports-where = Опори – під притискачами й за крайніми отворами, щоб осьова сила не перекидала деталь, і не під наскрізними отворами.
plan-supports-none = Установ { $setup }: опори не потрібні, інструмент під деталь не виходить; у файлі висоти не задано (fixture.height).
plan-times = { $parts } = { $total } хв
plan-time-machine = Машинний час { $time }
plan-time-feed-out = інші ходи на робочій подачі { $time }
plan-time-dwell = витримки { $time }
plan-time-rapid = час холостих ходів { $time }
plan-time-change = час заміни інструмента { $time }
plan-time-hand = ручні прийоми під час зупинок програми { $time }
# Findings: how grave they are.
plan-impossible = помилка
plan-wrong = хибно
plan-doubtful = сумнівно
plan-note = зауваження
plan-of-pocket = кишеня { $pocket }: { $finding }
plan-of-slot = паз { $slot }: { $finding }
# Genitive: for the hole.
plan-hole-of = отвору
plan-slot-of = паза
plan-of-hole = отвір { $hole }: { $finding }
# Why a hole is made as it is.
explain-title = Отвір { $hole } { $size }
explain-scheme = Схема { $scheme } ({ $table })
explain-others = Інші маршрути і чому не вони
explain-other-route = { $route }: { $why }
explain-other-route-timed = { $route }, { $time } хв: { $why }
explain-made = { $operation } Ø{ $diameter }
explain-transition-only-elsewhere = { $number }. { $verb } Ø{ $diameter } на іншому верстаті
explain-transition-elsewhere = { $number }. { $verb } Ø{ $diameter } на іншому верстаті – { $designation }, { $holder }
explain-transition = { $number }. { $verb } Ø{ $diameter } – T{ $tool } { $designation }, { $holder }
explain-conditions = S = { $feed } мм/об, V = { $speed } м/хв, n = { $rpm } об/хв
explain-decision = { $decision } [{ $rests }: { $place }]
explain-row = рядок { $row }
explain-seed = надруковано в джерелі
explain-standard = за стандартом
explain-reconstructed = відновлено
explain-reason = підстава: { $why }
explain-to-be-ground = * { $why }
explain-unconfirmed = * не підтверджено: { $why }
explain-not-taken = не взято: { $why }
explain-sources = Джерела, названі літерами
explain-source = { $id } – { $source }
plan-bought = { $designation }, для H{ $it }
plan-bottoming-tap = { $designation }, з короткою забірною частиною { $lead } P (форма E за DIN 2197)
plan-pilot = { $designation }, напрямна цапфа Ø{ $pilot }
plan-ground = { $designation }, перешліфувати з Ø{ $from } на Ø{ $to }
plan-ground-exactly = { $designation }, новий перешліфувати точно на Ø{ $to }
