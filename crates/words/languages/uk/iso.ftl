unknown-word = слово { $word } тут не виконується
    .help = виконувані слова дають `technolog table iso-addresses`, `iso-g-functions`, `iso-m-functions`
not-carried-out = { $word } тут не виконується{ $count ->
        [one] {" "}({ $count } місце)
        [few] {" "}({ $count } місця)
       *[many] {" "}({ $count } місць)
    }: того, що воно змінює, у показаних рухах немає
    .help = перевірте цю частину програми інакше; решту простежено: `technolog table iso-not-carried-out`
passed-over = { $word } не змінює рухів і пропущене{ $count ->
        [one] {" "}({ $count } місце)
        [few] {" "}({ $count } місця)
       *[many] {" "}({ $count } місць)
    }
    .help = нічого робити не треба
macro-not-run = макропрограми тут не виконуються: `{ $word }` вирішує, які кадри діють{ $count ->
        [one] {" "}({ $count } таке слово)
        [few] {" "}({ $count } таких слова)
       *[many] {" "}({ $count } таких слів)
    }
    .help = перевірте програму графікою самого пристрою ЧПК або запишіть її без розгалужень і циклів
number-too-long = у числі адреси { $address } більше шести знаків після точки
    .help = заокругліть число
number-without-point = число адреси { $address } без крапки: узято міліметри (калькуляторний запис)
    .help = пишіть крапку: X10.
point-missing = число адреси { $address } без крапки, а інші довжини програми її мають: воно може рахувати мікрометри
    .help = поставте крапку або скажіть у налагодженні, що воно рахує: decimal: calculator
comment-open = коментар не закрито
    .help = допишіть )
active-comment = коментар { $word } виконується: він пише файл, запускає Python або перериває програму
    .help = приберіть його або з’ясуйте, що він робить: `technolog table iso-active-comments`
message-comment = коментар { $word } виконується: він показує повідомлення
    .help = якщо повідомлення потрібне, нічого робити не треба
group-exclusive = { $first } і { $second } з однієї групи в одному кадрі
    .help = поділіть кадр на два або лишіть одну
sub-without-pair = sub, return чи endsub без своєї пари
    .help = закінчіть o… sub рядком o… endsub з тим самим ім’ям; одна в одній не стоять
call-without-number = M98 без номера P
    .help = задайте P
motion-missing = розмір є, а функції руху немає
    .help = задайте G0, G1, G2 або G3; з G53 – G0 чи G1
machine-position-with-g91 = G53, коли діє G91
    .help = задайте перед нею G90
axes-missing = { $function } без жодної осі
    .help = задайте осі, наприклад G91 G28 Z0
axes-taken-twice = { $first } і { $second } обидві беруть осі кадру
    .help = поділіть кадр на два
dwell-time-missing = G4 без часу: { $words }
    .help = задайте час
corrector-missing = G43 без H
    .help = задайте H
arc-radius-alone = радіус R не дає дуги: кінець збігається з початком або R 0
    .help = повне коло задають I, J, K
arc-radius-short = радіус { $radius } мм не дістає кінця дуги: треба щонайменше { $needed } мм
    .help = перевірте кінцеву точку й радіус
cycle-levels = дно циклу Z{ $z } вище за площину R{ $r }
    .help = задайте Z, нижчу за R
cycle-plane = постійний цикл не в площині G17
    .help = задайте перед циклом G17
tap-without-spindle = нарізання різі мітчиком, а шпиндель стоїть
    .help = увімкніть його перед циклом: S і M3
tap-counterclockwise = нарізання різі, а шпиндель обертається проти годинникової стрілки
    .help = задайте M3
too-many-blocks = кадрів у програмі більше ніж { $most }: її не виконано
    .help = винесіть повторення в підпрограми або поділіть програму на кілька
