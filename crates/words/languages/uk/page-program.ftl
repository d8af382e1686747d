# The encoding sheet of a program.
encoding-title = Карта кодування інформації (ГОСТ 3.1404-86, форма 5а)
encoding-part = Деталь
encoding-equipment = Обладнання, пристрій ЧПК
encoding-equipment-is = { $machine }, { $control }
encoding-instructions = Особливі вказівки†
encoding-zero = установ { $setup }: нуль деталі від нуля верстата X{ $x } Y{ $y } Z{ $z }
encoding-correctors = коректори, мм: { $held }
encoding-ours = † доповнено проти зразка посібника
encoding-transition = Зміст переходу
encoding-tool = T, H†
encoding-block = Кодування інформації, зміст кадру
encoding-meaning = Зміст кадру словами†
# What the words of a block say.
encoding-is = { $meaning } = { $value } { $unit }
encoding-moves-to = { $meaning } до { $value } { $unit }
encoding-moves-by = { $meaning } на { $value } { $unit }
encoding-both = { $first } і { $second }
encoding-unknown = таблиці керування не знають цього слова
encoding-comment = примітка: { $text }
encoding-skip = /: далі – пропуск за ознакою оператора
encoding-tape = %: початок або кінець програми
encoding-statement = { $text }: оператор мови керування
encoding-sub = { $text }: початок підпрограми
encoding-endsub = { $text }: кінець підпрограми
encoding-call = { $text }: виклик підпрограми
# What the operator sets before a program runs.
setting-title = Налагодження верстата: { $part }
setting-stand = установ { $setup }: деталь на опорах { $supports } мм; від стола до торця шпинделя за верхнього положення повзуна { $nose } мм
setting-stand-own = установ { $setup }: деталь лежить у своєму пристосуванні за { $supports } мм над столом; від стола до торця шпинделя за верхнього положення повзуна { $nose } мм
setting-stand-vice = установ { $setup }: від стола до торця шпинделя за верхнього положення повзуна { $nose } мм
setting-mark = * – спирається на рядок таблиці, якого ніщо не підтверджує; чому – каже `technolog plan … --all-problems`
setting-lengths = довжини H – суми з каталогів: кожен комплект виміряти й набрати виміряну довжину
setting-clamps-of-second = установ { $setup }: місця притискачів вибрати наново, у плані вони лише для першого установа
setting-of-set-up = установ { $setup }: { $clamps }
setting-tool = T{ $place } H{ $corrector }: { $designation }, Ø{ $diameter }, довжина { $length } мм
setting-length = Довжина комплекту
setting-place = Гніздо
setting-places = T у програмі – номер гнізда магазину.
setting-load = T{ $tool } ставлять у гніздо { $place } вручну, коли програма зупиняється на M00 перед ним; програма називає його T{ $place }
setting-unfinished = Не закінчено: { $hole }: { $left }
setting-not-as-drawn = виготовлено не за кресленням
setting-not-made = не виготовлено зовсім
program-not-written = програму не записано: її не можна запускати
    .help = `--force` усе ж запише її, і перший рядок скаже, чому її не можна запускати
program-number-beyond = у пристрою 2С42-65 програми від 01 до 99, а не { $number }
program-numbers-run-out = за номером програми { $number } немає місця для підпрограм ({ $count }): номери кінчаються на 9999; дайте менший або --no-subprograms
setting-zeros = Нулі деталі від нуля верстата
setting-frame = Система координат
setting-file = Файл цього налагодження для `technolog check … --setting` дає `--show setting --format yaml`.
setting-keys = Набір на пульті, по черзі
keys-input = { $keys }: введення з пульта
keys-correctors = { $keys }: таблиця коректорів
keys-reference = Еталонний інструмент{ $tool } підвести до мірної плитки на столі; { $keys }: індикація Z показує 0
keys-corrector = T{ $tool } підвести до тієї самої плитки; { $keys }: довжина записується в H{ $corrector }, близько { $value }
keys-restore = { $keys }: індикація Z – як раніше
keys-leave = { $keys }: вийти з таблиці
keys-zeros = Установ { $setup }: { $keys }: таблиця нулів
keys-page = { $keys }, до сторінки { $page }: там { $frame }
keys-value = { $frame }, рядки X і Y, щоразу { $keys }: X = xM{ $x }, близько { $about_x }; Y = yM{ $y }, близько { $about_y }
keys-each-part = На кожній деталі знову
keys-read-z = Еталонний інструмент{ $tool } від Z 0 верстата підвести до поверхні; { $keys } у рядку Z для { $frame }: близько { $about }
keys-value-z = Еталонний інструмент{ $tool } від Z 0 верстата підвести до поверхні, зчитати zM; { $frame }, рядок Z, { $keys }: Z = zM{ $less }, близько { $about }
