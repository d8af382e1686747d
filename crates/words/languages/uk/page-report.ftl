# The laboratory report.
lab-title = Звіт про виконання лабораторної роботи: { $part }
lab-part = { $number }. { $name }
lab-aim = Назва і мета роботи
lab-task = Завдання на роботу
lab-equipment = Стислі характеристики верстата і пристрою ЧПК
lab-possible = Висновок про можливість оброблення заданих поверхонь на цьому обладнанні
lab-blank = Заготовка
lab-steps = Ступені оброблення кожної поверхні та метод їх виконання
lab-route = Технологічний маршрут оброблення
lab-tools = Різальний і допоміжний інструмент
lab-conditions = Режими різання і припуски
lab-fixture = Установно-затискний пристрій
lab-setting = Налагодження інструмента
lab-zeros = Нулі верстата
lab-change = Положення виконавчих органів під час заміни інструмента
lab-charts = Розрахунково-технологічні карти інструментів
lab-program = Керувальна програма на карті кодування інформації
lab-conclusions = Висновки
# The title block.
lab-institution = Заклад
lab-department = Кафедра
lab-author = Виконав
lab-group = Група
lab-variant = Варіант
lab-lecturer = Прийняв
lab-date = Дата
# What only the author can write.
lab-place = [ Вписати: { $what } ]
lab-write-aim = назву і мету роботи
lab-write-fixture = пристрій та його установно-центрувальні елементи, якщо їх не обрано вище
lab-write-conclusions = власні висновки
# The task.
lab-count = К-сть
lab-size = Розмір
lab-depth = Глибина
lab-through = наскрізний
lab-roughness = Шорсткість
lab-places = Центри [X; Y], мм
lab-from-above = Деталь зверху: поверхні, які обробляються, габарити й нуль креслення
# The machine, and whether the part can be made on it.
lab-characteristic = Характеристика
lab-figure = Значення
lab-unit = Одиниця
lab-limit = Що порівнюється
lab-needed = Потрібно
lab-available = Є
lab-enough = Досить
lab-yes = так
lab-no = ні
lab-span-x = відстань між крайніми отворами по X і переміщення стола
lab-span-y = відстань між крайніми отворами по Y і переміщення стола
lab-tool-length = довжина найдовшого комплекту і найбільший виліт
lab-tool-diameter = діаметр найбільшого інструмента
lab-power = найбільша потужність різання і потужність головного привода
lab-torque = найбільший крутний момент
lab-thrust = найбільша осьова сила
lab-mass = маса заготовки
lab-can-be-made = Усі поверхні, перелічені в завданні, можна обробити на цьому обладнанні: план не має помилок.
lab-cannot-be-made = Не все завдання можна виконати на цьому обладнанні так, як воно задане:
# The blank and the steps.
lab-of-hole = { $hole }: { $size }
lab-not-planned = Для цієї поверхні маршруту немає: причина в частині 4 і в частині 16.
lab-step = { $what } Ø{ $diameter }{ $reached }{ $elsewhere }
lab-reaches = {" "}– досягається { $reached }
lab-elsewhere = , на іншому верстаті
# Tool change, charts, program, conclusions.
lab-change-at = Інструмент замінюють у точці X { $x }, Y { $y }, Z { $z } мм у системі верстата.
lab-change-apart = Вона має бути не ближче ніж { $distance } мм від притискача (посібник, 1.11).
lab-chart = Цикли інструмента T{ $tool }. { $does }
lab-program-form = Карта – за ГОСТ 3.1404-86, форма 5а, як у додатку Г посібника. Додаток В посібника (програми підприємств) утрачено, тому на нього посилання немає.
lab-not-to-run = Цю програму не можна запускати: { $why }.
lab-made = Отворів оброблено: { $holes } з { $all }. Інструментів: { $tools }, переходів: { $transitions }, установів: { $setups }. Час за планом: { $time } хв.
lab-slowest = Найдовше обробляється група { $hole }: { $time } хв.
lab-nothing-wrong = Помилок у плані й програмі перевірка не знайшла.
# The file of the title block.
lab-no-such-part = частини звіту { $text } немає
lab-parts-are = частини мають номери від 1 до { $most }
lab-blank-mass = Маса заготовки { $mass } кг.
lab-more = Також, розміри в мм
lab-step-of = { $size } на глибину { $depth }
lab-counterbore = цекування Ø{ $diameter } на глибину { $depth }
lab-countersink = зенківка Ø{ $diameter } × { $angle }°
lab-cone = конус до Ø{ $diameter }, { $angle }°
lab-face = торець Ø{ $diameter }
lab-groove = канавка Ø{ $diameter } × { $width }
lab-chamfer = фаска { $chamfer }
lab-centre = допуск центрів { $width }
lab-centre-of-grade = допуск центрів за IT{ $it }
lab-allowances = Припуски на діаметр
lab-before = Попередній Ø
lab-after = Отриманий Ø
lab-allowance = Припуск на діаметр
lab-can-be-made-but = На цьому обладнанні можна обробити все, крім переліченого:
lab-left = Програма робить не все: { $what }.
lab-unconfirmed = Рядків таблиць, на які спирається план і яких ніщо не підтверджує: { $count }. Їх перелічує сам план.
form-tool-list = Відомість інструментів і оправок: { $part }
lab-path-of = Шлях інструментів над отворами: { $tools }
lab-clamping-scheme = Схема закріплення: притискачі, отвір з найбільшою потрібною силою закріплення та плече d
lab-clamping-arm = d = { $distance }
lab-clamping-force = Q = { $force } Н на кожному
lab-clamping-torque = M = { $torque } Н·м
lab-clamping-side = P = { $side } Н
lab-assemblies = Інструментальні комплекти: довжина допоміжного інструмента, виліт, довжина комплекту Lк; мм
lab-assembly-holder = lопр { $length }
lab-assembly-overhang = виліт { $length }
lab-assembly-length = Lк { $length }
lab-assembly-offset = корекція { $offset }
lab-zone = Робоча зона: стіл, опори, деталь і найдовший інструмент T{ $tool } над нулем деталі, повзун угорі; мм
lab-zone-table = стіл { $length }
lab-zone-nose = торець шпинделя – стіл { $height }
lab-zone-tool = Lк { $length }
lab-zone-part = деталь { $height }
lab-zone-supports = опори { $height }
lab-zone-vice = лещата { $height }
lab-zone-gap = до деталі { $height }
